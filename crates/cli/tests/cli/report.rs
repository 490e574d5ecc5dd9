//! `report`: what a page says of a run, of a solution and of two of them.

use super::run::{case, go, number};
use super::{AG, Scratch, assert_close, fixture, run};
use serde_json::Value;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use tribodyn_case::{set_value, values};

/// A short run of the case of the tests of `run`.
fn recorded(scratch: &Scratch) -> PathBuf {
    let recording = scratch.0.join("run.mcap");
    go(&case(scratch), &recording, &[&"--duration", &"0.012", &"--json"]).json();
    recording
}

/// The text of a file of a report.
fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// The page and the Markdown of a report, markup of the latter taken back.
fn texts(folder: &Path) -> [String; 2] {
    let unescaped = |text: String| text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    let markdown: String = read(folder, "summary.md").chars().filter(|c| *c != '\\').collect();
    [read(folder, "report.html").replace("&quot;", "\""), markdown].map(unescaped)
}

#[test]
fn regress_a_report_holds_loads_speed_and_every_value_of_the_case() {
    let scratch = Scratch::new();
    let recording = recorded(&scratch);
    let folder = scratch.0.join("report");
    let answer = run(&[&"report", &recording, &"-o", &folder, &"--json"]).json();
    let text = fs::read_to_string(scratch.0.join("case.ron")).unwrap();
    let listed = answer["case_values"].as_array().unwrap();
    let all = values(&text);
    assert!(all.len() > 60, "{}", all.len());
    for page in texts(&folder) {
        // Results come first, every input last.
        let opening = page.rfind("What was run").unwrap();
        assert!(opening < page.find("Case: geometry").unwrap());
        for result in ["Results", "Characteristic frequencies", "Power balance", "Operation"] {
            assert!(page.find(result).unwrap() < opening, "{result} comes after what was run");
        }
        for (path, _) in &all {
            let value = listed.iter().find(|v| v["path"] == path.as_str()).unwrap_or_else(|| panic!("{path}"));
            let value = value["value"].as_str().unwrap();
            assert!(page.contains(path.as_str()) && page.contains(value), "{path} = {value} is not in the report");
        }
        for said in ["14000 r/min", "30.16 mm", "RungeKutta4, step 10 µs", "BPFO", "BPFI", "FTF", "BSF", "published"] {
            assert!(page.contains(said), "{said} is not in the report");
        }
        for load in ["ring.x", "ring.z", "transient.duration"] {
            let value = listed.iter().find(|v| v["path"] == load).unwrap()["value"].as_str().unwrap();
            assert!(page.matches(value).count() >= 2, "{load} = {value} is in the opening and among the values");
        }
    }
    assert_eq!(listed.iter().find(|v| v["path"] == "transient.duration").unwrap()["value"], "0.012 s");
    let page = read(&folder, "report.html");
    let (shown, folded) = page.split_once("<details").unwrap();
    assert!(!shown.contains("Case: geometry") && folded.contains("Case: geometry"), "inputs are folded");
    let place = |part: &str| page.find(part).unwrap_or_else(|| panic!("{part} is not on the page"));
    assert!(place(">Results<") < place("<figure id=\"bearing\">"));
    assert!(place("<figure id=\"bearing\">") < place(">Power balance<"));
    let operation = &answer["operation"];
    // A dry bearing has no films, and a report none of no thickness.
    assert!(!operation.as_object().unwrap().keys().any(|key| key.starts_with("film") || key.starts_with("lambda")));
    assert!(number(operation, "friction_torque_mean_nm") > 0.0, "{operation}");
    assert_eq!(number(operation, "load_zone_deg"), 360.0);
    assert_eq!(number(operation, "loaded_balls_min"), 13.0);
    let angles = ["min", "mean", "max"].map(|part| number(operation, &format!("contact_angle_inner_{part}_deg")));
    assert!(15.0 < angles[0] && angles[0] < angles[1] && angles[1] < angles[2] && angles[2] < 40.0, "{angles:?}");
    // 12 ms are about one turn of the cage.
    assert_eq!(answer["settled_at_s"], Value::Null);
    assert!(page.contains("whether it is steady cannot be told"));
    // Rolling at the operating angle and the run differ by the slip.
    let (rolling, computed) = (number(&answer["rolling"], "cage_hz"), number(&answer["frequencies"], "cage_hz"));
    assert!((rolling / computed - 1.0).abs() < 0.05, "{rolling} {computed}");
}

