//! The page with all figures: the numbers that the paper gives, the command under each, and its case where that is not
//! the one before.

use super::spec::Spec;
use super::specs::SPECS;

/// The page.
pub const PAGE: &str = "docs/figures.md";

/// Its text, which does not depend on any result.
pub fn page() -> String {
    let mut out = String::from(
        "# Figures\n\n\
        The result figures of the paper, 9 and 13 to 24, from our own runs. All of them, with this page, by one \
        command:\n\n    cargo xtask figures\n\n\
        and from runs just long enough for an orbit, into `target/figures`, by `cargo xtask figures --quick`. Numbers \
        that the paper's text\n\
        gives are marked black or in the colour of their line, as open diamonds, thin dash-dotted lines or light \
        ranges, and are named\n\
        \"published\" in the legend. Which of the paper's statements our runs bear out stands in \
        [validation.md](validation.md).\n\n\
        Azimuth 0° is the direction of the radial load, and balls orbit counter-clockwise; curves over the azimuth \
        are means of all balls\n\
        over the settled orbits in sectors of 2°, with a light band from least to greatest value where orbits differ. \
        Signed values are\n\
        drawn over degrees, and crosses mark where balls are without contact.\n",
    );
    let (mut section, mut cases) = ("", "");
    for spec in &SPECS {
        if spec.section != section {
            (section, cases) = (spec.section, "");
            out.push_str(&format!("\n## {section}\n"));
        }
        let changed = (spec.cases.text() != cases).then(|| spec.cases.text());
        cases = spec.cases.text();
        out.push_str(&entry(spec, changed));
    }
    out
}

fn entry(Spec { name, of, title, note, .. }: &Spec, cases: Option<&str>) -> String {
    let cases = cases.map_or(String::new(), |cases| format!("{cases}:\n\n"));
    let note = if note.is_empty() { String::new() } else { format!("{note}\n\n") };
    format!(
        "\n### {of}: {title}\n\n![{name}](figures/{name}.svg)\n\n\
        {note}{cases}    cargo xtask figures --only {name}\n"
    )
}

/// Names of the figures that a page shows.
pub fn linked(page: &str) -> Vec<&str> {
    page.split("](figures/").skip(1).filter_map(|rest| rest.split_once(".svg)")).map(|(name, _)| name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn identity_the_page_shows_every_figure_once_with_case_and_command() {
        let page = page();
        let names: Vec<&str> = SPECS.iter().map(|spec| spec.name).collect();
        assert_eq!(linked(&page), names);
        assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len());
        for spec in &SPECS {
            let part = page.split(&format!("](figures/{}.svg)", spec.name)).nth(1).unwrap();
            let part = part.split("\n#").next().unwrap();
            assert!(part.contains(&format!("    cargo xtask figures --only {}\n", spec.name)), "{part}");
            let until = page.split(&format!("--only {}\n", spec.name)).next().unwrap();
            let last = |spec: &Spec| until.rfind(&format!("\n{}:\n", spec.cases.text()));
            assert_eq!(last(spec), SPECS.iter().map(last).max().unwrap(), "{}", spec.name);
        }
    }

    #[test]
    fn paper_every_result_figure_is_there() {
        for number in [9].into_iter().chain(13..=24) {
            let prefix = format!("fig{number:02}-");
            assert!(SPECS.iter().any(|spec| spec.name.starts_with(&prefix)), "{prefix}");
        }
    }

    #[test]
    fn identity_no_command_takes_another_figure_with_it() {
        for spec in &SPECS {
            assert_eq!(SPECS.iter().filter(|other| other.name.starts_with(spec.name)).count(), 1, "{}", spec.name);
        }
    }
}
