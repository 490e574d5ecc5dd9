//! How stiff a state is: the bound on the step of an explicit scheme.

use crate::equations::{BallForces, Equations, Frame};
use crate::layout::{BALL, VELOCITY};
use crate::machine::Machine;
use nalgebra::{Matrix6, Schur};
use serde::{Deserialize, Deserializer, Serialize};

/// The stiffest modes at a state.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Stiffness {
    /// Fastest decay by friction of any ball, 1/s.
    pub traction_rate_per_s: f64,
    /// The ball with it.
    pub ball: usize,
    /// Highest frequency of a ball between its races, Hz.
    pub contact_frequency_hz: f64,
    /// Longest step at which the classical Runge–Kutta method is stable, s; infinite where nothing is stiff.
    #[serde(deserialize_with = "or_infinite")]
    pub runge_kutta_step_s: f64,
    /// Longest step of the fast scheme, s; oil in the pockets bounds it as it does the other. With a law or a choice of
    /// pressure for which the patch has no derivative in closed form, friction is explicit there and bounds it too.
    /// Infinite where no contact carries load.
    #[serde(deserialize_with = "or_infinite")]
    pub fast_step_s: f64,
}

/// A number that JSON has as `null` because it is infinite.
pub(crate) fn or_infinite<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or(f64::INFINITY))
}

/// Longest step of the fast scheme over the period of springs that nothing damps: from half a period on the kicks drive
/// them.
pub(crate) const FAST_PERIOD: f64 = 0.45;
/// The same where contacts are damped by [`DAMPED`] and more, for which no step is seen to drive them: the longest that
/// was tried, with bearings from a 608 to a 6308.
const FAST_PERIOD_DAMPED: f64 = 2.0;
/// Damping of the contacts over the critical one.
const DAMPED: f64 = 0.01;
/// The same from which on what contacts vibrate has died out after a period, and folds into no spectrum: of a 6206 and
/// a 608 with 0.25, sampled at 25.6 kHz, bands within 40 dB of the highest are the same to 6 % in steps of 2.5 and of
/// 19.6 µs, in which contacts vibrate 0.9 and 2.2 times.
const WELL_DAMPED: f64 = 0.2;

/// Where the stability region of the classical Runge–Kutta method ends on the negative real axis, and on the imaginary.
pub(crate) const REAL_LIMIT: f64 = 2.785;
pub(crate) const IMAGINARY_LIMIT: f64 = 2.828;
/// Where that of Euler's explicit method ends.
pub(crate) const EULER_LIMIT: f64 = 2.0;
/// Square of step and angular frequency on the walls of the pockets, half of where leapfrog ends: dampers take of it,
/// too.
const MOST_OF_POCKET: f64 = 2.0;
/// Relative change of a speed for the difference quotients, and the least change, m/s or rad/s.
const RELATIVE_CHANGE: f64 = 1e-7;
const LEAST_CHANGE: f64 = 1e-5;

/// Most iterations for the eigenvalues of a ball: it takes some ten.
const MOST_ITERATIONS: usize = 1000;

/// Fastest decay of a linear system, 1/s. Where there are no eigenvalues, since a motion has gone beyond all numbers,
/// it is the largest number: no step is short enough.
fn fastest_decay(matrix: Matrix6<f64>) -> f64 {
    // The iteration need not end for what is not a number.
    match Schur::try_new(matrix, f64::EPSILON, MOST_ITERATIONS) {
        Some(schur) => schur.complex_eigenvalues().iter().fold(0.0f64, |most, e| most.max(-e.re)).min(f64::MAX),
        None => f64::MAX,
    }
}

impl Machine {
    /// Stiffest modes of the balls, each by itself.
    pub fn stiffness(&self, t: f64, y: &[f64]) -> Stiffness {
        let frame = self.frame(t, y);
        let (mut rate, mut worst, mut frequency) = (0.0f64, 0, 0.0f64);
        for index in 0..self.layout.balls {
            let b = self.unknowns(index, y);
            let here = self.with_kernel(index, b, &frame);
            let fastest = fastest_decay(self.velocity_jacobian((index, b), &frame, &here));
            if fastest > rate {
                (rate, worst) = (fastest, index);
            }
            frequency = frequency.max(self.contact_frequency(&here));
        }
        let implicit = self.kernel.has_derivative(&self.bearing);
        let omega = std::f64::consts::TAU * frequency;
        let film = self.pocket_film_step();
        Stiffness {
            traction_rate_per_s: rate,
            ball: worst,
            contact_frequency_hz: frequency,
            runge_kutta_step_s: (REAL_LIMIT / rate).min(IMAGINARY_LIMIT / omega).min(film),
            fast_step_s: (self.fast_period() / frequency)
                .min(if implicit { f64::INFINITY } else { EULER_LIMIT / rate })
                .min(film)
                .min(self.free_cage_step()),
        }
    }

    /// Longest step at which the oil in the pockets is stable where it is thinnest, at all balls at once, s; infinite
    /// in dry ones.
    pub(crate) fn pocket_film_step(&self) -> f64 {
        let pocket = &self.cage.pocket;
        let Some(film) = &pocket.film else { return f64::INFINITY };
        let of_cage = self.layout.balls as f64 * pocket.radius * pocket.radius / self.cage.inertia;
        EULER_LIMIT * film.least_thickness() / (film.resistance * (self.bearing.ball_mass.recip() + of_cage))
    }

