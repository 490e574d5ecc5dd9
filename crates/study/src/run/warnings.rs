//! Warnings of a run, put together by kind and ball.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::RangeInclusive;
use tribodyn::plausibility::tested_gpa;
use tribodyn_bearing::Side;
use tribodyn_case::{Case, CoatingSpec, CurveSpec};
use tribodyn_record::{BallRow, LogRow};

/// A ball that leaves the load zone: files of earlier versions mark it as a warning.
const CONTACT_LOST: &str = "contact-lost";
/// How a quasi-static solution begins to say the same.
const UNLOADED: &str = "no contact with the ";

/// The warnings of a log so far: one line for each kind and ball, with the first time and the count.
#[derive(Debug, Clone, Default)]
pub struct Warnings {
    /// Places in `found`.
    kinds: BTreeMap<String, usize>,
    /// The first message of a kind, and how many there were.
    found: Vec<(String, usize)>,
}

impl Warnings {
    /// Takes in a line of the log.
    pub fn add(&mut self, row: &LogRow) {
        if !row.warning || row.kind == CONTACT_LOST || row.is_of_start() {
            return;
        }
        let found = &mut self.found;
        let place = *self.kinds.entry(format!("{} {}", row.kind, kind(text(row)))).or_insert_with(|| {
            found.push((row.message.clone(), 0));
            found.len() - 1
        });
        self.found[place].1 += 1;
    }

    /// The lines.
    pub fn lines(&self) -> Vec<String> {
        let line = |(first, count): &(String, usize)| match count {
            1 => first.clone(),
            _ => format!("{first} ({count} times, this is the first)"),
        };
        self.found.iter().map(line).collect()
    }
}

/// The warnings of a whole log.
pub fn of_log(log: &[LogRow]) -> Vec<String> {
    let mut warnings = Warnings::default();
    log.iter().for_each(|row| warnings.add(row));
    warnings.lines()
}

/// The message of a line of the log without its time.
fn text(row: &LogRow) -> &str {
    row.message.strip_prefix("t = ").and_then(|rest| rest.split_once(" s: ")).map_or(&row.message, |(_, text)| text)
}

/// A message with its numbers left out, but for those of balls.
fn kind(message: &str) -> String {
    let mut kept: Vec<String> = Vec::new();
    for word in message.split_whitespace() {
        let of_ball = kept.last().is_some_and(|last| last == "ball");
        let number = !of_ball && word.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '('));
        kept.push(if number && word.contains(|c: char| c.is_ascii_digit()) { "#".to_owned() } else { word.to_owned() });
    }
    kept.join(" ")
}

/// Those warnings of a quasi-static solution that are warnings of a run: balls outside the load zone are not.
pub fn at_start(warnings: Vec<String>) -> Vec<String> {
    warnings.into_iter().filter(|warning| !warning.starts_with(UNLOADED)).collect()
}

/// Peak pressures of one race against those at which its coating was tested.
#[derive(Debug, Clone)]
pub struct Tested {
    race: &'static str,
    inner: bool,
    tested_gpa: RangeInclusive<f64>,
    least: f64,
    most: f64,
    all: u64,
    outside: u64,
}

impl Tested {
    /// For the races whose traction parameters vary with pressure; those that do not are taken at one pressure,
    /// whatever the contacts have.
    pub fn of(case: &Case) -> Vec<Self> {
        let (Some(coatings), Some(traction)) = (&case.coatings, &case.traction) else { return Vec::new() };
        let races = [("inner", true, &coatings.inner.curve), ("outer", false, &coatings.outer.curve)];
        let one = |(race, inner, curve): (&'static str, bool, &CurveSpec)| {
            let tested_gpa = tested_gpa(curve)?;
            Some(Self { race, inner, tested_gpa, least: f64::INFINITY, most: 0.0, all: 0, outside: 0 })
        };
        races.into_iter().filter(|_| traction.varying).filter_map(one).collect()
    }

