//! Widths of text and numbers as a typesetter writes them.

use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider};

/// DejaVu Sans reduced to Latin, Greek and mathematical characters; licence in `assets/LICENSE-DejaVu.txt`.
pub(crate) const FONT: &[u8] = include_bytes!("../assets/DejaVuSans-subset.ttf");
/// DejaVu Sans Bold, reduced likewise.
pub(crate) const BOLD: &[u8] = include_bytes!("../assets/DejaVuSans-Bold-subset.ttf");
/// Name under which both register.
pub(crate) const FAMILY: &str = "DejaVu Sans";

/// Width given to a character that the font lacks, in units of the type size.
const MISSING_EM: f64 = 0.65;

/// Width of a line of text at a type size, px.
///
/// A viewer may take another sans-serif face; DejaVu Sans is among the widest, so that measured text fits there too.
pub(crate) fn width(text: &str, size_px: f64, bold: bool) -> f64 {
    let Ok(font) = FontRef::new(if bold { BOLD } else { FONT }) else {
        return MISSING_EM * size_px * text.chars().count() as f64;
    };
    let (characters, glyphs) = (font.charmap(), font.glyph_metrics(Size::new(size_px as f32), LocationRef::default()));
    text.chars()
        .map(|c| {
            characters.map(c).and_then(|glyph| glyphs.advance_width(glyph)).map_or(MISSING_EM * size_px, f64::from)
        })
        .sum()
}

/// Size of subscripts relative to the text.
pub(crate) const SUBSCRIPT_SIZE: f64 = 0.76;

/// The runs of a text with `true` for those that an underscore makes subscripts: the letters and digits after it.
pub(crate) fn runs(text: &str) -> Vec<(&str, bool)> {
    let mut pieces = text.split('_');
    let mut all = vec![(pieces.next().unwrap_or(""), false)];
    for piece in pieces {
        let end = piece.find(|c: char| !c.is_alphanumeric()).unwrap_or(piece.len());
        all.extend([(&piece[..end], true), (&piece[end..], false)]);
    }
    all.retain(|(run, _)| !run.is_empty());
    all
}

/// Width of a text with subscripts, px.
pub(crate) fn width_with_subscripts(text: &str, size_px: f64) -> f64 {
    let scale = |subscript| if subscript { SUBSCRIPT_SIZE } else { 1.0 };
    runs(text).into_iter().map(|(run, subscript)| width(run, scale(subscript) * size_px, false)).sum()
}

/// A number with at most three significant digits after the point, without zeros at its end.
pub(crate) fn short_number(value: f64) -> String {
    let size = value.abs();
    let decimals = if size == 0.0 { 0 } else { (2 - size.log10().floor() as i32).clamp(0, 4) as usize };
    let text = number(value, decimals);
    if decimals == 0 { text } else { text.trim_end_matches('0').trim_end_matches('.').to_owned() }
}

/// A number with a fixed count of decimals and the typographic minus; never a negative zero.
pub(crate) fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits.to_owned(),
        Some(digits) => format!("\u{2212}{digits}"),
        None => text,
    }
}

/// An integer as superscript characters.
fn superscript(value: i32) -> String {
    value.to_string().chars().map(|c| if c == '-' { '⁻' } else { SUPERSCRIPTS[c as usize - '0' as usize] }).collect()
}

const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

/// Ten to an integer power, such as `10⁻¹²`.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    format!("10{}", superscript(exponent))
}

/// A quantity with its unit and the power of ten taken out of the numbers: `Wear rate (10⁻¹² m³/s)`.
pub(crate) fn axis_title(label: &str, unit: &str, exponent: i32) -> String {
    let power = if exponent == 0 { String::new() } else { power_of_ten(exponent) };
    match (power.is_empty(), unit.is_empty()) {
        (true, true) => label.to_owned(),
        (true, false) => format!("{label} ({unit})"),
        (false, true) => format!("{label} ({power})"),
        (false, false) => format!("{label} ({power} {unit})"),
    }
}

/// Text with the characters that XML reserves, or forbids, replaced.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() || matches!(c, '\u{FFFE}' | '\u{FFFF}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_numbers_have_a_typographic_minus_and_no_negative_zero() {
        assert_eq!(number(-1.25, 2), "−1.25");
        assert_eq!(number(-0.001, 2), "0.00");
        assert_eq!(number(5800.0, 0), "5800");
        assert_eq!(power_of_ten(-12), "10⁻¹²");
        assert_eq!(axis_title("Wear rate", "m³/s", -12), "Wear rate (10⁻¹² m³/s)");
        assert_eq!(axis_title("Slide-to-roll ratio", "", 0), "Slide-to-roll ratio");
    }

    #[test]
    fn limit_underscores_make_subscripts() {
        assert_eq!(runs("13 f_c − 2 f_s"), [("13 f", false), ("c", true), (" − 2 f", false), ("s", true)]);
        assert_eq!(runs("plain"), [("plain", false)]);
        assert!(width_with_subscripts("f_c", 12.0) < width("fc", 12.0, false));
    }

    #[test]
    fn limit_short_numbers_have_three_digits() {
        let texts = [0.0, 1234.6, 1200.0, 12.346, -0.012_346, 3.0, 0.05].map(short_number);
        assert_eq!(texts, ["0", "1235", "1200", "12.3", "−0.0123", "3", "0.05"]);
    }

    #[test]
    fn identity_width_is_additive_and_proportional_to_size() {
        let parts = width("Contact ", 12.0, false) + width("load", 12.0, false);
        assert!((width("Contact load", 12.0, false) - parts).abs() < 1e-9);
        let ratio = width("Contact", 24.0, true) / width("Contact", 12.0, true);
        assert!((ratio - 2.0).abs() < 1e-3, "{ratio}");
        // Bold is wider, and a wide letter wider than a narrow one: both fonts are read, not estimated.
        assert!(width("load", 12.0, true) > width("load", 12.0, false));
        assert!(width("m", 12.0, false) > 2.0 * width("i", 12.0, false));
    }

    #[test]
    fn limit_escape_leaves_nothing_for_xml_to_trip_on() {
        assert_eq!(escape("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot; ");
    }
}
