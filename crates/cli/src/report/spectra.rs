//! Spectra of the acceleration of the outer ring, with the frequencies at which balls and cage come by.

use crate::failure::Failure;
use crate::run::Summary;
use tribodyn_plot::{Axis, Figure, Mark, Samples, SpectrumView, spectrum_figure};
use tribodyn_record::{Run, StateRow};
use tribodyn_signal::{BearingFrequencies, Spectrum, Window, envelope_spectrum};

/// Key of the metadata `simulation` with the end of the band that the filter of the samples passes, Hz.
const PASS_BAND: &str = "filter_pass_band_hz";

/// Fewest samples of which a spectrum says something.
const FEWEST: usize = 256;
/// Frequencies shown, in passes of a ball.
const PASSES_SHOWN: f64 = 6.0;
const DECADES: u32 = 5;

/// The second half of a run as an evenly sampled signal.
struct Half<'a> {
    rows: &'a [StateRow],
    rate_hz: f64,
}

pub fn figures(
    run: &Run,
    summary: &Summary,
    frequencies: &BearingFrequencies,
    notes: &mut Vec<String>,
) -> Result<Vec<Figure>, Failure> {
    let from = run.states.partition_point(|row| row.time_s < summary.averaged_from_s);
    let half = match half(&run.states[from..]) {
        Ok(half) => half,
        Err(why) => {
            notes.push(format!("There are no spectra: {why}."));
            return Ok(Vec::new());
        }
    };
    let marks = marks(frequencies, super::facts::balls(run));
    let band_hz = pass_band_hz(run);
    let most = band_hz.unwrap_or(0.5 * half.rate_hz);
    notes.extend(undersampled(band_hz, &half, frequencies));
    let passes = PASSES_SHOWN * frequencies.ball_pass_outer_hz;
    let shown = if passes > 0.0 { most.min(passes) } else { most };
    let signal = |get: fn(&StateRow) -> f64| half.rows.iter().map(get).collect::<Vec<f64>>();
    let axes = [signal(|r| r.outer_acceleration_x_m_s2), signal(|r| r.outer_acceleration_y_m_s2)];
    let still = |samples: &Vec<f64>| samples.iter().all(|a| *a == samples[0]);
    if axes.iter().all(still) {
        notes.push("There are no spectra: the outer ring does not move.".to_owned());
        return Ok(Vec::new());
    }
    let plain: Vec<Spectrum> =
        axes.iter().map(|a| Spectrum::of(a, half.rate_hz, Window::Hann)).collect::<Result<_, _>>()?;
    let envelopes: Vec<Spectrum> =
        axes.iter().map(|a| envelope_spectrum(a, half.rate_hz, Some([0.0, most]))).collect::<Result<_, _>>()?;
    let plans = [
        ("spectrum", "Spectrum of the acceleration of the outer ring", plain),
        ("envelope-spectrum", "Spectrum of the envelope of the acceleration of the outer ring", envelopes),
    ];
    let mut figures = Vec::new();
    for (name, title, spectra) in plans {
        let labels = ["along X", "along Y"];
        let lines: Vec<Samples> = spectra
            .iter()
            .zip(labels)
            .filter(|(s, _)| s.amplitude.iter().any(|a| *a > 0.0))
            .map(|(s, label)| Samples { label, x: &s.frequency_hz, y: &s.amplitude })
            .collect();
        let view = SpectrumView::frequency().logarithmic(DECADES).up_to(shown);
        if !lines.is_empty() {
            figures.push(spectrum_figure(name, title, Axis::new("Amplitude", "m/s²"), &lines, &marks, &view)?);
        }
    }
    Ok(figures)
}

/// End of the pass band of the filter behind the samples, Hz; none where the recording names no filter.
fn pass_band_hz(run: &Run) -> Option<f64> {
    run.metadata.get("simulation")?.get(PASS_BAND)?.parse().ok()
}

/// Where a spectrum may show lines that did not occur, or cannot show those of the balls.
fn undersampled(band_hz: Option<f64>, half: &Half, frequencies: &BearingFrequencies) -> Option<String> {
    let passing = frequencies.ball_pass_outer_hz.max(frequencies.ball_pass_inner_hz);
    match band_hz {
        None => Some(format!(
            "The recording names no filter: what vibrates above {:.0} Hz, half its state rate, shows at other frequencies in the spectra.",
            0.5 * half.rate_hz
        )),
        Some(end) if end < passing => Some(format!(
            "The spectra end at {end:.0} Hz, below the ball passing frequencies, up to {passing:.0} Hz: raise recording.state_rate."
        )),
        Some(_) => None,
    }
}

fn half(rows: &[StateRow]) -> Result<Half<'_>, String> {
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else {
        return Err("the run has no samples".to_owned());
    };
    if rows.len() < FEWEST {
        return Err(format!("half of the run has {} samples, {FEWEST} are needed", rows.len()));
    }
    let step = (last.time_s - first.time_s) / (rows.len() - 1) as f64;
    let even = |(k, row): (usize, &StateRow)| (row.time_s - first.time_s - step * k as f64).abs() < 0.01 * step;
    if !rows.iter().enumerate().all(even) {
        return Err("samples are missing, so that they are not evenly spaced".to_owned());
    }
    Ok(Half { rows, rate_hz: 1.0 / step })
}

/// Turns of cage and shaft, and passes of balls over a point of the outer ring with their multiples.
fn marks(f: &BearingFrequencies, balls: usize) -> Vec<Mark> {
    let mut marks = vec![Mark::new(f.cage_hz, "f_c"), Mark::new(f.shaft_hz, "f_i")];
    for multiple in 1..PASSES_SHOWN as usize {
        let label = format!("{} f_c", multiple * balls);
        marks.push(Mark::new(multiple as f64 * f.ball_pass_outer_hz, label));
    }
    marks.retain(|mark| mark.at > 0.0);
    marks
}
