#include "committed.h"
#include "lock.h"
#include "messages.h"
#include "solver.h"

#include <math.h>
#include <string.h>

enum { MOST_DAMPERS = 256, STATE_NUMBERS = sizeof(dashpot_state) / sizeof(double), SAVED_FORMAT = 3 };

/* Longest step of the damper, s. A longer step of the solver is divided, so that only the interpolated motion inside it
 * is inaccurate, not the damper's response. Above MOST_STEPS divisions the steps become longer. */
static const double LONGEST_STEP = 2.5e-4;
enum { MOST_STEPS = 4000 };

typedef struct {
    int kind, element;
    /* The last committed time and state. is_start: they are those at the start of a run. */
    int is_set, is_start;
    double time;
    dashpot_state state;
    /* The last trial after the committed time. */
    int has_trial;
    request trial;
    /* The last output and its state, for REQUEST elements. */
    dashpot_output output;
    dashpot_state output_state;
    int has_output;
} committed;

static committed dampers[MOST_DAMPERS];
static volatile long dampers_lock;

static committed *damper_of(int kind, int element)
{
    committed *found = NULL;
    int i;
    lock(&dampers_lock);
    for (i = 0; i < MOST_DAMPERS && !found; i++) {
        if (dampers[i].kind == 0) {
            memset(&dampers[i], 0, sizeof dampers[i]);
            dampers[i].element = element;
            dampers[i].kind = kind;
        }
        if (dampers[i].kind == kind && dampers[i].element == element)
            found = &dampers[i];
    }
    unlock(&dampers_lock);
    if (!found)
        message_stop(element, "more than %d dampers in one process", MOST_DAMPERS);
    return found;
}

/* Returns the difference below which two times count as equal, s. */
static double same_time(double t) { return 1e-12 * (1.0 + fabs(t)); }

static int refused(int element, int32_t status)
{
    if (status >= 0)
        return 0;
    message_stop(element, "force: %s", dashpot_status_text(status));
    return -1;
}

/* Returns the input at the fraction s of the interval from a state to a request: displacement and velocity by the cubic
 * Hermite polynomial through both ends, all else as requested. */
static dashpot_input between(const dashpot_state *from, const dashpot_input *to, double dt, double s)
{
    dashpot_input input = *to;
    double x0 = from->displacement, x1 = to->displacement, v0 = from->velocity * dt, v1 = to->velocity * dt;
    double a = 2 * (x0 - x1) + v0 + v1, b = 3 * (x1 - x0) - 2 * v0 - v1;
    if (s < 1.0) {
        input.displacement = ((a * s + b) * s + v0) * s + x0;
        input.velocity = ((3 * a * s + 2 * b) * s + v0) / dt;
    }
    return input;
}

/* Integrates the damper from a state over dt to a request. */
static int32_t advance(const damper_model *damper, const dashpot_state *from, const dashpot_input *to, double dt,
                       dashpot_state *state, dashpot_output *output)
{
    int n = (int)fmin(MOST_STEPS, ceil(dt / LONGEST_STEP)), i;
    int32_t status = 0;
    *state = *from;
    for (i = 1; i <= n && status >= 0; i++) {
        dashpot_input input = between(from, to, dt, (double)i / n);
        status = dashpot_step(&damper->model, state, &input, dt / n, state, output);
    }
    return status;
}

/* Computes the state of a damper in steady motion: internal states in equilibrium, the internal mass at the velocity of
 * the moving end. */
static int32_t steady(const damper_model *damper, const dashpot_input *input, dashpot_state *state,
                      dashpot_output *output)
{
    dashpot_state unused;
    int32_t status;
    if (input->known & DASHPOT_KNOWS_SETTING) {
        dashpot_input still = dashpot_input_motion(input->displacement, 0.0);
        still = dashpot_input_with_setting(still, input->setting);
        status = dashpot_state_init_motion(&damper->model, &still, state);
    } else {
        status = dashpot_state_init(&damper->model, input->displacement, state);
    }
    if (status < 0)
        return status;
    status = dashpot_step(&damper->model, state, input, 0.0, &unused, output);
    if (status < 0)
        return status;
    state->velocity = input->velocity;
    if (damper->used[0]) {
        state->mass_displacement = input->displacement - output->series_deflection;
        state->mass_velocity = input->velocity;
    }
    return status;
}

/* Computes the force at the committed time, for a requested motion that may differ from the committed one. */
static int32_t at_once(const damper_model *damper, const dashpot_state *from, const dashpot_input *input,
                       dashpot_state *state, dashpot_output *output)
{
    dashpot_state rate;
    *state = *from;
    state->displacement = input->displacement;
    state->velocity = input->velocity;
    return dashpot_evaluate(&damper->model, state, input, output, &rate);
}

