//! Figures of runs: what is drawn, where, and what is refused.

use resvg::usvg;
use tribodyn_plot::{
    Axis, Figure, History, Mark, PlotError, Samples, SpectrumView, bars, orbit_polar, path_figure, spectrum_figure,
    stacked_bars, time_history,
};

use crate::synthetic_run::{crowded_spectrum, run_figures, spectra, times};
use crate::{parse, texts};

fn axis() -> Axis {
    Axis::new("Force", "N")
}

/// Paths of data: coordinates of the points of each.
fn paths(figure: &Figure, colour: &str) -> Vec<Vec<[f64; 2]>> {
    let document = parse(figure);
    let drawn = document.descendants().filter(|n| n.attribute("stroke") == Some(colour));
    let point = |text: &str| {
        let mut numbers = text.trim().split(' ').map(|n| n.parse::<f64>().expect("a number"));
        [numbers.next().expect("x"), numbers.next().expect("y")]
    };
    let split = |d: &str| d.trim_start_matches('M').trim_end_matches(" Z").split(" L").map(point).collect();
    drawn.filter_map(|n| n.attribute("d")).map(split).collect()
}

#[test]
fn identity_run_figures_are_drawable_and_the_same_every_time() {
    let (first, second) = (run_figures(), run_figures());
    assert_eq!(first, second);
    for figure in &first {
        usvg::Tree::from_str(figure.svg(), &usvg::Options::default()).expect("an SVG that usvg reads");
        assert!(!figure.svg().contains("NaN") && !figure.svg().contains("inf"), "{}", figure.name);
        assert!(figure.svg().len() < 500_000, "{}", figure.name);
        assert!(!figure.png(400).unwrap().is_empty());
    }
}

#[test]
fn identity_axes_of_runs_name_quantity_and_unit() {
    let wanted = [
        ("histories", "Time (ms)"),
        ("histories", "Speed (r/min)"),
        ("histories", "(c) Outer-ring acceleration"),
        ("spectrum", "Frequency (Hz)"),
        ("spectrum", "Amplitude (m/s²)"),
        ("orbit", "Contact load (kN)"),
        ("wear", "Wear rate (10⁻¹² m³/s)"),
        ("power-balance", "Power (W)"),
        ("power-balance", "53230"),
        ("power-balance", "Contact damping"),
        ("path", "x (µm)"),
    ];
    let figures = run_figures();
    for (name, label) in wanted {
        let figure = figures.iter().find(|f| f.name == name).expect("a figure of that name");
        assert!(texts(figure).contains(label), "{name}: {label} not among {:?}", texts(figure));
    }
}

/// One sample among a million, on an axis with 660 px.
#[test]
fn identity_a_single_sample_of_a_long_history_is_drawn() {
    let t = times(1_000_000, 1e6);
    let mut force = vec![0.0; t.len()];
    (force[612_345], force[100]) = (7.0, -3.0);
    let history = |y: &[f64]| {
        let samples = vec![Samples { label: "Ball 1", x: &t, y }];
        time_history("h", "H", &[History { title: "", quantity: axis().covering(-3.0, 7.0), samples }]).unwrap()
    };
    let drawn = &paths(&history(&force), "#0072B2")[0];
    assert!(drawn.len() < 6000, "{}", drawn.len());
    let extreme = |most: f64, sign: f64| drawn.iter().fold(most, |e, p| if sign * p[1] > sign * e { p[1] } else { e });
    let (lowest, highest) = (extreme(0.0, 1.0), extreme(1e9, -1.0));
    let zero = drawn[5000.min(drawn.len() - 1)][1];
    // Page coordinates grow downwards; 7 N up and 3 N down are in proportion.
    assert!(((zero - highest) / (lowest - zero) - 7.0 / 3.0).abs() < 0.01, "{highest} {zero} {lowest}");
}

#[test]
fn identity_marks_are_drawn_where_their_frequencies_are() {
    let figure = spectra(&SpectrumView::frequency());
    let peak = paths(&figure, "#0072B2")[0].iter().copied().fold([0.0, 1e9], |a, b| if b[1] < a[1] { b } else { a });
    let marks: Vec<f64> = paths(&figure, "#6E6E6E").iter().map(|line| line[0][0]).collect();
    assert_eq!(marks.len(), 7, "the one outside the axis is not drawn");
    let nearest = marks.iter().fold(f64::INFINITY, |least: f64, x| least.min((x - peak[0]).abs()));
    assert!(nearest < 0.3, "the highest line is at 13 f_c: {nearest} px");
    // The subscript is a run of its own.
    assert!(figure.svg().contains("13 f<tspan") && !figure.svg().contains("f_c"));
}

