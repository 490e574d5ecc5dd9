//! Hertz contact of a 30.16 mm ball on the inner race of an angular-contact bearing, steel on steel.

use tribodyn_contact::{Body, ContactError, ElasticBody, HertzContact, effective_modulus, relative_curvatures};

fn main() -> Result<(), ContactError> {
    let steel = ElasticBody { young: 206e9, poisson: 0.3 };
    // x along rolling, y across the groove; the groove is concave.
    let ball = Body { radius_x: 15.08e-3, radius_y: 15.08e-3 };
    let race = Body { radius_x: 65.0e-3, radius_y: -15.68e-3 };
    let curvatures = relative_curvatures(&ball, &race, 0.0)?;
    let contact = HertzContact::new(curvatures.x, curvatures.y, effective_modulus(&steel, &steel))?;
    for load in [1e3, 5e3, 10e3] {
        let ellipse = contact.ellipse(load);
        let [a, b] = [ellipse.semi_lateral(), ellipse.semi_rolling()].map(|axis| axis * 1e3);
        let (pressure, approach) = (ellipse.peak_pressure * 1e-9, contact.approach(load) * 1e6);
        println!("{load:>6} N: {pressure:.3} GPa, {a:.3} x {b:.3} mm, approach {approach:.2} um");
    }
    println!("stiffness {:.3e} N/m^1.5", contact.stiffness());
    Ok(())
}
