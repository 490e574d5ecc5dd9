//! Files that tribodyn wrote: only those are replaced unasked.

use crate::error::StudyError;
use std::fs::{self, File};
use std::io::{Error, ErrorKind, Read, Result, Seek, SeekFrom};
use std::path::Path;

/// The content of a file of ours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ours {
    /// A recording (MCAP).
    Recording,
    /// A table: of a sweep or an ensemble (CSV or Parquet), of stiffness or of modes (CSV).
    Table,
    /// A figure (SVG, or the PNG beside one).
    Figure,
    /// A Foxglove layout (JSON).
    Layout,
    /// A functional mock-up unit.
    Fmu,
    /// A page, a summary, or what an identification found.
    Report,
    /// Nothing: an empty file, in which nothing can be lost.
    Empty,
}

/// Bytes that are looked at from the start and from the end.
const LOOK: u64 = 64 << 10;
const MCAP: &[u8] = b"\x89MCAP0\r\n\x01";
/// First columns of the tables of `stiffness`, `modes` and `shaft`, and of worn cells; `frequency` is what the speed
/// was called for ROSS 2.
const TABLES: [&str; 8] = [
    "load_case,position_m,displacement_x_m",
    "bearing,node,speed,kxx,kxy,kyx,kyy,kzz",
    "bearing,node,frequency,kxx,kxy,kyx,kyy,kzz",
    "inner_speed_rpm,k_x_x,k_x_y",
    "speed,kxx,kxy,kyx,kyy,kzz",
    "frequency,kxx,kxy,kyx,kyy,kzz",
    "frequency_hz,damping_ratio,growth_rate_per_s",
    "cell,race,azimuth_deg,angle_deg,depth_um",
];
const SVG: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
const PAGE: &str = "<meta name=\"generator\" content=\"tribodyn\">";

impl Ours {
    /// The content of the file at a path if tribodyn wrote it, told by its bytes; none for a file of anybody else's.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn of(path: &Path) -> Result<Option<Self>> {
        let mut file = File::open(path)?;
        let length = file.metadata()?.len();
        let mut head = Vec::new();
        (&mut file).take(LOOK).read_to_end(&mut head)?;
        file.seek(SeekFrom::Start(length.saturating_sub(LOOK)))?;
        let mut tail = Vec::new();
        file.take(LOOK).read_to_end(&mut tail)?;
        let text = String::from_utf8_lossy(&head);
        let beside = |extension: &str| Self::of_text(&path.with_extension(extension));
        Ok(match path.extension().and_then(|e| e.to_str()) {
            _ if head.is_empty() => Some(Self::Empty),
            _ if head.starts_with(MCAP) => recorded(&head).then_some(Self::Recording),
            // The description is the first file of the archive, not compressed.
            _ if head.starts_with(b"PK\x03\x04") => text.contains("generationTool=\"tribodyn").then_some(Self::Fmu),
            _ if head.starts_with(b"PAR1") => holds(&tail, b"tribodyn version").then_some(Self::Table),
            // Bitmaps say nothing of their maker; they are made with a drawing of the same name.
            Some("png") => beside("svg").filter(|_| head.starts_with(b"\x89PNG")),
            Some("md") => Self::of_text(&path.with_file_name("report.html")),
            Some("ron") => Self::of_text(&path.with_file_name("identification.json")),
            _ => told(&text),
        })
    }

    /// Refuses a path of output at which something stands that may not be replaced: the case, what is no plain file,
    /// and, without `force`, what is not of ours or not of this kind.
    ///
    /// # Errors
    /// [`StudyError`] that says which of these.
    pub fn may_replace(self, path: &Path, case: &Path, force: bool) -> std::result::Result<(), StudyError> {
        let (kind, replaceable) = match self {
            Self::Recording => ("recording", "a recording"),
            Self::Table => ("table", "a table"),
            Self::Fmu => ("FMU", "an FMU"),
            _ => ("layout", "a layout"),
        };
        let Ok(standing) = fs::canonicalize(path) else { return Ok(()) };
        if fs::canonicalize(case).is_ok_and(|case| case == standing) {
            let message = format!("the {kind} would replace the case file");
            return Err(StudyError::argument("output", path.display(), message));
        }
        let failure = |source| StudyError::Write { path: path.to_owned(), source };
        if !standing.is_file() {
            return Err(failure(Error::new(ErrorKind::InvalidInput, "it is not a regular file")));
        }
        let ours = |found: Self| found == self || found == Self::Empty;
        if force || Self::of(&standing).map_err(failure)?.is_some_and(ours) {
            return Ok(());
        }
        Err(StudyError::NotOurs { path: path.to_owned(), wanted: replaceable })
    }

    /// Refuses to replace a recording of another bearing; one that cannot be read names none.
    ///
    /// # Errors
    /// [`StudyError::OtherRecording`].
    pub fn keeps_others(path: &Path, bearing: &str) -> std::result::Result<(), StudyError> {
        let Ok(summary) = tribodyn_record::read_summary(path) else { return Ok(()) };
        match summary.metadata.get("simulation").and_then(|entries| entries.get("bearing")) {
            Some(found) if found != bearing => {
                Err(StudyError::OtherRecording { path: path.to_owned(), found: found.clone() })
            }
            _ => Ok(()),
        }
    }

    /// The kind of another file by its beginning alone; none where there is none.
    fn of_text(path: &Path) -> Option<Self> {
        let mut head = Vec::new();
        File::open(path).ok()?.take(LOOK).read_to_end(&mut head).ok()?;
        told(&String::from_utf8_lossy(&head))
    }
}

