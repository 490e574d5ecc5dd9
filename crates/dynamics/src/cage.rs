//! The cage of a run: its pockets against the balls, and where it is free, its lands and its motion.

use crate::equations::Frame;
use crate::forces::{BodyForces, Sums};
use crate::layout::{AXIAL, AZIMUTH, OMEGA, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;
use crate::sample::FreeCageSample;
use tribodyn_bearing::{
    AzimuthFrame, CagePose, FREE_CAGE, FreeCage, InPocket, LandLoad, Pocket, PocketLoad, PocketMotion, Races,
    RingState, Side, Wrench,
};

/// Angle (rad) and speed (rad/s) of a cage, and where it is, if it is free.
pub(crate) type CageAt<'a> = ([f64; 2], Option<&'a CagePose>);

/// Forces, torques and power of the lands on a free cage and on the rings.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Lands {
    pub on_cage: Wrench,
    /// Force on the cage by the lands of a ring, N.
    pub force: Races<[f64; 3]>,
    /// Moments on the rings about their centres, N m.
    pub on_rings: Races<[f64; 3]>,
    /// Torques that the rings' drives have to give for them, N m.
    pub drive: Races<f64>,
    /// Smallest gap left at a ring's lands, m.
    pub gap: Races<Option<f64>>,
    pub friction_power: f64,
    pub damping_power: f64,
    pub film_power: f64,
    pub energy: f64,
}

impl Lands {
    fn add(&mut self, side: Side, load: &LandLoad) {
        self.on_cage.add_at([0.0; 3], load.on_cage.force, load.on_cage.moment);
        for k in 0..3 {
            self.force[side][k] += load.on_cage.force[k];
            self.on_rings[side][k] += load.on_ring[k];
        }
        self.drive[side] += load.drive;
        self.gap[side] = Some(self.gap[side].map_or(load.gap, |gap| gap.min(load.gap)));
        self.friction_power += load.friction_power;
        self.damping_power += load.damping_power;
        self.film_power += load.film_power;
        self.energy += load.energy;
    }

    /// Power that they take, W.
    pub fn losses(&self) -> f64 {
        self.friction_power + self.damping_power + self.film_power
    }
}

impl Machine {
    /// Angle and speed of the cage at a state, and where it is, if it is free.
    pub fn cage_at(&self, y: &[f64]) -> ([f64; 2], Option<CagePose>) {
        let (at, free) = (self.layout.cage(), self.layout.free());
        let cage = [y[at], y[at + 1]];
        let unknowns = y.get(free).and_then(|y| y.first_chunk::<FREE_CAGE>());
        (cage, self.free_cage.as_ref().zip(unknowns).map(|(free, unknowns)| CagePose::new(free, cage, unknowns)))
    }

    /// Place of a ball in its azimuth frame about the bearing's centre [a, r, t], m.
    #[inline]
    pub fn ball_place(&self, b: &[f64]) -> [f64; 3] {
        self.place_in_bearing(b[AXIAL], b[RADIUS])
    }

    /// The same from the axial position against the outer groove centres and the orbit's radius, m.
    #[inline]
    pub fn place_in_bearing(&self, axial: f64, radius: f64) -> [f64; 3] {
        [axial - self.plane(), radius, 0.0]
    }

    /// Plane of the unloaded balls against that of the outer groove centres, m.
    pub fn plane(&self) -> f64 {
        let g = &self.bearing.geometry;
        g.groove_offset(Side::Outer) * g.sin_contact_angle()
    }

    fn in_free_pocket(&self, (cage, pose): (&FreeCage, &CagePose), (index, b): (usize, &[f64])) -> InPocket {
        let (pocket, at) = (&self.cage.pocket, (AzimuthFrame::at(b[AZIMUTH]), self.ball_place(b)));
        pocket.place(&pocket.wall(cage.pockets), (pose, self.directions[index]), at)
    }