#[test]
fn identity_twenty_marks_in_a_row_all_have_labels() {
    let figure = crowded_spectrum();
    let labels = (1..=20).filter(|k| figure.svg().contains(&format!(">{k} f<tspan"))).count();
    assert_eq!(labels, 20);
}

#[test]
fn limit_logarithmic_spectra_end_at_their_decades() {
    let (x, y) = ([0.0, 1.0, 2.0, 3.0], [0.0, 1.0, 0.0, 1e-9]);
    let lines = [Samples { label: "s", x: &x, y: &y }];
    let view = SpectrumView::frequency().logarithmic(3);
    let figure = spectrum_figure("s", "S", axis(), &lines, &[], &view).unwrap();
    let drawn = paths(&figure, "#0072B2").into_iter().find(|p| p.len() == 3).expect("three lines: not that at 0 Hz");
    assert_eq!(drawn[1][1], drawn[2][1]);
    assert!(texts(&figure).contains("10⁻³") && !texts(&figure).contains("10⁻⁴"));
    let silent = [Samples { label: "s", x: &x, y: &[0.0; 4] }];
    assert!(matches!(spectrum_figure("s", "S", axis(), &silent, &[], &view), Err(PlotError::NotPositive { .. })));
    assert!(spectrum_figure("s", "S", axis(), &silent, &[], &SpectrumView::frequency()).is_ok());
}

#[test]
fn identity_values_over_the_orbit_close() {
    let phi: Vec<f64> = (0..1000).map(|k| 0.4 + 0.02 * f64::from(k)).collect();
    let y: Vec<f64> = phi.iter().map(|p| 3.0 + p.cos()).collect();
    let figure = orbit_polar("o", "O", axis(), &[Samples { label: "b", x: &phi, y: &y }]).unwrap();
    let curve = paths(&figure, "#0072B2").into_iter().max_by_key(Vec::len).expect("a curve");
    assert_eq!(curve.first(), curve.last());
    assert!(curve.len() > 180);
}

#[test]
fn limit_bad_plain_data_are_refused_with_their_place() {
    let (three, two, bad) = ([0.0, 1.0, 2.0], [0.0, 1.0], [0.0, f64::NAN, 2.0]);
    let of = |x, y| Samples { label: "s", x, y };
    let history = |samples| time_history("h", "H", &[History { title: "", quantity: axis(), samples }]);
    assert!(matches!(history(vec![of(&three, &two)]), Err(PlotError::Lengths { abscissas: 3, ordinates: 2, .. })));
    assert!(matches!(history(vec![of(&three, &bad)]), Err(PlotError::NotFinite { index: 1, .. })));
    assert!(matches!(history(vec![of(&bad, &three)]), Err(PlotError::NotFinite { index: 1, .. })));
    assert!(matches!(history(Vec::new()), Err(PlotError::NoSeries { .. })));
    assert!(matches!(time_history("h", "H", &[]), Err(PlotError::NoPanel { .. })));
    assert!(history(vec![of(&[1.0], &[1.0])]).is_ok());

    let polar = |samples: &[Samples]| orbit_polar("o", "O", axis(), samples);
    assert!(matches!(polar(&[of(&three, &bad)]), Err(PlotError::NotFinite { index: 1, .. })));
    assert!(matches!(polar(&[of(&[], &[])]), Err(PlotError::EmptySeries { .. })));
    assert!(matches!(path_figure("p", "P", axis(), axis(), &[]), Err(PlotError::NoSeries { .. })));

    let view = SpectrumView::frequency();
    let marks = [Mark::new(f64::NAN, "nowhere"), Mark::new(-1.0, "below")];
    let figure = spectrum_figure("s", "S", axis(), &[of(&three, &three)], &marks, &view).unwrap();
    assert!(!figure.svg().contains("nowhere") && !figure.svg().contains("below"));
    let logarithmic = spectrum_figure("s", "S", axis(), &[of(&three, &bad)], &[], &view.logarithmic(4));
    assert!(matches!(logarithmic, Err(PlotError::NotFinite { .. })));

    let too_many = [("a", vec![1.0, 2.0, 3.0])];
    assert!(matches!(bars("b", "B", axis(), &["g", "h"], &too_many), Err(PlotError::NoGroup { groups: 2, .. })));
    let infinite = [("a", vec![f64::INFINITY])];
    assert!(matches!(stacked_bars("b", "B", axis(), &["g"], &infinite), Err(PlotError::NotFinite { .. })));
}
