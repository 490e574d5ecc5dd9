//! Balls and pitch diameters that are published.

/// The balls of a size as somebody has counted and measured them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PublishedBalls {
    /// Number of balls.
    pub ball_count: usize,
    /// Ball diameter, m.
    pub ball_diameter: f64,
    /// Pitch diameter, m.
    pub pitch_diameter: f64,
    /// Where they are published.
    pub source: &'static str,
}

const CWRU: &str = "bearing data centre of Case Western Reserve University, bearing information";

/// Designation, number of balls, ball diameter and pitch diameter in mm, source.
///
/// The data centre gives inches to three or four digits and the defect frequencies to five: 7.94 mm on 39.04 mm and
/// 17/64 in on 28.5 mm are the values within those digits that give the frequencies too. 6203 also: Lessmeier et al.,
/// PHM Society European Conference 3 (2016), 8 balls of 6.75 mm on 28.55 mm. 608 and 6206: the usual sets, which their
/// ratings confirm.
const SETS: [(&str, usize, f64, f64, &str); 4] = [
    ("608", 7, 3.96875, 15.0, "usual set of makers: 5/32 in, on the mean of bore and outside diameter"),
    ("6203", 8, 6.746875, 28.5, CWRU),
    ("6205", 9, 7.94, 39.04, CWRU),
    ("6206", 9, 9.525, 46.0, "usual set of makers: 3/8 in, on the mean of bore and outside diameter"),
];

/// The published balls of a size; none where none are known.
pub(super) fn published(designation: &str) -> Option<PublishedBalls> {
    let set = SETS.iter().find(|set| set.0 == designation)?;
    let &(_, ball_count, ball_mm, pitch_mm, source) = set;
    Some(PublishedBalls { ball_count, ball_diameter: ball_mm * 1e-3, pitch_diameter: pitch_mm * 1e-3, source })
}
