//! Claims of the paper that exclude each other, with ours beside both.

use super::contradiction;
use super::settled::share;
use crate::error::PaperError;
use crate::transient::Set;
use crate::validate::row::Row;

pub(super) fn rows(set: &Set) -> Result<Vec<Row>, PaperError> {
    let window = set.ag.settled();
    let [low, high] = window.orbit_limits();
    let mean = window.mean_orbit_rpm();
    let passing = 13.0 * window.cage_hz();
    let at_passing = share(&window, passing)?;
    Ok(vec![
        contradiction(
            "F13.3/T4.dyn",
            "range 5810–5844 r/min against a mean of 5799 r/min: they exclude each other",
            "our mean above our least orbital speed",
            "r/min",
            mean - low,
            format!("ours: {low:.1} to {high:.1} r/min around a mean of {mean:.1}"),
        ),
        contradiction(
            "F13.1/T4.dyn",
            "1260 Hz is 5815 r/min over 13 balls, against 5799 r/min",
            "our 13 f_c over that of 5799 r/min",
            "",
            passing / (13.0 * 5799.0 / 60.0),
            format!(
                "ours {passing:.1} Hz; 5799 r/min gives 1256.5 Hz, whose nearest line in a spectrum of 10 Hz spacing \
                is 1260"
            ),
        ),
        contradiction(
            "F19.4/F13.2",
            "cage frequency only, against a single line at 13 times the cage frequency",
            "part of our variance at multiples of 13 f_c",
            "",
            at_passing,
            format!(
                "{:.3} at multiples of f_c, {:.3} at multiples of half of 13 f_c: every other ball meets the cage \
                alike",
                share(&window, window.cage_hz())?,
                share(&window, 0.5 * passing)?
            ),
        ),
    ])
}
