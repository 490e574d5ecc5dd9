//! Impossible values of the parts that a transient run needs.

use super::validate::{Verdict, curve, fraction, millimetres, not_negative, positive, require};
use super::validate_cage::{GAP_MAX, land_place};
use super::*;
use std::f64::consts::TAU;
use tribodyn_bearing::Scheme;

/// Longest step of a fixed-step scheme, s: ten times that of the paper, at which no contact is resolved any more.
const STEP_MAX: f64 = 1e-4;
/// Shortest one, s: ten thousand times shorter than friction on bare steel asks for. The adaptive scheme gives up
/// there too.
const STEP_MIN: f64 = 1e-12;
/// Most steps of a run: weeks of calculation, and the time still has four digits of a step.
const STEPS_MAX: f64 = 1e12;
/// Longest run, s.
const DURATION_MAX: f64 = 1e4;
/// Largest number of samples in one channel: a file of some tens of gigabytes.
const SAMPLES_MAX: f64 = 1e9;

pub(super) fn validate(case: &Case) -> Verdict {
    if let Some(spec) = &case.coatings {
        coatings(spec, case.traction.as_ref().map(|spec| spec.order))?;
    }
    if let Some(spec) = &case.supports {
        support("supports.inner", &spec.inner)?;
        support("supports.outer", &spec.outer)?;
        super::validate_tilt::validate(spec, case)?;
        for (i, stiffness) in spec.outer.stiffness.into_iter().enumerate() {
            let path = format!("supports.outer.stiffness[{i}]");
            require(stiffness > 0.0, &path, "must be greater than 0: nothing else holds the outer ring")?;
        }
    }
    for (i, defect) in case.defects.iter().enumerate() {
        self::defect(&format!("defects[{i}]"), defect, case)?;
    }
    for (i, spec) in case.spalls.iter().enumerate() {
        spall(&format!("spalls[{i}]"), spec, case.geometry.ball_diameter)?;
    }
    super::validate_ball_spalls::validate(case)?;
    if let Some(spec) = &case.cage {
        cage(spec, &case.geometry)?;
    }
    super::validate_cage::validate(case)?;
    if let Some(spec) = &case.transient {
        transient(spec)?;
    }
    if let Some(recording) = &case.recording {
        rates(recording, case.transient.as_ref().map_or(0.0, |spec| spec.duration))?;
    }
    Ok(())
}

fn coatings(spec: &Coatings, order: Option<usize>) -> Verdict {
    if let Some(bare) = &spec.bare {
        curve("coatings.bare", &bare.curve, order)?;
    }
    if let Some(transfer) = &spec.transfer {
        curve("coatings.transfer", &transfer.curve, order)?;
        fraction("coatings.transfer.loss", transfer.loss)?;
        positive("coatings.transfer.cover", transfer.cover)?;
        not_negative("coatings.transfer.wear.coefficient", transfer.wear.coefficient)?;
        positive("coatings.transfer.wear.hardness", transfer.wear.hardness)?;
    }
    for (name, coating) in [("inner", &spec.inner), ("outer", &spec.outer)] {
        let path = format!("coatings.{name}.worn");
        fraction(&path, coating.worn)?;
        require(
            coating.worn == 0.0 || spec.bare.is_some(),
            &path,
            "a worn coating needs the curve of what lies bare: add coatings.bare",
        )?;
    }
    Ok(())
}

fn support<const N: usize>(path: &str, spec: &SupportSpec<N>) -> Verdict {
    positive(&format!("{path}.mass"), spec.mass)?;
    for i in 0..N {
        not_negative(&format!("{path}.stiffness[{i}]"), spec.stiffness[i])?;
        not_negative(&format!("{path}.damping[{i}]"), spec.damping[i])?;
    }
    Ok(())
}

fn defect(path: &str, spec: &DefectSpec, case: &Case) -> Verdict {
    require(
        spec.width > 0.0 && spec.width < TAU,
        &format!("{path}.width"),
        "must be greater than 0° and less than 360°",
    )?;
    let most = case.geometry.ball_diameter / 100.0;
    require(
        (0.0..=most).contains(&spec.depth),
        &format!("{path}.depth"),
        format!("must lie between 0 and a hundredth of the ball diameter, {} um", most * 1e6),
    )?;
    fraction(&format!("{path}.bare"), spec.bare)?;
    require(
        spec.bare == 0.0 || case.coatings.as_ref().is_some_and(|coatings| coatings.bare.is_some()),
        &format!("{path}.bare"),
        "where the coating is gone the curve of what lies bare is needed: add coatings.bare",
    )
}

