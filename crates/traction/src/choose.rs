//! Patch rule from a target error, and the error estimate of a rule.

use crate::{FastPatch, Patch, PatchLaw, PatchRule, PatchTraction, RelativeMotion, SlipField, TractionError};
use crate::{TractionLaw, fast_patch_traction};
use std::sync::OnceLock;

/// One contact at which a rule is judged.
#[derive(Debug, Clone, Copy)]
pub struct Probe<'a, L> {
    /// Its ellipse.
    pub patch: Patch,
    /// Its relative motion.
    pub motion: RelativeMotion,
    /// Its rolling speed, m/s.
    pub rolling_speed: f64,
    /// Its law.
    pub law: PatchLaw<'a, L>,
}

impl<L: TractionLaw> Probe<'_, L> {
    fn traction(&self, rule: &FastPatch) -> PatchTraction {
        fast_patch_traction(rule, &self.patch, &self.motion, self.rolling_speed, &self.law)
    }

    /// Error of the force over the load and of the moment over load times ball radius, the larger; zero without load.
    pub(crate) fn relative_error(&self, ours: &PatchTraction, exact: &PatchTraction) -> f64 {
        let force = (ours.force_rolling - exact.force_rolling).hypot(ours.force_lateral - exact.force_lateral);
        let moment = (ours.moment_lateral - exact.moment_lateral)
            .hypot(ours.moment_normal - exact.moment_normal)
            .hypot(ours.moment_rolling - exact.moment_rolling);
        let load = self.load();
        if load > 0.0 { (force / load).max(moment / (load * self.patch.ball_radius)) } else { 0.0 }
    }

    /// The load under the ellipse, N.
    fn load(&self) -> f64 {
        2.0 * std::f64::consts::PI / 3.0 * self.patch.peak_pressure * self.patch.semi_lateral * self.patch.semi_rolling
    }
}

/// Candidates of [`choose_rule`], by points: polar rules where the integrand is smooth, strips where it is nearly
/// Coulomb's. Of the combinations measured at slip scales from 1 to 100 per m/s (docs/patch-rules.md) these lie at the
/// edge of error against points; more nodes along a strip than two thirds of those across bring nothing.
const CANDIDATES: [PatchRule; 20] = [
    PatchRule::GaussJacobi { radial: 2, angles: 8 },
    PatchRule::GaussJacobi { radial: 3, angles: 8 },
    PatchRule::GaussJacobi { radial: 4, angles: 8 },
    PatchRule::SplitStrip { across: 5, along: 3 },
    PatchRule::SplitStrip { across: 7, along: 3 },
    PatchRule::GaussJacobi { radial: 5, angles: 12 },
    PatchRule::SplitStrip { across: 8, along: 4 },
    PatchRule::SplitStrip { across: 8, along: 5 },
    PatchRule::SplitStrip { across: 10, along: 5 },
    PatchRule::SplitStrip { across: 10, along: 6 },
    PatchRule::SplitStrip { across: 12, along: 6 },
    PatchRule::SplitStrip { across: 12, along: 8 },
    PatchRule::SplitStrip { across: 14, along: 8 },
    PatchRule::SplitStrip { across: 16, along: 8 },
    PatchRule::SplitStrip { across: 16, along: 12 },
    PatchRule::SplitStrip { across: 20, along: 14 },
    PatchRule::SplitStrip { across: 24, along: 18 },
    PatchRule::SplitStrip { across: 7, along: 8 },
    PatchRule::SplitStrip { across: 8, along: 10 },
    PatchRule::SplitStrip { across: 10, along: 14 },
];
/// So many of them are for solvers.
const FOR_SOLVERS: usize = 17;

/// Who is to work with a rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RuleUse {
    /// Newton's method.
    Solver,
    /// Integration in time, which has more rules to choose from. In oil the stress changes along rolling from one limit
    /// to the other, and strips with more nodes than there are strips err as little with half the points. Their error
    /// ripples as a contact moves: Newton's method lost the orbit of a 6206 over it.
    Run,
}

