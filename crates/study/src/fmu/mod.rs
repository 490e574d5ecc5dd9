//! A case as a functional mock-up unit on disk, with a library for this machine where a C compiler makes one.

use crate::error::StudyError;
use crate::files::StagedFiles;
use crate::ours::Ours;
use serde::Serialize;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicU32, Ordering};
use std::{env, fs, io};
use tribodyn::answers::{Answer, Equations, Findings, Question, solved};
use tribodyn_bearing::{Races, RingState};
use tribodyn_fmu::{Binary, Fmu, Platform};
use tribodyn_quasistatic::Model;

/// How an FMU is made.
#[derive(Debug, Clone, Copy)]
pub struct FmuOptions {
    /// True if the sources are compiled where there is a compiler.
    pub compile: bool,
    /// True if a file of somebody else is replaced.
    pub force: bool,
}

/// An FMU that was written.
#[derive(Debug, Clone, Serialize)]
pub struct FmuAnswer {
    /// The file.
    pub output: PathBuf,
    /// Version of the interface.
    pub fmi_version: &'static str,
    /// Name of its libraries, and prefix of its functions in a program that links several.
    pub model_identifier: String,
    /// Platforms with a compiled library, by their folders; other ones compile the sources.
    pub platforms: Vec<&'static str>,
    /// Displacement of the inner ring at the start, m: the equilibrium of the case.
    pub ring_displacement_m: [f64; 3],
    /// Tilt about X and Y at the start, rad.
    pub ring_tilt_rad: [f64; 2],
    /// Force of the bearing on the inner ring there, N: the opposite of the ring's load.
    pub force_n: [f64; 3],
    /// Moment about X and Y, N m.
    pub moment_nm: [f64; 2],
}

/// Writes the FMU of a case, which starts in the equilibrium of Jones–Harris at the operating point; `case` is the file
/// that it may not replace.
///
/// # Errors
/// A case without an equilibrium, or that raceway control cannot take; a file that may not be replaced or cannot be
/// written.
pub fn export_fmu(
    question: &Question<'_>,
    case: &Path,
    output: &Path,
    options: &FmuOptions,
) -> Result<Answer<FmuAnswer>, StudyError> {
    Ours::Fmu.may_replace(output, case, options.force)?;
    let Some(file_name) = output.file_name().and_then(|name| name.to_str()) else {
        return Err(StudyError::argument("output", output.display(), "allowed is the path of a file"));
    };
    let (bearing, solved) = solved(question, Model::JonesHarris)?;
    let solution = solved.solution;
    let mut findings = Findings::of(question, &bearing, (Equations::JonesHarris, &solution))?;
    let point = question.point();
    let inner = RingState {
        displacement: solution.ring_displacement_m,
        tilt: solution.ring_tilt_rad,
        ..RingState::centred(point.inner_speed)
    };
    let outer = RingState::centred(point.outer_speed);
    let name = Path::new(question.name).file_stem().map_or(question.name.into(), |stem| stem.to_string_lossy());
    let fmu = Fmu::new(&name, &bearing, Races { inner: &inner, outer: &outer })
        .map_err(|source| StudyError::Fmu { file: question.name.to_owned(), source })?;
    let binary = match options.compile.then(|| compiled(&fmu)) {
        Some(Ok(binary)) => Some(binary),
        Some(Err(why)) => {
            findings = findings.with(format!("no library for this machine, the sources alone: {why}"));
            None
        }
        None => None,
    };
    let folder = output.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut staged = StagedFiles::new(folder, true)?;
    staged.write(file_name.to_owned(), &fmu.archive(binary.as_ref()))?;
    staged.publish()?;
    Ok(Answer::new(
        findings,
        FmuAnswer {
            output: output.to_owned(),
            fmi_version: "2.0",
            model_identifier: fmu.identifier().to_owned(),
            platforms: binary.iter().map(|binary| binary.platform.name()).collect(),
            ring_displacement_m: solution.ring_displacement_m,
            ring_tilt_rad: solution.ring_tilt_rad,
            force_n: solution.ring_load_n.map(|load| -load),
            moment_nm: solution.ring_moment_nm.map(|moment| -moment),
        },
    ))
}

/// The sources compiled by the compiler that `CC` names, or `cc`.
fn compiled(fmu: &Fmu) -> Result<Binary, String> {
    let Some(platform) = Platform::here() else { return Err("FMI 2.0 has no name for it that was tried".to_owned()) };
    let folder = TemporaryFolder::new().map_err(|error| error.to_string())?;
    let write = |(name, text): &(&str, String)| fs::write(folder.0.join(name), text);
    let sources = fmu.sources();
    sources.iter().try_for_each(write).map_err(|error| error.to_string())?;
    let library = folder.0.join(fmu.identifier());
    let compiler = env::var_os("CC").filter(|name| !name.is_empty()).unwrap_or_else(|| OsString::from("cc"));
    let mut command = Command::new(&compiler);
    // One library for all processors of the platform, with the same digits: no fused multiplication and addition.
    command.args(["-std=c99", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-ffp-contract=off", "-o"]);
    command.arg(&library).current_dir(&folder.0);
    command.args(sources.iter().map(|(name, _)| *name).filter(|name| name.ends_with(".c"))).arg("-lm");
    let named = compiler.to_string_lossy();
    let done = command.output().map_err(|error| format!("{named}: {error}"))?;
    if !done.status.success() {
        let said = String::from_utf8_lossy(&done.stderr);
        return Err(format!("{named}: {}", said.lines().next().unwrap_or("it failed without a word")));
    }
    Ok(Binary { platform, bytes: fs::read(&library).map_err(|error| error.to_string())? })
}

/// A folder among the system's temporary ones that goes when it is dropped.
struct TemporaryFolder(PathBuf);

impl TemporaryFolder {
    fn new() -> io::Result<Self> {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        loop {
            let count = COUNT.fetch_add(1, Ordering::Relaxed);
            let path = env::temp_dir().join(format!("tribodyn-fmu-{}-{count}", std::process::id()));
            match fs::create_dir(&path) {
                Ok(()) => return Ok(Self(path)),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
    }
}

impl Drop for TemporaryFolder {
    fn drop(&mut self) {
        // What is left is in the system's care.
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[cfg(test)]
mod tests;
