//! The compiled half of the Python package `tribodyn`: cases, and the procedures of `tribodyn-study` on them.
//!
//! Everything that users see is in the folder `python`: classes with documented attributes. Here are functions that
//! take and give plain values. A result is what the command prints with `--json`, from the same types.
//!
//! There is no `unsafe` block in this crate, as nowhere in the workspace, and a check of the sources holds it to that.
//! The lint alone cannot: PyO3's attributes write the functions that the interpreter calls, which are unsafe, and they
//! allow it for themselves, which a forbidden lint does not let them. So it is denied here and not forbidden.
//!
//! While something is computed, the interpreter is free for other threads.

mod answers;
mod case;
mod convert;
mod dataset;
mod ensemble;
mod error;
mod figures;
mod fmus;
mod recording;
mod runs;
mod sets;
mod signals;
mod solution;
mod sweep;
mod watch;

use pyo3::prelude::*;

/// The compiled half of tribodyn.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::answers::{
        check, contact_film, films, heat, hertz, modes, quantities, rating, solve, stiffness, torque, traction_curve,
    };
    #[pymodule_export]
    use super::case::{NativeCase, in_si, unit_names};
    #[pymodule_export]
    use super::dataset::{dataset, dataset_members};
    #[pymodule_export]
    use super::ensemble::ensemble;
    #[pymodule_export]
    use super::fmus::fmu;
    #[pymodule_export]
    use super::recording::{read_recording, recorded_names, report};
    #[pymodule_export]
    use super::runs::{acting_life, identification_starts, identify, life, run};
    #[pymodule_export]
    use super::sets::{catalogue, pair, set, shaft, sheet};
    #[pymodule_export]
    use super::signals::{layout, recover, vibration};
    #[pymodule_export]
    use super::solution::solution_figures;
    #[pymodule_export]
    use super::sweep::{NativeGrid, merge_tables};
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
