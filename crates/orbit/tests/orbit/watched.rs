//! A search that is followed, and one that its caller ends.

use crate::support::fixture;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use tribodyn_bearing::{SearchObserver, SearchStage, SearchWatch};
use tribodyn_orbit::{OrbitError, OrbitSettings, steady_orbit};
use tribodyn_quasistatic::{Model, QuasiStaticError, solve};

/// Ends a search after so many looks.
struct Counted {
    looks: AtomicUsize,
    most: usize,
    stages: Mutex<Vec<SearchStage>>,
}

impl Counted {
    fn new(most: usize) -> Arc<Self> {
        Arc::new(Self { looks: AtomicUsize::new(0), most, stages: Mutex::default() })
    }
}

impl SearchObserver for Counted {
    fn stage(&self, stage: SearchStage) {
        self.stages.lock().unwrap().push(stage);
    }

    fn stops(&self) -> bool {
        self.looks.fetch_add(1, Ordering::Relaxed) >= self.most
    }
}

#[test]
fn limit_a_search_ends_when_its_caller_says_so_and_is_the_same_while_it_does_not() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    let settings = OrbitSettings::default();
    let alone = steady_orbit(&bearing, &point, &cage, &settings).unwrap().solution;
    let followed = Counted::new(usize::MAX);
    point.watch = SearchWatch::new(followed.clone());
    assert_eq!(steady_orbit(&bearing, &point, &cage, &settings).unwrap().solution, alone);
    let stages = followed.stages.lock().unwrap().clone();
    assert!(stages.first().is_some_and(|stage| stage.cage_speed.is_some_and(|speed| speed > 0.0)), "{stages:?}");
    let looks = followed.looks.load(Ordering::Relaxed);
    for most in [0, 1, looks / 4, looks / 2] {
        let ended = Counted::new(most);
        point.watch = SearchWatch::new(ended.clone());
        assert_eq!(steady_orbit(&bearing, &point, &cage, &settings).unwrap_err(), OrbitError::Ended);
        // Nothing long is begun after the end.
        let after = ended.looks.load(Ordering::Relaxed) - most;
        assert!(after < 2000, "{after} looks after the end");
    }
}

#[test]
fn limit_a_search_for_an_equilibrium_ends_when_its_caller_says_so() {
    let (_, bearing, mut point, _) = fixture("paper-ag");
    let alone = solve(&bearing, &point, Model::Traction).unwrap().solution;
    let followed = Counted::new(usize::MAX);
    point.watch = SearchWatch::new(followed.clone());
    assert_eq!(solve(&bearing, &point, Model::Traction).unwrap().solution, alone);
    let looks = followed.looks.load(Ordering::Relaxed);
    point.watch = SearchWatch::new(Counted::new(looks / 2));
    assert_eq!(solve(&bearing, &point, Model::Traction).unwrap_err(), QuasiStaticError::Ended);
}
