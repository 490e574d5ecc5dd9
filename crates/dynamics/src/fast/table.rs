//! Linear forms of contacts before, for those that come by the same motion and load again: balls follow one another on
//! nearly one orbit, so that few patches are integrated once the first has been round.
//!
//! A form serves any contact of its race within its reach. That was found along the way of one ball, and others may
//! come from elsewhere: a form is held against the integral the first time that it serves, the second, the fourth and
//! so on, and gives way to one with a shorter reach where it errs by more than it may. This is in situ adaptive
//! tabulation, S. B. Pope, Combust. Theory Model. 1 (1997) 41, doi:10.1088/713665229.

use super::lanes::{Lane, WIDTH, put};
use crate::linear::{LOAD_AS_SLIP, LinearTraction};
use crate::machine::Machine;
use fearless_simd::{Level, dispatch};
use serde::{Deserialize, Serialize};
use tribodyn_bearing::{LoadedPatch, Side};
use tribodyn_traction::PatchTraction;

/// Forms that are kept of a race; then the oldest gives way. A 6206 in oil comes by some eighty on its orbit, and by
/// several hundred where balls strike a spall.
const KEPT: usize = 512;
/// Share of its reach within which a form serves a contact that it was not made at.
const AGAIN_WITHIN: f64 = 0.9;
/// The same of the load alone, with a margin for rounding.
const LOAD_WITHIN: f64 = 1.001 * AGAIN_WITHIN / LOAD_AS_SLIP;

/// Forms of the inner and the outer race.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Table {
    forms: [Vec<Kept>; 2],
    /// Places of the oldest, once the lists are full.
    oldest: [usize; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Kept {
    form: LinearTraction,
    /// How often it served.
    served: u64,
}

/// Numbers that tell where a form serves: those before its traction, and those after. Which of them are load and reach.
const KEYS: usize = LinearTraction::NUMBERS - OF_TRACTION;
const OF_TRACTION: usize = LinearTraction::OF_TRACTION.end - LinearTraction::OF_TRACTION.start;
const KEY_OF_LOAD: usize = 5;
const KEY_OF_REACH: usize = LinearTraction::SEMI_LATERAL + 1 - OF_TRACTION;
/// Where the forms of a block serve.
pub(super) type Keys = [Lane; KEYS];
/// The forms of one race in lanes, in which they are searched by the vector instructions of a level.
type InLanes<'a> = (Side, Level, &'a mut Vec<Keys>);

impl Table {
    /// Length of the longer list, and the longest that it may have.
    pub fn size(&self) -> [usize; 2] {
        [self.forms[0].len().max(self.forms[1].len()), KEPT]
    }

    /// All numbers.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.forms.iter().flatten().flat_map(|kept| kept.form.values())
    }

    /// Traction of a contact whose form does not serve any more, and whether it is integrated; `form` becomes that of
    /// the table which is nearest, or one that is made here.
    pub fn traction(
        &mut self,
        (side, level, lanes): InLanes<'_>,
        form: &mut LinearTraction,
        (machine, p, tolerance): (&Machine, &LoadedPatch<'_, f64>, f64),
    ) -> (PatchTraction, bool) {
        let forms = &mut self.forms[side as usize];
        if lanes.len() != forms.len().div_ceil(WIDTH) {
            lanes.clear();
            forms.iter().enumerate().for_each(|(at, kept)| set(lanes, at, &kept.form));
        }
        // Forms know nothing of contact constants that follow the contact angle.
        let shared = !machine.bearing.modelling.contact_at_actual_angle;
        let known = shared.then(|| dispatch!(level, _simd => nearest(lanes, p))).flatten();
        let Some(at) = known else {
            let traction = form.refresh(machine, p, tolerance);
            if shared && form.reach_is_found() {
                self.keep(side, form, lanes);
            }
            return (traction, true);
        };
        let kept = &mut forms[at];
        kept.served = kept.served.saturating_add(1);
        if !kept.served.is_power_of_two() {
            return (form.give_way(kept.form, p), false);
        }
        let traction = form.refresh(machine, p, tolerance);
        let found = kept.form.error_at(p, &traction);
        if found[0] > tolerance {
            form.narrow(found, tolerance);
            *kept = Kept { form: *form, served: 0 };
            set(lanes, at, form);
        }
        (traction, true)
    }

    fn keep(&mut self, side: Side, form: &LinearTraction, lanes: &mut Vec<Keys>) {
        let (forms, oldest) = (&mut self.forms[side as usize], &mut self.oldest[side as usize]);
        let new = Kept { form: *form, served: 0 };
        let at = if forms.len() < KEPT { forms.len() } else { *oldest % KEPT };
        match forms.get_mut(at) {
            Some(form) => (*form, *oldest) = (new, at + 1),
            None => {
                forms.reserve_exact(KEPT - forms.len());
                forms.push(new);
            }
        }
        set(lanes, at, form);
    }
}

