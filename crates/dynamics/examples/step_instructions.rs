//! Runs the fast scheme over a fixed time for an instruction counter: no clock, no random numbers, the same work every
//! time.
//!
//!     cargo build --release -p tribodyn-dynamics --example step_instructions
//!     valgrind --tool=callgrind --toggle-collect='*measured*' target/release/examples/step_instructions 20 10
//!
//! Arguments: simulated time, ms, and any third one of the rate of samples, kHz (25.6 unless given); the start, ms, is
//! not counted. It prints the number of steps times balls, by which a count is to be divided, and a checksum.

use std::{env, error::Error, fs};
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::Run;

/// The part that is to be counted.
#[inline(never)]
fn measured(run: &mut Run, until_s: f64) -> bool {
    run.advance(until_s, &mut ()).is_ok()
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/cases/paper-ag.ron");
    let mut arguments = env::args().skip(1);
    let mut number = |otherwise: f64| arguments.next().map_or(Ok(otherwise), |text| text.parse::<f64>());
    let (length_ms, start_ms, rate_khz) = (number(20.0)?, number(10.0)?, number(25.6)?);
    let mut text = fs::read_to_string(path)?;
    let rate = format!("kHz({rate_khz})");
    let balls = format!("kHz({})", rate_khz / 5.0);
    // A target that integrates few patches: it is the loops over the balls that are to be counted.
    let target = "TargetError(relative: 1e-4)";
    let changes = [
        ("transient.scheme", "Fast(step: us(20))"),
        ("traction.patch", target),
        ("recording.ball_rate", &balls),
        ("recording.state_rate", &rate),
    ];
    for (path, value) in changes {
        text = set_value(&text, path, value)?;
    }
    let mut run = Run::new(Case::from_ron(&text)?.run_inputs()?)?;
    let _ = run.advance(1e-3 * start_ms, &mut ())?;
    let before = run.statistics();
    if !measured(&mut run, 1e-3 * (start_ms + length_ms)) {
        return Err("the run ended early".into());
    }
    let after = run.statistics();
    let sample = run.sample();
    let steps = after.steps - before.steps;
    println!("steps times balls {} checksum {:e}", steps * sample.balls.len() as u64, sample.cage.angle_rad);
    Ok(())
}
