//! The temperature of a film: that of its surroundings and what shear adds.

use super::{FilmLaw, FilmStress, STEEL, STEEL_DIFFUSIVITY, Shearing};
use crate::{MovingPatch, Quadrature, Scalar, SlipField};
use num_dual::Dual64;
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
    /// Rise of the mean temperature over the frictional power, K/W: within the film of a thickness (m), and of both
    /// surfaces as a band of heat passes over them (J. C. Jaeger, Proc. R. Soc. NSW 76 (1942) 203; slow contacts by
    /// their Péclet number).
    pub(super) fn heating<D: Scalar>(&self, contact: &MovingPatch<D>, gap: D) -> D {
        let b = contact.patch.semi_rolling;
        let passing = contact.speed() + b.recip() * STEEL_DIFFUSIVITY;
        let flash = (b / passing * (2.0 / (PI * STEEL))).sqrt() * (2.0 / 3.0);
        let within = gap * (1.0 / (8.0 * self.oil.thermal.conductivity));
        (within + flash) / (contact.patch.semi_lateral * b * PI)
    }

    /// A film at a temperature (K) other than that for which it is there.
    pub(super) fn warmed<D: Scalar>(&self, film: &Shearing, temperature: D) -> Shearing<D> {
        let stress = FilmStress::new(&self.oil, (self.shear, self.boundary_friction), temperature);
        let [gap, creep, share] = [film.gap, film.creep, film.share].map(D::from);
        Shearing { stress, gap, creep, share }
    }

    /// The temperature at which shear heats the film as much as it is warmer than its surroundings. Heat falls with
    /// temperature, so there is one, and Newton steps held between bounds find it.
    pub fn settled(&self, contact: &MovingPatch, quadrature: &Quadrature) -> FilmTemperature {
        let nodes = nodes(contact, quadrature);
        let at_rest = self.shearing(contact, self.temperature);
        let heating = self.heating(contact, at_rest.gap);
        let mut low = self.temperature;
        let mut high = f64::INFINITY;
        let mut temperature = low;
        let mut slope = 0.0;
        for round in 1..=ROUNDS {
            let film = self.warmed(&at_rest, Dual64::from(temperature).derivative());
            let of_node = |[pressure, squared, weight]: &[f64; 3]| {
                film.over_speed(Dual64::from(*pressure), Dual64::from(squared.sqrt())) * (weight * squared)
            };
            let power = nodes.iter().map(of_node).fold(Dual64::from(0.0), |sum, power| sum + power);
            slope = heating * power.eps;
            let off = self.temperature + heating * power.re - temperature;
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

/// Pressure, square of the sliding speed and area of every node.
fn nodes(contact: &MovingPatch, quadrature: &Quadrature) -> Vec<[f64; 3]> {
    let MovingPatch { patch, motion, .. } = contact;
    let (a, b) = (patch.semi_lateral, patch.semi_rolling);
    let mut found = Vec::with_capacity(256);
    quadrature.for_each(&SlipField::new(patch, motion), |x, y, weight: f64| {
        let inside = 1.0 - x * x - y * y;
        if inside > 0.0 {
            let depth = inside.sqrt();
            let [u, v] = motion.slip_at(b * x, a * y, patch);
            found.push([patch.peak_pressure * depth, u * u + v * v, a * b * weight / depth]);
        }
    });
    found
}
