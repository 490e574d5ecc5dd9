//! Effects of wear on a bearing, by name.

use crate::error::StudyError;

/// Effects of wear on the bearing, each to be switched by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Effects {
    /// Depth under the contacts counts as radial clearance: the contact angle grows.
    pub clearance: bool,
    /// The worn profile changes the curvature of the groove under the contacts: pressures change.
    pub curvature: bool,
    /// Bare steel slides where the coating is gone.
    pub traction: bool,
    /// Lubricant comes from the cage.
    pub transfer: bool,
}

impl Effects {
    /// By their names.
    ///
    /// # Errors
    /// Another name, with those that there are.
    pub fn named<'a>(names: impl IntoIterator<Item = &'a str>) -> Result<Self, StudyError> {
        let mut effects = Self::default();
        for name in names {
            match name.trim() {
                "clearance" => effects.clearance = true,
                "curvature" => effects.curvature = true,
                "traction" => effects.traction = true,
                "transfer" => effects.transfer = true,
                "none" => {}
                other => {
                    let allowed = "allowed are clearance, curvature, traction, transfer, and none";
                    return Err(StudyError::argument("acting", other, allowed));
                }
            }
        }
        Ok(effects)
    }

    /// The names of those that are on.
    pub fn names(&self) -> Vec<&'static str> {
        let all = [
            ("clearance", self.clearance),
            ("curvature", self.curvature),
            ("traction", self.traction),
            ("transfer", self.transfer),
        ];
        all.into_iter().filter(|(_, on)| *on).map(|(name, _)| name).collect()
    }
}
