//! The variables of the FMU, in the order of their value references.

use tribodyn_bearing::{Bearing, GyroscopicFriction, RaceControl, Races, RingState, Side};

/// The part of a variable in its surroundings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Causality {
    /// Given at any time.
    Input,
    /// Follows from inputs and parameters.
    Output,
    /// Given before the simulation begins.
    Parameter,
}

/// Type of a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A number with a unit of [`UNITS`], or without one.
    Real(&'static str),
    /// A whole number.
    Integer,
    /// True or false.
    Boolean,
    /// One of several choices, counted from 1.
    Enumeration(&'static Choice),
}

/// An enumeration with the names of its items.
#[derive(Debug, PartialEq, Eq)]
pub struct Choice {
    /// Its name.
    pub name: &'static str,
    /// Items, the first of which is 1.
    pub items: &'static [&'static str],
}

/// One variable.
pub struct Variable {
    /// Its name; in capitals that of the enumerator in `model.h`.
    pub name: &'static str,
    pub description: &'static str,
    pub causality: Causality,
    pub kind: Kind,
    /// Its value at the start; 0 for an output, which has none.
    pub start: fn(&Bearing, Races<&RingState>) -> f64,
}

/// Units with their exponents of kg, m, s, rad.
pub const UNITS: [(&str, [i8; 4]); 9] = [
    ("m", [0, 1, 0, 0]),
    ("rad", [0, 0, 0, 1]),
    ("m/s", [0, 1, -1, 0]),
    ("rad/s", [0, 0, -1, 1]),
    ("N", [1, 1, -2, 0]),
    ("N.m", [1, 2, -2, 0]),
    ("Pa", [1, -1, -2, 0]),
    ("kg", [1, 0, 0, 0]),
    ("s", [0, 0, 1, 0]),
];

pub const CHOICES: [&Choice; 2] = [&RACE_CONTROL, &GYROSCOPIC_FRICTION];
const RACE_CONTROL: Choice = Choice { name: "RaceControl", items: &["Outer", "Inner", "Criterion"] };
const GYROSCOPIC_FRICTION: Choice =
    Choice { name: "GyroscopicFriction", items: &["Controlling", "Shared", "Absent", "ControllingAsPrinted"] };

const fn input(
    name: &'static str,
    unit: &'static str,
    description: &'static str,
    start: fn(&Bearing, Races<&RingState>) -> f64,
) -> Variable {
    Variable { name, description, causality: Causality::Input, kind: Kind::Real(unit), start }
}

const fn output(name: &'static str, unit: &'static str, description: &'static str) -> Variable {
    Variable { name, description, causality: Causality::Output, kind: Kind::Real(unit), start: |_, _| 0.0 }
}

const fn parameter(
    name: &'static str,
    kind: Kind,
    description: &'static str,
    start: fn(&Bearing, Races<&RingState>) -> f64,
) -> Variable {
    Variable { name, description, causality: Causality::Parameter, kind, start }
}

