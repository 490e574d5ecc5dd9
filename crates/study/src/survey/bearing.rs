//! Random bearings: physically sensible, of all kinds, loads, speeds and supports, each the text of a case file.

use std::fmt::{self, Write};
use tribodyn_bearing::Side;
use tribodyn_case::{Case, CaseError, set_value};
use tribodyn_wear::Random;

/// Kind of a random bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Deep groove, by its radial clearance.
    DeepGroove,
    /// Angular contact, 15° to 40°.
    AngularContact,
    /// Angular contact in a cryogenic fluid at high speed, with a solid lubricant.
    Turbopump,
}

/// A random bearing at a random operating point.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomBearing {
    /// Seed of the family and number of the member.
    pub origin: (u64, u64),
    /// Kind of bearing.
    pub kind: Kind,
    /// Peak pressure that the load would make at the inner race if balls shared it as usual and did not turn, GPa.
    pub nominal_pressure_gpa: f64,
    /// Pitch diameter times speed of the ring that turns faster, mm/min.
    pub pitch_speed_mm_min: f64,
    /// The case file.
    pub text: String,
}

/// Drawn geometry and speeds, SI.
struct Draw {
    kind: Kind,
    balls: usize,
    pitch: f64,
    ball: f64,
    grooves: [f64; 2],
    fit: String,
    contact_angle: f64,
    speeds: [f64; 2],
}

/// Slowest and fastest pitch diameter times speed, mm/min.
const PITCH_SPEED: [f64; 2] = [1e3, 3e6];
/// Least and most nominal pressure, GPa.
const PRESSURE_GPA: [f64; 2] = [0.1, 4.0];
/// A ball hardly larger than this part of the pitch diameter leaves no room for the inner ring.
const LARGEST_BALL: f64 = 0.35;

/// Member `index` of the family with this seed.
///
/// # Errors
/// The case that was drawn is refused: a fault of the generator or of the bounds of case files.
pub fn random_bearing(seed: u64, index: u64) -> Result<RandomBearing, CaseError> {
    let mut random = Random::new(seed, index);
    let kind = random.one_of(&[(0.35, Kind::DeepGroove), (0.35, Kind::AngularContact), (0.3, Kind::Turbopump)]);
    let slowest = if kind == Kind::Turbopump { 3e5 } else { PITCH_SPEED[0] };
    let pitch_speed_mm_min = random.decades(slowest, PITCH_SPEED[1]);
    let draw = Draw::new(&mut random, kind, pitch_speed_mm_min);
    let nominal_pressure_gpa = random.decades(PRESSURE_GPA[0], PRESSURE_GPA[1]);
    let name = format!("random bearing {seed}-{index}: {kind}, {nominal_pressure_gpa:.2} GPa");
    let unloaded = draw.text(&mut random, &name);
    let text = draw.loaded(&mut random, &unloaded, nominal_pressure_gpa * 1e9)?;
    Case::from_ron(&text)?;
    Ok(RandomBearing { origin: (seed, index), kind, nominal_pressure_gpa, pitch_speed_mm_min, text })
}

