//! The figures that a set of parameter values gives.

use crate::IdentifyError;
use crate::problem::{Datum, Hypothesis, ModelName, Problem, Quantity, Relation};
use crate::settled::Settled;
use std::collections::BTreeMap;
use std::ops::Range;
use tribodyn_bearing::{OperatingPoint, SearchWatch};
use tribodyn_case::{Case, Purpose, locate, set_value};
use tribodyn_quasistatic::{Model, OverAzimuth, QuasiStaticError, Solution, WarmStart, solve, solve_from};

/// A case file's text with holes where the free parameters stand.
#[derive(Debug, Clone)]
struct Template {
    text: String,
    /// Byte range of each hole and which parameter fills it, by position.
    holes: Vec<(Range<usize>, usize)>,
}

impl Template {
    fn new(text: String, paths: &[(usize, &str)]) -> Result<Self, IdentifyError> {
        let mut holes = Vec::new();
        for &(index, path) in paths {
            let range = locate(&text, path).ok_or_else(|| IdentifyError::Path { path: path.to_owned() })?;
            if text[range.clone()].trim().parse::<f64>().is_err() {
                let value = text[range].to_owned();
                return Err(IdentifyError::NotANumber { path: path.to_owned(), value });
            }
            holes.push((range, index));
        }
        holes.sort_by_key(|(range, _)| range.start);
        Ok(Self { text, holes })
    }

    fn fill(&self, values: &[f64]) -> String {
        let mut out = String::with_capacity(self.text.len() + 16 * self.holes.len());
        let mut from = 0;
        for (range, index) in &self.holes {
            out.push_str(&self.text[from..range.start]);
            out.push_str(&format!("{:?}", values[*index]));
            from = range.end;
        }
        out.push_str(&self.text[from..]);
        out
    }
}

/// One variant of the case, ready to be solved for parameter values.
#[derive(Debug, Clone)]
struct Variant {
    template: Template,
    model: ModelName,
}

/// The model under one hypothesis: parameter values in, figures out.
#[derive(Debug, Clone)]
pub struct ForwardModel {
    variants: BTreeMap<String, Variant>,
    base: Template,
    /// By which searches and runs are ended.
    pub watch: SearchWatch,
}

/// Solutions by run, and starts for the neighbourhood.
#[derive(Debug, Clone, Default)]
pub struct Evaluation {
    /// Solutions by the name of the run.
    pub solutions: BTreeMap<String, Solution>,
    /// What transient runs settled to, by their names.
    pub settled: BTreeMap<String, Settled>,
    warm: BTreeMap<String, WarmStart>,
}

impl ForwardModel {
    /// Prepares the case's text: hypothesis and run replace values, free parameters become holes.
    ///
    /// # Errors
    /// A path that leads nowhere, a value that is no number, a case that is refused.
    pub fn new(problem: &Problem, case_text: &str, hypothesis: Option<&Hypothesis>) -> Result<Self, IdentifyError> {
        let mut text = case_text.to_owned();
        for (path, value) in hypothesis.iter().flat_map(|h| &h.set) {
            text = set_value(&text, path, value)?;
        }
        let paths: Vec<(usize, &str)> = free(problem, hypothesis)
            .iter()
            .enumerate()
            .flat_map(|(index, &p)| problem.parameters[p].paths.iter().map(move |path| (index, path.as_str())))
            .collect();
        let base = Template::new(text.clone(), &paths)?;
        let variants = problem.runs.iter().map(|(name, run)| {
            let mut text = text.clone();
            for (path, value) in problem.search.iter().chain(&run.set) {
                text = set_value(&text, path, value)?;
            }
            Case::from_ron(&text)?;
            Ok((name.clone(), Variant { template: Template::new(text, &paths)?, model: run.model }))
        });
        Ok(Self { variants: variants.collect::<Result<_, IdentifyError>>()?, base, watch: SearchWatch::default() })
    }

    /// The case file's text with these values.
    pub fn case_text(&self, values: &[f64]) -> String {
        self.base.fill(values)
    }

    /// Works out all runs, equilibria from neighbouring solutions where there are some.
    ///
    /// # Errors
    /// A case that is refused or does not converge.
    pub fn evaluate(&self, values: &[f64], near: Option<&Evaluation>) -> Result<Evaluation, IdentifyError> {
        let mut out = Evaluation::default();
        for (name, variant) in &self.variants {
            if self.watch.stops() {
                return Err(QuasiStaticError::Ended.into());
            }
            let case = Case::from_ron(&variant.template.fill(values))?;
            let (model, purpose) = match variant.model {
                ModelName::JonesHarris => (Model::JonesHarris, Purpose::JonesHarris),
                ModelName::Traction => (Model::Traction, Purpose::Traction),
                ModelName::Transient => {
                    out.settled.insert(name.clone(), Settled::of(&case, &self.watch)?);
                    continue;
                }
            };
            case.require(purpose)?;
            let bearing = case.bearing()?;
            let point = OperatingPoint { watch: self.watch.clone(), ..case.operating_point() };
            let warm = near.and_then(|n| n.warm.get(name));
            let solved = match warm {
                Some(start) => solve_from(&bearing, &point, start).or_else(|_| solve(&bearing, &point, model)),
                None => solve(&bearing, &point, model),
            }?;
            if let Some(start) = solved.warm_start {
                out.warm.insert(name.clone(), start);
            }
            out.solutions.insert(name.clone(), solved.solution);
        }
        Ok(out)
    }
}

