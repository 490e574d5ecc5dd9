//! Traction through a film with its derivatives, in closed form at every node.

use super::node::Sloped;
use super::{FilmContact, FilmLaw, FilmState};
use crate::{Patch, PatchDerivative, PatchTraction, Quadrature, RelativeMotion, SlipField};
use num_dual::{DualNum, DualSVec64};

/// Force along and across, moments about the normal, the lateral axis and the rolling direction, and power.
type Outputs = [f64; 6];
/// Motion (5), load and rolling speed.
const INPUTS: usize = 7;
type Dual = DualSVec64<INPUTS>;

/// Sums over the nodes, all at the film's temperature.
#[derive(Default)]
struct Sums {
    value: Outputs,
    wear: f64,
    wear_by_load: f64,
    by_motion: [Outputs; 5],
    /// With ln Q: pressure, semi-axes and places of the nodes, at the same film.
    by_load: Outputs,
    by_temperature: Outputs,
    by_gap: Outputs,
    by_log_creep: Outputs,
    by_share: Outputs,
}

/// One node.
struct Place {
    x: f64,
    y: f64,
    arm: f64,
    slip: [f64; 2],
}

impl Place {
    /// What a stress along and across on the ball adds to the outputs.
    fn outputs(&self, [fx, fy]: [f64; 2]) -> Outputs {
        let power = -(fx * self.slip[0] + fy * self.slip[1]);
        [fx, fy, self.x * fy - self.y * fx, self.arm * fx, -self.arm * fy, power]
    }
}

fn add(sum: &mut Outputs, term: Outputs, factor: f64) {
    sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += factor * term);
}

impl FilmLaw {
    /// [`Self::traction`] with its derivatives by motion, load and rolling speed, the semi-axes and the peak pressure
    /// growing with the cube root of the load.
    pub fn derivative(&self, contact: &FilmContact, quadrature: &Quadrature) -> PatchDerivative {
        if contact.patch.peak_pressure <= 0.0 {
            return PatchDerivative::zero();
        }
        let settled = self.settled(contact, quadrature);
        let film = Sloped::new(self.shearing(contact, settled.temperature), &self.oil, settled.temperature);
        let sums = self.sums(&film, contact, quadrature);
        let seeded = seeded(contact);
        let state = self.state(&seeded);
        let by_input = self.by_inputs(&sums, (&seeded, &state), settled.slope);
        assemble(&sums, &by_input, &self.rolling_loads(&seeded), contact.load())
    }

    /// Change of the outputs with each input.
    fn by_inputs(
        &self,
        sums: &Sums,
        (contact, state): (&FilmContact<Dual>, &FilmState<Dual>),
        of_heat: f64,
    ) -> [Outputs; INPUTS] {
        let gap = self.gap(state.thickness.central);
        let share = state.asperity_share;
        let heating = self.heating(contact);
        let log_creep = contact.speed().ln();
        let load = contact.load();
        std::array::from_fn(|input| {
            let along = |dual: &Dual| slope(dual, input);
            let mut change = Outputs::default();
            match input {
                0..5 => add(&mut change, sums.by_motion[input], 1.0),
                5 => add(&mut change, sums.by_load, 1.0 / load.re),
                _ => {}
            }
            add(&mut change, sums.by_gap, along(&gap));
            add(&mut change, sums.by_share, along(&share));
            add(&mut change, sums.by_log_creep, along(&log_creep));
            let warmer = (heating.re * change[5] + sums.value[5] * along(&heating)) / (1.0 - of_heat);
            add(&mut change, sums.by_temperature, warmer);
            change
        })
    }

    fn sums(&self, film: &Sloped, contact: &FilmContact, quadrature: &Quadrature) -> Sums {
        let FilmContact { patch, motion, .. } = contact;
        let mut sums = Sums::default();
        quadrature.for_each(&SlipField::new(patch, motion), |x, y, weight: f64| {
            let inside = 1.0 - x * x - y * y;
            if inside > 0.0 {
                sums.add_node(film, (patch, motion), [x, y, weight, inside.sqrt()]);
            }
        });
        sums
    }
}

