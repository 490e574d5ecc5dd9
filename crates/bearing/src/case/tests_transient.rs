//! The sections of a transient run.

use super::tests::{Refused, check_refusal};
use super::*;

const AG: &str = include_str!("../../../../fixtures/cases/paper-handset.ron");

#[test]
fn probe() {
    let base = "    supports: (
        inner: (mass: kg(12), stiffness: (N_per_um(100), N_per_um(100), N_per_um(50)), damping: (N_s_per_m(500), N_s_per_m(500), N_s_per_m(300))),
        outer: (mass: kg(5), stiffness: (N_per_um(200), N_per_um(200)), damping: (N_s_per_m(800), N_s_per_m(800))),
    ),\n";
    for s in [base.to_owned(),
        base.replace("(N_per_um(100), N_per_um(100), N_per_um(50))", "[N_per_um(100), N_per_um(100), N_per_um(50)]"),
        base.replace("N_per_um(100), N_per_um(50)", "N_per_um(100)"),
        base.replace("(N_per_um(200), N_per_um(200))", "(N_per_um(200), N_per_um(200), N_per_um(200))"),
        base.replace("N_per_um(50)", "N_s_per_m(50)"),
        base.replace("N_per_um(50)", "N_per_um(-50)"),
        base.replace("N_per_um(50)", "50"),
        base.replace("kg(12)", "12"),
        base.replace("kg(12)", "g(0)"),
        base.replace("mass: kg(12), ", ""),
        base.replace("outer: (mass", "outre: (mass"),
        base.replace("(N_per_um(100), N_per_um(100), N_per_um(50))", "N_per_um(100)"),
        base.replace("supports: (", "supports: Some(("). replace("    ),\n", "    )),\n"),
    ] {
        let text = AG.replacen("    numerics: (", &format!("{s}    numerics: ("), 1);
        match Case::from_ron(&text) { Ok(c) => println!("ok {:?}", c.supports), Err(e) => println!("{}:{} {e} [{}]", e.line, e.column, &text[e.offset..e.offset+e.length]) }
    }
    for s in ["inertia: kg_m2(0.004),", "inertia: Some(kg_m2(0.004)),", "inertia: None,", "inertia: kg(3),", "inertia: kg_m2(0),", "pocket_damping: N_per_m(3),", "pocket_damping: s_per_m(-1),", "guidance: (land: Middle, radius: mm(80), width: mm(6), gap: mm(0.3)),", "guidance: Some((land: Outer, radius: mm(80), width: mm(6), gap: mm(0.3))),","guidance: (land: Outer, radius: mm(80), width: mm(6), gap: mm(0)),","guidance: (land: Outer, radius: mm(80), width: mm(6)),"] {
        let text = AG.replacen("        pocket_friction", &format!("        {s}\n        pocket_friction"), 1);
        match Case::from_ron(&text) { Ok(c) => println!("ok {:?}", c.cage), Err(e) => println!("{}:{} {e} [{}]", e.line, e.column, &text[e.offset..e.offset+e.length]) }
    }
    for s in ["recording: (state_rate: kHz(25.6), ball_rate: kHz(50)),", "recording: (state_rate: kHz(0), ball_rate: kHz(5)),","transient: (duration: s(1), start: Rest, scheme: Fast(step: us(2)), contact_damping: 2, wear_acceleration: 0),", "transient: (duration: s(1), start: Rest, scheme: Euler(step: us(2)), contact_damping: 0.1, wear_acceleration: 0),", "transient: (duration: s(1), start: rest, scheme: Fast(step: us(2)), contact_damping: 0.1, wear_acceleration: 0),","transient: (duration: s(1), start: Rest, scheme: Fast(step: us(200)), contact_damping: 0.1, wear_acceleration: 0),","transient: (duration: s(1), start: Rest, scheme: DormandPrince(tolerance: 1, longest: us(20)), contact_damping: 0.1, wear_acceleration: 0),","defects: [(race: Inner, azimuth: deg(0), width: deg(0), depth: um(3), bare: 0)],","defects: [(race: Inner, azimuth: deg(0), width: deg(3), depth: um(3), bare: 0.5)],","defects: (race: Inner, azimuth: deg(0), width: deg(3), depth: um(3), bare: 0.5),","defects: [(race: Inner, azimuth: deg(0), width: deg(3), depth: um(3), bare: 0, x: 1)],"] {
        let text = AG.replacen("    numerics: (", &format!("    {s}\n    numerics: ("), 1);
        match Case::from_ron(&text) { Ok(_) => println!("ok {s}"), Err(e) => println!("{}:{} {e} [{}]", e.line, e.column, &text[e.offset..e.offset+e.length]) }
    }
}
