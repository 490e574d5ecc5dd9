//! Tasks after a step: samples, events, wear, and a check that all is well.

use super::filter::Between;
use super::{ACCELERATION_ERROR, CHECK_EVERY, FAST_CHECK_EVERY, Run, RunError, Scheme, WEAR_CHECK_EVERY};
use crate::error::DynamicsError;
use crate::layout::AZIMUTH;
use crate::observer::{BallDetail, Event, EventKind, Observer};
use crate::sample::Sample;
use crate::stiffness::{EULER_LIMIT, Stiffness};
use std::ops::ControlFlow;
use tribodyn_bearing::Side;

impl Run {
    /// Takes the step to time `t`: samples on the way, events, wear.
    pub(super) fn accept<O: Observer>(
        &mut self,
        t: f64,
        observer: &mut O,
    ) -> Result<ControlFlow<()>, RunError<O::Error>> {
        self.progress.statistics.steps += 1;
        let from = self.progress.time;
        self.spall_events(t, observer)?;
        self.pocket_events(t, observer)?;
        let mut flow = self.samples_within(from, t, observer)?;
        std::mem::swap(&mut self.progress.state, &mut self.next);
        std::mem::swap(&mut self.progress.derivative, &mut self.next_derivative);
        self.progress.time = t;
        self.deposit(t - from, observer)?;
        self.contact_events(observer)?;
        if self.progress.statistics.steps.is_multiple_of(CHECK_EVERY) {
            self.check()?;
        }
        if observer.stepped(t).is_break() {
            flow = ControlFlow::Break(());
        }
        Ok(flow)
    }

    /// Filter and samples over the step just made; a break counts from the next step on.
    pub(super) fn samples_within<O: Observer>(
        &mut self,
        from: f64,
        to: f64,
        observer: &mut O,
    ) -> Result<ControlFlow<()>, RunError<O::Error>> {
        let mut flow = ControlFlow::Continue(());
        loop {
            let (at, sample) = self.filter.next(&self.progress.filter);
            if at > to * (1.0 + 1e-14) {
                return Ok(flow);
            }
            let length = to - from;
            let s = (at - from) / length;
            let p = &self.progress;
            // The fast scheme knows no derivatives; its steps end at the samples.
            let fast = matches!(self.scheme, Scheme::Fast { .. });
            let slopes = (!fast).then_some([p.derivative.as_slice(), self.next_derivative.as_slice()]);
            let step = Between { state: [&p.state, &self.next], slopes, length };
            let values = step.values(self.machine.layout, s);
            let mut shown = std::mem::take(&mut self.shown);
            if sample && fast {
                p.fast.show(self.machine.layout, &self.next, &mut shown);
            } else if sample {
                shown.clear();
                shown.extend((0..self.next.len()).map(|i| step.at(s, i)));
            }
            self.filter.take(&mut self.progress.filter, values);
            if sample && self.hand_out(at, &shown, observer)?.is_break() {
                flow = ControlFlow::Break(());
            }
            self.shown = shown;
        }
    }

    pub(super) fn hand_out<O: Observer>(
        &mut self,
        t: f64,
        state: &[f64],
        observer: &mut O,
    ) -> Result<ControlFlow<()>, RunError<O::Error>> {
        let mut room = std::mem::take(&mut self.room);
        let with_balls = self.progress.samples.is_multiple_of(self.balls_every);
        let detail = if with_balls { BallDetail::All } else { observer.between() };
        let mut sample = self.sample_at(t, state, (detail, &mut room));
        if matches!(self.scheme, Scheme::Fast { .. }) {
            self.add_work(&mut sample);
        }
        self.progress.samples += 1;
        let flow = observer.sample(&sample, with_balls).map_err(RunError::Observer);
        room.balls = sample.balls;
        self.room = room;
        flow
    }

    /// The fast scheme has no powers of its own order within its steps: work is summed by the trapezium rule over
    /// samples.
    pub(super) fn add_work(&mut self, sample: &mut Sample) {
        let p = &sample.power;
        let rates = [p.put_in(), p.lost(), p.shaft_w.abs() + p.load_w.abs()];
        if self.progress.samples > 0 {
            let half = 0.5 / self.state_rate;
            (0..3).for_each(|k| self.progress.work[k] += half * (rates[k] + self.progress.rates[k]));
        }
        self.progress.rates = rates;
        let [put_in, lost, throughput] = self.progress.work;
        let stored = sample.power.energy_j - self.progress.energy_at_start;
        sample.power.imbalance_j = put_in - lost - sample.power.wear_work_j - stored;
        sample.power.throughput_j = throughput.max(lost.abs());
    }

