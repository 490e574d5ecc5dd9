//! The draws of members: shares of the distributions, by seed and number alone.

use crate::survey::Random;
use serde::{Deserialize, Serialize};

/// How the members lie in the space of the spreads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sampling {
    /// Each member by itself: its values are the same in an ensemble of any size.
    Independent,
    /// Each spread cut into as many equally likely parts as there are members, one member in each.
    ///
    /// Source: McKay, Beckman and Conover, Technometrics 21 (1979) 239, doi:10.1080/00401706.1979.10489755.
    LatinHypercube,
    /// Each value of every spread with each of the others, the first spread changing slowest.
    Grid,
}

/// Shares of the members of a grid, from the number of values of each spread.
pub(super) fn grid(counts: &[usize]) -> Vec<Vec<f64>> {
    let members: usize = counts.iter().product();
    let mut after = members;
    let one = |&count: &usize| {
        after /= count;
        (0..members).map(|member| ((member / after % count) as f64 + 0.5) / count as f64).collect()
    };
    counts.iter().map(one).collect()
}

/// For each spread the share of its distribution that each member has, from 0 to 1.
pub(super) fn shares(sampling: Sampling, seed: u64, members: usize, spreads: usize) -> Vec<Vec<f64>> {
    let mut shares = vec![Vec::with_capacity(members); spreads];
    for member in 0..members {
        let mut random = Random::new(seed, member as u64);
        shares.iter_mut().for_each(|of_spread| of_spread.push(random.share()));
    }
    if sampling == Sampling::LatinHypercube {
        for (k, of_spread) in shares.iter_mut().enumerate() {
            let parts = permutation(Random::new(seed, u64::MAX - k as u64), members);
            let within = |(share, part): (&mut f64, usize)| *share = (part as f64 + *share) / members as f64;
            of_spread.iter_mut().zip(parts).for_each(within);
        }
    }
    shares
}

/// The numbers below a count in a random order (Fisher and Yates).
fn permutation(mut random: Random, count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    for last in (1..count).rev() {
        order.swap(last, random.whole(0, last));
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regress_a_seed_gives_these_shares() {
        let found = shares(Sampling::Independent, 1, 3, 2);
        let expected = [
            [0.36818951565166946, 0.16364449857840258, 0.36700444700006973],
            [0.9435642308648544, 0.059980197777462, 0.7439640487348732],
        ];
        assert_eq!(found, expected.map(|s| s.to_vec()));
    }

    #[test]
    fn identity_a_grid_has_each_value_with_each_other() {
        let found = grid(&[2, 3]);
        let place = |k: usize, m: usize, count: usize| (found[k][m] * count as f64) as usize;
        let members: Vec<[usize; 2]> = (0..6).map(|m| [place(0, m, 2), place(1, m, 3)]).collect();
        assert_eq!(members, [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2]]);
    }

    #[test]
    fn identity_a_member_does_not_depend_on_the_others() {
        let (few, many) = (shares(Sampling::Independent, 7, 3, 1), shares(Sampling::Independent, 7, 100, 2));
        assert_eq!(few[0], many[0][..3]);
        assert_ne!(shares(Sampling::Independent, 8, 3, 1), few);
    }

    /// Mean 1/2, variance 1/12 and no correlation between spreads, or between a member and the next, within four
    /// standard errors.
    #[test]
    fn limit_shares_are_even_and_independent() {
        const COUNT: usize = 20_000;
        let found = shares(Sampling::Independent, 3, COUNT, 2);
        let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / COUNT as f64;
        let error = 4.0 / (COUNT as f64).sqrt();
        for of_spread in &found {
            assert!((mean(&mut of_spread.iter().copied()) - 0.5).abs() < error / 12.0_f64.sqrt());
            assert!(
                (mean(&mut of_spread.iter().map(|s| (s - 0.5).powi(2))) - 1.0 / 12.0).abs() < error / 180.0_f64.sqrt()
            );
        }
        let product = |a: f64, b: f64| 12.0 * (a - 0.5) * (b - 0.5);
        let between = mean(&mut found[0].iter().zip(&found[1]).map(|(a, b)| product(*a, *b)));
        let next = mean(&mut found[0].windows(2).map(|pair| product(pair[0], pair[1])));
        let across = mean(&mut found[0][1..].iter().zip(&found[1]).map(|(a, b)| product(*a, *b)));
        assert!([between, next, across].iter().all(|c| c.abs() < error), "{between} {next} {across}");
    }

    #[test]
    fn identity_a_latin_hypercube_has_one_member_in_each_part() {
        let found = shares(Sampling::LatinHypercube, 5, 40, 3);
        let parts = |of_spread: &Vec<f64>| of_spread.iter().map(|s| (s * 40.0) as usize).collect::<Vec<_>>();
        for of_spread in &found {
            let mut sorted = parts(of_spread);
            sorted.sort_unstable();
            assert_eq!(sorted, (0..40).collect::<Vec<_>>());
        }
        assert_ne!(parts(&found[0]), parts(&found[1]));
        assert_eq!(found, shares(Sampling::LatinHypercube, 5, 40, 3));
    }
}
