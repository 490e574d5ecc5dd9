//! The cage pocket force of a quasi-static solution: lead and lag of the balls over one orbit.
//!
//! A ball that orbits faster than the cage gains ∫ (ω_m(φ) − ω_c)/ω_c dφ on its pocket. What exceeds the pocket's
//! clearance loads the pocket spring. The cage's own phase is where the pocket forces balance the drag on the cage.

use std::f64::consts::PI;
use tribodyn_bearing::PocketForce;

/// Lead of each ball over its pocket (rad) and pocket force on it along the orbit (N).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PocketForces {
    pub lead: Vec<f64>,
    pub force: Vec<f64>,
}

/// Stiffness N/m, clearance angle rad, pitch radius m and drag torque N m (along the orbit's direction: positive
/// retards) of a cage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pocket {
    pub stiffness: f64,
    pub clearance: f64,
    pub radius: f64,
    pub drag_torque: f64,
    pub force: PocketForce,
}

/// Pocket forces from orbital speeds at equispaced azimuths.
pub(crate) fn pocket_forces(orbital_speeds: &[f64], pocket: &Pocket) -> PocketForces {
    let lead = periodic_lead(orbital_speeds);
    let torque = |phase: f64| -> f64 { lead.iter().map(|l| force(l - phase, pocket)).sum::<f64>() * -pocket.radius };
    // Torque of the balls on the cage falls as the cage's phase rises; it must equal the drag.
    let widest = lead.iter().fold(0.0f64, |m, l| m.max(l.abs())) + pocket.clearance;
    let stretch = pocket.drag_torque.abs() / (pocket.stiffness * pocket.radius.powi(2)).max(f64::MIN_POSITIVE);
    let reach = widest + stretch + 1e-9;
    // With play all round there is a range of phases: take its middle.
    let edge = |at_least: bool| {
        let (mut low, mut high) = (-reach, reach);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            let t = torque(middle) - pocket.drag_torque;
            if t > 0.0 || (at_least && t == 0.0) { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    let phase = if pocket.stiffness > 0.0 { 0.5 * (edge(true) + edge(false)) } else { 0.0 };
    let lead: Vec<f64> = lead.iter().map(|l| l - phase).collect();
    let force = lead.iter().map(|&l| force(l, pocket)).collect();
    PocketForces { lead, force }
}

/// Force on the ball: against its lead, none within the clearance.
fn force(lead: f64, pocket: &Pocket) -> f64 {
    let excess = lead.abs() - pocket.clearance;
    let pressed = match pocket.force {
        PocketForce::FromWall => excess,
        PocketForce::AsPrinted => lead.abs(),
    };
    if excess > 0.0 { -lead.signum() * pocket.stiffness * pocket.radius * pressed } else { 0.0 }
}

/// ∫ (ω − ω_c)/ω_c dφ at the balls, by the trigonometric polynomial through the speeds, with zero mean.
fn periodic_lead(speeds: &[f64]) -> Vec<f64> {
    let count = speeds.len();
    let mean = speeds.iter().sum::<f64>() / count as f64;
    if mean == 0.0 {
        return vec![0.0; count];
    }
    let angle = |k: usize, j: usize| 2.0 * PI * ((k * j) % count) as f64 / count as f64;
    let mut lead = vec![0.0; count];
    // The highest harmonic of an even number of balls has its integral zero at every ball.
    for k in 1..count.div_ceil(2) {
        let (mut a, mut b) = (0.0, 0.0);
        for (j, speed) in speeds.iter().enumerate() {
            let (sin, cos) = angle(k, j).sin_cos();
            a += 2.0 / count as f64 * (speed - mean) * cos;
            b += 2.0 / count as f64 * (speed - mean) * sin;
        }
        for (j, value) in lead.iter_mut().enumerate() {
            let (sin, cos) = angle(k, j).sin_cos();
            *value += (a * sin - b * cos) / (k as f64 * mean);
        }
    }
    lead
}

#[cfg(test)]
mod tests {
    use super::*;

    const POCKET: Pocket =
        Pocket { stiffness: 1e6, clearance: 1e-3, radius: 0.08, drag_torque: 0.0, force: PocketForce::FromWall };

    fn speeds(count: usize, f: impl Fn(f64) -> f64) -> Vec<f64> {
        (0..count).map(|j| f(2.0 * PI * j as f64 / count as f64)).collect()
    }

    #[test]
    fn limit_one_harmonic_integrates_exactly() {
        for count in [12, 13] {
            let lead = periodic_lead(&speeds(count, |phi| 600.0 * (1.0 + 0.01 * phi.cos())));
            for (j, l) in lead.iter().enumerate() {
                assert!((l - 0.01 * (2.0 * PI * j as f64 / count as f64).sin()).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn identity_forces_on_a_free_cage_sum_to_zero() {
        let result = pocket_forces(&speeds(13, |phi| 600.0 + 3.0 * phi.cos() + 1.0 * (2.0 * phi).sin()), &POCKET);
        assert!(result.force.iter().any(|f| *f > 1.0) && result.force.iter().any(|f| *f < -1.0));
        let total: f64 = result.force.iter().sum();
        assert!(total.abs() < 1e-6 * result.force.iter().map(|f| f.abs()).sum::<f64>(), "{total}");
    }

    #[test]
    fn identity_drag_on_the_cage_is_carried_by_the_balls() {
        let pocket = Pocket { drag_torque: 0.5, ..POCKET };
        let result = pocket_forces(&speeds(13, |_| 600.0), &pocket);
        let torque: f64 = result.force.iter().map(|f| -f * pocket.radius).sum();
        assert!((torque - 0.5).abs() < 1e-9, "{torque}");
        assert!(result.lead.iter().all(|l| *l > pocket.clearance), "every ball leads and pushes the cage");
    }

    #[test]
    fn limit_play_all_round_gives_no_force() {
        let result = pocket_forces(&speeds(13, |phi| 600.0 + 0.1 * phi.cos()), &POCKET);
        assert!(result.force.iter().all(|f| *f == 0.0));
    }
}
