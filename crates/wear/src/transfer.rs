//! Solid lubricant that balls scrape off the cage and carry to the races: a film kept by a balance of volumes.
//!
//! The volume that the pockets lose per time by Archard's law, W, comes to the balls but for the part λ that is thrown
//! off at once. Balls and tracks are rolled over some thousand times a second, far more often than the film wears, so
//! that one thickness h = V/A covers them, A being the surface of all balls and of both tracks. It covers c = h/h_c of
//! a contact, at most all of it: what would make the film thicker than h_c does not stick and is lost. Where the film
//! is, it slides and wears in the place of what is under it; of what it loses there, the part λ goes and the rest stays
//! in it:
//!
//! ```text
//! dV/dt = (1 − λ) W − λ (K_f/H_f) c ∬ p |Δv| dA,     c = min(1, V/(A h_c))
//! scraped = film + lost                               (always)
//! ```

use crate::{Archard, WearError};
use serde::{Deserialize, Serialize};

/// How lubricant of the cage is carried and lost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransferLaw {
    /// Part λ of what is scraped or worn off that is lost, 0 to 1.
    pub loss: f64,
    /// Thickness h_c at which the film covers all of a contact, m.
    pub cover: f64,
    /// Wear of the film between ball and race.
    pub wear: Archard,
}

/// Rates that feed and wear the film, and the area that it covers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransferRates {
    /// Volume that all pockets lose per time, W, m³/s.
    pub scraped: f64,
    /// ∬ p |Δv| dA of all contacts of balls and races, W.
    pub sliding: f64,
    /// Surface A that the film covers, m².
    pub area: f64,
}

/// The film and its account, m³.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct TransferFilm {
    /// On balls and tracks.
    pub volume: f64,
    /// Scraped off the cage so far.
    pub scraped: f64,
    /// Lost so far.
    pub lost: f64,
}

impl TransferLaw {
    /// Refuses what is no law.
    ///
    /// # Errors
    /// [`WearError`].
    pub fn check(&self) -> Result<(), WearError> {
        if !(0.0..=1.0).contains(&self.loss) {
            return Err(WearError::Fraction { name: "part of the transferred film that is lost", value: self.loss });
        }
        if !(self.cover > 0.0 && self.cover.is_finite()) {
            return Err(WearError::Length { name: "thickness of a film that covers a contact", value: self.cover });
        }
        Ok(())
    }

    /// Loss per time of a film that covers everything, λ (K_f/H_f) ∬ p |Δv|, m³/s.
    fn drain(&self, rates: &TransferRates) -> f64 {
        self.loss * self.wear.rate(rates.sliding)
    }
}

impl TransferFilm {
    /// Part of a contact that the film covers.
    pub fn cover(&self, law: &TransferLaw, area: f64) -> f64 {
        if area > 0.0 { (self.volume / (area * law.cover)).min(1.0) } else { 0.0 }
    }

    /// The film after a time (s) at constant rates, and the mean of its cover in that time. Exact.
    pub fn after(&self, law: &TransferLaw, rates: &TransferRates, time: f64) -> (Self, f64) {
        let full = rates.area * law.cover;
        let (gain, drain) = ((1.0 - law.loss) * rates.scraped, law.drain(rates));
        let begin = self.volume.min(full);
        let (end, mean) = match drain * time > 1e-9 * full {
            true => {
                // V' = g − V d/V_full, cut at V_full.
                let (steady, scale) = (full * gain / drain, full / drain);
                let free = |t: f64| steady + (begin - steady) * (-t / scale).exp();
                let until =
                    if steady > full { scale * ((steady - begin) / (steady - full)).ln() } else { f64::INFINITY };
                let (rising, held) = (time.min(until), (time - until).max(0.0));
                let covered = steady * rising - (begin - steady) * scale * (-rising / scale).exp_m1();
                (free(rising).min(full), (covered + full * held) / (full * time))
            }
            false => {
                let until = if gain > 0.0 { (full - begin) / gain } else { f64::INFINITY };
                let rising = time.min(until);
                let covered = begin * rising + 0.5 * gain * rising * rising + full * (time - rising);
                ((begin + gain * rising).min(full), covered / (full * time))
            }
        };
        let scraped = self.scraped + rates.scraped * time;
        // What is neither on balls and tracks nor still on the cage is lost.
        (Self { volume: end, scraped, lost: self.lost + (rates.scraped * time + self.volume - end) }, mean)
    }

