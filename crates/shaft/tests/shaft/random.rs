//! Random shafts solve or say why.

use tribodyn_bearing::{Bearing, BearingSpec, Dimensions, Fit, Geometry, Modelling, RaceControl, RingCentre};
use tribodyn_contact::ElasticBody;
use tribodyn_shaft::{Element, Material, RestingBearing, Seat, Section, Shaft, ShaftError, Support, System};

/// Numbers from 0 to 1 that are the same in every run: a linear congruential generator of Knuth's.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.next() * (high - low)
    }

    fn chance(&mut self, share: f64) -> bool {
        self.next() < share
    }
}

fn bearing(numbers: &mut Numbers, bore: f64, deep_groove: bool) -> Bearing {
    let ball = bore * numbers.between(0.2, 0.35);
    let pitch = bore + 2.2 * ball;
    let most = (std::f64::consts::PI * pitch / ball / 1.15).floor();
    let fit = if deep_groove {
        Fit::RadialClearance(bore * numbers.between(-5e-5, 8e-4))
    } else {
        Fit::ContactAngle(numbers.between(15.0, 40.0).to_radians())
    };
    let geometry = Geometry::new(Dimensions {
        ball_count: (most * if deep_groove { 0.62 } else { 1.0 }) as usize,
        ball_diameter: ball,
        pitch_diameter: pitch,
        inner_coefficient: numbers.between(0.51, 0.53),
        outer_coefficient: numbers.between(0.515, 0.54),
        fit,
    });
    let modelling = Modelling {
        race_control: Some(RaceControl::Outer),
        centrifugal_at_free_pitch: Some(true),
        ..Modelling::with_traction(numbers.chance(0.3), RingCentre::Displaced)
    };
    let steel = ElasticBody { young: 208e9, poisson: 0.3 };
    Bearing::new(BearingSpec::new(geometry.unwrap(), (steel, 7800.0), modelling)).unwrap()
}

/// Where a bearing stands: node, side, offset, spring of a ring that slides.
type SeatSpec = (usize, bool, f64, Option<f64>);

/// A locating bearing and others that slide, or angular-contact bearings pressed together, on a random shaft.
fn random(
    numbers: &mut Numbers,
    bearings: &[Bearing],
    deep_groove: bool,
    bore: f64,
) -> (Shaft, Vec<SeatSpec>, Vec<[f64; 5]>) {
    let count = 6 + (numbers.next() * 10.0) as usize;
    let material = Material::new(210e9, 0.3, 7850.0);
    let elements: Vec<Element> = (0..count)
        .map(|_| {
            let outer = bore * numbers.between(0.9, 1.6);
            let section = |outer: f64, share: f64| Section { outer, inner: share * outer };
            let share = if numbers.chance(0.4) { numbers.between(0.1, 0.7) } else { 0.0 };
            let end = outer * numbers.between(0.9, 1.1);
            Element {
                length: bore * numbers.between(0.3, 1.5),
                start: section(outer, share),
                end: section(end, share),
                material,
            }
        })
        .collect();
    let shaft = Shaft::new(elements, Vec::new()).unwrap();
    let spread = bearings.len();
    let supports = (0..spread)
        .map(|k| {
            let node = 1 + k * (count - 2) / (spread - 1);
            let play = bearings[k].geometry.axial_play();
            match deep_groove {
                true => (node, true, -0.5 * play, (k > 0).then(|| if numbers.chance(0.5) { 0.0 } else { 100.0 })),
                false => (node, 2 * k < spread, numbers.between(-2e-6, 1.5e-5), None),
            }
        })
        .collect();
    let mut loads = vec![[0.0; 5]; count + 1];
    let size = 2e6 * bore * bore;
    for _ in 0..3 {
        let node = (numbers.next() * (count + 1) as f64) as usize;
        for (part, share) in loads[node].iter_mut().zip([1.0, 1.0, 0.3]) {
            *part += share * size * numbers.between(-1.0, 1.0);
        }
    }
    (shaft, supports, loads)
}

/// A hundred shafts: what solves is in balance to 1e-9, and the rest lacks resistance. None ends without either.
#[test]
fn identity_a_hundred_random_shafts_solve_or_say_why() {
    let mut numbers = Numbers(20_251_125);
    let (mut solved, mut loose, mut steps) = (0, 0, 0);
    for case in 0..100 {
        let bore = numbers.between(0.01, 0.1);
        let deep_groove = numbers.chance(0.5);
        let count = 2 + (numbers.next() * 3.0) as usize;
        let bearings: Vec<Bearing> = (0..count).map(|_| bearing(&mut numbers, bore, deep_groove)).collect();
        let (shaft, places, loads) = random(&mut numbers, &bearings, deep_groove, bore);
        let soft = numbers.chance(0.3);
        let supports = places.iter().zip(&bearings).map(|(&(node, carries_plus_z, offset, slides), bearing)| {
            let k = [2e8, 2e8, 1e8, 1e5, 1e5];
            let stiffness = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { k[i] } else { 0.0 }));
            let seat = Seat { stiffness: soft.then_some(stiffness), slides, ..Seat::default() };
            let ring = Box::new(RestingBearing { bearing, first_ball: 0.3 });
            Support { node, carries_plus_z, offset, ring, seat }
        });
        let mut system = System { shaft, supports: supports.collect(), housing: None, loads };
        match system.equilibrium() {
            Ok(found) => {
                assert!(found.residual < 1e-9 && found.unbalanced < 1e-9, "{case}: {found:?}");
                (solved, steps) = (solved + 1, steps + found.steps);
            }
            Err(ShaftError::Loose { .. }) => loose += 1,
            Err(other) => panic!("shaft {case}, {count} bearings, deep groove {deep_groove}, soft {soft}: {other}"),
        }
    }
    assert!(solved >= 95, "{solved} solved, {loose} without resistance");
    assert!(steps / solved < 100, "{} steps each", steps / solved);
}
