//! How the finished rows of an earlier sweep, ensemble or life differ from those that are asked for.

/// How finished rows on disk differ from those that a study would make.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SweepDifference {
    /// The file holds something else.
    #[error("this is not a file of finished rows of such a study")]
    Unknown,
    /// Another version made them.
    #[error("these finished rows are of version {found} of the command")]
    Version {
        /// Version of the file.
        found: String,
    },
    /// Another case.
    #[error("these finished rows are of another case")]
    Case,
    /// Another model.
    #[error("these finished rows are by the model {found}")]
    Model {
        /// Model of the file.
        found: String,
    },
    /// Other swept values.
    #[error("these finished rows are of other swept values")]
    Values,
    /// Another part of the sweep.
    #[error("these finished rows are of shard {found}")]
    Shard {
        /// Part in the file, `I/N`.
        found: String,
    },
    /// Rows that start from neighbours and rows that do not.
    #[error("these finished rows are of a sweep with another choice of cold starts")]
    Cold,
    /// Members drawn otherwise: other spreads, numbers of members or seeds.
    #[error("these finished members are of other --vary, --members, --seed or --latin-hypercube")]
    Draws,
    /// Another plan of a data set.
    #[error("these finished members are of another plan")]
    Plan,
    /// Strides of another length, or a life with another end.
    #[error("these finished strides are of other --strides, --until, --clearance-limit or --bare-limit")]
    Strides,
    /// A life in which wear does something else, or with another mission.
    #[error("these finished strides are of another --acting or --mission")]
    Effects,
}
