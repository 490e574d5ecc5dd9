//! Figures of a run in time from plain numbers: histories, spectra, paths, bars.

use crate::bars::BarChart;
use crate::cartesian::LineChart;
use crate::error::PlotError;
use crate::figure::{Figure, Panel};
use crate::marks::Mark;
use crate::series::{Axis, Series};

/// A named sequence of numbers against another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Samples<'a> {
    /// Name in the legend.
    pub label: &'a str,
    /// Abscissas: time in s, frequency in Hz, azimuth in rad, as the figure says.
    pub x: &'a [f64],
    /// Ordinates in the unit of the figure's axis.
    pub y: &'a [f64],
}

/// One quantity, or several of one unit, over time.
#[derive(Debug, Clone, PartialEq)]
pub struct History<'a> {
    /// Heading of the panel; may be empty.
    pub title: &'a str,
    /// The quantity of the ordinates.
    pub quantity: Axis,
    /// Time in s against the quantity.
    pub samples: Vec<Samples<'a>>,
}

/// Abscissas and scale of a spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumView {
    /// The quantity of the abscissas; the axis begins at zero if it covers nothing else.
    pub abscissa: Axis,
    /// Abscissa up to which the spectrum is drawn; all of it without one.
    pub up_to: Option<f64>,
    /// Decades below the highest amplitude that a logarithmic axis shows, smaller amplitudes drawn at the end of these
    /// and abscissa zero, where the mean would be, left out; linear without.
    pub decades: Option<u32>,
}

impl SpectrumView {
    /// Over frequency, linear.
    pub fn frequency() -> Self {
        Self { abscissa: Axis::new("Frequency", "Hz"), up_to: None, decades: None }
    }

    /// Over orders, events per shaft turn, linear.
    pub fn order() -> Self {
        Self { abscissa: Axis::new("Order (events per shaft turn)", ""), ..Self::frequency() }
    }

    /// The same with amplitudes on a logarithmic axis over some decades.
    #[must_use]
    pub fn logarithmic(mut self, decades: u32) -> Self {
        self.decades = Some(decades);
        self
    }

    /// The same up to an abscissa.
    #[must_use]
    pub fn up_to(mut self, abscissa: f64) -> Self {
        self.up_to = Some(abscissa);
        self
    }
}

/// Size of the area of a history that stands alone, and of one among others above and below it, px.
const HISTORY_PX: [[f64; 2]; 2] = [[660.0, 270.0], [660.0, 150.0]];
/// Size of the area of a path, px.
const PATH_PX: [f64; 2] = [330.0, 330.0];
/// Size of the area of a spectrum, px.
const SPECTRUM_PX: [f64; 2] = [660.0, 270.0];
fn pairs(samples: &Samples, scale_x: f64) -> Result<Vec<(f64, f64)>, PlotError> {
    if samples.x.len() != samples.y.len() {
        let series = samples.label.to_owned();
        return Err(PlotError::Lengths { series, abscissas: samples.x.len(), ordinates: samples.y.len() });
    }
    Ok(samples.x.iter().zip(samples.y).map(|(x, y)| (scale_x * x, *y)).collect())
}

/// The unit of time in which a span of seconds has handy numbers, and its count in one second.
fn time_unit(span_s: f64) -> (&'static str, f64) {
    match span_s {
        s if s >= 1.0 => ("s", 1.0),
        s if s >= 1e-3 => ("ms", 1e3),
        _ => ("µs", 1e6),
    }
}

/// Histories one above the other over one time axis.
///
/// Any number of samples: of each half pixel the first, least, greatest and last sample are drawn, so that short peaks
/// stay.
///
/// # Errors
///
/// No history, one without samples, unequal numbers of times and values, numbers that are not finite.
pub fn time_history(name: &str, title: &str, histories: &[History]) -> Result<Figure, PlotError> {
    let (charts, _) = history_charts(histories)?;
    Figure::in_columns(name, title, 1, &charts.into_iter().map(Panel::Cartesian).collect::<Vec<_>>())
}

/// The charts of [`time_history`], for what else belongs on them, and the count of their unit of time in one second.
///
/// # Errors
///
/// Unequal numbers of times and values.
pub fn history_charts(histories: &[History]) -> Result<(Vec<LineChart>, f64), PlotError> {
    let times =
        || histories.iter().flat_map(|h| &h.samples).flat_map(|s| s.x.iter().copied()).filter(|t| t.is_finite());
    let (first, last) = times().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), t| (a.min(t), b.max(t)));
    let (unit, scale) = time_unit(last - first);
    let area_px = HISTORY_PX[usize::from(histories.len() > 1)];
    let mut charts = Vec::with_capacity(histories.len());
    for history in histories {
        let line = |s: &Samples| pairs(s, scale).map(|points| Series::dense(s.label, points));
        let series = history.samples.iter().map(line).collect::<Result<Vec<_>, _>>()?;
        let mut time = Axis::new("Time", unit);
        if first < last {
            time = time.covering(scale * first, scale * last);
        }
        let chart = LineChart::new(history.title, time, history.quantity.clone(), series);
        charts.push(LineChart { area_px, ..chart });
    }
    Ok((charts, scale))
}

