//! A cage on the land of a ring: two edges that are hard, and the film between.

use super::{CageLand, CagePose, Gauge, Wrench, WrenchSlope, friction};
use crate::pocket::CREEP;
use crate::races::Side;
use crate::state::RingState;
use crate::vectors::{across, add, along, cross, dot, length, scaled};
use tribodyn_fluid::{AnnulusDrag, FilmExtent, FilmMotion, ShortBearing};

/// The fluid between land and cage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LandFilm {
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
    /// Density, kg/m³: above the crossover of its law the drag is turbulent.
    pub density: f64,
    /// Share of the gap that is full, by which forces and drag are less.
    pub fill: f64,
    /// How far round it reaches.
    pub extent: FilmExtent,
    /// Height of the surfaces' roughness, m: there the edges begin to carry, and the film gets no stiffer.
    pub roughness: f64,
}

/// Forces, power and gap of a land.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LandLoad {
    /// Force and moment on the cage.
    pub on_cage: Wrench,
    /// How they change with its velocities.
    pub slope: WrenchSlope,
    /// Moment on the ring about its centre, with the part along its axis that the drive gives back, N m.
    pub on_ring: [f64; 3],
    /// Torque about the ring's axis that its drive has to give, N m.
    pub drive: f64,
    /// Power that friction at the edges takes, W.
    pub friction_power: f64,
    /// Power that damping of the edges takes, W.
    pub damping_power: f64,
    /// Power that the film takes, W.
    pub film_power: f64,
    /// Energy of the edges' springs, J.
    pub energy: f64,
    /// Smallest gap left, m; negative where an edge is pressed.
    pub gap: f64,
}

/// A land's ring and axis.
struct Seat<'a> {
    ring: &'a RingState,
    /// Centre of the ring, m.
    centre: [f64; 3],
    /// Unit vector along the ring's axis.
    axis: [f64; 3],
}

impl Seat<'_> {
    /// From the ring's axis to a point, across the axis.
    fn off_axis(&self, point: [f64; 3]) -> [f64; 3] {
        across(along(self.centre, point), self.axis)
    }

    /// Velocity by which the ring's motion but for its speed moves a point, m/s.
    fn swing(&self, point: [f64; 3]) -> [f64; 3] {
        match self.ring.turning {
            Some(turning) => add(self.ring.velocity, cross(turning, along(self.centre, point))),
            None => self.ring.velocity,
        }
    }

    /// Moment on the ring about its centre of the reaction to a force at a point and a moment, N m.
    fn reaction(&self, point: [f64; 3], force: [f64; 3], moment: [f64; 3]) -> [f64; 3] {
        scaled(add(cross(along(self.centre, point), force), moment), -1.0)
    }
}

impl CageLand {
    /// Force of the land on the cage, of both edges and the film. The ring tilts about its centre, whose height above
    /// that of the bearing is along the axis, m.
    pub fn load(&self, pose: &CagePose, (ring, height): (&RingState, f64)) -> LandLoad {
        let [tilt_x, tilt_y] = ring.tilt;
        let axis = [tilt_y, -tilt_x, 1.0];
        let centre = add(ring.displacement, [0.0, 0.0, height]);
        let seat = Seat { ring, centre, axis: scaled(axis, 1.0 / length(axis)) };
        let mut load = LandLoad { gap: self.gap, ..LandLoad::default() };
        for plane in [-0.5 * self.width, 0.5 * self.width] {
            self.edge(pose, &seat, self.axial + plane, &mut load);
        }
        if let Some(film) = &self.film {
            self.film(film, pose, &seat, &mut load);
        }
        load
    }

    /// Force and energy of an edge's spring where the gap is closed by `depth`: from the roughness on it grows with the
    /// square, so that the film hands over to it smoothly, and is then linear.
    fn spring(&self, depth: f64) -> [f64; 2] {
        let soft = self.film.map_or(0.0, |film| film.roughness);
        let depth = depth + soft;
        if depth <= 0.0 {
            return [0.0; 2];
        }
        if depth < 2.0 * soft {
            let force = self.stiffness * depth * depth / (4.0 * soft);
            return [force, force * depth / 3.0];
        }
        let straight = depth - soft;
        [self.stiffness * straight, 0.5 * self.stiffness * (straight * straight + soft * soft / 3.0)]
    }

    fn edge(&self, pose: &CagePose, seat: &Seat<'_>, plane: f64, load: &mut LandLoad) {
        let middle = add(pose.centre, scaled(pose.axes[2], plane));
        let off = seat.off_axis(middle);
        let eccentricity = length(off);
        load.gap = load.gap.min(self.gap - eccentricity);
        let [spring, energy] = self.spring(eccentricity - self.gap);
        if spring <= 0.0 {
            return;
        }
        let n = scaled(off, 1.0 / eccentricity);
        // The cage's bore meets the inner ring's land behind the cage's centre, its outside the outer ring's ahead.
        let to_point = scaled(n, if self.side == Side::Inner { -self.radius } else { self.radius });
        let point = add(middle, add(to_point, scaled(off, -1.0)));
        let of_ring = add(seat.swing(point), cross(scaled(seat.axis, seat.ring.speed), to_point));
        let moving = along(of_ring, pose.velocity_at(point));
        let closing = dot(moving, n);
        let normal = (spring * (1.0 + self.damping * closing)).max(0.0);
        let slip = across(moving, n);
        let (dragged, power) = friction(self.friction, normal, slip, [CREEP, f64::INFINITY]);
        let force = add(scaled(n, -normal), dragged);
        let arm = along(pose.mass_centre, point);
        load.on_cage.add_at(arm, force, [0.0; 3]);
        self.slope_at_edge((arm, n), [normal, spring], slip, &mut load.slope);
        load.on_ring = add(load.on_ring, seat.reaction(point, force, [0.0; 3]));
        load.drive += dot(seat.axis, cross(to_point, force));
        load.friction_power += power;
        load.damping_power += (normal - spring) * closing;
        load.energy += energy;
    }

