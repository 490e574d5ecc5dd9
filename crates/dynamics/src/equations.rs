//! The equations of motion of section 5 of the model, in two parts: springs and friction.
//!
//! Both parts are written once. The explicit schemes add them, the fast scheme takes its drift from the first and its
//! kick from the second, samples and energies come from the same two. A test leaves a term out by replacing a part.
//!
//! Accelerations of a ball by its forces are those of `tribodyn_bearing::Bearing::ball_motion`.

use crate::layout::{AXIAL, AZIMUTH, BALL, OMEGA, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;
use tribodyn_bearing::{
    AzimuthFrame, BallFriction, BallLoads, BallSize, BallState, CagePose, ContactForces, LoadedPatch, NormalContact,
    NormalLoads, PocketLoad, RaceContact, Races, RingState, Side, Sliding,
};
use tribodyn_traction::PatchTraction;
use tribodyn_wear::LocalSurface;

/// Rings and cage at a time.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame {
    pub rings: Races<RingState>,
    /// Angles turned by the rings, rad.
    pub angles: Races<f64>,
    /// Cage angle (rad) and speed (rad/s).
    pub cage: [f64; 2],
    /// Where the cage is, if it is free.
    pub free_cage: Option<CagePose>,
    /// Orientations of the balls that are not round, in the order of [`crate::ball_surfaces::BallSurfaces`].
    pub orientations: Vec<[f64; 4]>,
}

/// The spring part: all that acts through the normals of the contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Springs {
    pub normal: NormalLoads,
    /// Normal forces on the ball [a, r, t], N.
    pub force: [f64; 3],
}

/// The friction part: traction, drag, churning and the pocket.
pub(crate) type Friction = BallFriction;

/// A ball between its races and in the fluid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Touched {
    pub state: BallState,
    pub surfaces: Races<LocalSurface>,
    pub loads: BallLoads,
    pub pocket: PocketLoad,
    /// Lead over the middle of the pocket, rad.
    pub lead: f64,
}

/// One ball with all that acts on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallForces {
    pub state: BallState,
    pub surfaces: Races<LocalSurface>,
    pub orbit_radius: f64,
    pub contacts: Races<RaceContact>,
    pub friction: Friction,
    pub lead: f64,
    /// Of the axial and radial velocity (m/s²), the orbital speed and the angular velocity (rad/s²).
    pub acceleration: [f64; 6],
}

impl BallForces {
    /// Its contacts and what the fluid does.
    #[inline(always)]
    pub fn loads(&self) -> BallLoads {
        let BallFriction { drag, churning, .. } = self.friction;
        BallLoads { contacts: self.contacts, orbit_radius: self.orbit_radius, drag, churning }
    }
}

/// The equations of a machine, part by part.
pub(crate) trait Equations {
    fn machine(&self) -> &Machine;

    fn machine_mut(&mut self) -> &mut Machine;

    /// State of a ball of a size at a position from its unknowns `b`.
    #[inline(always)]
    fn state_at(&self, (frame, size): (AzimuthFrame, BallSize), position: [f64; 2], b: &[f64]) -> BallState {
        BallState {
            frame,
            position,
            velocity: [b[VELOCITY], b[VELOCITY + 1]],
            orbital_speed: b[ORBIT],
            angular_velocity: [b[OMEGA], b[OMEGA + 1], b[OMEGA + 2]],
            size,
        }
    }

    /// The spring part of a ball that is pressed like this.
    #[inline(always)]
    fn springs(&self, normal: NormalLoads) -> Springs {
        Springs { force: normal.on_ball(), normal }
    }

    /// How a ball slides on a race.
    #[inline(always)]
    fn sliding(&self, side: Side, contact: &NormalContact, state: &BallState, at: (&RingState, f64)) -> Sliding {
        self.machine().bearing.sliding(side, contact, state, at)
    }

    /// The friction part of a ball under the tractions of its contacts, the fluid and its pocket.
    #[inline(always)]
    fn friction(
        &self,
        traction: &Races<ContactForces>,
        fluid: (f64, [f64; 3]),
        pocket: PocketLoad,
        orbit_radius: f64,
    ) -> Friction {
        BallFriction::new(traction, fluid, (pocket, self.machine().pocket_arm(orbit_radius)), orbit_radius)
    }

    /// Accelerations of a ball by the spring part: axial, radial, orbital.
    #[inline(always)]
    fn spring_acceleration(&self, springs: &Springs, state: &BallState) -> [f64; 3] {
        self.machine().bearing.spring_acceleration(springs.force, springs.normal.orbit_radius, state)
    }

