#include "ball.h"

/* Relative residual of the balances at which a ball is in equilibrium, and that of a state to go on from. */
static const double TOLERANCE = 1e-12, ELASTIC = 1e-6;
/* The same where rounding lets it come no nearer. */
static const double ROUNDING = 1e-10;
/* Friction over load that no dry contact exceeds for long. */
static const double FRICTION_MAX = 1.0;
enum { MOST_STEPS = 100 };

/* How the balances are taken: frozen, with the contact constants of the free angle and a given centrifugal force, they
   have a convex potential. */
typedef struct {
    int frozen, inner_control;
    /* The frozen centrifugal force, N. */
    double centrifugal;
    /* Share of the rings' speeds. */
    double share;
} Setting;

typedef struct {
    /* Axial and radial force on the ball, N, and what each is measured against. */
    Dual residual[2];
    double scale[2];
    Hertz hertz[RACES];
    Dual load[RACES];
    /* Of the inner ring on the ball. */
    Dual force[2];
    double orbital_speed;
    /* Of the frozen forces, N m. */
    double energy;
} Balance;

/* Curvature sums of ball and race at a contact angle. */
static int contact_at(const Parameters *p, int side, Dual cosine, Hertz *out) {
    double ball = 2.0 / p->ball_diameter;
    Dual gamma = times(cosine, p->ball_diameter / p->pitch_diameter);
    Dual opposite = times(gamma, -1.0);
    Dual groove = side == INNER ? over(gamma, plus(opposite, 1.0)) : over(opposite, plus(gamma, 1.0));
    Dual lateral = dual(ball - 1.0 / (p->coefficient[side] * p->ball_diameter));
    return hertz_contact(plus(times(groove, ball), ball), lateral, p->modulus[side], out);
}

/* Shares of the gyroscopic moment that friction at the races holds: the force is share M_g/D. */
static void gyroscopic_shares(const Parameters *p, int inner_control, double share[RACES]) {
    int controlling = inner_control ? INNER : OUTER;
    share[INNER] = share[OUTER] = 0.0;
    switch (p->gyroscopic_friction) {
        case GYRO_SHARED: share[INNER] = share[OUTER] = 1.0; break;
        case GYRO_ABSENT: break;
        case GYRO_AS_PRINTED: share[controlling] = -2.0; break;
        default: share[controlling] = 2.0; break;
    }
}

/* What is wanted beyond the friction that a load gives. */
static Dual beyond(Dual wanted, Dual load) {
    double most = FRICTION_MAX * load.v;
    if (fabs(wanted.v) <= most) {
        return dual(0.0);
    }
    return sub(wanted, times(load, wanted.v < 0.0 ? -FRICTION_MAX : FRICTION_MAX));
}

/* Friction within the loads: what one race cannot hold the other takes over, and what neither can turns the ball. */
static void held(Dual friction[RACES], const Dual load[RACES]) {
    Dual left_inner = beyond(friction[INNER], load[INNER]), left_outer = beyond(friction[OUTER], load[OUTER]);
    if (left_inner.v == 0.0 && left_outer.v == 0.0) {
        return;
    }
    friction[INNER] = add(sub(friction[INNER], left_inner), left_outer);
    friction[OUTER] = add(sub(friction[OUTER], left_outer), left_inner);
    friction[INNER] = sub(friction[INNER], beyond(friction[INNER], load[INNER]));
    friction[OUTER] = sub(friction[OUTER], beyond(friction[OUTER], load[OUTER]));
}

/* Orbital speed and spin about the radial direction under raceway control, rad/s. */
static void rolling(
    const Bearing *b, const Setting *at, const Dual sine[RACES], const Dual cosine[RACES], Dual *orbit, Dual *spin
) {
    double ratio = b->p->ball_diameter / b->p->pitch_diameter;
    double inner = at->share * b->speed[INNER], outer = at->share * b->speed[OUTER];
    Dual tangent = at->inner_control ? over(sine[INNER], plus(cosine[INNER], -ratio))
                                     : over(sine[OUTER], plus(cosine[OUTER], ratio));
    Dual roll_i = add(cosine[INNER], mul(tangent, sine[INNER]));
    Dual roll_o = add(cosine[OUTER], mul(tangent, sine[OUTER]));
    Dual near_i = plus(times(cosine[INNER], -ratio), 1.0), near_o = plus(times(cosine[OUTER], ratio), 1.0);
    Dual share_i = mul(near_i, roll_o), share_o = mul(near_o, roll_i);
    Dual axial;
    *orbit = over(add(times(share_i, inner), times(share_o, outer)), add(share_i, share_o));
    axial = over(mul(plus(*orbit, -outer), near_o), times(roll_o, ratio));
    *spin = mul(axial, tangent);
}

