//! The steady orbit, stiffness and modes as the command gives them.

use super::new::run_in;
use super::{Scratch, assert_close, fixture, run, run_words};

#[test]
fn identity_the_orbit_is_the_mean_of_a_run() {
    let case = fixture("paper-ag.ron");
    let orbit = run(&[&"solve", &case, &"--model", &"steady-orbit", &"--json"]).json();
    assert_eq!(orbit["model"], "steady-orbit");
    assert_eq!((orbit["balls"].as_array().unwrap().len(), orbit["points"].as_array().unwrap().len()), (13, 180));
    // The mean of its run, row T4.dyn of docs/validation.md.
    let speed = orbit["cage_speed_rpm"].as_f64().unwrap();
    assert!((speed / 5793.7 - 1.0).abs() < 1e-4, "{speed}");
    assert!(orbit["residual"].as_f64().unwrap() <= 1e-10);
}

/// Orbits and equilibria answer under the same names, and are rated alike.
#[test]
fn identity_an_orbit_has_all_that_an_equilibrium_has() {
    let case = fixture("paper-handset.ron");
    let solve = |model: &str| run(&[&"solve", &case, &"--model", &model, &"--json"]).json();
    let (orbit, equilibrium) = (solve("steady-orbit"), solve("traction"));
    let names = |answer: &serde_json::Value| answer.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    let lacks = |of: &serde_json::Value, all: &serde_json::Value| {
        names(all).into_iter().filter(|name| of.get(name).is_none()).collect::<Vec<_>>()
    };
    // Whether an orbit is stable is a matter of its growth over a turn, which `modes` has.
    assert_eq!(lacks(&orbit, &equilibrium), ["stable"]);
    assert_eq!(lacks(&orbit["balls"][3], &equilibrium["balls"][3]), [""; 0]);
    assert_eq!(lacks(&orbit["points"][100], &orbit["balls"][3]), [""; 0]);
    let rated = run(&[&"rating", &case, &"--model", &"steady-orbit", &"--json"]).json();
    assert_eq!(rated["model"], "steady-orbit");
    for name in ["rating_life_l10_mrev", "rating_life_l10r_mrev", "static_safety"] {
        assert_eq!(orbit[name], rated[name], "{name}");
        let ratio = orbit[name].as_f64().unwrap() / equilibrium[name].as_f64().unwrap();
        assert!((ratio - 1.0).abs() < 0.05, "{name}: {ratio}");
    }
    assert!(orbit.get("ball_mass_factor").is_none(), "{}", orbit["ball_mass_factor"]);
}

/// A run from the orbit goes on in it; from the equilibrium idle balls push the cage about at first.
#[test]
fn identity_a_run_from_the_orbit_stays_in_it() {
    let scratch = Scratch::new();
    let case = fixture("angular-7210.ron");
    let orbit = run(&[&"solve", &case, &"--json"]).json()["cage_speed_rpm"].as_f64().unwrap();
    let off = |start: &str| {
        let (set, recording) = (format!("transient.start={start}"), scratch.0.join(format!("{start}.mcap")));
        let words: [&dyn AsRef<std::ffi::OsStr>; 9] =
            [&"run", &case, &"--set", &set, &"--duration", &"0.001", &"-o", &recording, &"--json"];
        run(&words).json()["cage_speed_mean_rpm"].as_f64().unwrap() / orbit - 1.0
    };
    let (from_orbit, from_equilibrium) = (off("SteadyOrbit"), off("QuasiStatic"));
    assert!(from_orbit.abs() < 2e-3 && from_equilibrium.abs() > 0.02, "{from_orbit:e} {from_equilibrium:e}");
}

#[test]
fn limit_a_steady_orbit_has_no_other_roots() {
    let answer = run(&[&"solve", &fixture("paper-ag.ron"), &"--model", &"steady-orbit", &"--roots"]);
    answer.fails(2, &["--roots"]);
}

