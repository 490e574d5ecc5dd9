//! The cage as a body: its pockets, and what drives and brakes it.

use crate::bearing::Bearing;
use crate::modelling::PocketForce;
use crate::pocket::{Pocket, hypot};
use crate::races::{Races, Side};
use crate::run_inputs::{GuidingLand, MovingCage, PocketFilm};
use num_dual::{Dual64, first_derivative};
use tribodyn_contact::Scalar;
use tribodyn_fluid::{AnnulusDrag, CageChurning, SqueezeFilm};

/// A cage that turns about the bearing's axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CageBody {
    /// Its pockets.
    pub pocket: Pocket,
    /// Moment of inertia about the bearing's axis, kg m².
    pub inertia: f64,
    /// Constant torque against the rotation, N m.
    pub drag_torque: f64,
    /// The land that guides it; none where the balls alone do.
    pub guidance: Option<Guidance>,
    /// Braking by the fluid round it, and the speed of the fluid over that of the inner ring; none in a dry bearing.
    pub churning: Option<(CageChurning, f64)>,
}

/// The land that guides a cage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guidance {
    /// The fluid film.
    pub land: AnnulusDrag,
    /// The ring with the land.
    pub side: Side,
}

/// Cage speed below which a constant drag torque falls off in proportion, rad/s, so that it does not start a cage at
/// rest.
const STANDSTILL: f64 = 1.0;

impl CageBody {
    /// The cage between the rings of a bearing; its pockets stand on the pitch circle. A dry bearing has no film to
    /// guide it.
    pub fn new(cage: &MovingCage, bearing: &Bearing) -> Self {
        let MovingCage { pockets, pocket_friction, pocket_damping, pocket_film, inertia, guidance: land } = *cage;
        let radius = 0.5 * bearing.geometry.pitch_diameter;
        let pocket = Pocket {
            radius,
            clearance: pockets.pocket_gap / radius,
            stiffness: pockets.pocket_stiffness,
            damping: pocket_damping,
            friction: pocket_friction,
            ball_radius: bearing.geometry.ball_radius(),
            force: bearing.modelling.pocket_force.unwrap_or(PocketForce::FromWall),
            film: pocket_film.and_then(|film| squeezed(film, pockets.pocket_gap, bearing)),
        };
        let film = |GuidingLand { side, radius, width, gap }| {
            let fluid = bearing.fluid.as_ref()?;
            let (density, viscosity) = (fluid.density, fluid.viscosity);
            Some(Guidance { land: AnnulusDrag { density, viscosity, radius, width, gap }, side })
        };
        let swirl = bearing.fluid.as_ref().map_or(0.0, |fluid| fluid.swirl);
        let churning = pockets.churning(bearing).map(|churning| (churning, swirl));
        Self { pocket, inertia, drag_torque: pockets.drag_torque, guidance: land.and_then(film), churning }
    }

    /// Torques of guidance, and of drag and churning, on the cage, N m. The ring with the land carries the reaction of
    /// the first.
    pub fn fluid_torques<D: Scalar>(&self, speed: D, rings: Races<D>) -> [D; 2] {
        let guidance = self.guidance.map_or(D::zero(), |g| g.land.torque_on_cage(rings[g.side], speed));
        let against = |(churning, swirl): (CageChurning, f64)| churning.moments(speed - rings.inner * swirl).sum();
        let churned = self.churning.map_or(D::zero(), against);
        [guidance, speed * -self.drag_torque / hypot(speed, D::from(STANDSTILL)) - churned]
    }

    /// The sum of these torques, N m, and its slope by the cage's speed, N m s.
    pub fn fluid_torque_and_slope(&self, speed: f64, rings: Races<f64>) -> (f64, f64) {
        let rings = Races { inner: Dual64::from(rings.inner), outer: Dual64::from(rings.outer) };
        let sum = |speed| {
            let [guidance, drag] = self.fluid_torques(speed, rings);
            guidance + drag
        };
        first_derivative(sum, speed)
    }
}

/// The oil of a bearing between a ball and the wall of its pocket, a cylinder with its axis radial; none in a bearing
/// without oil.
fn squeezed(film: PocketFilm, gap: f64, bearing: &Bearing) -> Option<SqueezeFilm> {
    let viscosity = bearing.film_law(Side::Inner)?.inlet.viscosity;
    let ball = bearing.geometry.ball_radius();
    let about = ball * (ball + gap) / gap;
    Some(SqueezeFilm::new(film.fill * viscosity, [about, ball], film.roughness))
}
