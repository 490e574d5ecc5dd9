//! The equations of one ball on its way round, generic over the scalar: the forces are those of `tribodyn-bearing`.

use std::f64::consts::TAU;
use tribodyn_bearing::{
    AzimuthFrame, BallFriction, BallLoads, BallSize, BallState, Bearing, CageBody, LoadedPatch, LocalSurface,
    PocketLoad, PocketMotion, Races, RingFreedom, RingState, Scalar, Side,
};
use tribodyn_traction::{FastPatch, PatchTraction};

/// Freedoms of the inner ring.
pub(crate) const RING: usize = 5;
/// Least speed of a cage over that of the inner ring where the outer one stands: usual are 0.35 to 0.45.
const OF_RINGS: f64 = 0.3;
/// Unknowns of a ball: position X1, X2 against the unmoved outer groove centre (m), lead over its pocket (rad), axial
/// and radial velocity (m/s), orbital speed and absolute angular velocity (axial, radial, tangential) (rad/s).
pub(crate) const BALL: usize = 9;
pub(crate) const LEAD: usize = 2;
pub(crate) const VELOCITY: usize = 3;
pub(crate) const ORBIT: usize = 5;
pub(crate) const OMEGA: usize = 6;

/// A bearing with its cage between two rings that turn steadily.
pub(crate) struct OrbitSystem<'a> {
    pub bearing: &'a Bearing,
    pub surfaces: Races<LocalSurface>,
    pub cage: CageBody,
    pub speeds: Races<f64>,
    pub ring: [RingFreedom; RING],
    pub kernel: FastPatch,
    /// Azimuth at which the turn begins, rad: where a ball is pressed hardest.
    pub origin: f64,
    /// 1 where the balls go round with the azimuth, −1 where against it.
    pub direction: f64,
    /// Stiffness, N/m, that draws a ball to the middle of its pocket: next to nothing, it only settles where a cage
    /// hangs that no ball touches.
    pub centring: f64,
    /// Rate at which the axial and radial motion of balls dies out besides, 1/s.
    pub settling: f64,
    /// Speed at which the cage is held, rad/s; none where it goes as fast as the torques on it let it.
    pub held: Option<f64>,
}

/// A ball at a state.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Evaluation<D = f64> {
    pub state: BallState<D>,
    pub loads: BallLoads<D>,
    pub friction: BallFriction<D>,
    /// Time derivatives of the unknowns.
    pub rate: [D; BALL],
    /// Forces (x, y, z) and moments (about x, y) of the inner ring on the ball.
    pub ring: [D; RING],
    /// Forces (x, y) of the outer ring on the ball.
    #[cfg_attr(not(feature = "modes"), expect(dead_code, reason = "asked for by modes"))]
    pub outer: [D; 2],
    /// Torque of the inner ring on the ball about the ring's axis, N m.
    pub torque: D,
    /// Torque of the ball on the cage, N m.
    pub cage_torque: D,
}

impl Evaluation {
    /// Magnitude of the forces on the ball, N.
    pub fn force_scale(&self, mass: f64) -> f64 {
        let centrifugal = mass * self.loads.orbit_radius * self.state.orbital_speed.powi(2);
        let contacts = Side::BOTH.map(|side| self.loads.contacts[side].normal.force.abs());
        contacts[0] + contacts[1] + centrifugal + self.friction.drag.abs() + self.friction.pocket.force.abs()
    }
}

/// Inner ring where its freedoms stand, the outer one in the centre.
pub(crate) fn rings<D: Scalar>(ring: [D; RING], speeds: Races<f64>) -> Races<RingState<D>> {
    let [x, y, z, tilt @ ..] = ring;
    let inner = RingState { displacement: [x, y, z], tilt, ..RingState::centred(D::from(speeds.inner)) };
    Races { inner, outer: RingState::centred(D::from(speeds.outer)) }
}

