//! All figures from short runs: that they can be made, that the page shows them all and none is left over.

use super::{Outcome, finish};
use crate::error::Failure;
use crate::terminal::progress;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use tribodyn_paper::{PaperError, figures, files};

/// Attributes that hold coordinates.
const COORDINATES: [&str; 14] =
    ["x", "y", "x1", "x2", "y1", "y2", "cx", "cy", "r", "width", "height", "points", "d", "stroke-width"];

pub fn check() -> Result<Outcome, Failure> {
    let folder = files::root().join(figures::QUICK_FOLDER);
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|source| PaperError::Write { path: folder.clone(), source })?;
    }
    figures::quick(&folder, &progress)?;
    let page = files::read(&files::root().join(figures::PAGE))?;
    let mut findings = Vec::new();
    if page != figures::page() {
        findings.push(format!("{} is not what `cargo xtask figures` writes", figures::PAGE));
    }
    let linked = figures::linked(&page).into_iter().map(str::to_owned).collect();
    let (made, committed) = (drawn(&folder)?, drawn(&files::root().join(figures::FOLDER))?);
    findings.extend(differences(&linked, &made, &committed));
    for name in &made {
        let path = |extension: &str| folder.join(format!("{name}.{extension}"));
        findings.extend(flaws(&files::read(&path("svg"))?).map(|flaw| format!("{name}.svg: {flaw}")));
        if fs::metadata(path("png")).map_or(0, |file| file.len()) == 0 {
            findings.push(format!("{name}.png is missing or empty"));
        }
    }
    finish("figures", findings)
}

/// Names of the SVG files of a folder.
fn drawn(folder: &Path) -> Result<BTreeSet<String>, Failure> {
    let entries = fs::read_dir(folder).map_err(|source| PaperError::Read { path: folder.to_owned(), source })?;
    let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    Ok(names.filter_map(|name| name.strip_suffix(".svg").map(str::to_owned)).collect())
}

/// Differences between the figures that the page shows, those made, and those committed.
fn differences(linked: &BTreeSet<String>, made: &BTreeSet<String>, committed: &BTreeSet<String>) -> Vec<String> {
    let lacks = |all: &BTreeSet<String>, of: &BTreeSet<String>, what: &str| -> Vec<String> {
        all.difference(of).map(|name| format!("{name} {what}")).collect()
    };
    [
        lacks(linked, made, "is on the page and was not made"),
        lacks(made, linked, "was made and is not on the page"),
        lacks(linked, committed, "is on the page and not committed"),
        lacks(committed, made, "is committed and was not made"),
    ]
    .concat()
}

/// Faults of an SVG: nothing drawn, or coordinates that are no numbers.
fn flaws(svg: &str) -> impl Iterator<Item = String> {
    let whole = svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>");
    let empty = !whole || !(svg.contains("<path") || svg.contains("<rect x="));
    let no_numbers = attributes(svg).filter(|(name, _)| COORDINATES.contains(name)).filter_map(|(name, value)| {
        let mut parts = value.split(|c: char| c.is_whitespace() || matches!(c, ',' | 'M' | 'L' | 'Z'));
        let wrong = parts.find(|part| !part.is_empty() && !part.parse::<f64>().is_ok_and(f64::is_finite))?;
        Some(format!("{name}: {wrong:?} is no coordinate"))
    });
    empty.then(|| "nothing is drawn".to_owned()).into_iter().chain(no_numbers)
}

/// Names and values of all attributes; texts hold no quotation marks, which are written as entities.
fn attributes(svg: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut pieces = svg.split('"');
    std::iter::from_fn(move || {
        let (before, value) = (pieces.next()?, pieces.next()?);
        Some((before.trim_end_matches('=').rsplit(char::is_whitespace).next().unwrap_or(""), value))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_plot::{Axis, Figure, LineChart, Panel, Series};

    fn names(names: &[&str]) -> BTreeSet<String> {
        names.iter().map(|&name| name.to_owned()).collect()
    }

    #[test]
    fn limit_a_figure_that_is_anywhere_missing_is_found() {
        let all = names(&["a", "b"]);
        assert!(differences(&all, &all, &all).is_empty());
        let one = names(&["a"]);
        assert_eq!(differences(&all, &one, &all).len(), 2);
        assert_eq!(differences(&one, &all, &one).len(), 1);
        assert_eq!(differences(&all, &all, &one).len(), 1);
        assert_eq!(differences(&one, &one, &all).len(), 1);
    }

    #[test]
    fn limit_coordinates_that_are_no_numbers_are_found() {
        let series = vec![Series::line("a \"quoted\" label of inf", vec![(0.0, 1.0), (1.0, 2.0)])];
        let chart = LineChart::new("t", Axis::new("x", "s"), Axis::new("y", "NaN"), series);
        let figure = Figure::new("f", "F", &[Panel::Cartesian(chart)]).unwrap();
        let good = figure.svg();
        assert_eq!(flaws(good).next(), None);
        let found = |svg: &str| flaws(svg).count();
        assert!(found(&good.replacen("d=\"M", "d=\"MNaN 3 L", 1)) == 1);
        assert!(found(&good.replacen("x1=\"", "x1=\"inf", 1)) == 1);
        assert_eq!((found(""), found("<svg></svg>")), (1, 1));
    }
}
