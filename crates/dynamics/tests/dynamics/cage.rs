//! A free cage in whole runs of the fast scheme.

use super::run;
use tribodyn_case::{Case, set_value};

/// A light cage that hardly slides where balls press it, its lands dry and without friction, thrown about by the
/// friction in its pockets.
#[test]
fn limit_friction_in_pockets_puts_no_energy_in() {
    let land = "radius: mm(26.5), width: mm(2), gap: mm(0.15), stiffness: N_per_um(5), damping: s_per_m(0.5), \
                friction: 0";
    let lands = format!("[(land: Outer, axial: mm(-5.5), {land}), (land: Outer, axial: mm(5.5), {land})]");
    let changes = [
        ("cage.pocket_friction", "0.5"),
        ("cage.inertia", "kg_mm2(1.48)"),
        ("cage.free.transverse_inertia", "kg_mm2(0.773)"),
        ("cage.free.mass", "g(2.5)"),
        ("cage.free.lands", &lands),
        ("cage.free.displacement", "(um(-30), um(10))"),
        ("transient.duration", "s(0.12)"),
        ("transient.scheme", "Fast(step: us(10))"),
    ];
    let text = include_str!("../../../../fixtures/cases/cage-6206.ron").to_owned();
    let text = changes.iter().fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
    let (_, kept) = run(&Case::from_ron(&text).unwrap());
    let largest = kept.samples.iter().flat_map(|s| &s.balls).filter_map(|b| Some(b.pocket?.force_n.abs()));
    let largest = largest.fold(0.0, f64::max);
    let power = &kept.samples.last().unwrap().power;
    let off = power.imbalance_j / power.throughput_j;
    // While friction was taken at the start of a step, 6 to 7 % of the work were lost.
    assert!(largest > 50.0 && off.abs() < 0.02, "{largest} N, {off:e}");
}
