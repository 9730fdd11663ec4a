/* The damper as an FMI 3.0 FMU: co-simulation and model exchange. */
#include "fmi3.h"
#include "instance.h"
#include <stdlib.h>
#include <string.h>

/* The logger is a function pointer. A structure wraps it, because the instance stores an object pointer. */
struct logger {
    fmi3LogMessageCallback call;
};

static void tell(struct instance *instance, int error, const char *text)
{
    struct logger *logger = instance->logger;

    if (logger && logger->call && (error || instance->logging))
        logger->call(instance->environment, error ? fmi3Error : fmi3Warning,
                     error ? "logStatusError" : "logStatusWarning", text);
}

static size_t states_of(const struct instance *instance)
{
    return (size_t)instance->contents->states;
}

static size_t corners_of(const struct instance *instance)
{
    return (size_t)instance->contents->corners;
}

static fmi3Status answer(int failed)
{
    return failed ? fmi3Error : fmi3OK;
}

static fmi3Instance instantiate(fmi3String name, fmi3String token, fmi3String resources, int exchange, bool logging,
                                fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    struct logger *logger = malloc(sizeof *logger);
    struct instance *instance;

    if (!logger)
        return NULL;
    logger->call = log;
    instance = instance_new(name, token, resources, exchange, logging, tell, logger, environment);
    if (!instance)
        free(logger);
    return instance;
}

EXPORT const char *fmi3GetVersion(void)
{
    return "3.0";
}

EXPORT fmi3Status fmi3SetDebugLogging(fmi3Instance c, bool on, size_t n, const fmi3String categories[])
{
    (void)n;
    (void)categories;
    ((struct instance *)c)->logging = on;
    return fmi3OK;
}

EXPORT fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, bool visible,
                                                 bool logging, fmi3InstanceEnvironment environment,
                                                 fmi3LogMessageCallback log)
{
    (void)visible;
    return instantiate(name, token, resources, 1, logging, environment, log);
}

EXPORT fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, bool visible,
                                                bool logging, bool event_mode, bool early_return,
                                                const fmi3ValueReference required[], size_t required_count,
                                                fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                                fmi3IntermediateUpdateCallback update)
{
    (void)visible;
    (void)event_mode;
    (void)early_return;
    (void)required;
    (void)required_count;
    (void)update;
    return instantiate(name, token, resources, 0, logging, environment, log);
}

EXPORT fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                                      bool visible, bool logging, fmi3InstanceEnvironment environment,
                                                      fmi3LogMessageCallback log, fmi3ClockUpdateCallback update,
                                                      fmi3LockPreemptionCallback lock, fmi3LockPreemptionCallback unlock)
{
    (void)name;
    (void)token;
    (void)resources;
    (void)visible;
    (void)logging;
    (void)environment;
    (void)log;
    (void)update;
    (void)lock;
    (void)unlock;
    return NULL;
}

EXPORT void fmi3FreeInstance(fmi3Instance c)
{
    if (c)
        free(((struct instance *)c)->logger);
    instance_free(c);
}

EXPORT fmi3Status fmi3EnterInitializationMode(fmi3Instance c, bool tolerance_defined, double tolerance, double start,
                                              bool stop_defined, double stop)
{
    (void)tolerance_defined;
    (void)tolerance;
    (void)stop_defined;
    (void)stop;
    return answer(instance_enter_initialization(c, start));
}

EXPORT fmi3Status fmi3ExitInitializationMode(fmi3Instance c)
{
    return answer(instance_exit_initialization(c));
}

EXPORT fmi3Status fmi3Terminate(fmi3Instance c)
{
    return answer(instance_terminate(c));
}

EXPORT fmi3Status fmi3Reset(fmi3Instance c)
{
    return answer(instance_reset(c));
}

/* ---- variables -------------------------------------------------------------------------------------------------- */

#define GET_AND_SET(Name, Type, type)                                                                                  \
    EXPORT fmi3Status fmi3Get##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, Type value[],             \
                                    size_t values)                                                                     \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n && i < values; i++) {                                                                        \
            double v;                                                                                                  \
            if (instance_get(c, vr[i], type, &v))                                                                      \
                return fmi3Error;                                                                                      \
            value[i] = (Type)v;                                                                                        \
        }                                                                                                              \
        return answer(n != values);                                                                                    \
    }                                                                                                                  \
    EXPORT fmi3Status fmi3Set##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const Type value[],       \
                                    size_t values)                                                                     \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        if (n != values)                                                                                               \
            return fmi3Error;                                                                                          \
        for (i = 0; i < n; i++)                                                                                        \
            if (instance_set(c, vr[i], type, (double)value[i]))                                                        \
                return fmi3Error;                                                                                      \
        return fmi3OK;                                                                                                 \
    }
GET_AND_SET(Float64, double, REAL)
GET_AND_SET(Int32, int32_t, INTEGER)
/* Enumerations are read and set as Int64. */
GET_AND_SET(Int64, int64_t, INTEGER)
GET_AND_SET(Boolean, bool, BOOLEAN)

