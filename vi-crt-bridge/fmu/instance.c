#include "instance.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef char states_as_exported[STATES_OF_CORNER == EXPORTED_STATES ? 1 : -1];

static int complain(struct instance *instance, const char *format, ...)
{
    char text[400];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    instance->log(instance, 1, text);
    return -1;
}

/* ---- what the host has set ----------------------------------------------------------------------------------- */

double instance_given(const struct data *data, int corner, enum kind kind)
{
    return data->value[1 + corner * BLOCK + (kind - DISPLACEMENT)];
}

dashpot_input instance_input(const struct data *data, int corner)
{
    double scale = instance_given(data, corner, MOTION_SCALE);
    dashpot_input input = dashpot_input_velocity(scale * instance_given(data, corner, VELOCITY));

    if (instance_given(data, corner, DISPLACEMENT_GIVEN) != 0.0) {
        input.known |= DASHPOT_KNOWS_DISPLACEMENT;
        input.displacement = scale * instance_given(data, corner, DISPLACEMENT);
    }
    input.known |= DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE;
    input.side_force = instance_given(data, corner, SIDE_FORCE);
    input.temperature = instance_given(data, corner, TEMPERATURE);
    return input;
}

double *instance_state_number(dashpot_state *state, int index)
{
    /* displacement, then what follows the velocity. */
    return (double *)state + (index == 0 ? 0 : index + 1);
}

/* The models' own values of the parameters, and the start values of everything else. */
static void start_values(struct data *data)
{
    uint32_t i;

    for (i = 0; i < VARIABLES; i++) {
        const struct variable *v = &VARIABLE[i];
        const dashpot_params *params = v->corner < 0 ? NULL : &data->corner[v->corner].params;
        double list[256] = {0};
        uint32_t count;

        switch (v->kind) {
        case TEMPERATURE: data->value[i] = 20.0; break;
        case MOTION_SCALE: data->value[i] = MOTION_SCALE_START; break;
        case FORCE_SCALE: data->value[i] = FORCE_SCALE_START; break;
        case DISPLACEMENT_GIVEN: data->value[i] = 1.0; break;
        case CHOICE: dashpot_params_get(params, v->name, &data->value[i]); break;
        case PARAMETER:
            if (v->index < 0)
                dashpot_params_get(params, v->name, &data->value[i]);
            else if (dashpot_params_get_list(params, v->name, list, 256, &count) >= 0)
                data->value[i] = list[v->index];
            break;
        default: data->value[i] = 0.0;
        }
    }
}

/* Prepares the models with the parameters as set; leaves all as it was where they are refused. */
int instance_settle_parameters(struct instance *instance)
{
    struct data *data = &instance->data;
    dashpot_params params[CORNERS];
    dashpot_model model[CORNERS];
    uint32_t i, k;
    int c;

    if (!data->retune)
        return 0;
    for (c = 0; c < CORNERS; c++) {
        dashpot_fault fault;
        int32_t status;

        params[c] = data->corner[c].params;
        for (i = 0; i < VARIABLES; i++) {
            const struct variable *v = &VARIABLE[i];
            double list[256];

            status = 0;
            if (v->corner != c || (v->kind != PARAMETER && v->kind != CHOICE))
                continue;
            if (v->index < 0) {
                status = dashpot_params_set(&params[c], v->name, data->value[i]);
            } else if (v->index == 0) {
                for (k = 0; i + k < VARIABLES && k < 256 && VARIABLE[i + k].corner == c && VARIABLE[i + k].name &&
                            !strcmp(VARIABLE[i + k].name, v->name); k++)
                    list[k] = data->value[i + k];
                status = dashpot_params_set_list(&params[c], v->name, list, k);
            }
            if (status < 0)
                return complain(instance, "%s %s", v->name, dashpot_status_text(status));
        }
        status = dashpot_params_check(&params[c], &fault);
        if (status < 0)
            return complain(instance, "%s %s", fault.parameter, dashpot_status_text(status));
        status = dashpot_model_init(&model[c], &params[c]);
        if (status < 0)
            return complain(instance, "%s", dashpot_status_text(status));
    }
    for (c = 0; c < CORNERS; c++) {
        data->corner[c].params = params[c];
        data->corner[c].model = model[c];
    }
    data->retune = 0;
    data->stale = 1;
    return 0;
}

/* ---- life ------------------------------------------------------------------------------------------------------ */

static int load(struct instance *instance)
{
    int c;

    memset(&instance->data, 0, sizeof instance->data);
    for (c = 0; c < CORNERS; c++) {
        dashpot_fault fault;
        int32_t status =
            dashpot_corner_read(&instance->data.corner[c], MODEL_TEXT[c], strlen(MODEL_TEXT[c]), &fault);

        if (status < 0)
            return complain(instance, "the model inside: line %u: %s %s", (unsigned)fault.line, fault.parameter,
                            dashpot_status_text(status));
    }
    start_values(&instance->data);
    instance->data.stale = 1;
    return 0;
}

