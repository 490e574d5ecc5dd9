/* Hertz's elliptical point contact. Source of the formulas: K. L. Johnson, Contact Mechanics, chapter 4. */
#ifndef TRIBODYN_HERTZ_H
#define TRIBODYN_HERTZ_H

#include "dual.h"

typedef struct {
    Dual ellipticity;
    Dual second_integral;
    /* K in Q = K delta^1.5, N/m^1.5. */
    Dual stiffness;
    /* Cube of the longer semi-axis over the load, m^3/N. */
    Dual major_cubed;
    /* True where the longer axis lies across the rolling direction. */
    int major_is_lateral;
} Hertz;

/* The contact of bodies with these sums of curvatures along rolling and across it, 1/m, and effective modulus, Pa.
   False where they make no point contact. */
int hertz_contact(Dual rolling, Dual lateral, double modulus, Hertz *out);

/* Load at an elastic approach (m), N; none where the bodies are apart. */
Dual hertz_load(const Hertz *hertz, Dual approach);

/* Semi-axis across the rolling direction (m) and peak pressure (Pa) under a load, N. */
double hertz_semi_lateral(const Hertz *hertz, double load);
double hertz_peak_pressure(const Hertz *hertz, double load);

#endif
