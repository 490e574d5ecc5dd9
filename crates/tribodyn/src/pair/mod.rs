//! Two like bearings on one rigid shaft, preloaded against each other.
//!
//! ```text
//! shaft u = (x, y, z, tilt about X, tilt about Y) in the middle, bearing k at z_k = ∓ half the distance, s_k = ±1:
//!   x_k = x + θ_y z_k,  y_k = y − θ_x z_k,  z_k' = s_k z + offset/2,  tilts s_k θ      seen by a bearing of its own
//!   Σ T_kᵀ F_k(T_k u + offset) = load on the shaft,   K = Σ T_kᵀ K_k T_k,   T_k = du_k/du
//! ```
//!
//! A bearing that faces the other way is the mirror image of the first: forces along Z and tilts change their signs,
//! the sense of rotation does not. Back to back the lines of contact meet the axis outside the pair, face to face
//! inside. Sources: T. A. Harris, M. N. Kotzalas, Essential Concepts of Bearing Technology, 2006, section 9.4
//! (preloaded pairs); the mirror is ours.

mod step;

use serde::Serialize;
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint, RingFreedom};
use tribodyn_orbit::{OrbitError, OrbitSettings, OrbitStart, orbit_slopes, steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{
    Model, QuasiStaticError, Seated, Solution, StiffnessMatrix, WarmStart, jones_harris_stiffness, shaft_at_rest,
    solve, solve_from, traction_stiffness,
};

/// How the bearings stand to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Arrangement {
    /// DB: the lines of contact meet the axis outside the pair.
    BackToBack,
    /// DF: they meet it inside.
    FaceToFace,
    /// DT: both bearings carry the axial load, along +Z.
    Tandem,
}

impl Arrangement {
    /// Direction of the push on the shaft that each bearing carries, +Z (1) or −Z (−1): the one at −Z first.
    fn senses(self) -> [f64; 2] {
        match self {
            Self::BackToBack => [1.0, -1.0],
            Self::FaceToFace => [-1.0, 1.0],
            Self::Tandem => [1.0, 1.0],
        }
    }
}

/// Preload between the bearings.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Preload {
    /// Axial gap between the rings that is closed when they are clamped, m: each bearing takes half of it.
    OffsetM(f64),
    /// Force of a soft spring, N, that pushes the outer ring of the bearing at +Z, which slides in its housing.
    SpringN(f64),
}

/// Equations of each bearing.
#[expect(clippy::large_enum_variant, reason = "a pair has one, which lives as long as its search")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PairModel {
    /// An equilibrium.
    QuasiStatic(Model),
    /// The steady orbit with its cage.
    SteadyOrbit(CageBody, OrbitSettings),
}

/// Two like bearings on a shaft. The freedoms of the operating point are the shaft's, its loads act in the middle.
#[derive(Debug, Clone, Copy)]
pub struct Pair<'a> {
    /// Each of the two.
    pub bearing: &'a Bearing,
    /// Speeds, loads of the shaft, numerics.
    pub point: &'a OperatingPoint,
    /// Equations.
    pub model: PairModel,
    /// How they stand.
    pub arrangement: Arrangement,
    /// Distance between their middles, m.
    pub distance: f64,
    /// Preload between them.
    pub preload: Preload,
}

/// Why a pair has no equilibrium.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PairError {
    /// An equilibrium of one bearing.
    #[error(transparent)]
    Equilibrium(#[from] QuasiStaticError),
    /// An orbit of one bearing.
    #[error(transparent)]
    Orbit(#[from] OrbitError),
    /// The shaft moves without resistance.
    #[error("the shaft moves without resistance: give the pair preload or load")]
    Loose,
    /// The iteration stopped above the tolerance.
    #[error(
        "the pair did not converge: a relative residual of {residual:.1e} is left on the shaft (tolerance {tolerance:.1e})"
    )]
    NotConverged {
        /// Residual over the load.
        residual: f64,
        /// Tolerance asked for.
        tolerance: f64,
    },
    /// The caller ended the search.
    #[error("the search for the pair was stopped before it found one")]
    Ended,
    /// A spring in tandem has nothing to push against.
    #[error("a spring cannot preload bearings in tandem against each other; allowed is an offset")]
    SpringInTandem,
}