/// All variables. `fmi2.c` counts on displacements and tilts, their rates, and forces and moments each standing in the
/// order x, y, z, about x, about y.
pub const VARIABLES: [Variable; 40] = [
    input("displacement_x", "m", "Displacement of the inner ring along X", |_, r| r.inner.displacement[0]),
    input("displacement_y", "m", "Displacement of the inner ring along Y", |_, r| r.inner.displacement[1]),
    input("displacement_z", "m", "Displacement of the inner ring along the axis Z", |_, r| r.inner.displacement[2]),
    input("tilt_x", "rad", "Tilt of the inner ring about X", |_, r| r.inner.tilt[0]),
    input("tilt_y", "rad", "Tilt of the inner ring about Y", |_, r| r.inner.tilt[1]),
    input("velocity_x", "m/s", "Velocity along X, for damping", |_, r| r.inner.velocity[0]),
    input("velocity_y", "m/s", "Velocity along Y, for damping", |_, r| r.inner.velocity[1]),
    input("velocity_z", "m/s", "Velocity along Z, for damping", |_, r| r.inner.velocity[2]),
    input("tilt_rate_x", "rad/s", "Rate of the tilt about X, for damping", |_, _| 0.0),
    input("tilt_rate_y", "rad/s", "Rate of the tilt about Y, for damping", |_, _| 0.0),
    input("inner_speed", "rad/s", "Speed of the inner ring about Z", |_, r| r.inner.speed),
    input("outer_speed", "rad/s", "Speed of the outer ring about Z", |_, r| r.outer.speed),
    input("first_ball_azimuth", "rad", "Azimuth of the first ball, from X towards Y", |b, _| b.azimuth(0)),
    output("force_x", "N", "Force of the bearing on the inner ring along X"),
    output("force_y", "N", "Force of the bearing on the inner ring along Y"),
    output("force_z", "N", "Force of the bearing on the inner ring along Z"),
    output("moment_x", "N.m", "Moment of the bearing on the inner ring about X"),
    output("moment_y", "N.m", "Moment of the bearing on the inner ring about Y"),
    output("cage_speed", "rad/s", "Mean orbital speed of the balls"),
    output("load_inner", "N", "Largest load of a ball on the inner race"),
    output("load_outer", "N", "Largest load of a ball on the outer race"),
    output("pressure_inner", "Pa", "Largest contact pressure on the inner race"),
    output("pressure_outer", "Pa", "Largest contact pressure on the outer race"),
    parameter("ball_count", Kind::Integer, "Number of balls", |b, _| b.geometry.ball_count as f64),
    parameter("ball_diameter", Kind::Real("m"), "Diameter of the balls", |b, _| b.geometry.ball_diameter),
    parameter("pitch_diameter", Kind::Real("m"), "Pitch diameter", |b, _| b.geometry.pitch_diameter),
    parameter("ball_mass", Kind::Real("kg"), "Mass of a ball", |b, _| b.ball_mass),
    parameter("contact_angle", Kind::Real("rad"), "Free contact angle", |b, _| b.geometry.contact_angle()),
    parameter("interference", Kind::Real("m"), "Diametral interference of balls pressed without load", |b, _| {
        b.geometry.interference()
    }),
    parameter(
        "groove_coefficient_inner",
        Kind::Real(""),
        "Radius of the inner groove over the ball diameter",
        |b, _| b.geometry.inner_coefficient,
    ),
    parameter(
        "groove_coefficient_outer",
        Kind::Real(""),
        "Radius of the outer groove over the ball diameter",
        |b, _| b.geometry.outer_coefficient,
    ),
    parameter(
        "effective_modulus_inner",
        Kind::Real("Pa"),
        "2/((1-nu1^2)/E1 + (1-nu2^2)/E2) at the inner race",
        |b, _| modulus(b, Side::Inner),
    ),
    parameter(
        "effective_modulus_outer",
        Kind::Real("Pa"),
        "2/((1-nu1^2)/E1 + (1-nu2^2)/E2) at the outer race",
        |b, _| modulus(b, Side::Outer),
    ),
    parameter("worn_inner", Kind::Real("m"), "Wear all round the inner race", |b, _| b.worn.inner.depth),
    parameter("worn_outer", Kind::Real("m"), "Wear all round the outer race", |b, _| b.worn.outer.depth),
    parameter("race_control", Kind::Enumeration(&RACE_CONTROL), "The race that controls a ball", |b, _| {
        match b.modelling.race_control {
            Some(RaceControl::Inner) => 2.0,
            Some(RaceControl::Criterion) => 3.0,
            Some(RaceControl::Outer) | None => 1.0,
        }
    }),
    parameter(
        "gyroscopic_friction",
        Kind::Enumeration(&GYROSCOPIC_FRICTION),
        "The race whose friction holds the gyroscopic moment",
        |b, _| match b.modelling.gyroscopic_friction {
            Some(GyroscopicFriction::Shared) => 2.0,
            Some(GyroscopicFriction::Absent) => 3.0,
            Some(GyroscopicFriction::ControllingAsPrinted) => 4.0,
            Some(GyroscopicFriction::Controlling) | None => 1.0,
        },
    ),
    parameter("contact_at_actual_angle", Kind::Boolean, "Contact constants follow the actual contact angle", |b, _| {
        f64::from(u8::from(b.modelling.contact_at_actual_angle))
    }),
    parameter(
        "centrifugal_at_free_pitch",
        Kind::Boolean,
        "Centrifugal force at the undeformed pitch radius",
        |b, _| f64::from(u8::from(b.modelling.centrifugal_at_free_pitch == Some(true))),
    ),
    parameter("damping", Kind::Real("s"), "Damping over stiffness of the contacts", |_, _| 0.0),
];

fn modulus(bearing: &Bearing, side: Side) -> f64 {
    bearing.races[side].frozen::<f64>().effective_modulus
}
