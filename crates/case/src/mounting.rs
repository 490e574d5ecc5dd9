//! From a case's fits and temperatures to the growth of its rings, and the limits of both.

use crate::validate::{Refusal, Verdict, positive, require};
use crate::{Case, FitSpec, GeometrySpec, Groove, MaterialSpec, MountedRingSpec, RatingSpec, SeatSpec, Shoulder};
use tribodyn_bearing::fits::{FitError, Within};
use tribodyn_bearing::{BearingError, Cylinder, Geometry, GrownBearing, Growth, MountedRing, Races, Seat, Side, Solid};
use tribodyn_contact::ElasticBody;

/// Largest interference over the diameter of the seat: rings yield far below it.
const INTERFERENCE_MAX: f64 = 0.01;
/// Roughest surfaces, m: turned roughly.
const ROUGHNESS_MAX: f64 = 200e-6;
/// Largest temperature difference, K.
const TEMPERATURE_MAX: f64 = 2000.0;
/// Largest coefficient of thermal expansion, 1/K: beyond polymers.
const EXPANSION_MAX: f64 = 1e-3;

/// Largest nominal contact angle of a radial bearing, degrees (ISO 281).
const CONTACT_ANGLE_MAX_DEG: f64 = 45.0;

/// A bearing on the drawing, mounted, and running.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growths {
    /// After mounting, at rest and at the temperature of the drawing.
    pub mounted: GrownBearing,
    /// At the speeds and temperatures of the case.
    pub running: GrownBearing,
}

impl GeometrySpec {
    /// Groove radii over ball diameter, inner and outer.
    pub fn coefficients(&self) -> [f64; 2] {
        [self.inner_groove, self.outer_groove].map(|groove| match groove {
            Groove::Coefficient(f) => f,
            Groove::Radius(radius) => radius / self.ball_diameter,
        })
    }

    /// Angle from the bottom of each groove to its edge, rad, of the bearing on the drawing; absent where the case
    /// does not give the shoulder.
    ///
    /// # Errors
    /// [`BearingError::Clearance`] for a radial clearance that no contact angle has.
    pub fn shoulder_angles(&self) -> Result<Races<Option<f64>>, BearingError> {
        let geometry = self.resolve()?;
        let of = |side: Side, shoulder: Option<Shoulder>| {
            let radius = geometry.coefficient(side) * geometry.ball_diameter;
            shoulder.map(|shoulder| (1.0 - shoulder.height(&geometry, side) / radius).clamp(-1.0, 1.0).acos())
        };
        Ok(Races { inner: of(Side::Inner, self.inner_shoulder), outer: of(Side::Outer, self.outer_shoulder) })
    }
}

impl Shoulder {
    /// Height over the bottom of the groove, m.
    fn height(self, geometry: &Geometry, side: Side) -> f64 {
        match self {
            Self::Height(height) => height,
            Self::Diameter(diameter) => (0.5 * diameter - geometry.groove_bottom_radius(side)) * outwards(side),
        }
    }
}

/// 1 where shoulders are larger than the bottom of the groove, −1 where they are smaller.
fn outwards(side: Side) -> f64 {
    match side {
        Side::Inner => 1.0,
        Side::Outer => -1.0,
    }
}

impl Case {
    /// The bearing mounted and running; absent for a case without `mounting`.
    ///
    /// # Errors
    /// [`BearingError::Clearance`] where growth leaves no bearing.
    pub fn growths(&self) -> Result<Option<Growths>, BearingError> {
        let drawn = self.geometry.resolve()?;
        let Some(growth) = self.growth(&drawn) else { return Ok(None) };
        Ok(Some(Growths { mounted: growth.mounted().apply(&drawn)?, running: growth.apply(&drawn)? }))
    }

    /// The same case with seats at another place within their tolerance classes.
    pub fn with_fits(&self, within: Within) -> Self {
        Self { mounting: self.mounting.map(|mounting| mounting.within(within)), ..self.clone() }
    }

    /// The geometry that the solvers work with: that of the running bearing.
    ///
    /// # Errors
    /// [`BearingError::Clearance`] for a clearance that no contact angle has, drawn or grown.
    pub fn running_geometry(&self) -> Result<Geometry, BearingError> {
        let drawn = self.geometry.resolve()?;
        self.growth(&drawn).map_or(Ok(drawn), |growth| growth.apply(&drawn).map(|grown| grown.geometry))
    }

    /// Checks a mounting that the case got from elsewhere, as a file's own is checked.
    ///
    /// # Errors
    /// Path of the value, such as `mounting.inner.seat.fit.class`, and what is wrong with it.
    pub fn check_mounting(&self) -> Result<(), (String, String)> {
        validate(self).map_err(|Refusal { path, message }| (path, message))
    }

