/* Quasi-static equilibrium of a ball bearing at a given place of its inner ring, by raceway control.
   Sources: A. B. Jones, J. Basic Eng. 82 (1960) 309, doi:10.1115/1.3662587; T. A. Harris, Rolling Bearing Analysis.

   Z is the axis; a ball stands at its azimuth phi, from X towards Y. SI units throughout. */
#ifndef TRIBODYN_BEARING_H
#define TRIBODYN_BEARING_H

#include "hertz.h"

enum { INNER, OUTER, RACES };
/* Freedoms of the ring: displacements x, y, z and tilts about X and Y. */
enum { RING = 5 };
enum { CONTROL_OUTER = 1, CONTROL_INNER, CONTROL_CRITERION };
enum { GYRO_CONTROLLING = 1, GYRO_SHARED, GYRO_ABSENT, GYRO_AS_PRINTED };

typedef struct {
    int ball_count;
    double ball_diameter, pitch_diameter, ball_mass;
    /* Free contact angle, rad, and diametral interference of balls that are pressed without load, m. */
    double contact_angle, interference;
    /* Per race: groove radius over ball diameter, effective modulus (Pa), wear all round (m). */
    double coefficient[RACES], modulus[RACES], worn[RACES];
    int race_control, gyroscopic_friction;
    int contact_at_actual_angle, centrifugal_at_free_pitch;
    /* Damping over stiffness, s. */
    double damping;
} Parameters;

typedef struct {
    double ring[RING], rate[RING];
    /* Of the rings, rad/s. */
    double speed[RACES];
    /* Azimuth of the first ball, rad. */
    double first_ball;
} Inputs;

typedef struct {
    /* Of the bearing on the inner ring: forces, N, and moments about X and Y, N m. */
    double force[RING];
    /* Mean orbital speed of the balls, rad/s. */
    double cage_speed;
    /* The largest of all balls: load, N, and pressure, Pa. */
    double load[RACES], pressure[RACES];
} Outputs;

/* The index of a ball without equilibrium, or -1: the outputs hold. */
int bearing_solve(const Parameters *parameters, const Inputs *inputs, Outputs *out);

/* False where the parameters make no bearing. */
int bearing_is_possible(const Parameters *parameters);

#endif
