//! `tribodyn layout`: the Foxglove layout as a file, for viewers of a live run. Recordings carry theirs.

use crate::failure::Failure;
use crate::input::{LimitArguments, ReplaceArguments};
use std::path::{Path, PathBuf};
use tribodyn_record::{Layout, LayoutKind};
use tribodyn_study::{Ours, StagedFiles, layout_of, read_case};

/// Write the Foxglove layout.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn layout 7210B.ron -o layout.json")]
pub struct Arguments {
    /// Case whose bearing sets the distance of the camera, the rows of balls and the band of the spectra
    #[arg(value_name = "CASE")]
    case: Option<PathBuf>,
    /// File to write
    #[arg(short, long, value_name = "LAYOUT.json")]
    output: PathBuf,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    limits: LimitArguments,
    /// Write the layout for recordings of `solve`, not of `run`
    #[arg(long)]
    solution: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let kind = if arguments.solution { LayoutKind::Solution } else { LayoutKind::Run };
    let layout = match &arguments.case {
        Some(path) => layout_of(&read_case(path, &[], &arguments.limits.limits())?, kind)?,
        None => Layout::general(kind),
    };
    let case = arguments.case.as_deref().unwrap_or(Path::new(""));
    arguments.replace.check(&arguments.output, case, Ours::Layout)?;
    let path = &arguments.output;
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
        let message = "the name of a file is wanted".to_owned();
        return Err(Failure::Option { option: "output", value: path.display().to_string(), message });
    };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut staged = StagedFiles::new(folder, true)?;
    staged.write(name.to_owned(), layout.json().as_bytes())?;
    Ok(staged.publish()?)
}