struct instance *instance_new(const char *name, const char *token, int exchange, int logging, instance_log *log,
                              void *logger, void *environment)
{
    struct instance *instance = calloc(1, sizeof *instance);

    if (!instance)
        return NULL;
    instance->exchange = exchange;
    instance->logging = logging;
    instance->log = log;
    instance->logger = logger;
    instance->environment = environment;
    snprintf(instance->name, sizeof instance->name, "%s", name ? name : "");
    if (!token || strcmp(token, MODEL_GUID)) {
        complain(instance, "the guid or instantiation token is not the one of this FMU");
    } else if (!load(instance)) {
        return instance;
    }
    free(instance);
    return NULL;
}

void instance_free(struct instance *instance)
{
    free(instance);
}

int instance_reset(struct instance *instance)
{
    return load(instance);
}

/* At rest at the position that the host gives. */
static int rest(struct instance *instance)
{
    struct data *data = &instance->data;
    int c;

    if (instance_settle_parameters(instance))
        return -1;
    for (c = 0; c < CORNERS; c++) {
        dashpot_input input = instance_input(data, c);
        double position =
            input.known & DASHPOT_KNOWS_DISPLACEMENT ? input.displacement : instance_given(data, c, INITIAL_POSITION);
        int32_t status = dashpot_corner_rest(&data->corner[c], position);

        if (status < 0)
            return complain(instance, "initial position: %s", dashpot_status_text(status));
        data->from[c] = data->corner[c].now.state;
        data->status[c] = 0;
    }
    data->dt = 0.0;
    return 0;
}

/* Brings outputs and rates up to date with inputs and states. */
static int refresh(struct instance *instance)
{
    struct data *data = &instance->data;
    int c;

    if (!data->stale)
        return 0;
    if (data->phase == INSTANTIATED || data->phase == TERMINATED)
        return 0;
    if (data->phase == INITIALIZATION && rest(instance))
        return -1;
    if (instance->exchange) {
        for (c = 0; c < CORNERS; c++) {
            dashpot_corner *corner = &data->corner[c];
            dashpot_input input = instance_input(data, c);
            int32_t status = dashpot_evaluate(&corner->model, &corner->now.state, &input, &corner->now.output,
                                              &data->rate[c]);

            if (status < 0)
                return complain(instance, "%s", dashpot_status_text(status));
            data->status[c] = status;
            data->rate[c].displacement = input.known & DASHPOT_KNOWS_DISPLACEMENT ? 0.0 : input.velocity;
        }
    }
    data->stale = 0;
    return 0;
}

int instance_enter_initialization(struct instance *instance, double start)
{
    if (instance->data.phase != INSTANTIATED)
        return complain(instance, "initialization mode is entered once, after instantiation or reset");
    instance->data.phase = INITIALIZATION;
    instance->data.value[0] = start;
    instance->data.stale = 1;
    return 0;
}

int instance_exit_initialization(struct instance *instance)
{
    if (instance->data.phase != INITIALIZATION)
        return complain(instance, "initialization mode was not entered");
    instance->data.stale = 1;
    if (refresh(instance))
        return -1;
    instance->data.phase = RUNNING;
    return 0;
}

/* ---- variables ------------------------------------------------------------------------------------------------- */

static enum type type_of(enum kind kind)
{
    return kind == STATUS || kind == CHOICE ? INTEGER : kind == DISPLACEMENT_GIVEN ? BOOLEAN : REAL;
}

static double read(struct data *data, const struct variable *v, double stored)
{
    const dashpot_output *output;
    double motion, force;

    if (v->corner < 0)
        return stored;
    output = &data->corner[v->corner].now.output;
    motion = instance_given(data, v->corner, MOTION_SCALE);
    force = instance_given(data, v->corner, FORCE_SCALE);
    switch (v->kind) {
    case FORCE: return force * output->force;
    case FORCE_BY_DISPLACEMENT: return force * output->force_by_displacement * motion;
    case FORCE_BY_VELOCITY: return force * output->force_by_velocity * motion;
    case STATUS: return data->status[v->corner];
    case STATE: return *instance_state_number(&data->corner[v->corner].now.state, v->index);
    case RATE: return *instance_state_number(&data->rate[v->corner], v->index);
    default: return stored;
    }
}

int instance_get(struct instance *instance, uint32_t reference, enum type type, double *value)
{
    if (reference >= VARIABLES || type_of(VARIABLE[reference].kind) != type)
        return complain(instance, "value reference %u is no variable of that type", (unsigned)reference);
    if (refresh(instance))
        return -1;
    *value = read(&instance->data, &VARIABLE[reference], instance->data.value[reference]);
    return 0;
}

