//! One raceway as it wears: coating left and depth of the groove over the azimuth, and its local defects.

use crate::{Defect, LocalSurface, WearError};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Number of azimuth bins of a [`Raceway`]: 1° each. A contact ellipse of a bearing of 150 mm pitch diameter is 0.3° to
/// 1° long, so that finer bins would resolve what the contact itself smooths.
pub const BINS: usize = 360;

/// Mean wear depth over coating thickness at which the first steel shows: a Hertz contact loads the middle of its track
/// 1.5 times as much as the mean over its width, 1 − (y/a)² against ⅔, and slides about evenly.
const FIRST_STEEL: f64 = 2.0 / 3.0;

/// The state of one raceway, in the ring's own frame.
///
/// # Depth
/// Wear is kept as one depth per azimuth bin: the mean over the width 2a of the track that the ball's contact ellipse
/// leaves at each removal. Between the bins the depth is the quadratic B-spline of the bins' values, d(φ) = Σ c_k
/// B_k(φ). It is continuous with its first derivative, never negative, and its integral is that of the bins, so that a
/// volume removed anywhere comes out again: 2a R ∫ d dφ. A volume is shared among bins by the same B-spline, and so
/// goes along smoothly with a ball that rolls from bin to bin. Defects add their own depth.
///
/// Across the groove nothing is resolved: tracks at different contact angles or of different width are laid over each
/// other with their middles together. Where the contact angle varies along a turn the true depth is smaller.
///
/// # Coating
/// The thickness left is the new one less the depth, at least 0; after that the depth grows into the steel. The part of
/// the coating that is gone follows from the mean wear u = d/thickness by an assumption: nothing up to u = ⅔, where the
/// middle of a track worn in proportion to Hertz's pressure is through, everything at u = 1, and 3t² − 2t³ with
/// t = (u − ⅔)/⅓ between. (With Hertz's profile the bare strip carries 77 % of the load at u = 1; the rest goes soon
/// after.) A defect takes its part off what wear has left. A thickness of 0 stands for a race without coating: there is
/// nothing to wear through, and nothing becomes bare.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Stored")]
pub struct Raceway {
    /// Thickness of the coating when new, m.
    thickness: f64,
    /// Radius of the track about the bearing's axis, m.
    radius: f64,
    /// Wear depth by bin, m.
    depth: Vec<f64>,
    /// Volume removed since [`Self::new`], m³.
    volume: f64,
    defects: Vec<Defect>,
    /// True if nothing is worn and there is no defect.
    pristine: bool,
}

/// A stored raceway before it is checked.
#[derive(Deserialize)]
struct Stored {
    thickness: f64,
    radius: f64,
    depth: Vec<f64>,
    volume: f64,
    defects: Vec<Defect>,
    pristine: bool,
}

impl TryFrom<Stored> for Raceway {
    type Error = WearError;

    fn try_from(stored: Stored) -> Result<Self, WearError> {
        let Stored { thickness, radius, depth, volume, defects, pristine } = stored;
        check(thickness, radius, &defects)?;
        if depth.len() != BINS {
            return Err(WearError::Bins { count: depth.len() });
        }
        if let Some(&value) = depth.iter().chain([&volume]).find(|value| !(**value >= 0.0 && value.is_finite())) {
            return Err(WearError::Depth { race: "stored", value });
        }
        let pristine = pristine && defects.is_empty() && depth.iter().all(|&d| d == 0.0);
        Ok(Self { thickness, radius, depth, volume, defects, pristine })
    }
}

fn check(thickness: f64, radius: f64, defects: &[Defect]) -> Result<(), WearError> {
    if !(thickness >= 0.0 && thickness.is_finite()) {
        return Err(WearError::Thickness { value: thickness });
    }
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(WearError::Length { name: "radius of the track", value: radius });
    }
    defects.iter().try_for_each(Defect::check)
}

