/* Directional derivatives: the kernel's own partials where it has them, differences elsewhere. */
#include "instance.h"
#include <math.h>
#include <string.h>

/* Force and rates by displacement, velocity and states, from the kernel. Returns 1 where it has this one. */
static int analytic(struct instance *instance, const struct variable *u, const struct variable *k, double *partial)
{
    struct data *data = &instance->data;
    dashpot_corner *corner = &data->corner[u->corner];
    double motion = instance_given(data, u->corner, MOTION_SCALE), force = instance_given(data, u->corner, FORCE_SCALE);
    int integrated = instance_given(data, u->corner, DISPLACEMENT_GIVEN) == 0.0;
    dashpot_partials p;
    dashpot_input input;
    int column;

    if (!instance->exchange) {
        const dashpot_output *o = &corner->now.output;
        if (u->kind != FORCE || (k->kind != DISPLACEMENT && k->kind != VELOCITY))
            return 0;
        *partial = force * motion * (k->kind == VELOCITY ? o->force_by_velocity : integrated ? 0.0 : o->force_by_displacement);
        return 1;
    }
    if ((u->kind != FORCE && u->kind != RATE) || (k->kind != DISPLACEMENT && k->kind != VELOCITY && k->kind != STATE))
        return 0;
    if (u->kind == RATE && u->index == 0) {
        *partial = k->kind == VELOCITY && integrated ? motion : 0.0;
        return 1;
    }
    if ((k->kind == STATE && k->index == 0 && !integrated) || (k->kind == DISPLACEMENT && integrated)) {
        *partial = 0.0;
        return 1;
    }
    input = instance_input(data, u->corner);
    if (dashpot_jacobian(&corner->model, &corner->now.state, &input, &p) < 0)
        return 0;
    /* The integrated displacement acts as the given one. */
    column = k->kind == VELOCITY ? 1 : 0;
    if (k->kind == STATE && k->index > 0)
        *partial = u->kind == FORCE ? p.force_by_state[k->index - 1] : p.rate_by_state[u->index - 1][k->index - 1];
    else
        *partial = u->kind == FORCE ? p.force_by_input[column] : p.rate_by_input[u->index - 1][column];
    *partial *= (u->kind == FORCE ? force : 1.0) * (k->kind == STATE ? 1.0 : motion);
    return 1;
}

/* The unknown with the known moved by `by`; in co-simulation the last step is taken again. */
static int moved(struct instance *instance, uint32_t unknown, uint32_t known, double by, double *value)
{
    struct data *data = &instance->data;
    const struct variable *k = &VARIABLE[known];
    dashpot_corner_memory now = data->corner[k->corner].now;
    dashpot_state rate = data->rate[k->corner];
    double time = data->value[0], before = data->value[known];
    int stale = data->stale, retune = data->retune, answer;
    dashpot_params params = data->corner[k->corner].params;
    dashpot_model model = data->corner[k->corner].model;
    dashpot_state from = data->from[k->corner];
    int32_t status = data->status[k->corner];

    if (k->kind == STATE)
        *instance_state_number(&data->corner[k->corner].now.state, k->index) += by;
    else
        data->value[known] += by;
    data->retune = k->kind == PARAMETER;
    answer = instance_settle_parameters(instance);
    data->stale = 1;
    if (!answer && !instance->exchange) {
        dashpot_input input = instance_input(data, k->corner);

        data->corner[k->corner].now.state = from;
        data->status[k->corner] = dashpot_corner_step(&data->corner[k->corner], &input, data->dt);
        data->stale = 0;
    }
    answer = answer ? answer : instance_get(instance, unknown, REAL, value);
    data->corner[k->corner].now = now;
    data->corner[k->corner].params = params;
    data->corner[k->corner].model = model;
    data->rate[k->corner] = rate;
    data->status[k->corner] = status;
    data->value[known] = before;
    data->value[0] = time;
    data->stale = stale;
    data->retune = retune;
    return answer;
}

int instance_partial(struct instance *instance, uint32_t unknown, uint32_t known, double *partial)
{
    const struct variable *u, *k;
    double up, down, by, at, ignored;

    *partial = 0.0;
    if (unknown >= VARIABLES || known >= VARIABLES)
        return instance_get(instance, VARIABLES, REAL, &at);
    u = &VARIABLE[unknown];
    k = &VARIABLE[known];
    if (instance_settle_parameters(instance) || instance_get(instance, unknown, REAL, &ignored) ||
        instance_get(instance, known, REAL, &at))
        return -1;
    if (u->corner != k->corner || u->corner < 0)
        return 0;
    if (analytic(instance, u, k, partial))
        return 0;
    if (k->kind != DISPLACEMENT && k->kind != VELOCITY && k->kind != SIDE_FORCE && k->kind != TEMPERATURE &&
        k->kind != PARAMETER && (k->kind != STATE || !instance->exchange)) {
        instance->log(instance, 1, "no derivative by that variable");
        return -1;
    }
    by = 1e-6 * fmax(fabs(at), k->kind == SIDE_FORCE || k->kind == TEMPERATURE ? 1.0 : 1e-3);
    if (moved(instance, unknown, known, by, &up) || moved(instance, unknown, known, -by, &down))
        return -1;
    *partial = (up - down) / (2.0 * by);
    return 0;
}
