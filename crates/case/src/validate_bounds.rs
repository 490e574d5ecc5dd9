//! Bounds of the format: values that no bearing has, however finite they are.
//!
//! They are far wider than anything plausible. What they keep out are slips of the pen by many powers of ten and
//! numbers whose products overflow: a mass of 1e300 kg, a drag of infinitely many kilowatts. A value that is possible
//! but unusual is not refused here.

use super::validate::{Refusal, Verdict};
use super::*;
use tribodyn_bearing::{PocketShape, Scheme, SpeedHistory, Tilt, Translation};
use tribodyn_traction::SlipUnit;

/// The range of one kind of value.
struct Bound {
    /// Path of the value, `*` for any name or index.
    path: &'static str,
    /// Least and largest value allowed, SI.
    range: [f64; 2],
    /// SI unit, empty for a number.
    unit: &'static str,
    /// Reason of the range.
    reason: &'static str,
}

const fn bound(path: &'static str, range: [f64; 2], unit: &'static str, reason: &'static str) -> Bound {
    Bound { path, range, unit, reason }
}

const BALL: &str = "balls of bearings measure 0.25 mm to 150 mm";
const PITCH: &str = "bearings measure 1 mm to 15 m";
const STEEL: &str = "rubber has 1e7 Pa, diamond 1.2e12 Pa";
const HEAVIEST: &str = "the densest solid, osmium, has 22 590 kg/m³";
const COATING: &str = "a coating is a film of at most some millimetres";
const TEST: &str = "no contact is tested beyond the strength of solids";
const SLIP: &str = "no slip is measured in such numbers";
const FRICTION: &str = "clean metals in vacuum reach about 5";
const ARCHARD: &str = "wear coefficients lie between 1e-12 and 0.1: at 1 every contact leaves a particle";
const HARDNESS: &str = "soft polymers have 1e6 Pa, diamond 1e11 Pa";
const LOAD: &str = "the largest bearings carry 1e8 N";
const MOMENT: &str = "the largest bearings carry 1e9 N m";
const PLACE: &str = "a ring farther away has left its balls";
const ANGLE: &str = "an azimuth is an angle on a ring";
const TILT: &str = "a ring that is tilted further has left its balls";
const INSTANT: &str = "a table is in simulated time, which ends at 1e4 s";
const MASS: &str = "rings and what moves with them weigh a milligram to some thousand tonnes";
const RATED: &str = "the largest bearings are rated at some 1e8 N";
const SPRING: &str = "a metre cube of steel has 2e11 N/m";
const DAMPER: &str = "critical damping of 1e6 kg on 1e13 N/m is 6e9 N s/m";

