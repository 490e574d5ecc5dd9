//! Time of reading a case, and of all that races and fluid do to one ball of the paper's bearing, by the generic
//! quadrature and by the vector kernel.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tribodyn_bearing::{AzimuthFrame, BallSize, BallState, Races, RingState, Side};
use tribodyn_case::Case;
use tribodyn_traction::{FastPatch, PatchRule, Quadrature};

const PAPER_AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");
const RULE: PatchRule = PatchRule::SplitStrip { across: 8, along: 3 };

fn interaction(c: &mut Criterion) {
    c.bench_function("case", |b| b.iter(|| Case::from_ron(black_box(PAPER_AG))));
    let bearing = Case::from_ron(PAPER_AG).expect("the paper's case").bearing().expect("the paper's bearing");
    let g = &bearing.geometry;
    let along = g.groove_offset(Side::Outer) + 3e-5;
    let ball = BallState {
        frame: AzimuthFrame { sin: 0.6, cos: 0.8 },
        position: [along * g.sin_contact_angle(), along * g.cos_contact_angle()],
        velocity: [0.0; 2],
        orbital_speed: 607.0,
        angular_velocity: [-3000.0, 900.0, 10.0],
        size: BallSize::NOMINAL,
    };
    // Pressed on both races by the axial shift of the inner ring.
    let inner = RingState { displacement: [0.0, 0.0, 1e-4], ..RingState::centred(1466.0) };
    let outer = RingState::centred(0.0);
    let rings = Races { inner: &inner, outer: &outer };
    let quadrature = Quadrature::new(RULE).expect("a rule with nodes");
    let kernel = FastPatch::new(RULE).expect("a rule with nodes");
    c.bench_function("generic", |b| b.iter(|| bearing.ball_loads(black_box(&ball), rings, &quadrature)));
    c.bench_function("vector kernel", |b| {
        let surfaces = bearing.surfaces();
        b.iter(|| {
            bearing.ball_loads_with(black_box(&ball), rings, surfaces.each_ref(), |patch| {
                bearing.fast_traction(patch, &kernel)
            })
        })
    });
}

criterion_group!(benches, interaction);
criterion_main!(benches);
