//! Figures of synthetic solutions, read back as SVG and as bitmaps.

mod balls;
mod published;
mod ranges;
mod run;
mod synthetic;
mod synthetic_run;

use std::collections::BTreeSet;

use resvg::usvg;
use tribodyn_plot::{Axis, Figure, LineChart, Panel, PlotError, PolarChart, Published, Series, solution_figures};
use tribodyn_quasistatic::Model;

use synthetic::{figures, solution, table_5, traction_curve_and_convergence};

fn parse(figure: &Figure) -> usvg::roxmltree::Document<'_> {
    usvg::roxmltree::Document::parse(figure.svg()).expect("well-formed XML")
}

/// Visible texts of a figure.
fn texts(figure: &Figure) -> BTreeSet<String> {
    let document = parse(figure);
    let shown = document.descendants().filter(|n| n.has_tag_name("text"));
    shown.filter_map(|n| n.text().map(str::to_owned)).collect()
}

/// Figures of signed quantities.
const SIGNED: [&str; 3] = ["longitudinal-traction", "slide-to-roll", "cage-force"];

#[test]
fn identity_every_figure_is_a_drawable_svg_with_its_title_axes_and_legend() {
    let figures = figures();
    let names: Vec<_> = figures.iter().map(|f| f.name.as_str()).collect();
    let expected = [
        "contact-angles",
        "contact-loads",
        "elastic-approaches",
        "peak-pressures",
        "longitudinal-traction",
        "slide-to-roll",
        "wear-rates",
        "orbital-speed",
        "cage-force",
        "power-losses",
    ];
    assert_eq!(names, expected);
    for figure in &figures {
        usvg::Tree::from_str(figure.svg(), &usvg::Options::default()).expect("an SVG that usvg reads");
        let texts = texts(figure);
        let azimuths = if SIGNED.contains(&figure.name.as_str()) {
            ["0", "60", "180", "360", "Azimuth (°)"]
        } else {
            ["0°", "30°", "90°", "180°", "270°"]
        };
        for label in ["Case 1", "Case 2", "Case 3", "Case 4", &figure.title].into_iter().chain(azimuths) {
            assert!(texts.contains(label), "{}: {label}", figure.name);
        }
        assert!(!figure.svg().contains("NaN") && !figure.svg().contains("inf"), "{}", figure.name);
        assert!(!texts.iter().any(|t| t.starts_with('-')), "{}: a hyphen for a minus", figure.name);
    }
}

#[test]
fn identity_axes_name_quantity_power_of_ten_and_unit() {
    let figures = figures();
    let wanted = [
        ("contact-loads", "Contact load (kN)"),
        ("peak-pressures", "Peak pressure (GPa)"),
        ("peak-pressures", "Published (Table 5)"),
        ("slide-to-roll", "Slide-to-roll ratio (10⁻³)"),
        ("wear-rates", "Wear rate (10⁻¹² m³/s)"),
        ("wear-rates", "(c) Cage pocket"),
        ("orbital-speed", "Orbital speed (r/min)"),
        ("slide-to-roll", "−2"),
    ];
    for (name, label) in wanted {
        let figure = figures.iter().find(|f| f.name == name).expect("a figure of that name");
        assert!(texts(figure).contains(label), "{name}: {label} not among {:?}", texts(figure));
    }
}

#[test]
fn identity_the_same_data_give_the_same_bytes() {
    let (first, second) = (figures(), figures());
    assert_eq!(first, second);
    assert_eq!(first[3].png(640).unwrap(), second[3].png(640).unwrap());
}

#[test]
fn identity_curves_over_the_azimuth_are_closed() {
    let figures = figures();
    for figure in figures.iter().filter(|figure| !SIGNED.contains(&figure.name.as_str())) {
        let document = parse(figure);
        let paths: Vec<_> =
            document.descendants().filter_map(|n| n.attribute("d")).filter(|d| d.ends_with('Z')).collect();
        assert!(paths.len() >= 4, "{}", figure.name);
        for d in paths {
            let points: Vec<&str> = d.trim_start_matches('M').trim_end_matches(" Z").split(" L").collect();
            assert!(points.len() > 180, "{}", figure.name);
            assert_eq!(points.first(), points.last(), "{}", figure.name);
        }
    }
}

#[test]
fn limit_jones_harris_runs_appear_only_where_the_model_says_something() {
    let figures = figures();
    let shows = |name: &str| texts(figures.iter().find(|f| f.name == name).unwrap()).contains("Jones–Harris");
    assert!(shows("contact-angles") && shows("orbital-speed"));
    assert!(!shows("longitudinal-traction") && !shows("wear-rates") && !shows("power-losses"));
    let alone = solution(Model::JonesHarris, 0.0, 0.0);
    let names: Vec<_> = solution_figures(&[("JH", &alone)], &[]).unwrap().into_iter().map(|f| f.name).collect();
    assert_eq!(names, ["contact-angles", "contact-loads", "elastic-approaches", "peak-pressures", "orbital-speed"]);
}

#[test]
fn identity_a_run_that_did_not_converge_says_so_and_keeps_its_published_points() {
    let mut run = solution(Model::Traction, 1.0, 1.0);
    run.converged = false;
    let published: Vec<_> = table_5().into_iter().map(|p| Published { run: Some("Case 1".into()), ..p }).collect();
    let figures = solution_figures(&[("Case 1", &run)], &published).unwrap();
    let pressures = figures.iter().find(|f| f.name == "peak-pressures").unwrap();
    assert!(texts(pressures).contains("Case 1 (not converged)"));
    let document = parse(pressures);
    let open = document.descendants().filter(|n| n.attribute("fill") == Some("#FFFFFF") && n.has_tag_name("polygon"));
    let colours: BTreeSet<_> = open.filter_map(|n| n.attribute("stroke")).collect();
    assert_eq!(colours, BTreeSet::from(["#0072B2"]));
}

