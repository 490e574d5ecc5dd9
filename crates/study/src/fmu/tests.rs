//! The C sources of an FMU against the solver, through the interface that a simulation calls.

use super::TemporaryFolder;
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Stdio};
use std::{fs, iter};
use tribodyn::{CaseFile, Limits};
use tribodyn_bearing::{Bearing, GyroscopicFriction, OperatingPoint, RaceControl, Races, RingFreedom, RingState};
use tribodyn_case::Purpose;
use tribodyn_fmu::Fmu;
use tribodyn_quasistatic::{Model, Solution, jones_harris_stiffness, solve};

/// Reads the inputs in the order of their references, prints the outputs, line by line; a line `damping` first.
const MASTER: &str = r#"
#include "fmi2.h"
#include "model.h"
#include <stdio.h>
#include <stdlib.h>
fmi2Component fmi2Instantiate(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *, int, int);
fmi2Status fmi2ExitInitializationMode(fmi2Component);
fmi2Status fmi2SetReal(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Real[]);
fmi2Status fmi2GetReal(fmi2Component, const fmi2ValueReference[], size_t, fmi2Real[]);
int main(void) {
    fmi2CallbackFunctions callbacks = {0, calloc, free, 0, 0};
    fmi2ValueReference in[FORCE_X], out[BALL_COUNT - FORCE_X], damping = DAMPING;
    double given[FORCE_X], found[BALL_COUNT - FORCE_X], tau;
    fmi2Component c = fmi2Instantiate("test", fmi2ModelExchange, MODEL_GUID, "", &callbacks, 0, 0);
    int k, got;
    for (k = 0; k < FORCE_X; k++) in[k] = k;
    for (k = FORCE_X; k < BALL_COUNT; k++) out[k - FORCE_X] = k;
    if (!c || scanf("%lf", &tau) != 1 || fmi2SetReal(c, &damping, 1, &tau) != fmi2OK) return 1;
    fmi2ExitInitializationMode(c);
    for (;;) {
        for (k = 0, got = 1; k < FORCE_X && got == 1; k++) got = scanf("%lf", &given[k]);
        if (got != 1) return 0;
        if (fmi2SetReal(c, in, FORCE_X, given) != fmi2OK) return 1;
        if (fmi2GetReal(c, out, BALL_COUNT - FORCE_X, found) != fmi2OK) {
            printf("none\n");
            continue;
        }
        for (k = 0; k < BALL_COUNT - FORCE_X; k++) printf("%.17g ", found[k]);
        printf("\n");
    }
}
"#;

/// Outputs of the FMU: forces and moments, cage speed, loads and pressures of inner and outer race.
type Outputs = Vec<f64>;

/// The FMU of a bearing, called with rows of its thirteen inputs; none where a row has no answer.
fn called(bearing: &Bearing, damping: f64, rows: &[[f64; 13]]) -> Vec<Option<Outputs>> {
    let rest = RingState::centred(0.0);
    let fmu = Fmu::new("test", bearing, Races { inner: &rest, outer: &rest }).unwrap();
    let folder = TemporaryFolder::new().unwrap();
    let sources = fmu.sources();
    sources.iter().for_each(|(name, text)| fs::write(folder.0.join(name), text).unwrap());
    fs::write(folder.0.join("master.c"), MASTER).unwrap();
    let compiled = sources.iter().map(|(name, _)| *name).filter(|name| name.ends_with(".c")).chain(["master.c"]);
    let strict = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function", "-o", "master"];
    let made = Command::new("cc").current_dir(&folder.0).args(strict).args(compiled).arg("-lm").output().unwrap();
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let mut text = format!("{damping:e}\n");
    rows.iter().for_each(|row| row.iter().for_each(|value| _ = writeln!(text, "{value:e}")));
    let mut child = Command::new(folder.0.join("master"));
    let mut child = child.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    let done = child.wait_with_output().unwrap();
    assert!(done.status.success());
    let numbers = |line: &str| line.split_whitespace().map(|n| n.parse().ok()).collect();
    let answers: Vec<_> = String::from_utf8(done.stdout).unwrap().lines().map(numbers).collect();
    assert_eq!(answers.len(), rows.len());
    answers
}