static void balance(const Bearing *b, const double centre[2], const double place[2], const Setting *at, Balance *out) {
    const Parameters *p = b->p;
    Dual x1 = variable(place[0], BY_X1), x2 = variable(place[1], BY_X2);
    Dual axial[RACES], radial[RACES], sine[RACES], cosine[RACES], friction[RACES];
    Dual approach, length, orbit, spin, centrifugal = dual(at->centrifugal), moment = dual(0.0), on_outer[2];
    double share[RACES], floor = 1e-3 * b->typical_force;
    double inertia = 0.1 * p->ball_mass * p->ball_diameter * p->ball_diameter;
    int side;
    axial[INNER] = sub(variable(centre[0], BY_A), x1);
    radial[INNER] = sub(variable(centre[1], BY_R), x2);
    axial[OUTER] = x1;
    radial[OUTER] = x2;
    out->energy = -at->centrifugal * place[1];
    for (side = INNER; side < RACES; side++) {
        length = root(add(mul(axial[side], axial[side]), mul(radial[side], radial[side])));
        sine[side] = over(axial[side], length);
        cosine[side] = over(radial[side], length);
        approach = plus(length, -b->reach[side]);
        if (at->frozen || !p->contact_at_actual_angle || !contact_at(p, side, cosine[side], &out->hertz[side])) {
            out->hertz[side] = b->frozen[side];
        }
        out->load[side] = hertz_load(&out->hertz[side], approach);
        out->energy += 0.4 * out->load[side].v * approach.v;
    }
    rolling(b, at, sine, cosine, &orbit, &spin);
    out->orbital_speed = orbit.v;
    if (!at->frozen) {
        Dual radius = plus(x2, b->centre_radius[OUTER]);
        radius = p->centrifugal_at_free_pitch ? dual(0.5 * p->pitch_diameter) : radius;
        centrifugal = times(mul(radius, mul(orbit, orbit)), p->ball_mass);
        moment = times(mul(spin, orbit), inertia);
    }
    gyroscopic_shares(p, at->inner_control, share);
    for (side = INNER; side < RACES; side++) {
        friction[side] = times(moment, share[side] / p->ball_diameter);
    }
    held(friction, out->load);
    out->force[0] = add(mul(out->load[INNER], sine[INNER]), mul(friction[INNER], cosine[INNER]));
    out->force[1] = sub(mul(out->load[INNER], cosine[INNER]), mul(friction[INNER], sine[INNER]));
    on_outer[0] = add(mul(out->load[OUTER], sine[OUTER]), mul(friction[OUTER], cosine[OUTER]));
    on_outer[1] = sub(mul(out->load[OUTER], cosine[OUTER]), mul(friction[OUTER], sine[OUTER]));
    out->residual[0] = sub(out->force[0], on_outer[0]);
    out->residual[1] = add(sub(out->force[1], on_outer[1]), centrifugal);
    out->scale[0] = fmax(fabs(out->force[0].v) + fabs(on_outer[0].v), floor);
    out->scale[1] = fmax(fabs(out->force[1].v) + fabs(on_outer[1].v) + fabs(centrifugal.v), floor);
}

static double worst(const Balance *of) {
    double axial = fabs(of->residual[0].v) / of->scale[0], radial = fabs(of->residual[1].v) / of->scale[1];
    double larger = axial > radial ? axial : radial;
    return axial == axial && radial == radial ? larger : HUGE_VAL;
}

/* The step to equilibrium, some stiffness added: (J - soft) step = -residual. False where it has none. */
static int step_of(const Balance *of, double soft, double most, double step[2]) {
    const Dual *r = of->residual;
    double a = r[0].d[BY_X1] - soft, b = r[0].d[BY_X2], c = r[1].d[BY_X1], d = r[1].d[BY_X2] - soft;
    double determinant = a * d - b * c, length;
    step[0] = -(d * r[0].v - b * r[1].v) / determinant;
    step[1] = -(a * r[1].v - c * r[0].v) / determinant;
    length = hypot(step[0], step[1]);
    if (!(length < HUGE_VAL)) {
        return 0;
    }
    if (length > most) {
        step[0] *= most / length;
        step[1] *= most / length;
    }
    return 1;
}

