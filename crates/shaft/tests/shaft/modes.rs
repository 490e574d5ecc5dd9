//! Frequencies at rest and at speed.

use crate::support::on_springs;
use tribodyn_shaft::{Disc, Element, LinearShaft, Material, Section, Shaft, Whirl};

/// The reference rotor: ten elements of 50 mm, ø 50 mm, springs at nodes 1 and 9, a disc at node 5.
fn reference() -> LinearShaft {
    let material = Material { young: 211e9, shear: 81.2e9, density: 7810.0 };
    let section = Section::solid(0.05);
    let element = Element { length: 0.05, start: section, end: section, material };
    let disc = Disc { node: 5, mass: 8.0, transverse_inertia: 0.02, polar_inertia: 0.035 };
    let shaft = Shaft::new(vec![element; 10], vec![disc]).unwrap();
    let springs = [(1, [1.2e8, 1.2e8, 0.0, 0.0, 0.0]), (9, [0.9e8, 0.9e8, 0.0, 0.0, 0.0])];
    linear(shaft, &springs)
}

fn linear(shaft: Shaft, springs: &[(usize, [f64; 5])]) -> LinearShaft {
    let loads = vec![[0.0; 5]; shaft.nodes()];
    let mut system = on_springs(shaft, springs, loads);
    let at_rest = system.equilibrium().unwrap();
    system.linearised(&at_rest, &[]).unwrap()
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 6e-5, "{found} Hz where {expected} Hz is printed");
}

/// Printed by ROSS 2.3.0 for the same rotor, to four decimals.
#[test]
fn code_ross_frequencies_at_rest() {
    let modes = reference().modes(0.0).unwrap();
    let lateral: Vec<f64> = modes.iter().filter(|m| m.whirl != Whirl::Axial).map(|m| m.frequency_hz).collect();
    for (pair, expected) in lateral.chunks(2).zip([291.4790, 967.0460, 1345.0462, 1673.5635]) {
        pair.iter().for_each(|&found| close(found, expected));
    }
}

/// Printed by ROSS 2.3.0 at 1500 rad/s, backward and forward.
#[test]
fn code_ross_frequencies_at_speed() {
    for speed in [1500.0, -1500.0] {
        let modes = reference().modes(speed).unwrap();
        let of = |whirl: Whirl| modes.iter().filter(move |m| m.whirl == whirl).map(|m| m.frequency_hz);
        of(Whirl::Backward).zip([290.9332, 896.1496, 1334.4261]).for_each(|(a, b)| close(a, b));
        of(Whirl::Forward).zip([292.0231, 1028.4173, 1355.0822]).for_each(|(a, b)| close(a, b));
        assert!(of(Whirl::Forward).count() >= 3 && of(Whirl::Backward).count() >= 3);
    }
}

/// A free slender beam: β l = 4.730041 and 7.853205 of Euler and Bernoulli, and four rigid motions of the planes and
/// one along the axis that have no frequency.
#[test]
fn limit_free_slender_beam() {
    let material = Material::new(210e9, 0.3, 7850.0);
    let section = Section::solid(0.01);
    let (length, count) = (2.0, 24);
    let element = Element { length: length / f64::from(count), start: section, end: section, material };
    let shaft = Shaft::new(vec![element; count as usize], Vec::new()).unwrap();
    let modes = linear(shaft, &[]).modes(0.0).unwrap();
    let wave = (material.young * section.second_moment() / (material.density * section.area())).sqrt();
    for (pair, product) in modes.chunks(2).zip([4.730_041, 7.853_205]) {
        let expected = (product / length).powi(2) * wave / std::f64::consts::TAU;
        for mode in pair {
            assert!((mode.frequency_hz / expected - 1.0).abs() < 2e-4, "{} {expected}", mode.frequency_hz);
        }
    }
}

/// Without damping the eigenvalues are imaginary, gyroscopic moments or not.
#[test]
fn identity_gyroscopic_moments_take_no_energy() {
    for mode in reference().modes(2500.0).unwrap() {
        assert!(mode.damping_ratio.abs() < 1e-8, "{mode:?}");
    }
}
