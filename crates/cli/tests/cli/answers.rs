//! Answers of the commands: the promised JSON fields, and numbers against sources of their own.

use super::{assert_close, fixture, run, run_words};
use serde_json::Value;

/// The field as a number; its absence fails the test.
#[track_caller]
fn number(value: &Value, field: &str) -> f64 {
    let found = value.get(field).unwrap_or_else(|| panic!("no field `{field}`"));
    found.as_f64().unwrap_or_else(|| panic!("`{field}` is {found}, not a number"))
}

#[test]
fn limit_hertz_sphere_on_flat() {
    // Johnson, Contact Mechanics, section 4.2: a³ = 3QR/(4E*), δ = a²/R, p = 3Q/(2πa²), E* = E/(2(1 − ν²)) here.
    let (radius, load) = (6.35e-3, 100.0);
    let modulus = 206e9 / (2.0 * (1.0 - 0.3f64.powi(2)));
    let a = (0.75 * load * radius / modulus).cbrt();
    for (bodies, options) in [
        ("--body1 6.35,6.35 --body2 inf,inf", ""),
        ("--body1 inf,inf --body2 6.35,6.35", "--young1 206 --poisson1 0.3 --young2 206 --poisson2 0.3"),
        // Equal crossed cylinders make the same gap.
        ("--body1 6.35,inf --body2 6.35,inf", "--angle 90"),
    ] {
        let answer = run_words(&format!("hertz {bodies} --load 100 {options} --json")).json();
        for (field, expected) in [
            ("ellipticity", 1.0),
            ("semi_major_m", a),
            ("semi_minor_m", a),
            ("peak_pressure_pa", 1.5 * load / (std::f64::consts::PI * a * a)),
            ("approach_m", a * a / radius),
            ("stiffness_n_per_m_1_5", load * (radius / (a * a)).powf(1.5)),
        ] {
            assert_close(number(&answer, field), expected, 1e-13);
        }
        assert_eq!(answer.as_object().unwrap().len(), 9);
    }
}

/// Johnson, Contact Mechanics, section 4.2c: b² = 4wR/(πE*), p = 2w/(πb), largest shear stress 0.300 p at 0.786 b.
#[test]
fn limit_hertz_cylinders_along_a_line() {
    let (per_length, modulus) = (4000.0 / 0.012, 206e9 / (2.0 * (1.0 - 0.3f64.powi(2))));
    let radius = 1.0 / (1.0 / 0.005 + 1.0 / 0.025);
    let b = (4.0 * per_length * radius / (std::f64::consts::PI * modulus)).sqrt();
    let answer = run_words("hertz --body1 5,inf --body2 25,inf --length 12 --load 4000 --json").json();
    assert_close(number(&answer, "half_width_m"), b, 1e-13);
    let pressure = number(&answer, "peak_pressure_pa");
    assert_close(pressure, 2.0 * per_length / (std::f64::consts::PI * b), 1e-13);
    assert_close(answer["max_shear_pa"][0].as_f64().unwrap() / pressure, 0.3003, 1e-4);
    assert_close(answer["max_shear_depth_m"][1].as_f64().unwrap() / b, 0.7862, 1e-4);
}

/// Below a circle the largest shear stress is 0.310 of the peak pressure at 0.481 of the radius for ν = 0.3 (Johnson,
/// Contact Mechanics, 1985, 4.23), and a rigid body halves the approach of two alike.
#[test]
fn limit_hertz_below_the_surface_and_against_a_rigid_body() {
    let answer = run_words("hertz --body1 6.35,6.35 --body2 inf,inf --load 100 --json").json();
    let (radius, peak) = (number(&answer, "semi_major_m"), number(&answer, "peak_pressure_pa"));
    let below = |field: &str| answer[field][0].as_f64().unwrap();
    assert!((below("max_shear_pa") / peak - 0.310).abs() < 5e-4, "{answer}");
    assert!((below("max_shear_depth_m") / radius - 0.481).abs() < 1e-3, "{answer}");
    assert!((below("von_mises_pa") / peak - 0.620).abs() < 1e-3, "{answer}");
    let rigid = run_words("hertz --body1 6.35,6.35 --body2 inf,inf --load 100 --young2 inf --json").json();
    let ratio = number(&rigid, "approach_m") / number(&answer, "approach_m");
    assert!((ratio - 0.5f64.powf(2.0 / 3.0)).abs() < 1e-9, "{ratio}");
    run_words("hertz --body1 6,6 --body2 6,6 --load 9 --young1 inf --young2 inf").fails(2, &["--young2 inf", "rigid"]);
    let none = run_words("hertz --body1 6,6 --body2 6,6 --load 0 --json").json();
    assert!(none["max_shear_pa"].is_null(), "{none}");
}

