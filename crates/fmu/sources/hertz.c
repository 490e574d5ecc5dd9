#include "hertz.h"

static const double PI = 3.14159265358979323846;
/* An ellipse longer than this is a line for every practical purpose. */
static const double MAX_ELLIPTICITY = 1e4;
/* Approaches and loads below it are no contact: roots of smaller ones have no slope. */
static const double NEGLIGIBLE = 1e-100;

/* Complete elliptic integrals of the axis ratio k' = b/a, m = 1 - k'^2:
   K = B + D, E = B + k'^2 D, B = (E - k'^2 K)/m, D = (K - E)/m. */
typedef struct {
    Dual first, second, b, d;
} Elliptic;

/* By the arithmetic-geometric mean (NIST DLMF 19.8) with q = c^2/m, so that nothing is divided by m, which is 0 in a
   circle. */
static Elliptic elliptic(Dual ratio) {
    Dual a = times(plus(ratio, 1.0), 0.5), g = root(ratio);
    Dual c = times(plus(times(ratio, -1.0), 1.0), 0.5);
    Dual q = over(plus(times(ratio, -1.0), 1.0), times(plus(ratio, 1.0), 4.0));
    Dual tail = q, mean, part;
    Elliptic out;
    double weight = 1.0;
    int left = 2;
    while (left > 0) {
        if (c.v <= 1e-8 * a.v) {
            left--;
        }
        mean = times(add(a, g), 0.5);
        g = root(mul(a, g));
        a = mean;
        part = over(c, times(a, 4.0));
        c = mul(c, part);
        q = mul(q, mul(part, part));
        weight *= 2.0;
        tail = add(tail, times(q, weight));
    }
    out.first = over(dual(0.5 * PI), a);
    out.d = mul(out.first, plus(tail, 0.5));
    out.b = mul(out.first, plus(times(tail, -1.0), 0.5));
    out.second = add(out.b, mul(mul(ratio, ratio), out.d));
    return out;
}

/* The ratio k^2 B/D of the curvature sums that belongs to an ellipticity k. */
static Dual curvature_ratio(Dual ellipticity) {
    Elliptic e = elliptic(over(dual(1.0), ellipticity));
    return over(mul(mul(ellipticity, ellipticity), e.b), e.d);
}

/* By Newton's method in ln k, which cannot fail: d ln ratio/d ln k rises from 3/2 to 2. */
static Dual ellipticity_of(Dual ratio) {
    double k = pow(ratio.v, 0.636), step;
    Dual found;
    int round;
    for (round = 0; round < 20; round++) {
        found = curvature_ratio(variable(k, 0));
        step = log1p((found.v - ratio.v) / ratio.v) / (found.d[0] * k / found.v);
        k *= exp(-step);
        if (k < 1.0) {
            k = 1.0;
        }
        if (fabs(step) < 1e-9) {
            break;
        }
    }
    found = curvature_ratio(variable(k, 0));
    return chain(k, ratio, 1.0 / found.d[0], ratio, 0.0);
}

int hertz_contact(Dual rolling, Dual lateral, double modulus, Hertz *out) {
    Dual ratio, k, sum, first, reduced;
    Elliptic e;
    if (!(rolling.v > 0.0 && lateral.v > 0.0 && modulus > 0.0)) {
        return 0;
    }
    out->major_is_lateral = rolling.v >= lateral.v;
    ratio = out->major_is_lateral ? over(rolling, lateral) : over(lateral, rolling);
    if (!(sqrt(ratio.v) <= MAX_ELLIPTICITY)) {
        return 0;
    }
    k = ellipticity_of(ratio);
    if (!(k.v <= MAX_ELLIPTICITY)) {
        return 0;
    }
    e = elliptic(over(dual(1.0), k));
    sum = add(rolling, lateral);
    first = e.first;
    reduced = root(over(e.second, times(mul(sum, mul(first, mul(first, first))), 4.5)));
    out->ellipticity = k;
    out->second_integral = e.second;
    out->stiffness = times(mul(k, reduced), PI * modulus);
    out->major_cubed = times(over(mul(mul(k, k), e.second), sum), 6.0 / (PI * modulus));
    return 1;
}

Dual hertz_load(const Hertz *hertz, Dual approach) {
    if (!(approach.v > NEGLIGIBLE)) {
        return dual(0.0);
    }
    return mul(hertz->stiffness, mul(approach, root(approach)));
}

static double semi_major(const Hertz *hertz, double load) { return cbrt(hertz->major_cubed.v * load); }

double hertz_semi_lateral(const Hertz *hertz, double load) {
    double major = semi_major(hertz, load);
    return hertz->major_is_lateral ? major : major / hertz->ellipticity.v;
}

double hertz_peak_pressure(const Hertz *hertz, double load) {
    double major = semi_major(hertz, load);
    return load > NEGLIGIBLE ? 1.5 * load * hertz->ellipticity.v / (PI * major * major) : 0.0;
}
