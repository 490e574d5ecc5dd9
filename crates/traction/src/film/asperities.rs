//! The share of the load that asperities carry.

use crate::Scalar;

/// λ below which the share is taken at this one: its slope at 0 is infinite in no direction that matters.
const LEAST_LAMBDA: f64 = 1e-9;

/// Share of the load that asperities carry at a film parameter λ: f = 1/(1 + 4 λ^1.5).
///
/// A fit through what is usual, not a theory: 1 without a film, a fifth at λ = 1, 5 % at 3.
pub fn asperity_share<D: Scalar>(lambda_ratio: D) -> D {
    let lambda = if lambda_ratio.re() > LEAST_LAMBDA { lambda_ratio } else { D::from(LEAST_LAMBDA) };
    (lambda * lambda.sqrt() * 4.0 + 1.0).recip()
}

#[cfg(test)]
mod tests {
    use super::asperity_share;

    #[test]
    fn limit_asperities_carry_all_without_a_film_and_nothing_in_a_thick_one() {
        assert!((asperity_share(0.0) - 1.0_f64).abs() < 1e-12 && asperity_share(100.0) < 3e-4);
        assert!((asperity_share(1.0) - 0.2_f64).abs() < 1e-15 && (0.04..0.05).contains(&asperity_share(3.0)));
    }
}
