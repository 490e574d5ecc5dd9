//! Sweeps: the table's rows are solutions, the same however the work was shared out or stopped, and nothing is lost.

use super::{AG, Outcome, Scratch, assert_close, command, fixture, run};
use std::collections::HashMap;
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

const AXIAL: &str = "ring.z.Force=kN(30..55 by 5)";
const RADIAL: &str = "ring.x.Force=kN(8..20 in 4)";

/// By the equilibrium with traction, which is solved in no time, where no model is named.
fn sweep(rest: &[&dyn AsRef<OsStr>]) -> Outcome {
    let case = fixture("paper-handset.ron");
    let start: [&dyn AsRef<OsStr>; 4] = [&"sweep", &case, &"--model", &"traction"];
    let named = rest.iter().any(|word| word.as_ref() == "--model");
    run(&[if named { &start[..2] } else { &start[..] }, rest].concat())
}

/// The equilibrium of a row.
fn solve(changes: &[&dyn AsRef<OsStr>]) -> serde_json::Value {
    let case = fixture("paper-handset.ron");
    let start: [&dyn AsRef<OsStr>; 5] = [&"solve", &case, &"--model", &"traction", &"--json"];
    run(&[&start[..], changes].concat()).json()
}

/// The grid of 24 rows in three chunks that most tests use.
fn grid(output: &Path, rest: &[&dyn AsRef<OsStr>]) -> Outcome {
    let start: [&dyn AsRef<OsStr>; 6] = [&"--set", &AXIAL, &"--set", &RADIAL, &"-o", &output];
    sweep(&[&start[..], rest].concat())
}

/// The fields of a line; quotes may hold commas.
fn fields(line: &str) -> Vec<String> {
    let mut fields = vec![String::new()];
    let mut quoted = false;
    for letter in line.chars() {
        match (letter, fields.last_mut()) {
            ('"', _) => quoted = !quoted,
            (',', _) if !quoted => fields.push(String::new()),
            (_, Some(last)) => last.push(letter),
            (_, None) => {}
        }
    }
    fields
}

/// Header and rows of a table without line ends and quotes in its fields.
pub fn read(path: &Path) -> (Vec<String>, Vec<HashMap<String, String>>) {
    let text = fs::read_to_string(path).unwrap();
    let mut lines = text.lines().map(fields);
    let header = lines.next().unwrap();
    let rows = lines.map(|fields| {
        assert_eq!(fields.len(), header.len());
        header.iter().cloned().zip(fields).collect()
    });
    (header.clone(), rows.collect())
}

pub fn value(row: &HashMap<String, String>, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name} = {}", row[name]))
}

#[test]
fn identity_rows_are_what_solve_answers() {
    let scratch = Scratch::new();
    let table = scratch.0.join("table.csv");
    let summary = grid(&table, &[&"--json"]).json();
    assert_eq!(
        (&summary["rows"], &summary["failed_rows"], &summary["resumed_rows"]),
        (&24.into(), &0.into(), &0.into())
    );
    let (header, rows) = read(&table);
    assert_eq!(header[..4], ["row", "ring.z.Force [kN]", "ring.x.Force [kN]", "converged"]);
    assert_eq!(rows.len(), 24);
    for (i, row) in rows.iter().enumerate() {
        let expected = [i as f64, [30.0, 35.0, 40.0, 45.0, 50.0, 55.0][i / 4], [8.0, 12.0, 16.0, 20.0][i % 4]];
        assert_eq!(["row", "ring.z.Force [kN]", "ring.x.Force [kN]"].map(|name| value(row, name)), expected);
        assert_eq!((row["converged"].as_str(), row["error"].as_str()), ("true", ""));
        assert!(value(row, "residual") <= 1e-10 && value(row, "patch_error_estimate") <= 1e-5);
        // Power at the shaft is what friction and fluid take.
        let power = value(row, "shaft_torque_nm") * 14000.0 * std::f64::consts::PI / 30.0;
        let losses: f64 = ["inner", "outer", "fluid"].map(|at| value(row, &format!("power_loss_{at}_w"))).iter().sum();
        assert_close(power, losses, 1e-3);
    }
    // Rows 6 and 23 come from a neighbour where that leads to the same equilibrium.
    for i in [6, 23] {
        let set = |name: &str| format!("{name}.Force=kN({})", rows[i][&format!("{name}.Force [kN]")]);
        let (x, z) = (set("ring.x"), set("ring.z"));
        let alone = solve(&[&"--set", &x, &"--set", &z]);
        let balls = alone["balls"].as_array().unwrap();
        let of = |name: &str| balls.iter().map(|b| b[name].as_f64().unwrap()).collect::<Vec<_>>();
        let largest = |name: &str| of(name).into_iter().fold(f64::MIN, f64::max);
        let same = |name: &str, expected: f64| assert_close(value(&rows[i], name), expected, 1e-4);
        same("cage_speed_rpm", alone["cage_speed_rpm"].as_f64().unwrap());
        same("shaft_torque_nm", alone["shaft_torque_nm"].as_f64().unwrap());
        same("ring_displacement_z_m", alone["ring_displacement_z_m"].as_f64().unwrap());
        same("peak_pressure_inner_max_pa", largest("peak_pressure_inner_pa"));
        same("load_outer_max_n", largest("load_outer_n"));
        same("power_loss_outer_w", of("power_loss_outer_w").iter().sum());
        same("wear_rate_inner_m3_s", of("wear_rate_inner_m3_s").iter().sum());
        assert_eq!(value(&rows[i], "balls_in_contact"), 13.0);
        assert_eq!(value(&rows[i], "warnings") as usize, alone["warnings"].as_array().unwrap().len());
    }
    assert_eq!(scratch.names(), ["table.csv"]);
}

