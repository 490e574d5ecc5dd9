//! Opening table of a report: the run or solution that it is about.

use super::Answer;
use super::page_table::Table;
use super::values::readable;
use crate::words::number;
use tribodyn::CaseFile;
use tribodyn_case::locate;
use tribodyn_record::Run;
use tribodyn_study::evaluation::facts::said;

fn row(name: &str, value: impl Into<String>) -> Vec<String> {
    vec![name.to_owned(), value.into()]
}

fn table(title: &str, rows: Vec<Vec<String>>) -> Table {
    Table { title: title.to_owned(), text: String::new(), header: vec!["", "Value"], rows, numbers: 0..0, wide: true }
}

/// Of a run.
pub fn of_run(answer: &Answer, case: Option<&CaseFile>, run: &Run) -> Table {
    let mut rows = of_case(&answer.bearing, case, run);
    let s = &answer.summary;
    let wanted = said(run, "duration_s").map_or_else(String::new, |wanted| format!(" of {wanted} s"));
    rows.push(row("Duration", format!("{} s{wanted}", number(s.simulated_s, 6))));
    if let Some(file) = case {
        rows.extend(
            [("Scheme", "transient.scheme"), ("Start", "transient.start")]
                .into_iter()
                .filter_map(|(name, path)| Some(row(name, described(&file.text, path)?))),
        );
    }
    if let Some(step) = answer.known.step_s {
        rows.push(row("Step taken", format!("{} µs", number(step * 1e6, 3))));
    }
    if let Some(choice) = answer.known.step_choice {
        let found = format!("{:.1e} of loads and torque, {:.1e} asked for", choice.errors.worst(), choice.accuracy);
        rows.push(row("Error of the step", found + if choice.scatters { "; shorter steps are no better" } else { "" }));
    }
    if let Some(error) = answer.acceleration_error() {
        rows.push(row("Error of accelerations, rms", format!("{error:.1e} m/s²")));
    }
    rows.push(row("Samples", format!("{} of rings and cage, {} of the balls", run.states.len(), run.balls.len())));
    if let Some(error) = answer.known.patch_error_estimate {
        rows.push(row("Patch error estimate", format!("{error:.1e} of the load")));
    }
    rows.extend(of_file(&answer.generator, &answer.recording.display().to_string()));
    table("What was run", rows)
}

/// Of a solution.
pub fn of_solution(bearing: &str, case: Option<&CaseFile>, run: &Run, (generator, recording): (&str, &str)) -> Table {
    let mut rows = of_case(bearing, case, run);
    let entries = [
        ("Model", "model"),
        ("Converged", "converged"),
        ("Largest relative residual", "residual"),
        ("Newton steps", "iterations"),
    ];
    rows.extend(entries.into_iter().filter_map(|(name, key)| Some(row(name, said(run, key)?))));
    rows.extend(of_file(generator, recording));
    table("What was solved", rows)
}

fn of_file(generator: &str, recording: &str) -> [Vec<String>; 2] {
    [row("Program", generator), row("Recording", recording)]
}

