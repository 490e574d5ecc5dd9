//! Roots within a step.

/// Place in (0, 1) at which a function that is positive at 0, or not, changes its sign: by 50 halvings, the upper end
/// of the last.
pub fn bisect(f: impl Fn(f64) -> f64, positive_at_0: bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == positive_at_0 { low = middle } else { high = middle }
    }
    high
}

/// Cubic through two values with their slopes over the interval, at `s` from 0 to 1.
pub fn hermite(s: f64, [a, b]: [f64; 2], [da, db]: [f64; 2]) -> f64 {
    let r = 1.0 - s;
    // Differences from a keep the digits of large values.
    a + (b - a) * s * s * (3.0 - 2.0 * s) + s * r * (da * r - db * s)
}
