//! The traction law of a race, chosen at run time.

use crate::kragelskii::scan_for_fall;
use crate::{
    CoatingLaw, Conditions, CustomLaw, Fall, FastPatch, FilmLaw, Kragelskii, MovingPatch, OwnLaw, Patch,
    PatchDerivative, PatchTraction, Scalar, SlipCurve, SlipUnit, TractionLaw,
};
use std::sync::Arc;

/// The traction law of a race.
#[derive(Debug, Clone)]
pub enum Law {
    /// Kragelskii's curve of a coating with parameters that vary with pressure, by the vector kernel.
    Coating(Arc<CoatingLaw>),
    /// A lubricant film, by an integral of its own.
    Film(Arc<FilmLaw>),
    /// A law of one's own, by the vector kernel compiled for it.
    Own(OwnLaw),
}

impl Law {
    /// A law of one's own.
    pub fn custom(law: impl CustomLaw) -> Self {
        Self::Own(OwnLaw::new(law))
    }
}

impl From<FilmLaw> for Law {
    fn from(law: FilmLaw) -> Self {
        Self::Film(Arc::new(law))
    }
}

impl From<CoatingLaw> for Law {
    fn from(law: CoatingLaw) -> Self {
        Self::Coating(Arc::new(law))
    }
}

/// Slip over which the friction of asperities without a film rises, m/s.
const DRY_SLIP: f64 = 1e-3;

/// A contact of which nothing but a pressure is known, at rest.
fn at_rest<D: Scalar>(pressure: D) -> Conditions<D> {
    let unknown = D::zero();
    let patch = Patch {
        semi_lateral: unknown,
        semi_rolling: unknown,
        peak_pressure: pressure,
        ball_radius: 0.0,
        surface_radius: f64::INFINITY,
    };
    Conditions { pressure, entrainment_speed: unknown, patch }
}

/// A [`Law`] at one pressure.
#[derive(Debug, Clone)]
pub enum LawCurve<D> {
    /// Kragelskii's curve.
    Kragelskii(Kragelskii<D>),
    /// A law of one's own under conditions.
    Own(OwnLaw, Conditions<D>),
}

impl<D: Scalar> SlipCurve<D> for LawCurve<D> {
    fn over_slip(&self, slip: D) -> D {
        match self {
            Self::Kragelskii(curve) => curve.over_slip(slip),
            Self::Own(law, conditions) => {
                let Conditions { pressure, entrainment_speed, .. } = conditions;
                let at = law.over_slip(slip.re(), &conditions.map(|value| value.re()));
                // The differences have no value, only derivatives. At rest the slip has none.
                let change = |value: D, slope: f64| (value - value.re()) * slope;
                let by_slip = if slip.re() > 0.0 { (at.slope - at.value) / slip.re() } else { 0.0 };
                let by_entrainment = at.by_entrainment.unwrap_or(0.0);
                let of_contact = change(*pressure, at.by_pressure) + change(*entrainment_speed, by_entrainment);
                change(slip, by_slip) + of_contact + at.value
            }
        }
    }

    fn fall(&self) -> Option<Fall<D>> {
        match self {
            Self::Kragelskii(curve) => curve.fall(),
            Self::Own(..) => scan_for_fall(|slip| self.coefficient(D::from(slip)).re()),
        }
    }
}

impl TractionLaw for Law {
    type Curve<D: Scalar> = LawCurve<D>;

    fn at<D: Scalar>(&self, pressure: D) -> LawCurve<D> {
        self.under(&at_rest(pressure))
    }

    fn under<D: Scalar>(&self, conditions: &Conditions<D>) -> LawCurve<D> {
        match self {
            Self::Coating(law) => LawCurve::Kragelskii(law.at(conditions.pressure)),
            Self::Own(law) => LawCurve::Own(law.clone(), *conditions),
            // Without its film it is the friction of asperities, μ_b [1 − exp(−|Δv|/v_0)].
            Self::Film(law) => LawCurve::Kragelskii(Kragelskii {
                a: D::from(-law.boundary_friction),
                b: D::zero(),
                c: D::from(1.0 / DRY_SLIP),
            }),
        }
    }

    fn film(&self) -> Option<&FilmLaw> {
        if let Self::Film(law) = self { Some(law) } else { None }
    }

    fn fast_traction(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> Option<PatchTraction> {
        match self {
            Self::Coating(law) => law.fast_traction(contact, unit, fast),
            Self::Film(law) => Some(law.fast_value(contact, fast)),
            Self::Own(law) => Some(law.traction(contact, unit, fast)),
        }
    }

    fn fast_derivative(&self, contact: &MovingPatch, unit: SlipUnit, fast: &FastPatch) -> Option<PatchDerivative> {
        match self {
            Self::Coating(law) => law.fast_derivative(contact, unit, fast),
            Self::Film(law) => Some(law.derivative(contact, fast)),
            Self::Own(law) => Some(law.derivative(contact, unit, fast)),
        }
    }

    fn has_derivative(&self) -> bool {
        true
    }

    fn clamps(&self, pressure: f64) -> bool {
        match self {
            Self::Coating(law) => law.clamps(pressure),
            Self::Film(_) => false,
            Self::Own(law) => {
                let [low, high] = law.valid_pressure();
                pressure < low || pressure > high
            }
        }
    }

    fn kragelskii(&self, pressure: f64) -> Option<Kragelskii> {
        match self {
            Self::Coating(law) => law.kragelskii(pressure),
            Self::Own(_) | Self::Film(_) => None,
        }
    }

    fn kragelskii_slope(&self, pressure: f64) -> Option<Kragelskii> {
        match self {
            Self::Coating(law) => law.kragelskii_slope(pressure),
            Self::Own(_) | Self::Film(_) => None,
        }
    }
}
