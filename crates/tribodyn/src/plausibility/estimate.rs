//! A first estimate of a bearing's load, in a line and without a search.
//!
//! ```text
//! s_0 = C_0r/P_0                                             ISO 76
//! Q ≈ 5 F_r/(Z cos α_0) + F_a/(Z sin α)                      Stribeck's number; thrust shared evenly
//! F_a = Z K (A (cos α_0/cos α − 1))^1.5 sin α                contact angle α under thrust
//! ```
//!
//! Source: T. A. Harris, M. N. Kotzalas, Essential Concepts of Bearing Technology, 2006, chapter 7.

use super::shown;
use crate::rating::{rated_bearing, static_rating};
use tribodyn_bearing::{Bearing, RingFreedom, Side};
use tribodyn_case::{Case, Quantity, quantities};
use tribodyn_quasistatic::Solution;

/// Static safety below which a load is named: the least of ISO 76, for rough running.
const SAFETY_LEAST: f64 = 0.5;
/// Estimated peak pressure beyond which nothing is solved, Pa: half as much again as the hardness of bearing steel, to
/// which no contact is elastic.
pub(crate) const PRESSURE_MOST: f64 = 12e9;
/// Static safety of a load that somebody may have meant.
const MEANT: std::ops::Range<f64> = 0.1..1e4;
/// Stribeck's number.
const STRIBECK: f64 = 5.0;
/// Largest contact angle under thrust, rad.
const STEEPEST: f64 = 1.55;
/// Load below which a bearing counts as not loaded, N/m²: times the balls and the square of their diameter. A millionth
/// of a usual static load rating, far below the weight of a ring, and far above what solvers leave.
const NO_LOAD_PER_AREA: f64 = 12.0;

/// Said of every answer about a bearing that nothing loads.
pub const NO_LOAD: &str = "no load: rating lives, static safety and the contact angles of balls are not defined";

/// The loads of a case against what its bearing carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StaticEstimate {
    /// Radial load, N.
    pub radial_load_n: f64,
    /// Axial load, N.
    pub axial_load_n: f64,
    /// Static load rating C_0r, N; absent for a bearing that the standards do not rate.
    pub static_rating_n: Option<f64>,
    /// Static safety s_0 = C_0r/P_0; absent without load, or where there is no rating.
    pub static_safety: Option<f64>,
    /// Load of the hardest pressed ball, N.
    pub ball_load_n: f64,
    /// Its peak pressure on the inner race, Pa.
    pub peak_pressure_pa: f64,
}

/// Radial and axial load of a case, N; none where the ring is held along x, y or z.
pub fn case_loads(case: &Case) -> Option<[f64; 2]> {
    let force = |freedom: RingFreedom| match freedom {
        RingFreedom::Loaded(force) => Some(force),
        RingFreedom::Held(_) => None,
    };
    let [x, y, z, ..] = case.operating_point().ring;
    Some([force(x)?.hypot(force(y)?), force(z)?.abs()])
}

/// The estimate for the loads of a case; none where the ring is held along x, y or z.
pub fn estimate(case: &Case, bearing: &Bearing) -> Option<StaticEstimate> {
    case_loads(case).map(|loads| of_loads(case, bearing, loads))
}

fn of_loads(case: &Case, bearing: &Bearing, [radial, axial]: [f64; 2]) -> StaticEstimate {
    let balls = bearing.geometry.ball_count as f64;
    let of_thrust = if axial > 0.0 { axial / (balls * thrust_angle(bearing, axial).sin()) } else { 0.0 };
    let ball_load = STRIBECK * radial / (balls * bearing.geometry.cos_contact_angle()) + of_thrust;
    let rating = static_rating(case).ok();
    let equivalent = rated_bearing(case).static_equivalent_load(radial, axial).ok().filter(|load| *load > 0.0);
    StaticEstimate {
        radial_load_n: radial,
        axial_load_n: axial,
        static_rating_n: rating,
        static_safety: rating.zip(equivalent).map(|(rating, load)| rating / load),
        ball_load_n: ball_load,
        peak_pressure_pa: bearing.races.inner.frozen::<f64>().ellipse(ball_load).peak_pressure,
    }
}