/* Advances *d to the time that the solver has accepted. *d is unchanged on failure. */
static int32_t commit(const damper_model *damper, committed *d, double accepted)
{
    dashpot_state state;
    dashpot_output output;
    dashpot_input input = d->trial.input;
    double dt = d->trial.time - d->time, wanted = accepted - d->time;
    int32_t status;
    /* The accepted time may be before the last trial, or after it if the solver interpolates. */
    if (fabs(wanted - dt) > same_time(accepted)) {
        if (wanted < dt)
            input = between(&d->state, &d->trial.input, dt, wanted / dt);
        else
            input.displacement += input.velocity * (wanted - dt);
    }
    status = advance(damper, &d->state, &input, wanted, &state, &output);
    if (status >= 0) {
        d->state = state;
        d->time = accepted;
        d->is_start = 0;
        d->has_trial = 0;
    }
    return status;
}

/* Computes the output of one request from the committed state. */
static int32_t answer_from(const damper_model *damper, const committed *d, const request *asked, dashpot_state *state,
                           dashpot_output *output)
{
    double dt = asked->time - d->time;
    if (d->is_start && dt <= same_time(asked->time))
        return steady(damper, &asked->input, state, output);
    if (dt <= same_time(asked->time))
        return at_once(damper, &d->state, &asked->input, state, output);
    return advance(damper, &d->state, &asked->input, dt, state, output);
}

/* Steps of the central differences: displacement m, velocity m/s, side force N. */
static const double NUDGE[3] = {1e-8, 1e-6, 1e-3};

static double *nudged(dashpot_input *input, int i)
{
    return i == 0 ? &input->displacement : i == 1 ? &input->velocity : &input->side_force;
}

/* Computes the force of steady motion without dry friction. It depends on the motion alone, so that its derivatives are
 * stiffness and damping. */
static int32_t linear_force(const damper_model *damper, const dashpot_input *input, double *force)
{
    dashpot_state state;
    dashpot_output output;
    int32_t status = dashpot_state_init_motion(&damper->linear, input, &state);
    if (status >= 0)
        status = dashpot_step(&damper->linear, &state, input, 0.0, &state, &output);
    if (status >= 0)
        *force = output.force;
    return status;
}

/* Differentiates linear_force() by central differences. At a knee of the force curve they give the mean of both sides. */
static int32_t linear_partials(const damper_model *damper, const dashpot_input *input, force_answer *answer)
{
    double *by[3], f[2] = {0.0, 0.0};
    int i, k;
    by[0] = &answer->by_displacement;
    by[1] = &answer->by_velocity;
    by[2] = &answer->by_side_force;
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 2; k++) {
            dashpot_input other = *input;
            int32_t status;
            *nudged(&other, i) += k == 0 ? -NUDGE[i] : NUDGE[i];
            status = linear_force(damper, &other, &f[k]);
            if (status < 0)
                return status;
        }
        *by[i] = (f[1] - f[0]) / (2 * NUDGE[i]);
    }
    return 0;
}

/* Step of the central difference with respect to the setting, per (1 + |setting|). */
static const double SETTING_NUDGE = 1e-6;

static int32_t by_setting(const damper_model *damper, const committed *d, const request *asked, force_answer *answer)
{
    const double h = SETTING_NUDGE * (1.0 + fabs(asked->input.setting));
    double f[2];
    int k;
    for (k = 0; k < 2; k++) {
        request other = *asked;
        dashpot_state state;
        dashpot_output output;
        int32_t status;
        other.input.setting += k == 0 ? -h : h;
        status = answer_from(damper, d, &other, &state, &output);
        if (status < 0)
            return status;
        f[k] = output.force;
    }
    answer->by_setting = (f[1] - f[0]) / (2 * h);
    return 0;
}

/* Computes the partial derivatives of answer_from() by central differences of its inputs. */
static int32_t partials(const damper_model *damper, const committed *d, const request *asked, force_answer *answer)
{
    double by[3];
    int i, k;
    for (i = 0; i < 3; i++) {
        double f[2];
        for (k = 0; k < 2; k++) {
            request other = *asked;
            dashpot_state state;
            dashpot_output output;
            int32_t status;
            *nudged(&other.input, i) += k == 0 ? -NUDGE[i] : NUDGE[i];
            status = answer_from(damper, d, &other, &state, &output);
            if (status < 0)
                return status;
            f[k] = output.force;
        }
        by[i] = (f[1] - f[0]) / (2 * NUDGE[i]);
    }
    answer->by_displacement = by[0];
    answer->by_velocity = by[1];
    answer->by_side_force = by[2];
    return asked->input.known & DASHPOT_KNOWS_SETTING ? by_setting(damper, d, asked, answer) : 0;
}

