//! Arguments that are refused, each with exit code 2 and what is allowed.

use super::run_words;

#[test]
fn limit_hertz_refuses_impossible_numbers() {
    let hertz = |rest: &str| run_words(&format!("hertz --body1 10,10 {rest}"));
    hertz("--body2 inf,inf --load -3").fails(2, &["--load -3: allowed is a force in N, 0 or more"]);
    hertz("--body2 inf,inf --load NaN").fails(2, &["--load NaN: "]);
    hertz("--body2 inf,inf --load inf").fails(2, &["--load inf: "]);
    hertz("--body2 inf,inf --load ten").fails(2, &["'ten'", "--load"]);
    hertz("--body2 inf,inf").fails(2, &["--load"]);
    hertz("--body2 inf,inf --load 1 --young1 0").fails(2, &["--young1 0: allowed is a modulus in GPa above 0, or inf"]);
    hertz("--body2 inf,inf --load 1 --young2 NaN").fails(2, &["--young2 NaN: "]);
    hertz("--body2 inf,inf --load 1 --poisson1 0.5")
        .fails(2, &["--poisson1 0.5: allowed is a ratio from 0 to below 0.5"]);
    hertz("--body2 inf,inf --load 1 --poisson2 -0.1").fails(2, &["--poisson2 -0.1: "]);
    hertz("--body2 inf,inf --load 1 --angle NaN").fails(2, &["--angle NaN: "]);
    for body in ["NaN,1", "0,1", "1", "1,2,3", "a,b", ","] {
        hertz(&format!("--body2 {body} --load 1")).fails(2, &["--body2", "two radii in mm as RX,RY"]);
    }
    // Numbers that overflow on the way are refused, not written as null.
    hertz("--body2 inf,inf --load 1 --young1 1e300 --young2 1e300 --json").fails(2, &["modulus is inf"]);
}

#[test]
fn limit_hertz_refuses_bodies_without_a_point_contact() {
    let hertz = |body2: &str| run_words(&format!("hertz --body1 10,10 --body2 {body2} --load 1"));
    hertz("-10,-10").fails(2, &["curvature sum in the x plane", "above 0"]);
    hertz("20,-10").fails(2, &["curvature sum in the y plane", "above 0"]);
    hertz("-9,inf").fails(2, &["curvature sum in the x plane is -11.1111 1/m"]);
    let line = "hertz --body1 10,inf --body2 inf,inf --load 1";
    run_words(line).fails(2, &["length", "cylinders", "mm"]);
    run_words(&format!("{line} --length 0")).fails(2, &["length", "above 0"]);
    run_words("hertz --body1 10,10 --body2 inf,inf --load 1 --length 5").fails(2, &["length", "RX,inf"]);
}

/// A quarter of an inch is 6.35 mm, 10 lbf are 44.4822 N; a grade alone is a mineral oil.
#[test]
fn identity_numbers_with_units_and_names_of_oils() {
    let peak = |line: &str| run_words(&format!("hertz {line} --json")).json()["peak_pressure_pa"].as_f64().unwrap();
    let inches = peak("--body1 0.25in,0.25in --body2 inf,inf --load 10lbf");
    super::assert_close(inches, peak("--body1 6.35,6.35 --body2 inf,inf --load 44.4822161526"), 1e-9);
    let film = |oil: &str| {
        let line = "film contact --temperature 70 --load 555 --speed 3.46 --radius 3.78 --json --oil";
        run_words(&format!("{line} {oil}")).json()
    };
    assert_eq!(film("vg68"), film("mineral-vg68"));
}

#[test]
fn limit_traction_refuses_impossible_numbers() {
    let traction = |rest: &str| run_words(&format!("traction {rest}"));
    traction("--coating gold --pressure 2.5 --slip 1").fails(2, &["unknown coating \"gold\": allowed are ag, ptfe"]);
    for pressure in ["0", "-1", "NaN", "inf"] {
        let expected = format!("--pressure {pressure}: allowed is a pressure in GPa above 0");
        traction(&format!("--coating ag --pressure {pressure} --slip 1")).fails(2, &[&expected]);
    }
    traction("--coating ag --pressure 2.5 --slip 1,-1").fails(2, &["--slip -1: allowed are slips of 0 or more"]);
    traction("--coating ag --pressure 2.5 --slip NaN").fails(2, &["--slip NaN: "]);
    traction("--coating ag --pressure 2.5 --slip 1,x").fails(2, &["'x'", "--slip"]);
    traction("--coating ag --pressure 2.5").fails(2, &["--slip"]);
    traction("--coating ag --pressure 2.5 --slip 1 --order 3").fails(2, &["order 3 need 4 tested pressures, got 3"]);
}

#[test]
fn limit_unknown_words_are_refused() {
    run_words("dance").fails(2, &["dance"]);
    run_words("solve").fails(2, &["<CASE>"]);
    run_words("solve case.ron --model newton").fails(2, &["newton", "jones-harris", "traction"]);
    run_words("solve case.ron --varying maybe").fails(2, &["maybe", "true, false"]);
    run_words("").fails(2, &["Usage: tribodyn"]);
}

/// A slip in a range is a sweep of years: nothing is written before it is asked for twice.
/// A negative number behind any option is a value of it.
#[test]
fn limit_negative_numbers_are_told_what_is_allowed() {
    for (words, said) in [
        ("solve nowhere.ron --time-limit -1", "allowed are seconds above 0"),
        ("ensemble nowhere.ron --vary a=1..2 --members 2 --seed -1", "'-1' for '--seed"),
        ("hertz --body1 10,10 --body2 inf,inf --load 1 --length -2", "--length -2"),
    ] {
        let outcome = run_words(words);
        outcome.fails(2, &[said]);
        assert!(!outcome.err.contains("unexpected argument"), "{}", outcome.err);
    }
}

#[test]
fn limit_a_sweep_of_many_millions_asks_for_yes() {
    let scratch = super::Scratch::new();
    let (case, table) = (super::fixture("paper-handset.ron"), scratch.0.join("table.csv"));
    let many = super::run(&[
        &"sweep",
        &case,
        &"--set",
        &"ring.z.Force=kN(30..55 in 300)",
        &"--set",
        &"ring.x.Force=kN(8..20 in 300)",
        &"--set",
        &"speed.inner.Constant=rpm(9000..13000 in 300)",
        &"-o",
        &table,
    ]);
    many.fails(2, &["for 27000000 rows", "more than 10000000 rows", "--plan", "--yes"]);
    assert_eq!(scratch.names(), [""; 0]);
}
