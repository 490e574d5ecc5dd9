//! The traction law of a race, chosen at run time.

use crate::kragelskii::scan_for_fall;
use crate::{CoatingLaw, Conditions, Fall, FilmLaw, Kragelskii, Patch, Scalar, SlipCurve, TractionLaw};
use std::fmt::Debug;
use std::sync::Arc;

/// κ/s and its slopes at one slip under the conditions of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OverSlip {
    /// κ/s, finite at s = 0 where it is the initial slope.
    pub value: f64,
    /// Its derivative by the slip s.
    pub by_slip: f64,
    /// Its derivative by the pressure, per Pa.
    pub by_pressure: f64,
    /// Its derivative by the entrainment speed, s/m.
    pub by_entrainment: f64,
}

/// A traction law of one's own: a coefficient over slip, pressure and entrainment speed, given by value and slopes.
///
/// Solvers integrate it node by node; [`Law::Coating`] alone has the vector kernel.
pub trait CustomLaw: Debug + Send + Sync {
    /// κ/s with its slopes at a slip s ≥ 0 under the conditions of a contact. The size of the ellipse, which they hold
    /// too, has no slopes: what depends on it is differentiated as if it stayed.
    fn over_slip(&self, slip: f64, conditions: &Conditions) -> OverSlip;

    /// Pressures between which the law is supported by data, Pa.
    fn valid_pressure(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }
}

/// The traction law of a race.
#[derive(Debug, Clone)]
pub enum Law {
    /// Kragelskii's curve of a coating with parameters that vary with pressure, by the vector kernel.
    Coating(Arc<CoatingLaw>),
    /// A lubricant film, by an integral of its own.
    Film(Arc<FilmLaw>),
    /// A law of one's own, by the plain quadrature; the fast scheme of a transient run takes its friction explicitly.
    Custom(Arc<dyn CustomLaw>),
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
    Custom(Arc<dyn CustomLaw>, Conditions<D>),
}

impl<D: Scalar> SlipCurve<D> for LawCurve<D> {
    fn over_slip(&self, slip: D) -> D {
        match self {
            Self::Kragelskii(curve) => curve.over_slip(slip),
            Self::Custom(law, conditions) => {
                let Conditions { pressure, entrainment_speed, .. } = conditions;
                let at = law.over_slip(slip.re(), &conditions.map(|value| value.re()));
                // The differences have no value, only derivatives.
                let change = |value: D, slope: f64| (value - value.re()) * slope;
                let of_contact = change(*pressure, at.by_pressure) + change(*entrainment_speed, at.by_entrainment);
                change(slip, at.by_slip) + of_contact + at.value
            }
        }
    }

    fn fall(&self) -> Option<Fall<D>> {
        match self {
            Self::Kragelskii(curve) => curve.fall(),
            Self::Custom(..) => scan_for_fall(|slip| self.coefficient(D::from(slip)).re()),
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
            Self::Custom(law) => LawCurve::Custom(Arc::clone(law), *conditions),
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

    fn clamps(&self, pressure: f64) -> bool {
        match self {
            Self::Coating(law) => law.clamps(pressure),
            Self::Film(_) => false,
            Self::Custom(law) => {
                let [low, high] = law.valid_pressure();
                pressure < low || pressure > high
            }
        }
    }

    fn kragelskii(&self, pressure: f64) -> Option<Kragelskii> {
        match self {
            Self::Coating(law) => law.kragelskii(pressure),
            Self::Custom(_) | Self::Film(_) => None,
        }
    }

    fn kragelskii_slope(&self, pressure: f64) -> Option<Kragelskii> {
        match self {
            Self::Coating(law) => law.kragelskii_slope(pressure),
            Self::Custom(_) | Self::Film(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Coating, FastPatch, Patch, PatchLaw, PatchRule, PressureChoice, RelativeMotion, SlipUnit};
    use crate::{fast_patch_traction, linear_patch_traction};
    use num_dual::Dual64;

    /// The silver coating's law handed in as one's own.
    #[derive(Debug)]
    struct Silver(CoatingLaw);

    impl CustomLaw for Silver {
        fn over_slip(&self, slip: f64, &Conditions { pressure, .. }: &Conditions) -> OverSlip {
            let plain = Dual64::from;
            let by_slip = self.0.at(plain(pressure)).over_slip(plain(slip).derivative());
            let by_pressure = self.0.at(plain(pressure).derivative()).over_slip(plain(slip));
            OverSlip { value: by_slip.re, by_slip: by_slip.eps, by_pressure: by_pressure.eps, by_entrainment: 0.0 }
        }
    }

    /// Value and derivative of a custom law are those of the same curve on the fast path.
    #[test]
    fn identity_a_custom_law_equals_the_coating_that_it_copies() {
        let coating = CoatingLaw::varying(&Coating::library("ag").unwrap(), 2).unwrap();
        let laws = [Law::from(coating.clone()), Law::Custom(Arc::new(Silver(coating)))];
        let plain = Dual64::from;
        let patch = Patch {
            semi_lateral: plain(3e-3),
            semi_rolling: plain(0.4e-3),
            peak_pressure: plain(2.2e9),
            ball_radius: 0.015,
            surface_radius: 0.0153,
        };
        let motion = RelativeMotion {
            rolling: plain(0.3).derivative(),
            lateral: plain(0.1),
            spin: plain(200.0),
            about_lateral: plain(-2.0),
            about_rolling: plain(1.0),
        };
        let fast = FastPatch::new(PatchRule::GaussJacobi { radial: 4, angles: 12 }).unwrap();
        let [a, b] = laws.each_ref().map(|law| {
            let law = PatchLaw { law, slip_unit: SlipUnit::MeterPerSecond, pressure: PressureChoice::Peak };
            linear_patch_traction(&fast, &patch, &motion, plain(60.0), &law)
        });
        let size = a.force_rolling.re.abs();
        assert!((a.force_rolling.re - b.force_rolling.re).abs() < 1e-12 * size);
        assert!((a.force_rolling.eps - b.force_rolling.eps).abs() < 1e-10 * a.force_rolling.eps.abs());
        let plain_law = PatchLaw { law: &laws[1], slip_unit: SlipUnit::MeterPerSecond, pressure: PressureChoice::Peak };
        let value = fast_patch_traction(&fast, &patch.re(), &motion.re(), 60.0, &plain_law);
        assert!((value.force_rolling - a.force_rolling.re).abs() < 1e-12 * size);
    }
}
