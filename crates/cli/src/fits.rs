//! Rows of fits by tolerance class.

use crate::rating::Row;
use crate::table::number;
use tribodyn::answers::Fits;

/// Interference of each seat with its range, and the clearance that is left over it.
pub fn rows(fits: &Fits) -> Vec<Row> {
    let mut rows = Vec::new();
    let microns = |values: &[f64]| values.iter().map(|v| number(v * 1e6, 1)).collect::<Vec<_>>().join("  ");
    for seat in &fits.seats {
        let [shaft, on_seat, interference] = if seat.ring == "inner" {
            ["class of shaft and bearing", "shaft and bore, from nominal", "interference on the shaft"]
        } else {
            ["class of housing and bearing", "housing and outside, from nominal", "interference in the housing"]
        };
        rows.push((shaft, format!("{} {}", seat.seat_class, seat.ring_class), ""));
        let limits = |[low, high]: [f64; 2]| format!("{} to {}", number(low * 1e6, 1), number(high * 1e6, 1));
        rows.push((on_seat, format!("{}, {}", limits(seat.seat_deviations_m), limits(seat.ring_deviations_m)), "µm"));
        rows.push((interference, microns(&seat.interference_m), "µm, loosest to tightest, likely, mean"));
        rows.push(("of this bearing, smoothed", number(seat.effective_interference_m * 1e6, 1), "µm"));
    }
    for (name, clearance) in [
        ("clearance mounted over these fits", fits.radial_clearance_mounted_m),
        ("clearance running over these fits", fits.radial_clearance_running_m),
    ] {
        let shown = clearance.map(|c| c.map_or_else(|| "–".to_owned(), |c| number(c * 1e6, 1)));
        rows.push((name, shown.join("  "), "µm"));
    }
    rows
}
