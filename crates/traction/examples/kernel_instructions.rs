//! Runs a fixed number of patches for an instruction counter: no clock, no random numbers, the same work every time.
//!
//!     cargo build --release -p tribodyn-traction --example kernel_instructions
//!     valgrind --tool=callgrind --toggle-collect='*measured*' \
//!         target/release/examples/kernel_instructions fast strips 1000
//!
//! Arguments: `generic`, `fast` or `derivative`, or `own` or `own-derivative` for a film-like law that this example
//! brings; `midpoint` (10 × 40), `jacobi` (4 × 12), `strips` (8 × 3) or `fine`
//! (16 × 8); how many times the three contacts are run. It prints the number of nodes, by which a count is to be
//! divided, and a checksum.

mod film_law;

use film_law::Film;
use std::{env, process::ExitCode};
use tribodyn_traction::{
    Coating, CoatingLaw, Conditions, CurveNumber, CustomCurve, CustomLaw, FastPatch, Law, MovingPatch, OverSlip, Patch,
    PatchLaw, PatchRule, PressureChoice, RelativeMotion, SlipField, SlipUnit, fast_patch_traction, patch_traction,
};

/// A loaded and a light contact, and one without spin.
fn contacts() -> [(Patch, RelativeMotion); 3] {
    let patch = |semi_lateral: f64, peak_pressure: f64| Patch {
        semi_lateral,
        semi_rolling: 0.12 * semi_lateral,
        peak_pressure,
        ball_radius: 0.01508,
        surface_radius: 0.0155,
    };
    let motion = |rolling: f64, lateral: f64, spin: f64| RelativeMotion {
        rolling,
        lateral,
        spin,
        about_lateral: -25.0,
        about_rolling: 4.0,
    };
    [
        (patch(4e-3, 2.2e9), motion(0.4, 0.07, 250.0)),
        (patch(3e-3, 1.7e9), motion(0.1, 0.05, -90.0)),
        (patch(3.5e-3, 1.9e9), motion(0.38, 0.07, 0.0)),
    ]
}

/// The part that is to be counted.
#[inline(never)]
fn measured(kind: &str, fast: &FastPatch, law: &PatchLaw<'_, Law>, repeats: usize) -> Option<f64> {
    let contacts = contacts();
    let mut sum = 0.0;
    for i in 0..repeats {
        for (patch, motion) in &contacts {
            let motion = RelativeMotion { rolling: motion.rolling + 1e-6 * i as f64, ..*motion };
            sum += match kind {
                "generic" => patch_traction(patch, &motion, 60.0, law, fast.quadrature()).force_rolling,
                "fast" | "own" => fast_patch_traction(fast, patch, &motion, 60.0, law).force_rolling,
                "derivative" | "own-derivative" => {
                    let contact = MovingPatch { patch: *patch, motion, rolling_speed: 60.0 };
                    law.fast_derivative(&contact, fast)?.by_motion[0][0]
                }
                _ => return None,
            };
        }
    }
    Some(sum)
}

/// The law that a kind is measured with.
fn law_of(kind: &str) -> Result<Law, String> {
    if kind.starts_with("own") {
        return Ok(Law::custom(Film { temperature: 340.0 }));
    }
    let silver = Coating::library("ag").and_then(|coating| CoatingLaw::varying(&coating, 2));
    silver.map(Law::from).map_err(|error| error.to_string())
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [kind, rule, repeats] = arguments.as_slice() else {
        eprintln!(
            "usage: kernel_instructions generic|fast|derivative|own|own-derivative midpoint|jacobi|strips|fine REPEATS"
        );
        return ExitCode::FAILURE;
    };
    let rule = match rule.as_str() {
        "midpoint" => PatchRule::PolarMidpoint { radial: 10, circumferential: 40 },
        "jacobi" => PatchRule::GaussJacobi { radial: 4, angles: 12 },
        "strips" => PatchRule::SplitStrip { across: 8, along: 3 },
        "fine" => PatchRule::SplitStrip { across: 16, along: 8 },
        other => {
            eprintln!("no rule is called {other}");
            return ExitCode::FAILURE;
        }
    };
    let (Ok(repeats), Ok(fast)) = (repeats.parse::<usize>(), FastPatch::new(rule)) else {
        eprintln!("not a number of repeats: {repeats}");
        return ExitCode::FAILURE;
    };
    let law = match law_of(kind) {
        Ok(law) => law,
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    };
    let patch_law =
        PatchLaw { law: &law, slip_unit: SlipUnit::Scaled { per_m_s: 22.0 }, pressure: PressureChoice::Peak };
    let Some(sum) = measured(kind, &fast, &patch_law, repeats) else {
        eprintln!("nothing is called {kind}");
        return ExitCode::FAILURE;
    };
    let nodes: usize =
        contacts().iter().map(|(patch, motion)| fast.quadrature().point_count(&SlipField::new(patch, motion))).sum();
    println!("nodes {} checksum {sum:.9e}", nodes * repeats);
    ExitCode::SUCCESS
}
