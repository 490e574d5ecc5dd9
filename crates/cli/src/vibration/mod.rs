//! `tribodyn vibration`: what a measured or recorded signal says of a bearing.

mod figures;

use crate::drawn;
use crate::failure::Failure;
use crate::input::{LimitArguments, ReplaceArguments};
use crate::table::{self, number};
use crate::units::in_unit;
use serde::Serialize;
use std::path::{Path, PathBuf};
use tribodyn_signal::{BandVelocity, Evidence, Fault, Search, VibrationClass};
use tribodyn_study::StagedFiles;
use tribodyn_study::vibration::{Analysis, SignalQuestion, Window, diagnosed};

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
    /// Column to evaluate, by its name or number
    #[arg(long, value_name = "NAME")]
    channel: Option<String>,
    /// Sampling rate, Hz; known for WAV files, recordings and files with a column `time`
    #[arg(long, value_name = "HZ", value_parser = in_unit("Hz"))]
    rate: Option<f64>,
    /// Bearing: a case file, a designation such as 6205, or balls,ball mm,pitch mm[,angle °] such as 9,7.94,39.04
    #[arg(long, value_name = "BEARING")]
    bearing: Option<String>,
    /// Nominal contact angle of an angular-contact designation, degrees
    #[arg(long, value_name = "DEG", value_parser = in_unit("deg"))]
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
    #[arg(long, value_name = "S")]
    from: Option<f64>,
    /// End at this time, s
    #[arg(long, value_name = "S")]
    to: Option<f64>,
    /// Uncertainty of the speed given in r/min, %
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0 * Search::default().speed)]
    speed_tolerance: f64,
    /// Deviation of the cage from pure rolling by slip and contact angle, %
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0 * Search::default().slip)]
    slip: f64,
    /// Folder for vibration.json and the figures (SVG and PNG)
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    limits: LimitArguments,
    /// Print JSON instead of tables
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

impl Arguments {
    fn question(&self) -> SignalQuestion {
        SignalQuestion {
            file: self.file.clone(),
            channel: self.channel.clone(),
            rate_hz: self.rate,
            bearing: self.bearing.clone(),
            angle_deg: self.angle,
            speed: self.speed.clone(),
            key_phase: self.key_phase.clone().map(|column| (column, self.pulses)),
            window: Window { from_s: self.from, to_s: self.to },
            speed_tolerance_percent: self.speed_tolerance,
            slip_percent: self.slip,
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let found = diagnosed(&arguments.question(), &arguments.limits.limits())?;
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
        ("rms", format!("{:.4e}", a.statistics.rms), if a.is_in_m_s2() { "m/s²" } else { "unit of the file" }),
        ("kurtosis", a.statistics.kurtosis.map_or("-".to_owned(), |k| number(k, 2)), ""),
        ("shaft", format!("{} ± {}", number(shaft.frequency_hz, 3), number(shaft.deviation_hz, 3)), from),
        ("band", format!("{} – {}", number(d.band.low_hz, 0), number(d.band.high_hz, 0)), "Hz"),
        ("spectral kurtosis of the band", number(d.band.kurtosis, 2), whitened),
    ];
    if let Some(cage) = &d.cage {
        let speed = format!("{} ± {}", number(cage.speed_rpm, 2), number(cage.deviation_rpm, 2));
        rows.push(("cage", speed, "r/min"));
    }
    let velocities: Vec<(String, String)> = a.velocity_bands.iter().map(velocity).collect();
    rows.extend(velocities.iter().map(|(name, value)| (name.as_str(), value.clone(), "mm/s")));
    let class = a.velocity_class.as_ref().map(class);
    rows.extend(class.iter().map(|(name, limits)| ("class of bearing testers", name.clone(), limits.as_str())));
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

/// Velocity in a band of bearing testers: its name, rms and peak.
fn velocity(band: &BandVelocity) -> (String, String) {
    let name = format!("velocity {:.0} – {:.0} Hz, rms peak", band.low_hz, band.high_hz);
    (name, format!("{}  {}", number(1e3 * band.rms_m_s, 4), number(1e3 * band.peak_m_s, 4)))
}

/// Name of a class and its limits.
fn class(class: &VibrationClass) -> (String, String) {
    let name = class.name.map_or("louder than V".to_owned(), str::to_owned);
    let [low, middle, high] = class.limits_m_s.map(|limit| number(1e3 * limit, 3));
    (name, format!("up to {low}  {middle}  {high} mm/s rms at a bore of {} mm", number(1e3 * class.bore_m, 0)))
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
