//! Every ball is there: those with a value marked, those without contact crossed out, and no line between where nothing
//! is.

use crate::parse;
use crate::synthetic::{ball, borrowed, figures, runs, solution};
use tribodyn_bearing::{BallResult, ContactResult, FrictionResult, Side};
use tribodyn_plot::{Axis, Figure, OrbitSamples, orbit_figure, solution_figures};
use tribodyn_quasistatic::{Model, Solution};

const BLUE: &str = "#0072B2";

fn friction(contact: &mut ContactResult) -> &mut FrictionResult {
    contact.friction.as_mut().expect("a ball under traction")
}

/// Takes the load off both contacts.
fn unload(ball: &mut BallResult) {
    for side in Side::BOTH {
        (ball.contacts[side].load_n, ball.contacts[side].peak_pressure_pa) = (0.0, 0.0);
    }
}

/// A bearing under radial load: five of 13 balls carry it.
fn partly_loaded() -> Solution {
    let mut all = solution(Model::Traction, 1.0, 1.0);
    for ball in all.balls.iter_mut().filter(|ball| ball.azimuth_rad.cos() < 0.5) {
        unload(ball);
        ball.orbital_speed_rad_s = 0.0;
        ball.contacts.outer.angle_rad = 0.0;
        friction(&mut ball.contacts.inner).slide_to_roll[0] = -2.0;
    }
    all
}

pub fn partly_loaded_figures() -> Vec<Figure> {
    solution_figures(&[("this case", &partly_loaded())], &[]).expect("finite numbers")
}

fn named<'a>(figures: &'a [Figure], name: &str) -> &'a Figure {
    figures.iter().find(|f| f.name == name).expect("a figure of that name")
}

/// Filled markers of a colour.
fn markers(figure: &Figure, colour: &str) -> usize {
    let document = parse(figure);
    let round = document.descendants().filter(|n| n.has_tag_name("circle") || n.has_tag_name("polygon"));
    round.filter(|n| n.attribute("fill") == Some(colour)).count()
}

/// Crosses of a colour.
fn crosses(figure: &Figure, colour: &str) -> usize {
    let document = parse(figure);
    let paths = document.descendants().filter(|n| n.attribute("stroke") == Some(colour));
    paths.filter_map(|n| n.attribute("d")).filter(|d| d.matches('M').count() == 2).count()
}

/// Lines of a colour, each as its points.
fn lines(figure: &Figure, colour: &str) -> Vec<Vec<[f64; 2]>> {
    let document = parse(figure);
    let paths = document.descendants().filter(|n| n.attribute("stroke") == Some(colour));
    let of = paths.filter_map(|n| n.attribute("d")).filter(|d| d.matches('M').count() == 1);
    let point = |text: &str| {
        let (x, y) = text.trim().split_once(' ').expect("two numbers");
        [x, y].map(|n| n.parse::<f64>().expect("a number"))
    };
    of.map(|d| d.trim_start_matches('M').trim_end_matches(" Z").split(" L").map(point).collect()).collect()
}

#[test]
fn identity_every_ball_of_every_run_is_marked() {
    let runs = runs();
    let figures = solution_figures(&borrowed(&runs), &[]).unwrap();
    for colour in [BLUE, "#D55E00", "#009E73", "#CC79A7"] {
        // Both contacts of 13 balls, and the sample in the legend.
        assert_eq!(markers(named(&figures, "contact-loads"), colour), 27);
        assert_eq!(markers(named(&figures, "slide-to-roll"), colour), 27);
        assert_eq!(markers(named(&figures, "orbital-speed"), colour), 14);
    }
}

#[test]
fn identity_balls_without_contact_are_crosses_and_no_line_goes_over_them() {
    let figures = partly_loaded_figures();
    for name in ["contact-loads", "peak-pressures", "contact-angles", "slide-to-roll"] {
        let figure = named(&figures, name);
        // Two panels with 5 loaded balls and 8 others.
        assert_eq!((markers(figure, BLUE), crosses(figure, BLUE)), (11, 16), "{name}");
        assert!(figure.svg().contains(">ball without contact<"), "{name}");
        assert!(!parse(figure).descendants().any(|n| n.attribute("d").is_some_and(|d| d.ends_with('Z'))), "{name}");
    }
    assert_eq!(crosses(named(&figures, "orbital-speed"), BLUE), 8);
    // The slide-to-roll ratio of −2 of balls at rest does not set the scale.
    assert!(named(&figures, "slide-to-roll").svg().contains("10⁻³"));
    // Over degrees the line ends at the last loaded ball before the gap.
    let ends = lines(named(&figures, "longitudinal-traction"), BLUE);
    let long = ends.iter().filter(|line| line.len() > 2).map(|line| line[line.len() - 1][0] - line[0][0]);
    assert!(long.clone().count() >= 2 && long.fold(0.0, f64::max) < 100.0, "{ends:?}");
}

