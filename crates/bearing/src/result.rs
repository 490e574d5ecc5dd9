//! The result for one ball, the same from an equilibrium and from a moment of a run: SI, angles in radians. Vectors are
//! [axial, radial, tangential] in the ball's azimuth frame. What a model does not have is absent.

use crate::bearing::Bearing;
use crate::contact::{BallLoads, RaceContact};
use crate::geometry::{ContactPose, Geometry};
use crate::pocket::PocketLoad;
use crate::races::{Races, Side};
use crate::state::{BallSize, BallState};
use serde::{Deserialize, Serialize};
use tribodyn_contact::Ellipse;
use tribodyn_wear::LocalSurface;

/// One ball.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct BallResult {
    /// Azimuth from X towards Y, rad; a run counts it on from its start without wrapping.
    pub azimuth_rad: f64,
    /// Orbital speed ω_m, rad/s.
    pub orbital_speed_rad_s: f64,
    /// Radius of the orbit of the ball centre about the inertial axis, m.
    pub orbit_radius_m: f64,
    /// Orbit radius less half the pitch diameter, m.
    pub radial_displacement_m: f64,
    /// Axial position of the ball centre against the unloaded one, m.
    pub axial_displacement_m: f64,
    /// Angular velocity ω relative to the orbiting frame, rad/s.
    pub angular_velocity_rad_s: [f64; 3],
    /// Centrifugal force m r ω_m², N.
    pub centrifugal_force_n: f64,
    /// Magnitude of the gyroscopic moment J |ω_m e_a × Ω|, N m.
    pub gyroscopic_moment_nm: f64,
    /// Both contacts.
    pub contacts: Races<ContactResult>,
    /// Drag and churning; absent where the model has no fluid, as that of Jones and Harris.
    pub fluid: Option<FluidResult>,
    /// Contact with the cage pocket; absent without a cage.
    pub pocket: Option<PocketResult>,
    /// Motion besides orbit and rotation; absent in an equilibrium.
    pub motion: Option<BallMotionResult>,
}

impl BallResult {
    /// True if it carries load at both races.
    pub fn is_loaded(&self) -> bool {
        self.contacts.inner.load_n > 0.0 && self.contacts.outer.load_n > 0.0
    }
}

/// One ball–race contact.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactResult {
    /// Contact angle, rad.
    pub angle_rad: f64,
    /// Elastic approach, m; 0 or less where there is no contact.
    pub approach_m: f64,
    /// Contact load Q, N, of the elastic approach.
    pub load_n: f64,
    /// Highest pressure in the contact, Pa.
    pub peak_pressure_pa: f64,
    /// Semi-axes of the contact: across the groove, along rolling, m.
    pub semi_axes_m: [f64; 2],
    /// Rolling speed V, m/s.
    pub rolling_speed_m_s: f64,
    /// Spin ratio φ: relative rotation about the contact normal over the rolling speed, 1/m.
    pub spin_ratio_per_m: f64,
    /// Traction and what follows from it; absent in a model without traction.
    pub friction: Option<FrictionResult>,
    /// Film of the lubricant; absent where there is none, and where the ball has left the race or does not roll.
    pub film: Option<FilmResult>,
    /// Damping, wear and defects where the ball stands; absent in an equilibrium.
    pub transient: Option<TransientContact>,
}

/// The lubricant film of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct FilmResult {
    /// Central thickness, m.
    pub central_m: f64,
    /// Least thickness, m.
    pub minimum_m: f64,
    /// Film parameter λ: least thickness over roughness.
    pub lambda_ratio: f64,
    /// Mean temperature of the film in the contact less that of its surroundings, K.
    pub temperature_rise_k: f64,
}

/// Friction of one ball–race contact.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct FrictionResult {
    /// Traction on the ball: along the orbit, across the groove, N.
    pub traction_n: [f64; 2],
    /// Slide-to-roll ratios: longitudinal ξ_x, lateral ξ_y.
    pub slide_to_roll: [f64; 2],
    /// Sliding speed, the mean over the contact weighted by pressure, m/s: the speed of a PV value; 0 without load.
    pub sliding_speed_m_s: f64,
    /// Frictional power, W.
    pub power_loss_w: f64,
    /// Archard wear rate of the race, m³/s.
    pub wear_rate_m3_s: f64,
}

/// Numbers of a contact that only a run has.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct TransientContact {
    /// Normal force on top of the load by the damping of the contact, N.
    pub damping_n: f64,
    /// Part of the coating that is gone where the ball stands, 0 to 1.
    pub bare: f64,
    /// Depth of the groove where the ball stands, by defects and wear, m.
    pub depth_m: f64,
}

