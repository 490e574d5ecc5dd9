//! The paper's figures, read from `fixtures/reference/zhang2025`.

use crate::error::PaperError;
use crate::table::Table;

/// Curve parameters of one coating at one pressure.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveRow {
    pub coating: String,
    /// As printed, GPa.
    pub pressure_label: String,
    /// GPa.
    pub pressure: f64,
    /// A, B, C, D.
    pub parameters: [f64; 4],
}

/// A cage speed of Table 4.
#[derive(Debug, Clone, PartialEq)]
pub struct SpeedRow {
    pub id: String,
    pub model: String,
    /// r/min.
    pub cage_speed: f64,
    /// Against the test, %; none for the test itself.
    pub error: Option<f64>,
}

/// Pressures of Table 5 at one azimuth.
#[derive(Debug, Clone, PartialEq)]
pub struct PressureRow {
    /// Degrees.
    pub azimuth: f64,
    /// Inner and outer, GPa.
    pub pressure: [f64; 2],
    /// Half of the last digit, GPa.
    pub uncertainty: f64,
}

/// Everything of the paper that the quasi-static rows are compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct Published {
    pub curves: Vec<CurveRow>,
    pub speeds: Vec<SpeedRow>,
    pub pressures: Vec<PressureRow>,
    /// Cage speed of the test, r/min.
    pub tested_speed: f64,
}

impl Published {
    pub fn read() -> Result<Self, PaperError> {
        let curves = table("table2.csv", include_str!("../../../../fixtures/reference/zhang2025/table2.csv"))?;
        let speeds = table("table4.csv", include_str!("../../../../fixtures/reference/zhang2025/table4.csv"))?;
        let pressures = table("table5.csv", include_str!("../../../../fixtures/reference/zhang2025/table5.csv"))?;
        let speeds = speeds.rows().map(|row| {
            let id = row.text("id")?.to_owned();
            let error = if id == "test" { None } else { Some(row.number("error_percent")?) };
            let model = row.text("model")?.to_owned();
            Ok(SpeedRow { id, model, cage_speed: row.number("cage_speed_rpm")?, error })
        });
        let speeds = speeds.collect::<Result<Vec<_>, PaperError>>()?;
        let tested = speeds.iter().find(|row| row.id == "test").map(|row| row.cage_speed);
        let no_test = || PaperError::Table { file: path("table4.csv"), line: 1, message: "no row `test`".into() };
        Ok(Self {
            curves: curves.rows().map(curve).collect::<Result<_, PaperError>>()?,
            pressures: pressures.rows().map(pressure).collect::<Result<_, PaperError>>()?,
            speeds,
            tested_speed: tested.ok_or_else(no_test)?,
        })
    }
}

fn path(name: &str) -> String {
    format!("fixtures/reference/zhang2025/{name}")
}

fn table(name: &str, text: &str) -> Result<Table, PaperError> {
    Table::read(&path(name), text)
}

fn curve(row: crate::table::Row) -> Result<CurveRow, PaperError> {
    Ok(CurveRow {
        coating: row.text("coating")?.to_owned(),
        pressure_label: row.text("pressure_gpa")?.to_owned(),
        pressure: row.number("pressure_gpa")?,
        parameters: [row.number("a")?, row.number("b")?, row.number("c")?, row.number("d")?],
    })
}

fn pressure(row: crate::table::Row) -> Result<PressureRow, PaperError> {
    Ok(PressureRow {
        azimuth: row.number("azimuth_deg")?,
        pressure: [row.number("inner_gpa")?, row.number("outer_gpa")?],
        uncertainty: row.half_digit("inner_gpa")?.max(row.half_digit("outer_gpa")?),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_printed_errors_follow_from_printed_speeds() {
        let published = Published::read().unwrap();
        for row in published.speeds.iter().filter(|row| row.id != "test") {
            let error = (row.cage_speed / published.tested_speed - 1.0).abs() * 100.0;
            // Speeds are rounded to 1 r/min, errors to 0.01 %.
            let rounding = 0.5 / published.tested_speed * 100.0 + 0.005;
            assert!((error - row.error.unwrap()).abs() <= rounding, "{}: {error}", row.id);
        }
    }

    #[test]
    fn identity_printed_pressures_are_symmetric_and_periodic() {
        let rows = Published::read().unwrap().pressures;
        assert_eq!(rows.len(), 7);
        for (row, mirrored) in rows.iter().zip(rows.iter().rev()) {
            assert_eq!((row.azimuth, row.pressure), (360.0 - mirrored.azimuth, mirrored.pressure));
        }
    }

    #[test]
    fn identity_printed_curves_start_at_zero() {
        let rows = Published::read().unwrap().curves;
        assert_eq!(rows.len(), 6);
        for CurveRow { parameters: [a, _, _, d], .. } in rows {
            assert_eq!(a, -d);
        }
    }
}