    /// Accelerations of a ball by the friction part.
    #[inline(always)]
    fn friction_acceleration(&self, state: &BallState, friction: &Friction, orbit_radius: f64) -> [f64; 6] {
        self.machine().bearing.friction_acceleration(state, friction, orbit_radius)
    }

    /// Friction part and accelerations of a ball under all that acts on it.
    #[inline(always)]
    fn motion(&self, state: &BallState, loads: &BallLoads, pocket: PocketLoad) -> (Friction, [f64; 6]) {
        let machine = self.machine();
        machine.bearing.ball_motion(state, loads, (pocket, machine.pocket_arm(loads.orbit_radius)))
    }

    /// One ball with all that acts on it; `b` are its unknowns, `traction` integrates over a patch that slides so.
    fn ball(
        &self,
        index: usize,
        b: &[f64],
        frame: &Frame,
        mut traction: impl FnMut(&LoadedPatch<'_, f64>, &Sliding) -> PatchTraction,
    ) -> BallForces {
        let machine = self.machine();
        let (axes, position, surfaces) = machine.place(index, b, frame);
        let state = self.state_at((axes, machine.bearing.ball_size(index)), position, b);
        let normal = machine.normal_loads(&state, &surfaces, frame);
        let r = normal.orbit_radius;
        let mut contacts = Races::from_fn(|side| {
            let contact = normal.contacts[side];
            let sliding = self.sliding(side, &contact, &state, (&frame.rings[side], r));
            let traction = |patch: &LoadedPatch<'_, f64>| traction(patch, &sliding);
            machine.bearing.race_contact(side, contact, &sliding, surfaces[side].bare, traction)
        });
        for side in Side::BOTH {
            let RaceContact { normal, moment, .. } = &mut contacts[side];
            (0..3).for_each(|k| moment[k] += normal.force * surfaces[side].turn[k]);
        }
        let (drag, churning) = machine.bearing.fluid_loads(&state, r, frame.rings.inner.speed);
        let loads = BallLoads { contacts, orbit_radius: r, drag, churning };
        let (pocket, lead) = machine.in_pocket(index, b, frame);
        self.together(Touched { state, surfaces, loads, pocket, lead })
    }

    /// A ball of which all is known that touches it.
    #[inline(always)]
    fn together(&self, touched: Touched) -> BallForces {
        let Touched { state, surfaces, loads, pocket, lead } = touched;
        let (friction, acceleration) = self.motion(&state, &loads, pocket);
        let BallLoads { contacts, orbit_radius, .. } = loads;
        BallForces { state, surfaces, orbit_radius, contacts, friction, lead, acceleration }
    }
}

impl Frame {
    /// The same with tilts held, no free cage and no orientations, for loops over the lanes of balls whose rings do not
    /// tilt and whose surfaces are known: what a free cage does is left to others.
    #[inline(always)]
    pub fn held(&self) -> Self {
        let rings = Races { inner: self.rings.inner.held(), outer: self.rings.outer.held() };
        Self { rings, angles: self.angles, cage: self.cage, free_cage: None, orientations: Vec::new() }
    }
}

impl Equations for Machine {
    #[inline]
    fn machine(&self) -> &Machine {
        self
    }

    #[inline]
    fn machine_mut(&mut self) -> &mut Machine {
        self
    }
}

impl Machine {
    /// Rings and cage of a state.
    pub fn frame(&self, t: f64, y: &[f64]) -> Frame {
        let frame = self.frame_of_rings(t, y);
        Frame { free_cage: self.cage_at(y).1, ..frame }
    }

    /// The same without the pose of a free cage, for what the cage has no part in.
    pub fn frame_of_rings(&self, t: f64, y: &[f64]) -> Frame {
        let l = self.layout;
        let [i, o, a] = [l.inner(), l.outer(), l.angles()];
        let tilted = self.tilts_at(y);
        let inner = RingState {
            displacement: [y[i], y[i + 1], y[i + 2]],
            tilt: tilted.inner.0,
            velocity: [y[i + 3], y[i + 4], y[i + 5]],
            speed: self.speeds.inner.at(t),
            turning: tilted.inner.1,
        };
        let outer = RingState {
            displacement: [y[o], y[o + 1], 0.0],
            tilt: tilted.outer.0,
            velocity: [y[o + 2], y[o + 3], 0.0],
            speed: self.speeds.outer.at(t),
            turning: tilted.outer.1,
        };
        let (at, angles) = (l.cage(), [y[a], y[a + 1]].into());
        let (cage, orientations) = ([y[at], y[at + 1]], self.orientations_at(y));
        Frame { rings: Races { inner, outer }, angles, cage, free_cage: None, orientations }
    }

