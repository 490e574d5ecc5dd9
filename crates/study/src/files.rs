//! Files on disk: each is written under a temporary name and gets its own when everything else is written.

use crate::error::StudyError;
use std::fs;
use std::path::{Path, PathBuf};

/// Files under temporary names in one folder. What is not [published](Self::publish) is removed again when this is
/// dropped, with the folders that were made for it.
pub struct StagedFiles {
    folder: PathBuf,
    names: Vec<String>,
    made: Vec<PathBuf>,
}

impl StagedFiles {
    /// Makes the folder, and those above it, where they are missing.
    pub fn new(folder: &Path) -> Result<Self, StudyError> {
        let missing = folder.ancestors().take_while(|f| !f.as_os_str().is_empty() && !f.exists());
        let staged = Self { folder: folder.to_owned(), names: Vec::new(), made: missing.map(Path::to_owned).collect() };
        fs::create_dir_all(folder).map_err(|source| StudyError::Write { path: folder.to_owned(), source })?;
        Ok(staged)
    }

    /// Writes one file under its temporary name.
    pub fn write(&mut self, name: String, bytes: &[u8]) -> Result<(), StudyError> {
        let target = self.folder.join(&name);
        if target.is_dir() {
            let source = std::io::ErrorKind::IsADirectory.into();
            return Err(StudyError::Write { path: target, source });
        }
        let path = self.folder.join(temporary(&name));
        self.names.push(name);
        fs::write(&path, bytes).map_err(|source| StudyError::Write { path, source })
    }

    /// Opens one file under its temporary name, for what is too long to be held as a whole.
    pub fn create(&mut self, name: String) -> Result<fs::File, StudyError> {
        let path = self.folder.join(temporary(&name));
        self.names.push(name);
        fs::File::create(&path).map_err(|source| StudyError::Write { path, source })
    }

    /// Gives all files their names, replacing those that stand there.
    pub fn publish(mut self) -> Result<(), StudyError> {
        self.made.clear();
        while let Some(name) = self.names.last() {
            let path = self.folder.join(name);
            let renamed = fs::rename(self.folder.join(temporary(name)), &path);
            renamed.map_err(|source| StudyError::Write { path, source })?;
            self.names.pop();
        }
        Ok(())
    }
}

impl Drop for StagedFiles {
    fn drop(&mut self) {
        // Files and folders may not exist, and a folder that is no longer empty stays; the error that counts is the
        // one that led here.
        for name in &self.names {
            let _ = fs::remove_file(self.folder.join(temporary(name)));
        }
        for folder in &self.made {
            let _ = fs::remove_dir(folder);
        }
    }
}

/// A path with something after its whole name.
pub(crate) fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    PathBuf::from(name)
}

fn temporary(name: &str) -> String {
    format!(".{name}.part")
}
