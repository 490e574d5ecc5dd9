//! The five quasi-static solutions of Table 4.

use crate::error::PaperError;
use crate::files;
use std::path::Path;
use tribodyn_bearing::CageBody;
use tribodyn_case::{Case, Source, set_value};
use tribodyn_identify::Adapt;
use tribodyn_orbit::{OrbitSettings, steady_orbit};
use tribodyn_quasistatic::{Model, Solution, other_roots, root_warnings, solve};

/// Equations that a row of Table 4 stands for.
struct Plan {
    id: &'static str,
    label: &'static str,
    model: Model,
    varying: bool,
    differential_slip: bool,
}

const PLANS: [Plan; 5] = [
    Plan { id: "jh", label: "Jones–Harris", model: Model::JonesHarris, varying: true, differential_slip: true },
    Plan { id: "1", label: "case 1", model: Model::Traction, varying: true, differential_slip: true },
    Plan { id: "2", label: "case 2", model: Model::Traction, varying: false, differential_slip: true },
    Plan { id: "3", label: "case 3", model: Model::Traction, varying: true, differential_slip: false },
    Plan { id: "4", label: "case 4", model: Model::Traction, varying: false, differential_slip: false },
];

/// One solved row of Table 4.
#[derive(Debug)]
pub struct Run {
    /// Row of Table 4.
    pub id: &'static str,
    pub label: &'static str,
    /// The case file with the row's switches set.
    pub text: String,
    pub case: Case,
    pub solution: Solution,
    /// Balls with several equilibria or without a rolling one.
    pub roots: Vec<String>,
}

/// All rows of Table 4 that the quasi-static models have.
#[derive(Debug)]
pub struct Runs {
    /// The case file, relative to the workspace where it is inside.
    pub file: String,
    pub jones_harris: Run,
    /// Cases 1 to 4.
    pub cases: [Run; 4],
}

impl Runs {
    pub fn solve(path: &Path) -> Result<Self, PaperError> {
        Self::changed(path, &[])
    }

    /// With other values, by their paths. Those that the rows of Table 4 differ by are theirs.
    pub fn changed(path: &Path, changes: &[(String, String)]) -> Result<Self, PaperError> {
        let file = path.strip_prefix(files::root()).unwrap_or(path).display().to_string();
        let refused = |source| PaperError::Case { file: file.clone(), source: Box::new(source) };
        let set = |text: String, (path, value): &(String, String)| set_value(&text, path, value).map_err(refused);
        let text = changes.iter().try_fold(files::read(path)?, set)?;
        Self::of(file, &text, None)
    }

    /// Of a case's text, its bearings changed by what no case file can express.
    pub fn of(file: String, text: &str, adapt: Option<&Adapt>) -> Result<Self, PaperError> {
        let [first, second, third, fourth, fifth] = &PLANS;
        let one = |plan: &Plan| run(&file, text, adapt, plan);
        let jones_harris = one(first)?;
        let cases = [one(second)?, one(third)?, one(fourth)?, one(fifth)?];
        Ok(Self { file, jones_harris, cases })
    }

    /// The same with the steady orbits of cases 1 to 4 in place of their equilibria, a ball at each of its places.
    pub fn by_orbits(self) -> Result<Self, PaperError> {
        let cases = self.cases.into_iter().map(orbit).collect::<Result<Vec<_>, _>>()?;
        let cases = cases.try_into().map_err(|_| PaperError::Check { what: "orbits", findings: Vec::new() })?;
        Ok(Self { cases, ..self })
    }

    pub fn all(&self) -> impl Iterator<Item = &Run> {
        std::iter::once(&self.jones_harris).chain(&self.cases)
    }

    /// Origin of the parameters that the paper does not print.
    pub fn provenance(&self) -> String {
        let (mut assumed, mut searched, mut identified) = (0, 0, 0);
        for source in self.cases[0].case.sources.values() {
            match source {
                Source::Assumed(_) => assumed += 1,
                Source::Searched(_) => searched += 1,
                Source::Identified { .. } => identified += 1,
                Source::Published(_) | Source::Catalogue(_) | Source::Reference(_) => {}
            }
        }
        let identification = match identified {
            0 => "none is identified yet".to_owned(),
            count => format!("{count} identified"),
        };
        let search = match searched {
            0 => String::new(),
            count => format!("{count} chosen by a search, "),
        };
        format!("of the case's parameters {assumed} are assumed, {search}{identification}")
    }
}

fn orbit(run: Run) -> Result<Run, PaperError> {
    let inputs = run
        .case
        .run_inputs()
        .map_err(|source| PaperError::Inputs { run: run.label.to_owned(), source: Box::new(source) })?;
    let cage = CageBody::new(&inputs.cage, &inputs.bearing);
    let point = run.case.operating_point();
    let speeds = [point.inner_speed, point.outer_speed];
    let found = steady_orbit(&inputs.bearing, &point, &cage, &OrbitSettings::default())
        .map_err(|source| PaperError::Orbit { run: run.label, source: Box::new(source) })?
        .solution;
    Ok(Run { solution: found.as_solution(&found.points, speeds), ..run })
}

fn run(file: &str, text: &str, adapt: Option<&Adapt>, plan: &Plan) -> Result<Run, PaperError> {
    let refused = |source| PaperError::Case { file: file.to_owned(), source: Box::new(source) };
    // Jones–Harris has no traction, so its switches do not matter.
    let text = set_value(text, "traction.varying", &plan.varying.to_string()).map_err(refused)?;
    let text = set_value(&text, "traction.differential_slip", &plan.differential_slip.to_string()).map_err(refused)?;
    let case = Case::from_ron(&text).map_err(refused)?;
    let mut bearing = case.bearing().map_err(|source| PaperError::Bearing { run: plan.label, source })?;
    let point = case.operating_point();
    if let Some(Adapt(change)) = adapt {
        change(&mut bearing, &point);
    }
    let failed = |source| PaperError::Solver { run: plan.label, source };
    let solved = solve(&bearing, &point, plan.model).map_err(failed)?;
    let roots = match &solved.warm_start {
        Some(start) => root_warnings(&other_roots(&bearing, &point, start).map_err(failed)?),
        None => Vec::new(),
    };
    Ok(Run { id: plan.id, label: plan.label, text, case, solution: solved.solution, roots })
}
