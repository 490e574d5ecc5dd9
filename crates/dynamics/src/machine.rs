//! The bearing as a system of bodies: what moves, what holds it and what drives it.

use crate::error::DynamicsError;
use crate::forces::Watch;
use crate::layout::Layout;
use tribodyn_bearing::{Bearing, CageBody, Guidance, LoadedPatch, Pocket, RingOffset, Side};
use tribodyn_case::{Case, CoatingSpec, GuidanceSpec, SpeedHistory, SupportSpec, Tilt, Translation};
use tribodyn_fluid::AnnulusDrag;
use tribodyn_traction::{
    FastPatch, Law, PatchDerivative, PatchRule, PatchTraction, PressureChoice, Quadrature, TractionLaw,
};
use tribodyn_wear::{Defect, Raceway};

/// A bearing with its cage, supports, loads and drives.
#[derive(Debug, Clone)]
pub(crate) struct Machine {
    pub bearing: Bearing,
    pub layout: Layout,
    pub kernel: Kernel,
    pub inner: Support<3>,
    pub outer: Support<2>,
    /// Tilt of the inner ring, held at what the quasi-static solution has, rad.
    pub tilt: [f64; 2],
    pub cage: CageBody,
    pub loads: [Translation; 3],
    pub speeds: [SpeedHistory; 2],
    /// Inner, outer.
    pub raceways: [Raceway; 2],
    /// Thinnest coating left on each, m, as of the last look.
    pub thinnest: [f64; 2],
    /// Factor on wear in what it does to the raceways.
    pub wear_acceleration: f64,
    /// What the last evaluation of the derivative saw of each ball.
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

    /// Whether [`Self::derivative`] has something to say of this bearing.
    pub fn has_derivative(&self, bearing: &Bearing) -> bool {
        // Any pressure: a law is of that kind or is not.
        const PRESSURE: f64 = 2e9;
        let curve = |side| bearing.races[side].law.kragelskii_slope(PRESSURE).is_some();
        matches!(self, Self::Fast(_))
            && bearing.pressure_choice == PressureChoice::Peak
            && curve(Side::Inner)
            && curve(Side::Outer)
    }

    /// Traction with its derivatives by motion and load, of coating and bare steel by their shares; none for laws without
    /// a Kragelskii curve.
    pub fn derivative(&self, bearing: &Bearing, p: &LoadedPatch<'_, f64>) -> Option<PatchDerivative> {
        let Self::Fast(fast) = self else { return None };
        if bearing.pressure_choice != PressureChoice::Peak {
            return None;
        }
        let of = |law: &Law| {
            let curve = law.kragelskii(p.patch.peak_pressure)?;
            let slope = law.kragelskii_slope(p.patch.peak_pressure)?;
            Some(fast.derivative(&p.patch, &p.motion, p.rolling_speed, (&curve, &slope), bearing.slip_unit))
        };
        match &p.race.bare_law {
            Some(bare) if p.bare >= 1.0 => of(bare),
            Some(bare) if p.bare > 0.0 => Some(of(&p.race.law)?.mixed_with(&of(bare)?, p.bare)),
            _ => of(&p.race.law),
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
    /// Whether the ring moves along the axis.
    pub free: [bool; N],
}

impl<const N: usize> Support<N> {
    fn new(spec: &SupportSpec<N>, free: [bool; N]) -> Self {
        let SupportSpec { mass, stiffness, damping } = *spec;
        Self { mass, stiffness, damping, reference: [0.0; N], free }
    }

    /// Force of springs and dampers on the ring, N.
    pub fn force(&self, axis: usize, position: f64, velocity: f64) -> f64 {
        -self.stiffness[axis] * (position - self.reference[axis]) - self.damping[axis] * velocity
    }
}

impl Machine {
    /// The machine of a case, its springs not yet set.
    pub fn new(case: &Case, mut bearing: Bearing, quadrature: Quadrature) -> Result<Self, DynamicsError> {
        let missing = |path| DynamicsError::Missing { path };
        let supports = case.supports.as_ref().ok_or(missing("supports"))?;
        let transient = case.transient.as_ref().ok_or(missing("transient"))?;
        let inertia = case.cage.inertia.ok_or(missing("cage.inertia"))?;
        if supports.outer.stiffness.contains(&0.0) {
            return Err(DynamicsError::Unsupported { path: "supports.outer.stiffness" });
        }
        (bearing.contact_damping, bearing.ring_offset) = (transient.contact_damping, RingOffset::Exact);
        let loads = [&case.ring.x, &case.ring.y, &case.ring.z].map(Clone::clone);
        let free = [0, 1, 2].map(|i| !matches!(loads[i], Translation::Held(_)));
        let tilt = |t: &Tilt| t.at(0.0);
        let raceways = raceways(case, &bearing)?;
        Ok(Self {
            layout: Layout { balls: bearing.geometry.ball_count },
            watch: vec![Watch::default(); bearing.geometry.ball_count],
            inner: Support::new(&supports.inner, free),
            outer: Support::new(&supports.outer, [true; 2]),
            tilt: [tilt(&case.ring.tilt_x), tilt(&case.ring.tilt_y)],
            cage: cage_body(case, &bearing, inertia),
            loads,
            speeds: [case.speed.inner.clone(), case.speed.outer.clone()],
            thinnest: raceways.each_ref().map(Raceway::thinnest),
            raceways,
            wear_acceleration: transient.wear_acceleration,
            kernel: Kernel::Fast(FastPatch::of(quadrature)),
            bearing,
        })
    }
}

fn cage_body(case: &Case, bearing: &Bearing, inertia: f64) -> CageBody {
    let spec = &case.cage;
    let radius = 0.5 * bearing.geometry.pitch_diameter;
    let pocket = Pocket {
        radius,
        clearance: spec.pocket_gap / radius,
        stiffness: spec.pocket_stiffness,
        damping: spec.pocket_damping,
        friction: spec.pocket_friction,
        ball_radius: 0.5 * bearing.geometry.ball_diameter,
    };
    let guidance = spec.guidance.and_then(|land| guidance(&land, bearing));
    CageBody { pocket, inertia, drag_torque: spec.drag_torque, guidance }
}

/// The land's film; a dry bearing has none.
fn guidance(spec: &GuidanceSpec, bearing: &Bearing) -> Option<Guidance> {
    let GuidanceSpec { radius, width, gap, .. } = *spec;
    let land = bearing.fluid.map(|f| AnnulusDrag { density: f.density, viscosity: f.viscosity, radius, width, gap })?;
    Some(Guidance { land, side: spec.land })
}

fn raceways(case: &Case, bearing: &Bearing) -> Result<[Raceway; 2], DynamicsError> {
    let of = |side: Side, spec: &CoatingSpec| {
        let defects: Vec<Defect> = case
            .defects
            .iter()
            .filter(|d| d.race == side)
            .map(|d| Defect { azimuth: d.azimuth, width: d.width, depth: d.depth, bare: d.bare })
            .collect();
        let g = &bearing.geometry;
        // Where the balls touch at the free contact angle.
        let outwards = g.ball_radius() * g.cos_contact_angle();
        let track = 0.5 * g.pitch_diameter + if side == Side::Inner { -outwards } else { outwards };
        Raceway::new(spec.thickness, spec.worn, track, &defects)
    };
    Ok([of(Side::Inner, &case.coatings.inner)?, of(Side::Outer, &case.coatings.outer)?])
}
