//! The nodes of a patch in groups of eight, with all that the stress there has of pressure and speed alone.

use crate::fast::elementary::{exp, exp_m1, ln};
use crate::fast::lanes::{LANES, Lanes, fused};
use crate::fast::nodes::{Block, Kernel, NODES, ROWS};
use crate::fast::{SMALLEST_SQUARE, values::row_slip};
use crate::film::{FilmLaw, node::LEAST_PRESSURE};
use crate::{MovingPatch, Patch, SlipField};
use fearless_simd::prelude::*;
use tribodyn_lubricant::{PressureViscosity, ROELANDS_PRESSURE};

/// Numbers of eight nodes.
pub(super) type Eight = [f64; LANES];

/// Eight nodes as they are kept from one pass over them to the next.
#[derive(Clone, Copy)]
pub(super) struct Kept {
    /// In the order of [`Group`].
    numbers: [Eight; 11],
}

/// Eight nodes.
pub(super) struct Group<S: Simd> {
    /// X and Y on the unit disc.
    pub x: Lanes<S>,
    pub y: Lanes<S>,
    /// Sliding velocity along rolling and across, and its magnitude, m/s.
    pub u: Lanes<S>,
    pub v: Lanes<S>,
    pub speed: Lanes<S>,
    /// Area that the node stands for, m².
    pub area: Lanes<S>,
    /// Pa.
    pub pressure: Lanes<S>,
    /// ln(η/η0) by pressure alone, and its derivative by ln p.
    pub rise: Lanes<S>,
    pub rise_slope: Lanes<S>,
    /// Stress of asperities, Pa, and its derivative by the logarithm of the speed.
    pub dry: Lanes<S>,
    pub dry_slope: Lanes<S>,
}

impl Kept {
    #[inline(always)]
    pub fn group<S: Simd>(&self, simd: S) -> Group<S> {
        let [x, y, u, v, speed, area, pressure, rise, rise_slope, dry, dry_slope] = &self.numbers;
        Group {
            x: Lanes::simd_from(simd, *x),
            y: Lanes::simd_from(simd, *y),
            u: Lanes::simd_from(simd, *u),
            v: Lanes::simd_from(simd, *v),
            speed: Lanes::simd_from(simd, *speed),
            area: Lanes::simd_from(simd, *area),
            pressure: Lanes::simd_from(simd, *pressure),
            rise: Lanes::simd_from(simd, *rise),
            rise_slope: Lanes::simd_from(simd, *rise_slope),
            dry: Lanes::simd_from(simd, *dry),
            dry_slope: Lanes::simd_from(simd, *dry_slope),
        }
    }
}

/// Values that the nodes of one patch share.
pub(super) struct Ground {
    pub slip: SlipField,
    peak: f64,
    area: f64,
    viscosity: PressureViscosity,
    /// Stress over speed that the flexibility of the bodies allows, Pa s/m.
    stick: f64,
    boundary_friction: f64,
}

/// Two rings of four points, exact for r⁶: (X, Y, weight).
const COARSE: [[f64; LANES]; 3] = {
    const RADII: [f64; 2] = [0.422_892_523_952_101_7, 0.842_645_122_263_405_2];
    const WEIGHTS: [f64; 2] = [0.305_606_804_347_677_1, 0.217_991_971_250_621_67];
    let mut nodes = [[0.0; LANES]; 3];
    // At 22.5° and 67.5° from the axes by turns.
    const COS: f64 = 0.923_879_532_511_286_7;
    const SIN: f64 = 0.382_683_432_365_089_8;
    let mut k = 0;
    while k < LANES {
        let ring = k / 4;
        let (c, s) = if ring == 0 { (COS, SIN) } else { (SIN, COS) };
        let [x, y] = match k % 4 {
            0 => [c, s],
            1 => [-s, c],
            2 => [-c, -s],
            _ => [s, -c],
        };
        nodes[0][k] = RADII[ring] * x;
        nodes[1][k] = RADII[ring] * y;
        nodes[2][k] = WEIGHTS[ring];
        k += 1;
    }
    nodes
};

