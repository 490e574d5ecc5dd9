//! Units of case files: `mm(30.16)` becomes 0.03016 when the file is read, and everything after is SI.
//!
//! Each function reads one kind of quantity and is named in `#[serde(deserialize_with)]` of a schema field. Numbers may
//! be written without a decimal point; NaN and infinities are refused, also where a conversion overflows.

mod dimension;

pub use dimension::{in_si, unit_names};
pub(crate) use dimension::{is_unit, others};

use dimension::{
    ACCELERATION, ANGLE, DAMPING, DENSITY, Dimension, EXPANSION, FORCE, FREQUENCY, INERTIA, KINEMATIC_VISCOSITY,
    LENGTH, MASS, PRESSURE, PRESSURE_COEFFICIENT, SLOWNESS, SPEED, STIFFNESS, TEMPERATURE, TEMPERATURE_DIFFERENCE,
    TILT_DAMPING, TILT_STIFFNESS, TIME, TORQUE, UNBALANCE, VISCOSITY,
};
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, EnumAccess, Error, SeqAccess, VariantAccess, Visitor};
use std::cell::Cell;
use std::fmt;

macro_rules! readers {
    ($($(#[$doc:meta])* $function:ident: $dimension:ident;)+) => {
        $($(#[$doc])*
        pub(super) fn $function<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
            Quantity(&$dimension).deserialize(deserializer)
        })+
    };
}

readers! {
    /// Length, m.
    length: LENGTH;
    /// Angle, rad.
    angle: ANGLE;
    /// Pressure, Pa.
    pressure: PRESSURE;
    /// Density, kg/m³.
    density: DENSITY;
    /// Force, N.
    force: FORCE;
    /// Torque, N m.
    torque: TORQUE;
    /// Rotational speed, rad/s.
    speed: SPEED;
    /// Absolute temperature, K.
    temperature: TEMPERATURE;
    /// Dynamic viscosity, Pa s.
    viscosity: VISCOSITY;
    /// Stiffness, N/m.
    stiffness: STIFFNESS;
    /// Time, s.
    time: TIME;
    /// Mass, kg.
    mass: MASS;
    /// Moment of inertia, kg m².
    inertia: INERTIA;
    /// Rate, Hz.
    frequency: FREQUENCY;
    /// Time per length, s/m.
    slowness: SLOWNESS;
    /// Coefficient of thermal expansion, 1/K.
    expansion: EXPANSION;
    /// Temperature difference, K.
    temperature_difference: TEMPERATURE_DIFFERENCE;
    /// Tilting stiffness, N m/rad.
    tilt_stiffness: TILT_STIFFNESS;
    /// Unbalance, kg m.
    unbalance: UNBALANCE;
    /// Damping constant, N s/m.
    damping: DAMPING;
    /// Kinematic viscosity, m²/s.
    kinematic_viscosity: KINEMATIC_VISCOSITY;
    /// Pressure–viscosity coefficient, 1/Pa.
    pressure_coefficient: PRESSURE_COEFFICIENT;
}

macro_rules! optionals {
    ($($(#[$doc:meta])* $function:ident: $reader:ident;)+) => {
        $($(#[$doc])*
        pub(super) fn $function<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<f64>, D::Error> {
            struct Value(f64);
            impl<'de> Deserialize<'de> for Value {
                fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    $reader(deserializer).map(Value)
                }
            }
            Ok(Option::<Value>::deserialize(deserializer)?.map(|value| value.0))
        })+
    };
}

optionals! {
    /// A moment of inertia that may be left out, kg m².
    optional_inertia: inertia;
    /// An angle that may be left out, rad.
    optional_angle: angle;
    /// A force that may be left out, N.
    optional_force: force;
    /// A length that may be left out, m.
    optional_length: length;
    /// A mass that may be left out, kg.
    optional_mass: mass;
    /// A damping constant that may be left out, N s/m.
    optional_damping: damping;
    /// A rotational speed that may be left out, rad/s.
    optional_speed: speed;
    /// A density that may be left out, kg/m³.
    optional_density: density;
}

macro_rules! triples {
    ($($(#[$doc:meta])* $function:ident: $dimension:ident;)+) => {
        $($(#[$doc])*
        pub(super) fn $function<'de, D: Deserializer<'de>, const N: usize>(
            deserializer: D,
        ) -> Result<[f64; N], D::Error> {
            deserializer.deserialize_tuple(N, Components(&$dimension))
        })+
    };
}

triples! {
    /// One stiffness for each axis, N/m.
    stiffnesses: STIFFNESS;
    /// One damping constant for each axis, N s/m.
    dampings: DAMPING;
    /// One tilting stiffness for each axis, N m/rad.
    tilt_stiffnesses: TILT_STIFFNESS;
    /// One damping constant of tilts for each axis, N m s/rad.
    tilt_dampings: TILT_DAMPING;
    /// One angle for each axis, rad.
    angles: ANGLE;
    /// One length for each axis, m.
    lengths: LENGTH;
    /// One acceleration for each axis, m/s².
    accelerations: ACCELERATION;
}

/// A quantity for each of `N` axes.
struct Components<const N: usize>(&'static Dimension);

impl<'de, const N: usize> Visitor<'de> for Components<N> {
    type Value = [f64; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{N} values in parentheses, each such as {}", self.0.example)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut values: A) -> Result<Self::Value, A::Error> {
        let mut result = [0.0; N];
        for (i, slot) in result.iter_mut().enumerate() {
            *slot = values.next_element_seed(Quantity(self.0))?.ok_or_else(|| A::Error::invalid_length(i, &self))?;
        }
        Ok(result)
    }
}

macro_rules! tables {
    ($($(#[$doc:meta])* $function:ident: $dimension:ident;)+) => {
        $($(#[$doc])*
        pub(super) fn $function<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<(f64, f64)>, D::Error> {
            deserializer.deserialize_seq(Rows(&$dimension))
        })+
    };
}

tables! {
    /// Rows (time in s, force in N), written `(s(0), kN(20))`.
    force_table: FORCE;
    /// Rows (time in s, torque in N m).
    torque_table: TORQUE;
    /// Rows (time in s, rotational speed in rad/s).
    speed_table: SPEED;
}

/// A value of a dimension, as `unit(number)`.
#[derive(Clone, Copy)]
struct Quantity(&'static Dimension);

impl<'de> DeserializeSeed<'de> for Quantity {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f64, D::Error> {
        let dimension = self.0;
        let unit_known = Cell::new(false);
        let visitor = QuantityVisitor { dimension, unit_known: &unit_known };
        deserializer.deserialize_enum("", dimension.names, visitor).map_err(|error| {
            // What is wrong after a known unit is the number; the error of its reader tells more than we can.
            if unit_known.get() { error } else { D::Error::custom(dimension) }
        })
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { noun, example, names, .. } = self;
        write!(f, "expected {noun} with its unit, such as {example}; allowed units: {}", names.join(", "))
    }
}

struct QuantityVisitor<'a> {
    dimension: &'static Dimension,
    unit_known: &'a Cell<bool>,
}

impl<'de> Visitor<'de> for QuantityVisitor<'_> {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} with its unit", self.dimension.noun)
    }

    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<f64, A::Error> {
        let (to_si, content) = data.variant_seed(Unit(self.dimension))?;
        self.unit_known.set(true);
        let number: f64 = content.newtype_variant()?;
        let value = to_si(number);
        if value.is_finite() {
            Ok(value)
        } else if number.is_finite() {
            Err(A::Error::custom(format!("{number} in this unit is too large for a number in SI units")))
        } else {
            Err(A::Error::custom(format!("{number} is not allowed: the number must be finite")))
        }
    }
}

/// The unit's name, which gives its conversion.
struct Unit(&'static Dimension);

impl<'de> DeserializeSeed<'de> for Unit {
    type Value = fn(f64) -> f64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Unit {
    type Value = fn(f64) -> f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a unit of {}", self.0.noun)
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Self::Value, E> {
        let index = self.0.names.iter().position(|known| *known == name);
        index.map(|i| self.0.to_si[i]).ok_or_else(|| E::unknown_variant(name, self.0.names))
    }
}

/// A table: a list of rows (time, value).
struct Rows(&'static Dimension);

impl<'de> Visitor<'de> for Rows {
    type Value = Vec<(f64, f64)>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a list of rows such as (s(0), {})", self.0.example)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut rows: A) -> Result<Self::Value, A::Error> {
        let mut table = Vec::new();
        while let Some(row) = rows.next_element_seed(Row(self.0))? {
            table.push(row);
        }
        Ok(table)
    }
}

/// One row of a table.
struct Row(&'static Dimension);

impl<'de> DeserializeSeed<'de> for Row {
    type Value = (f64, f64);

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_tuple(2, self)
    }
}

impl<'de> Visitor<'de> for Row {
    type Value = (f64, f64);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a row of time and value such as (s(0), {})", self.0.example)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut row: A) -> Result<Self::Value, A::Error> {
        let time = row.next_element_seed(Quantity(&TIME))?.ok_or_else(|| A::Error::invalid_length(0, &self))?;
        let value = row.next_element_seed(Quantity(self.0))?.ok_or_else(|| A::Error::invalid_length(1, &self))?;
        Ok((time, value))
    }
}
