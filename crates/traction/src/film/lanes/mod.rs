//! Traction through a film with its derivatives in closed form, eight nodes at a time.
//!
//! The part of a node's stress that depends on its pressure and speed alone is worked out once; then the temperature of
//! the film is found, with two or three looks at the power of all nodes; then the integrals are summed. They agree with
//! [`FilmLaw::traction`] to 1e-10 of the largest, and derivatives to 1e-5.

mod nodes;
mod state;
mod stress;
mod sums;

use super::{FilmLaw, Shearing};
use crate::{FastPatch, MovingPatch, PatchDerivative, PatchTraction};
use fearless_simd::dispatch;
use nodes::{Collected, Ground, Kept};
use state::State;
use stress::Sloped;
use sums::{OUTPUTS, Outputs, Slopes, Values, slopes, values};

/// Motion (5), load and rolling speed.
const INPUTS: usize = 7;
/// Looks at the power before the last temperature is taken.
const ROUNDS: usize = 40;
/// Temperature within which the film must be where the integrals are summed, K: they are carried on to first order, and
/// the next term is 1e-10 of them.
const NEAR: f64 = 3e-4;
/// Largest second derivative of the logarithm of the power by the temperature, 1/K².
const BEND: f64 = 5e-4;

/// A film whose temperature is looked for.
struct Warm<'a> {
    law: &'a FilmLaw,
    /// At the temperature of its surroundings.
    shearing: Shearing,
    /// K/W.
    heating: f64,
}

impl Warm<'_> {
    /// All nodes of a patch, and the film at a temperature from which the integrals can be carried on.
    fn settle(&self, ground: &Ground, fast: &FastPatch) -> (Vec<Kept>, Sloped, f64) {
        let mut all = Collected { of: ground, nodes: Vec::with_capacity(fast.layout().groups()) };
        let coarse = dispatch!(fast.level(), simd => {
            fast.layout().walk(simd, &ground.slip, &mut all);
            ground.coarse(simd)
        });
        let from = self.near(self.law.temperature, fast, &[coarse]);
        let temperature = self.near(from, fast, &all.nodes);
        (all.nodes, Sloped::new(self.law, &self.shearing, temperature), temperature)
    }

    /// A temperature near that of the film, from another.
    fn near(&self, from: f64, fast: &FastPatch, nodes: &[Kept]) -> f64 {
        let mut temperature = from;
        for _ in 0..ROUNDS {
            let film = Sloped::new(self.law, &self.shearing, temperature);
            let step = self.step(temperature, stress::power(fast.level(), &film, nodes));
            temperature += step;
            // What the step leaves of the way.
            if BEND * step * step * (temperature - self.law.temperature).abs() < NEAR {
                break;
            }
        }
        temperature
    }

    /// From a temperature towards that which heat and cooling agree on, by power (W) and its slope (W/K) there, K.
    ///
    /// The power falls with the temperature nearly as an exponential: with its own slope it is one, and T is the root
    /// of T = T_0 + q P exp[b (T − T_k)].
    fn step(&self, temperature: f64, [power, slope]: [f64; 2]) -> f64 {
        let ambient = self.law.temperature;
        if power <= 0.0 {
            return ambient - temperature;
        }
        let (rise, bend) = (self.heating * power, slope / power);
        let mut step = 0.0;
        for _ in 0..ROUNDS {
            let heat = rise * f64::exp(bend * step);
            let change = (ambient + heat - temperature - step) / (1.0 - bend * heat);
            step += change;
            if change.abs() < 1e-7 * step.abs() + 1e-12 {
                break;
            }
        }
        step
    }
}

impl FilmLaw {
    /// [`Self::value`] by the nodes of a patch rule laid out for vector instructions.
    pub fn fast_value(&self, contact: &MovingPatch, fast: &FastPatch) -> PatchTraction {
        if contact.patch.peak_pressure <= 0.0 {
            return PatchTraction::zero();
        }
        let shearing = self.shearing(contact, self.temperature);
        let heating = self.heating(contact, shearing.gap);
        let ground = Ground::new(self, contact, shearing.creep);
        let warm = Warm { law: self, shearing, heating };
        let (nodes, film, temperature) = warm.settle(&ground, fast);
        let values = dispatch!(fast.level(), simd => values(simd, &film, contact, &nodes));
        let outputs = values.carried(warm.step(temperature, values.heat()));
        traction(&outputs, self.rolling_loads(contact), values.wear)
    }

