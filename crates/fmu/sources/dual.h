/* Numbers with first derivatives: by the ball's place X1, X2 and by the place A, R of the inner groove centre. */
#ifndef TRIBODYN_DUAL_H
#define TRIBODYN_DUAL_H

#include <math.h>

enum { BY_X1, BY_X2, BY_A, BY_R, SLOPES };

typedef struct {
    double v;
    double d[SLOPES];
} Dual;

static inline Dual dual(double value) {
    Dual out = {0.0, {0.0, 0.0, 0.0, 0.0}};
    out.v = value;
    return out;
}

static inline Dual variable(double value, int by) {
    Dual out = dual(value);
    out.d[by] = 1.0;
    return out;
}

/* A function of a and b with its partial derivatives there. */
static inline Dual chain(double value, Dual a, double by_a, Dual b, double by_b) {
    Dual out;
    int k;
    out.v = value;
    for (k = 0; k < SLOPES; k++) {
        out.d[k] = by_a * a.d[k] + by_b * b.d[k];
    }
    return out;
}

static inline Dual add(Dual a, Dual b) { return chain(a.v + b.v, a, 1.0, b, 1.0); }
static inline Dual sub(Dual a, Dual b) { return chain(a.v - b.v, a, 1.0, b, -1.0); }
static inline Dual mul(Dual a, Dual b) { return chain(a.v * b.v, a, b.v, b, a.v); }
static inline Dual over(Dual a, Dual b) { return chain(a.v / b.v, a, 1.0 / b.v, b, -a.v / (b.v * b.v)); }
static inline Dual plus(Dual a, double b) { return chain(a.v + b, a, 1.0, a, 0.0); }
static inline Dual times(Dual a, double b) { return chain(a.v * b, a, b, a, 0.0); }

static inline Dual root(Dual a) {
    double r = sqrt(a.v);
    return chain(r, a, 0.5 / r, a, 0.0);
}

#endif