    pub(super) fn pocket_events<O: Observer>(&self, t: f64, observer: &mut O) -> Result<(), RunError<O::Error>> {
        let machine = &self.machine;
        let fast = matches!(self.scheme, Scheme::Fast { .. }).then_some(&self.progress.fast);
        for ball in 0..machine.layout.balls {
            // The fast scheme knows which balls touch their walls: few do.
            if fast.is_some_and(|fast| !fast.touches_pocket(ball)) {
                continue;
            }
            let [[depth, closing_speed_m_s, lead], before] = [&self.next, &self.progress.state].map(|y| {
                let (cage, pose) = machine.cage_at(y);
                machine.pocket_depth(ball, machine.unknowns(ball, y), (cage, pose.as_ref()))
            });
            if depth <= 0.0 || before[0] > 0.0 {
                continue;
            }
            let after = machine.unknowns(ball, &self.next);
            let kind = EventKind::Impact {
                ball,
                azimuth_deg: degrees(after[AZIMUTH]),
                closing_speed_m_s,
                ball_leads: lead > 0.0,
            };
            observer.event(&Event { time_s: t, kind }).map_err(RunError::Observer)?;
        }
        Ok(())
    }

    /// Contacts lost and made since the last step.
    pub(super) fn contact_events<O: Observer>(&mut self, observer: &mut O) -> Result<(), RunError<O::Error>> {
        for ball in 0..self.machine.layout.balls {
            let loaded = self.machine.watch[ball].loaded;
            let before = self.progress.loaded[ball];
            for side in Side::BOTH.into_iter().filter(|side| loaded[*side] != before[*side]) {
                let now = loaded[side];
                self.progress.loaded[ball][side] = now;
                let azimuth_deg = degrees(self.progress.state[self.machine.layout.ball(ball) + AZIMUTH]);
                let inner = side == Side::Inner;
                let kind = if now {
                    EventKind::ContactMade { ball, inner, azimuth_deg }
                } else {
                    EventKind::ContactLost { ball, inner, azimuth_deg }
                };
                observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)?;
            }
        }
        Ok(())
    }

    /// Wear of a step of length `h` at the rates of its end.
    pub(super) fn deposit<O: Observer>(&mut self, h: f64, observer: &mut O) -> Result<(), RunError<O::Error>> {
        let l = self.machine.layout;
        let before = self.elastic_energy_where_worn();
        for ball in 0..l.balls {
            let watch = self.machine.watch[ball];
            let [inner, outer, cage] = &mut self.progress.worn;
            *inner += watch.wear.inner * h;
            *outer += watch.wear.outer * h;
            *cage += watch.pocket_wear * h;
            if self.machine.wear_acceleration == 0.0 {
                continue;
            }
            for side in Side::BOTH {
                let volume = watch.wear[side] * h * self.machine.wear_acceleration;
                let angle = self.progress.state[l.angles() + side as usize];
                let azimuth = self.progress.state[l.ball(ball) + AZIMUTH] - angle;
                self.machine.raceways[side].remove(azimuth, volume, watch.semi_lateral[side]);
            }
        }
        self.progress.wear_work += before - self.elastic_energy_where_worn();
        if self.machine.wear_acceleration == 0.0 || !self.progress.statistics.steps.is_multiple_of(WEAR_CHECK_EVERY) {
            return Ok(());
        }
        for side in Side::BOTH {
            self.machine.thinnest[side] = self.machine.raceways[side].thinnest();
            if self.progress.through[side] {
                continue;
            }
            if let Some(azimuth) = self.machine.raceways[side].worn_through() {
                self.progress.through[side] = true;
                let kind = EventKind::CoatingThrough { inner: side == Side::Inner, azimuth_deg: degrees(azimuth) };
                observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)?;
            }
        }
        Ok(())
    }

    /// Elastic energy of all ball–race contacts, J: what a change of the raceways under the balls takes away or gives.
    /// Nothing changes, and 0 stands for it, where wear leaves the raceways alone.
    fn elastic_energy_where_worn(&self) -> f64 {
        if self.machine.wear_acceleration == 0.0 {
            return 0.0;
        }
        let y = &self.progress.state;
        let frame = self.machine.frame(self.progress.time, y);
        (0..self.machine.layout.balls)
            .map(|ball| self.machine.elastic_energy(ball, self.machine.unknowns(ball, y), &frame))
            .sum()
    }

    /// Length of a whole step, s.
    pub(super) fn step(&self) -> f64 {
        match self.scheme {
            Scheme::Rk4 { step, .. } | Scheme::Fast { step } => step,
            Scheme::DormandPrince { .. } => self.progress.control.step,
        }
    }

    /// Checks stiffness, and balls that leave.
    pub(super) fn check<E>(&mut self) -> Result<(), RunError<E>> {
        let time_s = self.progress.time;
        if let Some((ball, distance)) = self.thrown_out(&self.progress.state) {
            let blame = self.blame();
            return Err(DynamicsError::BallLost { ball, time_s, distance_mm: distance * 1e3, blame }.into());
        }
        let rarely = matches!(self.scheme, Scheme::Fast { .. });
        if !rarely || self.progress.statistics.steps.is_multiple_of(FAST_CHECK_EVERY) {
            self.progress.stiffness = self.machine.stiffness(time_s, &self.progress.state);
        }
        self.progress.looked.time = time_s;
        self.progress.looked.state.copy_from_slice(&self.progress.state);
        Ok(())
    }

    /// Says at the start that the patch rule does not carry accelerations.
    pub(super) fn warn_if_coarse<O: Observer>(&mut self, observer: &mut O) -> Result<(), RunError<O::Error>> {
        let Some(error) = self.solution.patch_error_estimate.filter(|&error| error > ACCELERATION_ERROR) else {
            return Ok(());
        };
        let section = if self.machine.bearing.film_law(Side::Inner).is_some() { "lubricant" } else { "traction" };
        let message = format!(
            "the patch rule errs by {error:.1e} of the load: good for speeds and loads, but accelerations and pocket \
             forces may be off by a quarter; {section}.patch: TargetError(relative: 1e-5) carries them"
        );
        let kind = EventKind::Warning { message };
        observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)
    }

    /// Says at the start that the filter of the samples cannot see the contact vibration.
    pub(super) fn warn_if_undersampled<O: Observer>(&mut self, observer: &mut O) -> Result<(), RunError<O::Error>> {
        let (internal, contact) = (self.filter.internal_rate_hz(), self.progress.stiffness.contact_frequency_hz);
        if internal >= 2.0 * contact || self.machine.is_well_damped() {
            return Ok(());
        }
        let message = format!(
            "accelerations are filtered from {internal:.0} values a second, but contacts vibrate at {contact:.0} Hz: spectra may show lines that did not occur; shorten the step"
        );
        let kind = EventKind::Warning { message };
        observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)
    }

    /// Refuses a step of the fast scheme that friction does not allow where the scheme has to take it explicitly: with
    /// a curve of the local pressure, or a law of one's own on elastic patches. The scheme promises stable friction,
    /// and the balls then slide too fast by some per cent without another sign.
    pub(super) fn refuse_unstable_friction(&self) -> Result<(), DynamicsError> {
        let Stiffness { traction_rate_per_s, ball, .. } = self.progress.stiffness;
        let Scheme::Fast { step: step_s } = self.scheme else { return Ok(()) };
        let limit_s = EULER_LIMIT / traction_rate_per_s;
        if self.machine.kernel.has_derivative(&self.machine.bearing) || step_s <= limit_s {
            return Ok(());
        }
        Err(DynamicsError::UnstableFriction { time_s: self.progress.time, step_s, limit_s, ball })
    }

    /// Says once that a fixed step is beyond the bound.
    pub(super) fn warn_if_stiff<O: Observer>(&mut self, observer: &mut O) -> Result<(), RunError<O::Error>> {
        self.refuse_unstable_friction()?;
        let Stiffness { traction_rate_per_s, ball, contact_frequency_hz, .. } = self.progress.stiffness;
        let (step, name) = match self.scheme {
            Scheme::Rk4 { step, .. } => (step, "the Runge–Kutta method"),
            Scheme::Fast { step } => (step, "the fast scheme"),
            Scheme::DormandPrince { .. } => return Ok(()),
        };
        let limit = self.longest_step();
        if step <= limit {
            return Ok(());
        }
        let first = self.progress.beyond.is_none();
        self.progress.beyond = Some(self.progress.beyond.map_or(limit, |before| before.min(limit)));
        if !first {
            return Ok(());
        }
        let message = format!(
            "the step of {step:.2e} s is beyond the stability of {name}, {limit:.2e} s here (friction of ball {ball} decays at {traction_rate_per_s:.2e} per s, contacts vibrate at {contact_frequency_hz:.0} Hz): results may be wrong without a sign; shorten the step, or take the fast scheme where friction is the stiffer"
        );
        let kind = EventKind::Warning { message };
        observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)
    }
}

pub(super) fn degrees(azimuth: f64) -> f64 {
    azimuth.to_degrees().rem_euclid(360.0)
}
