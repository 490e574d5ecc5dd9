//! Numbers of a ball that are drawn, with their units.

use tribodyn_bearing::quantities::{OfBall, RPM_PER_RAD_S, Scope};
use tribodyn_bearing::{BallResult, Side};

/// A quantity of one ball, or of one of its contacts, that is drawn over the azimuth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Inner contact angle, in degrees.
    ContactAngleInner,
    /// Outer contact angle, in degrees.
    ContactAngleOuter,
    /// Inner contact load; N, drawn in kN.
    LoadInner,
    /// Outer contact load; N, drawn in kN.
    LoadOuter,
    /// Inner elastic approach; m, drawn in µm.
    ApproachInner,
    /// Outer elastic approach; m, drawn in µm.
    ApproachOuter,
    /// Inner peak pressure; Pa, drawn in GPa.
    PeakPressureInner,
    /// Outer peak pressure; Pa, drawn in GPa.
    PeakPressureOuter,
    /// Longitudinal traction on the ball at the inner contact, N.
    TractionInner,
    /// Longitudinal traction on the ball at the outer contact, N.
    TractionOuter,
    /// Longitudinal slide-to-roll ratio at the inner contact.
    SlideToRollInner,
    /// Longitudinal slide-to-roll ratio at the outer contact.
    SlideToRollOuter,
    /// Wear rate at the inner race, m³/s.
    WearRateInner,
    /// Wear rate at the outer race, m³/s.
    WearRateOuter,
    /// Wear rate at the cage pocket, m³/s.
    WearRateCage,
    /// Orbital speed; rad/s, drawn in r/min.
    OrbitalSpeed,
    /// Pocket force on the ball along the orbit, N.
    CageForce,
    /// Frictional power at the inner contact, W.
    PowerLossInner,
    /// Frictional power at the outer contact, W.
    PowerLossOuter,
    /// Power taken by drag and churning, W.
    PowerLossFluid,
}

/// Load up to which a contact counts as open, N: what the balance leaves at the outer race of a ball that nothing
/// drives.
const LEAST_LOAD_N: f64 = 1e-3;

impl Quantity {
    /// Its row in the table of quantities: its race, and its name without race and unit.
    fn key(self) -> (Option<Side>, &'static str) {
        let (inner, outer) = (Some(Side::Inner), Some(Side::Outer));
        match self {
            Self::ContactAngleInner => (inner, "contact_angle"),
            Self::ContactAngleOuter => (outer, "contact_angle"),
            Self::LoadInner => (inner, "load"),
            Self::LoadOuter => (outer, "load"),
            Self::ApproachInner => (inner, "approach"),
            Self::ApproachOuter => (outer, "approach"),
            Self::PeakPressureInner => (inner, "peak_pressure"),
            Self::PeakPressureOuter => (outer, "peak_pressure"),
            Self::TractionInner => (inner, "traction"),
            Self::TractionOuter => (outer, "traction"),
            Self::SlideToRollInner => (inner, "slide_to_roll"),
            Self::SlideToRollOuter => (outer, "slide_to_roll"),
            Self::WearRateInner => (inner, "wear_rate"),
            Self::WearRateOuter => (outer, "wear_rate"),
            Self::WearRateCage => (None, "wear_rate_cage"),
            Self::OrbitalSpeed => (None, "orbital_speed"),
            Self::CageForce => (None, "pocket_force"),
            Self::PowerLossInner => (inner, "power_loss"),
            Self::PowerLossOuter => (outer, "power_loss"),
            Self::PowerLossFluid => (None, "power_loss_fluid"),
        }
    }

    /// Its row; a test holds every key against the table.
    fn row(self) -> Option<OfBall> {
        match self.key() {
            (Some(side), name) => OfBall::contact(side, name),
            (None, name) => OfBall::ball(name),
        }
    }

    /// The value where the ball has one: `None` for a contact without load, and for the motion and wear in the cage of
    /// a ball that the inner race does not drive.
    pub fn found(self, ball: &BallResult) -> Option<f64> {
        let side = self.key().0.unwrap_or(Side::Inner);
        let load = ball.contacts[side].load_n;
        // A load that is no number is not an absent one: it is refused with its place.
        (load.is_nan() || load > LEAST_LOAD_N).then(|| self.of(ball)).flatten()
    }

    /// True if the sign has a meaning.
    pub(crate) fn signed(self) -> bool {
        self.row().is_some_and(|row| row.facts().signed)
    }

    /// The value in the unit of results: SI, angles in degrees; absent where the model does not have it.
    pub fn of(self, ball: &BallResult) -> Option<f64> {
        let row = self.row()?;
        row.get(ball).map(|value| value * row.facts().unit.per_si)
    }

    /// Label, unit on the axis, and that unit's count in the unit of results.
    pub(crate) fn axis(self) -> (&'static str, &'static str, f64) {
        let (unit, count) = match self {
            Self::ContactAngleInner | Self::ContactAngleOuter => ("°", 1.0),
            Self::LoadInner | Self::LoadOuter => ("kN", 1e-3),
            Self::ApproachInner | Self::ApproachOuter => ("µm", 1e6),
            Self::PeakPressureInner | Self::PeakPressureOuter => ("GPa", 1e-9),
            Self::SlideToRollInner | Self::SlideToRollOuter => ("", 1.0),
            Self::WearRateInner | Self::WearRateOuter | Self::WearRateCage => ("m³/s", 1.0),
            Self::OrbitalSpeed => ("r/min", RPM_PER_RAD_S),
            Self::TractionInner | Self::TractionOuter | Self::CageForce => ("N", 1.0),
            Self::PowerLossInner | Self::PowerLossOuter | Self::PowerLossFluid => ("W", 1.0),
        };
        (self.row().map_or("", |row| row.facts().label), unit, count)
    }

    /// True if the quantity comes from the traction integrals or from the slip they fix, which Jones–Harris does not
    /// solve.
    pub(crate) fn needs_traction(self) -> bool {
        let in_cage = matches!(self, Self::CageForce | Self::WearRateCage);
        in_cage || self.row().is_some_and(|row| row.facts().scope != Scope::All)
    }
}

#[cfg(test)]
mod tests {
    use crate::solution::drawn;

    #[test]
    fn identity_all_that_is_drawn_is_in_the_table() {
        assert_eq!(drawn().count(), 20);
        for quantity in drawn() {
            assert!(quantity.row().is_some(), "{quantity:?}");
        }
    }
}
