//! Newton steps of a periodic solution by collocation: the points of each interval follow from its beginning and from
//! the border, the unknowns of the whole period, so that only the start of the period and the border are left.
//!
//! Motion with friction forgets: the product of the intervals' transfer matrices stays small, and the elimination from
//! one interval to the next is stable. A sparse factorisation of the same chain takes ten times as long.
//!
//! Sizes: `N` unknowns at a place of the period, `B` of the border, `S` = 3 N at the points of an interval, `F` = N + B
//! that these follow from.

use nalgebra::{Const, DimMin, LU, SMatrix, SVector, ToTypenum};

/// Linearised equations that have no one solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the linearised equations are singular")]
pub struct Singular;

/// Slopes of an interval's equations.
#[derive(Debug, Clone)]
pub struct Interval<const S: usize, const B: usize, const F: usize> {
    /// Equations of the points by the points.
    pub own: Box<SMatrix<f64, S, S>>,
    /// Less equations of the points by the beginning of the interval and the border.
    pub right: Box<SMatrix<f64, S, F>>,
    /// Equations of the border by the points.
    pub rows: Box<SMatrix<f64, B, S>>,
}

/// An interval with its points eliminated.
#[derive(Debug)]
struct Eliminated<const S: usize, const B: usize, const F: usize>
where
    Const<S>: DimMin<Const<S>, Output = Const<S>>,
{
    lu: LU<f64, Const<S>, Const<S>>,
    /// Points by beginning and border.
    back: Box<SMatrix<f64, S, F>>,
    rows: Box<SMatrix<f64, B, S>>,
    /// Border rows by beginning and border, through the points.
    coupling: SMatrix<f64, B, F>,
}

/// The linearised equations of a period, factorised.
#[derive(Debug)]
pub struct Periodic<const N: usize, const S: usize, const B: usize, const F: usize>
where
    Const<S>: DimMin<Const<S>, Output = Const<S>>,
    Const<F>: DimMin<Const<F>, Output = Const<F>>,
{
    intervals: Vec<Eliminated<S, B, F>>,
    /// Start of the period and border.
    lu: LU<f64, Const<F>, Const<F>>,
    transfer: SMatrix<f64, N, N>,
}

/// A change of all unknowns, or what their equations lack.
#[derive(Debug, Clone, PartialEq)]
pub struct Change<const S: usize, const B: usize> {
    /// Of the points of each interval, unknowns of one point after those of the other.
    pub values: Vec<[f64; S]>,
    /// Of the border.
    pub border: [f64; B],
}

impl<const S: usize, const B: usize> Change<S, B> {
    /// Root of the mean square of the points with the square of the border.
    pub fn norm(&self) -> f64 {
        self.dot(self).sqrt()
    }

    /// Product in which all points together weigh as much as the border.
    fn dot(&self, other: &Self) -> f64 {
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let points: f64 = self.values.iter().zip(&other.values).map(|(a, b)| product(a, b)).sum();
        points / (self.values.len() * S) as f64 + product(&self.border, &other.border)
    }

    /// How far it goes along another, as a share of that.
    fn along(&self, other: &Self) -> f64 {
        let length = other.dot(other);
        if length > 0.0 { self.dot(other) / length } else { 0.0 }
    }

