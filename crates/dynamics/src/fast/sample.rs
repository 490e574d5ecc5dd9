//! The balls at a moment of the fast scheme, for samples: all in lanes but the pockets and what the linear forms do not
//! reach.

use super::Fast;
use super::depths::depths;
use super::drift::{Pressed, press};
use super::kick_forces::{Forms, KickForces, LINEAR, slide, surroundings};
use super::lanes::{Lane, WIDTH, blocks, filled, gather, get, put};
use super::numbers::{HELD_SUMS, IN_POCKET, Numbers, SUMS, SlidingContact};
use super::scratch::{Scratch, force_of};
use crate::detail::{Balls, ball_result};
use crate::equations::{Equations, Frame, Touched};
use crate::forces::Sums;
use crate::layout::{BALL, VELOCITY};
use crate::linear::LinearTraction;
use crate::machine::Machine;
use crate::observer::BallDetail;
use fearless_simd::{Level, dispatch};
use tribodyn_bearing::{BallLoads, BallResult, BallState, ContactSprings, PocketLoad, RaceContact, Races, Sheet, Side};

/// Reach of a linear traction for samples, over that for steps: half a step before a refresh the linear form must not
/// give way to an integral that serves only once.
const BEFORE_REFRESH: f64 = 1.5;

/// Semi-axes (longer, shorter) and peak pressure at inner and outer contacts.
type Ellipses = [[Lane; 3]; 2];
/// Ellipses, pockets, and the leads of the balls in these.
type Beside<'a> = (&'a Ellipses, &'a [Lane; IN_POCKET], &'a Lane);

/// Room that a sample works in, kept from one to the next, and the list of balls that it fills.
#[derive(Default)]
pub(crate) struct Room {
    pub balls: Vec<BallResult>,
    /// One, once there was a sample.
    found: Vec<(Pressed, KickForces, Slides, Sampled)>,
}

/// How the balls of a block slide.
struct Slides {
    of: [[Lane; SlidingContact::NUMBERS]; 2],
    /// 1 where both linear forms are near, else 0.
    near: Lane,
}

impl Slides {
    const NONE: Self = Self { of: [[Lane::ZERO; SlidingContact::NUMBERS]; 2], near: Lane::ZERO };
}

/// The balls of a block as samples have them, part by part.
struct Sampled {
    ball: [Lane; 10],
    fluid: [Lane; 6],
    pocket: [Lane; 5],
    motion: [Lane; 3],
    contacts: [[Lane; 8]; 2],
    frictions: [[Lane; 7]; 2],
    transients: [[Lane; 3]; 2],
    sums: [Lane; HELD_SUMS],
}

impl Sampled {
    const NONE: Self = Self {
        ball: [Lane::ZERO; 10],
        fluid: [Lane::ZERO; 6],
        pocket: [Lane::ZERO; 5],
        motion: [Lane::ZERO; 3],
        contacts: [[Lane::ZERO; 8]; 2],
        frictions: [[Lane::ZERO; 7]; 2],
        transients: [[Lane::ZERO; 3]; 2],
        sums: [Lane::ZERO; HELD_SUMS],
    };

    /// Writes a ball's result in place: a copy of what was just written number by number would wait for it.
    #[inline(always)]
    fn write(&self, k: usize, (result, detail): (&mut BallResult, BallDetail)) {
        result.take(get(&self.ball, k));
        result.pocket.get_or_insert_default().take(get(&self.pocket, k));
        for side in Side::BOTH {
            result.contacts[side].take(get(&self.contacts[side as usize], k));
        }
        if detail == BallDetail::Loads {
            return leave_loads(result);
        }
        result.fluid.get_or_insert_default().take(get(&self.fluid, k));
        result.motion.get_or_insert_default().take(get(&self.motion, k));
        for side in Side::BOTH {
            let (contact, i) = (&mut result.contacts[side], side as usize);
            contact.friction.get_or_insert_default().take(get(&self.frictions[i], k));
            contact.transient.get_or_insert_default().take(get(&self.transients[i], k));
        }
    }
}

/// Leaves of a ball's result what [`BallDetail::Loads`] has.
#[inline(always)]
fn leave_loads(result: &mut BallResult) {
    (result.fluid, result.motion) = (None, None);
    for side in Side::BOTH {
        (result.contacts[side].friction, result.contacts[side].transient) = (None, None);
    }
}

