//! One writer at a time for an output file.
//!
//! The lock is the system's, on a file beside the output: it ends with the process that holds it, however that ends, so
//! that a file left by a dead process blocks nobody. The file says who holds it.

use crate::error::StudyError;
use crate::files::with_suffix;
use crate::holder::Holder;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Looks at a lock whose holder has not yet written its name, and the time between them.
const LOOKS: usize = 5;
const LOOK_STEP: Duration = Duration::from_millis(10);
/// Longest name of a holder, bytes.
const LONGEST: u64 = 4096;

impl Holder {
    fn this() -> Self {
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        Self { pid: std::process::id(), host: host(), since: date_and_time(since.as_secs()) }
    }

    /// The holder that a lock file names.
    fn read(path: &Path) -> Option<Self> {
        let mut text = String::new();
        File::open(path).ok()?.take(LONGEST).read_to_string(&mut text).ok()?;
        serde_json::from_str(&text).ok()
    }
}

/// The right to write an output, until it is dropped.
#[derive(Debug)]
pub(crate) struct OutputLock {
    path: PathBuf,
    _file: File,
}

impl OutputLock {
    /// Takes the lock `<output>.lock`, or says at once who has it.
    pub fn take(output: &Path) -> Result<Self, StudyError> {
        let path = with_suffix(output, ".lock");
        let write = |source| StudyError::Write { path: path.clone(), source };
        loop {
            let options = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path);
            let mut file = options.map_err(write)?;
            match file.try_lock() {
                Err(TryLockError::WouldBlock) => {
                    return Err(StudyError::Busy { output: output.to_owned(), holder: holder(&path) });
                }
                // Some file systems know no locks: then the user has to take care.
                Ok(()) | Err(TryLockError::Error(_)) => {}
            }
            // Between opening and locking the holder may have ended and removed the file.
            if !is_at(&file, &path) {
                continue;
            }
            let mut text = String::new();
            let read = (&mut file).take(LONGEST).read_to_string(&mut text);
            if read.is_err() || !(text.is_empty() || text.starts_with("{\"pid\":")) {
                return Err(StudyError::NoLock { path });
            }
            // The lock holds without a name too: on a full disk, say.
            let _ = file.set_len(0).and_then(|()| rewrite(&mut file));
            return Ok(Self { path, _file: file });
        }
    }
}

impl Drop for OutputLock {
    fn drop(&mut self) {
        // Removed while it is locked: who has opened it meanwhile sees that it is gone. A file that stays blocks
        // nobody.
        let _ = fs::remove_file(&self.path);
    }
}

fn rewrite(file: &mut File) -> std::io::Result<()> {
    use std::io::{Seek, SeekFrom};
    file.seek(SeekFrom::Start(0))?;
    file.write_all(&serde_json::to_vec(&Holder::this())?)
}

/// Who holds a lock, where the file says so.
fn holder(path: &Path) -> Option<Holder> {
    (0..LOOKS).find_map(|look| {
        if look > 0 {
            std::thread::sleep(LOOK_STEP);
        }
        Holder::read(path)
    })
}

/// True if an open file is still the one of that name.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let (Ok(open), Ok(named)) = (file.metadata(), fs::metadata(path)) else { return false };
    (open.dev(), open.ino()) == (named.dev(), named.ino())
}

/// Elsewhere a file that is open keeps its name.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// The name of this machine, empty where neither the system nor the environment tells.
fn host() -> String {
    let of_system = fs::read_to_string("/proc/sys/kernel/hostname").ok();
    let of_environment = || ["HOSTNAME", "COMPUTERNAME"].iter().find_map(|name| std::env::var(name).ok());
    of_system.or_else(of_environment).map_or(String::new(), |name| name.trim().to_owned())
}

/// Seconds since 1970 as date and time, UTC. The date counts in eras of 400 years that begin in March, so that the
/// leap day is the last of its year (Reingold, Dershowitz, Calendrical Calculations, 2018, chapter 2).
fn date_and_time(seconds: u64) -> String {
    let (days, rest) = (seconds / 86_400 + 719_468, seconds % 86_400);
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = era * 400 + year_of_era + u64::from(month <= 2);
    format!("{year}-{month:02}-{day:02} {:02}:{:02}:{:02} UTC", rest / 3600, rest / 60 % 60, rest % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("tribodyn-lock-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn limit_dates_at_the_ends_of_months_and_years() {
        assert_eq!(date_and_time(0), "1970-01-01 00:00:00 UTC");
        assert_eq!(date_and_time(951_782_399), "2000-02-28 23:59:59 UTC");
        assert_eq!(date_and_time(951_782_400), "2000-02-29 00:00:00 UTC");
        assert_eq!(date_and_time(1_735_689_599), "2024-12-31 23:59:59 UTC");
        assert_eq!(date_and_time(4_107_542_400), "2100-03-01 00:00:00 UTC");
    }

    #[test]
    fn limit_a_second_writer_is_refused_with_the_name_of_the_first() {
        let folder = folder("second");
        let output = folder.join("run.mcap");
        let first = OutputLock::take(&output).unwrap();
        let refused = OutputLock::take(&output).unwrap_err();
        let StudyError::Busy { holder: Some(holder), .. } = &refused else { panic!("{refused:?}") };
        assert_eq!(holder.pid, std::process::id());
        let text = refused.to_string();
        assert!(text.contains("run.mcap") && text.contains(&format!("pid {}", std::process::id())), "{text}");
        drop(first);
        assert!(!folder.join("run.mcap.lock").exists());
        // What a killed process leaves.
        fs::write(folder.join("run.mcap.lock"), r#"{"pid":1,"host":"gone","since":"long ago"}"#).unwrap();
        drop(OutputLock::take(&output).unwrap());
        fs::remove_dir(folder).unwrap();
    }

    #[test]
    fn limit_a_file_of_somebody_else_is_no_lock() {
        let folder = folder("foreign");
        let file = folder.join("run.mcap.lock");
        fs::write(&file, "[package]\n").unwrap();
        assert!(matches!(OutputLock::take(&folder.join("run.mcap")), Err(StudyError::NoLock { .. })));
        assert_eq!(fs::read_to_string(&file).unwrap(), "[package]\n");
        fs::remove_dir_all(folder).unwrap();
    }
}
