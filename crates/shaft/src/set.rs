//! Bearings side by side on one seat, pressed against each other along the axis.
//!
//! ```text
//! F(z) = Σ s_k f_k(s_k z + o_k),   s_k = ±1 the side that bearing k carries, o_k its offset
//! ```
//! f_k is the axial force of one bearing. Preloaded by P, the set lifts one side off under the unloading force; with
//! equal bearings on both sides and f ~ z^1.5 that is 2^1.5 P.

use crate::error::ShaftError;
use crate::ring::{Held, RingForce};

/// One bearing of a set.
pub struct Member<'a> {
    /// True if it carries a shaft pushed along +z.
    pub carries_plus_z: bool,
    /// The bearing.
    pub ring: Box<dyn RingForce + 'a>,
}

/// Bearings pressed against each other.
pub struct AxialSet<'a> {
    /// The bearings.
    pub members: Vec<Member<'a>>,
    /// How far each is pressed in when the shaft has not moved, m, in the order of the bearings.
    pub offsets: Vec<f64>,
    /// Force (N) of a soft spring that takes the place of the bearings that carry −z; absent in a rigid set.
    pub spring: Option<f64>,
}

/// A set under an axial load.
#[derive(Debug, Clone, PartialEq)]
pub struct AxialState {
    /// Displacement of the shaft along z, m.
    pub displacement: f64,
    /// Axial force on each bearing's inner ring, N, 0 or more.
    pub forces: Vec<f64>,
    /// dF/dz, N/m.
    pub stiffness: f64,
}

/// Relative width of a root.
const WIDTH: f64 = 1e-13;
/// Halvings of the range of a root, and doublings to find one.
const HALVINGS: usize = 200;
/// First guess of a displacement, m.
const FIRST: f64 = 1e-6;
/// Farthest displacement that is looked at, m.
const FARTHEST: f64 = 5e-3;

/// Share of the preload that centrifugal force may keep on bearings that are said to lift off.
const KEPT: f64 = 0.01;

