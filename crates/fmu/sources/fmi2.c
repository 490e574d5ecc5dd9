/* The bearing behind the interface of FMI 2.0. It has no state: what it puts out follows from what it is given. */
#include "bearing.h"
#include "fmi2.h"
#include "model.h"
#include <stdlib.h>
#include <string.h>

typedef struct {
    double values[VARIABLES];
    double time;
    /* False where the outputs are not those of the inputs. */
    int known;
    int initialised;
} State;

typedef struct {
    State state;
    fmi2CallbackFunctions callbacks;
    char name[128];
} Instance;

static void *allocate(const fmi2CallbackFunctions *callbacks, size_t size) {
    return callbacks->allocateMemory ? callbacks->allocateMemory(1, size) : calloc(1, size);
}

static void give_back(const fmi2CallbackFunctions *callbacks, void *memory) {
    if (callbacks->freeMemory) {
        callbacks->freeMemory(memory);
    } else {
        free(memory);
    }
}

static fmi2Status failed(const Instance *of, fmi2Status status, const char *message, int number) {
    if (of->callbacks.logger) {
        of->callbacks.logger(
            of->callbacks.componentEnvironment, of->name, status,
            status == fmi2Discard ? "logStatusDiscard" : "logStatusError", message, number
        );
    }
    return status;
}

static void start(State *state) {
    memcpy(state->values, START, sizeof(START));
    state->time = 0.0;
    state->known = state->initialised = 0;
}

static Parameters parameters(const double *v) {
    Parameters p;
    p.ball_count = (int)v[BALL_COUNT];
    p.ball_diameter = v[BALL_DIAMETER];
    p.pitch_diameter = v[PITCH_DIAMETER];
    p.ball_mass = v[BALL_MASS];
    p.contact_angle = v[CONTACT_ANGLE];
    p.interference = v[INTERFERENCE];
    p.coefficient[INNER] = v[GROOVE_COEFFICIENT_INNER];
    p.coefficient[OUTER] = v[GROOVE_COEFFICIENT_OUTER];
    p.modulus[INNER] = v[EFFECTIVE_MODULUS_INNER];
    p.modulus[OUTER] = v[EFFECTIVE_MODULUS_OUTER];
    p.worn[INNER] = v[WORN_INNER];
    p.worn[OUTER] = v[WORN_OUTER];
    p.race_control = (int)v[RACE_CONTROL];
    p.gyroscopic_friction = (int)v[GYROSCOPIC_FRICTION];
    p.contact_at_actual_angle = v[CONTACT_AT_ACTUAL_ANGLE] != 0.0;
    p.centrifugal_at_free_pitch = v[CENTRIFUGAL_AT_FREE_PITCH] != 0.0;
    p.damping = v[DAMPING];
    return p;
}

static Inputs inputs(const double *v) {
    Inputs in;
    int k;
    for (k = 0; k < RING; k++) {
        in.ring[k] = v[DISPLACEMENT_X + k];
        in.rate[k] = v[VELOCITY_X + k];
    }
    in.speed[INNER] = v[INNER_SPEED];
    in.speed[OUTER] = v[OUTER_SPEED];
    in.first_ball = v[FIRST_BALL_AZIMUTH];
    return in;
}

/* Brings the outputs up to date. */
static fmi2Status solve(Instance *of) {
    double *v = of->state.values;
    Parameters p = parameters(v);
    Inputs in = inputs(v);
    Outputs out;
    int k, ball;
    if (of->state.known) {
        return fmi2OK;
    }
    if (!bearing_is_possible(&p)) {
        return failed(of, fmi2Error, "the parameters make no bearing (%d balls)", p.ball_count);
    }
    ball = bearing_solve(&p, &in, &out);
    if (ball >= 0) {
        return failed(of, fmi2Discard, "ball %d, counted from 0, has no equilibrium under raceway control", ball);
    }
    for (k = 0; k < RING; k++) {
        v[FORCE_X + k] = out.force[k];
    }
    v[CAGE_SPEED] = out.cage_speed;
    v[LOAD_INNER] = out.load[INNER];
    v[LOAD_OUTER] = out.load[OUTER];
    v[PRESSURE_INNER] = out.pressure[INNER];
    v[PRESSURE_OUTER] = out.pressure[OUTER];
    of->state.known = 1;
    return fmi2OK;
}

