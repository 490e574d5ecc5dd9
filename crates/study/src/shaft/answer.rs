//! Results for a shaft in equilibrium.

use super::RPM_PER_RAD_S;
use super::build::Running;
use super::file::ShaftFile;
use super::preloads;
use crate::error::StudyError;
use crate::held::{elastic, held_pressure, held_solution};
use serde::Serialize;
use tribodyn::AnswerError;
use tribodyn::answers::{Fits, fits};
use tribodyn::plausibility::{peak_pressure, solution_findings};
use tribodyn::rating::{Rating, rating};
use tribodyn_case::Carries;
use tribodyn_quasistatic::{Solution, StiffnessMatrix};
use tribodyn_shaft::{Equilibrium, RestingBearing, Vector};

/// A place on the shaft.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Station {
    /// Distance from the start of the shaft, m.
    pub position_m: f64,
    /// Displacement x, y, z, m.
    pub displacement_m: [f64; 3],
    /// Tilt about X and Y, rad: the slope of the shaft.
    pub tilt_rad: [f64; 2],
    /// Shear force along x and y at the cut with the larger bending moment, N.
    pub shear_force_n: [f64; 2],
    /// Axial force there, above 0 for tension, N.
    pub axial_force_n: f64,
    /// Bending moment about X and Y there, N m.
    pub bending_moment_nm: [f64; 2],
    /// Torque there, N m.
    pub torque_nm: f64,
    /// Nominal bending stress, Pa, without notches.
    pub bending_stress_pa: f64,
    /// Nominal equivalent stress (von Mises), Pa.
    pub equivalent_stress_pa: f64,
}

/// A cut beside a node, before or beyond what comes in there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CutAnswer {
    /// Distance from the start of the shaft, m.
    pub position_m: f64,
    /// Bending moment about X and Y, N m.
    pub bending_moment_nm: [f64; 2],
    /// Torque, N m.
    pub torque_nm: f64,
}

/// A bearing on its shaft.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BearingAnswer {
    /// Its name.
    pub name: String,
    /// Distance of its middle from the start of the shaft, m.
    pub position_m: f64,
    /// Force of the bearing on the shaft: x, y, z, N.
    pub reaction_n: [f64; 3],
    /// Moment of the bearing on the shaft about its own middle: X, Y, N m.
    pub reaction_moment_nm: [f64; 2],
    /// Radial load, N.
    pub radial_load_n: f64,
    /// Axial load, N.
    pub axial_load_n: f64,
    /// Displacement of the inner against the outer ring from where it stands without load: x, y, z of the shaft, m.
    pub ring_displacement_m: [f64; 3],
    /// Tilt of the inner against the outer ring about X and Y, rad.
    pub ring_tilt_rad: [f64; 2],
    /// Balls that carry load on the inner race.
    pub loaded_balls: usize,
    /// Largest load of a ball on the inner race, N.
    pub ball_load_max_n: f64,
    /// Highest peak pressure of all contacts, Pa; absent where the balls have no equilibrium of their own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_pressure_max_pa: Option<f64>,
    /// Least and largest contact angle of the loaded balls on the inner race, rad.
    pub contact_angle_rad: [f64; 2],
    /// Stiffness against the ring's displacement in the shaft's axes, by rows: N, N m over m, rad.
    pub stiffness: StiffnessMatrix,
    /// Radial internal clearance in operation, m.
    pub radial_clearance_m: f64,
    /// Fits by tolerance class, and the clearance over their range; absent where no seat has a class.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fits: Option<Fits>,
    /// Ratings and lives; absent where the standards do not rate the bearing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rating: Option<Rating>,
    /// Warnings about this bearing.
    pub warnings: Vec<String>,
}

/// A shaft in equilibrium.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShaftAnswer {
    /// Speed of the shaft, r/min.
    pub speed_rpm: f64,
    /// Mass of the shaft with its discs, kg.
    pub mass_kg: f64,
    /// Bearings.
    pub bearings: Vec<BearingAnswer>,
    /// Nodes of the shaft.
    pub stations: Vec<Station>,
    /// Both ends of every element, where moments and torques jump at the nodes between them.
    pub cuts: Vec<CutAnswer>,
    /// Largest residual over the largest force.
    pub residual: f64,
    /// Sum of loads and reactions over the largest force or moment.
    pub unbalanced: f64,
    /// Warnings about the shaft.
    pub warnings: Vec<String>,
}