#[test]
fn identity_hertz_concave_groove() {
    let answer = run_words("hertz --body1 11.115,11.115 --body2 45,-11.63 --load 1850 --young1 200 --json").json();
    let [k, a, b] = ["ellipticity", "semi_major_m", "semi_minor_m"].map(|field| number(&answer, field));
    let [p, delta, stiffness] =
        ["peak_pressure_pa", "approach_m", "stiffness_n_per_m_1_5"].map(|field| number(&answer, field));
    assert!(k > 4.0 && k < 12.0, "{k}");
    assert_close(a / b, k, 1e-14);
    assert_close(p * std::f64::consts::PI * a * b / 1.5, 1850.0, 1e-13);
    assert_close(stiffness * delta.powf(1.5), 1850.0, 1e-13);
    let unloaded = run_words("hertz --body1 11.115,11.115 --body2 45,-11.63 --load 0 --json").json();
    assert_eq!(["peak_pressure_pa", "approach_m"].map(|field| number(&unloaded, field)), [0.0, 0.0]);
}

#[test]
fn paper_traction_table_2_at_the_tested_pressures() {
    // Zhang et al., Lubricants 2025, 13(8), 352, Table 2: A, B, C, D as printed, to three decimals.
    let rows = [
        ("ag", 2.5, [-0.124, 0.079, 0.698, 0.124]),
        ("ag", 3.0, [-0.116, 0.066, 0.648, 0.116]),
        ("ag", 3.5, [-0.102, 0.062, 0.513, 0.102]),
        ("ptfe", 2.5, [-0.109, 0.103, 0.724, 0.109]),
        ("ptfe", 3.0, [-0.105, 0.096, 0.683, 0.105]),
        ("ptfe", 3.5, [-0.100, 0.086, 0.666, 0.100]),
    ];
    for (coating, pressure, [a, b, c, d]) in rows {
        let answer = run_words(&format!("traction --coating {coating} --pressure {pressure} --slip 0,1,2.5,30 --json"));
        let answer = answer.json();
        for (field, expected) in [("a", a), ("b", b), ("c", c), ("d", d)] {
            assert_close(number(&answer, field), expected, 1e-9);
        }
        let coefficients: Vec<f64> =
            answer["coefficient"].as_array().unwrap().iter().map(|k| k.as_f64().unwrap()).collect();
        assert_eq!(coefficients.len(), 4);
        assert!(coefficients[0].abs() < 1e-15);
        for (slip, found) in [1.0f64, 2.5, 30.0].into_iter().zip(&coefficients[1..]) {
            assert_close(*found, (a + b * slip) * (-c * slip).exp() + d, 1e-9);
        }
        assert_eq!((&answer["clamped"], &answer["extrapolated"]), (&Value::Bool(false), &Value::Bool(false)));
    }
}

#[test]
fn limit_traction_says_where_it_extrapolates_and_clamps() {
    for (pressure, extrapolated, clamped, note) in
        [(2.0, true, false, "outside the tested 2.5 to 3.5 GPa"), (1.0, true, true, "outside 1.5 to 4 GPa")]
    {
        let arguments = format!("traction --coating ag --pressure {pressure} --slip 1");
        let answer = run_words(&format!("{arguments} --json")).json();
        assert_eq!((&answer["extrapolated"], &answer["clamped"]), (&extrapolated.into(), &clamped.into()));
        let outcome = run_words(&arguments);
        assert!(outcome.err.contains(note), "{}", outcome.err);
        assert!(outcome.table().contains("coefficient"));
    }
}

#[test]
fn code_mpmath_jones_harris_of_the_218_bearing() {
    let answer = run(&[&"solve", &fixture("bearing-218.ron"), &"--model", &"jones-harris", &"--json"]).json();
    assert_eq!((&answer["model"], &answer["converged"]), (&"jones-harris".into(), &true.into()));
    let balls = answer["balls"].as_array().unwrap();
    assert_eq!(balls.len(), 16);
    let reference = include_str!("../reference/jones_harris_218.csv");
    let rows = reference.lines().filter(|line| !line.starts_with('#')).skip(1);
    let mut compared = 0;
    for (field, value) in rows.map(|row| row.split_once(',').unwrap()) {
        let expected: f64 = value.parse().unwrap();
        compared += 1;
        if field == "axial_displacement_m" {
            assert_close(number(&answer, "ring_displacement_z_m"), expected, 1e-9);
        } else {
            // The solver stops at a relative residual of 1e-10.
            balls.iter().for_each(|ball| assert_close(number(ball, field), expected, 1e-9));
        }
    }
    assert_eq!(compared, 12);
    let orbit = number(&balls[0], "orbital_speed_rad_s") * 30.0 / std::f64::consts::PI;
    assert_close(number(&answer, "cage_speed_rpm"), orbit, 1e-12);
}