/* Whether a variable may be asked for as a type, and set. */
static int is(fmi2ValueReference reference, char type) { return reference < VARIABLES && TYPE[reference] == type; }

static fmi2Status set(Instance *of, fmi2ValueReference reference, char type, double value) {
    char causality = is(reference, type) ? CAUSALITY[reference] : '-';
    int open = causality == 'i' || (causality == 'p' && !of->state.initialised);
    if (!open || value != value) {
        return failed(of, fmi2Error, "variable %d cannot be set to that now", (int)reference);
    }
    of->state.known = of->state.known && of->state.values[reference] == value;
    of->state.values[reference] = value;
    return fmi2OK;
}

static fmi2Status get(Instance *of, fmi2ValueReference reference, char type, double *value) {
    fmi2Status status = fmi2OK;
    if (!is(reference, type)) {
        return failed(of, fmi2Error, "there is no variable %d of that type", (int)reference);
    }
    if (CAUSALITY[reference] == 'o') {
        status = solve(of);
    }
    *value = of->state.values[reference];
    return status;
}

FMI2_EXPORT const char *FMI2(fmi2GetTypesPlatform)(void) { return "default"; }

FMI2_EXPORT const char *FMI2(fmi2GetVersion)(void) { return "2.0"; }

FMI2_EXPORT fmi2Status FMI2(fmi2SetDebugLogging)(
    fmi2Component c, fmi2Boolean on, size_t count, const fmi2String categories[]
) {
    /* What is told are failures, which always are. */
    (void)c;
    (void)on;
    (void)count;
    (void)categories;
    return fmi2OK;
}

FMI2_EXPORT fmi2Component FMI2(fmi2Instantiate)(
    fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources, const fmi2CallbackFunctions *callbacks,
    fmi2Boolean visible, fmi2Boolean logging
) {
    Instance *made;
    (void)type;
    (void)resources;
    (void)visible;
    (void)logging;
    if (!callbacks || !guid || strcmp(guid, MODEL_GUID) != 0) {
        return NULL;
    }
    made = allocate(callbacks, sizeof(Instance));
    if (made) {
        made->callbacks = *callbacks;
        strncpy(made->name, name ? name : "", sizeof(made->name) - 1);
        start(&made->state);
    }
    return made;
}

FMI2_EXPORT void FMI2(fmi2FreeInstance)(fmi2Component c) {
    if (c) {
        fmi2CallbackFunctions callbacks = ((Instance *)c)->callbacks;
        give_back(&callbacks, c);
    }
}

FMI2_EXPORT fmi2Status FMI2(fmi2SetupExperiment)(
    fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real begin, fmi2Boolean has_end, fmi2Real end
) {
    (void)has_tolerance;
    (void)tolerance;
    (void)has_end;
    (void)end;
    ((Instance *)c)->state.time = begin;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2EnterInitializationMode)(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2ExitInitializationMode)(fmi2Component c) {
    fmi2Status status = solve(c);
    ((Instance *)c)->state.initialised = 1;
    return status;
}

FMI2_EXPORT fmi2Status FMI2(fmi2Terminate)(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2Reset)(fmi2Component c) {
    start(&((Instance *)c)->state);
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetReal)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, fmi2Real values[]
) {
    fmi2Status status = fmi2OK;
    size_t k;
    for (k = 0; k < count && status == fmi2OK; k++) {
        status = get(c, of[k], 'r', &values[k]);
    }
    return status;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetInteger)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, fmi2Integer values[]
) {
    fmi2Status status = fmi2OK;
    double value = 0.0;
    size_t k;
    for (k = 0; k < count && status == fmi2OK; k++) {
        status = get(c, of[k], 'i', &value);
        values[k] = (fmi2Integer)value;
    }
    return status;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetBoolean)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, fmi2Boolean values[]
) {
    fmi2Status status = fmi2OK;
    double value = 0.0;
    size_t k;
    for (k = 0; k < count && status == fmi2OK; k++) {
        status = get(c, of[k], 'b', &value);
        values[k] = value != 0.0;
    }
    return status;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetString)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, fmi2String values[]
) {
    (void)values;
    return count == 0 ? fmi2OK : failed(c, fmi2Error, "there is no text variable %d", (int)of[0]);
}