int committed_force(int kind, int element, const damper_model *damper, const request *asked, double accepted,
                    int analysis, int is_difference, int with_partials, force_answer *answer)
{
    committed *stored = damper_of(kind, element);
    committed d;
    dashpot_state state;
    dashpot_output output;
    int32_t status = 0;
    int is_static = analysis == ANALYSIS_STATIC;
    if (!stored)
        return -1;
    d = *stored;
    if (analysis == ANALYSIS_LINEAR) {
        memset(answer, 0, sizeof *answer);
        status = linear_force(damper, &asked->input, &answer->force);
        if (d.has_output)
            answer->force += d.output.friction_force;
        if (status >= 0 && with_partials)
            status = linear_partials(damper, &asked->input, answer);
        return refused(element, status);
    }
    /* A run starts or restarts, or the solver goes back to a time before the committed state. */
    if (!d.is_set || is_static || accepted < d.time - same_time(accepted)) {
        status = steady(damper, &asked->input, &d.state, &output);
        d.time = accepted;
        d.is_set = 1;
        d.is_start = 1;
        d.has_trial = 0;
    } else if (accepted > d.time + same_time(accepted)) {
        if (d.has_trial) {
            status = commit(damper, &d, accepted);
        } else {
            /* The accepted time advanced without a call, for example because the element was deactivated. */
            status = steady(damper, &asked->input, &d.state, &output);
            d.time = accepted;
            d.is_start = 1;
        }
    }
    if (refused(element, status))
        return -1;
    /* Until the time advances, the solver may still move the markers, so the start state follows each request. */
    if (d.is_start && asked->time <= d.time + same_time(d.time))
        if (refused(element, steady(damper, &asked->input, &d.state, &output)))
            return -1;
    status = answer_from(damper, &d, asked, &state, &output);
    if (refused(element, status))
        return -1;
    memset(answer, 0, sizeof *answer);
    answer->force = output.force;
    if (with_partials && refused(element, partials(damper, &d, asked, answer)))
        return -1;
    if (!is_difference) {
        if (asked->time > d.time + same_time(d.time)) {
            d.trial = *asked;
            d.has_trial = 1;
        }
        d.output = output;
        d.output_state = state;
        d.has_output = 1;
        *stored = d;
    }
    return 0;
}

int committed_last(int kind, int element, dashpot_output *output, dashpot_state *state)
{
    int i;
    for (i = 0; i < MOST_DAMPERS && dampers[i].kind != 0; i++)
        if (dampers[i].kind == kind && dampers[i].element == element && dampers[i].has_output) {
            *output = dampers[i].output;
            *state = dampers[i].output_state;
            return 0;
        }
    return -1;
}

void committed_forget(int kind, int element)
{
    committed *d = damper_of(kind, element);
    if (d) {
        memset(d, 0, sizeof *d);
        d->kind = kind;
        d->element = element;
    }
}

void committed_save(int kind, int element)
{
    const solver_functions *s = solver();
    const char *lacks = solver_lacks(SOLVER_FOR_SAVING);
    const committed *d = damper_of(kind, element);
    int head[5];
    double numbers[STATE_NUMBERS + 8];
    if (lacks) {
        message_stop(element, "the solver has no function %s, which saving needs", lacks);
        return;
    }
    if (!d)
        return;
    head[0] = SAVED_FORMAT;
    head[1] = STATE_NUMBERS;
    head[2] = d->is_set;
    head[3] = d->is_start;
    head[4] = d->has_trial;
    memcpy(numbers, &d->state, sizeof d->state);
    numbers[STATE_NUMBERS] = d->time;
    numbers[STATE_NUMBERS + 1] = d->trial.time;
    numbers[STATE_NUMBERS + 2] = d->trial.input.displacement;
    numbers[STATE_NUMBERS + 3] = d->trial.input.velocity;
    numbers[STATE_NUMBERS + 4] = d->trial.input.side_force;
    numbers[STATE_NUMBERS + 5] = d->trial.input.temperature;
    numbers[STATE_NUMBERS + 6] = d->trial.input.known & DASHPOT_KNOWS_SETTING ? 1.0 : 0.0;
    numbers[STATE_NUMBERS + 7] = d->trial.input.setting;
    s->serialize_integers(head, 5);
    s->serialize_doubles(numbers, STATE_NUMBERS + 8);
}

void committed_reload(int kind, int element)
{
    const solver_functions *s = solver();
    const char *lacks = solver_lacks(SOLVER_FOR_SAVING);
    committed *d = damper_of(kind, element);
    int head[5] = {0, 0, 0, 0, 0};
    double numbers[STATE_NUMBERS + 8];
    if (lacks) {
        message_stop(element, "the solver has no function %s, which reloading needs", lacks);
        return;
    }
    if (!d)
        return;
    s->unserialize_integers(head, 5);
    if (head[0] != SAVED_FORMAT || head[1] != STATE_NUMBERS) {
        message_stop(element, "the saved state is of another version of this library; run again from the start");
        return;
    }
    s->unserialize_doubles(numbers, STATE_NUMBERS + 8);
    committed_forget(kind, element);
    memcpy(&d->state, numbers, sizeof d->state);
    d->is_set = head[2];
    d->is_start = head[3];
    d->has_trial = head[4];
    d->time = numbers[STATE_NUMBERS];
    d->trial.time = numbers[STATE_NUMBERS + 1];
    d->trial.input = dashpot_input_motion(numbers[STATE_NUMBERS + 2], numbers[STATE_NUMBERS + 3]);
    d->trial.input.side_force = numbers[STATE_NUMBERS + 4];
    d->trial.input.temperature = numbers[STATE_NUMBERS + 5];
    d->trial.input.known |= DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE;
    if (numbers[STATE_NUMBERS + 6] != 0.0)
        d->trial.input = dashpot_input_with_setting(d->trial.input, numbers[STATE_NUMBERS + 7]);
}