/* Types of which the damper has no variables. */
#define NONE(Name, Type)                                                                                               \
    EXPORT fmi3Status fmi3Get##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, Type value[],             \
                                    size_t values)                                                                     \
    {                                                                                                                  \
        (void)c;                                                                                                       \
        (void)vr;                                                                                                      \
        (void)value;                                                                                                   \
        (void)values;                                                                                                  \
        return answer(n != 0);                                                                                         \
    }                                                                                                                  \
    EXPORT fmi3Status fmi3Set##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const Type value[],       \
                                    size_t values)                                                                     \
    {                                                                                                                  \
        (void)c;                                                                                                       \
        (void)vr;                                                                                                      \
        (void)value;                                                                                                   \
        (void)values;                                                                                                  \
        return answer(n != 0);                                                                                         \
    }
NONE(Float32, float)
NONE(Int8, int8_t)
NONE(UInt8, uint8_t)
NONE(Int16, int16_t)
NONE(UInt16, uint16_t)
NONE(UInt32, uint32_t)
NONE(UInt64, uint64_t)
NONE(String, fmi3String)

EXPORT fmi3Status fmi3GetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t n, size_t sizes[],
                                fmi3Binary value[], size_t values)
{
    (void)c;
    (void)vr;
    (void)sizes;
    (void)value;
    (void)values;
    return answer(n != 0);
}

EXPORT fmi3Status fmi3SetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const size_t sizes[],
                                const fmi3Binary value[], size_t values)
{
    (void)c;
    (void)vr;
    (void)sizes;
    (void)value;
    (void)values;
    return answer(n != 0);
}

EXPORT fmi3Status fmi3GetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Clock value[])
{
    (void)c;
    (void)vr;
    (void)value;
    return answer(n != 0);
}

EXPORT fmi3Status fmi3SetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Clock value[])
{
    (void)c;
    (void)vr;
    (void)value;
    return answer(n != 0);
}

/* Not supported: the model description contains the dependencies of every variable. */
EXPORT fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance c, fmi3ValueReference vr, size_t *n)
{
    (void)c;
    (void)vr;
    (void)n;
    return fmi3Error;
}

EXPORT fmi3Status fmi3GetVariableDependencies(fmi3Instance c, fmi3ValueReference dependent, size_t element[],
                                              fmi3ValueReference independent[], size_t independent_element[],
                                              fmi3DependencyKind kinds[], size_t n)
{
    (void)c;
    (void)dependent;
    (void)element;
    (void)independent;
    (void)independent_element;
    (void)kinds;
    (void)n;
    return fmi3Error;
}

/* ---- FMU state -------------------------------------------------------------------------------------------------- */

EXPORT fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *state)
{
    if (!*state)
        *state = malloc(instance_data_bytes(c));
    if (!*state)
        return fmi3Error;
    memcpy(*state, ((struct instance *)c)->data, instance_data_bytes(c));
    return fmi3OK;
}

EXPORT fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state)
{
    memcpy(((struct instance *)c)->data, state, instance_data_bytes(c));
    return fmi3OK;
}

EXPORT fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *state)
{
    (void)c;
    free(*state);
    *state = NULL;
    return fmi3OK;
}

EXPORT fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t *size)
{
    (void)state;
    *size = instance_bytes(c);
    return fmi3OK;
}

EXPORT fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size)
{
    if (size < instance_bytes(c))
        return fmi3Error;
    instance_serialize(c, state, bytes);
    return fmi3OK;
}

EXPORT fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *state)
{
    struct data *data = *state ? *state : malloc(instance_data_bytes(c));

    if (!data)
        return fmi3Error;
    if (instance_deserialize(c, data, bytes, size)) {
        if (!*state)
            free(data);
        return fmi3Error;
    }
    *state = data;
    return fmi3OK;
}

/* ---- derivatives ------------------------------------------------------------------------------------------------ */

EXPORT fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, const fmi3ValueReference unknown[], size_t unknowns,
                                               const fmi3ValueReference known[], size_t knowns, const double seed[],
                                               size_t seeds, double sensitivity[], size_t sensitivities)
{
    size_t i, k;

    if (seeds != knowns || sensitivities != unknowns)
        return fmi3Error;
    for (i = 0; i < unknowns; i++) {
        sensitivity[i] = 0.0;
        for (k = 0; k < knowns; k++) {
            double partial;
            if (instance_partial(c, unknown[i], known[k], &partial))
                return fmi3Error;
            sensitivity[i] += partial * seed[k];
        }
    }
    return fmi3OK;
}

EXPORT fmi3Status fmi3GetAdjointDerivative(fmi3Instance c, const fmi3ValueReference unknown[], size_t unknowns,
                                           const fmi3ValueReference known[], size_t knowns, const double seed[],
                                           size_t seeds, double sensitivity[], size_t sensitivities)
{
    size_t i, k;

    if (seeds != unknowns || sensitivities != knowns)
        return fmi3Error;
    for (k = 0; k < knowns; k++) {
        sensitivity[k] = 0.0;
        for (i = 0; i < unknowns; i++) {
            double partial;
            if (instance_partial(c, unknown[i], known[k], &partial))
                return fmi3Error;
            sensitivity[k] += partial * seed[i];
        }
    }
    return fmi3OK;
}

