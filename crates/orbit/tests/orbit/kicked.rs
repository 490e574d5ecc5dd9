//! Modes against the ringing of a run after a kick.

use nalgebra::{Matrix3, Vector3};
use std::{convert::Infallible, f64::consts::TAU, ops::ControlFlow};
use tribodyn_bearing::{CageBody, Races, RingFreedom, Scheme, Translation};
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{Event, Observer, Run, Sample};
use tribodyn_orbit::{Bodies, OrbitSettings, orbit_modes, steady_orbit};
use tribodyn_quasistatic::PatchRule;

const LOAD: f64 = 54_760.0;
const KICKED: f64 = 55_000.0;

/// Where the ring stands along the axis, m, after the kick.
#[derive(Default)]
struct Axial(Vec<f64>);

impl Observer for Axial {
    type Error = Infallible;

    fn sample(&mut self, s: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
        if s.time_s > 1e-3 {
            self.0.push(s.inner.displacement_m[2]);
        }
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, _: &Event) -> Result<(), Infallible> {
        Ok(())
    }
}

/// Frequency, Hz, and growth, 1/s, of one damped oscillation about a constant: s_{k+1} = a s_k + b s_{k−1} + c.
fn ringing(samples: &[f64], spacing: f64) -> (f64, f64) {
    let middle = samples.iter().sum::<f64>() / samples.len() as f64;
    let size = samples.iter().map(|s| (s - middle).abs()).fold(0.0, f64::max);
    let s: Vec<f64> = samples.iter().map(|s| (s - middle) / size).collect();
    let (mut left, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for w in s.windows(3) {
        let row = Vector3::new(w[1], w[0], 1.0);
        left += row * row.transpose();
        right += row * w[2];
    }
    let by = left.lu().solve(&right).unwrap();
    let (re, square) = (0.5 * by[0], 0.25 * by[0] * by[0] + by[1]);
    assert!(square < 0.0, "no oscillation");
    ((-square).sqrt().atan2(re) / (TAU * spacing), 0.5 * (-by[1]).ln() / spacing)
}

/// Under thrust alone the bearing looks the same from all sides, so that its modes do not change while balls pass.
#[test]
fn identity_a_kicked_ring_rings_at_the_frequency_of_its_mode() {
    let path = format!("{}/../../fixtures/cases/paper-ag.ron", env!("CARGO_MANIFEST_DIR"));
    let text = set_value(&std::fs::read_to_string(path).unwrap(), "ring.x", "Force(N(0))").unwrap();
    let case = Case::from_ron(&text).unwrap();
    let mut inputs = case.run_inputs().unwrap();
    inputs.patch = PatchRule::GaussJacobi { radial: 6, angles: 12 }.into();
    inputs.options.scheme = Scheme::RungeKutta4 { step: 4e-6 };
    inputs.options.duration = 0.016;
    inputs.supports.inner.damping = [200.0; 3];
    inputs.ring.z = Translation::ForceTable(vec![(0.0, LOAD), (5e-4, LOAD), (5.1e-4, KICKED)]);
    let cage = CageBody::new(&inputs.cage, &inputs.bearing);
    let (supports, contact_damping) = (inputs.supports, inputs.options.contact_damping);
    let mut point = inputs.operating_point_at(1.0);
    point.ring[2] = RingFreedom::Loaded(KICKED);
    let (bearing, rate) = (inputs.bearing.clone(), inputs.options.state_rate);
    let mut run = Run::new(inputs).unwrap();
    let mut axial = Axial::default();
    let _ = run.advance(run.duration(), &mut axial).unwrap();
    let (frequency, growth) = ringing(&axial.0, 1.0 / rate);

    let settings = OrbitSettings::default();
    let start = steady_orbit(&bearing, &point, &cage, &settings).unwrap().start.unwrap();
    let bodies = Bodies { cage, contact_damping, supports, tilting: Races::default() };
    let modes = orbit_modes(&bearing, &point, &bodies, &settings, &start).unwrap().modes;
    let axial = |m: &&tribodyn_orbit::Mode| m.inner_ring[2] > 0.5 && m.energy_shares.inner_ring > 0.5;
    let mode = modes.iter().find(axial).unwrap();
    assert!((frequency / mode.frequency_hz - 1.0).abs() < 5e-3, "{frequency} {mode:?}");
    assert!((growth / mode.growth_rate_per_s - 1.0).abs() < 0.1, "{growth} {mode:?}");
}
