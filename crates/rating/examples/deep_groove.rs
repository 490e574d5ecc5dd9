//! Ratings and basic lives of a deep-groove bearing 6206 under rising radial loads.
use tribodyn_rating::{RatedBearing, RatingError, basic_life_mrev};

fn main() -> Result<(), RatingError> {
    let bearing = RatedBearing {
        ball_count: 9,
        ball_diameter: 9.525e-3,
        pitch_diameter: 46e-3,
        contact_angle: 0.0,
        inner_coefficient: 0.52,
        outer_coefficient: 0.53,
    };
    let dynamic = bearing.dynamic_rating()?;
    println!("C_r {dynamic:.0} N, C_0r {:.0} N", bearing.static_rating()?);
    for radial in [1000.0, 2000.0, 4000.0] {
        let life = basic_life_mrev(dynamic, bearing.equivalent_load(radial, 500.0)?);
        println!("{radial} N: L_10 {:.1} million turns", life.unwrap_or(f64::INFINITY));
    }
    Ok(())
}
