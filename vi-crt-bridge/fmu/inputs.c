/* What the host tells of the motion, and what it means between the instants at which it tells it.
 *
 * Hosts that import for model exchange seldom set inputs in every stage of their integrator: CVODE in FMPy and fmusim sets them
 * where a step has ended and holds them through the next. A velocity that stands still for a millisecond is 2 % to 10 % of the
 * force late. So an instance remembers when the last two velocities were told and runs on along the line through them, until it is
 * told anew and at most for twice the time between the two. A host that sets its inputs in every stage, as one may expect, is not
 * touched by it: no time passes between its inputs and the question.
 *
 * When was an input told? Hosts set time and inputs in either order. Where the time was set since the last evaluation, before the
 * inputs, it is that time; where not, it is the time of the next evaluation, which follows both. */
#include "instance.h"
#include <math.h>

double *instance_values(const struct data *data)
{
    return (double *)(data->part + data->corners);
}

double instance_given(const struct data *data, int corner, enum kind kind)
{
    return instance_values(data)[1 + corner * BLOCK + (kind - DISPLACEMENT)];
}

int instance_displacement_given(const struct data *data, int corner)
{
    return instance_given(data, corner, DISPLACEMENT_GIVEN) != 0.0;
}

dashpot_input instance_input(const struct data *data, int corner)
{
    double scale = instance_given(data, corner, MOTION_SCALE);
    dashpot_input input = dashpot_input_velocity(scale * instance_given(data, corner, VELOCITY));

    if (instance_displacement_given(data, corner)) {
        input.known |= DASHPOT_KNOWS_DISPLACEMENT;
        input.displacement = scale * instance_given(data, corner, DISPLACEMENT) + instance_given(data, corner, POSITION_OFFSET);
    }
    input.known |= DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE;
    input.side_force = instance_given(data, corner, SIDE_FORCE);
    input.temperature = instance_given(data, corner, TEMPERATURE);
    return input;
}

static enum between between(const struct instance *instance)
{
    enum between chosen = (enum between)(int)instance_values(instance->data)[instance->contents->between];

    /* A co-simulation host may give the inputs of the step's end, and ours do: held is right there and safe elsewhere. */
    return chosen == AUTOMATIC ? (instance->exchange ? EXTRAPOLATE : HOLD) : chosen;
}

/* Runs a motion on by dt at an acceleration. */
static void run_on(dashpot_input *input, double acceleration, double dt)
{
    if (input->known & DASHPOT_KNOWS_DISPLACEMENT)
        input->displacement += input->velocity * dt + 0.5 * acceleration * dt * dt;
    input->velocity += acceleration * dt;
}

dashpot_input instance_input_now(const struct instance *instance, int corner)
{
    const struct data *data = instance->data;
    const struct told *told = &data->part[corner].told;
    dashpot_input input = instance_input(data, corner);
    double since = instance_values(data)[0] - told->at, apart = told->at - told->at_before;

    /* NaN, where something is not known, fails every comparison. */
    if (between(instance) == EXTRAPOLATE && since > 0.0 && apart > 0.0 && since < 2.0 * apart)
        run_on(&input, (told->velocity - told->velocity_before) / apart, since);
    return input;
}

dashpot_input instance_input_ahead(const struct instance *instance, int corner, double dt)
{
    const struct data *data = instance->data;
    const struct part *part = &data->part[corner];
    double scale = instance_given(data, corner, MOTION_SCALE);
    dashpot_input input = instance_input(data, corner);

    if (part->derivatives) {
        const double *d = part->derivative;
        double start = input.displacement;

        if (part->derivatives & 1u << (VELOCITY - DISPLACEMENT))
            run_on(&input, scale * d[VELOCITY - DISPLACEMENT], dt);
        if (part->derivatives & 1u)
            input.displacement = start + scale * d[0] * dt;
        if (part->derivatives & 1u << (SIDE_FORCE - DISPLACEMENT))
            input.side_force += d[SIDE_FORCE - DISPLACEMENT] * dt;
        if (part->derivatives & 1u << (TEMPERATURE - DISPLACEMENT))
            input.temperature += d[TEMPERATURE - DISPLACEMENT] * dt;
    } else if (between(instance) == EXTRAPOLATE && data->dt > 0.0) {
        double before = part->told.velocity;

        if (isfinite(before))
            run_on(&input, (input.velocity - before) / data->dt, dt);
    }
    return input;
}

void instance_input_forget(struct told *told)
{
    told->fresh = 0;
    told->when = told->at = told->velocity = told->at_before = told->velocity_before = NAN;
}

void instance_input_set(struct instance *instance, int corner)
{
    struct told *told = &instance->data->part[corner].told;

    told->fresh = 1;
    told->when = instance->data->moved ? instance_values(instance->data)[0] : NAN;
}

void instance_input_seen(struct instance *instance, int corner)
{
    struct data *data = instance->data;
    struct told *told = &data->part[corner].told;
    double velocity, when;

    if (!told->fresh)
        return;
    when = isnan(told->when) ? instance_values(data)[0] : told->when;
    velocity = instance_input(data, corner).velocity;
    told->fresh = 0;
    if (data->phase == EVENT) {
        /* A jump: the line before it says nothing of what follows. */
        told->at_before = NAN;
    } else if (when > told->at) {
        told->at_before = told->at;
        told->velocity_before = told->velocity;
    } else if (when < told->at && !(told->at_before < when)) {
        /* The host has gone back, behind all that is known. */
        told->at_before = NAN;
    }
    told->at = when;
    told->velocity = velocity;
}
