//! Searches beside the one that was asked for, which end soon.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tribodyn_bearing::{OperatingPoint, SearchObserver, SearchStage, SearchWatch};

/// Ends a search after some looks, or with that of the asker.
struct Limited {
    looks: AtomicUsize,
    most: usize,
    asker: SearchWatch,
}

impl SearchObserver for Limited {
    fn stage(&self, _: SearchStage) {}

    fn stops(&self) -> bool {
        self.looks.fetch_add(1, Ordering::Relaxed) >= self.most || self.asker.stops()
    }
}

/// The same point for a search that ends after so many looks: what is counted by looks is the same on every machine.
pub(super) fn limited(point: &OperatingPoint, most: usize) -> OperatingPoint {
    let limited = Limited { looks: AtomicUsize::new(0), most, asker: point.watch.clone() };
    OperatingPoint { watch: SearchWatch::new(Arc::new(limited)), ..point.clone() }
}
