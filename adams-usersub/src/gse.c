/* The damper as a GSE: the solver integrates its states. This file computes rates and outputs from inputs and states and
 * stores nothing between calls.
 *
 *     USER(string [, length unit, force unit, time unit])
 *
 * inputs  (array U)  displacement, velocity [, side force [, temperature in degrees Celsius [, setting in the unit of the
 *                    model file]]], model units, extension positive
 * states  (array X)  1 deflection: internal mass relative to moving end, model length
 *                    2 velocity of the internal mass, model units
 *                    3... internal states of the elements: SI value divided by the model's length unit in m, so that
 *                    the solver's error tolerance applies to lengths as it does to state 1
 * outputs (array Y)  1 force with the sign of an SFORCE: negative if the damper is in tension, as it is in rebound
 *                    2 series deflection  3 velocity of the internal mass
 *                    4 force of the primary damper  5 springs  6 friction  7 gas  8 stops, tension positive
 *                    9 oil temperature, degrees Celsius
 *
 * State 1 is relative to the moving end. Zero is therefore a suitable initial value at any damper length, and the
 * solver's error tolerance applies to the deflection that makes the force.
 *
 * In statics the rates relax the states toward the damper's equilibrium. The dynamic rates have no unique equilibrium,
 * because presliding friction depends on the past motion. */
#include "damper_model.h"
#include "entry.h"
#include "messages.h"

#include <math.h>
#include <string.h>

enum { FEWEST_INPUTS = 2, MAX_INPUTS = 5, MAX_OUTPUTS = 9, UNITS_AT = 1 };

/* Rate, 1/s, at which unused states decay to zero and, in statics, all states relax toward their equilibrium. */
static const double DECAY = 100.0;

typedef struct {
    const damper_model *damper;
    const dashpot_model *model; /* damper->model, or damper->linear in a LINEAR analysis */
    int ns, ni, no, is_static;
    dashpot_input input;
    dashpot_state state;
    double x[MAX_STATES]; /* the states in the solver's units */
} instant;

/* Returns the model units per SI unit of state i. */
static double state_scale(const unit_scales *u, int i)
{
    return i == 1 ? u->time / u->length : 1.0 / u->length;
}

/* Reads inputs and states from the solver. It calls the same solver functions for every iflag, because the solver
 * records them as dependencies. Returns 0, or -1 after a message. */
static int read_instant(const adams_gse *gse, int iflag, instant *now)
{
    const solver_functions *s = solver();
    const char *lacks = solver_lacks(SOLVER_FOR_GSE);
    const unit_scales *u;
    double x[MAX_STATES], in[MAX_INPUTS];
    int i, mode = 0;
    if (lacks) {
        message_stop(gse->id, "the solver has no function %s, which a GSE needs", lacks);
        return -1;
    }
    if (gse->npar != 1 && gse->npar != 4) {
        message_stop(gse->id, "USER has %d values; a GSE takes USER(string) or USER(string, length unit, force unit, time "
                              "unit)", gse->npar);
        return -1;
    }
    now->damper = damper_model_of(gse->id, gse->npar, gse->par, UNITS_AT, iflag == SOLVER_INITIALISE);
    if (!now->damper)
        return -1;
    now->ns = s->gse_ns();
    now->ni = s->gse_ni();
    now->no = s->gse_no();
    if (now->ns != now->damper->states) {
        message_stop(gse->id, "the GSE has NS=%d states; this model file needs NS=%d", now->ns, now->damper->states);
        return -1;
    }
    if (now->ni < FEWEST_INPUTS || now->ni > MAX_INPUTS) {
        message_stop(gse->id, "the GSE has NI=%d inputs; it takes displacement and velocity, then side force and "
                              "temperature and the setting if wanted: NI=2 to 5", now->ni);
        return -1;
    }
    if (now->no < 1 || now->no > MAX_OUTPUTS) {
        message_stop(gse->id, "the GSE has NO=%d outputs; it gives 1 to %d, the force first", now->no, MAX_OUTPUTS);
        return -1;
    }
    memset(x, 0, sizeof x);
    memset(in, 0, sizeof in);
    s->gse_x(x, now->ns);
    s->gse_u(in, now->ni);
    u = &now->damper->units;
    now->input = dashpot_input_motion(units_displacement(u, in[0]), units_velocity(u, in[1]));
    if (now->ni > 2) {
        now->input.known |= DASHPOT_KNOWS_SIDE_FORCE;
        now->input.side_force = units_force(u, in[2]);
    }
    if (now->ni > 3) {
        now->input.known |= DASHPOT_KNOWS_TEMPERATURE;
        now->input.temperature = in[3];
    }
    if (now->ni > 4)
        now->input = dashpot_input_with_setting(now->input, in[4]);
    memset(&now->state, 0, sizeof now->state);
    now->state.displacement = now->input.displacement;
    now->state.velocity = now->input.velocity;
    now->state.mass_displacement = now->input.displacement + units_displacement(u, x[0]);
    now->state.mass_velocity = units_velocity(u, x[1]);
    for (i = 2; i < now->ns; i++)
        now->state.internal[i - 2] = x[i] / state_scale(u, i);
    memcpy(now->x, x, sizeof now->x);
    s->getmod(&mode);
    /* LINEAR: the model without dry friction, which would lock the damper. It has the same states; those of friction have
     * no effect on the force. */
    now->model = mode == SOLVER_LINEAR ? &now->damper->linear : &now->damper->model;
    now->is_static = mode == SOLVER_STATICS || mode == SOLVER_QUASI_STATICS;
    if (now->is_static) {
        now->input.velocity = 0.0;
        now->state.velocity = 0.0;
    }
    return 0;
}