impl Draw {
    fn new(random: &mut Random, kind: Kind, pitch_speed_mm_min: f64) -> Self {
        let balls = random.whole(5, 25);
        let pitch = random.decades(0.010, 0.500);
        let room = (std::f64::consts::PI / balls as f64).sin() * pitch;
        let ball = (room * random.between(0.6, 0.95)).min(LARGEST_BALL * pitch);
        let grooves = [random.between(0.508, 0.54), random.between(0.508, 0.55)];
        let centres = (grooves[0] + grooves[1] - 1.0) * ball;
        let (fit, contact_angle) = if kind == Kind::DeepGroove {
            // From none to about what ISO 5753 allows as C4: 5e-4 of the pitch diameter.
            let clearance = random.decades(5e-6, 5e-4) * pitch;
            let cosine: f64 = 1.0 - clearance / (2.0 * centres);
            (format!("RadialClearance(um({:.3}))", 1e6 * clearance), cosine.max(0.9).acos())
        } else {
            let degrees = random.between(15.0, if kind == Kind::Turbopump { 28.0 } else { 40.0 });
            (format!("ContactAngle(deg({degrees:.2}))"), degrees.to_radians())
        };
        let speed = pitch_speed_mm_min / (1e3 * pitch);
        let speeds = match random.one_of(&[(0.7, 0), (0.12, 1), (0.18, 2)]) {
            0 => [speed, 0.0],
            1 => [0.0, speed],
            _ if random.chance(0.5) => [speed, speed * random.between(-0.9, 0.8)],
            _ => [speed * random.between(-0.9, 0.8), speed],
        };
        Self { kind, balls, pitch, ball, grooves, fit, contact_angle, speeds }
    }

    /// The case without loads.
    fn text(&self, random: &mut Random, name: &str) -> String {
        let Self { balls, pitch, ball, grooves, fit, speeds, .. } = self;
        let density = random.one_of(&[(0.8, 7800.0), (0.2, 3200.0)]);
        let young = if density < 5000.0 { 310.0 } else { random.between(200.0, 212.0) };
        let sections = [
            format!("    name: \"{name}\",\n"),
            format!(
                "    geometry: (ball_count: {balls}, ball_diameter: mm({:.4}), pitch_diameter: mm({:.4}), \
                 inner_groove: Coefficient({:.4}), outer_groove: Coefficient({:.4}), fit: {fit}),\n",
                1e3 * ball, 1e3 * pitch, grooves[0], grooves[1]
            ),
            format!(
                "    materials: (\n        ball: (young: GPa({young:.1}), poisson: 0.27, density: kg_per_m3({density})),\n        \
                 inner: (young: GPa(208), poisson: 0.3, density: kg_per_m3(7800)),\n        \
                 outer: (young: GPa(208), poisson: 0.3, density: kg_per_m3(7800)),\n    ),\n"
            ),
            coatings(random),
            traction(random),
            fluid(random, self.kind),
            self.cage(random),
            "    wear: (\n        inner: (coefficient: 1e-6, hardness: MPa(250)),\n        outer: (coefficient: 1e-6, hardness: MPa(250)),\n        cage: (coefficient: 1e-6, hardness: MPa(60)),\n    ),\n".to_owned(),
            "    ring: (x: Force(N(0)), y: Force(N(0)), z: Force(N(0)), tilt_x: Held(deg(0)), tilt_y: Held(deg(0))),\n".to_owned(),
            format!("    speed: (inner: Constant(rpm({:.2})), outer: Constant(rpm({:.2}))),\n", speeds[0], speeds[1]),
            self.supports(random),
            self.defects(random),
            transient(random),
            modelling(random),
            "    recording: (state_rate: kHz(25.6), ball_rate: kHz(5.12)),\n".to_owned(),
        ];
        let mut text = String::from("(\n");
        sections.iter().for_each(|section| text.push_str(section));
        text.push_str(")\n");
        text
    }

