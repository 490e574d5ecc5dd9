//! Signals of the size of those of a transient run of a 13-ball bearing at 14 000 r/min. They are no result of any
//! model.

use std::f64::consts::TAU;

use tribodyn_plot::{
    Axis, Figure, History, Mark, Samples, SpectrumView, bars, orbit_polar, path_figure, spectrum_figure, stacked_bars,
    time_history,
};

/// Cage frequency, Hz.
const CAGE_HZ: f64 = 96.7;

/// The least of noise: a sum of sines without a common period.
fn restless(t: f64) -> f64 {
    (0..12).map(|k| (TAU * 1370.7 * f64::from(k * k + 3).sqrt() * t).sin()).sum::<f64>() / 12.0
}

pub fn times(count: usize, rate_hz: f64) -> Vec<f64> {
    (0..count).map(|n| n as f64 / rate_hz).collect()
}

pub fn histories() -> Figure {
    let t = times(60_000, 100_000.0);
    let of = |f: &dyn Fn(f64) -> f64| t.iter().map(|t| f(*t)).collect::<Vec<f64>>();
    let cage = of(&|t| 5802.0 - 60.0 * (-t / 0.08).exp() + 3.0 * (TAU * CAGE_HZ * t).sin());
    let balls = [0.0, 2.1].map(|phase| {
        of(&|t| 5800.0 - 55.0 * (-t / 0.06).exp() + 14.0 * (TAU * CAGE_HZ * t + phase).cos() + 2.0 * restless(t))
    });
    let acceleration = of(&|t| 40.0 * restless(t) + if (t - 0.31).abs() < 2e-5 { 900.0 } else { 0.0 });
    let shaft = of(&|t| 24.0 + 1.3 * (TAU * 13.0 * CAGE_HZ * t).sin() * (1.0 + (-t / 0.1).exp()));
    let line = |label, y| Samples { label, x: &t, y };
    let all = [
        History {
            title: "Orbital speed and cage speed",
            quantity: Axis::new("Speed", "r/min"),
            samples: vec![line("Ball 1", &balls[0]), line("Ball 7", &balls[1]), line("Cage", &cage)],
        },
        History {
            title: "Ring displacement",
            quantity: Axis::new("Displacement x", "µm"),
            samples: vec![line("Inner ring", &shaft)],
        },
        History {
            title: "Outer-ring acceleration",
            quantity: Axis::new("Acceleration x", "m/s²"),
            samples: vec![line("Outer ring", &acceleration)],
        },
    ];
    time_history("histories", "Transient run, 0 to 0.6 s", &all).expect("finite data")
}

/// Spectrum lines with harmonics of the cage and a floor.
fn spectrum(floor: f64, strong: &[(f64, f64)]) -> (Vec<f64>, Vec<f64>) {
    (0..5000)
        .map(|k| {
            let f = f64::from(k);
            let line = |(f0, a): &(f64, f64)| a / (1.0 + ((f - f0) / 1.2).powi(4));
            (f, if k == 0 { 0.0 } else { floor * (1.0 + 0.6 * restless(f)) + strong.iter().map(line).sum::<f64>() })
        })
        .unzip()
}

pub fn marks() -> Vec<Mark> {
    vec![
        Mark::new(CAGE_HZ, "f_c"),
        Mark::new(1400.0 / 6.0, "f_s"),
        Mark::new(2.0 * CAGE_HZ, "2 f_c"),
        Mark::new(3.0 * CAGE_HZ, "3 f_c"),
        Mark::new(13.0 * CAGE_HZ, "13 f_c"),
        Mark::new(26.0 * CAGE_HZ, "26 f_c"),
        Mark::new(13.0 * (1400.0 / 6.0 - CAGE_HZ), "13 (f_s − f_c)"),
        Mark::new(9e9, "outside"),
    ]
}

pub fn spectra(view: &SpectrumView) -> Figure {
    let case_1 = spectrum(2e-4, &[(96.7, 0.02), (193.4, 0.006), (1257.1, 0.9), (2514.2, 0.12)]);
    let case_2 = spectrum(1e-4, &[(96.7, 0.05), (1257.1, 0.4)]);
    let all = [
        Samples { label: "Case 1", x: &case_1.0, y: &case_1.1 },
        Samples { label: "Case 2", x: &case_2.0, y: &case_2.1 },
    ];
    let quantity = Axis::new("Amplitude", "m/s²");
    spectrum_figure("spectrum", "Spectrum of the outer-ring acceleration", quantity, &all, &marks(), view)
        .expect("finite data")
}

