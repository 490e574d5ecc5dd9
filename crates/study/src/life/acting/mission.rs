//! A mission: phases of speed, load and fluid, one after the other, over and over.

use crate::error::StudyError;
use tribodyn::{CaseFile, Change, Limits};

/// One phase of a mission.
pub struct Phase {
    /// Its number and values, for tables.
    pub name: String,
    /// How long it lasts, s; without end where there is no mission.
    pub duration_s: f64,
    /// The case as it is in this phase.
    pub file: CaseFile,
}

/// Phases that are repeated.
pub struct Mission {
    /// In the order in which they run.
    pub phases: Vec<Phase>,
}

impl Mission {
    /// The case as it is, without end.
    pub fn steady(file: &CaseFile, limits: &Limits) -> Result<Self, StudyError> {
        let file = CaseFile::from_text(&file.name, file.text.clone(), &[], limits)?;
        Ok(Self { phases: vec![Phase { name: "steady".to_owned(), duration_s: f64::INFINITY, file }] })
    }

    /// A table: first the duration, in the column `s`, `min` or `h`, then values of the case by their paths as in
    /// `--set`, in the notation of case files. A line for each phase; fields are parted by commas, lines that begin
    /// with `#` and empty ones are left out.
    ///
    /// ```text
    /// s,   speed.inner.Constant, ring.z.Force
    /// 70,  rpm(9000),            kN(30)
    /// 600, rpm(14000),           kN(55)
    /// ```
    ///
    /// # Errors
    /// A table that cannot be read, with its line, and values that the case refuses.
    pub fn read(text: &str, file: &CaseFile, limits: &Limits) -> Result<Self, StudyError> {
        let refused = |line: usize, message: String| StudyError::argument("mission", format!("line {line}"), message);
        let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
        let Some((_, head)) = lines.next() else {
            return Err(refused(1, "a table needs a line of names: s, min or h, then paths of the case".to_owned()));
        };
        let names: Vec<&str> = head.split(',').map(str::trim).collect();
        let unit = match names[0] {
            "s" => 1.0,
            "min" => 60.0,
            "h" => 3600.0,
            other => return Err(refused(1, format!("the first column is `{other}`: allowed is s, min or h"))),
        };
        let mut phases = Vec::new();
        for (number, line) in lines {
            let cells = split(line);
            if cells.len() != names.len() {
                let message = format!("has {} fields, the line of names {}", cells.len(), names.len());
                return Err(refused(number + 1, message));
            }
            let duration_s = cells[0].parse().ok().map(|value: f64| value * unit).filter(|s| *s > 0.0 && s.is_finite());
            let Some(duration_s) = duration_s else {
                return Err(refused(number + 1, format!("`{}`: allowed is a duration above 0", cells[0])));
            };
            let changes: Vec<Change> = names
                .iter()
                .zip(&cells)
                .skip(1)
                .map(|(path, value)| Change::new(format!("mission, line {}: {path}={value}", number + 1), path, value))
                .collect();
            let file = CaseFile::from_text(&file.name, file.text.clone(), &changes, limits)?;
            let name = std::iter::once((phases.len() + 1).to_string()).chain(cells[1..].iter().cloned());
            phases.push(Phase { name: name.collect::<Vec<_>>().join(" "), duration_s, file });
        }
        if phases.is_empty() {
            return Err(refused(1, "there is no phase below the line of names".to_owned()));
        }
        Ok(Self { phases })
    }

    /// Duration of all phases, s.
    pub fn cycle_s(&self) -> f64 {
        self.phases.iter().map(|phase| phase.duration_s).sum()
    }
}

/// Fields between commas that stand outside parentheses: a value may be a list.
fn split(line: &str) -> Vec<String> {
    let (mut fields, mut depth) = (vec![String::new()], 0_i32);
    for letter in line.chars() {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        match letter {
            ',' if depth == 0 => fields.push(String::new()),
            _ => fields.last_mut().expect("there is a first field").push(letter),
        }
    }
    fields.into_iter().map(|field| field.trim().to_owned()).collect()
}
