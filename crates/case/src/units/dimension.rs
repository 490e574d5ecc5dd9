//! Kinds of quantities with their units and how each becomes SI.

use std::f64::consts::PI;

/// A kind of quantity with the units in which it may be written.
pub(super) struct Dimension {
    /// With its article, for messages.
    pub noun: &'static str,
    /// How a value looks in a file.
    pub example: &'static str,
    /// Unit names.
    pub names: &'static [&'static str],
    /// Conversion to SI of the unit at the same index.
    pub to_si: &'static [fn(f64) -> f64],
}

/// `value` times 10 to the power `exponent`, by moving the decimal point: `mm(0.12)` is the double closest to 0.00012,
/// which neither 0.12/1000 nor 0.12 × 0.001 is.
fn shifted(value: f64, exponent: i32) -> f64 {
    // NaN and infinities have no decimal point; they stay what they are.
    format!("{value}e{exponent}").parse().unwrap_or(value)
}

/// Pound, kg, and standard gravity, m/s²: both exact by definition, as is the inch, m.
const POUND: f64 = 0.453_592_37;
const GRAVITY: f64 = 9.806_65;
const INCH: f64 = 0.0254;
/// Pound-force, N, and pound-force on a square inch, Pa.
const POUND_FORCE: f64 = POUND * GRAVITY;
const PSI: f64 = POUND_FORCE / (INCH * INCH);

/// Declares a dimension, each unit beside its conversion.
macro_rules! dimension {
    ($name:ident, $noun:literal, $example:literal, { $($unit:literal => $to_si:expr),+ $(,)? }) => {
        pub(super) const $name: Dimension =
            Dimension { noun: $noun, example: $example, names: &[$($unit),+], to_si: &[$($to_si),+] };
    };
}

dimension!(LENGTH, "a length", "mm(30.16)", {
    "m" => |v| v,
    "mm" => |v| shifted(v, -3),
    "um" => |v| shifted(v, -6),
    "inch" => |v| v * INCH,
    "in" => |v| v * INCH,
});
dimension!(ANGLE, "an angle", "deg(18)", {
    "rad" => |v| v,
    "deg" => f64::to_radians,
    "mrad" => |v| shifted(v, -3),
});
dimension!(PRESSURE, "a pressure", "GPa(2.5)", {
    "Pa" => |v| v,
    "kPa" => |v| shifted(v, 3),
    "MPa" => |v| shifted(v, 6),
    "GPa" => |v| shifted(v, 9),
    "psi" => |v| v * PSI,
    "ksi" => |v| 1e3 * v * PSI,
});
dimension!(DENSITY, "a density", "kg_per_m3(7800)", {
    "kg_per_m3" => |v| v,
    "g_per_cm3" => |v| shifted(v, 3),
    "lb_per_in3" => |v| v * POUND / (INCH * INCH * INCH),
});
dimension!(FORCE, "a force", "kN(20)", {
    "N" => |v| v,
    "kN" => |v| shifted(v, 3),
    "lbf" => |v| v * POUND_FORCE,
});
dimension!(TORQUE, "a torque", "Nm(1.5)", {
    "Nm" => |v| v,
    "Nmm" => |v| shifted(v, -3),
    "lbf_in" => |v| v * POUND_FORCE * INCH,
});
dimension!(SPEED, "a rotational speed", "rpm(14000)", {
    "rad_per_s" => |v| v,
    "rpm" => |v| v * PI / 30.0,
});
dimension!(TEMPERATURE, "a temperature", "K(87.5)", {
    "K" => |v| v,
    "degC" => |v| v + 273.15,
    "degF" => |v| (v + 459.67) / 1.8,
});
dimension!(VISCOSITY, "a dynamic viscosity", "uPa_s(119.7)", {
    "Pa_s" => |v| v,
    "mPa_s" => |v| shifted(v, -3),
    "uPa_s" => |v| shifted(v, -6),
});
dimension!(STIFFNESS, "a stiffness", "N_per_um(10)", {
    "N_per_m" => |v| v,
    "N_per_um" => |v| shifted(v, 6),
    "lbf_per_in" => |v| v * POUND_FORCE / INCH,
});
dimension!(TIME, "a time", "s(0.5)", {
    "s" => |v| v,
    "ms" => |v| shifted(v, -3),
    "us" => |v| shifted(v, -6),
});
dimension!(MASS, "a mass", "kg(2.5)", {
    "kg" => |v| v,
    "g" => |v| shifted(v, -3),
    "lb" => |v| v * POUND,
});
dimension!(INERTIA, "a moment of inertia", "kg_m2(0.004)", {
    "kg_m2" => |v| v,
    "kg_mm2" => |v| shifted(v, -6),
});
dimension!(DAMPING, "a damping constant", "N_s_per_m(500)", {
    "N_s_per_m" => |v| v,
});
dimension!(FREQUENCY, "a rate", "kHz(25.6)", {
    "Hz" => |v| v,
    "kHz" => |v| shifted(v, 3),
});
dimension!(ACCELERATION, "an acceleration", "m_per_s2(9.81)", {
    "m_per_s2" => |v| v,
});
dimension!(SLOWNESS, "a time per length", "s_per_m(0.5)", {
    "s_per_m" => |v| v,
});