/// Forces of the fluid on one ball.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct FluidResult {
    /// Drag against the orbit, N.
    pub drag_n: f64,
    /// Churning moment, N m.
    pub churning_nm: [f64; 3],
    /// Power that churning takes from the absolute angular velocity, W.
    pub churning_w: f64,
    /// Power lost to drag, by the speed against the fluid, and churning, W.
    pub power_loss_w: f64,
}

/// One ball in its cage pocket.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PocketResult {
    /// Lead of the ball over the middle of its pocket, rad; negative where it lags.
    pub lead_rad: f64,
    /// Force of the pocket on the ball along the orbit, N; negative where it retards the ball.
    pub force_n: f64,
    /// Friction of the pocket on the ball (axial, radial), N; absent in an equilibrium.
    pub friction_n: Option<[f64; 2]>,
    /// Archard wear rate of the cage pocket, m³/s.
    pub wear_rate_m3_s: f64,
}

/// Motion that an equilibrium does not have.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct BallMotionResult {
    /// Orbital acceleration, rad/s².
    pub orbital_acceleration_rad_s2: f64,
    /// Axial and radial velocity of the ball centre, m/s.
    pub velocity_m_s: [f64; 2],
}

impl ContactResult {
    /// The friction; NaN in all its numbers where the model has none.
    pub fn friction_or_nan(&self) -> FrictionResult {
        self.friction.unwrap_or(FrictionResult {
            traction_n: [f64::NAN; 2],
            slide_to_roll: [f64::NAN; 2],
            sliding_speed_m_s: f64::NAN,
            power_loss_w: f64::NAN,
            wear_rate_m3_s: f64::NAN,
        })
    }
}

/// A ball between its races, as far as every model knows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallPlace {
    /// Azimuth, rad.
    pub azimuth: f64,
    /// Ball centre against the outer groove centre, axial, m.
    pub axial: f64,
    /// Radius of the orbit, m.
    pub orbit_radius: f64,
    /// Orbital speed ω_m, rad/s.
    pub orbital_speed: f64,
    /// Angular velocity ω relative to the orbiting frame, rad/s.
    pub angular_velocity: [f64; 3],
    /// Size of the ball.
    pub size: BallSize,
}

impl Bearing {
    /// The numbers of the bearing that results are written with.
    pub fn sheet(&self) -> Sheet {
        Sheet {
            geometry: self.geometry,
            ball_mass: self.ball_mass,
            ball_inertia: self.ball_inertia,
            swirl: self.fluid.as_ref().map_or(0.0, |f| f.swirl),
            wear: Races::from_fn(|side| self.wear_rate(side, 1.0)),
            pocket_wear: self.pocket_wear_rate(1.0),
            worn: self.worn.map(|worn| worn.depth),
        }
    }
}

/// All of a bearing that the results for its balls need, by value: a loop over many balls that has its own copy need
/// not fear that what it writes changes it.
#[derive(Debug, Clone, Copy)]
pub struct Sheet {
    geometry: Geometry,
    ball_mass: f64,
    ball_inertia: f64,
    /// Speed of the fluid over that of the inner ring.
    swirl: f64,
    /// Wear rate of a race, m³/s, over the wear integral of its patch, W.
    wear: Races<f64>,
    /// The same of a pocket, over force times sliding speed.
    pocket_wear: f64,
    /// Depth of the surfaces all round when the case begins, m.
    worn: Races<f64>,
}

impl Sheet {
    /// The result for a ball under traction at an azimuth, rad, given the speed of the inner ring, rad/s. Pocket,
    /// motion and the transient part of the contacts are left for the model that has them.
    #[inline(always)]
    pub fn ball(&self, azimuth: f64, ball: &BallState, loads: &BallLoads, inner_speed: f64) -> BallResult {
        let orbital_speed = ball.orbital_speed;
        let place = BallPlace {
            azimuth,
            axial: ball.position[0],
            orbit_radius: loads.orbit_radius,
            orbital_speed,
            angular_velocity: [
                ball.angular_velocity[0] - orbital_speed,
                ball.angular_velocity[1],
                ball.angular_velocity[2],
            ],
            size: ball.size,
        };
        let Races { inner, outer } = &loads.contacts;
        let contacts = Races { inner: self.race(Side::Inner, inner), outer: self.race(Side::Outer, outer) };
        let against_fluid = loads.orbit_radius * (orbital_speed - self.swirl * inner_speed);
        let (m, w) = (loads.churning, ball.angular_velocity);
        let churning_w = -m[0] * w[0] - m[1] * w[1] - m[2] * w[2];
        let fluid = FluidResult {
            drag_n: loads.drag,
            churning_nm: loads.churning,
            churning_w,
            power_loss_w: loads.drag * against_fluid + churning_w,
        };
        BallResult { fluid: Some(fluid), ..self.place(&place, contacts) }
    }

