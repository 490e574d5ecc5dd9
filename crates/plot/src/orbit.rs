//! Values of balls over the azimuth from samples along orbits.

use crate::error::PlotError;
use crate::figure::{Figure, Panel};
use crate::run::Samples;
use crate::series::{Axis, Series};
use crate::solution::{fits_circle, over_azimuth};

/// Samples of one quantity along orbits, in any order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitSamples<'a> {
    /// Name in the legend.
    pub label: &'a str,
    /// Azimuths in rad, of any turn.
    pub azimuth_rad: &'a [f64],
    /// Values in the unit of the figure's axis; `None` where a ball has none, as the pressure of a contact without
    /// load.
    pub values: &'a [Option<f64>],
}

/// Sectors of an orbit in which samples are averaged: 2° each, as fine as the curve is drawn.
const SECTORS: usize = 180;
/// Part of the spread of all values below which the spread within the sectors is not drawn.
const BAND_SHOWN: f64 = 0.02;
/// Name in the legend of azimuths where balls have no value.
const NO_CONTACT: &str = "no contact";

/// Values of a ball over the azimuth from samples along one orbit or several.
///
/// The curve is the mean of the samples in sectors of 2° at their mean azimuth, closed over 0°; a light band from the
/// least to the greatest value of each sector shows where orbits differ or a value jumps, if that is more than 2 % of
/// the whole spread anywhere. Sectors in which at least half of the samples have no value are marked by crosses, and no
/// line goes over them; in others the mean is that of the samples that have one. Polar where no value is negative and
/// not all are zero, otherwise over degrees.
///
/// # Errors
///
/// No samples, unequal numbers of azimuths and values, numbers that are not finite.
pub fn orbit_figure(name: &str, title: &str, quantity: Axis, samples: &[OrbitSamples]) -> Result<Figure, PlotError> {
    Figure::new(name, title, &orbit_panels(&[("", quantity, samples)])?)
}

/// The panels of [`orbit_figure`] with their headings, for figures of several and for what else belongs on them: all
/// polar, or, where one of them cannot be, all over degrees.
///
/// # Errors
///
/// Unequal numbers of azimuths and values, numbers that are not finite.
pub fn orbit_panels(panels: &[(&str, Axis, &[OrbitSamples])]) -> Result<Vec<Panel>, PlotError> {
    let curves = |samples: &[OrbitSamples]| samples.iter().map(over_orbit).collect::<Result<Vec<Series>, _>>();
    let drawn = panels.iter().map(|(_, _, samples)| curves(samples)).collect::<Result<Vec<_>, _>>()?;
    let polar = drawn.iter().all(|series| fits_circle(series));
    let made = panels.iter().zip(drawn);
    Ok(made.map(|((title, quantity, _), series)| over_azimuth(title, quantity.clone(), series, polar)).collect())
}

/// [`orbit_figure`] of values that are there at every azimuth.
///
/// # Errors
///
/// Those of [`orbit_figure`].
pub fn orbit_polar(name: &str, title: &str, quantity: Axis, samples: &[Samples]) -> Result<Figure, PlotError> {
    let values: Vec<Vec<Option<f64>>> = samples.iter().map(|s| s.y.iter().copied().map(Some).collect()).collect();
    let made = samples.iter().zip(&values);
    let orbits: Vec<OrbitSamples> =
        made.map(|(s, values)| OrbitSamples { label: s.label, azimuth_rad: s.x, values }).collect();
    orbit_figure(name, title, quantity, &orbits)
}

/// Samples of a sector: azimuths in degrees with values, and azimuths without.
#[derive(Default, Clone)]
struct Sector {
    found: Vec<(f64, f64)>,
    absent: Vec<f64>,
}

