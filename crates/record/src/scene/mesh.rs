//! Triangle meshes of the bodies: rings as surfaces of revolution, the band about a ball, the cage with its pockets.
//! Triangles wind anticlockwise seen from outside.

use crate::quaternion::{Rotation, grid, pose};
use crate::wire::foxglove::{Color, Point3, TriangleListPrimitive};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use tribodyn_bearing::{Geometry, Side};

/// Segments of a full circle of a ring: at 96 the facets are no longer seen.
const SEGMENTS: usize = 96;
/// Points along a groove.
const GROOVE_POINTS: usize = 14;
/// Points along each of the four sides of the cage sector about a pocket.
const SIDE_POINTS: usize = 12;

/// Ring faces and outside diameters are not part of a case: proportions of a 7224 bearing (bore 120, outside 215,
/// width 40 mm at D 30.16 mm and d_m 167.5 mm), for the picture only.
const RING_DEPTH: f64 = 0.7875;
const RING_WIDTH: f64 = 1.326;
/// Cage proportions, over D, that clear both shoulders and show the balls.
const CAGE_DEPTH: f64 = 0.24;
const CAGE_WIDTH: f64 = 1.22;

/// Points and the triangles between them.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Mesh {
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Mesh {
    fn point(&mut self, at: [f64; 3]) -> u32 {
        self.points.push(at);
        (self.points.len() - 1) as u32
    }

    fn quad(&mut self, [a, b, c, d]: [u32; 4]) {
        self.triangles.extend([[a, b, c], [a, c, d]]);
    }

    /// As the message has it, a colour for each point.
    pub(crate) fn coloured(&self, colors: Vec<Color>) -> TriangleListPrimitive {
        TriangleListPrimitive { colors, ..self.message(Color::default()) }
    }

    /// As the message has it, one colour for all.
    pub(crate) fn message(&self, color: Color) -> TriangleListPrimitive {
        let point = |p: &[f64; 3]| Point3 { x: grid(p[0]), y: grid(p[1]), z: grid(p[2]) };
        TriangleListPrimitive {
            pose: Some(pose([0.0; 3], Rotation::IDENTITY)),
            points: self.points.iter().map(point).collect(),
            color: Some(color),
            colors: Vec::new(),
            indices: self.triangles.iter().flatten().copied().collect(),
        }
    }

    /// Turns a profile of (radius, z) points about z. A closed profile that runs anticlockwise with the radius to
    /// the right and z upwards encloses a body.
    fn revolve(profile: &[[f64; 2]], closed: bool) -> Self {
        let mut mesh = Mesh::default();
        let rows = profile.len() as u32;
        for segment in 0..SEGMENTS {
            let (sin, cos) = (TAU * segment as f64 / SEGMENTS as f64).sin_cos();
            for [radius, z] in profile {
                mesh.point([radius * cos, radius * sin, *z]);
            }
        }
        let edges = if closed { rows } else { rows - 1 };
        for segment in 0..SEGMENTS as u32 {
            let (here, next) = (segment * rows, (segment + 1) % SEGMENTS as u32 * rows);
            for edge in 0..edges {
                let after = (edge + 1) % rows;
                mesh.quad([here + edge, next + edge, next + after, here + after]);
            }
        }
        mesh
    }
}

/// Half the width of the rings, m.
pub(crate) fn half_width(geometry: &Geometry) -> f64 {
    0.5 * RING_WIDTH * geometry.ball_diameter
}

/// Outside radius of the outer ring or bore radius of the inner ring, m.
pub(crate) fn back_radius(geometry: &Geometry, side: Side) -> f64 {
    let depth = RING_DEPTH * geometry.ball_diameter;
    match side {
        Side::Outer => 0.5 * geometry.pitch_diameter + depth,
        // Few large balls leave no bore; keep a hole to look at.
        Side::Inner => (0.5 * geometry.pitch_diameter - depth).max(0.05 * geometry.ball_diameter),
    }
}

/// A ring with its groove: true groove radius and centre, contact side with the high shoulder.
pub(crate) fn ring(geometry: &Geometry, side: Side) -> Mesh {
    let half = half_width(geometry);
    let sign = match side {
        Side::Outer => 1.0,
        Side::Inner => -1.0,
    };
    let groove = geometry.coefficient(side) * geometry.ball_diameter;
    let centre_radius = geometry.groove_centre_radius(side);
    // The unloaded ball centre is the origin of z; the outer groove centre lies behind it, the inner one before it.
    let centre_z = -sign * geometry.groove_offset(side) * geometry.sin_contact_angle();
    // Angles from radial to the shoulder edges: beyond the contact on the loaded side, cut low on the other side
    // where the bearing has a contact angle worth the name.
    let high = (geometry.contact_angle() + 0.6).clamp(0.95, 1.4);
    let low = if geometry.contact_angle() > 0.17 { 0.6 } else { high };
    let arc = (0..=GROOVE_POINTS).map(|i| {
        let angle = high - (high + low) * i as f64 / GROOVE_POINTS as f64;
        [centre_radius + sign * groove * angle.cos(), centre_z + sign * groove * angle.sin()]
    });
    let mut profile: Vec<[f64; 2]> = arc.collect();
    let [first, last] = [profile[0], profile[GROOVE_POINTS]];
    let back = back_radius(geometry, side);
    profile.extend([[last[0], -sign * half], [back, -sign * half], [back, sign * half], [first[0], sign * half]]);
    Mesh::revolve(&profile, true)
}

