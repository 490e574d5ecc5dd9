//! Five nodes in steady state.

use nalgebra::{SMatrix, SVector};

/// Conductances between the nodes and to the surroundings, W/K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conductances {
    /// Inner ring and balls, through the contacts.
    pub inner_balls: f64,
    /// Outer ring and balls.
    pub outer_balls: f64,
    /// Oil or grease and the inner ring.
    pub oil_inner: f64,
    /// Oil or grease and the balls.
    pub oil_balls: f64,
    /// Oil or grease and the outer ring.
    pub oil_outer: f64,
    /// Outer ring and housing, through the joint.
    pub outer_housing: f64,
    /// Inner ring and surroundings, along the shaft.
    pub inner_surroundings: f64,
    /// Housing and surroundings.
    pub housing_surroundings: f64,
    /// Oil that flows through and its supply, which has the temperature of the surroundings: flow times heat capacity.
    pub oil_surroundings: f64,
}

/// Friction that heats each node, W.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Heat {
    /// Inner ring.
    pub inner: f64,
    /// Balls.
    pub balls: f64,
    /// Outer ring.
    pub outer: f64,
    /// Oil or grease.
    pub oil: f64,
}

/// Temperature of each node, K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Temperatures {
    /// Inner ring.
    pub inner: f64,
    /// Balls.
    pub balls: f64,
    /// Outer ring.
    pub outer: f64,
    /// Oil or grease.
    pub oil: f64,
    /// Housing.
    pub housing: f64,
}

/// Why there are no temperatures.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ThermalError {
    /// A conductance that none is.
    #[error("conductance {name} is {value} W/K: it must be finite and 0 or more")]
    Conductance {
        /// Which.
        name: &'static str,
        /// Its value, W/K.
        value: f64,
    },
    /// Heat that cannot leave.
    #[error("no conductance leads from every node to the surroundings: the heat cannot leave")]
    Closed,
}

impl Heat {
    /// All of it, W.
    pub fn total(&self) -> f64 {
        self.inner + self.balls + self.outer + self.oil
    }
}

impl Temperatures {
    /// All nodes at one temperature in K.
    pub fn even(temperature: f64) -> Self {
        Self { inner: temperature, balls: temperature, outer: temperature, oil: temperature, housing: temperature }
    }

    /// In the order inner ring, balls, outer ring, oil, housing.
    pub fn to_array(&self) -> [f64; 5] {
        [self.inner, self.balls, self.outer, self.oil, self.housing]
    }

    /// From that order.
    pub fn from_array([inner, balls, outer, oil, housing]: [f64; 5]) -> Self {
        Self { inner, balls, outer, oil, housing }
    }
}

