//! Figures of a sweep, from the rows of its table: curves over one swept value, maps over two.

use crate::drawn::{self, Plan, plan};
use crate::failure::Failure;
use std::collections::BTreeMap;
use std::path::Path;
use tribodyn_plot::{Abscissas, Axis, Cell as MapCell, Figure, LineChart, MapAxis, MapChart, Panel, Series};
use tribodyn_study::StagedFiles;
use tribodyn_study::sweep::{AxisSummary, CONVERGED, Cell, Column, Grid, Kind, Rows};

/// Revolutions per minute in one rad/s.
const RPM: f64 = 30.0 / std::f64::consts::PI;

const PLANS: [Plan; 15] = [
    plan("cage-speed", "Cage speed", ("Cage speed", "r/min", 1.0), &[("mean of the balls", "cage_speed_rpm")]),
    plan(
        "orbital-speeds",
        "Orbital speeds of the balls",
        ("Orbital speed", "r/min", RPM),
        &[("slowest ball", "orbital_speed_min_rad_s"), ("fastest ball", "orbital_speed_max_rad_s")],
    ),
    plan(
        "ring-displacement",
        "Displacement of the inner ring",
        ("Displacement", "µm", 1e6),
        &[("x", "ring_displacement_x_m"), ("y", "ring_displacement_y_m"), ("z, axial", "ring_displacement_z_m")],
    ),
    plan(
        "ring-tilt",
        "Tilt of the inner ring",
        ("Tilt", "mrad", 1e3),
        &[("about x", "ring_tilt_x_rad"), ("about y", "ring_tilt_y_rad")],
    ),
    plan("shaft-torque", "Shaft torque", ("Torque", "N m", 1.0), &[("shaft", "shaft_torque_nm")]),
    plan(
        "power-losses",
        "Power losses",
        ("Power", "W", 1.0),
        &[
            ("inner contacts", "power_loss_inner_w"),
            ("outer contacts", "power_loss_outer_w"),
            ("drag and churning", "power_loss_fluid_w"),
        ],
    ),
    plan(
        "contact-loads",
        "Contact loads",
        ("Contact load", "kN", 1e-3),
        &[
            ("inner, largest", "load_inner_max_n"),
            ("inner, smallest", "load_inner_min_n"),
            ("outer, largest", "load_outer_max_n"),
            ("outer, smallest", "load_outer_min_n"),
        ],
    ),
    plan(
        "peak-pressures",
        "Highest peak pressures",
        ("Peak pressure", "GPa", 1e-9),
        &[("inner", "peak_pressure_inner_max_pa"), ("outer", "peak_pressure_outer_max_pa")],
    ),
    plan(
        "contact-angles",
        "Contact angles",
        ("Contact angle", "°", 1.0),
        &[
            ("inner, largest", "contact_angle_inner_max_deg"),
            ("inner, smallest", "contact_angle_inner_min_deg"),
            ("outer, largest", "contact_angle_outer_max_deg"),
            ("outer, smallest", "contact_angle_outer_min_deg"),
        ],
    ),
    plan(
        "slide-to-roll",
        "Largest longitudinal slide-to-roll ratios",
        ("Slide-to-roll ratio", "", 1.0),
        &[("inner", "slide_to_roll_inner_max"), ("outer", "slide_to_roll_outer_max")],
    ),
    plan(
        "spin-ratios",
        "Largest spin ratios",
        ("Spin ratio", "1/m", 1.0),
        &[("inner", "spin_ratio_inner_max_per_m"), ("outer", "spin_ratio_outer_max_per_m")],
    ),
    plan(
        "wear-rates",
        "Wear rates",
        ("Wear rate", "m³/s", 1.0),
        &[
            ("inner race", "wear_rate_inner_m3_s"),
            ("outer race", "wear_rate_outer_m3_s"),
            ("cage pockets", "wear_rate_cage_m3_s"),
        ],
    ),
    plan("cage-force", "Largest pocket force", ("Pocket force", "N", 1.0), &[("largest", "pocket_force_max_n")]),
    plan(
        "ring-load",
        "Force of the inner ring on the balls",
        ("Force", "kN", 1e-3),
        &[("x", "ring_load_x_n"), ("y", "ring_load_y_n"), ("z, axial", "ring_load_z_n")],
    ),
    plan(
        "balls-in-contact",
        "Balls in contact with the inner race",
        ("Balls", "", 1.0),
        &[("inner race", "balls_in_contact")],
    ),
];

/// Name in the legend of rows without a solution.
const UNSOLVED: &str = "no solution";
/// Most points on a line that are marked one by one.
const MARKED: usize = 60;
/// Most cells of a map: beyond it an SVG is slow to open.
const MAX_CELLS: usize = 40_000;
/// Most names on an axis, and most characters of one.
const NAMES: [usize; 2] = [40, 24];

