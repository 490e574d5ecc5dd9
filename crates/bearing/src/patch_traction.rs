//! Traction of a patch whose surfaces are rigid or give way under shear, and where it stands in the ball.

use crate::bearing::Bearing;
use crate::contact::{LoadedPatch, NormalContact};
use crate::elastic::ElasticPatches;
use crate::modelling::RollingRadius;
use crate::races::Side;
use crate::state::BallSize;
use tribodyn_contact::Scalar;
use tribodyn_traction::{
    FastPatch, Law, MovingPatch, PatchDerivative, PatchLaw, PatchTraction, PressureChoice, Quadrature, TractionLaw,
    elastic_patch_traction, fast_elastic_patch_traction, fast_patch_traction, linear_elastic_patch_traction,
    linear_patch_traction, patch_traction,
};

/// Pa: a law has a curve of a kind at every pressure or at none.
const ANY_PRESSURE: f64 = 2e9;

impl LoadedPatch<'_, f64> {
    /// Traction with its derivatives by motion and load, of coating and bare steel by their shares; `None` where the
    /// generic quadrature has to be taken.
    pub fn derivative(&self, fast: &FastPatch) -> Option<PatchDerivative> {
        let tribology = self.tribology?;
        let of = |law: &Law| {
            let law = tribology.patch_law(law);
            match self.elastic {
                Some(elastic) => elastic.derivative(self, &law),
                None => law.fast_derivative(&self.moving(), fast),
            }
        };
        let coating = &tribology.laws[self.side];
        match &tribology.bare_law {
            Some(bare) if self.bare >= 1.0 => of(bare),
            Some(bare) if self.bare > 0.0 => Some(of(coating)?.mixed_with(&of(bare)?, self.bare)),
            _ => of(coating),
        }
    }

    /// The patch with its motion.
    fn moving(&self) -> MovingPatch {
        MovingPatch { patch: self.patch, motion: self.motion, rolling_speed: self.rolling_speed }
    }
}

impl ElasticPatches {
    /// Traction of a patch with its derivatives where one Kragelskii curve holds for all of it.
    fn derivative(&self, p: &LoadedPatch<'_, f64>, law: &PatchLaw<'_, Law>) -> Option<PatchDerivative> {
        if law.pressure != PressureChoice::Peak {
            return None;
        }
        let curve = law.law.kragelskii(p.patch.peak_pressure)?;
        let slope = law.law.kragelskii_slope(p.patch.peak_pressure)?;
        let curves = (&curve, &slope, law.slip_unit);
        Some(self.grid.derivative(&p.patch, &p.motion, p.rolling_speed, curves, &self.pairs[p.side]))
    }
}

impl Bearing {
    /// The same bearing with rigid patches: cheap, and near enough to find the neighbourhood of an equilibrium.
    pub fn with_rigid_patches(&self) -> Self {
        Self { elastic: None, ..self.clone() }
    }

    /// True where [`LoadedPatch::derivative`] has an answer on both races.
    pub fn has_patch_derivative(&self) -> bool {
        let Some(tribology) = &self.tribology else { return false };
        let of_law = |law: &Law| {
            let curve_in_elastic = || law.kragelskii_slope(ANY_PRESSURE).is_some();
            tribology.patch_law(law).has_derivative() && (self.elastic.is_none() || curve_in_elastic())
        };
        Side::BOTH.into_iter().all(|side| of_law(&tribology.laws[side]))
    }

    /// How far a patch stands within a sphere of the nominal radius about the ball's centre, m: without it for a ball
    /// that is too large, and 0 for a nominal one that rolls at its undeformed radius.
    #[inline(always)]
    pub(crate) fn sunk<D: Scalar>(&self, side: Side, contact: &NormalContact<D>, ball: &BallSize) -> D {
        let approach = contact.pose.approach;
        let within = match self.modelling.rolling_radius {
            Some(RollingRadius::Deformed) if approach.re() > 0.0 => approach * self.races[side].ball_share,
            _ => D::zero(),
        };
        within - ball.excess
    }

    /// The traction of a patch by the generic quadrature; where the coating is partly gone, of both surfaces by their
    /// shares. An elastic patch has strips and cells of its own instead of the quadrature.
    pub fn plain_traction<D: Scalar>(&self, p: &LoadedPatch<'_, D>, quadrature: &Quadrature) -> PatchTraction<D> {
        match p.elastic {
            None => p.blend(|law| patch_traction(&p.patch, &p.motion, p.rolling_speed, law, quadrature)),
            Some(ElasticPatches { grid, pairs }) => {
                p.blend(|law| elastic_patch_traction(&p.patch, &p.motion, p.rolling_speed, law, &pairs[p.side], grid))
            }
        }
    }

    /// [`Self::plain_traction`] by the kernel that works on several nodes at a time.
    pub fn fast_traction(&self, p: &LoadedPatch<'_, f64>, kernel: &FastPatch) -> PatchTraction {
        match p.elastic {
            None => p.blend(|law| fast_patch_traction(kernel, &p.patch, &p.motion, p.rolling_speed, law)),
            Some(ElasticPatches { grid, pairs }) => p.blend(|law| {
                fast_elastic_patch_traction(grid, &p.patch, &p.motion, p.rolling_speed, law, &pairs[p.side])
            }),
        }
    }

    /// [`Self::fast_traction`] with first derivatives, under the conditions of [`linear_patch_traction`].
    pub fn linear_traction<D: Scalar>(&self, p: &LoadedPatch<'_, D>, kernel: &FastPatch) -> PatchTraction<D> {
        match p.elastic {
            None => p.blend(|law| linear_patch_traction(kernel, &p.patch, &p.motion, p.rolling_speed, law)),
            Some(ElasticPatches { grid, pairs }) => p.blend(|law| {
                linear_elastic_patch_traction(grid, &p.patch, &p.motion, p.rolling_speed, law, &pairs[p.side])
            }),
        }
    }
}
