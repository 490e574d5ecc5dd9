//! Tests of the film law, for any oil.

use super::*;
use crate::{FastPatch, PatchDerivative, PatchRule};
use tribodyn_lubricant::{BaseStock, PressureViscosity};

const STEEL_BODY: ElasticBody = ElasticBody { young: 208e9, poisson: 0.3 };

pub(super) fn rule(radial: usize, angles: usize) -> Quadrature {
    Quadrature::new(PatchRule::GaussJacobi { radial, angles }).unwrap()
}

/// The inner contact of a 6206.
pub(super) fn law(shear: FilmShear) -> FilmLaw {
    let oil = BaseStock::Mineral.oil(68.0, None).unwrap();
    let temperature = 343.15;
    let inlet = InletFilm::new(&oil, temperature, 1.0, 0.07e-6).unwrap();
    FilmLaw::new((oil, temperature, inlet), (shear, 0.12), [3.776e-3, 0.1238], [STEEL_BODY; 2]).unwrap()
}

pub(super) const EYRING: FilmShear = FilmShear::Eyring { stress: 5e6 };

/// Rolling at 3.46 m/s with some slip and spin, under 555 N.
pub(super) fn contact(slip: f64, spin: f64) -> MovingPatch {
    let ball_radius = 4.7625e-3;
    let about_lateral = -1500.0;
    MovingPatch {
        patch: Patch {
            semi_lateral: 1.26e-3,
            semi_rolling: 0.134e-3,
            peak_pressure: 1.57e9,
            ball_radius,
            surface_radius: 4.85e-3,
        },
        motion: RelativeMotion {
            rolling: slip - about_lateral * ball_radius,
            lateral: 0.3 * slip,
            spin,
            about_lateral,
            about_rolling: 4.0,
        },
        rolling_speed: 3.46,
    }
}

/// T/Q of a patch at 1 GPa that slides evenly at 0.05 m/s over 0.3 µm, 0.02 Pa s, without heat and flexibility.
fn even_sliding(shear: FilmShear, pressure: PressureViscosity, limiting: f64, gap: f64, slip: f64) -> f64 {
    let stress = FilmStress {
        shear,
        pressure,
        log_ambient: 0.02f64.ln(),
        stiffness: pressure.stiffness(0.02),
        limiting,
        boundary_friction: 0.12,
    };
    let shearing = Shearing { stress, gap, creep: 1e-30, share: 0.0 };
    let still = contact(0.0, 0.0);
    let contact = MovingPatch {
        patch: Patch { peak_pressure: 1e9, surface_radius: f64::INFINITY, ..still.patch },
        motion: RelativeMotion { rolling: slip, lateral: 0.0, spin: 0.0, about_lateral: 0.0, about_rolling: 0.0 },
        rolling_speed: 1.0,
    };
    let traction = integrate(&shearing, &contact, &rule(400, 4));
    -traction.force_rolling / contact.load()
}

/// Values worked out beside this program. Barus' exponential at 1 GPa is the trap: twice the load.
#[test]
fn code_traction_over_load_of_even_sliding() {
    let barus = PressureViscosity::Barus { coefficient: 15e-9 };
    let of = |shear, pressure, limiting| even_sliding(shear, pressure, limiting, 0.3e-6, 0.05);
    let newton = of(FilmShear::LimitingShear, barus, 1e9);
    let c = 15.0f64;
    let closed = 0.02 * 0.05 / 0.3e-6 * 3.0 * ((c - 1.0) * c.exp() + 1.0) / (c * c * 1e9);
    assert!((newton / closed - 1.0).abs() < 1e-6 && (newton - 2.03406).abs() < 1e-5, "{newton} {closed}");
    let limited = of(FilmShear::LimitingShear, barus, 0.07);
    assert!((limited - 0.054616).abs() < 1e-6, "{limited}");
    let eyring = of(EYRING, barus, 1e9);
    assert!((eyring - 0.028916).abs() < 1e-6, "{eyring}");
    let roelands = of(FilmShear::LimitingShear, PressureViscosity::Roelands { index: 0.6 }, 0.07);
    assert!((roelands - 0.035973).abs() < 1e-6, "{roelands}");
}

#[test]
fn limit_slow_fast_thick_and_unpressed() {
    let roelands = PressureViscosity::Roelands { index: 0.6 };
    let of = |shear, gap, slip| even_sliding(shear, roelands, 0.07, gap, slip);
    for shear in [FilmShear::LimitingShear, EYRING] {
        // Newton: traction in proportion to slip; then all of it at the limit; nothing across a thick film.
        let (slow, slower) = (of(shear, 0.3e-6, 1e-8), of(shear, 0.3e-6, 1e-9));
        assert!((slow / slower / 10.0 - 1.0).abs() < 1e-2, "{slow} {slower}");
        let fast = of(shear, 0.3e-6, if shear == EYRING { 1e30 } else { 1e9 });
        assert!((fast - 0.07).abs() < 1e-9, "{fast}");
        assert!(of(shear, 1e3, 0.05) < 1e-6);
        assert!(of(shear, 0.3e-6, 0.05) < 0.07);
    }
    let law = law(EYRING);
    let pressed = contact(0.05, 0.0);
    let unpressed = MovingPatch { patch: Patch { peak_pressure: 0.0, ..pressed.patch }, ..pressed };
    assert_eq!(law.traction(&unpressed, &rule(8, 12)), PatchTraction::zero());
    assert_eq!(law.derivative(&unpressed, &FastPatch::of(rule(8, 12))), PatchDerivative::zero());
    let light = MovingPatch { patch: Patch { peak_pressure: 1e3, ..pressed.patch }, ..pressed };
    // What is left is the rolling resistance of its inlet.
    assert!(law.traction(&light, &rule(8, 12)).force_rolling.abs() < 1e-3);
}