    fn load_in_free_pocket(&self, (pose, place): (&CagePose, &InPocket), b: &[f64]) -> PocketLoad {
        let velocity = [b[VELOCITY], b[VELOCITY + 1], b[RADIUS] * b[ORBIT]];
        let omega = [b[OMEGA], b[OMEGA + 1], b[OMEGA + 2]];
        self.cage.pocket.load_of_free(pose, place, (AzimuthFrame::at(b[AZIMUTH]), velocity, omega), self.hold)
    }

    /// Force and friction of the pocket on a ball, and its lead over the middle of the pocket, rad.
    pub fn in_pocket(&self, index: usize, b: &[f64], frame: &Frame) -> (PocketLoad, f64) {
        let (Some(cage), Some(pose)) = (&self.free_cage, &frame.free_cage) else {
            return (self.pocket_load(index, b, frame), self.lead(index, b, frame.cage[0]));
        };
        let place = self.in_free_pocket((cage, pose), (index, b));
        (self.load_in_free_pocket((pose, &place), b), place.lead())
    }

    /// Force and friction of the pocket on a ball.
    pub fn pocket_load(&self, index: usize, b: &[f64], frame: &Frame) -> PocketLoad {
        if let (Some(cage), Some(pose)) = (&self.free_cage, &frame.free_cage) {
            return self.load_in_free_pocket((pose, &self.in_free_pocket((cage, pose), (index, b))), b);
        }
        self.pocket_of_step().load(&self.motion_in_pocket(index, b, frame))
    }

    /// The same in a cage that only turns for a kick over `h`, which begins with this state.
    pub fn pocket_kick(&self, (index, b): (usize, &[f64]), frame: &Frame, h: f64) -> PocketLoad {
        let (pocket, motion) = (self.pocket_of_step(), self.motion_in_pocket(index, b, frame));
        let rate = pocket.rate_in_step(motion.lead, motion.rate, (self.hold, h));
        pocket.load(&PocketMotion { rate, ..motion })
    }

    /// A pocket of a cage that only turns, as soft as the step makes it.
    fn pocket_of_step(&self) -> Pocket {
        let pocket = &self.cage.pocket;
        Pocket { stiffness: self.pocket_share * pocket.stiffness, ..*pocket }
    }

    fn motion_in_pocket(&self, index: usize, b: &[f64], frame: &Frame) -> PocketMotion {
        PocketMotion {
            lead: self.lead(index, b, frame.cage[0]),
            rate: b[ORBIT] - frame.cage[1],
            velocity: [b[VELOCITY], b[VELOCITY + 1]],
            angular_velocity: [b[OMEGA], b[OMEGA + 1]],
            cage_speed: frame.cage[1],
        }
    }

    /// How far a ball is pressed into its pocket (m; negative: the gap), how fast that grows (m/s), and its lead, rad.
    pub fn pocket_depth(&self, index: usize, b: &[f64], ([angle, speed], pose): CageAt<'_>) -> [f64; 3] {
        let pocket = &self.cage.pocket;
        let (Some(cage), Some(pose)) = (&self.free_cage, pose) else {
            let lead = b[AZIMUTH] - angle - self.places[index];
            let rate = (b[ORBIT] - speed) * pocket.radius * lead.signum();
            return [pocket.penetration(lead), rate, lead];
        };
        let place = self.in_free_pocket((cage, pose), (index, b));
        let velocity = [b[VELOCITY], b[VELOCITY + 1], b[RADIUS] * b[ORBIT]];
        let rate = pocket.closing(pose, &place, (AzimuthFrame::at(b[AZIMUTH]), velocity));
        [place.depth, rate, place.lead()]
    }

    /// Lead of a ball over the middle of its pocket in any cage, rad.
    pub fn lead_in(&self, index: usize, b: &[f64], frame: &Frame) -> f64 {
        match (&self.free_cage, &frame.free_cage) {
            (Some(cage), Some(pose)) => self.in_free_pocket((cage, pose), (index, b)).lead(),
            _ => self.lead(index, b, frame.cage[0]),
        }
    }

    /// Arm of a pocket's force along the orbit on a ball, m: a free cage pushes at the ball itself.
    #[inline(always)]
    pub fn pocket_arm(&self, orbit_radius: f64) -> f64 {
        if self.free_cage.is_some() { orbit_radius } else { self.cage.pocket.radius }
    }

