//! `run`, `recover` and `report`: short transient runs with a cheap patch rule, so that they take seconds in a debug
//! build.

use super::{Outcome, Scratch, assert_close, command, fixture, names, run};
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::{Duration, Instant};
use tribodyn_record::{RunItem, RunReader};

/// Sections that a transient run needs besides the values of the quasi-static case.
const TRANSIENT: &str = "
    supports: (
        inner: (
            mass: kg(12),
            stiffness: (N_per_um(0), N_per_um(0), N_per_um(0)),
            damping: (N_s_per_m(2000), N_s_per_m(2000), N_s_per_m(2000)),
        ),
        outer: (mass: kg(5), stiffness: (N_per_um(500), N_per_um(500)), damping: (N_s_per_m(5000), N_s_per_m(5000))),
    ),
    transient: (
        duration: s(0.004),
        start: QuasiStatic,
        scheme: RungeKutta4(step: us(10)),
        contact_damping: 0.02,
        wear_acceleration: 0,
    ),
    recording: (state_rate: kHz(25.6), ball_rate: kHz(5.12)),
";

/// The case of the fixtures with the sections of a run and a cheap patch rule.
pub fn case(scratch: &Scratch) -> PathBuf {
    let mut text = fs::read_to_string(fixture("paper-handset.ron")).unwrap();
    text = text.replacen("TargetError(relative: 1e-5)", "SplitStrip(across: 5, along: 3)", 1);
    if !text.contains("transient:") {
        text = text.replacen("    numerics:", &format!("{TRANSIENT}\n    numerics:"), 1);
        let cage = "pocket_gap: mm(0.12),\n        inertia: kg_m2(0.002),\n        pocket_damping: s_per_m(0.3),";
        text = text.replacen("pocket_gap: mm(0.12),", cage, 1);
    }
    scratch.file("case.ron", text)
}

pub fn go(case: &Path, recording: &Path, rest: &[&dyn AsRef<OsStr>]) -> Outcome {
    let start: [&dyn AsRef<OsStr>; 4] = [&"run", &case, &"-o", &recording];
    run(&[&start[..], rest].concat())
}

/// Viewers take the span of a recording from the indexes of its chunks: one without messages would begin in 1970.
#[track_caller]
fn opens_at_its_start(recording: &Path) {
    let summary = mcap::Summary::read(&fs::read(recording).unwrap()).unwrap().unwrap();
    let (chunks, statistics) = (summary.chunk_indexes, summary.stats.unwrap());
    assert!(chunks.iter().all(|chunk| !chunk.message_index_offsets.is_empty()), "a chunk has no message");
    let start = chunks.iter().map(|chunk| chunk.message_start_time).min();
    let end = chunks.iter().map(|chunk| chunk.message_end_time).max();
    assert_eq!((start, end), (Some(statistics.message_start_time), Some(statistics.message_end_time)));
}

/// All numbers that are recorded, in the order of the file.
fn items(recording: &Path) -> Vec<RunItem> {
    opens_at_its_start(recording);
    RunReader::open(recording).unwrap().map(|item| item.unwrap()).collect()
}

/// Topic, log time and bytes of all messages, in the order of the file.
fn messages(recording: &Path) -> Vec<(String, u64, Vec<u8>)> {
    opens_at_its_start(recording);
    let bytes = fs::read(recording).unwrap();
    let stream = mcap::MessageStream::new(&bytes).unwrap().map(|message| message.unwrap());
    stream.map(|m| (m.channel.topic.clone(), m.log_time, m.data.into_owned())).collect()
}

pub fn number(value: &serde_json::Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} is missing"))
}