    /// The result for a ball of which only its place and its contacts are known.
    #[inline(always)]
    pub fn place(&self, place: &BallPlace, contacts: Races<ContactResult>) -> BallResult {
        let g = &self.geometry;
        let &BallPlace { azimuth, axial, orbit_radius, orbital_speed, angular_velocity, size } = place;
        BallResult {
            azimuth_rad: azimuth,
            orbital_speed_rad_s: orbital_speed,
            orbit_radius_m: orbit_radius,
            radial_displacement_m: orbit_radius - 0.5 * g.pitch_diameter,
            axial_displacement_m: axial - g.groove_offset(Side::Outer) * g.sin_contact_angle(),
            angular_velocity_rad_s: angular_velocity,
            centrifugal_force_n: self.ball_mass * size.mass * orbit_radius * (orbital_speed * orbital_speed),
            // The axial part of the angular velocity drops out.
            gyroscopic_moment_nm: (self.ball_inertia * size.inertia * orbital_speed).abs()
                * (angular_velocity[1] * angular_velocity[1] + angular_velocity[2] * angular_velocity[2]).sqrt(),
            contacts,
            fluid: None,
            pocket: None,
            motion: None,
        }
    }

    /// Place and pressure of a contact, with its rolling speed (m/s) and spin ratio (1/m), without friction.
    #[inline(always)]
    pub fn contact(
        pose: &ContactPose,
        (load, ellipse): (f64, &Ellipse),
        [rolling_speed, spin_ratio]: [f64; 2],
    ) -> ContactResult {
        ContactResult {
            angle_rad: pose.angle(),
            approach_m: pose.approach,
            load_n: load,
            peak_pressure_pa: ellipse.peak_pressure,
            semi_axes_m: [ellipse.semi_lateral(), ellipse.semi_rolling()],
            rolling_speed_m_s: rolling_speed.abs(),
            spin_ratio_per_m: spin_ratio,
            friction: None,
            film: None,
            transient: None,
        }
    }

    #[inline(always)]
    fn race(&self, side: Side, contact: &RaceContact) -> ContactResult {
        let normal = &contact.normal;
        let [along, across, spin_ratio] = contact.slide_to_roll(self.geometry.ball_radius());
        let t = &contact.traction;
        let friction = FrictionResult {
            traction_n: [t.force_rolling, t.force_lateral],
            slide_to_roll: [along, across],
            // ∬ p |Δv| dA / Q.
            sliding_speed_m_s: if normal.load > 0.0 { t.wear_integral / normal.load } else { 0.0 },
            power_loss_w: t.power,
            wear_rate_m3_s: self.wear[side] * t.wear_integral,
        };
        let rolling = [contact.rolling_speed, spin_ratio];
        let pressed = Self::contact(&normal.pose, (normal.load, &contact.ellipse), rolling);
        ContactResult { friction: Some(friction), ..pressed }
    }

    /// The numbers that a run adds to a contact on a surface whose depth counts from that of [`Bearing::worn`].
    #[inline(always)]
    pub fn transient_contact(&self, side: Side, contact: &RaceContact, surface: &LocalSurface) -> TransientContact {
        TransientContact {
            damping_n: contact.normal.force - contact.normal.load,
            bare: surface.bare,
            depth_m: surface.depth + self.worn[side],
        }
    }

    /// Wear rate of a pocket, m³/s.
    #[inline(always)]
    pub fn pocket_wear(&self, pocket: &PocketLoad) -> f64 {
        self.pocket_wear * pocket.sliding_power()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_bearing::spec;

    /// A steel ball of 30.16 mm weighs 7800 π/6 D³ = 112 g; at 83.79 mm and 607.6 rad/s that is 3466 N. Its moment of
    /// inertia is m D²/10 = 10.2 kg mm².
    #[test]
    fn limit_inertia_of_a_steel_ball() {
        let bearing = Bearing::new(spec()).unwrap();
        let (orbit_radius, orbital_speed) = (0.083_79, 607.6);
        let angular_velocity = [-3900.0, 900.0, 15.0];
        let place = BallPlace {
            azimuth: 0.1,
            axial: 0.0,
            orbit_radius,
            orbital_speed,
            angular_velocity,
            size: BallSize::NOMINAL,
        };
        let ball = bearing.sheet().place(&place, Races::default());
        assert!((ball.centrifugal_force_n - 3466.0).abs() < 5.0, "{}", ball.centrifugal_force_n);
        let moment = 0.1 * 0.11204 * 0.03016f64.powi(2) * 607.6 * 900f64.hypot(15.0);
        assert!((ball.gyroscopic_moment_nm / moment - 1.0).abs() < 1e-3, "{}", ball.gyroscopic_moment_nm);
        assert!((ball.radial_displacement_m - (orbit_radius - 0.5 * bearing.geometry.pitch_diameter)).abs() < 1e-15);
        assert_eq!((ball.fluid, ball.motion, ball.contacts.inner.friction), (None, None, None));
    }
}
