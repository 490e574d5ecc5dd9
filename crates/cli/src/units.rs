//! Numbers of options with a unit of their own.

use tribodyn_case::{in_si, unit_names};

/// Reads a number that stands in `unit`, or has another unit of its kind: `450`, `450lbf`, `450 lbf` or `lbf(450)`. The
/// answer is in `unit`.
pub fn in_unit(unit: &'static str) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync + 'static {
    move |text| read(text, unit)
}

fn read(text: &str, unit: &str) -> Result<f64, String> {
    let text = text.trim();
    if let Ok(number) = text.parse() {
        return Ok(number);
    }
    let kind = unit_names().into_iter().find(|names| names.contains(&unit)).unwrap_or(&[]);
    let refused = || format!("allowed is a number in {unit}, or one with its unit, as 1{unit}: {}", kind.join(", "));
    let (number, name) = match text.strip_suffix(')').and_then(|call| call.split_once('(')) {
        Some((name, number)) => (number, name),
        // The longest beginning that is a number: "1e3N" and "2e" have an e each.
        None => (0..text.len())
            .rev()
            .filter(|end| text.is_char_boundary(*end))
            .map(|end| text.split_at(end))
            .find(|(number, _)| number.trim().parse::<f64>().is_ok())
            .ok_or_else(refused)?,
    };
    let name = name.trim();
    let number: f64 = number.trim().parse().map_err(|_| refused())?;
    if !kind.contains(&name) {
        return Err(refused());
    }
    let si = |unit: &str, number: f64| in_si(unit, number).ok_or_else(refused);
    let (zero, one) = (si(unit, 0.0)?, si(unit, 1.0)?);
    Ok((si(name, number)? - zero) / (one - zero))
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn limit_numbers_have_a_unit_of_their_own_or_that_of_the_option() {
        for (text, unit, expected) in [
            ("450", "N", 450.0),
            ("-2.5e2", "N", -250.0),
            ("450lbf", "N", 2001.6997267),
            ("450 lbf", "N", 2001.6997267),
            ("lbf(450)", "N", 2001.6997267),
            ("1.5kN", "N", 1500.0),
            ("1e3N", "N", 1000.0),
            ("2in", "mm", 50.8),
            ("0.0004inch", "um", 10.16),
            ("212degF", "degC", 100.0),
            ("20", "degC", 20.0),
            ("30000psi", "GPa", 0.206_842_718_795_051),
            ("100rad_per_s", "rpm", 954.929_658_551_372),
        ] {
            let found = read(text, unit).unwrap();
            assert!((found - expected).abs() <= 1e-10 * expected.abs(), "{text} in {unit}: {found}");
        }
    }

    #[test]
    fn limit_other_units_are_refused_with_those_that_are_allowed() {
        for text in ["450mm", "lbf", "lbf()", "450 pounds", "(450)", "", "4,5", "450°"] {
            let message = read(text, "N").unwrap_err();
            assert!(message.contains("N, kN, lbf"), "{text}: {message}");
        }
    }
}
