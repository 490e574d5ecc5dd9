//! Steady orbits beside the means of long, damped runs of the same bearings: cage speed, torque, loads and pocket force
//! over azimuth.
//!
//! `cargo run --release -p tribodyn-orbit --example against_run -- [WORDS OF NAMES] [--write]`: all bearings without
//! words; `--write` puts the table in docs/steady-orbit.md. Loads over azimuth are those of bins of two degrees. In the
//! runs rings and cage are so heavy and damped that they do not answer to single balls, and pockets and contacts are
//! damped as in the orbit: what the orbit takes for granted.

mod bearings;
mod mean;

use bearings::{Compared, bearings};
use mean::{Mean, weigh_down};
use std::{error::Error, f64::consts::TAU, fmt::Write, fs};
use tribodyn_bearing::{Bearing, CageBody};
use tribodyn_case::Case;
use tribodyn_dynamics::StartMotion;
use tribodyn_orbit::{OrbitSettings, POINTS, SolvedOrbit, SteadyOrbit, steady_orbit};

const DOCUMENT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/steady-orbit.md");
const BEGIN: &str = "<!-- orbits:begin -->";
const END: &str = "<!-- orbits:end -->";
const HEADER: &str = "| bearing | cage, r/min | off | torque, N m | off | load off | inner load over azimuth | contact \
begins | pocket force, N | over azimuth |\n|---|---|---|---|---|---|---|---|---|---|\n";

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let write = arguments.iter().any(|a| a == "--write");
    let words: Vec<&String> = arguments.iter().filter(|a| *a != "--write").collect();
    let mut table = HEADER.to_owned();
    print!("{HEADER}");
    for bearing in bearings() {
        if !words.iter().all(|word| bearing.name.contains(word.as_str())) {
            continue;
        }
        let row = row(&bearing).unwrap_or_else(|why| format!("| {} | {why} ||||||||", bearing.name));
        println!("{row}");
        writeln!(table, "{row}")?;
    }
    if write {
        let text = fs::read_to_string(DOCUMENT)?;
        let (before, rest) = text.split_once(BEGIN).ok_or("the document has no block for orbits")?;
        let (_, after) = rest.split_once(END).ok_or("the block for orbits has no end")?;
        fs::write(DOCUMENT, format!("{before}{BEGIN}\n{table}{END}{after}"))?;
    }
    Ok(())
}

/// A bearing's row.
fn row(compared: &Compared) -> Result<String, Box<dyn Error>> {
    let case = Case::from_ron(&compared.text()?)?;
    let mut inputs = case.run_inputs()?;
    let settings = OrbitSettings::default();
    let cage = CageBody::new(&inputs.cage, &inputs.bearing);
    let bearing = Bearing { contact_damping: inputs.options.contact_damping, ..inputs.bearing.clone() };
    let point = case.operating_point();
    let SolvedOrbit { solution: orbit, start, .. } = steady_orbit(&bearing, &point, &cage, &settings)?;
    let motion = start.filter(|_| compared.from_orbit).map(|start| {
        let solution = orbit.as_solution(&orbit.balls, [point.inner_speed, point.outer_speed]);
        StartMotion { motion: start.motion(orbit.balls.len()), rule: start.rule(), solution }
    });
    let turn = 60.0 / orbit.cage_speed_rpm.abs();
    let slow = 0.01 * TAU / turn * cage.pocket.radius;
    weigh_down(&mut inputs, settings.pocket_damping / slow, compared.heavy);
    let mean = Mean::of(&inputs, turn, compared.turns, motion)?;
    Ok(compare(compared.name, &mean, &orbit))
}

fn compare(name: &str, mean: &Mean, orbit: &SteadyOrbit) -> String {
    let off = |ours: f64, theirs: f64| ours / theirs - 1.0;
    let (speed, torque, load) = (mean.cage_speed_rpm(), mean.torque(), mean.load());
    let size = load.iter().map(|f| f * f).sum::<f64>().sqrt();
    let load_off = orbit.ring_load_n.iter().zip(load).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size;
    let ours: Vec<[f64; 2]> =
        orbit.points.iter().map(|p| [p.contacts.inner.load_n, p.pocket.map_or(0.0, |p| p.force_n)]).collect();
    let theirs: Vec<Option<[f64; 2]>> = mean.by_azimuth().collect();
    let peak = |k: usize| ours.iter().map(|v| v[k].abs()).fold(f64::MIN_POSITIVE, f64::max);
    let mut apart: [Vec<f64>; 2] = [0, 1].map(|k| {
        ours.iter().zip(&theirs).filter_map(|(a, b)| b.map(|b| (a[k] - b[k]).abs() / peak(k))).collect::<Vec<_>>()
    });
    apart.iter_mut().for_each(|v| v.sort_by(f64::total_cmp));
    // Where a ball meets or leaves its pocket the force jumps within the bin.
    let most = |v: &[f64]| v[(v.len() * 97 / 100).min(v.len() - 1)];
    let theirs: Vec<[f64; 2]> = theirs.into_iter().map(|v| v.unwrap_or_default()).collect();
    let begins = match (begin(&ours, 0.01 * peak(0)), begin(&theirs, 0.01 * peak(0))) {
        (Some(a), Some(b)) => format!("{a}°, {b}°"),
        _ => "everywhere".to_owned(),
    };
    let pocket = if peak(1) < 1e-3 { "–".to_owned() } else { format!("{:.1e}", most(&apart[1])) };
    format!(
        "| {name} | {:.3}, {speed:.3} | {:+.1e} | {:.5}, {torque:.5} | {:+.1e} | {load_off:.1e} | {:.1e} | {begins} | \
         {:.1} | {pocket} |",
        orbit.cage_speed_rpm,
        off(orbit.cage_speed_rpm, speed),
        orbit.shaft_torque_nm,
        off(orbit.shaft_torque_nm, torque),
        apart[0].last().copied().unwrap_or(0.0),
        orbit.pocket_force_max_n,
    )
}

/// Azimuth in degrees at which the inner load first exceeds a threshold after the widest gap.
fn begin(values: &[[f64; 2]], threshold: f64) -> Option<usize> {
    let loaded = |n: usize| values[n % POINTS][0] > threshold;
    let gap = |n: usize| (1..POINTS).take_while(|back| !loaded(n + POINTS - back)).count();
    let first = (0..POINTS).filter(|&n| loaded(n) && !loaded(n + POINTS - 1)).max_by_key(|&n| gap(n))?;
    Some(first * 360 / POINTS)
}
