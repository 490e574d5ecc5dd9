//! `tribodyn pair`: two like bearings on one rigid shaft, preloaded against each other.

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::search::{Search, TimeArguments};
use crate::solve::ModelName;
use crate::table::{self, number};
use crate::units::in_unit;
use tribodyn::answers::{Equations, PairSetting, pair};
use tribodyn::pair::{Arrangement, PairBearing, PairSolution, Preload};

/// Two bearings of a case on one rigid shaft: loads, preload, stiffness. The loads of the case act on the shaft, in the
/// middle between the bearings.
#[derive(clap::Args)]
#[command(group = clap::ArgGroup::new("pressed").required(true).args(["offset", "spring"]))]
#[command(after_help = "Examples:
  tribodyn pair 7210B.ron --arrangement db --distance 20 --offset 10
  tribodyn pair 7210B.ron --arrangement df --distance 20 --spring 300 --json")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Arrangement of the two bearings
    #[arg(long, value_enum, ignore_case = true)]
    arrangement: ArrangementName,
    /// Distance between the middles of the bearings, mm
    #[arg(long, value_name = "MM", value_parser = in_unit("mm"))]
    distance: f64,
    /// Axial gap between the rings that clamping closes, µm
    #[arg(long, value_name = "UM", allow_hyphen_values = true, value_parser = in_unit("um"))]
    offset: Option<f64>,
    /// Force of a soft spring on the bearing at +z, whose outer ring slides, N
    #[arg(long, value_name = "N", value_parser = in_unit("N"))]
    spring: Option<f64>,
    /// Equations of each bearing [default: steady-orbit, or jones-harris for a case without traction or cage]
    #[arg(long, value_enum)]
    model: Option<ModelName>,
    #[command(flatten)]
    time: TimeArguments,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum ArrangementName {
    /// Back to back: stiff against tilting
    Db,
    /// Face to face: tolerates misalignment
    Df,
    /// Tandem: both carry the axial load
    Dt,
}

impl From<ArrangementName> for Arrangement {
    fn from(name: ArrangementName) -> Self {
        match name {
            ArrangementName::Db => Self::BackToBack,
            ArrangementName::Df => Self::FaceToFace,
            ArrangementName::Dt => Self::Tandem,
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let file = arguments.case.read()?;
    let setting = PairSetting {
        arrangement: arguments.arrangement.into(),
        distance: 1e-3 * allowed("distance", Some(arguments.distance), |mm| mm >= 0.0, "0 mm or more")?,
        preload: match arguments.spring {
            None => Preload::OffsetM(1e-6 * allowed("offset", arguments.offset, |_| true, "a finite number of µm")?),
            spring => Preload::SpringN(allowed("spring", spring, |n| n >= 0.0, "0 N or more")?),
        },
    };
    let equations = arguments.model.map_or_else(|| Equations::usual(&file.case), ModelName::equations);
    let search = Search::begin(&file, &arguments.time);
    let answer = pair(&file.question(search.watch()), equations, setting).map_err(|error| search.failed(error))?;
    drop(search);
    if arguments.json {
        return table::print_json(&answer);
    }
    table::print_head(&file.name, answer.findings())?;
    print(answer.value(), equations)?;
    table::print_warnings(answer.findings().warnings())
}

/// A finite number that a rule allows.
fn allowed(option: &'static str, value: Option<f64>, rule: impl Fn(f64) -> bool, text: &str) -> Result<f64, Failure> {
    let value = value.unwrap_or(f64::NAN);
    if value.is_finite() && rule(value) {
        return Ok(value);
    }
    Err(Failure::Option { option, value: value.to_string(), message: format!("allowed is {text}") })
}

fn print(s: &PairSolution, equations: Equations) -> Result<(), Failure> {
    let list = |values: &[f64], factor: f64, digits: usize| {
        values.iter().map(|v| number(v * factor, digits)).collect::<Vec<_>>().join("  ")
    };
    table::print_pairs(&[
        ("shaft displacement x y z", list(&s.shaft_displacement_m, 1e6, 3), "µm"),
        ("shaft tilt about x y", list(&s.shaft_tilt_rad, 1e3, 4), "mrad"),
        ("axial force within the pair", number(s.preload_n, 1), "N"),
        ("axial stiffness", number(s.stiffness[2][2] * 1e-6, 2), "N/µm"),
        ("radial stiffness along x y", list(&[s.stiffness[0][0], s.stiffness[1][1]], 1e-6, 2), "N/µm"),
        ("tilting stiffness about x y", list(&[s.stiffness[3][3], s.stiffness[4][4]], 1e-3, 3), "N m/mrad"),
        ("largest relative residual", format!("{:.1e}", s.residual), ""),
        ("each bearing by the model", equations.name().to_owned(), ""),
    ])?;
    table::print_line("")?;
    let header = ["bearing at mm", "F_x N", "F_y N", "F_z N", "M_x N m", "M_y N m", "Q_i N", "p_i GPa", "α_i °"];
    let row = |bearing: &PairBearing| {
        let [x, y, z] = bearing.load_n;
        let [mx, my] = bearing.moment_nm;
        let hardest = bearing.solution.balls.iter().map(|ball| ball.contacts.inner);
        let inner = hardest.max_by(|a, b| a.load_n.total_cmp(&b.load_n));
        let of = |value: Option<f64>, digits: usize| value.map_or_else(String::new, |v| number(v, digits));
        vec![
            number(bearing.position_m * 1e3, 1),
            number(x, 1),
            number(y, 1),
            number(z, 1),
            number(mx, 2),
            number(my, 2),
            of(inner.map(|c| c.load_n), 1),
            of(inner.map(|c| c.peak_pressure_pa * 1e-9), 3),
            of(inner.map(|c| c.angle_rad.to_degrees()), 2),
        ]
    };
    table::print_rows(&header, s.bearings.iter().map(row))
}