/// Width and height in the header of a PNG.
fn png_size(bytes: &[u8]) -> [u32; 2] {
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    [16, 20].map(|at| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()))
}

#[test]
fn identity_bitmaps_have_the_width_asked_for_and_show_the_text() {
    let figure = traction_curve_and_convergence();
    let document = parse(&figure);
    let size = |name: &str| document.root_element().attribute(name).unwrap().parse::<f64>().unwrap();
    let [width, height] = png_size(&figure.png(1200).unwrap());
    assert_eq!(width, 1200);
    assert!((f64::from(height) / 1200.0 - size("height") / size("width")).abs() < 1e-3);
    // Without its text the same figure is a different picture: the font is found without one in the system.
    let one = |title: &str| {
        let chart = LineChart::new(
            title,
            Axis::new("x", ""),
            Axis::new("y", ""),
            vec![Series::line("s", vec![(0.0, 0.0), (1.0, 1.0)])],
        );
        Figure::new("f", "F", &[Panel::Cartesian(chart)]).unwrap().png(600).unwrap()
    };
    assert_ne!(one("m"), one("n"));
    assert!(matches!(figure.png(0), Err(PlotError::BitmapSize { width_px: 0, .. })));
    assert!(matches!(figure.png(u32::MAX), Err(PlotError::BitmapSize { .. })));
}

#[test]
fn identity_texts_neither_overlap_nor_leave_the_figure() {
    let mut all = figures();
    all.push(traction_curve_and_convergence());
    all.push(published::both());
    all.extend(synthetic_run::run_figures());
    all.extend(balls::partly_loaded_figures());
    all.extend(ranges::all());
    let mut options = usvg::Options { font_family: "DejaVu Sans".into(), ..usvg::Options::default() };
    let fonts = options.fontdb_mut();
    fonts.load_font_data(include_bytes!("../../assets/DejaVuSans-subset.ttf").to_vec());
    fonts.load_font_data(include_bytes!("../../assets/DejaVuSans-Bold-subset.ttf").to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    for figure in &all {
        let tree = usvg::Tree::from_str(figure.svg(), &options).unwrap();
        let mut boxes: Vec<(String, usvg::Rect)> = Vec::new();
        for node in tree.root().children() {
            if let usvg::Node::Text(text) = node {
                let label: String = text.chunks().iter().map(|chunk| chunk.text()).collect();
                boxes.push((label, text.abs_bounding_box()));
            }
        }
        assert!(boxes.len() > 4, "{}", figure.name);
        for (i, (label, rect)) in boxes.iter().enumerate() {
            let size = tree.size();
            let inside = rect.left() >= 0.0
                && rect.top() >= 0.0
                && rect.right() <= size.width()
                && rect.bottom() <= size.height();
            assert!(inside, "{}: {label} at {rect:?} leaves the figure", figure.name);
            for (other, rect_2) in &boxes[..i] {
                let apart = rect.left() >= rect_2.right()
                    || rect_2.left() >= rect.right()
                    || rect.top() >= rect_2.bottom()
                    || rect_2.top() >= rect.bottom();
                assert!(apart, "{}: {label:?} {rect:?} over {other:?} {rect_2:?}", figure.name);
            }
        }
    }
}

#[test]
fn limit_bad_input_is_refused_with_its_place() {
    assert!(matches!(solution_figures(&[], &[]), Err(PlotError::NoRun)));
    let good = solution(Model::Traction, 1.0, 1.0);
    assert!(matches!(solution_figures(&[("a", &good), ("a", &good)], &[]), Err(PlotError::DuplicateLabel { .. })));
    let foreign = [Published { run: Some("Case 9".into()), ..table_5().remove(0) }];
    assert!(matches!(solution_figures(&[("a", &good)], &foreign), Err(PlotError::UnknownRun { .. })));
    let no_points = [Published { points: Vec::new(), ..table_5().remove(0) }];
    assert!(matches!(solution_figures(&[("a", &good)], &no_points), Err(PlotError::EmptySeries { .. })));

    let mut bad = good.clone();
    bad.balls[4].contacts.inner.load_n = f64::NAN;
    let error = solution_figures(&[("a", &bad)], &[]).unwrap_err();
    assert!(matches!(&error, PlotError::NotFinite { series, index: 4, .. } if series == "a"), "{error}");
    bad.balls.clear();
    assert!(matches!(solution_figures(&[("a", &bad)], &[]), Err(PlotError::NoBalls { .. })));
}

#[test]
fn limit_bad_panels_are_refused_with_their_place() {
    let polar = |series| [Panel::Polar(PolarChart::new("t", Axis::new("v", ""), series))];
    assert!(matches!(Figure::new("f", "F", &[]), Err(PlotError::NoPanel { .. })));
    assert!(matches!(Figure::new("f", "F", &polar(Vec::new())), Err(PlotError::NoSeries { .. })));
    for value in [f64::INFINITY, f64::NAN, -1e200] {
        let endless = [Series::line("s", vec![(0.0, 1.0), (90.0, value)])];
        let error = Figure::new("f", "F", &polar(endless.to_vec())).unwrap_err();
        assert!(matches!(error, PlotError::NotFinite { index: 1, .. }), "{error}");
    }
    let unbounded = Axis::new("x", "").covering(0.0, f64::INFINITY);
    let chart = LineChart::new("t", unbounded, Axis::new("y", ""), vec![Series::line("s", vec![(0.0, 1.0)])]);
    assert!(matches!(Figure::new("f", "F", &[Panel::Cartesian(chart)]), Err(PlotError::NotFinite { .. })));
}
