//! Rings that are free to tilt, with what turns with them: rigid bodies of revolution.
//!
//! ```text
//! I_t dω/dt = M − I_p Ω ω × e    ω across the axis e, M the moment across it about the ring's centre
//! de/dt = ω × e                  e = (θ_y, −θ_x, sqrt(1 − θ_x² − θ_y²))
//! ```
//!
//! The drive keeps the speed Ω about e, so that ω stays across it; it may change in time.

use crate::equations::Frame;
use crate::forces::BodyForces;
use crate::machine::Machine;
use crate::tilting::tilt_rates;
use tribodyn_bearing::vectors::dot;
use tribodyn_bearing::{Races, RingState, Side};

/// Tilts of a ring (rad), and its angular velocity across its axis where rings are free to tilt, rad/s.
pub(crate) type Tilted = ([f64; 2], Option<[f64; 3]>);

impl Machine {
    /// How the rings stand at a state. Where one is free to tilt, the other one has an angular velocity too: of 0.
    pub fn tilts_at(&self, y: &[f64]) -> Races<Tilted> {
        let any = self.layout.any_tilts();
        let held = Races { inner: self.tilt, outer: [0.0; 2] };
        Races::from_fn(|side| self.tilt_at(side, y).unwrap_or((held[side], any.then_some([0.0; 3]))))
    }

    fn tilt_at(&self, side: Side, y: &[f64]) -> Option<Tilted> {
        let &[tilt_x, tilt_y, w_x, w_y] = y.get(self.layout.tilt(side))?.first_chunk::<4>()?;
        let axis = RingState { tilt: [tilt_x, tilt_y], ..RingState::centred(0.0) }.axis();
        let along = -(w_x * axis[0] + w_y * axis[1]) / axis[2];
        Some(([tilt_x, tilt_y], Some([w_x, w_y, along])))
    }

    /// Moment about x and y on a ring that is free to tilt by its own turning, −I_p Ω ω × e, N m.
    pub fn gyroscopic_moment(&self, side: Side, ring: &RingState) -> [f64; 2] {
        let (Some(tilting), Some([w_x, w_y, w_z])) = (&self.tilting[side], ring.turning) else { return [0.0; 2] };
        let ([e_x, e_y, e_z], spin) = (ring.axis(), tilting.body.polar_inertia * ring.speed);
        [-spin * (w_y * e_z - w_z * e_y), -spin * (w_z * e_x - w_x * e_z)]
    }

    /// Rates, powers and energy of a ring that is free to tilt, with the moment of balls and cage on it, N m.
    pub fn tilting_body(&self, side: Side, t: f64, (frame, by_others): (&Frame, [f64; 3]), f: &mut BodyForces) {
        let ring = &frame.rings[side];
        let (Some(tilting), Some(turning)) = (&self.tilting[side], ring.turning) else { return };
        let inertia = tilting.body.transverse_inertia;
        let outside = tilting.outside((t, frame.angles[side]), ring, turning);
        let moment = [0, 1, 2].map(|k| outside.moment[k] + by_others[k]);
        let axis = ring.axis();
        let along = dot(moment, axis);
        let gyroscopic = self.gyroscopic_moment(side, ring);
        let about = [0, 1].map(|k| (moment[k] - along * axis[k] + gyroscopic[k]) / inertia);
        let [x, y] = tilt_rates(ring, turning);
        f.tilt[side] = Some([x, y, about[0], about[1]]);
        f.torque[side] += outside.drive;
        f.load_power += outside.put_in;
        f.support_loss += outside.lost;
        f.energy += outside.energy + 0.5 * inertia * dot(turning, turning);
    }

    /// Moves the tilts of rings on over a time, s, by the rates in its middle.
    pub fn glide_tilts(&self, y: &mut [f64], h: f64) {
        for side in Side::BOTH {
            let at = self.layout.tilt(side).start;
            let rates = |y: &[f64]| {
                let (tilt, turning) = self.tilt_at(side, y)?;
                Some(tilt_rates(&RingState { tilt, ..RingState::centred(0.0) }, turning?))
            };
            let Some(first) = rates(y) else { continue };
            let start = [y[at], y[at + 1]];
            (0..2).for_each(|k| y[at + k] = start[k] + 0.5 * h * first[k]);
            let middle = rates(y).unwrap_or(first);
            (0..2).for_each(|k| y[at + k] = start[k] + h * middle[k]);
        }
    }

    /// Puts an inner ring that is free to tilt where it stands at the start.
    pub fn start_tilts(&self, state: &mut [f64]) {
        if self.tilting.inner.is_none() {
            return;
        }
        let at = self.layout.tilt(Side::Inner).start;
        state[at..at + 2].copy_from_slice(&self.tilt);
    }
}
