//! The answer as tables.

use crate::failure::Failure;
use crate::table::{self, number};
use tribodyn_study::shaft::{BearingAnswer, LifeAnswer, ShaftAnswer, ShaftFile, WhirlAnswer};

/// Stations that are printed: those where something happens, and what lies between is in the CSV.
pub fn print(file: &ShaftFile, life: &LifeAnswer, whirl: Option<&WhirlAnswer>) -> Result<(), Failure> {
    table::print_line(&format!("{}: {}\n", file.name, file.system.name))?;
    let single = life.duties.len() == 1;
    for (index, duty) in life.duties.iter().enumerate() {
        if !single {
            let share = 100.0 * duty.share;
            let text = format!("load case {}: {share:.1} % of the time, loads times {}", index + 1, duty.load);
            table::print_line(&text)?;
        }
        shaft(&duty.shaft)?;
    }
    lives(file, life)?;
    if let Some(whirl) = whirl {
        modes(whirl)?;
    }
    let warnings = life.duties.iter().flat_map(|duty| {
        let of = |b: &BearingAnswer| b.warnings.iter().map(|w| format!("{}: {w}", b.name)).collect::<Vec<_>>();
        duty.shaft.warnings.iter().cloned().chain(duty.shaft.bearings.iter().flat_map(of)).collect::<Vec<_>>()
    });
    let mut seen: Vec<String> = Vec::new();
    for warning in warnings.chain(whirl.iter().flat_map(|w| w.warnings.clone())) {
        if !seen.contains(&warning) {
            table::print_line(&format!("warning: {warning}"))?;
            seen.push(warning);
        }
    }
    Ok(())
}

fn shaft(answer: &ShaftAnswer) -> Result<(), Failure> {
    table::print_line(&format!(
        "{} r/min, mass of the shaft {} kg",
        number(answer.speed_rpm, 0),
        number(answer.mass_kg, 2)
    ))?;
    let header = [
        "bearing",
        "at mm",
        "F_x N",
        "F_y N",
        "F_z N",
        "M_x N m",
        "M_y N m",
        "tilt mrad",
        "Q N",
        "p GPa",
        "α °",
        "balls",
    ];
    let row = |b: &BearingAnswer| {
        let ([x, y, z], [mx, my]) = (b.reaction_n, b.reaction_moment_nm);
        let [low, high] = b.contact_angle_rad.map(f64::to_degrees);
        vec![
            b.name.clone(),
            number(b.position_m * 1e3, 1),
            number(x, 1),
            number(y, 1),
            number(z, 1),
            number(mx, 2),
            number(my, 2),
            number(b.ring_tilt_rad[0].hypot(b.ring_tilt_rad[1]) * 1e3, 3),
            number(b.ball_load_max_n, 1),
            b.peak_pressure_max_pa.map_or_else(String::new, |p| number(p * 1e-9, 3)),
            format!("{} to {}", number(low, 1), number(high, 1)),
            b.loaded_balls.to_string(),
        ]
    };
    table::print_rows(&header, answer.bearings.iter().map(row))?;
    fits(answer)?;
    extremes(answer)?;
    table::print_line("")
}

/// Interference and clearance of bearings with fits by class.
fn fits(answer: &ShaftAnswer) -> Result<(), Failure> {
    let row = |b: &BearingAnswer| {
        let fits = b.fits.as_ref()?;
        let classes: Vec<&str> = fits.seats.iter().map(|seat| seat.seat_class.as_str()).collect();
        let microns = |metres: f64| number(metres * 1e6, 1);
        let interference = |ring| {
            let seat = fits.seats.iter().find(|seat| seat.ring == ring);
            seat.map_or_else(String::new, |seat| microns(seat.effective_interference_m))
        };
        let optional = |clearance: Option<f64>| clearance.map_or_else(|| "–".to_owned(), microns);
        let [loosest, .., tightest] = fits.radial_clearance_running_m;
        Some(vec![
            b.name.clone(),
            classes.join(" "),
            interference("inner"),
            interference("outer"),
            microns(b.radial_clearance_m),
            format!("{} to {}", optional(tightest), optional(loosest)),
        ])
    };
    let rows: Vec<Vec<String>> = answer.bearings.iter().filter_map(row).collect();
    if rows.is_empty() {
        return Ok(());
    }
    table::print_line("")?;
    let header = ["bearing", "fits", "on shaft µm", "in housing µm", "clearance running µm", "over all fits µm"];
    table::print_rows(&header, rows.into_iter())
}

