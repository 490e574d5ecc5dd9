//! Case files as arguments, with the changes that the command line makes to them.

use std::path::PathBuf;
use tribodyn_study::Change;

/// A case file and what to change in it for this run.
#[derive(clap::Args)]
pub struct CaseArguments {
    /// Case file (RON)
    #[arg(value_name = "CASE")]
    pub path: PathBuf,
    /// Replace one value of the case for this run, such as 'ring.z.Force=kN(30)'; may be repeated
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = change)]
    pub changes: Vec<Change>,
}

fn change(text: &str) -> Result<Change, String> {
    match text.split_once('=') {
        Some((path, value)) if !path.trim().is_empty() && !value.trim().is_empty() => {
            Ok(Change::new(format!("--set {text}"), path.trim(), value.trim()))
        }
        _ => Err("allowed is PATH=VALUE, the value as in a case file, such as ring.z.Force=kN(30)".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::change;
    use tribodyn_study::Change;

    #[test]
    fn limit_a_change_has_a_path_and_a_value() {
        let expected = Change::new("--set geometry.fit = deg(1)".to_owned(), "geometry.fit", "deg(1)");
        assert_eq!(change("geometry.fit = deg(1)").unwrap(), expected);
        assert!(change("geometry.fit").is_err() && change("=1").is_err() && change("a=").is_err());
    }
}
