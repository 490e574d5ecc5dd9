//! Effects that a case leaves out where they may matter: thin rings, growth by rotation, contacts far from the angle at
//! which their constants are taken.

use super::Question;
use tribodyn_bearing::{Bearing, ContactPose, Side};
use tribodyn_case::Case;
use tribodyn_quasistatic::{Model, OperatingPoint, solve};

/// Wall behind a groove over the ball diameter below which a ring gives way: rings of catalogue bearings have 0.15 to
/// 0.3, and rings of less ovalise over single balls, which rigid ones do not.
const THIN_WALL: f64 = 0.1;
/// Growth over the distance of the groove centres that moves a contact angle by some degrees.
const GROWTH: f64 = 0.01;
/// Distance from the free contact angle at which frozen contact constants are worth a word, rad.
const FAR: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Change of a peak pressure that is worth a word, Pa: half a percent of 2.5 GPa, where traction tests begin.
const WORTH: f64 = 1.25e7;
/// Balls up to which `check` solves the case for its angles.
const FEW: usize = 100;

/// Sentences on thin walls and on growth by rotation.
pub(super) fn geometry_warnings(case: &Case, bearing: &Bearing) -> Vec<String> {
    let g = &bearing.geometry;
    let mut all = Vec::new();
    if let Some(mounting) = &case.mounting {
        let walls = [
            ("inner", g.groove_bottom_radius(Side::Inner) - 0.5 * mounting.inner.seat_diameter),
            ("outer", 0.5 * mounting.outer.seat_diameter - g.groove_bottom_radius(Side::Outer)),
        ];
        for (ring, wall) in walls.into_iter().filter(|(_, wall)| *wall < THIN_WALL * g.ball_diameter) {
            all.push(format!(
                "the wall of the {ring} ring behind its groove is {:.2} mm, less than a tenth of the ball: such a ring bends between the balls, and the model has rigid ones",
                wall * 1e3
            ));
        }
        return all;
    }
    let point = case.operating_point();
    let rings = [
        ("inner", &case.materials.inner, point.inner_speed, g.groove_bottom_radius(Side::Inner)),
        ("outer", &case.materials.outer, point.outer_speed, g.groove_bottom_radius(Side::Outer)),
    ];
    for (ring, material, speed, radius) in rings {
        let growth = material.density * speed * speed * radius.powi(3) / material.young;
        if growth > GROWTH * g.centre_distance() {
            all.push(format!(
                "at its speed a free {ring} ring of this size grows by {:.1} µm in radius, which is left out: add `mounting` to have it in the contact angles",
                growth * 1e6
            ));
        }
    }
    all
}

/// A sentence where the contacts of a bearing under its load stand far from the angle of their constants.
pub(super) fn frozen_warning(question: &Question<'_>, bearing: &Bearing) -> Option<String> {
    let case = question.case;
    let frozen = !case.modelling.contact_at_actual_angle && case.modelling.race_control.is_some();
    if !frozen || bearing.geometry.ball_count > FEW {
        return None;
    }
    let point = OperatingPoint { watch: question.watch.clone(), ..case.operating_point() };
    let solution = solve(bearing, &point, Model::JonesHarris).ok()?.solution;
    let free = bearing.geometry.contact_angle();
    let contacts = solution.balls.iter().flat_map(|ball| Side::BOTH.map(|side| (side, ball.contacts[side])));
    let loaded = contacts.filter(|(_, contact)| contact.load_n > 0.0);
    let (side, farthest) =
        loaded.max_by(|(_, a), (_, b)| (a.angle_rad - free).abs().total_cmp(&(b.angle_rad - free).abs()))?;
    let away = (farthest.angle_rad - free).abs();
    if away < FAR {
        return None;
    }
    // The pressure that the same load makes with the constants of the angle.
    let (sin, cos) = farthest.angle_rad.sin_cos();
    let g = &bearing.geometry;
    let [rolling, lateral] = g.curvatures(side, cos);
    let at_angle = bearing.races[side].hertz_at(rolling, lateral).ok()?;
    let approach = (farthest.load_n / at_angle.stiffness()).powf(2.0 / 3.0);
    let pose = ContactPose { sin, cos, approach };
    let pressure = at_angle.ellipse_at(pose.approach).peak_pressure;
    let change = pressure - farthest.peak_pressure_pa;
    if change.abs() < WORTH {
        return None;
    }
    Some(format!(
        "contact constants are those of the free angle, {:.1}° away from the {} contact that stands \
         farthest: its peak pressure would be {:.3} GPa {} with those of its own angle \
         (`modelling.contact_at_actual_angle`)",
        away.to_degrees(),
        side.name(),
        change.abs() * 1e-9,
        if change > 0.0 { "higher" } else { "lower" }
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_bearing::SearchWatch;

    fn case(text: &str, changes: &[(&str, &str)]) -> Case {
        let set = |text: String, (path, value): &(&str, &str)| tribodyn_case::set_value(&text, path, value).unwrap();
        Case::from_ron(&changes.iter().fold(text.to_owned(), set)).unwrap()
    }

    const PAPER: &str = include_str!("../../../../fixtures/cases/paper-ag.ron");

    /// ρ ω² r³/E of a ring of 61 mm at 14 000 r/min: 18 µm.
    #[test]
    fn limit_growth_by_rotation_is_named_where_it_is_left_out() {
        let fast = case(PAPER, &[]);
        let bearing = fast.bearing().unwrap();
        let said = geometry_warnings(&fast, &bearing);
        let radius: f64 = bearing.geometry.groove_bottom_radius(Side::Inner);
        let growth = 7800.0 * (14000.0_f64 * std::f64::consts::PI / 30.0).powi(2) * radius.powi(3) / 208.06e9 * 1e6;
        assert!(said.len() == 1 && said[0].contains(&format!("{growth:.1} µm")), "{said:?} {growth}");
        let slow = case(PAPER, &[("speed.inner.Constant", "rpm(1000)")]);
        assert!(geometry_warnings(&slow, &bearing).is_empty());
    }

    #[test]
    fn limit_thin_walls_are_named() {
        let ring = |diameter: f64| {
            format!("(seat_diameter: mm({diameter}), expansion: per_K(1.1e-5), temperature_rise: K(0))")
        };
        let mounted = |bore: f64| {
            let ball = "(expansion: per_K(1.1e-5), temperature_rise: K(0))";
            let mounting = format!("(inner: {}, outer: {}, ball: {ball})", ring(bore), ring(215.0));
            let case = case(PAPER, &[("mounting", &mounting)]);
            geometry_warnings(&case, &case.bearing().unwrap())
        };
        let thin = mounted(120.0);
        assert!(thin.len() == 1 && thin[0].contains("inner ring"), "{thin:?}");
        assert!(mounted(100.0).is_empty());
    }

    #[test]
    fn limit_contacts_far_from_their_constants_are_named() {
        let said = |case: &Case| {
            let question = Question { name: "test", text: PAPER, case, watch: SearchWatch::default() };
            frozen_warning(&question, &case.bearing().unwrap())
        };
        let paper = said(&case(PAPER, &[])).unwrap();
        assert!(paper.contains("inner contact") && paper.contains("GPa"), "{paper}");
        assert!(paper.contains(" lower ") || paper.contains(" higher "), "{paper}");
        let actual = case(PAPER, &[("modelling.contact_at_actual_angle", "true")]);
        assert_eq!(said(&actual), None);
    }
}