/// Mean and band over the azimuth.
fn over_orbit(samples: &OrbitSamples) -> Result<Series, PlotError> {
    let series = samples.label.to_owned();
    let (abscissas, ordinates) = (samples.azimuth_rad.len(), samples.values.len());
    if abscissas != ordinates {
        return Err(PlotError::Lengths { series, abscissas, ordinates });
    }
    let mut sectors = vec![Sector::default(); SECTORS];
    for (index, (azimuth, value)) in samples.azimuth_rad.iter().zip(samples.values).enumerate() {
        let (x, y) = (azimuth.to_degrees(), value.unwrap_or(0.0));
        // Refused here: in sums a single NaN would lose its place.
        if !(x.is_finite() && y.is_finite()) {
            return Err(PlotError::NotFinite { series, index, x, y });
        }
        let within = crate::turn::within(x);
        let sector = &mut sectors[((within / 360.0 * SECTORS as f64) as usize).min(SECTORS - 1)];
        match value {
            Some(value) => sector.found.push((within, *value)),
            None => sector.absent.push(within),
        }
    }
    let mean = |of: &mut dyn Iterator<Item = f64>, count: usize| of.sum::<f64>() / count as f64;
    let (mut points, mut band, mut absent) = (Vec::new(), Vec::new(), Vec::new());
    for Sector { found, absent: without } in &sectors {
        if found.len() > without.len() {
            let phi = mean(&mut found.iter().map(|p| p.0), found.len());
            let extreme = |start: f64, pick: fn(f64, f64) -> f64| found.iter().fold(start, |e, p| pick(e, p.1));
            points.push((phi, mean(&mut found.iter().map(|p| p.1), found.len())));
            band.push((phi, extreme(f64::INFINITY, f64::min), extreme(f64::NEG_INFINITY, f64::max)));
        } else if !without.is_empty() {
            absent.push(mean(&mut without.iter().copied(), without.len()));
        }
    }
    let (low, high) = band.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), e| (a.min(e.1), b.max(e.2)));
    let shown = band.iter().any(|(_, a, b)| b - a > BAND_SHOWN * (high - low));
    let line = Series { band: shown.then_some(band), ..Series::line(series, points) };
    Ok(line.without(NO_CONTACT, absent))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orbit(phi: &[f64], value: &[Option<f64>]) -> Series {
        over_orbit(&OrbitSamples { label: "b", azimuth_rad: phi, values: value }).unwrap()
    }

    #[test]
    fn limit_samples_of_one_orbit_are_drawn_as_they_are() {
        let phi: Vec<f64> = (0..90).map(|k| 0.3 + f64::from(k) * std::f64::consts::TAU / 90.0).collect();
        let value: Vec<Option<f64>> = phi.iter().map(|p| Some(p.cos())).collect();
        let series = orbit(&phi, &value);
        assert_eq!((series.points.len(), &series.band, &series.absent), (90, &None, &None));
        assert!(series.points.iter().all(|(p, v)| (p.to_radians().cos() - v).abs() < 1e-12));
    }

    #[test]
    fn identity_the_band_holds_every_sample_and_the_curve() {
        let phi: Vec<f64> = (0..5000).map(|k| -0.013 * f64::from(k)).collect();
        let value: Vec<f64> = phi.iter().map(|p| p.cos() + 0.1 * (0.37 * p).sin()).collect();
        let series = orbit(&phi, &value.iter().copied().map(Some).collect::<Vec<_>>());
        let band = series.band.unwrap();
        assert_eq!((series.points.len(), band.len()), (SECTORS, SECTORS));
        assert!(series.points.iter().zip(&band).all(|((_, v), (_, low, high))| low <= v && v <= high));
        let greatest = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(greatest(&mut band.iter().map(|b| b.2)), greatest(&mut value.iter().copied()));
    }

    #[test]
    fn limit_sectors_without_contact_have_no_value() {
        let phi: Vec<f64> = (0..3600).map(|k| 1e-6 + f64::from(k) * std::f64::consts::TAU / 1200.0).collect();
        let value: Vec<Option<f64>> = phi.iter().map(|p| (p.cos() > 0.0).then(|| 5.0 * p.cos())).collect();
        let series = orbit(&phi, &value);
        let absent = &series.absent.as_ref().unwrap().at;
        assert_eq!((series.points.len(), absent.len()), (90, 90));
        assert!(absent.iter().all(|phi| (90.0..270.0).contains(phi)) && series.points.iter().all(|p| p.1 > 0.0));
    }
}