/// Share of the largest torque that may be left over.
const TORQUE: f64 = 1e-6;
/// Share of the largest ball load below which a ball counts as unloaded.
const UNLOADED: f64 = 1e-6;

impl ShaftAnswer {
    /// The shaft under its loads times a factor at a speed, rad/s.
    ///
    /// # Errors
    /// [`StudyError::Shaft`] and what is wrong with a bearing, loads under which no contact is elastic among it.
    pub fn at(file: &ShaftFile, speed: f64, factor: f64) -> Result<Self, StudyError> {
        let running = Running::new(file, speed, factor)?;
        let found = running.equilibrium(None)?;
        let of_preload = preloads::changed(file).into_iter().enumerate();
        let bearings = of_preload.map(|(index, sentence)| {
            let mut answer = bearing(file, &running, &found, index)?;
            answer.warnings.extend(sentence);
            Ok(answer)
        });
        Ok(Self {
            speed_rpm: running.speed * RPM_PER_RAD_S,
            mass_kg: running.shaft().mass(),
            bearings: bearings.collect::<Result<_, StudyError>>()?,
            stations: stations(&running, &found),
            cuts: cuts(&running, &found),
            residual: found.residual,
            unbalanced: found.unbalanced,
            warnings: warnings(&running, &found),
        })
    }
}

fn warnings(running: &Running<'_>, found: &Equilibrium) -> Vec<String> {
    let mut all: Vec<String> = found
        .loose
        .iter()
        .map(|direction| {
            format!("nothing holds the shaft {direction}: it stands where the solver left it, one of many equilibria")
        })
        .collect();
    let torques = running.torques();
    let (sum, largest) = torques.iter().fold((0.0, 0.0f64), |(sum, most), t| (sum + t, most.max(t.abs())));
    if f64::abs(sum) > TORQUE * largest {
        all.push(format!(
            "the torques make {sum:.3} N m: at a steady speed they make 0 but for the bearings' friction; torque and \
             equivalent stress are counted from the start of the shaft"
        ));
    }
    all
}

fn bearing(
    file: &ShaftFile,
    running: &Running<'_>,
    found: &Equilibrium,
    index: usize,
) -> Result<BearingAnswer, StudyError> {
    let spec = &file.system.bearings[index];
    let (reaction, node) = (found.reactions[index], running.node(spec.at));
    let against: Vector = std::array::from_fn(|k| found.nodes[node][k] - found.seats[index][k]);
    let (own, case) = (&running.bearings[index], file.case_at(index, running.speed));
    let solution = held_solution(own, running.point(index), found.rings[index]);
    let place = file.bearing_name(index);
    elastic(&place, held_pressure(own, found.rings[index], solution.as_ref()))?;
    let balls = Balls::of(running, found, index, solution.as_ref());
    let rated = solution.as_ref().map(|s| rating(&case, Some(s)));
    let mut warnings = balls.warnings(spec.carries);
    let of_balls = solution.as_ref().map(|s| solution_findings(&case, own, s)).transpose();
    let of_balls = of_balls.map_err(|source| AnswerError::Bearing { file: place, source })?;
    warnings.extend(of_balls.into_iter().flat_map(|found| found.sentences));
    match &rated {
        Some(Err(why)) => warnings.push(format!("no rating life: {why}")),
        None => {
            warnings.push("the balls have no equilibrium of their own here: no pressures, no rating".to_owned());
        }
        Some(Ok(_)) => {}
    }
    Ok(BearingAnswer {
        name: spec.name.clone(),
        position_m: spec.at,
        reaction_n: [reaction[0], reaction[1], reaction[2]],
        reaction_moment_nm: [reaction[3], reaction[4]],
        radial_load_n: reaction[0].hypot(reaction[1]),
        axial_load_n: reaction[2].abs(),
        ring_displacement_m: [against[0], against[1], against[2]],
        ring_tilt_rad: [against[3], against[4]],
        loaded_balls: balls.loaded,
        ball_load_max_n: balls.most,
        peak_pressure_max_pa: solution.as_ref().map(peak_pressure),
        contact_angle_rad: balls.angles,
        stiffness: found.stiffnesses[index],
        radial_clearance_m: own.geometry.radial_clearance(),
        // Bearings that run have a mounting that was checked.
        fits: fits(&case).ok().flatten(),
        rating: rated.and_then(Result::ok),
        warnings,
    })
}

