/* Co-simulation: the FMU integrates its own states. */
#include "instance.h"
#include <math.h>

/* The kernel's longest step, s (DASHPOT_BAD_TIME_STEP). A longer step is probably in milliseconds instead of seconds. */
static const double LONGEST = 100.0;

int instance_step(struct instance *instance, double time, double dt)
{
    struct data *data = instance->data;
    int c, held = 0;

    if (instance->exchange)
        return instance_complain(instance, "a step of an instance that was made for model exchange");
    if (data->phase != RUNNING)
        return instance_complain(instance, "a step before the end of initialization or after terminate");
    if (!(dt >= 0.0 && dt <= LONGEST))
        return instance_complain(instance,
                                 dt > LONGEST ? "a communication step of %g s is too long: the damper takes at most %g s, and resolves fast "
                                                "motion in steps of 0.01 s or less. Is it in milliseconds?"
                                              : "a communication step of %g s is none: it lies between 0 and %g s",
                                 dt, LONGEST);
    if (instance_settle_parameters(instance))
        return -1;
    for (c = 0; c < data->corners; c++) {
        struct part *part = &data->part[c];
        dashpot_input input = instance_input_ahead(instance, c, dt);

        part->from = part->corner.now.state;
        part->status = dashpot_corner_step(&part->corner, &input, dt);
        held |= part->status & DASHPOT_BRIDGE_LAST_FORCE;
        /* Store the velocity at the start of this step. With `extrapolate` the next step uses the line through this velocity and
         * the velocity at its own start. */
        part->told.velocity[0] = instance_input(data, c).velocity;
        part->derivatives = 0;
    }
    data->dt = dt;
    instance_values(data)[0] = time + dt;
    data->stale = 0;
    return held != 0;
}

int instance_set_derivative(struct instance *instance, uint32_t reference, int order, double value)
{
    const struct variable *v =
        reference < instance->contents->variables ? &instance->contents->variable[reference] : NULL;

    if (!v || ((v->kind < DISPLACEMENT || v->kind > TEMPERATURE) && v->kind != SETTING))
        return instance_complain(instance, "value reference %u is no input", (unsigned)reference);
    if (order != 1)
        return instance_complain(instance, "an input has a first derivative here, and none of order %d", order);
    if (!isfinite(value))
        return instance_complain(instance, "the derivative of an input must be finite");
    order = v->kind == SETTING ? OF_SETTING : (int)v->kind - DISPLACEMENT;
    instance->data->part[v->corner].derivative[order] = value;
    instance->data->part[v->corner].derivatives |= 1u << order;
    return 0;
}
