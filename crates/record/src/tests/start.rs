//! Start and end of a recording: no empty panel, facts, warnings, and the bearing as it was mounted.

use super::run::messages;
use super::sample::{feed, recording, run_bytes};
use super::{BALLS, case, path};
use crate::{RunRecorder, RunRecording, read_run};
use tribodyn_case::{Case, set_value};

/// A default run lasts 0.1 s and is watched at a hundredth of its speed: what comes slowly is there from the first
/// second of that on.
#[test]
fn limit_no_panel_is_empty_at_the_start_of_a_recording() {
    let file = run_bytes(2560, 25_600.0, 5);
    let slow = |topic: &str| -> Vec<f64> {
        let of_topic = messages(&file).into_iter().filter(|m| m.1 == topic);
        of_topic.map(|m| (m.0 - crate::timeline::EPOCH_NS) as f64 * 1e-9).collect()
    };
    for topic in ["/bearing/orbit", "/bearing/coating", "/bearing/wear"] {
        let times = slow(topic);
        assert_eq!(times[0], 0.0, "{topic}");
        assert!(times.windows(2).all(|pair| pair[1] - pair[0] < 0.0101), "{topic}: {times:?}");
    }
    for topic in ["/bearing/spectrum", "/bearing/spectrum/inner", "/bearing/spectrum/cage"] {
        let times = slow(topic);
        // 256 samples of 25.6 kHz take 10 ms.
        assert!(times[0] < 0.0101 && times.len() == 5, "{topic}: {times:?}");
    }
}

/// Facts known before the first step are in the metadata and the log, those known at the end in a record of their own.
#[test]
fn identity_facts_and_warnings_of_a_run_come_back() {
    let (case, path) = (case::case(BALLS), path("run-facts"));
    let facts = [("patch_rule", "SplitStrip".to_owned())];
    let input = RunRecording { facts: &facts, warnings: &["pressure below the tests".to_owned()], ..recording(&case) };
    let mut recorder = RunRecorder::create(&path, &input).unwrap();
    feed(&mut recorder, 30, 10_000.0, 5).unwrap();
    recorder.conclude(&[("steps", "300".to_owned())]).unwrap();
    recorder.finish().unwrap();
    let run = read_run(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert_eq!(run.metadata["simulation"]["patch_rule"], "SplitStrip");
    assert_eq!(run.metadata["outcome"]["steps"], "300");
    let at_start: Vec<&str> =
        run.events.iter().filter(|row| row.is_of_start()).map(|row| row.message.as_str()).collect();
    assert_eq!(at_start, ["pressure below the tests"]);
    assert_eq!((run.states.len(), run.wear.len()), (30, 2));
}

/// A bearing on its seats is recorded as it runs, not as it is drawn.
#[test]
fn regress_a_recording_has_the_geometry_of_the_mounted_bearing() {
    let part = "expansion: per_K(10.4e-6), temperature_rise: K(0)";
    let seat = |diameter: f64| format!("(seat_diameter: mm({diameter}), {part})");
    let mounting = format!("(inner: {}, outer: {}, ball: ({part}))", seat(120.0), seat(215.0));
    let text = include_str!("../../../../fixtures/cases/paper-ag.ron");
    let case = Case::from_ron(&set_value(text, "mounting", &mounting).unwrap()).unwrap();
    let (made, path) = (case::Made::of(&case), path("run-mounted"));
    let mut recorder = RunRecorder::create(&path, &recording(&made)).unwrap();
    feed(&mut recorder, 10, 25_600.0, 5).unwrap();
    recorder.finish().unwrap();
    let run = read_run(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    let found = &run.metadata["simulation"]["free_contact_angle_deg"];
    let solver = case.bearing().unwrap().geometry.contact_angle().to_degrees();
    assert_eq!(found.parse::<f64>().unwrap(), solver);
    assert!((solver - 15.54).abs() < 0.01, "docs/growth.md has 15.54°, not {solver}°");
}

/// A run has no use for the films of its contacts; the recorder puts them in.
#[test]
fn identity_a_recording_has_the_films_of_its_contacts() {
    let text = include_str!("../../../../fixtures/cases/oil-6206.ron");
    let case = Case::from_ron(&set_value(text, "transient.start", "QuasiStatic").unwrap()).unwrap();
    let (made, path) = (case::Made::of(&case), path("run-films"));
    let mut recorder = RunRecorder::create(&path, &recording(&made)).unwrap();
    let mut run = tribodyn_dynamics::Run::new(case.run_inputs().unwrap()).unwrap();
    let mut balls = run.sample().balls;
    assert!(balls.iter().all(|ball| ball.contacts.outer.film.is_none()));
    case.bearing().unwrap().put_films(&mut balls);
    let _ = run.advance(2e-4, &mut recorder).unwrap();
    recorder.finish().unwrap();
    let recorded = read_run(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    let (time, rows) = &recorded.balls[0];
    assert_eq!((*time, rows.len()), (0.0, balls.len()));
    let mut thick = 0;
    for (row, ball) in rows.iter().zip(&balls) {
        let film = ball.contacts.outer.film.unwrap_or_default();
        assert_eq!(row.film_central_outer_um, (1e6 * film.central_m) as f32);
        assert_eq!(row.lambda_ratio_outer, film.lambda_ratio as f32);
        thick += usize::from(row.film_central_outer_um > 0.05);
    }
    assert!(thick > 2, "{thick}");
}
