//! How a value is spread over the members: `mm(0.2 ± 0.02)` and `mm(0.18..0.22)`.

use super::normal::normal_quantile;
use crate::sweep::{Setting, short};
use std::fmt;
use tribodyn::Change;

/// Signs between a mean and its standard deviation.
const SIGNS: [&str; 2] = ["±", "+-"];
/// Between the ends of a range.
const RANGE: &str = "..";
/// Shares from which values follow, the ends of a distribution left out.
const SHARES: [f64; 2] = [f64::EPSILON / 4.0, 1.0 - f64::EPSILON / 2.0];

/// A place of the case and the distribution of its values: `PATH=SPREAD`.
#[derive(Debug, Clone, PartialEq)]
pub struct Spread {
    /// Stands before the spread in messages.
    option: &'static str,
    /// Place in the case.
    pub path: String,
    /// As it was given, without the path.
    pub text: String,
    /// The text before the number in the case, such as `mm(`, and after it.
    around: [String; 2],
    distribution: Distribution,
}

#[derive(Debug, Clone, PartialEq)]
enum Distribution {
    /// Values of a grid, as a case file has them.
    Each(Vec<String>),
    Normal {
        mean: f64,
        deviation: f64,
    },
    Uniform {
        low: f64,
        high: f64,
    },
}

impl fmt::Display for Spread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}={}", self.option, self.path, self.text)
    }
}

impl Spread {
    /// Reads `PATH=SPREAD`, such as `cage.pocket_gap=mm(0.2 ± 0.02)`.
    ///
    /// # Errors
    /// A text that says what is wrong and what is allowed.
    pub fn parse(text: &str) -> Result<Self, String> {
        let halves = text.split_once('=').map(|(path, spread)| [path.trim(), spread.trim()]);
        match halves {
            Some([path, spread]) if !path.is_empty() && !spread.is_empty() => Self::of(path, spread),
            _ => Err(format!("allowed is PATH=SPREAD: a path in the case, and {ALLOWED}")),
        }
    }

    /// A spread for a place of the case.
    ///
    /// # Errors
    /// A text that says what is wrong and what is allowed.
    pub fn of(path: &str, spread: &str) -> Result<Self, String> {
        let syntax = || format!("`{spread}` is not a spread; allowed is {ALLOWED}");
        let mut found = SIGNS.into_iter().chain([RANGE]).flat_map(|sign| spread.match_indices(sign));
        let (Some((at, sign)), None) = (found.next(), found.next()) else { return Err(syntax()) };
        if spread.contains("...") {
            return Err(syntax());
        }
        let numeric = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | 'e' | 'E');
        let before = spread[..at].trim_end();
        let prefix = before.trim_end_matches(numeric);
        let rest = spread[at + sign.len()..].trim_start();
        let second = &rest[..rest.find(|c| !numeric(c)).unwrap_or(rest.len())];
        let number = |text: &str| text.parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(syntax);
        let (a, b) = (number(&before[prefix.len()..])?, number(second)?);
        let distribution = if sign == RANGE {
            // The difference has to be a number too: ends far apart may overflow.
            let wide = (b - a).is_finite() && b > a;
            wide.then_some(Distribution::Uniform { low: a, high: b })
                .ok_or_else(|| format!("`{spread}`: allowed is a range from its lower end to a higher one"))
        } else {
            let deviation = (b > 0.0).then_some(Distribution::Normal { mean: a, deviation: b });
            deviation.ok_or_else(|| format!("`{spread}`: allowed is a standard deviation above 0"))
        }?;
        let around = [prefix, &rest[second.len()..]].map(str::to_owned);
        Ok(Self { option: "", path: path.to_owned(), text: spread.to_owned(), around, distribution })
    }

    /// Reads `PATH=VALUES`, each of which is a value of a grid: lists and ranges as those of a sweep.
    ///
    /// # Errors
    /// A text that says what is wrong and what is allowed.
    pub fn each(text: &str) -> Result<Self, String> {
        let Setting { path, values, .. } = Setting::parse(text)?;
        let given = text.split_once('=').map_or(text, |(_, values)| values.trim()).to_owned();
        let around = [String::new(), String::new()];
        Ok(Self { option: "", path, text: given, around, distribution: Distribution::Each(values) })
    }

    /// Number of values of a grid; none for values that are drawn.
    pub fn count(&self) -> Option<usize> {
        if let Distribution::Each(values) = &self.distribution { Some(values.len()) } else { None }
    }

    /// With a text that stands before the spread in messages, such as the name of an option.
    pub fn prefixed(self, option: &'static str) -> Self {
        Self { option, ..self }
    }

    /// The value below which a share of all values lies, as a case file has it.
    pub(super) fn value(&self, share: f64) -> String {
        let value = match &self.distribution {
            Distribution::Each(values) => {
                let place = (share * values.len() as f64) as usize;
                return values[place.min(values.len() - 1)].clone();
            }
            Distribution::Normal { mean, deviation } => {
                mean + deviation * normal_quantile(share.clamp(SHARES[0], SHARES[1]))
            }
            Distribution::Uniform { low, high } => low + (high - low) * share,
        };
        let [before, after] = &self.around;
        // Not −0, which no list of values has.
        format!("{before}{}{after}", short(value + 0.0))
    }

    /// The value in the middle, for a case.
    pub(super) fn middle(&self) -> Change {
        let Self { option, path, .. } = self;
        let value = self.value(0.5);
        Change::new(format!("{option}{path}={value}"), path, &value)
    }

    /// Values of some shares, for the members' cases.
    pub(super) fn setting(&self, shares: &[f64]) -> Setting {
        Setting::of(&self.path, shares.iter().map(|share| self.value(*share)).collect()).prefixed(self.option)
    }

    /// True if another place lies within the one of this spread, or around it.
    pub(super) fn meets(&self, path: &str) -> bool {
        Change::new(String::new(), &self.path, "").concerns(path)
    }
}