/// The bounds, in the order of the case file. A path that is not here is a choice, or bounded where it is checked.
const BOUNDS: &[Bound] = &[
    bound(
        "geometry.ball_count",
        [2.0, 1000.0],
        "",
        "slewing bearings have some hundred balls; above 500 --no-limits is needed",
    ),
    bound("geometry.ball_diameter", [1e-5, 1.0], "m", BALL),
    bound("geometry.pitch_diameter", [1e-4, 50.0], "m", PITCH),
    bound("materials.*.young", [1e6, 1e13], "Pa", STEEL),
    bound("materials.*.density", [1e-9, 3e4], "kg/m³", HEAVIEST),
    bound("coatings.*.thickness", [0.0, 0.01], "m", COATING),
    bound("coatings.transfer.cover", [1e-10, 0.01], "m", COATING),
    bound("coatings.transfer.wear.coefficient", [0.0, 1.0], "", ARCHARD),
    bound("coatings.transfer.wear.hardness", [1e3, 1e12], "Pa", HARDNESS),
    bound("coatings.*.curve.Tested[*].pressure", [1e3, 1e12], "Pa", TEST),
    bound("coatings.*.curve.Tested[*].peak_slip", [1e-9, 1e9], "", SLIP),
    bound("coatings.*.curve.Tested[*].peak_coefficient", [1e-9, 10.0], "", FRICTION),
    bound("coatings.*.curve.Tested[*].residual_coefficient", [1e-9, 10.0], "", FRICTION),
    bound("traction.slip_unit.Scaled.per_m_s", [1e-6, 1e6], "s/m", SLIP),
    bound("traction.order", [0.0, 20.0], "", "a polynomial of higher order swings between its points"),
    bound("traction.reference_pressure", [1e3, 1e12], "Pa", TEST),
    bound("fluid.gas_density", [1e-6, 3e4], "kg/m³", HEAVIEST),
    bound("fluid.drag_coefficient", [0.0, 1e3], "", "bluff bodies have some 1, films of oil some tens"),
    bound("fluid.medium.Custom.density", [1e-6, 3e4], "kg/m³", HEAVIEST),
    bound("fluid.medium.Custom.viscosity", [1e-9, 1e6], "Pa s", "gases have 1e-5 Pa s, pitch 1e8 Pa s"),
    bound("rating.dynamic", [1e-3, 1e10], "N", RATED),
    bound("rating.static_load", [1e-3, 1e10], "N", RATED),
    bound("rating.fatigue_limit", [1e-6, 1e10], "N", RATED),
    bound("rating.bore", [1e-5, 50.0], "m", PITCH),
    bound("rating.outside", [1e-5, 50.0], "m", PITCH),
    bound("cage.pocket_gap", [0.0, 1.0], "m", "a pocket is about as large as its ball"),
    bound("cage.pocket_stiffness", [0.0, 1e13], "N/m", SPRING),
    bound("cage.pocket_friction", [0.0, 10.0], "", FRICTION),
    bound("cage.drag_torque", [-1e9, 1e9], "N m", MOMENT),
    bound("cage.inertia", [1e-18, 1e9], "kg m²", "cages of 1 mm and of 15 m"),
    bound("cage.pocket_damping", [0.0, 1e6], "s/m", "at 10 s/m a ball that meets its pocket at 0.1 m/s stays there"),
    bound("cage.pocket_film.roughness", [1e-10, 1e-3], "m", "polished steel has 1e-9 m, a raw casting 1e-5 m"),
    bound("cage.churning.bore", [1e-5, 100.0], "m", PITCH),
    bound("cage.churning.outside", [1e-5, 100.0], "m", PITCH),
    bound("cage.churning.width", [1e-6, 10.0], "m", PITCH),
    bound("cage.guidance.radius", [1e-5, 50.0], "m", PITCH),
    bound("cage.guidance.width", [1e-6, 10.0], "m", PITCH),
    bound("cage.guidance.gap", [1e-9, 1.0], "m", "a film of fluid has some molecules across it"),
    bound("cage.free.mass", [1e-12, 1e6], "kg", "cages of 1 mm and of 15 m"),
    bound("cage.free.transverse_inertia", [1e-18, 1e9], "kg m²", "cages of 1 mm and of 15 m"),
    bound("cage.free.gravity[*]", [-1e6, 1e6], "m/s²", "a centrifuge has 1e6 m/s²"),
    bound("cage.free.pockets.RaceTrack.axial_gap", [0.0, 1.0], "m", "a pocket is about as large as its ball"),
    bound("cage.free.lands[*].axial", [-10.0, 10.0], "m", PITCH),
    bound("cage.free.lands[*].radius", [1e-5, 50.0], "m", PITCH),
    bound("cage.free.lands[*].width", [1e-6, 10.0], "m", PITCH),
    bound("cage.free.lands[*].gap", [1e-9, 1.0], "m", "a film of fluid has some molecules across it"),
    bound("cage.free.lands[*].stiffness", [0.0, 1e13], "N/m", SPRING),
    bound("cage.free.lands[*].damping", [0.0, 1e6], "s/m", "at 10 s/m a cage that meets a land at 0.1 m/s stays there"),
    bound("cage.free.lands[*].friction", [0.0, 10.0], "", FRICTION),
    bound("cage.free.lands[*].film.viscosity", [1e-9, 1e6], "Pa s", "gases have 1e-5 Pa s, pitch 1e8 Pa s"),
    bound("cage.free.lands[*].film.density", [1e-6, 3e4], "kg/m³", HEAVIEST),
    bound("wear.*.coefficient", [0.0, 1.0], "", ARCHARD),
    bound("wear.*.hardness", [1e3, 1e12], "Pa", HARDNESS),
    bound("ring.*.Force", [-1e10, 1e10], "N", LOAD),
    bound("ring.*.ForceTable[*][0]", [-1e9, 1e9], "s", INSTANT),
    bound("ring.*.ForceTable[*][1]", [-1e10, 1e10], "N", LOAD),
    bound("ring.x.Held", [-0.1, 0.1], "m", PLACE),
    bound("ring.y.Held", [-0.1, 0.1], "m", PLACE),
    bound("ring.z.Held", [-0.1, 0.1], "m", PLACE),
    bound("ring.*.Moment", [-1e9, 1e9], "N m", MOMENT),
    bound("ring.*.MomentTable[*][0]", [-1e9, 1e9], "s", INSTANT),
    bound("ring.*.MomentTable[*][1]", [-1e9, 1e9], "N m", MOMENT),
    bound("ring.tilt_x.Held", [-0.5, 0.5], "rad", TILT),
    bound("ring.tilt_y.Held", [-0.5, 0.5], "rad", TILT),
    bound("speed.*.Table[*][0]", [-1e9, 1e9], "s", INSTANT),
    bound("supports.*.mass", [1e-9, 1e8], "kg", MASS),
    bound("supports.*.stiffness[*]", [0.0, 1e14], "N/m", SPRING),
    bound("supports.*.damping[*]", [0.0, 1e11], "N s/m", DAMPER),
    bound("deviations.position.ball", [-1e4, 1e4], "rad", ANGLE),
    bound("deviations.position.inner", [-1e4, 1e4], "rad", ANGLE),
    bound("deviations.position.outer", [-1e4, 1e4], "rad", ANGLE),
    bound("deviations.*.waves[*].phase", [-1e4, 1e4], "rad", ANGLE),
    bound("spalls[*].azimuth", [-1e4, 1e4], "rad", ANGLE),
    bound("defects[*].azimuth", [-1e4, 1e4], "rad", ANGLE),
    bound("transient.wear_acceleration", [0.0, 1e15], "", "a ring would be gone in one step"),
    bound("transient.duration", [1e-12, 1e4], "s", "time is counted in doubles"),
    bound("transient.scheme.*.step", [1e-12, 1e-4], "s", "sound passes an atom of steel in 5e-14 s"),
    bound("transient.scheme.*.longest", [1e-12, 1e-4], "s", "sound passes an atom of steel in 5e-14 s"),
    bound("recording.state_rate", [1e-6, 1e6], "Hz", "less often than once in the longest run is never"),
    bound("recording.ball_rate", [1e-6, 1e6], "Hz", "less often than once in the longest run is never"),
    bound("numerics.tolerance", [1e-15, 1e-3], "", "below the last digit of a double nothing converges"),
    bound("numerics.max_iterations", [1.0, 1e6], "", "a solution takes 10 to 40 steps"),
];

