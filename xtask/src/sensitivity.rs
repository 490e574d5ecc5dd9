//! scan (draft)
use crate::error::Failure;
use crate::transient::{Plan, Transient, run_all};

fn line(t: &Transient) -> String {
    let w = t.settled();
    let [low, high] = w.orbit_limits();
    let (first, n) = w.first_impact();
    let imp: Vec<f64> = { let mut v: Vec<f64> = w.impacts().map(|i| i.azimuth_deg).collect(); v.sort_by(f64::total_cmp); v };
    let q = |p: f64| imp.get((p * imp.len() as f64) as usize).copied().unwrap_or(f64::NAN);
    format!(
        "{:<10} start {:.1} cage {:.2} orb {:.1}..{:.1} accx pk {:.2} rms {:.2} | in x {:.2} y {:.2} z {:.2} | pocket pk {:.0} hard {:.0} first {:.0} ({}) share {:.2} n {} q {:.0} {:.0} {:.0} {:.0} {:.0} lost {} imb {:.1e} xi {:.2e}/{:.2e}",
        t.id, t.start_rpm, w.cage_rpm(), low, high, w.peak(|s| s.outer_acceleration[0]), w.rms(|s| s.outer_acceleration[0]),
        w.rms(|s| s.inner_acceleration[0]), w.rms(|s| s.inner_acceleration[1]), w.rms(|s| s.inner_acceleration[2]),
        w.pocket_peak(), w.hardest_pocket(), first, n, w.impact_share([245.0, 330.0]), imp.len(), q(0.0), q(0.25), q(0.5), q(0.75), q(0.999), t.trace.contacts_lost, t.trace.imbalance,
        w.ball_mean(|b| b.inner.slide_to_roll[0].abs()), w.ball_mean(|b| b.outer.slide_to_roll[0].abs()))
}

pub fn scan(sets: &[String]) -> Result<(), Failure> {
    let plans: Vec<Plan> = [Plan::ag(), Plan::ptfe(), Plan::axial(25), Plan::axial(50), Plan::axial(75)].into_iter().map(|p| {
        let mut p = p.with("transient.scheme", "Fast(step: us(20))").with("transient.duration", "s(0.12)");
        for s in sets { if let Some((a, b)) = s.split_once('=') { p = p.with(a, b); } }
        p
    }).collect();
    println!("{sets:?}");
    for t in run_all(&plans, None)? { println!("  {}", line(&t)); }
    Ok(())
}