#[test]
fn limit_a_ball_between_two_without_contact_is_a_marker_and_no_line() {
    let mut alone = partly_loaded();
    alone.balls.iter_mut().skip(1).for_each(unload);
    let figures = solution_figures(&[("this case", &alone)], &[]).unwrap();
    let loads = named(&figures, "contact-loads");
    assert_eq!((markers(loads, BLUE), crosses(loads, BLUE)), (3, 24));
    // None but the sample in the legend.
    assert_eq!(lines(loads, BLUE).len(), 1);
    alone.balls[0] = ball(0.0, 0.0, 0.0);
    unload(&mut alone.balls[0]);
    let none = solution_figures(&[("this case", &alone)], &[]).unwrap();
    assert_eq!(crosses(named(&none, "contact-loads"), BLUE), 26);
}

#[test]
fn identity_signed_quantities_are_over_degrees_and_magnitudes_on_circles() {
    for figure in figures() {
        let signed = ["longitudinal-traction", "slide-to-roll", "cage-force"].contains(&figure.name.as_str());
        assert_eq!(figure.svg().contains("Azimuth (°)"), signed, "{}", figure.name);
        assert_eq!(figure.svg().contains(">270°<"), !signed, "{}", figure.name);
    }
}

#[test]
fn limit_wear_that_is_zero_has_zero_alone_on_its_axis() {
    let mut none = solution(Model::Traction, 1.0, 1.0);
    for ball in &mut none.balls {
        ball.pocket.as_mut().unwrap().wear_rate_m3_s = 0.0;
        for side in Side::BOTH {
            friction(&mut ball.contacts[side]).wear_rate_m3_s = 0.0;
        }
    }
    let figures = solution_figures(&[("this case", &none)], &[]).unwrap();
    let wear = named(&figures, "wear-rates");
    let texts = crate::texts(wear);
    assert!(texts.contains("0") && texts.contains("Wear rate (m³/s)"), "{texts:?}");
    assert!(!["1", "−1", "0.5", "1.0", "−1.0"].iter().any(|label| texts.contains(*label)), "{texts:?}");
    assert_eq!(markers(wear, BLUE), 40);
}

#[test]
fn identity_orbits_have_no_curve_where_samples_have_no_value() {
    let phi: Vec<f64> = (0..3600).map(|k| 0.002 * f64::from(k)).collect();
    let load: Vec<Option<f64>> = phi.iter().map(|p| Some(3.0 + 9.0 * p.cos()).filter(|q| *q > 3.0)).collect();
    let samples = [OrbitSamples { label: "ball 0", azimuth_rad: &phi, values: &load }];
    let figure = orbit_figure("o", "Load", Axis::new("Load", "kN"), &samples).unwrap();
    assert!(figure.svg().contains(">no contact<") && figure.svg().contains(">270°<"));
    let curve = lines(&figure, BLUE).into_iter().max_by_key(Vec::len).unwrap();
    // From −90° to 90°: the rim's centre lies half-way between the ends, and nothing left of it.
    let [first, last] = [curve[0], curve[curve.len() - 1]];
    let leftmost = curve.iter().fold(f64::INFINITY, |least, p| least.min(p[0]));
    assert!((first[1] - last[1]).abs() > 30.0 && leftmost > 0.5 * (first[0] + last[0]) - 1.0, "{first:?} {last:?}");
    let signed: Vec<Option<f64>> = phi.iter().map(|p| Some(p.cos())).collect();
    let samples = [OrbitSamples { label: "ball 0", azimuth_rad: &phi, values: &signed }];
    let figure = orbit_figure("o", "Traction", Axis::new("Force", "N"), &samples).unwrap();
    assert!(figure.svg().contains("Azimuth (°)"));
}
