//! Impossible values, which no calculation could make sense of.
//!
//! Limits are physical where there is one (a ball must fit its groove) and otherwise wide enough for any bearing, so
//! that what they refuse is a slip of the pen.

use super::*;
use std::f64::consts::PI;
use tribodyn_bearing::{Geometry, Modelling, PatchSurfaces, SpeedHistory, Tilt, Translation};
use tribodyn_fluid::Fluid;
use tribodyn_traction::{Coating, PatchChoice, PatchRule, SlipUnit, coating_names};

/// A value that is refused, and why.
pub(super) struct Refusal {
    /// Path of the value.
    pub path: String,
    /// The fault and what is allowed.
    pub message: String,
}

pub(super) type Verdict = Result<(), Refusal>;

/// Groove radius over ball diameter: conformity ends at ½; a groove above 0.7 no longer guides a ball.
const GROOVE_COEFFICIENT_MAX: f64 = 0.7;
/// Largest free contact angle, degrees: beyond it a bearing is a thrust bearing, whose races this geometry does not
/// have.
const CONTACT_ANGLE_MAX_DEG: f64 = 60.0;
/// Fastest ring, rad/s: about 955 000 r/min.
pub const SPEED_MAX: f64 = 1e5;
/// Most nodes of a quadrature rule along one direction; the reference rule of the traction crate has 40 × 61.
const NODES_MAX: usize = 1000;
/// Open limits of the target error of the patch rule: below is rounding, above is no traction force to speak of.
const TARGET_ERROR: (f64, f64) = (1e-12, 0.1);
/// Largest tolerance of the solver.
const TOLERANCE_MAX: f64 = 1e-3;

/// Checks everything but the sources, section by section.
pub(super) fn validate(case: &Case) -> Verdict {
    geometry(&case.geometry)?;
    let Materials { ball, inner, outer } = &case.materials;
    for (name, body) in [("ball", ball), ("inner", inner), ("outer", outer)] {
        material(&format!("materials.{name}"), body)?;
    }
    if let Some(spec) = &case.traction {
        traction(spec)?;
    }
    let order = case.traction.as_ref().map(|spec| spec.order);
    if let Some(coatings) = &case.coatings {
        for (name, spec) in [("inner", &coatings.inner), ("outer", &coatings.outer)] {
            coating(&format!("coatings.{name}"), spec, order)?;
        }
    }
    if let Some(spec) = &case.fluid {
        fluid(spec)?;
    }
    if let Some(spec) = &case.cage {
        cage(spec)?;
    }
    if let Some(spec) = &case.wear {
        wear(spec)?;
    }
    ring(&case.ring)?;
    for (name, history) in [("inner", &case.speed.inner), ("outer", &case.speed.outer)] {
        speed(&format!("speed.{name}"), history)?;
    }
    super::validate_transient::validate(case)?;
    super::mounting::validate(case)?;
    super::lubricant::validate(case)?;
    super::deviations::validate(case)?;
    modelling(&case.modelling)?;
    numerics(&case.numerics)?;
    super::validate_bounds::validate(case)
}

pub(super) fn require(allowed: bool, path: &str, message: impl Into<String>) -> Verdict {
    if allowed { Ok(()) } else { Err(Refusal { path: path.to_owned(), message: message.into() }) }
}

pub(super) fn positive(path: &str, value: f64) -> Verdict {
    require(value.is_finite() && value > 0.0, path, "must be greater than 0 and finite")
}

pub(super) fn not_negative(path: &str, value: f64) -> Verdict {
    require(value.is_finite() && value >= 0.0, path, "must be at least 0 and finite")
}

pub(super) fn fraction(path: &str, value: f64) -> Verdict {
    require((0.0..=1.0).contains(&value), path, "must lie between 0 and 1")
}

