//! The rows of a ball and of its contacts.

use super::unit::*;
use super::{Course, Over, Quantity, Scope};
use crate::place;
use crate::result::{BallResult, ContactResult};

type B = Quantity<BallResult>;
type C = Quantity<ContactResult>;

fn friction(ball: &mut BallResult) -> &mut [f64; 2] {
    ball.pocket.get_or_insert_default().friction_n.get_or_insert_default()
}

/// Quantities of a ball.
pub static BALL: [Quantity<BallResult>; 24] = [
    B::new(["azimuth", "Azimuth", "Azimuth from X towards Y"], [DEGREE, DEGREE], place!(.azimuth_rad)),
    B::new(
        ["orbital_speed", "Orbital speed", "Orbital speed ω_m"],
        [RADIAN_PER_SECOND, RPM],
        place!(.orbital_speed_rad_s),
    )
    .over(&[Over::Min, Over::Max])
    .reported(2),
    B::new(
        ["orbit_radius", "Orbit radius", "Radius of the orbit of the ball centre about the bearing axis"],
        [METRE, MILLIMETRE],
        place!(.orbit_radius_m),
    ),
    B::new(
        ["radial_displacement", "Radial displacement", "Orbit radius less half the pitch diameter"],
        [METRE, MICROMETRE],
        place!(.radial_displacement_m),
    ),
    B::new(
        ["axial_displacement", "Axial displacement", "Axial position of the ball centre against the unloaded one"],
        [METRE, MICROMETRE],
        place!(.axial_displacement_m),
    ),
    B::new(
        [
            "angular_velocity_axial",
            "Angular velocity, axial",
            "Angular velocity relative to the orbiting frame, axial component",
        ],
        [RADIAN_PER_SECOND, RADIAN_PER_SECOND],
        place!(.angular_velocity_rad_s[0]),
    ),
    B::new(
        [
            "angular_velocity_radial",
            "Angular velocity, radial",
            "Angular velocity relative to the orbiting frame, radial component",
        ],
        [RADIAN_PER_SECOND, RADIAN_PER_SECOND],
        place!(.angular_velocity_rad_s[1]),
    ),
    B::new(
        [
            "angular_velocity_tangential",
            "Angular velocity, tangential",
            "Angular velocity relative to the orbiting frame, tangential component",
        ],
        [RADIAN_PER_SECOND, RADIAN_PER_SECOND],
        place!(.angular_velocity_rad_s[2]),
    ),
    B::new(
        ["centrifugal_force", "Centrifugal force", "Centrifugal force of the orbit, m r ω_m²"],
        [NEWTON, NEWTON],
        place!(.centrifugal_force_n),
    )
    .along(Course::Positive),
    B::new(
        ["gyroscopic_moment", "Gyroscopic moment", "Magnitude of the gyroscopic moment"],
        [NEWTON_METRE, NEWTON_MILLIMETRE],
        place!(.gyroscopic_moment_nm),
    )
    .along(Course::Positive),
    B::new(["drag", "Drag", "Fluid drag, positive against the orbit"], [NEWTON, NEWTON], place!(fluid ? drag_n))
        .in_scope(Scope::Traction),
    B::new(
        ["churning_axial", "Churning moment, axial", "Moment of the fluid on the ball, axial component"],
        [NEWTON_METRE, NEWTON_MILLIMETRE],
        place!(fluid ? churning_nm[0]),
    )
    .in_scope(Scope::Traction),
    B::new(
        ["churning_radial", "Churning moment, radial", "Moment of the fluid on the ball, radial component"],
        [NEWTON_METRE, NEWTON_MILLIMETRE],
        place!(fluid ? churning_nm[1]),
    )
    .in_scope(Scope::Traction),
    B::new(
        ["churning_tangential", "Churning moment, tangential", "Moment of the fluid on the ball, tangential component"],
        [NEWTON_METRE, NEWTON_MILLIMETRE],
        place!(fluid ? churning_nm[2]),
    )
    .in_scope(Scope::Traction),
    B::new(
        ["churning", "Churning power", "Power that churning takes from the absolute angular velocity"],
        [WATT, WATT],
        place!(fluid ? churning_w),
    )
    .in_scope(Scope::Traction)
    .along(Course::Positive),
    B::new(
        ["power_loss_fluid", "Power loss", "Power lost to drag, by the speed against the fluid, and churning"],
        [WATT, WATT],
        place!(fluid ? power_loss_w),
    )
    .in_scope(Scope::Traction)
    .along(Course::Positive)
    .over(&[Over::Sum]),
    B::new(
        [
            "pocket_lead",
            "Lead over the pocket",
            "Lead of the ball over the middle of its cage pocket; negative where it lags",
        ],
        [RADIAN, MILLIRADIAN],
        place!(pocket ? lead_rad),
    ),
    B::new(
        [
            "pocket_force",
            "Pocket force on the ball",
            "Force of the cage pocket on the ball along the orbit; negative where it retards the ball",
        ],
        [NEWTON, NEWTON],
        place!(pocket ? force_n),
    )
    .along(Course::Threshold)
    .signed()
    .over(&[Over::Largest]),
    B::new(
        ["wear_rate_cage", "Wear rate", "Archard wear rate of the cage pocket"],
        [CUBIC_METRE_PER_SECOND, CUBIC_MICROMETRE_PER_SECOND],
        place!(pocket ? wear_rate_m3_s),
    )
    .along(Course::Threshold)
    .over(&[Over::Sum]),
    B::new(
        ["pocket_friction_axial", "Pocket friction, axial", "Friction of the cage pocket on the ball, axial component"],
        [NEWTON, NEWTON],
        (|b| b.pocket?.friction_n.map(|f| f[0]), |b, v| friction(b)[0] = v),
    )
    .in_scope(Scope::Run),
    B::new(
        [
            "pocket_friction_radial",
            "Pocket friction, radial",
            "Friction of the cage pocket on the ball, radial component",
        ],
        [NEWTON, NEWTON],
        (|b| b.pocket?.friction_n.map(|f| f[1]), |b, v| friction(b)[1] = v),
    )
    .in_scope(Scope::Run),
    B::new(
        ["orbital_acceleration", "Orbital acceleration", "Orbital acceleration"],
        [RADIAN_PER_SECOND_SQUARED, RADIAN_PER_SECOND_SQUARED],
        place!(motion ? orbital_acceleration_rad_s2),
    )
    .in_scope(Scope::Run),
    B::new(
        ["axial_velocity", "Axial velocity", "Axial velocity of the ball centre"],
        [METRE_PER_SECOND, MILLIMETRE_PER_SECOND],
        place!(motion ? velocity_m_s[0]),
    )
    .in_scope(Scope::Run),
    B::new(
        ["radial_velocity", "Radial velocity", "Radial velocity of the ball centre"],
        [METRE_PER_SECOND, MILLIMETRE_PER_SECOND],
        place!(motion ? velocity_m_s[1]),
    )
    .in_scope(Scope::Run),
];