/* Returns the SI units per model unit of input i: 0 displacement, 1 velocity. */
static double input_scale(const unit_scales *u, int i) { return i == 0 ? u->length : u->length / u->time; }

static int wants_partials(void)
{
    const solver_functions *s = solver();
    int wanted = 0;
    if (s->needs_partials && s->gsepar_x && s->gsepar_u)
        s->needs_partials(&wanted);
    return wanted;
}

/* Computes the equilibrium of the states at a displacement, in the solver's units. */
static int32_t settled(const instant *now, double displacement, double x[MAX_STATES])
{
    const unit_scales *u = &now->damper->units;
    dashpot_state state;
    int i;
    int32_t status;
    if (now->input.known & DASHPOT_KNOWS_SETTING) {
        dashpot_input still = dashpot_input_motion(displacement, 0.0);
        still = dashpot_input_with_setting(still, now->input.setting);
        status = dashpot_state_init_motion(&now->damper->model, &still, &state);
    } else {
        status = dashpot_state_init(&now->damper->model, displacement, &state);
    }
    memset(x, 0, MAX_STATES * sizeof(double));
    if (status < 0)
        return status;
    for (i = 0; i < now->ns; i++)
        if (now->damper->used[i])
            x[i] = i == 1 ? 0.0
                          : state_scale(u, i) * (i == 0 ? state.mass_displacement - displacement : state.internal[i - 2]);
    return status;
}

/* Computes the rates in statics, and passes their partial derivatives to the solver if `with_partials`. */
static int32_t static_rates(const instant *now, double *rates, int with_partials)
{
    const unit_scales *u = &now->damper->units;
    double rest[MAX_STATES], low[MAX_STATES], high[MAX_STATES];
    double by_x[MAX_STATES * MAX_STATES], by_u[MAX_STATES * MAX_INPUTS];
    const double near = 1e-7; /* m */
    int i;
    int32_t status = settled(now, now->input.displacement, rest);
    if (status < 0)
        return status;
    for (i = 0; i < now->ns; i++)
        rates[i] = DECAY * u->time * (rest[i] - now->x[i]);
    if (!with_partials || settled(now, now->input.displacement - near, low) < 0 ||
        settled(now, now->input.displacement + near, high) < 0)
        return status;
    memset(by_x, 0, sizeof by_x);
    memset(by_u, 0, sizeof by_u);
    for (i = 0; i < now->ns; i++) {
        by_x[i + i * now->ns] = -DECAY * u->time;
        by_u[i] = DECAY * u->time * (high[i] - low[i]) / (2 * near) * input_scale(u, 0);
    }
    solver()->gsepar_x(by_x, now->ns * now->ns);
    solver()->gsepar_u(by_u, now->ns * now->ni);
    return status;
}

