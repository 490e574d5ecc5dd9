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
    numbers(sample, &mut |_, values| sum += values.iter().map(|v| v * 0.0).sum::<f64>());
    if sum == 0.0 {
        return Ok(());
    }
    let mut found = None;
    numbers(sample, &mut |field, values| {
        if found.is_none() {
            found = values.iter().find(|v| !v.is_finite()).map(|&value| (field.to_owned(), value));
        }
    });
    let (mut field, mut value) = found.unwrap_or_else(|| ("time_s".to_owned(), sample.time_s));
    // Numbers of balls are named without their ball above.
    for (index, ball) in sample.balls.iter().enumerate() {
        let mut here = None;
        ball_numbers(ball, &mut |name, values| {
            here = here.take().or_else(|| values.iter().find(|v| !v.is_finite()).map(|&v| (name, v)));
        });
        if let Some((name, wrong)) = here
            && field == name
        {
            (field, value) = (format!("balls[{index}].{name}"), wrong);
            break;
        }
    }
    Err(RecordError::NotFinite { field, value })
}

type Visit<'a> = dyn FnMut(&'static str, &[f64]) + 'a;

fn numbers(sample: &Sample, visit: &mut Visit) {
    visit("time_s", &[sample.time_s]);
    ring_numbers(["inner.angle_rad", "inner.motion", "inner.ball_force_n", "inner.torque_nm"], &sample.inner, visit);
    ring_numbers(["outer.angle_rad", "outer.motion", "outer.ball_force_n", "outer.torque_nm"], &sample.outer, visit);
    let (c, p, w) = (&sample.cage, &sample.power, &sample.wear);
    visit("cage.angle_rad", &[c.angle_rad]);
    visit("cage.speed_rad_s", &[c.speed_rad_s, c.acceleration_rad_s2]);
    visit("cage torque", &[c.ball_torque_nm, c.fluid_torque_nm]);
    visit("power in", &[p.shaft_w, p.load_w]);
    visit("power lost at the races", &[p.friction_inner_w, p.friction_outer_w, p.contact_damping_w]);
    visit("power lost to fluid and supports", &[p.drag_w, p.churning_w, p.support_w]);
    visit("power lost at the cage", &[p.pocket_friction_w, p.pocket_damping_w, p.cage_w]);
    visit("energy_j", &[p.energy_j, p.imbalance_j, p.throughput_j]);
    visit("worn volume", &[w.volume_inner_m3, w.volume_outer_m3, w.volume_cage_m3]);
    visit("coating left", &[w.coating_inner_min_m, w.coating_outer_min_m]);
    for ball in &sample.balls {
        ball_numbers(ball, visit);
    }
}

fn ring_numbers(names: [&'static str; 4], r: &RingSample, visit: &mut Visit) {
    visit(names[0], &[r.angle_rad, r.speed_rad_s]);
    visit(names[1], &r.displacement_m);
    visit(names[1], &r.velocity_m_s);
    visit(names[1], &r.acceleration_m_s2);
    visit(names[2], &r.ball_force_n);
    visit(names[3], &[r.torque_nm]);
}

fn ball_numbers(b: &BallSample, visit: &mut Visit) {
    visit("azimuth_rad", &[b.azimuth_rad]);
    visit("orbital_speed_rad_s", &[b.orbital_speed_rad_s, b.orbital_acceleration_rad_s2]);
    visit("position", &[b.orbit_radius_m, b.axial_displacement_m]);
    visit("velocity_m_s", &b.velocity_m_s);
    visit("spin_rad_s", &b.spin_rad_s);
    visit("drag_n", &[b.drag_n]);
    visit("pocket_lead_rad", &[b.pocket_lead_rad]);
    visit("pocket_force_n", &[b.pocket_force_n, b.wear_rate_cage_m3_s]);
    visit("pocket_friction_n", &b.pocket_friction_n);
    contact_numbers(["inner contact", "inner slip", "inner wear"], &b.inner, visit);
    contact_numbers(["outer contact", "outer slip", "outer wear"], &b.outer, visit);
}

fn contact_numbers(names: [&'static str; 3], c: &ContactSample, visit: &mut Visit) {
    visit(names[0], &[c.angle_rad, c.approach_m, c.load_n, c.normal_force_n, c.peak_pressure_pa]);
    visit(names[0], &c.semi_axes_m);
    visit(names[1], &[c.spin_ratio_per_m, c.rolling_speed_m_s, c.power_loss_w]);
    visit(names[1], &c.traction_n);
    visit(names[1], &c.slide_to_roll);
    visit(names[2], &[c.wear_rate_m3_s, c.bare, c.depth_m]);
}