/* Takes Newton steps, shortened until they lead down: in the potential of the frozen forces, or else in the residual.
   Gives the residual that it came to. */
static double descend(const Bearing *b, const double centre[2], const Setting *at, double tolerance, double place[2]) {
    double most = 0.1 * fmin(b->reach[INNER], b->reach[OUTER]);
    double soft = at->frozen ? b->typical_stiffness : 0.0, reached, step[2], trial[2], part;
    Balance now, next;
    int round, halving, down;
    balance(b, centre, place, at, &now);
    reached = worst(&now);
    for (round = 0; round < MOST_STEPS && reached > tolerance; round++) {
        if (!step_of(&now, soft, most, step) && !step_of(&now, 1e-3 * b->typical_stiffness, most, step)) {
            break;
        }
        down = 0;
        for (part = 1.0, halving = 0; halving < 12 && !down; part *= 0.5, halving++) {
            trial[0] = place[0] + part * step[0];
            trial[1] = place[1] + part * step[1];
            balance(b, centre, trial, at, &next);
            down = at->frozen ? next.energy < now.energy || worst(&next) < 0.5 * reached : worst(&next) < reached;
        }
        if (!down && (!at->frozen || soft > 1e6 * b->typical_stiffness)) {
            break;
        }
        soft *= down ? (halving == 1 ? 0.1 : 1.0) : 10.0;
        if (down) {
            place[0] = trial[0];
            place[1] = trial[1];
            now = next;
            reached = worst(&now);
        }
    }
    return reached;
}

/* Where a ball starts: in line between the groove centres where they press it, or as far out as the races let it. */
static void start(const Bearing *b, const double centre[2], double place[2]) {
    double apart = hypot(centre[0], centre[1]), sine = centre[0] / apart, cosine = centre[1] / apart;
    double outer = b->reach[OUTER], inner = b->reach[INNER], along, across;
    double approach = apart - outer - inner;
    if (approach > 0.0) {
        double soft_i = pow(b->frozen[INNER].stiffness.v, -2.0 / 3.0);
        double soft_o = pow(b->frozen[OUTER].stiffness.v, -2.0 / 3.0);
        outer += approach * soft_o / (soft_i + soft_o);
        place[0] = outer * sine;
        place[1] = outer * cosine;
    } else if (hypot(centre[0], centre[1] - outer) <= inner) {
        place[0] = 0.0;
        place[1] = outer;
    } else {
        along = (apart * apart + outer * outer - inner * inner) / (2.0 * apart);
        across = copysign(sqrt(fmax(outer * outer - along * along, 0.0)), sine);
        place[0] = along * sine - across * cosine;
        place[1] = along * cosine + across * sine;
    }
}

/* From slow to fast where the straight way does not lead there. Gives the residual at full speed. */
static double speed_up(
    const Bearing *b, const double centre[2], const Setting *whole, const double elastic[2], double place[2]
) {
    double share, reached = 0.0, stride = 0.25, left = HUGE_VAL, trial[2], from[2];
    Setting at;
    from[0] = elastic[0];
    from[1] = elastic[1];
    while (stride >= 0.01) {
        share = fmin(reached + stride, 1.0);
        at = *whole;
        at.share = share;
        trial[0] = from[0];
        trial[1] = from[1];
        left = reached > 0.0 ? descend(b, centre, &at, TOLERANCE, trial) : HUGE_VAL;
        if (left > ROUNDING) {
            Setting frozen = at;
            frozen.frozen = 1;
            frozen.centrifugal = b->centrifugal * share * share;
            trial[0] = from[0];
            trial[1] = from[1];
            descend(b, centre, &frozen, ELASTIC, trial);
            left = descend(b, centre, &at, TOLERANCE, trial);
        }
        if (left > ROUNDING) {
            stride *= 0.5;
            continue;
        }
        from[0] = trial[0];
        from[1] = trial[1];
        if (share >= 1.0) {
            place[0] = trial[0];
            place[1] = trial[1];
            return left;
        }
        reached = share;
        stride *= 1.5;
    }
    return HUGE_VAL;
}

