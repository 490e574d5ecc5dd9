//! Usual ranges of the values of a case: one table.

/// Usual range of a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UsualRange {
    /// Path of the value; `*` is any one step.
    pub path: &'static str,
    /// Least usual value, SI.
    pub least: f64,
    /// Largest usual value, SI.
    pub most: f64,
    /// Unit in which the range is shown, as case files write it, and its size in SI; empty where there is none.
    pub unit: (&'static str, f64),
    /// Where the range comes from.
    pub source: &'static str,
    /// True if the value may also be 0: a part that is not there.
    pub or_zero: bool,
}

const fn usual(
    path: &'static str,
    [least, most]: [f64; 2],
    unit: (&'static str, f64),
    source: &'static str,
) -> UsualRange {
    UsualRange { path, least: least * unit.1, most: most * unit.1, unit, source, or_zero: false }
}

const fn or_zero(range: UsualRange) -> UsualRange {
    UsualRange { or_zero: true, ..range }
}

const GPA: (&str, f64) = ("GPa", 1e9);
const MPA: (&str, f64) = ("MPa", 1e6);
const DENSITY: (&str, f64) = ("kg/m³", 1.0);
const MM: (&str, f64) = ("mm", 1e-3);
const UM: (&str, f64) = ("µm", 1e-6);
const N_PER_UM: (&str, f64) = ("N/µm", 1e6);
const NM_PER_MRAD: (&str, f64) = ("N m/mrad", 1e3);
const PLAIN: (&str, f64) = ("", 1.0);
const DEG: (&str, f64) = ("°", std::f64::consts::PI / 180.0);

const HANDBOOK: &str =
    "handbook values from aluminium bronze to tungsten carbide; bearing steel 200 to 212, silicon nitride 310";
const DENSITIES: &str = "handbook values from silicon nitride (3200) to tungsten carbide; bearing steel 7750 to 7850";
const HARRIS: &str = "Harris and Kotzalas, Rolling Bearing Analysis: usual grooves";
const ARCHARD: &str =
    "Archard coefficients from lubricated to severe metallic wear (Rabinowicz, Friction and Wear of Materials)";
const OWN: &str = "order of magnitude of the project's cases";

/// Usual ranges of values that stand alone. Values that count against another one (clearances over the ball diameter,
/// speed times pitch diameter) are in [`super::case_findings`].
pub const USUAL_RANGES: &[UsualRange] = &[
    usual("geometry.ball_diameter", [0.3, 120.0], MM, "ISO 3290: balls of rolling bearings"),
    usual("geometry.pitch_diameter", [2.0, 2500.0], MM, "ISO 15: boundary dimensions"),
    usual("geometry.inner_groove.Coefficient", [0.505, 0.56], PLAIN, HARRIS),
    usual("geometry.outer_groove.Coefficient", [0.505, 0.56], PLAIN, HARRIS),
    usual("geometry.fit.ContactAngle", [5.0, 45.0], DEG, "ISO 281: radial angular-contact bearings"),
    usual("materials.*.young", [100.0, 700.0], GPA, HANDBOOK),
    usual(
        "materials.*.poisson",
        [0.14, 0.36],
        PLAIN,
        "handbook values; bearing steel 0.28 to 0.3, silicon nitride 0.26",
    ),
    usual("materials.*.density", [3000.0, 16_000.0], DENSITY, DENSITIES),
    or_zero(usual(
        "coatings.*.thickness",
        [0.05, 100.0],
        UM,
        "solid films from sputtered MoS2 to electroplated silver",
    )),
    usual("traction.reference_pressure", [0.5, 5.0], GPA, "pressures of traction tests"),
    usual("traction.slip_unit.Scaled.per_m_s", [0.5, 1000.0], PLAIN, OWN),
    or_zero(usual("cage.pocket_gap", [0.003, 5.0], MM, "cage pockets of bearings of all sizes")),
    or_zero(usual(
        "cage.pocket_stiffness",
        [0.05, 500.0],
        N_PER_UM,
        "Hertz contacts of balls in PTFE to steel pockets",
    )),
    or_zero(usual("cage.pocket_friction", [0.002, 0.6], PLAIN, "lubricated to dry sliding")),
    or_zero(usual("cage.pocket_damping", [0.005, 20.0], ("s/m", 1.0), "impacts that lose 0.1 to 90 % of their speed")),
    or_zero(usual("wear.*.coefficient", [1e-10, 1e-2], PLAIN, ARCHARD)),
    usual(
        "wear.inner.hardness",
        [10.0, 30_000.0],
        MPA,
        "PTFE (some 30) to hard carbon films; silver 250, bearing steel 7000",
    ),
    usual(
        "wear.outer.hardness",
        [10.0, 30_000.0],
        MPA,
        "PTFE (some 30) to hard carbon films; silver 250, bearing steel 7000",
    ),
    usual("wear.cage.hardness", [10.0, 5000.0], MPA, "PTFE fabric (60) to steel cages"),
    usual("supports.*.mass", [1e-3, 1e4], ("kg", 1.0), OWN),
    or_zero(usual("supports.tilt.stiffness", [1e-4, 1e5], NM_PER_MRAD, OWN)),
    or_zero(usual("supports.outer_tilt.stiffness", [1e-4, 1e5], NM_PER_MRAD, OWN)),
    or_zero(usual("supports.*.stiffness", [0.1, 1e4], N_PER_UM, "soft mounts to solid housings")),
    or_zero(usual(
        "transient.contact_damping",
        [1e-4, 1.0],
        PLAIN,
        "fractions of critical damping of rolling contacts, dry to well oiled",
    )),
    usual("lubricant.roughness.*", [0.005, 0.6], UM, "R_q of honed races and of balls, new to well worn"),
    usual("lubricant.boundary_friction", [0.08, 0.2], PLAIN, "steel on steel in oil"),
    or_zero(usual("lubricant.hysteresis", [0.002, 0.02], PLAIN, "Johnson, Contact Mechanics, section 9.4")),
    usual("lubricant.starvation", [0.2, 1.0], PLAIN, "Lugt, Grease Lubrication in Rolling Bearings"),
    usual("rating.viscosity_ratio", [0.1, 10.0], PLAIN, "ISO 281: range of the formulas, 0.1 to 4"),
];

/// The usual range of the value at a path.
pub fn usual_range(path: &str) -> Option<&'static UsualRange> {
    USUAL_RANGES.iter().find(|range| matches(range.path, path))
}

fn matches(pattern: &str, path: &str) -> bool {
    let (mut steps, mut found) = (pattern.split('.'), path.split('.'));
    loop {
        match (steps.next(), found.next()) {
            (None, None) => return true,
            (Some(step), Some(name)) if step == "*" || step == name => {}
            _ => return false,
        }
    }
}

impl UsualRange {
    /// True for a value (SI) within the range.
    pub fn holds(&self, value: f64) -> bool {
        (self.or_zero && value == 0.0) || (self.least..=self.most).contains(&value)
    }
}