fn case(name: &str, text: &str) -> CaseFile {
    CaseFile::from_text(name, text.to_owned(), &[], &Limits::NORMAL).unwrap()
}

fn cases() -> Vec<CaseFile> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/cases");
    let names = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut names: Vec<_> = names.filter(|path| path.extension().is_some_and(|e| e == "ron")).collect();
    names.sort();
    let read = names.iter().map(|path| case(&path.display().to_string(), &fs::read_to_string(path).unwrap()));
    read.filter(|file| file.case.require(Purpose::JonesHarris).is_ok()).collect()
}

/// A number from −1 to 1 by a place in a sequence that fills the interval evenly (the golden ratio's).
fn spread(index: usize) -> f64 {
    2.0 * (0.618_033_988_749_894_9 * index as f64).fract() - 1.0
}

/// Places of the ring about that of an equilibrium: displacements by some approaches, tilts to match.
fn about(solution: &Solution, bearing: &Bearing, count: usize) -> Vec<[f64; 5]> {
    let scale = 1e-3 * bearing.geometry.ball_diameter;
    let tilt = scale / (0.5 * bearing.geometry.pitch_diameter);
    let [x, y, z] = solution.ring_displacement_m;
    let centre = [x, y, z, solution.ring_tilt_rad[0], solution.ring_tilt_rad[1]];
    let moved =
        |n: usize| std::array::from_fn(|k| centre[k] + if k < 3 { scale } else { tilt } * spread(7 * n + 13 * k + 3));
    iter::once(centre).chain((1..count).map(moved)).collect()
}

fn inputs(ring: [f64; 5], rate: [f64; 5], point: &OperatingPoint, bearing: &Bearing) -> [f64; 13] {
    let mut row = [0.0; 13];
    row[..5].copy_from_slice(&ring);
    row[5..10].copy_from_slice(&rate);
    row[10..].copy_from_slice(&[point.inner_speed, point.outer_speed, bearing.azimuth(0)]);
    row
}

fn held(point: &OperatingPoint, ring: [f64; 5]) -> OperatingPoint {
    OperatingPoint { ring: ring.map(RingFreedom::Held), ..point.clone() }
}

/// Forces and moments on the ring, cage speed, largest loads and pressures of a solution, as the FMU has them.
fn expected(solution: &Solution) -> Outputs {
    let largest = |of: fn(&tribodyn_bearing::BallResult) -> f64| solution.balls.iter().map(of).fold(0.0, f64::max);
    let mut out: Outputs = solution.ring_load_n.iter().chain(&solution.ring_moment_nm).map(|load| -load).collect();
    out.push(solution.cage_speed_rpm * std::f64::consts::PI / 30.0);
    out.push(largest(|ball| ball.contacts.inner.load_n));
    out.push(largest(|ball| ball.contacts.outer.load_n));
    out.push(largest(|ball| ball.contacts.inner.peak_pressure_pa));
    out.push(largest(|ball| ball.contacts.outer.peak_pressure_pa));
    out
}

/// The largest difference over the size of such outputs.
fn apart(found: &[f64], wanted: &[f64], radius: f64) -> f64 {
    let force = wanted[..3].iter().fold(wanted[7], |most: f64, f| most.max(f.abs()));
    let size = |k: usize| match k {
        0..=2 | 6 | 7 => force,
        3 | 4 => force * radius,
        _ => wanted[k].abs().max(1e-6),
    };
    (0..wanted.len()).map(|k| (found[k] - wanted[k]).abs() / size(k)).fold(0.0, f64::max)
}

#[test]
fn identity_the_sources_solve_what_the_solver_solves() {
    let mut compared = 0;
    for file in cases() {
        compared += compare(&file.name, &file.bearing().unwrap(), &file.case.operating_point(), 40);
    }
    assert!(compared > 300, "{compared}");
}

