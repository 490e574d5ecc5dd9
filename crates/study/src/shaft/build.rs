//! From a shaft's file to nodes, elements and bearings.

use super::file::ShaftFile;
use super::loads;
use crate::error::StudyError;
use tribodyn::AnswerError;
use tribodyn_bearing::{Bearing, BearingError, Geometry, OperatingPoint};
use tribodyn_case::{Carries, Case, LoadSpec, MaterialSpec, OuterRing, PreloadSpec, Purpose, ShaftSystem, WeightSpec};
use tribodyn_quasistatic::Model;
use tribodyn_shaft::{
    Disc, Element, Equilibrium, FREEDOMS, Material, RestingBearing, RingForce, Seat, Section, Shaft, ShaftError,
    Support, TurningBearing, Vector, offset_for,
};

pub use tribodyn_shaft::System;

/// Elements of a shaft whose file does not say how long they may be.
const ELEMENTS: f64 = 20.0;
/// Most elements of a shaft: its matrices are full, and those of a thousand elements take some gigabytes.
const MOST_ELEMENTS: f64 = 1000.0;
/// Stations closer than this share of the shaft are one.
const ONE_STATION: f64 = 1e-6;
/// Acceleration of free fall, m/s².
const GRAVITY: f64 = 9.806_65;

/// Bearings as they run, and the shaft's mesh.
pub struct Running<'a> {
    file: &'a ShaftFile,
    /// Speed of the shaft, rad/s.
    pub speed: f64,
    /// Factor on all loads but the weight.
    pub factor: f64,
    /// Bearings of that speed.
    pub bearings: Vec<Bearing>,
    points: Vec<OperatingPoint>,
    /// How far fits, heat and rotation press each bearing in where its rings stay in their places along z, m.
    growth: Vec<f64>,
    shaft: Shaft,
    positions: Vec<f64>,
}

impl<'a> Running<'a> {
    /// A shaft at a speed (rad/s) under its loads times a factor.
    ///
    /// # Errors
    /// Bearings that are none at this speed, and a shaft that is no beam.
    pub fn new(file: &'a ShaftFile, speed: f64, factor: f64) -> Result<Self, StudyError> {
        let (mut bearings, mut points, mut growth) = (Vec::new(), Vec::new(), Vec::new());
        for index in 0..file.cases.len() {
            let case = file.case_at(index, speed);
            let name = || file.bearing_name(index);
            case.require(Purpose::JonesHarris).map_err(|source| AnswerError::Lacking { file: name(), source })?;
            let refused = |source: BearingError| AnswerError::Bearing { file: name(), source };
            let bearing = case.bearing().map_err(refused)?;
            growth.push(reach(&case.geometry.resolve().map_err(refused)?) - reach(&bearing.geometry));
            bearings.push(bearing);
            points.push(case.operating_point());
        }
        let positions = mesh(&file.system);
        let shaft = shaft(file, &positions).map_err(|source| failed(file, source))?;
        Ok(Self { file, speed, factor, bearings, points, growth, shaft, positions })
    }

