//! Quantiles of the members' figures.

use super::member::Member;
use crate::sweep::{Cell, Column, Kind};
use serde::Serialize;

/// Shares of the members that lie below a quantile.
const SHARES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];

/// Quantiles of one figure over the members that have it. Between two members they are interpolated linearly:
/// definition 7 of Hyndman and Fan, The American Statistician 50 (1996) 361, doi:10.2307/2684934.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantiles {
    /// Name of the figure's column, with the unit.
    pub quantity: String,
    /// Members that have the figure.
    pub members: usize,
    /// 5 % of the members lie below.
    pub p05: f64,
    /// 25 % of the members lie below.
    pub p25: f64,
    /// The median.
    pub p50: f64,
    /// 75 % of the members lie below.
    pub p75: f64,
    /// 95 % of the members lie below.
    pub p95: f64,
}

impl Quantiles {
    /// Of a figure's values; none without any.
    fn of(quantity: &str, mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let [p05, p25, p50, p75, p95] = SHARES.map(|share| {
            let place = share * last as f64;
            let low = place.floor() as usize;
            let (below, above) = (values[low], values[last.min(low + 1)]);
            below + (place - low as f64) * (above - below)
        });
        Some(Self { quantity: quantity.to_owned(), members: values.len(), p05, p25, p50, p75, p95 })
    }

    /// In ascending order.
    pub fn all(&self) -> [f64; 5] {
        [self.p05, self.p25, self.p50, self.p75, self.p95]
    }
}

/// Values of the figure at a place among the columns, of all members that have it.
pub(super) fn values(members: &[Member], place: usize) -> Vec<f64> {
    let value = |member: &Member| match member.figures.as_ref().ok()?.get(place)? {
        Cell::Number(value) if value.is_finite() => Some(*value),
        Cell::Integer(value) => Some(*value as f64),
        _ => None,
    };
    members.iter().filter_map(value).collect()
}

/// Of all figures that any member has.
pub(super) fn quantiles(columns: &[Column], members: &[Member]) -> Vec<Quantiles> {
    let number = |column: &Column| matches!(column.kind, Kind::Number | Kind::Integer);
    let of = |(place, column): (usize, &Column)| Quantiles::of(&column.name, values(members, place));
    columns.iter().enumerate().filter(|(_, column)| number(column)).filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_quantiles_of_even_values_are_their_shares() {
        // Out of order, from 0 to 20.
        let found = Quantiles::of("x", (0..21).map(|k| f64::from(k * 8 % 21)).collect()).unwrap();
        assert_eq!((found.members, found.all()), (21, [1.0, 5.0, 10.0, 15.0, 19.0]));
        // Between members: 0.05 of the way from 1 to 3.
        let found = Quantiles::of("x", vec![3.0, 1.0]).unwrap();
        assert!((found.p05 - 1.1).abs() < 1e-15 && found.p50 == 2.0, "{found:?}");
        assert_eq!(Quantiles::of("x", vec![4.0]).unwrap().all(), [4.0; 5]);
        assert_eq!(Quantiles::of("x", Vec::new()), None);
    }
}