    /// Axes of a ball with its number and the unknowns `b`, its centre against the outer groove centre, and the
    /// surfaces under it.
    #[inline]
    pub fn place(&self, index: usize, b: &[f64], frame: &Frame) -> (AzimuthFrame, [f64; 2], Races<LocalSurface>) {
        let axes = AzimuthFrame::at(b[AZIMUTH]);
        let surfaces = Races::from_fn(|side| self.surface(side, index, Self::seen_from(side, axes, b, frame), frame));
        let groove = self.bearing.geometry.groove_centre_radius(Side::Outer);
        (axes, Self::position(axes, [b[AXIAL], b[RADIUS]], frame, groove), surfaces)
    }

    /// Azimuth of a ball with the unknowns `b` in the frame of a ring, rad.
    #[inline]
    pub fn on_ring(side: Side, axes: AzimuthFrame, b: &[f64], frame: &Frame) -> f64 {
        Self::seen_from(side, axes, b, frame)[0]
    }

    /// Azimuth of a ball with the unknowns `b` in the frame of a ring, and how far it stands behind its own azimuth,
    /// seen from the ring's axis, rad.
    #[inline(always)]
    pub fn seen_from(side: Side, axes: AzimuthFrame, b: &[f64], frame: &Frame) -> [f64; 2] {
        let (ring, angle) = match side {
            Side::Inner => (&frame.rings.inner, frame.angles.inner),
            Side::Outer => (&frame.rings.outer, frame.angles.outer),
        };
        let [_, radial, along] = axes.from_inertial(ring.displacement);
        let behind = along / (b[RADIUS] - radial);
        [b[AZIMUTH] - behind - angle, behind]
    }

    /// How hard a ball is pressed on its races.
    #[inline]
    pub fn normal_loads(&self, state: &BallState, surfaces: &Races<LocalSurface>, frame: &Frame) -> NormalLoads {
        self.bearing.normal_loads(state, frame.rings.each_ref(), surfaces.each_ref())
    }

    /// A ball's centre, by its axial position and the radius of its orbit, against the outer groove centre, which is at
    /// a radius of its own.
    #[inline(always)]
    pub fn position(axes: AzimuthFrame, [axial, radius]: [f64; 2], frame: &Frame, groove: f64) -> [f64; 2] {
        let centre = axes.from_inertial(frame.rings.outer.displacement);
        [axial, radius - centre[1] - groove]
    }

    /// Surfaces of raceways that nothing has happened to.
    pub fn new_surfaces(&self) -> Races<LocalSurface> {
        Races::from_fn(|side| LocalSurface { depth: -self.bearing.worn[side].depth, ..LocalSurface::NEW })
    }

    /// Surface of a raceway under a ball that is [`Self::seen_from`] it so; what had worn off all round at the start is
    /// in the pose of the ball.
    #[inline]
    pub fn surface(&self, side: Side, ball: usize, [azimuth, behind]: [f64; 2], frame: &Frame) -> LocalSurface {
        let mut surface = self.raceways[side].at(azimuth);
        surface.depth -= self.bearing.worn[side].depth;
        if !self.bearing.deviations.are_none() {
            let (depth, slope) = self.bearing.deviations.at(side, ball, azimuth);
            surface.depth += depth;
            surface.slope += slope;
        }
        for spall in &self.spalls[side] {
            let (depth, slope) = spall.at(azimuth);
            surface.depth += depth;
            surface.slope += slope;
        }
        self.ball_surfaces.add_to(&mut surface, (side, ball), (&frame.orientations, behind));
        surface
    }

    /// True while every race is round and as it was when the run began, and all balls are equal.
    pub fn is_even(&self) -> bool {
        let as_new = |side| self.raceways[side].is_new() && self.spalls[side].is_empty();
        Side::BOTH.into_iter().all(as_new) && self.bearing.deviations.are_none() && self.ball_surfaces.are_round()
    }

    /// True where a race or a ball has a place at which balls strike.
    pub fn is_damaged(&self) -> bool {
        let struck = |side| !self.raceways[side].is_new() || !self.spalls[side].is_empty();
        Side::BOTH.into_iter().any(struck) || !self.ball_surfaces.spalls().is_empty()
    }

    /// The unknowns of a ball.
    #[inline]
    pub fn unknowns<'a>(&self, index: usize, y: &'a [f64]) -> &'a [f64] {
        &y[self.layout.ball(index)..][..BALL]
    }
}