impl OrbitSystem<'_> {
    /// A ball whose pocket stands at an azimuth, rad.
    pub fn ball<D: Scalar>(
        &self,
        pocket_azimuth: D,
        unknowns: &[D; BALL],
        cage_speed: D,
        rings: &Races<RingState<D>>,
        traction: impl FnMut(&LoadedPatch<'_, D>) -> PatchTraction<D>,
    ) -> Evaluation<D> {
        let &[x1, x2, lead, v_a, v_r, orbit, angular_velocity @ ..] = unknowns;
        let (bearing, pocket) = (self.bearing, &self.cage.pocket);
        let (sin, cos) = (pocket_azimuth + lead).sin_cos();
        let frame = AzimuthFrame { sin, cos };
        let outer = frame.from_inertial(rings.outer.displacement);
        let state = BallState {
            frame,
            position: [x1 - outer[0], x2 - outer[1]],
            velocity: [v_a, v_r],
            orbital_speed: orbit,
            angular_velocity,
            size: BallSize::NOMINAL,
        };
        let loads = bearing.ball_loads_with(&state, rings.each_ref(), self.surfaces.each_ref(), traction);
        let r = loads.orbit_radius;
        let rate = orbit - cage_speed;
        let on_ball = self.in_pocket(unknowns, cage_speed);
        let (friction, [a, b, c, about @ ..]) = bearing.ball_motion(&state, &loads, (on_ball, pocket.radius));
        let centring = lead * (self.centring * pocket.radius * pocket.radius);
        let settling = self.settling;
        let orbital = c - centring / (r * r * bearing.ball_mass);
        let [x, y, z, mx, my, torque] = bearing.ring_action(&state, &loads, &rings.inner);
        let reaction = bearing.reaction(Side::Outer, &loads.contacts.outer);
        let [outer_x, outer_y, _] = frame.to_inertial(reaction);
        Evaluation {
            state,
            loads,
            friction,
            rate: [v_a, v_r, rate, a - v_a * settling, b - v_r * settling, orbital, about[0], about[1], about[2]],
            ring: [x, y, z, mx, my],
            outer: [outer_x, outer_y],
            torque,
            cage_torque: on_ball.cage_torque + centring,
        }
    }

    /// Distances that open where contacts end, negative in contact: of the inner and the outer race and of the two
    /// walls of the pocket, m, m, rad, rad.
    pub fn gaps(&self, pocket_azimuth: f64, y: &[f64; BALL], (cage_speed, ring): (f64, [f64; RING])) -> [f64; 4] {
        let without = |_: &LoadedPatch<'_, f64>| PatchTraction::zero();
        let contacts = self.ball(pocket_azimuth, y, cage_speed, &rings(ring, self.speeds), without).loads.contacts;
        let [inner, outer] = Side::BOTH.map(|side| -contacts[side].normal.pose.approach);
        let clearance = self.cage.pocket.clearance;
        [inner, outer, clearance - y[LEAD], clearance + y[LEAD]]
    }

    /// Load of the pocket on a ball with these unknowns.
    pub fn in_pocket<D: Scalar>(&self, unknowns: &[D; BALL], cage_speed: D) -> PocketLoad<D> {
        let &[_, _, lead, v_a, v_r, orbit, omega_a, omega_r, _] = unknowns;
        let motion = PocketMotion {
            lead,
            rate: orbit - cage_speed,
            velocity: [v_a, v_r],
            angular_velocity: [omega_a, omega_r],
            cage_speed,
        };
        self.cage.pocket.load(&motion)
    }

    /// Speed of a cage, or where the rings turn against each other and it hardly moves, of one whose outer ring stood,
    /// rad/s.
    pub fn pace(&self, cage_speed: f64) -> f64 {
        cage_speed.abs().max(OF_RINGS * (self.speeds.inner - self.speeds.outer).abs())
    }

    /// Azimuth of a pocket after a share of a turn, rad.
    pub fn azimuth(&self, turn: f64) -> f64 {
        self.origin + self.direction * TAU * turn
    }

    /// Share of a turn after which a pocket stands at an azimuth, rad.
    pub fn turn(&self, azimuth: f64) -> f64 {
        (self.direction * (azimuth - self.origin) / TAU).rem_euclid(1.0)
    }

    /// Time of a share of a turn, s.
    pub fn time(&self, turn: f64, cage_speed: f64) -> f64 {
        self.direction * TAU * turn / cage_speed
    }

    /// A ball in plain numbers.
    pub fn value(&self, pocket_azimuth: f64, y: &[f64; BALL], cage_speed: f64, ring: [f64; RING]) -> Evaluation {
        let traction = |patch: &LoadedPatch<'_, f64>| self.bearing.fast_traction(patch, &self.kernel);
        self.ball(pocket_azimuth, y, cage_speed, &rings(ring, self.speeds), traction)
    }
}
