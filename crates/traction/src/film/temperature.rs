//! The temperature of a film: that of its surroundings and what shear adds.

use super::node::Sloped;
use super::{FilmContact, FilmLaw, STEEL, STEEL_DIFFUSIVITY};
use crate::{Quadrature, Scalar, SlipField};
use std::f64::consts::PI;

/// Temperature of a film in its patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmTemperature {
    /// Mean temperature, K.
    pub temperature: f64,
    /// Slope of the heating by the temperature, below 0: −4 stands for a film five times as stiff as its heat.
    pub(super) slope: f64,
    /// Rounds that it took.
    pub rounds: usize,
}

/// Newton steps before the last one is taken; 3 to 6 are usual.
const ROUNDS: usize = 40;
/// Step below which the temperature has settled, K.
const SETTLED: f64 = 1e-10;

impl FilmLaw {
    /// Rise of the mean temperature over the frictional power, K/W: within the film, and of both surfaces as a band of
    /// heat passes over them (J. C. Jaeger, Proc. R. Soc. NSW 76 (1942) 203; slow contacts by their Péclet number).
    pub(super) fn heating<D: Scalar>(&self, contact: &FilmContact<D>) -> D {
        let b = contact.patch.semi_rolling;
        let gap = self.gap(self.state(contact).thickness.central);
        let passing = contact.speed() + b.recip() * STEEL_DIFFUSIVITY;
        let flash = (b / passing * (2.0 / (PI * STEEL))).sqrt() * (2.0 / 3.0);
        let within = gap * (1.0 / (8.0 * self.oil.thermal.conductivity));
        (within + flash) / (contact.patch.semi_lateral * b * PI)
    }

    /// The temperature at which shear heats the film as much as it is warmer than its surroundings. Heat falls with
    /// temperature, so there is one, and Newton steps held between bounds find it.
    pub fn settled(&self, contact: &FilmContact, quadrature: &Quadrature) -> FilmTemperature {
        let heating = self.heating(contact);
        let nodes = nodes(contact, quadrature, |pressure| self.oil.pressure.relative_log(pressure.max(1.0)));
        let at_rest = self.shearing(contact, self.temperature);
        let mut low = self.temperature;
        let mut high = f64::INFINITY;
        let mut temperature = low;
        let mut slope = 0.0;
        for round in 1..=ROUNDS {
            let stress = super::FilmStress::new(&self.oil, (self.shear, self.boundary_friction), temperature);
            let film = Sloped::new(super::Shearing { stress, ..at_rest }, &self.oil, temperature);
            let [mut power, mut by_temperature] = [0.0; 2];
            for [pressure, relative_log, squared, weight] in &nodes {
                let [value, change] = film.by_temperature(*pressure, *relative_log, squared.sqrt());
                power += weight * squared * value;
                by_temperature += weight * squared * change;
            }
            slope = heating * by_temperature;
            let off = self.temperature + heating * power - temperature;
            if off > 0.0 {
                low = temperature;
            } else {
                high = temperature;
            }
            let step = off / (1.0 - slope);
            let next = temperature + step;
            let next = if next > high || next < low { 0.5 * (low + high) } else { next };
            if (next - temperature).abs() < SETTLED || !next.is_finite() {
                return FilmTemperature { temperature, slope, rounds: round };
            }
            temperature = next;
        }
        FilmTemperature { temperature, slope, rounds: ROUNDS }
    }
}

/// Pressure, relative log of the viscosity, square of the sliding speed and weight of every node.
fn nodes(contact: &FilmContact, quadrature: &Quadrature, relative_log: impl Fn(f64) -> f64) -> Vec<[f64; 4]> {
    let FilmContact { patch, motion, .. } = contact;
    let (a, b) = (patch.semi_lateral, patch.semi_rolling);
    let mut found = Vec::with_capacity(256);
    quadrature.for_each(&SlipField::new(patch, motion), |x, y, weight: f64| {
        let inside = 1.0 - x * x - y * y;
        if inside > 0.0 {
            let depth = inside.sqrt();
            let [u, v] = motion.slip_at(b * x, a * y, patch);
            let pressure = patch.peak_pressure * depth;
            found.push([pressure, relative_log(pressure), u * u + v * v, a * b * weight / depth]);
        }
    });
    found
}
