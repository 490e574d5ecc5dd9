//! FMUs on disk: a whole one or none, compiled or not, and what is refused. What they compute is tested in
//! `tribodyn-study` and, by FMPy, in the Python package.

use super::{Outcome, Scratch, command, fixture, run};
use std::ffi::OsStr;
use std::fs;

fn fmu(scratch: &Scratch, rest: &[&dyn AsRef<OsStr>]) -> Outcome {
    let (case, output) = (fixture("angular-7210.ron"), scratch.0.join("bearing.fmu"));
    let start: [&dyn AsRef<OsStr>; 4] = [&"fmu", &case, &"-o", &output];
    run(&[&start[..], rest].concat())
}

#[test]
fn identity_an_fmu_is_the_same_twice_and_replaces_itself() {
    let scratch = Scratch::new();
    let made = |_| {
        let answer = fmu(&scratch, &[&"--no-compile", &"--json"]).json();
        assert_eq!((answer["fmi_version"].as_str(), answer["platforms"].as_array().unwrap().len()), (Some("2.0"), 0));
        fs::read(scratch.0.join("bearing.fmu")).unwrap()
    };
    let [first, second] = [0, 1].map(made);
    assert!(first == second && first.starts_with(b"PK\x03\x04") && scratch.names() == ["bearing.fmu"]);
}

/// A compiler that is not there, or fails, leaves the sources, and is told.
#[test]
fn limit_without_a_compiler_the_sources_are_left() {
    for compiler in ["/nowhere/cc", "false"] {
        let scratch = Scratch::new();
        let (case, output) = (fixture("angular-7210.ron"), scratch.0.join("bearing.fmu"));
        let done = command(&[&"fmu", &case, &"-o", &output, &"--json"]).env("CC", compiler).output().unwrap();
        let answer: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        assert!(answer["platforms"].as_array().unwrap().is_empty() && output.exists());
        let warnings = answer["warnings"].to_string();
        assert!(warnings.contains("the sources alone") && warnings.contains(compiler), "{warnings}");
    }
}

#[test]
fn limit_what_makes_no_fmu_is_refused_and_nothing_written() {
    let scratch = Scratch::new();
    let wave = "deviations.outer.waves=[(order: 14, amplitude: um(0.2), phase: deg(0))]";
    fmu(&scratch, &[&"--set", &wave]).fails(2, &["angular-7210.ron", "`deviations`"]);
    fmu(&scratch, &[&"--set", &"geometry.ball_count=0"]).fails(2, &["geometry.ball_count"]);
    assert!(scratch.names().is_empty(), "{:?}", scratch.names());
    let case = scratch.file("case.ron", fs::read_to_string(fixture("angular-7210.ron")).unwrap());
    run(&[&"fmu", &case, &"-o", &case, &"--force"]).fails(2, &["would replace the case file"]);
    let theirs = scratch.file("bearing.fmu", "somebody's");
    fmu(&scratch, &[&"--no-compile"]).fails(2, &["not an FMU that tribodyn wrote", "--force"]);
    assert_eq!(fs::read_to_string(theirs).unwrap(), "somebody's");
}