fn told(text: &str) -> Option<Ours> {
    let first = text.lines().next().unwrap_or_default();
    // Columns of sweeps, of ensembles, of lives.
    let has = |columns: [&str; 3]| columns.iter().all(|column| first.split(',').any(|name| name == *column));
    let columns = || {
        has(["converged", "cage_speed_rpm", "error"])
            || has(["member", "cage_speed_mean_rpm", "error"])
            || has(["stride", "revolutions", "wear_rate_cage_um3_s"])
    };
    let both = |a: &str, b: &str| text.contains(a) && text.contains(b);
    match text.chars().next()? {
        '<' if first.starts_with(SVG) && first.ends_with("font-family=\"sans-serif\" role=\"img\">") => {
            Some(Ours::Figure)
        }
        '<' if text.contains(PAGE) => Some(Ours::Report),
        '{' if both("\"configById\"", "/bearing/") => Some(Ours::Layout),
        '{' if text.contains("\"generator\": \"tribodyn") || both("\"case_differences\"", "\"differences\"") => {
            Some(Ours::Report)
        }
        '[' if both("\"data_cost\"", "\"parameters\"") => Some(Ours::Report),
        _ if columns() || TABLES.iter().any(|begin| first.starts_with(begin)) => Some(Ours::Table),
        _ => None,
    }
}

/// True if the header of an MCAP file names one of our writers.
fn recorded(head: &[u8]) -> bool {
    // Opcode and length, then profile and library, each with its length.
    let text_at = |at: usize| {
        let length = u32::from_le_bytes(head.get(at..at + 4)?.try_into().ok()?) as usize;
        Some((head.get(at + 4..)?.get(..length)?, at + 4 + length))
    };
    let library = text_at(MCAP.len() + 8).and_then(|(_, at)| text_at(at));
    library.is_some_and(|(library, _)| library.starts_with(b"tribodyn"))
}

fn holds(bytes: &[u8], part: &[u8]) -> bool {
    bytes.windows(part.len()).any(|window| window == part)
}

#[cfg(test)]
mod tests {
    use super::{Ours, PAGE, told};

    #[test]
    fn limit_files_of_others_are_not_ours() {
        for text in
            ["<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1\"/>", "{}", "[]", "a,b\n1,2\n", "<html></html>", "x"]
        {
            assert_eq!(told(text), None, "{text}");
        }
        assert_eq!(told(&format!("<!DOCTYPE html>\n<head>{PAGE}")), Some(Ours::Report));
        assert_eq!(told("ring_z_kn,converged,error,cage_speed_rpm\n"), Some(Ours::Table));
        assert_eq!(told("member,ring_z_kn,complete,cage_speed_mean_rpm,error\n"), Some(Ours::Table));
    }
}
