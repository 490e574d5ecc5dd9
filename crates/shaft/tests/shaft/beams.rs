//! Deflections against formulas.

use crate::support::on_springs;
use tribodyn_shaft::{Element, Material, Section, Shaft};

const FORCE: f64 = 1000.0;

fn shaft(section: Section, length: f64, count: u32) -> Shaft {
    let material = Material::new(210e9, 0.3, 7850.0);
    let element = Element { length: length / f64::from(count), start: section, end: section, material };
    Shaft::new(vec![element; count as usize], Vec::new()).unwrap()
}

/// A pinned beam with a force in the middle, with shear: F L³/48EI + F L/4κGA.
#[test]
fn limit_pinned_beam_with_shear() {
    let (section, length) = (Section { outer: 0.06, inner: 0.03 }, 0.3);
    let shaft = shaft(section, length, 6);
    let mut load = vec![[0.0; 5]; 7];
    load[3][1] = FORCE;
    let pin = [1e15, 1e15, 1e15, 0.0, 0.0];
    let moved = on_springs(shaft, &[(0, pin), (6, pin)], load).equilibrium().unwrap().nodes;
    let (e, g) = (210e9, 210e9 / 2.6);
    let expected = FORCE * length.powi(3) / (48.0 * e * section.second_moment())
        + FORCE * length / (4.0 * section.shear_coefficient(0.3) * g * section.area());
    assert!((moved[3][1] / expected - 1.0).abs() < 1e-7, "{} {expected}", moved[3][1]);
    // y falls off towards +z beyond the middle: the tilt about X is −dy/dz.
    assert!(moved[4][3] > 0.0 && moved[4][1] < moved[3][1]);
}

/// A cantilever in the plane x–z: F L³/3EI + F L/κGA, slope θ_y = F L²/2EI.
#[test]
fn limit_cantilever() {
    let (section, length) = (Section::solid(0.04), 0.2);
    let shaft = shaft(section, length, 4);
    let mut load = vec![[0.0; 5]; 5];
    load[4][0] = FORCE;
    let moved = on_springs(shaft, &[(0, [1e16; 5])], load).equilibrium().unwrap().nodes;
    let (e, g, i) = (210e9, 210e9 / 2.6, section.second_moment());
    let expected =
        FORCE * length.powi(3) / (3.0 * e * i) + FORCE * length / (section.shear_coefficient(0.3) * g * section.area());
    assert!((moved[4][0] / expected - 1.0).abs() < 1e-7);
    assert!((moved[4][4] / (FORCE * length.powi(2) / (2.0 * e * i)) - 1.0).abs() < 1e-7);
}

/// A cone under axial force: F L/(E π d₁ d₂/4); elements with mean areas come to it with the square of their length.
#[test]
fn limit_cone_under_axial_force() {
    let (large, small, length, count) = (Section::solid(0.06), Section::solid(0.03), 0.3, 32u32);
    let material = Material::new(210e9, 0.3, 7850.0);
    let share = |k: u32| f64::from(k) / f64::from(count);
    let elements = (0..count).map(|k| Element {
        length: length / f64::from(count),
        start: large.towards(&small, share(k)),
        end: large.towards(&small, share(k + 1)),
        material,
    });
    let shaft = Shaft::new(elements.collect(), Vec::new()).unwrap();
    let mut load = vec![[0.0; 5]; count as usize + 1];
    load[count as usize][2] = FORCE;
    let moved = on_springs(shaft, &[(0, [1e16; 5])], load).equilibrium().unwrap().nodes;
    let expected = FORCE * length / (210e9 * std::f64::consts::FRAC_PI_4 * 0.06 * 0.03);
    assert!((moved[count as usize][2] / expected - 1.0).abs() < 2e-4);
}
