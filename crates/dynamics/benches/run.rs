//! Time of one revolution of the shaft (4.286 ms) in the paper's bearing, samples at 25.6 kHz included.
//!
//! `cargo xtask bench` has the same methods in one table, with their errors.

use criterion::{Criterion, criterion_group, criterion_main};
use std::convert::Infallible;
use std::hint::black_box;
use std::ops::ControlFlow;
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{Event, Observer, Run, Sample};

const PAPER_AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");
const REVOLUTION: f64 = 60.0 / 14_000.0;
const PAPER_RULE: &str = "PolarMidpoint(radial: 10, circumferential: 40)";
const STRIPS: &str = "SplitStrip(across: 8, along: 3)";

struct Silent;

impl Observer for Silent {
    type Error = Infallible;

    fn sample(&mut self, sample: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
        black_box(sample);
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, _: &Event) -> Result<(), Infallible> {
        Ok(())
    }
}

fn run(scheme: &str, rule: &str) -> Run {
    let set = |text: String, (path, value)| set_value(&text, path, value).expect("a path of the case");
    let text = [("transient.scheme", scheme), ("traction.patch", rule)].into_iter().fold(PAPER_AG.to_owned(), set);
    Run::new(Case::from_ron(&text).expect("the paper's case").run_inputs().unwrap()).expect("a start")
}

fn revolutions(c: &mut Criterion) {
    let mut group = c.benchmark_group("revolution");
    group.sample_size(10);
    let mut measure = |name: &str, mut run: Run| {
        let start = run.checkpoint();
        group.bench_function(name, |b| {
            b.iter(|| {
                run.resume(start.clone()).expect("its own checkpoint");
                run.advance(REVOLUTION, &mut Silent)
            });
        });
    };
    measure("RK4 10 us, 10x40, plain", run("RungeKutta4(step: us(10))", PAPER_RULE).with_plain_kernel().unwrap());
    measure("RK4 10 us, 10x40", run("RungeKutta4(step: us(10))", PAPER_RULE));
    measure("RK4 10 us, strips 8x3", run("RungeKutta4(step: us(10))", STRIPS));
    measure("Dormand-Prince 1e-6, strips 8x3", run("DormandPrince(tolerance: 1e-6, longest: us(20))", STRIPS));
    measure("fast 20 us, strips 8x3", run("Fast(step: us(20))", STRIPS));
    group.finish();
}

criterion_group!(benches, revolutions);
criterion_main!(benches);
