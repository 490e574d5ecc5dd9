//! Figures 13 and 19: histories and spectra of the outer ring's acceleration, and the orbital speed.

use super::loads::{SPEEDS, over_orbits};
use super::runs::Made;
use super::spec::Spec;
use crate::error::PaperError;
use crate::transient::{RPM, StateSample, Transient};
use tribodyn_plot::{
    Axis, Figure, History, LineChart, Mark, Panel, Place, Reference, Samples, SpectrumView, history_charts,
    spectrum_chart,
};
use tribodyn_signal::{Spectrum, Window as Taper, envelope_spectrum};

/// A run and its name in a legend.
type Named<'a> = (&'a str, &'a Transient);

/// Spectra are drawn up to this frequency, Hz.
const UP_TO: f64 = 5000.0;
/// Band whose amplitude a defect modulates: above the ring on its support, below half the sampling rate, Hz.
const BAND: [f64; 2] = [3000.0, 9984.0];
/// Size of each area, px.
const HISTORY_PX: [f64; 2] = [660.0, 190.0];
const SPECTRUM_PX: [f64; 2] = [660.0, 200.0];
/// Published peak accelerations of section 5.2.1, m/s².
const PEAKS: [(&str, f64); 2] = [("Ag coating", 8.41), ("PTFE film", 22.65)];
/// Published period of the orbital speed, s, and how many of them are drawn.
const PERIOD: f64 = 0.0103;
const PERIODS: f64 = 4.0;

fn columns(runs: &[Named], from: f64, get: fn(&StateSample) -> f64) -> Vec<[Vec<f64>; 2]> {
    let shown = |run: &Transient, get: fn(&StateSample) -> f64| {
        run.trace.states.iter().filter(|s| s.time_s >= from).map(get).collect::<Vec<f64>>()
    };
    runs.iter().map(|(_, run)| [shown(run, |s| s.time_s), shown(run, get)]).collect()
}

/// A quantity over time from some time on, and the count of its unit of time in one second.
fn history(
    runs: &[Named],
    quantity: Axis,
    from: f64,
    get: fn(&StateSample) -> f64,
) -> Result<(LineChart, f64), PaperError> {
    let values = columns(runs, from, get);
    let samples = runs.iter().zip(&values).map(|((label, _), [x, y])| Samples { label, x, y }).collect();
    let (charts, scale) = history_charts(&[History { title: "", quantity, samples }])?;
    let chart = charts.into_iter().next();
    let chart = chart.ok_or_else(|| PaperError::Check { what: "no history was drawn", findings: Vec::new() })?;
    Ok((LineChart { area_px: HISTORY_PX, ..chart }, scale))
}

fn acceleration(runs: &[Named]) -> Result<(LineChart, f64), PaperError> {
    history(runs, Axis::new("x acceleration, outer ring", "m/s²"), 0.0, |s| s.outer_acceleration[0])
}

fn orbital_speed(runs: &[Named], from: f64) -> Result<(LineChart, f64), PaperError> {
    history(runs, Axis::new("Orbital speed, one ball", "r/min"), from, |s| s.orbit / RPM)
}

fn stacked(spec: &Spec, charts: [LineChart; 2]) -> Result<Figure, PaperError> {
    Ok(Figure::in_columns(spec.name, spec.title, 1, &charts.map(Panel::Cartesian))?)
}

/// Both signs of an amplitude.
fn amplitude(label: &str, value: f64) -> [Reference; 2] {
    [value, -value].map(|v| Reference::new(label, Place::Value(v)))
}

/// Fig. 13a, b.
pub fn start(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let runs = [("Ag coating", made.ag()?)];
    let (mut shaking, scale) = acceleration(&runs)?;
    shaking.references.extend(amplitude("published amplitude: about 5 m/s²", 5.0));
    shaking.references.push(Reference::new("published: settled after about 0.1 s", Place::At(0.1 * scale)));
    let (mut speed, _) = orbital_speed(&runs, 0.0)?;
    speed.references.push(Reference::new("published range: 5810–5844 r/min", Place::Range(5810.0, 5844.0)));
    stacked(spec, [shaking, speed])
}

/// Fig. 19a, b: the whole run, and the last orbits.
pub fn coatings(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let runs = made.coatings()?;
    let (mut shaking, _) = acceleration(&runs)?;
    for (line, peak) in PEAKS {
        let label = format!("published peak, {line}: {peak} m/s²");
        shaking.references.extend(amplitude(&label, peak).map(|r| r.of(line)));
    }
    let end = runs[0].1.trace.states.last().map_or(0.0, |s| s.time_s);
    let (mut speed, scale) = orbital_speed(&runs, end - PERIODS * PERIOD)?;
    let period = Place::Between((end - 2.0 * PERIOD) * scale, (end - PERIOD) * scale);
    speed.references.push(Reference::new("published period: 10.3 ms", period));
    stacked(spec, [shaking, speed])
}

