//! From a case's lubricant to the film laws of its contacts, and the limits of both.

use crate::validate::{Refusal, Verdict, patch_rule, require};
use crate::{Case, LubricantSpec, OilSpec, PressureSpec, ShearSpec};
use tribodyn_bearing::{BearingError, Geometry, Races, Side};
use tribodyn_contact::ElasticBody;
use tribodyn_lubricant::{
    GRADING_TEMPERATURE, InletFilm, LubricantError, Oil, PressureViscosity, Walther, ZERO_CELSIUS, roelands_index,
    so_klaus,
};
use tribodyn_traction::{FilmLaw, FilmShear, Law, PatchChoice, STEEL_HYSTERESIS};

/// Roughest surface of a rolling bearing, m.
const ROUGHNESS_MAX: f64 = 5e-6;
/// Eyring stresses of oils, Pa.
const EYRING: [f64; 2] = [1e5, 1e8];
/// Largest share of the elastic work that bodies lose: rubber.
const HYSTERESIS_MAX: f64 = 0.5;
/// Friction of asperities in oil.
const BOUNDARY: [f64; 2] = [0.01, 0.5];

impl OilSpec {
    /// The oil.
    ///
    /// # Errors
    /// [`LubricantError`] where the data are none of an oil.
    pub fn oil(&self) -> Result<Oil, LubricantError> {
        let oil = match *self {
            Self::Library(ref name) => Oil::library(name)?,
            Self::Grade { stock, vg, viscosity_index } => stock.oil(vg, viscosity_index)?,
            Self::Viscosities { stock, at_40, at_100, density_15, pressure, limiting_shear } => {
                let curve = Walther::through((GRADING_TEMPERATURE, at_40), (ZERO_CELSIUS + 100.0, at_100))?;
                let usual = stock.with_viscosity(curve)?;
                let oil = Oil {
                    density_15: density_15.unwrap_or(usual.density_15),
                    limiting_shear: limiting_shear.unwrap_or(usual.limiting_shear),
                    ..usual
                };
                let coefficient = pressure.map(|pressure| match pressure {
                    PressureSpec::At40(coefficient) => coefficient,
                    PressureSpec::SoKlaus => so_klaus(at_40, oil.density(GRADING_TEMPERATURE), &curve),
                });
                let index = coefficient.map(|alpha| roelands_index(alpha, oil.dynamic(GRADING_TEMPERATURE)));
                index.transpose()?.map_or(oil, |index| Oil { pressure: PressureViscosity::Roelands { index }, ..oil })
            }
        };
        oil.check()?;
        Ok(oil)
    }
}

impl LubricantSpec {
    /// The oil at the inlet of a race's contacts.
    ///
    /// # Errors
    /// [`LubricantError`] where oil, temperature, starvation or roughness are none of a bearing.
    pub fn inlet(&self, side: Side) -> Result<InletFilm, LubricantError> {
        let race = match side {
            Side::Inner => self.roughness.inner,
            Side::Outer => self.roughness.outer,
        };
        let starvation = self.starvation.unwrap_or(self.supply.starvation());
        InletFilm::new(&self.oil.oil()?, self.temperature, starvation, self.roughness.ball.hypot(race))
    }

    /// Film laws of both races between elastic bodies.
    ///
    /// # Errors
    /// As [`Self::inlet`].
    pub(crate) fn laws(
        &self,
        geometry: &Geometry,
        ball: ElasticBody,
        rings: Races<ElasticBody>,
    ) -> Result<Races<Law>, BearingError> {
        let shear = match self.shear {
            ShearSpec::LimitingShear => FilmShear::LimitingShear,
            ShearSpec::Eyring(stress) => FilmShear::Eyring { stress },
        };
        let oil = self.oil.oil()?;
        Races::try_from_fn(|side| {
            let steel = FilmLaw::new(
                (oil, self.temperature, self.inlet(side)?),
                (shear, self.boundary_friction),
                geometry.relative_radii(side),
                [ball, rings[side]],
            )?;
            Ok(FilmLaw { hysteresis: self.hysteresis.unwrap_or(STEEL_HYSTERESIS), ..steel }.into())
        })
    }
}

impl Case {
    /// The rule for the contact patches: of the lubricant, or of the coatings' traction.
    pub fn patch(&self) -> Option<PatchChoice> {
        let of_lubricant = self.lubricant.as_ref().map(|lubricant| lubricant.patch);
        of_lubricant.or(self.traction.as_ref().map(|traction| traction.patch))
    }
}

/// Checks the lubricant.
pub(super) fn validate(case: &Case) -> Verdict {
    let Some(spec) = &case.lubricant else { return Ok(()) };
    let alone = case.coatings.is_none() && case.traction.is_none();
    require(alone, "lubricant", "a case has a lubricant or `coatings` with their `traction`: leave out one of both")?;
    let refused = |path: &str| {
        let path = path.to_owned();
        move |error: LubricantError| Refusal { path, message: error.to_string() }
    };
    spec.oil.oil().map_err(refused("lubricant.oil"))?;
    Oil::check_temperature(spec.temperature).map_err(refused("lubricant.temperature"))?;
    let starvation = spec.starvation.is_none_or(|factor| factor > 0.0 && factor <= 1.0);
    require(starvation, "lubricant.starvation", "must be greater than 0 and at most 1, a flooded contact")?;
    let roughness = &spec.roughness;
    for (name, value) in [("ball", roughness.ball), ("inner", roughness.inner), ("outer", roughness.outer)] {
        let allowed = value > 0.0 && value <= ROUGHNESS_MAX;
        let message = format!("must be greater than 0 and at most {} um", ROUGHNESS_MAX * 1e6);
        require(allowed, &format!("lubricant.roughness.{name}"), message)?;
    }
    if let ShearSpec::Eyring(stress) = spec.shear {
        let [low, high] = EYRING;
        let message = format!("must lie between {} and {} MPa; oils have 3 to 10", low * 1e-6, high * 1e-6);
        require((low..=high).contains(&stress), "lubricant.shear.Eyring", message)?;
    }
    let [low, high] = BOUNDARY;
    let message = format!("must lie between {low} and {high}; steel in oil has 0.08 to 0.15");
    require((low..=high).contains(&spec.boundary_friction), "lubricant.boundary_friction", message)?;
    let lossy = spec.hysteresis.is_none_or(|share| (0.0..=HYSTERESIS_MAX).contains(&share));
    let message = format!("must lie between 0 and {HYSTERESIS_MAX}; bearing steel has 0.003 to 0.01");
    require(lossy, "lubricant.hysteresis", message)?;
    patch_rule("lubricant.patch", spec.patch)
}
