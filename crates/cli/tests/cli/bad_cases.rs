//! Case files that are refused: exit code 2; file, line, column, path, value and what is allowed; nothing written.

use super::{AG, Scratch, fixture, run};

/// A change to the silver-coated case of the paper that is refused.
struct Refusal {
    /// A text of the good case.
    from: &'static str,
    /// Its replacement, with « before the place that the message points at.
    to: &'static str,
    /// Path, with the value where there is one.
    field: &'static str,
    /// The fault or what is allowed.
    allowed: &'static str,
}

impl Refusal {
    fn check(&self) {
        assert!(AG.contains(self.from), "{} is not in the good case", self.from);
        let marked = AG.replacen(self.from, self.to, 1);
        let (before, _) = marked.split_once('«').unwrap();
        let line = before.lines().count();
        let column = before.lines().next_back().unwrap().chars().count() + 1;
        let scratch = Scratch::new();
        let case = scratch.file("case.ron", marked.replace('«', ""));
        let (run_file, plots) = (scratch.0.join("run.mcap"), scratch.0.join("plots"));
        let message = format!("{}:{line}:{column}: {}: ", case.display(), self.field);
        run(&[&"check", &case]).fails(2, &[&message, self.allowed]);
        for model in ["jones-harris", "traction"] {
            let solve: [&dyn AsRef<std::ffi::OsStr>; 9] =
                [&"solve", &case, &"--model", &model, &"-o", &run_file, &"--plot", &plots, &"--json"];
            run(&solve).fails(2, &[&message, self.allowed]);
        }
        assert_eq!(scratch.names(), ["case.ron"], "a refused case left something behind");
    }
}

#[test]
fn limit_unknown_field_is_refused() {
    Refusal {
        from: "ball_diameter: mm",
        to: "«ball_diametre: mm",
        field: "geometry.ball_diametre = mm(30.16)",
        allowed: "unknown field `ball_diametre`; allowed: ball_count, ball_diameter, pitch_diameter",
    }
    .check();
}

#[test]
fn limit_wrong_unit_is_refused() {
    Refusal {
        from: "ball_diameter: mm(30.16)",
        to: "ball_diameter: «kN(30.16)",
        field: "geometry.ball_diameter = kN(30.16)",
        allowed: "expected a length with its unit, such as mm(30.16); allowed units: m, mm, um, inch",
    }
    .check();
}

#[test]
fn limit_number_without_unit_is_refused() {
    Refusal {
        from: "Constant(rpm(14000))",
        to: "Constant(«14000)",
        field: "speed.inner.Constant = 14000",
        allowed: "allowed units: rad_per_s, rpm",
    }
    .check();
}

#[test]
fn limit_missing_field_is_refused() {
    Refusal {
        from: "geometry: (\n        ball_count: 13,",
        to: "geometry: «(",
        field: "geometry.ball_count",
        allowed: "field `ball_count` is missing",
    }
    .check();
}

#[test]
fn limit_negative_diameter_is_refused() {
    Refusal {
        from: "mm(30.16)",
        to: "«mm(-30.16)",
        field: "geometry.ball_diameter = mm(-30.16)",
        allowed: "must be greater than 0",
    }
    .check();
}

#[test]
fn limit_groove_smaller_than_the_ball_radius_is_refused() {
    Refusal {
        from: "inner_groove: Coefficient(0.527)",
        to: "inner_groove: Radius(«mm(15))",
        field: "geometry.inner_groove.Radius = mm(15)",
        allowed: "must be greater than the ball radius, 15.08 mm, and at most 21.112 mm",
    }
    .check();
    Refusal {
        from: "outer_groove: Coefficient(0.527)",
        to: "outer_groove: Coefficient(«0.49)",
        field: "geometry.outer_groove.Coefficient = 0.49",
        allowed: "must be above 0.5",
    }
    .check();
}

#[test]
fn limit_too_many_balls_for_the_pitch_circle_are_refused() {
    Refusal {
        from: "ball_count: 13",
        to: "ball_count: «18",
        field: "geometry.ball_count = 18",
        allowed: "must exceed the ball diameter, 30.16 mm; at most 17 fit",
    }
    .check();
}

#[test]
fn limit_peak_coefficient_below_the_residual_one_is_refused() {
    Refusal {
        from: "inner: (curve: Library(\"ag\")",
        to: "inner: (curve: Tested([
            (pressure: GPa(2.5), peak_slip: 3, peak_coefficient: 0.14, residual_coefficient: 0.12),
            (pressure: GPa(3.0), peak_slip: 3, peak_coefficient: «0.11, residual_coefficient: 0.12),
            (pressure: GPa(3.5), peak_slip: 3, peak_coefficient: 0.14, residual_coefficient: 0.12),
        ])",
        field: "coatings.inner.curve.Tested[1].peak_coefficient = 0.11",
        allowed: "must be greater than the residual coefficient, 0.12",
    }
    .check();
}