/// Force and moment take from the relative motion what friction and inlet turn into heat, and friction never drives.
#[test]
fn identity_power_is_the_work_of_the_traction() {
    for shear in [FilmShear::LimitingShear, EYRING] {
        let law = law(shear);
        for (slip, spin) in [(0.0, 0.0), (0.02, 0.0), (-0.5, 30.0), (3.0, -200.0)] {
            let contact = contact(slip, spin);
            let traction = law.traction(&contact, &rule(10, 16));
            let work = traction.work_on(&contact.motion);
            assert!((work + traction.power).abs() < 1e-10 * traction.power, "{work} {}", traction.power);
            let rolled = 2.0 * law.rolling_resistance(&contact) * contact.rolling_speed;
            assert!(traction.power >= rolled && rolled > 0.0);
        }
    }
}

/// Bodies that give back the share 1 − α of the pressure behind the middle: the moment is α times that of half of
/// Hertz's pressure about the lateral axis, it turns against rolling, and nothing is lost where nothing rolls.
#[test]
fn limit_hysteresis_is_the_moment_of_half_the_pressure() {
    let law = law(EYRING);
    let contact = contact(0.0, 0.0);
    let Patch { semi_lateral: a, semi_rolling: b, peak_pressure, .. } = contact.patch;
    let n = 400;
    let mut half = 0.0;
    for i in 0..n {
        let x = (f64::from(i) + 0.5) / f64::from(n);
        // Across rolling the pressure is a half ellipse: its area is known.
        half += peak_pressure * 0.5 * PI * a * (1.0 - x * x) * x * b * b / f64::from(n);
    }
    let found = law.hysteresis_moment(&contact);
    assert!((found / (law.hysteresis * half) - 1.0).abs() < 1e-5, "{found} {half}");
    let lossless = FilmLaw { hysteresis: 0.0, ..law.clone() };
    let rolled = |at: &MovingPatch| {
        let [[_, with, heat], [_, without, cold]] = [&law, &lossless].map(|law| law.rolling_loads(at));
        [with - without, heat - cold]
    };
    let [moment, power] = rolled(&contact);
    let turning = contact.motion.about_lateral;
    assert!(
        (moment + found * turning.signum()).abs() < 1e-7 * found && (power + moment * turning).abs() < 1e-9 * power
    );
    let still = RelativeMotion { about_lateral: 0.0, ..contact.motion };
    assert_eq!(rolled(&MovingPatch { motion: still, ..contact }), [0.0; 2]);
}

/// A disc machine's traction at 1 GPa, 40 °C and some percent of slip is the limiting shear that the library has of
/// the stock. The limiting law bears that; Eyring's stress of 5 MPa half of it.
#[test]
fn limit_the_friction_of_a_disc_machine() {
    let oil = BaseStock::Mineral.oil(68.0, None).unwrap();
    let friction = |shear| {
        let pressure = oil.pressure;
        let ambient = oil.dynamic(313.15_f64);
        let stress = FilmStress {
            shear,
            pressure,
            log_ambient: ambient.ln(),
            stiffness: pressure.stiffness(ambient),
            limiting: oil.limiting_shear,
            boundary_friction: 0.12,
        };
        // 5 % of 2 m/s over half a micrometre.
        Shearing { stress, gap: 0.5e-6, creep: 1e-30, share: 0.0 }.over_speed(0.67e9, 0.1) * 0.1 / 0.67e9
    };
    let limiting = friction(FilmShear::LimitingShear);
    assert!((0.8..1.0).contains(&(limiting / oil.limiting_shear)), "{limiting}");
    let eyring = friction(EYRING);
    assert!((0.3..0.6).contains(&(eyring / oil.limiting_shear)), "{eyring}");
}

/// The film is as much warmer than its surroundings as its heat makes it.
#[test]
fn identity_the_temperature_is_a_fixed_point() {
    let law = law(EYRING);
    for (slip, rise) in [(0.001, 0.01..3.0), (1.0, 10.0..150.0), (8.0, 50.0..400.0)] {
        let contact = contact(slip, 0.0);
        let settled = law.settled(&contact, &rule(10, 16));
        assert!(settled.rounds <= 10, "{} rounds", settled.rounds);
        let sheared = integrate(&law.shearing(&contact, settled.temperature), &contact, &rule(10, 16));
        let gap = law.gap(law.state(&contact).thickness.central);
        let heated = law.temperature + law.heating(&contact, gap) * sheared.power;
        assert!((heated - settled.temperature).abs() < 1e-8, "{heated} {}", settled.temperature);
        assert!(rise.contains(&(settled.temperature - law.temperature)), "{slip}: {}", settled.temperature);
    }
}

/// A film like those of bearings: some tenths of a micrometre, friction far below Newton's at this pressure.
#[test]
fn limit_a_film_of_a_6206_is_one_of_an_engineer() {
    let law = law(EYRING);
    let contact = contact(0.05, 0.0);
    let state = law.state(&contact);
    assert!((0.1e-6..0.5e-6).contains(&state.thickness.central), "{:e}", state.thickness.central);
    assert!((1.0..5.0).contains(&state.lambda_ratio), "{}", state.lambda_ratio);
    let traction = law.traction(&contact, &rule(10, 16));
    let friction = -traction.force_rolling / contact.load();
    assert!((0.01..0.07).contains(&friction), "{friction}");
    // Newton's friction at the Barus viscosity there would be thousands of loads.
    let stress = FilmStress::new(&law.oil, (EYRING, 0.12), law.temperature);
    assert!((10.0..1e5).contains(&stress.viscosity(1e9)), "{} Pa s", stress.viscosity(1e9));
}
