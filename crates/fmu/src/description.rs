//! `modelDescription.xml` by FMI 2.0.5, section 2.2.

use crate::table::{CHOICES, Causality, Kind, UNITS, VARIABLES, Variable};
use crate::{Fmu, SOURCES};
use std::fmt::Write;

/// Abilities of a model whose outputs follow from its inputs of the moment.
const KINDS: [(&str, &str); 2] =
    [("ModelExchange", ""), ("CoSimulation", " canHandleVariableCommunicationStepSize=\"true\"")];

pub fn text(fmu: &Fmu) -> String {
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let name = escaped(&fmu.name);
    let _ = writeln!(
        out,
        "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"{name}\" guid=\"{}\" \
         description=\"Ball bearing {name}: forces from displacements, by raceway control\" \
         generationTool=\"tribodyn {}\" variableNamingConvention=\"flat\" numberOfEventIndicators=\"0\">",
        fmu.guid,
        env!("CARGO_PKG_VERSION"),
    );
    KINDS.iter().for_each(|kind| put_kind(&mut out, kind, &fmu.identifier));
    put_units(&mut out);
    put_choices(&mut out);
    out.push_str(
        "  <LogCategories>\n    <Category name=\"logStatusDiscard\"/>\n    <Category name=\"logStatusError\"/>\n",
    );
    out.push_str("  </LogCategories>\n  <ModelVariables>\n");
    for (reference, (variable, start)) in VARIABLES.iter().zip(&fmu.starts).enumerate() {
        put_variable(&mut out, reference, variable, *start);
    }
    out.push_str("  </ModelVariables>\n  <ModelStructure>\n");
    put_outputs(&mut out);
    out.push_str("  </ModelStructure>\n</fmiModelDescription>\n");
    out
}

fn put_kind(out: &mut String, (kind, more): &(&str, &str), identifier: &str) {
    let _ = writeln!(
        out,
        "  <{kind} modelIdentifier=\"{identifier}\"{more} canGetAndSetFMUstate=\"true\" \
         canSerializeFMUstate=\"true\">\n    \
         <SourceFiles>"
    );
    let compiled = SOURCES.iter().map(|(name, _)| name).filter(|name| name.ends_with(".c"));
    compiled.for_each(|name| _ = writeln!(out, "      <File name=\"{name}\"/>"));
    let _ = writeln!(out, "    </SourceFiles>\n  </{kind}>");
}

fn put_units(out: &mut String) {
    out.push_str("  <UnitDefinitions>\n");
    for (name, exponents) in UNITS {
        let _ = write!(out, "    <Unit name=\"{name}\"><BaseUnit");
        for (base, exponent) in ["kg", "m", "s", "rad"].iter().zip(exponents).filter(|(_, exponent)| *exponent != 0) {
            let _ = write!(out, " {base}=\"{exponent}\"");
        }
        out.push_str("/></Unit>\n");
    }
    out.push_str("  </UnitDefinitions>\n");
}

fn put_choices(out: &mut String) {
    out.push_str("  <TypeDefinitions>\n");
    for choice in CHOICES {
        let _ = writeln!(out, "    <SimpleType name=\"{}\">\n      <Enumeration>", choice.name);
        for (index, item) in choice.items.iter().enumerate() {
            let _ = writeln!(out, "        <Item name=\"{item}\" value=\"{}\"/>", index + 1);
        }
        out.push_str("      </Enumeration>\n    </SimpleType>\n");
    }
    out.push_str("  </TypeDefinitions>\n");
}

fn put_variable(out: &mut String, reference: usize, variable: &Variable, start: f64) {
    let (causality, variability, initial) = match variable.causality {
        Causality::Input => ("input", "continuous", ""),
        Causality::Output => ("output", "continuous", " initial=\"calculated\""),
        Causality::Parameter => ("parameter", "fixed", " initial=\"exact\""),
    };
    let _ = write!(
        out,
        "    <ScalarVariable name=\"{}\" valueReference=\"{reference}\" description=\"{}\" causality=\"{causality}\" \
         variability=\"{variability}\"{initial}>",
        variable.name, variable.description,
    );
    // A number that reads back to the last bit, in the form of XML Schema.
    let given = |value: String| match variable.causality {
        Causality::Output => String::new(),
        Causality::Input | Causality::Parameter => format!(" start=\"{value}\""),
    };
    let _ = match variable.kind {
        Kind::Real("") => write!(out, "<Real{}/>", given(format!("{start:e}"))),
        Kind::Real(unit) => write!(out, "<Real unit=\"{unit}\"{}/>", given(format!("{start:e}"))),
        Kind::Integer => write!(out, "<Integer{}/>", given(format!("{start:.0}"))),
        Kind::Boolean => write!(out, "<Boolean{}/>", given((start != 0.0).to_string())),
        Kind::Enumeration(choice) => {
            write!(out, "<Enumeration declaredType=\"{}\"{}/>", choice.name, given(format!("{start:.0}")))
        }
    };
    out.push_str("</ScalarVariable>\n");
}

/// Each output follows from all inputs, at the start too.
fn put_outputs(out: &mut String) {
    for element in ["Outputs", "InitialUnknowns"] {
        let _ = writeln!(out, "    <{element}>");
        let outputs = VARIABLES.iter().enumerate().filter(|(_, v)| v.causality == Causality::Output);
        outputs.for_each(|(index, _)| _ = writeln!(out, "      <Unknown index=\"{}\"/>", index + 1));
        let _ = writeln!(out, "    </{element}>");
    }
}

fn escaped(text: &str) -> String {
    let legal = text.chars().filter(|c| !c.is_control());
    legal.fold(String::new(), |mut out, c| {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            other => out.push(other),
        }
        out
    })
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn limit_names_cannot_leave_their_attribute() {
        assert_eq!(escaped("a \"b\" <c> & d\n"), "a &quot;b&quot; &lt;c&gt; &amp; d");
    }
}
