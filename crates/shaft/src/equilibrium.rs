//! Equilibrium of shaft, bearings and housings by Newton's method on all nodes.
//!
//! Balls that lift off and clearance make the tangent jump or vanish. Where Newton's method from the unloaded shaft
//! finds no way, springs that centre the shaft in its bearings are added, the load is put on in steps, and the springs
//! are taken away again.

use crate::element::FREEDOMS;
use crate::error::ShaftError;
use crate::ring::{Held, Vector};
use crate::system::{Evaluated, System, resultant};
use faer::Mat;
use faer::linalg::solvers::Solve;
use tribodyn_quasistatic::StiffnessMatrix;

/// Residual over the largest force at which an equilibrium is found.
pub const TOLERANCE: f64 = 1e-9;
/// Residual that is tried for: Newton's last step costs little.
const WANTED: f64 = 1e-12;
/// Steps of Newton's method, and halvings of one.
const STEPS: usize = 80;
const HALVINGS: i32 = 10;
/// Displacement (m) that the load brings about against the first centring springs alone, and how they are taken away.
const CENTRED_WITHIN: f64 = 2e-5;
const CENTRING: [f64; 7] = [1.0, 0.2, 0.04, 8e-3, 1e-3, 1e-4, 1e-6];
/// Shares of the load that are put on with the first springs.
const SHARES: [f64; 3] = [0.1, 0.4, 1.0];
/// Load that stands for none, N.
const LEAST: f64 = 1.0;
/// Stiffness against a rigid motion below which nothing holds the shaft, over that of the stiffest.
const LOOSE: f64 = 1e-10;

/// A shaft in equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// Displacement (m) and tilt (rad) of each node.
    pub nodes: Vec<Vector>,
    /// The same of the outer rings.
    pub seats: Vec<Vector>,
    /// Displacement of each bearing's inner ring against its outer one, in the bearing's own axes.
    pub rings: Vec<Vector>,
    /// Force (N) and moment about the bearing's middle (N m) of each bearing on the shaft.
    pub reactions: Vec<Vector>,
    /// Stiffness of each bearing in the shaft's axes: force on the shaft against its displacement, with the sign
    /// changed.
    pub stiffnesses: Vec<StiffnessMatrix>,
    /// Largest residual of all freedoms over the largest force or moment.
    pub residual: f64,
    /// Sum of loads and reactions over the largest force and moment.
    pub unbalanced: f64,
    /// Steps of Newton's method.
    pub steps: usize,
    /// Directions in which the shaft moves without resistance; empty where it is held.
    pub loose: Vec<&'static str>,
}

struct Found {
    u: Mat<f64>,
    now: Evaluated,
    residual: f64,
}