#[test]
fn identity_two_recordings_are_compared_and_solutions_reported() {
    let scratch = Scratch::new();
    let recording = recorded(&scratch);
    let solved = scratch.0.join("solved.mcap");
    let patch = "traction.patch=SplitStrip(across: 5, along: 3)";
    let paper = fixture("paper-handset.ron");
    let solution = run(&[&"solve", &paper, &"--set", &patch, &"-o", &solved, &"--json"]).json();

    let folder = scratch.0.join("solution");
    let answer = run(&[&"report", &solved, &"-o", &folder, &"--json"]).json();
    assert_eq!(answer["model"], "steady-orbit");
    assert_eq!(number(&answer, "cage_speed_rpm"), number(&solution, "cage_speed_rpm"));
    let [page, markdown] = texts(&folder);
    for said in ["What was solved", "Steady orbit", "14000 r/min", "Characteristic frequencies", "Balls"] {
        assert!(page.contains(said) && markdown.contains(said), "{said} is not in the report");
    }
    assert!(folder.join("contact-loads.svg").exists() || page.matches("<svg").count() > 5);
    let load = number(&solution["balls"][0], "load_inner_n");
    assert!((number(&answer["balls"][0], "load_inner_n") / load - 1.0).abs() < 1e-6);

    let folder = scratch.0.join("compared");
    let answer = run(&[&"report", &recording, &solved, &"-o", &folder, &"--json"]).json();
    let difference = |name: &str| {
        let all = answer["differences"].as_array().unwrap();
        all.iter().find(|d| d["quantity"] == name).unwrap_or_else(|| panic!("{name} is not compared")).clone()
    };
    let cage = difference("cage_speed_mean_rpm");
    assert_eq!(number(&cage, "b"), number(&solution, "cage_speed_rpm"));
    assert_eq!(number(&cage, "difference"), number(&cage, "b") - number(&cage, "a"));
    difference("friction_torque_mean_nm");
    difference("contact_angle_outer_max_deg");
    let paths: Vec<&str> =
        answer["case_differences"].as_array().unwrap().iter().map(|d| d["path"].as_str().unwrap()).collect();
    assert!(paths.contains(&"transient.duration") && !paths.contains(&"ring.x"), "{paths:?}");
    assert_eq!(answer["figures"], serde_json::json!(["compare-azimuth"]));

    let same = run(&[&"report", &recording, &recording, &"-o", &scratch.0.join("same"), &"--json"]).json();
    assert!(same["differences"].as_array().unwrap().iter().all(|d| d["difference"] == 0.0));
    assert_eq!(same["case_differences"], serde_json::json!([]));
    assert_eq!(same["figures"], serde_json::json!(["compare-azimuth", "compare-histories"]));
}

