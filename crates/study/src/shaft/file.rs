//! The file of a shaft with the cases of its bearings.

use crate::case_file::{read_case, read_text};
use crate::error::StudyError;
use std::path::{Path, PathBuf};
use tribodyn::{AnswerError, CaseFile, Change, Limits, RefusedCase};
use tribodyn_bearing::BearingError;
use tribodyn_case::{
    BearingChoice, Carries, Case, CaseError, Fit, HousingFile, ShaftBearingSpec, ShaftSystem, SpeedSpec,
};
use tribodyn_catalogue::{Given, NewCase, find};

/// A shaft's file, changes made, with all that it names.
pub struct ShaftFile {
    /// Name for messages.
    pub name: String,
    /// Contents of the file.
    pub system: ShaftSystem,
    /// The case of each bearing, as it runs on the shaft but for its speed.
    pub cases: Vec<Case>,
    /// Rows of the housing's stiffness over five freedoms of each seat, where there is one.
    pub housing: Option<Vec<Vec<f64>>>,
}

impl ShaftFile {
    /// Reads the file, makes the changes, and reads what it names.
    ///
    /// # Errors
    /// [`StudyError`] with the place in the file.
    pub fn read(path: &Path, changes: &[Change], limits: &Limits) -> Result<Self, StudyError> {
        let name = path.display().to_string();
        let mut text = read_text(path, limits)?;
        for change in changes {
            text = change
                .apply(&text)
                .map_err(|error| AnswerError::Change { option: change.to_string(), error: Box::new(error) })?;
        }
        let folder = path.parent().map_or_else(PathBuf::new, Path::to_owned);
        Self::from_text(&name, &text, &folder, limits)
    }

    /// From a text; what it names stands in a folder.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn from_text(name: &str, text: &str, folder: &Path, limits: &Limits) -> Result<Self, StudyError> {
        let refused = |error: CaseError| {
            let (file, text) = (name.to_owned(), text.to_owned());
            StudyError::from(AnswerError::Case(Box::new(RefusedCase { file, options: String::new(), text, error })))
        };
        let system = ShaftSystem::from_ron(text).map_err(refused)?;
        let too_many = |message: String| refused(CaseError::at(text, "shaft.longest_element", message));
        super::build::check_elements(&system).map_err(too_many)?;
        let mut cases = Vec::with_capacity(system.bearings.len());
        for (index, spec) in system.bearings.iter().enumerate() {
            let at = |field: &str, message: String| {
                let path = format!("bearings[{index}].{field}");
                refused(CaseError::at(text, &path, message))
            };
            let mut case = match &spec.bearing {
                BearingChoice::Listed(designation) => {
                    listed_case(designation, Given::default(), &[], limits).map_err(|error| match error {
                        StudyError::Answer(AnswerError::Catalogue(error)) => at("bearing", error.to_string()),
                        other => other,
                    })?
                }
                BearingChoice::Case(file) => read_case(&folder.join(file), &[], limits)?.case,
            };
            if let Some(fits) = &spec.fits {
                let mounted = super::fits::mounting(&system, spec.at, fits, &case);
                case.mounting = Some(mounted.map_err(|(field, message)| at(field, message))?);
            }
            if let Some(mounting) = spec.mounting {
                case.mounting = Some(mounting);
            }
            let own = spec.fits.is_some() || spec.mounting.is_some();
            if let Some((path, message)) = case.check_mounting().err().filter(|_| own) {
                return Err(at(&own_field(spec, &path), message));
            }
            if let Some(clearance) = spec.clearance {
                case.geometry.fit = Fit::RadialClearance(clearance);
                case.mounting = None;
                case.geometry.resolve().map_err(|error| at("clearance", in_microns(&error)))?;
            }
            if spec.carries == Carries::Both && matches!(case.geometry.fit, Fit::ContactAngle(_)) {
                let message = "an angular-contact bearing carries one direction; allowed are PlusZ, MinusZ".to_owned();
                return Err(at("carries", message));
            }
            cases.push(case);
        }
        let housing = match &system.housing {
            Some(HousingFile::Matrix(file)) => Some(matrix(&folder.join(file), system.bearings.len(), limits)?),
            None => None,
        };
        Ok(Self { name: name.to_owned(), system, cases, housing })
    }

    /// A bearing with the name of its file, for messages.
    pub(super) fn bearing_name(&self, index: usize) -> String {
        format!("{}: bearing {}", self.name, self.system.bearings[index].name)
    }

    /// The case of a bearing at a speed of the shaft in rad/s: fits and growth are those of that speed.
    pub fn case_at(&self, index: usize, speed: f64) -> Case {
        let mut case = self.cases[index].clone();
        let constant = tribodyn_bearing::SpeedHistory::Constant;
        case.speed = SpeedSpec { inner: constant(speed), outer: constant(0.0) };
        case
    }
}

/// Why a clearance is refused, its numbers as people write them.
fn in_microns(error: &BearingError) -> String {
    let microns = |metres: f64| format!("{:.0}", metres * 1e6);
    match *error {
        BearingError::Clearance { clearance, least, most } => format!(
            "{} µm are no radial clearance of this bearing; allowed are {} to {} µm",
            microns(clearance),
            microns(least),
            microns(most)
        ),
        _ => error.to_string(),
    }
}