/// Waits until a file is there.
fn wait_for(path: &Path) {
    let start = Instant::now();
    while !path.exists() {
        assert!(start.elapsed() < Duration::from_secs(120), "{} did not come", path.display());
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn identity_a_run_is_recorded_summed_up_and_the_same_twice() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let paths = ["a.mcap", "b.mcap"].map(|name| scratch.0.join(name));
    let duration: [&dyn AsRef<OsStr>; 3] = [&"--duration", &"0.004", &"--json"];
    let answers = paths.clone().map(|path| go(&case, &path, &duration).json());
    let answer = &answers[0];
    assert_eq!(number(answer, "simulated_s"), 102.0 / 25_600.0, "the last sample is the last one within the duration");
    assert_eq!(number(answer, "samples"), 103.0, "at 0 and 102 times 1/25600 s after it");
    // At the start from the quasi-static solution the cage turns with it.
    assert_close(number(answer, "cage_speed_mean_rpm"), number(answer, "cage_speed_start_rpm"), 0.01);
    let power = &answer["power"];
    assert!(number(power, "shaft_w") > 1e5 && number(power, "imbalance_percent").abs() < 1e-4, "{power}");
    assert!(number(&answer["scheme_statistics"], "steps") >= 400.0);
    assert!(number(&answer["stiffness"], "runge_kutta_step_s") > 1e-5);
    assert!(number(&answer["wear"], "volume_inner_um3") > 0.0);
    assert!(fs::read(&paths[0]).unwrap() == fs::read(&paths[1]).unwrap(), "two runs of one case differ");
    assert_eq!(scratch.names(), ["a.mcap", "b.mcap", "case.ron"]);
    let table = go(&case, &paths[0], &[]);
    for part in ["cage speed, mean of last half", "power in: shaft", "longest stable fixed step", "patch rule"] {
        assert!(table.table().contains(part), "{part} is not in {}", table.out);
    }
}

#[test]
fn identity_runs_of_every_scheme_and_solutions_open_at_their_start() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let recording = scratch.0.join("run.mcap");
    for scheme in ["RungeKutta4(step: us(5))", "DormandPrince(tolerance: 1e-4, longest: us(10))", "Fast(step: us(5))"] {
        let set = format!("transient.scheme={scheme}");
        go(&case, &recording, &[&"--duration", &"0.001", &"--set", &set, &"--json"]).json();
        opens_at_its_start(&recording);
    }
    run(&[&"solve", &case, &"-o", &recording, &"--json"]).json();
    opens_at_its_start(&recording);
}

#[test]
fn identity_a_killed_run_goes_on_to_the_same_samples() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let [whole, killed] = ["whole.mcap", "killed.mcap"].map(|name| scratch.0.join(name));
    // Long enough for a checkpoint, which comes twice a second.
    let words = |path: &PathBuf| -> Vec<String> {
        let path = path.to_str().unwrap().to_owned();
        ["run", case.to_str().unwrap(), "-o", &path, "--duration", "0.1"].map(str::to_owned).to_vec()
    };
    let start = |words: &[String]| {
        let words: Vec<&dyn AsRef<OsStr>> = words.iter().map(|word| word as _).collect();
        command(&words).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
    };
    let mut child = start(&words(&killed));
    wait_for(&scratch.0.join("killed.mcap.checkpoint"));
    child.kill().unwrap();
    assert!(!child.wait().unwrap().success(), "the run was over before it could be killed");
    // The lock of a dead process stays and blocks nobody.
    assert_eq!(scratch.names(), ["case.ron", "killed.mcap.active", "killed.mcap.checkpoint", "killed.mcap.lock"]);
    let page = scratch.0.join("page");
    run(&[&"report", &killed, &"-o", &page])
        .fails(2, &["no recording", "killed.mcap.active of an unfinished run", "recover"]);
    // Nothing is lost by giving the command again, and no other case goes on.
    let again: [&dyn AsRef<OsStr>; 2] = [&"--duration", &"0.1"];
    go(&case, &killed, &again).fails(2, &["killed.mcap.checkpoint", "--resume goes on", "--restart forgets"]);
    go(&case, &killed, &[&"--duration", &"0.2", &"--resume"]).fails(2, &["belongs to another case", "differs at line"]);
    let resumed = go(&case, &killed, &[&"--duration", &"0.1", &"--resume", &"--json"]).json();
    assert_eq!(scratch.names(), ["case.ron", "killed.mcap"]);
    let answer = go(&case, &whole, &[&"--duration", &"0.1", &"--json"]).json();
    for name in ["cage_speed_mean_rpm", "samples", "impacts", "power", "wear", "scheme_statistics", "warnings"] {
        assert_eq!(resumed[name], answer[name], "{name}");
    }
    let (killed, whole) = (messages(&killed), messages(&whole));
    assert_eq!(killed.len(), whole.len());
    for (a, b) in killed.iter().zip(&whole) {
        assert!(a == b, "{} at {} ns is another one on {} at {} ns", a.0, a.1, b.0, b.1);
    }
    for topic in
        ["/tf", "/bearing/spectrum", "/bearing/spectrum/cage", "/bearing/orbit", "/bearing/wear", "/bearing/contacts"]
    {
        assert!(whole.iter().any(|(name, ..)| name == topic), "{topic} has no message");
    }
}

