//! Defects of the raceways, and their coating as the balls found it.
//!
//! A ball that passes tells how much of the coating is gone where it stands. The raceway is drawn in sectors of 2° of
//! its ring, each in the colour of what the last ball there found; where none has been yet it is grey.

use crate::mesh;
use crate::wire::foxglove::{SceneEntity, SceneUpdate};
use crate::{colour, frames, guide, scene};
use prost_types::Timestamp;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_bearing::{BallResult, Geometry, RunInputs, Side};
use tribodyn_dynamics::Sample;

/// Sectors of a raceway.
pub(crate) const SECTORS: usize = 180;
/// How far the drawn coating reaches across the groove to either side of the contact, rad.
const COATING_HALF_WIDTH: f64 = 0.2;
/// The same of a defect.
const DEFECT_HALF_WIDTH: f64 = 0.4;
/// Distances of coating, defects and hits from the surface, in ball diameters: drawn on it they would flicker.
const COATING_LIFT: f64 = 0.004;
const DEFECT_LIFT: f64 = 0.007;
const HIT_LIFT: f64 = 0.01;
/// A ball shows as passing a defect up to this angle beyond its edge, rad: about its own width on the raceway.
const REACH: f64 = 0.05;

/// A defect as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Defect {
    side: Side,
    azimuth: f64,
    width: f64,
    depth: f64,
    /// Edges across the groove, rad from the free contact angle.
    across: [f64; 2],
    name: &'static str,
}

/// The defects and spalls of a run, those of the inner race first.
pub(crate) fn defects(inputs: &RunInputs) -> Vec<Defect> {
    let of = |side| {
        let all = inputs.defects[side].iter();
        let defects = all.map(move |d| Defect {
            side,
            azimuth: d.azimuth,
            width: d.width,
            depth: d.depth,
            across: [-DEFECT_HALF_WIDTH, DEFECT_HALF_WIDTH],
            name: "defect",
        });
        let g = &inputs.bearing.geometry;
        let (track, groove) = (inputs.bearing.track_radius(side), g.coefficient(side) * g.ball_diameter);
        let spalls = inputs.spalls[side].iter().map(move |s| Defect {
            side,
            azimuth: s.azimuth,
            width: s.length / track,
            depth: s.depth,
            across: [s.across - 0.5 * s.width, s.across + 0.5 * s.width].map(|place| place / groove),
            name: "spall",
        });
        defects.chain(spalls)
    };
    Side::BOTH.into_iter().flat_map(of).collect()
}

fn frame(side: Side) -> &'static str {
    match side {
        Side::Inner => frames::INNER_RING,
        Side::Outer => frames::OUTER_RING,
    }
}

impl Defect {
    fn body(&self, geometry: &Geometry, lift: f64, color: crate::wire::foxglove::Color, entity: &mut SceneEntity) {
        let pieces = (self.width / 0.02).ceil().clamp(1.0, 200.0);
        let start = self.azimuth - 0.5 * self.width;
        let along: Vec<f64> = (0..=pieces as usize).map(|i| start + self.width * i as f64 / pieces).collect();
        let contact = geometry.contact_angle();
        let [from, to] = self.across;
        let across = [0.0, 0.25, 0.5, 0.75, 1.0].map(|part| contact + from + part * (to - from));
        let strip = mesh::strip(geometry, self.side, &along, &across, lift * geometry.ball_diameter);
        entity.triangles.push(strip.message(color));
    }

    /// The defect where it is, and a label with its size off the raceway.
    pub(crate) fn entity(&self, geometry: &Geometry, index: usize, stamp: Timestamp) -> SceneEntity {
        let mut entity = scene::entity(stamp, frame(self.side).into(), format!("defect_{index}"));
        self.body(geometry, DEFECT_LIFT, colour::DEFECT, &mut entity);
        let back = mesh::back_radius(geometry, self.side);
        let (radius, up) = match self.side {
            Side::Outer => (1.25 * back, -1.6 * mesh::half_width(geometry)),
            Side::Inner => (0.5 * back, 1.6 * mesh::half_width(geometry)),
        };
        let (sin, cos) = self.azimuth.sin_cos();
        let digits = |value: f64| (value * 100.0).round() / 100.0;
        let text = format!("{} {}° x {} µm", self.name, digits(self.width.to_degrees()), digits(self.depth * 1e6));
        entity.texts.push(guide::Stage::new(geometry).label([radius * cos, radius * sin, up], text));
        entity
    }

    /// The defect alight while a ball passes, dark else.
    pub(crate) fn flash(
        &self,
        geometry: &Geometry,
        index: usize,
        turned: [f64; 2],
        balls: &[f64],
        stamp: Timestamp,
    ) -> SceneEntity {
        let mut entity = scene::entity(stamp, frame(self.side).into(), format!("passed_{index}"));
        let ring = if self.side == Side::Inner { turned[0] } else { turned[1] };
        let near = |azimuth: &f64| {
            let distance = (azimuth - ring - self.azimuth).rem_euclid(TAU);
            distance.min(TAU - distance) <= 0.5 * self.width + REACH
        };
        if balls.iter().any(near) {
            self.body(geometry, HIT_LIFT, colour::DEFECT_HIT, &mut entity);
        }
        entity
    }
}

/// Coating as the balls found it on both raceways: the part that is left, by sector; none where no ball has been.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Found {
    inner: Vec<Option<f32>>,
    outer: Vec<Option<f32>>,
}

impl Default for Found {
    fn default() -> Self {
        Self { inner: vec![None; SECTORS], outer: vec![None; SECTORS] }
    }
}

impl Found {
    /// Sectors that are remembered, those of the shorter list.
    pub(crate) fn sectors(&self) -> usize {
        self.inner.len().min(self.outer.len())
    }

    /// Looks below every loaded ball.
    pub(crate) fn push(&mut self, sample: &Sample, balls: &[BallResult]) {
        for ball in balls {
            let contacts = &ball.contacts;
            let sides =
                [(&mut self.inner, &contacts.inner, &sample.inner), (&mut self.outer, &contacts.outer, &sample.outer)];
            for (sectors, contact, ring) in sides {
                if let Some(surface) = contact.transient.filter(|_| contact.load_n > 0.0) {
                    let turn = (ball.azimuth_rad - ring.angle_rad).rem_euclid(TAU) / TAU;
                    let sector = (turn * SECTORS as f64) as usize % SECTORS;
                    sectors[sector] = Some((1.0 - surface.bare) as f32);
                }
            }
        }
    }

    /// Both raceways in colour.
    pub(crate) fn message(&self, geometry: &Geometry, stamp: Timestamp) -> SceneUpdate {
        let entities = [(Side::Inner, &self.inner), (Side::Outer, &self.outer)].map(|(side, sectors)| {
            let along: Vec<f64> = (0..=SECTORS).map(|i| TAU * i as f64 / SECTORS as f64).collect();
            let contact = geometry.contact_angle();
            let across = [contact - COATING_HALF_WIDTH, contact + COATING_HALF_WIDTH];
            let strip = mesh::strip(geometry, side, &along, &across, COATING_LIFT * geometry.ball_diameter);
            let color = |sector: usize| {
                sectors[sector % SECTORS].map_or(colour::UNSEEN, |left| colour::coating(f64::from(left)))
            };
            let mut entity = scene::entity(stamp, frame(side).into(), format!("coating_{}", frame(side)));
            entity.triangles = vec![strip.coloured((0..=SECTORS).flat_map(|sector| [color(sector); 2]).collect())];
            entity
        });
        SceneUpdate { deletions: Vec::new(), entities: entities.into() }
    }
}
