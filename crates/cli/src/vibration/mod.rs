//! `tribodyn vibration`: what a measured or recorded signal says of a bearing.

mod figures;

use crate::drawn;
use crate::failure::Failure;
use crate::input::{LimitArguments, ReplaceArguments};
use crate::table::{self, number};
use serde::Serialize;
use std::path::{Path, PathBuf};
use tribodyn::{CaseFile, Limits};
use tribodyn_catalogue::KnownBalls;
use tribodyn_signal::{Evidence, Fault, Kinematics, Search};
use tribodyn_study::vibration::{Analysis, SignalFile, Speed, Window, analysis, bearing_of_case, bearing_of_numbers};
use tribodyn_study::{StagedFiles, read_case};

/// Find the faults of a bearing in a vibration signal: the lines of its envelope spectrum, the speed of its cage, a
/// verdict with its reasons.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn vibration 105.mat --channel X105_DE_time --rate 12000 --bearing 9,7.94,39.04 --speed 1797
  tribodyn vibration motor.csv --rate 25600 --channel acceleration --bearing 6206 --speed speed_rpm -o figures
  tribodyn vibration run.mcap --from 0.2

A signal is searched for lines near those of pure rolling: within the uncertainty of the speed and the slip.")]
pub struct Arguments {
    /// Signal: numbers in columns (.csv, .txt, .tsv, .dat), .wav, .mat (level 5), .parquet, or a recorded run (.mcap)
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// The column to evaluate, by its name or number
    #[arg(long, value_name = "NAME")]
    channel: Option<String>,
    /// Sampling rate, Hz; WAV files, recordings and files with a column `time` say it themselves
    #[arg(long, value_name = "HZ")]
    rate: Option<f64>,
    /// The bearing: a case file, a designation such as 6205, or balls,ball mm,pitch mm[,angle °] such as 9,7.94,39.04
    #[arg(long, value_name = "BEARING")]
    bearing: Option<String>,
    /// Nominal contact angle of an angular-contact designation, degrees
    #[arg(long, value_name = "DEG")]
    angle: Option<f64>,
    /// Speed of the shaft: r/min, or the column that holds it
    #[arg(long, value_name = "RPM|COLUMN")]
    speed: Option<String>,
    /// Column with the pulses of a key phase or tachometer
    #[arg(long, value_name = "COLUMN", conflicts_with = "speed")]
    key_phase: Option<String>,
    /// Pulses of the key phase in a turn
    #[arg(long, value_name = "N", default_value_t = 1.0, requires = "key_phase")]
    pulses: f64,
    /// Begin at this time, s
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    from: Option<f64>,
    /// End at this time, s
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    to: Option<f64>,
    /// How far the true speed may lie from the one given in r/min, %
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0 * Search::default().speed)]
    speed_tolerance: f64,
    /// How far slip and contact angle may move the cage from pure rolling, %
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0 * Search::default().slip)]
    slip: f64,
    /// Folder for vibration.json and the figures (SVG and PNG)
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    limits: LimitArguments,
    /// Print JSON, and nothing else, to standard output
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer<'a> {
    generator: String,
    file: &'a Path,
    #[serde(flatten)]
    analysis: &'a Analysis,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let limits = arguments.limits.limits();
    let search =
        Search { speed: share("speed-tolerance", arguments.speed_tolerance)?, slip: share("slip", arguments.slip)? };
    let file = SignalFile::read(&arguments.file, &limits)?;
    let (bearing, case_hz) = bearing(arguments, &file, &limits)?;
    let speed = speed(arguments, &file, case_hz)?;
    let window = Window { from_s: arguments.from, to_s: arguments.to };
    let signal = (arguments.channel.as_deref(), arguments.rate);
    let found = analysis(&arguments.file, &file, signal, window, &speed, &bearing, search)?;
    let generator = format!("tribodyn {}", env!("CARGO_PKG_VERSION"));
    let answer = Answer { generator, file: &arguments.file, analysis: &found };
    if let Some(folder) = &arguments.output {
        let mut staged = StagedFiles::new(folder, arguments.replace.force)?;
        staged
            .write("vibration.json".to_owned(), format!("{}\n", serde_json::to_string_pretty(&answer)?).as_bytes())?;
        figures::of(&found)?.iter().try_for_each(|figure| drawn::stage(&mut staged, figure))?;
        staged.publish()?;
    }
    if arguments.json {
        return table::print_json(&answer);
    }
    print(&arguments.file, &found)?;
    match &arguments.output {
        Some(folder) => table::print_line(&format!("figures: {}", folder.display())),
        None => Ok(()),
    }
}

/// An option in per cent as a share, from 0 to 20 %.
fn share(option: &'static str, percent: f64) -> Result<f64, Failure> {
    if (0.0..=20.0).contains(&percent) {
        return Ok(0.01 * percent);
    }
    Err(Failure::Option { option, value: percent.to_string(), message: "allowed is 0 to 20 %".to_owned() })
}

