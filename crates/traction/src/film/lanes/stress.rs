//! The stress of a film at eight nodes, and the film's temperature.

use super::nodes::{Group, Kept};
use crate::fast::elementary::{exp, exp_m1, ln};
use crate::fast::lanes::{Lanes, fused, total};
use crate::film::{FilmLaw, FilmShear, Shearing};
use fearless_simd::{Level, dispatch, prelude::*};
use num_dual::Dual64;

/// Arguments of asinh below which its series is taken: the next term is 4e-17 of it.
const SERIES: f64 = 0.05;
/// asinh(x)/x in x².
const ASINH: [f64; 6] = [1.0, -1.0 / 6.0, 3.0 / 40.0, -15.0 / 336.0, 105.0 / 3456.0, -945.0 / 42_240.0];

/// A film at one temperature with the slopes of its oil by temperature.
#[derive(Clone, Copy)]
pub(super) struct Sloped {
    pub at: Shearing,
    /// d ln η0/dT, 1/K.
    log_ambient_slope: f64,
    /// d stiffness/dT, 1/K.
    stiffness_slope: f64,
    /// d ln Λ/dT, 1/K.
    limiting_slope: f64,
}

impl Sloped {
    /// A film at a temperature in K other than that for which it is there.
    pub fn new(law: &FilmLaw, film: &Shearing, temperature: f64) -> Self {
        let Shearing { stress, gap, creep, share } = law.warmed(film, Dual64::from(temperature).derivative());
        let at = Shearing { stress: stress.re(), gap: gap.re, creep: creep.re, share: share.re };
        Self {
            at,
            log_ambient_slope: stress.log_ambient.eps,
            stiffness_slope: stress.stiffness.eps,
            limiting_slope: stress.limiting.eps / stress.limiting.re,
        }
    }
}

/// Stress of the film alone and its slopes, Pa.
pub(super) struct Sheared<S: Simd> {
    pub stress: Lanes<S>,
    /// By the logarithm of the Newtonian slope m, which is that by the logarithm of the speed.
    pub by_newton: Lanes<S>,
    /// By the logarithm of τ_L; none where nothing limits it.
    pub by_limit: Lanes<S>,
    /// Share of the film in what film and bodies yield.
    pub yielding: Lanes<S>,
}

/// The film at eight nodes.
#[inline(always)]
pub(super) fn sheared<S: Simd>(film: &Sloped, at: &Group<S>) -> Sheared<S> {
    let stress = &film.at.stress;
    let thinning = fused(at.rise, -stress.stiffness, -stress.log_ambient);
    let compliance = exp(thinning.max(-700.0).min(700.0)) * film.at.gap;
    let newton = Lanes::splat(at.x.token(), 1.0) / (compliance + film.at.creep);
    let (limit, free) = (at.pressure * stress.limiting, newton * at.speed);
    let yielding = compliance * newton;
    match stress.shear {
        FilmShear::LimitingShear => {
            let e = exp_m1((-(free / limit)).max(-700.0));
            let (stress, by_newton) = (-(limit * e), free * (e + 1.0));
            Sheared { stress, by_newton, by_limit: stress - by_newton, yielding }
        }
        FilmShear::Eyring { stress: reference } => {
            let x = free * (1.0 / reference);
            let x2 = x * x;
            let root = (x2 + 1.0).sqrt();
            let stress = asinh(x, x2, root) * reference;
            let capped = stress.simd_gt(limit);
            let nothing = Lanes::splat(x.token(), 0.0);
            Sheared {
                stress: capped.select(limit, stress),
                by_newton: capped.select(nothing, free / root),
                by_limit: capped.select(limit, nothing),
                yielding,
            }
        }
    }
}

/// asinh(x) with x² and √(1 + x²), x ≥ 0.
#[inline(always)]
fn asinh<S: Simd>(x: Lanes<S>, x2: Lanes<S>, root: Lanes<S>) -> Lanes<S> {
    let (c, x4) = (ASINH, x2 * x2);
    let low = fused(fused(x2, c[3], c[2]), x4, fused(x2, c[1], c[0]));
    let series = x * fused(x4 * x4, fused(x2, c[5], c[4]), low);
    x.simd_lt(SERIES).select(series, ln(x + root))
}

/// Slope of the stress by the temperature, Pa/K.
#[inline(always)]
pub(super) fn by_temperature<S: Simd>(film: &Sloped, at: &Group<S>, sheared: &Sheared<S>) -> Lanes<S> {
    let warmed = fused(at.rise, film.stiffness_slope, film.log_ambient_slope) * sheared.yielding;
    fused(sheared.by_newton, warmed, sheared.by_limit * film.limiting_slope) * (1.0 - film.at.share)
}

/// Stress of film and asperities, Pa.
#[inline(always)]
pub(super) fn blended<S: Simd>(film: &Sloped, at: &Group<S>, sheared: &Sheared<S>) -> Lanes<S> {
    fused(at.dry - sheared.stress, film.at.share, sheared.stress)
}

/// Frictional power of the nodes (W) and its slope by the temperature (W/K).
pub(super) fn power(level: Level, film: &Sloped, nodes: &[Kept]) -> [f64; 2] {
    dispatch!(level, simd => {
        let mut sums = [Lanes::splat(simd, 0.0); 2];
        for kept in nodes {
            let node = kept.group(simd);
            let sheared = sheared(film, &node);
            let flow = node.area * node.speed;
            sums[0] = fused(flow, blended(film, &node, &sheared), sums[0]);
            sums[1] = fused(flow, by_temperature(film, &node, &sheared), sums[1]);
        }
        [total(sums[0]), total(sums[1])]
    })
}
