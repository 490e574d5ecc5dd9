//! Ensembles: the rows are runs, the same on any number of threads; what fails or is stopped takes nothing with it.

use super::run::case;
use super::sweep::{read, value};
use super::{Outcome, Scratch, command, names, run};
use std::collections::HashMap;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

const GAP: &str = "cage.pocket_gap=mm(0.6 ± 0.05)";
const LOAD: &str = "ring.z.Force=kN(45..60)";
const FAST: &str = "transient.scheme=Fast(step: us(10))";

fn ensemble(case: &Path, rest: &[&dyn AsRef<OsStr>]) -> Outcome {
    let start: [&dyn AsRef<OsStr>; 7] = [&"ensemble", &case, &"--set", &FAST, &"--duration", &"0.002", &"--quiet"];
    run(&[&start[..], rest].concat())
}

/// The number of an answer at a path with dots between levels; none where it is null.
fn at(answer: &serde_json::Value, path: &str) -> Option<f64> {
    let pointer = format!("/{}", path.replace('.', "/"));
    let found = answer.pointer(&pointer).unwrap_or_else(|| panic!("{path} is missing"));
    assert!(found.is_null() || found.is_number(), "{path} = {found}");
    found.as_f64()
}

/// Columns of figures: all between that of complete members and that of the number of warnings.
fn figures(header: &[String]) -> &[String] {
    let place = |name: &str| header.iter().position(|column| column == name).unwrap();
    &header[place("complete") + 1..place("warnings")]
}

#[test]
fn identity_members_are_runs_with_their_values_on_any_number_of_threads() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let tables = ["1", "2"].map(|threads| {
        let table = scratch.0.join(format!("{threads}.csv"));
        let vary: [&dyn AsRef<OsStr>; 6] = [&"--vary", &GAP, &"--vary", &LOAD, &"--members", &"3"];
        let rest: [&dyn AsRef<OsStr>; 5] = [&"--threads", &threads, &"-o", &table, &"--json"];
        let answer = ensemble(&case, &[&vary[..], &rest].concat()).json();
        assert_eq!(at(&answer["cost"], "threads"), threads.parse().ok());
        (table, answer)
    });
    let [(one, answer), (two, again)] = &tables;
    assert_eq!(fs::read_to_string(one).unwrap(), fs::read_to_string(two).unwrap());
    assert_eq!(answer["quantiles"], again["quantiles"]);
    let (header, rows) = read(one);
    assert_eq!(header[..4], ["member", "cage.pocket_gap [mm]", "ring.z.Force [kN]", "complete"]);
    assert_eq!(header[header.len() - 2..], ["warnings", "error"]);
    assert!(figures(&header).len() > 40, "{header:?}");
    // A row is what `run` answers with its values.
    for row in &rows {
        let gap = format!("cage.pocket_gap=mm({})", row["cage.pocket_gap [mm]"]);
        let load = format!("ring.z.Force=kN({})", row["ring.z.Force [kN]"]);
        let set: [&dyn AsRef<OsStr>; 6] = [&"--set", &FAST, &"--set", &gap, &"--set", &load];
        let recording = scratch.0.join("run.mcap");
        let alone =
            super::run::go(&case, &recording, &[&set[..], &[&"--duration", &"0.002", &"--json"]].concat()).json();
        for name in figures(&header) {
            let in_table = (!row[name].is_empty()).then(|| value(row, name));
            assert_eq!(in_table, at(&alone, name), "{name} of member {}", row["member"]);
        }
        let warnings = ["warnings_at_start", "untested_pressures", "warnings"];
        let count: usize = warnings.iter().map(|list| alone[list].as_array().unwrap().len()).sum();
        assert_eq!(value(row, "warnings") as usize, count);
    }
    quantiles_are_those_of_the_rows(answer, &rows);
    assert_eq!((&answer["members"], &answer["finished"], &answer["failed"]), (&3.into(), &3.into(), &0.into()));
    assert!(
        at(&answer["cost"], "processor_per_member_s").unwrap() > 0.0 && answer["cost"]["wall_per_member_s"].is_f64()
    );
    let simulated = rows.iter().map(|row| value(row, "simulated_s")).sum::<f64>();
    assert_eq!(at(&answer["cost"], "simulated_s"), Some(simulated));
    assert_eq!(answer["varied"][0]["spread"], "mm(0.6 ± 0.05)");
}

/// Of three members the median is the second one, and of the way to it from the first the lower quartile is half.
fn quantiles_are_those_of_the_rows(answer: &serde_json::Value, rows: &[HashMap<String, String>]) {
    for quantiles in answer["quantiles"].as_array().unwrap() {
        let name = quantiles["quantity"].as_str().unwrap();
        let mut values: Vec<f64> =
            rows.iter().filter(|row| !row[name].is_empty()).map(|row| value(row, name)).collect();
        values.sort_by(f64::total_cmp);
        assert_eq!(quantiles["members"], values.len(), "{name}");
        if let [least, middle, _] = values[..] {
            assert_eq!(at(quantiles, "p50"), Some(middle), "{name}");
            assert_eq!(at(quantiles, "p25"), Some(least + 0.5 * (middle - least)), "{name}");
        }
    }
    let spread = |name: &str| rows.iter().map(|row| row[name].as_str()).collect::<std::collections::HashSet<_>>().len();
    assert_eq!((spread("cage_speed_mean_rpm"), spread("simulated_s")), (3, 1));
}