EXPORT fmi3Status fmi3GetOutputDerivatives(fmi3Instance c, const fmi3ValueReference vr[], size_t n,
                                           const int32_t order[], double value[], size_t values)
{
    (void)c;
    (void)vr;
    (void)order;
    (void)value;
    (void)values;
    return answer(n != 0);
}

/* ---- modes ------------------------------------------------------------------------------------------------------ */

EXPORT fmi3Status fmi3EnterConfigurationMode(fmi3Instance c)
{
    (void)c;
    return fmi3OK;
}

EXPORT fmi3Status fmi3ExitConfigurationMode(fmi3Instance c)
{
    (void)c;
    return fmi3OK;
}

EXPORT fmi3Status fmi3EnterEventMode(fmi3Instance c)
{
    return answer(((struct instance *)c)->exchange && instance_enter_event_mode(c));
}

EXPORT fmi3Status fmi3EnterStepMode(fmi3Instance c)
{
    (void)c;
    return fmi3OK;
}

EXPORT fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance c)
{
    (void)c;
    return fmi3OK;
}

EXPORT fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, bool *again, bool *terminate, bool *nominals, bool *values,
                                           bool *next_defined, double *next)
{
    *again = *terminate = *nominals = *values = *next_defined = false;
    *next = 0.0;
    return answer(instance_settle_parameters(c));
}

/* ---- co-simulation ---------------------------------------------------------------------------------------------- */

EXPORT fmi3Status fmi3DoStep(fmi3Instance c, double time, double dt, bool no_set_before, bool *event, bool *terminate,
                             bool *early, double *last)
{
    int held = instance_step(c, time, dt);

    (void)no_set_before;
    *event = *terminate = *early = false;
    *last = instance_values(((struct instance *)c)->data)[0];
    if (held > 0)
        tell(c, 0, "an input is not finite: the last force is held");
    return held < 0 ? fmi3Error : held ? fmi3Warning : fmi3OK;
}

/* ---- model exchange --------------------------------------------------------------------------------------------- */

EXPORT fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c)
{
    return answer(instance_enter_continuous_time(c));
}

EXPORT fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, bool no_set_before, bool *enter_event, bool *terminate)
{
    (void)c;
    (void)no_set_before;
    *enter_event = *terminate = false;
    return fmi3OK;
}

EXPORT fmi3Status fmi3SetTime(fmi3Instance c, double time)
{
    return answer(instance_set_time(c, time));
}

EXPORT fmi3Status fmi3SetContinuousStates(fmi3Instance c, const double x[], size_t n)
{
    return answer(n != states_of(c) || instance_set_states(c, x));
}

EXPORT fmi3Status fmi3GetContinuousStates(fmi3Instance c, double x[], size_t n)
{
    return answer(n != states_of(c) || instance_states(c, x));
}

EXPORT fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, double rates[], size_t n)
{
    return answer(n != states_of(c) || instance_rates(c, rates));
}

EXPORT fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, double nominals[], size_t n)
{
    return answer(n != states_of(c) || instance_nominals(c, nominals));
}

EXPORT fmi3Status fmi3GetEventIndicators(fmi3Instance c, double indicators[], size_t n)
{
    return answer(n != corners_of(c) || instance_indicators(c, indicators));
}

EXPORT fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t *n)
{
    *n = corners_of(c);
    return fmi3OK;
}

EXPORT fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t *n)
{
    (void)c;
    *n = states_of(c);
    return fmi3OK;
}

/* ---- clocks: there are none ------------------------------------------------------------------------------------- */

#define NO_CLOCK(Name, ...)                                                                                            \
    EXPORT fmi3Status fmi3##Name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, __VA_ARGS__)                 \
    {                                                                                                                  \
        (void)c;                                                                                                       \
        (void)vr;                                                                                                      \
        return answer(n != 0);                                                                                         \
    }
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
NO_CLOCK(GetIntervalDecimal, double intervals[], fmi3IntervalQualifier qualifiers[])
NO_CLOCK(GetIntervalFraction, uint64_t counters[], uint64_t resolutions[], fmi3IntervalQualifier qualifiers[])
NO_CLOCK(GetShiftDecimal, double shifts[])
NO_CLOCK(GetShiftFraction, uint64_t counters[], uint64_t resolutions[])
NO_CLOCK(SetIntervalDecimal, const double intervals[])
NO_CLOCK(SetIntervalFraction, const uint64_t counters[], const uint64_t resolutions[])
NO_CLOCK(SetShiftDecimal, const double shifts[])
NO_CLOCK(SetShiftFraction, const uint64_t counters[], const uint64_t resolutions[])

EXPORT fmi3Status fmi3ActivateModelPartition(fmi3Instance c, fmi3ValueReference clock, double time)
{
    (void)c;
    (void)clock;
    (void)time;
    return fmi3Error;
}
