//! Compiles the `.proto` files into Rust structs and into the descriptor sets that the recording embeds, so that
//! the two cannot disagree. `protox` is a compiler written in Rust: nothing has to be installed.

use prost::Message;
use std::{env, error::Error, fs, path::PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=proto");
    let out = PathBuf::from(env::var("OUT_DIR")?);
    for name in ["foxglove", "tribodyn"] {
        let mut set = protox::compile([format!("{name}.proto")], ["proto"])?;
        prost_build::Config::new().compile_fds(set.clone())?;
        // Readers of the file need the types; the comments have done their work in the generated docs.
        for file in &mut set.file {
            file.source_code_info = None;
        }
        fs::write(out.join(format!("{name}.binpb")), set.encode_to_vec())?;
    }
    Ok(())
}
