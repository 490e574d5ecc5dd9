//! An outer-race defect: not a claim with a number of the paper, but what its section 2.3 is for.

use super::settled::signal;
use super::{CLEARLY, claim};
use crate::error::PaperError;
use crate::transient::{Transient, Window};
use crate::validate::row::Row;
use tribodyn_signal::{Spectrum, envelope_spectrum};

/// Band whose amplitude the defect modulates: from above the ring on its support to the end of the filter's pass band,
/// Hz.
const BAND: [f64; 2] = [3000.0, 9984.0];
/// Harmonics of the passing frequency that must be there.
const HARMONICS: usize = 3;

fn envelope(window: &Window) -> Result<Spectrum, PaperError> {
    Ok(envelope_spectrum(&signal(window), window.rate_hz(), Some(BAND))?)
}

pub(super) fn rows(defect: &Transient, healthy: &Transient) -> Result<Vec<Row>, PaperError> {
    let [with, without] = [defect, healthy].map(|run| run.settled());
    let (spectrum, healthy) = (envelope(&with)?, envelope(&without)?);
    let count = defect.case.geometry.ball_count as f64;
    let passing = count * with.cage_hz();
    let line = spectrum.line_spacing_hz();
    let family = spectrum.harmonic_family(passing, HARMONICS, 1.0)?;
    let found = family.lines.len();
    let off = family.lines.iter().fold(0.0, |most: f64, l| most.max(l.off_lines.abs()));
    let height = |s: &Spectrum, w: &Window| s.amplitude_near(count * w.cage_hz(), line);
    let [ours, theirs] = [height(&spectrum, &with), height(&healthy, &without)];
    let worst = if found == HARMONICS { off } else { f64::INFINITY };
    let text = "a defect of the outer race shows at the ball passing frequency and its multiples";
    let measured = "largest distance of the envelope's first three lines from multiples of 13 f_c, in lines";
    let above = family.lines.iter().map(|l| l.amplitude / l.floor_amplitude).fold(f64::INFINITY, f64::min);
    Ok(vec![
        claim("defect.place", text, measured).row(
            worst,
            worst <= 1.0,
            format!(
                "met up to 1; envelope of the outer ring's x acceleration from 3 to 10 kHz, 13 f_c = {passing:.2} \
            Hz, lines {line:.2} Hz apart; least height over the floor {above:.1}"
            ),
        ),
        claim("defect.height", text, "height of the envelope's line at 13 f_c over that of the run without defect")
            .row(ours / theirs, ours / theirs > CLEARLY, format!("met above 1.5; {ours:.3} against {theirs:.3} m/s²")),
    ])
}