/// The field of a shaft's bearing that a path of its case's mounting came from.
fn own_field(spec: &ShaftBearingSpec, path: &str) -> String {
    if spec.mounting.is_some() {
        return path.to_owned();
    }
    let ring = if path.contains(".outer") { "housing" } else { "shaft" };
    match path.rsplit('.').next() {
        Some("class") => format!("fits.{ring}"),
        Some("far_diameter") if ring == "housing" => "fits.housing_outside".to_owned(),
        Some(field @ ("roughness" | "expansion")) => format!("fits.{field}"),
        _ => "fits".to_owned(),
    }
}

/// The case of a file, or of a designation of the built-in list with what is given besides, which is at rest.
///
/// # Errors
/// As [`read_case`] and [`listed_case`]; fits and lubricant of a case file, which has its own.
pub fn named_case(bearing: &str, given: Given, changes: &[Change], limits: &Limits) -> Result<Case, StudyError> {
    let path = Path::new(bearing);
    if path.extension().is_some_and(|ending| ending == "ron") || path.exists() {
        if let Some(class) = given.fits.shaft.or(given.fits.housing) {
            let why = "a case file has its fits in its section mounting: change it there or by --set";
            return Err(StudyError::argument("fit", class, why));
        }
        if let Some(word) = given.lubricant {
            let why = "a case file has its own lubricant: change it there or by --set";
            return Err(StudyError::argument("lubricant", word, why));
        }
        return Ok(read_case(path, changes, limits)?.case);
    }
    listed_case(bearing, given, changes, limits)
}

/// A case of the built-in list, at rest, with changes.
///
/// # Errors
/// A designation that is not in the list, and changes that cannot be made.
pub fn listed_case(designation: &str, given: Given, changes: &[Change], limits: &Limits) -> Result<Case, StudyError> {
    // Where nobody has said what oil it runs in lives are basic ones.
    let lubricant = given.lubricant.or_else(|| Some("ag".to_owned()));
    let given = Given { lubricant, ..given };
    let text = find(designation, None).and_then(|found| NewCase::of_listed(found, designation).given(given)?.text());
    let text = text.map_err(AnswerError::from)?;
    let mut case = CaseFile::from_text(designation, text, changes, limits)?.case;
    if !changes.iter().any(|change| change.concerns("speed.inner")) {
        case.speed.inner = tribodyn_bearing::SpeedHistory::Constant(0.0);
    }
    Ok(case)
}

/// A matrix of 5 or 6 rows and columns for each seat; the sixth, about z, is left out. Plain numbers, or the stiffness
/// of a substructure that CalculiX or Abaqus writes.
fn matrix(path: &Path, seats: usize, limits: &Limits) -> Result<Vec<Vec<f64>>, StudyError> {
    let text = read_text(path, limits)?;
    let refused = |line: usize, message: String| StudyError::Matrix { path: path.to_owned(), line, message };
    if let Some(start) = text.lines().position(|line| line.to_uppercase().starts_with("*MATRIX,TYPE=STIFFNESS")) {
        return square(&substructure(&text, start + 1, &refused)?, seats, &refused);
    }
    let mut rows = Vec::new();
    for (index, line) in text.lines().enumerate() {
        if line.trim().is_empty() || line.starts_with('#') {
            continue;
        }
        let numbers = line.split([',', ';', ' ', '\t']).filter(|word| !word.is_empty());
        let numbers: Result<Vec<f64>, _> = numbers.map(str::parse::<f64>).collect();
        match numbers {
            Ok(row) if row.iter().all(|number| number.is_finite()) => rows.push(row),
            _ => return Err(refused(index + 1, "allowed are finite numbers parted by commas".to_owned())),
        }
    }
    square(&rows, seats, &refused)
}

/// Rows of the lower triangle that CalculiX and Abaqus write of a substructure, from a line on, made whole.
fn substructure(
    text: &str,
    start: usize,
    refused: &impl Fn(usize, String) -> StudyError,
) -> Result<Vec<Vec<f64>>, StudyError> {
    let mut all = Vec::new();
    for (index, line) in text.lines().enumerate().skip(start) {
        if line.starts_with('*') {
            break;
        }
        for word in line.split([',', ' ', '\t']).filter(|word| !word.is_empty()) {
            let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
            all.push(
                number.ok_or_else(|| refused(index + 1, "allowed are finite numbers parted by commas".to_owned()))?,
            );
        }
    }
    let count = (((8 * all.len() + 1) as f64).sqrt() as usize).saturating_sub(1) / 2;
    if count * (count + 1) / 2 != all.len() {
        let message = format!("{} numbers are no lower triangle of a matrix", all.len());
        return Err(refused(start + 1, message));
    }
    let at = |row: usize, column: usize| all[row.max(column) * (row.max(column) + 1) / 2 + row.min(column)];
    Ok((0..count).map(|row| (0..count).map(|column| at(row, column)).collect()).collect())
}

/// A matrix over five or six freedoms of each seat, the sixth left out.
fn square(
    rows: &[Vec<f64>],
    seats: usize,
    refused: &impl Fn(usize, String) -> StudyError,
) -> Result<Vec<Vec<f64>>, StudyError> {
    let of = if rows.len() == 6 * seats { 6 } else { 5 };
    let n = of * seats;
    if rows.len() != n || rows.iter().any(|row| row.len() != n) {
        let message = format!("{} rows; allowed are 5 or 6 rows and columns for each of {seats} seats", rows.len());
        return Err(refused(1, message));
    }
    let kept = |k: &usize| k % of < 5;
    let row = |i: usize| (0..n).filter(kept).map(|j| rows[i][j]).collect();
    Ok((0..n).filter(kept).map(row).collect())
}
