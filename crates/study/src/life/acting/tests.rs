use super::*;
use tribodyn::Limits;

/// The paper's bearing with bare steel, a film from the cage, and a coarse patch rule.
fn case(changes: &[(&str, &str)]) -> CaseFile {
    let text = include_str!("../../../../../fixtures/cases/paper-handset.ron");
    let transfer = "(curve: Library(\"ptfe\"), cover: um(0.1), loss: 0.3, \
                    wear: (coefficient: 1e-6, hardness: MPa(60)))";
    let all = [
        ("traction.patch", "SplitStrip(across: 8, along: 3)"),
        ("coatings.bare", "(curve: Library(\"bare-440c\"))"),
        ("coatings.transfer", transfer),
    ];
    let changed = all
        .iter()
        .chain(changes)
        .fold(text.to_owned(), |text, (path, value)| tribodyn_case::set_value(&text, path, value).unwrap());
    CaseFile::from_text("test", changed, &[], &Limits::NORMAL).unwrap()
}

fn options(effects: &str, strides: u32, until_s: Option<f64>) -> ActingOptions {
    ActingOptions {
        effects: Effects::named(effects.split(',')).unwrap(),
        strides,
        until_s,
        bare_limit: 0.5,
        equations: Equations::Traction,
        watch: SearchWatch::default(),
    }
}

fn lived(file: &CaseFile, options: &ActingOptions) -> ActingLife {
    let mission = Mission::steady(file, &Limits::NORMAL).unwrap();
    acting_life(file, &mission, options, |_| ControlFlow::Continue(())).unwrap()
}

/// Rates that nothing changes: the worn volume is rate times time, the depth linear, and the first spot is through when
/// the closed form says.
#[test]
fn limit_a_state_on_which_wear_does_not_act_is_worn_linearly() {
    let life = lived(&case(&[]), &options("none", 10, None));
    let rows = &life.strides;
    let (first, through) = (&rows[0], life.first_through.as_ref().unwrap());
    for row in rows {
        let seconds = row.time_h * HOUR;
        let expected = first.wear_rate_inner_um3_s * seconds * 1e-9;
        assert!((row.worn_inner_mm3 - expected).abs() <= 1e-10 * expected, "{} {expected}", row.worn_inner_mm3);
        let linear = 10.0 * (1.0 - row.time_h / through.time_h).max(0.0);
        let left = if through.race == "inner" { row.coating_inner_min_um } else { row.coating_outer_min_um };
        assert!((left - linear).abs() < 1e-8, "{left} {linear}");
    }
    assert_eq!(life.ended_by, LifeEnd::WornThrough);
    assert!(rows.last().unwrap().unlubricated_inner.max(rows.last().unwrap().unlubricated_outer) >= 0.5);
    for (field, worn) in
        life.fields.iter().zip([rows.last().unwrap().worn_inner_mm3, rows.last().unwrap().worn_outer_mm3])
    {
        assert!((field.integral() * MM3 / worn - 1.0).abs() < 1e-10);
    }
}

/// Every volume is accounted for in every stride, whatever acts, and shares of the load add up to one.
#[test]
fn identity_volumes_balance_while_everything_acts() {
    let life = lived(&case(&[]), &options("clearance,curvature,traction,transfer", 8, Some(25.0)));
    assert!(life.strides.len() > 3);
    let mut last = 0.0;
    for row in &life.strides {
        let gap = row.scraped_mm3 - row.film_mm3 - row.lost_mm3;
        assert!(gap.abs() <= 1e-10 * row.scraped_mm3.max(1e-12), "{gap}");
        let inner = row.precoated_inner + row.self_lubricated + row.unlubricated_inner;
        let outer = row.precoated_outer + row.self_lubricated + row.unlubricated_outer;
        assert!((inner - 1.0).abs() < 1e-12 && (outer - 1.0).abs() < 1e-12);
        assert!(row.scraped_mm3 >= last);
        last = row.scraped_mm3;
    }
    let end = life.strides.last().unwrap();
    assert!((end.time_h * HOUR - 25.0).abs() < 1e-6 && end.self_lubricated > 0.0);
    for (field, worn) in life.fields.iter().zip([end.worn_inner_mm3, end.worn_outer_mm3]) {
        assert!((field.integral() * MM3 / worn - 1.0).abs() < 1e-10);
    }
}

