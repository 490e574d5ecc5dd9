//! Value lists: `kN(10),kN(20)`, `kN(10..60 by 5)`, `kN(10..60 in 11)` and `kN(1..100 log 21)`.

/// Most values of one list: a typing error should not fill the memory.
const MAX_VALUES: usize = 1_000_000;
/// Most bytes around the numbers of a range.
const MAX_BYTES: usize = 64 << 20;

/// How the values of a range lie between its ends.
enum Spacing {
    /// From the first end on by this step.
    By(f64),
    /// So many, evenly, both ends among them.
    In(usize),
    /// So many with a constant ratio, both ends among them.
    Log(usize),
}

/// The values of a list, each as a case file would have it, in order.
///
/// # Errors
/// A text that says what is wrong and what is allowed.
pub fn expand(list: &str) -> Result<Vec<String>, String> {
    let mut values = Vec::new();
    for item in split(list)? {
        let item = item.trim();
        if item.is_empty() {
            return Err("a value is missing beside a comma".to_owned());
        }
        values.extend(expand_item(item)?);
        if values.len() > MAX_VALUES {
            return Err(too_many());
        }
    }
    Ok(values)
}

fn too_many() -> String {
    format!("more than {MAX_VALUES} values in one list")
}

/// Characters of a text outside strings: byte offset, character, and the number of brackets open around it.
fn scan(text: &str) -> Result<Vec<(usize, char, usize)>, String> {
    let (mut open, mut quoted, mut escaped) = (Vec::new(), false, false);
    let mut outside = Vec::with_capacity(text.len());
    for (at, c) in text.char_indices() {
        if quoted {
            quoted = c != '"' || escaped;
            escaped = c == '\\' && !escaped;
            continue;
        }
        match c {
            '"' => quoted = true,
            '(' | '[' | '{' => open.push(c),
            ')' | ']' | '}' => match (open.pop(), c) {
                (Some('('), ')') | (Some('['), ']') | (Some('{'), '}') => {}
                _ => return Err(format!("brackets do not match in `{text}`")),
            },
            _ => {}
        }
        outside.push((at, c, open.len()));
    }
    if quoted || !open.is_empty() {
        return Err(format!("brackets or quotes do not match in `{text}`"));
    }
    Ok(outside)
}

/// Cuts at commas that no bracket or string holds.
fn split(list: &str) -> Result<Vec<&str>, String> {
    let mut items = Vec::new();
    let mut start = 0;
    for (at, c, depth) in scan(list)? {
        if c == ',' && depth == 0 {
            items.push(&list[start..at]);
            start = at + 1;
        }
    }
    items.push(&list[start..]);
    Ok(items)
}

/// One value, or those of the range in it.
fn expand_item(item: &str) -> Result<Vec<String>, String> {
    let dots = |window: &[(usize, char, usize)]| (window[0].1 == '.' && window[1].1 == '.').then_some(window[0].0);
    let found: Vec<usize> = scan(item)?.windows(2).filter_map(dots).collect();
    let at = match found[..] {
        [] => return Ok(vec![item.to_owned()]),
        [at] => at,
        _ => return Err(format!("`{item}` has more dots than one range may have")),
    };
    let syntax = || {
        format!("`{item}` is not a range; allowed are 10..60 by 5, 10..60 in 11 and 1..100 log 21, in a unit or bare")
    };
    let numeric = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | 'e' | 'E');
    let before = item[..at].trim_end();
    let prefix = before.trim_end_matches(numeric);
    let rest = item[at + 2..].trim_start();
    let to = &rest[..rest.find(|c| !numeric(c)).unwrap_or(rest.len())];
    let rest = rest[to.len()..].trim_start();
    let (word, rest) = rest.split_once(' ').ok_or_else(syntax)?;
    let rest = rest.trim_start();
    let steps = &rest[..rest.find(|c| !numeric(c)).unwrap_or(rest.len())];
    let suffix = &rest[steps.len()..];
    let count = || {
        steps
            .parse::<usize>()
            .ok()
            .filter(|n| *n >= 2)
            .ok_or_else(|| format!("`{steps}` in `{item}`: allowed is a whole number of values, 2 or more"))
    };
    let spacing = match word {
        "by" => Spacing::By(steps.parse().map_err(|_| syntax())?),
        "in" => Spacing::In(count()?),
        "log" => Spacing::Log(count()?),
        _ => return Err(syntax()),
    };
    let end = |text: &str| text.parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(syntax);
    let numbers =
        numbers(end(&before[prefix.len()..])?, end(to)?, &spacing).map_err(|why| format!("`{item}`: {why}"))?;
    // Long texts around many numbers would fill the memory too.
    if numbers.len().saturating_mul(prefix.len() + suffix.len()) > MAX_BYTES {
        return Err(format!(
            "the values of `{}…` have more than {MAX_BYTES} bytes",
            item.chars().take(40).collect::<String>()
        ));
    }
    Ok(numbers.into_iter().map(|number| format!("{prefix}{}{suffix}", short(number))).collect())
}

/// A number with all its digits; very large and very small ones with an exponent instead of hundreds of zeros.
pub fn short(number: f64) -> String {
    let plain = number == 0.0 || (1e-15..1e18).contains(&number.abs());
    if plain { number.to_string() } else { format!("{number:e}") }
}