/* Passes the partial derivatives of the rates to the solver, stored by columns: d(rate i)/d(state j) at i + j ns. */
static void give_rate_partials(const instant *now, const dashpot_partials *p)
{
    const unit_scales *u = &now->damper->units;
    double by_x[MAX_STATES * MAX_STATES], by_u[MAX_STATES * MAX_INPUTS];
    int i, j;
    memset(by_x, 0, sizeof by_x);
    memset(by_u, 0, sizeof by_u);
    for (i = 0; i < now->ns; i++) {
        double to_model = state_scale(u, i) * u->time;
        if (!now->damper->used[i]) {
            by_x[i + i * now->ns] = -DECAY * u->time;
            continue;
        }
        for (j = 0; j < now->ns; j++)
            by_x[i + j * now->ns] = p->d_rate_d_state[i][j] * to_model / state_scale(u, j);
        /* The internal mass is at displacement + deflection, so it moves with the displacement. */
        by_u[i] = (p->d_rate_d_input[i][0] + p->d_rate_d_state[i][0]) * to_model * input_scale(u, 0);
        by_u[i + now->ns] = (p->d_rate_d_input[i][1] - (i == 0 ? 1.0 : 0.0)) * to_model * input_scale(u, 1);
    }
    /* Side force, temperature and setting: by central differences. */
    for (j = 2; j < now->ni; j++) {
        double *member;
        instant other = *now;
        dashpot_state low, high;
        dashpot_output unused;
        double h, scale = j == 2 ? u->force : 1.0;
        member = j == 2 ? &other.input.side_force : j == 3 ? &other.input.temperature : &other.input.setting;
        h = 1e-4 * (1.0 + fabs(*member));
        *member -= h;
        if (dashpot_evaluate(now->model, &now->state, &other.input, &unused, &low) < 0)
            return;
        *member += 2 * h;
        if (dashpot_evaluate(now->model, &now->state, &other.input, &unused, &high) < 0)
            return;
        for (i = 0; i < now->ns; i++) {
            double a = i == 0 ? low.mass_displacement : i == 1 ? low.mass_velocity : low.internal[i - 2];
            double b = i == 0 ? high.mass_displacement : i == 1 ? high.mass_velocity : high.internal[i - 2];
            by_u[i + j * now->ns] = now->damper->used[i] ? (b - a) / (2 * h) * state_scale(u, i) * u->time * scale : 0.0;
        }
    }
    solver()->gsepar_x(by_x, now->ns * now->ns);
    solver()->gsepar_u(by_u, now->ns * now->ni);
}

void Dashpot_gse_deriv(const adams_gse *gse, double time, int dflag, int iflag, int n, double *rates)
{
    instant now;
    dashpot_output output;
    dashpot_state rate;
    dashpot_partials partials;
    const unit_scales *u;
    int32_t status;
    int i;
    (void)time;
    (void)dflag;
    for (i = 0; i < n; i++)
        rates[i] = 0.0;
    if (iflag != SOLVER_EVALUATE && iflag != SOLVER_INITIALISE && iflag != SOLVER_DEPENDENCIES)
        return;
    if (read_instant(gse, iflag, &now) || n != now.ns)
        return;
    if (iflag == SOLVER_INITIALISE && solver()->declare_threadsafe)
        solver()->declare_threadsafe();
    if (iflag != SOLVER_EVALUATE)
        return;
    status = now.is_static ? static_rates(&now, rates, wants_partials())
                           : dashpot_evaluate(now.model, &now.state, &now.input, &output, &rate);
    if (status < 0) {
        message_stop(gse->id, "rates: %s", dashpot_status_text(status));
        return;
    }
    if (now.is_static)
        return;
    u = &now.damper->units;
    for (i = 0; i < n; i++) {
        double si = i == 0   ? rate.mass_displacement - now.input.velocity
                    : i == 1 ? rate.mass_velocity
                             : rate.internal[i - 2];
        rates[i] = now.damper->used[i] ? si * state_scale(u, i) * u->time : -DECAY * u->time * now.x[i];
    }
    if (wants_partials() && dashpot_jacobian(now.model, &now.state, &now.input, &partials) >= 0)
        give_rate_partials(&now, &partials);
}

static void outputs_of(const instant *now, const dashpot_output *o, double y[MAX_OUTPUTS])
{
    const unit_scales *u = &now->damper->units;
    y[0] = units_sforce(u, o->force);
    y[1] = o->series_deflection / u->length;
    y[2] = now->state.mass_velocity * u->time / u->length;
    y[3] = o->primary_force / u->force;
    y[4] = o->spring_force / u->force;
    y[5] = o->friction_force / u->force;
    y[6] = o->gas_force / u->force;
    y[7] = o->stop_force / u->force;
    y[8] = o->oil_temperature;
}

