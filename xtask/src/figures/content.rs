//! What each figure shows.

use super::Entry;
use crate::error::Failure;
use crate::transient::{RPM, Set, Transient, Window};
use tribodyn_dynamics::BallSample;
use tribodyn_plot::{
    Axis, Figure, History, Mark, Samples, SpectrumView, bars, orbit_polar, spectrum_figure, time_history,
};
use tribodyn_signal::{Spectrum, Window as Taper};

/// A run and its name in a legend.
type Named<'a> = (&'a str, &'a Transient);
type Quantity = fn(&BallSample) -> f64;

/// Multiples of the passing frequency that are marked.
const MARKED: usize = 3;
/// Spectra are drawn up to this frequency, Hz.
const UP_TO: f64 = 5000.0;

pub fn all(set: &Set) -> Result<Vec<Entry>, Failure> {
    let coatings = [&set.ag, &set.ptfe].map(|run| (run.label.as_str(), run));
    let [a, b, c, d] = set.by_load().map(|(_, run)| run);
    let loads = [(a.label.as_str(), a), (&b.label, b), (&c.label, c), ("100 % axial load", d)];
    let mut out = vec![
        entry(
            "13a, b",
            AG,
            history("fig13-history", "Outer-ring acceleration and orbital speed of a ball", &coatings[..1])?,
        ),
        entry("13c", AG, spectrum("fig13-spectrum", "Spectrum of the outer ring's acceleration, Ag", &set.ag)?),
        entry(
            "19a, b",
            COATINGS,
            history("fig19-history", "Outer-ring acceleration and orbital speed of a ball", &coatings)?,
        ),
        entry("19c", AG, spectrum("fig19-spectrum-ag", "Spectrum of the outer ring's acceleration, Ag", &set.ag)?),
        entry(
            "19d",
            PTFE,
            spectrum("fig19-spectrum-ptfe", "Spectrum of the outer ring's acceleration, PTFE", &set.ptfe)?,
        ),
    ];
    let angles = Axis::new("Contact angle", "°");
    let force = Axis::new("Contact load", "kN");
    let slip = Axis::new("Slide-to-roll ratio", "‰");
    let wear = Axis::new("Wear rate of both races", "1e-12 m³/s");
    let pocket = Axis::new("Pocket force", "N");
    let cage_wear = Axis::new("Wear rate of the pocket", "1e-12 m³/s");
    let spin = Axis::new("Spin ratio", "1/m");
    let sides = |name: [&str; 2], title: [&str; 2], axis: &Axis, get: [Quantity; 2], runs: &[Named]| {
        let inner = over_orbit(name[0], title[0], axis, get[0], runs)?;
        Ok::<_, Failure>([inner, over_orbit(name[1], title[1], axis, get[1], runs)?])
    };
    const ANGLES: [Quantity; 2] = [|b| b.inner.angle_rad.to_degrees(), |b| b.outer.angle_rad.to_degrees()];
    const LOADS: [Quantity; 2] = [|b| 1e-3 * b.inner.load_n, |b| 1e-3 * b.outer.load_n];
    const SLIPS: [Quantity; 2] = [|b| 1e3 * b.inner.slide_to_roll[0], |b| 1e3 * b.outer.slide_to_roll[0]];
    const SPINS: [Quantity; 2] = [|b| b.inner.spin_ratio_per_m, |b| b.outer.spin_ratio_per_m];
    let angle_titles = ["Inner contact angle", "Outer contact angle"];
    let load_titles = ["Inner contact load", "Outer contact load"];
    let slip_titles = ["Inner slide-to-roll ratio", "Outer slide-to-roll ratio"];
    for (of, names, titles, axis, get) in [
        ("20a", ["fig20-angle-inner", "fig20-angle-outer"], angle_titles, &angles, ANGLES),
        ("20b", ["fig20-load-inner", "fig20-load-outer"], load_titles, &force, LOADS),
        ("20c", ["fig20-slip-inner", "fig20-slip-outer"], slip_titles, &slip, SLIPS),
        ("20d", ["fig20-spin-inner", "fig20-spin-outer"], ["Inner spin ratio", "Outer spin ratio"], &spin, SPINS),
    ] {
        out.extend(sides(names, titles, axis, get, &coatings)?.map(|figure| entry(of, COATINGS, figure)));
    }
    let race: Quantity = |b| 1e12 * (b.inner.wear_rate_m3_s + b.outer.wear_rate_m3_s);
    let rubbing: Quantity = |b| 1e12 * b.wear_rate_cage_m3_s;
    out.push(entry("21a", COATINGS, over_orbit("fig21-race", "Wear of the races by a ball", &wear, race, &coatings)?));
    out.push(entry("21b", COATINGS, over_orbit("fig21-cage", "Wear of a pocket", &cage_wear, rubbing, &coatings)?));
    out.push(entry("22a", PRELOADS, vibration(set)?));
    let orbital = Axis::new("Orbital speed", "r/min");
    let speed: Quantity = |b| b.orbital_speed_rad_s / RPM;
    out.push(entry("22b", PRELOADS, over_orbit("fig22-orbit", "Orbital speed of the balls", &orbital, speed, &loads)?));
    for (of, names, titles, axis, get) in [
        ("23a", ["fig23-angle-inner", "fig23-angle-outer"], angle_titles, &angles, ANGLES),
        ("23b", ["fig23-load-inner", "fig23-load-outer"], load_titles, &force, LOADS),
        ("23c", ["fig23-slip-inner", "fig23-slip-outer"], slip_titles, &slip, SLIPS),
    ] {
        out.extend(sides(names, titles, axis, get, &loads)?.map(|figure| entry(of, PRELOADS, figure)));
    }
    let pushing: Quantity = |b| b.pocket_force_n.abs();
    out.push(entry(
        "23d",
        PRELOADS,
        over_orbit("fig23-pocket", "Force of the pocket on a ball", &pocket, pushing, &loads)?,
    ));
    out.push(entry("24a", PRELOADS, over_orbit("fig24-race", "Wear of the races by a ball", &wear, race, &loads)?));
    out.push(entry("24b", PRELOADS, over_orbit("fig24-cage", "Wear of a pocket", &cage_wear, rubbing, &loads)?));
    Ok(out)
}

