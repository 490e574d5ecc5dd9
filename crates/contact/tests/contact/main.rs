//! Elliptic integrals and Hertz contact against 40-digit references, closed forms, another crate and limiting cases.

mod identities;
mod limits;
mod references;

use tribodyn_contact::{HertzContact, Scalar};

fn error(found: f64, expected: f64) -> f64 {
    ((found - expected) / expected).abs()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs() / expected.abs().max(f64::MIN_POSITIVE);
    assert!(error <= tolerance, "{found} instead of {expected}: relative error {error:e} above {tolerance:e}");
}

fn contact<D: Scalar>(x: D, y: D) -> HertzContact<D> {
    HertzContact::new(x, y, 2.2e11).unwrap()
}