    /// Takes in the balls of a sample; a contact that is lost has no pressure.
    pub fn add(&mut self, balls: &[BallRow]) {
        for ball in balls {
            let pressure =
                f64::from(if self.inner { ball.peak_pressure_inner_gpa } else { ball.peak_pressure_outer_gpa });
            if pressure > 0.0 {
                (self.least, self.most) = (self.least.min(pressure), self.most.max(pressure));
                self.all += 1;
                self.outside += u64::from(!self.tested_gpa.contains(&pressure));
            }
        }
    }

    /// A sentence where the curve was used outside its tests.
    pub fn warning(&self) -> Option<String> {
        let (low, high) = (self.tested_gpa.start(), self.tested_gpa.end());
        (self.outside > 0).then(|| {
            format!(
                "Pressures at the {} race were {:.3} to {:.3} GPa, the coating was tested at {low} to {high} GPa: its traction curve is extrapolated in {:.0} % of the samples.",
                self.race,
                self.least,
                self.most,
                100.0 * self.outside as f64 / self.all as f64
            )
        })
    }
}

/// Part of the film under the balls that may go before a run has to say so.
const WORN_MUCH: f64 = 0.1;

/// Sentences where much of a coating would have gone by the worn volume of a run in which wear does not act: the film
/// under the balls is its thickness times the track, as wide as the contact of the largest load (N). Volumes (µm³) and
/// loads of the inner and outer race.
pub fn worn_through_unseen(case: &Case, volumes_um3: [f64; 2], largest_loads: [f64; 2]) -> Vec<String> {
    let acts = case.transient.as_ref().is_none_or(|transient| transient.wear_acceleration != 0.0);
    let (Some(coatings), false, Ok(bearing)) = (&case.coatings, acts, case.bearing()) else { return Vec::new() };
    let volumes = volumes_um3.map(|volume| volume * 1e-18);
    let races = Side::BOTH.into_iter().zip([&coatings.inner, &coatings.outer]).zip(volumes).zip(largest_loads);
    let one = |(((side, coating), volume), load): (((Side, &CoatingSpec), f64), f64)| {
        let hertz = bearing.races[side].frozen::<f64>();
        let approach = (load / hertz.stiffness()).powf(2.0 / 3.0);
        let width = 2.0 * hertz.ellipse_at(approach).semi_lateral();
        let film = coating.thickness * TAU * bearing.track_radius(side) * width;
        (film > 0.0 && volume > WORN_MUCH * film).then(|| {
            format!(
                "By Archard's law {:.3} mm³ of the {:.3} mm³ of coating under the balls would be worn off the {} race, but wear does not act in this run (`transient.wear_acceleration` is 0): the coating stays whole.",
                volume * 1e9,
                film * 1e9,
                side.name()
            )
        })
    };
    races.filter_map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(kind: &str, message: &str) -> LogRow {
        LogRow { time_s: 0.0, warning: true, kind: kind.to_owned(), message: message.to_owned() }
    }

    #[test]
    fn limit_warnings_of_one_kind_and_ball_are_one_line() {
        let mut log = vec![row("contact-lost", "t = 0.1 s: ball 2 leaves the inner race at 181.0°")];
        for k in 0..40 {
            let at = format!("t = 0.{k:03} s: the coating of the inner race is worn through at {k}.5° of the ring");
            log.push(row("coating-through", &at));
            log.push(row("warning", &format!("t = 0.{k:03} s: ball {} skids at {k}.25 %", k % 3)));
        }
        log.push(LogRow { warning: false, ..row("impact", "t = 0.1 s: ball 1 meets its pocket") });
        let lines = of_log(&log);
        assert_eq!(lines.len(), 4, "{lines:#?}");
        assert_eq!(
            lines[0],
            "t = 0.000 s: the coating of the inner race is worn through at 0.5° of the ring (40 times, this is the first)"
        );
        assert!(lines[1].starts_with("t = 0.000 s: ball 0 skids") && lines[1].contains("14 times"), "{lines:#?}");
        assert!(lines[3].starts_with("t = 0.002 s: ball 2 skids") && lines[3].contains("13 times"), "{lines:#?}");
        assert_eq!(of_log(&[row("warning", "no time")]), ["no time"]);
    }

    #[test]
    fn limit_a_ball_outside_the_load_zone_is_no_warning() {
        let text = include_str!("../../../../fixtures/cases/paper-handset.ron");
        // Next to no axial load: the balls at the far side carry nothing.
        let set = |text: &str, path, value| tribodyn_case::set_value(text, path, value).unwrap();
        let text = set(&set(text, "ring.z", "Force(kN(2))"), "traction.patch", "SplitStrip(across: 5, along: 3)");
        let case = Case::from_ron(&text).unwrap();
        let bearing = case.bearing().unwrap();
        let point = case.operating_point();
        let solved = tribodyn_quasistatic::solve(&bearing, &point, tribodyn_quasistatic::Model::Traction).unwrap();
        let of_solution = solved.solution.warnings;
        assert!(of_solution.iter().any(|w| w.contains("no contact with the inner race")), "{of_solution:?}");
        let kept = at_start(of_solution);
        assert!(kept.iter().all(|w| !w.contains("no contact")), "{kept:?}");
    }

    /// The film is 10 µm on a track 2π R long and 2a wide; p = 3Q/(2π a b) is 2.444 GPa under 12.5 kN.
    #[test]
    fn limit_wear_that_does_not_act_is_said_where_it_is_large() {
        let text = include_str!("../../../../fixtures/cases/paper-ag.ron");
        let case = Case::from_ron(text).unwrap();
        let worn = |mm3: f64| [mm3 * 1e9, 0.0];
        let said = worn_through_unseen(&case, worn(27.0), [12_500.0, 15_300.0]);
        assert_eq!(said.len(), 1, "{said:?}");
        let film: f64 = said[0].split("of the ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
        let bearing = case.bearing().unwrap();
        let ellipticity = bearing.races.inner.frozen::<f64>().ellipticity;
        let semi_axis = (3.0 * 12_500.0 * ellipticity / (TAU * 2.444e9)).sqrt();
        let expected = 1e9 * 10e-6 * TAU * bearing.track_radius(Side::Inner) * 2.0 * semi_axis;
        assert!((film / expected - 1.0).abs() < 2e-3, "{film} {expected}");
        assert!(said[0].contains("27.000 mm³") && said[0].contains("inner race"), "{said:?}");
        assert!(worn_through_unseen(&case, worn(1.0), [12_500.0, 15_300.0]).is_empty());
        let acting = tribodyn_case::set_value(text, "transient.wear_acceleration", "1").unwrap();
        let acting = Case::from_ron(&acting).unwrap();
        assert!(worn_through_unseen(&acting, worn(27.0), [12_500.0, 15_300.0]).is_empty());
    }

    #[test]
    fn limit_pressures_are_held_against_those_of_the_tests() {
        let text = include_str!("../../../../fixtures/cases/paper-handset.ron");
        let mut races = Tested::of(&Case::from_ron(text).unwrap());
        let ball = |inner: f32, outer: f32| BallRow {
            peak_pressure_inner_gpa: inner,
            peak_pressure_outer_gpa: outer,
            ..BallRow::default()
        };
        races.iter_mut().for_each(|race| race.add(&[ball(2.4, 3.0), ball(3.0, 3.1), ball(0.0, 2.6), ball(2.0, 2.7)]));
        let said = races[0].warning().unwrap();
        assert!(said.contains("inner race were 2.000 to 3.000 GPa") && said.contains("67 %"), "{said}");
        assert_eq!(races[1].warning(), None);
    }
}
