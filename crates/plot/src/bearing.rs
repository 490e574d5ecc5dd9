//! The bearing as a drawing: a section through one side, with the contact angle, and the balls seen along the axis.

use crate::error::PlotError;
use crate::figure::Figure;
use crate::style::{GREY, INK, LABEL_PX, Stroke, TICK_PX, TITLE_PX, reference_stroke};
use crate::svg::{Anchor, Svg, Type};
use std::f64::consts::TAU;

/// Dimensions of a bearing for its drawing, m and rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingDrawing {
    /// Number of balls.
    pub ball_count: usize,
    /// Ball diameter, m.
    pub ball_diameter: f64,
    /// Pitch diameter, m.
    pub pitch_diameter: f64,
    /// Groove radii of inner and outer race over the ball diameter.
    pub groove_coefficients: [f64; 2],
    /// Contact angle of the unloaded bearing, rad.
    pub contact_angle: f64,
    /// Azimuth of the radial load on the inner ring, rad; none where there is none.
    pub radial_load: Option<f64>,
}

/// Size of the drawing, px, and the middles of section and face.
const SIZE: [f64; 2] = [640.0, 330.0];
const SECTION: [f64; 2] = [160.0, 185.0];
const FACE: [f64; 2] = [465.0, 185.0];
/// Ball diameter in the section and radius of the outer ring in the face, px.
const BALL_PX: f64 = 120.0;
const OUTSIDE_PX: f64 = 122.0;
/// Half width of the rings and distance of their backs from the pitch circle, in ball diameters: not in a case, drawn
/// in usual proportions.
const HALF_WIDTH: f64 = 0.62;
const BACK: f64 = 0.88;
/// Half width of the drawn grooves in ball diameters.
const GROOVE: f64 = 0.42;

impl BearingDrawing {
    fn check(&self) -> Result<(), PlotError> {
        let lengths = [self.ball_diameter, self.pitch_diameter, self.contact_angle];
        let sound = lengths.iter().chain(&self.groove_coefficients).all(|value| value.is_finite())
            && self.ball_count > 0
            && self.ball_diameter > 0.0
            && self.pitch_diameter > self.ball_diameter
            && self.groove_coefficients.iter().all(|f| *f > 0.5);
        if sound { Ok(()) } else { Err(PlotError::NoBearing) }
    }
}

/// The figure `bearing`: section and face.
///
/// # Errors
///
/// [`PlotError::NoBearing`] for lengths that make no bearing.
pub fn bearing_figure(drawing: &BearingDrawing) -> Result<Figure, PlotError> {
    drawing.check()?;
    let title = "The bearing that was solved";
    let mut svg = Svg::default();
    let head = Type { size: TITLE_PX, bold: true, anchor: Anchor::Middle, ..Type::default() };
    svg.text([0.5 * SIZE[0], 22.0], title, head);
    section(&mut svg, drawing);
    face(&mut svg, drawing);
    let below = Type { size: TICK_PX, anchor: Anchor::Middle, colour: GREY, ..Type::default() };
    let mm = |m: f64| format!("{:.2}", 1e3 * m);
    let sizes = format!(
        "{} balls of {} mm on a pitch circle of {} mm",
        drawing.ball_count,
        mm(drawing.ball_diameter),
        mm(drawing.pitch_diameter)
    );
    svg.text([0.5 * SIZE[0], SIZE[1] - 8.0], &sizes, below);
    let svg = svg.finish(SIZE, title, &format!("{title}: {sizes}, free contact angle {}.", degrees(drawing)));
    Ok(Figure::drawn("bearing", title, svg))
}

fn degrees(drawing: &BearingDrawing) -> String {
    format!("{:.2}°", drawing.contact_angle.to_degrees())
}

fn ink(width: f64) -> Stroke {
    Stroke { colour: INK, dash: "", width, ..reference_stroke(None) }
}

