//! `cargo xtask figures`: the result figures of the paper from our own runs: 9 and 15 of the traction curves, the transient
//! 13 and 19 to 24, and the quasi-static 14 and 16 to 18. The paper's numbers are marked where its text gives them.

mod content;
mod curves;

use crate::error::Failure;
use crate::files;
use crate::transient::{Set, in_time};
use std::path::PathBuf;
use tribodyn_plot::Figure;

/// Wide enough for a page at 200 dots per inch.
const PNG_WIDTH: u32 = 1600;
/// Where the page looks for them.
const DEFAULT_FOLDER: &str = "docs/figures";
/// The page that shows them.
const PAGE: &str = "docs/figures.md";

/// Options of `figures`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Folder for the figures; the page with all of them is written for the default one only
    #[arg(short, long, value_name = "DIR", default_value = DEFAULT_FOLDER)]
    output: PathBuf,
}

/// A figure of the page.
pub struct Entry {
    /// The paper's figure, as in `13a`.
    pub of: &'static str,
    /// Case files and what is seen.
    pub caption: &'static str,
    pub figure: Figure,
}

/// Makes the runs and writes all figures and the page.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let set = in_time("dynamic runs", || Set::run(None))?;
    let folder = files::root().join(&arguments.output);
    let steady = crate::validate::write_solution_figures(&folder)?;
    let mut entries = curves::all()?;
    entries.extend(content::all(&set)?);
    for entry in &entries {
        files::write(&folder.join(format!("{}.svg", entry.figure.name)), entry.figure.svg().as_bytes())?;
        files::write(&folder.join(format!("{}.png", entry.figure.name)), &entry.figure.png(PNG_WIDTH)?)?;
    }
    if arguments.output.as_os_str() == DEFAULT_FOLDER {
        files::write(&files::root().join(PAGE), page(&entries, &steady).as_bytes())?;
    }
    Ok(())
}

fn page(entries: &[Entry], steady: &[String]) -> String {
    let mut out = String::from(
        "# Figures\n\nThe result figures of the paper from our own runs, all by one command:\n\n    cargo xtask figures\n\nWhich of the paper's statements they bear out stands in [validation.md](validation.md).\n\n## Traction curves and transient: Figs. 9, 13, 15 and 19 to 24\n",
    );
    for Entry { of, caption, figure } in entries {
        out.push_str(&format!("\n### Fig. {of}\n\n![{0}](figures/{0}.svg)\n\n{caption}\n", figure.name));
    }
    out.push_str("\n## Quasi-static: Figs. 14 and 16 to 18\n\nCases 1 to 4 of Table 4, from `fixtures/cases/paper-ag.ron`; crosses of the pressures are Table 5's.\n");
    steady.iter().for_each(|name| out.push_str(&format!("\n![{name}](figures/{name}.svg)\n")));
    out
}