fn spall(path: &str, spec: &SpallSpec, ball: f64) -> Verdict {
    let within = |name: &str, value: f64, [least, most]: [f64; 2], of: &str| {
        let above = if least > 0.0 { "above" } else { "at least" };
        let message = format!("must be {above} 0 and at most {of}, {} mm", millimetres(most));
        require((least..=most).contains(&value), &format!("{path}.{name}"), message)
    };
    let above = f64::MIN_POSITIVE;
    within("length", spec.length, [above, 0.8 * ball], "0.8 ball diameters")?;
    within("width", spec.width, [above, 2.0 * ball], "two ball diameters")?;
    within("depth", spec.depth, [0.0, 0.1 * ball], "a tenth of the ball diameter")?;
    within("edge_radius", spec.edge_radius, [0.0, 0.02 * ball], "a fiftieth of the ball diameter")?;
    require(
        spec.across.abs() <= ball,
        &format!("{path}.across"),
        format!("must lie within one ball diameter, ±{} mm", millimetres(ball)),
    )
}

fn cage(spec: &CageSpec, geometry: &GeometrySpec) -> Verdict {
    if let Some(inertia) = spec.inertia {
        positive("cage.inertia", inertia)?;
    }
    not_negative("cage.pocket_damping", spec.pocket_damping)?;
    if let Some(land) = &spec.guidance {
        positive("cage.guidance.radius", land.radius)?;
        positive("cage.guidance.width", land.width)?;
        let most = GAP_MAX * land.radius;
        let of_radius = format!("a tenth of the land's radius, {} mm: a thin film", millimetres(most));
        let limits = format!("must be greater than 0 and at most {of_radius}");
        require(land.gap > 0.0 && land.gap <= most, "cage.guidance.gap", limits)?;
        land_place("cage.guidance.radius", (land.land, land.radius), geometry)?;
    }
    Ok(())
}

fn transient(spec: &TransientSpec) -> Verdict {
    let allowed = spec.duration > 0.0 && spec.duration <= DURATION_MAX;
    require(allowed, "transient.duration", format!("must be greater than 0 s and at most {DURATION_MAX} s"))?;
    let step = |path: &str, value: f64| {
        let path = format!("transient.scheme.{path}");
        let least = STEP_MIN.max(spec.duration / STEPS_MAX);
        let allowed = (least..=STEP_MAX).contains(&value);
        let why = if least > STEP_MIN { format!(", {STEPS_MAX:e} of which make the duration") } else { String::new() };
        require(allowed, &path, format!("must lie between {least:e} s{why} and {STEP_MAX:e} s"))
    };
    match spec.scheme {
        Scheme::RungeKutta4 { step: h } => step("RungeKutta4.step", h)?,
        Scheme::Fast { step: h } => step("Fast.step", h)?,
        Scheme::FastTo { accuracy } => {
            let allowed = (1e-6..=0.1).contains(&accuracy);
            require(allowed, "transient.scheme.FastTo.accuracy", "must lie between 1e-6 and 0.1 of loads and torque")?;
        }
        Scheme::DormandPrince { tolerance, longest } => {
            let allowed = (1e-13..=1e-2).contains(&tolerance);
            require(allowed, "transient.scheme.DormandPrince.tolerance", "must lie between 1e-13 and 0.01")?;
            step("DormandPrince.longest", longest)?;
        }
    }
    require(
        (0.0..=1.0).contains(&spec.contact_damping),
        "transient.contact_damping",
        "must lie between 0 and 1, critical damping",
    )?;
    not_negative("transient.wear_acceleration", spec.wear_acceleration)
}

fn rates(spec: &RecordingSpec, duration: f64) -> Verdict {
    for (name, rate) in [("state_rate", spec.state_rate), ("ball_rate", spec.ball_rate)] {
        let path = format!("recording.{name}");
        let allowed = rate > 0.0 && rate <= 1e6;
        require(allowed, &path, "must be greater than 0 Hz and at most 1 MHz")?;
        require(
            rate * duration <= SAMPLES_MAX,
            &path,
            format!("{} samples in {duration} s; allowed are {SAMPLES_MAX:e}", rate * duration),
        )?;
    }
    require(
        spec.ball_rate <= spec.state_rate,
        "recording.ball_rate",
        "must not exceed recording.state_rate: the balls are written with every so many states",
    )
}
