//! Licences of all dependencies, against those that MIT code may be linked with.

use super::metadata::Metadata;
use super::{Outcome, finish};
use crate::error::Failure;
use std::process::Command;

/// Permissive licences without a duty beyond keeping the notice.
const ALLOWED: [&str; 11] = [
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "CC0-1.0",
    "ISC",
    "MIT",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];

pub fn check() -> Result<Outcome, Failure> {
    let Some(host) = host() else {
        return Ok(Outcome::Skipped("rustc does not name its host platform".to_owned()));
    };
    let metadata = Metadata::read(&["--filter-platform", &host])?;
    let refused = metadata.packages.iter().filter(|package| package.source.is_some()).filter_map(|package| {
        let licence = package.license.as_deref().unwrap_or("none stated");
        (!allowed(licence)).then(|| format!("{} {}: {licence}", package.name, package.version))
    });
    finish("licences that are not on the list in xtask/src/ci/licences.rs", refused.collect())
}

/// The platform that Cargo builds for: others would have to be downloaded.
fn host() -> Option<String> {
    let output = Command::new("rustc").arg("-vV").output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    text.lines().find_map(|line| line.strip_prefix("host: ").map(str::to_owned))
}

/// True if an SPDX expression can be met with allowed licences; `/` is the old way to write OR.
fn allowed(expression: &str) -> bool {
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let tokens: Vec<&str> = spaced.split_whitespace().collect();
    let mut rest = tokens.as_slice();
    either(&mut rest) && rest.is_empty()
}

/// `both OR both …`
fn either(rest: &mut &[&str]) -> bool {
    let mut met = both(rest);
    while skip(rest, "OR") {
        met |= both(rest);
    }
    met
}

/// `one AND one …`
fn both(rest: &mut &[&str]) -> bool {
    let mut met = one(rest);
    while skip(rest, "AND") {
        met &= one(rest);
    }
    met
}

/// A licence, with its exception, or an expression in brackets.
fn one(rest: &mut &[&str]) -> bool {
    if skip(rest, "(") {
        let met = either(rest);
        return skip(rest, ")") && met;
    }
    let Some((&name, tail)) = rest.split_first() else { return false };
    *rest = tail;
    if !skip(rest, "WITH") {
        return ALLOWED.contains(&name);
    }
    let Some((exception, tail)) = rest.split_first() else { return false };
    *rest = tail;
    ALLOWED.contains(&format!("{name} WITH {exception}").as_str())
}

fn skip(rest: &mut &[&str], word: &str) -> bool {
    match rest.split_first() {
        Some((first, tail)) if *first == word => {
            *rest = tail;
            true
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_expressions_are_met_as_spdx_reads_them() {
        for met in [
            "MIT",
            "Apache-2.0 / MIT",
            "GPL-3.0-only OR MIT",
            "(MIT OR GPL-2.0-only) AND Unicode-3.0",
            "Apache-2.0 WITH LLVM-exception OR GPL-2.0-only",
        ] {
            assert!(allowed(met), "{met}");
        }
        for not in ["GPL-3.0-only", "MIT AND GPL-3.0-only", "none stated", "(MIT", "", "MIT WITH odd-exception"] {
            assert!(!allowed(not), "{not}");
        }
    }
}
