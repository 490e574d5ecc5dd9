//! Structures as rows of numbers, for lanes.

use crate::forces::Sums;
use tribodyn_bearing::{
    BallMotionResult, BallResult, ContactResult, FluidResult, FrictionResult, PocketLoad, PocketResult, Sliding,
    TransientContact,
};
use tribodyn_traction::{PatchTraction, RelativeMotion};

/// Numbers of a pocket's load, and of the sums over the balls.
pub(super) const IN_POCKET: usize = 12;
pub(super) const SUMS: usize = 29;
/// The first of these: all where rings do not tilt and the cage only turns.
pub(super) const HELD_SUMS: usize = 17;

/// A structure of `N` numbers.
pub(super) trait Numbers<const N: usize> {
    fn numbers(&self) -> [f64; N];

    /// Takes them over.
    fn take(&mut self, numbers: [f64; N]);
}

/// Both ways from one list of places.
macro_rules! numbers {
    ($of:ty, $count:literal; $($place:ident $(.$part:ident)* $([$i:literal])?),+) => {
        impl Numbers<$count> for $of {
            #[inline(always)]
            fn numbers(&self) -> [f64; $count] {
                [$(self.$place$(.$part)*$([$i])?),+]
            }

            #[inline(always)]
            fn take(&mut self, numbers: [f64; $count]) {
                let mut next = numbers.into_iter();
                $(self.$place$(.$part)*$([$i])? = next.next().unwrap_or_default();)+
            }
        }
    };
}

// What a ball's result has besides its parts.
numbers!(BallResult, 10;
    azimuth_rad, orbital_speed_rad_s, orbit_radius_m, radial_displacement_m, axial_displacement_m,
    angular_velocity_rad_s[0], angular_velocity_rad_s[1], angular_velocity_rad_s[2], centrifugal_force_n,
    gyroscopic_moment_nm);
numbers!(ContactResult, 8;
    angle_rad, approach_m, load_n, peak_pressure_pa, semi_axes_m[0], semi_axes_m[1], rolling_speed_m_s,
    spin_ratio_per_m);
numbers!(FrictionResult, 7;
    traction_n[0], traction_n[1], slide_to_roll[0], slide_to_roll[1], sliding_speed_m_s, power_loss_w,
    wear_rate_m3_s);
numbers!(TransientContact, 3; damping_n, bare, depth_m);
numbers!(FluidResult, 6;
    drag_n, churning_nm[0], churning_nm[1], churning_nm[2], churning_w, power_loss_w);
numbers!(BallMotionResult, 3;
    orbital_acceleration_rad_s2, velocity_m_s[0], velocity_m_s[1]);
numbers!(PocketLoad, 12;
    force, friction[0], friction[1], moment[0], moment[1], moment[2], cage_torque, energy, damping_power,
    friction_power, sliding, normal);
numbers!(Sums, 29;
    on_rings.inner[0], on_rings.inner[1], on_rings.inner[2], on_rings.outer[0], on_rings.outer[1], on_rings.outer[2],
    torque.inner, torque.outer, cage_torque, powers.friction.inner, powers.friction.outer, powers.drag,
    powers.churning, powers.contact_damping, powers.pocket_friction, powers.pocket_damping, powers.energy,
    moment.inner[0], moment.inner[1], moment.inner[2], moment.outer[0], moment.outer[1], moment.outer[2],
    on_cage.force[0], on_cage.force[1], on_cage.force[2], on_cage.moment[0], on_cage.moment[1], on_cage.moment[2]);

impl Sums {
    /// The first [`HELD_SUMS`].
    #[inline(always)]
    pub(super) fn of_held(&self) -> [f64; HELD_SUMS] {
        let all = self.numbers();
        std::array::from_fn(|i| all[i])
    }
}

/// How a ball slides on a race whose tilts are held, and its traction.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlidingContact {
    pub sliding: Sliding,
    pub traction: PatchTraction,
}

impl SlidingContact {
    /// Its numbers.
    pub const NUMBERS: usize = 16;

    pub const NONE: Self = Self {
        sliding: Sliding {
            normal: [0.0; 2],
            motion: RelativeMotion { rolling: 0.0, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 },
            rolling_speed: 0.0,
            sunk: 0.0,
            meridian: None,
        },
        traction: PatchTraction {
            force_rolling: 0.0,
            force_lateral: 0.0,
            moment_lateral: 0.0,
            moment_normal: 0.0,
            moment_rolling: 0.0,
            power: 0.0,
            wear_integral: 0.0,
        },
    };
}

numbers!(SlidingContact, 16;
    sliding.normal[0], sliding.normal[1], sliding.motion.rolling, sliding.motion.lateral, sliding.motion.spin,
    sliding.motion.about_lateral, sliding.motion.about_rolling, sliding.rolling_speed, sliding.sunk,
    traction.force_rolling, traction.force_lateral, traction.moment_lateral, traction.moment_normal,
    traction.moment_rolling, traction.power, traction.wear_integral);

impl Numbers<5> for PocketResult {
    #[inline(always)]
    fn numbers(&self) -> [f64; 5] {
        let [axial, radial] = self.friction_n.unwrap_or_default();
        [self.lead_rad, self.force_n, axial, radial, self.wear_rate_m3_s]
    }

    #[inline(always)]
    fn take(&mut self, [lead_rad, force_n, axial, radial, wear_rate_m3_s]: [f64; 5]) {
        *self = Self { lead_rad, force_n, friction_n: Some([axial, radial]), wear_rate_m3_s };
    }
}