/// Refuses a sweep that has no figures: nothing is swept, more than two values, or too many.
pub fn check(grid: &Grid) -> Result<(), Failure> {
    let axes = grid.summary();
    let named = |a: &AxisSummary| format!("{} ({} values)", a.column, a.values);
    let swept = axes.iter().map(named).collect::<Vec<_>>().join(", ");
    let refuse = |why: String| Err(Failure::NoFigures { why });
    match axes.len() {
        0 => refuse("nothing is swept; give one --set or two a list of values".to_owned()),
        1 | 2 => {
            if let [a, b] = &axes[..]
                && a.values * b.values > MAX_CELLS
            {
                return refuse(format!("a map has at most {MAX_CELLS} cells, and this one is over {swept}"));
            }
            let long = grid.columns().zip(&axes).find(|(c, a)| c.kind != Kind::Number && a.values > NAMES[0]);
            match long {
                Some((column, _)) => refuse(format!("an axis has at most {} names: {}", NAMES[0], column.name)),
                None => Ok(()),
            }
        }
        count => refuse(format!(
            "figures are over one swept value or two, and {count} are swept: {swept}; give all but two a single value"
        )),
    }
}

/// Values of the columns that are drawn, by the places of their row on the swept axes.
struct Answers {
    rows: BTreeMap<Vec<usize>, Answer>,
}

/// Result of one row of the table.
struct Answer {
    solved: bool,
    /// By plan and line.
    values: Vec<Vec<Option<f64>>>,
}

/// A swept axis with its different values in order.
struct Swept {
    label: String,
    unit: String,
    /// Ascending, as far as they are numbers.
    cells: Vec<Cell>,
}

impl Swept {
    fn new(column: &Column, mut cells: Vec<Cell>) -> Self {
        let (label, unit) = column.name.strip_suffix(']').and_then(|name| name.split_once(" [")).unzip();
        cells.sort_by(|a, b| match (a, b) {
            (Cell::Number(a), Cell::Number(b)) => a.total_cmp(b),
            // Names stay in the order in which they were given.
            _ => std::cmp::Ordering::Equal,
        });
        let mut different: Vec<Cell> = Vec::new();
        cells.into_iter().for_each(|cell| {
            if !different.contains(&cell) {
                different.push(cell);
            }
        });
        let unit = match unit.unwrap_or("") {
            "um" => "µm".to_owned(),
            "deg" => "°".to_owned(),
            "rpm" => "r/min".to_owned(),
            "degC" => "°C".to_owned(),
            "Nm" => "N m".to_owned(),
            other => other.replace("_per_", "/").replace("um", "µm").replace('_', " "),
        };
        Self { label: label.unwrap_or(&column.name).to_owned(), unit, cells: different }
    }

    fn axis(&self) -> Axis {
        Axis::new(self.label.clone(), self.unit.clone())
    }

    /// The values, if all are numbers.
    fn numbers(&self) -> Option<Vec<f64>> {
        let number = |cell: &Cell| if let Cell::Number(v) = cell { Some(*v) } else { None };
        self.cells.iter().map(number).collect()
    }

    /// True if the ratio of neighbours is the same, as of `1..100 log 21`.
    fn logarithmic(&self) -> bool {
        let Some(at) = self.numbers().filter(|at| at.len() > 2 && at[0] > 0.0) else { return false };
        let steps: Vec<f64> = at.windows(2).map(|pair| (pair[1] / pair[0]).ln()).collect();
        steps.iter().all(|step| (step - steps[0]).abs() <= 1e-6 * steps[0])
    }

    fn names(&self) -> Vec<String> {
        let name = |cell: &Cell| match cell {
            Cell::Text(text) if text.chars().count() > NAMES[1] => {
                text.chars().take(NAMES[1] - 1).chain(['…']).collect::<String>()
            }
            Cell::Text(text) => text.clone(),
            Cell::Truth(truth) => truth.to_string(),
            Cell::Number(number) => number.to_string(),
            Cell::Integer(number) => number.to_string(),
            Cell::Null => String::new(),
        };
        self.cells.iter().map(name).collect()
    }

    fn map_axis(&self) -> MapAxis {
        match self.numbers() {
            Some(at) => MapAxis { log: self.logarithmic(), ..MapAxis::numbers(self.axis(), at) },
            None => MapAxis::names(self.axis(), self.names()),
        }
    }
}

