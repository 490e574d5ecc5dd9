//! Balls of unequal diameter: the grades of ISO 3290-1.

use crate::Random;

/// Variation of the diameter of a ball lot V_DwL, µm, by grade.
///
/// Source: ISO 3290-1, as ball makers print its table (RGPBALLS, "International standards ISO 3290"; Marteau & Lemarié,
/// "Steel and stainless steel balls: table of tolerances"): both give the same values.
const LOT_VARIATION_UM: [(u32, f64); 10] =
    [(3, 0.13), (5, 0.25), (10, 0.5), (16, 0.8), (20, 1.0), (24, 1.2), (28, 1.4), (40, 2.0), (60, 3.0), (100, 5.0)];

/// Grades that [`lot_variation`] knows.
pub fn ball_grades() -> impl Iterator<Item = u32> {
    LOT_VARIATION_UM.iter().map(|row| row.0)
}

/// Largest difference between the mean diameters of two balls of one lot, m, by the grade of ISO 3290-1; none for a
/// grade that the standard does not have.
pub fn lot_variation(grade: u32) -> Option<f64> {
    LOT_VARIATION_UM.iter().find(|row| row.0 == grade).map(|row| row.1 * 1e-6)
}

/// Deviations of the diameters of balls from the nominal one, m, that fill a lot's variation (m): each as likely
/// anywhere in it. The standard bounds them and does not say how they lie.
pub fn ball_deviations(variation: f64, count: usize, seed: u64) -> Vec<f64> {
    (0..count).map(|ball| Random::new(seed, ball as u64).between(-0.5 * variation, 0.5 * variation)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_lot_keeps_its_variation() {
        let variation = lot_variation(10).unwrap();
        assert_eq!(variation, 0.5e-6);
        assert!(ball_grades().all(|grade| lot_variation(grade).is_some()) && lot_variation(11).is_none());
        let lot = ball_deviations(variation, 1000, 3);
        let (least, most) = lot.iter().fold((0.0_f64, 0.0_f64), |(low, high), d| (low.min(*d), high.max(*d)));
        assert!(most - least <= variation && most - least > 0.98 * variation);
        assert_eq!(lot[..9], ball_deviations(variation, 9, 3));
        assert_ne!(lot[..9], ball_deviations(variation, 9, 4));
    }
}
