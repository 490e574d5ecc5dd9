//! Conductances of usual surroundings, from the size of a bearing.

use crate::Conductances;
use std::f64::consts::PI;

/// Boundary dimensions, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingSize {
    /// Bore d.
    pub bore: f64,
    /// Outside diameter D.
    pub outside: f64,
    /// Width B.
    pub width: f64,
}

/// Heat through the seats over their area and the rise of the temperature, W/(m² K): 16 kW/m² at 50 K, the reference of
/// ISO 15312 for radial bearings with seats of up to 0.05 m².
const SEATS: f64 = 16e3 / 50.0;
/// Largest area for which that holds, m², and the power by which it falls beyond (ISO 15312).
const SEATS_AREA: (f64, f64) = (0.05, -0.34);
/// Conductance over area of a joint of ground steel in a bored housing, W/(m² K); 1000 to 10 000.
const JOINT: f64 = 3000.0;
/// Heat transfer from surfaces of a bearing to its oil or grease, W/(m² K): some tens in grease and mist, hundreds in a
/// jet.
const OIL: f64 = 50.0;

impl Conductances {
    /// Those of usual surroundings for a bearing, given the conductances between balls and inner and outer ring, W/K.
    /// No oil flows through.
    ///
    /// Source: ISO 15312, reference conditions of the thermal speed rating.
    pub fn usual(size: &BearingSize, inner_balls: f64, outer_balls: f64) -> Self {
        let BearingSize { bore, outside, width } = *size;
        let [inner, outer] = [bore, outside].map(|diameter| PI * width * diameter);
        let (most, power) = SEATS_AREA;
        let density = SEATS * ((inner + outer) / most).max(1.0).powf(power);
        let (joint, seat) = (JOINT * outer, density * outer);
        // In series with the joint it is that of the seat.
        let housing_surroundings = seat * joint / (joint - seat);
        let within = OIL * 0.5 * (inner + outer);
        Self {
            inner_balls,
            outer_balls,
            oil_inner: within,
            oil_balls: within,
            oil_outer: within,
            outer_housing: joint,
            inner_surroundings: density * inner,
            housing_surroundings,
            oil_surroundings: 0.0,
        }
    }
}

/// Conductance between two bodies of one material that pass each other's contact: each point touches for 2b/V, and half
/// spaces exchange the mean heat flow ΔT sqrt(k ρ c/(π t)) over a time t, W/K.
///
/// Semi-axes across and along rolling (m), rolling speed (m/s), conductivity times density times specific heat
/// (J²/(m⁴ K² s)). Source: H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids, 1959, section 2.15.
pub fn passing_conductance([semi_lateral, semi_rolling]: [f64; 2], speed: f64, material: f64) -> f64 {
    if semi_rolling <= 0.0 || speed <= 0.0 {
        return 0.0;
    }
    let time = 2.0 * semi_rolling / speed;
    PI * semi_lateral * semi_rolling * (material / (PI * time)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Heat, Temperatures};

    /// ISO 15312: with 16 kW/m² the rings stand 50 K over the surroundings.
    #[test]
    fn paper_the_reference_heat_flow_makes_50_k() {
        for (bore, outside, width) in [(0.030, 0.062, 0.016), (0.2, 0.36, 0.058)] {
            let usual = Conductances::usual(&BearingSize { bore, outside, width }, 1e6, 1e6);
            let area = PI * width * (bore + outside);
            let density = 16e3 * f64::max(area / 0.05, 1.0).powf(-0.34);
            let heat = Heat { balls: density * area, ..Heat::default() };
            let Temperatures { inner, outer, .. } = usual.steady(&heat, 293.15).unwrap();
            assert!((inner - 343.15).abs() < 1e-2 && (outer - 343.15).abs() < 1e-2, "{inner} {outer}");
        }
    }

    #[test]
    fn limit_nothing_passes_at_rest() {
        assert_eq!(passing_conductance([1e-3, 1e-4], 0.0, 1.7e8), 0.0);
        let [slow, fast] = [1.0, 4.0].map(|speed| passing_conductance([1e-3, 1e-4], speed, 1.7e8));
        assert!((fast / slow - 2.0).abs() < 1e-12 && (0.1..1.0).contains(&fast), "{fast}");
    }
}