/// Puts a form into its lane.
fn set(lanes: &mut Vec<Keys>, at: usize, form: &LinearTraction) {
    if at / WIDTH == lanes.len() {
        lanes.reserve_exact(KEPT.div_ceil(WIDTH) - lanes.len());
        // Without a reach: none of them is near.
        lanes.push([Lane::ZERO; KEYS]);
    }
    put(&mut lanes[at / WIDTH], at % WIDTH, keys(form));
}

fn keys(form: &LinearTraction) -> [f64; KEYS] {
    let numbers = form.numbers();
    std::array::from_fn(|i| numbers[if i < LinearTraction::OF_TRACTION.start { i } else { i + OF_TRACTION }])
}

/// A form that knows where it serves, and no more.
#[inline(always)]
fn with_keys(keys: impl Fn(usize) -> f64) -> LinearTraction {
    LinearTraction::from_numbers(|i| match i {
        _ if i < LinearTraction::OF_TRACTION.start => keys(i),
        _ if i < LinearTraction::OF_TRACTION.end => 0.0,
        _ => keys(i - OF_TRACTION),
    })
}

/// Place of the nearest form, over its reach, that serves a contact.
#[inline(always)]
fn nearest(lanes: &[Keys], p: &LoadedPatch<'_, f64>) -> Option<usize> {
    let (mut least, mut at) = (Lane::all(f64::INFINITY), Lane::ZERO);
    for (block, forms) in lanes.iter().enumerate() {
        if !any_has_load(forms, p.load) {
            continue;
        }
        for k in 0..WIDTH {
            let distance = with_keys(|i| forms[i].0[k]).distance_to(p, AGAIN_WITHIN);
            let nearer = distance < least.0[k];
            least.0[k] = if nearer { distance } else { least.0[k] };
            at.0[k] = if nearer { block as f64 } else { at.0[k] };
        }
    }
    let k = (0..WIDTH).min_by(|&a, &b| least.0[a].total_cmp(&least.0[b]))?;
    least.0[k].is_finite().then(|| WIDTH * at.0[k] as usize + k)
}

