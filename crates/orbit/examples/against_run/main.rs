//! Steady orbits beside the means of long, damped runs of the same bearings: cage speed, torque, loads and pocket force
//! over azimuth.
//!
//! `cargo run --release -p tribodyn-orbit --example against_run -- [WORDS OF NAMES] [--write]`: all bearings without
//! words; `--write` puts the table in docs/steady-orbit.md. Loads over azimuth are those of bins of two degrees. In the
//! runs rings and cage are so heavy and damped that they do not answer to single balls, and pockets and contacts are
//! damped as in the orbit: what the orbit takes for granted. A run begins on the orbit. Its cage would take thousands
//! of turns to another speed, so that the torque on it tells: an orbit whose cage takes that torque says by how much
//! the run is from its own balance.

mod bearings;
mod mean;

use bearings::{Compared, bearings};
use mean::{Mean, weigh_down};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{error::Error, f64::consts::TAU, fmt::Write, fs};
use tribodyn_bearing::{Bearing, CageBody};
use tribodyn_case::Case;
use tribodyn_dynamics::StartMotion;
use tribodyn_orbit::{OrbitSettings, POINTS, SolvedOrbit, SteadyOrbit, steady_orbit, steady_orbit_from};

const DOCUMENT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/steady-orbit.md");
const BEGIN: &str = "<!-- orbits:begin -->";
const END: &str = "<!-- orbits:end -->";
const HEADER: &str = "| bearing | cage, r/min | off | torque, N m | off | load off | inner load over azimuth | contact \
begins | pocket force, N | over azimuth |\n|---|---|---|---|---|---|---|---|---|---|\n";

/// Turns of the cage until the balls have settled, and those of the mean.
const TURNS: [f64; 2] = [3.0, 6.0];
/// Torque on the cage, over that of the bearing's load on its pitch circle, that is none.
const NO_TORQUE: f64 = 1e-12;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let write = arguments.iter().any(|a| a == "--write");
    let words: Vec<&String> = arguments.iter().filter(|a| *a != "--write").collect();
    let mut chosen = bearings();
    chosen.retain(|bearing| words.iter().all(|word| bearing.name.contains(word.as_str())));
    let mut table = HEADER.to_owned();
    for row in rows(&chosen) {
        writeln!(table, "{row}")?;
    }
    print!("{table}");
    if write {
        let text = fs::read_to_string(DOCUMENT)?;
        let (before, rest) = text.split_once(BEGIN).ok_or("the document has no block for orbits")?;
        let (_, after) = rest.split_once(END).ok_or("the block for orbits has no end")?;
        fs::write(DOCUMENT, format!("{before}{BEGIN}\n{table}{END}{after}"))?;
    }
    Ok(())
}

/// The rows of all, each thread taking the next.
fn rows(bearings: &[Compared]) -> Vec<String> {
    let next = AtomicUsize::new(0);
    let made = |index: usize| {
        let bearing = &bearings[index];
        let row = row(bearing).unwrap_or_else(|why| format!("| {} | {why} ||||||||", bearing.name));
        eprintln!("{row}");
        (index, row)
    };
    let taken = || std::iter::repeat_with(|| next.fetch_add(1, Ordering::Relaxed)).take_while(|n| *n < bearings.len());
    let work = || taken().map(made).collect::<Vec<_>>();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut rows: Vec<(usize, String)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        threads.into_iter().flat_map(|thread| thread.join().unwrap_or_default()).collect()
    });
    rows.sort_by_key(|(index, _)| *index);
    rows.into_iter().map(|(_, row)| row).collect()
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
    let start = start.ok_or("the bearing does not turn")?;
    let (motion, rule) = (start.motion(orbit.balls.len()), start.rule());
    let solution = orbit.as_solution(&orbit.balls, [point.inner_speed, point.outer_speed]);
    let turn = 60.0 / orbit.cage_speed_rpm.abs();
    let slow = 0.01 * TAU / turn * cage.pocket.radius;
    weigh_down(&mut inputs, settings.pocket_damping / slow);
    let mut mean = Mean::of(&inputs, turn, TURNS, StartMotion { motion, rule, solution })?;
    let load = mean.load.iter().map(|f| f * f).sum::<f64>().sqrt();
    let mut cage_speed_rpm = mean.orbital_speed * 60.0 / TAU;
    // Where no ball touches its pocket the cage keeps any speed, and that of the balls counts.
    if mean.cage_torque.abs() > NO_TORQUE * load * cage.pocket.radius {
        let mut braked = cage;
        braked.drag_torque += mean.cage_torque * orbit.cage_speed_rpm.signum();
        let braked = steady_orbit_from(&bearing, &point, &braked, &settings, &start)?.solution;
        cage_speed_rpm = 2.0 * orbit.cage_speed_rpm - braked.cage_speed_rpm;
        mean.torque += orbit.shaft_torque_nm - braked.shaft_torque_nm;
    }
    Ok(compare(compared.name, (&mean, cage_speed_rpm), &orbit))
}

fn compare(name: &str, (mean, speed): (&Mean, f64), orbit: &SteadyOrbit) -> String {
    let off = |ours: f64, theirs: f64| ours / theirs - 1.0;
    let (torque, load) = (mean.torque, mean.load);
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
