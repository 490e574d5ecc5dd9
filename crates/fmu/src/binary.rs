//! Libraries that are compiled of the sources, and where they stand in the archive.

/// A system that a library is compiled for, as FMI 2.0 names its folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Platform {
    /// Linux on x86-64.
    Linux64,
}

impl Platform {
    /// The platform of this program; none where FMI 2.0 has no name for it, or where nobody has tried to compile for
    /// it.
    pub fn here() -> Option<Self> {
        (cfg!(target_os = "linux") && cfg!(target_arch = "x86_64")).then_some(Self::Linux64)
    }

    /// Its folder under `binaries`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linux64 => "linux64",
        }
    }

    /// The ending of its libraries.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Linux64 => "so",
        }
    }
}

/// A compiled library.
#[derive(Debug, Clone)]
pub struct Binary {
    /// The system it runs on.
    pub platform: Platform,
    /// Its bytes.
    pub bytes: Vec<u8>,
}