/// Amplitude spectra over frequency or order with marked places, such as the cage frequency and its multiples.
///
/// # Errors
///
/// No spectrum, one without lines in the range, unequal numbers of abscissas and amplitudes, numbers that are not
/// finite, only zero amplitudes on a logarithmic axis.
pub fn spectrum_figure(
    name: &str,
    title: &str,
    quantity: Axis,
    spectra: &[Samples],
    marks: &[Mark],
    view: &SpectrumView,
) -> Result<Figure, PlotError> {
    Figure::new(name, title, &[Panel::Cartesian(spectrum_chart(quantity, spectra, marks, view)?)])
}

/// The chart of [`spectrum_figure`], for what else belongs on it.
///
/// # Errors
///
/// Unequal numbers of abscissas and amplitudes.
pub fn spectrum_chart(
    quantity: Axis,
    spectra: &[Samples],
    marks: &[Mark],
    view: &SpectrumView,
) -> Result<LineChart, PlotError> {
    let mut series = Vec::with_capacity(spectra.len());
    for spectrum in spectra {
        let mut lines = pairs(spectrum, 1.0)?;
        lines.retain(|(x, _)| view.up_to.is_none_or(|most| *x <= most) && (view.decades.is_none() || *x != 0.0));
        series.push(Series::dense(spectrum.label, lines));
    }
    let mut amplitude = quantity;
    if let Some(decades) = view.decades {
        let highest = series.iter().flat_map(|s| &s.points).fold(0.0, |most: f64, (_, a)| most.max(*a));
        let least = highest * 10f64.powi(-i32::try_from(decades).unwrap_or(i32::MAX));
        for (_, a) in series.iter_mut().flat_map(|s| &mut s.points) {
            // NaN stays and is refused.
            *a = if *a < least { least } else { *a };
        }
        amplitude.at_least = None;
    } else if amplitude.at_least.is_none() {
        amplitude = amplitude.covering(0.0, 0.0);
    }
    let mut abscissa = view.abscissa.clone();
    if abscissa.at_least.is_none() {
        abscissa = abscissa.covering(0.0, 0.0);
    }
    let log_y = view.decades.is_some();
    let chart = LineChart::new("", abscissa, amplitude, series);
    Ok(LineChart { log_y, marks: marks.to_vec(), area_px: SPECTRUM_PX, ..chart })
}

/// Paths in a plane with equal scales on both axes, such as the orbit of a ring's centre: abscissas and ordinates in
/// one unit.
///
/// # Errors
///
/// No path, one without points, unequal numbers of coordinates, numbers that are not finite.
pub fn path_figure(name: &str, title: &str, x: Axis, y: Axis, paths: &[Samples]) -> Result<Figure, PlotError> {
    let line = |s: &Samples| pairs(s, 1.0).map(|points| Series::dense(s.label, points));
    let series = paths.iter().map(line).collect::<Result<Vec<_>, _>>()?;
    let chart = LineChart { equal_scales: true, area_px: PATH_PX, ..LineChart::new("", x, y, series) };
    Figure::new(name, title, &[Panel::Cartesian(chart)])
}

fn bar_chart(quantity: Axis, groups: &[&str], bars: &[(&str, Vec<f64>)]) -> BarChart {
    let series = bars.iter().map(|(label, values)| Series::bars(*label, values)).collect();
    let chart = BarChart::new("", quantity, groups.iter().map(|&g| g.to_owned()).collect(), series);
    BarChart { area_px: [chart.area_px[0].max(70.0 * groups.len() as f64), chart.area_px[1]], ..chart }
}

/// Bars side by side: of each label one value for each group.
///
/// # Errors
///
/// No bars, more values than groups, numbers that are not finite.
pub fn bars(
    name: &str,
    title: &str,
    quantity: Axis,
    groups: &[&str],
    bars: &[(&str, Vec<f64>)],
) -> Result<Figure, PlotError> {
    Figure::new(name, title, &[Panel::Bars(bar_chart(quantity, groups, bars))])
}

/// Stacked bars, as for a power balance: of each label one value for each group, zero where it has no part in it.
///
/// # Errors
///
/// No bars, more values than groups, numbers that are not finite.
pub fn stacked_bars(
    name: &str,
    title: &str,
    quantity: Axis,
    groups: &[&str],
    bars: &[(&str, Vec<f64>)],
) -> Result<Figure, PlotError> {
    Figure::new(name, title, &[Panel::Bars(bar_chart(quantity, groups, bars).stacked())])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_units_of_time() {
        assert_eq!((time_unit(2.0).0, time_unit(0.3).0, time_unit(2e-4).0), ("s", "ms", "µs"));
    }
}
