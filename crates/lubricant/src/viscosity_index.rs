//! The viscosity index of ASTM D2270, and the viscosity at 100 °C that it stands for.

use crate::{LubricantError, MM2_PER_M2};

/// Coefficients of L = a Y² + b Y + c and H = d Y² + e Y + f from the first column on, Y in mm²/s at 100 °C.
///
/// Source: ASTM D2270, appendix X2 (ISO 2909), table X2.1.
#[rustfmt::skip]
const RANGES: [[f64; 7]; 16] = [
    [2.0, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077],
    [3.8, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183],
    [4.4, 2.5, -7.2143, 13.812, 0.82143, 1.5679, 0.119],
    [5.0, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557],
    [6.4, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656],
    [7.0, 0.01191, 21.475, -72.870, 0.79762, -0.7321, 14.61],
    [7.7, 0.41858, 16.1558, -56.04, 0.05794, 10.5156, -28.24],
    [9.0, 0.88779, 7.5527, -16.6, 0.26665, 6.7015, -10.81],
    [12.0, 0.7672, 10.7972, -38.18, 0.20073, 8.4658, -22.49],
    [15.0, 0.97305, 5.3135, -2.2, 0.28889, 5.9741, -4.93],
    [18.0, 0.97256, 5.25, -0.98, 0.24504, 7.416, -16.73],
    [22.0, 0.91413, 7.4759, -21.82, 0.20323, 9.1267, -34.23],
    [28.0, 0.87031, 9.7157, -50.77, 0.18411, 10.1015, -46.75],
    [40.0, 0.84703, 12.6752, -133.31, 0.17029, 11.4866, -80.62],
    [55.0, 0.85921, 11.1009, -83.19, 0.1713, 11.368, -76.94],
    [70.0, 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947],
];
/// Least viscosity at 100 °C of the standard, mm²/s.
const LEAST: f64 = 2.0;
/// Viscosity indices that oils have.
const INDICES: [f64; 2] = [0.0, 400.0];

/// Viscosities at 40 °C of the reference oils of index 0 and 100, mm²/s.
fn references(at_100: f64) -> [f64; 2] {
    let row = RANGES.iter().rev().find(|row| row[0] <= at_100).unwrap_or(&RANGES[0]);
    let [_, a, b, c, d, e, f] = *row;
    [(a * at_100 + b) * at_100 + c, (d * at_100 + e) * at_100 + f]
}

/// Viscosity index of an oil from its kinematic viscosities at 40 and 100 °C, m²/s.
///
/// # Errors
/// [`LubricantError`] below 2 mm²/s at 100 °C, where the standard ends, and unless viscosity falls.
pub fn viscosity_index(at_40: f64, at_100: f64) -> Result<f64, LubricantError> {
    let (u, y) = (at_40 * MM2_PER_M2, at_100 * MM2_PER_M2);
    if !(LEAST..=1e4).contains(&y) {
        let quantity = "viscosity at 100 °C";
        return Err(LubricantError::Range { quantity, value: y, unit: "mm²/s", low: LEAST, high: 1e4 });
    }
    if u.is_nan() || u <= y {
        return Err(LubricantError::Rising { cold: u, cold_c: 40.0, hot: y, hot_c: 100.0 });
    }
    let [l, h] = references(y);
    if u >= h {
        return Ok(100.0 * (l - u) / (l - h));
    }
    let n = (h / u).log10() / y.log10();
    Ok((10f64.powf(n) - 1.0) / 0.00715 + 100.0)
}

/// Kinematic viscosity at 100 °C, m²/s, of an oil with a viscosity at 40 °C in m²/s and a viscosity index.
///
/// # Errors
/// [`LubricantError`] for an index that no oil has or a viscosity below the range of the standard.
pub fn viscosity_at_100(at_40: f64, index: f64) -> Result<f64, LubricantError> {
    let [low, high] = INDICES;
    if !(low..=high).contains(&index) {
        return Err(LubricantError::Range { quantity: "viscosity index", value: index, unit: "", low, high });
    }
    // The index rises with the viscosity at 100 °C.
    let (mut below, mut above) = (LEAST / MM2_PER_M2, at_40.min(1e4 / MM2_PER_M2) * (1.0 - 1e-12));
    let within = above > below && viscosity_index(at_40, below)? <= index;
    if !within {
        let quantity = "viscosity at 40 °C";
        return Err(LubricantError::Range {
            quantity,
            value: at_40 * MM2_PER_M2,
            unit: "mm²/s",
            low: if index > 0.0 { 4.0 } else { 8.0 },
            high: 1e4,
        });
    }
    for _ in 0..80 {
        let middle = 0.5 * (below + above);
        if viscosity_index(at_40, middle)? < index { below = middle } else { above = middle }
    }
    Ok(0.5 * (below + above))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both worked examples of ASTM D2270: 73.3 and 8.86 mm²/s have 92, 22.83 and 5.05 mm²/s 156.
    #[test]
    fn paper_examples_of_the_standard() {
        assert!((viscosity_index(73.3e-6, 8.86e-6).unwrap() - 92.0).abs() < 0.5);
        assert!((viscosity_index(22.83e-6, 5.05e-6).unwrap() - 156.0).abs() < 0.5);
    }

    /// The quadratics of neighbouring ranges meet to the digits that the table of the standard has.
    #[test]
    fn identity_ranges_meet() {
        for row in &RANGES[1..] {
            let (below, above) = (references(row[0] - 1e-9), references(row[0]));
            for (b, a) in below.iter().zip(above) {
                assert!((a / b - 1.0).abs() < 4e-3, "at {} mm²/s: {b} {a}", row[0]);
            }
        }
    }

    #[test]
    fn identity_an_index_gives_back_its_viscosity() {
        for (at_40, index) in [(10e-6, 95.0), (32e-6, 0.0), (46e-6, 95.0), (68e-6, 140.0), (460e-6, 97.0)] {
            let at_100 = viscosity_at_100(at_40, index).unwrap();
            // At a joint of two ranges the index has a small step.
            assert!((viscosity_index(at_40, at_100).unwrap() - index).abs() < 0.6, "{at_40} {index}");
        }
        let vg68 = viscosity_at_100(68e-6, 95.0).unwrap() * 1e6;
        assert!((8.4..8.8).contains(&vg68), "{vg68}");
    }

    #[test]
    fn limit_what_the_standard_does_not_know_is_refused() {
        assert!(viscosity_index(5e-6, 1.5e-6).is_err() && viscosity_index(8e-6, 9e-6).is_err());
        assert!(viscosity_at_100(68e-6, 900.0).unwrap_err().to_string().contains("0 to 400"));
        assert!(viscosity_at_100(68e-6, f64::NAN).is_err() && viscosity_at_100(3e-6, 95.0).is_err());
    }
}
