//! Axes of numbers that are all the same, nearly so, huge, tiny, negative, single or absent; and maps.

use crate::{parse, texts};
use resvg::usvg;
use tribodyn_plot::{
    Abscissas, Axis, Cell, Figure, LineChart, MapAxis, MapChart, Panel, PlotError, PolarChart, Series,
};

/// Values that are hard on an axis.
const HARD: [(&str, [f64; 3]); 10] = [
    ("zero", [0.0, 0.0, 0.0]),
    ("constant", [5855.0, 5855.0, 5855.0]),
    ("a little about much", [5855.0, 5855.001, 5855.02]),
    ("rounding about much", [1e9, 1e9 + 1e-6, 1e9]),
    ("huge", [1e140, 3e140, 2e140]),
    ("tiny", [1e-140, 3e-140, 2e-140]),
    ("below all that is drawn", [1e-300, 0.0, 2e-300]),
    ("negative", [-5.0, -3.0, -4.0]),
    ("constant and negative", [-7e-12, -7e-12, -7e-12]),
    ("about zero", [-1e-9, 2e-9, 0.0]),
];

fn line(values: &[f64; 3]) -> Panel {
    let points = values.iter().enumerate().map(|(k, v)| (1.0 + k as f64, *v)).collect();
    let chart = LineChart::new("over x", Axis::new("x", "mm"), Axis::new("y", "N"), vec![Series::marked("a", points)]);
    Panel::Cartesian(chart)
}

/// The same values on the abscissa.
fn turned(values: &[f64; 3]) -> Panel {
    let points = values.iter().enumerate().map(|(k, v)| (*v, 1.0 + k as f64)).collect();
    let chart = LineChart::new("over y", Axis::new("y", "N"), Axis::new("x", "mm"), vec![Series::marked("a", points)]);
    Panel::Cartesian(chart)
}

fn polar(values: &[f64; 3]) -> Option<Panel> {
    let points = values.iter().enumerate().map(|(k, v)| (120.0 * k as f64, *v)).collect();
    let chart = PolarChart::new("over φ", Axis::new("y", "N"), vec![Series::marked("a", points)]);
    values.iter().all(|v| *v >= 0.0).then_some(Panel::Polar(chart))
}

fn grid(count: usize, from: f64, step: f64) -> Vec<f64> {
    (0..count).map(|k| from + step * k as f64).collect()
}

fn map(cells: Vec<Cell>, columns: usize, rows: usize) -> MapChart {
    let x = MapAxis::numbers(Axis::new("ring.z.Force", "kN"), grid(columns, 10.0, 5.0));
    let y = MapAxis::numbers(Axis::new("ring.x.Force", "kN"), grid(rows, 1.0, 0.5));
    MapChart { absent: "no solution".into(), ..MapChart::new("", x, y, Axis::new("Cage speed", "r/min"), cells) }
}

/// A slope with a cell without solution and one of another shard.
fn slope() -> Vec<Cell> {
    let mut cells: Vec<Cell> =
        (0..30).map(|k| Cell::Value(5000.0 + 11.0 * f64::from(k % 6) + f64::from(k / 6))).collect();
    (cells[8], cells[29]) = (Cell::Absent, Cell::Unknown);
    cells
}

fn maps() -> Vec<Figure> {
    let one = |chart: MapChart| Figure::new("map", "A map", &[Panel::Map(chart)]).unwrap();
    let names = MapAxis::names(
        Axis::new("coatings.inner", ""),
        ["Library(\"ag\")", "Library(\"ptfe\")"].map(String::from).to_vec(),
    );
    let log = MapAxis { log: true, ..MapAxis::numbers(Axis::new("load", "N"), vec![0.7, 7.0, 70.0, 700.0]) };
    let cells = |count: u32| (0..count).map(|k| Cell::Value(f64::from(k * k))).collect::<Vec<_>>();
    let quantity = || Axis::new("q", "");
    vec![
        one(map(slope(), 6, 5)),
        one(map(vec![Cell::Value(0.0); 30], 6, 5)),
        one(map(vec![Cell::Absent; 2], 1, 2)),
        one(map(vec![Cell::Value(3.0)], 1, 1)),
        one(MapChart::new("", log.clone(), names.clone(), quantity(), cells(8))),
        one(MapChart::new("", names, log, quantity(), cells(8))),
    ]
}