/* Slopes of the inner ring's force with the ball in balance: F_q - F_x (J_x)^-1 J_q. */
static void condense(const Balance *of, double stiffness[2][2]) {
    static const int BY[2] = {BY_A, BY_R};
    const Dual *r = of->residual;
    double a = r[0].d[BY_X1], b = r[0].d[BY_X2], c = r[1].d[BY_X1], d = r[1].d[BY_X2];
    double determinant = a * d - b * c, x1, x2;
    int row, column;
    for (column = 0; column < 2; column++) {
        /* A ball that nothing presses has no place of its own, and no force. */
        x1 = determinant == 0.0 ? 0.0 : -(d * r[0].d[BY[column]] - b * r[1].d[BY[column]]) / determinant;
        x2 = determinant == 0.0 ? 0.0 : -(a * r[1].d[BY[column]] - c * r[0].d[BY[column]]) / determinant;
        for (row = 0; row < 2; row++) {
            const double *slope = of->force[row].d;
            stiffness[row][column] = slope[BY[column]] + slope[BY_X1] * x1 + slope[BY_X2] * x2;
        }
    }
}

static void report(const Balance *of, const Bearing *b, Ball *out) {
    int k;
    for (k = 0; k < RACES; k++) {
        out->load[k] = of->load[k].v;
        out->pressure[k] = hertz_peak_pressure(&of->hertz[k], of->load[k].v);
        out->resistance[k] =
            of->load[k].v * hertz_semi_lateral(&of->hertz[k], of->load[k].v) * b->frozen[k].second_integral.v;
        out->force[k] = of->force[k].v;
    }
    out->orbital_speed = of->orbital_speed;
    condense(of, out->stiffness);
}

int ball_solve(const Bearing *b, const double centre[2], int inner_control, Ball *out) {
    Setting elastic = {1, 0, 0.0, 1.0}, whole = {0, 0, 0.0, 1.0};
    Balance found;
    double left, place[2];
    elastic.inner_control = whole.inner_control = inner_control;
    elastic.centrifugal = b->centrifugal;
    start(b, centre, place);
    descend(b, centre, &elastic, ELASTIC, place);
    balance(b, centre, place, &elastic, &found);
    out->touched = found.load[INNER].v > 1e-6 * b->typical_force;
    out->place[0] = place[0];
    out->place[1] = place[1];
    left = descend(b, centre, &whole, TOLERANCE, out->place);
    if (left > ROUNDING) {
        left = speed_up(b, centre, &whole, place, out->place);
    }
    if (left > ROUNDING) {
        return 0;
    }
    balance(b, centre, out->place, &whole, &found);
    report(&found, b, out);
    return 1;
}

int bearing_of(const Parameters *p, const double speed[RACES], Bearing *out) {
    double sine = sin(p->contact_angle), cosine = cos(p->contact_angle), diameter = p->ball_diameter, offset[RACES];
    double place[2], centre[2], least = 5e4 * diameter * diameter, approach;
    Setting free_rolling = {0, 0, 0.0, 1.0};
    Parameters undeformed = *p;
    Balance found;
    int side;
    out->p = p;
    for (side = INNER; side < RACES; side++) {
        out->speed[side] = speed[side];
        offset[side] = (p->coefficient[side] - 0.5) * diameter;
        out->reach[side] = offset[side] + p->worn[side];
        if (!contact_at(p, side, dual(cosine), &out->frozen[side]) || !(offset[side] > 0.0)) {
            return 0;
        }
    }
    out->centre_radius[INNER] = 0.5 * p->pitch_diameter + offset[INNER] * cosine + 0.5 * p->interference;
    out->centre_radius[OUTER] = 0.5 * p->pitch_diameter - offset[OUTER] * cosine;
    out->apart[0] = (offset[INNER] + offset[OUTER]) * sine;
    out->apart[1] = (offset[INNER] + offset[OUTER]) * cosine + 0.5 * p->interference;
    out->typical_force = least;
    place[0] = offset[OUTER] * sine;
    place[1] = offset[OUTER] * cosine;
    centre[0] = out->apart[0];
    centre[1] = out->apart[1];
    free_rolling.inner_control = p->race_control == CONTROL_INNER;
    undeformed.contact_at_actual_angle = 0;
    undeformed.centrifugal_at_free_pitch = 1;
    out->p = &undeformed;
    balance(out, centre, place, &free_rolling, &found);
    out->p = p;
    out->centrifugal = 0.5 * p->pitch_diameter * p->ball_mass * found.orbital_speed * found.orbital_speed;
    out->typical_force = fmax(out->centrifugal, least);
    approach = pow(out->typical_force / out->frozen[OUTER].stiffness.v, 2.0 / 3.0);
    out->typical_stiffness = 1.5 * out->typical_force / approach;
    return out->centrifugal < HUGE_VAL && p->ball_count > 0;
}
