//! Colours of a map: from dark for low values to light for high ones, even in lightness, safe for colour-blind readers.

/// Viridis at eleven even steps (S. van der Walt, N. Smith, "A Better Default Colormap for Matplotlib", SciPy 2015;
/// CC0). Its lightness rises evenly, so that it also reads in grey.
const STEPS: [[u8; 3]; 11] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x24, 0x75],
    [0x41, 0x44, 0x87],
    [0x35, 0x5F, 0x8D],
    [0x2A, 0x78, 0x8E],
    [0x21, 0x91, 0x8C],
    [0x22, 0xA8, 0x84],
    [0x44, 0xBF, 0x70],
    [0x7A, 0xD1, 0x51],
    [0xBD, 0xDF, 0x26],
    [0xFD, 0xE7, 0x25],
];

/// Number of colours: finer than an eye tells apart, coarse enough for neighbours to share one.
pub(crate) const SHADES: usize = 128;

/// The shade of a position between the ends of a scale, 0 to 1.
pub(crate) fn shade(position: f64) -> usize {
    ((position.clamp(0.0, 1.0) * SHADES as f64) as usize).min(SHADES - 1)
}

/// A shade as `#RRGGBB`.
pub(crate) fn colour(shade: usize) -> String {
    let place = (shade as f64 + 0.5) / SHADES as f64 * (STEPS.len() - 1) as f64;
    let step = (place as usize).min(STEPS.len() - 2);
    let part = place - step as f64;
    let [r, g, b] = [0, 1, 2].map(|k| {
        let [from, to] = [STEPS[step][k], STEPS[step + 1][k]].map(f64::from);
        (from + part * (to - from)).round() as u8
    });
    format!("#{r:02X}{g:02X}{b:02X}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance after ITU-R BT.709.
    fn luminance(shade: usize) -> f64 {
        let text = colour(shade);
        let part = |at: usize| f64::from(u8::from_str_radix(&text[at..at + 2], 16).unwrap()) / 255.0;
        let linear = |v: f64| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
        0.2126 * linear(part(1)) + 0.7152 * linear(part(3)) + 0.0722 * linear(part(5))
    }

    #[test]
    fn identity_higher_values_are_lighter() {
        assert!((1..SHADES).all(|k| luminance(k) > luminance(k - 1)));
        assert_eq!((shade(-1.0), shade(0.0), shade(1.0), shade(2.0)), (0, 0, SHADES - 1, SHADES - 1));
    }
}