    fn growth(&self, drawn: &Geometry) -> Option<Growth> {
        let mounting = self.mounting.as_ref()?;
        let point = self.operating_point();
        let inner = mounted_ring(&mounting.inner, &self.materials.inner, point.inner_speed, drawn, Side::Inner);
        let outer = mounted_ring(&mounting.outer, &self.materials.outer, point.outer_speed, drawn, Side::Outer);
        let ball_strain = mounting.ball.expansion * mounting.ball.temperature_rise;
        Some(Growth { rings: Races { inner, outer }, ball_strain })
    }
}

fn mounted_ring(
    spec: &MountedRingSpec,
    material: &MaterialSpec,
    speed: f64,
    drawn: &Geometry,
    side: Side,
) -> MountedRing {
    let seat_radius = 0.5 * spec.seat_diameter;
    let cylinder = |solid: Solid, a: f64, b: f64, temperature_rise: f64| Cylinder {
        solid,
        inner_radius: a.min(b),
        outer_radius: a.max(b),
        speed,
        temperature_rise,
    };
    let ring = solid(material, spec.expansion);
    let seat = spec.seat.map(|seat| Seat {
        interference: seat.effective_interference(spec.seat_diameter),
        // A shaft turns with its ring, and so does a housing that turns.
        partner: cylinder(
            solid(&seat.material, seat.expansion),
            seat_radius,
            0.5 * seat.far_diameter,
            seat.temperature_rise,
        ),
    });
    MountedRing { ring: cylinder(ring, seat_radius, drawn.groove_bottom_radius(side), spec.temperature_rise), seat }
}

fn solid(material: &MaterialSpec, expansion: f64) -> Solid {
    let MaterialSpec { young, poisson, density } = *material;
    Solid { elastic: ElasticBody { young, poisson }, density, expansion }
}

/// Checks fits, temperatures, shoulders and ratings.
pub(super) fn validate(case: &Case) -> Verdict {
    // Geometry is checked before.
    let Ok(drawn) = case.geometry.resolve() else { return Ok(()) };
    for (side, name, shoulder) in
        [(Side::Inner, "inner", case.geometry.inner_shoulder), (Side::Outer, "outer", case.geometry.outer_shoulder)]
    {
        if let Some(shoulder) = shoulder {
            edge(&format!("geometry.{name}_shoulder"), shoulder, &drawn, side)?;
        }
    }
    if let Some(spec) = &case.rating {
        rating(spec, case.lubricant.is_some())?;
    }
    let Some(mounting) = &case.mounting else { return Ok(()) };
    heat("mounting.ball", mounting.ball.expansion, mounting.ball.temperature_rise)?;
    for (side, name, ring) in [(Side::Inner, "inner", &mounting.inner), (Side::Outer, "outer", &mounting.outer)] {
        let path = format!("mounting.{name}");
        heat(&path, ring.expansion, ring.temperature_rise)?;
        let bottom = 2.0 * drawn.groove_bottom_radius(side);
        let within = ring.seat_diameter > 0.0 && (bottom - ring.seat_diameter) * outwards(side) > 0.0;
        let rule = if side == Side::Inner { "greater than 0 and below" } else { "greater than" };
        let message = format!("must be {rule} the diameter of the groove's bottom, {} mm", millimetres(bottom));
        require(within && ring.seat_diameter.is_finite(), &format!("{path}.seat_diameter"), message)?;
        if let Some(seat) = &ring.seat {
            seat_of(&format!("{path}.seat"), seat, ring.seat_diameter, side)?;
        }
    }
    case.running_geometry().map(drop).map_err(|error| Refusal { path: "mounting".into(), message: error.to_string() })
}

fn edge(path: &str, shoulder: Shoulder, drawn: &Geometry, side: Side) -> Verdict {
    let radius = drawn.coefficient(side) * drawn.ball_diameter;
    let height = shoulder.height(drawn, side);
    let (variant, least, most) = match shoulder {
        Shoulder::Height(_) => ("Height", 0.0, radius),
        Shoulder::Diameter(_) => {
            let bottom = 2.0 * drawn.groove_bottom_radius(side);
            let far = bottom + 2.0 * radius * outwards(side);
            ("Diameter", bottom.min(far), bottom.max(far))
        }
    };
    let message = format!("must lie between {} and {} mm, within the groove", millimetres(least), millimetres(most));
    require(height > 0.0 && height <= radius, &format!("{path}.{variant}"), message)
}