    /// [`Self::traction`] with its derivatives by motion, load and rolling speed, the semi-axes and the peak pressure
    /// growing with the cube root of the load.
    pub fn derivative(&self, contact: &MovingPatch, fast: &FastPatch) -> PatchDerivative {
        if contact.patch.peak_pressure <= 0.0 {
            return PatchDerivative::zero();
        }
        let state = State::new(self, contact);
        let shearing = self.sheared(contact, (state.gap.value, state.share.value), self.temperature);
        let ground = Ground::new(self, contact, shearing.creep);
        let warm = Warm { law: self, shearing, heating: state.heating.value };
        let (nodes, film, temperature) = warm.settle(&ground, fast);
        let (values, slopes) = dispatch!(fast.level(), simd => slopes(simd, &film, (contact, &state), &nodes));
        assemble(self, (contact, &state), (&values, &slopes), warm.step(temperature, values.heat()))
    }
}

impl Values {
    /// Power, W, and its slope by the temperature, W/K.
    fn heat(&self) -> [f64; 2] {
        [self.value[5], self.by_temperature[5]]
    }

    /// Over a small change of the temperature, K.
    fn carried(&self, off: f64) -> Outputs {
        std::array::from_fn(|row| self.value[row] + off * self.by_temperature[row])
    }
}

/// Outputs with the inlet's force, moment and power.
fn traction(outputs: &Outputs, [force, moment, power]: [f64; 3], wear: f64) -> PatchTraction {
    PatchTraction {
        force_rolling: outputs[0] + force,
        force_lateral: outputs[1],
        moment_normal: outputs[2],
        moment_lateral: outputs[3] + moment,
        moment_rolling: outputs[4],
        power: outputs[5] + power,
        wear_integral: wear,
    }
}

/// Change of a number of the state with each input.
fn chain(by: &[f64; state::INPUTS], squared: &[f64; 5], load: f64) -> [f64; INPUTS] {
    let [of_load, of_speed, of_sliding] = *by;
    std::array::from_fn(|input| match input {
        5 => of_load / load,
        6 => of_speed,
        motion => of_sliding * squared[motion],
    })
}

fn assemble(
    law: &FilmLaw,
    (contact, state): (&MovingPatch, &State),
    (values, slopes): (&Values, &Slopes),
    off: f64,
) -> PatchDerivative {
    let radius = contact.patch.ball_radius;
    let load = contact.load();
    let [along, across] = contact.motion.centre_slip(radius);
    // Of the square of the sliding velocity in the middle by the motion.
    let squared = [2.0 * along, 2.0 * across, 0.0, 2.0 * radius * along, -2.0 * radius * across];
    let by_state: [[f64; INPUTS]; OUTPUTS] =
        std::array::from_fn(|row| chain(&slopes.by_state.each_ref().map(|by| by[row]), &squared, load));
    let heating = chain(&state.heating.by, &squared, load);
    let cooling = 1.0 - state.heating.value * values.by_temperature[5];
    let outputs = values.carried(off);
    let resistance = chain(&state.resistance.by, &squared, load);
    let inlet = law.rolling_slopes(contact, state.resistance.value, &resistance);
    let columns: [Outputs; INPUTS] = std::array::from_fn(|input| {
        let mut change: Outputs = std::array::from_fn(|row| by_state[row][input]);
        if input < 5 {
            (0..5).for_each(|row| change[row] -= slopes.stiffness[place_of(row, input)]);
            change[5] += slopes.power_by_motion[input];
        }
        let warmer = (state.heating.value * change[5] + outputs[5] * heating[input]) / cooling;
        std::array::from_fn(|row| change[row] + warmer * values.by_temperature[row])
    });
    let with = |input: usize, wear| traction(&columns[input], inlet.by[input], wear);
    let by_motion = std::array::from_fn(|row| {
        std::array::from_fn(|input| {
            let [force, moment, _] = inlet.by[input];
            columns[input][row] + [force, 0.0, 0.0, moment, 0.0][row]
        })
    });
    PatchDerivative {
        traction: traction(&outputs, inlet.value, values.wear),
        by_motion,
        by_load: with(5, slopes.wear_by_load / load),
        by_rolling_speed: with(6, 0.0),
    }
}

/// Place of an entry in the lower half of a symmetric matrix.
fn place_of(row: usize, column: usize) -> usize {
    let (low, high) = if row < column { (row, column) } else { (column, row) };
    high * (high + 1) / 2 + low
}

#[cfg(test)]
mod tests;
