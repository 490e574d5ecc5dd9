//! Prints the tables of docs/patch-rules.md: errors of the patch rules against their points, and what is chosen.

#[path = "../tests/patch_rules/contacts.rs"]
mod contacts;

use contacts::{SCALES, contacts, measure, silver};
use tribodyn_traction::{PatchRule, RuleUse, TractionError, choose_rule};

/// Cells of the reference in each direction: its own error is about 1e-9 at 22 per m/s, 1e-7 at 100.
const CELLS: usize = 2000;

/// Counts across and along of the split strips that are measured.
const STRIPS: [(usize, usize); 20] = [
    (4, 3),
    (5, 3),
    (6, 3),
    (7, 3),
    (8, 3),
    (8, 4),
    (8, 5),
    (10, 5),
    (10, 6),
    (10, 8),
    (12, 5),
    (12, 6),
    (12, 8),
    (14, 8),
    (16, 8),
    (16, 12),
    (20, 14),
    (24, 18),
    (28, 24),
    (32, 28),
];

fn main() -> Result<(), TractionError> {
    let law = silver();
    let rules = rules();
    for scale in SCALES {
        let contacts = contacts(scale);
        let exact: Vec<_> = contacts.iter().map(|contact| contact.brute_force(&law, CELLS)).collect();
        let coarser: Vec<_> = contacts.iter().map(|contact| contact.brute_force(&law, CELLS / 2)).collect();
        let (own, name_of_worst) = contacts
            .iter()
            .zip(exact.iter().zip(&coarser))
            .map(|(contact, (fine, coarse))| {
                (contact.errors(coarse, fine).into_iter().fold(0.0, f64::max), contact.name.as_str())
            })
            .fold((0.0, ""), |worst, one| if one.0 > worst.0 { one } else { worst });
        println!("\n## Slip scale {scale} per m/s\n");
        println!("With half the cells the reference differs by {own:.0e} ({name_of_worst}).\n");
        println!("| rule | points | force | moment | power |\n|---|---|---|---|---|");
        for &rule in &rules {
            let measured = measure(rule, &contacts, &law, &exact)?;
            let [force, moment, power] = measured.errors;
            println!("| {} | {:.1} | {force:.1e} | {moment:.1e} | {power:.1e} |", name(rule), measured.points);
        }
        println!("\n| target | chosen | points | error |\n|---|---|---|---|");
        let probes: Vec<_> = contacts.iter().map(|contact| contact.probe(&law)).collect();
        for target in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
            match choose_rule(target, &probes, RuleUse::Solver) {
                Ok((rule, error)) => {
                    let points = measure(rule, &contacts, &law, &exact)?.points;
                    println!("| {target:.0e} | {} | {points:.1} | {error:.1e} |", name(rule));
                }
                Err(error) => println!("| {target:.0e} | – | – | {error} |"),
            }
        }
    }
    Ok(())
}

fn rules() -> Vec<PatchRule> {
    let midpoint = [(5, 20), (10, 40), (20, 80), (40, 160)]
        .map(|(radial, circumferential)| PatchRule::PolarMidpoint { radial, circumferential });
    let jacobi =
        [(2, 6), (2, 8), (3, 8), (4, 8), (4, 10), (5, 12), (6, 14), (6, 16), (8, 16), (8, 20), (10, 24), (12, 32)]
            .map(|(radial, angles)| PatchRule::GaussJacobi { radial, angles });
    let strips = STRIPS.map(|(across, along)| PatchRule::SplitStrip { across, along });
    midpoint.into_iter().chain(jacobi).chain(strips).collect()
}

fn name(rule: PatchRule) -> String {
    match rule {
        PatchRule::PolarMidpoint { radial, circumferential } => format!("PolarMidpoint {radial} × {circumferential}"),
        PatchRule::GaussJacobi { radial, angles } => format!("GaussJacobi {radial} × {angles}"),
        PatchRule::SplitStrip { across, along } => format!("SplitStrip {across} × {along}"),
    }
}
