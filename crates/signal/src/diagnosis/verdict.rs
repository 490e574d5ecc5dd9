//! Verdict on a bearing from the evidence.

use super::Kinematics;
use super::evidence::{Evidence, Fault, SURE};
use super::shaft::ShaftSpeed;
use serde::Serialize;

/// The verdict on a bearing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Verdict {
    /// The part that is damaged; none where no line of the bearing stands out.
    pub fault: Option<Fault>,
    /// Reasons, a sentence each.
    pub reasons: Vec<String>,
}

/// Speed of the cage by a line of the bearing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CageSpeed {
    /// Speed, r/min, with its sign.
    pub speed_rpm: f64,
    /// One standard deviation of it, r/min.
    pub deviation_rpm: f64,
    /// Name of the line.
    pub from: String,
}

/// Decadic logarithm of the chance in noise of a line from which only a speed is read.
const READ: f64 = -6.0;
/// Mean height of the first two harmonics over the floor from which a family is one of damage, dB.
const HIGH_DB: f64 = 9.0;
/// Modulation of the squared envelope from which a family is one of damage: balls pass a sound race at the same
/// frequency.
const DEEP: f64 = 0.1;
/// Decadic logarithm of the chance of lines of a ball and their sidebands where the cage shows too: a damaged ball
/// turns out of its track and strikes now and then only.
const SURE_WITH_CAGE: f64 = -6.0;

/// Height by which a line has to stand above FTF and above those one turn of the cage beside it, not to be one of many
/// multiples, dB: at other faults too impacts vary with the cage, but a line that is modulated wholly has sidebands
/// 6 dB below it.
const CAGE_DB: f64 = 5.0;

/// Decadic logarithm of the chance of lines that others beside them may make sure.
const READ_WITH_SIDES: f64 = -5.0;
/// Farthest sideband: a load zone of a third of a turn has that many.
const FARTHEST: u32 = 3;

/// Distance over its frequency within which a line is one of another family.
const SAME: f64 = 0.01;
/// Multiples of the fundamental of a family that are looked at as lines of others.
const MULTIPLES: u32 = 20;

/// Farthest from a multiple of the cage at which a line is one, over the speed of the cage.
const WITHIN: f64 = 0.25;

/// Height below that line to which the fifth multiple of the cage may have fallen, dB.
const ALL_DB: f64 = 10.0;

impl Evidence {
    /// Mean height of the first two harmonics, dB: those of a coincidence are not both high.
    pub fn height_db(&self) -> f64 {
        let first: Vec<f64> = self.harmonics.iter().filter(|h| h.order <= 2).map(|h| h.over_floor_db).collect();
        if first.is_empty() { 0.0 } else { first.iter().sum::<f64>() / first.len() as f64 }
    }

    /// By which two families are compared: the mean height of the first two harmonics, the second one counted up to the
    /// first. A train of impacts has its highest line at the fundamental; a second harmonic above it may be a line of
    /// another family, as three times BPFO is nearly twice BPFI in many bearings.
    fn rank(&self) -> f64 {
        let of = |order: usize| self.harmonics.iter().find(|h| h.order == order).map(|h| h.over_floor_db);
        let first = of(1).unwrap_or(0.0);
        0.5 * (first + of(2).unwrap_or(0.0).min(first))
    }

    /// True if the fundamental may be a sideband of another family: the first one, or a farther one if this family has
    /// no sidebands of its own and the other one has. BPFO is near BPFI less two turns of the shaft in many bearings,
    /// and BPFI near 2 BSF and two turns of the cage.
    fn beside(&self, other: &Self) -> bool {
        let reach = SAME * self.frequency_hz;
        let distance = (self.frequency_hz - other.frequency_hz).abs();
        let farthest = if other.is_modulated() && !self.is_modulated() { FARTHEST } else { 1 };
        let is = |by: f64| (1..=farthest).any(|k| (distance - f64::from(k) * by).abs() < reach);
        other.modulating_hz.is_some_and(is)
    }

