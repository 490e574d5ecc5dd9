//! How a long search tells what it is at, and how its caller ends it.

use std::fmt;
use std::sync::Arc;

/// Where a search stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchStage {
    /// The attempt, in a few words.
    pub name: &'static str,
    /// Cage speed that was reached, rad/s; none before there is one.
    pub cage_speed: Option<f64>,
}

/// A caller that follows a search. Both functions are called on the thread that searches, some times a millisecond at
/// most, so that they should be quick.
pub trait SearchObserver: Send + Sync {
    /// Told when something else is tried, or when a better state was reached.
    fn stage(&self, stage: SearchStage);
    /// True if the search is to end. Once true it stays true.
    fn stops(&self) -> bool;
}

/// The link of a search to its caller; a search without one goes on to its own end and tells nothing.
///
/// It is part of an operating point, as every solver takes one, but of no problem: all links are equal.
#[derive(Clone, Default)]
pub struct SearchWatch(Option<Arc<dyn SearchObserver>>);

impl SearchWatch {
    /// With an observer.
    pub fn new(observer: Arc<dyn SearchObserver>) -> Self {
        Self(Some(observer))
    }

    /// Tells what is tried from here on.
    pub fn stage(&self, name: &'static str, cage_speed: Option<f64>) {
        if let Some(observer) = &self.0 {
            observer.stage(SearchStage { name, cage_speed });
        }
    }

    /// True if the search is to end.
    pub fn stops(&self) -> bool {
        self.0.as_ref().is_some_and(|observer| observer.stops())
    }
}

impl fmt::Debug for SearchWatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "SearchWatch(observed)" } else { "SearchWatch" })
    }
}

impl PartialEq for SearchWatch {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
