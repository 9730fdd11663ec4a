/* The damper as an FMI 2.0 FMU: co-simulation and model exchange. */
#include "fmi2.h"
#include "instance.h"
#include <stdlib.h>
#include <string.h>

/* The logger is a function pointer. A structure wraps it, because the instance stores an object pointer. It is a copy, because
 * some importers free the structure of call-backs that they pass. */
struct logger {
    fmi2CallbackLogger call;
};

static void tell(struct instance *instance, int error, const char *text)
{
    const struct logger *logger = instance->logger;

    if (logger && logger->call && (error || instance->logging))
        logger->call(instance->environment, instance->name, error ? fmi2Error : fmi2Warning,
                     error ? "logStatusError" : "logStatusWarning", "%s", text);
}

static size_t states_of(const struct instance *instance)
{
    return (size_t)instance->contents->states;
}

static size_t corners_of(const struct instance *instance)
{
    return (size_t)instance->contents->corners;
}

static fmi2Status answer(int failed)
{
    return failed ? fmi2Error : fmi2OK;
}

EXPORT const char *fmi2GetTypesPlatform(void)
{
    return "default";
}

EXPORT const char *fmi2GetVersion(void)
{
    return "2.0";
}

EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[])
{
    (void)n;
    (void)categories;
    ((struct instance *)c)->logging = on;
    return fmi2OK;
}

EXPORT fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                     const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean logging)
{
    struct logger *logger = malloc(sizeof *logger);
    struct instance *instance;

    (void)visible;
    if (!logger)
        return NULL;
    logger->call = functions ? functions->logger : NULL;
    instance = instance_new(name, guid, resources, type == fmi2ModelExchange, logging, tell, logger,
                            functions ? functions->componentEnvironment : NULL);
    if (!instance)
        free(logger);
    return instance;
}

EXPORT void fmi2FreeInstance(fmi2Component c)
{
    if (c)
        free(((struct instance *)c)->logger);
    instance_free(c);
}

EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                      fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop)
{
    struct instance *instance = c;

    (void)tolerance_defined;
    (void)tolerance;
    (void)stop_defined;
    (void)stop;
    if (instance->data->phase != INSTANTIATED)
        return answer(instance_complain(instance, "the experiment is set up before the initialization mode"));
    instance_values(instance->data)[0] = start;
    return fmi2OK;
}

EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c)
{
    struct instance *instance = c;

    return answer(instance_enter_initialization(instance, instance_values(instance->data)[0]));
}

EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c)
{
    return answer(instance_exit_initialization(c));
}

EXPORT fmi2Status fmi2Terminate(fmi2Component c)
{
    return answer(instance_terminate(c));
}

EXPORT fmi2Status fmi2Reset(fmi2Component c)
{
    return answer(instance_reset(c));
}

#define GET_AND_SET(Name, Type, type)                                                                                  \
    EXPORT fmi2Status fmi2Get##Name(fmi2Component c, const fmi2ValueReference vr[], size_t n, Type value[])            \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++) {                                                                                      \
            double v;                                                                                                  \
            if (instance_get(c, vr[i], type, &v))                                                                      \
                return fmi2Error;                                                                                      \
            value[i] = (Type)v;                                                                                        \
        }                                                                                                              \
        return fmi2OK;                                                                                                 \
    }                                                                                                                  \
    EXPORT fmi2Status fmi2Set##Name(fmi2Component c, const fmi2ValueReference vr[], size_t n, const Type value[])      \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++)                                                                                        \
            if (instance_set(c, vr[i], type, value[i]))                                                                \
                return fmi2Error;                                                                                      \
        return fmi2OK;                                                                                                 \
    }
GET_AND_SET(Real, fmi2Real, REAL)
GET_AND_SET(Integer, fmi2Integer, INTEGER)
GET_AND_SET(Boolean, fmi2Boolean, BOOLEAN)

/* The damper has no string variables. */
EXPORT fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2String value[])
{
    (void)c;
    (void)vr;
    (void)value;
    return answer(n != 0);
}

EXPORT fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2String value[])
{
    (void)c;
    (void)vr;
    (void)value;
    return answer(n != 0);
}

/* ---- FMU state -------------------------------------------------------------------------------------------------- */

EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    if (!*state)
        *state = malloc(instance_data_bytes(c));
    if (!*state)
        return fmi2Error;
    memcpy(*state, ((struct instance *)c)->data, instance_data_bytes(c));
    return fmi2OK;
}

EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state)
{
    memcpy(((struct instance *)c)->data, state, instance_data_bytes(c));
    return fmi2OK;
}

EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state)
{
    (void)c;
    free(*state);
    *state = NULL;
    return fmi2OK;
}

EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size)
{
    (void)state;
    *size = instance_bytes(c);
    return fmi2OK;
}

EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    if (size < instance_bytes(c))
        return fmi2Error;
    instance_serialize(c, state, (unsigned char *)bytes);
    return fmi2OK;
}

EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    struct data *data = *state ? *state : malloc(instance_data_bytes(c));

    if (!data)
        return fmi2Error;
    if (instance_deserialize(c, data, (const unsigned char *)bytes, size)) {
        if (!*state)
            free(data);
        return fmi2Error;
    }
    *state = data;
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], size_t unknowns,
                                               const fmi2ValueReference known[], size_t knowns, const fmi2Real seed[],
                                               fmi2Real sensitivity[])
{
    size_t i, k;

    for (i = 0; i < unknowns; i++) {
        sensitivity[i] = 0.0;
        for (k = 0; k < knowns; k++) {
            double partial;
            if (instance_partial(c, unknown[i], known[k], &partial))
                return fmi2Error;
            sensitivity[i] += partial * seed[k];
        }
    }
    return fmi2OK;
}

/* ---- co-simulation ---------------------------------------------------------------------------------------------- */

EXPORT fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real dt, fmi2Boolean no_set_before)
{
    int held = instance_step(c, time, dt);

    (void)no_set_before;
    if (held > 0)
        tell(c, 0, "an input is not finite: the last force is held");
    return held < 0 ? fmi2Error : held ? fmi2Warning : fmi2OK;
}

EXPORT fmi2Status fmi2CancelStep(fmi2Component c)
{
    (void)c;
    return fmi2Error;
}

/* No step is ever pending. Only fmi2LastSuccessfulTime and fmi2Terminated have values. */
EXPORT fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind kind, fmi2Status *value)
{
    (void)c;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real *value)
{
    if (kind != fmi2LastSuccessfulTime)
        return fmi2Discard;
    *value = instance_values(((struct instance *)c)->data)[0];
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind kind, fmi2Integer *value)
{
    (void)c;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean *value)
{
    if (kind != fmi2Terminated)
        return fmi2Discard;
    *value = ((struct instance *)c)->data->phase == TERMINATED;
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind kind, fmi2String *value)
{
    (void)c;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                              const fmi2Integer order[], const fmi2Real value[])
{
    size_t i;

    for (i = 0; i < n; i++)
        if (instance_set_derivative(c, vr[i], order[i], value[i]))
            return fmi2Error;
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                               const fmi2Integer order[], fmi2Real value[])
{
    (void)c;
    (void)vr;
    (void)order;
    (void)value;
    return answer(n != 0);
}

/* ---- model exchange --------------------------------------------------------------------------------------------- */

EXPORT fmi2Status fmi2SetTime(fmi2Component c, fmi2Real time)
{
    return answer(instance_set_time(c, time));
}

EXPORT fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n)
{
    return answer(n != states_of(c) || instance_set_states(c, x));
}

EXPORT fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n)
{
    return answer(n != states_of(c) || instance_states(c, x));
}

EXPORT fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real rates[], size_t n)
{
    return answer(n != states_of(c) || instance_rates(c, rates));
}

EXPORT fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real nominals[], size_t n)
{
    return answer(n != states_of(c) || instance_nominals(c, nominals));
}

EXPORT fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real indicators[], size_t n)
{
    return answer(n != corners_of(c) || instance_indicators(c, indicators));
}

EXPORT fmi2Status fmi2EnterEventMode(fmi2Component c)
{
    return answer(instance_enter_event_mode(c));
}

EXPORT fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info)
{
    memset(info, 0, sizeof *info);
    return answer(instance_settle_parameters(c));
}

EXPORT fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c)
{
    return answer(instance_enter_continuous_time(c));
}

EXPORT fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean no_set_before, fmi2Boolean *enter_event,
                                              fmi2Boolean *terminate)
{
    (void)c;
    (void)no_set_before;
    *enter_event = fmi2False;
    *terminate = fmi2False;
    return fmi2OK;
}
