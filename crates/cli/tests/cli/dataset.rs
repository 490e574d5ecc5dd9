//! Data sets: members are the same on any number of threads and after a stop, labels are true, no bearing is in both
//! parts, and a bad plan writes nothing.
#![cfg(feature = "parquet")]

use super::run::case;
use super::{Outcome, Scratch, command, kill_after_rows, run};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row};
use std::collections::HashMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

/// Sound bearings and spalls of the outer race of the paper's bearing, signals of 2.5 ms.
const PLAN: &str = r#"(
    name: "small",
    cases: ["case.ron"],
    faults: [Sound, Outer],
    lengths: [mm(3)],
    loads: [(radial: kN(20))],
    speeds: [rpm(14000), rpm(10000)],
    bearings: 2,
    spall: (depth: um(100), width: mm(20), edge_radius: um(20), zone: deg(10)),
    deviations: (
        inner: (first: 2, last: 30, amplitude: um(0.5), exponent: 1, seed: 0),
        outer: (first: 2, last: 30, amplitude: um(0.5), exponent: 1, seed: 0),
        balls: 10,
    ),
    settle: ms(0.5),
    duration: ms(2.5),
    rate: kHz(25.6),
    sensors: [
        (name: "acc_x", direction: deg(0), direct: 1, noise: 0.01,
         modes: [(frequency: kHz(3), damping: 0.03, gain: 1)]),
    ],
    test_share: 0.5,
    seed: 7,
)"#;

fn plan(scratch: &Scratch, text: &str) -> PathBuf {
    let case = case(scratch);
    let coarse = fs::read_to_string(&case).unwrap().replace("RungeKutta4(step: us(10))", "Fast(step: us(10))");
    fs::write(&case, coarse).unwrap();
    scratch.file("plan.ron", text)
}

fn dataset(plan: &Path, folder: &Path, rest: &[&dyn AsRef<OsStr>]) -> Outcome {
    let start: [&dyn AsRef<OsStr>; 5] = [&"dataset", &plan, &"-o", &folder, &"--quiet"];
    run(&[&start[..], rest].concat())
}

fn rows(folder: &Path) -> Vec<HashMap<String, Field>> {
    let reader = SerializedFileReader::new(fs::File::open(folder.join("members.parquet")).unwrap()).unwrap();
    let row = |row: Result<Row, _>| row.unwrap().into_columns().into_iter().collect();
    reader.get_row_iter(None).unwrap().map(row).collect()
}

fn list(field: &Field) -> Vec<f64> {
    let Field::ListInternal(list) = field else { panic!("{field} is no list") };
    let value = |field: &Field| match field {
        Field::Float(v) => f64::from(*v),
        Field::Double(v) => *v,
        Field::Long(v) => *v as f64,
        other => panic!("{other}"),
    };
    list.elements().iter().map(value).collect()
}

