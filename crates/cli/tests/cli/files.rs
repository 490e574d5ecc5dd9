//! Files on disk after a run: whole files or none, and the answer where it was asked for.

use super::{AG, Scratch, command, fixture, names, run};
use std::ffi::OsStr;
use std::path::Path;
use std::process::Stdio;

fn solve(rest: &[&dyn AsRef<OsStr>]) -> super::Outcome {
    let case = fixture("paper-handset.ron");
    let start: [&dyn AsRef<OsStr>; 4] = [&"solve", &case, &"--model", &"jones-harris"];
    run(&[&start[..], rest].concat())
}

#[test]
fn identity_the_same_run_writes_the_same_whole_files() {
    let scratch = Scratch::new();
    let contents = |folder: &Path| -> Vec<(String, Vec<u8>)> {
        names(folder).into_iter().map(|name| (name.clone(), std::fs::read(folder.join(name)).unwrap())).collect()
    };
    let mut runs = Vec::new();
    for round in ["first", "second"] {
        let folder = scratch.0.join(round).join("deeper");
        let recording = scratch.0.join(format!("{round}.mcap"));
        let answer = solve(&[&"--plot", &folder, &"-o", &recording, &"--json"]).json();
        assert_eq!(answer["balls"].as_array().unwrap().len(), 13);
        runs.push((contents(&folder), std::fs::read(recording).unwrap()));
    }
    assert!(runs[0] == runs[1], "two runs of one case differ");
    let (figures, recording) = &runs[0];
    let stems = ["contact-angles", "contact-loads", "elastic-approaches", "orbital-speed", "peak-pressures"];
    let expected: Vec<String> = stems.iter().flat_map(|stem| [format!("{stem}.png"), format!("{stem}.svg")]).collect();
    assert_eq!(figures.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>(), expected);
    for (name, bytes) in figures {
        let whole = if name.ends_with("svg") {
            bytes.starts_with(b"<svg") || bytes.starts_with(b"<?xml")
        } else {
            bytes.starts_with(b"\x89PNG\r\n\x1a\n") && bytes.ends_with(b"IEND\xae\x42\x60\x82")
        };
        assert!(whole, "{name} is not whole");
    }
    // MCAP begins and ends with its magic bytes.
    let magic = b"\x89MCAP0\r\n";
    assert!(recording.starts_with(magic) && recording.ends_with(magic));
    assert_eq!(scratch.names(), ["first", "first.mcap", "second", "second.mcap"]);
}

#[test]
fn identity_a_recording_holds_the_case_that_was_solved() {
    let scratch = Scratch::new();
    let recording = scratch.0.join("run.mcap");
    let changed = |name: &str| {
        let set = "ring.z.Force=kN(31.25)";
        let written = solve(&[&"--set", &set, &"--varying", &"false", &"-o", &recording, &"--json"]).json();
        let case =
            scratch.file(name, AG.replacen("kN(44)", "kN(31.25)", 1).replacen("varying: true", "varying: false", 1));
        let whole = std::fs::read_to_string(&case).unwrap();
        let bytes = std::fs::read(&recording).unwrap();
        // Attachments are stored as they are.
        assert!(
            bytes.windows(whole.len()).any(|window| window == whole.as_bytes()),
            "the changed text is not attached"
        );
        let direct = run(&[&"solve", &case, &"--model", &"jones-harris", &"--json"]).json();
        assert_eq!(written, direct);
        written["ring_load_z_n"].as_f64().unwrap()
    };
    super::assert_close(changed("changed.ron"), 31250.0, 1e-9);
}

#[test]
fn limit_an_output_that_cannot_be_written_leaves_nothing() {
    let scratch = Scratch::new();
    let wall = scratch.file("wall", "a file where a folder is needed");
    let (plots, good) = (scratch.0.join("plots/deeper"), scratch.0.join("run.mcap"));
    let (below, missing) = (wall.join("below"), scratch.0.join("missing/run.mcap"));
    let occupied = scratch.0.join("occupied");
    std::fs::create_dir_all(occupied.join("contact-loads.svg")).unwrap();
    solve(&[&"-o", &below]).fails(1, &["cannot create", "wall/below"]);
    solve(&[&"-o", &missing, &"--plot", &plots]).fails(1, &["cannot create", "missing/run.mcap"]);
    solve(&[&"-o", &scratch.0]).fails(1, &["cannot write", "it is not a regular file"]);
    solve(&[&"-o", &good, &"--plot", &below]).fails(1, &["cannot write", "wall/below"]);
    solve(&[&"-o", &good, &"--plot", &wall]).fails(1, &["cannot write", "wall"]);
    solve(&[&"-o", &good, &"--plot", &occupied]).fails(1, &["cannot write", "contact-loads.svg"]);
    assert_eq!(scratch.names(), ["occupied", "wall"]);
    assert_eq!(names(&occupied), ["contact-loads.svg"]);
}

