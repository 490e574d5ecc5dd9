//! Film, heating and inlet of a contact with their slopes by load, rolling speed and sliding in its middle.

use crate::film::FilmLaw;
use crate::{MovingPatch, Patch, RelativeMotion};
use num_dual::DualSVec64;

/// Logarithm of the load, rolling speed V, square of the sliding velocity in the middle.
pub(super) const INPUTS: usize = 3;
type Dual = DualSVec64<INPUTS>;

/// A number of a contact with its slopes.
#[derive(Clone, Copy)]
pub(super) struct Sloping {
    pub value: f64,
    pub by: [f64; INPUTS],
}

/// Values that the nodes of a contact need besides their pressure and speed.
pub(super) struct State {
    /// Thickness that is sheared, m.
    pub gap: Sloping,
    /// Share of asperities.
    pub share: Sloping,
    /// Rise of the temperature over the power, K/W.
    pub heating: Sloping,
    /// Resistance of the inlet, N.
    pub resistance: Sloping,
}

impl Sloping {
    fn new(dual: &Dual) -> Self {
        let slopes = dual.eps.unwrap_generic(nalgebra::Const, nalgebra::U1);
        Self { value: dual.re, by: std::array::from_fn(|input| slopes[input]) }
    }
}

fn seed(value: f64, input: usize, slope: f64) -> Dual {
    let mut slopes = nalgebra::SVector::zeros();
    slopes[input] = slope;
    Dual::new(value, num_dual::Derivative::some(slopes))
}

impl State {
    pub fn new(law: &FilmLaw, contact: &MovingPatch) -> Self {
        let patch = &contact.patch;
        // All lengths and the pressure grow by a third of ln Q.
        let [semi_lateral, semi_rolling, peak_pressure] =
            [patch.semi_lateral, patch.semi_rolling, patch.peak_pressure].map(|size| seed(size, 0, size / 3.0));
        let [along, across] = contact.motion.centre_slip(patch.ball_radius);
        let sliding = along.hypot(across);
        // Its square is the input; at rest nothing changes with it.
        let rolling = if sliding > 1e-30 { seed(sliding, 2, 0.5 / sliding) } else { Dual::from(0.0) };
        let nothing = Dual::from(0.0);
        let contact = MovingPatch {
            patch: Patch {
                semi_lateral,
                semi_rolling,
                peak_pressure,
                ball_radius: patch.ball_radius,
                surface_radius: patch.surface_radius,
            },
            motion: RelativeMotion {
                rolling,
                lateral: nothing,
                spin: nothing,
                about_lateral: nothing,
                about_rolling: nothing,
            },
            rolling_speed: seed(contact.rolling_speed, 1, 1.0),
        };
        let state = law.state(&contact);
        let gap = law.gap(state.thickness.central);
        Self {
            gap: Sloping::new(&gap),
            share: Sloping::new(&state.asperity_share),
            heating: Sloping::new(&law.heating(&contact, gap)),
            resistance: Sloping::new(&law.rolling_resistance(&contact)),
        }
    }
}