/// Axial force and stiffness of a ring at an axial displacement.
fn axial(ring: &mut (dyn RingForce + '_), z: f64, bearing: usize) -> Result<(f64, f64), ShaftError> {
    if z <= -ring.half_play() {
        return Ok((0.0, 0.0));
    }
    let Held { force, stiffness } =
        ring.at(&[0.0, 0.0, z, 0.0, 0.0]).map_err(|source| ShaftError::Bearing { bearing, source })?;
    Ok((force[2], stiffness[2][2]))
}

/// A root of a growing function, by regula falsi with halvings; `None` where it has none within the farthest one. Of a
/// stretch without any force, in which nothing touches, it is the near end.
fn root(mut f: impl FnMut(f64) -> Result<f64, ShaftError>) -> Result<Option<f64>, ShaftError> {
    let at_zero = f(0.0)?;
    if at_zero == 0.0 {
        return Ok(Some(0.0));
    }
    let sign = if at_zero < 0.0 { 1.0 } else { -1.0 };
    let (mut near, mut near_value, mut far) = (0.0, at_zero, sign * FIRST);
    let mut far_value = f(far)?;
    while far_value * sign < 0.0 {
        (near, near_value, far) = (far, far_value, 2.0 * far);
        if far.abs() > FARTHEST {
            return Ok(None);
        }
        far_value = f(far)?;
    }
    for step in 0..HALVINGS {
        if (far - near).abs() <= WIDTH * far.abs().max(FIRST) {
            break;
        }
        let secant = near - near_value * (far - near) / (far_value - near_value);
        let middle = 0.5 * (near + far);
        let at = if step % 3 == 2 || far_value == 0.0 || !secant.is_finite() { middle } else { secant };
        let value = f(at)?;
        if value * sign < 0.0 { (near, near_value) = (at, value) } else { (far, far_value) = (at, value) }
    }
    Ok(Some(far))
}

/// Displacement (m) at which a ring carries an axial force (N).
///
/// # Errors
/// [`ShaftError::TooLarge`] where it never does, and those of the bearing.
pub fn offset_for(ring: &mut (dyn RingForce + '_), force: f64) -> Result<f64, ShaftError> {
    root(|z| Ok(axial(ring, z, 0)?.0 - force))?.ok_or(ShaftError::TooLarge { force, farthest: FARTHEST })
}

const NO_RESISTANCE: ShaftError =
    ShaftError::Loose { direction: "along z", advice: "no bearing carries a load that way; turn one round" };

impl AxialSet<'_> {
    /// True if all bearings carry the same way: nothing presses them against each other.
    fn is_tandem(&self) -> bool {
        let side = self.members.first().map(|member| member.carries_plus_z);
        side.is_some_and(|side| self.members.iter().all(|member| member.carries_plus_z == side))
    }

    /// How far a bearing is pressed in at a displacement of the shaft, m.
    pub fn pressed(&self, index: usize, displacement: f64) -> f64 {
        self.side(index) * displacement + self.offsets[index]
    }

    /// The sign of a bearing's side.
    fn side(&self, index: usize) -> f64 {
        if self.members[index].carries_plus_z { 1.0 } else { -1.0 }
    }

    /// Axial force on the shaft's bearings at a displacement, and what each carries.
    fn at(&mut self, z: f64) -> Result<(f64, AxialState), ShaftError> {
        let mut state = AxialState { displacement: z, forces: Vec::new(), stiffness: 0.0 };
        let mut sum = 0.0;
        for index in 0..self.members.len() {
            let side = self.side(index);
            if let Some(spring) = self.spring.filter(|_| side < 0.0) {
                state.forces.push(spring);
                sum -= spring;
                continue;
            }
            let pressed = self.pressed(index, z);
            let (force, stiffness) = axial(self.members[index].ring.as_mut(), pressed, index)?;
            state.forces.push(force);
            sum += side * force;
            state.stiffness += stiffness;
        }
        Ok((sum, state))
    }

    /// The set under an axial load along +z, N.
    ///
    /// # Errors
    /// [`ShaftError::Loose`] where nothing carries the load, [`ShaftError::TooLarge`], and those of the bearings.
    pub fn under(&mut self, load: f64) -> Result<AxialState, ShaftError> {
        let carried = self.members.iter().any(|member| member.carries_plus_z == (load > 0.0));
        let refused = || if carried { ShaftError::TooLarge { force: load, farthest: FARTHEST } } else { NO_RESISTANCE };
        let z = root(|z| Ok(self.at(z)?.0 - load))?.ok_or_else(refused)?;
        Ok(self.at(z)?.1)
    }

    /// The set without load: one in tandem where the first of its bearings begins to carry.
    ///
    /// # Errors
    /// As [`Self::under`].
    pub fn unloaded(&mut self) -> Result<AxialState, ShaftError> {
        if !self.is_tandem() || self.spring.is_some() {
            return self.under(0.0);
        }
        let side = self.side(0);
        // Where nothing touches any force of the other sign makes a root of the edge.
        let z = root(|z| {
            let sum = self.at(z)?.0;
            Ok(if sum == 0.0 { -side } else { sum })
        })?;
        Ok(self.at(z.ok_or(NO_RESISTANCE)?)?.1)
    }

    /// Sets the offsets so that, unloaded, either side carries a preload (N) in all: bearings of one side share it by
    /// equal offsets, and the shaft does not move.
    ///
    /// # Errors
    /// As [`Self::under`].
    pub fn preload(&mut self, preload: f64) -> Result<(), ShaftError> {
        for plus in [true, false] {
            let of_side: Vec<usize> =
                (0..self.members.len()).filter(|&k| self.members[k].carries_plus_z == plus).collect();
            if of_side.is_empty() {
                continue;
            }
            let members = &mut self.members;
            let found = root(|offset| {
                let mut sum = -preload;
                for &k in &of_side {
                    sum += axial(members[k].ring.as_mut(), offset, k)?.0;
                }
                Ok(sum)
            })?;
            let offset = found.ok_or(ShaftError::TooLarge { force: preload, farthest: FARTHEST })?;
            of_side.into_iter().for_each(|k| self.offsets[k] = offset);
        }
        Ok(())
    }

    /// Preload of the unloaded set, N: the smaller of what its sides carry.
    ///
    /// # Errors
    /// As [`Self::under`].
    pub fn preload_force(&mut self) -> Result<f64, ShaftError> {
        let state = self.unloaded()?;
        let of = |plus: bool| {
            let members = self.members.iter().zip(&state.forces);
            members.filter(|(member, _)| member.carries_plus_z == plus).map(|(_, force)| force).sum::<f64>()
        };
        Ok(of(true).min(of(false)))
    }

    /// Loads along +z and along −z (N) under which the bearings of the other side lift off; absent where there are
    /// none, or where a spring or the centrifugal force of the balls keeps them loaded.
    ///
    /// # Errors
    /// Those of the bearings.
    pub fn unloading_forces(&mut self) -> Result<[Option<f64>; 2], ShaftError> {
        let mut found = [None; 2];
        let preload = self.preload_force()?;
        for (place, plus) in [(0, true), (1, false)] {
            let sign = if plus { 1.0 } else { -1.0 };
            // The side that lifts off, and how far the shaft moves until the last of it does.
            let lifted: Vec<usize> =
                (0..self.members.len()).filter(|&k| self.members[k].carries_plus_z != plus).collect();
            let farthest = lifted.iter().map(|&k| self.offsets[k]).fold(f64::NEG_INFINITY, f64::max);
            if farthest == f64::NEG_INFINITY || self.spring.is_some() {
                continue;
            }
            let (sum, state) = self.at(sign * farthest)?;
            let kept: f64 = lifted.iter().map(|&k| state.forces[k]).sum();
            found[place] = (kept <= KEPT * preload).then_some(sign * sum);
        }
        Ok(found)
    }
}
