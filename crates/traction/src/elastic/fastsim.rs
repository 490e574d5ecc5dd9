//! Kalker's simplified theory of rolling contact with a traction curve, the plain way: any scalar, any law.

use super::across::Crowding;
use super::cell::{Cell, Friction, MEMORY, Solved};
use super::elasticity::TangentialElasticity;
use super::grid::{Fastsim, Node};
use crate::{Conditions, Fall, TractionLaw};
use crate::{Patch, PatchLaw, PatchTraction, PressureChoice, RelativeMotion, Scalar, SlipCurve, SlipField};
use num_dual::Dual64;

/// The traction of a patch whose surfaces give way tangentially: [`crate::patch_traction`] with the true slip in place
/// of the rigid one.
///
/// `rolling_speed` V in m/s is the mean speed of both surfaces through the contact along x; its sign says at which end
/// of a strip they enter. At V = 0 the result is that of rigid sliding.
///
/// Steel at a creep of 1e-4 carries far less than the friction bound, which rigid surfaces reach at any creep:
/// ```
/// use tribodyn_traction::{
///     Coating, CoatingLaw, Fastsim, FastsimRule, Patch, PatchLaw, PressureChoice, RelativeMotion, SlipUnit,
///     TangentialElasticity, elastic_patch_traction,
/// };
///
/// let patch = Patch {
///     semi_lateral: 4e-3,
///     semi_rolling: 0.5e-3,
///     peak_pressure: 2e9,
///     ball_radius: 0.015,
///     surface_radius: f64::INFINITY,
/// };
/// let speed = 60.0;
/// let motion =
///     RelativeMotion { rolling: 1e-4 * speed, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 };
/// let silver = CoatingLaw::varying(&Coating::library("ag")?, 2)?;
/// let law =
///     PatchLaw { law: &silver, slip_unit: SlipUnit::Scaled { per_m_s: 1e4 }, pressure: PressureChoice::Peak };
/// let steel = TangentialElasticity::new(80e9, 0.3)?;
/// let grid = Fastsim::new(FastsimRule { across: 8, cells: 24 })?;
/// let traction = elastic_patch_traction(&patch, &motion, speed, &law, &steel, &grid);
/// let linear = 80e9 * 4e-3 * 0.5e-3 * steel.coefficients().at(0.125).longitudinal * 1e-4;
/// let difference: f64 = traction.force_rolling / -linear - 1.0;
/// assert!(difference.abs() < 0.1);
/// # Ok::<(), tribodyn_traction::TractionError>(())
/// ```
pub fn elastic_patch_traction<D: Scalar, L: TractionLaw>(
    patch: &Patch<D>,
    motion: &RelativeMotion<D>,
    rolling_speed: D,
    law: &PatchLaw<'_, L>,
    elasticity: &TangentialElasticity,
    grid: &Fastsim,
) -> PatchTraction<D> {
    let mut sum = PatchTraction::zero();
    if patch.peak_pressure.re() <= 0.0 {
        return sum;
    }
    let strips = Strips::new(patch, motion, rolling_speed, law, elasticity, grid);
    let crowding = Crowding::new(strips.slip.longitudinal, strips.taken_up);
    for &(t, weight) in &grid.across {
        let (y, stretch) = crowding.place(t);
        let squared = (-y + 1.0) * (y + 1.0);
        if squared.re() > 0.0 {
            strips.strip(y, squared.sqrt()).add_to(&mut sum, patch, y, squared * stretch * weight);
        }
    }
    sum.times(patch.peak_pressure * patch.semi_lateral * patch.semi_rolling)
}

/// Values that the strips of a patch have in common.
struct Strips<'a, D, L> {
    grid: &'a Fastsim,
    law: &'a PatchLaw<'a, L>,
    slip: SlipField<D>,
    /// λ, s/m.
    scale: D,
    /// At the highest pressure.
    conditions: Conditions<D>,
    /// |V| L p_max/b, m/s.
    yielding: [D; 2],
    /// C κ along rolling, with κ at a slip of C.
    taken_up: D,
    /// 1 where surfaces move along x, −1 against it.
    direction: f64,
}

/// Sums over one strip of half length one and peak pressure one.
struct StripSums<D> {
    /// Forces on the ball, and of force across times X.
    force: [D; 2],
    turn: D,
    power: D,
    wear: D,
}

/// A law at one pressure in the scalar, and in dual numbers for the cell's root.
type Frictions<D, L> = (Friction<<L as TractionLaw>::Curve<D>, D>, Friction<<L as TractionLaw>::Curve<Dual64>, Dual64>);

/// State that passes from cell to cell.
struct March<D> {
    /// Traction over the strip's peak pressure: parts of the next three differences that are known.
    traction: [[D; 3]; 2],
    /// The same of the weakening.
    weakening: [D; 3],
    guess: f64,
}

impl<'a, D: Scalar, L: TractionLaw> Strips<'a, D, L> {
    fn new(
        patch: &Patch<D>,
        motion: &RelativeMotion<D>,
        rolling_speed: D,
        law: &'a PatchLaw<'a, L>,
        elasticity: &TangentialElasticity,
        grid: &'a Fastsim,
    ) -> Self {
        let flexibility = elasticity.flexibility(patch, motion, rolling_speed);
        let direction = if rolling_speed.re() < 0.0 { -1.0 } else { 1.0 };
        let per_flexibility = rolling_speed * direction * patch.peak_pressure / patch.semi_rolling;
        let yielding = [flexibility.longitudinal, flexibility.lateral].map(|l| per_flexibility * l);
        let scale = law.slip_unit.scale(rolling_speed);
        let [longitudinal, _] = yielding;
        let entrainment_speed = rolling_speed.abs();
        let conditions = Conditions { pressure: patch.peak_pressure, entrainment_speed, patch: *patch };
        let taken_up = longitudinal * law.law.under(&conditions).coefficient(longitudinal * scale);
        let slip = SlipField::new(patch, motion);
        Self { grid, law, slip, scale, conditions, yielding, taken_up, direction }
    }