    /// The case with loads, displacements and tilts by the pressure that they are to make, Pa.
    fn loaded(&self, random: &mut Random, unloaded: &str, pressure: f64) -> Result<String, CaseError> {
        let case = Case::from_ron(unloaded)?;
        // A case that is accepted has a bearing; one that has none is drawn as unloaded and fails where it is solved.
        let Ok(bearing) = case.bearing() else { return Ok(unloaded.to_owned()) };
        let hertz = bearing.races.inner.frozen::<f64>();
        let load = hertz.load_from_peak_pressure(pressure);
        let approach = hertz.approach(load) + bearing.races[Side::Outer].frozen::<f64>().approach(load);
        // Deep grooves stand at some 12° under thrust, whatever their angle when free.
        let angle = self.contact_angle.max(0.2);
        let (all, (sin, cos)) = (self.balls as f64, angle.sin_cos());
        // A radial load is carried by a fifth of the balls (Stribeck's 5 instead of 4.37, with clearance).
        let [radial, axial] = match (random.one_of(&[(0.25, 0), (0.3, 1), (0.45, 2)]), self.kind) {
            (0, Kind::DeepGroove) => [1.0, 0.0],
            (0 | 1, _) => [0.0, 1.0],
            _ => [random.between(0.1, 0.9), random.between(0.2, 1.0)],
        };
        let (force_x, force_z) = (radial * load * all * cos / 5.0, axial * load * all * sin);
        let held_z = axial > 0.0 && self.kind != Kind::DeepGroove && random.chance(0.15);
        let held_x = radial > 0.0 && random.chance(0.1);
        let z = if held_z { held(axial.powf(2.0 / 3.0) * approach / sin) } else { force(force_z) };
        let x = if held_x { held(0.3 * radial * approach) } else { force(force_x) };
        let y = random.one_of(&[(0.7, 0), (0.2, 1), (0.1, 2)]);
        let y = [force(0.0), held(0.0), force(random.between(-0.3, 0.3) * force_x)][y].clone();
        let mut tilt = || match random.one_of(&[(0.6, 0), (0.2, 1), (0.2, 2)]) {
            0 => "Held(deg(0))".to_owned(),
            1 => format!("Held(mrad({:.4}))", random.between(-0.5, 0.5)),
            // What tilts it is a load off its plane by up to a tenth of the pitch radius.
            _ => format!("Moment(Nm({:.5e}))", random.between(-0.05, 0.05) * self.pitch * (force_x + force_z)),
        };
        let tilts = [tilt(), tilt()];
        let changes = [
            ("ring.x", x),
            ("ring.y", y),
            ("ring.z", z),
            ("ring.tilt_x", tilts[0].clone()),
            ("ring.tilt_y", tilts[1].clone()),
        ];
        changes.iter().try_fold(unloaded.to_owned(), |text, (path, value)| set_value(&text, path, value))
    }

    fn cage(&self, random: &mut Random) -> String {
        let (ball, pitch) = (1e3 * self.ball, 1e3 * self.pitch);
        // A ring of plastic, a third of the balls' diameter thick and 1.2 of it wide, half of it pockets.
        let mass = 2000.0 * 0.5 * std::f64::consts::PI * self.pitch * 0.4 * self.ball * self.ball;
        let inertia = mass * 0.25 * self.pitch * self.pitch;
        let guided = random.chance(0.4);
        let land = if guided {
            let side = if random.chance(0.5) { "Outer" } else { "Inner" };
            let radius = 0.5 * pitch + if side == "Outer" { 0.3 * ball } else { -0.3 * ball };
            format!(
                ", guidance: (land: {side}, radius: mm({radius:.4}), width: mm({:.4}), gap: mm({:.5}))",
                0.3 * ball,
                0.005 * ball + 0.05 * random.share() * 0.1 * radius
            )
        } else {
            String::new()
        };
        format!(
            "    cage: (pocket_gap: mm({:.5}), pocket_stiffness: N_per_um({:.3}), pocket_friction: {:.3}, \
             drag_torque: Nm({:.3e}), inertia: kg_m2({inertia:.5e}), pocket_damping: s_per_m({:.3}){land}),\n",
            ball * random.between(0.005, 0.03),
            random.decades(0.1, 20.0) * (ball / 10.0),
            random.between(0.02, 0.2),
            if random.chance(0.7) { 0.0 } else { random.decades(1e-4, 1e-2) * mass * 9.81 * self.pitch },
            random.between(0.0, 1.0),
        )
    }