impl Conductances {
    fn check(&self) -> Result<(), ThermalError> {
        for (name, value) in [
            ("inner_balls", self.inner_balls),
            ("outer_balls", self.outer_balls),
            ("oil_inner", self.oil_inner),
            ("oil_balls", self.oil_balls),
            ("oil_outer", self.oil_outer),
            ("outer_housing", self.outer_housing),
            ("inner_surroundings", self.inner_surroundings),
            ("housing_surroundings", self.housing_surroundings),
            ("oil_surroundings", self.oil_surroundings),
        ] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(ThermalError::Conductance { name, value });
            }
        }
        Ok(())
    }

    /// Temperatures at which all friction leaves to the surroundings at a temperature in K.
    ///
    /// # Errors
    /// [`ThermalError`] for conductances that are none, or that keep the heat of a node.
    pub fn steady(&self, heat: &Heat, surroundings: f64) -> Result<Temperatures, ThermalError> {
        self.check()?;
        let mut balance = SMatrix::<f64, 5, 5>::zeros();
        for (i, j, conductance) in [
            (0, 1, self.inner_balls),
            (2, 1, self.outer_balls),
            (3, 0, self.oil_inner),
            (3, 1, self.oil_balls),
            (3, 2, self.oil_outer),
            (2, 4, self.outer_housing),
        ] {
            balance[(i, i)] += conductance;
            balance[(j, j)] += conductance;
            balance[(i, j)] -= conductance;
            balance[(j, i)] -= conductance;
        }
        balance[(0, 0)] += self.inner_surroundings;
        balance[(3, 3)] += self.oil_surroundings;
        balance[(4, 4)] += self.housing_surroundings;
        let sources = SVector::<f64, 5>::from([heat.inner, heat.balls, heat.outer, heat.oil, 0.0]);
        // Rises over the surroundings: positive definite where heat can leave from everywhere.
        let factors = balance.cholesky().ok_or(ThermalError::Closed)?;
        let mut rise = factors.solve(&sources);
        // Once more for the last digits.
        rise += factors.solve(&(sources - balance * rise));
        let rise: [f64; 5] = rise.into();
        if rise.iter().any(|rise| !rise.is_finite()) {
            return Err(ThermalError::Closed);
        }
        Ok(Temperatures::from_array(rise.map(|rise| surroundings + rise)))
    }

    /// Heat that leaves to the surroundings at a temperature in K, W.
    pub fn to_surroundings(&self, at: &Temperatures, surroundings: f64) -> f64 {
        self.inner_surroundings * (at.inner - surroundings)
            + self.oil_surroundings * (at.oil - surroundings)
            + self.housing_surroundings * (at.housing - surroundings)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const USUAL: Conductances = Conductances {
        inner_balls: 1.5,
        outer_balls: 1.2,
        oil_inner: 0.1,
        oil_balls: 0.2,
        oil_outer: 0.1,
        outer_housing: 5.0,
        inner_surroundings: 0.5,
        housing_surroundings: 1.0,
        oil_surroundings: 0.3,
    };
    const HEAT: Heat = Heat { inner: 4.0, balls: 7.0, outer: 3.0, oil: 2.0 };

    #[test]
    fn identity_all_friction_arrives_at_the_surroundings() {
        let found = USUAL.steady(&HEAT, 293.15).unwrap();
        let left = USUAL.to_surroundings(&found, 293.15);
        assert!((left - HEAT.total()).abs() < 1e-11 * HEAT.total(), "{left}");
        assert!(found.balls > found.outer && found.outer > found.housing && found.housing > 293.15);
    }

    /// One way out and nothing else: a chain of resistances.
    #[test]
    fn limit_a_chain_of_resistances() {
        let chain = Conductances {
            inner_balls: 2.0,
            outer_balls: 4.0,
            oil_inner: 0.0,
            oil_balls: 1.0,
            oil_outer: 0.0,
            outer_housing: 8.0,
            inner_surroundings: 0.0,
            housing_surroundings: 0.5,
            oil_surroundings: 0.0,
        };
        let heat = Heat { inner: 1.0, ..Heat::default() };
        let found = chain.steady(&heat, 300.0).unwrap();
        let expected = [2.0 + 0.125 + 0.25 + 0.5, 2.0 + 0.125 + 0.25, 2.0 + 0.125, 2.0 + 0.125 + 0.25, 2.0];
        for (found, expected) in found.to_array().iter().zip(expected) {
            assert!((found - 300.0 - expected).abs() < 1e-12, "{found} {expected}");
        }
        assert_eq!(chain.steady(&Heat::default(), 300.0).unwrap(), Temperatures::even(300.0));
    }

    #[test]
    fn limit_heat_that_cannot_leave_is_refused() {
        let closed =
            Conductances { inner_surroundings: 0.0, housing_surroundings: 0.0, oil_surroundings: 0.0, ..USUAL };
        assert_eq!(closed.steady(&HEAT, 293.15), Err(ThermalError::Closed));
        let negative = Conductances { oil_inner: -1.0, ..USUAL };
        assert!(negative.steady(&HEAT, 293.15).unwrap_err().to_string().contains("oil_inner is -1 W/K"));
    }
}