fn geometry(spec: &GeometrySpec) -> Verdict {
    let (ball, pitch) = (spec.ball_diameter, spec.pitch_diameter);
    require(spec.ball_count >= 2, "geometry.ball_count", "a bearing has at least 2 balls")?;
    positive("geometry.ball_diameter", ball)?;
    require(
        pitch.is_finite() && pitch > ball,
        "geometry.pitch_diameter",
        format!("must be greater than the ball diameter, {} mm", millimetres(ball)),
    )?;
    // Neighbouring balls touch where the chord of their spacing is the ball diameter.
    let chord = (PI / spec.ball_count as f64).sin() * pitch;
    require(
        chord > ball,
        "geometry.ball_count",
        format!(
            "too many balls: sin(π/{}) × pitch diameter = {} mm must exceed the ball diameter, {} mm; at most {} fit",
            spec.ball_count,
            millimetres(chord),
            millimetres(ball),
            (PI / (ball / pitch).asin()).ceil() - 1.0,
        ),
    )?;
    let inner = groove("geometry.inner_groove", spec.inner_groove, ball)?;
    let outer = groove("geometry.outer_groove", spec.outer_groove, ball)?;
    fit(spec.fit, (inner + outer - 1.0) * ball)
}

/// The groove radius over the ball diameter.
fn groove(path: &str, spec: Groove, ball: f64) -> Result<f64, Refusal> {
    let allowed = |f: f64| f > 0.5 && f <= GROOVE_COEFFICIENT_MAX;
    let (coefficient, path, limits) = match spec {
        Groove::Coefficient(f) => {
            let limits =
                format!("must be above 0.5, a groove as small as the ball, and at most {GROOVE_COEFFICIENT_MAX}");
            (f, format!("{path}.Coefficient"), limits)
        }
        Groove::Radius(radius) => {
            let limits = format!(
                "must be greater than the ball radius, {} mm, and at most {} mm",
                millimetres(0.5 * ball),
                millimetres(GROOVE_COEFFICIENT_MAX * ball)
            );
            (radius / ball, format!("{path}.Radius"), limits)
        }
    };
    require(allowed(coefficient), &path, limits).map(|()| coefficient)
}

/// Free contact angle, or the clearance that gives it with the groove centres `distance` apart, m.
fn fit(spec: Fit, distance: f64) -> Verdict {
    let largest = CONTACT_ANGLE_MAX_DEG.to_radians();
    match spec {
        Fit::ContactAngle(angle) => require(
            (0.0..=largest).contains(&angle),
            "geometry.fit.ContactAngle",
            format!("the free contact angle must lie between 0° and {CONTACT_ANGLE_MAX_DEG}°"),
        ),
        Fit::RadialClearance(clearance) => {
            let most = 2.0 * distance * (1.0 - largest.cos());
            let least = -Geometry::INTERFERENCE_MAX * distance;
            require(
                (least..=most).contains(&clearance),
                "geometry.fit.RadialClearance",
                format!(
                    "must lie between {} mm, an interference of a tenth of the distance of the groove centres, and {} mm, where the free contact angle is {CONTACT_ANGLE_MAX_DEG}° with these grooves",
                    millimetres(least),
                    millimetres(most)
                ),
            )
        }
    }
}

/// A length in m as millimetres with the digits a drawing has.
pub(super) fn millimetres(metres: f64) -> f64 {
    (metres * 1e7).round() / 1e4
}

fn material(path: &str, spec: &MaterialSpec) -> Verdict {
    positive(&format!("{path}.young"), spec.young)?;
    require((0.0..0.5).contains(&spec.poisson), &format!("{path}.poisson"), "must be at least 0 and below 0.5")?;
    positive(&format!("{path}.density"), spec.density)
}

fn coating(path: &str, spec: &CoatingSpec, order: Option<usize>) -> Verdict {
    curve(path, &spec.curve, order)?;
    not_negative(&format!("{path}.thickness"), spec.thickness)
}

