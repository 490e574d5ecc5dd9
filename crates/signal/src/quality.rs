//! Quality classes of deep groove ball bearings by the velocity of their vibration.
//!
//! Makers sort new bearings into classes V, V1 to V4, by the velocity on a tester (ISO 15242-1) in its three bands:
//! each has a limit by the bore. Sources: KYK, general catalogue, page 29, "Vibration of single bearing"; EMS,
//! catalogue of bearings, page XV, "Vibrations tolerances table". They agree in V to V3 for all bores that both have, 3
//! to 50 mm; V4 is that of KYK, EMS has up to 15 µm/s more for the larger bores of a row.

use crate::velocity::{BandVelocity, TESTER_BANDS_HZ};
use serde::Serialize;

/// Speed of the inner ring on a tester, r/min.
pub const TESTER_SPEED_RPM: f64 = 1800.0;
/// Names of the classes, from the loudest.
const NAMES: [&str; 5] = ["V", "V1", "V2", "V3", "V4"];
/// Smallest and largest bore of a row, mm, and the limits of its classes in the bands of testers, µm/s.
type Row = ([f64; 2], [[f64; 3]; 5]);
#[rustfmt::skip]
const ROWS: [Row; 10] = [
    ([3.0, 4.0], [[80.0, 44.0, 44.0], [60.0, 35.0, 32.0], [48.0, 26.0, 22.0], [31.0, 16.0, 15.0], [28.0, 10.0, 10.0]]),
    ([5.0, 6.0], [[110.0, 72.0, 60.0], [74.0, 48.0, 40.0], [58.0, 36.0, 30.0], [35.0, 21.0, 18.0], [32.0, 11.0, 11.0]]),
    ([7.0, 9.0], [[130.0, 96.0, 80.0], [92.0, 66.0, 54.0], [72.0, 48.0, 40.0], [44.0, 28.0, 24.0], [38.0, 12.0, 12.0]]),
    ([10.0, 12.0], [[160.0, 120.0, 100.0], [120.0, 80.0, 70.0], [90.0, 60.0, 50.0], [55.0, 35.0, 30.0],
        [45.0, 14.0, 15.0]]),
    ([15.0, 17.0], [[210.0, 150.0, 120.0], [150.0, 100.0, 85.0], [110.0, 78.0, 60.0], [65.0, 46.0, 35.0],
        [52.0, 18.0, 18.0]]),
    ([20.0, 28.0], [[260.0, 190.0, 150.0], [180.0, 125.0, 100.0], [130.0, 100.0, 75.0], [80.0, 60.0, 45.0],
        [60.0, 25.0, 25.0]]),
    ([30.0, 35.0], [[300.0, 240.0, 190.0], [200.0, 150.0, 130.0], [150.0, 120.0, 100.0], [90.0, 75.0, 60.0],
        [70.0, 35.0, 40.0]]),
    ([40.0, 45.0], [[360.0, 300.0, 260.0], [240.0, 180.0, 160.0], [180.0, 150.0, 130.0], [110.0, 90.0, 80.0],
        [82.0, 50.0, 50.0]]),
    ([50.0, 55.0], [[420.0, 320.0, 320.0], [280.0, 200.0, 200.0], [210.0, 160.0, 160.0], [125.0, 100.0, 100.0],
        [95.0, 70.0, 70.0]]),
    ([60.0, 60.0], [[480.0, 360.0, 440.0], [320.0, 220.0, 240.0], [240.0, 180.0, 200.0], [145.0, 110.0, 130.0],
        [100.0, 80.0, 80.0]]),
];

/// The class of a bearing on a tester.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct VibrationClass {
    /// The quietest class that it keeps: V, V1, V2, V3 or V4; none where it is louder than V allows.
    pub name: Option<&'static str>,
    /// Limits of that class, or of V, in the three bands, m/s.
    pub limits_m_s: [f64; 3],
    /// Bore, m.
    pub bore_m: f64,
}

/// The class of a deep groove ball bearing by its bore (m) and its rms velocities on a tester at
/// [`TESTER_SPEED_RPM`]. None without all bands of testers, and for bores that the tables do not have: from 3 to 60 mm.
pub fn vibration_class(bore_m: f64, bands: &[BandVelocity]) -> Option<VibrationClass> {
    let is_of_testers = bands.iter().map(|band| [band.low_hz, band.high_hz]).eq(TESTER_BANDS_HZ);
    let bore_mm = 1e3 * bore_m;
    // Bores between two rows go with the smaller one, whose limits are tighter.
    let (_, classes) = ROWS.iter().rfind(|([least, _], _)| bore_mm > least - 0.5)?;
    if !is_of_testers || bore_mm > ROWS[ROWS.len() - 1].0[1] + 0.5 {
        return None;
    }
    let in_m_s = |limits: &[f64; 3]| limits.map(|limit| 1e-6 * limit);
    let keeps = |limits: &[f64; 3]| bands.iter().zip(in_m_s(limits)).all(|(band, limit)| band.rms_m_s <= limit);
    let kept = classes.iter().rposition(keeps);
    let limits_m_s = in_m_s(&classes[kept.unwrap_or(0)]);
    Some(VibrationClass { name: kept.map(|class| NAMES[class]), limits_m_s, bore_m })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bands(rms: [f64; 3]) -> Vec<BandVelocity> {
        let band = |(rms, [low_hz, high_hz]): (f64, [f64; 2])| BandVelocity {
            low_hz,
            high_hz,
            rms_m_s: 1e-6 * rms,
            peak_m_s: 4e-6 * rms,
        };
        rms.into_iter().zip(TESTER_BANDS_HZ).map(band).collect()
    }

    #[test]
    fn limit_the_loudest_band_decides_over_the_class() {
        let name = |bore, rms| vibration_class(bore, &bands(rms)).unwrap().name;
        assert_eq!(name(0.03, [67.0, 102.0, 30.0]), Some("V2"));
        assert_eq!(name(0.03, [67.0, 75.0, 30.0]), Some("V3"));
        assert_eq!(name(0.03, [69.0, 34.0, 39.0]), Some("V4"));
        assert_eq!(name(0.03, [10.0, 10.0, 191.0]), None);
        assert_eq!(name(0.008, [67.0, 45.0, 30.0]), Some("V2"));
        let beyond = vibration_class(0.03, &bands([10.0, 10.0, 191.0])).unwrap();
        assert_eq!(beyond.limits_m_s.map(|limit| (1e6 * limit).round()), [300.0, 240.0, 190.0]);
    }

    #[test]
    fn limit_there_is_no_class_beyond_the_tables() {
        assert_eq!(vibration_class(0.002, &bands([1.0; 3])), None);
        assert_eq!(vibration_class(0.065, &bands([1.0; 3])), None);
        assert_eq!(vibration_class(0.03, &bands([1.0; 3])[..2]), None);
    }

    /// Quieter classes have lower limits in every band, and larger bores higher ones.
    #[test]
    fn limit_limits_fall_with_the_class_and_grow_with_the_bore() {
        for (_, classes) in &ROWS {
            assert!(classes.windows(2).all(|pair| (0..3).all(|band| pair[1][band] < pair[0][band])), "{classes:?}");
        }
        for pair in ROWS.windows(2) {
            assert!(pair[0].0[1] < pair[1].0[0]);
            assert!((0..5).all(|class| (0..3).all(|band| pair[0].1[class][band] < pair[1].1[class][band])));
        }
    }
}
