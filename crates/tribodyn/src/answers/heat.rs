//! Temperatures of a bearing from its friction, which depends on them.

use super::friction::{WithFriction, turning};
use super::{Answer, Equations, Question};
use crate::error::AnswerError;
use crate::rating::noted_boundaries;
use serde::Serialize;
use tribodyn_bearing::{Bearing, BearingError, ContactResult, Side};
use tribodyn_case::{Case, HeatSpec, MountedRingSpec, MountingSpec};
use tribodyn_lubricant::ZERO_CELSIUS;
use tribodyn_thermal::{BearingSize, Conductances, Heat, Temperatures, passing_conductance};

/// Surroundings of the bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surroundings {
    /// Temperature of air, shaft end and oil supply, °C.
    pub temperature_deg_c: f64,
    /// Conductances to the surroundings over the usual ones.
    pub cooling: f64,
    /// Width of the bearing, mm; estimated where it is not known.
    pub width_mm: Option<f64>,
    /// Oil that flows through, l/min.
    pub oil_flow_l_min: f64,
}

impl Surroundings {
    /// Refuses numbers that no surroundings have.
    fn check(&self) -> Result<(), AnswerError> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let flows = self.oil_flow_l_min >= 0.0 && self.oil_flow_l_min.is_finite();
        let (temperature, width) = (self.temperature_deg_c, self.width_mm.unwrap_or(1.0));
        for (name, value, sound, allowed) in [
            ("surroundings", temperature, (-60.0..=150.0).contains(&temperature), "-60 to 150 °C"),
            ("cooling", self.cooling, positive(self.cooling), "a factor above 0"),
            ("width", width, positive(width), "a width above 0 in mm"),
            ("oil-flow", self.oil_flow_l_min, flows, "a flow of 0 or more in l/min"),
        ] {
            if !sound {
                return Err(AnswerError::argument(name, value, format!("allowed is {allowed}")));
            }
        }
        Ok(())
    }
}

/// Temperatures at which all friction leaves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HeatAnswer {
    /// Inner ring, °C.
    pub inner_temperature_deg_c: f64,
    /// Balls, °C.
    pub ball_temperature_deg_c: f64,
    /// Outer ring, °C.
    pub outer_temperature_deg_c: f64,
    /// Oil or grease between them, °C.
    pub oil_temperature_deg_c: f64,
    /// Housing, °C.
    pub housing_temperature_deg_c: f64,
    /// Mean of the surfaces, which the films have at their inlets, °C.
    pub film_inlet_temperature_deg_c: f64,
    /// Kinematic viscosity there, mm²/s.
    pub kinematic_viscosity_mm2_s: f64,
    /// Friction torque there, N m.
    pub torque_nm: f64,
    /// All friction, W.
    pub friction_power_w: f64,
    /// Heat to the surroundings along the shaft, W.
    pub heat_shaft_w: f64,
    /// From the housing, W.
    pub heat_housing_w: f64,
    /// With the oil that flows through, W.
    pub heat_oil_w: f64,
    /// Radial clearance of the running bearing, m; below 0 it is preloaded.
    pub radial_clearance_m: f64,
    /// Solutions that it took.
    pub rounds: usize,
    /// Assumptions that had to be made.
    pub notes: Vec<String>,
}

/// Change of every temperature below which they have settled, K.
const SETTLED: f64 = 1e-3;
/// Solutions after which temperatures that do not settle are given up.
const ROUNDS: usize = 60;
/// Temperature at which bearing steel and every usual lubricant are lost, °C.
const LOST: f64 = 250.0;
/// Temperature of the drawing, K.
const DRAWN: f64 = ZERO_CELSIUS + 20.0;
/// Thermal expansion of bearing steel, 1/K.
const EXPANSION: f64 = 11.5e-6;
/// Conductivity times density times specific heat of bearing steel, J²/(m⁴ K² s).
const STEEL: f64 = 46.0 * 7810.0 * 475.0;
/// Width over section of usual bearings.
const WIDTH: f64 = 0.5;