    /// True if the speed that varies the load of the damage shows beside the lines.
    fn is_modulated(&self) -> bool {
        self.sidebands_log_chance.is_some_and(|chance| chance < READ)
    }

    /// True if the fundamental is one of many multiples of that of the cage and not much higher than the others: what
    /// strikes once in a turn of the cage has all multiples, BPFO among them.
    fn of_cage(&self, cage: &Self) -> bool {
        let multiple = (self.frequency_hz / cage.frequency_hz).round();
        let uncertain = 3.0 * self.deviation_hz.hypot(multiple * cage.deviation_hz) + 0.002 * self.frequency_hz;
        // In a short signal any line would be a multiple: lines of a ball lie between those of the cage.
        let reach = uncertain.min(WITHIN * cage.frequency_hz);
        // What a ball strikes in the load zone has a few multiples of the cage, what strikes once in a turn has all.
        let last = cage.harmonics.last().map_or(0.0, |h| h.over_floor_db);
        let own = |e: &Self| e.harmonics.first().map_or(0.0, |h| h.over_floor_db);
        let first = own(self);
        let near = self.beside_db.min(own(cage));
        let all = last > self.rank() - ALL_DB && near > first - CAGE_DB;
        all && (self.frequency_hz - multiple * cage.frequency_hz).abs() < reach
    }

    /// True for a frequency, Hz, of a multiple of the fundamental or of a sideband of one.
    fn has(&self, hz: f64) -> bool {
        let by = self.modulating_hz.unwrap_or(0.0);
        let is = |multiple: f64, side: i32| (hz - multiple - f64::from(side) * by).abs() < SAME * hz;
        let sides = -(FARTHEST as i32)..=FARTHEST as i32;
        (0..=MULTIPLES).any(|k| sides.clone().any(|side| is(f64::from(k) * self.frequency_hz, side)))
    }

    /// True if the family stands out by its own lines, without those that are multiples of the fundamental of the
    /// family found or sidebands of them: 3/2 of BPFO is near BPFI and 4/3 of it near 2 BSF in many bearings.
    fn stands_out_beside(&self, found: &Self) -> bool {
        let harmonics: Vec<_> = self.harmonics.iter().filter(|h| !found.has(h.frequency_hz)).copied().collect();
        let modulation = harmonics.iter().map(|h| h.modulation.powi(2)).sum::<f64>().sqrt();
        let has_fundamental = harmonics.first().is_some_and(|h| h.order == 1);
        has_fundamental && Self { harmonics, modulation, ..self.clone() }.stands_out()
    }

    /// True if the family stands out as that of damage does.
    pub fn stands_out(&self) -> bool {
        self.is_high() && self.strikes()
    }

    fn is_high(&self) -> bool {
        // A ball that is struck has lines of the cage beside its own: they are as much a part of it.
        let of_sides = if self.fault == Fault::Ball { self.sidebands_log_chance.unwrap_or(0.0) } else { 0.0 };
        let sure = self.log_chance < READ_WITH_SIDES && self.log_chance + of_sides < SURE;
        sure && self.height_db() > HIGH_DB && self.modulation > DEEP
    }

    /// True if the band has the kurtosis of blows: tones that beat have less.
    fn strikes(&self) -> bool {
        self.kurtosis >= self.kurtosis_of_blows
    }

    /// Sentence on a family that is high as that of damage, and none.
    fn beating(&self) -> Option<String> {
        (self.is_high() && !self.strikes()).then(|| {
            format!(
                "{} has the lines of tones that beat, as waves of races and unequal balls make them, or of blows deep \
                 in noise: spectral kurtosis {:.2}, of blows alone at least {:.2}",
                self.fault.line(),
                self.kurtosis,
                self.kurtosis_of_blows
            )
        })
    }

    /// Sentence on a family whose blows are too low for damage.
    fn quiet(&self, quiet: f64) -> Option<String> {
        (self.stands_out() && self.height <= quiet).then(|| {
            format!(
                "{} has blows of {:.2} in the unit of the signal: up to {quiet:.1} balls that enter the load zone of a \
                 sound bearing make them",
                self.fault.line(),
                self.height
            )
        })
    }