impl System<'_> {
    /// The equilibrium under the loads.
    ///
    /// # Errors
    /// [`ShaftError::Loose`] where a load meets no resistance, [`ShaftError::NotConverged`], and those of bearings.
    pub fn equilibrium(&mut self) -> Result<Equilibrium, ShaftError> {
        self.equilibrium_from(None)
    }

    /// The equilibrium under the loads, from one of the same shaft nearby.
    ///
    /// # Errors
    /// As [`Self::equilibrium`].
    pub fn equilibrium_from(&mut self, near: Option<&Equilibrium>) -> Result<Equilibrium, ShaftError> {
        self.check()?;
        let linear = self.linear();
        let free = [0.0; FREEDOMS];
        let mut steps = 0;
        if let Some(near) = near.filter(|near| FREEDOMS * (near.nodes.len() + near.seats.len()) == self.unknowns()) {
            let start = Mat::from_fn(self.unknowns(), 1, |row, _| {
                let all = near.nodes.iter().chain(&near.seats).nth(row / FREEDOMS);
                all.map_or(0.0, |vector| vector[row % FREEDOMS])
            });
            if let Ok(found) = self.newton(&linear, start, 1.0, &free, &mut steps) {
                return self.answer(&linear, found, steps);
            }
        }
        if let Ok(found) = self.newton(&linear, self.start(), 1.0, &free, &mut steps) {
            return self.answer(&linear, found, steps);
        }
        let found = self.with_springs(&linear, &mut steps).map_err(|error| {
            let held = self.supports.iter().any(|support| support.seat.slides.is_none());
            let advice = "all outer rings slide in their seats; hold one of them";
            if !held { ShaftError::Loose { direction: "along its axis", advice } } else { error }
        })?;
        self.answer(&linear, found, steps)
    }

    fn with_springs(&mut self, linear: &Mat<f64>, steps: &mut usize) -> Result<Found, ShaftError> {
        let positions = self.shaft.positions();
        let length = positions[positions.len() - 1];
        let load = self.loads.iter().flat_map(|l| [l[0], l[1], l[2], l[3] / length, l[4] / length]);
        let force = load.map(f64::abs).fold(LEAST, f64::max);
        let spring = |share: f64| {
            let k = share * force / CENTRED_WITHIN;
            let tilt = k * (0.1 * length).powi(2);
            [k, k, k, tilt, tilt]
        };
        let mut u = self.start();
        for share in SHARES {
            u = self.newton(linear, u, share, &spring(CENTRING[0]), steps)?.u;
        }
        for centring in &CENTRING[1..] {
            // A spring that cannot be thinned out further leaves its start to the next.
            match self.newton(linear, u.clone(), 1.0, &spring(*centring), steps) {
                Ok(found) => u = found.u,
                Err(_) => break,
            }
        }
        let found = self.newton(linear, u.clone(), 1.0, &[0.0; FREEDOMS], steps);
        match found {
            Ok(found) => Ok(found),
            Err(error) => {
                let now = self.evaluate(linear, &u, 1.0, &[0.0; FREEDOMS])?;
                let tangent = self.tangent(linear, &now.held, &[0.0; FREEDOMS]);
                Err(self.loose(&tangent).first().map_or(error, |&direction| ShaftError::Loose {
                    direction,
                    advice: "a bearing without load or preload gives no resistance; give preload, or locate it",
                }))
            }
        }
    }

    fn newton(
        &mut self,
        linear: &Mat<f64>,
        start: Mat<f64>,
        share: f64,
        centring: &Vector,
        steps: &mut usize,
    ) -> Result<Found, ShaftError> {
        let mut u = start;
        let mut now = self.evaluate(linear, &u, share, centring)?;
        let mut residual = self.residual(&now);
        for _ in 0..STEPS {
            if residual <= WANTED {
                break;
            }
            let tangent = self.tangent(linear, &now.held, centring);
            let step = tangent.partial_piv_lu().solve(&now.lacking);
            if !(0..step.nrows()).all(|k| step[(k, 0)].is_finite()) {
                break;
            }
            *steps += 1;
            let mut length = self.allowed_share(&step);
            let mut better = None;
            for _ in 0..=HALVINGS {
                let trial = &u + Mat::from_fn(step.nrows(), 1, |k, _| length * step[(k, 0)]);
                if let Ok(evaluated) = self.evaluate(linear, &trial, share, centring) {
                    let left = self.residual(&evaluated);
                    if left < residual {
                        better = Some((trial, evaluated, left));
                        break;
                    }
                }
                length *= 0.5;
            }
            let Some(found) = better else { break };
            (u, now, residual) = found;
        }
        if residual <= TOLERANCE {
            return Ok(Found { u, now, residual });
        }
        Err(ShaftError::NotConverged { residual, share, tolerance: TOLERANCE })
    }

    /// Largest of what is lacking, over the largest force or moment; over a ball's play where a seat is held.
    fn residual(&self, now: &Evaluated) -> f64 {
        let positions = self.shaft.positions();
        let length = positions[positions.len() - 1];
        let force = now.size[0].max(now.size[1] / length).max(1e-9);
        let mut largest = 0.0f64;
        let edge = FREEDOMS * self.shaft.nodes();
        for row in 0..now.lacking.nrows() {
            let k = row % FREEDOMS;
            let held = row >= edge && self.is_held((row - edge) / FREEDOMS, k);
            let scale = match (held, k > 2) {
                (true, _) => 1e-3,
                (false, true) => force * length,
                (false, false) => force,
            };
            let relative = now.lacking[(row, 0)].abs() / scale;
            largest = if relative.is_nan() { f64::INFINITY } else { largest.max(relative) };
        }
        largest
    }

    /// Share of a step that no bearing finds too long.
    fn allowed_share(&self, step: &Mat<f64>) -> f64 {
        let mut share = 1.0f64;
        for (index, support) in self.supports.iter().enumerate() {
            let (node, seat) = (FREEDOMS * support.node, self.seat(index));
            let [length, tilt] = support.ring.longest_step();
            for k in 0..FREEDOMS {
                let moved = (step[(node + k, 0)] - step[(seat + k, 0)]).abs();
                share = share.min(if k < 3 { length } else { tilt } / moved.max(1e-300));
            }
        }
        share
    }

    fn answer(&self, linear: &Mat<f64>, found: Found, steps: usize) -> Result<Equilibrium, ShaftError> {
        let Found { u, now, residual } = found;
        let at = |row: usize| std::array::from_fn(|k| u[(row + k, 0)]);
        let nodes: Vec<Vector> = (0..self.shaft.nodes()).map(|node| at(FREEDOMS * node)).collect();
        let reactions: Vec<Vector> = now.held.iter().map(|held| held.force.map(|force| -force)).collect();
        let positions = self.shaft.positions();
        let mut all = self.loads.clone();
        for (support, reaction) in self.supports.iter().zip(&reactions) {
            (0..FREEDOMS).for_each(|k| all[support.node][k] += reaction[k]);
        }
        let length = positions[positions.len() - 1];
        let force = now.size[0].max(now.size[1] / length).max(1e-9);
        let sum = resultant(&positions, &all);
        let relative = (0..FREEDOMS).map(|k| sum[k].abs() / if k < 3 { force } else { force * length });
        let tangent = self.tangent(linear, &now.held, &[0.0; FREEDOMS]);
        Ok(Equilibrium {
            rings: (0..self.supports.len()).map(|index| self.ring_displacement(index, &u)).collect(),
            seats: (0..self.supports.len()).map(|index| at(self.seat(index))).collect(),
            stiffnesses: now.held.iter().map(|held: &Held| held.stiffness).collect(),
            unbalanced: relative.fold(0.0, f64::max),
            loose: self.loose(&tangent),
            nodes,
            reactions,
            residual,
            steps,
        })
    }

    /// Directions in which a rigid shaft meets no resistance.
    fn loose(&self, tangent: &Mat<f64>) -> Vec<&'static str> {
        let positions = self.shaft.positions();
        let middle = 0.5 * positions[positions.len() - 1];
        let half = middle.max(1e-9);
        // Tilts so that the ends move by the unit of a displacement.
        let motion = |kind: usize, z: f64| -> Vector {
            let out = (z - middle) / half;
            match kind {
                0 => [1.0, 0.0, 0.0, 0.0, 0.0],
                1 => [0.0, 1.0, 0.0, 0.0, 0.0],
                2 => [0.0, 0.0, 1.0, 0.0, 0.0],
                3 => [0.0, -out, 0.0, 1.0 / half, 0.0],
                _ => [out, 0.0, 0.0, 0.0, 1.0 / half],
            }
        };
        let resistance = |kind: usize| {
            let vectors: Vec<Vector> = positions.iter().map(|&z| motion(kind, z)).collect();
            let mut sum = 0.0;
            for (i, a) in vectors.iter().enumerate() {
                for (j, b) in vectors.iter().enumerate() {
                    for (p, left) in a.iter().enumerate() {
                        let row = FREEDOMS * i + p;
                        sum += left * (0..FREEDOMS).map(|q| tangent[(row, FREEDOMS * j + q)] * b[q]).sum::<f64>();
                    }
                }
            }
            sum
        };
        let names = ["along x", "along y", "along z", "against tilting about x", "against tilting about y"];
        let all: Vec<f64> = (0..FREEDOMS).map(resistance).collect();
        let stiffest = all.iter().fold(0.0f64, |m, v| m.max(*v));
        // Rounding of the free shaft's own matrix.
        let rounding = 1e-13 * (0..tangent.nrows()).map(|k| tangent[(k, k)].abs()).fold(0.0, f64::max);
        let none = (LOOSE * stiffest).max(rounding);
        names.into_iter().zip(all).filter(|(_, resistance)| *resistance <= none).map(|(name, _)| name).collect()
    }
}