    /// Longest step of the fast scheme with a free cage that all balls press, s: half of that at which what vibrates on
    /// the walls of the pockets is no more stable. Infinite for others, which touch few balls.
    pub(crate) fn free_cage_step(&self) -> f64 {
        let (Some(cage), pocket) = (&self.free_cage, &self.cage.pocket) else { return f64::INFINITY };
        let balls = self.layout.balls as f64;
        let turning = balls * pocket.radius * pocket.radius / self.cage.inertia;
        let moving = 0.5 * balls / cage.mass;
        (pocket.stiffness * (self.bearing.ball_mass.recip() + turning.max(moving))).sqrt().recip()
    }

    /// Lets no film in a pocket be thinner than a step of the fast scheme resolves, where the step is longer than
    /// [`Self::pocket_film_step`]: the last micrometres before a ball meets its wall are then softer.
    pub(crate) fn thicken_pocket_film(&mut self, step: f64) {
        let over = step / self.pocket_film_step();
        if let Some(film) = self.cage.pocket.film.as_mut().filter(|_| over > 1.0) {
            film.thinnest = EULER_LIMIT * over * film.least_thickness();
        }
    }

    /// Fits the pockets of a cage that only turns to a step of the fast scheme in which so many balls press on it: as
    /// soft as what vibrates on their walls is resolved, and how much stops a ball within the step. One ball alone
    /// hardly ever makes a pocket softer; several that a blow throws on a light cage do.
    pub(crate) fn fit_pockets(&mut self, touching: usize, step: f64) {
        if self.free_cage.is_some() {
            return;
        }
        let pocket = &self.cage.pocket;
        let of_cage = touching as f64 * pocket.radius * pocket.radius / self.cage.inertia;
        self.hold = 1.0 / (step * (self.bearing.ball_mass.recip() + of_cage));
        self.pocket_share = (MOST_OF_POCKET * self.hold / (step * pocket.stiffness)).min(1.0);
    }

    /// Longest step of the fast scheme over the period of the contact springs.
    pub(crate) fn fast_period(&self) -> f64 {
        if self.bearing.contact_damping < DAMPED { FAST_PERIOD } else { FAST_PERIOD_DAMPED }
    }

    /// True where what contacts vibrate dies out within a period.
    pub(crate) fn is_well_damped(&self) -> bool {
        self.bearing.contact_damping >= WELL_DAMPED
    }

    fn with_kernel(&self, index: usize, b: &[f64], frame: &Frame) -> BallForces {
        self.ball(index, b, frame, |patch, _| self.kernel.traction(&self.bearing, patch))
    }

    /// Derivatives of a ball's six accelerations by its six velocities, by differences to one side, from what there is
    /// `here`: the bound needs no digits.
    fn velocity_jacobian(&self, (index, b): (usize, &[f64]), frame: &Frame, here: &BallForces) -> Matrix6<f64> {
        let mut unknowns = [0.0; BALL];
        unknowns.copy_from_slice(b);
        let mut jacobian = Matrix6::zeros();
        for column in 0..6 {
            let at = VELOCITY + column;
            let change = (RELATIVE_CHANGE * b[at].abs()).max(LEAST_CHANGE);
            unknowns[at] = b[at] + change;
            let there = self.with_kernel(index, &unknowns, frame).acceleration;
            unknowns[at] = b[at];
            for row in 0..6 {
                jacobian[(row, column)] = (there[row] - here.acceleration[row]) / change;
            }
        }
        jacobian
    }

    /// sqrt of the stiffness against an axial or radial shift over the mass; both contacts in line bound it from above.
    fn contact_frequency(&self, ball: &BallForces) -> f64 {
        let stiffness = ball.contacts.each_ref().map(|c| {
            let normal = &c.normal;
            if normal.load > 0.0 { 1.5 * normal.load / normal.pose.approach } else { 0.0 }
        });
        ((stiffness.inner + stiffness.outer) / self.bearing.ball_mass).sqrt() / std::f64::consts::TAU
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_what_is_not_a_number_has_no_stable_step_and_ends() {
        let mut matrix = Matrix6::from_diagonal_element(-3.0);
        assert_eq!(fastest_decay(matrix), 3.0);
        for value in [f64::NAN, f64::INFINITY, 1e300] {
            matrix.fill(value);
            assert!(fastest_decay(matrix) >= 0.0);
        }
        matrix.fill(f64::NAN);
        assert_eq!(fastest_decay(matrix), f64::MAX);
    }

    #[test]
    fn identity_a_bearing_without_loaded_contacts_goes_through_a_checkpoint() {
        let free = Stiffness {
            traction_rate_per_s: 0.0,
            ball: 0,
            contact_frequency_hz: 0.0,
            runge_kutta_step_s: f64::INFINITY,
            fast_step_s: f64::INFINITY,
        };
        let text = serde_json::to_string(&free).unwrap();
        assert_eq!(serde_json::from_str::<Stiffness>(&text).unwrap(), free);
    }
}
