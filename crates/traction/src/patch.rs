//! Traction of one contact patch: force, moment, power and wear integral with spin, lateral and differential slip.

use crate::{
    Conditions, FastPatch, PatchDerivative, PressureChoice, Quadrature, Scalar, SlipCurve, SlipUnit, TractionLaw,
};

/// The contact ellipse and the surface it lies on.
///
/// Patch axes: n outward from the ball centre, y across the groove, x along rolling, (y, n, x) right-handed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch<D = f64> {
    /// Semi-axis across the groove, m.
    pub semi_lateral: D,
    /// Semi-axis along rolling, m.
    pub semi_rolling: D,
    /// Peak pressure, Pa.
    pub peak_pressure: D,
    /// Ball radius r_b, m.
    pub ball_radius: f64,
    /// Radius of the deformed contact across the groove R_c = 2 r_b r_e/(r_b + r_e), m; infinite without
    /// differential slip.
    pub surface_radius: f64,
}

impl<D: Scalar> Patch<D> {
    /// Without derivatives.
    pub fn re(&self) -> Patch {
        Patch {
            semi_lateral: self.semi_lateral.re(),
            semi_rolling: self.semi_rolling.re(),
            peak_pressure: self.peak_pressure.re(),
            ball_radius: self.ball_radius,
            surface_radius: self.surface_radius,
        }
    }
}

/// Velocity of the ball's surface against the race's over the patch, from the relative rigid motion.
///
/// With h(y) = r_b − y²/(2R_c): Δv_x = W_x + w_y h − w_n y and Δv_y = W_y − w_x h + w_n x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeMotion<D = f64> {
    /// Velocity of the ball centre against the race along rolling, W_x, m/s.
    pub rolling: D,
    /// The same across the groove, W_y, m/s.
    pub lateral: D,
    /// Angular velocity of the ball against the race about the normal (spin), w_n, rad/s.
    pub spin: D,
    /// About the lateral axis (rolling), w_y, rad/s.
    pub about_lateral: D,
    /// About the rolling direction, w_x, rad/s.
    pub about_rolling: D,
}

impl<D: Scalar> RelativeMotion<D> {
    /// Without derivatives.
    pub fn re(&self) -> RelativeMotion {
        RelativeMotion {
            rolling: self.rolling.re(),
            lateral: self.lateral.re(),
            spin: self.spin.re(),
            about_lateral: self.about_lateral.re(),
            about_rolling: self.about_rolling.re(),
        }
    }

    /// Sliding velocity (x along rolling, y lateral) at the patch centre, m/s.
    #[inline(always)]
    pub fn centre_slip(&self, ball_radius: f64) -> [D; 2] {
        [self.rolling + self.about_lateral * ball_radius, self.lateral - self.about_rolling * ball_radius]
    }

    /// Sliding velocity at (x, y) of the patch, m/s: the paper's Eqs. 3 to 5 with every term.
    pub fn slip_at(&self, x: D, y: D, patch: &Patch<D>) -> [D; 2] {
        let arm = D::from(patch.ball_radius) - y * y * (0.5 / patch.surface_radius);
        [
            self.rolling + self.about_lateral * arm - self.spin * y,
            self.lateral - self.about_rolling * arm + self.spin * x,
        ]
    }
}

/// Integrals over one patch, as forces on the ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchTraction<D = f64> {
    /// Traction along rolling, N.
    pub force_rolling: D,
    /// Traction across the groove, N.
    pub force_lateral: D,
    /// Moment about the ball centre, about the lateral axis, N m.
    pub moment_lateral: D,
    /// About the outward normal, N m.
    pub moment_normal: D,
    /// About the rolling direction, N m.
    pub moment_rolling: D,
    /// Frictional power ∬ κ p |Δv|, W.
    pub power: D,
    /// Wear integral ∬ p |Δv|, W (N/s·m): times K_w/H it is Archard's rate.
    pub wear_integral: D,
}

impl<D: Scalar> PatchTraction<D> {
    /// No contact, no traction.
    pub fn zero() -> Self {
        let z = D::zero();
        Self {
            force_rolling: z,
            force_lateral: z,
            moment_lateral: z,
            moment_normal: z,
            moment_rolling: z,
            power: z,
            wear_integral: z,
        }
    }

