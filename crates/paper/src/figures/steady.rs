//! Figures 14 and 16 to 18: the quasi-static cases, with Tables 4 and 5.

use super::runs::Made;
use super::spec::Spec;
use crate::error::PaperError;
use tribodyn_plot::{Figure, Panel, Place, Quantity, Reference};

/// Cage speeds of Table 4, r/min.
const CAGE_SPEEDS: [(&str, &str, f64); 3] = [
    ("case 1", "published mean, cases 1 and 2: 5802 r/min", 5802.0),
    ("case 3", "published mean, case 3: 5861 r/min", 5861.0),
    ("case 4", "published mean, case 4: 5860 r/min", 5860.0),
];
/// The test's, section 4.3.2, r/min.
const TESTED_SPEED: f64 = 5788.0;
/// The heavily loaded zone of section 5.1.2, degrees.
const HEAVY_ZONE: Place = Place::Between(-90.0, 90.0);

fn figure(spec: &Spec, made: &Made, name: &str, add: impl Fn(Quantity, &mut Panel)) -> Result<Figure, PaperError> {
    let mut panels = made.steady(name)?.panels;
    panels.iter_mut().for_each(|(quantity, panel)| add(*quantity, panel));
    let panels: Vec<Panel> = panels.into_iter().map(|(_, panel)| panel).collect();
    Ok(Figure::new(spec.name, spec.title, &panels)?)
}

/// As it is, with what Table 5 gives.
pub fn plain(name: &'static str, spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    figure(spec, made, name, |_, _| ())
}

/// With the zone that the paper compares with the rest of the orbit.
pub fn with_zone(name: &'static str, spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    figure(spec, made, name, |_, panel| {
        panel.publish(Reference::new("published heavy zone: −90° to 90°", HEAVY_ZONE));
    })
}

pub fn loads(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    figure(spec, made, "contact-loads", |quantity, panel| {
        if quantity == Quantity::LoadOuter {
            panel.publish(twice_the_least(panel));
        }
    })
}

/// "Nearly twice that in the lightly loaded zone": twice the least value of the first line.
pub fn twice_the_least(panel: &Panel) -> Reference {
    let first = panel.series().first().map_or(&[][..], |series| &series.points);
    let least = first.iter().fold(f64::INFINITY, |least, (_, value)| least.min(*value));
    Reference::new("published: heaviest nearly twice the lightest", Place::Value(2.0 * least))
}

/// Table 4's mean orbital speeds, which the balls' go about.
pub fn speeds(spec: &Spec, made: &Made) -> Result<Figure, PaperError> {
    figure(spec, made, "orbital-speed", |_, panel| {
        for (case, label, speed) in CAGE_SPEEDS {
            panel.publish(Reference::new(label, Place::Value(speed)).of(case));
        }
        let label = format!("published test: {TESTED_SPEED} r/min");
        panel.publish(Reference::new(label, Place::Value(TESTED_SPEED)));
    })
}
