//! The sections of a new case and the sources of their values.

use super::numbers::{MODERATE_SPEED, Numbers, STEEL};
use super::{NewCase, Sources, trim};
use crate::Origin;

const MODELLING: &str = "    modelling: (
        contact_at_actual_angle: false,
        ring_centre: Displaced,
        race_control: Outer,
        centrifugal_at_free_pitch: true,
    ),

";

pub(super) fn modelling(sources: &mut Sources) -> &'static str {
    sources.assumed(
        "modelling",
        "the usual choices of Jones-Harris programs; a displaced ring turns about its own centre",
    );
    MODELLING
}

pub(super) fn ball_sources(origin: &Origin, sources: &mut Sources) {
    match origin {
        Origin::Given => {
            sources.catalogue("geometry.ball_count", "as given");
            sources.catalogue("geometry.ball_diameter", "as given");
        }
        Origin::Published { source } => {
            sources.reference("geometry.ball_count", source);
            sources.reference("geometry.ball_diameter", source);
        }
        Origin::Ratings { dynamic, at_rest, next } => {
            let next = next.map_or_else(String::new, |next| {
                format!(
                    "; next best {} of {} mm, {:.1} % off",
                    next.ball_count,
                    trim(next.ball_diameter * 1e3, 3),
                    100.0 * next.deviation
                )
            });
            let why = format!(
                "the standard balls whose ratings by ISO 281 and ISO 76 come nearest to the catalogue's, {:+.1} % in C_r and {:+.1} % in C_0r{next}",
                100.0 * dynamic,
                100.0 * at_rest
            );
            sources.assumed("geometry.ball_count", &why);
            sources.assumed("geometry.ball_diameter", &why);
        }
        Origin::Thumb => {
            sources.assumed("geometry.ball_count", "rule of thumb: as many as can be put in; usual two more or fewer");
            sources.assumed(
                "geometry.ball_diameter",
                "rule of thumb: 0.3 of the outside diameter less the bore; usual 0.25 to 0.35",
            );
        }
    }
}

pub(super) fn materials(case: &NewCase, sources: &mut Sources) -> String {
    sources.reference(
        "materials",
        "bearing steel 100Cr6 (SAE 52100), usual handbook values: 200 to 212 GPa, 7750 to 7850 kg/m3",
    );
    let steel = format!("(young: GPa(208), poisson: 0.3, density: kg_per_m3({STEEL}))");
    let ceramic = "(young: GPa(310), poisson: 0.27, density: kg_per_m3(3200))";
    let hint = format!("        // Silicon nitride balls: {ceramic}.\n");
    let (hint, ball) = if case.ceramic_balls {
        let why = "silicon nitride, usual handbook values: 300 to 320 GPa, 3150 to 3300 kg/m3";
        sources.reference("materials.ball", why);
        (String::new(), ceramic)
    } else {
        (hint, steel.as_str())
    };
    format!(
        "    materials: (
{hint}        ball: {ball},
        inner: {steel},
        outer: {steel},
    ),

"
    )
}

