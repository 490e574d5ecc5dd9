//! Time of the spectrum and of the envelope spectrum of one second of a rig's acquisition at 25.6 kHz.

use criterion::{Criterion, criterion_group, criterion_main};
use std::f64::consts::TAU;
use std::hint::black_box;
use tribodyn_signal::{Spectrum, Window, envelope_spectrum};

const RATE_HZ: f64 = 25_600.0;

fn spectra(c: &mut Criterion) {
    let samples: Vec<f64> = (0..25_600)
        .map(|i| {
            let t = f64::from(i) / RATE_HZ;
            (1.0 + 0.5 * (TAU * 1255.0 * t).cos()) * (TAU * 6000.0 * t).sin()
        })
        .collect();
    c.bench_function("spectrum", |b| b.iter(|| Spectrum::of(black_box(&samples), RATE_HZ, Window::Hann)));
    let band = Some([3000.0, 12_000.0]);
    c.bench_function("envelope spectrum", |b| b.iter(|| envelope_spectrum(black_box(&samples), RATE_HZ, band)));
}

criterion_group!(benches, spectra);
criterion_main!(benches);