    /// z of each node, m.
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }

    /// The shaft.
    pub fn shaft(&self) -> &Shaft {
        &self.shaft
    }

    /// Operating point of a bearing, its ring's freedoms aside.
    pub fn point(&self, index: usize) -> &OperatingPoint {
        &self.points[index]
    }

    /// The node nearest to a place, m.
    pub fn node(&self, at: f64) -> usize {
        let distance = |k: &usize| (self.positions[*k] - at).abs();
        let nearest = (0..self.positions.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        nearest.unwrap_or(0)
    }

    /// Torque about +z that loads bring in at each node, N m.
    pub fn torques(&self) -> Vec<f64> {
        let mut all = vec![0.0; self.positions.len()];
        for load in &self.file.system.loads {
            all[self.node(load.at())] += self.factor * loads::force(load).1;
        }
        all
    }

    /// Unbalances: node, mass times eccentricity (kg m), phase (rad).
    pub fn unbalances(&self) -> Vec<(usize, f64, f64)> {
        let of = |load: &LoadSpec| match *load {
            LoadSpec::Unbalance { at, moment, phase } => Some((self.node(at), moment, phase)),
            _ => None,
        };
        self.file.system.loads.iter().filter_map(of).collect()
    }

    fn node_loads(&self) -> Vec<Vector> {
        let mut all = vec![[0.0; FREEDOMS]; self.positions.len()];
        for load in &self.file.system.loads {
            let (force, node) = (loads::force(load).0, self.node(load.at()));
            (0..FREEDOMS).for_each(|k| all[node][k] += self.factor * force[k]);
        }
        let Some(weight) = self.file.system.weight else { return all };
        let direction = match weight {
            WeightSpec::Across(angle) => [angle.cos(), angle.sin(), 0.0],
            WeightSpec::PlusZ => [0.0, 0.0, 1.0],
            WeightSpec::MinusZ => [0.0, 0.0, -1.0],
        };
        let mass = self.shaft.mass_matrix();
        for (row, value) in (0..mass.nrows()).map(|row| {
            let falling = |column: usize| direction.get(column % FREEDOMS).map_or(0.0, |part| part * GRAVITY);
            (row, (0..mass.ncols()).map(|column| mass[(row, column)] * falling(column)).sum::<f64>())
        }) {
            all[row / FREEDOMS][row % FREEDOMS] += value;
        }
        all
    }

    /// Shaft, bearings and housings, the bearings at rest or as they turn.
    ///
    /// # Errors
    /// A preload that a bearing does not carry.
    pub fn system(&self, turning: bool) -> Result<System<'_>, StudyError> {
        let spec = &self.file.system;
        let mut supports = Vec::with_capacity(self.bearings.len());
        for (index, entry) in spec.bearings.iter().enumerate() {
            let bearing = &self.bearings[index];
            let geometry = &bearing.geometry;
            let offset = match (entry.carries, entry.preload) {
                // The middle of its play.
                (Carries::Both, _) => -0.5 * geometry.axial_play(),
                (_, Some(PreloadSpec::Offset(offset))) => offset + self.growth[index],
                (_, Some(PreloadSpec::Force(force))) => self.drawn_offset(index, force)? + self.growth[index],
                (_, None) => self.growth[index],
            };
            let ring: Box<dyn RingForce + '_> = if turning {
                Box::new(TurningBearing::new(bearing, &self.points[index], Model::JonesHarris))
            } else {
                Box::new(RestingBearing { bearing, first_ball: 0.0 })
            };
            let displaced = [0.0, 0.0, self.seat_shift(entry.at), 0.0, 0.0];
            let slides = match entry.outer_ring {
                OuterRing::Fixed => None,
                OuterRing::Slides(force) => Some(force),
            };
            let stiffness = entry.housing.map(|seat| {
                let k = [seat.radial, seat.radial, seat.axial, seat.tilt, seat.tilt];
                std::array::from_fn(|i| std::array::from_fn(|j| if i == j { k[i] } else { 0.0 }))
            });
            let seat = Seat { stiffness, displaced, slides, mass: entry.housing.and_then(|seat| seat.mass) };
            let carries_plus_z = entry.carries != Carries::MinusZ;
            supports.push(Support { node: self.node(entry.at), carries_plus_z, offset, ring, seat });
        }
        let housing = self.file.housing.clone();
        Ok(System { shaft: self.shaft.clone(), supports, housing, loads: self.node_loads() })
    }

    /// Offset at which a bearing, as it is drawn, carries an axial force at rest, m.
    fn drawn_offset(&self, index: usize, force: f64) -> Result<f64, StudyError> {
        let drawn = Case { mounting: None, ..self.file.case_at(index, 0.0) }.bearing();
        let file = || self.file.bearing_name(index);
        let bearing = drawn.map_err(|source| AnswerError::Bearing { file: file(), source })?;
        let mut resting = RestingBearing { bearing: &bearing, first_ball: 0.0 };
        offset_for(&mut resting, force).map_err(|source| failed(self.file, source))
    }

    /// How far heat moves a seat along z against the shaft, m.
    fn seat_shift(&self, at: f64) -> f64 {
        self.file.system.heat.map_or(0.0, |heat| {
            let housing = heat.housing_expansion * heat.housing_temperature_rise;
            (housing - heat.shaft_expansion * heat.shaft_temperature_rise) * at
        })
    }

    /// The equilibrium: of bearings at rest, and from there of those that turn.
    ///
    /// # Errors
    /// [`StudyError::Shaft`].
    pub fn equilibrium(&self, near: Option<&Equilibrium>) -> Result<Equilibrium, StudyError> {
        let failed = |source| failed(self.file, source);
        let start = match near {
            Some(near) => near.clone(),
            None => self.system(false)?.equilibrium().map_err(failed)?,
        };
        if self.speed == 0.0 && near.is_none() {
            return Ok(start);
        }
        self.system(self.speed != 0.0)?.equilibrium_from(Some(&start)).map_err(failed)
    }
}

