//! Impossible values of an inner ring that is free to tilt.

use super::validate::{Verdict, not_negative, positive, require};
use super::*;
use tribodyn_bearing::{RingCentre, Side, Tilt};

pub(super) fn tilt(spec: &TiltSpec, case: &Case) -> Verdict {
    let path = "supports.tilt";
    match spec.inertia {
        RingInertia::Given { polar, transverse } => {
            let path = format!("{path}.inertia.Given");
            positive(&format!("{path}.polar"), polar)?;
            positive(&format!("{path}.transverse"), transverse)?;
            let limits = format!("must be at least half of the polar one, {polar:e} kg m²: no body has less");
            require(2.0 * transverse >= polar, &format!("{path}.transverse"), limits)?;
        }
        RingInertia::Cylinder { bore, outside, width } => {
            let path = format!("{path}.inertia.Cylinder");
            not_negative(&format!("{path}.bore"), bore)?;
            let limits = format!("must be greater than the bore, {} mm", bore * 1e3);
            require(outside > bore, &format!("{path}.outside"), limits)?;
            positive(&format!("{path}.width"), width)?;
        }
    }
    for k in 0..2 {
        not_negative(&format!("{path}.stiffness[{k}]"), spec.stiffness[k])?;
        not_negative(&format!("{path}.damping[{k}]"), spec.damping[k])?;
    }
    for (name, tilt) in [("ring.tilt_x", &case.ring.tilt_x), ("ring.tilt_y", &case.ring.tilt_y)] {
        let loaded = !matches!(tilt, Tilt::Held(_));
        require(loaded, name, "is held: with supports.tilt the ring is free to tilt, under Moment(Nm(0)) or more")?;
    }
    let displaced = case.modelling.ring_centre != Some(RingCentre::Inertial);
    require(displaced, "modelling.ring_centre", "must be Displaced: a ring that tilts turns about its own axis")?;
    let lands = case.cage.iter().filter_map(|cage| cage.free.as_ref()).flat_map(|free| &free.lands);
    let inner = lands.filter(|land| land.land == Side::Inner).count();
    require(inner == 0, "cage.free.lands", "must be those of the outer ring alone where the inner one tilts")
}