/// One side of the bearing cut along its axis, which lies below; the axial direction points to the right.
fn section(svg: &mut Svg, drawing: &BearingDrawing) {
    let (sin, cos) = drawing.contact_angle.sin_cos();
    let at = |axial: f64, radial: f64| [SECTION[0] + BALL_PX * axial, SECTION[1] - BALL_PX * radial];
    for (out, f) in [(-1.0, drawing.groove_coefficients[0]), (1.0, drawing.groove_coefficients[1])] {
        // The groove touches the ball where its normal points; its centre lies behind the ball's.
        let centre = [-out * (f - 0.5) * sin, -out * (f - 0.5) * cos];
        let groove = |axial: f64| {
            let along: f64 = axial - centre[0];
            at(axial, centre[1] + out * (f * f - along * along).max(0.0).sqrt())
        };
        let mut outline: Vec<[f64; 2]> = (0..=32).map(|k| groove(GROOVE * (f64::from(k) / 16.0 - 1.0))).collect();
        let shoulders = [outline[32][1], outline[0][1]];
        let [right, left] = [SECTION[0] + HALF_WIDTH * BALL_PX, SECTION[0] - HALF_WIDTH * BALL_PX];
        let back = at(0.0, out * BACK)[1];
        outline.extend([[right, shoulders[0]], [right, back], [left, back], [left, shoulders[1]]]);
        svg.tint(std::slice::from_ref(&outline), GREY, 0.16);
        svg.path(&outline, &ink(1.4), true);
    }
    svg.circle(SECTION, 0.5 * BALL_PX, INK, 1.6);
    let long = 0.78;
    svg.dashed_line(at(-long * sin, -long * cos), at(long * sin, long * cos), INK, 1.0);
    svg.dashed_line(at(0.0, -long), at(0.0, long), GREY, 1.0);
    let label = Type { size: LABEL_PX, ..Type::default() };
    svg.text(at(0.70, 0.10), &format!("α0 = {}", degrees(drawing)), label);
    let small = Type { size: TICK_PX, anchor: Anchor::Middle, colour: GREY, ..Type::default() };
    svg.text([SECTION[0], SECTION[1] - BALL_PX * BACK - 12.0], "section, axis of the bearing below", small);
}

/// The balls seen along the axis, X to the right and Y up.
fn face(svg: &mut Svg, drawing: &BearingDrawing) {
    let ratio = drawing.ball_diameter / drawing.pitch_diameter;
    // Radii over that of the pitch circle.
    let pitch = OUTSIDE_PX / (1.0 + 2.0 * BACK * ratio);
    let ring = |ratio: f64| pitch * ratio.max(0.02);
    for radius in [1.0 + 2.0 * BACK * ratio, 1.0 + ratio, 1.0 - ratio, 1.0 - 2.0 * BACK * ratio] {
        svg.circle(FACE, ring(radius), INK, 1.2);
    }
    let place = |azimuth: f64, radius: f64| [FACE[0] + radius * azimuth.cos(), FACE[1] - radius * azimuth.sin()];
    let numbered = drawing.ball_count <= 24;
    for ball in 0..drawing.ball_count {
        let azimuth = TAU * ball as f64 / drawing.ball_count as f64;
        let centre = place(azimuth, pitch);
        svg.circle(centre, 0.5 * pitch * 2.0 * ratio * 0.98, INK, 1.2);
        if numbered {
            svg.text(centre, &ball.to_string(), Type { size: TICK_PX, anchor: Anchor::Middle, ..Type::default() });
        }
    }
    let small = Type { size: TICK_PX, colour: GREY, ..Type::default() };
    svg.text([FACE[0] + OUTSIDE_PX + 6.0, FACE[1]], "X", small);
    svg.text([FACE[0], FACE[1] - OUTSIDE_PX - 9.0], "Y", Type { anchor: Anchor::Middle, ..small });
    let Some(direction) = drawing.radial_load else { return };
    let reach = 0.8 * ring(1.0 - 2.0 * BACK * ratio);
    let (tip, wing) = (place(direction, reach), 7.0);
    let barb = |turn: f64| {
        let back = direction + std::f64::consts::PI + turn;
        [tip[0] + wing * back.cos(), tip[1] - wing * back.sin()]
    };
    svg.path(&[FACE, tip], &ink(1.8), false);
    svg.path(&[barb(0.45), tip, barb(-0.45)], &ink(1.8), false);
    svg.text([FACE[0], FACE[1] + 14.0], "load", Type { anchor: Anchor::Middle, ..small });
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: BearingDrawing = BearingDrawing {
        ball_count: 13,
        ball_diameter: 0.03,
        pitch_diameter: 0.16,
        groove_coefficients: [0.52, 0.53],
        contact_angle: 0.3,
        radial_load: Some(0.0),
    };

    #[test]
    fn identity_all_balls_and_the_angle_are_drawn() {
        let figure = bearing_figure(&BALL).unwrap();
        // The ball of the section, four circles of the rings and 13 balls.
        assert_eq!(figure.svg().matches("<circle").count(), 18);
        assert!(figure.svg().contains("17.19°") && figure.svg().contains(">load<"), "{}", figure.svg());
        let without = bearing_figure(&BearingDrawing { radial_load: None, ..BALL }).unwrap();
        assert!(!without.svg().contains(">load<"));
    }

    #[test]
    fn limit_lengths_of_no_bearing_are_refused() {
        for wrong in [
            BearingDrawing { ball_count: 0, ..BALL },
            BearingDrawing { pitch_diameter: 0.02, ..BALL },
            BearingDrawing { groove_coefficients: [0.5, 0.53], ..BALL },
            BearingDrawing { contact_angle: f64::NAN, ..BALL },
        ] {
            assert!(matches!(bearing_figure(&wrong), Err(PlotError::NoBearing)));
        }
    }
}