#[test]
fn limit_a_member_that_fails_is_a_row_with_its_reason() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let (table, plots) = (scratch.0.join("table.csv"), scratch.0.join("plots"));
    let gaps: [&dyn AsRef<OsStr>; 4] = [&"--vary", &"cage.pocket_gap=mm(-0.5..0.7)", &"--members", &"4"];
    let outcome = ensemble(&case, &[&gaps[..], &[&"-o", &table, &"--plot", &plots]].concat());
    let (header, rows) = read(&table);
    let failed: Vec<_> = rows.iter().filter(|row| value(row, "cage.pocket_gap [mm]") < 0.0).collect();
    assert!((1..4).contains(&failed.len()), "the seed gives gaps of both signs");
    for row in &rows {
        let bad = value(row, "cage.pocket_gap [mm]") < 0.0;
        assert_eq!((row["complete"] == "true", row["error"].is_empty()), (!bad, !bad));
        assert!(figures(&header).iter().all(|name| !bad || row[name].is_empty()));
    }
    assert!(failed[0]["error"].contains("--vary cage.pocket_gap=mm(-0."), "{}", failed[0]["error"]);
    assert_eq!(outcome.code, 1);
    assert!(outcome.err.contains(&format!("{} of 4 members have no result", failed.len())), "{}", outcome.err);
    for part in ["cage speed, mean of last half", "processor time of a member", "--vary cage.pocket_gap=mm(-0."] {
        assert!(outcome.out.contains(part), "{part} is not in {}", outcome.out);
    }
    let drawn = names(&plots);
    assert!(drawn.len() == 16 && drawn.contains(&"cage-speed.svg".to_owned()), "{drawn:?}");
    // Our own table and figures are replaced.
    assert_eq!(ensemble(&case, &[&gaps[..], &[&"-o", &table, &"--plot", &plots]].concat()).code, 1);
    assert_eq!(scratch.names(), ["case.ron", "plots", "table.csv"]);
}

#[test]
fn limit_bad_ensembles_are_refused_and_nothing_is_written() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let table = scratch.0.join("table.csv");
    let refused = |rest: &[&dyn AsRef<OsStr>], parts: &[&str]| {
        let output: [&dyn AsRef<OsStr>; 2] = [&"-o", &table];
        ensemble(&case, &[rest, &output].concat()).fails(2, parts);
    };
    let vary = |spread: &str, parts: &[&str]| refused(&[&"--vary", &spread, &"--members", &"2"], parts);
    vary("cage.pocket_gap=mm(0.2)", &["mm(0.2)", "is not a spread", "mm(0.2 ± 0.02)", "mm(0.18..0.22)"]);
    vary("cage.pocket_gap=mm(0.2 ± 0)", &["a standard deviation above 0"]);
    vary("cage.pocket_gap=mm(0.3..0.2)", &["from its lower end to a higher one"]);
    vary("cage.pocket_gap=N(0.2 ± 0.02)", &["--vary cage.pocket_gap=N(0.2): ", "case.ron:", "N(0.2)"]);
    vary("cage.pocket=mm(0.2 ± 0.02)", &["--vary cage.pocket=mm(0.2)", "pocket_gap"]);
    vary("cage.pocket_gap=mm(-0.3..-0.2)", &["cage.pocket_gap=mm(-0.25)"]);
    // Sound in the middle, but no whole number of balls is drawn.
    vary("geometry.ball_count=11..15", &["--vary geometry.ball_count=1", "case.ron:"]);
    vary("transient.duration=s(1..2)", &["--duration 0.002 is about the same value"]);
    vary("numerics.max_iterations=2000..3000", &["2500 iterations", "--no-limits"]);
    refused(
        &[&"--vary", &GAP, &"--vary", &"cage.pocket_gap=mm(0.1..0.2)", &"--members", &"2"],
        &["--vary cage.pocket_gap=mm(0.1..0.2): --vary cage.pocket_gap=mm(0.6 ± 0.05) is about the same value"],
    );
    refused(&[&"--vary", &GAP, &"--members", &"0"], &["--members 0: allowed are 1 to 100000"]);
    refused(&[&"--vary", &GAP, &"--members", &"100001"], &["--members 100001: allowed are 1 to 100000"]);
    refused(&[&"--vary", &GAP], &["--members"]);
    refused(&[&"--members", &"2"], &["--vary"]);
    let txt = scratch.0.join("table.txt");
    ensemble(&case, &[&"--vary", &GAP, &"--members", &"2", &"-o", &txt]).fails(2, &["table.txt", ".csv"]);
    let mine = scratch.file("mine.csv", "my,own,numbers\n1,2,3\n");
    ensemble(&case, &[&"--vary", &GAP, &"--members", &"2", &"-o", &mine]).fails(2, &["is not a table that tribodyn"]);
    let plain = super::fixture("bearing-218.ron");
    run(&[&"ensemble", &plain, &"--vary", &GAP, &"--members", &"2", &"--duration", &"1"])
        .fails(2, &["a transient run needs what the case does not have"]);
    assert_eq!(scratch.names(), ["case.ron", "mine.csv"]);
}