/// A strip of a raceway, over angles about the axis and angles across the groove (rad, from radial towards the
/// contact), lifted off the surface by `lift` (m): rows of points along the strip, two or more across it.
pub(crate) fn strip(geometry: &Geometry, side: Side, along: &[f64], across: &[f64], lift: f64) -> Mesh {
    let sign = if side == Side::Outer { 1.0 } else { -1.0 };
    let groove = geometry.coefficient(side) * geometry.ball_diameter - lift;
    let centre_z = -sign * geometry.groove_offset(side) * geometry.sin_contact_angle();
    let mut mesh = Mesh::default();
    for azimuth in along {
        for angle in across {
            let radius = geometry.groove_centre_radius(side) + sign * groove * angle.cos();
            mesh.point([radius * azimuth.cos(), radius * azimuth.sin(), centre_z + sign * groove * angle.sin()]);
        }
    }
    let row = across.len() as u32;
    for i in 0..along.len().saturating_sub(1) as u32 {
        for j in 0..row.saturating_sub(1) {
            let corner = i * row + j;
            mesh.quad([corner, corner + row, corner + row + 1, corner + 1]);
        }
    }
    mesh
}

/// A band about the z axis of a ball, standing a little above its surface.
pub(crate) fn band(ball_radius: f64) -> Mesh {
    const HALF_WIDTH: f64 = 0.16;
    const ABOVE: f64 = 1.006;
    let row = |angle: f64| [ABOVE * ball_radius * angle.cos(), ABOVE * ball_radius * angle.sin()];
    Mesh::revolve(&[row(-HALF_WIDTH), row(-0.5 * HALF_WIDTH), row(0.0), row(0.5 * HALF_WIDTH), row(HALF_WIDTH)], false)
}

/// The cage: one sector about each pocket, pockets drilled radially. Also returns the outer rim of each pocket.
pub(crate) fn cage(geometry: &Geometry, pocket_gap: f64, first_azimuth: f64) -> (Mesh, Vec<Vec<[f64; 3]>>) {
    let count = geometry.ball_count;
    let depth = CAGE_DEPTH * geometry.ball_diameter;
    let radii = [0.5 * geometry.pitch_diameter - 0.5 * depth, 0.5 * geometry.pitch_diameter + 0.5 * depth];
    let half = 0.5 * CAGE_WIDTH * geometry.ball_diameter;
    let sector = PI / count as f64;
    // A pocket that would cut its neighbour or the side of the cage is drawn smaller.
    let web = (radii[0] * sector.min(FRAC_PI_2).sin()).min(half);
    let pocket = (geometry.ball_radius() + pocket_gap).min(0.95 * web);
    let mut mesh = Mesh::default();
    let mut rims = Vec::with_capacity(count);
    for ball in 0..count {
        let azimuth = first_azimuth + TAU * ball as f64 / count as f64;
        let shells = radii.map(|radius| Shell { radius, azimuth, pocket, half, sector });
        let rows = shells.map(|shell| shell.rows(&mut mesh));
        join(&mut mesh, &rows);
        rims.push(rows[1][0].iter().map(|&i| mesh.points[i as usize]).collect());
    }
    (mesh, rims)
}

/// One of the two cylindrical faces of a cage sector.
struct Shell {
    radius: f64,
    azimuth: f64,
    pocket: f64,
    half: f64,
    sector: f64,
}

impl Shell {
    /// Rows of points from the pocket's rim out to the sector's border, which starts at its corner (−, −) and runs
    /// along the lower side, the right one, the upper one and the left one.
    fn rows(&self, mesh: &mut Mesh) -> Vec<Vec<u32>> {
        let layers = 2 + 24 / (PI / self.sector).round() as usize;
        (0..=layers)
            .map(|layer| {
                let part = layer as f64 / layers as f64;
                (0..4 * SIDE_POINTS).map(|i| mesh.point(self.between(border(i), part))).collect()
            })
            .collect()
    }

