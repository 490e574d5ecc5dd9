//! Traction on a silver-coated contact patch that slips along rolling and spins, for a growing slip.

use tribodyn_traction::*;

fn main() -> Result<(), TractionError> {
    let law = CoatingLaw::varying(&Coating::library("ag")?, 2)?;
    let unit = SlipUnit::Scaled { per_m_s: 22.0 };
    let law = PatchLaw { law: &law, slip_unit: unit, pressure: PressureChoice::Peak };
    let (semi_lateral, semi_rolling, ball_radius, surface_radius) = (3e-3, 0.4e-3, 0.015, 0.0153);
    let patch = Patch { semi_lateral, semi_rolling, peak_pressure: 2.4e9, ball_radius, surface_radius };
    let load = 2.0 / 3.0 * std::f64::consts::PI * patch.peak_pressure * semi_lateral * semi_rolling;
    let kernel = FastPatch::new(PatchRule::SplitStrip { across: 8, along: 3 })?;
    for rolling in [0.01, 0.1, 1.0] {
        let motion = RelativeMotion { rolling, lateral: 0.0, spin: 150.0, about_lateral: 0.0, about_rolling: 0.0 };
        let traction = fast_patch_traction(&kernel, &patch, &motion, 60.0, &law);
        let (force, heat) = (traction.force_rolling, traction.power);
        println!("slip {rolling} m/s: {force:.1} N of {load:.0} N load, coefficient {:.4}, {heat:.0} W", -force / load);
    }
    Ok(())
}