/// The rule that estimates are made against: its own error is about 1e-8 at a slip scale of 22 per m/s and 2e-7 at 100.
pub const REFERENCE_RULE: PatchRule = PatchRule::SplitStrip { across: 32, along: 28 };

/// The reference and the candidates laid out, each when it is first asked for: that takes longer than a contact.
static LAID_OUT: [OnceLock<FastPatch>; CANDIDATES.len() + 1] = [const { OnceLock::new() }; CANDIDATES.len() + 1];

fn laid_out(index: usize) -> Result<&'static FastPatch, TractionError> {
    let place = &LAID_OUT[index];
    if let Some(fast) = place.get() {
        return Ok(fast);
    }
    let fast = FastPatch::new(CANDIDATES.get(index).copied().unwrap_or(REFERENCE_RULE))?;
    Ok(place.get_or_init(|| fast))
}

/// Reference for the error of a rule: strips twice as fine across and three times along the groove, by which the
/// estimate is a tenth off at most; for other rules, and where these would be finer still, [`REFERENCE_RULE`].
fn reference(rule: PatchRule) -> Result<FastPatch, TractionError> {
    match (rule, REFERENCE_RULE) {
        (PatchRule::SplitStrip { across, along }, PatchRule::SplitStrip { across: most_across, along: most_along })
            if 2 * across <= most_across && 3 * along <= most_along =>
        {
            FastPatch::new(PatchRule::SplitStrip { across: 2 * across, along: 3 * along })
        }
        _ => laid_out(CANDIDATES.len()).cloned(),
    }
}

/// Largest error of a rule over the probes: of the force over the load and of the moment over load times ball radius.
///
/// # Errors
/// Those of [`FastPatch::new`].
pub fn rule_error<L: TractionLaw>(rule: PatchRule, probes: &[Probe<'_, L>]) -> Result<f64, TractionError> {
    let reference = reference(rule)?;
    let exact: Vec<_> = probes.iter().map(|p| p.traction(&reference)).collect();
    Ok(largest_error(&FastPatch::new(rule)?, probes, &exact))
}

fn largest_error<L: TractionLaw>(rule: &FastPatch, probes: &[Probe<'_, L>], exact: &[PatchTraction]) -> f64 {
    probes
        .iter()
        .zip(exact)
        .fold(0.0, |worst, (probe, exact)| worst.max(probe.relative_error(&probe.traction(rule), exact)))
}

/// The candidate for a use with the fewest points whose error over the probes is at most `relative`, and that error.
///
/// # Errors
/// [`TractionError::TargetNotReached`] where the finest candidate misses the target.
pub fn choose_rule<L: TractionLaw>(
    relative: f64,
    probes: &[Probe<'_, L>],
    by: RuleUse,
) -> Result<(PatchRule, f64), TractionError> {
    let count = if by == RuleUse::Run { CANDIDATES.len() } else { FOR_SOLVERS };
    let reference = laid_out(CANDIDATES.len())?;
    let exact: Vec<_> = probes.iter().map(|p| p.traction(reference)).collect();
    let mut best: Option<(PatchRule, f64, usize)> = None;
    let mut finest = f64::INFINITY;
    for (index, rule) in CANDIDATES.into_iter().enumerate().take(count) {
        let fast = laid_out(index)?;
        let points =
            probes.iter().map(|p| fast.quadrature().point_count(&SlipField::new(&p.patch, &p.motion))).sum::<usize>();
        if best.is_some_and(|(_, _, fewest)| fewest <= points) {
            continue;
        }
        let error = largest_error(fast, probes, &exact);
        finest = finest.min(error);
        if error <= relative {
            best = Some((rule, error, points));
        }
    }
    best.map(|(rule, error, _)| (rule, error))
        .ok_or(TractionError::TargetNotReached { target: relative, reached: finest })
}
