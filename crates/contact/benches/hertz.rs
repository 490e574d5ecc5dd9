//! Time of one Hertz contact: its constants from the curvatures, and its ellipse from a load once they are known.

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use tribodyn_contact::HertzContact;

/// Curvature sums of the paper's inner contact along and across rolling, 1/m, and steel's effective modulus, Pa.
const CURVATURES: [f64; 2] = [82.0, 2.7];
const MODULUS: f64 = 2.275e11;

fn contacts(c: &mut Criterion) {
    let [along, across] = CURVATURES;
    c.bench_function("constants", |b| b.iter(|| HertzContact::new(black_box(along), black_box(across), MODULUS)));
    let hertz = HertzContact::new(along, across, MODULUS).expect("two convex curvatures");
    c.bench_function("ellipse", |b| b.iter(|| hertz.ellipse(black_box(8e3))));
    c.bench_function("load", |b| b.iter(|| hertz.load(black_box(3e-5))));
}

criterion_group!(benches, contacts);
criterion_main!(benches);
