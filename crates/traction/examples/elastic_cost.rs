//! Time and error of the elastic patch beside the rigid one, each against its own converged result.
//!
//!     cargo run --release -p tribodyn-traction --example elastic_cost
//!
//! The contacts are those of `tests/patch_rules/contacts.csv`, the error is that of force over load or of moment over
//! load times ball radius, the largest of the six contacts of a slip scale; the time is the least of several passes.

use std::{hint::black_box, time::Instant};
use tribodyn_traction::{
    ElasticProbe, FastPatch, Fastsim, FastsimRule, PatchRule, TangentialElasticity, TractionError, TractionLaw,
    fast_elastic_patch_traction, fast_patch_traction, fastsim_rule_error, rule_error,
};

#[path = "../tests/patch_rules/contacts.rs"]
#[allow(dead_code, reason = "shared with the tests, which use more of it")]
mod contacts;

const RIGID: [(usize, usize); 7] = [(4, 2), (5, 3), (7, 3), (8, 4), (10, 6), (12, 8), (16, 12)];
const ELASTIC: [(usize, usize); 9] = [(4, 4), (4, 5), (6, 5), (8, 6), (8, 8), (8, 12), (8, 16), (16, 16), (16, 32)];

/// Least time of a call over several passes, ns.
fn least(contacts: &[contacts::Contact], mut one: impl FnMut(&contacts::Contact) -> f64) -> f64 {
    const REPEATS: usize = 200;
    (0..15).fold(f64::INFINITY, |least, _| {
        let start = Instant::now();
        for _ in 0..REPEATS {
            black_box(black_box(contacts).iter().map(&mut one).sum::<f64>());
        }
        least.min(start.elapsed().as_secs_f64() * 1e9 / (REPEATS * contacts.len()) as f64)
    })
}

fn main() -> Result<(), TractionError> {
    let (law, steel) = (contacts::silver(), TangentialElasticity::new(80e9, 0.3)?);
    println!("scale,patch,across,along,error,ns,ns_with_derivatives");
    for scale in contacts::SCALES {
        let contacts = contacts::contacts(scale);
        let probes: Vec<_> = contacts.iter().map(|contact| contact.probe(&law)).collect();
        let slope = law.kragelskii_slope(2e9);
        for (across, along) in RIGID {
            let rule = PatchRule::SplitStrip { across, along };
            let (fast, error) = (FastPatch::new(rule)?, rule_error(rule, &probes)?);
            let time = least(&contacts, |c| {
                fast_patch_traction(&fast, &c.patch, &c.motion, c.rolling_speed, &c.law(&law)).force_rolling
            });
            let with = least(&contacts, |c| {
                let curves = law.kragelskii(c.patch.peak_pressure).zip(slope);
                curves.map_or(f64::NAN, |(curve, slope)| {
                    let unit = c.law(&law).slip_unit;
                    fast.derivative(&c.patch, &c.motion, c.rolling_speed, (&curve, &slope), unit).by_motion[0][0]
                })
            });
            println!("{scale},rigid,{across},{along},{error:.1e},{time:.0},{with:.0}");
        }
        let probes: Vec<_> = probes.into_iter().map(|contact| ElasticProbe { contact, elasticity: &steel }).collect();
        for (across, cells) in ELASTIC {
            let rule = FastsimRule { across, cells };
            let (grid, error) = (Fastsim::new(rule)?, fastsim_rule_error(rule, &probes)?);
            let time = least(&contacts, |c| {
                fast_elastic_patch_traction(&grid, &c.patch, &c.motion, c.rolling_speed, &c.law(&law), &steel)
                    .force_rolling
            });
            let with = least(&contacts, |c| {
                let curves = law.kragelskii(c.patch.peak_pressure).zip(slope);
                curves.map_or(f64::NAN, |(curve, slope)| {
                    let unit = c.law(&law).slip_unit;
                    grid.derivative(&c.patch, &c.motion, c.rolling_speed, (&curve, &slope, unit), &steel).by_motion[0]
                        [0]
                })
            });
            println!("{scale},elastic,{across},{cells},{error:.1e},{time:.0},{with:.0}");
        }
    }
    Ok(())
}