#[test]
fn limit_load_table_that_does_not_rise_in_time_is_refused() {
    Refusal {
        from: "Force(kN(20))",
        to: "ForceTable([(s(0), kN(0)), (s(1), kN(10)), («s(1), kN(20))])",
        field: "ring.x.ForceTable[2][0] = s(1)",
        allowed: "times must rise from row to row; the row before is at 1 s",
    }
    .check();
}

#[test]
fn limit_nan_is_refused() {
    Refusal {
        from: "kN(44)",
        to: "«kN(NaN)",
        field: "ring.z.Force = kN(NaN)",
        allowed: "NaN is not allowed: the number must be finite",
    }
    .check();
    Refusal {
        from: "drag_coefficient: 0.32",
        to: "drag_coefficient: «NaN",
        field: "fluid.drag_coefficient = NaN",
        allowed: "must be at least 0 and finite",
    }
    .check();
}

#[test]
fn limit_files_that_are_no_case_are_refused() {
    let scratch = Scratch::new();
    let empty = scratch.file("empty.ron", "");
    let latin = scratch.file("latin.ron", b"(name: \"\xb5m\")");
    let cut = scratch.file("cut.ron", &AG[..AG.len() / 2]);
    let missing = scratch.0.join("missing.ron");
    let missing = missing.as_path();
    for command in ["check", "solve"] {
        run(&[&command, &empty]).fails(2, &["empty.ron:1:1: ", "expected fields in parentheses"]);
        run(&[&command, &latin]).fails(2, &["cannot read", "latin.ron: it is not UTF-8 text"]);
        run(&[&command, &cut]).fails(2, &["cut.ron:", "not well-formed RON"]);
        run(&[&command, &missing]).fails(2, &["cannot read", "missing.ron"]);
        run(&[&command, &scratch.0]).fails(2, &["cannot read", &scratch.0.display().to_string()]);
    }
}

#[test]
fn limit_a_change_that_is_refused_names_its_option() {
    let case = fixture("paper-handset.ron");
    let refused = |change: &str, parts: &[&str]| run(&[&"check", &case, &"--set", &change]).fails(2, parts);
    refused("geometry.ball_count=18", &["--set geometry.ball_count=18: ", "paper-handset.ron:", "at most 17 fit"]);
    refused("geometry.ball=18", &["--set geometry.ball=18: geometry.ball: no such path", "ball_count, ball_diameter"]);
    refused("ring.z=kN(30)", &["--set ring.z=kN(30): ", "ring.z = kN(30)", "allowed: Force, ForceTable, Held"]);
    refused("ring.z.Force=kN(", &["--set ring.z.Force=kN(: ", "not one value in RON"]);
    refused("ring.z.Force", &["--set", "PATH=VALUE"]);
    // The pitch diameter is good by itself, but not with the ball that the other option makes.
    let both = run(&[&"check", &case, &"--set", &"ring.x.Force=kN(1)", &"--set", &"geometry.ball_diameter=mm(200)"]);
    both.fails(2, &["geometry.pitch_diameter = mm(165): must be greater than the ball diameter, 200 mm"]);
}

#[test]
fn limit_a_bad_file_is_not_blamed_on_an_option() {
    let scratch = Scratch::new();
    let case = scratch.file("case.ron", AG.replacen("mm(30.16)", "mm(-1)", 1));
    let outcome = run(&[&"solve", &case, &"--varying", &"false", &"--set", &"ring.x.Force=kN(1)"]);
    outcome.fails(2, &["× ", "case.ron:11:24: geometry.ball_diameter = mm(-1): "]);
    assert!(!outcome.err.contains("--"), "{}", outcome.err);
}

#[test]
fn limit_no_convergence_names_place_equation_and_residual() {
    let scratch = Scratch::new();
    let case = fixture("paper-handset.ron");
    let (run_file, plots) = (scratch.0.join("run.mcap"), scratch.0.join("plots"));
    let one_step: &str = "numerics.max_iterations=1";
    let words: [&dyn AsRef<std::ffi::OsStr>; 10] =
        [&"solve", &case, &"--model", &"traction", &"--set", &one_step, &"-o", &run_file, &"--plot", &plots];
    let outcome = run(&words);
    outcome
        .fails(1, &["paper-handset.ron: ", "did not converge", " of ", "relative residual of ", "tolerance 1.0e-10"]);
    assert!(outcome.err.contains("ball ") || outcome.err.contains("the inner ring"), "{}", outcome.err);
    assert_eq!(scratch.names(), [""; 0]);
}

#[test]
fn identity_a_byte_order_mark_is_left_out() {
    let scratch = Scratch::new();
    let marked = scratch.file("marked.ron", format!("\u{feff}{AG}"));
    let (with, without) =
        (run(&[&"check", &marked, &"--json"]), run(&[&"check", &fixture("paper-handset.ron"), &"--json"]));
    assert_eq!(with.json(), without.json());
    let bad = scratch.file("bad.ron", format!("\u{feff}{}", AG.replacen("ball_count: 13", "ball_count: 1", 1)));
    let column = AG.lines().find(|line| line.contains("ball_count: 13")).unwrap().find("13").unwrap() + 1;
    run(&[&"check", &bad]).fails(2, &[&format!(":{column}: geometry.ball_count = 1")]);
}