    /// This and another traction in the shares 1 − `share` and `share`: two surfaces under one patch.
    pub fn mixed_with(&self, other: &Self, share: f64) -> Self {
        self.with(other, |a, b| a * (1.0 - share) + b * share)
    }

    /// The sum of this and another traction.
    pub fn plus(&self, other: &Self) -> Self {
        self.with(other, |a, b| a + b)
    }

    /// Each number of this and another together.
    fn with(&self, other: &Self, of: impl Fn(D, D) -> D) -> Self {
        Self {
            force_rolling: of(self.force_rolling, other.force_rolling),
            force_lateral: of(self.force_lateral, other.force_lateral),
            moment_lateral: of(self.moment_lateral, other.moment_lateral),
            moment_normal: of(self.moment_normal, other.moment_normal),
            moment_rolling: of(self.moment_rolling, other.moment_rolling),
            power: of(self.power, other.power),
            wear_integral: of(self.wear_integral, other.wear_integral),
        }
    }

    /// So many times the traction.
    #[inline(always)]
    pub fn times(&self, factor: D) -> Self {
        Self {
            force_rolling: self.force_rolling * factor,
            force_lateral: self.force_lateral * factor,
            moment_lateral: self.moment_lateral * factor,
            moment_normal: self.moment_normal * factor,
            moment_rolling: self.moment_rolling * factor,
            power: self.power * factor,
            wear_integral: self.wear_integral * factor,
        }
    }

    /// Work of forces and moments on the relative rigid motion, W: the negative of the power.
    pub fn work_on(&self, motion: &RelativeMotion<D>) -> D {
        self.force_rolling * motion.rolling
            + self.force_lateral * motion.lateral
            + self.moment_lateral * motion.about_lateral
            + self.moment_normal * motion.spin
            + self.moment_rolling * motion.about_rolling
    }
}

/// A patch with the ball's motion against the race.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingPatch<D = f64> {
    /// The ellipse.
    pub patch: Patch<D>,
    /// The ball's motion against the race.
    pub motion: RelativeMotion<D>,
    /// Mean of both surface speeds V, m/s, with its sign.
    pub rolling_speed: D,
}

/// The relation of traction to sliding speed: the law, the unit of its slip and the pressure at which it is taken.
#[derive(Debug, Clone, Copy)]
pub struct PatchLaw<'a, L> {
    /// The coating's law.
    pub law: &'a L,
    /// Unit of the slip axis.
    pub slip_unit: SlipUnit,
    /// Pressure at which the curve is taken.
    pub pressure: PressureChoice,
}

impl<L: TractionLaw> PatchLaw<'_, L> {
    /// True where the curve changes from node to node; a film has pressures of its own.
    fn is_local(&self) -> bool {
        self.pressure == PressureChoice::Local && self.law.film().is_none()
    }

    /// The integral by the vector kernel; `None` where the curve changes from node to node, or the law has none in
    /// lanes.
    pub fn fast_traction(&self, contact: &MovingPatch, fast: &FastPatch) -> Option<PatchTraction> {
        if self.is_local() { None } else { self.law.fast_traction(contact, self.slip_unit, fast) }
    }

    /// [`Self::fast_traction`] with its derivatives.
    pub fn fast_derivative(&self, contact: &MovingPatch, fast: &FastPatch) -> Option<PatchDerivative> {
        if self.is_local() { None } else { self.law.fast_derivative(contact, self.slip_unit, fast) }
    }

    /// True where [`Self::fast_derivative`] has an answer.
    pub fn has_derivative(&self) -> bool {
        !self.is_local() && self.law.has_derivative()
    }
}

/// Rolling speed below which a fraction of it is taken of this one instead, m/s: a slide-to-roll ratio has no meaning
/// where nothing rolls, and a ball at rest must still have a finite slope of traction over slip.
pub(crate) const LEAST_ROLLING: f64 = 1e-3;

impl SlipUnit {
    /// s = scale · |Δv|, given the rolling speed V in m/s.
    pub fn scale<D: Scalar>(&self, rolling_speed: D) -> D {
        let speed = rolling_speed.abs();
        let rolling = if speed.re() > LEAST_ROLLING { speed } else { D::from(LEAST_ROLLING) };
        match *self {
            Self::MeterPerSecond => D::one(),
            Self::PercentOfRolling => rolling.recip() * 100.0,
            Self::PerMilleOfRolling => rolling.recip() * 1000.0,
            Self::Scaled { per_m_s } => D::from(per_m_s),
        }
    }
}

