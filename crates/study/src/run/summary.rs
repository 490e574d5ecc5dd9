//! Summary of a recorded run in a few numbers.

use super::balance::{Judgement, judge};
use super::cage::CageMotion;
use super::known::{KnownAtEnd, KnownAtStart};
use super::settled::Settled;
use super::warnings::worn_through_unseen;
use serde::ser::{Serialize, SerializeMap, Serializer};
use tribodyn_bearing::quantities::joined;
use tribodyn_case::Case;
use tribodyn_dynamics::{ACCELERATION_ERROR, ACCELERATION_PART, POWER_IN, POWER_LOST, PowerSample};
use tribodyn_record::WearRow;

/// Numbers of a run; means, rms and extremes are of its second half, where what is left of the start has faded most, or
/// of what is left once the run is steady, if that is later.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Summary {
    /// Time at the end, s.
    pub simulated_s: f64,
    /// From when on the averages are taken.
    pub averaged_from_s: f64,
    /// From when on the run is steady; none where it is not, or cannot be judged.
    pub settled_at_s: Option<f64>,
    /// How steady the run is.
    #[serde(skip)]
    pub settled: Settled,
    /// Samples of the whole run.
    pub samples: usize,
    /// Mean cage speed, r/min.
    pub cage_speed_mean_rpm: f64,
    /// Cage speed of the first sample, r/min.
    pub cage_speed_start_rpm: f64,
    /// Cage speed at the end, r/min.
    pub cage_speed_end_rpm: f64,
    /// Least orbital speed of a ball, r/min.
    pub orbital_speed_min_rpm: f64,
    /// Largest orbital speed of a ball, r/min.
    pub orbital_speed_max_rpm: f64,
    /// About the mean.
    pub outer_acceleration_x_rms_m_s2: f64,
    /// About the mean.
    pub outer_acceleration_y_rms_m_s2: f64,
    /// Farthest from the mean.
    pub outer_acceleration_x_peak_m_s2: f64,
    /// Farthest from the mean.
    pub outer_acceleration_y_peak_m_s2: f64,
    /// Largest contact load at the inner race, N.
    pub load_inner_max_n: f64,
    /// Largest contact load at the outer race, N.
    pub load_outer_max_n: f64,
    /// Highest peak pressure at the inner race, GPa.
    pub peak_pressure_inner_max_gpa: f64,
    /// Highest peak pressure at the outer race, GPa.
    pub peak_pressure_outer_max_gpa: f64,
    /// Largest force between a ball and its pocket, N.
    pub pocket_force_max_n: f64,
    /// The cage, where it is free to move.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cage: Option<CageMotion>,
    /// In the whole run.
    pub impacts: u32,
    /// Fewest balls that carried load at both races at one time.
    pub balls_in_contact_min: u32,
    /// Mean powers.
    pub power: Powers,
    /// Worn volumes and coatings left.
    pub wear: Worn,
    /// Of the log, and of the balance of work.
    pub warnings: Vec<String>,
}

/// Mean powers and how well they balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Powers {
    /// Means of the terms of the balance; energy and work are not among them.
    pub mean: PowerSample,
    /// Energy that moving and pressed parts took up, W.
    pub stored_w: f64,
    /// Work missing at the end over all work put in, %.
    pub imbalance_percent: f64,
}

impl Powers {
    /// The losses by name, and what was stored.
    pub fn out(&self) -> Vec<(&'static str, f64)> {
        let lost = POWER_LOST.iter().filter_map(|term| Some((term.facts.label, (term.get)(&self.mean)?)));
        lost.chain([("stored", self.stored_w)]).collect()
    }
}

impl Serialize for Powers {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for term in POWER_IN.iter().chain(&POWER_LOST) {
            let name = joined(&[term.facts.name, term.facts.unit.suffix]);
            map.serialize_entry(&name, &(term.get)(&self.mean))?;
        }
        map.serialize_entry("stored_w", &self.stored_w)?;
        map.serialize_entry("imbalance_percent", &self.imbalance_percent)?;
        map.end()
    }
}

/// True if the patch rule is fine enough for accelerations; an error that is not known does not speak against it.
pub fn carries_accelerations_of_patch(patch_error_estimate: Option<f64>) -> bool {
    patch_error_estimate.is_none_or(|error| error <= ACCELERATION_ERROR)
}

/// True if an error of the scheme, m/s², is small against accelerations along x and y, rms, m/s². One that is not known
/// carries none.
pub fn carries_accelerations_of_scheme(error_m_s2: Option<f64>, [x, y]: [f64; 2]) -> bool {
    error_m_s2.is_some_and(|error| error <= ACCELERATION_PART * x.hypot(y))
}

