//! A millisecond of a silver-coated bearing from its equilibrium, by plain inputs in SI units and without a case file.

use std::error::Error;
use tribodyn_dynamics::*;
use tribodyn_traction::{Coating, CoatingLaw, SlipUnit};
use tribodyn_wear::Archard;

fn main() -> Result<(), Box<dyn Error>> {
    let (ball_count, ball_diameter, pitch_diameter, fit) = (13, 30.16e-3, 165e-3, Fit::ContactAngle(0.314));
    let (inner_coefficient, outer_coefficient) = (0.527, 0.527);
    let size = Dimensions { ball_count, ball_diameter, pitch_diameter, inner_coefficient, outer_coefficient, fit };
    let steel = (ElasticBody { young: 208e9, poisson: 0.28 }, 7800.0);
    let (silver, wear) =
        (CoatingLaw::varying(&Coating::library("ag")?, 2)?, Archard { coefficient: 1e-6, hardness: 250e6 });
    let tribology = Some(Tribology::of_one(silver.into(), SlipUnit::Scaled { per_m_s: 22.0 }, wear));
    let spec = BearingSpec::new(Geometry::new(size)?, steel, Modelling::with_traction(false, RingCentre::Displaced));
    let bearing = Bearing::new(BearingSpec { tribology, ..spec })?;
    let pockets = Cage { pocket_gap: 0.2e-3, pocket_stiffness: 5e6, drag_torque: 0.0, form: None };
    let cage = MovingCage {
        pockets,
        pocket_friction: 0.1,
        pocket_damping: 0.3,
        pocket_film: None,
        inertia: 2e-3,
        guidance: None,
    };
    let inner = Support { mass: 12.0, stiffness: [0.0; 3], damping: [2e3; 3] };
    let outer = Support { mass: 5.0, stiffness: [5e8; 2], damping: [5e3; 2] };
    let drives = (RingLoads::forces([20e3, 0.0, 44e3]), [1466.0, 0.0].map(SpeedHistory::Constant).into());
    let options = RunOptions::new(1e-3, Scheme::Fast { step: 10e-6 }, 0.02);
    let mut run = Run::new(RunInputs::new(bearing, drives, cage, Supports { inner, outer }, options))?;
    let _ = run.advance(f64::INFINITY, &mut ())?;
    println!("cage {:.1} rad/s after {:.1} ms", run.sample().cage.speed_rad_s, run.time() * 1e3);
    Ok(())
}
