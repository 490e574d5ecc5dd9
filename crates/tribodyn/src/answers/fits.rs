//! Fits by tolerance class: interference with its range, and the clearance that it leaves.

use serde::Serialize;
use tribodyn_bearing::fits::{Deviations, FitError, Interference, Within};
use tribodyn_bearing::{BearingError, Side};
use tribodyn_case::{Case, FitSpec, MountedRingSpec};

/// A ring on its seat.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeatFit {
    /// `inner` or `outer`.
    pub ring: &'static str,
    /// Tolerance class of the seat.
    pub seat_class: String,
    /// Tolerance class of the bearing.
    pub ring_class: &'static str,
    /// Nominal diameter, m.
    pub diameter_m: f64,
    /// Limit deviations of the seat, m.
    pub seat_deviations_m: [f64; 2],
    /// Limit deviations of the bore or outside diameter, m.
    pub ring_deviations_m: [f64; 2],
    /// Interference by the classes: loosest, likely loosest, mean, likely tightest, tightest, m; below 0 for play.
    pub interference_m: [f64; 5],
    /// Interference of this case after its surfaces are smoothed, m.
    pub effective_interference_m: f64,
}

/// The fits of a case, and the clearance of the bearing over their range.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fits {
    /// Rings with a fit by class.
    pub seats: Vec<SeatFit>,
    /// Radial internal clearance mounted, at rest and cold, m: both seats loosest, likely loosest, mean, likely
    /// tightest, tightest; absent where the rings press harder on the balls than the geometry stands for.
    pub radial_clearance_mounted_m: [Option<f64>; 5],
    /// The same at speed and temperature.
    pub radial_clearance_running_m: [Option<f64>; 5],
}

/// Places within the tolerances, from loose to tight.
const PLACES: [Within; 5] =
    [Within::Loosest, Within::LikelyLoosest, Within::Mean, Within::LikelyTightest, Within::Tightest];

/// The fits of a case; absent where no seat has a class.
///
/// # Errors
/// A case that makes no bearing.
pub fn fits(case: &Case) -> Result<Option<Fits>, BearingError> {
    let Some(mounting) = &case.mounting else { return Ok(None) };
    let rings = [("inner", Side::Inner, &mounting.inner), ("outer", Side::Outer, &mounting.outer)];
    let by_class = |(name, side, ring): (&'static str, Side, &MountedRingSpec)| {
        let seat = ring.seat?;
        // A checked case has no class that ends before the ring.
        seat_fit(name, side, ring.seat_diameter, &seat.fit?, seat.effective_interference(ring.seat_diameter)).ok()
    };
    let seats: Vec<SeatFit> = rings.into_iter().filter_map(by_class).collect();
    if seats.is_empty() {
        return Ok(None);
    }
    let (mut mounted, mut running) = ([None; 5], [None; 5]);
    for (place, within) in PLACES.into_iter().enumerate() {
        match case.with_fits(within).growths() {
            Ok(Some(growths)) => {
                mounted[place] = Some(growths.mounted.geometry.radial_clearance());
                running[place] = Some(growths.running.geometry.radial_clearance());
            }
            Ok(None) | Err(BearingError::Clearance { .. }) => {}
            Err(other) => return Err(other),
        }
    }
    Ok(Some(Fits { seats, radial_clearance_mounted_m: mounted, radial_clearance_running_m: running }))
}

fn seat_fit(name: &'static str, side: Side, diameter: f64, fit: &FitSpec, effective: f64) -> Result<SeatFit, FitError> {
    let interference: Interference = fit.interference(diameter)?;
    let limits = |d: Deviations| [d.low, d.high];
    Ok(SeatFit {
        ring: name,
        seat_class: fit.class.to_string(),
        ring_class: fit.ring.name(),
        diameter_m: diameter,
        seat_deviations_m: limits(fit.class.deviations(diameter)?),
        ring_deviations_m: limits(fit.ring.deviations(side, diameter)?),
        interference_m: PLACES.map(|within| interference.within(within)),
        effective_interference_m: effective,
    })
}
