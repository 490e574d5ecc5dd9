//! The bearing as a system of bodies: what moves, what holds it and what drives it.

use crate::ball_surfaces::BallSurfaces;
use crate::error::DynamicsError;
use crate::layout::Layout;
use crate::tilting::Tilting;
use crate::watch::Watch;
use tribodyn_bearing::{
    AzimuthFrame, Bearing, CageBody, CoatingState, FreeCage, LoadedPatch, Races, RingOffset, RunInputs, Side,
    SpeedHistory, Tilt, Translation,
};
use tribodyn_traction::{FastPatch, PatchDerivative, PatchRule, PatchTraction, Quadrature};
use tribodyn_wear::{Defect, Raceway, SpallPath};

/// A bearing with its cage, supports, loads and drives.
#[derive(Debug, Clone)]
pub(crate) struct Machine {
    pub bearing: Bearing,
    pub layout: Layout,
    pub kernel: Kernel,
    pub inner: Support<3>,
    pub outer: Support<2>,
    /// Tilt of the inner ring where it is held, at what the quasi-static solution has, rad.
    pub tilt: [f64; 2],
    /// Rings that are free to tilt.
    pub tilting: Races<Option<Tilting>>,
    pub cage: CageBody,
    /// The cage, where it is free to move in all directions.
    pub free_cage: Option<FreeCage>,
    /// Force over velocity that stops a ball in its pocket within a step of the fast scheme, N s/m: the most of
    /// friction over sliding velocity in that of a free cage. Infinite for other schemes.
    pub hold: f64,
    /// Share of the stiffness of the pockets that acts: less than one where several balls press on a light cage in long
    /// steps of the fast scheme.
    pub pocket_share: f64,
    pub loads: [Translation; 3],
    pub speeds: Races<SpeedHistory>,
    pub raceways: Races<Raceway>,
    /// Paths of the balls over the spalls of the races.
    pub spalls: Races<Vec<SpallPath>>,
    /// Spalls of the balls.
    pub ball_surfaces: BallSurfaces,
    /// Thinnest coating left on each, m, as of the last look.
    pub thinnest: Races<f64>,
    /// Factor on wear in what it does to the raceways.
    pub wear_acceleration: f64,
    /// Azimuths of the middles of the pockets against the cage, rad.
    pub places: Vec<f64>,
    /// The directions of these azimuths.
    pub directions: Vec<AzimuthFrame>,
    /// State of each ball's contacts at the last evaluation of the derivative.
    pub watch: Vec<Watch>,
}

/// Who integrates traction over the patches.
#[derive(Debug, Clone)]
pub(crate) enum Kernel {
    /// Several nodes at a time.
    Fast(FastPatch),
    /// Node by node, the generic reference.
    Plain(Quadrature),
}

impl Kernel {
    /// The rule, the same for both.
    pub fn rule(&self) -> PatchRule {
        match self {
            Self::Fast(fast) => fast.quadrature().rule(),
            Self::Plain(quadrature) => quadrature.rule(),
        }
    }

    /// True if [`Self::derivative`] has an answer for this bearing.
    pub fn has_derivative(&self, bearing: &Bearing) -> bool {
        matches!(self, Self::Fast(_)) && bearing.has_patch_derivative()
    }

    /// Traction with its derivatives by motion and load, of coating and bare steel by their shares; none where the
    /// generic quadrature has to be taken.
    pub fn derivative(&self, p: &LoadedPatch<'_, f64>) -> Option<PatchDerivative> {
        match self {
            Self::Fast(fast) => p.derivative(fast),
            Self::Plain(_) => None,
        }
    }

    pub fn traction(&self, bearing: &Bearing, patch: &LoadedPatch<'_, f64>) -> PatchTraction {
        match self {
            Self::Fast(fast) => bearing.fast_traction(patch, fast),
            Self::Plain(quadrature) => bearing.plain_traction(patch, quadrature),
        }
    }
}

/// A ring on its springs and dampers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Support<const N: usize> {
    pub mass: f64,
    pub stiffness: [f64; N],
    pub damping: [f64; N],
    /// Position at which the spring carries nothing, m.
    pub reference: [f64; N],
    /// True where the ring moves along the axis.
    pub free: [bool; N],
}

impl<const N: usize> Support<N> {
    fn new(support: &tribodyn_bearing::Support<N>, free: [bool; N]) -> Self {
        let tribodyn_bearing::Support { mass, stiffness, damping } = *support;
        Self { mass, stiffness, damping, reference: [0.0; N], free }
    }

    /// Force of springs and dampers on the ring, N.
    pub fn force(&self, axis: usize, position: f64, velocity: f64) -> f64 {
        -self.stiffness[axis] * (position - self.reference[axis]) - self.damping[axis] * velocity
    }
}

impl Machine {
    /// The machine of a run, its springs not yet set.
    pub fn new(inputs: RunInputs, quadrature: Quadrature) -> Result<Self, DynamicsError> {
        let ball_surfaces = BallSurfaces::of(&inputs);
        let marked = ball_surfaces.balls().len();
        let RunInputs { mut bearing, ring, speeds, cage, free_cage, supports, coatings, defects, options, .. } = inputs;
        let aligned = [Tilt::Held(0.0), Tilt::Held(0.0)];
        let moments = Races { inner: [ring.tilt_x.clone(), ring.tilt_y.clone()], outer: aligned };
        let tilting = Races::from_fn(|side| inputs.tilting[side].map(|body| Tilting::new(body, moments[side].clone())));
        if supports.outer.stiffness.contains(&0.0) {
            return Err(DynamicsError::Unsupported { path: "supports.outer.stiffness" });
        }
        if inputs.tilting.outer.is_some_and(|body| body.stiffness.contains(&0.0)) {
            return Err(DynamicsError::Unsupported { path: "supports.outer_tilt.stiffness" });
        }
        (bearing.contact_damping, bearing.ring_offset) = (options.contact_damping, RingOffset::Exact);
        let tilt = [ring.tilt_x.at(0.0), ring.tilt_y.at(0.0)];
        let loads = [ring.x, ring.y, ring.z];
        let free = [0, 1, 2].map(|i| !matches!(loads[i], Translation::Held(_)));
        let raceways = Races::try_from_fn(|side| raceway(&bearing, side, &coatings[side], &defects[side]))?;
        let balls = bearing.geometry.ball_count;
        Ok(Self {
            layout: Layout {
                balls,
                free_cage: free_cage.is_some(),
                tilting: tilting.each_ref().map(Option::is_some),
                marked,
            },
            places: (0..balls).map(|ball| bearing.azimuth(ball)).collect(),
            directions: (0..balls).map(|ball| AzimuthFrame::at(bearing.azimuth(ball))).collect(),
            watch: vec![Watch::default(); balls],
            inner: Support::new(&supports.inner, free),
            outer: Support::new(&supports.outer, [true; 2]),
            tilt,
            tilting,
            cage: CageBody::new(&cage, &bearing),
            free_cage,
            hold: f64::INFINITY,
            pocket_share: 1.0,
            loads,
            speeds,
            thinnest: raceways.each_ref().map(Raceway::thinnest),
            raceways,
            spalls: Races::default(),
            ball_surfaces,
            wear_acceleration: options.wear_acceleration,
            kernel: Kernel::Fast(FastPatch::of(quadrature)),
            bearing,
        })
    }
}

fn raceway(
    bearing: &Bearing,
    side: Side,
    coating: &CoatingState,
    defects: &[Defect],
) -> Result<Raceway, DynamicsError> {
    Ok(Raceway::new(coating.thickness, coating.worn, bearing.track_radius(side), defects)?)
}