/// Fields of a ball that are plain numbers, and limits between which they lie for the paper's bearing.
const BALL: &[(&str, f64, f64)] = &[
    ("azimuth_deg", 0.0, 360.0),
    ("contact_angle_inner_deg", 20.0, 40.0),
    ("contact_angle_outer_deg", 10.0, 25.0),
    ("load_inner_n", 2e3, 2e4),
    ("load_outer_n", 5e3, 2e4),
    ("approach_inner_m", 1e-5, 1e-4),
    ("approach_outer_m", 1e-5, 1e-4),
    ("peak_pressure_inner_pa", 1.2e9, 3e9),
    ("peak_pressure_outer_pa", 1.2e9, 3e9),
    ("orbital_speed_rad_s", 580.0, 650.0),
    ("orbit_radius_m", 0.08, 0.085),
    ("radial_displacement_m", -1e-3, 2e-3),
    ("semi_axis_across_inner_m", 1e-3, 1e-2),
    ("semi_axis_across_outer_m", 1e-3, 1e-2),
    ("semi_axis_rolling_inner_m", 1e-4, 1e-3),
    ("semi_axis_rolling_outer_m", 1e-4, 1e-3),
    ("angular_velocity_axial_rad_s", -5e3, -2e3),
    ("angular_velocity_radial_rad_s", 0.0, 3e3),
    ("angular_velocity_tangential_rad_s", -500.0, 500.0),
    ("axial_displacement_m", -1e-3, 1e-3),
    ("centrifugal_force_n", 3e3, 4e3),
    ("gyroscopic_moment_nm", 0.1, 50.0),
    ("drag_n", 50.0, 500.0),
    ("traction_inner_n", 1.0, 1e3),
    ("traction_outer_n", 1.0, 1e3),
    ("lateral_traction_inner_n", -2e3, 2e3),
    ("lateral_traction_outer_n", -2e3, 2e3),
    ("slide_to_roll_inner", -0.1, 0.1),
    ("slide_to_roll_outer", -0.1, 0.1),
    ("lateral_slide_to_roll_inner", -0.2, 0.2),
    ("lateral_slide_to_roll_outer", -0.2, 0.2),
    ("spin_ratio_inner_per_m", -100.0, 100.0),
    ("spin_ratio_outer_per_m", -100.0, 100.0),
    ("rolling_speed_inner_m_s", 10.0, 100.0),
    ("rolling_speed_outer_m_s", 10.0, 100.0),
    ("power_loss_inner_w", 1.0, 2e4),
    ("power_loss_outer_w", 1.0, 2e4),
    ("power_loss_fluid_w", 1e3, 3e4),
    ("wear_rate_inner_m3_s", 0.0, 1e-6),
    ("wear_rate_outer_m3_s", 0.0, 1e-6),
    ("pocket_lead_rad", -0.1, 0.1),
    ("pocket_force_n", -1e4, 1e4),
    ("wear_rate_cage_m3_s", 0.0, 1e-6),
];

/// Fields that Jones–Harris has no value for.
const OF_TRACTION: &[&str] = &[
    "drag_n",
    "traction_inner_n",
    "slide_to_roll_outer",
    "power_loss_fluid_w",
    "power_loss_inner_w",
    "wear_rate_outer_m3_s",
];

#[test]
fn limit_jones_harris_says_nothing_about_friction() {
    let answer = run(&[&"solve", &fixture("bearing-218.ron"), &"--model", &"jones-harris", &"--json"]).json();
    assert!(answer.get("shaft_torque_nm").is_none() && answer.get("patch_error_estimate").is_none());
    for ball in answer["balls"].as_array().unwrap() {
        for field in OF_TRACTION {
            assert!(BALL.iter().any(|(name, ..)| name == field) && ball.get(field).is_none(), "{field}");
        }
    }
}