impl Answers {
    fn read(rows: &Rows, swept: &[Swept]) -> Result<Self, Failure> {
        let place = |name: &str| rows.columns.iter().position(|column| column.name == name);
        let lines = |plan: &Plan| plan.lines.iter().map(|(_, column)| place(column)).collect::<Vec<_>>();
        let places: Vec<Vec<Option<usize>>> = PLANS.iter().map(lines).collect();
        let converged = place(CONVERGED);
        let mut all = BTreeMap::new();
        rows.each(|_, cells| {
            let at = |(axis, cell): (&Swept, &Cell)| axis.cells.iter().position(|known| known == cell);
            // The first column is the number of the row, then come the swept values.
            let Some(key) = swept.iter().zip(&cells[1..]).map(at).collect::<Option<Vec<usize>>>() else {
                return Ok(());
            };
            let value = |place: &Option<usize>, factor: f64| match place.map(|at| &cells[at]) {
                Some(Cell::Number(v)) if v.is_finite() => Some(factor * v),
                Some(Cell::Integer(n)) => Some(factor * *n as f64),
                _ => None,
            };
            let of =
                |(plan, places): (&Plan, &Vec<Option<usize>>)| places.iter().map(|p| value(p, plan.axis.2)).collect();
            let values = PLANS.iter().zip(&places).map(of).collect();
            let solved = converged.is_some_and(|at| cells[at] == Cell::Truth(true));
            all.insert(key, Answer { solved, values });
            Ok::<_, Failure>(())
        })?;
        Ok(Self { rows: all })
    }

    /// A curve for each line over the swept value.
    fn curves(&self, number: usize, swept: &Swept) -> Vec<Panel> {
        let plan = &PLANS[number];
        let at = swept.numbers().unwrap_or_else(|| (0..swept.cells.len()).map(|k| k as f64).collect());
        let unsolved: Vec<f64> = self.rows.iter().filter(|(_, row)| !row.solved).map(|(key, _)| at[key[0]]).collect();
        let curve = |(line, (label, _)): (usize, &(&str, &str))| {
            let found = |(key, row): (&Vec<usize>, &Answer)| Some((at[key[0]], row.values[number][line]?));
            let points: Vec<(f64, f64)> = self.rows.iter().filter_map(found).collect();
            let many = points.len() > MARKED;
            let curve = if many { Series::line(*label, points) } else { Series::marked(*label, points) };
            curve.without(UNSOLVED, unsolved.clone())
        };
        let (label, unit, _) = plan.axis;
        let series: Vec<Series> = plan.lines.iter().enumerate().map(curve).collect();
        let chart = LineChart::new("", swept.axis(), Axis::new(label, unit), series);
        let abscissas = match swept.numbers() {
            Some(_) => Abscissas::Numbers,
            None => Abscissas::Names(swept.names()),
        };
        vec![Panel::Cartesian(LineChart { log_x: swept.logarithmic(), abscissas, area_px: [500.0, 300.0], ..chart })]
    }

    /// A map for each line, the first swept value upwards.
    fn maps(&self, number: usize, y: &Swept, x: &Swept) -> Vec<Panel> {
        let plan = &PLANS[number];
        let (label, unit, _) = plan.axis;
        let cell = |line: usize, key: Vec<usize>| match self.rows.get(&key) {
            None => MapCell::Unknown,
            Some(row) => row.values[number][line].filter(|_| row.solved).map_or(MapCell::Absent, MapCell::Value),
        };
        let map = |(line, (heading, _)): (usize, &(&str, &str))| {
            let keys = (0..y.cells.len()).flat_map(|row| (0..x.cells.len()).map(move |column| vec![row, column]));
            let cells = keys.map(|key| cell(line, key)).collect();
            let title = if plan.lines.len() > 1 { *heading } else { "" };
            let chart = MapChart::new(title, x.map_axis(), y.map_axis(), Axis::new(label, unit), cells);
            Panel::Map(MapChart { absent: UNSOLVED.to_owned(), ..chart })
        };
        plan.lines.iter().enumerate().map(map).collect()
    }
}

fn no_axis() -> Failure {
    Failure::NoFigures { why: "nothing is swept".to_owned() }
}

/// Draws all figures of the rows into files that get their names when they are published.
pub fn stage(folder: &Path, force: bool, grid: &Grid, rows: &Rows) -> Result<StagedFiles, Failure> {
    let swept: Vec<Swept> = grid.columns().zip(grid.axis_cells()).map(|(c, cells)| Swept::new(&c, cells)).collect();
    let answers = Answers::read(rows, &swept)?;
    let mut staged = StagedFiles::new(folder, force)?;
    for (number, plan) in PLANS.iter().enumerate() {
        let panels = match &swept[..] {
            [axis] => answers.curves(number, axis),
            [first, second] => answers.maps(number, first, second),
            _ => return Err(check(grid).err().unwrap_or_else(no_axis)),
        };
        let columns = if panels.len() > 3 { 2 } else { panels.len() };
        let figure = Figure::in_columns(plan.name, plan.title, columns, &panels)?;
        drawn::stage(&mut staged, &figure)?;
    }
    Ok(staged)
}