    /// Lead of a ball over the middle of its pocket in a cage that only turns, rad.
    pub fn lead(&self, index: usize, b: &[f64], cage_angle: f64) -> f64 {
        b[AZIMUTH] - cage_angle - self.place_in_cage(index)
    }

    /// Azimuth of the middle of a pocket against the cage, rad.
    pub fn place_in_cage(&self, index: usize) -> f64 {
        self.places[index]
    }

    /// Forces, torques and power of a free cage's lands.
    pub fn lands(&self, frame: &Frame) -> Lands {
        frame.free_cage.map_or_else(Lands::default, |pose| self.lands_at(&pose, &frame.rings))
    }

    /// The same where the cage is at a pose.
    pub fn lands_at(&self, pose: &CagePose, rings: &Races<RingState>) -> Lands {
        let mut lands = Lands::default();
        for land in self.free_cage.iter().flat_map(|cage| &cage.lands) {
            lands.add(land.side, &land.load(pose, self.about_land(land.side, rings)));
        }
        lands
    }

    /// A ring, and the height of its centre over the middle of the unloaded balls, m.
    pub fn about_land<'a>(&self, side: Side, rings: &'a Races<RingState>) -> (&'a RingState, f64) {
        let g = &self.bearing.geometry;
        let height = match side {
            Side::Inner => g.groove_offset(side) * g.sin_contact_angle(),
            Side::Outer => -self.plane(),
        };
        (&rings[side], height)
    }

    /// The lands of a free cage, and the forces of balls and lands on the rings, N.
    pub fn lands_and_rings(&self, frame: &Frame, sums: &Sums) -> (Option<Lands>, Races<[f64; 3]>) {
        let mut on_rings = sums.on_rings;
        if frame.free_cage.is_none() {
            return (None, on_rings);
        }
        let lands = self.lands(frame);
        for side in Side::BOTH {
            (0..3).for_each(|k| on_rings[side][k] -= lands.force[side][k]);
        }
        (Some(lands), on_rings)
    }

    /// Rates and energy of a free cage under balls, lands, fluid and gravity, and what its lands ask of the drives.
    pub fn free_body(&self, frame: &Frame, sums: &Sums, lands: &Lands, f: &mut BodyForces) {
        let (Some(cage), Some(pose)) = (&self.free_cage, &frame.free_cage) else { return };
        let mut wrench = sums.on_cage;
        wrench.add_at([0.0; 3], lands.on_cage.force, lands.on_cage.moment);
        wrench.moment[2] += f.fluid_torque;
        let (rates, about_axis) = cage.rates(pose, &wrench, self.cage.inertia);
        (f.free_cage, f.cage) = (Some(rates), about_axis);
        f.energy += cage.energy(pose, self.cage.inertia) + lands.energy;
        f.cage_loss += lands.losses();
        for side in Side::BOTH {
            f.torque[side] += lands.drive[side];
        }
    }

    /// A free cage in a sample.
    pub fn free_cage_sample(&self, frame: &Frame) -> Option<FreeCageSample> {
        let (pose, lands) = (frame.free_cage.as_ref()?, self.lands(frame));
        Some(FreeCageSample {
            centre_m: pose.centre,
            velocity_m_s: pose.velocity_at(pose.centre),
            tilt_rad: pose.tilt(),
            land_force_n: lands.force,
            land_gap_m: lands.gap,
            land_friction_w: lands.friction_power,
            land_film_w: lands.film_power,
        })
    }

    /// Sets a free cage at the start: in the mean plane of the balls, turning at its speed.
    pub fn start_free_cage(&self, state: &mut [f64]) {
        let Some(cage) = &self.free_cage else { return };
        let l = self.layout;
        let planes = (0..l.balls).map(|index| self.ball_place(self.unknowns(index, state))[0]);
        let mean = planes.sum::<f64>() / l.balls as f64;
        let unknowns = cage.at_start(state[l.cage() + 1], mean);
        state[l.free()].copy_from_slice(&unknowns);
    }
}