pub fn all() -> Vec<Figure> {
    let mut figures: Vec<Figure> = HARD
        .iter()
        .map(|(name, values)| {
            let panels: Vec<Panel> =
                [Some(line(values)), Some(turned(values)), polar(values)].into_iter().flatten().collect();
            Figure::new(*name, *name, &panels).unwrap_or_else(|error| panic!("{name}: {error}"))
        })
        .collect();
    figures.extend(maps());
    figures
}

#[test]
fn limit_hard_ranges_have_finite_axes_with_labels_inside() {
    for figure in all() {
        usvg::Tree::from_str(figure.svg(), &usvg::Options::default()).expect("an SVG that usvg reads");
        assert!(!figure.svg().contains("NaN") && !figure.svg().contains("inf"), "{}", figure.name);
        let document = parse(&figure);
        let width: f64 = document.root_element().attribute("width").unwrap().parse().unwrap();
        let all = document.descendants().filter_map(|n| n.attribute("cx").or(n.attribute("x1")));
        for x in all.map(|x| x.parse::<f64>().unwrap()) {
            assert!((0.0..=width).contains(&x), "{}: {x} outside {width}", figure.name);
        }
    }
}

#[test]
fn limit_one_point_and_no_point() {
    let chart = |series| LineChart::new("c", Axis::new("x", "mm"), Axis::new("y", "N"), vec![series]);
    let one = chart(Series::marked("a", vec![(3.0, 4.0)]));
    assert!(Figure::new("f", "F", &[Panel::Cartesian(one)]).is_ok());
    let none = chart(Series::marked("a", Vec::new()));
    let error = Figure::new("f", "F", &[Panel::Cartesian(none)]).unwrap_err();
    assert!(matches!(error, PlotError::EmptySeries { .. }));
    let failed = chart(Series::marked("a", Vec::new()).without("no solution", vec![1.0, 2.0]));
    let figure = Figure::new("f", "F", &[Panel::Cartesian(failed)]).unwrap();
    assert!(texts(&figure).contains("no solution"));
    let named = LineChart {
        abscissas: Abscissas::Names(vec!["ag".into(), "ptfe".into()]),
        ..chart(Series::marked("a", vec![(0.0, 1.0), (1.0, 2.0)]))
    };
    let figure = Figure::new("f", "F", &[Panel::Cartesian(named)]).unwrap();
    assert!(texts(&figure).contains("ag") && texts(&figure).contains("ptfe"));
}

#[test]
fn identity_maps_show_every_cell_with_scale_unit_lines_and_what_has_no_value() {
    let figure = &maps()[0];
    let texts = texts(figure);
    for label in ["Cage speed (r/min)", "ring.z.Force (kN)", "ring.x.Force (kN)", "no solution", "5020", "5040"] {
        assert!(texts.contains(label), "{label} not among {texts:?}");
    }
    let document = parse(figure);
    let grey = document.descendants().filter(|n| n.has_tag_name("rect") && n.attribute("fill") == Some("#DCDCDC"));
    assert_eq!(grey.count(), 1);
    let lines = document.descendants().filter(|n| n.attribute("stroke-linecap") == Some("round")).count();
    assert!(lines >= 4 && lines % 2 == 0, "{lines} lines of equal value and casings");
    // Higher is lighter: the last column of the lowest row against the first.
    let cells: Vec<_> = document.descendants().filter(|n| n.has_tag_name("rect")).collect();
    assert!(cells.len() > 28, "{}", cells.len());
}

#[test]
fn limit_maps_that_cannot_be_drawn_are_refused_with_their_place() {
    let refused = |chart: MapChart| Figure::new("f", "F", &[Panel::Map(chart)]).unwrap_err();
    let few = refused(map(vec![Cell::Value(1.0); 5], 2, 3));
    assert!(matches!(few, PlotError::Cells { values: 5, columns: 2, rows: 3, .. }), "{few}");
    let nan = refused(map(vec![Cell::Value(1.0), Cell::Value(f64::NAN)], 2, 1));
    assert!(matches!(nan, PlotError::NotFinite { index: 1, .. }), "{nan}");
    let mut twice = map(vec![Cell::Value(1.0); 2], 2, 1);
    twice.x.at = vec![3.0, 3.0];
    assert!(matches!(refused(twice), PlotError::Order { index: 1, .. }));
    let mut zero = map(vec![Cell::Value(1.0); 2], 2, 1);
    (zero.x.at, zero.x.log) = (vec![0.0, 3.0], true);
    assert!(matches!(refused(zero), PlotError::NotPositive { value: 0.0, .. }));
}
