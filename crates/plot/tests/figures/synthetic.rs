//! Numbers of the size of those of a 13-ball bearing under combined load at 14 000 r/min. They are no result of any
//! model.

use tribodyn_bearing::{BallResult, ContactResult, FluidResult, FrictionResult, PocketResult, Races};
use tribodyn_plot::{Axis, Figure, LineChart, Panel, Published, Quantity, Series, solution_figures};
use tribodyn_quasistatic::{Model, Solution};

/// Share of the heaviest load that a ball at this cosine of its azimuth carries.
fn load_share(cos: f64) -> f64 {
    (0.5 * (1.0 + cos)).powf(1.4)
}

fn inner([sin, cos]: [f64; 2], slip: f64, swing: f64) -> ContactResult {
    let heavy = load_share(cos);
    let load_inner_n = 6000.0 + 5000.0 * heavy;
    ContactResult {
        angle_rad: (26.1 - 3.2 * cos + 0.01 * slip).to_radians(),
        approach_m: 38e-6 * (load_inner_n / 9000.0).powf(2.0 / 3.0),
        load_n: load_inner_n + 3.0 * slip,
        peak_pressure_pa: 1.79e9 + 0.67e9 * heavy + 1e6 * slip,
        semi_axes_m: [3.1e-3, 0.36e-3],
        rolling_speed_m_s: 54.0,
        spin_ratio_per_m: 5.2,
        film: None,
        friction: Some(FrictionResult {
            traction_n: [64.0 + (9.0 - 6.0 * swing) * cos + 5.0 * slip, 20.0],
            slide_to_roll: [1e-3 * ((0.2 - 1.5 * cos + 0.3 * swing * sin) * (0.25 + 0.75 * slip) - 0.3), 4e-4],
            power_loss_w: 900.0 + 700.0 * heavy - 40.0 * slip,
            wear_rate_m3_s: 1e-12 * (2.1 + 1.7 * heavy - 0.12 * slip + 0.02 * swing),
            ..FrictionResult::default()
        }),
        transient: None,
    }
}

fn outer(cos: f64, slip: f64, swing: f64) -> ContactResult {
    let heavy = load_share(cos);
    let load_outer_n = 7900.0 + 4100.0 * heavy;
    ContactResult {
        angle_rad: (17.4 - 1.9 * cos - 0.01 * slip).to_radians(),
        approach_m: 36e-6 * (load_outer_n / 9000.0).powf(2.0 / 3.0),
        load_n: load_outer_n - 2.0 * slip,
        peak_pressure_pa: 1.85e9 + 0.45e9 * heavy - 1e6 * slip,
        semi_axes_m: [2.9e-3, 0.44e-3],
        rolling_speed_m_s: 54.2,
        spin_ratio_per_m: -0.4,
        film: None,
        friction: Some(FrictionResult {
            traction_n: [58.0 - (11.0 - 7.0 * swing) * cos + 4.0 * slip, -18.0],
            slide_to_roll: [1e-3 * (0.35 * cos - 0.4 - 0.12 * slip), -3e-4],
            power_loss_w: 210.0 + 90.0 * heavy + 60.0 * slip,
            wear_rate_m3_s: 1e-12 * (0.42 + 0.2 * heavy + 0.1 * slip),
            ..FrictionResult::default()
        }),
        transient: None,
    }
}

/// A ball whose numbers vary with azimuth; `slip` scales what differential slip changes, `swing` what varying traction
/// changes.
pub fn ball(azimuth_deg: f64, slip: f64, swing: f64) -> BallResult {
    let (sin, cos) = azimuth_deg.to_radians().sin_cos();
    BallResult {
        azimuth_rad: azimuth_deg.to_radians(),
        orbital_speed_rad_s: 607.6 + 2.1 * cos + 0.4 * sin - 5.9 * slip,
        orbit_radius_m: 0.0837,
        radial_displacement_m: 0.0012,
        axial_displacement_m: 4e-5,
        angular_velocity_rad_s: [-3600.0, 1050.0, 4.0],
        centrifugal_force_n: 3500.0,
        gyroscopic_moment_nm: 2.2,
        contacts: Races { inner: inner([sin, cos], slip, swing), outer: outer(cos, slip, swing) },
        fluid: Some(FluidResult {
            drag_n: 120.0,
            power_loss_w: 6100.0 + 60.0 * cos - 20.0 * slip,
            ..FluidResult::default()
        }),
        pocket: Some(PocketResult {
            lead_rad: 1e-3 * sin,
            force_n: -(340.0 * (-cos - 0.55)).max(0.0) * (1.0 - 0.4 * slip),
            friction_n: None,
            wear_rate_m3_s: 3e-14 * (-cos - 0.55).max(0.0) * (1.0 - 0.4 * slip),
        }),
        motion: None,
    }
}