fn heat(path: &str, expansion: f64, temperature_rise: f64) -> Verdict {
    let message = format!("must lie between 0 and {EXPANSION_MAX} per K");
    require((0.0..=EXPANSION_MAX).contains(&expansion), &format!("{path}.expansion"), message)?;
    let message = format!("must lie between -{TEMPERATURE_MAX} and {TEMPERATURE_MAX} K");
    require(temperature_rise.abs() <= TEMPERATURE_MAX, &format!("{path}.temperature_rise"), message)
}

fn seat_of(path: &str, seat: &SeatSpec, diameter: f64, side: Side) -> Verdict {
    heat(path, seat.expansion, seat.temperature_rise)?;
    positive(&format!("{path}.material.young"), seat.material.young)?;
    let poisson = (0.0..0.5).contains(&seat.material.poisson);
    require(poisson, &format!("{path}.material.poisson"), "must be at least 0 and below 0.5")?;
    positive(&format!("{path}.material.density"), seat.material.density)?;
    let once = "an interference, or a fit by its class: give one of them";
    require(seat.interference.is_some() != seat.fit.is_some(), path, once)?;
    let most = INTERFERENCE_MAX * diameter;
    let message = format!("must lie between -{0} and {0} mm, a hundredth of the seat", millimetres(most));
    let allowed = seat.interference.is_none_or(|interference| interference.abs() <= most);
    require(allowed, &format!("{path}.interference"), message)?;
    if let Some(fit) = &seat.fit {
        classes(&format!("{path}.fit"), fit, diameter, side)?;
    }
    let (allowed, rule) = match side {
        Side::Inner => ((0.0..diameter).contains(&seat.far_diameter), "at least 0, a solid shaft, and below"),
        Side::Outer => (seat.far_diameter > diameter && seat.far_diameter.is_finite(), "greater than"),
    };
    let message = format!("must be {rule} the diameter of the seat, {} mm", millimetres(diameter));
    require(allowed, &format!("{path}.far_diameter"), message)
}

fn classes(path: &str, fit: &FitSpec, diameter: f64, side: Side) -> Verdict {
    let refused = |error: FitError| Refusal { path: format!("{path}.class"), message: error.to_string() };
    fit.class.of_ring(side).map_err(refused)?;
    let rough = (0.0..=ROUGHNESS_MAX).contains(&fit.roughness);
    let message = format!("must lie between 0 and {} mm: R_z of both surfaces together", millimetres(ROUGHNESS_MAX));
    require(rough, &format!("{path}.roughness"), message)?;
    fit.interference(diameter).map(drop).map_err(refused)
}

fn rating(spec: &RatingSpec, lubricated: bool) -> Verdict {
    let given = [("dynamic", spec.dynamic), ("static_load", spec.static_load), ("fatigue_limit", spec.fatigue_limit)];
    for (name, value) in given {
        value.map_or(Ok(()), |value| positive(&format!("rating.{name}"), value))?;
    }
    let largest = CONTACT_ANGLE_MAX_DEG;
    let message = format!("the nominal contact angle of a radial bearing must lie between 0° and {largest}°");
    // Half a millionth of a degree for the rounding of the unit.
    let radial = |angle: f64| (0.0..=largest + 5e-7).contains(&angle.to_degrees());
    require(spec.contact_angle.is_none_or(radial), "rating.contact_angle", message)?;
    let kappa = spec.viscosity_ratio.is_none_or(|kappa| kappa >= 0.1 && kappa.is_finite());
    require(kappa, "rating.viscosity_ratio", "must be at least 0.1, where ISO 281 begins")?;
    let clean = spec.contamination.is_none_or(|factor| (0.0..=1.0).contains(&factor));
    require(clean, "rating.contamination", "must lie between 0 and 1")?;
    let clean = spec.contamination.is_some() || spec.cleanliness.is_some();
    let once = spec.contamination.is_none() || spec.cleanliness.is_none();
    require(once, "rating", "contamination and cleanliness say the same: give one of them")?;
    let both = spec.viscosity_ratio.is_none() || clean;
    require(both, "rating", "viscosity_ratio and contamination (or cleanliness) belong together: give both or none")?;
    let alone = spec.viscosity_ratio.is_some() || lubricated || !clean;
    require(alone, "rating", "contamination and viscosity_ratio (or a lubricant) belong together: give both or none")?;
    for (name, value) in [("bore", spec.bore), ("outside", spec.outside)] {
        value.map_or(Ok(()), |value| positive(&format!("rating.{name}"), value))?;
    }
    let share = spec.reliability.is_none_or(|percent| (90.0..=99.95).contains(&percent));
    require(share, "rating.reliability", "must lie between 90 and 99.95 percent")
}

/// A length in m as millimetres with the digits a drawing has.
fn millimetres(metres: f64) -> f64 {
    (metres * 1e7).round() / 1e4
}
