//! Figures of a vibration signal: kurtogram, spectrum, envelope spectrum, spectrogram of a speed that changes.

use crate::failure::Failure;
use tribodyn_plot::{
    Axis, Cell, Figure, History, LineChart, MapAxis, MapChart, Mark, Panel, Samples, SpectrumView, spectrum_chart,
    time_history,
};
use tribodyn_signal::{Band, Fault, Spectrum, spectrogram};
use tribodyn_study::vibration::Analysis;

const DECADES: u32 = 4;
/// Harmonics of each line that are marked.
const MARKED: usize = 3;
/// Columns of the map of the kurtogram: every edge of a band lies on one.
const COLUMNS: usize = 96;
/// Pieces of time and bands of a spectrogram.
const PIECES: [usize; 2] = [120, 100];

pub fn of(a: &Analysis) -> Result<Vec<Figure>, Failure> {
    let mut figures = vec![signal(a)?, spectra(a)?, kurtogram(a)?];
    if let Some(speeds) = &a.speeds_rad_s {
        figures.push(run_up(a, speeds)?);
    }
    Ok(figures)
}

fn signal(a: &Analysis) -> Result<Figure, Failure> {
    let times: Vec<f64> = (0..a.samples.len()).map(|n| a.from_s + n as f64 / a.rate_hz).collect();
    let history =
        |title, quantity, y| History { title, quantity, samples: vec![Samples { label: title, x: &times, y }] };
    let mut panels = vec![history("Signal", Axis::new("Signal", ""), &a.samples)];
    let rpm: Option<Vec<f64>> =
        a.speeds_rad_s.as_ref().map(|all| all.iter().map(|w| w * 30.0 / std::f64::consts::PI).collect());
    if let Some(rpm) = &rpm {
        panels.push(history("Shaft", Axis::new("Speed", "r/min"), rpm));
    }
    Ok(time_history("signal", "Vibration signal", &panels)?)
}

/// Lines to mark: those that were found, by their frequencies, and the shaft.
fn marks(a: &Analysis) -> Vec<Mark> {
    let d = &a.diagnosis;
    let mut marks = vec![Mark::new(d.shaft.frequency_hz, "f_s")];
    for order in 1..=MARKED {
        for e in &d.evidence {
            let shown = d.verdict.fault.map_or(order == 1, |fault| fault == e.fault || order == 1);
            if shown && (e.fault != Fault::Cage || order == 1) {
                let label = if order == 1 { e.fault.line().to_owned() } else { format!("{order} {}", e.fault.line()) };
                marks.push(Mark::new(order as f64 * e.frequency_hz, label));
            }
        }
    }
    marks
}

fn spectra(a: &Analysis) -> Result<Figure, Failure> {
    let d = &a.diagnosis;
    let plain = Spectrum::of(&a.samples, a.rate_hz, Default::default())?;
    let lines = |s: &'static str, spectrum: &Spectrum, from: usize| -> (Vec<f64>, Vec<f64>, &'static str) {
        (spectrum.frequency_hz[from..].to_vec(), spectrum.amplitude[from..].to_vec(), s)
    };
    let chart = |title: &str, axis, (x, y, label): &(Vec<f64>, Vec<f64>, &'static str), marks: &[Mark], view| {
        let chart = spectrum_chart(axis, &[Samples { label, x, y }], marks, &view)?;
        Ok::<_, Failure>(Panel::Cartesian(LineChart { title: title.to_owned(), ..chart }))
    };
    let highest = d.evidence.iter().fold(0.0, |most: f64, e| most.max(e.frequency_hz));
    let band = [Mark::new(d.band.low_hz, "band"), Mark::new(d.band.high_hz, "band")];
    let whole = lines("Spectrum", &plain, 1);
    let envelope = lines("Envelope spectrum", &d.envelope, 1);
    let up_to = 3.5 * highest;
    let view = SpectrumView::frequency();
    let title = if d.order_tracked { "Squared envelope, over shaft angle" } else { "Squared envelope" };
    let panels = [
        chart("Signal", Axis::new("Amplitude", ""), &whole, &band, view.clone().logarithmic(DECADES))?,
        chart(title, Axis::new("Amplitude over mean", ""), &envelope, &marks(a), view.up_to(up_to))?,
    ];
    Ok(Figure::in_columns("envelope-spectrum", "Spectra of the signal and of the envelope of its band", 1, &panels)?)
}

/// Kurtosis over frequency and number of bands, wide bands at the bottom.
fn kurtogram(a: &Analysis) -> Result<Figure, Failure> {
    let bands = &a.diagnosis.kurtogram;
    let mut levels: Vec<(f64, Vec<&Band>)> = Vec::new();
    for band in bands {
        let width = band.high_hz - band.low_hz;
        match levels.last_mut() {
            Some((last, of_level)) if (*last - width).abs() < 1e-6 * width => of_level.push(band),
            _ => levels.push((width, vec![band])),
        }
    }
    let nyquist = 0.5 * a.rate_hz;
    let middles: Vec<f64> = (0..COLUMNS).map(|k| nyquist * (k as f64 + 0.5) / COLUMNS as f64).collect();
    let cell = |bands: &[&Band], hz: f64| {
        let inside = bands.iter().find(|band| (band.low_hz..band.high_hz).contains(&hz));
        inside.map_or(Cell::Unknown, |band| Cell::Value(band.kurtosis))
    };
    let cells = levels.iter().flat_map(|(_, bands)| middles.iter().map(move |hz| cell(bands, *hz))).collect();
    let names = levels.iter().map(|(width, _)| format!("{width:.0} Hz")).collect();
    let x = MapAxis::numbers(Axis::new("Frequency", "Hz"), middles.clone());
    let y = MapAxis::names(Axis::new("Width of the band", ""), names);
    let chart = MapChart::new("", x, y, Axis::new("Spectral kurtosis", ""), cells);
    Ok(Figure::new("kurtogram", "Kurtogram", &[Panel::Map(chart)])?)
}

fn run_up(a: &Analysis, _speeds: &[f64]) -> Result<Figure, Failure> {
    let map = |title: &str, up_to: f64| -> Result<Panel, Failure> {
        let shown = spectrogram(&a.samples, a.rate_hz, up_to, PIECES)?;
        let times = shown.time_s.iter().map(|t| a.from_s + t).collect();
        let x = MapAxis::numbers(Axis::new("Time", "s"), times);
        let y = MapAxis::numbers(Axis::new("Frequency", "Hz"), shown.frequency_hz);
        let cells = shown.level_db.into_iter().map(|level| Cell::Value(level.max(-80.0))).collect();
        Ok(Panel::Map(MapChart::new(title, x, y, Axis::new("Level", "dB"), cells)))
    };
    let highest = a.diagnosis.evidence.iter().fold(0.0, |most: f64, e| most.max(e.frequency_hz));
    let panels = [map("Whole band", 0.5 * a.rate_hz)?, map("Lines of the bearing", 4.0 * highest)?];
    Ok(Figure::in_columns("spectrogram", "Spectrogram", 2, &panels)?)
}