pub fn solution(model: Model, slip: f64, swing: f64) -> Solution {
    Solution {
        model,
        converged: true,
        stable: None,
        cage_speed_rpm: 5802.0,
        ring_displacement_m: [2.4e-5, 0.0, 6.0e-5],
        ring_tilt_rad: [0.0; 2],
        ring_load_n: [20_000.0, 0.0, 40_000.0],
        ring_moment_nm: [0.0; 2],
        shaft_torque_nm: Some(30.0),
        inner_speed_rad_s: 1466.0,
        outer_speed_rad_s: 0.0,
        residual: 1e-12,
        iterations: 6,
        patch_error_estimate: (model == Model::Traction).then_some(1e-4),
        warnings: Vec::new(),
        balls: (0..13).map(|k| ball(360.0 * f64::from(k) / 13.0, slip, swing)).collect(),
    }
}

/// Jones–Harris and the four cases with and without differential slip and varying traction.
pub fn runs() -> Vec<(&'static str, Solution)> {
    vec![
        ("Case 1", solution(Model::Traction, 1.0, 1.0)),
        ("Case 2", solution(Model::Traction, 1.0, 0.0)),
        ("Case 3", solution(Model::Traction, 0.0, 1.0)),
        ("Case 4", solution(Model::Traction, 0.0, 0.0)),
        ("Jones–Harris", solution(Model::JonesHarris, 0.1, 0.0)),
    ]
}

pub fn borrowed<'a>(runs: &'a [(&'static str, Solution)]) -> Vec<(&'static str, &'a Solution)> {
    runs.iter().map(|(label, solution)| (*label, solution)).collect()
}

/// Peak pressures of Zhang et al. 2025, Table 5, in GPa, given to 0.01 GPa.
pub fn table_5() -> Vec<Published> {
    let azimuth = [0.0, 60.0, 120.0, 180.0, 240.0, 300.0];
    let inner = [2.46, 2.28, 1.94, 1.79, 1.94, 2.28];
    let outer = [2.30, 2.17, 1.94, 1.85, 1.94, 2.17];
    [(Quantity::PeakPressureInner, inner), (Quantity::PeakPressureOuter, outer)]
        .into_iter()
        .map(|(quantity, gpa)| Published {
            quantity,
            label: "Published (Table 5)".to_owned(),
            run: None,
            points: azimuth.into_iter().zip(gpa.map(|p| 1e9 * p)).collect(),
            uncertainty: Some(0.005e9),
        })
        .collect()
}

pub fn figures() -> Vec<Figure> {
    solution_figures(&borrowed(&runs()), &table_5()).expect("the synthetic data are complete")
}

pub fn traction_curve_and_convergence() -> Figure {
    let curve = |a: f64, b: f64, c: f64| {
        (0..=400).map(|i| 0.03 * f64::from(i)).map(|s| (s, (a + b * s) * (-c * s).exp() - a)).collect::<Vec<_>>()
    };
    let traction = LineChart::new(
        "Traction curves, Ag",
        Axis::new("Slide-to-roll ratio", "%"),
        Axis::new("Traction coefficient", "").covering(0.0, 0.15),
        vec![
            Series::line("2.5 GPa", curve(-0.124, 0.079, 0.698)),
            Series::line("3.0 GPa", curve(-0.116, 0.066, 0.648)),
            Series::line("3.5 GPa", curve(-0.102, 0.062, 0.513)),
            Series {
                of: Some("2.5 GPa".into()),
                uncertainty: Some(0.003),
                ..Series::points("Peak at 2.5 GPa", vec![(3.0023, 0.13792)])
            },
        ],
    );
    let order =
        |factor: f64, order: i32| (1..=6).map(|k| (10.0 * 2f64.powi(k), factor * 2f64.powi(-k * order))).collect();
    let convergence = LineChart::new(
        "Patch rules",
        Axis::new("Points in the patch", ""),
        Axis::new("Error of traction over load", ""),
        vec![Series::marked("Midpoint", order(2e-3, 1)), Series::marked("Split strips", order(4e-3, 4))],
    )
    .log_log();
    Figure::new(
        "traction",
        "Traction curves & convergence",
        &[Panel::Cartesian(traction), Panel::Cartesian(convergence)],
    )
    .expect("finite and positive data")
}