/// Checks each value of the case against its bound.
pub(super) fn validate(case: &Case) -> Verdict {
    let mut values = Values::default();
    values.steady(case);
    values.loads(&case.ring, &case.speed);
    values.transient(case);
    values.first_out_of_bounds()
}

/// Values with their paths.
#[derive(Default)]
struct Values(Vec<(String, f64)>);

impl Values {
    fn add(&mut self, path: impl Into<String>, value: f64) {
        self.0.push((path.into(), value));
    }

    fn steady(&mut self, case: &Case) {
        let Case { geometry, materials, .. } = case;
        self.add("geometry.ball_count", geometry.ball_count as f64);
        self.add("geometry.ball_diameter", geometry.ball_diameter);
        self.add("geometry.pitch_diameter", geometry.pitch_diameter);
        for (name, body) in [("ball", &materials.ball), ("inner", &materials.inner), ("outer", &materials.outer)] {
            self.add(format!("materials.{name}.young"), body.young);
            self.add(format!("materials.{name}.density"), body.density);
        }
        if let Some(coatings) = &case.coatings {
            self.coatings(coatings);
        }
        if let Some(traction) = &case.traction {
            if let SlipUnit::Scaled { per_m_s } = traction.slip_unit {
                self.add("traction.slip_unit.Scaled.per_m_s", per_m_s);
            }
            self.add("traction.order", traction.order as f64);
            self.add("traction.reference_pressure", traction.reference_pressure);
        }
        if let Some(fluid) = &case.fluid {
            self.add("fluid.gas_density", fluid.gas_density);
            self.add("fluid.drag_coefficient", fluid.drag_coefficient);
            if let Medium::Custom { density, viscosity } = fluid.medium {
                self.add("fluid.medium.Custom.density", density);
                self.add("fluid.medium.Custom.viscosity", viscosity);
            }
        }
        if let Some(cage) = &case.cage {
            self.cage(cage);
        }
        let pairs =
            case.wear.iter().flat_map(|wear| [("inner", &wear.inner), ("outer", &wear.outer), ("cage", &wear.cage)]);
        for (name, pair) in pairs {
            self.add(format!("wear.{name}.coefficient"), pair.coefficient);
            self.add(format!("wear.{name}.hardness"), pair.hardness);
        }
        if let Some(rating) = &case.rating {
            let forces = [("dynamic", rating.dynamic), ("static_load", rating.static_load)];
            let lengths = [("bore", rating.bore), ("outside", rating.outside)];
            let all = forces.into_iter().chain([("fatigue_limit", rating.fatigue_limit)]).chain(lengths);
            all.for_each(|(name, value)| value.into_iter().for_each(|v| self.add(format!("rating.{name}"), v)));
        }
        self.add("numerics.tolerance", case.numerics.tolerance);
        self.add("numerics.max_iterations", case.numerics.max_iterations as f64);
    }