#[cfg(unix)]
#[test]
fn identity_an_interrupted_run_is_closed_and_goes_on() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let recording = scratch.0.join("run.mcap");
    let words: [&dyn AsRef<OsStr>; 7] = [&"run", &case, &"-o", &recording, &"--duration", &"30", &"--json"];
    let child = command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    wait_for(&scratch.0.join("run.mcap.checkpoint"));
    let interrupt = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(interrupt.success());
    let output = child.wait_with_output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("stopped after 0.") && message.contains("of 30 s; --resume goes on"), "{message}");
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(number(&answer, "simulated_s") > 0.0);
    assert_eq!(scratch.names(), ["case.ron", "run.mcap", "run.mcap.checkpoint"]);
    let states = |path: &Path| items(path).iter().filter(|item| matches!(item, RunItem::State(_))).count();
    assert_eq!(states(&recording) as f64, number(&answer, "samples"));
    go(&case, &scratch.0.join("other.mcap"), &[&"--resume"]).fails(2, &["no run to continue"]);
}

/// Simulated time of a checkpoint, s.
fn saved_s(checkpoint: &Path) -> Option<f64> {
    let text = fs::read_to_string(checkpoint).ok()?;
    let rest = text.split_once("\"simulated_s\":")?.1;
    rest.split(',').next()?.parse().ok()
}

/// A step of a nanosecond: a millisecond of such a run takes minutes.
#[cfg(unix)]
#[test]
fn limit_a_run_that_hardly_moves_is_saved_and_obeys() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let recording = scratch.0.join("run.mcap");
    let set = "transient.scheme=RungeKutta4(step: us(0.04))";
    let words: [&dyn AsRef<OsStr>; 8] = [&"run", &case, &"-o", &recording, &"--duration", &"30", &"--set", &set];
    let child = command(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let checkpoint = scratch.0.join("run.mcap.checkpoint");
    wait_for(&checkpoint);
    let saved = saved_s(&checkpoint).unwrap();
    assert!(saved < 5e-4, "{saved} s is no part of a millisecond");
    let asked = Instant::now();
    let asking = std::process::Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap();
    assert!(asking.success());
    let output = child.wait_with_output().unwrap();
    // `cargo xtask faults` measures how long; here other tests run beside it.
    assert!(asked.elapsed() < Duration::from_secs(10), "it took {:?} to obey", asked.elapsed());
    assert_eq!(output.status.code(), Some(1));
    assert!(saved_s(&checkpoint).unwrap() >= saved);
    assert_eq!(scratch.names(), ["case.ron", "run.mcap", "run.mcap.checkpoint"]);
    go(&case, &recording, &[&"--set", &"transient.scheme=RungeKutta4(step: s(1e-300))", &"--restart"])
        .fails(2, &["transient.scheme.RungeKutta4.step", "must lie between 1e-12 s and 1e-4 s"]);
}

#[test]
fn limit_two_runs_of_one_recording_do_not_meet() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let recording = scratch.0.join("run.mcap");
    let words: [&dyn AsRef<OsStr>; 6] = [&"run", &case, &"-o", &recording, &"--duration", &"30"];
    let mut child = command(&words).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let pid = format!("pid {}", child.id());
    let lock = scratch.0.join("run.mcap.lock");
    while !fs::read_to_string(&lock).is_ok_and(|text| text.ends_with('}')) {
        std::thread::sleep(Duration::from_millis(5));
    }
    // Before there is a checkpoint, and when there is one.
    for _ in 0..2 {
        for rest in ["--duration=30", "--resume", "--restart"] {
            go(&case, &recording, &[&rest]).fails(1, &["run.mcap: another process is writing it", &pid, " since "]);
        }
        wait_for(&scratch.0.join("run.mcap.checkpoint"));
    }
    assert!(child.try_wait().unwrap().is_none(), "the first run ended");
    child.kill().unwrap();
    child.wait().unwrap();
    go(&case, &recording, &[&"--restart", &"--duration", &"0.001"]).table();
    assert_eq!(scratch.names(), ["case.ron", "run.mcap"]);
    scratch.file("run.mcap.lock", "somebody's notes");
    go(&case, &recording, &[]).fails(2, &["run.mcap.lock is not a lock of this program"]);
    assert_eq!(fs::read_to_string(&lock).unwrap(), "somebody's notes");
}

