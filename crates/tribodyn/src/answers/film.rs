//! Lubricant films: of one contact, and of every contact of a case.

use super::friction::WithFriction;
use super::lubrication::named_oil;
use super::{Answer, Equations, Question};
use crate::error::AnswerError;
use crate::plausibility::{PRESSURE_MOST, not_elastic, shown};
use serde::Serialize;
use tribodyn_bearing::Side;
use tribodyn_lubricant::{InletFilm, Oil, RollingContact, ZERO_CELSIUS};
use tribodyn_rating::reference_viscosity;

/// An oil at a temperature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OilAnswer {
    /// Temperature, °C.
    pub temperature_deg_c: f64,
    /// Kinematic viscosity, mm²/s.
    pub kinematic_viscosity_mm2_s: f64,
    /// Dynamic viscosity at ambient pressure, Pa s.
    pub dynamic_viscosity_pa_s: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Pressure–viscosity coefficient, 1/Pa.
    pub pressure_viscosity_per_pa: f64,
}

/// The film of one contact.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactFilm {
    /// Ball, from 0; absent where only one contact was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball: Option<usize>,
    /// Race; likewise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub race: Option<&'static str>,
    /// Load, N.
    pub load_n: f64,
    /// Entrainment speed, m/s.
    pub entrainment_speed_m_s: f64,
    /// Central thickness, m.
    pub film_central_m: f64,
    /// Least thickness, m.
    pub film_minimum_m: f64,
    /// Film parameter λ.
    pub lambda_ratio: f64,
    /// Rise of the mean film temperature, K; absent where only one contact was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub film_temperature_rise_k: Option<f64>,
}

/// The films of a case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FilmAnswer {
    /// The oil at the inlet.
    pub oil: OilAnswer,
    /// Film thickness over that of flooded contacts.
    pub starvation: f64,
    /// Viscosity ratio κ; absent at rest.
    pub viscosity_ratio: Option<f64>,
    /// Viscosity that ISO 281 asks for at this speed, mm²/s; absent at rest.
    pub reference_viscosity_mm2_s: Option<f64>,
    /// Speed times pitch diameter, mm r/min.
    pub speed_factor_mm_rpm: f64,
    /// Loaded contacts, ball by ball.
    pub contacts: Vec<ContactFilm>,
}

/// One contact; messages about a value call it by the name of the command's option.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactFilmQuestion {
    /// Name of the oil in the library, or its grade alone: `vg68` is a mineral oil.
    pub oil: String,
    /// Temperature of the inlet, °C.
    pub temperature_deg_c: f64,
    /// Film thickness over that of a flooded contact.
    pub starvation: f64,
    /// Roughness of both surfaces together, µm.
    pub roughness_um: f64,
    /// Load, N.
    pub load_n: f64,
    /// Entrainment speed, m/s.
    pub speed_m_s: f64,
    /// Slide-to-roll ratio.
    pub slide_to_roll: f64,
    /// Radius of relative curvature along rolling, mm.
    pub rolling_radius_mm: f64,
    /// Radius of relative curvature across rolling, mm.
    pub lateral_radius_mm: f64,
    /// Young's modulus of both bodies, GPa.
    pub young_gpa: f64,
    /// Poisson's ratio of both bodies.
    pub poisson: f64,
}

fn oil_answer(oil: &Oil, temperature: f64) -> OilAnswer {
    OilAnswer {
        temperature_deg_c: temperature - ZERO_CELSIUS,
        kinematic_viscosity_mm2_s: oil.kinematic_mm2_s(temperature),
        dynamic_viscosity_pa_s: oil.dynamic(temperature),
        density_kg_m3: oil.density(temperature),
        pressure_viscosity_per_pa: oil.pressure_coefficient(temperature),
    }
}

