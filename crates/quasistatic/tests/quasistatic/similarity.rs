//! Scaling laws, which hold to rounding, and continuity, which holds where no ball changes its kind of equilibrium.

use crate::{PAPER_AG, STRIPS, assert_near, solve_case, variant};
use tribodyn_bearing::{Tilt, Translation};
use tribodyn_case::Case;
use tribodyn_quasistatic::Model::{self, JonesHarris, Traction};
use tribodyn_quasistatic::Solution;

const MODELS: [Model; 2] = [JonesHarris, Traction];
/// Friction that does not hang on pressure, and no churning, which hangs on viscosity.
const SCALABLE: [(&str, &str); 4] =
    [STRIPS, ("traction.varying", "false"), ("fluid.churning", "false"), ("ring.y", "Force(kN(3))")];

/// Multiplies all forces and moments on the ring.
fn load(case: &mut Case, force: f64, moment: f64) {
    for translation in [&mut case.ring.x, &mut case.ring.y, &mut case.ring.z] {
        if let Translation::Force(value) = translation {
            *value *= force;
        }
    }
    for tilt in [&mut case.ring.tilt_x, &mut case.ring.tilt_y] {
        if let Tilt::Moment(value) = tilt {
            *value *= moment;
        }
    }
}

/// Fails unless the second solution is the first with speeds, loads, displacements and torques multiplied.
fn assert_scaled(a: &Solution, b: &Solution, [speed, force, length, torque]: [f64; 4]) {
    assert_near("cage speed", b.cage_speed_rpm, speed * a.cage_speed_rpm, 1e-9);
    // Jones–Harris has no torque.
    assert_eq!(a.shaft_torque_nm.is_some(), b.shaft_torque_nm.is_some());
    assert_near("torque", b.shaft_torque_nm.unwrap_or(0.0), torque * a.shaft_torque_nm.unwrap_or(0.0), 1e-7);
    for (x, y) in a.ring_displacement_m.iter().zip(b.ring_displacement_m) {
        assert_near("displacement", y, length * x, 1e-7);
    }
    for (x, y) in a.ring_load_n.iter().zip(b.ring_load_n) {
        assert_near("ring load", y, force * x, 1e-8);
    }
}

/// All lengths twice as long, forces four times as large and speeds half as fast: the same stresses, surface speeds and
/// slips.
#[test]
fn identity_similar_bearings_have_similar_solutions() {
    const LENGTH: f64 = 2.0;
    for model in MODELS {
        let small = variant(PAPER_AG, &SCALABLE);
        let mut large = small.clone();
        large.geometry.ball_diameter *= LENGTH;
        large.geometry.pitch_diameter *= LENGTH;
        load(&mut large, LENGTH.powi(2), LENGTH.powi(3));
        large.speed.inner = tribodyn_bearing::SpeedHistory::Constant(small.speed.inner.last() / LENGTH);
        let (a, b) = (solve_case(&small, model).solution, solve_case(&large, model).solution);
        assert_scaled(&a, &b, [1.0 / LENGTH, LENGTH.powi(2), LENGTH, LENGTH.powi(3)]);
    }
}

/// Moduli, densities and loads three times as large: the same displacements and speeds.
#[test]
fn identity_loads_scale_with_moduli_and_densities() {
    const FACTOR: f64 = 3.0;
    for model in MODELS {
        let soft = variant(PAPER_AG, &SCALABLE);
        let mut stiff = soft.clone();
        for body in [&mut stiff.materials.ball, &mut stiff.materials.inner, &mut stiff.materials.outer] {
            body.young *= FACTOR;
            body.density *= FACTOR;
        }
        stiff.fluid.as_mut().unwrap().drag_coefficient *= FACTOR;
        load(&mut stiff, FACTOR, FACTOR);
        let (a, b) = (solve_case(&soft, model).solution, solve_case(&stiff, model).solution);
        assert_scaled(&a, &b, [1.0, FACTOR, 1.0, FACTOR]);
    }
}

/// Along a path on which every ball stays loaded and rolls, results are smooth: from one point to the next they change
/// by what they changed before, to the second order, and where they hardly change, by next to nothing. A ball that fell
/// into skidding would show as some per cent. Each point is solved cold, so that nothing carries over.
#[test]
fn identity_results_are_continuous_in_load_speed_and_friction() {
    const POINTS: usize = 7;
    type Value = fn(f64) -> String;
    let paths: [(&str, Value); 4] = [
        ("ring.z", |s| format!("Force(kN({}))", 40.0 + 12.0 * s)),
        ("ring.x", |s| format!("Force(kN({}))", 12.0 + 8.0 * s)),
        ("speed.inner", |s| format!("Constant(rpm({}))", 12e3 + 4e3 * s)),
        ("traction.slip_unit", |s| format!("Scaled(per_m_s: {})", 15.0 + 10.0 * s)),
    ];
    for model in MODELS {
        for (path, value) in paths {
            let solutions: Vec<Solution> = (0..POINTS)
                .map(|k| {
                    let value = value(k as f64 / (POINTS - 1) as f64);
                    solve_case(&variant(PAPER_AG, &[STRIPS, (path, value.as_str())]), model).solution
                })
                .collect();
            for (what, get) in [
                ("cage speed", (|s| s.cage_speed_rpm) as fn(&Solution) -> f64),
                ("axial displacement", |s| s.ring_displacement_m[2]),
                ("shaft torque", |s| s.shaft_torque_nm.unwrap_or(0.0)),
            ] {
                let numbers: Vec<f64> = solutions.iter().map(get).collect();
                let steps: Vec<f64> = numbers.windows(2).map(|pair| pair[1] - pair[0]).collect();
                let largest = steps.iter().fold(0.0f64, |most, step| most.max(step.abs()));
                let size = numbers.iter().fold(0.0f64, |most, number| most.max(number.abs()));
                for pair in steps.windows(2) {
                    let bend = (pair[1] - pair[0]).abs();
                    assert!(bend <= 0.35 * largest + 2e-4 * size, "{model:?}, {what} along {path}: {numbers:?}");
                }
            }
        }
    }
}