#[test]
fn identity_tables_of_stiffness_hold_the_matrix() {
    let scratch = Scratch::new();
    let (csv, ross) = (scratch.0.join("k.csv"), scratch.0.join("ross.csv"));
    let case = fixture("paper-ag.ron");
    let words: [&dyn AsRef<std::ffi::OsStr>; 11] = [
        &"stiffness",
        &case,
        &"--model",
        &"jones-harris",
        &"--speeds",
        &"7000,14000",
        &"--csv",
        &csv,
        &"--ross",
        &ross,
        &"--json",
    ];
    let answers = run(&words).json();
    let answers = answers.as_array().unwrap();
    assert_eq!(answers.len(), 2);
    let k = |row: usize, column: usize| answers[1]["stiffness"][row][column].as_f64().unwrap();
    assert!((0..5).all(|i| k(i, i) > 0.0));
    let table = std::fs::read_to_string(csv).unwrap();
    // What must be known of the operating point stands after the numbers.
    let numbers = |line: &str| line.split(',').map_while(|v| v.parse().ok()).collect::<Vec<f64>>();
    let last = numbers(table.lines().last().unwrap());
    assert_eq!((last.len(), last[1], last[2 + 4 * 5 + 3]), (26, k(0, 0), k(4, 4)));
    let table = std::fs::read_to_string(ross).unwrap();
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("speed,kxx,kxy,kyx,kyy,kzz,error_estimate,implausible,warnings"));
    let first = numbers(lines.next().unwrap());
    assert!(first.len() == 6 && (first[0] - 7000.0 * std::f64::consts::PI / 30.0).abs() < 1e-9);
}

#[test]
fn limit_modes_are_by_frequency_and_up_to_the_highest() {
    let case = fixture("paper-ag.ron");
    let answer = run(&[&"modes", &case, &"--up-to", &"20000", &"--json"]).json();
    let modes = answer["modes"].as_array().unwrap();
    let frequencies: Vec<f64> = modes.iter().map(|mode| mode["frequency_hz"].as_f64().unwrap()).collect();
    assert!(frequencies.windows(2).all(|pair| pair[0] <= pair[1]) && frequencies.iter().all(|f| *f <= 20000.0));
    // The outer ring swings between its support and the balls.
    assert!(modes.iter().any(|mode| mode["energy_shares"]["outer_ring"].as_f64().unwrap() > 0.5));
    run_words("modes nowhere.ron --up-to 100").fails(2, &["nowhere.ron"]);
}

/// Powers of an orbit are means over its turn, not those of the balls at one instant.
#[test]
fn identity_powers_of_orbits_are_those_of_solve() {
    let scratch = Scratch::new();
    let (case, table) = (fixture("angular-7210.ron"), scratch.0.join("table.csv"));
    let [x, z] = ["ring.x.Force=kN(1.9)", "ring.z.Force=kN(2)"];
    run(&[&"sweep", &case, &"--set", &x, &"--set", &z, &"-o", &table, &"--quiet"]).table();
    let (_, rows) = super::sweep::read(&table);
    let alone = run(&[&"solve", &case, &"--set", &x, &"--set", &z, &"--json"]).json();
    for name in ["power_loss_inner_w", "power_loss_outer_w"] {
        assert_close(super::sweep::value(&rows[0], name), alone[name].as_f64().unwrap(), 1e-9);
    }
    assert!(super::sweep::value(&rows[0], "wear_rate_inner_m3_s") >= 0.0);
}

/// A 6002 whose balls just reach their pockets: no ball that was sent round closed its turns, and what was found in the
/// end was on a mesh too coarse for it. The orbit of the same bearing at a slightly other speed leads to it.
#[test]
fn regress_an_orbit_is_found_by_way_of_a_neighbour() {
    let scratch = Scratch::new();
    run_in(&scratch.0, "new 6002 --radial 200 --axial 0 --speed 1500 --lubricant vg32").table();
    let solved = run_in(&scratch.0, "solve 6002.ron --json").json();
    let warnings = solved["warnings"].to_string();
    assert!(!warnings.contains("mesh") && warnings.contains("no inner contact"), "{warnings}");
    let (cage, carried) = (solved["cage_speed_rpm"].as_f64().unwrap(), solved["ring_load_x_n"].as_f64().unwrap());
    assert!((cage / 597.70 - 1.0).abs() < 1e-5, "{cage} r/min");
    assert!((carried / 200.0 - 1.0).abs() < 1e-4, "{carried} N");
}

/// A 6204 with half of its balls out of contact: two halvings of the mesh left 1.0 % open, so that no stiffness was
/// given; the third leaves a quarter of that.
#[test]
fn regress_a_stiffness_takes_the_mesh_that_it_needs() {
    let scratch = Scratch::new();
    run_in(&scratch.0, "new 6204 --radial 981 --axial 196 --speed 1810 --lubricant grease").table();
    let found = run_in(&scratch.0, "stiffness 6204.ron --json").json();
    let error = found[0]["error_estimate"].as_f64().unwrap();
    assert!(error < 5e-3, "{error}");
    let warnings = found[0]["warnings"].to_string();
    assert!(warnings.contains("the stiffness is uncertain by about 0."), "{warnings}");
}