    /// A point between the rim (part 0) and the border (part 1).
    fn between(&self, [u, v]: [f64; 2], part: f64) -> [f64; 3] {
        let direction = v.atan2(u);
        let rim = [(self.pocket * direction.cos() / self.radius).asin(), self.pocket * direction.sin()];
        let edge = [u * self.sector, v * self.half];
        let [angle, z] = [0, 1].map(|k| rim[k] + part * (edge[k] - rim[k]));
        let (sin, cos) = (self.azimuth + angle).sin_cos();
        [self.radius * cos, self.radius * sin, z]
    }
}

/// Point i of the border of the square from −1 to 1, anticlockwise from (−1, −1).
fn border(i: usize) -> [f64; 2] {
    let along = -1.0 + 2.0 * (i % SIDE_POINTS) as f64 / SIDE_POINTS as f64;
    match i / SIDE_POINTS {
        0 => [along, -1.0],
        1 => [1.0, along],
        2 => [-along, 1.0],
        _ => [-1.0, -along],
    }
}

/// Closes a cage sector: both faces, the pocket wall and the two sides of the cage.
fn join(mesh: &mut Mesh, [inner, outer]: &[Vec<Vec<u32>>; 2]) {
    let count = 4 * SIDE_POINTS;
    let last = inner.len() - 1;
    for i in 0..count {
        let j = (i + 1) % count;
        for layer in 0..last {
            mesh.quad([outer[layer][i], outer[layer + 1][i], outer[layer + 1][j], outer[layer][j]]);
            mesh.quad([inner[layer][i], inner[layer][j], inner[layer + 1][j], inner[layer + 1][i]]);
        }
        mesh.quad([inner[0][i], outer[0][i], outer[0][j], inner[0][j]]);
        // Left and right borders meet the neighbouring sectors and stay open.
        if matches!(i / SIDE_POINTS, 0 | 2) {
            mesh.quad([inner[last][i], inner[last][j], outer[last][j], outer[last][i]]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_bearing::{Dimensions, Fit};

    fn geometry(ball_count: usize) -> Geometry {
        Geometry::new(Dimensions {
            ball_count,
            ball_diameter: 0.03016,
            pitch_diameter: 0.1675,
            inner_coefficient: 0.52,
            outer_coefficient: 0.53,
            fit: Fit::ContactAngle(18_f64.to_radians()),
        })
        .unwrap()
    }

    /// Volume inside a closed mesh whose triangles wind anticlockwise from outside (divergence theorem).
    fn volume(mesh: &Mesh) -> f64 {
        let six = |[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|i| mesh.points[*i as usize]);
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        };
        mesh.triangles.iter().map(six).sum::<f64>() / 6.0
    }

    #[test]
    fn limit_revolved_square_has_the_volume_of_pappus() {
        let mesh = Mesh::revolve(&[[0.9, -0.1], [1.1, -0.1], [1.1, 0.1], [0.9, 0.1]], true);
        let pappus = TAU * 1.0 * 0.04;
        // A polygon of 96 corners has sin(2π/96)/(2π/96) of the circle's area.
        let facets = (TAU / 96.0).sin() / (TAU / 96.0);
        assert!((volume(&mesh) / (pappus * facets) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn identity_rings_are_closed_bodies_and_touch_the_unloaded_ball_at_the_contact() {
        let geometry = geometry(13);
        for side in [Side::Inner, Side::Outer] {
            let mesh = ring(&geometry, side);
            assert!(volume(&mesh) > 0.0);
            let centre = [0.5 * geometry.pitch_diameter, 0.0, 0.0];
            let distance = |p: &[f64; 3]| (0..3).map(|k| (p[k] - centre[k]).powi(2)).sum::<f64>().sqrt();
            let nearest = mesh.points.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
            let gap = distance(nearest) - geometry.ball_radius();
            assert!((0.0..1e-5).contains(&gap), "{side:?}: {gap} m");
            let angle = (nearest[2] / (nearest[0] - centre[0])).atan();
            assert!((angle - geometry.contact_angle()).abs() < 0.08, "{side:?}: {angle} rad");
        }
    }

    #[test]
    fn identity_every_edge_of_the_cage_belongs_to_two_triangles_of_opposite_sense() {
        for count in [3, 13, 40] {
            let (mesh, rims) = cage(&geometry(count), 1.2e-4, 0.0);
            assert_eq!(rims.len(), count);
            assert!(volume(&mesh) > 0.0);
            // Sectors repeat the points of their common border: compare edges by place.
            let key = |i: u32| mesh.points[i as usize].map(|x| (x * 1e7).round() as i64);
            let mut edges = std::collections::HashMap::new();
            for [a, b, c] in &mesh.triangles {
                for (p, q) in [(a, b), (b, c), (c, a)] {
                    *edges.entry((key(*p), key(*q))).or_insert(0) += 1;
                    *edges.entry((key(*q), key(*p))).or_insert(0) -= 1;
                }
            }
            assert!(edges.values().all(|&balance| balance == 0), "{count} balls");
        }
    }
}
