//! Against exact rolling contact (CONTACT) and Kalker's linear theory.

use crate::{Dry, steel};
use std::f64::consts::PI;
use tribodyn_traction::{
    Fastsim, FastsimRule, Patch, PatchLaw, PatchRule, PatchTraction, PressureChoice, Quadrature, RelativeMotion,
    SlipUnit, TangentialElasticity, elastic_patch_traction, patch_traction,
};

const FRICTION: f64 = 0.05;
const SPEED: f64 = 30.0;
const BALL_RADIUS: f64 = 0.01508;
const STILL: RelativeMotion =
    RelativeMotion { rolling: 0.0, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 };

/// The contact of the file's head.
fn patch() -> Patch {
    Patch {
        semi_lateral: 2.510437e-3,
        semi_rolling: 0.339849e-3,
        peak_pressure: 1119.274e6,
        ball_radius: BALL_RADIUS,
        surface_radius: f64::INFINITY,
    }
}

fn coulomb(law: &Dry) -> PatchLaw<'_, Dry> {
    PatchLaw { law, slip_unit: SlipUnit::MeterPerSecond, pressure: PressureChoice::Peak }
}

struct Row {
    creep: [f64; 3],
    /// F_X, F_Y, M_Z (N m) and the power lost.
    exact: [f64; 4],
}

fn rows() -> Vec<Row> {
    let table = include_str!("../../../../fixtures/reference/contact25/rolling-contact.csv");
    table
        .lines()
        .filter(|line| !line.starts_with('#'))
        .skip(1)
        .map(|line| {
            let n: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            Row { creep: [n[0], n[1], 1e3 * n[2]], exact: [n[3], n[4], 1e-3 * n[5], -n[6]] }
        })
        .collect()
}

impl Row {
    fn motion(&self) -> RelativeMotion {
        let [along, across, spin] = self.creep.map(|c| c * SPEED);
        RelativeMotion { rolling: along, lateral: across, spin, ..STILL }
    }

    /// Errors of force, force, moment and power: over μQ, μQ, μQ sqrt(ab) and the power itself.
    fn errors(&self, t: &PatchTraction) -> [f64; 4] {
        let p = patch();
        let bound = FRICTION * 2.0 / 3.0 * PI * p.peak_pressure * p.semi_lateral * p.semi_rolling;
        let size = (p.semi_lateral * p.semi_rolling).sqrt();
        let [fx, fy, mz, power] = self.exact;
        [
            (t.force_rolling - fx) / bound,
            (t.force_lateral - fy) / bound,
            (t.moment_normal - mz) / (bound * size),
            t.power / power - 1.0,
        ]
    }

    /// Slip everywhere well beyond what elasticity can take up, which is about 5e-4 here.
    fn slides(&self) -> bool {
        let [along, across, spin] = self.creep;
        along.hypot(across).max(spin.abs() * patch().semi_lateral) >= 2e-3
    }
}

#[test]
fn code_contact_forces_moments_and_power_of_rolling() {
    let grid = Fastsim::new(FastsimRule { across: 16, cells: 48 }).unwrap();
    let law = Dry::coulomb(FRICTION);
    for row in rows() {
        // In the file material moves towards −x.
        let t = elastic_patch_traction(&patch(), &row.motion(), -SPEED, &coulomb(&law), &steel(), &grid);
        let [fx, fy, mz, power] = row.errors(&t);
        println!("{:?}: {fx:8.4} {fy:8.4} {mz:8.4} {power:8.4}", row.creep);
        assert!(fx.abs() < 0.03 && fy.abs() < 0.03 && mz.abs() < 0.05, "{:?}: {fx} {fy} {mz}", row.creep);
        if row.slides() {
            assert!(power.abs() < 0.05, "{:?}: power {power}", row.creep);
        }
    }
}

#[test]
fn code_contact_the_elastic_patch_is_nearer_than_the_rigid_one_at_small_creep() {
    let grid = Fastsim::new(FastsimRule { across: 16, cells: 48 }).unwrap();
    let rigid = Quadrature::new(PatchRule::SplitStrip { across: 24, along: 24 }).unwrap();
    let law = Dry::coulomb(FRICTION);
    let mut compared = 0;
    for row in rows().iter().filter(|row| row.creep[0].abs().max(row.creep[1].abs()) < 2e-3) {
        let ours = elastic_patch_traction(&patch(), &row.motion(), -SPEED, &coulomb(&law), &steel(), &grid);
        let without = patch_traction(&patch(), &row.motion(), -SPEED, &coulomb(&law), &rigid);
        let distance = |t: &PatchTraction| {
            let [fx, fy, mz, _] = row.errors(t);
            fx.hypot(fy).max(mz.abs())
        };
        let (ours, without) = (distance(&ours), distance(&without));
        assert!(ours < without, "{:?}: {ours} {without}", row.creep);
        compared += 1;
    }
    assert_eq!(compared, 6);
}

/// Force over creepage at vanishing creep, by the coefficient that it belongs to.
#[test]
fn paper_kalker_1990_slopes_of_the_linear_theory() {
    let table = include_str!("../../../../fixtures/reference/kalker1990/creep-coefficients.csv");
    let grid = Fastsim::new(FastsimRule { across: 12, cells: 24 }).unwrap();
    let law = Dry::coulomb(0.3);
    for line in table.lines().filter(|line| !line.starts_with('#')).skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |column: usize| cells[column].parse::<f64>().unwrap();
        let ratio = if cells[0] == "a/b" { number(1) } else { number(1).recip() };
        for (k, poisson) in [0.0, 0.25, 0.5].into_iter().enumerate() {
            let elasticity = TangentialElasticity::new(80e9, poisson).unwrap();
            let c = 1e-3;
            let patch = Patch { semi_rolling: c * ratio.sqrt(), semi_lateral: c / ratio.sqrt(), ..patch() };
            let of = |motion: RelativeMotion| {
                elastic_patch_traction(&patch, &motion, -SPEED, &coulomb(&law), &elasticity, &grid)
            };
            let creep = 1e-6;
            let stiffness = 80e9 * c * c * creep;
            let along = of(RelativeMotion { rolling: creep * SPEED, ..STILL }).force_rolling / -stiffness;
            let across = of(RelativeMotion { lateral: creep * SPEED, ..STILL }).force_lateral / -stiffness;
            let turned = of(RelativeMotion { spin: creep / c * SPEED, ..STILL }).force_lateral / -stiffness;
            for (name, ours, column) in [("C11", along, 2), ("C22", across, 5), ("C23", turned, 8)] {
                let error = ours / number(column + k) - 1.0;
                assert!(error.abs() < 0.02, "{name} at {} = {}, {poisson}: {ours} {error:.4}", cells[0], cells[1]);
            }
        }
    }
}
