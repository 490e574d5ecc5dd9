//! Wear by strides against solutions in closed form.

use std::f64::consts::{PI, TAU};
use tribodyn_wear::{BallWear, CoatingLife, RaceWear, Raceway, WearError, WearRates};

const COATING: f64 = 10e-6;
const RADIUS: f64 = 0.07;
const SEMI: f64 = 2e-3;
const BALLS: usize = 13;

fn raceway() -> Raceway {
    Raceway::new(COATING, 0.0, RADIUS, &[]).unwrap()
}

fn life(loss: f64) -> CoatingLife {
    CoatingLife::new(raceway(), raceway(), loss).unwrap()
}

/// One ball at the azimuths of all balls, with a rate of its azimuth.
fn race(turning: bool, rate: impl Fn(f64) -> f64) -> RaceWear {
    let ball = |azimuth: f64| BallWear { azimuth, volume_rate: rate(azimuth), semi_lateral: SEMI };
    let along_orbit = (0..BALLS).map(|i| ball(TAU * i as f64 / BALLS as f64)).collect();
    RaceWear { along_orbit, ball_count: BALLS, turning }
}

type Answer = Result<WearRates, WearError>;

/// Volume per time of one ball that wears `depth_rate` off a whole track.
fn volume_rate(depth_rate: f64) -> f64 {
    depth_rate * TAU * RADIUS * 2.0 * SEMI / BALLS as f64
}

#[test]
fn limit_constant_even_wear_takes_thickness_over_rate_whatever_the_stride() {
    for loss in [1.0, 0.3, 0.01] {
        let mut life = life(loss);
        let mut strides = 0;
        while life.worn_through().is_none() {
            let rates = |_: &Raceway, _: &Raceway| -> Answer {
                Ok(WearRates { inner: race(true, |_| volume_rate(1e-12)), outer: race(false, |_| 0.0) })
            };
            life.advance(1e12, rates).unwrap();
            strides += 1;
        }
        assert!((life.elapsed() / (COATING / 1e-12) - 1.0).abs() < 1e-9, "{}", life.elapsed());
        assert_eq!(strides, (1.0 / loss).ceil() as usize);
        assert!(life.outer().is_pristine() && life.inner().thinnest() == 0.0);
    }
}

/// dd/dt = r (1 + d/h) gives t = (h/r) ln 2; Euler's method is of first order in the stride.
#[test]
fn limit_wear_that_speeds_up_converges_with_first_order() {
    let exact = COATING / 1e-12 * 2f64.ln();
    let error = |loss: f64| {
        let mut life = life(loss);
        while life.worn_through().is_none() {
            let rates = |inner: &Raceway, _: &Raceway| -> Answer {
                let rate = 1e-12 * (1.0 + inner.mean_depth() / COATING);
                Ok(WearRates { inner: race(true, |_| volume_rate(rate)), outer: race(false, |_| 0.0) })
            };
            life.advance(1e12, rates).unwrap();
        }
        life.elapsed() / exact - 1.0
    };
    let errors = [0.1, 0.05, 0.025].map(error);
    assert!(errors[2] > 0.0 && errors[2] < 0.01, "{errors:?}");
    for pair in errors.windows(2) {
        assert!((1.8..2.2).contains(&(pair[0] / pair[1])), "{errors:?}");
    }
}