    /// Rings of about the section of a catalogue bearing, on supports of some ten to a hundred hertz to a kilohertz.
    fn supports(&self, random: &mut Random) -> String {
        let ring = 7800.0 * std::f64::consts::PI * self.pitch * self.ball * self.ball;
        let mut support = |share: f64, axes: usize, at_least: f64| {
            let mass = share * ring * random.decades(1.0, 20.0);
            let rate = random.decades(at_least, 6000.0);
            let stiffness = mass * rate * rate;
            let damping = 2.0 * random.between(0.02, 0.3) * mass * rate;
            let list = |unit: &str, value: f64| vec![format!("{unit}({value:.4e})"); axes].join(", ");
            format!(
                "(mass: kg({mass:.4e}), stiffness: ({}), damping: ({}))",
                list("N_per_m", stiffness),
                list("N_s_per_m", damping)
            )
        };
        format!(
            "    supports: (\n        inner: {},\n        outer: {},\n    ),\n",
            support(0.5, 3, 100.0),
            support(0.5, 2, 1000.0)
        )
    }

    fn defects(&self, random: &mut Random) -> String {
        if !random.chance(0.2) {
            return String::new();
        }
        let depth = 1e6 * self.ball * random.decades(1e-5, 5e-4);
        format!(
            "    defects: [(race: {}, azimuth: deg({:.1}), width: deg({:.2}), depth: um({depth:.4}), bare: {})],\n",
            if random.chance(0.5) { "Outer" } else { "Inner" },
            random.between(0.0, 360.0),
            random.between(1.0, 10.0),
            if random.chance(0.5) { 1 } else { 0 },
        )
    }
}

fn force(newton: f64) -> String {
    format!("Force(N({newton:.6e}))")
}

fn held(metres: f64) -> String {
    format!("Held(um({:.5}))", 1e6 * metres)
}

fn coatings(random: &mut Random) -> String {
    let mut text = String::from("    coatings: (\n");
    for race in ["inner", "outer"] {
        let curve = random.one_of(&[
            (0.4, "Library(\"ag\")"),
            (0.25, "Library(\"ptfe\")"),
            (0.15, "Library(\"bare-440c\")"),
            (0.2, ""),
        ]);
        let curve = if curve.is_empty() {
            // About a lubricated contact: some hundredths, falling a little past the peak.
            let (peak, slip) = (random.between(0.02, 0.12), random.decades(0.5, 5.0));
            let point = |pressure: f64, share: f64| {
                format!(
                    "(pressure: GPa({pressure}), peak_slip: {slip:.3}, peak_coefficient: {:.4}, residual_coefficient: {:.4})",
                    peak * share,
                    0.8 * peak * share
                )
            };
            format!("Tested([{}, {}, {}])", point(0.5, 1.0), point(1.5, 0.97), point(3.0, 0.93))
        } else {
            curve.to_owned()
        };
        let worn = if random.chance(0.8) { 0.0 } else { random.between(0.0, 0.9) };
        let _ = writeln!(
            text,
            "        {race}: (curve: {curve}, thickness: um({:.2}), worn: {worn:.3}),",
            random.between(1.0, 20.0)
        );
    }
    text + "        bare: (curve: Library(\"bare-440c\")),\n    ),\n"
}

fn traction(random: &mut Random) -> String {
    let slip = random.one_of(&[(0.8, true), (0.2, false)]);
    let slip = if slip {
        format!("Scaled(per_m_s: {:.3})", random.decades(1.0, 100.0))
    } else {
        "PercentOfRolling".to_owned()
    };
    let patch = random.one_of(&[
        (0.7, "SplitStrip(across: 8, along: 3)"),
        (0.2, "TargetError(relative: 1e-4)"),
        (0.1, "GaussJacobi(radial: 5, angles: 12)"),
    ]);
    format!(
        "    traction: (slip_unit: {slip}, order: {}, varying: {}, reference_pressure: GPa(2.5), differential_slip: {}, \
         pressure: {}, patch: {patch}),\n",
        random.whole(1, 2),
        random.chance(0.7),
        random.chance(0.8),
        if random.chance(0.9) { "Peak" } else { "Local" },
    )
}