/// Axial distance of the groove centres at which the balls just touch, m.
fn reach(geometry: &Geometry) -> f64 {
    geometry.centre_distance() * geometry.sin_contact_angle()
}

/// A failure of the shaft with the names of its file and bearing.
pub(super) fn failed(file: &ShaftFile, source: ShaftError) -> StudyError {
    let name = match &source {
        ShaftError::Bearing { bearing, .. } => {
            format!("{} ({})", file.name, file.system.bearings[*bearing].name)
        }
        _ => file.name.clone(),
    };
    StudyError::Shaft { file: name, source }
}

/// Ends of sections and stations by growing z, m, and how many elements lie between each two.
fn parts(system: &ShaftSystem) -> Vec<([f64; 2], f64)> {
    let mut ends = vec![0.0];
    for section in &system.shaft.sections {
        ends.push(ends[ends.len() - 1] + section.length);
    }
    let length = ends[ends.len() - 1];
    let stations = system.bearings.iter().map(|b| b.at).chain(system.discs.iter().map(|d| d.at));
    for at in stations.chain(system.loads.iter().map(LoadSpec::at)) {
        if ends.iter().all(|known| (known - at).abs() > ONE_STATION * length) {
            ends.push(at);
        }
    }
    ends.sort_by(f64::total_cmp);
    let longest = system.shaft.longest_element.unwrap_or(length / ELEMENTS);
    let part = |pair: &[f64]| ([pair[0], pair[1]], ((pair[1] - pair[0]) / longest - 1e-9).ceil().max(1.0));
    ends.windows(2).map(part).collect()
}

/// Nodes: ends of sections, stations, and between them as many as elements may be long.
fn mesh(system: &ShaftSystem) -> Vec<f64> {
    let mut nodes = vec![0.0];
    for ([from, to], count) in parts(system) {
        (1..=count as usize).for_each(|k| nodes.push(from + (to - from) * k as f64 / count));
    }
    nodes
}

/// Refuses more elements than can be solved.
pub(super) fn check_elements(system: &ShaftSystem) -> Result<(), String> {
    let count: f64 = parts(system).iter().map(|(_, count)| count).sum();
    match count <= MOST_ELEMENTS {
        true => Ok(()),
        false => Err(format!("the shaft would have {count:.0} elements; allowed are {MOST_ELEMENTS}")),
    }
}

fn shaft(file: &ShaftFile, positions: &[f64]) -> Result<Shaft, ShaftError> {
    let spec = &file.system.shaft;
    let mut elements = Vec::with_capacity(positions.len());
    let (mut section, mut start) = (0, 0.0);
    for pair in positions.windows(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        while section + 1 < spec.sections.len() && middle > start + spec.sections[section].length {
            start += spec.sections[section].length;
            section += 1;
        }
        let part = &spec.sections[section];
        let inner = part.inner.unwrap_or(0.0);
        let first = Section { outer: part.outer, inner };
        let last = Section { outer: part.outer_end.unwrap_or(part.outer), inner: part.inner_end.unwrap_or(inner) };
        let at = |z: f64| first.towards(&last, (z - start) / part.length);
        let MaterialSpec { young, poisson, density } = part.material.unwrap_or(spec.material);
        let material = Material::new(young, poisson, density);
        elements.push(Element { length: pair[1] - pair[0], start: at(pair[0]), end: at(pair[1]), material });
    }
    let nearest = |at: f64| {
        let distance = |k: &usize| (positions[*k] - at).abs();
        (0..positions.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    };
    let disc = |disc: &tribodyn_case::DiscSpec| Disc {
        node: nearest(disc.at),
        mass: disc.mass,
        transverse_inertia: disc.transverse_inertia,
        polar_inertia: disc.polar_inertia,
    };
    Shaft::new(elements, file.system.discs.iter().map(disc).collect())
}