pub fn crowded_spectrum() -> Figure {
    let lines = spectrum(2e-4, &[(96.7, 0.2), (1257.1, 0.9)]);
    let many: Vec<Mark> = (1..=20).map(|k| Mark::new(CAGE_HZ * f64::from(k), format!("{k} f_c"))).collect();
    let all = [Samples { label: "Cage", x: &lines.0, y: &lines.1 }];
    let view = SpectrumView::frequency().up_to(2000.0);
    spectrum_figure("crowded", "Spectrum of the cage speed", Axis::new("Amplitude", "r/min"), &all, &many, &view)
        .expect("finite data")
}

pub fn orbits() -> Figure {
    let phi: Vec<f64> = (0..4000).map(|k| 1.0 + 0.011 * f64::from(k)).collect();
    let of = |f: &dyn Fn(f64) -> f64| phi.iter().map(|p| f(*p)).collect::<Vec<f64>>();
    let inner = of(&|p| 8.5 + 2.4 * p.cos() + 0.25 * (1.37 * p).sin());
    let outer = of(&|p| 10.0 + 1.9 * p.cos());
    let all = [
        Samples { label: "Inner contact", x: &phi, y: &inner },
        Samples { label: "Outer contact", x: &phi, y: &outer },
    ];
    orbit_polar("orbit", "Contact loads of ball 1 over 7 orbits", Axis::new("Contact load", "kN"), &all)
        .expect("finite data")
}

pub fn ring_path() -> Figure {
    let t = times(20_000, 100_000.0);
    let swing = |t: f64| 1.3 + 6.0 * (-t / 0.02).exp();
    let x: Vec<f64> = t.iter().map(|t| 24.0 + swing(*t) * (TAU * 13.0 * CAGE_HZ * t).cos()).collect();
    let y: Vec<f64> = t.iter().map(|t| -2.0 + 0.8 * swing(*t) * (TAU * 13.0 * CAGE_HZ * t).sin()).collect();
    let axis = |label: &str| Axis::new(label, "µm");
    let paths = [Samples { label: "Inner ring", x: &x, y: &y }];
    path_figure("path", "Path of the ring's centre", axis("x"), axis("y"), &paths).expect("finite data")
}

pub fn power_balance() -> Figure {
    let terms = [
        ("Shaft", vec![53_100.0, 0.0]),
        ("Inner contacts", vec![0.0, 15_900.0]),
        ("Outer contacts", vec![0.0, 3_300.0]),
        ("Ball drag", vec![0.0, 24_200.0]),
        ("Churning", vec![0.0, 7_600.0]),
        ("Cage pockets", vec![0.0, 1_700.0]),
        ("Contact damping", vec![0.0, 380.0]),
        ("Supports", vec![0.0, 150.0]),
        ("Stored energy", vec![0.0, -130.0]),
    ];
    stacked_bars(
        "power-balance",
        "Power balance, mean of the last orbit",
        Axis::new("Power", "W"),
        &["In", "Out"],
        &terms,
    )
    .expect("finite data")
}

pub fn wear_bars() -> Figure {
    let groups = ["250 N preload", "500 N preload", "750 N preload", "1000 N preload"];
    let rates = [
        ("Inner race", vec![2.1e-12, 2.4e-12, 2.9e-12, 3.6e-12]),
        ("Outer race", vec![0.42e-12, 0.5e-12, 0.61e-12, 0.66e-12]),
        ("Cage pockets", vec![0.31e-12, 0.22e-12, 0.12e-12, 0.05e-12]),
    ];
    bars("wear", "Wear rates against axial load", Axis::new("Wear rate", "m³/s"), &groups, &rates).expect("finite data")
}

pub fn signed_bars() -> Figure {
    let groups = ["Case 1", "Case 2", "Case 3"];
    let values = [("Inner ring, axial and radial mean", vec![-3.2, 1.5, 0.0]), ("Outer", vec![4.0, -2.0, -0.5])];
    bars("signed", "Deviation from the steady solution", Axis::new("Deviation", "%"), &groups, &values)
        .expect("finite data")
}

pub fn run_figures() -> Vec<Figure> {
    vec![
        histories(),
        spectra(&SpectrumView::frequency()),
        spectra(&SpectrumView::frequency().logarithmic(5)),
        crowded_spectrum(),
        orbits(),
        ring_path(),
        power_balance(),
        wear_bars(),
        signed_bars(),
    ]
}
