//! From fits by tolerance class to the mounting of a bearing: seats are the shaft's sections and a ring of housing.

use tribodyn_case::{
    Case, FitSpec, FitsSpec, HeatSpec, MaterialSpec, MountedRingSpec, MountingSpec, SeatSpec, ShaftSystem,
};

/// Largest difference of shaft and bore that is a seat, over the bore.
const SEAT: f64 = 5e-3;

/// A field of a bearing that cannot be used, and why.
type Refused = (&'static str, String);

/// The mounting of a bearing (m from the start of the shaft). Temperatures are those of `heat`: the inner ring has that
/// of the shaft, the outer one that of the housing, the balls the mean of both.
pub(super) fn mounting(system: &ShaftSystem, at: f64, fits: &FitsSpec, case: &Case) -> Result<MountingSpec, Refused> {
    let rating = case.rating.as_ref();
    let (Some(bore), Some(outside)) = (rating.and_then(|r| r.bore), rating.and_then(|r| r.outside)) else {
        let message = "the case of the bearing lacks rating.bore and rating.outside, from which the seats follow";
        return Err(("fits", message.to_owned()));
    };
    let (outer, inner, shaft_material) = section(system, at);
    if (outer - bore).abs() > SEAT * bore {
        let millimetres = |metres: f64| (metres * 1e6).round() / 1e3;
        let message = format!(
            "the shaft is {} mm thick where the bearing has a bore of {} mm: move the bearing or change the section",
            millimetres(outer),
            millimetres(bore)
        );
        return Err(("at", message));
    }
    let heat = system.heat.unwrap_or(tribodyn_case::ShaftHeatSpec {
        shaft_expansion: 0.0,
        shaft_temperature_rise: 0.0,
        housing_expansion: 0.0,
        housing_temperature_rise: 0.0,
    });
    let seat = |class, far_diameter, material: MaterialSpec, (expansion, temperature_rise)| SeatSpec {
        interference: None,
        fit: Some(FitSpec { class, ring: fits.ring, within: fits.within, roughness: fits.roughness }),
        far_diameter,
        material,
        expansion,
        temperature_rise,
    };
    let of_shaft = (heat.shaft_expansion, heat.shaft_temperature_rise);
    let of_housing = (heat.housing_expansion, heat.housing_temperature_rise);
    let expansion = fits.expansion;
    let ring = |seat_diameter, temperature_rise, seat| MountedRingSpec {
        seat_diameter,
        expansion,
        temperature_rise,
        seat: Some(seat),
    };
    let in_housing = fits.housing_material.unwrap_or(shaft_material);
    Ok(MountingSpec {
        inner: ring(bore, of_shaft.1, seat(fits.shaft, inner, shaft_material, of_shaft)),
        outer: ring(outside, of_housing.1, seat(fits.housing, fits.housing_outside, in_housing, of_housing)),
        ball: HeatSpec { expansion, temperature_rise: 0.5 * (of_shaft.1 + of_housing.1) },
    })
}

/// Outer and inner diameter of the shaft at a place, and its material; where two sections meet, the later one's.
fn section(system: &ShaftSystem, at: f64) -> (f64, f64, MaterialSpec) {
    let mut start = 0.0;
    let mut found = (0.0, 0.0, system.shaft.material);
    for part in &system.shaft.sections {
        // A checked shaft has one section at least, and begins at 0.
        if at + 1e-9 < start {
            break;
        }
        let share = ((at - start) / part.length).clamp(0.0, 1.0);
        let between = |first: f64, last: Option<f64>| first + share * (last.unwrap_or(first) - first);
        let bore = part.inner.unwrap_or(0.0);
        found = (
            between(part.outer, part.outer_end),
            between(bore, part.inner_end),
            part.material.unwrap_or(system.shaft.material),
        );
        start += part.length;
    }
    found
}
