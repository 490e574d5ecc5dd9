//! The closed-form derivative against dual numbers through the generic integral.

use crate::contacts::{Contact, SCALES, contacts, silver};
use num_dual::{Dual64, DualNum};
use tribodyn_traction::{
    CoatingLaw, FastPatch, Patch, PatchDerivative, PatchLaw, PatchRule, PatchTraction, PressureChoice, Quadrature,
    RelativeMotion, SlipUnit, TractionLaw, patch_traction,
};

/// Variables of the derivative: five components of the motion, the load and the rolling speed.
const INPUTS: usize = 7;

fn outputs<D: Copy>(t: &PatchTraction<D>) -> [D; 7] {
    [t.force_rolling, t.force_lateral, t.moment_normal, t.moment_lateral, t.moment_rolling, t.power, t.wear_integral]
}

fn law(law: &CoatingLaw, unit: SlipUnit) -> PatchLaw<'_, CoatingLaw> {
    PatchLaw { law, slip_unit: unit, pressure: PressureChoice::Peak }
}

/// Derivatives of the outputs by input `k`, by dual numbers.
fn dual(contact: &Contact, law: &PatchLaw<'_, CoatingLaw>, quadrature: &Quadrature, k: usize) -> [f64; 7] {
    let m = &contact.motion;
    let load = contact.load();
    let mut x =
        [m.rolling, m.lateral, m.spin, m.about_lateral, m.about_rolling, load, contact.rolling_speed].map(Dual64::from);
    x[k].eps = 1.0;
    let [rolling, lateral, spin, about_lateral, about_rolling, load_now, rolling_speed] = x;
    let growth = (load_now / load).powf(1.0 / 3.0);
    let Patch { semi_lateral, semi_rolling, peak_pressure, ball_radius, surface_radius } = contact.patch;
    let patch = Patch {
        semi_lateral: growth * semi_lateral,
        semi_rolling: growth * semi_rolling,
        peak_pressure: growth * peak_pressure,
        ball_radius,
        surface_radius,
    };
    let motion = RelativeMotion { rolling, lateral, spin, about_lateral, about_rolling };
    outputs(&patch_traction(&patch, &motion, rolling_speed, law, quadrature)).map(|d| d.eps)
}

fn closed_form(contact: &Contact, law: &PatchLaw<'_, CoatingLaw>, fast: &FastPatch) -> PatchDerivative {
    let p = contact.patch.peak_pressure;
    let curve = (&law.law.kragelskii(p).unwrap(), &law.law.kragelskii_slope(p).unwrap());
    fast.derivative(&contact.patch, &contact.motion, contact.rolling_speed, curve, law.slip_unit)
}

fn column(d: &PatchDerivative, k: usize) -> [Option<f64>; 7] {
    match k {
        5 => outputs(&d.by_load).map(Some),
        6 => outputs(&d.by_rolling_speed).map(Some),
        _ => std::array::from_fn(|i| d.by_motion.get(i).map(|row| row[k])),
    }
}

/// Largest difference of the two, in units of the largest derivative of like dimension in the column: forces, moments
/// about the axes in the surface, and each of the others by itself.
fn worst(
    contact: &Contact,
    law: &PatchLaw<'_, CoatingLaw>,
    fast: &FastPatch,
    quadrature: &Quadrature,
    inputs: std::ops::Range<usize>,
) -> f64 {
    let d = closed_form(contact, law, fast);
    let mut worst = 0.0f64;
    for k in inputs {
        let exact = dual(contact, law, quadrature, k);
        // By the load: the integrals over it, since their derivatives may vanish.
        let of = if k == 5 { outputs(&d.traction).map(|t| t / contact.load()) } else { exact };
        let (a, r) = (contact.patch.semi_lateral, contact.patch.ball_radius);
        let force = of[0].hypot(of[1]).max(of[2].abs() / a);
        let speed = (d.traction.wear_integral / contact.load()).max(0.1);
        let sizes = [force, force, force * a, force * r, force * r, force * speed, of[6]];
        for i in 0..7 {
            if let Some(ours) = column(&d, k)[i] {
                let difference = (ours - exact[i]).abs();
                worst = worst.max(if difference == 0.0 { 0.0 } else { difference / sizes[i].abs() });
            }
        }
    }
    worst
}

const UNITS: [fn(f64) -> SlipUnit; 2] = [
    |per_m_s| SlipUnit::Scaled { per_m_s },
    |per_m_s| if per_m_s > 10.0 { SlipUnit::PerMilleOfRolling } else { SlipUnit::PercentOfRolling },
];