#[test]
fn limit_recordings_that_cannot_be_reported_are_refused_and_nothing_written() {
    let scratch = Scratch::new();
    let solved = scratch.0.join("solved.mcap");
    let patch = "traction.patch=SplitStrip(across: 5, along: 3)";
    run(&[&"solve", &fixture("paper-handset.ron"), &"--set", &patch, &"-o", &solved, &"--json"]).json();
    let text = scratch.file("text.mcap", "no recording");
    let empty = scratch.0.join("empty.mcap");
    let mut writer = mcap::Writer::new(std::io::BufWriter::new(fs::File::create(&empty).unwrap())).unwrap();
    writer.finish().unwrap();
    drop(writer);
    let none = scratch.0.join("none");
    let missing = scratch.0.join("missing.mcap");
    let figures = scratch.file("figures.csv", "id,quantity,published,tolerance,source\n");
    for (recordings, said) in [
        (vec![&text], "is not an MCAP file"),
        (vec![&solved, &text], "is not an MCAP file"),
        (vec![&empty, &solved], "holds no sample of a transient run or of a solution"),
        (vec![&missing], "missing.mcap"),
        (vec![&solved, &solved, &solved], "unexpected value"),
        (vec![&solved, &solved, &figures], "unexpected value"),
    ] {
        let mut words: Vec<&dyn AsRef<OsStr>> = vec![&"report", &"-o", &none];
        recordings.iter().for_each(|path| words.push(*path));
        run(&words).fails(2, &[said]);
    }
    run(&[&"report", &solved, &solved, &"-o", &none, &"--against", &figures])
        .fails(2, &["--against", "not beside two"]);
    assert!(!none.exists());
}

#[test]
fn limit_a_name_is_neither_markup_nor_a_command_to_the_terminal() {
    let scratch = Scratch::new();
    let name = r#""a|b *c* <script>alert(1)</script> `d`\n# e \u{1b}[2J""#;
    let text = set_value(AG, "name", name).unwrap();
    let text = set_value(&text, "traction.patch", "SplitStrip(across: 5, along: 3)").unwrap();
    let case = scratch.file("case.ron", text);
    let solved = scratch.0.join("solved.mcap");
    run(&[&"solve", &case, &"-o", &solved, &"--json"]).json();
    let folder = scratch.0.join("report");
    let outcome = run(&[&"report", &solved, &"-o", &folder]);
    assert_eq!(outcome.code, 0, "{}", outcome.err);
    assert!(!outcome.out.contains('\u{1b}'), "{}", outcome.out);
    let markdown = read(&folder, "summary.md");
    assert!(markdown.starts_with("# a\\|b \\*c\\* &lt;script&gt;alert(1)&lt;/script&gt; \\`d\\` \\# e "), "{markdown}");
    assert!(!markdown.contains('\u{1b}') && !markdown.contains("<script"));
    let columns = |line: &str| line.replace("\\|", "").matches('|').count();
    let row = markdown.lines().find(|line| line.starts_with("| Bearing |")).unwrap();
    assert_eq!(columns(row), 3, "{row}");
    assert!(!read(&folder, "report.html").contains("<script>alert"));
}

/// A case that asks for more than the limits within a recording: the report goes without it.
#[test]
fn limit_a_hostile_case_in_a_recording_is_not_solved() {
    use tribodyn_record::{FileSink, RunRecorder, RunRecording};
    let scratch = Scratch::new();
    let path = scratch.0.join("hostile.mcap");
    let worn = fs::read_to_string(fixture("paper-ag-worn.ron")).unwrap();
    let case = tribodyn_case::Case::from_ron(&worn).unwrap();
    let many = set_value(&worn, "geometry.ball_count", "800").unwrap();
    let case_text = &set_value(&many, "geometry.pitch_diameter", "m(40)").unwrap();
    let inputs = &case.run_inputs().unwrap();
    let input = RunRecording::new(case_text, &case.name, inputs, "tribodyn test");
    let mut recorder = RunRecorder::new(FileSink::create(&path).unwrap(), &input).unwrap();
    let mut transient = tribodyn_dynamics::Run::new(inputs.clone()).unwrap();
    let _ = transient.advance(0.002, &mut recorder).unwrap();
    recorder.finish().unwrap();
    let answer = run(&[&"report", &path, &"-o", &scratch.0.join("report"), &"--json"]).json();
    assert!(answer["notes"].as_array().unwrap().iter().any(|note| note.as_str().unwrap().contains("no readable case")));
}

