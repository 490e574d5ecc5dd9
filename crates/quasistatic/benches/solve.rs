//! Time of one solve of the paper's case 1 (13 balls, silver coating, patch rule by target error).
//!
//! `cold` starts from nothing; `warm` goes back and forth between two neighbours of a sweep, 2 % apart in radial load
//! and 1 % in speed, each from the solution of the other; `warm, nearer` between points a tenth as far apart.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tribodyn_case::Case;
use tribodyn_quasistatic::{Model, RingFreedom, solve, solve_from};

fn solves(c: &mut Criterion) {
    let case = Case::from_ron(include_str!("../../../fixtures/cases/paper-ag.ron")).expect("the paper's case");
    let bearing = case.bearing().expect("the paper's bearing");
    let point = case.operating_point();
    c.bench_function("cold", |b| b.iter(|| solve(&bearing, black_box(&point), Model::Traction)));
    for (name, distance) in [("warm", 1.0), ("warm, nearer", 0.1)] {
        let mut other = point.clone();
        if let RingFreedom::Loaded(load) = &mut other.ring[0] {
            *load *= 1.0 + 0.02 * distance;
        }
        other.inner_speed *= 1.0 + 0.01 * distance;
        let start = |point| {
            let solved = solve(&bearing, point, Model::Traction).expect("the paper's case has an equilibrium");
            solved.warm_start.expect("a solution with traction")
        };
        let (here, there) = (start(&point), start(&other));
        c.bench_function(name, |b| {
            let mut forth = false;
            b.iter(|| {
                forth = !forth;
                let (to, from) = if forth { (&other, &here) } else { (&point, &there) };
                solve_from(&bearing, black_box(to), from)
            })
        });
    }
    c.bench_function("Jones-Harris", |b| b.iter(|| solve(&bearing, black_box(&point), Model::JonesHarris)));
}

criterion_group!(benches, solves);
criterion_main!(benches);
