//! Why a shaft has no answer.

use tribodyn_quasistatic::QuasiStaticError;

/// A shaft that cannot be built or solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ShaftError {
    /// An element that is no beam.
    #[error(
        "element {index}: {quantity} is {value}; allowed are lengths and moduli above 0, outer diameters above inner ones"
    )]
    Element {
        /// Which, from 0.
        index: usize,
        /// Which quantity.
        quantity: &'static str,
        /// Its value, SI.
        value: f64,
    },
    /// A node that the shaft does not have.
    #[error("node {node} of a shaft with {nodes} nodes; allowed are 0 to {}", nodes - 1)]
    Node {
        /// The node.
        node: usize,
        /// How many there are.
        nodes: usize,
    },
    /// Matrices of another size than the shaft's.
    #[error("a matrix of {found} rows where the shaft has {expected} freedoms")]
    Size {
        /// Rows given.
        found: usize,
        /// Rows wanted.
        expected: usize,
    },
    /// A mass matrix that is not positive.
    #[error("a degree of freedom has no mass: give the housing a mass, or leave out the mass of all seats")]
    Massless,
    /// The eigenvalues were not found.
    #[error("the eigenvalues of the shaft were not found")]
    Eigenvalues,
    /// A bearing has no equilibrium at the displacement of its rings.
    #[error("bearing {bearing}: {source}")]
    Bearing {
        /// Which, from 0.
        bearing: usize,
        /// Reason.
        source: QuasiStaticError,
    },
    /// The shaft moves without resistance.
    #[error("nothing holds the shaft {direction}: {advice}")]
    Loose {
        /// Along or about which axis.
        direction: &'static str,
        /// A remedy.
        advice: &'static str,
    },
    /// An axial force that a bearing does not carry.
    #[error(
        "{force} N along the axis are more than the bearings carry: no displacement up to {} mm gives them",
        1e3 * farthest
    )]
    TooLarge {
        /// Force, N.
        force: f64,
        /// Farthest displacement that was looked at, m.
        farthest: f64,
    },
    /// The iteration stopped above the tolerance.
    #[error("the shaft did not converge: {residual:.1e} of the load is left at {share:.0} % of it (tolerance {tolerance:.1e})", share = 100.0 * share)]
    NotConverged {
        /// Residual over the load.
        residual: f64,
        /// Share of the load that was reached.
        share: f64,
        /// Tolerance.
        tolerance: f64,
    },
}