/// The contact angle of a bearing under thrust alone, rad.
fn thrust_angle(bearing: &Bearing, axial: f64) -> f64 {
    let g = &bearing.geometry;
    let softness = Side::BOTH.map(|side| bearing.races[side].frozen::<f64>().stiffness().powf(-2.0 / 3.0));
    let stiffness = (softness[0] + softness[1]).powf(-1.5);
    let thrust = |angle: f64| {
        let stretched = g.centre_distance() * (g.cos_contact_angle() / angle.cos() - 1.0).max(0.0);
        g.ball_count as f64 * stiffness * stretched.powf(1.5) * angle.sin()
    };
    let (mut low, mut high) = (g.contact_angle().max(1e-6), STEEPEST);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if thrust(middle) < axial { &mut low } else { &mut high }) = middle;
    }
    high
}

impl StaticEstimate {
    /// A sentence on loads beyond what the bearing carries at rest, with the slip of a unit that it looks like.
    pub fn warning(&self, case: &Case, (text, bearing): (&str, &Bearing)) -> Option<String> {
        let safety = self.static_safety.filter(|safety| *safety < SAFETY_LEAST);
        if safety.is_none() && self.peak_pressure_pa <= PRESSURE_MOST {
            return None;
        }
        let against = match self.static_rating_n.zip(safety) {
            Some((rating, safety)) => format!(
                "static safety s_0 of {} against C_0r of {} N, usual is {SAFETY_LEAST} and more (ISO 76); ",
                shown(safety),
                shown(rating)
            ),
            None => String::new(),
        };
        let slip = slip(case, (text, bearing)).map(|slip| format!("; {slip} would be: a slip of the unit?"));
        Some(format!(
            "load of {} N radial, {} N axial: {against}about {} GPa on the most loaded ball, by a first estimate{}",
            shown(self.radial_load_n),
            shown(self.axial_load_n),
            shown(self.peak_pressure_pa * 1e-9),
            slip.unwrap_or_default()
        ))
    }

    /// True for a load to which no search can give an answer that means anything.
    pub fn is_hopeless(&self) -> bool {
        self.peak_pressure_pa > PRESSURE_MOST
    }
}

/// The sentence on loads to which nothing can be solved; none for others.
pub fn hopeless(case: &Case, (text, bearing): (&str, &Bearing)) -> Option<String> {
    let estimate = estimate(case, bearing).filter(StaticEstimate::is_hopeless)?;
    let warning = estimate.warning(case, (text, bearing))?;
    Some(format!("{warning}; {}: nothing is solved", not_elastic()))
}

/// The reason why nothing is solved at such a pressure, in words.
pub(crate) fn not_elastic() -> String {
    format!("no contact is elastic beyond {} GPa", shown(PRESSURE_MOST * 1e-9))
}

/// Highest peak pressure of all contacts, Pa.
pub fn peak_pressure(solution: &Solution) -> f64 {
    let contacts = solution.balls.iter().flat_map(|ball| Side::BOTH.map(|side| &ball.contacts[side]));
    contacts.map(|contact| contact.peak_pressure_pa).fold(0.0, f64::max)
}

/// The sentence on a peak pressure, Pa, beyond which no contact is elastic; none for lower ones.
pub fn inelastic(peak_pressure: f64) -> Option<String> {
    let gpa = shown(peak_pressure * 1e-9);
    (peak_pressure > PRESSURE_MOST).then(|| format!("{gpa} GPa on the most loaded ball; {}", not_elastic()))
}

/// The largest force of a case in another unit, where that is one that the bearing carries.
fn slip(case: &Case, (text, bearing): (&str, &Bearing)) -> Option<String> {
    let forces = quantities(text).into_iter().filter(|q| q.path.starts_with("ring.") && q.path.ends_with(".Force"));
    let largest: Quantity = forces.max_by(|a, b| a.value.abs().total_cmp(&b.value.abs()))?;
    let axial = largest.path.starts_with("ring.z.");
    let [radial, thrust] = case_loads(case)?;
    let carried = |value: f64| {
        let loads = if axial { [radial, value.abs()] } else { [value.abs(), thrust] };
        let safety = of_loads(case, bearing, loads).static_safety;
        safety.is_some_and(|safety| MEANT.contains(&safety))
    };
    largest.otherwise().into_iter().find(|(_, si)| carried(*si)).map(|(text, _)| text)
}

/// True if anything loads the bearing.
pub fn is_loaded(bearing: &Bearing, solution: &Solution) -> bool {
    let g = &bearing.geometry;
    let [x, y, z] = solution.ring_load_n;
    let [mx, my] = solution.ring_moment_nm;
    let load = x.hypot(y).hypot(z) + mx.hypot(my) / (0.5 * g.pitch_diameter);
    load > NO_LOAD_PER_AREA * g.ball_count as f64 * g.ball_diameter.powi(2)
}