/// A name with escape sequences goes through every command that prints it; `run` looks for them in what is printed.
#[test]
fn limit_a_name_does_not_steer_the_terminal() {
    let scratch = Scratch::new();
    let first = AG.find("name: \"").unwrap() + 7;
    let name = "\u{1b}]0;owned\u{7}\u{1b}[2J\u{9b}31m";
    let case = scratch.file("case.ron", format!("{}{name}{}", &AG[..first], &AG[first..]));
    for words in [&["check"][..], &["solve", "--model", "jones-harris"], &["check", "--json"]] {
        let words: Vec<&dyn AsRef<std::ffi::OsStr>> = words.iter().map(|word| word as _).collect();
        let outcome = run(&[&words[..1], &[&case], &words[1..]].concat());
        assert_eq!(outcome.code, 0, "{}", outcome.err);
        assert!(!outcome.out.contains(['\u{1b}', '\u{7}', '\u{9b}']));
    }
    let bad = scratch.file("bad.ron", format!("({name}"));
    let outcome = run(&[&"check", &bad]);
    assert!(outcome.code == 2 && !outcome.err.contains(['\u{1b}', '\u{7}', '\u{9b}']), "{}", outcome.err);
}

#[test]
fn limit_a_long_line_is_not_shown_whole() {
    let scratch = Scratch::new();
    let code = AG.lines().map(|line| line.split("//").next().unwrap_or_default());
    let line: String = code.collect::<Vec<_>>().join(" ").replacen("ball_count: 13", "ball_count: 1", 1);
    let case = scratch.file("case.ron", format!("{}{line}", " ".repeat(100_000)));
    let outcome = run(&[&"check", &case]);
    outcome.fails(2, &["geometry.ball_count = 1: a bearing has at least 2 balls"]);
    assert!(outcome.err.len() < 2000, "{} bytes", outcome.err.len());
    let outcome = run(&[&"check", &scratch.file("x.ron", "x".repeat(1_000_000))]);
    assert!(outcome.code == 2 && outcome.err.len() < 4000, "{} bytes", outcome.err.len());
}

#[test]
fn limit_what_asks_for_too_much_is_refused_unless_the_limits_are_lifted() {
    let scratch = Scratch::new();
    let far = AG.replacen("ball_count: 13", "ball_count: 800", 1).replacen(
        "pitch_diameter: mm(165)",
        "pitch_diameter: m(40)",
        1,
    );
    let case = scratch.file("case.ron", far);
    run(&[&"check", &case]).fails(2, &["geometry.ball_count = 800: 800 balls", "the limit", "--no-limits"]);
    run(&[&"check", &case, &"--no-limits"]).table();
    let long = scratch.file("long.ron", format!("{AG}//{}", "x".repeat(2 << 20)));
    run(&[&"check", &long]).fails(2, &["long.ron", "it is too long", "--no-limits"]);
    run(&[&"check", &long, &"--no-limits"]).table();
}

/// All parts that the models with traction need and a case for Jones–Harris lacks are named at once, each with what it
/// must hold.
#[test]
fn limit_a_model_that_the_case_has_no_sections_for_is_refused() {
    let scratch = Scratch::new();
    let (run_file, case) = (scratch.0.join("run.mcap"), fixture("bearing-218.ron"));
    let coatings = "`coatings` (inner and outer, each with curve and thickness; or a `lubricant` in their place)";
    let needs = format!("{}: the traction model needs what the case does not have: {coatings}", case.display());
    let parts = [
        "`traction` (slip_unit",
        "`cage` (pocket_gap",
        "`wear` (inner",
        "`modelling.ring_centre` (Displaced or Inertial)",
    ];
    let texts: Vec<&str> = [needs.as_str()].into_iter().chain(parts).collect();
    run(&[&"solve", &case, &"-o", &run_file]).fails(2, &texts);
    run(&[&"life", &case]).fails(2, &texts);
    let table = scratch.0.join("table.csv");
    run(&[&"sweep", &case, &"--set", &"geometry.ball_count=14,15", &"-o", &table]).fails(2, &["`coatings`", "`wear`"]);
    let run_needs = ["a transient run needs what the case does not have", "`supports`", "`transient` (duration"];
    run(&[&"run", &case, &"-o", &run_file]).fails(2, &run_needs);
    run(&[&"run", &case, &"--duration", &"0.1", &"-o", &run_file]).fails(2, &run_needs);
    assert!(scratch.names().is_empty(), "{:?}", scratch.names());
    run(&[&"check", &case, &"--json"]).json();
}