    fn coatings(&mut self, coatings: &Coatings) {
        for (name, coating) in [("inner", &coatings.inner), ("outer", &coatings.outer)] {
            self.add(format!("coatings.{name}.thickness"), coating.thickness);
            self.curve(name, &coating.curve);
        }
        if let Some(bare) = &coatings.bare {
            self.curve("bare", &bare.curve);
        }
        if let Some(transfer) = &coatings.transfer {
            self.add("coatings.transfer.cover", transfer.cover);
            self.add("coatings.transfer.wear.coefficient", transfer.wear.coefficient);
            self.add("coatings.transfer.wear.hardness", transfer.wear.hardness);
            self.curve("transfer", &transfer.curve);
        }
    }

    fn curve(&mut self, name: &str, curve: &CurveSpec) {
        let CurveSpec::Tested(points) = curve else { return };
        for (i, point) in points.iter().enumerate() {
            let path = format!("coatings.{name}.curve.Tested[{i}]");
            self.add(format!("{path}.pressure"), point.pressure);
            self.add(format!("{path}.peak_slip"), point.peak_slip);
            self.add(format!("{path}.peak_coefficient"), point.peak_coefficient);
            self.add(format!("{path}.residual_coefficient"), point.residual_coefficient);
        }
    }

    fn cage(&mut self, cage: &CageSpec) {
        self.add("cage.pocket_gap", cage.pocket_gap);
        self.add("cage.pocket_stiffness", cage.pocket_stiffness);
        self.add("cage.pocket_friction", cage.pocket_friction);
        self.add("cage.drag_torque", cage.drag_torque);
        self.add("cage.pocket_damping", cage.pocket_damping);
        if let Some(inertia) = cage.inertia {
            self.add("cage.inertia", inertia);
        }
        if let Some(form) = &cage.churning {
            self.add("cage.churning.bore", form.bore);
            self.add("cage.churning.outside", form.outside);
            self.add("cage.churning.width", form.width);
        }
        if let Some(film) = &cage.pocket_film {
            self.add("cage.pocket_film.roughness", film.roughness);
        }
        if let Some(land) = &cage.guidance {
            self.add("cage.guidance.radius", land.radius);
            self.add("cage.guidance.width", land.width);
            self.add("cage.guidance.gap", land.gap);
        }
        if let Some(free) = &cage.free {
            self.free_cage(free);
        }
    }

    fn free_cage(&mut self, cage: &FreeCageSpec) {
        self.add("cage.free.mass", cage.mass);
        self.add("cage.free.transverse_inertia", cage.transverse_inertia);
        for (k, value) in cage.gravity.into_iter().enumerate() {
            self.add(format!("cage.free.gravity[{k}]"), value);
        }
        if let PocketShape::RaceTrack { axial_gap } = cage.pockets {
            self.add("cage.free.pockets.RaceTrack.axial_gap", axial_gap);
        }
        for (k, land) in cage.lands.iter().enumerate() {
            let mut add = |name: &str, value| self.add(format!("cage.free.lands[{k}].{name}"), value);
            add("axial", land.axial);
            add("radius", land.radius);
            add("width", land.width);
            add("gap", land.gap);
            add("stiffness", land.stiffness);
            add("damping", land.damping);
            add("friction", land.friction);
            if let Some(film) = &land.film {
                add("film.viscosity", film.viscosity);
                add("film.density", film.density);
            }
        }
    }

    fn loads(&mut self, ring: &RingSpec, speed: &SpeedSpec) {
        for (name, translation) in [("x", &ring.x), ("y", &ring.y), ("z", &ring.z)] {
            match translation {
                Translation::Force(force) => self.add(format!("ring.{name}.Force"), *force),
                Translation::Held(place) => self.add(format!("ring.{name}.Held"), *place),
                Translation::ForceTable(rows) => self.table(&format!("ring.{name}.ForceTable"), rows),
            }
        }
        for (name, tilt) in [("tilt_x", &ring.tilt_x), ("tilt_y", &ring.tilt_y)] {
            match tilt {
                Tilt::Moment(moment) => self.add(format!("ring.{name}.Moment"), *moment),
                Tilt::Held(angle) => self.add(format!("ring.{name}.Held"), *angle),
                Tilt::MomentTable(rows) => self.table(&format!("ring.{name}.MomentTable"), rows),
            }
        }
        for (name, history) in [("inner", &speed.inner), ("outer", &speed.outer)] {
            if let SpeedHistory::Table(rows) = history {
                self.table(&format!("speed.{name}.Table"), rows);
            }
        }
    }

