//! A moment of a run without its balls one by one.

use crate::messages::{in_contact, over_fields};
use crate::wire::tribodyn::TransientState;
use std::sync::LazyLock;
use tribodyn_bearing::quantities::{OfBall, Over};
use tribodyn_dynamics::{BallDetail, Sample};

/// The numbers for all balls that a state holds, with the places of their fields.
pub(super) static OVER_BALLS: LazyLock<Vec<(OfBall, Over, usize)>> = LazyLock::new(over_fields::<TransientState>);

/// Rings, cage and powers of a sample, and what a recording says of all its balls together. Four of five samples have
/// no more to say at the default rates, and this is an eighth of the bytes.
#[derive(Debug, Clone)]
pub struct Overview {
    /// The sample; its list of balls is empty.
    pub(super) sample: Sample,
    /// Mean over the balls, rad/s.
    pub(super) orbital_speed_rad_s: f64,
    /// Balls that carry load at both races.
    pub(super) in_contact: u32,
    /// The numbers of [`OVER_BALLS`], SI.
    over: Vec<Option<f64>>,
    /// Angular velocity of each ball, rad/s: between samples with balls they turn on.
    pub(super) angular_velocities_rad_s: Vec<[f64; 3]>,
}

impl Overview {
    /// All that it takes of the balls.
    pub const DETAIL: BallDetail = BallDetail::Loads;

    /// Of a sample with its balls.
    pub fn of(sample: &Sample) -> Self {
        let mut overview = Self {
            sample: Sample { balls: Vec::new(), ..*sample },
            orbital_speed_rad_s: 0.0,
            in_contact: 0,
            over: Vec::new(),
            angular_velocities_rad_s: Vec::new(),
        };
        overview.take(sample);
        overview
    }

    /// The same in place of another one, whose memory it keeps.
    pub fn take(&mut self, sample: &Sample) {
        let balls = &sample.balls;
        self.sample = Sample { balls: Vec::new(), ..*sample };
        self.orbital_speed_rad_s = balls.iter().map(|b| b.orbital_speed_rad_s).sum::<f64>() / balls.len() as f64;
        self.in_contact = in_contact(balls);
        self.over.clear();
        self.over.extend(OVER_BALLS.iter().map(|(quantity, over, _)| quantity.over(*over, balls)));
        self.angular_velocities_rad_s.clear();
        self.angular_velocities_rad_s.extend(balls.iter().map(|b| b.angular_velocity_rad_s));
    }

    /// Simulated time, s.
    pub fn time_s(&self) -> f64 {
        self.sample.time_s
    }

    /// The numbers for all balls with what they are and the places of their fields; absent where the model has none.
    pub(super) fn over_balls(&self) -> impl Iterator<Item = (&'static OfBall, usize, f64)> + '_ {
        OVER_BALLS
            .iter()
            .zip(&self.over)
            .filter_map(|((quantity, _, place), value)| Some((quantity, *place, (*value)?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::Numbers;
    use std::convert::Infallible;
    use std::ops::ControlFlow;
    use tribodyn_case::{Case, set_value};
    use tribodyn_dynamics::{Event, Observer, Run};

    struct Keep(BallDetail, Vec<String>);

    impl Observer for Keep {
        type Error = Infallible;

        fn sample(&mut self, sample: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
            self.1.push(format!("{:?}", Overview::of(sample)));
            Ok(ControlFlow::Continue(()))
        }

        fn event(&mut self, _: &Event) -> Result<(), Infallible> {
            Ok(())
        }

        fn between(&self) -> BallDetail {
            self.0
        }
    }

    #[test]
    fn identity_samples_with_less_of_the_balls_say_as_much_of_all_together() {
        let text = include_str!("../../../../fixtures/cases/paper-ag.ron");
        let text = set_value(text, "transient.scheme", "Fast(step: us(20))").unwrap();
        let case = Case::from_ron(&text).unwrap();
        let [all, less] = [BallDetail::All, Overview::DETAIL].map(|detail| {
            let (mut keep, mut run) = (Keep(detail, Vec::new()), Run::new(case.run_inputs().unwrap()).unwrap());
            let _ = run.advance(1e-3, &mut keep).unwrap();
            keep.1
        });
        assert!(all.len() > 20);
        assert_eq!(all, less);
    }

    #[test]
    fn identity_what_is_known_of_all_balls_has_a_field() {
        for name in ["load_inner_max_n", "peak_pressure_outer_max_gpa", "pocket_force_max_n", "orbital_speed_min_rpm"] {
            assert!(OVER_BALLS.iter().any(|f| TransientState::NAMES[f.2] == name), "{name}");
        }
    }
}