    /// A simplified Newton step by what the steps before it, each taken whole, tell of the Jacobian: Broyden's update
    /// in the form of P. Deuflhard, Newton Methods for Nonlinear Problems, 2011, section 2.1.4.
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

impl<const N: usize, const S: usize, const B: usize, const F: usize> Periodic<N, S, B, F>
where
    Const<S>: DimMin<Const<S>, Output = Const<S>> + ToTypenum,
    Const<F>: DimMin<Const<F>, Output = Const<F>> + ToTypenum,
{
    /// Row of the end of an interval in its points.
    const END: usize = S - N;

    /// Eliminates the points, then the intervals. `direct` holds the border's equations by the border itself.
    ///
    /// # Errors
    /// [`Singular`].
    pub fn new(slopes: Vec<Interval<S, B, F>>, direct: &[[f64; B]; B]) -> Result<Self, Singular> {
        const { assert!(S.is_multiple_of(N) && F == N + B) }
        let mut intervals = Vec::with_capacity(slopes.len());
        for Interval { own, mut right, rows } in slopes {
            let lu = own.lu();
            if !lu.solve_mut(&mut *right) {
                return Err(Singular);
            }
            let coupling = *rows * *right;
            intervals.push(Eliminated { lu, back: right, rows, coupling });
        }
        // Beginning of an interval by the start of the period and the border.
        let mut by_start = SMatrix::<f64, N, N>::identity();
        let mut by_border = SMatrix::<f64, N, B>::zeros();
        let mut all = SMatrix::<f64, F, F>::zeros();
        for (k, row) in direct.iter().enumerate() {
            (0..B).for_each(|c| all[(N + k, N + c)] = row[c]);
        }
        for interval in &intervals {
            let through = interval.coupling.fixed_columns::<N>(0);
            let mut rows = all.fixed_view_mut::<B, N>(N, 0);
            rows += through * by_start;
            let mut rows = all.fixed_view_mut::<B, B>(N, N);
            rows += through * by_border + interval.coupling.fixed_columns::<B>(N);
            let end = interval.back.fixed_rows::<N>(Self::END);
            let transfer = end.fixed_columns::<N>(0).into_owned();
            by_border = transfer * by_border + end.fixed_columns::<B>(N);
            by_start = transfer * by_start;
        }
        let closing = SMatrix::<f64, N, N>::identity() - by_start;
        all.fixed_view_mut::<N, N>(0, 0).copy_from(&closing);
        all.fixed_view_mut::<N, B>(0, N).copy_from(&-by_border);
        let lu = all.lu();
        if !all.iter().all(|v| v.is_finite()) || !lu.is_invertible() {
            return Err(Singular);
        }
        Ok(Self { intervals, lu, transfer: by_start })
    }

    /// Intervals of its mesh.
    pub fn intervals(&self) -> usize {
        self.intervals.len()
    }

    /// End of the period by its start, the border held: its eigenvalues are Floquet's multipliers.
    pub fn transfer(&self) -> &SMatrix<f64, N, N> {
        &self.transfer
    }

    /// The change that takes away what the equations lack: residuals of the points of each interval, and of the border.
    pub fn step(&self, residuals: &[[f64; S]], border: &[f64; B]) -> Change<S, B> {
        let mut free: Vec<SVector<f64, S>> = Vec::with_capacity(self.intervals.len());
        let mut begin = SVector::<f64, N>::zeros();
        let mut edge = -SVector::<f64, B>::from(*border);
        for (interval, r) in self.intervals.iter().zip(residuals) {
            let mut own = -SVector::<f64, S>::from(*r);
            interval.lu.solve_mut(&mut own);
            edge -= interval.coupling.fixed_columns::<N>(0) * begin + *interval.rows * own;
            let end = interval.back.fixed_rows::<N>(Self::END);
            begin = end.fixed_columns::<N>(0) * begin + own.fixed_rows::<N>(Self::END);
            free.push(own);
        }
        let mut all = SVector::<f64, F>::zeros();
        all.fixed_rows_mut::<N>(0).copy_from(&begin);
        all.fixed_rows_mut::<B>(N).copy_from(&edge);
        self.lu.solve_mut(&mut all);
        // From here on `all` holds the beginning of an interval with the border.
        let border = std::array::from_fn(|k| all[N + k]);
        let values = self.intervals.iter().zip(free).map(|(interval, own)| {
            let points = own + *interval.back * all;
            all.fixed_rows_mut::<N>(0).copy_from(&points.fixed_rows::<N>(Self::END));
            points.into()
        });
        Change { values: values.collect(), border }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Step = Change<6, 2>;

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
        let mut u = Step { values: vec![[0.3; 6], [-0.2; 6]], border: [0.5; 2] };
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