/// One azimuth of a raceway's profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ProfilePoint {
    /// Azimuth in the ring's own frame, rad.
    pub azimuth: f64,
    /// Coating left, m.
    pub thickness: f64,
    /// Depth of the groove below the new one, defects included, m.
    pub depth: f64,
    /// Part of the coating that is gone, 0 to 1.
    pub bare: f64,
}

impl Raceway {
    /// A raceway whose coating was `thickness_m` thick when new and has lost the part `worn_fraction` of it all round,
    /// with its track at `track_radius_m` about the bearing's axis.
    ///
    /// # Errors
    /// [`WearError`] for a thickness or fraction out of range, a radius that is no length, and impossible defects.
    pub fn new(
        thickness_m: f64,
        worn_fraction: f64,
        track_radius_m: f64,
        defects: &[Defect],
    ) -> Result<Self, WearError> {
        check(thickness_m, track_radius_m, defects)?;
        if !(0.0..=1.0).contains(&worn_fraction) {
            return Err(WearError::Fraction { name: "worn part of the coating", value: worn_fraction });
        }
        let depth = worn_fraction * thickness_m;
        Ok(Self {
            thickness: thickness_m,
            radius: track_radius_m,
            depth: vec![depth; BINS],
            volume: 0.0,
            defects: defects.to_vec(),
            pristine: depth == 0.0 && defects.is_empty(),
        })
    }

    /// True if the raceway is as new everywhere: [`Self::at`] is then [`LocalSurface::NEW`].
    #[inline]
    pub fn is_pristine(&self) -> bool {
        self.pristine
    }

    /// The surface at an azimuth in the ring's own frame, rad, of any number of turns. Depth and bare part are
    /// continuous with their first derivatives, and `slope` is that of the depth.
    #[inline]
    pub fn at(&self, azimuth: f64) -> LocalSurface {
        if self.pristine {
            return LocalSurface::NEW;
        }
        let (mut depth, mut slope) = self.wear(azimuth);
        let mut covered = 1.0 - self.bare_by_wear(depth);
        for defect in &self.defects {
            let (d, s, bare) = defect.at(azimuth);
            depth += d;
            slope += s;
            covered *= 1.0 - bare;
        }
        LocalSurface { depth, slope, bare: 1.0 - covered, ..LocalSurface::NEW }
    }

    /// True while nothing is worn and there is no defect: the surface is [`LocalSurface::NEW`] everywhere.
    pub fn is_new(&self) -> bool {
        self.pristine
    }

    /// Wears off a volume, m³, where a ball stands whose contact ellipse is `semi_lateral_m` across the groove from its
    /// middle to its edge: the track is twice as wide. Nothing happens for a volume or a semi-axis that is not above 0,
    /// or an azimuth that is not finite.
    #[inline]
    pub fn remove(&mut self, azimuth: f64, volume_m3: f64, semi_lateral_m: f64) {
        if !(volume_m3 > 0.0 && semi_lateral_m > 0.0 && azimuth.is_finite()) {
            return;
        }
        let (bins, fraction) = neighbours(azimuth);
        let depth = self.mean_depth_of(volume_m3, semi_lateral_m);
        for (bin, weight) in bins.into_iter().zip(weights(fraction)) {
            self.depth[bin] += weight * depth;
        }
        self.volume += volume_m3;
        self.pristine = false;
    }

    /// Depth that a volume makes in one bin, m.
    fn mean_depth_of(&self, volume: f64, semi_lateral: f64) -> f64 {
        volume / (2.0 * semi_lateral * self.radius * (TAU / BINS as f64))
    }

    /// Wears depths, m, off the bins, in the order of their azimuths from 0, that make up a volume, m³.
    pub(crate) fn remove_depths(&mut self, depths: impl Iterator<Item = f64>, volume: f64) {
        for (bin, depth) in self.depth.iter_mut().zip(depths) {
            *bin += depth;
        }
        self.volume += volume;
        self.pristine &= volume == 0.0;
    }