/// Loads and angles of a bearing's balls on the inner race.
struct Balls {
    most: f64,
    loaded: usize,
    angles: [f64; 2],
}

impl Balls {
    /// Of a solution; without one those of the bearing at rest.
    fn of(running: &Running<'_>, found: &Equilibrium, index: usize, solution: Option<&Solution>) -> Self {
        let bearing = &running.bearings[index];
        let resting = RestingBearing { bearing, first_ball: 0.0 };
        let balls: Vec<(f64, f64)> = match solution {
            Some(s) => s.balls.iter().map(|b| (b.contacts.inner.load_n, b.contacts.inner.angle_rad)).collect(),
            None => (0..bearing.geometry.ball_count)
                .map(|k| {
                    let ball = resting.ball(resting.azimuth(k), found.rings[index]);
                    (ball.load, ball.sin.atan2(ball.cos))
                })
                .collect(),
        };
        let most = balls.iter().fold(0.0f64, |m, ball| m.max(ball.0));
        let loaded: Vec<f64> = balls.iter().filter(|ball| ball.0 > UNLOADED * most).map(|ball| ball.1).collect();
        let range =
            loaded.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], a| [low.min(*a), high.max(*a)]);
        Self { most, loaded: loaded.len(), angles: if loaded.is_empty() { [0.0; 2] } else { range } }
    }

    fn warnings(&self, carries: Carries) -> Vec<String> {
        let mut warnings = Vec::new();
        if carries != Carries::Both && self.angles[0] < 0.0 {
            warnings.push("balls bear on the side on which an angular-contact bearing has no shoulder".to_owned());
        }
        if carries != Carries::Both && self.loaded == 0 {
            warnings.push("no ball carries load: the preload is lost".to_owned());
        }
        warnings
    }
}

fn cuts(running: &Running<'_>, found: &Equilibrium) -> Vec<CutAnswer> {
    let (torques, mut carried) = (running.torques(), 0.0);
    let mut all = Vec::with_capacity(2 * found.nodes.len());
    for (element, ends) in running.shaft().cuts(&found.nodes).iter().enumerate() {
        carried += torques[element];
        all.extend(ends.iter().map(|cut| CutAnswer {
            position_m: cut.position,
            bending_moment_nm: [cut.force[3], cut.force[4]],
            torque_nm: -carried,
        }));
    }
    all
}

fn stations(running: &Running<'_>, found: &Equilibrium) -> Vec<Station> {
    let cuts = running.shaft().cuts(&found.nodes);
    let torques = running.torques();
    let mut carried = 0.0;
    let mut all = Vec::with_capacity(found.nodes.len());
    for (node, moved) in found.nodes.iter().enumerate() {
        // The cut before the node carries what came in before it, the one beyond it what comes in here too.
        let before = node.checked_sub(1).map(|element| (cuts[element][1], -carried));
        carried += torques[node];
        let beyond = cuts.get(node).map(|ends| (ends[0], -carried));
        let stress = |(cut, torque): &(tribodyn_shaft::Cut, f64)| cut.equivalent_stress(*torque);
        let worst = before.into_iter().chain(beyond).max_by(|a, b| stress(a).total_cmp(&stress(b)));
        let Some((cut, torque)) = worst else { continue };
        let [shear_x, shear_y, axial, about_x, about_y] = cut.force;
        all.push(Station {
            position_m: running.positions()[node],
            displacement_m: [moved[0], moved[1], moved[2]],
            tilt_rad: [moved[3], moved[4]],
            shear_force_n: [shear_x, shear_y],
            axial_force_n: axial,
            bending_moment_nm: [about_x, about_y],
            torque_nm: torque,
            bending_stress_pa: cut.bending_stress(),
            equivalent_stress_pa: cut.equivalent_stress(torque),
        });
    }
    all
}