impl Ground {
    pub fn new(law: &FilmLaw, contact: &MovingPatch, creep: f64) -> Self {
        let Patch { semi_lateral, semi_rolling, peak_pressure, .. } = contact.patch;
        Self {
            slip: SlipField::new(&contact.patch, &contact.motion),
            peak: peak_pressure,
            area: semi_lateral * semi_rolling,
            viscosity: law.oil.pressure,
            stick: 1.0 / creep,
            boundary_friction: law.boundary_friction,
        }
    }

    /// A coarse rule of eight nodes.
    #[inline(always)]
    pub fn coarse<S: Simd>(&self, simd: S) -> Kept {
        let [x, y, w] = COARSE;
        let (x, y, w) = (Lanes::simd_from(simd, x), Lanes::simd_from(simd, y), Lanes::simd_from(simd, w));
        let [u, offset, _] = row_slip(&self.slip, y);
        self.group(x, y, w, [u, offset])
    }

    #[inline(always)]
    fn group<S: Simd>(&self, x: Lanes<S>, y: Lanes<S>, weight: Lanes<S>, [u, offset]: [Lanes<S>; 2]) -> Kept {
        let v = fused(x, self.slip.lateral[1], offset);
        let speed = fused(v, v, u * u).max(SMALLEST_SQUARE).sqrt();
        let depth = fused(-x, x, fused(-y, y, 1.0)).max(0.0).sqrt();
        // The weight of the rule is for pressures: it holds the root. Nodes on the edge carry nothing.
        let nothing = Lanes::splat(x.token(), 0.0);
        let area = depth.simd_gt(0.0).select(weight * self.area / depth, nothing);
        let pressure = (depth * self.peak).max(LEAST_PRESSURE);
        let [rise, rise_slope] = self.pressed(pressure);
        let most = pressure * self.boundary_friction;
        let stretch = speed * self.stick / most;
        let e = exp_m1((-stretch).max(-700.0));
        let (dry, dry_slope) = (-(most * e), most * stretch * (e + 1.0));
        let [x, y, u, v] = [x.to_array(), y.to_array(), u.to_array(), v.to_array()];
        let [speed, area, pressure] = [speed.to_array(), area.to_array(), pressure.to_array()];
        let rises = [rise.to_array(), rise_slope.to_array()];
        let dries = [dry.to_array(), dry_slope.to_array()];
        Kept { numbers: [x, y, u, v, speed, area, pressure, rises[0], rises[1], dries[0], dries[1]] }
    }

    /// ln(η/η0) by pressure alone, as [`PressureViscosity::relative_log`], and its derivative by ln p.
    #[inline(always)]
    fn pressed<S: Simd>(&self, pressure: Lanes<S>) -> [Lanes<S>; 2] {
        match self.viscosity {
            PressureViscosity::Barus { coefficient } => [pressure * coefficient; 2],
            PressureViscosity::Roelands { index } => {
                let relative = pressure * ROELANDS_PRESSURE;
                let power = exp(ln(relative + 1.0) * index);
                [power - 1.0, power * index * (relative / (relative + 1.0))]
            }
        }
    }
}

/// The nodes of a rule.
pub(super) struct Collected<'a> {
    pub of: &'a Ground,
    pub nodes: Vec<Kept>,
}

impl<S: Simd> Kernel<S> for Collected<'_> {
    #[inline(always)]
    fn block(&mut self, block: &Block<S>) {
        for i in 0..block.rows.min(ROWS) {
            let y = block.y[i];
            let [u, offset, _] = row_slip(&self.of.slip, y);
            for k in 0..block.nodes.min(NODES) {
                self.nodes.push(self.of.group(block.x[i][k], y, block.w[i][k], [u, offset]));
            }
        }
    }
}
