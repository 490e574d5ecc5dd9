//! Spectra of the acceleration of the outer ring over frequency and order, with the frequencies at which balls and cage
//! come by.

use super::live::{Kind, Live, LiveMark, Plan, View};
use crate::ReportError;
use tribodyn_plot::{Axis, Figure, History, LineChart, Mark, Panel, PlotError, Samples, SpectrumView, spectrum_chart};
use tribodyn_record::{Run, StateRow};
use tribodyn_signal::{BearingFrequencies, Spectrum, Window, envelope_spectrum};
use tribodyn_study::run::Summary;

/// Key of the metadata `simulation` with the end of the band that the filter of the samples passes, Hz.
const PASS_BAND: &str = "filter_pass_band_hz";

/// Fewest samples of which a spectrum says something.
const FEWEST: usize = 256;
/// Frequencies of the panel over orders, in passes of a ball over a point of the outer race.
const PASSES_SHOWN: f64 = 6.0;
const DECADES: u32 = 5;

/// The second half of a run as an evenly sampled signal.
struct Half<'a> {
    rows: &'a [StateRow],
    rate_hz: f64,
}

pub fn figures(
    run: &Run,
    (summary, error_m_s2): (&Summary, Option<f64>),
    frequencies: &BearingFrequencies,
    notes: &mut Vec<String>,
    live: &mut Live,
) -> Result<Vec<Figure>, ReportError> {
    let from = run.states.partition_point(|row| row.time_s < summary.averaged_from_s);
    let half = match half(&run.states[from..]) {
        Ok(half) => half,
        Err(why) => {
            notes.push(format!("There are no spectra: {why}."));
            return Ok(Vec::new());
        }
    };
    let band_hz = pass_band_hz(run);
    let most = band_hz.unwrap_or(0.5 * half.rate_hz);
    notes.extend(undersampled(band_hz, &half, frequencies));
    let signal = |get: fn(&StateRow) -> f64| half.rows.iter().map(get).collect::<Vec<f64>>();
    let axes = [signal(|r| r.outer_acceleration_x_m_s2), signal(|r| r.outer_acceleration_y_m_s2)];
    let still = |samples: &Vec<f64>| samples.iter().all(|a| *a == samples[0]);
    if axes.iter().all(still) {
        notes.push("There are no spectra: the outer ring does not move.".to_owned());
        return Ok(Vec::new());
    }
    let above = match above_error(summary, error_m_s2) {
        Ok(above) => above,
        Err(why) => {
            notes.push(why);
            return Ok(Vec::new());
        }
    };
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
        let lines: Vec<Samples> = spectra
            .iter()
            .zip(["along X", "along Y"])
            .zip(above)
            .filter(|((s, _), above)| *above && s.amplitude.iter().any(|a| *a > 0.0))
            .map(|((s, label), _)| {
                let shown = s.frequency_hz.partition_point(|f| *f <= most);
                Samples { label, x: &s.frequency_hz[..shown], y: &s.amplitude[..shown] }
            })
            .collect();
        if !lines.is_empty() {
            figures.push(drawn((name, title), &lines, frequencies, most)?);
            interactive(live, (name, title), &lines, frequencies, most);
        }
    }
    Ok(figures)
}

/// The axes, X and Y, with vibration above the error of the run, or why none has: a spectrum would be of the error.
fn above_error(summary: &Summary, error_m_s2: Option<f64>) -> Result<[bool; 2], String> {
    let rms = [summary.outer_acceleration_x_rms_m_s2, summary.outer_acceleration_y_rms_m_s2];
    let above = rms.map(|rms| error_m_s2.is_none_or(|error| rms > error));
    match error_m_s2.filter(|_| above == [false; 2]) {
        None => Ok(above),
        Some(error) => Err(format!(
            "There are no spectra: the acceleration of the outer ring, {:.1e} m/s² rms, is not above the error of the run, {error:.1e} m/s².",
            rms[0].max(rms[1])
        )),
    }
}

fn amplitude() -> Axis {
    Axis::new("Amplitude", "m/s²")
}

/// The whole band over frequency, and the lower one over orders where there is a shaft frequency.
fn drawn(
    (name, title): (&str, &str),
    lines: &[Samples],
    frequencies: &BearingFrequencies,
    band_hz: f64,
) -> Result<Figure, PlotError> {
    let marks = marks(frequencies);
    let passes: Vec<Mark> = marks.iter().filter(|m| m.passes()).map(|m| Mark::new(m.at, &*m.label)).collect();
    let view = SpectrumView::frequency().logarithmic(DECADES);
    let whole = spectrum_chart(amplitude(), lines, &passes, &view)?;
    let mut panels = vec![Panel::Cartesian(LineChart { title: "Whole band".to_owned(), ..whole })];
    let shaft_hz = frequencies.shaft_hz;
    if shaft_hz > 0.0 {
        let orders: Vec<Vec<f64>> = lines.iter().map(|l| l.x.iter().map(|f| f / shaft_hz).collect()).collect();
        let lines: Vec<Samples> = lines.iter().zip(&orders).map(|(l, x)| Samples { x, ..*l }).collect();
        let marks: Vec<Mark> = marks.iter().map(|m| Mark::new(m.at / shaft_hz, &*m.label)).collect();
        let view = SpectrumView::order().logarithmic(DECADES).up_to(low_band_hz(frequencies, band_hz) / shaft_hz);
        let lower = spectrum_chart(amplitude(), &lines, &marks, &view)?;
        panels.push(Panel::Cartesian(LineChart { title: "By order".to_owned(), ..lower }));
    }
    Figure::in_columns(name, title, 1, &panels)
}

