//! Radial internal clearance of deep-groove bearings.

/// A group of radial internal clearance (ISO 5753-1).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ClearanceGroup {
    /// Smaller than normal.
    C2,
    /// Normal; designations do not say it.
    Normal,
    /// Larger than normal.
    C3,
    /// Larger than C3.
    C4,
    /// Larger than C4.
    C5,
}

/// Bore up to which a row holds, mm; least and largest clearance of the groups C2, CN, C3, C4 and C5, µm. ISO 5753-1,
/// as NSK, Rolling Bearings, CAT. No. E1102, table 9.9, prints it; the first row holds below 10 mm too.
const GROUPS: [(f64, [[u32; 2]; 5]); 15] = [
    (10.0, [[0, 7], [2, 13], [8, 23], [14, 29], [20, 37]]),
    (18.0, [[0, 9], [3, 18], [11, 25], [18, 33], [25, 45]]),
    (24.0, [[0, 10], [5, 20], [13, 28], [20, 36], [28, 48]]),
    (30.0, [[1, 11], [5, 20], [13, 28], [23, 41], [30, 53]]),
    (40.0, [[1, 11], [6, 20], [15, 33], [28, 46], [40, 64]]),
    (50.0, [[1, 11], [6, 23], [18, 36], [30, 51], [45, 73]]),
    (65.0, [[1, 15], [8, 28], [23, 43], [38, 61], [55, 90]]),
    (80.0, [[1, 15], [10, 30], [25, 51], [46, 71], [65, 105]]),
    (100.0, [[1, 18], [12, 36], [30, 58], [53, 84], [75, 120]]),
    (120.0, [[2, 20], [15, 41], [36, 66], [61, 97], [90, 140]]),
    (140.0, [[2, 23], [18, 48], [41, 81], [71, 114], [105, 160]]),
    (160.0, [[2, 23], [18, 53], [46, 91], [81, 130], [120, 180]]),
    (180.0, [[2, 25], [20, 61], [53, 102], [91, 147], [135, 200]]),
    (200.0, [[2, 30], [25, 71], [63, 117], [107, 163], [150, 230]]),
    (225.0, [[2, 35], [25, 85], [75, 140], [125, 195], [175, 265]]),
];

impl ClearanceGroup {
    /// The symbol, such as `C3`.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::C2 => "C2",
            Self::Normal => "CN",
            Self::C3 => "C3",
            Self::C4 => "C4",
            Self::C5 => "C5",
        }
    }

    /// Least and largest radial internal clearance for a bore (m), m: that of the largest bore of the table beyond it.
    pub fn of_bore(self, bore: f64) -> [f64; 2] {
        let row = GROUPS.iter().find(|row| bore * 1e3 <= row.0 + 1e-6).unwrap_or(&GROUPS[GROUPS.len() - 1]);
        row.1[self as usize].map(|um| f64::from(um) * 1e-6)
    }
}
