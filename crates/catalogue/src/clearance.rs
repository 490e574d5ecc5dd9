//! Radial internal clearance of deep-groove bearings.

/// Bore up to which a row holds, mm; least and largest clearance of group CN, µm. ISO 5753-1, as NSK, CAT. No. E1102,
/// table 9.9, prints it.
const NORMAL: [(f64, f64, f64); 12] = [
    (10.0, 2.0, 13.0),
    (18.0, 3.0, 18.0),
    (24.0, 5.0, 20.0),
    (30.0, 5.0, 20.0),
    (40.0, 6.0, 20.0),
    (50.0, 6.0, 23.0),
    (65.0, 8.0, 28.0),
    (80.0, 10.0, 30.0),
    (100.0, 12.0, 36.0),
    (120.0, 15.0, 41.0),
    (140.0, 18.0, 48.0),
    (160.0, 18.0, 53.0),
];

/// Least and largest radial internal clearance of group CN for a bore (m), m: that of the largest bore beyond 160 mm.
pub fn normal_clearance(bore: f64) -> [f64; 2] {
    let row = NORMAL.iter().find(|row| bore * 1e3 <= row.0 + 1e-6).unwrap_or(&NORMAL[NORMAL.len() - 1]);
    [row.1 * 1e-6, row.2 * 1e-6]
}