FMI2_EXPORT fmi2Status FMI2(fmi2SetReal)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, const fmi2Real values[]
) {
    fmi2Status status = fmi2OK;
    size_t k;
    for (k = 0; k < count && status == fmi2OK; k++) {
        status = set(c, of[k], 'r', values[k]);
    }
    return status;
}

FMI2_EXPORT fmi2Status FMI2(fmi2SetInteger)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, const fmi2Integer values[]
) {
    fmi2Status status = fmi2OK;
    size_t k;
    for (k = 0; k < count && status == fmi2OK; k++) {
        status = set(c, of[k], 'i', values[k]);
    }
    return status;
}

FMI2_EXPORT fmi2Status FMI2(fmi2SetBoolean)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, const fmi2Boolean values[]
) {
    fmi2Status status = fmi2OK;
    size_t k;
    for (k = 0; k < count && status == fmi2OK; k++) {
        status = set(c, of[k], 'b', values[k] != fmi2False);
    }
    return status;
}

FMI2_EXPORT fmi2Status FMI2(fmi2SetString)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, const fmi2String values[]
) {
    (void)values;
    return count == 0 ? fmi2OK : failed(c, fmi2Error, "there is no text variable %d", (int)of[0]);
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetFMUstate)(fmi2Component c, fmi2FMUstate *kept) {
    Instance *of = c;
    if (!*kept) {
        *kept = allocate(&of->callbacks, sizeof(State));
    }
    if (!*kept) {
        return failed(of, fmi2Error, "there is no memory for %d bytes", (int)sizeof(State));
    }
    memcpy(*kept, &of->state, sizeof(State));
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2SetFMUstate)(fmi2Component c, fmi2FMUstate kept) {
    memcpy(&((Instance *)c)->state, kept, sizeof(State));
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2FreeFMUstate)(fmi2Component c, fmi2FMUstate *kept) {
    if (*kept) {
        give_back(&((Instance *)c)->callbacks, *kept);
        *kept = NULL;
    }
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2SerializedFMUstateSize)(fmi2Component c, fmi2FMUstate kept, size_t *size) {
    (void)c;
    (void)kept;
    *size = sizeof(State);
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2SerializeFMUstate)(fmi2Component c, fmi2FMUstate kept, fmi2Byte bytes[], size_t size) {
    if (size < sizeof(State)) {
        return failed(c, fmi2Error, "a state takes %d bytes", (int)sizeof(State));
    }
    memcpy(bytes, kept, sizeof(State));
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2DeSerializeFMUstate)(
    fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *kept
) {
    Instance *of = c;
    if (size != sizeof(State)) {
        return failed(of, fmi2Error, "a state has %d bytes", (int)sizeof(State));
    }
    if (!*kept) {
        *kept = allocate(&of->callbacks, sizeof(State));
    }
    if (!*kept) {
        return failed(of, fmi2Error, "there is no memory for %d bytes", (int)sizeof(State));
    }
    memcpy(*kept, bytes, sizeof(State));
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetDirectionalDerivative)(
    fmi2Component c, const fmi2ValueReference unknown[], size_t unknowns, const fmi2ValueReference known[],
    size_t knowns, const fmi2Real given[], fmi2Real found[]
) {
    (void)unknown;
    (void)known;
    (void)knowns;
    (void)given;
    (void)found;
    return failed(c, fmi2Error, "directional derivatives, of which %d are asked for, are not provided", (int)unknowns);
}