    /// Slopes of the force N of an edge at an arm, −N n − μ N s/√(s² + creep²), s the slip across n.
    fn slope_at_edge(
        &self,
        (arm, n): ([f64; 3], [f64; 3]),
        [normal, spring]: [f64; 2],
        slip: [f64; 3],
        slope: &mut WrenchSlope,
    ) {
        let square = dot(slip, slip) + CREEP * CREEP;
        let share = self.friction / square.sqrt();
        if normal > 0.0 {
            let by_closing = scaled(add(n, scaled(slip, share)), -spring * self.damping);
            slope.add(&Gauge::of_point(n, arm), arm, (by_closing, [0.0; 3]));
        }
        for k in 0..3 {
            let (unit, along_n) = (axis_of(k), n[k]);
            let slip_by = add(unit, scaled(n, -along_n));
            let by_slip = scaled(add(slip_by, scaled(slip, -dot(slip, slip_by) / square)), -share * normal);
            slope.add(&Gauge::of_point(unit, arm), arm, (by_slip, [0.0; 3]));
        }
    }

    fn film(&self, film: &LandFilm, pose: &CagePose, seat: &Seat<'_>, load: &mut LandLoad) {
        let (c, thinnest) = (self.gap, film.roughness / self.gap);
        let viscosity = film.fill * film.viscosity;
        let bearing = ShortBearing {
            viscosity,
            radius: self.radius,
            length: self.width,
            clearance: c,
            extent: film.extent,
            thinnest,
        };
        let middle = add(pose.centre, scaled(pose.axes[2], self.axial));
        let off = seat.off_axis(middle);
        let moving = across(along(seat.swing(middle), pose.velocity_at(middle)), seat.axis);
        let distance = length(off);
        // In the very middle any direction serves.
        let n = if distance > 0.0 { scaled(off, 1.0 / distance) } else { across_any(seat.axis) };
        let ahead = cross(seat.axis, n);
        let eccentricity = distance / c;
        let turning = dot(pose.omega, seat.axis);
        let entraining = 0.5 * (turning + seat.ring.speed);
        let motion = FilmMotion {
            eccentricity,
            outward: dot(moving, n) / c,
            wedge: eccentricity * entraining - dot(moving, ahead) / c,
        };
        let ([radial, tangential], slopes) = bearing.force_and_slopes(&motion);
        let (density, width, gap) = (film.fill * film.density, self.width, self.gap);
        let drag = AnnulusDrag { density, viscosity, radius: self.radius, width, gap };
        let sheared_more = bearing.friction_factor(eccentricity);
        let sheared = drag.torque_on_cage(seat.ring.speed, turning) * sheared_more;
        // The pressure turns cage and ring alike, so that together with the forces' arm nothing is left.
        let of_pressure = -0.5 * distance * tangential;
        let force = add(scaled(n, radial), scaled(ahead, tangential));
        let moment = scaled(seat.axis, sheared + of_pressure);
        let arm = along(pose.mass_centre, middle);
        load.on_cage.add_at(arm, force, moment);
        load.on_ring = add(load.on_ring, seat.reaction(middle, force, moment));
        let mut wedge = Gauge::of_point(scaled(ahead, -1.0 / c), arm);
        wedge.omega = add(wedge.omega, scaled(seat.axis, 0.5 * eccentricity));
        for (gauge, [radial, tangential]) in [Gauge::of_point(scaled(n, 1.0 / c), arm), wedge].iter().zip(slopes) {
            let force = add(scaled(n, radial), scaled(ahead, tangential));
            load.slope.add(gauge, arm, (force, scaled(seat.axis, -0.5 * distance * tangential)));
        }
        let by_turning = drag.slope_by_cage_speed(seat.ring.speed, turning) * sheared_more;
        load.slope.add(&Gauge::of_turning(seat.axis), arm, ([0.0; 3], scaled(seat.axis, by_turning)));
        load.drive += sheared - of_pressure;
        load.film_power +=
            sheared * (seat.ring.speed - turning) + c * (tangential * motion.wedge - radial * motion.outward);
    }
}

/// The unit vector along one of the inertial axes.
fn axis_of(k: usize) -> [f64; 3] {
    std::array::from_fn(|i| f64::from(u8::from(i == k)))
}

/// A unit vector across an axis that is near Z.
fn across_any(axis: [f64; 3]) -> [f64; 3] {
    let x = across([1.0, 0.0, 0.0], axis);
    scaled(x, 1.0 / length(x))
}