    /// Longest time, s, in which the cover changes by no more than a part; endless where it never does.
    pub fn longest(&self, law: &TransferLaw, rates: &TransferRates, part: f64) -> f64 {
        let full = rates.area * law.cover;
        let (gain, drain) = ((1.0 - law.loss) * rates.scraped, law.drain(rates));
        let now = self.cover(law, rates.area);
        let end = if drain > 0.0 { (gain / drain).min(1.0) } else { f64::from(u8::from(gain > 0.0 || now >= 1.0)) };
        if (end - now).abs() <= part || full <= 0.0 {
            return f64::INFINITY;
        }
        let begun = (gain - drain * now).abs() / full;
        // The cover's rate only falls on the way to its end, so that this is never too long.
        part / begun
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: TransferLaw =
        TransferLaw { loss: 0.3, cover: 1e-7, wear: Archard { coefficient: 1e-6, hardness: 60e6 } };
    const RATES: TransferRates = TransferRates { scraped: 1e-10, sliding: 1.2e4, area: 0.04 };

    /// The balance in small steps of the classical Runge–Kutta method, which knows nothing of the closed form.
    fn marched(law: &TransferLaw, rates: &TransferRates, time: f64) -> f64 {
        let full = rates.area * law.cover;
        let slope = |v: f64| {
            let lost = law.loss * law.wear.coefficient / law.wear.hardness * rates.sliding * (v / full).min(1.0);
            (1.0 - law.loss) * rates.scraped - lost
        };
        let (steps, mut v) = (20_000, 0.0);
        let h = time / f64::from(steps);
        for _ in 0..steps {
            let first = slope(v);
            let second = slope(v + 0.5 * h * first);
            let third = slope(v + 0.5 * h * second);
            let fourth = slope(v + h * third);
            v = (v + h / 6.0 * (first + 2.0 * (second + third) + fourth)).min(full);
        }
        v
    }

    #[test]
    fn limit_closed_form_is_the_balance_in_small_steps() {
        for (rates, law) in [
            (RATES, LAW),
            (TransferRates { scraped: 1e-9, ..RATES }, LAW),
            (TransferRates { sliding: 0.0, ..RATES }, LAW),
            (RATES, TransferLaw { loss: 0.0, ..LAW }),
            (RATES, TransferLaw { loss: 1.0, ..LAW }),
        ] {
            for time in [1.0, 30.0, 200.0] {
                let (film, mean) = TransferFilm::default().after(&law, &rates, time);
                let expected = marched(&law, &rates, time);
                let full = rates.area * law.cover;
                assert!((film.volume - expected).abs() < 1e-6 * full, "{rates:?} {time}: {film:?} {expected:e}");
                assert!((0.0..=1.0).contains(&mean));
            }
        }
    }

    #[test]
    fn identity_what_is_scraped_is_on_the_surfaces_or_lost() {
        let mut film = TransferFilm::default();
        for k in 0..400 {
            let rates = TransferRates { scraped: 1e-10 * f64::from(k % 7), sliding: 2e3 * f64::from(k % 5), ..RATES };
            (film, _) = film.after(&LAW, &rates, 0.3 * f64::from(1 + k % 3));
            let gap = film.scraped - film.volume - film.lost;
            assert!(gap.abs() < 1e-10 * film.scraped.max(1e-30), "{k}: {gap:e} of {:e}", film.scraped);
            assert!(film.volume >= 0.0 && film.lost >= 0.0);
        }
    }

    /// Two strides are one of their length, and the mean cover is what the drain says.
    #[test]
    fn identity_halves_of_a_stride_and_the_cover_in_it() {
        let start = TransferFilm { volume: 1e-9, ..TransferFilm::default() };
        let (whole, mean) = start.after(&LAW, &RATES, 40.0);
        let (half, first) = start.after(&LAW, &RATES, 20.0);
        let (end, second) = half.after(&LAW, &RATES, 20.0);
        assert!((end.volume / whole.volume - 1.0).abs() < 1e-12);
        assert!((0.5 * (first + second) - mean).abs() < 1e-12);
        // Not full anywhere on the way: gain less loss is the change.
        assert!(whole.cover(&LAW, RATES.area) < 1.0);
        let lost = LAW.loss * LAW.wear.rate(RATES.sliding) * mean * 40.0;
        let change = (1.0 - LAW.loss) * RATES.scraped * 40.0 - lost;
        assert!((change / (whole.volume - start.volume) - 1.0).abs() < 1e-10);
    }

    #[test]
    fn limit_strides_end_where_the_cover_has_changed_by_a_part() {
        let longest = TransferFilm::default().longest(&LAW, &RATES, 0.05);
        let (film, _) = TransferFilm::default().after(&LAW, &RATES, longest);
        let cover = film.cover(&LAW, RATES.area);
        assert!(cover > 0.04 && cover <= 0.05 + 1e-12, "{cover}");
        let idle = TransferRates { scraped: 0.0, ..RATES };
        assert_eq!(TransferFilm::default().longest(&LAW, &idle, 0.05), f64::INFINITY);
        assert!(
            TransferLaw { loss: 1.5, ..LAW }.check().is_err() && TransferLaw { cover: 0.0, ..LAW }.check().is_err()
        );
    }
}
