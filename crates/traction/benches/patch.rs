//! Time of one patch by the generic and by the fast integral, and of the derivative.
//!
//! Each rule is measured on the inner and outer contacts of `tests/patch_rules/contacts.csv` at slip scales of 1 and
//! 22 per m/s, all in one call; criterion's elements are nodes, so its throughput is the inverse of the time per node.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use tribodyn_traction::{
    FastPatch, PatchRule, PatchTraction, SlipField, TractionLaw, fast_patch_traction, patch_traction,
};

#[path = "../tests/patch_rules/contacts.rs"]
#[allow(dead_code, reason = "shared with the tests, which use more of it")]
mod contacts;

const RULES: [(&str, PatchRule); 6] = [
    ("PolarMidpoint 10x40", PatchRule::PolarMidpoint { radial: 10, circumferential: 40 }),
    ("GaussJacobi 2x8", PatchRule::GaussJacobi { radial: 2, angles: 8 }),
    ("GaussJacobi 4x12", PatchRule::GaussJacobi { radial: 4, angles: 12 }),
    ("SplitStrip 5x3", PatchRule::SplitStrip { across: 5, along: 3 }),
    ("SplitStrip 8x3", PatchRule::SplitStrip { across: 8, along: 3 }),
    ("SplitStrip 10x7", PatchRule::SplitStrip { across: 10, along: 7 }),
];

fn patches(c: &mut Criterion) {
    let law = contacts::silver();
    let probes: Vec<_> = [1.0, 22.0].into_iter().flat_map(contacts::contacts).collect();
    let mut group = c.benchmark_group("patch");
    for (name, rule) in RULES {
        let fast = FastPatch::new(rule).expect("a rule with points");
        let points: usize =
            probes.iter().map(|p| fast.quadrature().point_count(&SlipField::new(&p.patch, &p.motion))).sum();
        group.throughput(Throughput::Elements(points as u64));
        let mut run = |kind: &str, one: &dyn Fn(&contacts::Contact) -> f64| {
            group.bench_function(BenchmarkId::new(kind, name), |b| {
                b.iter(|| black_box(&probes).iter().map(one).sum::<f64>());
            });
        };
        let force = |t: PatchTraction| t.force_rolling;
        run("generic", &|p| {
            force(patch_traction(&p.patch, &p.motion, p.rolling_speed, &p.law(&law), fast.quadrature()))
        });
        run("fast", &|p| force(fast_patch_traction(&fast, &p.patch, &p.motion, p.rolling_speed, &p.law(&law))));
        let curves: Vec<_> = probes.iter().map(|p| law.at(p.patch.peak_pressure)).collect();
        let slope = law.kragelskii_slope(2e9).expect("Kragelskii's curve");
        run("kernel", &|p| {
            let unit = p.law(&law).slip_unit;
            force(fast.traction(&p.patch, &p.motion, p.rolling_speed, &curves[0], unit))
        });
        run("derivative", &|p| {
            let unit = p.law(&law).slip_unit;
            fast.derivative(&p.patch, &p.motion, p.rolling_speed, (&curves[0], &slope), unit).by_motion[0][0]
        });
    }
    group.finish();
    let pressure = probes[0].patch.peak_pressure;
    c.bench_function("curve at a pressure", |b| b.iter(|| law.kragelskii(black_box(pressure))));
    c.bench_function("curve slope at a pressure", |b| b.iter(|| law.kragelskii_slope(black_box(pressure))));
}

criterion_group!(benches, patches);
criterion_main!(benches);