dimension!(TILT_STIFFNESS, "a tilting stiffness", "Nm_per_mrad(20)", {
    "Nm_per_rad" => |v| v,
    "Nm_per_mrad" => |v| shifted(v, 3),
});
dimension!(TILT_DAMPING, "a damping constant of tilts", "Nm_s_per_rad(2)", {
    "Nm_s_per_rad" => |v| v,
});
dimension!(UNBALANCE, "an unbalance", "g_mm(50)", {
    "kg_m" => |v| v,
    "g_mm" => |v| shifted(v, -6),
});
dimension!(EXPANSION, "a coefficient of thermal expansion", "per_K(11.5e-6)", {
    "per_K" => |v| v,
});
dimension!(TEMPERATURE_DIFFERENCE, "a temperature difference", "K(40)", {
    "K" => |v| v,
});

dimension!(KINEMATIC_VISCOSITY, "a kinematic viscosity", "mm2_per_s(68)", {
    "m2_per_s" => |v| v,
    "mm2_per_s" => |v| shifted(v, -6),
    "cSt" => |v| shifted(v, -6),
});
dimension!(PRESSURE_COEFFICIENT, "a pressure-viscosity coefficient", "per_GPa(20)", {
    "per_Pa" => |v| v,
    "per_GPa" => |v| shifted(v, -9),
});

const ALL: [&Dimension; 24] = [
    &ACCELERATION,
    &TILT_STIFFNESS,
    &TILT_DAMPING,
    &UNBALANCE,
    &LENGTH,
    &ANGLE,
    &PRESSURE,
    &DENSITY,
    &FORCE,
    &TORQUE,
    &SPEED,
    &TEMPERATURE,
    &VISCOSITY,
    &STIFFNESS,
    &TIME,
    &MASS,
    &INERTIA,
    &DAMPING,
    &FREQUENCY,
    &SLOWNESS,
    &EXPANSION,
    &TEMPERATURE_DIFFERENCE,
    &KINEMATIC_VISCOSITY,
    &PRESSURE_COEFFICIENT,
];

/// Names of all units of case files, a list for each kind of quantity.
pub fn unit_names() -> Vec<&'static [&'static str]> {
    ALL.iter().map(|dimension| dimension.names).collect()
}

/// True if `name` is a unit of any dimension.
pub(crate) fn is_unit(name: &str) -> bool {
    ALL.iter().any(|dimension| dimension.names.contains(&name))
}

pub(super) fn dimension_of(unit: &str) -> Option<(&'static Dimension, usize)> {
    ALL.iter().find_map(|dimension| Some((*dimension, dimension.names.iter().position(|name| *name == unit)?)))
}

/// A number with a unit of case files in SI; `None` for a word that is no unit. `K` is a temperature, and a difference
/// of two: both are in kelvin.
pub fn in_si(unit: &str, number: f64) -> Option<f64> {
    dimension_of(unit).map(|(dimension, at)| dimension.to_si[at](number))
}

/// SI values that a number with a unit would have with each of the other units of the same dimension.
pub(crate) fn others(unit: &str, number: f64) -> Vec<(&'static str, f64)> {
    let all = dimension_of(unit).into_iter().flat_map(|(dimension, _)| dimension.names.iter().zip(dimension.to_si));
    all.filter(|(name, _)| **name != unit).map(|(name, to_si)| (*name, to_si(number))).collect()
}
