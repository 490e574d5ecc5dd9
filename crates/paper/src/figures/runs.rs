//! The runs that figures need, made once for all of them.

use crate::error::PaperError;
use crate::progress::{Progress, in_time};
use crate::transient::{CLASSICAL, Plan, Transient, run_all};
use crate::validate;
use tribodyn_plot::SolutionCharts;

/// Parts of the axial load of section 5.2.2 of the paper below the full one, percent.
const PRELOADS: [u32; 3] = [25, 50, 75];
/// Duration of a quick run: its second half is longer than an orbit of 10.4 ms, so that every value over the orbit is
/// there.
const QUICK: &str = "s(0.024)";

/// Lengths of transient runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Length {
    /// As the case files have it.
    Full,
    Quick,
}

/// Input of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cases {
    /// The coatings' curves, without a run.
    Curves,
    /// The quasi-static cases 1 to 4 of Table 4.
    Steady,
    Ag,
    /// The outer race with a defect and without.
    Defect,
    Coatings,
    /// 25, 50, 75 and 100 % of the axial load.
    Loads,
}

impl Cases {
    /// The runs, the longest first, so that no core waits at the end.
    fn plans(self) -> Vec<Plan> {
        match self {
            Self::Curves | Self::Steady => Vec::new(),
            Self::Ag => vec![CLASSICAL.ag()],
            Self::Defect => vec![CLASSICAL.defect(), CLASSICAL.ag()],
            Self::Coatings => vec![CLASSICAL.ag(), CLASSICAL.ptfe()],
            Self::Loads => {
                PRELOADS.map(|percent| CLASSICAL.axial(percent)).into_iter().chain([CLASSICAL.ag()]).collect()
            }
        }
    }

    /// Place of the figure's input.
    pub fn text(self) -> &'static str {
        match self {
            Self::Curves => "Coatings `ag` and `ptfe` of the library",
            Self::Steady => {
                "Case `fixtures/cases/paper-ag.ron` with the switches of Table 4's cases 1 to 4 (`varying`, \
                `differential_slip`)"
            }
            Self::Ag => "Case `fixtures/cases/paper-ag.ron`",
            Self::Defect => "Cases `fixtures/cases/paper-ag-defect.ron` and `fixtures/cases/paper-ag.ron`",
            Self::Coatings => "Cases `fixtures/cases/paper-ag.ron` and `fixtures/cases/paper-ptfe.ron`",
            Self::Loads => {
                "Case `fixtures/cases/paper-ag.ron` with 25, 50, 75 and 100 % of its axial load and the whole radial \
                load"
            }
        }
    }
}

/// Finished runs.
pub struct Made {
    transients: Vec<(String, Transient)>,
    steady: Vec<SolutionCharts>,
}

impl Made {
    /// Makes what some figures need, every run once.
    pub fn for_all(
        cases: impl Iterator<Item = Cases> + Clone,
        length: Length,
        progress: Progress,
    ) -> Result<Self, PaperError> {
        let steady = if cases.clone().any(|c| c == Cases::Steady) {
            in_time("quasi-static cases", progress, validate::solution_charts)?
        } else {
            Vec::new()
        };
        let plans = plans(cases, length);
        let ids = plans.iter().map(|plan| plan.id.clone());
        let runs =
            if plans.is_empty() { Vec::new() } else { in_time("transient runs", progress, || run_all(&plans, None))? };
        Ok(Self { transients: ids.zip(runs).collect(), steady })
    }

    fn run(&self, id: &str) -> Result<&Transient, PaperError> {
        let found = self.transients.iter().find(|(known, _)| known == id).map(|(_, run)| run);
        found.ok_or_else(|| PaperError::Check { what: "a figure lacks a run", findings: vec![id.to_owned()] })
    }

    pub fn ag(&self) -> Result<&Transient, PaperError> {
        self.run("ag")
    }

    pub fn defect(&self) -> Result<&Transient, PaperError> {
        self.run("defect")
    }

    /// Silver and PTFE.
    pub fn coatings(&self) -> Result<Vec<(&str, &Transient)>, PaperError> {
        Ok(vec![("Ag coating", self.ag()?), ("PTFE film", self.run("ptfe")?)])
    }

    /// By rising axial load.
    pub fn loads(&self) -> Result<[(&str, &Transient); 4], PaperError> {
        let [a, b, c] = PRELOADS.map(|percent| self.run(&CLASSICAL.axial(percent).id));
        Ok([
            ("25 % axial load", a?),
            ("50 % axial load", b?),
            ("75 % axial load", c?),
            ("100 % axial load", self.ag()?),
        ])
    }

    /// The charts of the quasi-static cases of a name.
    pub fn steady(&self, name: &str) -> Result<SolutionCharts, PaperError> {
        let found = self.steady.iter().find(|charts| charts.name == name).cloned();
        found.ok_or_else(|| PaperError::Check {
            what: "a quasi-static figure is missing",
            findings: vec![name.to_owned()],
        })
    }
}

/// The plans of some cases, each once, the longest first.
fn plans(cases: impl Iterator<Item = Cases>, length: Length) -> Vec<Plan> {
    let mut wanted: Vec<Plan> = Vec::new();
    for plan in cases.flat_map(Cases::plans) {
        if wanted.iter().all(|known| known.id != plan.id) {
            wanted.push(plan);
        }
    }
    let defect = CLASSICAL.defect().id;
    wanted.sort_by_key(|plan| plan.id != defect);
    if length == Length::Full {
        return wanted;
    }
    wanted.into_iter().map(|plan| plan.with("transient.duration", QUICK)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files;
    use tribodyn_case::{Case, set_value};

    #[test]
    fn identity_each_run_is_made_once_and_only_where_it_is_needed() {
        let ids = |cases: &[Cases]| -> Vec<String> {
            plans(cases.iter().copied(), Length::Full).into_iter().map(|plan| plan.id).collect()
        };
        assert!(ids(&[Cases::Curves, Cases::Steady]).is_empty());
        assert_eq!(ids(&[Cases::Ag, Cases::Coatings, Cases::Ag]), ["ag", "ptfe"]);
        assert_eq!(ids(&[Cases::Ag, Cases::Defect, Cases::Loads])[0], "defect");
        assert_eq!(ids(&[Cases::Ag, Cases::Coatings, Cases::Defect, Cases::Loads]).len(), 6);
    }

    #[test]
    fn limit_quick_runs_differ_in_their_duration_alone_and_hold_an_orbit_in_their_second_half() {
        let all = [Cases::Defect, Cases::Coatings, Cases::Loads];
        for (full, quick) in plans(all.into_iter(), Length::Full).iter().zip(plans(all.into_iter(), Length::Quick)) {
            let read = |plan: &Plan| {
                let text = files::read(&files::root().join(&plan.file)).unwrap();
                let set = |text: String, (path, value): &(String, String)| set_value(&text, path, value).unwrap();
                Case::from_ron(&plan.changes.iter().fold(text, set)).unwrap()
            };
            let (full, mut short) = (read(full), read(&quick));
            let duration = |case: &Case| case.transient.as_ref().unwrap().duration;
            assert!(duration(&short) < 0.25 * duration(&full));
            // 5790 r/min, slower than any run of these.
            assert!(0.5 * duration(&short) > 60.0 / 5790.0);
            short.transient.as_mut().unwrap().duration = duration(&full);
            assert_eq!(short, full);
        }
    }
}