/// The same for all blocks.
struct Of<'a> {
    machine: &'a Machine,
    frame: Frame,
    sheet: Sheet,
    springs: ContactSprings,
}

impl Fast {
    /// True once there are linear forms to sample by.
    pub fn has_forms(&self) -> bool {
        !self.scratch.forms.is_empty()
    }

    /// The balls with the linear forms of the last step, in the list that there is room for.
    pub fn sample(&self, machine: &Machine, (t, y): (f64, &[f64]), (detail, room): (BallDetail, &mut Room)) -> Balls {
        let Scratch { level, forms, .. } = &self.scratch;
        let l = machine.layout;
        let of = Of {
            machine,
            frame: machine.frame(t, y),
            sheet: machine.bearing.sheet(),
            springs: machine.bearing.contact_springs(),
        };
        let (mut sums, mut results) = ([0.0; SUMS], std::mem::take(&mut room.balls));
        results.resize(l.balls, BallResult::default());
        room.found.resize_with(1, || (Pressed::NONE, KickForces::NONE, Slides::NONE, Sampled::NONE));
        let [(pressed, kick_forces, slides, sampled)] = &mut room.found[..] else { unreachable!("there is one") };
        for (block, forms) in forms.iter().enumerate().take(blocks(l.balls)) {
            let balls = gather(l, y, block);
            press(*level, machine, (&of.frame, block, &balls), pressed);
            let (places, now) = (self.scratch.places[block], (&balls, &*pressed));
            dispatch!(*level, _simd => surroundings(machine, &of.frame, now, kick_forces));
            kick_forces.depth = dispatch!(*level, _simd => depths(machine, (&of.frame, &places), now));
            let pockets = of.pockets(block, &balls, kick_forces);
            let (mean_forces, now) = (&self.scratch.mean_forces[block], (&balls, &*pressed));
            dispatch!(*level, _simd => slide_all(&of, now, (forms, mean_forces), slides));
            let (at, ellipses) = ((&balls, &*pressed, &*kick_forces), of.ellipses(*level, pressed));
            let (slides, beside) = (&*slides, (&ellipses, &pockets, &of.leads(block, &balls)));
            match detail {
                BallDetail::All => dispatch!(*level, _simd => sample_block::<true>(&of, at, (slides, beside), sampled)),
                BallDetail::Loads => {
                    dispatch!(*level, _simd => sample_block::<false>(&of, at, (slides, beside), sampled))
                }
            }
            for k in 0..filled(l, block) {
                let (index, result) = (WIDTH * block + k, &mut results[WIDTH * block + k]);
                let sums_of_ball = if slides.near.0[k] > 0.0 && !l.any_tilts() {
                    sampled.write(k, (result, detail));
                    of.with_reaction(get(&sampled.sums, k), (get(&pockets, k), &get(&balls, k)))
                } else {
                    of.alone((index, y), (forms, mean_forces, k), (result, detail))
                };
                sums.iter_mut().zip(sums_of_ball).for_each(|(sum, part)| *sum += part);
            }
        }
        let mut all = Sums::default();
        all.take(sums);
        (all, results)
    }
}

