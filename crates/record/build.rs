//! Compiles the `.proto` files into Rust structs and into the descriptor sets that the recording embeds, so that
//! the two cannot disagree. `protox` is a compiler written in Rust: nothing has to be installed.

use prost::Message;
use prost_types::field_descriptor_proto::{Label, Type};
use prost_types::{DescriptorProto, FileDescriptorSet};
use std::fmt::Write;
use std::{env, error::Error, fs, path::PathBuf};

/// Messages whose numbers are filled and read by their names.
const BY_NAME: [&str; 3] = ["Ball", "BearingState", "TransientState"];

/// The message of which there are the most.
const OFTEN: &str = "Ball";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=proto");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    for name in ["foxglove", "tribodyn"] {
        let mut set = protox::compile([format!("{name}.proto")], ["proto"])?;
        prost_build::Config::new().compile_fds(set.clone())?;
        fs::write(out.join(format!("{name}_numbers.rs")), numbers(&set)?)?;
        // Readers of the file need the types; the comments have done their work in the generated docs.
        for file in &mut set.file {
            file.source_code_info = None;
        }
        fs::write(out.join(format!("{name}.binpb")), set.encode_to_vec())?;
    }
    Ok(())
}

/// Access to the numbers of some messages by their places in a list of names.
fn numbers(set: &FileDescriptorSet) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let messages = set.file.iter().flat_map(|file| &file.message_type);
    for message in messages.filter(|message| BY_NAME.contains(&message.name())) {
        implementation(message, &mut text)?;
    }
    let messages = set.file.iter().flat_map(|file| &file.message_type);
    for message in messages.filter(|message| message.name() == OFTEN) {
        flat(message, &mut text)?;
    }
    Ok(text)
}

/// Encoding of a message of single numbers, the same bytes as the generated structure makes, with the keys worked out
/// here.
fn flat(message: &DescriptorProto, text: &mut String) -> std::fmt::Result {
    writeln!(text, "impl super::Flat for super::tribodyn::{} {{", message.name())?;
    writeln!(text, "fn put(&self, out: &mut Vec<u8>) {{")?;
    for field in &message.field {
        let (name, number) = (field.name(), field.number() as u64);
        let key = |wire: u64| {
            let mut key = Vec::new();
            prost::encoding::encode_varint(number << 3 | wire, &mut key);
            key
        };
        match field.r#type() {
            Type::Float | Type::Double => {
                let key = key(if field.r#type() == Type::Float { 5 } else { 1 });
                writeln!(text, "if self.{name} != 0.0 {{ super::put(out, &{key:?}, &self.{name}.to_le_bytes()); }}")?;
            }
            Type::Uint32 | Type::Bool | Type::Enum => {
                let key = key(0);
                writeln!(
                    text,
                    "if self.{name} as u64 != 0 {{ super::put_varint(out, &{key:?}, self.{name} as u64); }}"
                )?;
            }
            other => panic!("{name} is {other:?}: only single numbers are encoded here"),
        }
    }
    writeln!(text, "}} }}")
}

fn implementation(message: &DescriptorProto, text: &mut String) -> std::fmt::Result {
    let single = message.field.iter().filter(|field| field.label() != Label::Repeated);
    let numbers: Vec<(&str, &str)> = single
        .filter_map(|field| match field.r#type() {
            Type::Float => Some((field.name(), "f32")),
            Type::Double => Some((field.name(), "f64")),
            _ => None,
        })
        .collect();
    writeln!(text, "impl super::Numbers for super::tribodyn::{} {{", message.name())?;
    writeln!(text, "const NAMES: &'static [&'static str] = &{:?};", numbers.iter().map(|n| n.0).collect::<Vec<_>>())?;
    writeln!(text, "fn number(&self, place: usize) -> f64 {{ match place {{")?;
    for (place, (name, _)) in numbers.iter().enumerate() {
        writeln!(text, "{place} => self.{name} as f64,")?;
    }
    writeln!(text, "_ => f64::NAN }} }}")?;
    writeln!(text, "fn set_number(&mut self, place: usize, value: f64) {{ match place {{")?;
    for (place, (name, kind)) in numbers.iter().enumerate() {
        writeln!(text, "{place} => self.{name} = value as {kind},")?;
    }
    writeln!(text, "_ => {{}} }} }}")?;
    writeln!(text, "fn set_numbers(&mut self, value: impl Fn(usize) -> Option<f64>) {{")?;
    for (place, (name, kind)) in numbers.iter().enumerate() {
        writeln!(text, "if let Some(value) = value({place}) {{ self.{name} = value as {kind}; }}")?;
    }
    let finite: Vec<String> = numbers.iter().map(|(name, _)| format!("self.{name}.is_finite()")).collect();
    writeln!(text, "}} fn are_finite(&self) -> bool {{ {} }} }}", finite.join(" & "))
}
