//! Files on disk: read within bounds, and written under temporary names until everything else is written.

use crate::error::StudyError;
use crate::ours::Ours;
use std::fs;
use std::io::{Error, ErrorKind, Read, Result, Write};
use std::path::{Path, PathBuf};
use tribodyn::lifted;
use tribodyn_record::TemporaryFile;

/// The bytes of a file that has at most so many.
pub(crate) fn read_at_most(path: &Path, most: u64) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    // Not by the length that the system names: that of a pipe or a device is 0.
    fs::File::open(path)?.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(Error::new(
            ErrorKind::FileTooLarge,
            format!("it is too long; {}", lifted(format!("{most} bytes"))),
        ));
    }
    Ok(bytes)
}

/// Files under temporary names in one folder. What is not [published](Self::publish) is removed again when this is
/// dropped, with the folders that were made for it.
pub struct StagedFiles {
    folder: PathBuf,
    /// True if files of other makers are replaced too.
    force: bool,
    files: Vec<(PathBuf, TemporaryFile)>,
    made: Vec<PathBuf>,
}

impl StagedFiles {
    /// Makes the folder, and those above it, where they are missing. Files that stand there and that tribodyn did not
    /// write are replaced with `force` only.
    pub fn new(folder: &Path, force: bool) -> std::result::Result<Self, StudyError> {
        let missing = folder.ancestors().take_while(|f| !f.as_os_str().is_empty() && !f.exists());
        let staged =
            Self { folder: folder.to_owned(), force, files: Vec::new(), made: missing.map(Path::to_owned).collect() };
        fs::create_dir_all(folder).map_err(|source| StudyError::Write { path: folder.to_owned(), source })?;
        Ok(staged)
    }

    /// Writes one file under its temporary name.
    pub fn write(&mut self, name: String, bytes: &[u8]) -> std::result::Result<(), StudyError> {
        let path = self.folder.join(&name);
        let written = self.create(name)?.write_all(bytes);
        written.map_err(|source| StudyError::Write { path, source })
    }

    /// Opens one file under its temporary name, for what is too long to be held as a whole.
    pub fn create(&mut self, name: String) -> std::result::Result<fs::File, StudyError> {
        let path = self.folder.join(name);
        let write = |source| StudyError::Write { path: path.clone(), source };
        if path.is_dir() {
            return Err(write(ErrorKind::IsADirectory.into()));
        }
        if !self.force && path.exists() && Ours::of(&path).map_err(write)?.is_none() {
            return Err(StudyError::NotOurs { path, wanted: "a file" });
        }
        let mut file = TemporaryFile::beside(&path).map_err(write)?;
        let handle = file.file().try_clone().map_err(write)?;
        self.files.push((path, file));
        Ok(handle)
    }

    /// Gives all files their names, replacing those that stand there.
    pub fn publish(mut self) -> std::result::Result<(), StudyError> {
        self.made.clear();
        for (path, file) in self.files.drain(..) {
            file.rename(&path).map_err(|source| StudyError::Write { path, source })?;
        }
        Ok(())
    }
}

impl Drop for StagedFiles {
    fn drop(&mut self) {
        // Temporary files first; a folder that is no longer empty stays, and the error that counts is the one that led
        // here.
        self.files.clear();
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
