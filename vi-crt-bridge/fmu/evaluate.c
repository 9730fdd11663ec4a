#include "evaluate.h"
#include "complain.h"
#include "inputs.h"
#include <stdio.h>
#include <string.h>

int instance_states_lost(struct instance *instance)
{
    double step = instance->contents->explicit_step;
    char below[40] = "far shorter steps";

    if (step > 0.0)
        snprintf(below, sizeof below, "steps below %.2g microseconds", 1e6 * step);
    return instance_complain(instance,
                             "the states have left all bounds: the steps of the solver that integrates them are too long. This damper needs an "
                             "implicit solver (CVODE, DASSL, Radau) or %s; co-simulation is stable at every step",
                             below);
}

int instance_evaluate(struct instance *instance, int corner)
{
    struct data *data = instance->data;
    struct part *part = &data->part[corner];
    dashpot_state state, rate;
    dashpot_input input;
    int integrated = !instance_displacement_given(data, corner), k;
    int32_t status;

    instance_input_seen(instance, corner);
    if (corner + 1 == data->corners)
        data->moved = 0;
    input = instance_input_now(instance, corner);
    memset(&state, 0, sizeof state);
    state.displacement = integrated ? part->state[TRAVEL] : input.displacement;
    state.velocity = input.velocity;
    state.mass_displacement = state.displacement + part->state[DEFLECTION];
    state.mass_velocity = part->state[MASS_VELOCITY];
    for (k = FIRST_INTERNAL; k < STATES_OF_CORNER; k++)
        state.internal[k - FIRST_INTERNAL] = part->state[k];
    status = dashpot_evaluate(&part->corner.model, &state, &input, &part->corner.now.output, &rate);
    if (status == DASHPOT_BAD_STATE || status == DASHPOT_NOT_COMPUTABLE)
        return instance_states_lost(instance);
    if (status < 0)
        return instance_complain(instance, "%s", dashpot_status_text(status));
    part->status = status;
    part->corner.now.state = state;
    part->rate[TRAVEL] = integrated ? input.velocity : 0.0;
    part->rate[DEFLECTION] = rate.mass_displacement - input.velocity;
    part->rate[MASS_VELOCITY] = rate.mass_velocity;
    for (k = FIRST_INTERNAL; k < STATES_OF_CORNER; k++)
        part->rate[k] = rate.internal[k - FIRST_INTERNAL];
    return 0;
}
