//! Taking up a run: the old recording is copied into a new one up to the checkpoint, and a new recorder is shown what
//! the old one had seen, as far as it matters for what comes.

use super::RunError;
use super::checkpoint::{Files, Saved};
use super::tape::{SharedTape, from_hex};
use super::watcher::Watcher;
use crate::failure::Failure;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;
use tribodyn_dynamics::{Event, EventKind, Observer, RingSample, Sample};
use tribodyn_record::wire::tribodyn::{Ball, TransientState};
use tribodyn_record::{RecordError, RunItem, RunReader, recover};

/// Makes `files.earlier` the recording that the checkpoint belongs to, whole; `.active` is free afterwards.
pub fn set_aside(files: &Files) -> Result<(), Failure> {
    // One that stands there already is of a resumption that was stopped before its first checkpoint.
    if files.earlier.exists() {
        return Ok(());
    }
    let source = if files.active.exists() { &files.active } else { &files.recording };
    recover(source, &files.earlier)?;
    Ok(())
}

/// Writes what was recorded up to the checkpoint.
pub fn copy(files: &Files, saved: &Saved, tape: &SharedTape) -> Result<(), Failure> {
    let read = |source| Failure::Read { path: files.earlier.clone(), source };
    let bytes = fs::read(&files.earlier).map_err(read)?;
    let damaged = |source| RecordError::Mcap { action: "read", path: files.earlier.clone(), source };
    let mut copied = 0;
    for message in mcap::MessageStream::new(&bytes).map_err(damaged)?.take(saved.safe_messages as usize) {
        let message = message.map_err(damaged)?;
        let channel = tape.channel(&message.channel.topic).ok_or_else(|| lost(files, copied, saved))?;
        tape.put(channel, message.log_time, &message.data)?;
        copied += 1;
    }
    if copied < saved.safe_messages {
        return Err(lost(files, copied, saved).into());
    }
    for loose in &saved.loose_messages {
        let data = from_hex(&loose.hex).ok_or_else(|| lost(files, copied, saved))?;
        tape.put(loose.channel, loose.log_time_ns, &data)?;
    }
    // From now on a reader of the new file sees all of it.
    tape.flush()?;
    Ok(())
}

fn lost(files: &Files, found: u64, saved: &Saved) -> RunError {
    RunError::Incomplete { path: files.earlier.clone(), found, expected: saved.safe_messages }
}

/// Shows the recorder the run up to the checkpoint: `first` is the sample at time 0, later ones come from the new
/// recording. They set what the recorder derives from the past: orientations, last turn, samples behind spectra, times
/// at which something is due. Displacements and accelerations are as recorded; the spins have single precision, so that
/// the drawn orientation of balls, and that alone, differs in its seventh digit from that of a run without a stop.
pub fn remind(active: &Path, saved: &Saved, first: Sample, watcher: &mut Watcher) -> Result<(), Failure> {
    let logged = saved.past.impacts - (saved.past.unlogged[0].len() as u64).min(saved.past.impacts);
    // A watcher of ours never breaks off.
    let _ = watcher.sample(&first, true)?;
    for _ in 0..logged {
        let kind = EventKind::Impact { ball: 0, azimuth_deg: 0.0, closing_speed_m_s: 0.0, ball_leads: true };
        watcher.remind(&Event { time_s: 0.0, kind })?;
    }
    let mut pending: Vec<&Event> = saved.past.unlogged.iter().flatten().collect();
    pending.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
    let mut pending = pending.into_iter().peekable();
    let mut sample = first;
    let mut previous: Option<Sample> = None;
    let mut show = |sample: &Sample, with_balls: bool, watcher: &mut Watcher| -> Result<(), Failure> {
        while let Some(event) = pending.next_if(|event| event.time_s <= sample.time_s) {
            watcher.remind(event)?;
        }
        let _ = watcher.sample(sample, with_balls)?;
        Ok(())
    };
    for item in RunReader::open(active)? {
        match item? {
            RunItem::State(row) if row.time_s > 0.0 => {
                // Balls, where there are any at this time, follow the state: it is shown when that is known.
                if let Some(waiting) = previous.take() {
                    show(&waiting, false, watcher)?;
                }
                take_state(&mut sample, &row);
                previous = Some(sample.clone());
            }
            RunItem::Balls(time, rows) if time > 0.0 => {
                take_balls(&mut sample, &rows);
                if previous.take().is_some() {
                    show(&sample, true, watcher)?;
                }
            }
            _ => {}
        }
    }
    if let Some(waiting) = previous.take() {
        show(&waiting, false, watcher)?;
    }
    for event in pending {
        watcher.remind(event)?;
    }
    watcher.past = saved.past.clone();
    watcher.warnings.clone_from(&saved.warnings);
    Ok(())
}