#[test]
fn limit_a_run_that_fails_keeps_what_was_recorded() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let recording = scratch.0.join("run.mcap");
    let set = "transient.scheme=RungeKutta4(step: us(80))";
    let outcome = go(&case, &recording, &[&"--duration", &"0.05", &"--set", &set]);
    outcome.fails(1, &["too long", "stable up to", "what was recorded before is in", "run.mcap"]);
    assert_eq!(scratch.names(), ["case.ron", "run.mcap"]);
    let log: Vec<String> = items(&recording)
        .into_iter()
        .filter_map(|item| if let RunItem::Log(row) = item { Some(row.message) } else { None })
        .collect();
    assert!(log.iter().any(|line| line.contains("the run was broken off")), "{log:?}");
    assert!(log.iter().any(|line| line.contains("beyond the stability")), "{log:?}");
}

#[test]
fn limit_bad_input_writes_nothing() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let recording = scratch.0.join("run.mcap");
    let refused = |rest: &[&dyn AsRef<OsStr>], parts: &[&str]| go(&case, &recording, rest).fails(2, parts);
    refused(&[&"--duration", &"-1"], &["--duration -1: ", "transient.duration"]);
    refused(&[&"--duration", &"NaN"], &["--duration NaN: ", "transient.duration"]);
    refused(&[&"--set", &"transient.scheme=Euler"], &["transient.scheme"]);
    refused(&[&"--set", &"transient=None"], &["transient"]);
    refused(&[&"--resume", &"--restart"], &["--resume", "--restart"]);
    go(&case, &case, &[]).fails(2, &["would replace the case file"]);
    go(&case, &scratch.0.join("no/run.mcap"), &[]).fails(1, &["no/run.mcap"]);
    assert_eq!(scratch.names(), ["case.ron"]);
    let checkpoint = scratch.file("run.mcap.checkpoint", "no JSON");
    refused(&[&"--resume"], &["run.mcap.checkpoint is not a checkpoint", "--restart"]);
    fs::write(checkpoint, r#"{"format": 99, "version": "9.9.9"}"#).unwrap();
    refused(&[&"--resume"], &["is of version 9.9.9, format 99"]);
}

#[cfg(target_os = "linux")]
#[test]
fn limit_a_full_disk_is_told_and_leaves_a_recording_to_recover() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let recording = scratch.0.join("run.mcap");
    // A limit on the size of files, the signal that goes with it ignored, fails as a full disk does.
    let line = "trap '' XFSZ; ulimit -f 1200; exec \"$0\" \"$@\"";
    let output = std::process::Command::new("bash")
        .args(["-c", line, env!("CARGO_BIN_EXE_tribodyn"), "run"])
        .arg(&case)
        .arg("-o")
        .arg(&recording)
        .args(["--duration", "0.3"])
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    for part in ["after 0.", "cannot write", "File too large", "tribodyn recover", "run.mcap.active"] {
        assert!(message.contains(part), "{part} is not in: {message}");
    }
    assert!(!recording.exists(), "a torn recording has the name of a whole one");
    let saved = scratch.0.join("saved.mcap");
    let answer = run(&[&"recover", &scratch.0.join("run.mcap.active"), &"-o", &saved, &"--json"]).json();
    assert!(number(&answer, "messages") > 100.0, "{answer}");
    assert!(items(&saved).iter().any(|item| matches!(item, RunItem::State(_))));
}

