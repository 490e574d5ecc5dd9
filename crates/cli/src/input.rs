//! Arguments of several commands: case files with changes, limits on what files may ask for, permission to replace.

use crate::failure::Failure;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use tribodyn::answers::check_lubricant;
use tribodyn::{CaseFile, Change, Limits, path_and_value};
use tribodyn_bearing::Side;
use tribodyn_bearing::fits::SeatClass;
use tribodyn_catalogue::Fits;
use tribodyn_study::{Ours, StudyError, read_case};

/// Limits on what a file may ask for.
#[derive(clap::Args)]
pub struct LimitArguments {
    /// Lift the limits on balls, nodes, steps and sizes; a file may then fill the memory
    #[arg(long)]
    no_limits: bool,
}

impl LimitArguments {
    pub fn limits(&self) -> Limits {
        if self.no_limits { Limits::NONE } else { Limits::NORMAL }
    }
}

/// Permission to replace.
#[derive(clap::Args)]
pub struct ReplaceArguments {
    /// Replace existing files, also those that tribodyn did not write and recordings of other bearings
    #[arg(long)]
    pub force: bool,
}

impl ReplaceArguments {
    /// Refuses a path of output at which something stands that may not be replaced.
    pub fn check(&self, path: &Path, case: &Path, wanted: Ours) -> Result<(), Failure> {
        Ok(wanted.may_replace(path, case, self.force)?)
    }

    /// The same for the recording of a case, which replaces none of another bearing either.
    pub fn check_recording(&self, path: &Path, case: &Path, file: &CaseFile) -> Result<(), Failure> {
        self.check(path, case, Ours::Recording)?;
        if !self.force {
            Ours::keeps_others(path, &file.case.name)?;
        }
        Ok(())
    }
}

/// Fits of a bearing of the built-in list.
#[derive(clap::Args)]
pub struct FitArguments {
    /// Tolerance class of the shaft, such as k5 (ISO 286); the fit reduces the clearance
    #[arg(long, value_name = "CLASS", value_parser = seat_class(Side::Inner))]
    shaft_fit: Option<String>,
    /// Tolerance class of the housing, such as H7
    #[arg(long, value_name = "CLASS", value_parser = seat_class(Side::Outer))]
    housing_fit: Option<String>,
}

impl FitArguments {
    pub fn fits(&self) -> Fits {
        Fits { shaft: self.shaft_fit.clone(), housing: self.housing_fit.clone() }
    }
}

/// A case file and what to change in it for this run.
#[derive(clap::Args)]
pub struct CaseArguments {
    /// Case file (RON)
    #[arg(value_name = "CASE")]
    pub path: PathBuf,
    /// Replace one value of the case for this run, such as 'ring.z.Force=kN(30)'; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = change)]
    pub changes: Vec<Change>,
    #[command(flatten)]
    limits: LimitArguments,
}

impl CaseArguments {
    /// The case with the changes of `--set`.
    pub fn read(&self) -> Result<CaseFile, StudyError> {
        self.read_with(&self.changes)
    }

    /// The changes of `--set`, and that of `--duration` where it is given.
    pub fn run_changes(&self, duration: Option<f64>) -> Result<Vec<Change>, StudyError> {
        let Some(seconds) = duration else { return Ok(self.changes.clone()) };
        let plain = self.read()?;
        // A duration alone makes no section: the news is all that is missing, and not the path.
        if plain.case.transient.is_none() {
            plain.run_inputs()?;
        }
        let duration = Change::new(format!("--duration {seconds}"), "transient.duration", &format!("s({seconds})"));
        Ok(self.changes.iter().cloned().chain([duration]).collect())
    }

    /// Limits on the amounts that files ask for.
    pub fn limits(&self) -> Limits {
        self.limits.limits()
    }

    /// The case with changes.
    pub fn read_with(&self, changes: &[Change]) -> Result<CaseFile, StudyError> {
        read_case(&self.path, changes, &self.limits.limits())
    }
}

/// A change of `--set`.
pub fn change(text: &str) -> Result<Change, String> {
    path_and_value(text).map(|[path, value]| Change::new(format!("--set {text}"), path, value))
}

/// The name of a new case's lubricant.
pub fn lubricant(word: &str) -> Result<String, String> {
    check_lubricant(word).map(|()| word.to_owned()).map_err(|error| error.to_string())
}

/// Reads the tolerance class of the seat of a ring.
fn seat_class(side: Side) -> impl Fn(&str) -> Result<String, String> + Clone + Send + Sync + 'static {
    move |text| {
        let class = SeatClass::parse(text).and_then(|class| class.of_ring(side));
        class.map(|_| text.trim().to_owned()).map_err(|error| error.to_string())
    }
}

/// Threads for members or rows: so many, or one for each core.
pub fn pool(threads: Option<NonZeroUsize>) -> Result<rayon::ThreadPool, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.map_or(0, NonZeroUsize::get)).build();
    pool.map_err(|error| Failure::Output(std::io::Error::other(error)))
}

#[cfg(test)]
mod tests {
    use super::change;
    use tribodyn::Change;

    #[test]
    fn limit_a_change_has_a_path_and_a_value() {
        let expected = Change::new("--set geometry.fit = deg(1)".to_owned(), "geometry.fit", "deg(1)");
        assert_eq!(change("geometry.fit = deg(1)").unwrap(), expected);
        assert!(change("geometry.fit").is_err() && change("=1").is_err() && change("a=").is_err());
    }
}
