//! Time of one point of a patch, on the contacts that the patch rules are measured on.

use super::clock::least_per_call;
use super::row::{Limit, Row};
use crate::error::Failure;
use tribodyn_paper::files;
use tribodyn_paper::table::Table;
use tribodyn_traction::{
    Coating, CoatingLaw, FastPatch, Patch, PatchLaw, PatchRule, PressureChoice, RelativeMotion, SlipField, SlipUnit,
    TractionLaw, fast_patch_traction, patch_traction,
};

const GROUP: &str = "patch";
const CONTACTS: &str = "crates/traction/tests/patch_rules/contacts.csv";
/// Slip scale of the case, 1/(m/s).
const SLIP_SCALE: f64 = 100.0;
/// Ball radius and groove radius behind the contacts, m.
const BALL_RADIUS: f64 = 0.01508;
const GROOVE_RADIUS: f64 = 0.527 * 0.03016;

pub const RULES: [(&str, PatchRule); 4] = [
    ("10 × 40 midpoints", PatchRule::PolarMidpoint { radial: 10, circumferential: 40 }),
    ("Gauss–Jacobi 4 × 12", PatchRule::GaussJacobi { radial: 4, angles: 12 }),
    ("split strips 5 × 3", PatchRule::SplitStrip { across: 5, along: 3 }),
    ("split strips 8 × 3", PatchRule::SplitStrip { across: 8, along: 3 }),
];

/// A contact: ellipse, motion, rolling speed in m/s.
type Contact = (Patch, RelativeMotion, f64);

pub fn rows(quick: bool) -> Result<Vec<Row>, Failure> {
    let contacts = contacts()?;
    let law = CoatingLaw::varying(&Coating::library("ag")?, 2)?;
    let patch_law =
        PatchLaw { law: &law, slip_unit: SlipUnit::Scaled { per_m_s: SLIP_SCALE }, pressure: PressureChoice::Peak };
    let batches = if quick { 5 } else { 15 };
    let mut rows = Vec::new();
    for (name, rule) in RULES {
        let fast = FastPatch::new(rule)?;
        let points = points(&fast, &contacts);
        let per_point = |one: &dyn Fn(&Contact) -> f64| {
            let all = || contacts.iter().map(one).sum::<f64>();
            least_per_call(batches, 5e-3, all) * 1e9 / (points * contacts.len() as f64)
        };
        let generic =
            per_point(&|(p, m, speed)| patch_traction(p, m, *speed, &patch_law, fast.quadrature()).force_rolling);
        let quickly = per_point(&|(p, m, speed)| fast_patch_traction(&fast, p, m, *speed, &patch_law).force_rolling);
        let derivative = per_point(&|(p, m, speed)| {
            let curves = law.kragelskii(p.peak_pressure).zip(law.kragelskii_slope(p.peak_pressure));
            curves.map_or(f64::NAN, |(curve, slope)| {
                fast.derivative(p, m, *speed, (&curve, &slope), patch_law.slip_unit).by_motion[0][0]
            })
        });
        let note = format!("{points:.1} points a patch");
        rows.push(Row::new(GROUP, format!("{name}, generic"), generic, "ns/point").note(note));
        rows.push(Row::new(GROUP, format!("{name}, fast"), quickly, "ns/point").note(times(generic, quickly)));
        rows.push(Row::new(GROUP, format!("{name}, fast with derivatives"), derivative, "ns/point"));
        if matches!(rule, PatchRule::PolarMidpoint { .. }) {
            let ratio = Row::new(GROUP, format!("{name}, fast against generic"), generic / quickly, "times");
            rows.push(ratio.must_be(Limit::AtLeast(2.0)));
        }
    }
    Ok(rows)
}

fn times(before: f64, after: f64) -> String {
    format!("{:.1} times less than generic", before / after)
}

/// Mean number of points of a contact.
fn points(fast: &FastPatch, contacts: &[Contact]) -> f64 {
    let count = |(p, m, _): &Contact| fast.quadrature().point_count(&SlipField::new(p, m));
    contacts.iter().map(count).sum::<usize>() as f64 / contacts.len() as f64
}

/// Mean number of points of a rule.
pub fn mean_points(rule: PatchRule) -> Result<f64, Failure> {
    Ok(points(&FastPatch::new(rule)?, &contacts()?))
}

fn contacts() -> Result<Vec<Contact>, Failure> {
    let table = Table::read(CONTACTS, &files::read(&files::root().join(CONTACTS))?)?;
    let mut contacts = Vec::new();
    for row in table.rows() {
        if row.number("slip_scale_per_m_s")? != SLIP_SCALE {
            continue;
        }
        let patch = Patch {
            semi_lateral: row.number("semi_lateral_m")?,
            semi_rolling: row.number("semi_rolling_m")?,
            peak_pressure: row.number("peak_pressure_pa")?,
            ball_radius: BALL_RADIUS,
            surface_radius: 2.0 * BALL_RADIUS * GROOVE_RADIUS / (BALL_RADIUS + GROOVE_RADIUS),
        };
        let motion = RelativeMotion {
            rolling: row.number("rolling_m_s")?,
            lateral: row.number("lateral_m_s")?,
            spin: row.number("spin_rad_s")?,
            about_lateral: row.number("about_lateral_rad_s")?,
            about_rolling: row.number("about_rolling_rad_s")?,
        };
        contacts.push((patch, motion, row.number("rolling_speed_m_s")?));
    }
    Ok(contacts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_the_contacts_are_read_and_the_papers_rule_has_its_points() {
        assert_eq!(contacts().unwrap().len(), 6);
        assert_eq!(mean_points(RULES[0].1).unwrap(), 400.0);
    }
}
