#include "ball.h"

static const double TAU = 6.28318530717958647692;
/* Rounds of asking which race controls before a ball on the border counts as decided. */
enum { CONTROL_ROUNDS = 4, MOST_BALLS = 1000 };

/* The place of the inner groove centre at an azimuth from the outer one: axial, radial, of a displaced and tilted
   ring. With apart = 0 their rates. */
static void groove_centre(
    const Bearing *b, const double apart[2], const double ring[RING], double azimuth, double out[2]
) {
    double sine = sin(azimuth), cosine = cos(azimuth);
    out[0] = apart[0] + ring[2] + b->centre_radius[INNER] * (ring[3] * sine - ring[4] * cosine);
    out[1] = apart[1] + ring[0] * cosine + ring[1] * sine;
}

/* Harris's criterion: the outer race controls where it resists spin more. */
static int inner_race_controls(const double centre[2], const Ball *ball) {
    double angle_o = atan2(ball->place[0], ball->place[1]);
    double angle_i = atan2(centre[0] - ball->place[0], centre[1] - ball->place[1]);
    return ball->resistance[OUTER] * cos(angle_i - angle_o) <= ball->resistance[INNER];
}

/* A ball that the criterion gives to one of the races. */
static int solve_by_criterion(const Bearing *b, const double centre[2], Ball *out) {
    int inner = 0, round, next;
    for (round = 0;; round++) {
        if (!ball_solve(b, centre, inner, out)) {
            return 0;
        }
        next = inner_race_controls(centre, out);
        if (next == inner || round == CONTROL_ROUNDS) {
            return 1;
        }
        inner = next;
    }
}

/* Adds what a ball does to the ring. */
static void collect(const Bearing *b, const Inputs *in, double azimuth, const Ball *ball, Outputs *out) {
    static const double MIDDLE[2] = {0.0, 0.0};
    double sine = sin(azimuth), cosine = cos(azimuth), lever = b->centre_radius[INNER], rate[2], force[2];
    int row, side;
    groove_centre(b, MIDDLE, in->rate, azimuth, rate);
    for (row = 0; row < 2; row++) {
        double damped = ball->stiffness[row][0] * rate[0] + ball->stiffness[row][1] * rate[1];
        force[row] = ball->force[row] + b->p->damping * damped;
    }
    out->force[0] -= force[1] * cosine;
    out->force[1] -= force[1] * sine;
    out->force[2] -= force[0];
    out->force[3] -= force[0] * lever * sine;
    out->force[4] += force[0] * lever * cosine;
    out->cage_speed += ball->orbital_speed / b->p->ball_count;
    for (side = INNER; side < RACES; side++) {
        out->load[side] = fmax(out->load[side], ball->load[side]);
        out->pressure[side] = fmax(out->pressure[side], ball->pressure[side]);
    }
}

/* All balls, each with the race that `control` names; with `released` the outer one for those that the inner race does
   not touch. The index of the ball without equilibrium, or -1. */
static int solve_all(const Bearing *b, const Inputs *in, int control, int released, Outputs *out) {
    static const Outputs NONE;
    double azimuth, centre[2];
    Ball ball;
    int index, found;
    *out = NONE;
    for (index = 0; index < b->p->ball_count; index++) {
        azimuth = in->first_ball + TAU * index / b->p->ball_count;
        groove_centre(b, b->apart, in->ring, azimuth, centre);
        if (control == CONTROL_CRITERION) {
            found = solve_by_criterion(b, centre, &ball);
        } else {
            found = ball_solve(b, centre, control == CONTROL_INNER, &ball);
            if (released && !ball.touched) {
                found = ball_solve(b, centre, 0, &ball);
            }
        }
        if (!found) {
            return index;
        }
        collect(b, in, azimuth, &ball, out);
    }
    return -1;
}

int bearing_solve(const Parameters *p, const Inputs *in, Outputs *out) {
    Bearing b;
    int failed;
    if (!bearing_of(p, in->speed, &b)) {
        return 0;
    }
    failed = solve_all(&b, in, p->race_control, 0, out);
    if (failed >= 0 && p->race_control == CONTROL_INNER) {
        failed = solve_all(&b, in, p->race_control, 1, out);
    }
    /* Where the rings turn together the balls go with them, and speeds from rolling are rounding. */
    if (in->speed[INNER] == in->speed[OUTER]) {
        out->cage_speed = in->speed[OUTER];
    }
    return failed;
}

int bearing_is_possible(const Parameters *p) {
    static const double STILL[RACES] = {0.0, 0.0};
    Bearing b;
    /* Neighbouring balls touch where the chord of their spacing is the ball diameter. */
    return p->ball_count >= 2 && p->ball_count <= MOST_BALLS && p->ball_diameter > 0.0
        && p->pitch_diameter * sin(0.5 * TAU / p->ball_count) > p->ball_diameter && p->ball_mass > 0.0
        && p->damping >= 0.0 && bearing_of(p, STILL, &b);
}
