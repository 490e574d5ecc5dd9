//! Quality classes of deep groove ball bearings by the velocity of their vibration.
//!
//! Makers sort new bearings into classes V, V1 to V4, by the velocity on a tester (ISO 15242-1) in its three bands:
//! each has a limit by the bore. Sources: KYK, general catalogue, page 29, "Vibration of single bearing"; EMS,
//! catalogue of bearings, page XV, "Vibrations tolerances table". They agree in V to V3 for all bores that both have, 3
//! to 50 mm; V4 is that of KYK, EMS has up to 15 µm/s more for the larger bores of a row.

use crate::velocity::{BandVelocity, TESTER_BANDS_HZ};
use serde::Serialize;

/// Speed of the inner ring on a tester, Hz, and the farthest from it that counts as it, over it.
const TESTER_SPEED_HZ: f64 = 30.0;
const OFF_TESTER: f64 = 0.02;
/// Names of the classes, from the loudest.
const NAMES: [&str; 5] = ["V", "V1", "V2", "V3", "V4"];
/// Smallest and largest bore, mm, and the limits of one class after the other in the bands of testers, µm/s.
#[rustfmt::skip]
const ROWS: [([u16; 2], [u16; BANDS * NAMES.len()]); 10] = [
    ([3, 4], [80, 44, 44, 60, 35, 32, 48, 26, 22, 31, 16, 15, 28, 10, 10]),
    ([5, 6], [110, 72, 60, 74, 48, 40, 58, 36, 30, 35, 21, 18, 32, 11, 11]),
    ([7, 9], [130, 96, 80, 92, 66, 54, 72, 48, 40, 44, 28, 24, 38, 12, 12]),
    ([10, 12], [160, 120, 100, 120, 80, 70, 90, 60, 50, 55, 35, 30, 45, 14, 15]),
    ([15, 17], [210, 150, 120, 150, 100, 85, 110, 78, 60, 65, 46, 35, 52, 18, 18]),
    ([20, 28], [260, 190, 150, 180, 125, 100, 130, 100, 75, 80, 60, 45, 60, 25, 25]),
    ([30, 35], [300, 240, 190, 200, 150, 130, 150, 120, 100, 90, 75, 60, 70, 35, 40]),
    ([40, 45], [360, 300, 260, 240, 180, 160, 180, 150, 130, 110, 90, 80, 82, 50, 50]),
    ([50, 55], [420, 320, 320, 280, 200, 200, 210, 160, 160, 125, 100, 100, 95, 70, 70]),
    ([60, 60], [480, 360, 440, 320, 220, 240, 240, 180, 200, 145, 110, 130, 100, 80, 80]),
];
const BANDS: usize = TESTER_BANDS_HZ.len();

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

/// The class of a deep groove ball bearing by its bore (m), the speed of its inner ring (Hz) and its rms velocities.
/// None at other speeds than that of testers, 1800 r/min, without all of their bands, and for bores that the tables do
/// not have: from 3 to 60 mm.
pub fn vibration_class(bore_m: f64, speed_hz: f64, bands: &[BandVelocity]) -> Option<VibrationClass> {
    let is_of_testers = bands.iter().map(|band| [band.low_hz, band.high_hz]).eq(TESTER_BANDS_HZ);
    if !is_of_testers || (speed_hz / TESTER_SPEED_HZ - 1.0).abs() > OFF_TESTER {
        return None;
    }
    let bore_mm = (1e3 * bore_m).round();
    let [.., ([_, largest], _)] = ROWS;
    // Bores between two rows go with the smaller one, whose limits are tighter.
    let row = ROWS.iter().rfind(|([least, _], _)| bore_mm >= f64::from(*least) && bore_mm <= f64::from(largest));
    let (classes, _) = row?.1.as_chunks::<BANDS>();
    let in_m_s = |limits: &[u16; BANDS]| limits.map(|limit| 1e-6 * f64::from(limit));
    let keeps = |limits: &[u16; BANDS]| bands.iter().zip(in_m_s(limits)).all(|(band, limit)| band.rms_m_s <= limit);
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
        let name = |bore, rms| vibration_class(bore, 30.0, &bands(rms)).unwrap().name;
        assert_eq!(name(0.03, [67.0, 102.0, 30.0]), Some("V2"));
        assert_eq!(name(0.03, [67.0, 75.0, 30.0]), Some("V3"));
        assert_eq!(name(0.03, [69.0, 34.0, 39.0]), Some("V4"));
        assert_eq!(name(0.03, [10.0, 10.0, 191.0]), None);
        assert_eq!(name(0.008, [67.0, 45.0, 30.0]), Some("V2"));
        let beyond = vibration_class(0.03, 30.0, &bands([10.0, 10.0, 191.0])).unwrap();
        assert_eq!(beyond.limits_m_s.map(|limit| (1e6 * limit).round()), [300.0, 240.0, 190.0]);
    }

    #[test]
    fn limit_there_is_no_class_beyond_the_tables() {
        let quiet = bands([1.0; 3]);
        assert_eq!(vibration_class(0.002, 30.0, &quiet), None);
        assert_eq!(vibration_class(0.065, 30.0, &quiet), None);
        assert_eq!(vibration_class(0.03, 30.0, &quiet[..2]), None);
        assert_eq!(vibration_class(0.03, 50.0, &quiet), None);
    }

    /// Quieter classes have lower limits in every band, and larger bores higher ones.
    #[test]
    fn limit_limits_fall_with_the_class_and_grow_with_the_bore() {
        for (_, limits) in &ROWS {
            assert!((BANDS..limits.len()).all(|k| limits[k] < limits[k - BANDS]), "{limits:?}");
        }
        for [([_, largest], smaller), ([least, _], larger)] in ROWS.array_windows() {
            assert!(largest < least && smaller.iter().zip(larger).all(|(a, b)| a < b), "{least} mm");
        }
    }
}
