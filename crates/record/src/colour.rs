//! Colours: a scale that colour-blind readers can follow, and the tones of the bodies.

use crate::wire::foxglove::Color;

/// Five colours of viridis at equal distances (S. van der Walt and N. Smith, 2015, CC0), 8 bits a channel.
/// Lightness grows along the scale, so that it survives every kind of colour blindness and printing in grey.
const VIRIDIS: [[u8; 3]; 5] =
    [[0x44, 0x01, 0x54], [0x3b, 0x52, 0x8b], [0x21, 0x91, 0x8c], [0x5e, 0xc9, 0x62], [0xfd, 0xe7, 0x25]];

/// Ball steel.
pub(crate) const BALL: Color = rgba([0xd4, 0xd9, 0xe0], 1.0);
/// Band about a ball: vermilion of Okabe and Ito's palette (2008).
pub(crate) const BAND: Color = rgba([0xd5, 0x5e, 0x00], 1.0);
/// Dot on one pole of the band: blue of the same palette.
pub(crate) const DOT: Color = rgba([0x00, 0x72, 0xb2], 1.0);
/// Dot on the other pole: black.
pub(crate) const OTHER_DOT: Color = rgba([0x1c, 0x1e, 0x22], 1.0);
/// Outer ring, seen through.
pub(crate) const OUTER_RING: Color = rgba([0x9a, 0xa7, 0xb8], 0.25);
/// Inner ring, seen through less: it hides no ball from outside.
pub(crate) const INNER_RING: Color = rgba([0x6f, 0x9b, 0xd1], 0.5);
/// Cage, bronze, seen through.
pub(crate) const CAGE: Color = rgba([0xc9, 0x92, 0x3e], 0.45);
/// Rims of the cage pockets.
pub(crate) const POCKET: Color = rgba([0xe8, 0xb4, 0x5c], 1.0);
/// Marks that show how a ring turns.
pub(crate) const MARK: Color = rgba([0xd5, 0x5e, 0x00], 1.0);
/// Text.
pub(crate) const TEXT: Color = rgba([0xee, 0xf0, 0xf3], 1.0);

/// A tone from 8-bit channels and an opacity from 0 to 1.
const fn rgba([r, g, b]: [u8; 3], a: f64) -> Color {
    Color { r: r as f64 / 255.0, g: g as f64 / 255.0, b: b as f64 / 255.0, a }
}

/// The scale at a fraction from 0 to 1, clamped, in steps of 1/256.
pub(crate) fn scale(fraction: f64) -> Color {
    let steps = (VIRIDIS.len() - 1) as f64;
    let place = (fraction.clamp(0.0, 1.0) * 256.0).round() / 256.0 * steps;
    let left = (place.floor() as usize).min(VIRIDIS.len() - 2);
    let part = place - left as f64;
    let channel = |i: usize| {
        let (a, b) = (f64::from(VIRIDIS[left][i]), f64::from(VIRIDIS[left + 1][i]));
        (a + part * (b - a)).round() / 255.0
    };
    Color { r: channel(0), g: channel(1), b: channel(2), a: 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_scale_gets_lighter_all_the_way() {
        // Relative luminance of linear sRGB would need the gamma; its weights on the coded channels keep the order.
        let light = |c: Color| 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        let steps: Vec<f64> = (0..=64).map(|i| light(scale(f64::from(i) / 64.0))).collect();
        assert!(steps.windows(2).all(|pair| pair[1] > pair[0]));
        assert_eq!(scale(-1.0), scale(0.0));
        assert_eq!(scale(2.0), scale(1.0));
    }
}
