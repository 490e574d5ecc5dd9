//! What a sample must be before it is recorded: finite, of the right bearing, not earlier than the last one.

use crate::RecordError;
use tribodyn_dynamics::{BallSample, ContactSample, RingSample, Sample};

/// Refuses a sample that cannot be recorded.
pub(crate) fn check(sample: &Sample, balls: usize, last_time_s: f64) -> Result<(), RecordError> {
    if sample.balls.len() != balls {
        return Err(RecordError::BallCount { solution: sample.balls.len(), case: balls });
    }
    if sample.time_s < last_time_s {
        return Err(RecordError::TimeGoesBack { time_s: sample.time_s, last_s: last_time_s });
    }
    // A finite number times zero is zero: one sum tells of all numbers whether one of them is not.
    let mut sum = 0.0;
    numbers(sample, &mut |_, _, values| sum += values.iter().map(|v| v * 0.0).sum::<f64>());
    if sum == 0.0 {
        return Ok(());
    }
    let mut found = None;
    numbers(sample, &mut |ball, name, values| {
        if let (None, Some(&value)) = (&found, values.iter().find(|v| !v.is_finite())) {
            let field = ball.map_or_else(|| name.to_owned(), |index| format!("balls[{index}] {name}"));
            found = Some(RecordError::NotFinite { field, value });
        }
    });
    found.map_or(Ok(()), Err)
}

/// Gets the ball where the numbers are of one, a name for them, and the numbers.
type Visit<'a> = dyn FnMut(Option<usize>, &'static str, &[f64]) + 'a;

fn numbers(sample: &Sample, visit: &mut Visit) {
    visit(None, "time_s", &[sample.time_s]);
    ring_numbers(["inner.angle_rad", "inner.motion", "inner.ball_force_n", "inner.torque_nm"], &sample.inner, visit);
    ring_numbers(["outer.angle_rad", "outer.motion", "outer.ball_force_n", "outer.torque_nm"], &sample.outer, visit);
    let (c, p, w) = (&sample.cage, &sample.power, &sample.wear);
    visit(None, "cage.angle_rad", &[c.angle_rad]);
    visit(None, "cage.speed_rad_s", &[c.speed_rad_s, c.speed_filtered_rad_s, c.acceleration_rad_s2]);
    visit(None, "cage torque", &[c.ball_torque_nm, c.fluid_torque_nm]);
    visit(None, "power in", &[p.shaft_w, p.load_w]);
    visit(None, "power lost at the races", &[p.friction_inner_w, p.friction_outer_w, p.contact_damping_w]);
    visit(None, "power lost to fluid and supports", &[p.drag_w, p.churning_w, p.support_w]);
    visit(None, "power lost at the cage", &[p.pocket_friction_w, p.pocket_damping_w, p.cage_w]);
    visit(None, "energy_j", &[p.energy_j, p.imbalance_j, p.throughput_j]);
    visit(None, "worn volume", &[w.volume_inner_m3, w.volume_outer_m3, w.volume_cage_m3]);
    visit(None, "coating left", &[w.coating_inner_min_m, w.coating_outer_min_m]);
    for (index, ball) in sample.balls.iter().enumerate() {
        ball_numbers(index, ball, visit);
    }
}

fn ring_numbers(names: [&'static str; 4], r: &RingSample, visit: &mut Visit) {
    visit(None, names[0], &[r.angle_rad, r.speed_rad_s]);
    visit(None, names[1], &r.displacement_m);
    visit(None, names[1], &r.velocity_m_s);
    visit(None, names[1], &r.acceleration_m_s2);
    visit(None, names[2], &r.ball_force_n);
    visit(None, names[3], &[r.torque_nm]);
}

fn ball_numbers(index: usize, b: &BallSample, visit: &mut Visit) {
    let at = Some(index);
    visit(at, "azimuth_rad", &[b.azimuth_rad]);
    visit(at, "orbital_speed_rad_s", &[b.orbital_speed_rad_s, b.orbital_acceleration_rad_s2]);
    visit(at, "position", &[b.orbit_radius_m, b.axial_displacement_m]);
    visit(at, "velocity_m_s", &b.velocity_m_s);
    visit(at, "spin_rad_s", &b.spin_rad_s);
    visit(at, "drag_n", &[b.drag_n]);
    visit(at, "churning_w", &[b.churning_w]);
    visit(at, "churning_nm", &b.churning_nm);
    visit(at, "pocket_lead_rad", &[b.pocket_lead_rad]);
    visit(at, "pocket_force_n", &[b.pocket_force_n, b.wear_rate_cage_m3_s]);
    visit(at, "pocket_friction_n", &b.pocket_friction_n);
    contact_numbers(at, ["inner contact", "inner slip", "inner wear"], &b.inner, visit);
    contact_numbers(at, ["outer contact", "outer slip", "outer wear"], &b.outer, visit);
}

fn contact_numbers(at: Option<usize>, names: [&'static str; 3], c: &ContactSample, visit: &mut Visit) {
    visit(at, names[0], &[c.angle_rad, c.approach_m, c.load_n, c.normal_force_n, c.peak_pressure_pa]);
    visit(at, names[0], &c.semi_axes_m);
    visit(at, names[1], &[c.spin_ratio_per_m, c.rolling_speed_m_s, c.power_loss_w]);
    visit(at, names[1], &c.traction_n);
    visit(at, names[1], &c.slide_to_roll);
    visit(at, names[2], &[c.wear_rate_m3_s, c.bare, c.depth_m]);
}
