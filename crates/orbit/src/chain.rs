//! The linearised orbit: the points of each interval follow from its beginning and from cage speed and ring, so that
//! only the start of the turn and the border are left as unknowns.
//!
//! Motion with friction forgets: the product of the intervals' transfer matrices stays small, and the elimination from
//! one interval to the next is stable. A sparse factorisation of the same chain takes ten times as long.

use crate::OrbitError;
use crate::collocation::STAGES;
use crate::residual::{BORDER, Residual, STACK};
use crate::system::BALL;
use nalgebra::{Const, LU, SMatrix, SVector};

/// Unknowns that an interval's points follow from: its beginning, cage speed and ring.
pub(crate) const FROM: usize = BALL + BORDER;

/// Slopes of an interval's equations, over the scales.
pub(crate) struct Slopes {
    /// Equations of the points by the points.
    pub own: Box<SMatrix<f64, STACK, STACK>>,
    /// Less equations of the points by beginning and border.
    pub right: Box<SMatrix<f64, STACK, FROM>>,
    /// Border rows by the points.
    pub rows: Box<SMatrix<f64, BORDER, STACK>>,
}

/// An interval with its points eliminated.
#[derive(Debug)]
struct Interval {
    lu: LU<f64, Const<STACK>, Const<STACK>>,
    /// Points by beginning and border.
    back: Box<SMatrix<f64, STACK, FROM>>,
    rows: Box<SMatrix<f64, BORDER, STACK>>,
    /// Border rows by beginning and border, through the points.
    coupling: SMatrix<f64, BORDER, FROM>,
}

/// The linearised orbit, factorised.
#[derive(Debug)]
pub(crate) struct Linear {
    intervals: Vec<Interval>,
    /// Start of the turn and border.
    lu: LU<f64, Const<FROM>, Const<FROM>>,
    /// End of the turn by its start, cage and ring held.
    turn: SMatrix<f64, BALL, BALL>,
}

/// A change of all unknowns, over their scales.
pub(crate) struct Step {
    pub values: Vec<[f64; STACK]>,
    pub border: [f64; BORDER],
}

impl Step {
    pub fn norm(&self) -> f64 {
        self.dot(self).sqrt()
    }

    /// Product in which all points together weigh as much as the border.
    fn dot(&self, other: &Self) -> f64 {
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let points: f64 = self.values.iter().zip(&other.values).map(|(a, b)| product(a, b)).sum();
        points / (self.values.len() * STACK) as f64 + product(&self.border, &other.border)
    }

    /// How far it goes along another, as a share of that.
    fn along(&self, other: &Self) -> f64 {
        let length = other.dot(other);
        if length > 0.0 { self.dot(other) / length } else { 0.0 }
    }

    /// A simplified step by what the steps before it, each taken whole, tell of the Jacobian.
    pub fn corrected(mut self, taken: &[Self]) -> Self {
        for pair in taken.windows(2) {
            let share = self.along(&pair[0]);
            let add = |v: &mut f64, d: &f64| *v += share * d;
            let points = self.values.iter_mut().zip(&pair[1].values);
            points.for_each(|(a, b)| a.iter_mut().zip(b).for_each(|(v, d)| add(v, d)));
            self.border.iter_mut().zip(&pair[1].border).for_each(|(v, d)| add(v, d));
        }
        self
    }

    /// The same by the step just taken: what is left along it is as much too short again.
    pub fn lengthened(mut self, last: &Self) -> Self {
        let factor = 1.0 / (1.0 - self.along(last));
        self.values.iter_mut().flatten().chain(&mut self.border).for_each(|v| *v *= factor);
        self
    }
}

type Start = SVector<f64, BALL>;
type Edge = SVector<f64, BORDER>;
const END: usize = (STAGES - 1) * BALL;

