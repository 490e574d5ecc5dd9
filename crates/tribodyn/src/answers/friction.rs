//! Operating points with friction, for answers about what it takes.

use super::{Equations, Findings, OrbitAnswer, Question, solved};
use crate::error::AnswerError;
use tribodyn_bearing::{BallResult, Bearing, ContactResult, Side};
use tribodyn_orbit::OrbitStart;
use tribodyn_quasistatic::{Model, Solution};

/// A bearing with friction; sums over its balls are means over time.
pub(super) struct WithFriction {
    pub bearing: Bearing,
    /// The balls where they stand.
    pub solution: Solution,
    pub findings: Findings,
    /// Torque that the shaft needs, N m.
    pub torque_nm: f64,
    /// Frictional power of the contacts with the inner race and with the outer one, W.
    pub friction_w: [f64; 2],
    /// Power of drag and churning, W.
    pub fluid_w: f64,
    /// All balls of an equilibrium, or one ball round its orbit, each with the number of balls that it stands for.
    shares: Vec<(f64, BallResult)>,
}

impl WithFriction {
    /// The operating point of a case.
    ///
    /// # Errors
    /// Equations without friction, or a case that they do not solve.
    pub fn solve(question: &Question<'_>, equations: Equations) -> Result<Self, AnswerError> {
        Self::solve_near(question, equations, &mut None)
    }

    /// The same from the orbit of a neighbour, where there is one, which gives way to that of this point: none where
    /// that is not quite of the case, as its neighbours may be.
    ///
    /// # Errors
    /// As [`Self::solve`].
    pub fn solve_near(
        question: &Question<'_>,
        equations: Equations,
        near: &mut Option<OrbitStart>,
    ) -> Result<Self, AnswerError> {
        match equations.equilibrium() {
            Some(Model::JonesHarris) => {
                let message = "balls roll without friction in this model: allowed are traction, steady-orbit";
                Err(AnswerError::argument("model", equations.name(), message))
            }
            Some(model) => Self::of_equilibrium(question, model),
            None => Self::of_orbit(question, near),
        }
    }

    fn of_equilibrium(question: &Question<'_>, model: Model) -> Result<Self, AnswerError> {
        let (bearing, found) = solved(question, model)?;
        let solution = found.solution;
        let findings = Findings::of(question, &bearing, (model.into(), &solution))?;
        let Some(torque_nm) = solution.shaft_torque_nm else {
            unreachable!("an equilibrium with traction has a torque")
        };
        let of = |side: Side| {
            let frictions = solution.balls.iter().filter_map(|ball| ball.contacts[side].friction);
            frictions.map(|friction| friction.power_loss_w).sum::<f64>()
        };
        let friction_w = Side::BOTH.map(of);
        let fluid_w = solution.balls.iter().filter_map(|ball| ball.fluid).map(|fluid| fluid.power_loss_w).sum();
        let shares = solution.balls.iter().map(|ball| (1.0, *ball)).collect();
        Ok(Self { bearing, findings, torque_nm, friction_w, fluid_w, shares, solution })
    }

    fn of_orbit(question: &Question<'_>, near: &mut Option<OrbitStart>) -> Result<Self, AnswerError> {
        let (_, answer, start) = OrbitAnswer::with_start(question, near.as_ref())?;
        let OrbitAnswer { orbit, solution, findings, .. } = answer;
        *near = start.filter(|_| orbit.is_of_the_case());
        let bearing = question.bearing_for(Equations::SteadyOrbit.purpose())?;
        let (torque_nm, friction_w, fluid_w) = (orbit.shaft_torque_nm, orbit.friction_w, orbit.fluid_w);
        let shares = shares(orbit.points, solution.balls.len() as f64);
        Ok(Self { bearing, findings, torque_nm, friction_w, fluid_w, shares, solution })
    }

    /// A sum over the contacts of a race.
    pub fn sum(&self, side: Side, of: impl Fn(&ContactResult) -> f64) -> f64 {
        self.shares.iter().map(|(share, ball)| share * of(&ball.contacts[side])).sum()
    }
}

/// A ball at even places round its orbit, each by the time that it spends there.
fn shares(points: Vec<BallResult>, balls: f64) -> Vec<(f64, BallResult)> {
    let times: Vec<f64> = points.iter().map(|point| point.orbital_speed_rad_s.abs().recip()).collect();
    let turn: f64 = times.iter().sum();
    // Balls that stand stay at all of their places.
    let even = balls / points.len() as f64;
    let shares = times.into_iter().map(|time| if turn.is_finite() { balls * time / turn } else { even });
    shares.zip(points).collect()
}

/// Refuses a case whose rings do not turn against each other, for an answer that `needs` it.
pub(super) fn turning(question: &Question<'_>, needs: &str) -> Result<(), AnswerError> {
    let point = question.case.operating_point();
    if point.inner_speed != point.outer_speed && !point.turns_as_one() {
        return Ok(());
    }
    let why = format!("the rings do not turn against each other, which {needs} needs");
    Err(AnswerError::not_asked(question.name, &why))
}