#[cfg(unix)]
#[test]
fn limit_an_interrupted_ensemble_keeps_what_is_finished() {
    let scratch = Scratch::new();
    let (case, table) = (case(&scratch), scratch.0.join("table.csv"));
    let words: [&dyn AsRef<OsStr>; 12] = [
        &"ensemble",
        &case,
        &"--vary",
        &GAP,
        &"--members",
        &"100000",
        &"--duration",
        &"0.0002",
        &"-o",
        &table,
        &"--threads",
        &"1",
    ];
    let child = command(&[&words[..], &[&"--json"]].concat()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let child = child.unwrap();
    let began = Instant::now();
    while !scratch.0.join("table.csv.lock").exists() {
        assert!(began.elapsed() < Duration::from_secs(120), "the ensemble did not begin");
        std::thread::sleep(Duration::from_millis(20));
    }
    // Long enough for some members of some milliseconds each, on a busy machine too.
    std::thread::sleep(Duration::from_secs(6));
    let interrupt = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(interrupt.success());
    let output = child.wait_with_output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let finished = answer["finished"].as_u64().unwrap();
    assert!(message.contains(&format!("stopped: {finished} of 100000 members are finished")), "{message}");
    assert!(message.contains("table.csv.rows"), "{message}");
    let (_, rows) = read(&table);
    assert!(rows.len() as u64 == finished && rows.iter().all(|row| row["complete"] == "true"));
    assert_eq!(scratch.names(), ["case.ron", "table.csv", "table.csv.rows"]);
}

/// Killed in the middle and taken up again: the table of one that was not, byte for byte.
#[cfg(unix)]
#[test]
fn identity_a_killed_ensemble_goes_on_to_the_same_table() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let [whole, table] = ["whole.csv", "table.csv"].map(|name| scratch.0.join(name));
    let start: [&dyn AsRef<OsStr>; 8] = [&"--vary", &GAP, &"--vary", &LOAD, &"--members", &"12", &"--threads", &"1"];
    let expected = ensemble(&case, &[&start[..], &[&"-o", &whole, &"--json"]].concat()).json();
    assert_eq!(expected["resumed"], 0);
    let head: [&dyn AsRef<OsStr>; 7] = [&"ensemble", &case, &"--set", &FAST, &"--duration", &"0.002", &"--quiet"];
    let words = [&head[..], &start, &[&"-o", &table]].concat();
    super::kill_after_rows(command(&words), &scratch.0.join("table.csv.rows"), 3);
    assert!(!table.exists());
    // Another ensemble is told apart.
    let other = ensemble(&case, &[&start[..], &[&"--seed", &"2", &"-o", &table]].concat());
    other.fails(2, &["table.csv.rows", "--seed", "--restart"]);
    let answer = ensemble(&case, &[&start[..], &[&"-o", &table, &"--json"]].concat()).json();
    assert!((3..12).contains(&answer["resumed"].as_u64().unwrap()), "{}", answer["resumed"]);
    assert_eq!(answer["quantiles"], expected["quantiles"]);
    assert_eq!(fs::read(&table).unwrap(), fs::read(&whole).unwrap());
    assert_eq!(scratch.names(), ["case.ron", "table.csv", "whole.csv"]);
}

/// A grid has a member for each value with each other, and figures over the first of them.
#[test]
fn identity_a_grid_runs_each_value_with_each_other() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let (table, figures) = (scratch.0.join("grid.csv"), scratch.0.join("figures"));
    let answer = ensemble(
        &case,
        &[
            &"--grid",
            &"ring.z.Force=kN(50..60 in 3)",
            &"--grid",
            &"cage.pocket_friction=0.05,0.1",
            &"-o",
            &table,
            &"--plot",
            &figures,
            &"--json",
        ],
    )
    .json();
    assert_eq!((answer["members"].as_u64(), answer["sampling"].as_str()), (Some(6), Some("grid")), "{answer}");
    let text = fs::read_to_string(&table).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|c| c.contains(name)).unwrap();
    let (load, friction) = (column("ring.z.Force"), column("pocket_friction"));
    let places: Vec<(f64, f64)> =
        rows[1..].iter().map(|row| (row[load].parse().unwrap(), row[friction].parse().unwrap())).collect();
    assert_eq!(places, [(50.0, 0.05), (50.0, 0.1), (55.0, 0.05), (55.0, 0.1), (60.0, 0.05), (60.0, 0.1)]);
    assert!(figures.join("cage-speed.svg").exists());
    let both = ensemble(&case, &[&"--grid", &"ring.z.Force=kN(50),kN(55)", &"--members", &"3"]);
    both.fails(2, &["--members"]);
}