#[test]
fn identity_shards_together_are_the_whole_and_threads_change_nothing() {
    let scratch = Scratch::new();
    let [whole, again] = ["whole.csv", "again.csv"].map(|name| scratch.0.join(name));
    grid(&whole, &[&"--threads", &"1"]).table();
    grid(&again, &[&"--threads", &"2", &"--quiet"]).table();
    let whole = fs::read_to_string(whole).unwrap();
    assert_eq!(whole, fs::read_to_string(again).unwrap());
    for count in [2, 5] {
        let mut lines = Vec::new();
        for index in 0..count {
            let part = scratch.0.join("part.csv");
            grid(&part, &[&"--shard", &format!("{index}/{count}")]).table();
            let text = fs::read_to_string(part).unwrap();
            let (head, rest) = text.split_once('\n').unwrap();
            assert!(whole.starts_with(head));
            lines.extend(rest.lines().map(str::to_owned));
        }
        lines.sort_by_key(|line| line.split(',').next().unwrap().parse::<usize>().unwrap());
        assert_eq!(lines, whole.lines().skip(1).collect::<Vec<_>>(), "{count} shards");
    }
}

/// Waits until the finished rows on disk fulfil a condition.
fn wait(journal: &Path, until: impl Fn(&str) -> bool) {
    let began = Instant::now();
    while !fs::read_to_string(journal).is_ok_and(|text| until(&text)) {
        assert!(began.elapsed() < Duration::from_secs(60), "no rows were finished");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn identity_a_killed_sweep_goes_on_to_the_same_bytes() {
    let scratch = Scratch::new();
    let [whole, table] = ["whole.csv", "table.csv"].map(|name| scratch.0.join(name));
    grid(&whole, &[]).table();
    let case = fixture("paper-handset.ron");
    let start: [&dyn AsRef<OsStr>; 4] = [&"sweep", &case, &"--model", &"traction"];
    let rest: [&dyn AsRef<OsStr>; 8] = [&"--set", &AXIAL, &"--set", &RADIAL, &"-o", &table, &"--threads", &"1"];
    let words = [&start[..], &rest].concat();
    let mut child = command(&words).spawn().unwrap();
    let journal = scratch.0.join("table.csv.rows");
    wait(&journal, |text| text.ends_with('\n'));
    grid(&table, &[]).fails(1, &["table.csv: another process is writing it", &child.id().to_string()]);
    wait(&journal, |text| text.lines().count() > 8);
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!table.exists(), "the table has its name before it is whole");
    let finished = fs::read(&journal).unwrap();
    let lines = String::from_utf8(finished.clone()).unwrap().lines().count() - 1;
    assert_eq!(lines % 8, 0);
    // What a stop can leave: half a line, some lines of a chunk, a chunk without its end, bytes that are no text.
    let tails: [(&[u8], usize); 4] = [(b"8,30.0,1", 0), (b"16,30.0,8.0,tr\n", 0), (b"", 10), (b"\0\0\xff\n\0", 0)];
    for (tail, cut) in tails {
        fs::write(&journal, [&finished[..finished.len() - cut], tail].concat()).unwrap();
        let summary = grid(&table, &[&"--json"]).json();
        let kept = lines - if cut > 0 { 8 } else { 0 };
        assert_eq!((&summary["resumed_rows"], &summary["rows"]), (&kept.into(), &24.into()));
        assert_eq!(fs::read(&table).unwrap(), fs::read(&whole).unwrap());
        assert!(!journal.exists());
    }
    // A head without its end is a sweep that never began.
    fs::write(&journal, &finished[..20]).unwrap();
    assert_eq!(grid(&table, &[&"--json"]).json()["resumed_rows"], 0);
}

#[test]
fn limit_finished_rows_of_another_sweep_are_not_taken() {
    let scratch = Scratch::new();
    let table = scratch.0.join("table.csv");
    let journal = scratch.0.join("table.csv.rows");
    let identity = |case: &str, version: &str| {
        let swept = serde_json::json!([["ring.z.Force", ["kN(40)", "kN(44)"]]]);
        let shard = serde_json::json!({"index": 0, "count": 1});
        let head = serde_json::json!({
            "tribodyn": version, "case": case, "model": "traction", "swept": swept, "shard": shard, "cold": false,
        });
        format!("{head}\n")
    };
    let version = env!("CARGO_PKG_VERSION");
    let go = |list: &str, rest: &[&dyn AsRef<OsStr>]| {
        let start: [&dyn AsRef<OsStr>; 4] = [&"--set", &list, &"-o", &table];
        sweep(&[&start[..], rest].concat())
    };
    let same = "ring.z.Force=kN(40),kN(44)";
    fs::write(&journal, identity(AG, version)).unwrap();
    let refused = |list: &str, rest: &[&dyn AsRef<OsStr>], why: &str| {
        let before = fs::read(&journal).unwrap();
        go(list, rest).fails(2, &["table.csv.rows: ", why, "delete it, or use --restart"]);
        assert_eq!(fs::read(&journal).unwrap(), before, "finished rows were touched");
    };
    refused("ring.z.Force=kN(40),kN(45)", &[], "other --set values");
    refused(same, &[&"--shard", &"0/2"], "shard 0/1");
    refused(same, &[&"--cold"], "another --cold");
    refused(same, &[&"--model", &"steady-orbit"], "another --model, traction");
    refused(same, &[&"--set", &"ring.x.Force=kN(19)"], "another case");
    fs::write(&journal, identity(AG, "0.0.1")).unwrap();
    refused(same, &[], "version 0.0.1");
    fs::write(&journal, "somebody's notes\n").unwrap();
    refused(same, &[], "not a file of finished rows");
    assert_eq!(scratch.names(), ["table.csv.rows"]);
    assert_eq!(go(same, &[&"--restart", &"--json"]).json()["resumed_rows"], 0);
    // The head above is what the command itself writes: with it, nothing is refused.
    fs::write(&journal, identity(AG, version)).unwrap();
    go(same, &[]).table();
    assert_eq!(scratch.names(), ["table.csv"]);
}

#[test]
fn limit_bad_values_are_refused_before_anything_is_solved() {
    let scratch = Scratch::new();
    let table = scratch.0.join("table.csv");
    let refused = |list: &str, parts: &[&str]| {
        sweep(&[&"--set", &"ring.x.Force=kN(1..20 in 20)", &"--set", &list, &"-o", &table]).fails(2, parts);
    };
    refused("ring.q.Force=kN(1),kN(2)", &["--set ring.q.Force=kN(1): ", "no such path"]);
    refused("ring.z.Force=kN(1),mm(2)", &["--set ring.z.Force=mm(2): ", "expected a force"]);
    refused("geometry.ball_diameter=mm(30..-10 by -20)", &["--set geometry.ball_diameter=mm(-10): "]);
    refused("geometry.ball_count=8..9 by 0.5", &["--set geometry.ball_count=8.5: ", "whole number"]);
    refused("wear.cage.coefficient=-1", &["--set wear.cage.coefficient=-1: "]);
    refused("ring.z.Force=kN(1..2)", &["is not a range", "10..60 by 5"]);
    refused("ring.z.Force=kN(1..2", &["brackets or quotes do not match"]);
    refused("ring.z.Force=", &["PATH=VALUES"]);
    refused("ring.x=Held(um(0)),Held(um(1))", &["ring.x.Force", "sweep the same value"]);
    refused("ring.z.Force=kN(1..2 in 1000001)", &["more than 1000000 values"]);
    let many = ["x", "z"].map(|axis| format!("ring.{axis}.Force=kN(1..2 in 40000)"));
    sweep(&[&"--set", &many[0], &"--set", &many[1], &"-o", &table]).fails(2, &["more than 1000000000 rows"]);
    let output = |name: &str, parts: &[&str]| sweep(&[&"--set", &AXIAL, &"-o", &scratch.0.join(name)]).fails(2, parts);
    output("table.xlsx", &["--output", "table.xlsx", ".csv"]);
    output("table", &["--output"]);
    sweep(&[&"--set", &AXIAL]).fails(2, &["--output <TABLE>"]);
    for shard in ["1/1", "2", "a/b", "0/0", "-1/2"] {
        sweep(&[&"-o", &table, &format!("--shard={shard}")]).fails(2, &["--shard", "I/N"]);
    }
    sweep(&[&"-o", &table, &"--threads", &"0"]).fails(2, &["--threads"]);
    let missing = scratch.0.join("missing/table.csv");
    sweep(&[&"-o", &missing]).fails(1, &["cannot write", "missing/table.csv.lock"]);
    let case = scratch.file("case.csv", AG);
    run(&[&"sweep", &case, &"-o", &case]).fails(2, &["--output", "the table would replace the case file"]);
    assert_eq!(scratch.names(), ["case.csv"]);
}

#[test]
fn limit_rows_without_solution_do_not_stop_the_others() {
    let scratch = Scratch::new();
    let table = scratch.0.join("table.csv");
    let set = "numerics.max_iterations=1,200";
    let outcome = sweep(&[&"--set", &set, &"-o", &table]);
    assert_eq!(outcome.code, 1);
    assert!(outcome.err.contains("1 of 2 rows have no solution") && outcome.err.contains("table.csv"));
    let text = fs::read_to_string(&table).unwrap();
    let rows: Vec<&str> = text.lines().skip(1).collect();
    assert!(rows[0].starts_with("0,1.0,false,") && rows[0].contains("did not converge: "), "{}", rows[0]);
    assert!(rows[1].starts_with("1,200.0,true,") && rows[1].ends_with(','), "{}", rows[1]);
    // A case that only two values together make impossible.
    let lists = ["geometry.ball_count=13,18", "geometry.ball_diameter=mm(20),mm(30.16)"];
    let outcome = sweep(&[&"--set", &lists[0], &"--set", &lists[1], &"-o", &table, &"--json"]);
    assert_eq!(outcome.code, 1);
    let summary: serde_json::Value = serde_json::from_str(&outcome.out).unwrap();
    assert_eq!(summary["failed_rows"], 1);
    let text = fs::read_to_string(&table).unwrap();
    assert!(text.lines().nth(4).unwrap().starts_with("3,18.0,30.16,false,,,"), "{text}");
    assert_eq!(scratch.names(), ["table.csv"]);
}

#[test]
fn limit_a_plan_counts_and_writes_nothing() {
    let scratch = Scratch::new();
    let table = scratch.0.join("table.csv");
    let plan = grid(&table, &[&"--plan", &"--json", &"--shard", &"1/2", &"--threads", &"3"]).json();
    assert_eq!((&plan["grid_rows"], &plan["rows"], &plan["chunk_rows"]), (&24.into(), &8.into(), &8.into()));
    assert_eq!((&plan["threads"], &plan["shard"]), (&3.into(), &"1/2".into()));
    let axis = &plan["axes"][1];
    assert_eq!((&axis["values"], &axis["first"], &axis["last"]), (&4.into(), &"kN(8)".into(), &"kN(20)".into()));
    assert!(plan["estimated_time_s"].as_f64().unwrap() > 0.0);
    // Without an output, and with nothing swept at all.
    assert_eq!(sweep(&[&"--plan", &"--json"]).json()["grid_rows"], 1);
    assert_eq!(scratch.names(), [""; 0]);
}

/// Texts of a figure.
fn figure(folder: &Path, name: &str) -> String {
    assert!(fs::read(folder.join(format!("{name}.png"))).unwrap().starts_with(b"\x89PNG"));
    fs::read_to_string(folder.join(format!("{name}.svg"))).unwrap()
}

#[test]
fn identity_figures_are_curves_over_one_value_and_maps_over_two() {
    let scratch = Scratch::new();
    let [table, curves, maps, part] = ["table.csv", "curves", "maps", "part"].map(|name| scratch.0.join(name));
    let outcome = sweep(&[&"--set", &"numerics.max_iterations=1,150,200", &"-o", &table, &"--plot", &curves]);
    assert_eq!(outcome.code, 1, "{}", outcome.err);
    let angles = figure(&curves, "contact-angles");
    for text in ["no solution", "numerics.max_iterations", "Contact angle (°)", "inner, largest", "outer, smallest"] {
        assert!(angles.contains(text), "{text}");
    }
    let summary = grid(&table, &[&"--plot", &maps, &"--json"]).json();
    assert_eq!(summary["plot"], maps.to_str().unwrap());
    let pressures = figure(&maps, "peak-pressures");
    for text in ["(a) inner", "(b) outer", "Peak pressure (GPa)", "ring.z.Force (kN)", "ring.x.Force (kN)"] {
        assert!(pressures.contains(text), "{text}");
    }
    assert!(!pressures.contains("no solution"));
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let document: String =
        ["sweep.md", "quantities.md"].map(|page| fs::read_to_string(docs.join(page)).unwrap()).concat();
    for name in super::names(&maps) {
        let stem = name.split('.').next().unwrap();
        assert!(document.contains(&format!("`{stem}`")), "docs/sweep.md does not name {stem}");
    }
    assert_eq!(super::names(&curves), super::names(&maps));
    // A shard has fewer cells: what others solve is blank.
    grid(&table, &[&"--plot", &part, &"--shard", &"1/3"]).table();
    let cells = |folder: &Path| figure(folder, "cage-speed").matches("<rect").count();
    assert!(cells(&part) + 8 < cells(&maps), "{} {}", cells(&part), cells(&maps));
}

#[test]
fn limit_sweeps_without_figures_are_refused_before_anything_is_solved() {
    let scratch = Scratch::new();
    let [table, plot] = ["table.csv", "plot"].map(|name| scratch.0.join(name));
    let third = "ring.y.Force=kN(0),kN(1)";
    grid(&table, &[&"--set", &third, &"--plot", &plot])
        .fails(2, &["--plot", "one swept value or two, and 3 are swept"]);
    sweep(&[&"-o", &table, &"--plot", &plot]).fails(2, &["--plot", "nothing is swept"]);
    let fine = ["x", "z"].map(|axis| format!("ring.{axis}.Force=kN(10..20 in 201)"));
    let plotted = sweep(&[&"--set", &fine[0], &"--set", &fine[1], &"-o", &table, &"--plot", &plot]);
    plotted.fails(2, &["--plot", "at most 40000 cells"]);
    assert_eq!(scratch.names(), [""; 0]);
}

#[test]
fn regress_every_column_is_documented() {
    let scratch = Scratch::new();
    let table = scratch.0.join("table.csv");
    sweep(&[&"-o", &table]).table();
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let document: String =
        ["sweep.md", "quantities.md"].map(|page| fs::read_to_string(docs.join(page)).unwrap()).concat();
    let (header, rows) = read(&table);
    assert_eq!(rows.len(), 1);
    for name in header {
        let of_race = name.replacen("_inner", "_…", 1).replacen("_outer", "_…", 1);
        let explained = [&name, &of_race].iter().any(|name| document.contains(&format!("`{name}`")));
        assert!(explained, "neither docs/sweep.md nor docs/quantities.md explains {name}");
    }
}

#[cfg(feature = "parquet")]
#[test]
fn identity_parquet_holds_what_csv_holds() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    let scratch = Scratch::new();
    let sets = ["numerics.max_iterations=1,200", "traction.pressure=Peak,Local"];
    let tables = ["a.csv", "a.parquet", "b.parquet"].map(|name| scratch.0.join(name));
    for (table, threads) in tables.iter().zip(["1", "1", "2"]) {
        let outcome = sweep(&[&"--set", &sets[0], &"--set", &sets[1], &"-o", table, &"--threads", &threads]);
        assert_eq!(outcome.code, 1, "{}", outcome.err);
    }
    assert!(fs::read(&tables[1]).unwrap() == fs::read(&tables[2]).unwrap(), "the bytes depend on the threads");
    let (header, expected) = read(&tables[0]);
    let reader = SerializedFileReader::new(fs::File::open(&tables[1]).unwrap()).unwrap();
    let notes = reader.metadata().file_metadata().key_value_metadata().unwrap();
    assert!(notes.iter().any(|n| n.key == "tribodyn.case" && n.value.as_deref() == Some(AG)));
    let mut rows = 0;
    for (row, expected) in reader.get_row_iter(None).unwrap().zip(&expected) {
        let row = row.unwrap();
        assert_eq!(row.get_column_iter().map(|(name, _)| name.clone()).collect::<Vec<_>>(), header);
        for (name, field) in row.get_column_iter() {
            let text = match field {
                Field::Null => String::new(),
                Field::Bool(t) => t.to_string(),
                Field::Long(n) => n.to_string(),
                Field::Double(v) => format!("{v:?}"),
                Field::Str(s) => s.clone(),
                other => panic!("{name} is {other:?}"),
            };
            assert_eq!(text, expected[name], "{name}");
        }
        rows += 1;
    }
    assert_eq!(rows, 4);
}