/// Temperatures of a lubricated bearing in steady state: friction is solved for at the temperatures that it makes.
///
/// # Errors
/// A case without a lubricant, that stands still or has no solution; equations without friction; temperatures that run
/// away, do not settle or take all clearance.
pub fn heat(
    question: &Question<'_>,
    equations: Equations,
    surroundings: &Surroundings,
) -> Result<Answer<HeatAnswer>, AnswerError> {
    surroundings.check()?;
    let Some(lubricant) = &question.case.lubricant else {
        return Err(AnswerError::not_asked(question.name, "it has no `lubricant`, which temperatures need"));
    };
    turning(question, "friction")?;
    let mut notes = Vec::new();
    let size = size((question.name, question.case), surroundings, &mut notes)?;
    if question.case.mounting.is_none() {
        notes.push("without `mounting` the rings grow by heat and speed, and no seat presses on them".to_owned());
    }
    let mut at = Temperatures::even(lubricant.temperature);
    let (mut steps, mut near) = (Steps::default(), None);
    for round in 1..=ROUNDS {
        let case = warmed(question.case, &size, &at);
        let warm = Question { case: &case, ..question.clone() };
        let solved = WithFriction::solve_near(&warm, equations, &mut near).map_err(|error| clamped(error, &at))?;
        let found = Found::new(&solved);
        let conductances = found.conductances(&case, &size, surroundings)?;
        let ambient = surroundings.temperature_deg_c + ZERO_CELSIUS;
        let next = conductances.steady(&found.heat, ambient)?;
        let off = difference(&next, &at);
        if off.iter().all(|off| off.abs() < SETTLED) {
            let viscosity = lubricant.oil.oil()?.kinematic_mm2_s(inlet(&next));
            let answer = answer((&solved.bearing, viscosity), (&conductances, &next, ambient), &found, (round, notes));
            return Ok(Answer::new(solved.findings, answer));
        }
        at = steps.next(&at, off);
        let hottest = at.to_array().into_iter().fold(f64::NEG_INFINITY, f64::max) - ZERO_CELSIUS;
        if hottest.is_nan() || hottest >= LOST {
            let why = format!(
                "the temperatures run away: {hottest:.0} °C and rising with {:.0} W of friction",
                found.heat.total()
            );
            return Err(AnswerError::Runaway { file: question.name.to_owned(), why });
        }
    }
    let why = format!("the temperatures do not settle in {ROUNDS} rounds");
    Err(AnswerError::Runaway { file: question.name.to_owned(), why })
}

/// The error of a bearing that heat and speed have taken more clearance from than it can lose: no value of the case is
/// outside its range.
fn clamped(error: AnswerError, at: &Temperatures) -> AnswerError {
    match error {
        AnswerError::Bearing { file, source: BearingError::Clearance { clearance, least, .. } }
            if clearance < least =>
        {
            let why = format!(
                "the bearing clamps as it turns and gets warm: with the inner ring at {:.0} °C and the outer one at \
                 {:.0} °C its radial clearance would be {:.0} µm, and the least allowed is {:.0} µm: give it more \
                 clearance, less speed or more cooling",
                at.inner - ZERO_CELSIUS,
                at.outer - ZERO_CELSIUS,
                clearance * 1e6,
                least * 1e6
            );
            AnswerError::Runaway { file, why }
        }
        other => other,
    }
}

/// Heat and contacts of a solution.
struct Found {
    heat: Heat,
    /// Between balls and inner, outer ring, W/K.
    contacts: [f64; 2],
    torque: f64,
}

impl Found {
    fn new(solved: &WithFriction) -> Self {
        let (torque, friction, fluid) = (solved.torque_nm, solved.friction_w, solved.fluid_w);
        let speed = solved.solution.inner_speed_rad_s - solved.solution.outer_speed_rad_s;
        let passing = |c: &ContactResult| {
            let loaded = c.load_n > 0.0;
            if loaded { passing_conductance(c.semi_axes_m, c.rolling_speed_m_s.abs(), STEEL) } else { 0.0 }
        };
        let contacts = Side::BOTH.map(|side| solved.sum(side, passing));
        // What the shaft gives and contacts and fluid do not take is lost at the cage.
        let cage = (torque * speed - friction.iter().sum::<f64>() - fluid).max(0.0);
        // Two surfaces of one steel share what is made between them.
        let heat = Heat {
            inner: 0.5 * friction[0],
            balls: 0.5 * (friction[0] + friction[1]),
            outer: 0.5 * friction[1],
            oil: fluid + cage,
        };
        Self { heat, contacts, torque: torque.abs() }
    }

    fn conductances(
        &self,
        case: &Case,
        size: &BearingSize,
        surroundings: &Surroundings,
    ) -> Result<Conductances, AnswerError> {
        let [inner, outer] = self.contacts;
        let usual = Conductances::usual(size, inner, outer);
        let flow = surroundings.oil_flow_l_min * 1e-3 / 60.0;
        let carried = match &case.lubricant {
            Some(lubricant) if flow > 0.0 => {
                let oil = lubricant.oil.oil()?;
                flow * oil.density(lubricant.temperature) * oil.thermal.specific_heat
            }
            _ => 0.0,
        };
        Ok(Conductances {
            inner_surroundings: surroundings.cooling * usual.inner_surroundings,
            housing_surroundings: surroundings.cooling * usual.housing_surroundings,
            oil_surroundings: carried,
            ..usual
        })
    }
}

/// Steps towards the fixed point, each as long as the last two say (Aitken's, for vectors: B. M. Irons and
/// R. C. Tuck, Int. J. Numer. Meth. Engng 1 (1969) 275).
struct Steps {
    last: Option<[f64; 5]>,
    length: f64,
}

