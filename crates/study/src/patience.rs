//! How long a search may go on, and what it last told.

use cpu_time::ThreadTime;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::Duration;
use tribodyn_bearing::{SearchObserver, SearchStage};

/// A limit on one search by the processor time of its thread, so that a busy machine ends none too early; it can be
/// called off at any time.
#[derive(Debug, Default)]
pub struct Patience {
    limit: Option<Duration>,
    began: OnceLock<Duration>,
    /// At the last look, µs.
    spent: AtomicU64,
    stopped: AtomicBool,
    /// Ends this search with others.
    with: Option<Arc<AtomicBool>>,
    stage: Mutex<Option<SearchStage>>,
}

impl Patience {
    /// With a limit in s of processor time; none where that is infinite.
    pub fn of_seconds(limit: f64) -> Self {
        Self { limit: Duration::try_from_secs_f64(limit).ok(), ..Self::default() }
    }

    /// Ended with others, too, once the flag that they share is set.
    #[must_use]
    pub fn ended_with(self, others: Arc<AtomicBool>) -> Self {
        Self { with: Some(others), ..self }
    }

    /// Ends the search.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    /// Processor time that the search had taken at its last look, s.
    pub fn spent_s(&self) -> f64 {
        1e-6 * self.spent.load(Ordering::Relaxed) as f64
    }

    /// Stage that the search reported last.
    pub fn reached(&self) -> Option<SearchStage> {
        *self.stage.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl SearchObserver for Patience {
    fn stage(&self, stage: SearchStage) {
        let mut told = self.stage.lock().unwrap_or_else(PoisonError::into_inner);
        // A speed that was reached stands until there is another.
        let cage_speed = stage.cage_speed.or(told.and_then(|before| before.cage_speed));
        *told = Some(SearchStage { cage_speed, ..stage });
    }

    fn stops(&self) -> bool {
        let with_others = self.with.as_ref().is_some_and(|others| others.load(Ordering::Relaxed));
        if with_others || self.stopped.load(Ordering::Relaxed) {
            return true;
        }
        let now = ThreadTime::now().as_duration();
        // A search is done by one thread: its first look is its beginning.
        let spent = now.saturating_sub(*self.began.get_or_init(|| now));
        self.spent.store(u64::try_from(spent.as_micros()).unwrap_or(u64::MAX), Ordering::Relaxed);
        let over = self.limit.is_some_and(|limit| spent > limit);
        if over {
            self.stop();
        }
        over
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_search_ends_after_its_processor_time_and_stays_ended() {
        let patience = Patience::of_seconds(0.02);
        let mut sum = 0u64;
        let mut looks = 0;
        while !patience.stops() {
            sum = (0..10_000).fold(sum, |sum, k| sum.wrapping_mul(31).wrapping_add(k));
            looks += 1;
            assert!(looks < 10_000_000, "{sum}");
        }
        assert!(looks > 1 && patience.stops() && patience.spent_s() >= 0.02);
        let endless = Patience::of_seconds(f64::INFINITY);
        assert!(!endless.stops());
        endless.stage(SearchStage { name: "first", cage_speed: Some(5.0) });
        endless.stage(SearchStage { name: "second", cage_speed: None });
        assert_eq!(endless.reached(), Some(SearchStage { name: "second", cage_speed: Some(5.0) }));
        endless.stop();
        assert!(endless.stops());
    }
}