    fn said(&self) -> String {
        let high: Vec<String> =
            self.harmonics.iter().map(|h| format!("{} by {:.0} dB", h.order, h.over_floor_db)).collect();
        let mut text = format!(
            "{} at {:.3} Hz, {:+.2} % from pure rolling: harmonics over the noise floor {}; modulation of the squared envelope {:.3}; chance in noise 1e{:.0}",
            self.fault.line(),
            self.frequency_hz,
            100.0 * (self.frequency_hz / self.expected_hz - 1.0),
            high.join(", "),
            self.modulation,
            self.log_chance
        );
        if let Some(chance) = self.sidebands_log_chance {
            let sides: Vec<String> = self.sidebands.iter().map(|s| format!("{:.0} dB", s.over_floor_db)).collect();
            let by = if self.fault == Fault::Ball { "the cage" } else { "the shaft" };
            text += &format!("; sidebands at the speed of {by} {}, chance 1e{chance:.0}", sides.join(", "));
        }
        text
    }
}

/// The verdict, blows up to the height `quiet` counted as those of a sound bearing.
pub(super) fn of(evidence: &[Evidence], quiet: f64) -> Verdict {
    let by = |fault: Fault| evidence.iter().find(|e| e.fault == fault && e.height > quiet);
    let passing = || [Fault::Outer, Fault::Inner, Fault::Ball].into_iter().filter_map(by).filter(|e| e.stands_out());
    // What is a sideband of a family that stands out itself says nothing of its own.
    let cage = by(Fault::Cage).filter(|e| e.stands_out());
    let own = |e: &&Evidence| {
        !passing().any(|other| other.fault != e.fault && e.beside(other)) && !cage.is_some_and(|cage| e.of_cage(cage))
    };
    let highest =
        |among: &dyn Fn(&Evidence) -> bool| passing().filter(|e| among(e)).max_by(|a, b| a.rank().total_cmp(&b.rank()));
    // What would be left to a lower family that has a line of it among its first two is one of its own: 3/2 of BPFO,
    // with the cage, is BPFI in many bearings.
    let hides = |e: &Evidence, left: &Evidence| {
        let of_cage = cage.is_some_and(|cage| e.of_cage(cage));
        let shares = left.harmonics.iter().any(|h| h.order <= 2 && e.has(h.frequency_hz));
        e.fault != left.fault && of_cage && e.rank() > left.rank() && shares
    };
    let highest = highest(&|e| own(&e)).map(|left| highest(&|e| hides(e, left)).unwrap_or(left));
    let found = highest.or_else(|| {
        let sure = |e: &&Evidence| e.log_chance + e.sidebands_log_chance.unwrap_or(0.0) < SURE_WITH_CAGE;
        let ball = by(Fault::Ball).filter(sure).filter(own);
        cage.and(ball).or(cage)
    });
    let mut beats: Vec<String> = evidence.iter().filter_map(Evidence::beating).collect();
    beats.extend(evidence.iter().filter_map(|e| e.quiet(quiet)));
    let mut reasons = Vec::new();
    match found {
        None if beats.is_empty() => reasons.push(format!(
            "no line of the bearing stands {HIGH_DB} dB over the noise with a chance below 1e{SURE:.0} and a modulation above {DEEP}"
        )),
        None => {}
        Some(e) => {
            reasons.push(e.said());
            if e.fault == Fault::Cage {
                reasons.push("one ball unlike the others, a damaged one too, shows at the same frequency".to_owned());
            }
            if e.fault == Fault::Inner && e.sidebands_log_chance.is_some_and(|chance| chance > READ) {
                reasons.push("no sidebands at the speed of the shaft: the load is axial, or the line is another's".to_owned());
            }
        }
    }
    reasons.extend(beats);
    if let Some(found) = found {
        let another = |e: &&Evidence| {
            let high = e.fault != found.fault && e.height > quiet && e.stands_out_beside(found);
            high && own(e) && !e.beside(found)
        };
        reasons.extend(evidence.iter().filter(another).map(|e| format!("also {}", e.said())));
    }
    Verdict { fault: found.map(|e| e.fault), reasons }
}

