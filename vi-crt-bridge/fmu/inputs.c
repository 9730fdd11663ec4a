/* What the host tells of the motion, and what it means between the instants at which it tells it.
 *
 * Hosts that import for model exchange seldom set inputs in every stage of their integrator: CVODE in FMPy and fmusim sets them
 * where a step has ended and holds them through the next. A velocity that stands still for a millisecond is 2 % to 10 % of the
 * force late. So an instance remembers when the last two velocities were told and runs on along the line through them, until it is
 * told anew and at most for twice the time between the two. A host that sets its inputs in every stage, as one may expect, is not
 * touched by it: no time passes between its inputs and the question. Some of those ask for outputs at an instant that their solver has
 * stepped over, and leave the inputs where they were: what was told leads back to it.
 *
 * When was an input told? Hosts set time and inputs in either order. Where the time was set since the last evaluation, before the
 * inputs, it is that time; where not, it is the time of the next evaluation, which follows both. */
#include "inputs.h"
#include <math.h>
#include <string.h>

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
    return instance_given(data, corner, HAS_DISPLACEMENT) != 0.0;
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
    if (data->part[corner].setting)
        input = dashpot_input_with_setting(input, instance_values(data)[data->part[corner].setting]);
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

/* The velocity at an instant before the newest one, on the polynomial through those that are known (Newton's form). A chord would do for
 * most dampers; a moving mass asks for the acceleration, and steep dry friction for the instant of the reversal. The displacements that
 * were told would bend it too, but a host's table of both, straight between its rows, has a displacement that is not the integral of its
 * velocity. */
static double velocity_at(const struct told *told, double time)
{
    double difference[TOLD], velocity = told->velocity[0], product = 1.0;
    int order, i;

    memcpy(difference, told->velocity, sizeof difference);
    for (order = 1; order < TOLD && told->at[order] < told->at[order - 1]; order++) {
        for (i = 0; i + order < TOLD; i++)
            difference[i] = (difference[i] - difference[i + 1]) / (told->at[i] - told->at[i + order]);
        product *= time - told->at[order - 1];
        velocity += difference[0] * product;
    }
    return velocity;
}

dashpot_input instance_input_now(const struct instance *instance, int corner)
{
    const struct data *data = instance->data;
    const struct told *told = &data->part[corner].told;
    dashpot_input input = instance_input(data, corner);
    double now = instance_values(data)[0], since = now - told->at[0], apart = told->at[0] - told->at[1];

    /* NaN, where something is not known, fails every comparison. */
    if (between(instance) != EXTRAPOLATE || !(apart > 0.0 && fabs(since) < 2.0 * apart))
        return input;
    if (since > 0.0) {
        run_on(&input, (told->velocity[0] - told->velocity[1]) / apart, since);
    } else if (since < 0.0) {
        double velocity = velocity_at(told, now);

        /* Simpson's rule is exact for a cubic. */
        if (input.known & DASHPOT_KNOWS_DISPLACEMENT)
            input.displacement += since * (told->velocity[0] + 4.0 * velocity_at(told, now - 0.5 * since) + velocity) / 6.0;
        input.velocity = velocity;
    }
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
        if (part->derivatives & 1u << OF_SETTING)
            input.setting += d[OF_SETTING] * dt;
    } else if (between(instance) == EXTRAPOLATE && data->dt > 0.0) {
        double before = part->told.velocity[0];

        if (isfinite(before))
            run_on(&input, (input.velocity - before) / data->dt, dt);
    }
    return input;
}

void instance_input_forget(struct told *told)
{
    int i;

    told->fresh = 0;
    told->when = NAN;
    for (i = 0; i < TOLD; i++)
        told->at[i] = told->velocity[i] = NAN;
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
    int i;

    if (!told->fresh)
        return;
    when = isnan(told->when) ? instance_values(data)[0] : told->when;
    velocity = instance_input(data, corner).velocity;
    told->fresh = 0;
    if (data->phase == EVENT) {
        /* A jump: the line before it says nothing of what follows. */
        told->at[1] = NAN;
    } else if (when > told->at[0]) {
        for (i = TOLD - 1; i > 0; i--) {
            told->at[i] = told->at[i - 1];
            told->velocity[i] = told->velocity[i - 1];
        }
    } else if (when < told->at[0] && !(told->at[1] < when)) {
        /* The host has gone back, behind all that is known. */
        told->at[1] = NAN;
    }
    told->at[0] = when;
    told->velocity[0] = velocity;
}
