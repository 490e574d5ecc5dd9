//! The runs behind the rows: one set of parameters, and what each run changes.

use super::{Transient, run_all};
use crate::error::PaperError;
use crate::files;
use std::path::Path;
use tribodyn_identify::Adapt;

/// A run to make.
#[derive(Debug, Clone)]
pub struct Plan {
    pub id: String,
    pub label: String,
    /// Case file, relative to the workspace.
    pub file: String,
    /// Paths of the case file and their values.
    pub changes: Vec<(String, String)>,
    /// Changes of the bearing that no case file can express.
    pub adapt: Option<Adapt>,
}

/// Cases of one reading of the paper's models: silver, PTFE film, and the outer race with a defect.
#[derive(Debug, PartialEq)]
pub struct Reading {
    /// Case files, relative to the workspace.
    pub ag: &'static str,
    pub ptfe: &'static str,
    pub defect: &'static str,
    /// The axial load of the cases, N, which the paper's preloads are parts of.
    pub axial_load: f64,
    /// Their radial load, N.
    pub radial_load: f64,
}

/// The reading with the most evidence: no friction holds the gyroscopic moment in the paper's QSJH.
pub const AUTHORS: Reading = Reading {
    ag: "fixtures/cases/paper-authors-ag.ron",
    ptfe: "fixtures/cases/paper-authors-ptfe.ron",
    defect: "fixtures/cases/paper-authors-ag-defect.ron",
    axial_load: 46_140.0,
    radial_load: 20_370.0,
};
/// Jones and Harris as their books have it: the outer race holds the whole gyroscopic moment.
pub const CLASSICAL: Reading = Reading {
    ag: "fixtures/cases/paper-ag.ron",
    ptfe: "fixtures/cases/paper-ptfe.ron",
    defect: "fixtures/cases/paper-ag-defect.ron",
    axial_load: 54_760.0,
    radial_load: 22_980.0,
};

/// The fast scheme of runs that are many.
pub const FAST: &str = "Fast(step: us(20))";
/// Long enough for these rows: they settle within 0.05 s.
const PRELOAD_DURATION: &str = "s(0.12)";
/// Half of the paper's step: at a quarter of the load a ball skids and the classical Runge–Kutta method is stable to
/// 8.6e-6 s.
const PRELOAD_SCHEME: &str = "RungeKutta4(step: us(5))";

impl Plan {
    pub fn new(id: &str, label: &str, file: &str) -> Self {
        Self { id: id.to_owned(), label: label.to_owned(), file: file.to_owned(), changes: Vec::new(), adapt: None }
    }

    #[must_use]
    pub fn with(mut self, path: &str, value: &str) -> Self {
        self.changes.push((path.to_owned(), value.to_owned()));
        self
    }

    #[must_use]
    pub fn with_all(self, changes: &[(String, String)]) -> Self {
        changes.iter().fold(self, |plan, (path, value)| plan.with(path, value))
    }
}

impl Reading {
    /// The reading that a case is the silver one of.
    pub fn of(case: &Path) -> Option<&'static Self> {
        let place = case.canonicalize().ok()?;
        let same = |reading: &&Self| files::root().join(reading.ag).canonicalize().is_ok_and(|path| path == place);
        [&AUTHORS, &CLASSICAL].into_iter().find(same)
    }

    pub fn ag(&self) -> Plan {
        Plan::new("ag", "Ag coating", self.ag)
    }

    pub fn ptfe(&self) -> Plan {
        Plan::new("ptfe", "PTFE film", self.ptfe)
    }

    /// A part of the axial load with the whole radial load.
    pub fn axial(&self, percent: u32) -> Plan {
        let load = self.axial_load * f64::from(percent) / 100.0;
        Plan::new(&format!("axial-{percent}"), &format!("{percent} % axial load"), self.ag)
            .with("ring.z", &format!("Force(N({load}))"))
            .with("transient.duration", PRELOAD_DURATION)
            .with("transient.scheme", PRELOAD_SCHEME)
    }

    /// Silver, PTFE, and 25, 50 and 75 % of the axial load.
    fn plans(&self) -> [Plan; 5] {
        [self.ag(), self.ptfe(), self.axial(25), self.axial(50), self.axial(75)]
    }

    pub fn defect(&self) -> Plan {
        Plan::new("defect", "outer-race defect", self.defect)
    }
}