fn numbers(from: f64, to: f64, spacing: &Spacing) -> Result<Vec<f64>, String> {
    // Decimals that are no rounding errors of the ends: 0.1 + 2 · 0.1 is to be 0.3.
    let digits = 14 - from.abs().max(to.abs()).max(f64::MIN_POSITIVE).log10().floor() as i32;
    let clean = |v: f64, digits: i32| format!("{v:.*}", digits.max(0) as usize).parse::<f64>().map_or(v, |v| v + 0.0);
    match *spacing {
        Spacing::By(step) => {
            let steps = (to - from) / step;
            if !(steps.is_finite() && steps >= 0.0) {
                return Err(format!("steps of {step} do not lead from {from} to {to}"));
            }
            // The far end belongs to the range if a step ends there but for rounding.
            let last = (steps * (1.0 + 1e-12) + 1e-9).floor();
            if last >= MAX_VALUES as f64 {
                return Err(too_many());
            }
            Ok((0..=last as usize).map(|i| clean(from + i as f64 * step, digits)).collect())
        }
        Spacing::In(count) | Spacing::Log(count) if count > MAX_VALUES => {
            Err(format!("{count} are too many: {}", too_many()))
        }
        Spacing::In(count) => {
            let share = |i: usize| i as f64 / (count - 1) as f64;
            Ok((0..count).map(|i| clean(from * (1.0 - share(i)) + to * share(i), digits)).collect())
        }
        Spacing::Log(count) => {
            if !(from > 0.0 && to > 0.0) {
                return Err("both ends of a logarithmic range must be above 0".to_owned());
            }
            let value = |i: usize| match i {
                0 => from,
                i if i == count - 1 => to,
                i => {
                    let v = from * (to / from).powf(i as f64 / (count - 1) as f64);
                    clean(v, 14 - v.log10().floor() as i32)
                }
            };
            Ok((0..count).map(value).collect())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::expand;

    fn of(list: &str) -> Vec<String> {
        expand(list).unwrap()
    }

    #[test]
    fn limit_a_list_is_cut_at_outer_commas_only() {
        assert_eq!(of("kN(10), kN(20)"), ["kN(10)", "kN(20)"]);
        assert_eq!(of("SplitStrip(across: 8, along: 3)"), ["SplitStrip(across: 8, along: 3)"]);
        assert_eq!(of(r#"Library("a,b)\",c"),Library("d..e")"#), [r#"Library("a,b)\",c")"#, r#"Library("d..e")"#]);
        for bad in ["kN(1),", ",", "kN(1", "kN)1(", "(1]", "\"a"] {
            assert!(expand(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn limit_ranges_give_the_decimals_a_person_means() {
        assert_eq!(of("kN(10..25 by 5)"), ["kN(10)", "kN(15)", "kN(20)", "kN(25)"]);
        assert_eq!(of("kN(10 .. 26  by  5)"), ["kN(10)", "kN(15)", "kN(20)", "kN(25)"]);
        assert_eq!(of("0.1..0.5 by 0.1"), ["0.1", "0.2", "0.3", "0.4", "0.5"]);
        assert_eq!(
            of("um(-0.3..0.3 by 0.1)"),
            ["um(-0.3)", "um(-0.2)", "um(-0.1)", "um(0)", "um(0.1)", "um(0.2)", "um(0.3)"]
        );
        assert_eq!(of("3..1 by -1,7"), ["3", "2", "1", "7"]);
        assert_eq!(of("Force(kN(0..1 in 3))"), ["Force(kN(0))", "Force(kN(0.5))", "Force(kN(1))"]);
        assert_eq!(of("1e3..-1e3 in 3"), ["1000", "0", "-1000"]);
        assert_eq!(of("-1e300..1e300 in 3"), ["-1e300", "0", "1e300"]);
        assert_eq!(
            of("kN(1..100 log 5)"),
            ["kN(1)", "kN(3.16227766016838)", "kN(10)", "kN(31.6227766016838)", "kN(100)"]
        );
        assert_eq!(of("1e-9..1e-6 log 4"), ["0.000000001", "0.00000001", "0.0000001", "0.000001"]);
        assert_eq!(of("8..10 by 1"), ["8", "9", "10"]);
    }

    #[test]
    fn limit_impossible_ranges_say_why() {
        for (bad, why) in [
            ("1..2", "not a range"),
            ("1..2 of 3", "not a range"),
            ("a..2 by 1", "not a range"),
            ("1..2 by x", "not a range"),
            ("1...2 by 1", "more dots"),
            ("(1..2 by 1, 3..4 by 1)", "more dots"),
            ("1..2 by 0", "do not lead"),
            ("1..2 by -1", "do not lead"),
            ("1..2 in 1", "2 or more"),
            ("1..2 in 2.5", "2 or more"),
            ("0..2 log 3", "above 0"),
            ("0..1 by 1e-9", "more than"),
            ("0..1 in 99999999", "more than"),
        ] {
            let message = expand(bad).unwrap_err();
            assert!(message.contains(why), "{bad}: {message}");
        }
    }
}
