//! Half a millisecond of the paper's bearing, from its quasi-static start: cage speed over time, and events.

use std::{convert::Infallible, error::Error, fs, ops::ControlFlow};
use tribodyn_case::Case;
use tribodyn_dynamics::{Event, Observer, Run, Sample};

struct Print;

impl Observer for Print {
    type Error = Infallible;
    fn sample(&mut self, sample: &Sample, _with_balls: bool) -> Result<ControlFlow<()>, Infallible> {
        println!("{:.6} s: cage {:.2} rad/s", sample.time_s, sample.cage.speed_rad_s);
        Ok(ControlFlow::Continue(()))
    }
    fn event(&mut self, event: &Event) -> Result<(), Infallible> {
        println!("{:.6} s: {:?}", event.time_s, event.kind);
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/cases/paper-ag.ron");
    let _ = Run::new(Case::from_ron(&fs::read_to_string(path)?)?.run_inputs()?)?.advance(0.5e-3, &mut Print)?;
    Ok(())
}