/// Bearing and operating point.
fn of_case(bearing: &str, case: Option<&CaseFile>, run: &Run) -> Vec<Vec<String>> {
    let mut rows = vec![row("Bearing", bearing)];
    let meta = |key: &str| said(run, key).unwrap_or("–");
    let rounded = |key: &str, digits| {
        said(run, key).and_then(|text| text.parse().ok()).map_or("–".to_owned(), |value| number(value, digits))
    };
    rows.push(row(
        "Balls",
        format!(
            "{} of {} mm on a pitch circle of {} mm, free contact angle {}°",
            meta("ball_count"),
            rounded("ball_diameter_mm", 3),
            rounded("pitch_diameter_mm", 3),
            rounded("free_contact_angle_deg", 4)
        ),
    ));
    let Some(file) = case else { return rows };
    let text = |path: &str| described(&file.text, path).unwrap_or_else(|| "–".to_owned());
    let each = |paths: &[(&str, &str)]| {
        paths.iter().map(|(name, path)| format!("{name}: {}", text(path))).collect::<Vec<_>>().join(", ")
    };
    rows.push(row("Loads", each(&[("X", "ring.x"), ("Y", "ring.y"), ("Z (axial)", "ring.z")])));
    rows.push(row("Tilts", each(&[("about X", "ring.tilt_x"), ("about Y", "ring.tilt_y")])));
    rows.push(row("Speeds", each(&[("inner ring", "speed.inner"), ("outer ring", "speed.outer")])));
    for (name, race) in [("Coating, inner race", "inner"), ("Coating, outer race", "outer")] {
        let [curve, thick] = ["curve", "thickness"].map(|field| text(&format!("coatings.{race}.{field}")));
        rows.push(row(name, format!("{curve}, {thick} thick")));
    }
    let fluid = described(&file.text, "fluid.medium");
    rows.push(row("Fluid", fluid.unwrap_or_else(|| "none: no drag, no churning".to_owned())));
    let lists = [
        ("Defects", "defects", file.case.defects.len(), ["race", "azimuth", "width", "depth"]),
        ("Spalls", "spalls", file.case.spalls.len(), ["race", "azimuth", "length", "depth"]),
        ("Spalls of balls", "ball_spalls", file.case.ball_spalls.len(), ["ball", "angle", "length", "depth"]),
    ];
    for (name, list, count, fields) in lists.into_iter().filter(|(_, _, count, _)| *count > 0) {
        let one = |k| {
            let paths = fields.map(|field| (field, format!("{list}[{k}].{field}")));
            each(&paths.each_ref().map(|(field, path)| (*field, path.as_str())))
        };
        rows.push(row(name, (0..count).map(one).collect::<Vec<_>>().join("; ")));
    }
    let deviations = ["deviations.inner", "deviations.outer", "deviations.balls", "deviations.ball_waves"];
    let deviations: Vec<String> = deviations
        .iter()
        .filter_map(|path| Some(format!("{}: {}", path.rsplit('.').next()?, described(&file.text, path)?)))
        .collect();
    if !deviations.is_empty() {
        rows.push(row("Deviations", deviations.join("; ")));
    }
    rows
}

/// The value at a path as a person writes it, also where it has named fields.
fn described(text: &str, path: &str) -> Option<String> {
    let value = &text[locate(text, path)?];
    let fields = |(name, rest): (&str, &str)| {
        let inner = rest.strip_suffix(')')?;
        if inner.contains('[') && inner.contains(':') {
            return Some(format!("{}, see the values of the case", name.trim()));
        }
        let named = |part: &str| {
            let (key, value) = part.split_once(':')?;
            Some(format!("{} {}", key.trim().replace('_', " "), readable(value)))
        };
        let parts: Option<Vec<String>> = inner.split(',').filter(|p| !p.trim().is_empty()).map(named).collect();
        Some(format!("{}, {}", name.trim(), parts?.join(", ")))
    };
    Some(value.split_once('(').and_then(fields).unwrap_or_else(|| readable(value)))
}

#[cfg(test)]
mod tests {
    use super::described;

    #[test]
    fn limit_values_with_fields_are_described_too() {
        let text =
            "(a: RungeKutta4(step: us(2.5)), b: Nitrogen(temperature: K(87.5), pressure: MPa(4)), c: Force(kN(3)))";
        assert_eq!(described(text, "a").as_deref(), Some("RungeKutta4, step 2.5 µs"));
        assert_eq!(described(text, "b").as_deref(), Some("Nitrogen, temperature 87.5 K, pressure 4 MPa"));
        assert_eq!(described(text, "c").as_deref(), Some("force 3 kN"));
        assert_eq!(described(text, "d"), None);
        let tested = described("(a: Tested([(pressure: GPa(2.5), peak_slip: 1)]))", "a");
        assert_eq!(tested.as_deref(), Some("Tested, see the values of the case"));
    }
}