int instance_set(struct instance *instance, uint32_t reference, enum type type, double value)
{
    struct data *data = &instance->data;

    if (reference >= VARIABLES || type_of(VARIABLE[reference].kind) != type)
        return complain(instance, "value reference %u is no variable of that type", (unsigned)reference);
    switch (VARIABLE[reference].kind) {
    case MOTION_SCALE:
    case FORCE_SCALE:
        if (!(isfinite(value) && value != 0.0))
            return complain(instance, "a scale must be finite and not 0");
        /* Fixed, like the next three. */
        /* fall through */
    case DISPLACEMENT_GIVEN:
    case INITIAL_POSITION:
    case CHOICE:
        if (data->phase > INITIALIZATION)
            return complain(instance, "value reference %u is fixed once the run has begun", (unsigned)reference);
        data->retune |= VARIABLE[reference].kind == CHOICE;
        break;
    case PARAMETER:
        data->retune = 1;
        break;
    case DISPLACEMENT:
    case VELOCITY:
    case SIDE_FORCE:
    case TEMPERATURE:
        break;
    default:
        return complain(instance, "value reference %u cannot be set", (unsigned)reference);
    }
    data->value[reference] = value;
    /* Between two steps of a co-simulation the outputs stay those of the last communication point. */
    data->stale |= instance->exchange || data->phase == INITIALIZATION;
    return 0;
}

/* ---- co-simulation --------------------------------------------------------------------------------------------- */

int instance_step(struct instance *instance, double time, double dt)
{
    struct data *data = &instance->data;
    int c, held = 0;

    if (data->phase != RUNNING)
        return complain(instance, "a step before the end of initialization or after terminate");
    if (!(dt >= 0.0 && dt <= 1e9))
        return complain(instance, "the communication step size must be finite and not negative");
    if (instance_settle_parameters(instance))
        return -1;
    for (c = 0; c < CORNERS; c++) {
        dashpot_input input = instance_input(data, c);

        data->from[c] = data->corner[c].now.state;
        data->status[c] = dashpot_corner_step(&data->corner[c], &input, dt);
        held |= data->status[c] & DASHPOT_BRIDGE_HELD;
    }
    data->dt = dt;
    data->value[0] = time + dt;
    data->stale = 0;
    return held != 0;
}

/* ---- model exchange -------------------------------------------------------------------------------------------- */

int instance_states(struct instance *instance, double *states)
{
    int c, k;

    if (refresh(instance))
        return -1;
    for (c = 0; c < CORNERS; c++)
        for (k = 0; k < STATES_OF_CORNER; k++)
            *states++ = *instance_state_number(&instance->data.corner[c].now.state, k);
    return 0;
}

int instance_set_states(struct instance *instance, const double *states)
{
    int c, k;

    for (k = 0; k < STATES; k++)
        if (!isfinite(states[k]))
            return complain(instance, "a state is not finite");
    for (c = 0; c < CORNERS; c++)
        for (k = 0; k < STATES_OF_CORNER; k++)
            *instance_state_number(&instance->data.corner[c].now.state, k) = *states++;
    instance->data.stale = 1;
    return 0;
}

int instance_rates(struct instance *instance, double *rates)
{
    int c, k;

    if (instance_settle_parameters(instance) || refresh(instance))
        return -1;
    for (c = 0; c < CORNERS; c++)
        for (k = 0; k < STATES_OF_CORNER; k++)
            *rates++ = *instance_state_number(&instance->data.rate[c], k);
    return 0;
}

/* ---- serialised state ------------------------------------------------------------------------------------------ */

static const char MAGIC[8] = "dashpot";
#define HEAD (sizeof MAGIC + sizeof MODEL_GUID)

size_t instance_bytes(void)
{
    return HEAD + sizeof(struct data);
}

void instance_serialize(const struct data *data, unsigned char *bytes)
{
    memcpy(bytes, MAGIC, sizeof MAGIC);
    memcpy(bytes + sizeof MAGIC, MODEL_GUID, sizeof MODEL_GUID);
    memcpy(bytes + HEAD, data, sizeof *data);
}

int instance_deserialize(struct instance *instance, struct data *data, const unsigned char *bytes, size_t size)
{
    if (size != instance_bytes() || memcmp(bytes, MAGIC, sizeof MAGIC) ||
        memcmp(bytes + sizeof MAGIC, MODEL_GUID, sizeof MODEL_GUID))
        return complain(instance, "the bytes are no state of this FMU");
    memcpy(data, bytes + HEAD, sizeof *data);
    return 0;
}