/* Changes one state or one input by `by`, in model units; an index of -1 changes none. */
static void nudge(instant *now, int state, int input, double by)
{
    const unit_scales *u = &now->damper->units;
    if (state == 0)
        now->state.mass_displacement += by * u->length;
    else if (state == 1)
        now->state.mass_velocity += by * u->length / u->time;
    else if (state > 1)
        now->state.internal[state - 2] += by * u->length;
    if (input == 0) {
        now->input.displacement += by * u->length;
        now->state.displacement += by * u->length;
        now->state.mass_displacement += by * u->length;
    } else if (input == 1) {
        now->input.velocity += by * u->length / u->time;
    } else if (input == 2) {
        now->input.side_force += by * u->force;
    } else if (input == 3) {
        now->input.temperature += by;
    } else if (input == 4) {
        now->input.setting += by;
    }
}

/* Computes one column of the partial derivatives of the outputs. The force uses the kernel's derivatives where it has
 * them; all else uses central differences. */
static void output_column(const instant *now, const dashpot_partials *p, int state, int input, double *column)
{
    const unit_scales *u = &now->damper->units;
    double h = state > 1 ? 1e-6 / u->length : input == 2 ? 1e-3 / u->force : input >= 3 ? 1e-3 : 1e-8 / u->length;
    double low[MAX_OUTPUTS], high[MAX_OUTPUTS];
    dashpot_output output;
    dashpot_state rate;
    int i;
    instant other = *now;
    nudge(&other, state, input, -h);
    if (dashpot_evaluate(now->model, &other.state, &other.input, &output, &rate) < 0)
        return;
    outputs_of(&other, &output, low);
    other = *now;
    nudge(&other, state, input, h);
    if (dashpot_evaluate(now->model, &other.state, &other.input, &output, &rate) < 0)
        return;
    outputs_of(&other, &output, high);
    for (i = 0; i < now->no; i++)
        column[i] = (high[i] - low[i]) / (2 * h);
    if (state >= 0)
        column[0] = units_sforce(u, p->d_force_d_state[state]) / state_scale(u, state);
    else if (input == 0)
        column[0] = units_sforce(u, p->d_force_d_input[0] + p->d_force_d_state[0]) * input_scale(u, 0);
    else if (input == 1)
        column[0] = units_sforce(u, p->d_force_d_input[1]) * input_scale(u, 1);
}

void Dashpot_gse_output(const adams_gse *gse, double time, int dflag, int iflag, int n, double *outputs)
{
    instant now;
    dashpot_output output;
    dashpot_state rate;
    dashpot_partials partials;
    double y[MAX_OUTPUTS];
    int32_t status;
    int i;
    (void)time;
    (void)dflag;
    for (i = 0; i < n; i++)
        outputs[i] = 0.0;
    if (iflag != SOLVER_EVALUATE && iflag != SOLVER_INITIALISE && iflag != SOLVER_DEPENDENCIES)
        return;
    if (read_instant(gse, iflag, &now) || n != now.no)
        return;
    if (iflag == SOLVER_INITIALISE && solver()->declare_threadsafe)
        solver()->declare_threadsafe();
    if (iflag != SOLVER_EVALUATE)
        return;
    status = dashpot_evaluate(now.model, &now.state, &now.input, &output, &rate);
    if (status < 0) {
        message_stop(gse->id, "force: %s", dashpot_status_text(status));
        return;
    }
    outputs_of(&now, &output, y);
    memcpy(outputs, y, (size_t)n * sizeof(double));
    if (wants_partials() && dashpot_jacobian(now.model, &now.state, &now.input, &partials) >= 0) {
        double by_x[MAX_OUTPUTS * MAX_STATES], by_u[MAX_OUTPUTS * MAX_INPUTS];
        memset(by_x, 0, sizeof by_x);
        memset(by_u, 0, sizeof by_u);
        for (i = 0; i < now.ns; i++)
            output_column(&now, &partials, i, -1, by_x + i * now.no);
        for (i = 0; i < now.ni; i++)
            if (!(now.is_static && i == 1))
                output_column(&now, &partials, -1, i, by_u + i * now.no);
        solver()->gsepar_x(by_x, now.no * now.ns);
        solver()->gsepar_u(by_u, now.no * now.ni);
    }
}

/* Returns zeros: the damper has no discrete states, but the solver may call this function. */
void Dashpot_gse_update(const adams_gse *gse, double time, int dflag, int iflag, int n, double *states)
{
    int i;
    (void)gse;
    (void)time;
    (void)dflag;
    (void)iflag;
    for (i = 0; i < n; i++)
        states[i] = 0.0;
}

/* Returns a sampling interval longer than any run, because there are no discrete states to sample. */
void Dashpot_gse_samp(const adams_gse *gse, double time, int iflag, double *interval)
{
    (void)gse;
    (void)time;
    (void)iflag;
    *interval = 1e9;
}