    /// The curve at a point in the scalar and in dual numbers, at the peak pressure or at the point's own.
    fn friction(&self, share: D) -> Frictions<D, L> {
        let pressure = match self.law.pressure {
            PressureChoice::Peak => self.conditions.pressure,
            PressureChoice::Local => self.conditions.pressure * share,
        };
        let conditions = Conditions { pressure, ..self.conditions };
        let curve = self.law.law.under(&conditions);
        let fall = curve.fall();
        let real = |x: D| Dual64::from(x.re());
        let real_fall = fall.as_ref().map(|f| Fall { slip: real(f.slip), steepness: real(f.steepness) });
        let dual = self.law.law.under(&conditions.map(real));
        (
            Friction { curve, fall, scale: self.scale },
            Friction { curve: dual, fall: real_fall, scale: real(self.scale) },
        )
    }

    /// Marches from the leading edge of the strip at `y` with half length `chord` to its trailing edge.
    fn strip(&self, y: D, chord: D) -> StripSums<D> {
        let zero = D::zero();
        let mut sums = StripSums { force: [zero; 2], turn: zero, power: zero, wear: zero };
        let edge = self.rigid_slip(chord * -self.direction, y);
        let entering = norm(edge);
        let sticking = sticking(self.taken_up, entering);
        let mut friction = self.friction(D::one());
        let [_, weak] = friction.0.at(entering);
        let mut march = March { traction: [[zero; 3]; 2], weakening: self.grid.entering.map(|a| weak * a), guess: 0.0 };
        for node in &self.grid.nodes {
            if self.law.pressure == PressureChoice::Local {
                friction = self.friction(chord * node.sin);
            }
            let x = chord * (-self.direction * node.cos);
            let rigid = self.rigid_slip(x - chord * sticking * (self.direction * node.mean), y);
            let cell = self.step(node, rigid, &mut march, &friction);
            let traction = cell.traction.map(|t| t * node.sin);
            for (sum, part) in sums.force.iter_mut().zip(traction) {
                *sum += part * node.weight;
            }
            sums.turn += x * traction[1] * node.weight;
            sums.power += cell.coefficient * cell.speed * (node.weight * node.sin);
            sums.wear += cell.speed * (node.weight * node.sin);
        }
        sums
    }

    fn rigid_slip(&self, x: D, y: D) -> [D; 2] {
        self.slip.at(x, y)
    }

    fn step(&self, node: &Node, rigid: [D; 2], march: &mut March<D>, (friction, slope): &Frictions<D, L>) -> Solved<D> {
        let yielding = self.yielding.map(|y| y * node.over_reach);
        let trial: [D; 2] = std::array::from_fn(|k| rigid[k] - yielding[k] * march.traction[k][0] * node.over_sine);
        let keep = friction.fall.as_ref().map_or(D::zero(), |fall| {
            let [x, y] = self.yielding;
            let softer = if x.re() > y.re() { x } else { y };
            let memory = softer * friction.scale * fall.steepness * MEMORY;
            memory / (memory + node.memory_reach)
        });
        let [remembered, ..] = march.weakening;
        // The difference may overshoot where friction falls to almost nothing: it must not turn round.
        let remembered = if remembered.re() > 1.0 { D::one() } else { remembered };
        let cell = Cell { friction, trial, yielding, memory: [keep, remembered] };
        let real = |x: D| Dual64::from(x.re());
        let dual = Cell {
            friction: slope,
            trial: trial.map(real),
            yielding: yielding.map(real),
            memory: cell.memory.map(real),
        };
        let solved = cell.solve(&dual, march.guess);
        for (coming, traction) in march.traction.iter_mut().zip(solved.traction) {
            pass_on(coming, node, traction * node.sin);
        }
        pass_on(&mut march.weakening, node, solved.weakening);
        march.guess = solved.speed.re();
        solved
    }
}

impl<D: Scalar> StripSums<D> {
    /// Adds the strip at `y` with its share of the patch.
    fn add_to(&self, sum: &mut PatchTraction<D>, patch: &Patch<D>, y: D, share: D) {
        let [fx, fy] = self.force.map(|f| f * share);
        let lateral = y * patch.semi_lateral;
        let flatness = 0.5 / patch.surface_radius;
        let arm = D::from(patch.ball_radius) - lateral * lateral * flatness;
        sum.force_rolling += fx;
        sum.force_lateral += fy;
        sum.moment_lateral += arm * fx;
        sum.moment_normal += patch.semi_rolling * self.turn * share - lateral * fx;
        sum.moment_rolling -= arm * fy;
        sum.power += self.power * share;
        sum.wear_integral += self.wear * share;
    }
}

/// Share of the mean slip over a difference in the slip of a cell, by the slip that is taken up and that at the leading
/// edge. With twice or half the former the errors hardly change.
fn sticking<D: Scalar>(taken_up: D, entering: D) -> D {
    taken_up / (taken_up + entering * 0.5 + f64::MIN_POSITIVE)
}

/// Adds what is now known to the next three differences.
fn pass_on<D: Scalar>(coming: &mut [D; 3], node: &Node, known: D) {
    let [a, b, c] = node.next;
    *coming = [known * a + coming[1], known * b + coming[2], known * c];
}

/// |v| with derivative zero at the origin.
fn norm<D: Scalar>([u, v]: [D; 2]) -> D {
    let squared = u * u + v * v;
    if squared.re() > 1e-60 { squared.sqrt() } else { D::zero() }
}