/// docs/growth.md's example: a ring that turns at 14 000 r/min has 15.54° where it is drawn with 18°.
#[test]
fn regress_recordings_and_reports_of_a_mounted_bearing_have_its_geometry() {
    let scratch = Scratch::new();
    let part = "expansion: per_K(10.4e-6), temperature_rise: K(0)";
    let seat = |mm: f64| format!("(seat_diameter: mm({mm}), {part})");
    let mounting = format!("mounting=(inner: {}, outer: {}, ball: ({part}))", seat(120.0), seat(215.0));
    let case = fixture("paper-ag.ron");
    let checked = run(&[&"check", &case, &"--set", &mounting, &"--json"]).json();
    let recording = scratch.0.join("mounted.mcap");
    run(&[&"solve", &case, &"--model", &"jones-harris", &"--set", &mounting, &"-o", &recording, &"--json"]).json();
    let folder = scratch.0.join("report");
    run(&[&"report", &recording, &"-o", &folder, &"--json"]).json();
    let summary = tribodyn_record::read_summary(&recording).unwrap();
    let found: f64 = summary.metadata["simulation"]["free_contact_angle_deg"].parse().unwrap();
    assert!((found - 15.54).abs() < 0.01, "{found}");
    let mut all = Vec::new();
    leaves("", &checked, &mut all);
    let running = all.iter().find(|(path, _)| path.ends_with("contact_angle_running_deg")).unwrap();
    assert_eq!(running.1.as_f64(), Some(found));
    let page = read(&folder, "report.html");
    assert!(page.contains("free contact angle 15.54") && !page.contains("free contact angle 18°"));
}

/// Leaves of JSON by their paths.
fn leaves(path: &str, value: &Value, found: &mut Vec<(String, Value)>) {
    match value {
        Value::Object(map) => map.iter().for_each(|(key, value)| leaves(&format!("{path}/{key}"), value, found)),
        Value::Array(list) => {
            list.iter().enumerate().for_each(|(k, value)| leaves(&format!("{path}/{k}"), value, found));
        }
        leaf => found.push((path.to_owned(), leaf.clone())),
    }
}

/// A report says what the run said: nothing is solved anew, by another model or at another time.
#[test]
fn identity_every_value_of_a_run_is_that_of_its_report() {
    let scratch = Scratch::new();
    let (case, recording) = (fixture("paper-ag.ron"), scratch.0.join("run.mcap"));
    // Loads that are not those of the start at the end, and a step that divides the time between samples.
    let changes = [
        "ring.x=ForceTable([(s(0), kN(5)), (s(0.004), kN(22.98))])",
        "transient.scheme=Fast(step: us(20))",
        "transient.duration=ms(8)",
        "recording.state_rate=kHz(102.4)",
    ];
    let mut arguments: Vec<&dyn AsRef<OsStr>> = vec![&"run", &case, &"-o", &recording, &"--json"];
    changes.iter().for_each(|change| arguments.extend([&"--set" as &dyn AsRef<OsStr>, change]));
    let ran = run(&arguments).json();
    let told = run(&[&"report", &recording, &"-o", &scratch.0.join("report"), &"--json"]).json();
    let (mut of_run, mut of_report) = (Vec::new(), Vec::new());
    leaves("", &ran, &mut of_run);
    leaves("", &told, &mut of_report);
    // The file is the same whoever runs it: it has no clock and no name of a case.
    let own = ["/case", "/wall_s", "/simulated_per_wall"];
    for (path, value) in of_run.iter().filter(|(path, _)| !own.contains(&path.as_str())) {
        let found = of_report.iter().find(|(of, _)| of == path).map(|(_, found)| found);
        assert_eq!(found, Some(value), "{path}");
    }
    assert!(of_run.len() > 60, "{}", of_run.len());
    // What the command was asked for, and what it did.
    assert_close(ran["step_s"].as_f64().unwrap(), 1.0 / 102_400.0, 1e-12);
    let first = &tribodyn_record::read_run(&recording).unwrap().states[0];
    assert_eq!(told["cage_speed_start_rpm"].as_f64(), Some(first.cage_speed_rpm));
}