/// Fig. 19b over the azimuth, where the paper says that balls meet their pockets.
pub fn impacts(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let mut panels = over_orbits(&[(SPEEDS, &made.coatings()?)])?;
    panels[0].publish(Reference::new("published impacts: 245° to 330°", Place::Between(245.0, 330.0)));
    Ok(Figure::new(spec.name, spec.title, &panels)?)
}

/// Fig. 13c.
pub fn spectrum(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let mut chart = spectrum_of("", "Ag coating", made.ag()?)?;
    chart.references.push(passing());
    Ok(Figure::new(spec.name, spec.title, &[Panel::Cartesian(chart)])?)
}

/// The published passing frequency.
fn passing() -> Reference {
    Reference::new("published: 1260 Hz (test 1254 Hz)", Place::At(1260.0))
}

/// Fig. 19c, d.
pub fn spectra(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let runs = made.coatings()?;
    let mut charts = runs.iter().map(|(label, run)| spectrum_of(label, label, run)).collect::<Result<Vec<_>, _>>()?;
    let amplitudes = charts.iter().flat_map(|chart| &chart.series).flat_map(|series| &series.points);
    let highest = amplitudes.fold(0.0, |most: f64, (_, amplitude)| most.max(*amplitude));
    charts.iter_mut().for_each(|chart| chart.y.at_least = Some((0.0, highest)));
    let panels: Vec<Panel> = charts.into_iter().map(Panel::Cartesian).collect();
    Ok(Figure::in_columns(spec.name, spec.title, 1, &panels)?)
}

/// The same axis for all spectra, whatever the spacing of their lines.
fn view() -> SpectrumView {
    let abscissa = SpectrumView::frequency().abscissa.covering(0.0, UP_TO);
    SpectrumView { abscissa, ..SpectrumView::frequency() }.up_to(UP_TO)
}

/// The cage frequency and multiples of the frequency at which balls pass.
fn marks(run: &Transient) -> Vec<Mark> {
    let (cage, balls) = (run.settled().cage_hz(), run.case.geometry.ball_count);
    let passing = (1..=3).map(|k| Mark::new((k * balls) as f64 * cage, format!("{} f_c", k * balls)));
    [Mark::new(cage, "f_c")].into_iter().chain(passing).collect()
}

fn spectrum_of(title: &str, label: &str, run: &Transient) -> Result<LineChart, PaperError> {
    let window = run.settled();
    let signal = window.signal(|s| s.outer_acceleration[0]);
    let found = Spectrum::of(&signal, window.rate_hz(), Taper::Hann)?;
    let samples = [Samples { label, x: &found.frequency_hz, y: &found.amplitude }];
    let view = view();
    let chart = spectrum_chart(Axis::new("Amplitude", "m/s²"), &samples, &marks(run), &view)?;
    Ok(LineChart { title: title.to_owned(), area_px: SPECTRUM_PX, ..chart })
}

/// Source of the passing frequency of Fig. 13c: a defect of the outer race, in the envelope of the acceleration.
pub fn defect(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    let runs = [("with a defect of the outer race", made.defect()?), ("without", made.ag()?)];
    let mut spectra = Vec::new();
    for (_, run) in runs {
        let window = run.settled();
        spectra.push(envelope_spectrum(&window.signal(|s| s.outer_acceleration[0]), window.rate_hz(), Some(BAND))?);
    }
    let of = |((label, _), s): (Named, &'_ Spectrum)| (label.to_owned(), s.frequency_hz.clone(), s.amplitude.clone());
    let lines: Vec<_> = runs.into_iter().zip(&spectra).map(of).collect();
    let samples: Vec<Samples> = lines.iter().map(|(label, x, y)| Samples { label, x, y }).collect();
    let view = view();
    let quantity = Axis::new("Amplitude of the envelope", "m/s²");
    let mut chart = spectrum_chart(quantity, &samples, &marks(runs[0].1), &view)?;
    // The mean of the envelope is no line of interest, but would set the scale.
    chart.series.iter_mut().for_each(|series| series.points.retain(|(hz, _)| *hz > 50.0));
    chart.references.push(passing());
    Ok(Figure::new(spec.name, spec.title, &[Panel::Cartesian(chart)])?)
}