/// Integrates −κ(s) p Δv/|Δv| over the patch.
///
/// `rolling_speed` in m/s matters only for slip units that are fractions of it.
pub fn patch_traction<D: Scalar, L: TractionLaw>(
    patch: &Patch<D>,
    motion: &RelativeMotion<D>,
    rolling_speed: D,
    law: &PatchLaw<'_, L>,
    quadrature: &Quadrature,
) -> PatchTraction<D> {
    let mut sum = PatchTraction::zero();
    if patch.peak_pressure.re() <= 0.0 {
        return sum;
    }
    if let Some(film) = law.law.film() {
        return film.traction(&MovingPatch { patch: *patch, motion: *motion, rolling_speed }, quadrature);
    }
    let scale = law.slip_unit.scale(rolling_speed);
    let under =
        |pressure| law.law.under(&Conditions { pressure, entrainment_speed: rolling_speed.abs(), patch: *patch });
    let peak_curve = under(patch.peak_pressure);
    let (a, b) = (patch.semi_lateral, patch.semi_rolling);
    let flatness = 0.5 / patch.surface_radius;
    quadrature.for_each(&SlipField::new(patch, motion), |unit_x, unit_y, weight| {
        let (x, y) = (b * unit_x, a * unit_y);
        let [u, v] = motion.slip_at(x, y, patch);
        let speed = norm(u, v);
        let slip = speed * scale;
        let over_slip = match law.pressure {
            PressureChoice::Peak => peak_curve.over_slip(slip),
            PressureChoice::Local => under(local_pressure(patch, unit_x, unit_y)).over_slip(slip),
        };
        // κ/|Δv| = (κ/s)·scale stays finite where the slip vanishes.
        let share = weight * over_slip * scale;
        let (fx, fy) = (-(share * u), -(share * v));
        let arm = D::from(patch.ball_radius) - y * y * flatness;
        sum.force_rolling += fx;
        sum.force_lateral += fy;
        sum.moment_lateral += arm * fx;
        sum.moment_normal += x * fy - y * fx;
        sum.moment_rolling -= arm * fy;
        sum.power += share * speed * speed;
        sum.wear_integral += weight * speed;
    });
    sum.times(patch.peak_pressure * a * b)
}

/// Sliding velocity over the unit disc X = x/b, Y = y/a, in m/s: Δv_x = γ − β Y − α Y² and Δv_y = δ + σ X + ε Y².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlipField<D = f64> {
    /// γ, β, α: at the centre, by spin and by differential slip.
    pub longitudinal: [D; 3],
    /// δ, σ, ε: at the centre, by spin and by the curvature of the contact.
    pub lateral: [D; 3],
}

impl<D: Scalar> SlipField<D> {
    /// The field of a relative motion; [`RelativeMotion::slip_at`] in other coordinates.
    pub fn new(patch: &Patch<D>, motion: &RelativeMotion<D>) -> Self {
        let a = patch.semi_lateral;
        let bow = a * a * (0.5 / patch.surface_radius);
        let [along, across] = motion.centre_slip(patch.ball_radius);
        Self {
            longitudinal: [along, motion.spin * a, motion.about_lateral * bow],
            lateral: [across, motion.spin * patch.semi_rolling, motion.about_rolling * bow],
        }
    }

    /// Sliding velocity (along rolling, across) at a point of the unit disc, m/s.
    pub fn at(&self, x: D, y: D) -> [D; 2] {
        let ([gamma, beta, alpha], [delta, sigma, epsilon]) = (self.longitudinal, self.lateral);
        [gamma - y * (beta + alpha * y), delta + sigma * x + epsilon * y * y]
    }
}

/// |(u, v)| with derivative zero at the origin, where the integrand does not depend on it.
fn norm<D: Scalar>(u: D, v: D) -> D {
    let squared = u * u + v * v;
    if squared.re() > 1e-60 { squared.sqrt() } else { D::zero() }
}

fn local_pressure<D: Scalar>(patch: &Patch<D>, x: D, y: D) -> D {
    let inside = D::one() - x * x - y * y;
    if inside.re() > 0.0 { patch.peak_pressure * inside.sqrt() } else { D::zero() }
}
