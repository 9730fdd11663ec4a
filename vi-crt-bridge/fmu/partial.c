/* Partial derivatives of the FMU's variables: from the kernel where it has them, otherwise by central differences. */
#include "instance.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Computes a derivative of force or state derivative with respect to displacement, velocity or a state, from the kernel.
 * Returns 1, or 0 if the kernel does not have the requested one. */
static int analytic(struct instance *instance, const struct variable *u, const struct variable *k, double *partial)
{
    struct data *data = instance->data;
    struct part *part = &data->part[u->corner];
    double motion = instance_given(data, u->corner, MOTION_SCALE), force = instance_given(data, u->corner, FORCE_SCALE);
    int integrated = !instance_displacement_given(data, u->corner), row = u->index - DEFLECTION;
    dashpot_partials p;
    dashpot_input input;

    if (!instance->exchange) {
        const dashpot_output *o = &part->corner.now.output;

        if (u->kind != FORCE || (k->kind != DISPLACEMENT && k->kind != VELOCITY) || part->derivatives)
            return 0;
        *partial = force * motion * (k->kind == VELOCITY ? o->d_force_d_velocity : integrated ? 0.0 : o->d_force_d_displacement);
        return 1;
    }
    if ((u->kind != FORCE && u->kind != RATE) || (k->kind != DISPLACEMENT && k->kind != VELOCITY && k->kind != STATE))
        return 0;
    if (u->kind == RATE && u->index == TRAVEL) {
        *partial = k->kind == VELOCITY && integrated ? motion : 0.0;
        return 1;
    }
    if ((k->kind == STATE && k->index == TRAVEL && !integrated) || (k->kind == DISPLACEMENT && integrated)) {
        *partial = 0.0;
        return 1;
    }
    input = instance_input_now(instance, u->corner);
    if (dashpot_jacobian(&part->corner.model, &part->corner.now.state, &input, &p) < 0)
        return 0;
    if (k->kind == STATE && k->index > TRAVEL) {
        int column = k->index - DEFLECTION;

        *partial = u->kind == FORCE ? p.d_force_d_state[column] : p.d_rate_d_state[row][column];
    } else if (k->kind == VELOCITY) {
        *partial = u->kind == FORCE ? p.d_force_d_input[1] : p.d_rate_d_input[row][1] - (u->index == DEFLECTION ? 1.0 : 0.0);
    } else {
        /* The internal mass is at displacement + deflection, so it moves with the displacement, whether given or integrated. */
        *partial = u->kind == FORCE ? p.d_force_d_input[0] + p.d_force_d_state[0]
                                    : p.d_rate_d_input[row][0] + p.d_rate_d_state[row][0];
    }
    *partial *= (u->kind == FORCE ? force : 1.0) * (k->kind == STATE ? 1.0 : motion);
    return 1;
}

/* Computes a derivative with respect to the setting from the kernel, because differences would step beyond the ends of the
 * setting's grid. */
static int by_setting(struct instance *instance, const struct variable *u, double *partial)
{
    struct part *part = &instance->data->part[u->corner];
    dashpot_input input = instance_input_now(instance, u->corner);
    dashpot_setting_derivatives by;
    int32_t status = dashpot_jacobian_setting(&part->corner.model, &part->corner.now.state, &input, &by);

    if (status < 0)
        return instance_complain(instance, "%s", dashpot_status_text(status));
    if (u->kind == FORCE)
        *partial = instance_given(instance->data, u->corner, FORCE_SCALE) * by.d_force_d_setting;
    else
        *partial = u->index == TRAVEL ? 0.0 : by.d_rate_d_setting[u->index - DEFLECTION];
    return 0;
}

/* Computes the unknown with the known variable changed by `by`, on a copy of the data. In co-simulation it repeats the last
 * step. */
static int moved(struct instance *instance, uint32_t unknown, uint32_t known, double by, double *value)
{
    const struct variable *k = &instance->contents->variable[known];
    struct data *kept = instance->data, *copy = malloc(instance_data_bytes(instance));
    struct part *part;
    int answer;

    if (!copy)
        return instance_complain(instance, "no memory");
    memcpy(copy, kept, instance_data_bytes(instance));
    instance->data = copy;
    part = &copy->part[k->corner];
    if (k->kind == STATE)
        part->state[k->index] += by;
    else
        instance_values(copy)[known] += by;
    copy->retune = k->kind == PARAMETER;
    answer = instance_settle_parameters(instance);
    copy->stale = 1;
    if (!answer && !instance->exchange) {
        dashpot_input input = instance_input(copy, k->corner);

        part->corner.now.state = part->from;
        part->status = dashpot_corner_step(&part->corner, &input, copy->dt);
        copy->stale = 0;
    }
    answer = answer ? answer : instance_get(instance, unknown, REAL, value);
    instance->data = kept;
    free(copy);
    return answer;
}

/* Returns the ends of the differences with respect to the setting `at`, relative to it. They stay inside the grid, at whose ends the
 * setting is clamped. Their distance is a fraction of the grid, whatever the unit of the setting is. */
static void setting_ends(const struct part *part, double at, double *down, double *up)
{
    dashpot_setting setting;
    double low, high, by;

    setting.struct_size = (uint32_t)sizeof setting;
    *down = *up = 0.0;
    if (dashpot_params_setting(&part->corner.params, &setting) < 0 || setting.count < 2)
        return;
    low = setting.grid[0];
    high = setting.grid[setting.count - 1];
    by = 1e-6 * (high - low);
    *down = at >= low && at - by < low ? 0.0 : -by;
    *up = at <= high && at + by > high ? 0.0 : by;
}

int instance_partial(struct instance *instance, uint32_t unknown, uint32_t known, double *partial)
{
    const struct variable *u, *k;
    double up, down, from, to, at, usual, ignored;

    *partial = 0.0;
    if (unknown >= instance->contents->variables || known >= instance->contents->variables)
        return instance_complain(instance, "a derivative of or by a variable that is not there");
    u = &instance->contents->variable[unknown];
    k = &instance->contents->variable[known];
    if (instance_settle_parameters(instance) || instance_get(instance, unknown, REAL, &ignored) ||
        instance_get(instance, known, REAL, &at))
        return -1;
    if (u->corner != k->corner || u->corner < 0)
        return 0;
    if (analytic(instance, u, k, partial))
        return 0;
    if (k->kind != DISPLACEMENT && k->kind != VELOCITY && k->kind != SIDE_FORCE && k->kind != TEMPERATURE &&
        k->kind != SETTING && k->kind != PARAMETER && (k->kind != STATE || !instance->exchange))
        return instance_complain(instance, "no derivative by that variable");
    if (k->kind == SETTING && instance->exchange && (u->kind == FORCE || u->kind == RATE))
        return by_setting(instance, u, partial);
    usual = k->kind == SIDE_FORCE || k->kind == TEMPERATURE ? 1.0 : 1e-3;
    to = 1e-6 * (fabs(at) > usual ? fabs(at) : usual);
    from = -to;
    if (k->kind == SETTING)
        setting_ends(&instance->data->part[k->corner], at, &from, &to);
    if (from == to)
        return 0;
    if (moved(instance, unknown, known, to, &up) || moved(instance, unknown, known, from, &down))
        return -1;
    *partial = (up - down) / (to - from);
    return 0;
}