/// Each effect by itself moves what it is about, and a film makes the coating last longer.
#[test]
fn identity_effects_act_one_by_one() {
    let file = case(&[("coatings.inner.worn", "0.5")]);
    let end = |effects: &str| {
        let life = lived(&file, &options(effects, 4, Some(10.0)));
        life.strides.last().unwrap().clone()
    };
    let none = end("none");
    let clearance = end("clearance");
    assert!(clearance.contact_angle_free_deg > none.contact_angle_free_deg + 0.1);
    let curvature = end("curvature");
    assert_eq!(curvature.contact_angle_free_deg, none.contact_angle_free_deg);
    // A profile that is deeper in the middle conforms more and lowers the pressure, one with a ridge raises it.
    let change = curvature.peak_pressure_inner_max_gpa - none.peak_pressure_inner_max_gpa;
    assert!(change.abs() > 1e-3 && change * curvature.profile_curvature_inner_per_m < 0.0, "{change} {curvature:?}");
    let transfer = end("transfer");
    assert!(transfer.self_lubricated > 0.01 && none.self_lubricated == 0.0);
    assert!(transfer.worn_inner_mm3 < none.worn_inner_mm3);
    let gone = case(&[("coatings.inner.worn", "0.97"), ("coatings.outer.worn", "0.97")]);
    let power = |effects: &str| {
        let life = lived(&gone, &ActingOptions { bare_limit: 1.0, ..options(effects, 4, Some(1e-3)) });
        life.strides.last().unwrap().friction_races_w
    };
    assert!(power("traction") > 1.05 * power("none"), "{} {}", power("traction"), power("none"));
}

/// A mission that is one phase twice is that phase; whole cycles and single phases agree.
#[test]
fn identity_a_mission_of_equal_phases_is_the_steady_life() {
    let file = case(&[]);
    let table = "s, ring.z.Force\n0.5, kN(30)\n1.5, kN(30)\n";
    let steady = lived(&case(&[("ring.z.Force", "kN(30)")]), &options("clearance", 5, Some(20.0)));
    let mission = Mission::read(table, &file, &Limits::NORMAL).unwrap();
    assert!((mission.cycle_s() - 2.0).abs() < 1e-12 && mission.phases[1].name == "2 kN(30)");
    let cycled =
        acting_life(&file, &mission, &options("clearance", 5, Some(20.0)), |_| ControlFlow::Continue(())).unwrap();
    let (a, b) = (steady.strides.last().unwrap(), cycled.strides.last().unwrap());
    assert!((a.worn_inner_mm3 / b.worn_inner_mm3 - 1.0).abs() < 5e-3, "{} {}", a.worn_inner_mm3, b.worn_inner_mm3);
    assert!((a.revolutions / b.revolutions - 1.0).abs() < 1e-9);
}

#[test]
fn limit_what_makes_no_mission_is_refused_with_its_line() {
    let file = case(&[]);
    let refused = |table: &str| Mission::read(table, &file, &Limits::NORMAL).err().unwrap().to_string();
    assert!(refused("x, ring.z.Force\n1, kN(30)\n").contains("allowed is s, min or h"));
    assert!(refused("s, ring.z.Force\n-1, kN(30)\n").contains("line 2"));
    assert!(refused("s, ring.z.Force\n1\n").contains("line 2"));
    assert!(refused("# nothing\ns, ring.z.Force\n").contains("no phase"));
    assert!(refused("s, ring.z.Force\n1, kN(30)\n\n2, mm(3)\n").contains("line 4"));
    assert!(Effects::named(["friction"]).is_err());
}

/// A life that is stopped at each of some strides and begun again ends as one that goes through.
#[test]
fn identity_a_stopped_life_goes_on_to_the_same_strides() {
    let (file, options) = (case(&[]), options("clearance,traction,transfer", 5, Some(40.0)));
    let mission = Mission::steady(&file, &Limits::NORMAL).unwrap();
    let whole = lived(&file, &options);
    let folder = std::env::temp_dir().join(format!("tribodyn-acting-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("life.csv");
    for stop in [1, 3] {
        let mut table = ActingTable::open(&file, &mission, &options, (&path, false)).unwrap();
        let mut seen = table.finished_strides();
        let stopped = table.wear(|_| {
            seen += 1;
            if seen > stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert_eq!(stopped.unwrap().ended_by, LifeEnd::Stopped);
    }
    let other = ActingOptions { bare_limit: 0.25, ..options.clone() };
    let refused = ActingTable::open(&file, &mission, &other, (&path, false)).err().unwrap().to_string();
    assert!(refused.contains("--bare-limit"), "{refused}");
    let mut table = ActingTable::open(&file, &mission, &options, (&path, false)).unwrap();
    assert_eq!(table.finished_strides(), 3);
    let life = table.wear(|_| ControlFlow::Continue(())).unwrap();
    assert_eq!(life.strides, whole.strides);
    assert_eq!((life.fields.clone(), &life.first_through), (whole.fields, &whole.first_through));
    table.write(&life).unwrap();
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1);
    std::fs::remove_dir_all(&folder).unwrap();
}
