//! Pressure of the film in a plain bearing that is short along its axis: the land of a cage.
//!
//! F. W. Ocvirk, Short-bearing approximation for full journal bearings, NACA TN 2808 (1952). With h = c (1 + ε cos θ),
//! θ from the widest place,
//!
//! ```text
//! p = 6 η/(c² (1 + ε cos θ)³) (L²/4 − z²) (ε W sin θ − ε' cos θ),   W = ½ (ω_1 + ω_2) − ψ'
//! F_r = k ∫ (ε W sin θ − ε' cos θ) cos θ/(1 + ε cos θ)³ dθ,   F_t the same with sin θ,   k = η R L³/c²
//! ```
//!
//! F_r along the eccentricity, F_t a quarter turn ahead of it. A film that is full all round (Sommerfeld) bears
//! tension; one that tears where it would (half-Sommerfeld, or Gümbel) is that half of the circumference where the
//! pressure is positive: with ε' = 0 and W > 0 the half 0 < θ < π of the textbooks, and it turns with ε' and W so that
//! the force is continuous and the film only ever takes power. The integrals are elementary in Sommerfeld's angle γ,
//! cos γ = (ε + cos θ)/(1 + ε cos θ): J. F. Booker, J. Basic Eng. 87 (1965) 537, doi:10.1115/1.3650602, has a table.
//!
//! Short means L/2R below about 0.5. Laminar, of one viscosity, without the pressure of ends that are fed.

use std::f64::consts::{PI, TAU};

/// How far round the film reaches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilmExtent {
    /// Half-Sommerfeld: it tears where its pressure would be negative.
    Half,
    /// Full Sommerfeld: it bears tension, as under a pressure of supply above that of the film.
    Full,
}

/// A short film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShortBearing {
    /// Dynamic viscosity η, Pa s.
    pub viscosity: f64,
    /// Radius R, m.
    pub radius: f64,
    /// Length L along the axis, m.
    pub length: f64,
    /// Radial clearance c, m.
    pub clearance: f64,
    /// How far round it reaches.
    pub extent: FilmExtent,
    /// Thinnest film over the clearance that the formulas are used for: surfaces as rough as that carry each other
    /// below. Thinner films have the coefficients of this one, which are approached with a continuous slope.
    pub thinnest: f64,
}

/// Motion of the axis in the film, over the clearance: along the eccentricity and a quarter turn ahead of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmMotion {
    /// Eccentricity ε, at least 0; above 1 it counts as the thinnest film.
    pub eccentricity: f64,
    /// ε', 1/s.
    pub outward: f64,
    /// ε W = ½ ε (ω_1 + ω_2) − ε ψ', 1/s: finite in the centre, where ψ' is not.
    pub wedge: f64,
}

impl ShortBearing {
    /// Force [along the eccentricity, a quarter turn ahead] on the part that is displaced, N: on a journal in a bush as
    /// on a bush about a journal.
    pub fn force(&self, motion: &FilmMotion) -> [f64; 2] {
        self.force_and_slopes(motion).0
    }

    /// The same, and its slopes [∂/∂ε', ∂/∂(ε W)] at this eccentricity, N s: the integrals themselves, since the
    /// pressure is 0 at the ends of the film, whichever way they move. In the centre of a half film at rest there are
    /// none, and these are those of a pure wedge.
    pub fn force_and_slopes(&self, motion: &FilmMotion) -> ([f64; 2], [[f64; 2]; 2]) {
        let FilmMotion { outward, wedge, .. } = *motion;
        let [ss, sc, cc] = self.integrals(motion);
        let k = self.viscosity * self.radius * self.length.powi(3) / self.clearance.powi(2);
        let force = [k * (wedge * sc - outward * cc), k * (wedge * ss - outward * sc)];
        (force, [[-k * cc, -k * sc], [k * sc, k * ss]])
    }

    /// 1/√(1 − ε²), by which friction is more than in the middle.
    pub fn friction_factor(&self, eccentricity: f64) -> f64 {
        self.gap_squared(self.bounded(eccentricity)).sqrt().recip()
    }

    /// ε, but that 1 − ε stays above the thinnest film.
    fn bounded(&self, eccentricity: f64) -> f64 {
        let (least, gap) = (self.thinnest, 1.0 - eccentricity);
        if gap >= 2.0 * least {
            return eccentricity;
        }
        let gap = gap.max(0.0);
        1.0 - least - 0.25 * gap * gap / least
    }

    fn gap_squared(&self, eccentricity: f64) -> f64 {
        (1.0 - eccentricity) * (1.0 + eccentricity)
    }

