//! Traction of a patch whose surfaces are rigid or give way under shear, and where it stands in the ball.

use crate::bearing::Bearing;
use crate::contact::{LoadedPatch, NormalContact};
use crate::elastic::ElasticPatches;
use crate::modelling::RollingRadius;
use crate::races::Side;
use crate::state::BallSize;
use tribodyn_contact::Scalar;
use tribodyn_traction::{
    FastPatch, Kragelskii, PatchDerivative, PatchTraction, Quadrature, SlipUnit, elastic_patch_traction,
    fast_elastic_patch_traction, fast_patch_traction, linear_elastic_patch_traction, linear_patch_traction,
    patch_traction,
};

impl ElasticPatches {
    /// Traction of a patch with its derivatives, for a Kragelskii curve and its derivatives by the pressure.
    pub fn derivative(
        &self,
        p: &LoadedPatch<'_, f64>,
        (curve, slope, slip_unit): (&Kragelskii, &Kragelskii, SlipUnit),
    ) -> PatchDerivative {
        self.grid.derivative(&p.patch, &p.motion, p.rolling_speed, (curve, slope, slip_unit), &self.pairs[p.side])
    }
}

impl Bearing {
    /// The same bearing with rigid patches: cheap, and near enough to find the neighbourhood of an equilibrium.
    pub fn with_rigid_patches(&self) -> Self {
        Self { elastic: None, ..self.clone() }
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