#[test]
fn identity_solve_answers_with_every_promised_field() {
    let answer = run(&[&"solve", &fixture("paper-handset.ron"), &"--model", &"traction", &"--json"]).json();
    assert_eq!((&answer["model"], &answer["converged"]), (&"traction".into(), &true.into()));
    for (field, low, high) in [
        ("cage_speed_rpm", 5700.0, 6000.0),
        ("shaft_torque_nm", 1.0, 500.0),
        ("inner_speed_rad_s", 1466.0, 1466.1),
        ("outer_speed_rad_s", 0.0, 0.0),
        ("residual", 0.0, 1e-10),
        ("iterations", 1.0, 1000.0),
        ("patch_error_estimate", 0.0, 1e-5),
    ] {
        let value = number(&answer, field);
        assert!((low..=high).contains(&value), "{field} = {value}");
    }
    assert!(answer["iterations"].is_u64() && answer["warnings"].is_array());
    for field in ["ring_displacement_x_m", "ring_tilt_y_rad", "ring_load_y_n", "ring_moment_x_nm"] {
        number(&answer, field);
    }
    assert_eq!(answer["balls"].as_array().unwrap().len(), 13);
    for ball in answer["balls"].as_array().unwrap() {
        for &(field, low, high) in BALL {
            let value = number(ball, field);
            assert!((low..=high).contains(&value), "{field} = {value}");
        }
    }
    // The ring carries its load, and the balls carry the ring.
    assert_close(number(&answer, "ring_load_x_n"), 20e3, 1e-9);
    assert_close(number(&answer, "ring_load_z_n"), 44e3, 1e-9);
}

#[test]
fn identity_roots_start_from_the_solution() {
    let case = fixture("paper-handset.ron");
    let plain = run(&[&"solve", &case, &"--model", &"traction", &"--json"]).json();
    let answer = run(&[&"solve", &case, &"--model", &"traction", &"--roots", &"--json"]).json();
    assert!(plain.get("roots").is_none());
    assert_eq!(plain["balls"], answer["balls"]);
    let roots = answer["roots"].as_array().unwrap();
    assert_eq!(roots.len(), 13);
    for (ball, found) in answer["balls"].as_array().unwrap().iter().zip(roots) {
        let solution = &found["solution"];
        assert_eq!(solution["driven"], true);
        assert_close(number(found, "azimuth_deg"), number(ball, "azimuth_deg"), 1e-12);
        for field in ["orbital_speed_rad_s", "slide_to_roll_inner", "slide_to_roll_outer"] {
            assert_close(number(solution, field), number(ball, field), 1e-9);
        }
        assert!(number(solution, "growth_rate_per_s") < 0.0, "the ball's equilibrium is not stable");
        assert!(found["others"].is_array());
    }
    let refused = run(&[&"solve", &case, &"--roots", &"--model", &"jones-harris"]);
    refused.fails(2, &["--roots with --model jones-harris: "]);
}

#[test]
fn identity_options_are_changes_of_the_case() {
    let case = fixture("paper-handset.ron");
    let solve = |rest: &[&str]| {
        let mut arguments: Vec<&dyn AsRef<std::ffi::OsStr>> = vec![&"solve", &case, &"--json"];
        arguments.extend(rest.iter().map(|word| word as &dyn AsRef<std::ffi::OsStr>));
        run(&arguments).json()
    };
    let as_it_is = solve(&[]);
    assert_eq!(as_it_is, solve(&["--model", "steady-orbit", "--varying", "true", "--differential-slip", "true"]));
    let fixed = solve(&["--varying", "false", "--differential-slip", "false"]);
    assert_eq!(fixed, solve(&["--set", "traction.varying=false", "--set", "traction.differential_slip=false"]));
    let moved = (number(&as_it_is, "cage_speed_rpm") - number(&fixed, "cage_speed_rpm")).abs();
    assert!(moved > 0.1, "the options move the cage speed by {moved} r/min only");
}

#[test]
fn identity_tables_fit_a_page_and_hold_what_json_holds() {
    let case = fixture("paper-handset.ron");
    let answer = run(&[&"solve", &case, &"--json"]).json();
    let solved = run(&[&"solve", &case]);
    assert!(solved.table().contains(&format!("{:.3}", number(&answer, "cage_speed_rpm"))));
    assert!(solved.table().contains(&format!("{:.1}", number(&answer["balls"][5], "load_outer_n"))));
    let checked = run(&[&"check", &case]);
    let derived = run(&[&"check", &case, &"--json"]).json();
    assert!(checked.table().contains(&format!("{:.3}", number(&derived, "ball_mass_kg") * 1e3)));
    assert_close(number(&derived, "contact_angle_deg"), 18.0, 1e-14);
    assert_eq!(derived["sources"].as_object().unwrap().len(), super::AG.matches("\": ").count());
    let others =
        ["hertz --body1 6,6 --body2 inf,inf --load 9", "traction --coating ag --pressure 3 --slip 0,1", "--help"];
    let printed = others.map(|line| run_words(line).table().to_owned());
    // The first line of an answer holds the path of the case, which may be long.
    let cases = [&solved, &checked].map(|outcome| outcome.out.lines().skip(1).collect::<Vec<_>>().join("\n"));
    for text in printed.iter().chain(&cases) {
        // Warnings are sentences, as long as they need to be.
        let table = text.lines().filter(|line| !line.starts_with("warning: "));
        assert!(table.clone().all(|line| line.chars().count() <= 120), "{text}");
    }
}
