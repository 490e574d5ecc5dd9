//! Files under temporary names, which get their own when they are whole.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

/// Most temporary files of one name at a time: those of programs that write it now, and of those that were killed.
const MOST: usize = 100;

/// A file that is being written, beside the one that it will be: `.NAME.part`, `.NAME.2.part`, … It is created by this
/// program or not at all, so that what stands under such a name already, a link for instance, is not written through.
/// What is not [published](Self::publish) is removed when this is dropped.
#[derive(Debug)]
pub struct TemporaryFile {
    path: PathBuf,
    file: File,
    /// True once it has its own name.
    published: bool,
}

impl TemporaryFile {
    /// Creates the file beside `target`, which need not exist.
    ///
    /// # Errors
    /// That of the system; a path without a file name is no target.
    pub fn beside(target: &Path) -> io::Result<Self> {
        let Some(name) = target.file_name() else {
            return Err(io::ErrorKind::InvalidInput.into());
        };
        for number in 1..=MOST {
            let mut part = std::ffi::OsString::from(".");
            part.push(name);
            part.push(if number == 1 { ".part".to_owned() } else { format!(".{number}.part") });
            let path = target.with_file_name(part);
            match OpenOptions::new().read(true).write(true).create_new(true).open(&path) {
                Ok(file) => return Ok(Self { path, file, published: false }),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::Error::new(
            io::ErrorKind::AlreadyExists,
            format!("{MOST} temporary files of that name are there already"),
        ))
    }

    /// Its temporary path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The open file.
    pub fn file(&mut self) -> &mut File {
        &mut self.file
    }

    /// Gives it its name, replacing what stands there, once its bytes are on the disk: they survive a power cut from
    /// then on.
    ///
    /// # Errors
    /// That of the system; the temporary file is removed then.
    pub fn publish(self, target: &Path) -> io::Result<()> {
        self.file.sync_all()?;
        self.rename(target)?;
        // Not every system can open a folder; the file itself is safe.
        let folder = target.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
        Ok(())
    }

    /// Gives it its name, replacing what stands there, and leaves it to the system when the bytes reach the disk: for
    /// what is made again in a moment.
    ///
    /// # Errors
    /// That of the system; the temporary file is removed then.
    pub fn rename(mut self, target: &Path) -> io::Result<()> {
        fs::rename(&self.path, target)?;
        self.published = true;
        Ok(())
    }
}

impl Drop for TemporaryFile {
    fn drop(&mut self) {
        if !self.published {
            // The error that counts is the one that led here.
            let _ = fs::remove_file(&self.path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::TemporaryFile;
    use std::fs;
    use std::io::Write;

    #[test]
    fn limit_a_temporary_file_is_new_and_goes_away() {
        let folder = std::env::temp_dir().join(format!("tribodyn-temporary-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let target = folder.join("a.txt");
        let names = || {
            let mut names: Vec<String> =
                fs::read_dir(&folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
            names.sort();
            names
        };
        // What stands under the name already, here a link to a file of somebody else, is left alone.
        fs::write(folder.join("victim"), "mine").unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink(folder.join("victim"), folder.join(".a.txt.part")).unwrap();
        #[cfg(not(unix))]
        fs::write(folder.join(".a.txt.part"), "other").unwrap();
        let mut file = TemporaryFile::beside(&target).unwrap();
        assert_eq!(names(), [".a.txt.2.part", ".a.txt.part", "victim"]);
        file.file().write_all(b"new").unwrap();
        drop(file);
        assert_eq!(names(), [".a.txt.part", "victim"]);
        let mut file = TemporaryFile::beside(&target).unwrap();
        file.file().write_all(b"new").unwrap();
        file.publish(&target).unwrap();
        assert_eq!(names(), [".a.txt.part", "a.txt", "victim"]);
        assert_eq!(
            (fs::read(&target).unwrap(), fs::read(folder.join("victim")).unwrap()),
            (b"new".into(), b"mine".into())
        );
        fs::remove_dir_all(folder).unwrap();
    }
}