/// Quantities of a ball–race contact.
pub static CONTACT: [Quantity<ContactResult>; 22] = [
    C::new(["contact_angle", "Contact angle", "Contact angle"], [DEGREE, DEGREE], place!(.angle_rad))
        .over(&[Over::Min, Over::Max])
        .reported(3),
    C::new(["load", "Contact load", "Contact load Q of the elastic approach"], [NEWTON, NEWTON], place!(.load_n))
        .along(Course::Positive)
        .over(&[Over::Min, Over::Max])
        .reported(1),
    C::new(
        ["approach", "Elastic approach", "Elastic approach of ball and race"],
        [METRE, MICROMETRE],
        place!(.approach_m),
    ),
    C::new(
        ["peak_pressure", "Peak pressure", "Highest pressure in the contact"],
        [PASCAL, GIGAPASCAL],
        place!(.peak_pressure_pa),
    )
    .along(Course::Positive)
    .over(&[Over::Max])
    .reported(3),
    C::new(
        ["semi_axis_across", "Semi-axis across the groove", "Semi-axis of the contact ellipse across the groove"],
        [METRE, MILLIMETRE],
        place!(.semi_axes_m[0]),
    )
    .along(Course::Positive),
    C::new(
        ["semi_axis_rolling", "Semi-axis along rolling", "Semi-axis of the contact ellipse along rolling"],
        [METRE, MILLIMETRE],
        place!(.semi_axes_m[1]),
    )
    .along(Course::Positive),
    C::new(
        ["traction", "Longitudinal traction on the ball", "Traction on the ball along the orbit"],
        [NEWTON, NEWTON],
        place!(friction ? traction_n[0]),
    )
    .in_scope(Scope::Traction)
    .signed(),
    C::new(
        ["lateral_traction", "Lateral traction on the ball", "Traction on the ball across the groove"],
        [NEWTON, NEWTON],
        place!(friction ? traction_n[1]),
    )
    .in_scope(Scope::Traction)
    .signed(),
    C::new(
        [
            "slide_to_roll",
            "Slide-to-roll ratio",
            "Longitudinal sliding over rolling speed, ξ_x; positive where the ball is the faster",
        ],
        [ONE, PERCENT],
        place!(friction ? slide_to_roll[0]),
    )
    .in_scope(Scope::Traction)
    .signed()
    .over(&[Over::Largest])
    .reported(4),
    C::new(
        ["lateral_slide_to_roll", "Lateral slide-to-roll ratio", "Lateral sliding over rolling speed, ξ_y"],
        [ONE, PERCENT],
        place!(friction ? slide_to_roll[1]),
    )
    .in_scope(Scope::Traction)
    .signed()
    .reported(4),
    C::new(
        ["spin_ratio", "Spin ratio", "Relative rotation about the contact normal over the rolling speed, φ"],
        [PER_METRE, PER_METRE],
        place!(.spin_ratio_per_m),
    )
    .over(&[Over::Largest]),
    C::new(
        ["rolling_speed", "Rolling speed", "Mean of the two surface speeds in the orbiting frame, V"],
        [METRE_PER_SECOND, METRE_PER_SECOND],
        place!(.rolling_speed_m_s),
    ),
    C::new(
        [
            "sliding_speed",
            "Sliding speed",
            "Sliding speed, the mean over the contact weighted by pressure: V of a PV value",
        ],
        [METRE_PER_SECOND, METRE_PER_SECOND],
        place!(friction ? sliding_speed_m_s),
    )
    .in_scope(Scope::Traction)
    .along(Course::Positive)
    .over(&[Over::Max])
    .reported(3),
    C::new(
        ["power_loss", "Power loss", "Frictional power of the contact"],
        [WATT, WATT],
        place!(friction ? power_loss_w),
    )
    .in_scope(Scope::Traction)
    .along(Course::Positive)
    .over(&[Over::Sum]),
    C::new(
        ["wear_rate", "Wear rate", "Archard wear rate of the race"],
        [CUBIC_METRE_PER_SECOND, CUBIC_MICROMETRE_PER_SECOND],
        place!(friction ? wear_rate_m3_s),
    )
    .in_scope(Scope::Traction)
    .along(Course::Positive)
    .over(&[Over::Sum]),
    C::new(
        ["film_central", "Central film thickness", "Central thickness of the lubricant film"],
        [METRE, MICROMETRE],
        place!(film ? central_m),
    )
    .in_scope(Scope::Lubricated)
    .along(Course::Positive)
    .over(&[Over::Min])
    .reported(3),
    C::new(
        ["film_minimum", "Least film thickness", "Least thickness of the lubricant film, in its constriction"],
        [METRE, MICROMETRE],
        place!(film ? minimum_m),
    )
    .in_scope(Scope::Lubricated)
    .along(Course::Positive)
    .over(&[Over::Min])
    .reported(3),
    C::new(
        [
            "lambda_ratio",
            "Film parameter λ",
            "Film parameter λ: least film thickness over the roughness of both bodies",
        ],
        [ONE, ONE],
        place!(film ? lambda_ratio),
    )
    .in_scope(Scope::Lubricated)
    .along(Course::Positive)
    .over(&[Over::Min])
    .reported(2),
    C::new(
        [
            "film_temperature_rise",
            "Film temperature rise",
            "Mean temperature of the film in the contact less that of its surroundings",
        ],
        [KELVIN, KELVIN],
        place!(film ? temperature_rise_k),
    )
    .in_scope(Scope::Lubricated)
    .over(&[Over::Max])
    .reported(1),
    C::new(
        ["damping", "Damping force", "Normal force on top of the load by the damping of the contact"],
        [NEWTON, NEWTON],
        place!(transient ? damping_n),
    )
    .in_scope(Scope::Run)
    .signed(),
    C::new(
        ["bare", "Bare part", "Part of the coating that is gone where the ball stands"],
        [ONE, PERCENT],
        place!(transient ? bare),
    )
    .in_scope(Scope::Run),
    C::new(
        ["depth", "Depth", "Depth of the groove where the ball stands, by defects and wear"],
        [METRE, MICROMETRE],
        place!(transient ? depth_m),
    )
    .in_scope(Scope::Run),
];