    /// Wear depth and its derivative, m and m/rad.
    #[inline]
    fn wear(&self, azimuth: f64) -> (f64, f64) {
        let ([a, b, c], t) = neighbours(azimuth);
        let (a, b, c) = (self.depth[a], self.depth[b], self.depth[c]);
        let [wa, wb, wc] = weights(t);
        // The derivative in differences, so that it is 0 and not rounding where the depths are alike.
        let slope = ((b - a) * (1.0 - t) + (c - b) * t) * (BINS as f64 / TAU);
        (wa * a + wb * b + wc * c, slope)
    }

    #[inline]
    fn bare_by_wear(&self, depth: f64) -> f64 {
        if self.thickness == 0.0 {
            return 0.0;
        }
        let t = ((depth / self.thickness - FIRST_STEEL) / (1.0 - FIRST_STEEL)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    }

    /// Thickness of the coating when new, m.
    pub fn new_thickness(&self) -> f64 {
        self.thickness
    }

    /// Radius of the track about the bearing's axis, m.
    pub fn track_radius(&self) -> f64 {
        self.radius
    }

    /// Coating left at an azimuth, m, averaged over the width of the track; defects do not count.
    pub fn thickness_at(&self, azimuth: f64) -> f64 {
        (self.thickness - self.wear(azimuth).0).max(0.0)
    }

    /// The thinnest coating at the middle of any bin, m; defects do not count.
    pub fn thinnest(&self) -> f64 {
        self.thickness_at(self.deepest())
    }

    /// The azimuth where wear is deepest, rad, of the middles of the bins; the first of several.
    pub fn deepest(&self) -> f64 {
        let by_depth = |azimuth: f64| self.wear(azimuth).0;
        middles().fold(0.5 * TAU / BINS as f64, |best, next| if by_depth(next) > by_depth(best) { next } else { best })
    }

    /// Place at which the coating is worn through, rad: the azimuth where wear is deepest, if no coating is left there.
    /// Without a coating there is none, and defects do not count.
    pub fn worn_through(&self) -> Option<f64> {
        let deepest = self.deepest();
        (self.thickness > 0.0 && self.thickness_at(deepest) == 0.0).then_some(deepest)
    }

    /// Volume removed since the raceway was made, m³; what was worn before and what defects lack is not in it.
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// Mean wear depth over the azimuth, m, with what was worn at the start and without defects: the d of
    /// [`crate::WearDepths`].
    pub fn mean_depth(&self) -> f64 {
        self.depth.iter().sum::<f64>() / BINS as f64
    }

    /// The raceway at the middles of its bins, from azimuth 0 on.
    pub fn profile(&self) -> impl Iterator<Item = ProfilePoint> + '_ {
        middles().map(|azimuth| {
            let LocalSurface { depth, bare, .. } = self.at(azimuth);
            ProfilePoint { azimuth, thickness: self.thickness_at(azimuth), depth, bare }
        })
    }
}

/// Azimuths of the middles of the bins, rad.
pub(crate) fn middles() -> impl Iterator<Item = f64> {
    (0..BINS).map(|k| (k as f64 + 0.5) * (TAU / BINS as f64))
}

/// The bin before, of and after an azimuth, and where in its bin it lies, 0 to 1.
#[inline]
fn neighbours(azimuth: f64) -> ([usize; 3], f64) {
    let bins = azimuth * (BINS as f64 / TAU);
    let floor = bins.floor();
    // Both are below 2^53 for any azimuth a run can reach, so that the remainder is exact.
    let turned = floor - (floor / BINS as f64).floor() * BINS as f64;
    let k = (turned as usize).min(BINS - 1);
    let before = if k == 0 { BINS - 1 } else { k - 1 };
    let after = if k == BINS - 1 { 0 } else { k + 1 };
    ([before, k, after], bins - floor)
}

/// Quadratic B-spline weights of three bins at a place in the middle one.
#[inline]
fn weights(t: f64) -> [f64; 3] {
    [0.5 * (1.0 - t) * (1.0 - t), 0.5 + t * (1.0 - t), 0.5 * t * t]
}

#[cfg(test)]
mod tests;