/// One bearing of a solved pair.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PairBearing {
    /// Position of its middle, m.
    pub position_m: f64,
    /// Force of its inner ring on the balls: x, y, z of the shaft, N.
    pub load_n: [f64; 3],
    /// Moment about its own middle: x, y of the shaft, N m.
    pub moment_nm: [f64; 2],
    /// The bearing by itself, z along the load that it carries.
    pub solution: Solution,
}

/// A pair in equilibrium.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PairSolution {
    /// Displacement of the shaft's middle: x, y, z, m.
    pub shaft_displacement_m: [f64; 3],
    /// Tilt of the shaft about X and Y, rad.
    pub shaft_tilt_rad: [f64; 2],
    /// Axial force within the pair, N: the smaller of what the bearings carry against each other; 0 in tandem.
    pub preload_n: f64,
    /// Forces and moments over displacements and tilts of the shaft's middle, by rows.
    pub stiffness: StiffnessMatrix,
    /// Largest residual over the loads.
    pub residual: f64,
    /// The bearing at −Z, then that at +Z.
    pub bearings: [PairBearing; 2],
}

const FREEDOMS: usize = 5;
type Vector = [f64; FREEDOMS];
type Matrix = [[f64; FREEDOMS]; FREEDOMS];

/// Force, stiffness and solution of a bearing at a displacement of its ring.
struct Answer {
    force: Vector,
    stiffness: Matrix,
    solution: Solution,
}

/// Where the next solution of a bearing starts.
#[derive(Default)]
enum Near {
    #[default]
    Cold,
    Equilibrium(Box<WarmStart>),
    Orbit(Box<OrbitStart>),
}

/// Steps of Newton's method, and halvings of one.
const STEPS: usize = 60;
const HALVINGS: i32 = 12;

/// Longest step over the ball diameter: balls are pressed in by about a thousandth of it.
const LONGEST: f64 = 2e-3;

/// Solves both bearings together.
///
/// # Errors
/// [`PairError`].
pub fn solve_pair(pair: &Pair<'_>) -> Result<PairSolution, PairError> {
    if pair.arrangement == Arrangement::Tandem && matches!(pair.preload, Preload::SpringN(_)) {
        return Err(PairError::SpringInTandem);
    }
    let mut shaft = pair.start();
    let mut near = [Near::Cold, Near::Cold];
    let mut now = pair.evaluate(&shaft, &mut near)?;
    for _ in 0..STEPS {
        if now.residual <= pair.tolerance() {
            break;
        }
        let step = pair.step(&now).ok_or(PairError::Loose)?;
        let farthest = step[..3].iter().fold(f64::MIN_POSITIVE, |m, v| m.max(v.abs()));
        let mut share = (LONGEST * pair.bearing.geometry.ball_diameter / farthest).min(1.0);
        let before = shaft;
        for halving in 0..=HALVINGS {
            let moved: Vector = std::array::from_fn(|k| shaft[k] + share * step[k]);
            let trial = pair.evaluate(&moved, &mut near);
            if let Ok(trial) = trial
                && (trial.residual < now.residual || halving == HALVINGS)
            {
                (shaft, now) = (moved, trial);
                break;
            }
            share *= 0.5;
        }
        if shaft == before {
            break;
        }
    }
    if now.residual > pair.tolerance() {
        if pair.inverse(&now).is_none() {
            return Err(PairError::Loose);
        }
        return Err(PairError::NotConverged { residual: now.residual, tolerance: pair.tolerance() });
    }
    Ok(pair.solution(shaft, now))
}

/// Both bearings at a displacement of the shaft.
struct Evaluated {
    answers: [Answer; 2],
    /// Load less what the bearings carry, N and N m; how far a held freedom is off, m and rad.
    lacking: Vector,
    stiffness: Matrix,
    residual: f64,
}

