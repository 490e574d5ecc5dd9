//! The equations of motion that orbits and runs have in common.

use std::{convert::Infallible, f64::consts::TAU, ops::ControlFlow};
use tribodyn_bearing::{BallResult, CageBody, Motion, RunInputs, Scheme, Translation};
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{Event, Observer, Run, Sample, StartMotion};
use tribodyn_orbit::{OrbitSettings, steady_orbit};

/// The balls of the last sample.
#[derive(Default)]
struct Last(Vec<BallResult>);

impl Observer for Last {
    type Error = Infallible;

    fn sample(&mut self, s: &Sample, balls: bool) -> Result<ControlFlow<()>, Infallible> {
        if balls {
            self.0.clone_from(&s.balls);
        }
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, _: &Event) -> Result<(), Infallible> {
        Ok(())
    }
}

/// Orbital and angular velocities of the balls as results have them, rad/s, in the order of their numbers.
type Speeds = Vec<[f64; 4]>;

/// A heavy cage, so that it turns evenly, pockets with the damping that orbits have at least, and a fluid whose drag is
/// much beside the friction of the balls.
const CHANGES: [(&str, &str); 4] = [
    ("cage.inertia", "kg_m2(0.06)"),
    ("cage.pocket_damping", "s_per_m(100)"),
    ("fluid.liquid_fraction", "1"),
    ("fluid.drag_coefficient", "1"),
];
const STEPS: f64 = 400.0;

/// The speeds where a run ends that starts with a motion, a pocket's spacing later.
fn end(mut inputs: RunInputs, start: &StartMotion, scheme: Scheme) -> Speeds {
    inputs.options.scheme = scheme;
    let mut run = Run::moving(inputs, start.clone()).unwrap();
    let mut last = Last::default();
    let _ = run.advance(run.duration(), &mut last).unwrap();
    last.0
        .iter()
        .map(|b| {
            [
                b.orbital_speed_rad_s,
                b.angular_velocity_rad_s[0],
                b.angular_velocity_rad_s[1],
                b.angular_velocity_rad_s[2],
            ]
        })
        .collect()
}

/// Largest difference of two sets of speeds, rad/s.
fn apart(a: &Speeds, b: &Speeds) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// A pocket's spacing later every ball of a steady orbit is where the next one was. Runs by all schemes find it there
/// as long as they have the drag and churning of the orbit, and else not.
#[test]
fn identity_orbits_and_all_schemes_have_the_same_forces() {
    let path = format!("{}/../../fixtures/cases/pump-7210.ron", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let text = CHANGES.iter().fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    let mut inputs = case.run_inputs().unwrap();
    let settings = OrbitSettings::default();
    let cage = CageBody::new(&inputs.cage, &inputs.bearing);
    let point = case.operating_point();
    let solved = steady_orbit(&inputs.bearing, &point, &cage, &settings).unwrap();
    let (orbit, found) = (&solved.solution, solved.start.unwrap());
    assert_eq!((orbit.raised_pocket_damping_s_per_m, orbit.swing_damping), (None, None));

    let count = inputs.bearing.geometry.ball_count;
    let motion = found.motion(count);
    let spacing = TAU / motion.cage_speed / count as f64;
    let step = spacing / STEPS;
    let [x, y, z, ..] = motion.ring;
    (inputs.ring.x, inputs.ring.y, inputs.ring.z) = (Translation::Held(x), Translation::Held(y), Translation::Held(z));
    inputs.options.contact_damping = settings.contact_damping;
    inputs.options.duration = spacing;
    (inputs.options.state_rate, inputs.options.ball_rate) = (1.0 / spacing, 1.0 / spacing);
    let next: Speeds = next_speeds(&motion);
    let solution = orbit.as_solution(&orbit.balls, [point.inner_speed, point.outer_speed]);
    let start = StartMotion { motion, rule: found.rule(), solution };

    let mut dry = inputs.clone();
    dry.bearing.fluid = None;
    let schemes =
        [Scheme::RungeKutta4 { step }, Scheme::DormandPrince { tolerance: 1e-9, longest: step }, Scheme::Fast { step }];
    for scheme in schemes {
        let off = apart(&end(inputs.clone(), &start, scheme), &next);
        let effect = apart(&end(dry.clone(), &start, scheme), &next);
        assert!(off < 0.02 * effect, "{scheme:?}: {off} rad/s off, {effect} rad/s without the fluid");
    }
}

/// State of every ball a pocket's spacing later.
fn next_speeds(motion: &Motion) -> Speeds {
    let speeds = |(_, ball): &(f64, tribodyn_bearing::BallState)| {
        let [a, r, t] = ball.angular_velocity;
        [ball.orbital_speed, a - ball.orbital_speed, r, t]
    };
    let mut speeds: Speeds = motion.balls.iter().map(speeds).collect();
    speeds.rotate_left(1);
    speeds
}
