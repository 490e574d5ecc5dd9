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
struct Interval {
    lu: LU<f64, Const<STACK>, Const<STACK>>,
    /// Points by beginning and border.
    back: Box<SMatrix<f64, STACK, FROM>>,
    rows: Box<SMatrix<f64, BORDER, STACK>>,
    /// Border rows by beginning and border, through the points.
    coupling: SMatrix<f64, BORDER, FROM>,
}

/// The linearised orbit, factorised.
pub(crate) struct Linear {
    intervals: Vec<Interval>,
    /// Start of the turn and border.
    lu: LU<f64, Const<FROM>, Const<FROM>>,
}

/// A change of all unknowns, over their scales.
pub(crate) struct Step {
    pub values: Vec<[f64; STACK]>,
    pub border: [f64; BORDER],
}

impl Step {
    pub fn norm(&self) -> f64 {
        let points: f64 = self.values.iter().flatten().map(|v| v * v).sum();
        let points = points / (self.values.len() * STACK) as f64;
        (points + self.border.iter().map(|v| v * v).sum::<f64>()).sqrt()
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
        Ok(Self { intervals, lu })
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
