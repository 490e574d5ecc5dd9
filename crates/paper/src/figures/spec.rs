//! A figure: where it belongs, what it is drawn from, and how.

use super::runs::{Cases, Made};
use crate::error::PaperError;
use tribodyn_plot::Figure;

/// A figure of the page.
pub struct Spec {
    /// Name of its files.
    pub name: &'static str,
    /// Part of the page.
    pub section: &'static str,
    /// The paper's figure.
    pub of: &'static str,
    pub title: &'static str,
    pub cases: Cases,
    /// Words about the figure and about the paper's statements that have no place on the axes; may be empty.
    pub note: &'static str,
    pub draw: Draw,
}

/// Draws a figure from what was made for it.
pub type Draw = fn(&Spec, &Made) -> Result<Figure, PaperError>;

/// A figure without a note.
pub const fn spec(section: &'static str, cases: Cases, [name, of, title]: [&'static str; 3], draw: Draw) -> Spec {
    Spec { name, section, of, title, cases, note: "", draw }
}

impl Spec {
    pub const fn noted(mut self, note: &'static str) -> Self {
        self.note = note;
        self
    }
}
