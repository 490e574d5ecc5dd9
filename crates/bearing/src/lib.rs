//! (filled by the bearing work)
