//! `completions` and `man`: they know every command.

use super::{Scratch, run, run_words};

/// Commands as the help lists them.
fn listed() -> Vec<String> {
    let help = run_words("--help");
    let list = help.table().split("Commands:\n").nth(1).and_then(|rest| rest.split("\n\n").next()).unwrap().to_owned();
    let names = list.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names.filter_map(|line| line.split_whitespace().next().map(str::to_owned)).collect()
}

#[test]
fn identity_shells_complete_every_command() {
    assert!(listed().len() > 20);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let outcome = run_words(&format!("completions {shell}"));
        let script = outcome.table();
        for name in listed() {
            assert!(script.contains(&name), "{shell} does not complete {name}");
        }
    }
    run_words("completions tcsh").fails(2, &["bash", "fish"]);
}

#[test]
fn identity_every_command_has_a_manual_page() {
    let scratch = Scratch::new();
    let folder = scratch.0.join("man");
    assert_eq!(run(&[&"man", &"-o", &folder]).table(), "");
    for name in listed().into_iter().filter(|name| name != "help") {
        let page = std::fs::read_to_string(folder.join(format!("tribodyn-{name}.1"))).unwrap();
        assert!(page.starts_with(".ie") || page.contains(".TH"), "{name}: {}", &page[..80.min(page.len())]);
        assert!(page.contains(&format!("tribodyn\\-{name}")), "{name}");
    }
    let contact = std::fs::read_to_string(folder.join("tribodyn-film-contact.1")).unwrap();
    assert!(contact.contains("\\-\\-temperature"), "options are in the pages");
}
