//! The terms of the power balance: their list stands here once, for balances, recordings, summaries and reports.

use serde::{Deserialize, Serialize};
use tribodyn_bearing::place;
use tribodyn_bearing::quantities::{Get, Quantity, Scope, Set, WATT};

/// Where power comes from and where it goes, W, and the energy stored, J. In is what drives, every loss is positive:
/// shaft + loads = friction + drag + churning + damping + pocket + cage + supports + d(energy)/dt.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct PowerSample {
    /// Of both rings' drives.
    pub shaft_w: f64,
    /// Of the external loads on the rings.
    pub load_w: f64,
    /// Friction of all inner contacts.
    pub friction_inner_w: f64,
    /// Friction of all outer contacts.
    pub friction_outer_w: f64,
    /// Drag on the balls.
    pub drag_w: f64,
    /// Churning of the balls.
    pub churning_w: f64,
    /// Damping of the ball–race contacts.
    pub contact_damping_w: f64,
    /// Friction in the cage pockets.
    pub pocket_friction_w: f64,
    /// Damping in the cage pockets.
    pub pocket_damping_w: f64,
    /// Drag and guidance of the cage.
    pub cage_w: f64,
    /// Dampers of the supports.
    pub support_w: f64,
    /// Kinetic and elastic energy, J, those of the prescribed rotation of the rings left out.
    pub energy_j: f64,
    /// Elastic energy that wear has taken out of the contacts since the start by what it does to the raceways, J; less
    /// than 0 where it lets a load down.
    pub wear_work_j: f64,
    /// Error of the balance integrated from the start: work in − losses − wear − change of energy, J.
    pub imbalance_j: f64,
    /// Work put in from the start, all sources, magnitudes summed, or work lost where that is more, as where balls slow
    /// down, J: what the imbalance is compared with.
    pub throughput_j: f64,
}

type P = Quantity<PowerSample>;

const fn term([name, label, about]: [&'static str; 3], at: (Get<PowerSample>, Set<PowerSample>)) -> P {
    P::new([name, label, about], [WATT; 2], at).in_scope(Scope::Run)
}

/// Powers that drive.
pub static POWER_IN: [Quantity<PowerSample>; 2] = [
    term(["shaft", "shaft", "Power of the drives of both rings"], place!(.shaft_w)),
    term(["load", "loads", "Power of the external loads on the rings"], place!(.load_w)),
];

/// Powers lost.
pub static POWER_LOST: [Quantity<PowerSample>; 9] = [
    term(
        ["friction_inner", "friction, inner race", "Frictional power of all inner contacts"],
        place!(.friction_inner_w),
    ),
    term(
        ["friction_outer", "friction, outer race", "Frictional power of all outer contacts"],
        place!(.friction_outer_w),
    ),
    term(["drag", "drag on the balls", "Power taken by the drag on the balls"], place!(.drag_w)),
    term(["churning", "churning of the balls", "Power taken by the churning of the balls"], place!(.churning_w)),
    term(
        ["contact_damping", "contact damping", "Power taken by the damping of the ball–race contacts"],
        place!(.contact_damping_w),
    ),
    term(
        ["pocket_friction", "pocket friction", "Power taken by friction in the cage pockets"],
        place!(.pocket_friction_w),
    ),
    term(["pocket_damping", "pocket damping", "Power taken by damping in the cage pockets"], place!(.pocket_damping_w)),
    term(["cage", "cage drag and guidance", "Power taken by drag and guidance of the cage"], place!(.cage_w)),
    term(["support", "support dampers", "Power taken by the dampers of the supports"], place!(.support_w)),
];

impl PowerSample {
    /// Power of all that drives, W.
    pub fn put_in(&self) -> f64 {
        self.sum(&POWER_IN)
    }

    /// Power lost, W.
    pub fn lost(&self) -> f64 {
        self.sum(&POWER_LOST)
    }

    fn sum(&self, terms: &[Quantity<Self>]) -> f64 {
        terms.iter().filter_map(|term| (term.get)(self)).sum()
    }
}