/// The bearing, and the speed of the shaft that its case has, Hz.
fn bearing(arguments: &Arguments, file: &SignalFile, limits: &Limits) -> Result<(Kinematics, Option<f64>), Failure> {
    let Some(name) = &arguments.bearing else {
        let Some(text) = &file.case_text else {
            let message =
                "it is missing: the file says no bearing; give a case file, a designation or balls,ball mm,pitch mm";
            return Err(Failure::Option { option: "bearing", value: String::new(), message: message.to_owned() });
        };
        let case = CaseFile::from_text(&arguments.file.display().to_string(), text.clone(), &[], limits)?;
        return Ok(bearing_of_case(&case)?);
    };
    if let Some(bearing) = bearing_of_numbers(name) {
        return Ok((bearing, None));
    }
    let path = Path::new(name);
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("ron")) || path.is_file() {
        return Ok(bearing_of_case(&read_case(path, &[], limits)?)?);
    }
    let listed = tribodyn_catalogue::find(name, arguments.angle)?;
    let known = KnownBalls { published: listed.balls, ..KnownBalls::default() };
    let balls = listed.envelope.ball_set(known, listed.ratings)?;
    let kinematics = Kinematics {
        ball_count: balls.ball_count,
        ball_diameter_m: balls.ball_diameter,
        pitch_diameter_m: balls.pitch_diameter,
        contact_angle_rad: listed.envelope.contact_angle,
        inner_turns: 1.0,
        outer_turns: 0.0,
    };
    Ok((kinematics, None))
}

/// The speed that is asked for, or that of a recording, or that of the case.
fn speed(arguments: &Arguments, file: &SignalFile, case_hz: Option<f64>) -> Result<Speed, Failure> {
    if let Some(column) = &arguments.key_phase {
        return Ok(Speed::KeyPhase(column.clone(), arguments.pulses));
    }
    if let Some(given) = &arguments.speed {
        let refused = || Failure::Option {
            option: "speed",
            value: given.clone(),
            message: "allowed is a speed in r/min above 0 or below it, or the name of a column".to_owned(),
        };
        if file.columns.iter().any(|column| column.name == *given) && given.parse::<f64>().is_err() {
            return Ok(Speed::Column(given.clone()));
        }
        let rpm: f64 = given.parse().map_err(|_| refused())?;
        return if rpm.is_finite() && rpm != 0.0 { Ok(Speed::Near(rpm.abs() / 60.0)) } else { Err(refused()) };
    }
    if file.case_text.is_some() {
        return Ok(Speed::Column("inner_speed_rpm".to_owned()));
    }
    case_hz.map(Speed::Near).ok_or_else(|| Failure::Option {
        option: "speed",
        value: String::new(),
        message: "it is missing: lines are looked for by the speed of the shaft; give r/min or a column".to_owned(),
    })
}

/// The part that a fault is of.
fn part(fault: Option<Fault>) -> &'static str {
    match fault {
        None => "no fault seen",
        Some(Fault::Outer) => "outer race",
        Some(Fault::Inner) => "inner race",
        Some(Fault::Ball) => "ball",
        Some(Fault::Cage) => "cage",
    }
}

fn print(path: &Path, a: &Analysis) -> Result<(), Failure> {
    let d = &a.diagnosis;
    table::print_line(&format!("{}: {}\n", path.display(), crate::harmless::visible(&a.channel)))?;
    let shaft = &d.shaft;
    let from = match (d.order_tracked, shaft.measured) {
        (true, _) => "Hz, mean of the speeds given",
        (_, true) => "Hz, found in the signal",
        _ => "Hz, as given",
    };
    let whitened = if d.whitened { " of the whitened signal" } else { "" };
    let mut rows = vec![
        ("sampling rate", number(a.rate_hz, 0), "Hz"),
        ("duration", number(a.duration_s, 3), "s"),
        ("rms", format!("{:.4e}", a.statistics.rms), "unit of the file"),
        ("kurtosis", a.statistics.kurtosis.map_or("-".to_owned(), |k| number(k, 2)), ""),
        ("shaft", format!("{} ± {}", number(shaft.frequency_hz, 3), number(shaft.deviation_hz, 3)), from),
        ("band", format!("{} – {}", number(d.band.low_hz, 0), number(d.band.high_hz, 0)), "Hz"),
        ("spectral kurtosis of the band", number(d.band.kurtosis, 2), whitened),
    ];
    if let Some(cage) = &d.cage {
        let speed = format!("{} ± {}", number(cage.speed_rpm, 2), number(cage.deviation_rpm, 2));
        rows.push(("cage", speed, "r/min"));
    }
    table::print_pairs(&rows)?;
    table::print_line("")?;
    let header = ["line", "rolling Hz", "found Hz", "± Hz", "off %", "over noise dB", "modulation", "log10 chance"];
    table::print_rows(&header, d.evidence.iter().map(row))?;
    table::print_line(&format!("\nverdict: {}", part(d.verdict.fault)))?;
    for reason in &d.verdict.reasons {
        table::print_line(&format!("  {reason}"))?;
    }
    for warning in &d.warnings {
        table::print_line(&format!("warning: {warning}"))?;
    }
    Ok(())
}

fn row(e: &Evidence) -> Vec<String> {
    let heights: Vec<String> = e.harmonics.iter().map(|h| number(h.over_floor_db, 0)).collect();
    vec![
        e.fault.line().to_owned(),
        number(e.expected_hz, 3),
        number(e.frequency_hz, 3),
        number(e.deviation_hz, 3),
        number(100.0 * (e.frequency_hz / e.expected_hz - 1.0), 2),
        heights.join(" "),
        number(e.modulation, 3),
        number(e.log_chance, 0),
    ]
}
