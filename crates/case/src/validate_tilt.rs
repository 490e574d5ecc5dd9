//! Impossible values of rings that are free to tilt.

use super::validate::{Verdict, not_negative, positive, require};
use super::*;
use tribodyn_bearing::{RingCentre, Tilt};

/// Largest tilt of a seat, rad: a ring that is tilted further has left its balls.
const ASKEW_MAX: f64 = 0.05;

pub(super) fn validate(supports: &SupportsSpec, case: &Case) -> Verdict {
    if let Some(tilt) = &supports.tilt {
        body("supports.tilt", tilt)?;
        let tilts = [("ring.tilt_x", &case.ring.tilt_x), ("ring.tilt_y", &case.ring.tilt_y)];
        for ((name, start), stiffness) in tilts.into_iter().zip(tilt.stiffness) {
            let free = !matches!(start, Tilt::Held(_)) || stiffness > 0.0;
            let message = "is held where supports.tilt has no stiffness: give a Moment, or springs that hold the ring";
            require(free, name, message)?;
        }
        around(case)?;
    }
    if let Some(tilt) = &supports.outer_tilt {
        body("supports.outer_tilt", tilt)?;
        for (k, stiffness) in tilt.stiffness.into_iter().enumerate() {
            let path = format!("supports.outer_tilt.stiffness[{k}]");
            require(stiffness > 0.0, &path, "must be greater than 0: nothing else holds the outer ring")?;
        }
        around(case)?;
    }
    Ok(())
}

fn body(path: &str, spec: &TiltSpec) -> Verdict {
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
        let limits = format!("must lie between -{0} and {0} mrad", ASKEW_MAX * 1e3);
        require(spec.askew[k].abs() <= ASKEW_MAX, &format!("{path}.askew[{k}]"), limits)?;
    }
    let held = spec.askew == [0.0; 2] || spec.stiffness.iter().all(|&stiffness| stiffness > 0.0);
    require(
        held,
        &format!("{path}.stiffness"),
        "must be greater than 0 about both axes: a seat that stands askew holds the ring",
    )
}

/// Choices that a ring which tilts does not allow.
fn around(case: &Case) -> Verdict {
    let displaced = case.modelling.ring_centre != Some(RingCentre::Inertial);
    require(displaced, "modelling.ring_centre", "must be Displaced: a ring that tilts turns about its own axis")
}