/// The film of one contact, and its oil.
///
/// # Errors
/// Values that make no oil, contact or film.
pub fn contact_film(question: &ContactFilmQuestion) -> Result<(OilAnswer, ContactFilm), AnswerError> {
    let q = question;
    let oil = named_oil(&q.oil)?;
    let temperature = q.temperature_deg_c + ZERO_CELSIUS;
    let inlet = InletFilm::new(&oil, temperature, q.starvation, q.roughness_um * 1e-6)?;
    let steel = tribodyn_contact::ElasticBody { young: q.young_gpa * 1e9, poisson: q.poisson };
    let modulus = tribodyn_contact::effective_modulus(&steel, &steel);
    let [rolling, lateral] = [q.rolling_radius_mm, q.lateral_radius_mm].map(|radius| radius * 1e-3);
    let hertz = tribodyn_contact::HertzContact::new(1.0 / rolling, 1.0 / lateral, modulus)?;
    let ellipse = hertz.ellipse(q.load_n);
    let contact = RollingContact {
        load: q.load_n,
        entrainment: q.speed_m_s,
        slide_to_roll: q.slide_to_roll,
        rolling_radius: rolling,
        lateral_radius: lateral,
        ellipticity: ellipse.semi_lateral() / ellipse.semi_rolling(),
        peak_pressure: ellipse.peak_pressure,
        effective_modulus: modulus,
    };
    contact.check()?;
    if ellipse.peak_pressure > PRESSURE_MOST {
        let pressure = shown(ellipse.peak_pressure * 1e-9);
        let message = format!("{} and the peak pressure would be {pressure}", not_elastic());
        return Err(AnswerError::argument("load", q.load_n, format!("{message} GPa: allowed is a load below that")));
    }
    let film = inlet.thickness(&contact);
    let answer = ContactFilm {
        ball: None,
        race: None,
        load_n: q.load_n,
        entrainment_speed_m_s: q.speed_m_s,
        film_central_m: film.central,
        film_minimum_m: film.minimum,
        lambda_ratio: inlet.lambda_ratio(&film),
        film_temperature_rise_k: None,
    };
    Ok((oil_answer(&oil, temperature), answer))
}

/// The films of all loaded contacts of a case with a lubricant.
///
/// # Errors
/// A case without lubricant, equations without friction, or a case that they do not solve.
pub fn films(question: &Question<'_>, equations: Equations) -> Result<Answer<FilmAnswer>, AnswerError> {
    let Some(lubricant) = &question.case.lubricant else {
        return Err(AnswerError::not_asked(question.name, "it has no `lubricant`, so its contacts have no film"));
    };
    let WithFriction { solution, findings, .. } = WithFriction::solve(question, equations)?;
    let oil = lubricant.oil.oil()?;
    let speed = solution.inner_speed_rad_s - solution.outer_speed_rad_s;
    let pitch = question.case.geometry.pitch_diameter;
    let reference = if speed == 0.0 {
        None
    } else {
        let refused = |source| AnswerError::Rating { file: question.name.to_owned(), source };
        Some(reference_viscosity(speed, pitch).map_err(refused)?)
    };
    let contacts: Vec<ContactFilm> = solution
        .balls
        .iter()
        .enumerate()
        .flat_map(|(ball, result)| {
            Side::BOTH.into_iter().filter_map(move |side| {
                let contact = &result.contacts[side];
                let film = contact.film?;
                Some(ContactFilm {
                    ball: Some(ball),
                    race: Some(side.name()),
                    load_n: contact.load_n,
                    entrainment_speed_m_s: contact.rolling_speed_m_s,
                    film_central_m: film.central_m,
                    film_minimum_m: film.minimum_m,
                    lambda_ratio: film.lambda_ratio,
                    film_temperature_rise_k: Some(film.temperature_rise_k),
                })
            })
        })
        .collect();
    let answer = FilmAnswer {
        oil: oil_answer(&oil, lubricant.temperature),
        starvation: lubricant.starvation.unwrap_or(lubricant.supply.starvation()),
        viscosity_ratio: reference.map(|reference| oil.viscosity.kinematic(lubricant.temperature) / reference),
        reference_viscosity_mm2_s: reference.map(|reference| reference * 1e6),
        speed_factor_mm_rpm: (speed * 30.0 / std::f64::consts::PI * pitch * 1e3).abs(),
        contacts,
    };
    Ok(Answer::new(findings, answer))
}
