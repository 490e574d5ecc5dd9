//! `model.h`: the numbers of one bearing for its C sources.

use crate::Fmu;
use crate::table::{Causality, Kind, VARIABLES};
use std::fmt::Write;

pub fn text(fmu: &Fmu) -> String {
    let mut out = String::from("/* The variables of the model and their values at the start. */\n");
    out.push_str("#ifndef TRIBODYN_MODEL_H\n#define TRIBODYN_MODEL_H\n\n");
    let _ = writeln!(out, "#define MODEL_GUID \"{}\"\n\nenum {{", fmu.guid);
    VARIABLES.iter().for_each(|v| _ = writeln!(out, "    {},", v.name.to_ascii_uppercase()));
    out.push_str("    VARIABLES\n};\n\nstatic const double START[VARIABLES] = {\n");
    for (variable, start) in VARIABLES.iter().zip(&fmu.starts) {
        let _ = writeln!(out, "    {start:e}, /* {} */", variable.name);
    }
    let causality: String = VARIABLES.iter().map(|v| letter_of_causality(v.causality)).collect();
    let kind: String = VARIABLES.iter().map(|v| letter_of_kind(v.kind)).collect();
    out.push_str("};\n\n/* i input, o output, p parameter. */\n");
    let _ = writeln!(out, "static const char CAUSALITY[] = \"{causality}\";");
    out.push_str("/* r real, i integer or enumeration, b boolean. */\n");
    let _ = writeln!(out, "static const char TYPE[] = \"{kind}\";\n\n#endif");
    out
}

fn letter_of_causality(causality: Causality) -> char {
    match causality {
        Causality::Input => 'i',
        Causality::Output => 'o',
        Causality::Parameter => 'p',
    }
}

fn letter_of_kind(kind: Kind) -> char {
    match kind {
        Kind::Real(_) => 'r',
        Kind::Integer | Kind::Enumeration(_) => 'i',
        Kind::Boolean => 'b',
    }
}