/// The curve of a coating or of bare steel, with tests enough for polynomials of an order.
pub(super) fn curve(path: &str, spec: &CurveSpec, order: Option<usize>) -> Verdict {
    let tests = match spec {
        CurveSpec::Library(name) => {
            let known = || format!("no coating of this name in the library; allowed: {}", coating_names().join(", "));
            let found = Coating::library(name).ok();
            require(found.is_some(), &format!("{path}.curve.Library"), known())?;
            found.map_or(0, |coating| coating.tested.len())
        }
        CurveSpec::Tested(points) => {
            tested(&format!("{path}.curve.Tested"), points)?;
            points.len()
        }
    };
    let order = order.unwrap_or_default();
    // An order that needs more tests than there are, written so that it cannot overflow.
    require(
        order < tests,
        "traction.order",
        format!(
            "a polynomial of order {order} needs one tested pressure more than that, but {path} has {tests}; lower the order or add tests"
        ),
    )
}

fn tested(path: &str, points: &[TestedPoint]) -> Verdict {
    require(!points.is_empty(), path, "at least one tested point is needed")?;
    for (i, point) in points.iter().enumerate() {
        let path = format!("{path}[{i}]");
        positive(&format!("{path}.pressure"), point.pressure)?;
        let rises = i == 0 || point.pressure > points[i - 1].pressure;
        require(rises, &format!("{path}.pressure"), "tested pressures must rise from point to point")?;
        positive(&format!("{path}.peak_slip"), point.peak_slip)?;
        positive(&format!("{path}.residual_coefficient"), point.residual_coefficient)?;
        require(
            point.peak_coefficient.is_finite() && point.peak_coefficient > point.residual_coefficient,
            &format!("{path}.peak_coefficient"),
            format!("must be greater than the residual coefficient, {}", point.residual_coefficient),
        )?;
    }
    Ok(())
}

fn traction(spec: &TractionSpec) -> Verdict {
    if let SlipUnit::Scaled { per_m_s } = spec.slip_unit {
        positive("traction.slip_unit.Scaled.per_m_s", per_m_s)?;
    }
    positive("traction.reference_pressure", spec.reference_pressure)?;
    patch_rule("traction.patch", spec.patch)
}

/// The rule of the contact patches.
pub(super) fn patch_rule(path: &str, patch: PatchChoice) -> Verdict {
    let counts = match patch {
        PatchChoice::Named(PatchRule::PolarMidpoint { radial, circumferential }) => {
            [("PolarMidpoint.radial", radial), ("PolarMidpoint.circumferential", circumferential)]
        }
        PatchChoice::Named(PatchRule::GaussJacobi { radial, angles }) => {
            [("GaussJacobi.radial", radial), ("GaussJacobi.angles", angles)]
        }
        PatchChoice::Named(PatchRule::SplitStrip { across, along }) => {
            [("SplitStrip.across", across), ("SplitStrip.along", along)]
        }
        PatchChoice::TargetError { relative } => {
            let (low, high) = TARGET_ERROR;
            let allowed = relative > low && relative < high;
            let message = format!("must lie between {low:e} and {high}, limits excluded");
            return require(allowed, &format!("{path}.TargetError.relative"), message);
        }
    };
    for (name, count) in counts {
        let allowed = (1..=NODES_MAX).contains(&count);
        require(allowed, &format!("{path}.{name}"), format!("must lie between 1 and {NODES_MAX}"))?;
    }
    Ok(())
}

fn fluid(spec: &FluidSpec) -> Verdict {
    medium(spec.medium)?;
    fraction("fluid.liquid_fraction", spec.liquid_fraction)?;
    positive("fluid.gas_density", spec.gas_density)?;
    not_negative("fluid.drag_coefficient", spec.drag_coefficient)?;
    fraction("fluid.swirl", spec.swirl)?;
    fraction("fluid.shaded_fraction", spec.shaded_fraction)
}