impl Linear {
    /// Eliminates the points, then the intervals. `direct` holds the border rows by the border itself.
    ///
    /// # Errors
    /// [`OrbitError::Singular`].
    pub fn new(slopes: Vec<Slopes>, direct: &[[f64; BORDER]; BORDER]) -> Result<Self, OrbitError> {
        let mut intervals = Vec::with_capacity(slopes.len());
        for Slopes { own, mut right, rows } in slopes {
            let lu = own.lu();
            if !lu.solve_mut(&mut *right) {
                return Err(OrbitError::Singular);
            }
            let coupling = *rows * *right;
            intervals.push(Interval { lu, back: right, rows, coupling });
        }
        // Beginning of an interval by the start of the turn and the border.
        let mut by_start = SMatrix::<f64, BALL, BALL>::identity();
        let mut by_border = SMatrix::<f64, BALL, BORDER>::zeros();
        let mut all = SMatrix::<f64, FROM, FROM>::zeros();
        for (k, row) in direct.iter().enumerate() {
            (0..BORDER).for_each(|c| all[(BALL + k, BALL + c)] = row[c]);
        }
        for interval in &intervals {
            let through = interval.coupling.fixed_columns::<BALL>(0);
            let mut rows = all.fixed_view_mut::<BORDER, BALL>(BALL, 0);
            rows += through * by_start;
            let mut rows = all.fixed_view_mut::<BORDER, BORDER>(BALL, BALL);
            rows += through * by_border + interval.coupling.fixed_columns::<BORDER>(BALL);
            let end = interval.back.fixed_rows::<BALL>(END);
            let transfer = end.fixed_columns::<BALL>(0).into_owned();
            by_border = transfer * by_border + end.fixed_columns::<BORDER>(BALL);
            by_start = transfer * by_start;
        }
        let closing = SMatrix::<f64, BALL, BALL>::identity() - by_start;
        all.fixed_view_mut::<BALL, BALL>(0, 0).copy_from(&closing);
        all.fixed_view_mut::<BALL, BORDER>(0, BALL).copy_from(&-by_border);
        let lu = all.lu();
        if !all.iter().all(|v| v.is_finite()) || !lu.is_invertible() {
            return Err(OrbitError::Singular);
        }
        Ok(Self { intervals, lu, turn: by_start })
    }

    /// Intervals of its mesh.
    pub fn intervals(&self) -> usize {
        self.intervals.len()
    }

    /// Largest modulus of a Floquet multiplier of a ball over the turn, cage and ring held: below one, a ball that is
    /// moved off its orbit comes back to it.
    pub fn multiplier(&self) -> f64 {
        self.turn.complex_eigenvalues().iter().map(|v| v.re.hypot(v.im)).fold(0.0, f64::max)
    }

    /// The change that takes residuals away.
    pub fn step(&self, residual: &Residual) -> Step {
        let mut free: Vec<SVector<f64, STACK>> = Vec::with_capacity(self.intervals.len());
        let mut begin = Start::zeros();
        let mut edge = -Edge::from(residual.border);
        for (interval, r) in self.intervals.iter().zip(&residual.intervals) {
            let mut own = -SVector::<f64, STACK>::from(*r);
            interval.lu.solve_mut(&mut own);
            edge -= interval.coupling.fixed_columns::<BALL>(0) * begin + *interval.rows * own;
            let end = interval.back.fixed_rows::<BALL>(END);
            begin = end.fixed_columns::<BALL>(0) * begin + own.fixed_rows::<BALL>(END);
            free.push(own);
        }
        let mut all = SVector::<f64, FROM>::zeros();
        all.fixed_rows_mut::<BALL>(0).copy_from(&begin);
        all.fixed_rows_mut::<BORDER>(BALL).copy_from(&edge);
        self.lu.solve_mut(&mut all);
        // From here on `all` holds the beginning of an interval with the border.
        let border = std::array::from_fn(|k| all[BALL + k]);
        let values = self.intervals.iter().zip(free).map(|(interval, own)| {
            let points = own + *interval.back * all;
            all.fixed_rows_mut::<BALL>(0).copy_from(&points.fixed_rows::<BALL>(END));
            points.into()
        });
        Step { values: values.collect(), border }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The step −A x of a Jacobian taken as one, where it is 1 + c u uᵀ with u a unit vector.
    fn simplified(x: &Step, u: &Step, c: f64) -> Step {
        let along = c * x.dot(u);
        let of = |x: f64, u: f64| -(x + along * u);
        let values = x.values.iter().zip(&u.values);
        let values = values.map(|(x, u)| std::array::from_fn(|n| of(x[n], u[n]))).collect();
        Step { values, border: std::array::from_fn(|n| of(x.border[n], u.border[n])) }
    }

    fn added(x: &Step, step: &Step) -> Step {
        let values = x.values.iter().zip(&step.values);
        let values = values.map(|(x, d)| std::array::from_fn(|n| x[n] + d[n])).collect();
        Step { values, border: std::array::from_fn(|n| x.border[n] + step.border[n]) }
    }

    #[test]
    fn identity_what_a_jacobian_errs_by_in_one_direction_is_learnt_from_a_step() {
        let mut u = Step { values: vec![[0.3; STACK], [-0.2; STACK]], border: [0.5; BORDER] };
        let length = u.norm();
        u.values.iter_mut().flatten().chain(&mut u.border).for_each(|v| *v /= length);
        let c = 0.4;
        let first = simplified(&u, &u, c);
        let mut x = added(&u, &first);
        let mut taken = vec![first];
        let next = simplified(&x, &u, c).corrected(&taken).lengthened(&taken[0]);
        x = added(&x, &next);
        taken.push(next);
        assert!(x.norm() < 1e-15, "{:e}", x.norm());
        // Without it each step leaves c of the error.
        assert!((simplified(&added(&u, &taken[0]), &u, c).norm() - c * (1.0 + c)).abs() < 1e-14);
    }
}
