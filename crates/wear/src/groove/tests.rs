use super::*;

const PLACE: GroovePlace = GroovePlace { groove_radius: 0.0158, centre_radius: 0.0835, outer: false };

fn contact(azimuth: f64, angle: f64, volume_rate: f64) -> ContactWear {
    // Slip of a spinning patch: more at the edges, nothing at a place off the middle.
    let strip = |k: usize| {
        let y = (k as f64 + 0.5) / 24.0 - 1.0;
        (1.0 - y * y) * (y - 0.2).abs()
    };
    let across = (0..48).map(strip).collect();
    ContactWear { azimuth, angle, half_width: 0.14, load: 8e3 + 5e3 * azimuth.cos(), volume_rate, across }
}

fn orbit(turning: bool) -> GrooveWear {
    let ball = |k: usize| {
        let azimuth = 0.3 + TAU * k as f64 / 13.0;
        contact(azimuth, 0.5 + 0.06 * azimuth.cos(), 1e-14 * (2.0 + azimuth.cos()))
    };
    GrooveWear { along_orbit: (0..13).map(ball).collect(), ball_count: 13, turning }
}

#[test]
fn identity_the_field_holds_what_archard_takes() {
    for (turning, field_turns) in [(true, true), (false, false), (true, false)] {
        let mut field = GrooveField::new(PLACE, 1e-5, 0.0, field_turns).unwrap();
        let mut wear = orbit(turning);
        let mut total = 0.0;
        for (k, time) in [10.0, 25.0, 40.0].into_iter().enumerate() {
            wear.along_orbit
                .iter_mut()
                .for_each(|c| (c.angle, c.half_width) = (c.angle + 0.01, 0.14 + 0.01 * k as f64));
            let rates = field.depth_rates(&wear).unwrap();
            field.wear(&rates, time);
            total += wear.volume_rate() * time;
        }
        assert!((field.volume() / total - 1.0).abs() < 1e-10, "{:e} {total:e}", field.volume());
        assert!((field.integral() / total - 1.0).abs() < 1e-10, "{:e} {total:e}", field.integral());
    }
}

/// The mean rate over the orbit by the trapezoidal rule, written out.
#[test]
fn identity_volume_rate_is_the_mean_over_the_orbit() {
    let wear = orbit(false);
    let mean = wear.along_orbit.iter().map(|c| c.volume_rate).sum::<f64>() / 13.0;
    assert!((wear.volume_rate() / (13.0 * mean) - 1.0).abs() < 1e-13);
}

#[test]
fn limit_a_constant_state_wears_linearly_and_has_the_life_of_the_closed_form() {
    // One contact, worn evenly over its width from edge to edge of whole columns.
    let width = 20f64.to_radians();
    let even =
        ContactWear { across: vec![1.0; 40], half_width: 0.5 * width, ..contact(0.0, 25f64.to_radians(), 1e-14) };
    let wear = GrooveWear { along_orbit: vec![even], ball_count: 13, turning: true };
    let mut field = GrooveField::new(PLACE, 1e-5, 0.0, true).unwrap();
    let rates = field.depth_rates(&wear).unwrap();
    // The track is narrowest where the inner groove stands nearest to the axis: at the smallest angle.
    let least = PLACE.radius_at(15.25f64.to_radians());
    let per_time = 13.0 * 1e-14 / (TAU * least * PLACE.groove_radius * width);
    let mut depths = Vec::new();
    for _ in 0..5 {
        field.wear(&rates, 100.0);
        depths.push(field.deepest().depth);
    }
    for (k, depth) in depths.iter().enumerate() {
        let expected = 100.0 * (k + 1) as f64 * per_time;
        assert!((depth / expected - 1.0).abs() < 1e-9, "{depth:e} {expected:e}");
    }
    assert!((field.deepest().angle.to_degrees() - 15.25).abs() < 1e-9 && field.deepest().azimuth.is_none());
    let fresh = GrooveField::new(PLACE, 1e-5, 0.0, true).unwrap();
    assert!((fresh.longest(&rates, 1.0) * per_time / 1e-5 - 1.0).abs() < 1e-9);
    assert!((fresh.longest(&rates, 0.1) * per_time / 1e-6 - 1.0).abs() < 1e-9);
}

#[test]
fn limit_a_ring_that_stands_wears_where_it_is_loaded() {
    let mut field = GrooveField::new(PLACE, 1e-5, 0.0, false).unwrap();
    let rates = field.depth_rates(&orbit(false)).unwrap();
    field.wear(&rates, 100.0);
    let azimuth = field.deepest().azimuth.unwrap();
    assert!(azimuth.cos() > 0.9, "{azimuth}");
    // Where the ball stands there, whose rates are as 3 to 1 but for the hats between 13 balls.
    let at = |azimuth: f64| field.under_contact(&contact(azimuth, 0.5 + 0.06 * azimuth.cos(), 0.0)).depth;
    assert!((at(0.01) / at(0.5 * TAU) - 3.0).abs() < 0.3, "{}", at(0.01) / at(0.5 * TAU));
}

/// A depth that is a parabola under the contact comes back as what it is, and steel shows where it is deepest.
#[test]
fn limit_what_a_contact_finds_of_a_known_profile() {
    let mut field = GrooveField::new(PLACE, 1e-5, 0.0, true).unwrap();
    let probe = contact(0.0, 0.5, 0.0);
    let half = probe.half_width * PLACE.groove_radius;
    let columns = field.columns();
    let curvature = 4e-6 / (half * half);
    for column in 0..ACROSS {
        let y = (columns.middle(column) - 0.5) * PLACE.groove_radius;
        field.depth[column] = (8e-6 - 0.5 * curvature * y * y).max(0.0);
    }
    let found = field.under_contact(&probe);
    assert!((found.curvature / curvature - 1.0).abs() < 1e-9, "{} {curvature}", found.curvature);
    // The mean of y² by the pressure is a²/5.
    assert!((found.depth - (8e-6 - 0.1 * 4e-6)).abs() < 2e-9, "{:e}", found.depth);
    assert_eq!(found.bare, 0.0);
    field.depth.iter_mut().for_each(|d| *d += 3e-6);
    let bare = field.under_contact(&probe).bare;
    assert!(bare > 0.9 && bare <= 1.0, "{bare}");
}

#[test]
fn limit_impossible_input_is_refused() {
    assert!(GrooveField::new(PLACE, -1.0, 0.0, true).is_err() && GrooveField::new(PLACE, 1e-5, 1.5, true).is_err());
    assert!(GrooveField::new(GroovePlace { centre_radius: 0.01, ..PLACE }, 1e-5, 0.0, true).is_err());
    let field = GrooveField::new(PLACE, 1e-5, 0.0, true).unwrap();
    for wrong in [
        ContactWear { volume_rate: -1.0, ..contact(0.0, 0.5, 1e-14) },
        ContactWear { half_width: 0.0, ..contact(0.0, 0.5, 1e-14) },
        ContactWear { across: vec![0.0; 4], ..contact(0.0, 0.5, 1e-14) },
    ] {
        let wear = GrooveWear { along_orbit: vec![wrong], ball_count: 13, turning: true };
        assert!(field.depth_rates(&wear).is_err());
    }
}