const AG: &str = "Case `fixtures/cases/paper-ag.ron`.";
const PTFE: &str = "Case `fixtures/cases/paper-ptfe.ron`.";
const COATINGS: &str = "Cases `fixtures/cases/paper-ag.ron` and `fixtures/cases/paper-ptfe.ron`.";
const PRELOADS: &str =
    "Case `fixtures/cases/paper-ag.ron` with 25, 50, 75 and 100 % of its axial load and the whole radial load.";

fn entry(of: &'static str, caption: &'static str, figure: Figure) -> Entry {
    Entry { of, caption, figure }
}

/// Acceleration and orbital speed over the whole run.
fn history(name: &str, title: &str, runs: &[Named]) -> Result<Figure, Failure> {
    let column = |run: &Transient, get: fn(&crate::transient::StateSample) -> f64| -> Vec<f64> {
        run.trace.states.iter().map(get).collect()
    };
    let times: Vec<_> = runs.iter().map(|(_, run)| column(run, |s| s.time_s)).collect();
    let shaking: Vec<_> = runs.iter().map(|(_, run)| column(run, |s| s.outer_acceleration[0])).collect();
    let speeds: Vec<_> = runs.iter().map(|(_, run)| column(run, |s| s.orbit / RPM)).collect();
    let acceleration = Axis::new("x acceleration, outer ring", "m/s²");
    let orbital = Axis::new("Orbital speed, one ball", "r/min");
    let line = |k: usize, y| Samples { label: runs[k].0, x: &times[k], y };
    let histories = [(acceleration, &shaking), (orbital, &speeds)].map(|(quantity, values)| History {
        title: "",
        quantity,
        samples: values.iter().enumerate().map(|(k, y)| line(k, y.as_slice())).collect(),
    });
    Ok(time_history(name, title, &histories)?)
}

fn spectrum(name: &str, title: &str, run: &Transient) -> Result<Figure, Failure> {
    let window = run.settled();
    let signal = window.signal(|s| s.outer_acceleration[0]);
    let found = Spectrum::of(&signal, window.rate_hz(), Taper::Hann)?;
    let mut marks = vec![Mark::new(window.cage_hz(), "f_c"), Mark::new(1260.0, "1260 Hz (paper)")];
    let passing = 13.0 * window.cage_hz();
    marks.extend((2..=MARKED).map(|k| Mark::new(k as f64 * passing, format!("{} f_c", 13 * k))));
    let samples = [Samples { label: &run.label, x: &found.frequency_hz, y: &found.amplitude }];
    let view = SpectrumView::frequency().up_to(UP_TO);
    Ok(spectrum_figure(name, title, Axis::new("Amplitude", "m/s²"), &samples, &marks, &view)?)
}

/// A value of all balls over the azimuth in the settled orbits.
fn over_orbit(name: &str, title: &str, axis: &Axis, get: Quantity, runs: &[Named]) -> Result<Figure, Failure> {
    let columns: Vec<(Vec<f64>, Vec<f64>)> = runs.iter().map(|(_, run)| azimuths(&run.settled(), get)).collect();
    let samples: Vec<Samples> = runs.iter().zip(&columns).map(|((label, _), (x, y))| Samples { label, x, y }).collect();
    Ok(orbit_polar(name, title, axis.clone(), &samples)?)
}

fn azimuths(window: &Window, get: Quantity) -> (Vec<f64>, Vec<f64>) {
    window.all_balls().map(|ball| (ball.azimuth_rad, get(ball))).unzip()
}

/// Fig. 22a: rms of the inner ring's accelerations.
fn vibration(set: &Set) -> Result<Figure, Failure> {
    let rms = |k: usize| set.by_load().map(|(_, run)| run.settled().rms(|s| s.inner_acceleration[k])).to_vec();
    let groups = ["25 %", "50 %", "75 %", "100 %"];
    let values = [("x", rms(0)), ("y", rms(1)), ("z", rms(2))];
    let axis = Axis::new("rms acceleration, inner ring", "m/s²");
    Ok(bars("fig22-vibration", "Vibration of the inner ring against axial load", axis, &groups, &values)?)
}