fn medium(spec: Medium) -> Verdict {
    let (fluid, temperature, pressure) = match spec {
        Medium::Nitrogen { temperature, pressure } => (Fluid::Nitrogen, temperature, pressure),
        Medium::Oxygen { temperature, pressure } => (Fluid::Oxygen, temperature, pressure),
        Medium::Methane { temperature, pressure } => (Fluid::Methane, temperature, pressure),
        Medium::Custom { density, viscosity } => {
            positive("fluid.medium.Custom.density", density)?;
            return positive("fluid.medium.Custom.viscosity", viscosity);
        }
    };
    let state = fluid.state(temperature, pressure);
    state.map(drop).map_err(|error| Refusal { path: "fluid.medium".into(), message: error.to_string() })
}

fn wear(spec: &WearSpec) -> Verdict {
    for (name, spec) in [("inner", &spec.inner), ("outer", &spec.outer), ("cage", &spec.cage)] {
        not_negative(&format!("wear.{name}.coefficient"), spec.coefficient)?;
        positive(&format!("wear.{name}.hardness"), spec.hardness)?;
    }
    Ok(())
}

fn cage(spec: &CageSpec) -> Verdict {
    not_negative("cage.pocket_gap", spec.pocket_gap)?;
    not_negative("cage.pocket_stiffness", spec.pocket_stiffness)?;
    not_negative("cage.pocket_friction", spec.pocket_friction)
}

fn ring(spec: &RingSpec) -> Verdict {
    for (name, translation) in [("x", &spec.x), ("y", &spec.y), ("z", &spec.z)] {
        if let Translation::ForceTable(rows) = translation {
            table(&format!("ring.{name}.ForceTable"), rows)?;
        }
    }
    for (name, tilt) in [("tilt_x", &spec.tilt_x), ("tilt_y", &spec.tilt_y)] {
        if let Tilt::MomentTable(rows) = tilt {
            table(&format!("ring.{name}.MomentTable"), rows)?;
        }
    }
    Ok(())
}

fn speed(path: &str, history: &SpeedHistory) -> Verdict {
    let allowed = |path: &str, value: f64| {
        let message = format!("must lie between -{SPEED_MAX:e} and {SPEED_MAX:e} rad/s");
        require(value.abs() <= SPEED_MAX, path, message)
    };
    match history {
        SpeedHistory::Constant(value) => allowed(&format!("{path}.Constant"), *value),
        SpeedHistory::Table(rows) => {
            table(&format!("{path}.Table"), rows)?;
            let mut rows = rows.iter().enumerate();
            rows.try_for_each(|(i, row)| allowed(&format!("{path}.Table[{i}][1]"), row.1))
        }
    }
}

fn table(path: &str, rows: &[(f64, f64)]) -> Verdict {
    require(!rows.is_empty(), path, "a table needs at least one row")?;
    for (i, pair) in rows.windows(2).enumerate() {
        let message = format!("times must rise from row to row; the row before is at {} s", pair[0].0);
        require(pair[1].0 > pair[0].0, &format!("{path}[{}][0]", i + 1), message)?;
    }
    Ok(())
}

/// Fewer cells than these resolve no adhesion, more than these no processor wants.
fn modelling(choices: &Modelling) -> Verdict {
    let Some(PatchSurfaces::Elastic { strips, cells }) = choices.patch else { return Ok(()) };
    require((1..=64).contains(&strips), "modelling.patch.Elastic.strips", "must be a whole number between 1 and 64")?;
    require((2..=512).contains(&cells), "modelling.patch.Elastic.cells", "must be a whole number between 2 and 512")
}

fn numerics(spec: &Numerics) -> Verdict {
    let tolerance = spec.tolerance > 0.0 && spec.tolerance <= TOLERANCE_MAX;
    require(tolerance, "numerics.tolerance", format!("must be greater than 0 and at most {TOLERANCE_MAX}"))?;
    require(spec.max_iterations >= 1, "numerics.max_iterations", "must be at least 1")
}