/// Indices of the parameters that are free under a hypothesis.
pub(crate) fn free(problem: &Problem, hypothesis: Option<&Hypothesis>) -> Vec<usize> {
    let held = |name: &String| hypothesis.is_some_and(|h| h.hold.contains(name));
    (0..problem.parameters.len()).filter(|&i| !held(&problem.parameters[i].name)).collect()
}

impl Datum {
    /// The model's figure: the value, the ratio, or the difference to the other quantity.
    pub fn computed(&self, evaluation: &Evaluation) -> f64 {
        let of = |run: &str, quantity: Quantity| match evaluation.settled.get(run) {
            Some(settled) => quantity.of_settled(settled),
            None => quantity.of(&evaluation.solutions[run]),
        };
        let here = of(&self.run, self.quantity);
        match &self.relation {
            Relation::Value => here,
            Relation::RatioTo { run, quantity } => here / of(run, *quantity),
            Relation::Above { run, quantity } => here - of(run, *quantity),
        }
    }

    /// Deviation of the model's figure: computed − value, and 0 where an order holds by more than its margin.
    pub fn deviation(&self, computed: f64) -> f64 {
        let deviation = computed - self.value;
        if matches!(self.relation, Relation::Above { .. }) { deviation.min(0.0) } else { deviation }
    }

    /// Unit of the figure.
    pub fn unit(&self) -> &'static str {
        if matches!(self.relation, Relation::RatioTo { .. }) { "–" } else { self.quantity.unit() }
    }
}

impl Quantity {
    /// True if it is one of a transient run.
    pub fn of_run(&self) -> bool {
        matches!(
            self,
            Self::OrbitalSpeed
                | Self::OrbitalSpeedLeast
                | Self::OrbitalSpeedGreatest
                | Self::OuterAccelerationPeak
                | Self::OuterAccelerationAmplitude
                | Self::InnerAccelerationRms
                | Self::FirstImpact
                | Self::ImpactShare { .. }
        )
    }

    /// Its value in a settled run, in its unit; NaN where it is none of a run.
    pub fn of_settled(&self, run: &Settled) -> f64 {
        match *self {
            Self::OrbitalSpeed => run.orbital_speed_rpm,
            Self::OrbitalSpeedLeast => run.orbital_limits_rpm[0],
            Self::OrbitalSpeedGreatest => run.orbital_limits_rpm[1],
            Self::OuterAccelerationPeak => run.outer_peak_m_s2,
            Self::OuterAccelerationAmplitude => run.outer_amplitude_m_s2,
            Self::InnerAccelerationRms => run.inner_rms_m_s2.iter().map(|v| v * v).sum::<f64>().sqrt(),
            Self::FirstImpact => run.first_impact_deg,
            Self::ImpactShare { from, to } => {
                let inside = run.impacts_deg.iter().filter(|a| (from..=to).contains(*a)).count();
                inside as f64 / run.impacts_deg.len() as f64
            }
            _ => f64::NAN,
        }
    }

    /// Its value in a solution, in its unit; NaN where it is one of a run.
    pub fn of(&self, solution: &Solution) -> f64 {
        let ball = |azimuth: f64| OverAzimuth::new(solution).at(azimuth.to_radians());
        match *self {
            Self::CageSpeed => solution.cage_speed_rpm,
            Self::OuterPassingFrequency => {
                let outer = solution.outer_speed_rad_s * 30.0 / std::f64::consts::PI;
                (solution.cage_speed_rpm - outer).abs() / 60.0 * solution.balls.len() as f64
            }
            Self::PeakPressureInner { azimuth } => ball(azimuth).contacts.inner.peak_pressure_pa * 1e-9,
            Self::PeakPressureOuter { azimuth } => ball(azimuth).contacts.outer.peak_pressure_pa * 1e-9,
            Self::LoadInner { azimuth } => ball(azimuth).contacts.inner.load_n,
            Self::LoadOuter { azimuth } => ball(azimuth).contacts.outer.load_n,
            Self::ContactAngleInner { azimuth } => ball(azimuth).contacts.inner.angle_rad.to_degrees(),
            Self::ContactAngleOuter { azimuth } => ball(azimuth).contacts.outer.angle_rad.to_degrees(),
            Self::RingDisplacementAxial => solution.ring_displacement_m[2] * 1e6,
            Self::RingDisplacementRadial => solution.ring_displacement_m[0] * 1e6,
            Self::ShaftTorque => solution.shaft_torque_nm.unwrap_or(f64::NAN),
            _ => f64::NAN,
        }
    }

    /// Its unit.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::CageSpeed => "r/min",
            Self::OuterPassingFrequency => "Hz",
            Self::PeakPressureInner { .. } | Self::PeakPressureOuter { .. } => "GPa",
            Self::LoadInner { .. } | Self::LoadOuter { .. } => "N",
            Self::ContactAngleInner { .. } | Self::ContactAngleOuter { .. } => "°",
            Self::RingDisplacementAxial | Self::RingDisplacementRadial => "µm",
            Self::ShaftTorque => "N m",
            Self::OrbitalSpeed | Self::OrbitalSpeedLeast | Self::OrbitalSpeedGreatest => "r/min",
            Self::OuterAccelerationPeak | Self::OuterAccelerationAmplitude | Self::InnerAccelerationRms => "m/s²",
            Self::FirstImpact => "°",
            Self::ImpactShare { .. } => "–",
        }
    }
}
