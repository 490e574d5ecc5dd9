//! The tabs of runs and of solutions.

use super::panels::{Panel, numbers, over_array, over_time, table};
use super::{Layout, Tab, balls};

pub(super) fn of_run(layout: &Layout) -> Vec<Tab> {
    let count = layout.ball_count;
    vec![
        Tab {
            title: "Overview",
            rows: vec![
                vec![acceleration(), displacement()],
                vec![speeds(), balls::load()],
                vec![powers_of_run(), orbit()],
            ],
        },
        Tab {
            title: "Balls",
            rows: vec![
                vec![balls::one_ball(), balls::pocket(count)],
                vec![balls::pressure(), balls::contact_angle()],
                vec![balls::slide(), balls::speed()],
            ],
        },
        Tab { title: "Contacts", rows: vec![vec![balls::motion(count), balls::pocket_contact(count)]] },
        Tab {
            title: "Spectra",
            rows: vec![
                vec![spectrum("outer", "Outer ring, X", "m/s²", "/bearing/spectrum", Some(layout.band_hz))],
                vec![spectrum("outer_whole", "Outer ring, X, whole band", "m/s²", "/bearing/spectrum", None)],
                vec![
                    spectrum("inner", "Inner ring, X", "m/s²", "/bearing/spectrum/inner", Some(layout.band_hz)),
                    spectrum("cage", "Cage speed", "r/min", "/bearing/spectrum/cage", Some(layout.band_hz)),
                ],
            ],
        },
        Tab { title: "Wear", rows: vec![vec![coating(), worn()], vec![torques(), loads()]] },
        Tab { title: "Numbers", rows: vec![vec![numbers()], vec![table()]] },
    ]
}

pub(super) fn of_solution(_: &Layout) -> Vec<Tab> {
    vec![
        Tab {
            title: "Overview",
            rows: vec![
                vec![balls::load(), balls::pressure()],
                vec![balls::contact_angle(), balls::slide()],
                vec![balls::speed(), powers_of_solution()],
            ],
        },
        Tab { title: "Ball 0", rows: vec![vec![balls::one_ball()], vec![balls_pressure()], vec![lead()]] },
        Tab { title: "Numbers", rows: vec![vec![numbers()], vec![table()]] },
    ]
}

fn acceleration() -> Panel {
    over_time(
        "acceleration",
        "Acceleration of the rings",
        "m/s²",
        &[
            ("/bearing/state.outer_acceleration_x_m_s2", "outer X"),
            ("/bearing/state.outer_acceleration_y_m_s2", "outer Y"),
            ("/bearing/state.inner_acceleration_x_m_s2", "inner X"),
            ("/bearing/state.inner_acceleration_y_m_s2", "inner Y"),
        ],
    )
}

fn displacement() -> Panel {
    over_time(
        "displacement",
        "Displacement of the inner ring",
        "µm",
        &[
            ("/bearing/state.inner_displacement_x_um", "X"),
            ("/bearing/state.inner_displacement_y_um", "Y"),
            ("/bearing/state.inner_displacement_z_um", "Z, axial"),
        ],
    )
}

fn speeds() -> Panel {
    over_time(
        "speed",
        "Speed of cage and balls",
        "r/min",
        &[
            ("/bearing/state.cage_speed_rpm", "cage"),
            ("/bearing/state.orbital_speed_mean_rpm", "mean ball"),
            ("/bearing/state.orbital_speed_min_rpm", "slowest"),
            ("/bearing/state.orbital_speed_max_rpm", "fastest"),
        ],
    )
}

fn powers_of_run() -> Panel {
    over_time(
        "power",
        "Power lost",
        "W",
        &[
            ("/bearing/state.friction_inner_w", "inner"),
            ("/bearing/state.friction_outer_w", "outer"),
            ("/bearing/state.drag_w", "drag"),
            ("/bearing/state.churning_w", "churning"),
            ("/bearing/state.pocket_friction_w", "pockets"),
        ],
    )
}

fn powers_of_solution() -> Panel {
    over_time(
        "power",
        "Power lost",
        "W",
        &[
            ("/bearing/state.power_loss_inner_w", "inner"),
            ("/bearing/state.power_loss_outer_w", "outer"),
            ("/bearing/state.power_loss_fluid_w", "fluid"),
        ],
    )
}

fn orbit() -> Panel {
    let along = ("/bearing/orbit.x_um[:]", "X [µm]");
    over_array("orbit", ("Path of the inner ring, last turn: Y", "µm"), along, &[("/bearing/orbit.y_um[:]", "Y")])
}

/// A spectrum with the characteristic frequencies and two multiples of each marked.
fn spectrum(name: &str, title: &str, unit: &str, topic: &str, band_hz: Option<f64>) -> Panel {
    let path = |field: &str| format!("{topic}.{field}[:]");
    let marks = [
        ("amplitude", "amplitude"),
        ("mark_bpfo", "BPFO"),
        ("mark_bpfi", "BPFI"),
        ("mark_bsf", "BSF"),
        ("mark_ftf", "FTF"),
    ];
    let paths = marks.map(|(field, label)| (path(field), label));
    let curves = [0, 1, 2, 3, 4].map(|i| (paths[i].0.as_str(), paths[i].1));
    let along = path("frequency_hz");
    let panel = over_array(
        &format!("spectrum_{name}"),
        (&format!("Spectrum: {title}"), unit),
        (&along, "frequency [Hz]"),
        &curves,
    );
    match band_hz {
        Some(highest) => panel.up_to(highest),
        None => panel,
    }
}

fn coating() -> Panel {
    let curves = [("/bearing/wear.coating_inner_min_um", "inner"), ("/bearing/wear.coating_outer_min_um", "outer")];
    over_time("coating", "Thinnest coating left", "µm", &curves)
}

fn worn() -> Panel {
    over_time(
        "worn",
        "Volume worn off",
        "µm³",
        &[
            ("/bearing/wear.volume_inner_um3", "inner"),
            ("/bearing/wear.volume_outer_um3", "outer"),
            ("/bearing/wear.volume_cage_um3", "cage"),
        ],
    )
}

fn torques() -> Panel {
    let curves = [("/bearing/state.inner_torque_nm", "inner"), ("/bearing/state.outer_torque_nm", "outer")];
    over_time("torque", "Torque that keeps the speed", "N m", &curves)
}

fn loads() -> Panel {
    let curves = [("/bearing/state.load_inner_max_n", "inner"), ("/bearing/state.load_outer_max_n", "outer")];
    over_time("load", "Largest contact load of any ball", "N", &curves)
}

fn balls_pressure() -> Panel {
    let curves = [
        ("/bearing/balls.balls[0].peak_pressure_inner_gpa", "inner"),
        ("/bearing/balls.balls[0].peak_pressure_outer_gpa", "outer"),
    ];
    over_time("ball_pressure", "Peak pressure of ball 0", "GPa", &curves)
}

fn lead() -> Panel {
    over_time("lead", "Lead of ball 0 over its pocket", "mrad", &[("/bearing/balls.balls[0].pocket_lead_mrad", "lead")])
}