impl Pair<'_> {
    /// Above that of the bearings, whose forces it is made of.
    fn tolerance(&self) -> f64 {
        (100.0 * self.point.numerics.tolerance).max(1e-9)
    }

    /// Where the pair stands at rest; where that is not found, where the bearings just touch.
    fn start(&self) -> Vector {
        let still = OperatingPoint { inner_speed: 0.0, outer_speed: 0.0, ..self.point.clone() };
        let seated = |index| Seated {
            bearing: self.bearing,
            seat: self.transfer(index),
            shift: self.shift(index),
            spring: self.spring(index),
        };
        let held = self.point.ring.map(|freedom| if let RingFreedom::Held(value) = freedom { value } else { 0.0 });
        shaft_at_rest(vec![seated(0), seated(1)], &still).unwrap_or(held)
    }

    /// Axial displacement of a bearing's ring by the preload, m.
    fn shift(&self, index: usize) -> f64 {
        // In tandem the offset is how much farther the first is pushed than the second.
        let share = if self.arrangement == Arrangement::Tandem && index == 1 { -0.5 } else { 0.5 };
        if let Preload::OffsetM(offset) = self.preload { share * offset } else { 0.0 }
    }

    /// Force of the spring on a bearing whose ring slides, N.
    fn spring(&self, index: usize) -> Option<f64> {
        if let Preload::SpringN(force) = self.preload { (index == 1).then_some(force) } else { None }
    }

    fn position(&self, index: usize) -> f64 {
        (index as f64 - 0.5) * self.distance
    }

    /// dq/du: the freedoms of a bearing by those of the shaft.
    fn transfer(&self, index: usize) -> Matrix {
        let (sense, z) = (self.arrangement.senses()[index], self.position(index));
        let mut t = [[0.0; FREEDOMS]; FREEDOMS];
        (t[0][0], t[0][4]) = (1.0, z);
        (t[1][1], t[1][3]) = (1.0, -z);
        (t[2][2], t[3][3], t[4][4]) = (sense, sense, sense);
        t
    }

    /// The freedoms of a bearing's ring for a displacement of the shaft.
    fn ring(&self, index: usize, shaft: &Vector) -> [RingFreedom; FREEDOMS] {
        let moved = times(&self.transfer(index), shaft);
        let mut ring = moved.map(RingFreedom::Held);
        ring[2] = match self.spring(index) {
            Some(force) => RingFreedom::Loaded(force),
            None => RingFreedom::Held(moved[2] + self.shift(index)),
        };
        ring
    }

    fn evaluate(&self, shaft: &Vector, near: &mut [Near; 2]) -> Result<Evaluated, PairError> {
        let [first, second] = near;
        let answers = [self.answer(0, shaft, first)?, self.answer(1, shaft, second)?];
        let (mut carried, mut stiffness, mut size) = ([0.0; FREEDOMS], [[0.0; FREEDOMS]; FREEDOMS], [0.0; 2]);
        for (index, answer) in answers.iter().enumerate() {
            let t = self.transfer(index);
            for k in 0..FREEDOMS {
                carried[k] += (0..FREEDOMS).map(|i| t[i][k] * answer.force[i]).sum::<f64>();
                size[usize::from(k > 2)] += answer.force[k].abs();
                for c in 0..FREEDOMS {
                    let through = |i: usize| (0..FREEDOMS).map(|j| answer.stiffness[i][j] * t[j][c]).sum::<f64>();
                    stiffness[k][c] += (0..FREEDOMS).map(|i| t[i][k] * through(i)).sum::<f64>();
                }
            }
        }
        let mut residual = 0f64;
        let lever = 0.5 * (self.distance + self.bearing.geometry.pitch_diameter);
        let lacking = std::array::from_fn(|k| match self.point.ring[k] {
            RingFreedom::Held(value) => value - shaft[k],
            RingFreedom::Loaded(load) => {
                let of = if k < 3 { size[0] } else { size[1].max(size[0] * lever) } + load.abs();
                residual = residual.max((load - carried[k]).abs() / of.max(1e-12));
                load - carried[k]
            }
        });
        Ok(Evaluated { answers, lacking, stiffness, residual })
    }

    fn answer(&self, index: usize, shaft: &Vector, near: &mut Near) -> Result<Answer, PairError> {
        let point = OperatingPoint { ring: self.ring(index, shaft), ..self.point.clone() };
        let (solution, mut stiffness) = self.solve(&point, near)?;
        let ([x, y, z], [mx, my]) = (solution.ring_load_n, solution.ring_moment_nm);
        let mut force = [x, y, z, mx, my];
        if let RingFreedom::Loaded(load) = point.ring[2] {
            // The ring gives way along Z: it carries the spring alone, and the rest is what is left with Z free.
            force[2] = load;
            let along = stiffness[2];
            // A bearing that touches nowhere gives way without a force.
            let along = if along[2] == 0.0 { [0.0, 0.0, 1.0, 0.0, 0.0] } else { along };
            for row in &mut stiffness {
                let share = row[2] / along[2];
                row.iter_mut().zip(along).for_each(|(k, by)| *k -= share * by);
            }
        }
        Ok(Answer { force, stiffness, solution })
    }

    fn solve(&self, point: &OperatingPoint, near: &mut Near) -> Result<(Solution, Matrix), PairError> {
        match self.model {
            PairModel::QuasiStatic(Model::JonesHarris) => {
                let solution = solve(self.bearing, point, Model::JonesHarris)?.solution;
                Ok((solution, jones_harris_stiffness(self.bearing, point)?))
            }
            PairModel::QuasiStatic(model) => {
                let warm = match near {
                    Near::Equilibrium(start) => solve_from(self.bearing, point, start).ok(),
                    _ => None,
                };
                let solved = match warm {
                    Some(solved) => solved,
                    None => solve(self.bearing, point, model)?,
                };
                // A traction solution always comes with its unknowns.
                let Some(start) = solved.warm_start else { unreachable!("a traction solution has unknowns") };
                let stiffness = traction_stiffness(self.bearing, point, &start)?;
                *near = Near::Equilibrium(Box::new(start));
                Ok((solved.solution, stiffness))
            }
            PairModel::SteadyOrbit(cage, settings) => {
                let solved = match near {
                    Near::Orbit(start) => steady_orbit_from(self.bearing, point, &cage, &settings, start)?,
                    _ => steady_orbit(self.bearing, point, &cage, &settings)?,
                };
                let speeds = [point.inner_speed, point.outer_speed];
                let solution = solved.solution.as_solution(&solved.solution.balls, speeds);
                let stiffness = match &solved.start {
                    Some(start) => orbit_slopes(self.bearing, point, &cage, &settings, start)?,
                    // A bearing at rest: the elastic equilibrium.
                    None => jones_harris_stiffness(self.bearing, point)?,
                };
                *near = solved.start.map_or(Near::Cold, |start| Near::Orbit(Box::new(start)));
                Ok((solution, stiffness))
            }
        }
    }

    fn solution(&self, [x, y, z, tilt @ ..]: Vector, now: Evaluated) -> PairSolution {
        let mut index = 0;
        let bearings = now.answers.map(|answer| {
            let (sense, [x, y, z, mx, my]) = (self.arrangement.senses()[index], answer.force);
            let position_m = self.position(index);
            index += 1;
            let (load_n, moment_nm) = ([x, y, sense * z], [sense * mx, sense * my]);
            PairBearing { position_m, load_n, moment_nm, solution: answer.solution }
        });
        let [first, second] = bearings.each_ref().map(|bearing| bearing.load_n[2]);
        let preload_n = if first * second < 0.0 { first.abs().min(second.abs()) } else { 0.0 };
        PairSolution {
            shaft_displacement_m: [x, y, z],
            shaft_tilt_rad: tilt,
            preload_n,
            stiffness: now.stiffness,
            residual: now.residual,
            bearings,
        }
    }
}

fn times(matrix: &Matrix, vector: &Vector) -> Vector {
    std::array::from_fn(|i| (0..FREEDOMS).map(|k| matrix[i][k] * vector[k]).sum())
}

#[cfg(test)]
mod tests;