/// A solid lubricant on both races, with wear.
pub(super) fn coating(name: &str, sources: &mut Sources) -> String {
    let coating = "a solid lubricant of the library. Films are 0.2 to 20 um thick";
    sources.assumed("coatings.inner", coating);
    sources.assumed("coatings.outer", coating);
    sources.assumed(
        "traction.slip_unit",
        "how steeply traction rises with slip; the tests do not tell, usual 20 to 100 per m/s",
    );
    sources.assumed(
        "traction.reference_pressure",
        "the lowest tested pressure; the tests go from 2.5 to 3.5 GPa, bearings usually run at 1 to 2.5",
    );
    sources.assumed("traction.patch", "accelerations and pocket forces settle at this error; 1e-3 for a quick look");
    sources.assumed("traction", "the fullest model: parameters that vary with pressure, and differential slip");
    sources.assumed("wear", "orders of magnitude: wear coefficients 1e-7 to 1e-4, silver 250 MPa, cage 60 to 200 MPa");
    format!(
        "    coatings: (
        inner: (curve: Library(\"{name}\"), thickness: um(2)),
        outer: (curve: Library(\"{name}\"), thickness: um(2)),
    ),

    traction: (
        slip_unit: Scaled(per_m_s: 22),
        order: 2,
        varying: true,
        reference_pressure: GPa(2.5),
        differential_slip: true,
        pressure: Peak,
        patch: TargetError(relative: 1e-5),
    ),

    // No `fluid`: the bearing runs in air, without drag and churning.

    wear: (
        inner: (coefficient: 1e-6, hardness: MPa(250)),
        outer: (coefficient: 1e-6, hardness: MPa(250)),
        cage: (coefficient: 1e-6, hardness: MPa(100)),
    ),

"
    )
}

pub(super) fn cage(numbers: &Numbers, oiled: bool, sources: &mut Sources) -> String {
    sources.assumed("cage.pocket_gap", "0.01 of the ball diameter; usual 0.005 to 0.03");
    sources.assumed("cage.pocket_stiffness", "a polymer pocket; usual 1 to 50 N/um, steel and brass the stiffest");
    sources.assumed("cage.pocket_friction", "dry or poorly lubricated; usual 0.05 to 0.2");
    sources.assumed("cage.drag_torque", "a cage that the balls alone guide, in air");
    sources.assumed(
        "cage.inertia",
        "a cage of glass-filled polyamide; mass times pitch radius squared, steel and brass up to six times as much",
    );
    sources
        .assumed("cage.pocket_damping", "loses a few percent of the speed in an impact of 0.1 m/s; usual 0.1 to 1 s/m");
    let film = if oiled {
        sources.assumed("cage.pocket_film.fill", "pockets full of oil");
        sources.assumed("cage.pocket_film.roughness", "a moulded pocket; usual 0.5 to 5 um");
        "        // The oil between balls and pockets.\n        pocket_film: (fill: 1, roughness: um(1)),\n"
    } else {
        ""
    };
    format!(
        "    cage: (
        pocket_gap: mm({}),
        pocket_stiffness: N_per_um(5),
        pocket_friction: 0.1,
        drag_torque: Nm(0),
        inertia: kg_m2({:e}),
        pocket_damping: s_per_m(0.5),
{film}    ),

",
        trim(numbers.pocket_gap * 1e3, 4),
        numbers.cage_inertia,
    )
}

pub(super) fn operation(case: &NewCase, numbers: &Numbers, sources: &mut Sources) -> String {
    let mut load = |path: &str, given: bool, share: f64| {
        if given {
            sources.reference(path, "as given");
        } else {
            let why = format!("a moderate load, {:.0} % of C_r; usual 1 to 20 %: put in your own", 100.0 * share);
            sources.assumed(path, &why);
        }
    };
    load("ring.x", case.radial_load.is_some(), numbers.radial_load / numbers.dynamic_rating);
    load("ring.z", case.axial_load.is_some(), numbers.axial_load / numbers.dynamic_rating);
    if case.speed.is_some() {
        sources.reference("speed.inner", "as given");
    } else {
        let why = format!(
            "moderate: pitch diameter times speed about {MODERATE_SPEED} mm r/min, grease allows some 500000: put in your own"
        );
        sources.assumed("speed.inner", &why);
    }
    sources.assumed("ring.y", "the radial load acts along x");
    sources.assumed("speed.outer", "a fixed outer ring");
    sources.assumed("ring.tilt_x", "aligned; usual misalignment 0.1 to 1 mrad");
    sources.assumed("ring.tilt_y", "aligned; usual misalignment 0.1 to 1 mrad");
    format!(
        "    // Loads on the inner ring: x and y radial, z axial, against the side on which the balls bear. The axial position
    // z = 0 is the one in which the balls just touch both races.
    ring: (
        x: Force(N({})),
        y: Force(N(0)),
        z: Force(N({})),
        tilt_x: Held(mrad(0)),
        tilt_y: Held(mrad(0)),
    ),

    speed: (
        inner: Constant(rpm({})),
        outer: Constant(rpm(0)),
    ),

",
        trim(numbers.radial_load, 3),
        trim(numbers.axial_load, 3),
        trim(numbers.speed_rpm, 3),
    )
}

/// Why states and balls are recorded as often as they are.
const RATES: &str = "twenty samples for each ball that passes, or more, and what the outer ring vibrates at within \
                     their pass band; every ball at a fifth of it";

pub(super) fn transient(numbers: &Numbers, dry: bool, sources: &mut Sources) -> String {
    sources.assumed("supports.inner", "a steel shaft of the bore, four diameters long, carried by the balls alone");
    sources.assumed(
        "supports.outer",
        "a housing twice as large on a support of 10 N/um for each mm of ball diameter; usual 50 to 1000 N/um, 2 to 10 % of critical damping",
    );
    sources.assumed(
        "transient.scheme",
        "the fast scheme with a step that errs by a thousandth of loads and torque; Fast(step: …) sets the step itself",
    );
    sources.assumed("transient.start", "from the equilibrium; a start from rest needs a table of speeds");
    sources.assumed("transient.wear_acceleration", "no wear: coatings hold much longer than a run");
    sources.assumed("transient.duration", "five turns of the shaft, enough to look at; means need some tens");
    let (contact_damping, why) = if dry {
        ("0.02", "steel on steel with a solid film; 0.005 to 0.1 change little")
    } else {
        let usual = "oil between steel: damping over stiffness of a contact some 2.5 us, usual 2.5 to 25 us \
                     (Krämer, Dynamics of Rotors and Foundations)";
        ("0.25", usual)
    };
    sources.assumed("transient.contact_damping", why);
    sources.assumed("recording", RATES);
    let [stiffness, damping] = numbers.support;
    let inner = trim(numbers.inner_damping, 3);
    format!(
        "    // From here on what a transient run needs besides: masses, springs and dampers of the rings.
    supports: (
        inner: (
            mass: kg({}),
            stiffness: (N_per_um(0), N_per_um(0), N_per_um(0)),
            damping: (N_s_per_m({inner}), N_s_per_m({inner}), N_s_per_m({inner})),
        ),
        outer: (
            mass: kg({}),
            stiffness: (N_per_um({k}), N_per_um({k})),
            damping: (N_s_per_m({c}), N_s_per_m({c})),
        ),
    ),

    transient: (
        duration: s({}),
        start: SteadyOrbit,
        scheme: FastTo(accuracy: 0.001),
        contact_damping: {contact_damping},
        wear_acceleration: 0,
    ),

    recording: (state_rate: kHz({}), ball_rate: kHz({})),

",
        trim(numbers.inner_mass, 4),
        trim(numbers.outer_mass, 4),
        trim(numbers.duration, 3),
        trim(numbers.state_rate_khz, 2),
        trim(numbers.state_rate_khz / 5.0, 3),
        k = trim(stiffness * 1e-6, 3),
        c = trim(damping, 3),
    )
}

pub(super) fn rating(case: &NewCase, numbers: &Numbers, sources: &mut Sources) -> String {
    let angle = trim(case.envelope.contact_angle.to_degrees(), 3);
    let mut fields = format!("        contact_angle: deg({angle}),\n");
    match case.ratings {
        Some(ratings) => {
            sources.catalogue("rating", case.source());
            let [dynamic, at_rest] = [ratings.dynamic, ratings.at_rest].map(|n| trim(n, 3));
            fields += &format!("        dynamic: N({dynamic}),\n        static_load: N({at_rest}),\n");
        }
        None => {
            sources.assumed(
                "rating",
                "the nominal angle; no ratings are given, so they are computed by ISO 281 and ISO 76",
            );
            fields += &format!(
                "        // From the catalogue: dynamic: N({:.0}), static_load: N(…). Left out, they are computed.\n",
                numbers.dynamic_rating
            );
        }
    }
    if let Some((class, why)) = case.lubricant().cleanliness() {
        sources.assumed("rating.cleanliness", why);
        fields += &format!("        cleanliness: {class},\n");
    }
    let [bore, outside] = [case.envelope.bore, case.envelope.outside].map(|d| trim(d * 1e3, 4));
    fields +=
        &format!("        // For SKF's friction torque.\n        bore: mm({bore}),\n        outside: mm({outside}),\n");
    if let Some(series) = series(case) {
        fields += &format!("        series: {series},\n");
    }
    format!(
        "    // For `tribodyn rating`: the nominal contact angle and the load ratings.\n    rating: (\n{fields}    ),\n\n"
    )
}

/// Series of a listed deep-groove bearing: its digits without those of the bore, of which three digits have one.
fn series(case: &NewCase) -> Option<String> {
    let name = case.designation.as_ref()?.trim_start_matches(|c: char| !c.is_ascii_digit());
    let digits: String = name.chars().take_while(char::is_ascii_digit).collect();
    let series = digits.get(..digits.len().checked_sub(if digits.len() == 3 { 1 } else { 2 })?)?;
    (case.source.is_some() && case.is_deep_groove() && !series.is_empty()).then(|| series.to_owned())
}