/// Upper end of the band in which balls pass, Hz.
fn low_band_hz(frequencies: &BearingFrequencies, band_hz: f64) -> f64 {
    let passes = PASSES_SHOWN * frequencies.ball_pass_outer_hz;
    if passes > 0.0 { band_hz.min(passes) } else { band_hz }
}

/// The same lines over frequency with a second axis of orders; amplitudes end where those of the drawing do.
fn interactive(
    live: &mut Live,
    (name, title): (&str, &str),
    lines: &[Samples],
    frequencies: &BearingFrequencies,
    band_hz: f64,
) {
    let highest = lines.iter().flat_map(|line| line.y).fold(0.0, |most: f64, a| most.max(*a));
    let least = highest * 10f64.powi(-(DECADES as i32));
    let values: Vec<Vec<f64>> = lines.iter().map(|l| l.y[1..].iter().map(|a| a.max(least)).collect()).collect();
    let samples = lines.iter().zip(&values).map(|(l, y)| Samples { label: l.label, x: &l.x[1..], y });
    let panel = History { title: "", quantity: amplitude(), samples: samples.collect() };
    let view = |name: &str, to: f64| View { name: name.to_owned(), from: 0.0, to };
    let low = low_band_hz(frequencies, band_hz);
    let mut views = vec![view("Whole band", band_hz)];
    if low < band_hz {
        views.push(view(&format!("To {PASSES_SHOWN} BPFO"), low));
    }
    live.add(Plan {
        name,
        title,
        kind: Kind::Spectrum,
        abscissa: Axis::new("Frequency", "Hz"),
        panels: &[panel],
        views,
        marks: marks(frequencies).into_iter().filter(|mark| mark.at <= band_hz).collect(),
        shaft_hz: Some(frequencies.shaft_hz).filter(|hz| *hz > 0.0),
    });
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

/// Harmonics that are marked of each characteristic frequency.
const HARMONICS: [(&str, usize); 5] = [("BPFO", 5), ("BPFI", 5), ("FTF", 1), ("BSF", 2), ("f_r", 2)];

impl LiveMark {
    /// True if it marks passes of balls over a point of a race.
    fn passes(&self) -> bool {
        matches!(self.family, "BPFO" | "BPFI")
    }
}

/// The characteristic frequencies by the names of the field, f_r the turns of the shaft; twice BSF is what a ball
/// defect excites. Fundamentals come first: where labels crowd, these keep theirs.
fn marks(f: &BearingFrequencies) -> Vec<LiveMark> {
    let hz = [f.ball_pass_outer_hz, f.ball_pass_inner_hz, f.cage_hz, f.ball_spin_hz, f.shaft_hz];
    let most = HARMONICS.iter().map(|(_, count)| *count).max().unwrap_or(0);
    let mut marks = Vec::new();
    for multiple in 1..=most {
        for ((family, _), hz) in HARMONICS.iter().zip(hz).filter(|((_, count), hz)| multiple <= *count && *hz > 0.0) {
            let label = if multiple == 1 { (*family).to_owned() } else { format!("{multiple} {family}") };
            marks.push(LiveMark { family, label, at: multiple as f64 * hz });
        }
    }
    marks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_marks_have_the_names_of_the_field_and_are_multiples() {
        let frequencies = BearingFrequencies::from_run(600.0, 3000.0, 1400.0, 0.0, 13).unwrap();
        let all = marks(&frequencies);
        let at = |label: &str| all.iter().find(|m| m.label == label).map(|m| m.at).unwrap();
        assert!((at("BPFO") - 13.0 * at("FTF")).abs() < 1e-9);
        assert!((at("BPFO") + at("BPFI") - 13.0 * at("f_r")).abs() < 1e-9);
        assert_eq!(at("2 BSF"), frequencies.ball_defect_hz);
        assert_eq!(at("5 BPFI"), 5.0 * frequencies.ball_pass_inner_hz);
        assert_eq!(all[..5].iter().map(|m| m.label.as_str()).collect::<Vec<_>>(), HARMONICS.map(|(name, _)| name));
        let at_rest = BearingFrequencies::from_run(0.0, 0.0, 0.0, 0.0, 13).unwrap();
        assert!(marks(&at_rest).is_empty());
    }
}
