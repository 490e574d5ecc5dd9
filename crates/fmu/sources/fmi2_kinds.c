/* What FMI 2.0 asks of a model for co-simulation and of one for model exchange, without states and without events. */
#include "fmi2.h"

/* Co-simulation. */

FMI2_EXPORT fmi2Status FMI2(fmi2SetRealInputDerivatives)(
    fmi2Component c, const unsigned int of[], size_t count, const fmi2Integer order[], const fmi2Real values[]
) {
    (void)c;
    (void)of;
    (void)order;
    (void)values;
    return count == 0 ? fmi2OK : fmi2Error;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetRealOutputDerivatives)(
    fmi2Component c, const fmi2ValueReference of[], size_t count, const fmi2Integer order[], fmi2Real values[]
) {
    (void)c;
    (void)of;
    (void)order;
    (void)values;
    return count == 0 ? fmi2OK : fmi2Error;
}

/* Outputs follow from the inputs of the moment: a step has nothing to integrate. */
FMI2_EXPORT fmi2Status FMI2(fmi2DoStep)(fmi2Component c, fmi2Real from, fmi2Real step, fmi2Boolean no_way_back) {
    (void)c;
    (void)from;
    (void)step;
    (void)no_way_back;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2CancelStep)(fmi2Component c) {
    (void)c;
    return fmi2Error;
}

/* Steps are never pending, so that there is no status of one to ask for. */
FMI2_EXPORT fmi2Status FMI2(fmi2GetStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Status *value) {
    (void)c;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetRealStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value) {
    (void)c;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetIntegerStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value) {
    (void)c;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetBooleanStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value) {
    (void)c;
    (void)kind;
    *value = fmi2False;
    return kind == fmi2Terminated ? fmi2OK : fmi2Discard;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetStringStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2String *value) {
    (void)c;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

/* Model exchange. */

FMI2_EXPORT fmi2Status FMI2(fmi2EnterEventMode)(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2NewDiscreteStates)(fmi2Component c, fmi2EventInfo *info) {
    (void)c;
    info->newDiscreteStatesNeeded = info->terminateSimulation = fmi2False;
    info->nominalsOfContinuousStatesChanged = info->valuesOfContinuousStatesChanged = fmi2False;
    info->nextEventTimeDefined = fmi2False;
    info->nextEventTime = 0.0;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2EnterContinuousTimeMode)(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2CompletedIntegratorStep)(
    fmi2Component c, fmi2Boolean no_way_back, fmi2Boolean *event, fmi2Boolean *end
) {
    (void)c;
    (void)no_way_back;
    *event = *end = fmi2False;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2SetTime)(fmi2Component c, fmi2Real time) {
    (void)c;
    (void)time;
    return fmi2OK;
}

FMI2_EXPORT fmi2Status FMI2(fmi2SetContinuousStates)(fmi2Component c, const fmi2Real states[], size_t count) {
    (void)c;
    (void)states;
    return count == 0 ? fmi2OK : fmi2Error;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetDerivatives)(fmi2Component c, fmi2Real derivatives[], size_t count) {
    (void)c;
    (void)derivatives;
    return count == 0 ? fmi2OK : fmi2Error;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetEventIndicators)(fmi2Component c, fmi2Real indicators[], size_t count) {
    (void)c;
    (void)indicators;
    return count == 0 ? fmi2OK : fmi2Error;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetContinuousStates)(fmi2Component c, fmi2Real states[], size_t count) {
    (void)c;
    (void)states;
    return count == 0 ? fmi2OK : fmi2Error;
}

FMI2_EXPORT fmi2Status FMI2(fmi2GetNominalsOfContinuousStates)(fmi2Component c, fmi2Real nominals[], size_t count) {
    (void)c;
    (void)nominals;
    return count == 0 ? fmi2OK : fmi2Error;
}
