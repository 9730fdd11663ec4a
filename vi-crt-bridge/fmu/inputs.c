/* Inputs of the host, and their course between the times at which the host sets them.
 *
 * In model exchange few hosts set the inputs in every stage of their integrator: CVODE in FMPy and fmusim sets them at the end
 * of a step and keeps them constant during the next. A velocity that is constant for a millisecond causes a force error of 2 %
 * to 10 %. An instance therefore stores the last velocities with their times and extrapolates linearly through the last two.
 * The extrapolation ends when the host sets the motion again, or after twice the interval of the two velocities.
 *
 * A host that sets its inputs in every stage is not affected, because no time passes between inputs and evaluation. Some of
 * these hosts request outputs at a time before the end of the last step and do not change the inputs. The input there is
 * interpolated from the stored velocities.
 *
 * Hosts set time and inputs in either order. If the time was set since the last evaluation, before the inputs, it is the time
 * of the inputs. Otherwise the time of the inputs is that of the next evaluation, which follows both. */
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

    /* A co-simulation host may set the inputs of the end of a step, as our adapters do. HOLD is then exact, and otherwise safe. */
    return chosen == AUTOMATIC ? (instance->exchange ? EXTRAPOLATE : HOLD) : chosen;
}

/* Advances a motion by dt with constant acceleration. */
static void run_on(dashpot_input *input, double acceleration, double dt)
{
    if (input->known & DASHPOT_KNOWS_DISPLACEMENT)
        input->displacement += input->velocity * dt + 0.5 * acceleration * dt * dt;
    input->velocity += acceleration * dt;
}

/* Returns the velocity at a time before the newest one, by the polynomial through the stored velocities (Newton's form).
 * Linear interpolation suffices for most dampers, but an internal mass needs the acceleration and steep dry friction the time
 * of the reversal. The displacements are not used: in a host's table, linear between its rows, they are not the integral of
 * the velocities. */
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

    /* An unknown time is NaN, for which every comparison is false. */
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
    } else if (between(instance) == EXTRAPOLATE) {
        double before = part->told.velocity[0];

        /* In the first step no earlier velocity is known. The motion then goes on at its velocity: with the displacement of the
         * start, a damper that starts in motion would stand still for a step and move two steps in the next. */
        run_on(&input, data->dt > 0.0 && isfinite(before) ? (input.velocity - before) / data->dt : 0.0, dt);
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
        /* The input may jump at an event, so earlier velocities must not be extrapolated. */
        told->at[1] = NAN;
    } else if (when > told->at[0]) {
        for (i = TOLD - 1; i > 0; i--) {
            told->at[i] = told->at[i - 1];
            told->velocity[i] = told->velocity[i - 1];
        }
    } else if (when < told->at[0] && !(told->at[1] < when)) {
        /* The host has gone back to a time that is not after the second newest one. */
        told->at[1] = NAN;
    }
    told->at[0] = when;
    told->velocity[0] = velocity;
}
