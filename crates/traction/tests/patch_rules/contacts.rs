//! The contacts on which patch rules are measured, and a reference that shares nothing with the rules.

use std::f64::consts::{FRAC_PI_2, PI};
use tribodyn_traction::{
    Coating, CoatingLaw, Patch, PatchLaw, PatchRule, PatchTraction, PressureChoice, Probe, Quadrature, RelativeMotion,
    SlipField, SlipUnit, TractionError, TractionLaw, patch_traction,
};

/// Ball radius, m, and groove radius, m, of the case behind the contacts.
pub const BALL_RADIUS: f64 = 0.01508;
/// Groove coefficient 0.527 times the ball diameter.
const GROOVE_RADIUS: f64 = 0.527 * 0.03016;
/// The slip scales at which the case was solved, 1/(m/s).
pub const SCALES: [f64; 4] = [1.0, 5.0, 22.0, 100.0];

/// One contact of a solved bearing.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Slip scale λ, 1/(m/s).
    pub scale: f64,
    /// Ball and race.
    pub name: String,
    /// Its ellipse.
    pub patch: Patch,
    /// Its motion.
    pub motion: RelativeMotion,
    /// Rolling speed, m/s.
    pub rolling_speed: f64,
}

/// The frozen contacts at one slip scale.
pub fn contacts(scale: f64) -> Vec<Contact> {
    include_str!("contacts.csv")
        .lines()
        .filter(|line| !line.starts_with('#'))
        .skip(1)
        .map(contact)
        .filter(|contact| contact.scale == scale)
        .collect()
}

fn contact(line: &str) -> Contact {
    let cells: Vec<&str> = line.split(',').collect();
    let number = |column: usize| cells[column].parse::<f64>().unwrap();
    Contact {
        scale: number(0),
        name: format!("{} {}", cells[1], cells[2]),
        patch: Patch {
            semi_lateral: number(3),
            semi_rolling: number(4),
            peak_pressure: number(5),
            ball_radius: BALL_RADIUS,
            surface_radius: 2.0 * BALL_RADIUS * GROOVE_RADIUS / (BALL_RADIUS + GROOVE_RADIUS),
        },
        motion: RelativeMotion {
            rolling: number(6),
            lateral: number(7),
            spin: number(8),
            about_lateral: number(9),
            about_rolling: number(10),
        },
        rolling_speed: number(11),
    }
}

/// The law behind the contacts: silver, parabolas in the pressure.
pub fn silver() -> CoatingLaw {
    CoatingLaw::varying(&Coating::library("ag").unwrap(), 2).unwrap()
}

impl Contact {
    /// Load, N.
    pub fn load(&self) -> f64 {
        2.0 * PI / 3.0 * self.patch.peak_pressure * self.patch.semi_lateral * self.patch.semi_rolling
    }

    /// The law in the contact's slip scale.
    pub fn law<'a, L>(&self, law: &'a L) -> PatchLaw<'a, L> {
        PatchLaw { law, slip_unit: SlipUnit::Scaled { per_m_s: self.scale }, pressure: PressureChoice::Peak }
    }

    /// As a probe of [`tribodyn_traction::choose_rule`].
    pub fn probe<'a, L: TractionLaw>(&self, law: &'a L) -> Probe<'a, L> {
        Probe { patch: self.patch, motion: self.motion, rolling_speed: self.rolling_speed, law: self.law(law) }
    }

    /// The integrals by a rule.
    pub fn traction<L: TractionLaw>(&self, law: &L, quadrature: &Quadrature) -> PatchTraction {
        patch_traction(&self.patch, &self.motion, self.rolling_speed, &self.law(law), quadrature)
    }

    /// The integrals by `cells` × `cells` midpoints of latitude and longitude, X = cos φ sin θ, Y = sin φ, in which
    /// the Hertz pressure is a smooth hemisphere; slip, traction and moment as vectors, the curve as it is written.
    pub fn brute_force(&self, law: &CoatingLaw, cells: usize) -> PatchTraction {
        let Patch { semi_lateral: a, semi_rolling: b, peak_pressure, ball_radius, surface_radius, .. } = self.patch;
        let curve = law.at(peak_pressure);
        let spacing = PI / cells as f64;
        let angle = |i: usize| -FRAC_PI_2 + (i as f64 + 0.5) * spacing;
        let m = self.motion;
        // Components along y, n, x, a right-handed set.
        let (translation, rotation) = ([m.lateral, 0.0, m.rolling], [m.about_lateral, m.spin, m.about_rolling]);
        let mut sum = PatchTraction::zero();
        for (sin_phi, cos_phi) in (0..cells).map(|i| angle(i).sin_cos()) {
            for (sin_theta, cos_theta) in (0..cells).map(|i| angle(i).sin_cos()) {
                let (x, y) = (b * cos_phi * sin_theta, a * sin_phi);
                let arm = [y, ball_radius - y * y / (2.0 * surface_radius), x];
                let turned = cross(rotation, arm);
                let (u, v) = (translation[2] + turned[2], translation[0] + turned[0]);
                let speed = u.hypot(v);
                let slip = self.scale * speed;
                let coefficient = (curve.a + curve.b * slip) * (-curve.c * slip).exp() - curve.a;
                let area = a * b * cos_phi * cos_phi * cos_theta * spacing * spacing;
                let normal = peak_pressure * cos_phi * cos_theta * area;
                let force = [-coefficient * normal * v / speed, 0.0, -coefficient * normal * u / speed];
                let moment = cross(arm, force);
                sum.force_rolling += force[2];
                sum.force_lateral += force[0];
                sum.moment_lateral += moment[0];
                sum.moment_normal += moment[1];
                sum.moment_rolling += moment[2];
                sum.power += coefficient * normal * speed;
                sum.wear_integral += normal * speed;
            }
        }
        sum
    }

    /// Error of force over load, of moment over load times ball radius, and of power over the wear integral.
    pub fn errors(&self, ours: &PatchTraction, exact: &PatchTraction) -> [f64; 3] {
        let force = (ours.force_rolling - exact.force_rolling).hypot(ours.force_lateral - exact.force_lateral);
        let moment = (ours.moment_lateral - exact.moment_lateral)
            .hypot(ours.moment_normal - exact.moment_normal)
            .hypot(ours.moment_rolling - exact.moment_rolling);
        let power = (ours.power - exact.power).abs();
        [force / self.load(), moment / (self.load() * BALL_RADIUS), power / exact.wear_integral]
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A rule measured on the contacts of one slip scale.
#[derive(Debug, Clone, Copy)]
pub struct Measured {
    /// Mean number of points of a contact.
    pub points: f64,
    /// Largest errors of force, moment and power as in [`Contact::errors`].
    pub errors: [f64; 3],
}

/// Measures a rule against exact integrals, one for each contact.
pub fn measure(
    rule: PatchRule,
    contacts: &[Contact],
    law: &CoatingLaw,
    exact: &[PatchTraction],
) -> Result<Measured, TractionError> {
    let quadrature = Quadrature::new(rule)?;
    let mut measured = Measured { points: 0.0, errors: [0.0; 3] };
    for (contact, exact) in contacts.iter().zip(exact) {
        let points = quadrature.point_count(&SlipField::new(&contact.patch, &contact.motion));
        measured.points += points as f64 / contacts.len() as f64;
        let errors = contact.errors(&contact.traction(law, &quadrature), exact);
        measured.errors = [0, 1, 2].map(|k| measured.errors[k].max(errors[k]));
    }
    Ok(measured)
}