/// One thing that is otherwise in all runs of a set with the fast scheme.
#[derive(Debug, Clone)]
pub struct Change {
    pub name: String,
    /// Paths of the case file and their values, set last.
    pub values: Vec<(String, String)>,
    /// Load that the percentages of the axial load refer to, over the case's.
    pub axial_share: f64,
    /// True if the radial load is lowered with the axial one.
    pub radial_follows: bool,
    /// Changes of the bearing that no case file can express.
    pub adapt: Option<Adapt>,
}

impl Change {
    pub fn none(name: &str) -> Self {
        Self { name: name.to_owned(), values: Vec::new(), axial_share: 1.0, radial_follows: false, adapt: None }
    }

    #[must_use]
    pub fn with(mut self, path: &str, value: &str) -> Self {
        self.values.push((path.to_owned(), value.to_owned()));
        self
    }

    fn plan(&self, reading: &Reading, plan: Plan, percent: f64) -> Plan {
        let axial = reading.axial_load * self.axial_share * percent / 100.0;
        let plan = plan.with("transient.scheme", FAST).with("ring.z", &format!("Force(N({axial}))"));
        let plan = Plan { adapt: self.adapt.clone(), ..plan };
        match self.radial_follows {
            true => plan.with("ring.x", &format!("Force(N({}))", reading.radial_load * percent / 100.0)),
            false => plan,
        }
    }
}

/// All runs of the dynamic rows.
#[derive(Debug)]
pub struct Set {
    pub ag: Transient,
    pub ptfe: Transient,
    /// 25, 50 and 75 % of the axial load; the full one is `ag`.
    pub axial: [Transient; 3],
    /// Only where its rows are asked for.
    pub defect: Option<Transient>,
}

impl Set {
    /// Runs them with changes of the case, set last; recordings go into the folder if there is one.
    pub fn run(reading: &Reading, changes: &[(String, String)], recordings: Option<&Path>) -> Result<Self, PaperError> {
        Self::of(reading.plans(), Some(reading.defect()), changes, recordings)
    }

    /// The same runs without the defect.
    pub fn healthy(reading: &Reading, changes: &[(String, String)]) -> Result<Self, PaperError> {
        Self::of(reading.plans(), None, changes, None)
    }

    /// The set without the defect, with something changed and the fast scheme.
    pub fn changed(reading: &Reading, change: &Change) -> Result<Self, PaperError> {
        let [ag, ptfe, a, b, c] = reading.plans();
        let part = |plan: Plan, percent: f64| change.plan(reading, plan, percent);
        let plans = [part(ag, 100.0), part(ptfe, 100.0), part(a, 25.0), part(b, 50.0), part(c, 75.0)];
        Self::of(plans, None, &change.values, None)
    }

    /// The plans of silver, PTFE and 25, 50, 75 %, and that of the defect.
    fn of(
        healthy: [Plan; 5],
        defect: Option<Plan>,
        changes: &[(String, String)],
        recordings: Option<&Path>,
    ) -> Result<Self, PaperError> {
        // The longest first, so that no core waits at the end.
        let plans: Vec<Plan> = defect.into_iter().chain(healthy).map(|plan| plan.with_all(changes)).collect();
        let mut runs = run_all(&plans, recordings)?;
        let [ag, ptfe, a, b, c] = runs
            .split_off(plans.len() - 5)
            .try_into()
            .map_err(|_| PaperError::Check { what: "dynamic runs", findings: vec!["not all came back".to_owned()] })?;
        Ok(Self { ag, ptfe, axial: [a, b, c], defect: runs.pop() })
    }

    pub fn all(&self) -> impl Iterator<Item = &Transient> {
        [&self.ag, &self.ptfe].into_iter().chain(&self.axial).chain(&self.defect)
    }

    /// Loads 25 to 100 %.
    pub fn by_load(&self) -> [(u32, &Transient); 4] {
        let [a, b, c] = &self.axial;
        [(25, a), (50, b), (75, c), (100, &self.ag)]
    }
}
