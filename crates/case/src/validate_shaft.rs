//! Impossible values of a shaft's file.

use crate::validate::{Refusal, Verdict, positive, require};
use crate::{BearingChoice, Carries, MaterialSpec, ShaftSystem};

/// Most sections, bearings, loads or discs, and most elements of a shaft.
const MOST: usize = 200;
/// Fastest shaft, rad/s.
const SPEED_MAX: f64 = 1e5;
/// Rounding that shares of time may have.
const SHARES: f64 = 1e-6;

pub(super) fn validate(system: &ShaftSystem) -> Verdict {
    let shaft = &system.shaft;
    require(system.speed.abs() <= SPEED_MAX, "speed", format!("must lie between -{SPEED_MAX} and {SPEED_MAX} rad/s"))?;
    material("shaft.material", &shaft.material)?;
    let lists = [
        ("shaft.sections", shaft.sections.len(), 1),
        ("bearings", system.bearings.len(), 1),
        ("loads", system.loads.len(), 0),
        ("discs", system.discs.len(), 0),
        ("spectrum", system.spectrum.len(), 0),
    ];
    for (path, count, least) in lists {
        require((least..=MOST).contains(&count), path, format!("{count} entries; allowed are {least} to {MOST}"))?;
    }
    for (k, section) in shaft.sections.iter().enumerate() {
        let path = format!("shaft.sections[{k}]");
        positive(&format!("{path}.length"), section.length)?;
        let inner = section.inner.unwrap_or(0.0);
        let ends = [
            ("outer", section.outer, inner),
            ("outer_end", section.outer_end.unwrap_or(section.outer), section.inner_end.unwrap_or(inner)),
        ];
        for (name, outer, inner) in ends {
            let message = "must be above the inner diameter, which is 0 or more";
            let allowed = outer.is_finite() && inner >= 0.0 && outer > inner;
            require(allowed, &format!("{path}.{name}"), message)?;
        }
        section.material.as_ref().map_or(Ok(()), |own| material(&format!("{path}.material"), own))?;
    }
    if let Some(longest) = shaft.longest_element {
        positive("shaft.longest_element", longest)?;
    }
    let length: f64 = shaft.sections.iter().map(|section| section.length).sum();
    stations(system, length)?;
    for (k, bearing) in system.bearings.iter().enumerate() {
        self::bearing(&format!("bearings[{k}]"), bearing)?;
    }
    for (k, disc) in system.discs.iter().enumerate() {
        positive(&format!("discs[{k}].mass"), disc.mass)?;
        for (name, value) in [("transverse_inertia", disc.transverse_inertia), ("polar_inertia", disc.polar_inertia)] {
            require(value >= 0.0 && value.is_finite(), &format!("discs[{k}].{name}"), "must be at least 0")?;
        }
    }
    duty(system)
}

/// Everything stands on the shaft.
fn stations(system: &ShaftSystem, length: f64) -> Verdict {
    let bearings = system.bearings.iter().enumerate().map(|(k, b)| (format!("bearings[{k}].at"), b.at));
    let discs = system.discs.iter().enumerate().map(|(k, d)| (format!("discs[{k}].at"), d.at));
    let loads = system.loads.iter().enumerate().map(|(k, load)| (format!("loads[{k}]"), load.at()));
    for (path, at) in bearings.chain(discs).chain(loads) {
        let millimetres = (length * 1e7).round() / 1e4;
        let message = format!("must stand on the shaft: `at` between 0 and {millimetres} mm");
        require((0.0..=length * (1.0 + 1e-9)).contains(&at), &path, message)?;
    }
    for (k, load) in system.loads.iter().enumerate() {
        if let crate::LoadSpec::Gear { pitch_diameter, pressure_angle, helix_angle, .. } = *load {
            let right = pitch_diameter > 0.0 && (0.0..1.5).contains(&pressure_angle) && helix_angle.abs() < 1.5;
            let message =
                "a gear has a pitch diameter above 0, a pressure angle from 0 to 85° and a helix angle within 85°";
            require(right, &format!("loads[{k}]"), message)?;
        }
    }
    Ok(())
}

fn bearing(path: &str, bearing: &crate::ShaftBearingSpec) -> Verdict {
    let (BearingChoice::Listed(name) | BearingChoice::Case(name)) = &bearing.bearing;
    require(!name.trim().is_empty(), &format!("{path}.bearing"), "must not be empty")?;
    if let Some(seat) = &bearing.housing {
        for (name, value) in [("radial", seat.radial), ("axial", seat.axial), ("tilt", seat.tilt)] {
            positive(&format!("{path}.housing.{name}"), value)?;
        }
        seat.mass.map_or(Ok(()), |mass| positive(&format!("{path}.housing.mass"), mass))?;
    }
    if let Some(damping) = bearing.damping {
        require(damping >= 0.0 && damping.is_finite(), &format!("{path}.damping"), "must be at least 0")?;
    }
    if let Some(crate::PreloadSpec::Force(force)) = bearing.preload {
        require(force >= 0.0 && force.is_finite(), &format!("{path}.preload.Force"), "must be at least 0 N")?;
    }
    let ways = [bearing.clearance.is_some(), bearing.mounting.is_some(), bearing.fits.is_some()];
    let message = "clearance in operation, mounting and fits say the same: give one of them";
    require(ways.into_iter().filter(|given| *given).count() <= 1, path, message)?;
    let both = bearing.carries == Carries::Both;
    let message = "a bearing that carries both directions is preloaded by a spring on an outer ring that slides";
    require(!(both && bearing.preload.is_some()), &format!("{path}.preload"), message)
}

fn duty(system: &ShaftSystem) -> Verdict {
    for (k, duty) in system.spectrum.iter().enumerate() {
        let path = format!("spectrum[{k}]");
        require((0.0..=1.0).contains(&duty.share), &format!("{path}.share"), "must lie between 0 and 1")?;
        require(duty.load.is_finite(), &format!("{path}.load"), "must be finite")?;
        let speed = duty.speed.is_none_or(|speed| speed.abs() <= SPEED_MAX);
        require(speed, &format!("{path}.speed"), format!("must lie between -{SPEED_MAX} and {SPEED_MAX} rad/s"))?;
    }
    let sum: f64 = system.spectrum.iter().map(|duty| duty.share).sum();
    if !system.spectrum.is_empty() && (sum - 1.0).abs() > SHARES {
        let message = format!("shares of time make {sum}; allowed is 1");
        return Err(Refusal { path: "spectrum".to_owned(), message });
    }
    Ok(())
}

fn material(path: &str, material: &MaterialSpec) -> Verdict {
    positive(&format!("{path}.young"), material.young)?;
    require((0.0..0.5).contains(&material.poisson), &format!("{path}.poisson"), "must be at least 0 and below 0.5")?;
    positive(&format!("{path}.density"), material.density)
}