/// The speed of the cage by the line of the verdict, or by the highest one that gives it.
pub(super) fn cage(
    evidence: &[Evidence],
    verdict: &Verdict,
    bearing: &Kinematics,
    shaft: &ShaftSpeed,
) -> Option<CageSpeed> {
    let balls = bearing.ball_count as f64;
    let [inner, outer, cage] = [bearing.inner_turns, bearing.outer_turns, bearing.cage_turns()];
    let of = |e: &Evidence| match e.fault {
        Fault::Outer => {
            let hz = outer * shaft.frequency_hz + (cage - outer).signum() * e.frequency_hz / balls;
            Some((hz, (e.deviation_hz / balls).hypot(outer * shaft.deviation_hz)))
        }
        Fault::Inner => {
            let hz = inner * shaft.frequency_hz - (inner - cage).signum() * e.frequency_hz / balls;
            Some((hz, (e.deviation_hz / balls).hypot(inner * shaft.deviation_hz)))
        }
        Fault::Cage => Some((e.frequency_hz * cage.signum(), e.deviation_hz)),
        // Its turns about its own axis hardly depend on the speed of the cage.
        Fault::Ball => None,
    };
    let readable = |e: &&Evidence| e.log_chance < READ && e.fault != Fault::Ball;
    let by_verdict = evidence.iter().filter(readable).find(|e| Some(e.fault) == verdict.fault);
    let by = by_verdict
        .or_else(|| evidence.iter().filter(readable).max_by(|a, b| a.height_db().total_cmp(&b.height_db())))?;
    let (hz, deviation) = of(by)?;
    Some(CageSpeed { speed_rpm: 60.0 * hz, deviation_rpm: 60.0 * deviation, from: by.fault.line().to_owned() })
}

#[cfg(test)]
mod tests {
    use super::super::evidence::Harmonic;
    use super::*;

    /// A family with these heights of its harmonics, dB.
    fn family(fault: Fault, frequency_hz: f64, modulating_hz: Option<f64>, heights: &[f64]) -> Evidence {
        let harmonic = |(k, over_floor_db): (usize, &f64)| Harmonic {
            order: k + 1,
            frequency_hz: (k + 1) as f64 * frequency_hz,
            over_floor_db: *over_floor_db,
            modulation: 0.3,
        };
        Evidence {
            fault,
            expected_hz: frequency_hz,
            frequency_hz,
            deviation_hz: 0.03,
            log_chance: -42.0,
            modulation: 0.5,
            harmonics: heights.iter().enumerate().map(harmonic).collect(),
            sidebands: Vec::new(),
            modulating_hz,
            sidebands_log_chance: modulating_hz.map(|_| -45.0),
            band_hz: [1000.0, 2000.0],
            whitened: false,
            kurtosis: 4.0,
            height: 1.0,
            kurtosis_of_blows: 1.0,
            beside_db: 21.0,
            candidate: 0,
        }
    }

    /// The families of record 156 of the Case Western rig, an outer race that the cage modulates: BPFO is nine times
    /// FTF, and BPFI was told by a line at 3/2 of it.
    #[test]
    fn regress_an_outer_race_that_the_cage_modulates_is_not_the_inner_one() {
        let outer = family(Fault::Outer, 107.717, None, &[25.0, 24.0, 21.0, 22.0, 20.0]);
        let inner = |hz| family(Fault::Inner, hz, Some(29.971), &[11.0, 28.0, 14.0, 25.0, 7.0]);
        let cage = family(Fault::Cage, 11.962, None, &[22.0, 12.0, 18.0, 21.0]);
        let told = |hz: f64| of(&[outer.clone(), inner(hz), cage.clone()], 0.0).fault;
        assert_eq!(told(161.573), Some(Fault::Outer));
        // With lines of its own it is the inner race: all multiples of the cage are then of what strikes once a turn.
        assert_eq!(told(171.0), Some(Fault::Inner));
    }
}