/// True if the accelerations of a run are carried: by the patch rule, and by step, patch and linear traction together
/// against the accelerations themselves. A run that is too short to tell, or was cut off, carries none.
pub fn carries_accelerations(summary: &Summary, known: &KnownAtStart, outcome: Option<&KnownAtEnd>) -> bool {
    let error_m_s2 = outcome.and_then(|outcome| outcome.acceleration_error_m_s2);
    let rms = [summary.outer_acceleration_x_rms_m_s2, summary.outer_acceleration_y_rms_m_s2];
    carries_accelerations_of_scheme(error_m_s2, rms) && carries_accelerations_of_patch(known.patch_error_estimate)
}

/// A sentence where the accelerations of a run are not carried.
pub(crate) fn unresolved(summary: &Summary, known: &KnownAtStart, outcome: Option<&KnownAtEnd>) -> Option<String> {
    (!carries_accelerations(summary, known, outcome)).then(|| {
        let rms = summary.outer_acceleration_x_rms_m_s2.hypot(summary.outer_acceleration_y_rms_m_s2);
        match outcome.and_then(|outcome| outcome.acceleration_error_m_s2) {
            Some(error) => format!(
                "accelerations of the outer ring are not resolved: step and patch err by {error:.3} m/s², the \
                 accelerations have {rms:.3} m/s² rms"
            ),
            None => "accelerations of the outer ring may not be resolved: the run is too short to tell their error"
                .to_owned(),
        }
    })
}

/// Wear since the start, without the acceleration of wear.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct Worn {
    /// Of the inner race, µm³.
    pub volume_inner_um3: f64,
    /// Of the outer race, µm³.
    pub volume_outer_um3: f64,
    /// Of the cage, µm³.
    pub volume_cage_um3: f64,
    /// Thinnest coating left at the inner race, µm.
    pub coating_inner_min_um: f64,
    /// The same at the outer race, µm.
    pub coating_outer_min_um: f64,
    /// When this was so.
    pub at_s: f64,
}

impl Summary {
    /// With a warning where the work of the run does not balance as it should by this case's scheme.
    pub fn judged(mut self, case: &Case) -> Self {
        if let Judgement::Off { reason, .. } = judge(self.power.imbalance_percent, case) {
            self.warnings.push(reason);
        }
        let volumes = [self.wear.volume_inner_um3, self.wear.volume_outer_um3];
        let loads = [self.load_inner_max_n, self.load_outer_max_n];
        self.warnings.extend(worn_through_unseen(case, volumes, loads));
        self
    }
}

impl Worn {
    pub(crate) fn of(row: &WearRow) -> Self {
        Self {
            volume_inner_um3: row.volume_inner_um3,
            volume_outer_um3: row.volume_outer_um3,
            volume_cage_um3: row.volume_cage_um3,
            coating_inner_min_um: row.coating_inner_min_um,
            coating_outer_min_um: row.coating_outer_min_um,
            at_s: row.time_s,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_case::set_value;
    use tribodyn_record::StateRow;

    #[test]
    fn limit_averages_are_of_the_second_half() {
        let row = |k: i32| StateRow {
            time_s: 0.01 * f64::from(k),
            cage_speed_rpm: if k < 5 { 0.0 } else { 6000.0 + f64::from(k % 2) },
            outer_acceleration_x_m_s2: if k < 5 { 99.0 } else { 3.0 + 2.0 * f64::from(k % 2) },
            energy_j: 7.0 * f64::from(k),
            impacts: 4,
            ..StateRow::default()
        };
        let rows: Vec<StateRow> = (0..=10).map(row).collect();
        let summary = Summary::of(&rows, None, &[]).unwrap();
        assert_eq!((summary.averaged_from_s, summary.samples, summary.impacts), (0.05, 11, 4));
        assert!((summary.cage_speed_mean_rpm - 6000.5).abs() < 1e-9);
        assert!((summary.outer_acceleration_x_rms_m_s2 - 1.0).abs() < 1e-12);
        assert!((summary.power.stored_w - 700.0).abs() < 1e-9);
        assert!(summary.warnings.is_empty());
        assert_eq!(Summary::of(&[], None, &[]), None);
        assert!(Summary::of(&rows[..1], None, &[]).is_some());
    }

    #[test]
    fn limit_work_that_is_missing_is_warned_of() {
        let text = include_str!("../../../../fixtures/cases/paper-ag-worn.ron");
        let warnings = |imbalance_ppb: f64, changes: &[(&str, &str)]| {
            let text =
                changes.iter().fold(text.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
            let row = StateRow { imbalance_ppb, ..StateRow::default() };
            Summary::of(&[row], None, &[]).unwrap().judged(&Case::from_ron(&text).unwrap()).warnings
        };
        let fast = [("transient.scheme", "Fast(step: us(5))")];
        assert!(warnings(9e3, &[]).is_empty() && warnings(-9e6, &fast).is_empty());
        assert!(warnings(-2e4, &[])[0].starts_with("0.0020 % of the work"));
        assert!(warnings(5e8, &fast)[0].starts_with("50.0000 % of the work"));
        // What wear takes is in the balance.
        assert_eq!(warnings(5e8, &[("transient.wear_acceleration", "10")]).len(), 1);
    }
}