#[test]
fn limit_a_recording_does_not_replace_its_case() {
    let scratch = Scratch::new();
    let case = scratch.file("case.ron", AG);
    run(&[&"solve", &case, &"-o", &case]).fails(2, &["--output", "would replace the case file"]);
    assert_eq!(std::fs::read_to_string(&case).unwrap(), AG);
}

#[test]
fn limit_a_pipe_that_closes_early_is_no_failure() {
    let case = fixture("paper-handset.ron");
    let mut child =
        command(&[&"solve", &case, &"--json"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
}

#[cfg(target_os = "linux")]
#[test]
fn limit_a_full_disk_under_standard_output_is_a_failure() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let hertz = "hertz --body1 10,10 --body2 inf,inf --load 1 --json";
    let words: Vec<&str> = hertz.split(' ').collect();
    let words: Vec<&dyn AsRef<OsStr>> = words.iter().map(|word| word as _).collect();
    let output = command(&words).stdout(full).stderr(Stdio::piped()).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stderr).unwrap().contains("cannot write the answer"));
}

/// An output replaces a file of its kind that tribodyn wrote, and any other with `--force` only.
#[test]
fn limit_an_output_replaces_nothing_of_others() {
    let scratch = Scratch::new();
    let (other, layout) = (scratch.file("other.ron", AG), scratch.0.join("layout.json"));
    solve(&[&"-o", &other]).fails(2, &["other.ron exists and is not a recording that tribodyn wrote", "--force"]);
    run(&[&"layout", &"-o", &other]).fails(2, &["is not a layout that tribodyn wrote", "--force"]);
    let table = scratch.file("table.csv", "my,own,numbers\n1,2,3\n");
    let swept: [&dyn AsRef<OsStr>; 7] =
        [&"sweep", &other, &"--set", &"ring.z.Force=kN(40),kN(44)", &"-o", &table, &"--quiet"];
    run(&swept).fails(2, &["table.csv exists and is not a table that tribodyn wrote"]);
    assert_eq!(std::fs::read_to_string(&other).unwrap(), AG);
    assert_eq!(scratch.names(), ["other.ron", "table.csv"]);
    // With --force, and then over our own files without it.
    run(&[&swept[..], &[&"--force"]].concat()).table();
    run(&swept).table();
    run(&[&"layout", &"-o", &layout]).table();
    run(&[&"layout", &"-o", &layout]).table();
    solve(&[&"-o", &table]).fails(2, &["is not a recording"]);
    solve(&[&"-o", &table, &"--force"]).table();
    solve(&[&"-o", &table]).table();
    // A recording of another bearing is kept, one of the same may be made again.
    let twin = scratch.file("twin.ron", AG.replacen("name: \"", "name: \"another ", 1));
    let another = |rest: &[&dyn AsRef<OsStr>]| {
        run(&[&[&"solve" as &dyn AsRef<OsStr>, &twin, &"--model", &"jones-harris", &"-o", &table][..], rest].concat())
    };
    another(&[]).fails(2, &["is a recording of another bearing", "without --force"]);
    another(&[&"--force"]).table();
    another(&[]).table();
    // A recording in its own place, and a damaged one of nobody's.
    run(&[&"recover", &table, &"-o", &table]).table();
    run(&[&"recover", &table, &"-o", &other]).fails(2, &["other.ron exists and is"]);
    assert_eq!(std::fs::read_to_string(&other).unwrap(), AG);
}

#[test]
fn limit_figures_replace_nothing_of_others() {
    let scratch = Scratch::new();
    let folder = scratch.0.join("plots");
    std::fs::create_dir(&folder).unwrap();
    let mine = scratch.file("plots/contact-loads.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
    solve(&[&"--plot", &folder]).fails(2, &["contact-loads.svg exists and is not a file that tribodyn wrote"]);
    assert_eq!(names(&folder), ["contact-loads.svg"]);
    assert!(std::fs::metadata(&mine).unwrap().len() < 100);
    solve(&[&"--plot", &folder, &"--force"]).table();
    solve(&[&"--plot", &folder]).table();
    assert_eq!(names(&folder).len(), 10);
}

/// A link under the name of a temporary file is not written through.
#[cfg(unix)]
#[test]
fn limit_a_link_under_a_temporary_name_leads_nowhere() {
    let scratch = Scratch::new();
    let victim = scratch.file("victim", "mine");
    std::os::unix::fs::symlink(&victim, scratch.0.join(".run.mcap.part")).unwrap();
    std::os::unix::fs::symlink(&victim, scratch.0.join(".contact-loads.svg.part")).unwrap();
    solve(&[&"-o", &scratch.0.join("run.mcap"), &"--plot", &scratch.0]).table();
    assert_eq!(std::fs::read_to_string(victim).unwrap(), "mine");
}