#[test]
fn identity_a_report_is_made_of_whole_and_torn_recordings() {
    let scratch = Scratch::new();
    let case = case(&scratch);
    let recording = scratch.0.join("run.mcap");
    let ran = go(&case, &recording, &[&"--duration", &"0.025", &"--json"]).json();
    let folder = scratch.0.join("report");
    let answer = run(&[&"report", &recording, &"-o", &folder, &"--json"]).json();
    for name in ["cage_speed_mean_rpm", "outer_acceleration_x_rms_m_s2", "impacts", "power", "wear"] {
        assert_eq!(answer[name], ran[name], "{name}");
    }
    // The run is shorter than the time between two messages of wear: the last one is of its end.
    let wear = &answer["wear"];
    assert_eq!(number(wear, "at_s"), number(&answer, "simulated_s"));
    let by_balls: f64 = answer["ball_wear"].as_array().unwrap().iter().map(|ball| number(ball, "inner_um3")).sum();
    assert_close(number(wear, "volume_inner_um3"), by_balls, 0.01);
    let frequencies = &answer["frequencies"];
    assert_close(number(frequencies, "cage_hz"), number(&ran, "cage_speed_mean_rpm") / 60.0, 1e-12);
    assert_close(number(frequencies, "ball_pass_outer_hz"), 13.0 * number(frequencies, "cage_hz"), 1e-12);
    let figures: Vec<&str> = answer["figures"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
    for name in ["cage-speed", "spectrum", "envelope-spectrum", "orbit-traction", "power-balance", "wear"] {
        assert!(figures.contains(&name), "{name} is not among {figures:?}");
    }
    let mut expected: Vec<String> = figures.iter().flat_map(|n| [format!("{n}.svg"), format!("{n}.png")]).collect();
    expected.extend(["foxglove-layout.json", "report.html", "summary.json", "summary.md"].map(str::to_owned));
    expected.sort();
    assert_eq!(names(&folder), expected);
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert_eq!(page.matches("<svg").count(), figures.len());
    // Data, library and script of the interactive figures are in the page, the licence of the library too.
    assert_eq!(page.matches("<script").count(), 3);
    for outside in ["<script src", "<link", "src=", "@import", "url(http", "fetch(", "XMLHttpRequest"] {
        assert!(!page.contains(outside), "the page loads something: {outside}");
    }
    assert!(page.contains("The MIT License (MIT)") && page.contains("Copyright (c) 2022 Leon Sorokin"));
    for name in ["BPFO", "BPFI", "FTF", "BSF"] {
        assert!(page.contains(&format!("\"family\":\"{name}\"")), "{name} is not marked");
    }
    assert!(page.contains("published") && page.contains("assumed") && page.contains("SplitStrip"));
    // The cheap rule of these tests does not carry accelerations: tables do without, JSON says so.
    assert!(page.contains("not resolved"));
    assert_eq!([&answer["accelerations_supported"], &ran["accelerations_supported"]], [false, false]);
    report_beside_figures_and_torn(&scratch, &recording);
}

/// Figures set beside those of a run, and recordings that are cut or none at all.
fn report_beside_figures_and_torn(scratch: &Scratch, recording: &PathBuf) {
    let figures = scratch.file(
        "figures.csv",
        "id,quantity,published,tolerance,source\nslow,cage_speed_mean_rpm,1,1,nobody\nfast,frequencies.cage_hz,100,1e3,\"all, or none\"\n",
    );
    let folder = scratch.0.join("against");
    let compared = run(&[&"report", recording, &"-o", &folder, &"--against", &figures, &"--json"]).json();
    assert_eq!([&compared["validation"][0]["met"], &compared["validation"][1]["met"]], [false, true]);
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert!(page.contains("1 of 2 figures are met") && page.contains("all, or none"));
    let bad = scratch.file("bad.csv", "id,quantity,published,tolerance,source\nA,cage_speed,1,1,nobody\n");
    run(&[&"report", recording, &"-o", &scratch.0.join("none"), &"--against", &bad])
        .fails(2, &["bad.csv:2:3", "cage_speed", "summary.json"]);
    let torn = scratch.file("torn.mcap.active", &fs::read(recording).unwrap()[..500_000]);
    let folder = scratch.0.join("torn");
    let answer = run(&[&"report", &torn, &"-o", &folder, &"--json"]).json();
    assert_eq!(answer["truncated"], true);
    assert!(fs::read_to_string(folder.join("summary.md")).unwrap().contains("ends before its end mark"));
    let text = scratch.file("text.mcap", "no recording");
    run(&[&"report", &text, &"-o", &scratch.0.join("none")]).fails(2, &["is not an MCAP file"]);
    run(&[&"recover", &text, &"-o", &scratch.0.join("none")]).fails(1, &["is not an MCAP file"]);
    assert!(!scratch.0.join("none").exists());
}
