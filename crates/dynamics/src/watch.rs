//! The contacts of a ball after a step.

use tribodyn_bearing::Races;

/// State of a ball's contacts after a step, as wear and events need it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Watch {
    /// Wear rates of the races, m³/s.
    pub wear: Races<f64>,
    /// Wear rate of the pocket, m³/s.
    pub pocket_wear: f64,
    /// Lateral semi-axes of the contacts, m.
    pub semi_lateral: Races<f64>,
    /// True where a contact carries load.
    pub loaded: Races<bool>,
}