impl Sums {
    #[inline]
    fn add_node(
        &mut self,
        film: &Sloped,
        (patch, motion): (&Patch, &RelativeMotion),
        [unit_x, unit_y, weight, depth]: [f64; 4],
    ) {
        let (a, b) = (patch.semi_lateral, patch.semi_rolling);
        let (x, y) = (b * unit_x, a * unit_y);
        let [u, v] = motion.slip_at(x, y, patch);
        let speed = u.hypot(v);
        let bow = y * y * (0.5 / patch.surface_radius);
        let arm = patch.ball_radius - bow;
        let place = Place { x, y, arm, slip: [u, v] };
        let pressure = patch.peak_pressure * depth;
        let node = film.slopes(pressure, film.relative_log(pressure), speed);
        let area = a * b * weight / depth;
        let ahead = if speed > 0.0 { [u / speed, v / speed] } else { [0.0; 2] };
        let (t, bend) = (area * node.value, area * node.bend);
        // K of df = −K dΔv.
        let across = bend * ahead[0] * ahead[1];
        let stiffness = [t + bend * ahead[0] * ahead[0], across, t + bend * ahead[1] * ahead[1]];
        let pushed =
            |[du, dv]: [f64; 2]| [-(stiffness[0] * du + stiffness[1] * dv), -(stiffness[1] * du + stiffness[2] * dv)];
        let force = [-t * u, -t * v];
        add(&mut self.value, place.outputs(force), 1.0);
        self.wear += area * pressure * speed;
        // Δv by rolling, lateral, spin, about lateral, about rolling.
        let directions = [[1.0, 0.0], [0.0, 1.0], [-y, x], [arm, 0.0], [0.0, -arm]];
        for (sum, direction) in self.by_motion.iter_mut().zip(directions) {
            let df = pushed(direction);
            let mut change = place.outputs(df);
            change[5] -= force[0] * direction[0] + force[1] * direction[1];
            add(sum, change, 1.0);
        }
        let along = |slope: f64| place.outputs([-area * slope * u, -area * slope * v]);
        add(&mut self.by_temperature, along(node.by_temperature), 1.0);
        add(&mut self.by_gap, along(node.by_gap), 1.0);
        add(&mut self.by_log_creep, along(node.by_log_creep), 1.0);
        add(&mut self.by_share, along(node.by_share), 1.0);
        // All lengths and the pressure grow by a third of ln Q, the area by two thirds.
        let moved =
            [-motion.spin * y - 2.0 * motion.about_lateral * bow, motion.spin * x + 2.0 * motion.about_rolling * bow];
        let df = pushed(moved);
        let grown = 2.0 * node.value + node.by_log_pressure;
        let df = [df[0] - area * grown * u, df[1] - area * grown * v];
        let mut change = place.outputs(df);
        change[2] += x * force[1] - y * force[0];
        change[3] -= 2.0 * bow * force[0];
        change[4] += 2.0 * bow * force[1];
        change[5] -= force[0] * moved[0] + force[1] * moved[1];
        add(&mut self.by_load, change, 1.0 / 3.0);
        let faster = ahead[0] * moved[0] + ahead[1] * moved[1];
        self.wear_by_load += area * pressure * (speed + faster / 3.0);
    }
}

/// Derivative of a number by an input.
fn slope(dual: &Dual, input: usize) -> f64 {
    dual.eps.unwrap_generic(nalgebra::Const, nalgebra::U1)[input]
}

/// The contact with its inputs as directions of derivatives.
fn seeded(contact: &FilmContact) -> FilmContact<Dual> {
    let FilmContact { patch, motion, rolling_speed } = contact;
    let values = [motion.rolling, motion.lateral, motion.spin, motion.about_lateral, motion.about_rolling];
    let seed = |value: f64, input: usize| {
        let mut dual = Dual::from(value);
        dual.eps = num_dual::Derivative::derivative_generic(nalgebra::Const, nalgebra::U1, input);
        dual
    };
    let [rolling, lateral, spin, about_lateral, about_rolling] = std::array::from_fn(|i| seed(values[i], i));
    let load = seed(contact.load(), 5);
    let grown = (load / load.re).powf(1.0 / 3.0);
    FilmContact {
        patch: Patch {
            semi_lateral: grown * patch.semi_lateral,
            semi_rolling: grown * patch.semi_rolling,
            peak_pressure: grown * patch.peak_pressure,
            ball_radius: patch.ball_radius,
            surface_radius: patch.surface_radius,
        },
        motion: RelativeMotion { rolling, lateral, spin, about_lateral, about_rolling },
        rolling_speed: seed(*rolling_speed, 6),
    }
}

fn assemble(sums: &Sums, by_input: &[Outputs; INPUTS], rolling: &[Dual; 3], load: f64) -> PatchDerivative {
    let [force, moment, power] = rolling;
    let rolled = |input: Option<usize>| {
        let of = |dual: &Dual| match input {
            None => dual.re,
            Some(input) => slope(dual, input),
        };
        [of(force), 0.0, 0.0, of(moment), 0.0, of(power)]
    };
    let traction = |outputs: &Outputs, rolled: Outputs, wear: f64| PatchTraction {
        force_rolling: outputs[0] + rolled[0],
        force_lateral: outputs[1],
        moment_normal: outputs[2],
        moment_lateral: outputs[3] + rolled[3],
        moment_rolling: outputs[4],
        power: outputs[5] + rolled[5],
        wear_integral: wear,
    };
    let by_motion =
        std::array::from_fn(|row| std::array::from_fn(|input| by_input[input][row] + rolled(Some(input))[row]));
    PatchDerivative {
        traction: traction(&sums.value, rolled(None), sums.wear),
        by_motion,
        by_load: traction(&by_input[5], rolled(Some(5)), sums.wear_by_load / load),
        by_rolling_speed: traction(&by_input[6], rolled(Some(6)), 0.0),
    }
}