impl Default for Steps {
    fn default() -> Self {
        Self { last: None, length: 0.7 }
    }
}

impl Steps {
    /// Shortest and longest step over the way to what was found.
    const LENGTHS: [f64; 2] = [0.05, 1.5];
    /// Longest step, K: a cold oil's friction says nothing of where the temperatures end.
    const LONGEST: f64 = 40.0;

    fn next(&mut self, at: &Temperatures, off: [f64; 5]) -> Temperatures {
        if let Some(last) = self.last {
            let change: Vec<f64> = off.iter().zip(last).map(|(off, last)| off - last).collect();
            let squared: f64 = change.iter().map(|change| change * change).sum();
            let along: f64 = change.iter().zip(last).map(|(change, last)| change * last).sum();
            if squared > 0.0 {
                let [least, most] = Self::LENGTHS;
                self.length = (-self.length * along / squared).clamp(least, most);
            }
        }
        self.last = Some(off);
        let at = at.to_array();
        let step = |node: usize| (self.length * off[node]).clamp(-Self::LONGEST, Self::LONGEST);
        Temperatures::from_array(std::array::from_fn(|node| at[node] + step(node)))
    }
}

fn difference(a: &Temperatures, b: &Temperatures) -> [f64; 5] {
    let (a, b) = (a.to_array(), b.to_array());
    std::array::from_fn(|node| a[node] - b[node])
}

fn size(
    (name, case): (&str, &Case),
    surroundings: &Surroundings,
    notes: &mut Vec<String>,
) -> Result<BearingSize, AnswerError> {
    let [bore, outside] = noted_boundaries(case, notes);
    if bore <= 0.0 || outside <= bore {
        let why = "`rating.bore` must be above 0 and less than `rating.outside`";
        return Err(AnswerError::not_asked(name, why));
    }
    let width = surroundings.width_mm.map(|width| width * 1e-3).unwrap_or_else(|| {
        notes.push("width estimated as half of D − d: give --width".to_owned());
        WIDTH * (outside - bore)
    });
    Ok(BearingSize { bore, outside, width })
}

/// The temperature that films have at their inlets: the mean of the surfaces.
fn inlet(at: &Temperatures) -> f64 {
    (at.inner + at.outer + 2.0 * at.balls) / 4.0
}

/// The case with its oil, rings and balls at these temperatures.
fn warmed(case: &Case, size: &BearingSize, at: &Temperatures) -> Case {
    let mut warm = case.clone();
    if let Some(lubricant) = &mut warm.lubricant {
        lubricant.temperature = inlet(at);
    }
    let free =
        |seat_diameter: f64| MountedRingSpec { seat_diameter, expansion: EXPANSION, temperature_rise: 0.0, seat: None };
    let mut mounting = case.mounting.unwrap_or_else(|| MountingSpec {
        inner: free(size.bore),
        outer: free(size.outside),
        ball: HeatSpec { expansion: EXPANSION, temperature_rise: 0.0 },
    });
    mounting.inner.temperature_rise = at.inner - DRAWN;
    mounting.outer.temperature_rise = at.outer - DRAWN;
    mounting.ball.temperature_rise = at.balls - DRAWN;
    if let Some(shaft) = &mut mounting.inner.seat {
        shaft.temperature_rise = at.inner - DRAWN;
    }
    if let Some(housing) = &mut mounting.outer.seat {
        housing.temperature_rise = at.housing - DRAWN;
    }
    warm.mounting = Some(mounting);
    warm
}

fn answer(
    (bearing, viscosity): (&Bearing, f64),
    (conductances, at, ambient): (&Conductances, &Temperatures, f64),
    found: &Found,
    (rounds, notes): (usize, Vec<String>),
) -> HeatAnswer {
    let [inner, balls, outer, oil, housing] = at.to_array().map(|kelvin| kelvin - ZERO_CELSIUS);
    HeatAnswer {
        inner_temperature_deg_c: inner,
        ball_temperature_deg_c: balls,
        outer_temperature_deg_c: outer,
        oil_temperature_deg_c: oil,
        housing_temperature_deg_c: housing,
        film_inlet_temperature_deg_c: inlet(at) - ZERO_CELSIUS,
        kinematic_viscosity_mm2_s: viscosity,
        torque_nm: found.torque,
        friction_power_w: found.heat.total(),
        heat_shaft_w: conductances.inner_surroundings * (at.inner - ambient),
        heat_housing_w: conductances.housing_surroundings * (at.housing - ambient),
        heat_oil_w: conductances.oil_surroundings * (at.oil - ambient),
        radial_clearance_m: bearing.geometry.radial_clearance(),
        rounds,
        notes,
    }
}
