//! Processor time: what others do on the machine counts little.

use cpu_time::ThreadTime;

/// Processor time of one call, s, and what it gave.
pub fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = ThreadTime::now();
    let result = work();
    (start.elapsed().as_secs_f64(), result)
}

/// Least processor time of a call, s, over some batches that last `batch` seconds or more each.
pub fn least_per_call<T>(batches: usize, batch: f64, mut work: impl FnMut() -> T) -> f64 {
    let mut calls = 1u32;
    let mut lasting = |calls: u32| timed(|| (0..calls).for_each(|_| drop(std::hint::black_box(work())))).0;
    while lasting(calls) < batch && calls < 1 << 24 {
        calls *= 2;
    }
    (0..batches.max(1)).map(|_| lasting(calls) / f64::from(calls)).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_twice_the_work_takes_longer() {
        let sum = |n: u64| move || (0..n).map(|i| std::hint::black_box(i) as f64).sum::<f64>();
        let (one, four) = (least_per_call(3, 2e-3, sum(20_000)), least_per_call(3, 2e-3, sum(80_000)));
        assert!(one > 0.0 && four > 2.0 * one, "{one:e} {four:e}");
    }
}
