//! A run with a cage that is free to move, from the case to verdict, recording and report.

use super::run::go;
use super::{Scratch, fixture, run};
use std::ffi::OsStr;
use tribodyn_record::read_run;

/// A 6206 under thrust at 12 000 r/min with lands full of oil, over nine turns of its cage.
const CHANGES: [&str; 7] = [
    "transient.start=QuasiStatic",
    "transient.scheme=Fast(step: us(2))",
    "speed.inner=Constant(rpm(12000))",
    "ring.x=Force(N(0))",
    "ring.z=Force(N(300))",
    "cage.free.lands[0].film.fill=1",
    "cage.free.lands[1].film.fill=1",
];

#[test]
fn identity_a_run_judges_the_motion_of_its_cage_and_a_report_shows_it() {
    let scratch = Scratch::new();
    let recording = scratch.0.join("run.mcap");
    let mut rest: Vec<&dyn AsRef<OsStr>> = vec![&"--duration", &"0.11", &"--json"];
    CHANGES.iter().for_each(|change| rest.extend([&"--set" as &dyn AsRef<OsStr>, change]));
    let ran = go(&fixture("cage-6206.ron"), &recording, &rest).json();
    let cage = &ran["cage"];
    assert_eq!(cage["motion"], "with-reference", "{cage}");
    assert!((cage["whirl_ratio"].as_f64().unwrap() - 1.0).abs() < 0.05, "{cage}");
    let states = read_run(&recording).unwrap().states;
    let last = states.last().unwrap();
    // Off centre by its unbalance and what the balls allow, within its gap of 0.15 mm.
    let radius = last.cage_x_um.hypot(last.cage_y_um);
    assert!(last.cage_free && radius > 1.0 && radius < 150.0 && last.land_gap_um > 0.0, "{last:?}");
    assert!(last.land_film_w > 0.0 && last.land_film_w <= last.cage_w, "{last:?}");
    let folder = scratch.0.join("report");
    let answer = run(&[&"report", &recording, &"-o", &folder, &"--json"]).json();
    assert_eq!(&answer["cage"], cage);
    assert!(answer["figures"].as_array().unwrap().contains(&"cage-motion".into()), "{}", answer["figures"]);
    let page = std::fs::read_to_string(folder.join("report.html")).unwrap();
    assert!(page.contains("turns with the ball group") && page.contains("Centre, tilt and lands of the cage"));
}