    /// ∫ sin², sin cos and cos² over (1 + ε cos θ)³, over the film.
    fn integrals(&self, motion: &FilmMotion) -> [f64; 3] {
        let e = self.bounded(motion.eccentricity);
        let square = self.gap_squared(e);
        let root = square.sqrt();
        let [ss, sc, cc] = match self.extent {
            FilmExtent::Full => [PI, 0.0, PI * (1.0 + 2.0 * e * e)],
            FilmExtent::Half => {
                // From θ = atan2(ε', ε W) on, half a turn.
                let size = motion.outward.hypot(motion.wedge);
                let (sin, cos) = if size > 0.0 { (motion.outward / size, motion.wedge / size) } else { (0.0, 1.0) };
                let [first, last] = [[sin, cos], [-sin, -cos]].map(|theta| sommerfeld(theta, e, root));
                let start = first[1].atan2(first[0]);
                let end = start + (last[1].atan2(last[0]) - start).rem_euclid(TAU);
                let below = |g: f64, [cos, sin]: [f64; 2]| {
                    let double = 0.5 * sin * cos;
                    [0.5 * g - double, 0.5 * sin * sin + e * cos, (0.5 + e * e) * g + double - 2.0 * e * sin]
                };
                let (a, b) = (below(start, first), below(end, last));
                std::array::from_fn(|k| b[k] - a[k])
            }
        };
        [ss / (square * root), sc / (square * square), cc / (square * square * root)]
    }
}