#[test]
fn identity_a_turning_ring_wears_evenly_and_a_standing_one_where_it_is_loaded() {
    let load = |azimuth: f64| volume_rate(1e-12) * (1.0 + 0.9 * azimuth.cos());
    let mut life = life(0.2);
    let rates =
        |_: &Raceway, _: &Raceway| -> Answer { Ok(WearRates { inner: race(true, load), outer: race(false, load) }) };
    let stride = life.advance(1e12, rates).unwrap();
    let (inner, outer) = (life.inner(), life.outer());
    assert!((inner.volume() / outer.volume() - 1.0).abs() < 1e-12);
    assert!((inner.mean_depth() / outer.mean_depth() - 1.0).abs() < 1e-12);
    // 13 samples of a cosine have its mean.
    assert!((inner.volume() / (BALLS as f64 * volume_rate(1e-12) * stride.duration) - 1.0).abs() < 1e-12);
    assert!((inner.volume() / (inner.mean_depth() * TAU * RADIUS * 2.0 * SEMI) - 1.0).abs() < 1e-12);
    assert!((inner.at(0.0).depth / inner.at(PI).depth - 1.0).abs() < 1e-12);
    // Linear between balls: 1.9 at azimuth 0; at π, between two balls, 1 + 0.9 cos(π − π/13).
    let [top, bottom] = [0.01, PI].map(|azimuth| outer.at(azimuth).depth / inner.at(azimuth).depth);
    assert!((top - 1.9).abs() < 0.01, "{top}");
    assert!((bottom - (1.0 - 0.9 * (PI / 13.0).cos())).abs() < 0.01, "{bottom}");
    // The stride is limited by the deepest spot.
    assert!((outer.thinnest() / (0.8 * COATING) - 1.0).abs() < 1e-9, "{}", outer.thinnest());
    assert!(stride.outer_depth_rate > 1.85 * stride.inner_depth_rate && stride.outer_through.is_none());
}

#[test]
fn limit_stride_ends_at_the_longest_and_nothing_wears_without_rates() {
    let mut life = life(0.1);
    let none = |_: &Raceway, _: &Raceway| -> Answer {
        let empty = RaceWear { along_orbit: vec![], ball_count: BALLS, turning: true };
        Ok(WearRates { inner: empty, outer: race(false, |_| 0.0) })
    };
    let stride = life.advance(3600.0, none).unwrap();
    assert_eq!((stride.duration, life.elapsed()), (3600.0, 3600.0));
    assert!(life.inner().is_pristine() && life.outer().is_pristine());
    let slow = |_: &Raceway, _: &Raceway| -> Answer {
        Ok(WearRates { inner: race(true, |_| volume_rate(1e-12)), outer: race(true, |_| 0.0) })
    };
    assert_eq!(life.advance(60.0, slow).unwrap().elapsed, 3660.0);
    assert!((life.inner().mean_depth() / 60e-12 - 1.0).abs() < 1e-12);
}

/// Worn through, a race wears on into the steel by strides of the same depth.
#[test]
fn limit_wear_goes_on_after_wearing_through() {
    let worn = Raceway::new(COATING, 1.0, RADIUS, &[]).unwrap();
    let mut life = CoatingLife::new(worn, raceway(), 0.1).unwrap();
    let rates = |_: &Raceway, _: &Raceway| -> Answer {
        Ok(WearRates { inner: race(true, |_| volume_rate(1e-12)), outer: race(true, |_| 0.0) })
    };
    let stride = life.advance(1e12, rates).unwrap();
    assert!(stride.inner_through.is_some() && stride.outer_through.is_none());
    assert!((life.inner().mean_depth() / (1.1 * COATING) - 1.0).abs() < 1e-9);
}

#[test]
fn limit_rates_that_cannot_be_are_refused_and_change_nothing() {
    let bad: [fn() -> RaceWear; 5] = [
        || race(true, |_| -1e-15),
        || race(true, |_| f64::NAN),
        || RaceWear {
            along_orbit: vec![BallWear { azimuth: 0.0, volume_rate: 1e-15, semi_lateral: 0.0 }],
            ball_count: 1,
            turning: true,
        },
        || {
            let mut race = race(true, |_| 1e-15);
            race.along_orbit.swap(2, 7);
            race
        },
        || {
            let mut race = race(true, |_| 1e-15);
            race.along_orbit[3].azimuth = f64::INFINITY;
            race
        },
    ];
    let mut life = life(0.1);
    for make in bad {
        for (inner, outer) in [(make(), race(true, |_| 1e-15)), (race(true, |_| 1e-15), make())] {
            let found = life.advance(1.0, |_, _| -> Answer { Ok(WearRates { inner, outer }) });
            assert!(found.is_err());
        }
    }
    assert!(life.inner().is_pristine() && life.elapsed() == 0.0);
    let fine = |_: &Raceway, _: &Raceway| -> Answer { unreachable!("not asked") };
    for longest in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert!(matches!(life.advance(longest, fine), Err(WearError::Time { .. })));
    }
    for loss in [0.0, 1.5, f64::NAN] {
        assert!(matches!(CoatingLife::new(raceway(), raceway(), loss), Err(WearError::Fraction { .. })));
    }
}
