//! Colours: a scale that colour-blind readers can follow, and the tones of the bodies.

use crate::wire::foxglove::Color;

/// Five colours of plasma at equal distances up to four fifths of it (S. van der Walt and N. Smith, 2015, CC0), 8 bits
/// a channel. Lightness grows along the scale, so that it survives every kind of colour blindness and printing in grey;
/// the yellow end would be lost on white.
const PLASMA: [[u8; 3]; 5] =
    [[0x0d, 0x08, 0x87], [0x5c, 0x01, 0xa6], [0x9c, 0x17, 0x9e], [0xcc, 0x47, 0x78], [0xf1, 0x84, 0x4b]];
/// Coating whole and gone: gold and near black, with steps of lightness between.
const COATING: [[u8; 3]; 2] = [[0xf2, 0xc1, 0x4e], [0x3a, 0x1d, 0x12]];

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
/// Text: viewers put dark text on white boxes, which the white background of the layout hides.
pub(crate) const TEXT: Color = rgba([0x1c, 0x1e, 0x22], 1.0);
/// Ring load and the mark of its radial direction: bluish green of Okabe and Ito's palette.
pub(crate) const LOAD: Color = rgba([0x00, 0x9e, 0x73], 1.0);
/// Pocket forces: no tone of the scale of pressures is as dark and grey.
pub(crate) const POCKET_FORCE: Color = rgba([0x1d, 0x26, 0x2b], 1.0);
/// An arrow that stands for contact forces of any colour.
pub(crate) const FORCE: Color = rgba([0x9a, 0x9f, 0xa6], 1.0);
/// A defect, and one that a ball passes.
pub(crate) const DEFECT: Color = rgba([0x7a, 0x1f, 0x1f], 0.9);
pub(crate) const DEFECT_HIT: Color = rgba([0xff, 0x20, 0x10], 1.0);
/// Where no ball has been yet.
pub(crate) const UNSEEN: Color = rgba([0xb8, 0xbe, 0xc6], 1.0);
/// Axes X, Y and Z.
pub(crate) const AXES: [Color; 3] =
    [rgba([0xd5, 0x2b, 0x1e], 1.0), rgba([0x2a, 0x8f, 0x2a], 1.0), rgba([0x1f, 0x5f, 0xbf], 1.0)];

/// A tone from 8-bit channels and an opacity from 0 to 1.
const fn rgba([r, g, b]: [u8; 3], a: f64) -> Color {
    Color { r: r as f64 / 255.0, g: g as f64 / 255.0, b: b as f64 / 255.0, a }
}

/// The scale at a fraction from 0 to 1, clamped, in steps of 1/256.
pub(crate) fn scale(fraction: f64) -> Color {
    along(&PLASMA, fraction)
}

/// A coating of which this part is left, 0 to 1.
pub(crate) fn coating(left: f64) -> Color {
    along(&COATING, 1.0 - left)
}

fn along(colours: &[[u8; 3]], fraction: f64) -> Color {
    let steps = (colours.len() - 1) as f64;
    let place = (fraction.clamp(0.0, 1.0) * 256.0).round() / 256.0 * steps;
    let left = (place.floor() as usize).min(colours.len() - 2);
    let part = place - left as f64;
    let channel = |i: usize| {
        let (a, b) = (f64::from(colours[left][i]), f64::from(colours[left + 1][i]));
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
