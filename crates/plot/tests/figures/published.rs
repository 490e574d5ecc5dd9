//! Published numbers across panels: where they are drawn, how they look, and what is refused.

use crate::{parse, texts};
use tribodyn_plot::{Axis, Figure, LineChart, Panel, Place, PlotError, PolarChart, Reference, Series};

/// The dashes that published numbers alone have.
const DASH: &str = "7 2.5 1.5 2.5";

fn references() -> Vec<Reference> {
    vec![
        Reference::new("published: 8", Place::Value(8.0)),
        Reference::new("published: 2 to 5", Place::Range(2.0, 5.0)).of("a"),
        Reference::new("published at 40", Place::At(40.0)),
        Reference::new("published from −90 to 90", Place::Between(-90.0, 90.0)),
    ]
}

fn lines() -> Vec<Series> {
    let points = (0..36).map(|k| 10.0 * f64::from(k)).map(|phi| (phi, 3.0 + phi.to_radians().cos()));
    vec![Series::line("a", points.collect())]
}

fn line_chart(references: Vec<Reference>) -> LineChart {
    LineChart { references, ..LineChart::new("c", Axis::new("Azimuth", "°"), Axis::new("v", "N"), lines()) }
}

fn polar_chart(references: Vec<Reference>) -> PolarChart {
    PolarChart { references, ..PolarChart::new("p", Axis::new("v", "N"), lines()) }
}

pub fn both() -> Figure {
    let panels = [Panel::Cartesian(line_chart(references())), Panel::Polar(polar_chart(references()))];
    Figure::new("published", "Published numbers", &panels).expect("finite data")
}

/// Points of the dashed lines of a figure with one panel, the legend's samples left out: they come last, one line for
/// each published line, two for each range.
fn drawn(figure: &Figure, samples: usize) -> Vec<Vec<[f64; 2]>> {
    let document = parse(figure);
    let dashed = document.descendants().filter(|n| n.attribute("stroke-dasharray") == Some(DASH));
    let points = |d: &str| -> Vec<[f64; 2]> {
        let number = |text: &str| text.parse::<f64>().expect("a number");
        d.trim_start_matches('M')
            .split(" L")
            .map(|p| p.split_once(' ').expect("two"))
            .map(|(x, y)| [number(x), number(y)])
            .collect()
    };
    let mut all: Vec<_> = dashed.filter_map(|n| n.attribute("d")).map(points).collect();
    all.truncate(all.len() - samples);
    all
}

#[test]
fn identity_published_numbers_look_the_same_on_all_charts_and_are_in_the_legend_once() {
    let figure = both();
    let texts = texts(&figure);
    assert!(references().iter().all(|r| texts.contains(&r.label)), "{texts:?}");
    let document = parse(&figure);
    let dashed: Vec<_> = document.descendants().filter(|n| n.attribute("stroke-dasharray") == Some(DASH)).collect();
    // A line for a number, two for a range: on each chart and in the legend.
    assert_eq!(dashed.len(), 3 * 6);
    assert!(dashed.iter().all(|n| n.attribute("stroke-width") == Some("1.3")));
    let blue = dashed.iter().filter(|n| n.attribute("stroke") == Some("#0072B2")).count();
    assert_eq!(blue, 3 * 2, "the range has the colour of its line");
    let tints = document.descendants().filter(|n| n.attribute("fill-opacity").is_some()).count();
    assert_eq!(tints, 3 * 2);
}

#[test]
fn identity_lines_lie_where_their_numbers_are_and_the_axes_reach_them() {
    let only = |reference| Figure::new("f", "F", &[Panel::Cartesian(line_chart(vec![reference]))]).expect("finite");
    let level = |value| drawn(&only(Reference::new("r", Place::Value(value))), 1)[0].clone();
    let [low, high] = [level(2.0), level(4.0)];
    assert!(low[0][1] == low[1][1] && low[0][1] > high[0][1] && low[0][0] < low[1][0]);
    let beyond = only(Reference::new("r", Place::Value(50.0)));
    assert!(texts(&beyond).contains("50"), "{:?}", texts(&beyond));
    let upright = &drawn(&only(Reference::new("r", Place::At(500.0))), 1)[0];
    assert_eq!(upright[0][0], upright[1][0]);
    assert!(texts(&only(Reference::new("r", Place::At(500.0)))).contains("500"));
}

#[test]
fn identity_rays_circles_and_sectors_follow_the_azimuth() {
    let only = |reference| Figure::new("f", "F", &[Panel::Polar(polar_chart(vec![reference]))]).expect("finite");
    let rays = drawn(&only(Reference::new("r", Place::Between(-90.0, 90.0))), 2);
    let [[centre, down], [_, up]] = [0, 1].map(|k| [rays[k][0], rays[k][1]]);
    // Page coordinates grow downwards: 90° is up, −90° down.
    assert!((down[0] - centre[0]).abs() < 0.02 && down[1] > centre[1] && up[1] < centre[1]);
    let circle = &drawn(&only(Reference::new("r", Place::Value(4.0))), 1)[0];
    let radius = |p: &[f64; 2]| (p[0] - centre[0]).hypot(p[1] - centre[1]);
    assert!(circle.len() > 180 && circle.iter().all(|p| (radius(p) - radius(&circle[0])).abs() < 0.02));
    assert_eq!(circle.first(), circle.last());
    // A sector over 0° is the lesser part of the turn: its area holds the point at 0° and not the one at 180°.
    let figure = only(Reference::new("r", Place::Between(330.0, 30.0)));
    let document = parse(&figure);
    let area = document.descendants().find(|n| n.attribute("fill-opacity").is_some()).expect("a tint");
    let xs = area
        .attribute("d")
        .expect("a path")
        .split(['M', 'L', 'Z'])
        .filter_map(|p| p.trim().split(' ').next()?.parse::<f64>().ok());
    assert!(xs.fold(f64::INFINITY, f64::min) > centre[0] - 0.02);
}

#[test]
fn limit_published_numbers_that_cannot_be_drawn_are_refused() {
    for place in [Place::Value(f64::NAN), Place::Range(1.0, f64::INFINITY), Place::At(1e200)] {
        let reference = || vec![Reference::new("r", place)];
        for panel in [Panel::Cartesian(line_chart(reference())), Panel::Polar(polar_chart(reference()))] {
            let error = Figure::new("f", "F", &[panel]).unwrap_err();
            assert!(matches!(&error, PlotError::NotFinite { series, .. } if series == "r"), "{error}");
        }
    }
    let logarithmic = line_chart(vec![Reference::new("r", Place::Value(0.0))]).log_log();
    let series = vec![Series::line("a", vec![(1.0, 1.0), (2.0, 3.0)])];
    let error = Figure::new("f", "F", &[Panel::Cartesian(LineChart { series, ..logarithmic })]).unwrap_err();
    assert!(matches!(error, PlotError::NotPositive { value: 0.0, .. }), "{error}");
}