    fn table(&mut self, path: &str, rows: &[(f64, f64)]) {
        for (i, (time, value)) in rows.iter().enumerate() {
            self.add(format!("{path}[{i}][0]"), *time);
            self.add(format!("{path}[{i}][1]"), *value);
        }
    }

    fn transient(&mut self, case: &Case) {
        if let Some(SupportsSpec { inner, outer, .. }) = &case.supports {
            self.support("inner", inner);
            self.support("outer", outer);
        }
        self.deviations(case);
        for (i, spall) in case.spalls.iter().enumerate() {
            self.add(format!("spalls[{i}].azimuth"), spall.azimuth);
        }
        for (i, defect) in case.defects.iter().enumerate() {
            self.add(format!("defects[{i}].azimuth"), defect.azimuth);
        }
        if let Some(transient) = &case.transient {
            self.add("transient.duration", transient.duration);
            self.add("transient.wear_acceleration", transient.wear_acceleration);
            match transient.scheme {
                Scheme::RungeKutta4 { step } => self.add("transient.scheme.RungeKutta4.step", step),
                Scheme::Fast { step } => self.add("transient.scheme.Fast.step", step),
                Scheme::FastTo { accuracy } => self.add("transient.scheme.FastTo.accuracy", accuracy),
                Scheme::DormandPrince { longest, .. } => {
                    self.add("transient.scheme.DormandPrince.longest", longest);
                }
            }
        }
        if let Some(recording) = &case.recording {
            self.add("recording.state_rate", recording.state_rate);
            self.add("recording.ball_rate", recording.ball_rate);
        }
    }

    fn deviations(&mut self, case: &Case) {
        let Some(spec) = &case.deviations else { return };
        for (name, angle) in
            [("ball", spec.position.ball), ("inner", spec.position.inner), ("outer", spec.position.outer)]
        {
            self.add(format!("deviations.position.{name}"), angle);
        }
        for (name, race) in [("inner", &spec.inner), ("outer", &spec.outer)] {
            for (i, wave) in race.waves.iter().enumerate() {
                self.add(format!("deviations.{name}.waves[{i}].phase"), wave.phase);
            }
        }
        for (i, wave) in spec.ball_waves.waves.iter().enumerate() {
            self.add(format!("deviations.ball_waves.waves[{i}].phase"), wave.phase);
        }
    }

    fn support<const N: usize>(&mut self, name: &str, spec: &SupportSpec<N>) {
        self.add(format!("supports.{name}.mass"), spec.mass);
        for i in 0..N {
            self.add(format!("supports.{name}.stiffness[{i}]"), spec.stiffness[i]);
            self.add(format!("supports.{name}.damping[{i}]"), spec.damping[i]);
        }
    }

    fn first_out_of_bounds(self) -> Verdict {
        for (path, value) in self.0 {
            let Some(bound) = BOUNDS.iter().find(|bound| matches(bound.path, &path)) else { continue };
            let [low, high] = bound.range;
            if !(low..=high).contains(&value) {
                let unit = if bound.unit.is_empty() { String::new() } else { format!(" {}", bound.unit) };
                let [low, high] = [low, high].map(plain);
                let message = format!("must lie between {low} and {high}{unit}: {}", bound.reason);
                return Err(Refusal { path, message });
            }
        }
        Ok(())
    }
}

/// A limit as a person writes it: in full up to a million.
pub(super) fn plain(value: f64) -> String {
    if value == 0.0 || (1e-3..=1e6).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}

/// True if a path is one of a pattern's: `*` stands for a name or an index.
fn matches(pattern: &str, path: &str) -> bool {
    let (mut pattern, mut path) = (pattern.split(['.', '[']), path.split(['.', '[']));
    loop {
        match (pattern.next(), path.next()) {
            (None, None) => return true,
            (Some(p), Some(s)) if p == s || p == "*" || (p == "*]" && s.ends_with(']')) => {}
            _ => return false,
        }
    }
}

#[cfg(test)]
mod tests;