/// What the recorder remembers of rings and cage.
fn take_state(sample: &mut Sample, row: &TransientState) {
    let step = row.time_s - sample.time_s;
    sample.time_s = row.time_s;
    let inner = Ring {
        displacement_um: [row.inner_x_um, row.inner_y_um, row.inner_z_um],
        acceleration: [row.inner_acceleration_x_m_s2, row.inner_acceleration_y_m_s2, row.inner_acceleration_z_m_s2],
        speed_rpm: row.inner_speed_rpm,
        angle_deg: Some(row.shaft_angle_deg),
    };
    let outer = Ring {
        displacement_um: [row.outer_x_um, row.outer_y_um, row.outer_z_um],
        acceleration: [row.outer_acceleration_x_m_s2, row.outer_acceleration_y_m_s2, row.outer_acceleration_z_m_s2],
        speed_rpm: row.outer_speed_rpm,
        angle_deg: None,
    };
    inner.set(&mut sample.inner, step);
    outer.set(&mut sample.outer, step);
    let cage_speed = row.cage_speed_rpm * TAU / 60.0;
    let turned = sample.cage.angle_rad + 0.5 * (sample.cage.speed_rad_s + cage_speed) * step;
    sample.cage.angle_rad = nearest_turn(turned, row.cage_angle_deg);
    sample.cage.speed_rad_s = cage_speed;
}

struct Ring {
    displacement_um: [f64; 3],
    acceleration: [f64; 3],
    speed_rpm: f64,
    angle_deg: Option<f64>,
}

impl Ring {
    fn set(&self, ring: &mut RingSample, step: f64) {
        let speed = self.speed_rpm * TAU / 60.0;
        let turned = ring.angle_rad + 0.5 * (ring.speed_rad_s + speed) * step;
        ring.angle_rad = self.angle_deg.map_or(turned, |angle| nearest_turn(turned, angle));
        ring.speed_rad_s = speed;
        ring.displacement_m = self.displacement_um.map(|x| x * 1e-6);
        ring.acceleration_m_s2 = self.acceleration;
    }
}

/// The angle (rad) that is recorded within a turn, degrees, in the turn next to an estimate, rad.
fn nearest_turn(estimate: f64, within_deg: f64) -> f64 {
    let within = within_deg.to_radians();
    within + TAU * ((estimate - within) / TAU).round()
}

fn take_balls(sample: &mut Sample, rows: &[Ball]) {
    for (ball, row) in sample.balls.iter_mut().zip(rows) {
        ball.spin_rad_s = [row.spin_axial_rad_s, row.spin_radial_rad_s, row.spin_tangential_rad_s].map(f64::from);
    }
}

#[cfg(test)]
mod tests {
    use super::nearest_turn;
    use std::f64::consts::TAU;

    #[test]
    fn identity_an_angle_within_a_turn_finds_its_turn() {
        for angle in [-700.0, -1.0, 0.0, 3.0, 6.2, 6.3, 12.6, 9000.5] {
            let within = f64::rem_euclid(angle, TAU).to_degrees();
            assert!((nearest_turn(angle + 0.4, within) - angle).abs() < 1e-9);
            assert!((nearest_turn(angle - 0.4, within) - angle).abs() < 1e-9);
        }
    }
}
