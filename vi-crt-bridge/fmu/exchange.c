/* Model exchange: the host's solver integrates the states.
 *
 * The state of the internal mass is its deflection relative to the moving end. With its displacement as state, a host with
 * constant inputs would fix one end of the series spring while the other moves. At 3 MN/m, 0.6 m/s and a step of 1 ms, the
 * force error is 1800 N. */
#include "evaluate.h"
#include "instance.h"
#include <math.h>
#include <string.h>

int instance_enter_event_mode(struct instance *instance)
{
    if (!instance->exchange)
        return instance_complain(instance, "event mode of an instance that was made for co-simulation");
    if (instance->data->phase != RUNNING && instance->data->phase != EVENT)
        return instance_complain(instance, "event mode before the end of initialization or after terminate");
    instance->data->phase = EVENT;
    return 0;
}

int instance_enter_continuous_time(struct instance *instance)
{
    if (instance->data->phase != RUNNING && instance->data->phase != EVENT)
        return instance_complain(instance, "continuous-time mode before the end of initialization or after terminate");
    /* Evaluate before the phase changes, because inputs set in event mode count as a jump (instance_input_seen()). */
    if (instance_settle_parameters(instance) || instance_refresh(instance))
        return -1;
    instance->data->phase = RUNNING;
    return 0;
}

int instance_set_time(struct instance *instance, double time)
{
    struct data *data = instance->data;

    if (!isfinite(time))
        return instance_complain(instance, "the time is not finite");
    if (instance_values(data)[0] != time) {
        instance_values(data)[0] = time;
        data->moved = 1;
        data->stale = 1;
    }
    return 0;
}

/* Iterates over the states, which have the host's order in the table of variables. */
#define EACH_STATE(instance, v)                                                                                        \
    for (v = (instance)->contents->variable; v < (instance)->contents->variable + (instance)->contents->variables; v++) \
        if (v->kind == STATE)

int instance_states(struct instance *instance, double *states)
{
    const struct variable *v;

    if (instance_refresh(instance))
        return -1;
    EACH_STATE(instance, v)
        *states++ = instance->data->part[v->corner].state[v->index];
    return 0;
}

int instance_set_states(struct instance *instance, const double *states)
{
    const struct variable *v;
    int k;

    for (k = 0; k < instance->contents->states; k++)
        if (!isfinite(states[k]))
            return instance_states_lost(instance);
    EACH_STATE(instance, v)
        instance->data->part[v->corner].state[v->index] = *states++;
    instance->data->stale = 1;
    return 0;
}

int instance_rates(struct instance *instance, double *rates)
{
    const struct variable *v;

    if (instance_settle_parameters(instance) || instance_refresh(instance))
        return -1;
    EACH_STATE(instance, v)
        *rates++ = instance->data->part[v->corner].rate[v->index];
    return 0;
}

int instance_nominals(struct instance *instance, double *nominals)
{
    const struct variable *v;

    EACH_STATE(instance, v)
        *nominals++ = instance->contents->nominal[v->corner][v->index];
    return 0;
}

/* The indicator changes sign where the velocity leaves the range of the identified curve. The status then changes, and a host
 * reads it only at an event. With event indicators, CVODE in FMPy and fmusim also sets the inputs after each of its steps,
 * not only at communication points. */
int instance_indicators(struct instance *instance, double *indicators)
{
    int c;

    for (c = 0; c < instance->data->corners; c++)
        if (instance_get(instance, 1 + (uint32_t)(c * BLOCK + (SPEED_MARGIN - DISPLACEMENT)), REAL, &indicators[c]))
            return -1;
    return 0;
}
