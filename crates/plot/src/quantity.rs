//! Numbers of a ball that are drawn, with their units.

use tribodyn_quasistatic::BallSolution;

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

/// Revolutions per minute in one rad/s.
const RPM: f64 = 30.0 / std::f64::consts::PI;

/// Load up to which a contact counts as open, N: what the balance leaves at the outer race of a ball that nothing
/// drives.
const LEAST_LOAD_N: f64 = 1e-3;

impl Quantity {
    /// The value where the ball has one: `None` for a contact without load, and for the motion and wear in the cage of
    /// a ball that the inner race does not drive.
    pub fn found(self, ball: &BallSolution) -> Option<f64> {
        let load = match self {
            Self::ContactAngleOuter
            | Self::LoadOuter
            | Self::ApproachOuter
            | Self::PeakPressureOuter
            | Self::TractionOuter
            | Self::SlideToRollOuter
            | Self::WearRateOuter
            | Self::PowerLossOuter => ball.load_outer_n,
            _ => ball.load_inner_n,
        };
        // A load that is no number is not an absent one: it is refused with its place.
        (load.is_nan() || load > LEAST_LOAD_N).then(|| self.of(ball))
    }

    /// True if the sign has a meaning.
    pub(crate) fn signed(self) -> bool {
        matches!(
            self,
            Self::TractionInner
                | Self::TractionOuter
                | Self::SlideToRollInner
                | Self::SlideToRollOuter
                | Self::CageForce
        )
    }

    /// The value in the unit of [`BallSolution`]: SI, angles in degrees.
    pub fn of(self, ball: &BallSolution) -> f64 {
        match self {
            Self::ContactAngleInner => ball.contact_angle_inner_deg,
            Self::ContactAngleOuter => ball.contact_angle_outer_deg,
            Self::LoadInner => ball.load_inner_n,
            Self::LoadOuter => ball.load_outer_n,
            Self::ApproachInner => ball.approach_inner_m,
            Self::ApproachOuter => ball.approach_outer_m,
            Self::PeakPressureInner => ball.peak_pressure_inner_pa,
            Self::PeakPressureOuter => ball.peak_pressure_outer_pa,
            Self::TractionInner => ball.traction_inner_n,
            Self::TractionOuter => ball.traction_outer_n,
            Self::SlideToRollInner => ball.slide_to_roll_inner,
            Self::SlideToRollOuter => ball.slide_to_roll_outer,
            Self::WearRateInner => ball.wear_rate_inner_m3_s,
            Self::WearRateOuter => ball.wear_rate_outer_m3_s,
            Self::WearRateCage => ball.wear_rate_cage_m3_s,
            Self::OrbitalSpeed => ball.orbital_speed_rad_s,
            Self::CageForce => ball.cage_force_n,
            Self::PowerLossInner => ball.power_loss_inner_w,
            Self::PowerLossOuter => ball.power_loss_outer_w,
            Self::PowerLossFluid => ball.power_loss_fluid_w,
        }
    }

    /// Label, unit on the axis, and that unit's count in the unit of [`BallSolution`].
    pub(crate) fn axis(self) -> (&'static str, &'static str, f64) {
        match self {
            Self::ContactAngleInner | Self::ContactAngleOuter => ("Contact angle", "°", 1.0),
            Self::LoadInner | Self::LoadOuter => ("Contact load", "kN", 1e-3),
            Self::ApproachInner | Self::ApproachOuter => ("Elastic approach", "µm", 1e6),
            Self::PeakPressureInner | Self::PeakPressureOuter => ("Peak pressure", "GPa", 1e-9),
            Self::TractionInner | Self::TractionOuter => ("Longitudinal traction on the ball", "N", 1.0),
            Self::SlideToRollInner | Self::SlideToRollOuter => ("Slide-to-roll ratio", "", 1.0),
            Self::WearRateInner | Self::WearRateOuter | Self::WearRateCage => ("Wear rate", "m³/s", 1.0),
            Self::OrbitalSpeed => ("Orbital speed", "r/min", RPM),
            Self::CageForce => ("Pocket force on the ball", "N", 1.0),
            Self::PowerLossInner | Self::PowerLossOuter | Self::PowerLossFluid => ("Power loss", "W", 1.0),
        }
    }

    /// True if the quantity comes from the traction integrals or from the slip they fix, which Jones–Harris does not
    /// solve.
    pub(crate) fn needs_traction(self) -> bool {
        !matches!(
            self,
            Self::ContactAngleInner
                | Self::ContactAngleOuter
                | Self::LoadInner
                | Self::LoadOuter
                | Self::ApproachInner
                | Self::ApproachOuter
                | Self::PeakPressureInner
                | Self::PeakPressureOuter
                | Self::OrbitalSpeed
        )
    }
}