impl Of<'_> {
    /// The same for loops over the lanes: balls of rings that tilt are seen one by one.
    #[inline(always)]
    fn held(&self) -> Self {
        Self { frame: self.frame.held(), machine: self.machine, sheet: self.sheet, springs: self.springs }
    }

    /// Semi-axes and pressures of the contacts: ball by ball where the contact constants follow the contact angle.
    fn ellipses(&self, level: Level, pressed: &Pressed) -> Ellipses {
        let bearing = &self.machine.bearing;
        if !bearing.modelling.contact_at_actual_angle {
            return dispatch!(level, _simd => frozen_ellipses(self.springs, pressed));
        }
        let mut ellipses = [[Lane::ZERO; 3]; 2];
        for (side, k) in Side::BOTH.into_iter().flat_map(|side| pressed.in_use.lanes().map(move |k| (side, k))) {
            let e = bearing.ellipse(side, &pressed.contact(side, k));
            put(&mut ellipses[side as usize], k, [e.semi_major, e.semi_minor, e.peak_pressure]);
        }
        ellipses
    }

    /// Of those balls that touch the walls of theirs.
    fn pockets(&self, block: usize, balls: &[Lane; BALL], kick_forces: &KickForces) -> [Lane; IN_POCKET] {
        let mut pockets = [Lane::ZERO; IN_POCKET];
        for k in (0..filled(self.machine.layout, block)).filter(|&k| kick_forces.depth.0[k] > 0.0) {
            let load = self.machine.pocket_load(WIDTH * block + k, &get(balls, k), &self.frame);
            put(&mut pockets, k, load.numbers());
        }
        pockets
    }

    /// The sums of a ball seen in its lane, with what its pocket does to a free cage.
    fn with_reaction(&self, in_lane: [f64; HELD_SUMS], (load, b): ([f64; IN_POCKET], &[f64; BALL])) -> [f64; SUMS] {
        let mut numbers = [0.0; SUMS];
        numbers[..HELD_SUMS].copy_from_slice(&in_lane);
        if self.frame.free_cage.is_none() {
            return numbers;
        }
        let (mut sums, mut pocket) = (Sums::default(), PocketLoad::none());
        sums.take(numbers);
        pocket.take(load);
        self.machine.react_on_cage(&self.frame, (&pocket, b), &mut sums.on_cage);
        sums.numbers()
    }

    /// Leads of the balls over the middles of their pockets, rad.
    fn leads(&self, block: usize, balls: &[Lane; BALL]) -> Lane {
        let mut leads = Lane::ZERO;
        for k in 0..filled(self.machine.layout, block) {
            leads.0[k] = self.machine.lead_in(WIDTH * block + k, &get(balls, k), &self.frame);
        }
        leads
    }

    /// A ball by itself, its tractions by the linear forms where these are near, else integrated, but with the forces
    /// of the kick.
    fn alone(
        &self,
        (index, y): (usize, &[f64]),
        (forms, mean_forces, k): (&Forms, &[Lane; 6], usize),
        (result, detail): (&mut BallResult, BallDetail),
    ) -> [f64; SUMS] {
        let (machine, mut sums) = (self.machine, Sums::default());
        let b = machine.unknowns(index, y);
        let forces = machine.ball(index, b, &self.frame, |patch, sliding| {
            let linear = LinearTraction::from_numbers(|i| forms.traction[patch.side as usize][i].0[k]);
            let at = (patch.bare, BEFORE_REFRESH);
            let (change, near) =
                linear.reaches((&patch.motion, patch.rolling_speed), patch.load, at, patch.patch.ball_radius);
            let traction = if near {
                linear.traction(&patch.motion, &change)
            } else {
                machine.kernel.traction(&machine.bearing, patch)
            };
            sliding.with_force(&traction, force_of(mean_forces, patch.side, k), patch.patch.ball_radius)
        });
        machine.add_ball(&forces, [b[VELOCITY], b[VELOCITY + 1]], &self.frame, &mut sums);
        *result = ball_result(&self.sheet, (b, self.frame.rings.inner.speed), &forces);
        if detail == BallDetail::Loads {
            leave_loads(result);
        }
        sums.numbers()
    }
}

/// With the contact constants of the free contact angle.
#[inline(always)]
fn frozen_ellipses(springs: ContactSprings, pressed: &Pressed) -> Ellipses {
    let mut ellipses = [[Lane::ZERO; 3]; 2];
    for k in pressed.in_use.lanes() {
        let inner = springs.ellipse(Side::Inner, pressed.contact(Side::Inner, k).pose.approach);
        let outer = springs.ellipse(Side::Outer, pressed.contact(Side::Outer, k).pose.approach);
        put(&mut ellipses[0], k, [inner.semi_major, inner.semi_minor, inner.peak_pressure]);
        put(&mut ellipses[1], k, [outer.semi_major, outer.semi_minor, outer.peak_pressure]);
    }
    ellipses
}