/// cos γ and sin γ of Sommerfeld's angle at [sin θ, cos θ], with √(1 − ε²).
fn sommerfeld([sin, cos]: [f64; 2], e: f64, root: f64) -> [f64; 2] {
    let thickness = 1.0 + e * cos;
    [(e + cos) / thickness, root * sin / thickness]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A land of 65 mm bore, 4 mm wide, 0.15 mm of radial clearance, in oil of 20 mPa s.
    fn land(extent: FilmExtent) -> ShortBearing {
        ShortBearing { viscosity: 0.02, radius: 0.0325, length: 4e-3, clearance: 1.5e-4, extent, thinnest: 1e-3 }
    }

    fn at(eccentricity: f64, outward: f64, w: f64) -> FilmMotion {
        FilmMotion { eccentricity, outward, wedge: eccentricity * w }
    }

    /// Ocvirk's closed forms with ε' = 0, evaluated apart from this program.
    #[test]
    fn paper_forces_and_attitude_of_a_half_film() {
        for (e, radial, along, attitude) in [
            (0.1, -0.018864, 0.147417, 82.7078),
            (0.5, -0.821728, 1.117838, 53.6802),
            (0.8, -9.130316, 5.378200, 30.5002),
        ] {
            let [r, t] = land(FilmExtent::Half).force(&at(e, 0.0, 500.0));
            assert!((r - radial).abs() < 5e-7 && (t - along).abs() < 5e-7, "{e}: {r} {t}");
            let angle = t.atan2(-r).to_degrees();
            assert!((angle - attitude).abs() < 5e-5, "{e}: {angle}");
            let exact = (PI * (1.0f64 - e * e).sqrt()).atan2(4.0 * e).to_degrees();
            assert!((angle - exact).abs() < 1e-9, "{e}: {angle} {exact}");
        }
    }

    /// 30 g on a film at a mean speed of 300 1/s.
    #[test]
    fn paper_weight_against_film() {
        let film = land(FilmExtent::Half);
        let force = |e: f64| film.force(&at(e, 0.0, 300.0));
        let (mut low, mut high) = (0.0, 0.9);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let [r, t] = force(middle);
            if r.hypot(t) < 0.03 * 9.81 { low = middle } else { high = middle }
        }
        let [r, t] = force(low);
        assert!((low - 0.280112).abs() < 1e-6, "{low}");
        assert!((t.atan2(-r).to_degrees() - 69.6188).abs() < 1e-4, "{}", t.atan2(-r).to_degrees());
    }

    /// Simpson's rule over the positive part of the pressure.
    fn quadrature(film: &ShortBearing, motion: &FilmMotion) -> [f64; 2] {
        let (count, e) = (400_000, motion.eccentricity);
        let k = film.viscosity * film.radius * film.length.powi(3) / film.clearance.powi(2);
        let mut sum = [0.0; 2];
        for i in 0..count {
            let (sin, cos) = (TAU * f64::from(i) / f64::from(count)).sin_cos();
            let pressure = (motion.wedge * sin - motion.outward * cos) / (1.0 + e * cos).powi(3);
            let pressure = if film.extent == FilmExtent::Half { pressure.max(0.0) } else { pressure };
            (sum[0], sum[1]) = (sum[0] + pressure * cos, sum[1] + pressure * sin);
        }
        sum.map(|s| k * s * TAU / f64::from(count))
    }

    #[test]
    fn identity_closed_forms_are_the_integral_of_the_pressure() {
        for extent in [FilmExtent::Half, FilmExtent::Full] {
            let film = land(extent);
            for (e, outward, w) in
                [(0.0, 30.0, 0.0), (0.3, 40.0, 500.0), (0.6, -200.0, 100.0), (0.7, 90.0, -400.0), (0.9, -5.0, 0.0)]
            {
                let (found, sum) = (film.force(&at(e, outward, w)), quadrature(&film, &at(e, outward, w)));
                let size = sum[0].hypot(sum[1]);
                for k in 0..2 {
                    assert!((found[k] - sum[k]).abs() < 1e-6 * size, "{extent:?} {e}: {found:?} {sum:?}");
                }
            }
        }
    }

    /// The slopes against differences of the force, where the film tears and where it does not.
    #[test]
    fn identity_slopes_are_those_of_the_force() {
        for extent in [FilmExtent::Half, FilmExtent::Full] {
            let film = land(extent);
            for (e, outward, w) in [(0.3, 40.0, 500.0), (0.6, -200.0, 100.0), (0.7, 90.0, -400.0), (0.9, -5.0, 0.0)] {
                let now = at(e, outward, w);
                let (force, slopes) = film.force_and_slopes(&now);
                let (size, h) = (force[0].hypot(force[1]) / outward.hypot(e * w), 1e-4);
                for k in 0..2 {
                    let moved = |h: f64| {
                        let FilmMotion { outward, wedge, .. } = now;
                        let motion =
                            [FilmMotion { outward: outward + h, ..now }, FilmMotion { wedge: wedge + h, ..now }];
                        film.force(&motion[k])
                    };
                    let (after, before) = (moved(h), moved(-h));
                    for i in 0..2 {
                        let difference = (after[i] - before[i]) / (2.0 * h);
                        assert!((slopes[k][i] - difference).abs() < 1e-6 * size, "{extent:?} {e} {k} {i}: {slopes:?}");
                    }
                }
            }
        }
    }

    /// Near the centre the full film is the damper D = π η R L³/c³ in a frame that turns at W.
    #[test]
    fn limit_a_full_film_near_the_centre_is_a_turning_damper() {
        let film = land(FilmExtent::Full);
        let damping = PI * 0.02 * 0.0325 * 4e-3f64.powi(3) / 1.5e-4f64.powi(3);
        assert!((damping - 38.723038).abs() < 1e-6, "{damping}");
        let e = 1e-6;
        let [r, t] = film.force(&at(e, 2e-4, 500.0));
        assert!((r + damping * 2e-4 * film.clearance).abs() < 1e-6 * r.abs());
        assert!((t - damping * 500.0 * e * film.clearance).abs() < 1e-6 * t);
    }

    /// Half a film is continuous where wedge and squeeze change their signs, and takes power whatever the motion.
    #[test]
    fn identity_a_film_takes_power_and_is_continuous() {
        let film = land(FilmExtent::Half);
        for e in [0.0, 0.4, 0.95, 0.999, 1.2] {
            let mut before: Option<[f64; 2]> = None;
            for k in 0..=3600 {
                let (wedge, outward) = (TAU * f64::from(k) / 3600.0).sin_cos();
                let [r, t] = film.force(&FilmMotion { eccentricity: e, outward, wedge });
                assert!(r * outward - t * wedge <= 0.0, "{e} {k}: {r} {t}");
                if let Some([r0, t0]) = before {
                    let size = film.force(&FilmMotion { eccentricity: e, outward: 1.0, wedge: 0.0 })[0].abs();
                    assert!((r - r0).hypot(t - t0) < 0.02 * size, "{e} {k}");
                }
                before = Some([r, t]);
            }
        }
    }

    /// Where the thinnest film is near, the force goes over to that of the thinnest film with its slope.
    #[test]
    fn identity_the_thinnest_film_is_approached_smoothly() {
        let film = land(FilmExtent::Half);
        let force = |gap: f64| film.force(&FilmMotion { eccentricity: 1.0 - gap, outward: 1.0, wedge: 0.0 })[0];
        for edge in [0.0, 2e-3] {
            let slope = |gap: f64| (force(gap + 1e-8) - force(gap - 1e-8)) / 2e-8;
            let (below, above) = (slope(edge - 1e-7), slope(edge + 1e-7));
            assert!((below - above).abs() < 1e-3 * slope(1e-3).abs(), "{edge}: {below:e} {above:e}");
        }
        assert_eq!(force(-0.1), force(-0.2));
    }
}
