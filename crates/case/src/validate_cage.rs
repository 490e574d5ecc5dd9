//! Impossible values of oil in pockets and of a cage that is free to move.

use super::validate::{Verdict, millimetres, not_negative, positive, require};
use super::*;
use tribodyn_bearing::{PocketForce, PocketShape, Side};

/// Largest gap of a land over its radius: the film in it is treated as flat.
pub(super) const GAP_MAX: f64 = 0.1;

pub(super) fn validate(case: &Case) -> Verdict {
    film(case)?;
    churning(case)?;
    let Some((cage, free)) = case.cage.as_ref().and_then(|cage| Some((cage, cage.free.as_ref()?))) else {
        return Ok(());
    };
    let path = "cage.free";
    require(
        cage.guidance.is_none(),
        "cage.guidance",
        "guides a cage that only turns: the lands of a free one are in cage.free.lands, with their films",
    )?;
    require(
        case.modelling.pocket_force != Some(PocketForce::AsPrinted),
        "modelling.pocket_force",
        "as printed there is force in the whole pocket of a cage that only turns: leave it out with cage.free",
    )?;
    positive(&format!("{path}.mass"), free.mass)?;
    positive(&format!("{path}.transverse_inertia"), free.transverse_inertia)?;
    if let Some(inertia) = cage.inertia {
        let limits = format!("must be at least half of cage.inertia, {inertia:e} kg m²: no body has less");
        require(2.0 * free.transverse_inertia >= inertia, &format!("{path}.transverse_inertia"), limits)?;
    }
    let pitch = case.geometry.pitch_diameter;
    let within = format!("must be smaller than half of the pitch diameter, {} mm", pitch * 500.0);
    require(free.unbalance.abs() < 0.5 * pitch, &format!("{path}.unbalance"), within)?;
    if let PocketShape::RaceTrack { axial_gap } = free.pockets {
        not_negative(&format!("{path}.pockets.RaceTrack.axial_gap"), axial_gap)?;
    }
    let closest = free.lands.iter().map(|land| land.gap).fold(f64::INFINITY, f64::min);
    for (k, value) in free.displacement.into_iter().enumerate() {
        let most = closest.min(case.geometry.ball_diameter);
        let limits = format!("must be within ± {} mm, the smallest gap of its lands", millimetres(most));
        require(value.abs() <= most, &format!("{path}.displacement[{k}]"), limits)?;
    }
    free.lands
        .iter()
        .enumerate()
        .try_for_each(|(k, land)| self::land(&format!("{path}.lands[{k}]"), land, &case.geometry))
}

/// The form of a cage that a fluid brakes: a ring, of a bearing that has a fluid.
fn churning(case: &Case) -> Verdict {
    let Some(form) = case.cage.as_ref().and_then(|cage| cage.churning) else { return Ok(()) };
    let path = "cage.churning";
    require(case.fluid.is_some(), path, "is in the fluid of a section `fluid`: leave it out of a dry bearing")?;
    positive(&format!("{path}.bore"), form.bore)?;
    positive(&format!("{path}.width"), form.width)?;
    let limits = format!("must be greater than cage.churning.bore, {} mm", (form.bore * 1e9).round() / 1e6);
    require(form.outside > form.bore, &format!("{path}.outside"), limits)
}

/// Oil in the pockets: of a bearing that has some, and thinner than the pocket is wide.
fn film(case: &Case) -> Verdict {
    let Some((cage, film)) = case.cage.as_ref().and_then(|cage| Some((cage, cage.pocket_film?))) else {
        return Ok(());
    };
    let path = "cage.pocket_film";
    require(case.lubricant.is_some(), path, "is the oil of a section `lubricant`: leave it out of a dry bearing")?;
    let full = film.fill > 0.0 && film.fill <= 1.0;
    require(
        full,
        &format!("{path}.fill"),
        "must be greater than 0 and at most 1; leave pocket_film out of dry pockets",
    )?;
    let most = 0.25 * cage.pocket_gap;
    let limits = format!("must be greater than 0 and at most a quarter of the pocket's gap, {} um", most * 1e6);
    require(film.roughness > 0.0 && film.roughness <= most, &format!("{path}.roughness"), limits)
}

/// Farthest from the plane of the pockets that a land has its middle, ball diameters: cages are some two of them wide.
const AXIAL_MAX: f64 = 3.0;

/// Refuses a land that is not on the side of the pitch circle on which its ring is, or more than a ball diameter away.
pub(super) fn land_place(path: &str, (side, radius): (Side, f64), geometry: &GeometrySpec) -> Verdict {
    let (ball, pitch) = (geometry.ball_diameter, 0.5 * geometry.pitch_diameter);
    let (least, most) = match side {
        Side::Inner => ((pitch - ball).max(0.0), pitch),
        Side::Outer => (pitch, pitch + ball),
    };
    let [low, high] = [least, most].map(millimetres);
    let of_pitch_circle = if side == Side::Inner { "inside" } else { "outside" };
    let message = format!(
        "must lie between {low} and {high} mm: a land of the {} ring is {of_pitch_circle} the pitch circle, at most a \
         ball diameter from it",
        side.name()
    );
    require((least..=most).contains(&radius), path, message)
}

fn land(path: &str, land: &CageLandSpec, geometry: &GeometrySpec) -> Verdict {
    positive(&format!("{path}.radius"), land.radius)?;
    land_place(&format!("{path}.radius"), (land.land, land.radius), geometry)?;
    let most = AXIAL_MAX * geometry.ball_diameter;
    let limits = format!("must lie within {AXIAL_MAX} ball diameters of the pockets, ±{} mm", millimetres(most));
    require(land.axial.abs() <= most, &format!("{path}.axial"), limits)?;
    positive(&format!("{path}.width"), land.width)?;
    let most = GAP_MAX * land.radius;
    let limits = format!("must be greater than 0 and at most a tenth of the land's radius, {} mm", millimetres(most));
    require(land.gap > 0.0 && land.gap <= most, &format!("{path}.gap"), limits)?;
    positive(&format!("{path}.stiffness"), land.stiffness)?;
    not_negative(&format!("{path}.damping"), land.damping)?;
    not_negative(&format!("{path}.friction"), land.friction)?;
    let Some(film) = &land.film else { return Ok(()) };
    let path = format!("{path}.film");
    positive(&format!("{path}.viscosity"), film.viscosity)?;
    positive(&format!("{path}.density"), film.density)?;
    let full = film.fill > 0.0 && film.fill <= 1.0;
    require(full, &format!("{path}.fill"), "must be greater than 0 and at most 1; leave film out of a dry land")?;
    let most = 0.25 * land.gap;
    let limits = format!("must be greater than 0 and at most a quarter of the gap, {} um", most * 1e6);
    require(film.roughness > 0.0 && film.roughness <= most, &format!("{path}.roughness"), limits)
}