/// The forms that may stand after the path.
const ALLOWED: &str = "a mean with its standard deviation, mm(0.2 ± 0.02) or mm(0.2 +- 0.02), \
                       or a range in which all values are as likely, mm(0.18..0.22)";

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> [String; 3] {
        let spread = Spread::parse(text).unwrap();
        [0.0, 0.5, 0.975].map(|share| spread.value(share))
    }

    #[test]
    fn limit_values_stand_in_the_unit_of_their_spread() {
        assert_eq!(values("a.b = mm(0.18..0.22)"), ["mm(0.18)", "mm(0.2)", "mm(0.219)"]);
        assert_eq!(values("a=-1 .. 3"), ["-1", "1", "2.9"]);
        assert_eq!(values("a=Force(kN( 1e1 .. 3e1 ))"), ["Force(kN( 10 ))", "Force(kN( 20 ))", "Force(kN( 29.5 ))"]);
        let [least, mean, high] = values("cage.pocket_gap=mm(0.2 ± 0.02)");
        assert_eq!(mean, "mm(0.2)");
        let number = |text: &str| text[3..text.len() - 1].parse::<f64>().unwrap();
        assert!((number(&high) - (0.2 + 0.02 * 1.959_964)).abs() < 1e-8, "{high}");
        // The ends of a normal distribution lie at infinity: 8.3 deviations are as far as a share can be told from 0.
        assert!((number(&least) - (0.2 - 0.02 * 8.292_361)).abs() < 1e-7, "{least}");
        assert_eq!(values("a=mm(0.2 +- 0.02)"), values("a=mm(0.2±0.02)"));
        assert_eq!(values("a=-1..1")[1], "0");
        assert_eq!(values("a=-1e300..1e300")[0], "-1e300");
    }

    #[test]
    fn limit_what_is_no_spread_says_what_is_allowed() {
        for (bad, why) in [
            ("a", "allowed is PATH=SPREAD"),
            ("=1..2", "allowed is PATH=SPREAD"),
            ("a=mm(0.2)", "mm(0.2 ± 0.02)"),
            ("a=mm(0.2 ± 0.02 ± 1)", "is not a spread"),
            ("a=1..2..3", "is not a spread"),
            ("a=1...2", "is not a spread"),
            ("a=mm(x ± 0.1)", "is not a spread"),
            ("a=mm(0.2 ±)", "is not a spread"),
            ("a=mm(inf..2)", "is not a spread"),
            ("a=1..1", "to a higher one"),
            ("a=2..1", "to a higher one"),
            ("a=-1.7e308..1.7e308", "to a higher one"),
            ("a=mm(0.2 ± 0)", "above 0"),
            ("a=mm(0.2 ± -0.1)", "above 0"),
            ("a=Library(\"a..b\")", "is not a spread"),
        ] {
            let message = Spread::parse(bad).unwrap_err();
            assert!(message.contains(why), "{bad}: {message}");
        }
    }
}