#[test]
fn identity_members_are_the_same_on_any_number_of_threads_and_labels_are_true() {
    let scratch = Scratch::new();
    let plan = plan(&scratch, PLAN);
    let folders = ["1", "2"].map(|threads| {
        let folder = scratch.0.join(threads);
        let answer = dataset(&plan, &folder, &[&"--threads", &threads, &"--mat", &"--json"]).json();
        assert_eq!((answer["members"].as_u64(), answer["failed"].as_u64()), (Some(8), Some(0)), "{answer}");
        folder
    });
    let [one, two] = folders.each_ref().map(|folder| fs::read(folder.join("members.parquet")).unwrap());
    assert!(one == two, "threads change the table");
    let rows = rows(&folders[0]);
    assert_eq!(rows.len(), 8);
    let mut splits: HashMap<String, String> = HashMap::new();
    for row in &rows {
        let signal = list(&row["acc_x"]);
        assert_eq!(signal.len(), 64);
        assert!(signal.iter().any(|a| a.abs() > 0.05) && signal.iter().all(|a| a.abs() < 1e6));
        // A bearing is in one part.
        let (bearing, split) = (row["bearing"].to_string(), row["split"].to_string());
        assert_eq!(*splits.entry(bearing).or_insert(split.clone()), split);
        let entered = list(&row["entered_s"]);
        let speed = number(&row["inner_speed_rpm"]) / 60.0;
        // 13 balls pass at about 0.42 of the speed of the shaft.
        let expected = if row["fault"].to_string().contains("sound") { 0.0 } else { 2.5e-3 * 13.0 * 0.42 * speed };
        assert!((entered.len() as f64 - expected).abs() <= 1.2, "{} passages, {expected}", entered.len());
        for ((a, b), c) in entered.iter().zip(list(&row["struck_s"])).zip(list(&row["left_s"])) {
            // 3 mm of the circle of 97 mm radius.
            let time = 3e-3 / 97e-3 / (std::f64::consts::TAU * 0.42 * speed);
            assert!(*a < b && b < c && ((c - a) / time - 1.0).abs() < 0.05, "{a} {b} {c} {time}");
        }
    }
    assert_eq!(splits.values().filter(|split| split.contains("test")).count(), 2);
    // A run without a thrust of the plan has that of the case; one this short warns that its accelerations may not be
    // resolved, and has a step.
    assert!(rows.iter().all(|row| matches!(row["axial_load_n"], Field::Double(_))), "{:?}", rows[0]["axial_load_n"]);
    assert!(rows.iter().all(|row| row["warnings"].to_string().contains("resolved") && number(&row["step_us"]) > 0.0));
    // The signal of a MATLAB file is that of the row.
    let mat = fs::read(folders[0].join("mat/000003.mat")).unwrap();
    let has = |text: &[u8]| mat.windows(text.len()).any(|bytes| bytes == text);
    assert!(has(b"fault") && has(b"member") && has(b"split") && has(b"axial_load_n") && !has(b"case"));
    let labels = [&rows[3]["split"], &rows[3]["fault"]].map(|field| field.to_string().replace('"', ""));
    for label in labels {
        let letters: Vec<u8> = label.encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert!(has(&letters), "{label}");
    }
    let samples: Vec<u8> = list(&rows[3]["acc_x"]).iter().flat_map(|v| (*v as f32).to_le_bytes()).collect();
    assert!(has(&samples));
    // A smaller set in the same folder leaves no member of this one.
    let smaller = scratch.file("smaller.ron", PLAN.replace("faults: [Sound, Outer]", "faults: [Sound]"));
    dataset(&smaller, &folders[0], &[&"--mat"]).table();
    let left = |folder: &Path| fs::read_dir(folder.join("mat")).map_or(0, |entries| entries.count());
    assert_eq!((left(&folders[0]), left(&folders[1])), (4, 8));
}

fn number(field: &Field) -> f64 {
    let Field::Double(value) = field else { panic!("{field}") };
    *value
}

/// A set that is killed goes on with the members that are left, and its table is that of a set which was not.
#[cfg(unix)]
#[test]
fn identity_a_killed_set_goes_on_where_it_was() {
    let scratch = Scratch::new();
    let plan = plan(&scratch, PLAN);
    let [whole, killed] = ["whole", "killed"].map(|name| scratch.0.join(name));
    dataset(&plan, &whole, &[]).table();
    let rows = killed.join("members.parquet.rows");
    kill_after_rows(command(&[&"dataset", &plan, &"-o", &killed, &"--quiet", &"--threads", &"1"]), &rows, 2);
    let other = scratch.file("other.ron", PLAN.replace("seed: 7", "seed: 8"));
    dataset(&other, &killed, &[]).fails(2, &["members.parquet.rows"]);
    let answer = dataset(&plan, &killed, &[&"--json"]).json();
    assert!(answer["run"].as_u64().unwrap() <= 6, "{answer}");
    assert!(fs::read(killed.join("members.parquet")).unwrap() == fs::read(whole.join("members.parquet")).unwrap());
    assert!(!rows.exists());
}

#[test]
fn limit_a_bad_plan_writes_nothing() {
    let scratch = Scratch::new();
    for (from, to, message) in [
        ("rate: kHz(25.6)", "rate: kHz(0)", "greater than 0 Hz"),
        ("test_share: 0.5", "test_share: 1.5", "between 0 and 1"),
        ("frequency: kHz(3)", "frequency: kHz(30)", "at most 0.45 of rate"),
        ("faults: [Sound, Outer]", "faults: [Sound, Cage]", "allowed: Sound, Outer, Inner"),
        ("lengths: [mm(3)]", "lengths: []", "allowed are 1 to 1000"),
        ("\"acc_x\"", "\"Acc X\"", "lower-case letters"),
        ("balls: 10", "balls: 11", "grade of ISO 3290-1"),
        ("lengths: [mm(3)]", "lengths: [mm(28)]", "plan.ron:5:15: lengths[0] = mm(28): in case.ron: must be above 0"),
        ("\"acc_x\"", "\"rate_hz\"", "is a column of the labels"),
        ("bearings: 2", "bearings: 1", "leaves 1 of the 1 bearings"),
        ("zone: deg(10)", "zone: deg(-5)", "between 0 and 180 degrees"),
    ] {
        assert!(PLAN.contains(from), "{from}");
        let plan = plan(&scratch, &PLAN.replace(from, to));
        let folder = scratch.0.join("set");
        dataset(&plan, &folder, &[]).fails(2, &[message]);
        assert!(!folder.exists(), "{to}");
    }
}
