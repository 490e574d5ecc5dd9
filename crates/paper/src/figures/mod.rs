//! The result figures of the paper, 9 and 13 to 24, from our own runs, with the numbers marked that its text gives. The
//! page that shows them names case and command of each. Short runs do for a check that all of them can be made.

mod curves;
mod loads;
mod over_time;
mod page;
mod runs;
mod spec;
mod specs;
mod steady;

use crate::error::PaperError;
use crate::files;
use crate::progress::Progress;
use runs::{Length, Made};
use spec::Spec;
use specs::SPECS;
use std::path::{Path, PathBuf};

pub use page::{PAGE, linked, page};

/// Wide enough for a page at 200 dots per inch.
const PNG_WIDTH: u32 = 1600;
/// Folder in which the page looks for figures.
pub const FOLDER: &str = "docs/figures";
/// Folder of those of short runs.
pub const QUICK_FOLDER: &str = "target/figures";

/// Selection of figures, and their folder.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Options {
    /// Only figures whose names begin so, as `fig19`; makes only the runs that they need and leaves the page as it is.
    pub only: Option<String>,
    /// Transient runs just long enough for one orbit after the start: every figure, in a folder of its own.
    pub quick: bool,
    /// Folder for the figures; without it [`FOLDER`], or [`QUICK_FOLDER`] where they are quick.
    pub output: Option<PathBuf>,
}

/// Makes the runs and writes the figures; with all of them in the default folder also the page.
///
/// # Errors
///
/// No figure of that name, quick ones in the folder of the committed ones, a run that fails, a file that cannot be
/// written.
pub fn run(options: &Options, progress: Progress) -> Result<(), PaperError> {
    let (length, default) = if options.quick { (Length::Quick, QUICK_FOLDER) } else { (Length::Full, FOLDER) };
    let folder = files::root().join(options.output.as_deref().unwrap_or(Path::new(default)));
    let committed = is_committed(&folder);
    if options.quick && committed {
        let findings = vec![format!("{} holds those of whole runs", folder.display())];
        return Err(PaperError::Check { what: "figures of short runs go elsewhere", findings });
    }
    let specs = chosen(options.only.as_deref())?;
    write(&specs, &folder, length, progress)?;
    if committed && options.only.is_none() {
        files::write(&files::root().join(PAGE), page().as_bytes())?;
    }
    Ok(())
}

/// All figures from short runs.
///
/// # Errors
///
/// A run that fails, a file that cannot be written.
pub fn quick(folder: &Path, progress: Progress) -> Result<(), PaperError> {
    write(&SPECS.iter().collect::<Vec<_>>(), folder, Length::Quick, progress)
}

/// True for the folder of the committed figures, however it is written.
fn is_committed(folder: &Path) -> bool {
    let plain = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_owned());
    plain(folder) == plain(&files::root().join(FOLDER))
}

fn chosen(prefix: Option<&str>) -> Result<Vec<&'static Spec>, PaperError> {
    let prefix = prefix.unwrap_or("");
    let specs: Vec<&Spec> = SPECS.iter().filter(|spec| spec.name.starts_with(prefix)).collect();
    if specs.is_empty() {
        let findings = SPECS.iter().map(|spec| spec.name.to_owned()).collect();
        return Err(PaperError::Check { what: "no figure has a name that begins so; there are", findings });
    }
    Ok(specs)
}

fn write(specs: &[&Spec], folder: &Path, length: Length, progress: Progress) -> Result<(), PaperError> {
    let made = Made::for_all(specs.iter().map(|spec| spec.cases), length, progress)?;
    for spec in specs {
        let figure = (spec.draw)(spec, &made)?;
        files::write(&folder.join(format!("{}.svg", spec.name)), figure.svg().as_bytes())?;
        files::write(&folder.join(format!("{}.png", spec.name)), &figure.png(PNG_WIDTH)?)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_prefix_chooses_its_figures_and_a_wrong_one_is_refused() {
        assert_eq!(chosen(None).unwrap().len(), SPECS.len());
        let names: Vec<_> = chosen(Some("fig13")).unwrap().iter().map(|spec| spec.name).collect();
        assert!(names.len() > 1 && names.iter().all(|name| name.starts_with("fig13")), "{names:?}");
        let Err(PaperError::Check { findings, .. }) = chosen(Some("fig99")) else { panic!("found") };
        assert_eq!(findings.len(), SPECS.len());
    }

    #[test]
    fn limit_short_runs_never_go_over_the_committed_figures() {
        for folder in ["docs/figures", "docs/../docs/figures/"] {
            let output = Some(files::root().join(folder));
            let refused = run(&Options { only: Some("fig09".to_owned()), quick: true, output }, &|_| ());
            assert!(matches!(refused, Err(PaperError::Check { .. })), "{folder}");
        }
    }

    #[test]
    fn identity_figures_that_need_no_run_are_written_with_both_files() {
        let folder = std::env::temp_dir().join(format!("tribodyn-figures-{}", std::process::id()));
        let options = Options { only: Some("fig09".to_owned()), quick: false, output: Some(folder.clone()) };
        run(&options, &|_| ()).unwrap();
        let svg = files::read(&folder.join("fig09-curves.svg")).unwrap();
        let png = std::fs::read(folder.join("fig09-curves.png")).unwrap();
        std::fs::remove_dir_all(&folder).unwrap();
        assert!(svg.contains("published") && png.starts_with(b"\x89PNG"));
    }
}