fn fluid(random: &mut Random, kind: Kind) -> String {
    let medium = match kind {
        Kind::Turbopump => random.one_of(&[
            (0.5, "Nitrogen(temperature: K(87.5), pressure: MPa(4))"),
            (0.3, "Oxygen(temperature: K(90), pressure: MPa(4))"),
            (0.2, "Methane(temperature: K(111.7), pressure: MPa(4))"),
        ]),
        _ if random.chance(0.5) => return String::new(),
        _ => "Custom(density: kg_per_m3(850), viscosity: mPa_s(15))",
    };
    // Oil fills a hundredth to a tenth of the room between the rings, a cryogen more.
    let liquid = if kind == Kind::Turbopump { random.decades(0.05, 0.9) } else { random.decades(0.002, 0.1) };
    format!(
        "    fluid: (medium: {medium}, liquid_fraction: {liquid:.4}, gas_density: kg_per_m3({}), drag_coefficient: {:.4}, \
         swirl: {:.3}, shaded_fraction: {:.3}, churning: {}),\n",
        if kind == Kind::Turbopump { 12.0 } else { 1.2 },
        random.decades(0.01, 0.5),
        if random.chance(0.5) { 0.0 } else { random.between(0.0, 0.5) },
        random.between(0.0, 0.6),
        random.chance(0.7),
    )
}

/// A short run by each scheme, at steps from fine to too long.
fn transient(random: &mut Random) -> String {
    let scheme = match random.whole(0, 2) {
        0 => format!("RungeKutta4(step: us({:.3}))", random.decades(0.5, 5.0)),
        1 => format!("DormandPrince(tolerance: {:.1e}, longest: us(10))", random.decades(1e-9, 1e-5)),
        _ => format!("Fast(step: us({:.3}))", random.decades(1.0, 20.0)),
    };
    let wear = if random.chance(0.6) { 0.0 } else { random.decades(1.0, 1e6) };
    format!(
        "    transient: (duration: ms(2), start: QuasiStatic, scheme: {scheme}, contact_damping: {:.3}, wear_acceleration: {wear:.3e}),\n",
        random.between(0.0, 0.1)
    )
}

fn modelling(random: &mut Random) -> String {
    format!(
        "    modelling: (contact_at_actual_angle: {}, ring_centre: {}, race_control: {}, centrifugal_at_free_pitch: {}),\n",
        random.chance(0.1),
        if random.chance(0.9) { "Displaced" } else { "Inertial" },
        random.one_of(&[(0.6, "Outer"), (0.2, "Inner"), (0.2, "Criterion")]),
        random.chance(0.5),
    )
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::DeepGroove => "deep groove",
            Self::AngularContact => "angular contact",
            Self::Turbopump => "turbopump",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_random_bearing_is_a_case_and_the_same_each_time() {
        for index in 0..50 {
            let bearing = random_bearing(5, index).unwrap_or_else(|e| panic!("{index}: {e}"));
            assert_eq!(random_bearing(5, index).unwrap(), bearing);
            let case = Case::from_ron(&bearing.text).unwrap();
            assert!(case.bearing().is_ok() && case.transient.is_some(), "{index}");
        }
    }

    #[test]
    fn limit_all_kinds_freedoms_and_schemes_occur() {
        let all: Vec<String> = (0..120).map(|index| random_bearing(1, index).unwrap().text).collect();
        for part in [
            "RadialClearance",
            "ContactAngle",
            "Nitrogen",
            "Custom",
            "x: Held",
            "z: Held",
            "Moment",
            "Held(mrad",
            "RungeKutta4",
            "DormandPrince",
            "Fast",
            "defects",
            "guidance",
            "PercentOfRolling",
            "Tested",
            "outer: Constant(rpm(0.00))",
            "inner: Constant(rpm(0.00))",
        ] {
            assert!(all.iter().any(|text| text.contains(part)), "{part}");
        }
    }
}
