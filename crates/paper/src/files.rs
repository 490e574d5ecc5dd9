//! Files of the workspace.

use crate::error::PaperError;
use std::fs;
use std::path::{Path, PathBuf};

/// The workspace's root folder.
pub fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).unwrap_or(package).to_owned()
}

/// Reads a text file.
///
/// # Errors
///
/// No such file, no permission, no UTF-8.
pub fn read(path: &Path) -> Result<String, PaperError> {
    fs::read_to_string(path).map_err(|source| PaperError::Read { path: path.to_owned(), source })
}

/// Writes a file and makes its folder where there is none.
///
/// # Errors
///
/// No permission, no space.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), PaperError> {
    let fail = |source| PaperError::Write { path: path.to_owned(), source };
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(fail)?;
    }
    fs::write(path, bytes).map_err(fail)
}