/// How a ball slides on a race, its traction by the linear form with the force of the kick, and 1 where that is near,
/// else 0.
#[inline(always)]
fn sliding_contact(
    (of, side): (&Of<'_>, Side),
    state: &BallState,
    at: (&Pressed, &[Lane; LINEAR], usize),
    mean_forces: &[Lane; 6],
) -> (SlidingContact, f64) {
    let (sliding, traction, near) = slide(of.machine, side, (&of.frame.rings[side], state), at, BEFORE_REFRESH);
    let (loaded, ball_radius) = (at.0.load(side, at.2) > 0.0, of.machine.bearing.geometry.ball_radius());
    let traction = sliding.with_force(&traction, force_of(mean_forces, side, at.2), ball_radius);
    (SlidingContact { sliding, traction: traction.times(if loaded { 1.0 } else { 0.0 }) }, near)
}

/// One ball of a block: what it does to rings and cage, and its result.
#[inline(always)]
fn ball(
    of: &Of<'_>,
    (balls, pressed, kick_forces): (&[Lane; BALL], &Pressed, &KickForces),
    (slides, (ellipses, pockets, leads)): (&Slides, Beside<'_>),
    k: usize,
) -> (Sums, BallResult) {
    let (machine, b) = (of.machine, get(balls, k));
    let contact = |side: Side| {
        let mut sliding_contact = SlidingContact::NONE;
        sliding_contact.take(get(&slides.of[side as usize], k));
        // None, but with the axis that the longer semi-axis is along.
        let mut ellipse = of.springs.ellipse(side, 0.0);
        [ellipse.semi_major, ellipse.semi_minor, ellipse.peak_pressure] = get(&ellipses[side as usize], k);
        RaceContact::new(side, pressed.contact(side, k), ellipse, &sliding_contact.sliding, sliding_contact.traction)
    };
    let contacts = Races { inner: contact(Side::Inner), outer: contact(Side::Outer) };
    let mut pocket = PocketLoad::none();
    pocket.take(get(pockets, k));
    let (drag, churning) = kick_forces.fluid(k);
    let touched = Touched {
        state: pressed.state_of(machine, &b, k),
        surfaces: Races { inner: pressed.surface(Side::Inner, k), outer: pressed.surface(Side::Outer, k) },
        loads: BallLoads { contacts, orbit_radius: pressed.orbit_radius(k), drag, churning },
        pocket,
        lead: leads.0[k],
    };
    let (forces, mut sums) = (machine.together(touched), Sums::default());
    machine.add_ball(&forces, [b[VELOCITY], b[VELOCITY + 1]], &of.frame, &mut sums);
    (sums, ball_result(&of.sheet, (&b, of.frame.rings.inner.speed), &forces))
}

/// How all balls of a block slide. By itself: a loop that has more than 250 rows of lanes before it is too much for the
/// compiler to make vector instructions of it.
#[inline(always)]
fn slide_all(
    of: &Of<'_>,
    (balls, pressed): (&[Lane; BALL], &Pressed),
    (forms, mean_forces): (&Forms, &[Lane; 6]),
    out: &mut Slides,
) {
    let of = of.held();
    for k in pressed.in_use.lanes() {
        let state = pressed.state(of.machine, balls, k);
        let (inner, near_inner) =
            sliding_contact((&of, Side::Inner), &state, (pressed, &forms.traction[0], k), mean_forces);
        let (outer, near_outer) =
            sliding_contact((&of, Side::Outer), &state, (pressed, &forms.traction[1], k), mean_forces);
        put(&mut out.of[0], k, inner.numbers());
        put(&mut out.of[1], k, outer.numbers());
        out.near.0[k] = near_inner * near_outer;
    }
}

/// All balls of a block.
#[inline(always)]
fn sample_block<const ALL: bool>(
    of: &Of<'_>,
    at: (&[Lane; BALL], &Pressed, &KickForces),
    beside: (&Slides, Beside<'_>),
    out: &mut Sampled,
) {
    let (of, in_use) = (of.held(), at.1.in_use);
    for k in in_use.lanes() {
        let (sums, result) = ball(&of, at, beside, k);
        put(&mut out.sums, k, sums.of_held());
        let Races { inner, outer } = &result.contacts;
        put(&mut out.ball, k, result.numbers());
        put(&mut out.pocket, k, result.pocket.unwrap_or_default().numbers());
        put(&mut out.contacts[0], k, inner.numbers());
        put(&mut out.contacts[1], k, outer.numbers());
        if ALL {
            put(&mut out.fluid, k, result.fluid.unwrap_or_default().numbers());
            put(&mut out.motion, k, result.motion.unwrap_or_default().numbers());
            put(&mut out.frictions[0], k, inner.friction.unwrap_or_default().numbers());
            put(&mut out.frictions[1], k, outer.friction.unwrap_or_default().numbers());
            put(&mut out.transients[0], k, inner.transient.unwrap_or_default().numbers());
            put(&mut out.transients[1], k, outer.transient.unwrap_or_default().numbers());
        }
    }
}
