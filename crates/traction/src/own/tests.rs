#[path = "../../examples/film_law/mod.rs"]
mod film_law;

use super::*;
use crate::{
    Coating, CoatingLaw, Kragelskii, Law, Patch, PatchLaw, PatchRule, PressureChoice, RelativeMotion, TractionLaw,
    fast_patch_traction, linear_patch_traction, patch_traction,
};
use film_law::Film;
use num_dual::Dual64;

/// The silver coating's law handed in as one's own.
#[derive(Debug)]
struct Silver(CoatingLaw);

struct SilverCurve {
    at: Kragelskii,
    slope: Kragelskii,
}

impl CustomLaw for Silver {
    type Curve = SilverCurve;
    fn under(&self, &Conditions { pressure, .. }: &Conditions) -> SilverCurve {
        let curves = self.0.kragelskii(pressure).zip(self.0.kragelskii_slope(pressure));
        let (at, slope) = curves.expect("a coating has a curve");
        SilverCurve { at, slope }
    }
}

impl CustomCurve for SilverCurve {
    #[inline(always)]
    fn over_slip<N: CurveNumber>(&self, slip: N) -> OverSlip<N> {
        let (Kragelskii { a, b, c }, change) = (self.at, self.slope);
        let x = slip * c;
        let e = (-x).max(-700.0).exp_m1();
        let (decay, ratio) = (e + 1.0, e / x);
        OverSlip {
            value: decay * b + ratio * (a * c),
            slope: decay * (slip * (-b * c) + (b - a * c)),
            by_pressure: decay * (slip * (-change.c * b) + (change.b - change.c * a)) + ratio * (change.a * c),
            by_entrainment: None,
        }
    }
}

fn contact(sense: f64) -> MovingPatch {
    let patch = Patch {
        semi_lateral: 3e-3,
        semi_rolling: 0.4e-3,
        peak_pressure: 2.2e9,
        ball_radius: 0.015,
        surface_radius: 0.0153,
    };
    let motion = RelativeMotion { rolling: 0.3, lateral: 0.1, spin: 200.0, about_lateral: -2.0, about_rolling: 1.0 };
    MovingPatch { patch, motion, rolling_speed: 60.0 * sense }
}

fn rule() -> FastPatch {
    FastPatch::new(PatchRule::GaussJacobi { radial: 4, angles: 12 }).unwrap()
}

fn patch_law(law: &Law) -> PatchLaw<'_, Law> {
    PatchLaw { law, slip_unit: SlipUnit::MeterPerSecond, pressure: PressureChoice::Peak }
}

/// Value and derivative of a law of one's own are those of the same curve built in.
#[test]
fn identity_a_custom_law_equals_the_coating_that_it_copies() {
    let coating = CoatingLaw::varying(&Coating::library("ag").unwrap(), 2).unwrap();
    let laws = [Law::from(coating.clone()), Law::custom(Silver(coating))];
    let contact = contact(1.0);
    let [a, b] = laws.each_ref().map(|law| patch_law(law).fast_derivative(&contact, &rule()).unwrap());
    let size = a.traction.force_rolling.abs();
    assert!((a.traction.force_rolling - b.traction.force_rolling).abs() < 1e-13 * size);
    assert!((a.by_load.force_rolling / b.by_load.force_rolling - 1.0).abs() < 1e-12, "{a:?} {b:?}");
    for (a, b) in a.by_motion.as_flattened().iter().zip(b.by_motion.as_flattened()) {
        assert!((a - b).abs() < 1e-11 * a.abs(), "{a} {b}");
    }
    let MovingPatch { patch, motion, rolling_speed } = contact;
    let value = fast_patch_traction(&rule(), &patch, &motion, rolling_speed, &patch_law(&laws[1]));
    assert!((value.force_rolling - a.traction.force_rolling).abs() < 1e-13 * size);
}

/// The lanes against the generic integral on dual numbers, node by node.
#[test]
fn identity_a_custom_law_in_lanes_against_the_generic_integral() {
    let law = Law::custom(Film { temperature: 340.0 });
    let law = patch_law(&law);
    for sense in [1.0, -1.0] {
        let MovingPatch { patch, motion, rolling_speed } = contact(sense);
        let plain = Dual64::from;
        // Load, then speed, then motion: the ellipse grows with the cube root of the load.
        for input in 0..3 {
            let one = |which: usize, value: f64| if which == input { plain(value).derivative() } else { plain(value) };
            let grown = one(0, 0.0) / 3.0 + 1.0;
            let patch = Patch {
                semi_lateral: grown * patch.semi_lateral,
                semi_rolling: grown * patch.semi_rolling,
                peak_pressure: grown * patch.peak_pressure,
                ball_radius: patch.ball_radius,
                surface_radius: patch.surface_radius,
            };
            let motion = RelativeMotion {
                rolling: one(2, motion.rolling),
                lateral: plain(motion.lateral),
                spin: plain(motion.spin),
                about_lateral: plain(motion.about_lateral),
                about_rolling: plain(motion.about_rolling),
            };
            let speed = one(1, rolling_speed);
            let exact = patch_traction(&patch, &motion, speed, &law, rule().quadrature());
            let fast = linear_patch_traction(&rule(), &patch, &motion, speed, &law);
            let pairs = [
                (exact.force_rolling, fast.force_rolling),
                (exact.force_lateral, fast.force_lateral),
                (exact.moment_normal, fast.moment_normal),
            ];
            for (exact, fast) in pairs {
                assert!((exact.re - fast.re).abs() < 1e-12 * exact.re.abs(), "{input}: {exact} {fast}");
                assert!((exact.eps - fast.eps).abs() < 1e-10 * exact.eps.abs(), "{input}: {exact} {fast}");
            }
        }
    }
}

/// A warmer film is thinner of shear; a faster one thicker.
#[test]
fn limit_a_custom_film_slides_more_easily_when_warm_and_fast() {
    let friction = |temperature: f64, speed: f64| {
        let law = Law::custom(Film { temperature });
        let MovingPatch { patch, motion, .. } = contact(1.0);
        fast_patch_traction(&rule(), &patch, &motion, speed, &patch_law(&law)).force_rolling.abs()
    };
    assert!(friction(360.0, 60.0) < friction(340.0, 60.0) && friction(340.0, 90.0) < friction(340.0, 60.0));
}

/// Every function of the lanes against that of one double.
#[test]
fn identity_lanes_have_the_functions_of_a_double() {
    use fearless_simd::{Level, dispatch};
    fn all<N: CurveNumber>(x: N) -> [N; 9] {
        [
            x.sqrt(),
            x.exp(),
            x.exp_m1(),
            x.ln(),
            x.max(0.3).min(2.0),
            x.below(0.5, -x, x - 1.0),
            x.map(f64::sin),
            x.fused(x.constant(2.0), x / 3.0),
            (x + 1.0) / x * x - x,
        ]
    }
    for k in -200..=200 {
        let x = (0.7 * f64::from(k)).exp().min(600.0);
        let lanes = dispatch!(Level::new(), simd => {
            let all = all(Eight(Lanes::splat(simd, x)));
            let mut firsts = [0.0; 9];
            for (first, Eight(lanes)) in firsts.iter_mut().zip(all) {
                *first = lanes[0];
            }
            firsts
        });
        for (k, (ours, plain)) in lanes.into_iter().zip(all(x)).enumerate() {
            assert!((ours - plain).abs() <= 5e-16 * plain.abs(), "{k} of {x:e}: {ours} {plain}");
        }
    }
}
