//! Tables of ISO 286-1: standard tolerances and fundamental deviations up to 500 mm, µm.

/// Ends of the ranges of nominal size, mm.
pub(super) const SIZES: [f64; 13] = [3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0];

/// Finer ranges, which class r has, mm.
pub(super) const FINE_SIZES: [f64; 22] = [
    3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 65.0, 80.0, 100.0, 120.0, 140.0, 160.0, 180.0, 200.0, 225.0, 250.0, 280.0, 315.0,
    355.0, 400.0, 450.0, 500.0,
];

/// Number of the range that a size (mm) falls into: above one end, up to the next.
pub(super) fn range(sizes: &[f64], millimetres: f64) -> Option<usize> {
    (millimetres > 0.0).then(|| sizes.iter().position(|end| millimetres <= end * (1.0 + 1e-12)))?
}

/// Grades of [`STANDARD`].
pub(super) const GRADES: std::ops::RangeInclusive<u8> = 3..=10;

/// Standard tolerances of the grades 3 to 10 by range of size (ISO 286-1, table 1).
const STANDARD: [[f64; 13]; 8] = [
    [2.0, 2.5, 2.5, 3.0, 4.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 13.0, 15.0],
    [3.0, 4.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0],
    [4.0, 5.0, 6.0, 8.0, 9.0, 11.0, 13.0, 15.0, 18.0, 20.0, 23.0, 25.0, 27.0],
    [6.0, 8.0, 9.0, 11.0, 13.0, 16.0, 19.0, 22.0, 25.0, 29.0, 32.0, 36.0, 40.0],
    [10.0, 12.0, 15.0, 18.0, 21.0, 25.0, 30.0, 35.0, 40.0, 46.0, 52.0, 57.0, 63.0],
    [14.0, 18.0, 22.0, 27.0, 33.0, 39.0, 46.0, 54.0, 63.0, 72.0, 81.0, 89.0, 97.0],
    [25.0, 30.0, 36.0, 43.0, 52.0, 62.0, 74.0, 87.0, 100.0, 115.0, 130.0, 140.0, 155.0],
    [40.0, 48.0, 58.0, 70.0, 84.0, 100.0, 120.0, 140.0, 160.0, 185.0, 210.0, 230.0, 250.0],
];

/// Standard tolerance of a grade in a range of size, µm.
pub(super) fn standard(grade: u8, range: usize) -> f64 {
    STANDARD[usize::from(grade - GRADES.start())][range]
}

/// Upper deviations of shafts f and g, below 0.
pub(super) const F: [f64; 13] = [6.0, 10.0, 13.0, 16.0, 20.0, 25.0, 30.0, 36.0, 43.0, 50.0, 56.0, 62.0, 68.0];
pub(super) const G: [f64; 13] = [2.0, 4.0, 5.0, 6.0, 7.0, 9.0, 10.0, 12.0, 14.0, 15.0, 17.0, 18.0, 20.0];

/// Lower deviations of shafts j, below 0: of the grades 5 and 6, and of 7.
pub(super) const J_5_6: [f64; 13] = [2.0, 2.0, 2.0, 3.0, 4.0, 5.0, 7.0, 9.0, 11.0, 13.0, 16.0, 18.0, 20.0];
pub(super) const J_7: [f64; 13] = [4.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 15.0, 18.0, 21.0, 26.0, 28.0, 32.0];

/// Upper deviations of holes J of the grades 6, 7 and 8.
pub(super) const J_HOLE: [[f64; 13]; 3] = [
    [2.0, 5.0, 5.0, 6.0, 8.0, 10.0, 13.0, 16.0, 18.0, 22.0, 25.0, 29.0, 33.0],
    [4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 18.0, 22.0, 26.0, 30.0, 36.0, 39.0, 43.0],
    [6.0, 10.0, 12.0, 15.0, 20.0, 24.0, 28.0, 34.0, 41.0, 47.0, 55.0, 60.0, 66.0],
];

/// Lower deviations of shafts k of the grades 4 to 7, m, n and p.
pub(super) const K: [f64; 13] = [0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0, 5.0];
pub(super) const M: [f64; 13] = [2.0, 4.0, 6.0, 7.0, 8.0, 9.0, 11.0, 13.0, 15.0, 17.0, 20.0, 21.0, 23.0];
pub(super) const N: [f64; 13] = [4.0, 8.0, 10.0, 12.0, 15.0, 17.0, 20.0, 23.0, 27.0, 31.0, 34.0, 37.0, 40.0];
pub(super) const P: [f64; 13] = [6.0, 12.0, 15.0, 18.0, 22.0, 26.0, 32.0, 37.0, 43.0, 50.0, 56.0, 62.0, 68.0];

/// Lower deviations of shafts r, over the finer ranges.
pub(super) const R: [f64; 22] = [
    10.0, 15.0, 19.0, 23.0, 28.0, 34.0, 41.0, 43.0, 51.0, 54.0, 63.0, 65.0, 68.0, 77.0, 80.0, 84.0, 94.0, 98.0, 108.0,
    114.0, 126.0, 132.0,
];
