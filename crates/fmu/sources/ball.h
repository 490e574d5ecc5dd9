/* One ball between two races at a given place of the inner one. */
#ifndef TRIBODYN_BALL_H
#define TRIBODYN_BALL_H

#include "bearing.h"

/* What all balls share. */
typedef struct {
    const Parameters *p;
    /* Distance of the unloaded ball centre from a groove centre with its wear, and of the circle of the groove's
       centres from the axis, m. */
    double reach[RACES], centre_radius[RACES];
    /* From the outer to the inner groove centre where the ring is in the middle: axial, radial, m. */
    double apart[2];
    /* Contact constants at the free contact angle. */
    Hertz frozen[RACES];
    /* Speeds of the rings, rad/s. */
    double speed[RACES];
    /* Centrifugal force of a ball that rolls at the free contact angle, N. */
    double centrifugal;
    /* A contact force and the stiffness of a contact under it, for steps and for what counts as none. */
    double typical_force, typical_stiffness;
} Bearing;

/* A ball in equilibrium. */
typedef struct {
    /* Its centre from that of the outer groove: axial, radial, m. */
    double place[2];
    double load[RACES], pressure[RACES];
    double orbital_speed;
    /* Force of the inner ring on it (axial, radial, N) and its slopes by the place of the inner groove centre, N/m. */
    double force[2], stiffness[2][2];
    /* Resistance of the contacts against spin, over friction, N m. */
    double resistance[RACES];
    /* True if the inner race touches it where it has neither gyroscopic moment nor friction. */
    int touched;
} Ball;

/* Makes ready what all balls share. False where the parameters make no bearing. */
int bearing_of(const Parameters *p, const double speed[RACES], Bearing *out);

/* The equilibrium of a ball, the inner groove centre at (axial, radial) from the outer one, m. False where none is
   found. */
int ball_solve(const Bearing *b, const double centre[2], int inner_control, Ball *out);

#endif
