//! Random numbers that are the same everywhere: a small generator with a seed, and the draws that bearings need.

/// SplitMix64: 64 bits of state, every seed a good one.
///
/// Source: Steele, Lea and Flood, Fast splittable pseudorandom number generators, OOPSLA 2014,
/// doi:10.1145/2660193.2660195.
#[derive(Debug, Clone)]
pub struct Random {
    state: u64,
}

/// Increment of the state: the odd integer nearest to 2⁶⁴ over the golden ratio.
const STRIDE: u64 = 0x9e37_79b9_7f4a_7c15;

impl Random {
    /// The stream of one member of a family: member `index` does not depend on how many others are drawn.
    pub fn new(seed: u64, index: u64) -> Self {
        let mut of_seed = Self { state: seed };
        let start = of_seed.bits() ^ index.wrapping_mul(STRIDE);
        Self { state: start }
    }

    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(STRIDE);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Between 0 and 1, without 1.
    pub fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2.0f64.powi(-53)
    }

    /// Between two values, each as likely as any other.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// Between two positive values, each decade as likely as any other.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.share())
    }

    /// True with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.share() < probability
    }

    /// A whole number of a range, both ends included.
    pub fn whole(&mut self, low: usize, high: usize) -> usize {
        low + (self.share() * (high - low + 1) as f64) as usize
    }

    /// One of several values with their weights.
    pub fn one_of<T: Copy>(&mut self, choices: &[(f64, T)]) -> T {
        let total: f64 = choices.iter().map(|(weight, _)| weight).sum();
        let mut left = self.share() * total;
        for &(weight, value) in choices {
            left -= weight;
            if left < 0.0 {
                return value;
            }
        }
        choices[choices.len() - 1].1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_members_are_reproducible_and_differ() {
        let draw = |seed, index| Random::new(seed, index).share();
        assert_eq!(draw(1, 7), draw(1, 7));
        assert!(draw(1, 7) != draw(1, 8) && draw(1, 7) != draw(2, 7));
    }

    #[test]
    fn limit_draws_keep_their_ranges_and_fill_them() {
        let mut random = Random::new(3, 0);
        let (mut least, mut most, mut seen) = (f64::INFINITY, 0.0f64, [0; 3]);
        for _ in 0..2000 {
            let value = random.decades(1e3, 1e6);
            (least, most) = (least.min(value), most.max(value));
            seen[random.whole(5, 7) - 5] += 1;
        }
        assert!((1e3..1.1e3).contains(&least) && (9e5..1e6).contains(&most), "{least} {most}");
        assert!(seen.iter().all(|count| (550..780).contains(count)), "{seen:?}");
    }
}
