//! Thrust on the side of a groove that has no shoulder: refused or named by every command.

use super::{Scratch, fixture, run, run_words};

/// A relieved outer ring carries thrust one way: what would press the balls out of it is refused with the sign to take.
#[test]
fn limit_thrust_from_the_wrong_side_is_refused_by_every_command() {
    let scratch = Scratch::new();
    let case = scratch.0.join("7210B.ron");
    run(&[&"new", &"7210B", &"-o", &case]).table();
    let text = std::fs::read_to_string(&case).unwrap();
    assert!(text.contains("shoulders: (inner: Both, outer: One),"), "{text}");
    let case = case.to_str().unwrap();
    for load in ["--set ring.z.Force=N(-3000)", "--set ring.z.Force=N(0)"] {
        let hint = if load.contains("-3000") { "turn its sign" } else { "give it an axial load" };
        for command in [
            "solve",
            "solve --model traction",
            "solve --model jones-harris",
            "stiffness",
            "stiffness --model jones-harris",
            "modes",
            "rating",
            "rating --model steady-orbit",
        ] {
            run_words(&format!("{command} {case} {load}")).fails(2, &["geometry.shoulders", hint]);
        }
        let warnings = run_words(&format!("check {case} {load} --json")).json()["warnings"].to_string();
        assert!(warnings.contains("geometry.shoulders") && warnings.contains(hint), "{warnings}");
    }
}

/// Where the case does not say which sides have shoulders, balls on the side of negative contact angles are named.
#[test]
fn limit_balls_on_an_unknown_side_are_named() {
    let case = fixture("angular-7210.ron");
    let solve = |options: &str| {
        let line = format!("solve {} --model jones-harris {options} --json", case.to_str().unwrap());
        run_words(&line).json()["warnings"].to_string()
    };
    let open = solve("--set ring.z.Force=N(-3000)");
    assert!(open.contains("does not say whether their grooves have a shoulder there"), "{open}");
    let both = solve("--set ring.z.Force=N(-3000) --set geometry.shoulders=(inner:Both,outer:Both)");
    assert!(!both.contains("does not say whether"), "{both}");
    // Held on the wrong side of a ring with one shoulder: balls there are implausible.
    let held = solve("--set ring.z=Held(um(-850)) --set geometry.shoulders=(inner:Both,outer:One)");
    assert!(held.contains("has no shoulder") && held.contains("implausible: contact angle"), "{held}");
}