/// True if a load alone is within the reach of a form: most are made at others.
#[inline(always)]
fn any_has_load(forms: &Keys, load: f64) -> bool {
    let (of, reach) = (&forms[KEY_OF_LOAD].0, &forms[KEY_OF_REACH].0);
    let mut any = false;
    for k in 0..WIDTH {
        any |= (load - of[k]).abs() <= LOAD_WITHIN * reach[k] * of[k];
    }
    any
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::equations::Equations;
    use crate::start::{Started, start};
    use tribodyn_case::{Case, set_value};
    use tribodyn_traction::RelativeMotion;

    const TOLERANCE: f64 = 1e-3;

    /// Does something with the contact of a loaded ball of a 6206 in oil, its sliding speed changed by so much, m/s.
    fn at_slip(by: f64, mut of: impl FnMut(&Machine, &LoadedPatch<'_, f64>) -> PatchTraction) {
        let text = include_str!("../../../../fixtures/cases/oil-6206.ron");
        let case = Case::from_ron(&set_value(text, "transient.start", "QuasiStatic").unwrap()).unwrap();
        let Started { machine, state, .. } = start(case.run_inputs().unwrap(), None).unwrap();
        machine.ball(0, machine.unknowns(0, &state), &machine.frame(0.0, &state), |patch, _| {
            let motion = RelativeMotion { rolling: patch.motion.rolling + by, ..patch.motion };
            let moved = LoadedPatch { motion, ..*patch };
            if patch.side == Side::Outer {
                of(&machine, &moved)
            } else {
                machine.kernel.traction(&machine.bearing, patch)
            }
        });
    }

    /// A form whose reach is much too long errs beyond it only once: it is held against the integral as it serves for
    /// the first time, and gives way.
    #[test]
    fn limit_a_form_that_errs_is_found_out_at_its_first_use() {
        let (mut table, mut lanes, mut form) = (Table::default(), Vec::new(), LinearTraction::default());
        let mut use_at = |slip: f64, table: &mut Table, form: &mut LinearTraction| {
            let mut found = ([0.0; 2], true);
            at_slip(slip, |machine, patch| {
                let list = (Side::Outer, Level::new(), &mut lanes);
                let (traction, integrated) = table.traction(list, form, (machine, patch, TOLERANCE));
                let exact = machine.kernel.traction(&machine.bearing, patch);
                let off =
                    (traction.force_rolling - exact.force_rolling).hypot(traction.force_lateral - exact.force_lateral);
                found = ([off / patch.load, form.numbers()[REACH]], integrated);
                traction
            });
            found
        };
        let ([_, guess], integrated) = use_at(0.0, &mut table, &mut form);
        assert!(integrated && table.size()[0] == 0, "a guess of {guess} m/s is not kept");
        let mut numbers = form.numbers();
        (numbers[REACH], numbers[REACH + 1]) = (1.0, 1.0);
        let too_far = LinearTraction::from_numbers(|i| numbers[i]);
        table.forms[Side::Outer as usize].push(Kept { form: too_far, served: 0 });
        let ([off, reach], integrated) = use_at(0.1, &mut table, &mut form);
        assert!(integrated && off < TOLERANCE && reach < 0.1, "{off:e} within {reach} m/s");
        // At the place where the new one was made: held against the integral twice, then not.
        let integrated: Vec<bool> = (0..4).map(|_| use_at(0.1, &mut table, &mut form).1).collect();
        assert_eq!(integrated, [true, true, false, true]);
        assert!(use_at(0.1, &mut table, &mut form).0[0] < 1e-9);
    }

    /// Forms that the search passes over by their load alone are out of reach: it finds what the forms themselves say.
    #[test]
    fn identity_the_search_finds_the_nearest_form() {
        let form = std::cell::Cell::new(LinearTraction::default());
        at_slip(0.0, |machine, patch| {
            let mut made = LinearTraction::default();
            let traction = made.refresh(machine, patch, TOLERANCE);
            let of_load = |k: usize| {
                let mut numbers = made.numbers();
                numbers[KEY_OF_LOAD] *= 1.04f64.powi(k as i32 - 30);
                (numbers[REACH], numbers[REACH + 1]) = (0.01 * (1 + k % 7) as f64, 1.0);
                LinearTraction::from_numbers(|i| numbers[i])
            };
            let (forms, mut lanes): (Vec<_>, _) = ((0..61).map(of_load).collect(), Vec::new());
            forms.iter().enumerate().for_each(|(at, form)| set(&mut lanes, at, form));
            let mut found = 0;
            for k in 0..400 {
                let p = LoadedPatch { load: patch.load * 1.007f64.powi(k - 200), ..*patch };
                let distance = |form: &LinearTraction| form.distance_to(&p, AGAIN_WITHIN);
                let least = forms.iter().map(distance).fold(f64::INFINITY, f64::min);
                let searched = nearest(&lanes, &p).map_or(f64::INFINITY, |at| distance(&forms[at]));
                assert!(least == searched, "load {}: {searched} and {least}", p.load);
                found += usize::from(least.is_finite());
            }
            assert!((100..390).contains(&found), "{found} of 400 within reach");
            form.set(made);
            traction
        });
        assert!(form.get() != LinearTraction::default());
    }

    /// Place of the reach among the numbers of a form.
    const REACH: usize = LinearTraction::SEMI_LATERAL + 1;
}