/// Where the shaft bends and is stressed most.
fn extremes(answer: &ShaftAnswer) -> Result<(), Failure> {
    let deepest = answer.stations.iter().max_by(|a, b| radial(a.displacement_m).total_cmp(&radial(b.displacement_m)));
    let hardest = answer.stations.iter().max_by(|a, b| a.equivalent_stress_pa.total_cmp(&b.equivalent_stress_pa));
    let bent = answer.stations.iter().map(|s| s.bending_moment_nm[0].hypot(s.bending_moment_nm[1]));
    if let (Some(deepest), Some(hardest)) = (deepest, hardest) {
        let at = |z: f64| format!("at {} mm", number(z * 1e3, 1));
        table::print_line("")?;
        table::print_pairs(&[
            (
                "largest deflection",
                number(radial(deepest.displacement_m) * 1e6, 2),
                &format!("µm {}", at(deepest.position_m)),
            ),
            ("largest bending moment", number(bent.fold(0.0, f64::max), 2), "N m"),
            (
                "largest nominal stress (von Mises)",
                number(hardest.equivalent_stress_pa * 1e-6, 2),
                &format!("MPa {}", at(hardest.position_m)),
            ),
            ("residual, loads and reactions", format!("{:.1e}", answer.unbalanced.max(answer.residual)), ""),
        ])?;
    }
    Ok(())
}

fn radial([x, y, _]: [f64; 3]) -> f64 {
    x.hypot(y)
}

fn lives(file: &ShaftFile, life: &LifeAnswer) -> Result<(), Failure> {
    let optional = |value: Option<f64>, digits: usize| value.map_or_else(|| "–".to_owned(), |v| number(v, digits));
    let safety = |index: usize| {
        let all = life.duties.iter().filter_map(|duty| duty.shaft.bearings[index].rating.as_ref()?.static_safety);
        all.min_by(f64::total_cmp)
    };
    let header = ["bearing", "equivalent load N", "rating life h", "static safety"];
    let row = |(index, spec): (usize, &tribodyn_case::ShaftBearingSpec)| {
        vec![
            spec.name.clone(),
            optional(life.equivalent_load_n[index], 1),
            optional(life.life_h[index], 0),
            optional(safety(index), 2),
        ]
    };
    table::print_rows(&header, file.system.bearings.iter().enumerate().map(row))?;
    let system = ("rating life of all bearings together", optional(life.system_life_h, 0), "h");
    table::print_line("")?;
    table::print_pairs(&[system])
}

fn modes(whirl: &WhirlAnswer) -> Result<(), Failure> {
    for speed in &whirl.speeds {
        table::print_line(&format!("\nmodes at {} r/min", number(speed.speed_rpm, 0)))?;
        let row = |mode: &tribodyn_study::shaft::Mode| {
            let name = mode.whirl.name().to_owned();
            vec![name, number(mode.frequency_hz, 2), number(100.0 * mode.damping_ratio, 3)]
        };
        table::print_rows(&["whirl", "frequency Hz", "damping ratio %"], speed.modes.iter().map(row))?;
        if let Some(amplitude) = speed.amplitude_max_m {
            let at = speed.amplitude_m.iter().map(|a| number(a * 1e6, 3)).collect::<Vec<_>>().join("  ");
            let forces = speed.bearing_force_n.iter().map(|f| number(*f, 2)).collect::<Vec<_>>().join("  ");
            table::print_pairs(&[
                ("largest amplitude by unbalance", number(amplitude * 1e6, 3), "µm"),
                ("amplitudes at the bearings", at, "µm"),
                ("forces on the bearings", forces, "N"),
            ])?;
        }
    }
    table::print_line("")?;
    if whirl.critical.is_empty() && whirl.speeds.len() > 1 {
        return table::print_line("no critical speed between these speeds\n");
    }
    for critical in &whirl.critical {
        let rpm = number(critical.speed_rpm, 0);
        table::print_line(&format!("critical speed {rpm} r/min, whirl {}", critical.whirl.name()))?;
    }
    table::print_line("")
}