/// Every reading of the modelling choices, at rest, at the speed of the case and at twice that.
#[test]
fn identity_all_readings_are_those_of_the_solver() {
    let mut compared = 0;
    let read = cases()
        .into_iter()
        .filter(|file| ["angular-7210", "paper-ag.", "oil-6206"].iter().any(|n| file.name.contains(n)));
    for (index, file) in read.enumerate() {
        for (reading, control) in
            [RaceControl::Outer, RaceControl::Inner, RaceControl::Criterion].into_iter().enumerate()
        {
            let mut bearing = file.bearing().unwrap();
            let modelling = &mut bearing.modelling;
            modelling.race_control = Some(control);
            modelling.gyroscopic_friction = Some(match (index + reading) % 3 {
                0 => GyroscopicFriction::Shared,
                1 => GyroscopicFriction::Absent,
                _ => GyroscopicFriction::ControllingAsPrinted,
            });
            modelling.contact_at_actual_angle = !modelling.contact_at_actual_angle;
            modelling.centrifugal_at_free_pitch = Some(modelling.centrifugal_at_free_pitch == Some(false));
            for share in [0.0, 1.0, 2.0] {
                let mut point = file.case.operating_point();
                (point.inner_speed, point.outer_speed) = (share * point.inner_speed, share * point.outer_speed);
                let name = format!("{} {control:?} {share}", file.name);
                compared += compare(&name, &bearing, &point, 12);
            }
        }
    }
    assert!(compared > 200, "{compared}");
}

/// Compares both at places about the equilibrium; gives their number.
fn compare(name: &str, bearing: &Bearing, point: &OperatingPoint, count: usize) -> usize {
    let Ok(solved) = solve(bearing, point, Model::JonesHarris) else { return 0 };
    let places = about(&solved.solution, bearing, count);
    let rows: Vec<_> = places.iter().map(|ring| inputs(*ring, [0.0; 5], point, bearing)).collect();
    let mut compared = 0;
    for (ring, found) in places.iter().zip(called(bearing, 0.0, &rows)) {
        let wanted = solve(bearing, &held(point, *ring), Model::JonesHarris);
        match (wanted, found) {
            (Ok(wanted), Some(found)) => {
                let apart = apart(&found, &expected(&wanted.solution), 0.5 * bearing.geometry.pitch_diameter);
                assert!(apart < 1e-9, "{name}: {ring:?}: {apart:e} {found:?} {:?}", expected(&wanted.solution));
                compared += 1;
            }
            (Err(_), None) => {}
            (wanted, found) => panic!("{name}: {ring:?}: {found:?} {:?}", wanted.map(|w| w.solution.ring_load_n)),
        }
    }
    compared
}

/// More balls than fit, and damping that drives.
#[test]
fn limit_parameters_that_make_no_bearing_have_no_answer() {
    let file = cases().into_iter().find(|file| file.name.contains("angular-7210")).unwrap();
    let (mut bearing, point) = (file.bearing().unwrap(), file.case.operating_point());
    let place = about(&solve(&bearing, &point, Model::JonesHarris).unwrap().solution, &bearing, 1)[0];
    let row = [inputs(place, [0.0; 5], &point, &bearing)];
    assert!(called(&bearing, 1e-5, &row)[0].is_some() && called(&bearing, -1e-5, &row)[0].is_none());
    bearing.geometry.ball_count = 40;
    assert!(called(&bearing, 0.0, &row)[0].is_none());
}

/// With the ring in motion its force changes by the stiffness times velocity times the damping's time.
#[test]
fn identity_damping_is_stiffness_times_a_time() {
    const TAU: f64 = 2e-5;
    for file in cases() {
        let bearing = file.bearing().unwrap();
        let point = file.case.operating_point();
        let solution = solve(&bearing, &point, Model::JonesHarris).unwrap().solution;
        let stiffness = jones_harris_stiffness(&bearing, &point).unwrap();
        let place = about(&solution, &bearing, 1)[0];
        let rate = [0.02, -0.01, 0.015, 0.3, -0.2];
        let rows = [inputs(place, [0.0; 5], &point, &bearing), inputs(place, rate, &point, &bearing)];
        let found = called(&bearing, TAU, &rows);
        let (still, moving) = (found[0].as_ref().unwrap(), found[1].as_ref().unwrap());
        for (k, row) in stiffness.iter().enumerate() {
            let terms = row.iter().zip(rate).map(|(stiffness, rate)| TAU * stiffness * rate);
            let (sum, size) = terms.fold((0.0, 0.0), |(sum, size), term| (sum + term, size + f64::abs(term)));
            let damped = still[k] - moving[k];
            assert!((damped - sum).abs() < 1e-7 * size, "{}: {k}: {damped} {sum}", file.name);
        }
    }
}
