//! `cargo xtask web`: the page in the browser.

use crate::built;
use crate::error::Failure;
use crate::page::{self, Checked};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tribodyn_paper::{PaperError, files};

/// Build the page into target/web; with --serve, at an address of this machine
#[derive(clap::Args)]
pub struct Arguments {
    /// Serve it until Ctrl-C, by Python
    #[arg(long)]
    serve: bool,
    /// Port of the address
    #[arg(long, value_name = "N", default_value_t = 8000)]
    port: u16,
}

const FOLDER: &str = "target/web";
/// Apart from other builds: what it takes of the standard library and of macros is not theirs.
const BUILD: &str = "target/web-build";
const TARGET: &str = "wasm32-unknown-unknown";
const MODULE: &str = "tribodyn.wasm.gz";
const SOURCES: &str = "crates/web/page";
const SCRIPT: &str = "xtask/checks/web_page.py";
/// Largest page, bytes.
const MOST: u64 = 3_000_000;

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Checked::Skipped(reason) = build()? {
        return Err(Failure::Check { what: "no page", findings: vec![reason] });
    }
    if !arguments.serve {
        println!("open it by `cargo xtask web --serve`: browsers run no modules from a file");
        return Ok(());
    }
    println!("http://127.0.0.1:{}/", arguments.port);
    let mut python = Command::new("python3");
    python.args(["-m", "http.server", "--bind", "127.0.0.1", "--directory", FOLDER]).arg(arguments.port.to_string());
    page::finished(python.current_dir(files::root()), "python3", "http.server")
}

/// The module and its page in [`FOLDER`]; skipped where nothing compiles for WebAssembly.
pub fn build() -> Result<Checked, Failure> {
    let Some(mut cargo) = compiler() else {
        let reason = format!(
            "no compiler for {TARGET}: neither rustup's target nor Debian's rustc-web, cargo-web, rust-web-src and lld"
        );
        return Ok(Checked::Skipped(reason));
    };
    cargo.current_dir(files::root()).env("CARGO_TARGET_DIR", files::root().join(BUILD));
    // Vectors of 128 bits, which browsers have since 2023.
    cargo.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", "-C target-feature=+simd128");
    cargo.args(["--profile", "web", "--package", "tribodyn-web", "--target", TARGET]);
    page::finished(&mut cargo, "cargo", "cargo build --package tribodyn-web")?;
    let folder = files::root().join(FOLDER);
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| Failure::from(PaperError::Write { path, source })
    };
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(failed(&folder))?;
    }
    fs::create_dir_all(&folder).map_err(failed(&folder))?;
    // The worker unpacks it: static servers need not.
    let module = files::root().join(BUILD).join(TARGET).join("web/tribodyn_web.wasm");
    let mut gzip = Command::new("gzip");
    page::finished(gzip.args(["--best", "--no-name", "--force", "--keep"]).arg(&module), "gzip", "gzip")?;
    let mut parts: Vec<(PathBuf, PathBuf)> = vec![(module.with_extension("wasm.gz"), folder.join(MODULE))];
    let sources = files::root().join(SOURCES);
    for entry in fs::read_dir(&sources).map_err(failed(&sources))? {
        let entry = entry.map_err(failed(&sources))?;
        parts.push((entry.path(), folder.join(entry.file_name())));
    }
    let mut bytes = 0;
    for (from, to) in &parts {
        bytes += fs::copy(from, to).map_err(failed(to))?;
    }
    println!("{FOLDER}: {} files, {:.2} MB", parts.len(), bytes as f64 * 1e-6);
    if bytes > MOST {
        return Err(Failure::Check {
            what: "the page is too large",
            findings: vec![format!("{bytes} of {MOST} bytes")],
        });
    }
    Ok(Checked::Passed)
}

/// A `cargo build` for the target: by rustup where it has the target, else by Debian's compiler, which builds the
/// standard library from its sources.
fn compiler() -> Option<Command> {
    let listed = Command::new("rustup").args(["target", "list", "--installed"]).output();
    if listed.is_ok_and(|listed| String::from_utf8_lossy(&listed.stdout).lines().any(|line| line == TARGET)) {
        let mut cargo = Command::new(built::cargo_program());
        cargo.arg("build");
        return Some(cargo);
    }
    let sysroot = Command::new("/usr/bin/rustc").args(["--print", "sysroot"]).output().ok()?;
    let library = Path::new(String::from_utf8_lossy(&sysroot.stdout).trim()).join("lib/rustlib/src/rust/library");
    if !(library.is_dir() && Path::new("/usr/bin/cargo").exists() && page::answers("wasm-ld")) {
        return None;
    }
    let mut cargo = Command::new("/usr/bin/cargo");
    cargo.args(["build", "-Zbuild-std=std,panic_abort"]);
    // That option is not a stable one; the toolchain of this program is another one.
    cargo.env("RUSTC_BOOTSTRAP", "1").env("RUSTC", "/usr/bin/rustc").env_remove("RUSTUP_TOOLCHAIN");
    cargo.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", "wasm-ld");
    Some(cargo)
}

/// Types bearings into the page in a browser, and holds its numbers against the command's.
pub fn check() -> Result<Checked, Failure> {
    let folder = files::root().join(FOLDER);
    if !folder.join(MODULE).exists() {
        return Ok(Checked::Skipped(format!("no page in {FOLDER}: the step `wasm32` builds it")));
    }
    let browser = match page::browser() {
        Ok(browser) => browser,
        Err(reason) => return Ok(Checked::Skipped(reason)),
    };
    let mut python = Command::new("python3");
    python.arg(files::root().join(SCRIPT)).arg(&folder).args(["--browser", &browser]);
    python.arg("--command").arg(built::programs()?.join("tribodyn"));
    page::finished(python.current_dir(files::root()), "python3", SCRIPT)?;
    Ok(Checked::Passed)
}