#[test]
fn identity_derivative_of_fixed_nodes_equals_dual_numbers() {
    let silver = silver();
    for rule in [
        PatchRule::PolarMidpoint { radial: 10, circumferential: 40 },
        PatchRule::GaussJacobi { radial: 4, angles: 12 },
        PatchRule::GaussJacobi { radial: 3, angles: 7 },
    ] {
        let fast = FastPatch::new(rule).unwrap();
        let mut largest = 0.0f64;
        for contact in SCALES.into_iter().flat_map(contacts) {
            for unit in UNITS {
                let law = law(&silver, unit(contact.scale));
                largest = largest.max(worst(&contact, &law, &fast, fast.quadrature(), 0..INPUTS));
            }
        }
        println!("{rule:?}: {largest:.1e}");
        assert!(largest < 1e-10, "{rule:?}: {largest:e}");
    }
}

#[test]
fn identity_derivative_on_strips_approaches_that_of_the_integral() {
    let silver = silver();
    let fine = Quadrature::new(PatchRule::SplitStrip { across: 40, along: 40 }).unwrap();
    for (across, along, limits) in [(8, 3, [2e-2, 2e-1]), (10, 7, [1e-2, 1e-1]), (32, 28, [1e-5, 1e-2])] {
        let fast = FastPatch::new(PatchRule::SplitStrip { across, along }).unwrap();
        for (scale, limit) in [1.0, 22.0].into_iter().zip(limits) {
            let by = |inputs: std::ops::Range<usize>| {
                let unit = SlipUnit::Scaled { per_m_s: scale };
                contacts(scale)
                    .iter()
                    .fold(0.0f64, |w, c| w.max(worst(c, &law(&silver, unit), &fast, &fine, inputs.clone())))
            };
            let (motion, load) = (by(0..5), by(5..6));
            println!("SplitStrip {across} x {along}, {scale} per m/s: by motion {motion:.1e}, by load {load:.1e}");
            assert!(motion < limit && load < limit, "{across} x {along}, {scale}: {motion:e} {load:e}");
        }
    }
}

#[test]
fn identity_stiffness_is_symmetric_and_damps_where_the_curve_rises() {
    let silver = silver();
    let fast = FastPatch::new(PatchRule::SplitStrip { across: 8, along: 3 }).unwrap();
    for contact in contacts(1.0) {
        let d = closed_form(&contact, &law(&silver, SlipUnit::MeterPerSecond), &fast).by_motion;
        // Symmetric once every motion is measured as a speed.
        let sizes = [1.0, 1.0, contact.patch.semi_lateral, contact.patch.ball_radius, contact.patch.ball_radius];
        let at = |i: usize, j: usize| d[i][j] / (sizes[i] * sizes[j]);
        let largest = (0..25).fold(0.0f64, |m, k| m.max(at(k / 5, k % 5).abs()));
        for k in 0..25 {
            assert!((at(k / 5, k % 5) - at(k % 5, k / 5)).abs() < 1e-14 * largest);
        }
        // The slip stays below the curve's peak here: every motion loses power to its own force.
        for i in 0..200 {
            let v: [f64; 5] = std::array::from_fn(|k| (f64::from(i) * (1.7 + 0.9 * k as f64) + k as f64).sin());
            let power: f64 = (0..25).map(|k| v[k / 5] * at(k / 5, k % 5) * v[k % 5]).sum();
            assert!(power < 1e-14 * largest, "{power:e}");
        }
    }
}

#[test]
fn limit_derivative_at_rest_is_the_initial_slope() {
    let silver = silver();
    let fast = FastPatch::new(PatchRule::GaussJacobi { radial: 4, angles: 12 }).unwrap();
    let mut contact = contacts(1.0).swap_remove(0);
    contact.motion = RelativeMotion { rolling: 0.0, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 };
    let law = law(&silver, SlipUnit::MeterPerSecond);
    let d = closed_form(&contact, &law, &fast);
    let slope = law.law.at(contact.patch.peak_pressure).initial_slope() * contact.load();
    assert!((d.by_motion[0][0] + slope).abs() < 1e-12 * slope && (d.by_motion[1][1] + slope).abs() < 1e-12 * slope);
    assert!(d.by_motion.iter().flatten().all(|x| x.is_finite()) && d.by_load.force_rolling == 0.0);
}
