#include "instance.h"
#include "evaluate.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sets the parameters to the values of the models, and all other variables to their start values. */
static void start_values(struct instance *instance)
{
    const struct contents *contents = instance->contents;
    double *value = instance_values(instance->data);
    uint32_t i;

    for (i = 0; i < contents->variables; i++) {
        const struct variable *v = &contents->variable[i];
        const dashpot_params *params = v->corner < 0 ? NULL : &instance->data->part[v->corner].corner.params;
        double list[LONGEST_LIST] = {0};
        uint32_t count;

        value[i] = 0.0;
        switch (v->kind) {
        case TEMPERATURE: value[i] = 20.0; break;
        case SETTING: {
            dashpot_setting setting;

            setting.struct_size = (uint32_t)sizeof setting;
            if (dashpot_params_setting(params, &setting) >= 0)
                value[i] = setting.start;
            break;
        }
        case MOTION_SCALE: value[i] = contents->motion_scale; break;
        case FORCE_SCALE: value[i] = contents->force_scale; break;
        case POSITION_OFFSET: value[i] = contents->position_offset; break;
        case DISPLACEMENT: value[i] = contents->displacement; break;
        case HAS_DISPLACEMENT: value[i] = 1.0; break;
        case BETWEEN_POINTS: value[i] = contents->between_points; break;
        case CHOICE: dashpot_params_get(params, v->name, &value[i]); break;
        case PARAMETER:
            if (v->index < 0)
                dashpot_params_get(params, v->name, &value[i]);
            else if (dashpot_params_get_list(params, v->name, list, LONGEST_LIST, &count) >= 0)
                value[i] = list[v->index];
            break;
        default: break;
        }
    }
}

/* Sets the velocity range of the identified curve, outside which the kernel gives its warning. Equal ends: no range. */
static void find_range(struct part *part)
{
    double speed[256], form = 1.0;
    uint32_t on = 0, count = 0;

    part->low = part->high = 0.0;
    dashpot_params_is_on(&part->corner.params, "fv_curve", &on);
    dashpot_params_get(&part->corner.params, "fv_form", &form);
    if (on && form == 0.0 && dashpot_params_get_list(&part->corner.params, "fv_velocity", speed, 256, &count) >= 0 && count) {
        part->low = speed[0];
        part->high = speed[count - 1];
    }
}

/* Writes the first two adjacent values of a list that are out of order: " (fv_force[3] = 5000, fv_force[4] = 400)". A host
 * shows single numbers, not lists. If `status` is no error in the order of a list, the text is empty. */
static void neighbours(struct instance *instance, int c, const char *name, int32_t status, char *text, size_t room)
{
    const struct contents *contents = instance->contents;
    const double *value = instance_values(instance->data);
    uint32_t i;

    text[0] = 0;
    if (status != DASHPOT_FORCE_DECREASES && status != DASHPOT_NOT_INCREASING)
        return;
    for (i = 0; i + 1 < contents->variables; i++) {
        const struct variable *v = &contents->variable[i];

        if (v->kind == PARAMETER && v->corner == c && v->index >= 0 && !strcmp(v->name, name) && v[1].index == v->index + 1 &&
            (value[i + 1] < value[i] || (status == DASHPOT_NOT_INCREASING && value[i + 1] == value[i]))) {
            snprintf(text, room, " (%s[%d] = %g, %s[%d] = %g)", name, v->index + 1, value[i], name, v->index + 2, value[i + 1]);
            return;
        }
    }
}

/* Reports that the parameters do not fit together: the parameter, the reason, and the remedy. Returns -1. */
static int unfit(struct instance *instance, int c, const char *name, int32_t status)
{
    static const char *const corner[MAX_CORNERS] = {"L1.", "R1.", "L2.", "R2."};
    char where[160];

    neighbours(instance, c, name, status, where, sizeof where);
    return instance_complain(instance,
                             "%s%s %s%s. The parameters as they are set do not fit together, and nothing moves until they do; set numbers "
                             "that fit and go on",
                             instance->data->corners > 1 ? corner[c] : "", name, dashpot_status_text(status), where);
}

/* Prepares the model of corner c with the parameters that the host has set. Returns 0, or -1 after a message. */
static int prepare(struct instance *instance, int c, dashpot_params *params, dashpot_model *model)
{
    const struct contents *contents = instance->contents;
    const double *value = instance_values(instance->data);
    dashpot_fault fault;
    uint32_t i, k;
    int32_t status;

    for (i = 0; i < contents->variables; i++) {
        const struct variable *v = &contents->variable[i];
        double list[LONGEST_LIST];

        status = 0;
        if (v->corner != c || (v->kind != PARAMETER && v->kind != CHOICE))
            continue;
        if (v->index < 0) {
            status = dashpot_params_set(params, v->name, value[i]);
        } else if (v->index == 0) {
            for (k = 0; i + k < contents->variables && k < LONGEST_LIST && v[k].corner == c && v[k].kind == v->kind &&
                        !strcmp(v[k].name, v->name); k++)
                list[k] = value[i + k];
            status = dashpot_params_set_list(params, v->name, list, k);
        }
        if (status < 0)
            return unfit(instance, c, v->name, status);
    }
    status = dashpot_params_check(params, &fault);
    if (status < 0)
        return unfit(instance, c, fault.parameter, status);
    status = dashpot_model_init(model, params);
    return status < 0 ? unfit(instance, c, "", status) : 0;
}

/* Prepares the models with the parameters that the host has set. If these are rejected, it returns -1 and changes nothing. A
 * host sets parameters one by one, so that they may be inconsistent in between. The check is therefore made here, before
 * any evaluation, and repeated until the parameters are consistent. */
int instance_settle_parameters(struct instance *instance)
{
    struct data *data = instance->data;
    struct prepared {
        dashpot_params params;
        dashpot_model model;
    } *all;
    int c, failed = 0;

    if (!data->retune)
        return 0;
    all = malloc((size_t)data->corners * sizeof *all);
    if (!all)
        return instance_complain(instance, "no memory");
    for (c = 0; c < data->corners && !failed; c++) {
        all[c].params = data->part[c].corner.params;
        failed = prepare(instance, c, &all[c].params, &all[c].model);
    }
    for (c = 0; c < data->corners && !failed; c++) {
        data->part[c].corner.params = all[c].params;
        data->part[c].corner.model = all[c].model;
        find_range(&data->part[c]);
    }
    free(all);
    if (failed)
        return -1;
    data->retune = 0;
    data->stale = 1;
    return 0;
}

/* ---- life ------------------------------------------------------------------------------------------------------ */

size_t instance_data_bytes(const struct instance *instance)
{
    const struct contents *contents = instance->contents;

    return sizeof(struct data) + (size_t)contents->corners * sizeof(struct part) + contents->variables * sizeof(double);
}

static int load(struct instance *instance)
{
    int c;

    memset(instance->data, 0, instance_data_bytes(instance));
    instance->data->corners = instance->contents->corners;
    for (c = 0; c < instance->data->corners; c++) {
        struct part *part = &instance->data->part[c];
        const char *text = instance->contents->model[c];
        dashpot_fault fault;
        int32_t status = dashpot_corner_read(&part->corner, text, strlen(text), &fault);

        if (status < 0)
            return instance_complain(instance, "the model inside: line %u: %s %s", (unsigned)fault.line, fault.parameter,
                                     dashpot_status_text(status));
        find_range(part);
        part->setting = instance->contents->setting[c];
        instance_input_forget(&part->told);
    }
    start_values(instance);
    instance->data->stale = 1;
    return 0;
}

struct instance *instance_new(const char *name, const char *token, const char *resources, int exchange, int logging,
                              instance_log *log, void *logger, void *environment)
{
    struct instance *instance = calloc(1, sizeof *instance);
    char why[300] = "no memory";

    if (!instance)
        return NULL;
    instance->exchange = exchange;
    instance->logging = logging;
    instance->log = log;
    instance->logger = logger;
    instance->environment = environment;
    snprintf(instance->name, sizeof instance->name, "%s", name ? name : "");
    instance->contents = contents_read(resources, why, sizeof why);
    /* malloc() aligns its blocks sufficiently for the kernel's structures on every 64-bit system. */
    instance->data = instance->contents ? malloc(instance_data_bytes(instance)) : NULL;
    if (!instance->data)
        instance_complain(instance, "%s", why);
    else if (!token || strcmp(token, instance->contents->guid))
        instance_complain(instance, "the guid or instantiation token is not the one of this FMU");
    else if (!load(instance))
        return instance;
    instance_free(instance);
    return NULL;
}

void instance_free(struct instance *instance)
{
    if (!instance)
        return;
    contents_free(instance->contents);
    free(instance->data);
    free(instance);
}

int instance_reset(struct instance *instance)
{
    return load(instance);
}

/* Puts every corner into the steady state of its inputs: at rest, or in steady motion. */
static int begin(struct instance *instance)
{
    struct data *data = instance->data;
    int c, k;

    if (instance_settle_parameters(instance))
        return -1;
    for (c = 0; c < data->corners; c++) {
        struct part *part = &data->part[c];
        dashpot_state *state = &part->corner.now.state;
        dashpot_input input = instance_input(data, c);
        double position =
            input.known & DASHPOT_KNOWS_DISPLACEMENT ? input.displacement : instance_given(data, c, INITIAL_POSITION);
        int32_t status;

        input.known |= DASHPOT_KNOWS_DISPLACEMENT;
        input.displacement = position;
        status = dashpot_corner_begin(&part->corner, &input);
        if (status < 0)
            return instance_complain(instance, "the inputs at the start: %s", dashpot_status_text(status));
        part->from = *state;
        part->status = 0;
        part->state[TRAVEL] = position;
        part->state[DEFLECTION] = state->mass_displacement - state->displacement;
        part->state[MASS_VELOCITY] = state->mass_velocity;
        for (k = FIRST_INTERNAL; k < STATES_OF_CORNER; k++)
            part->state[k] = state->internal[k - FIRST_INTERNAL];
    }
    data->dt = 0.0;
    return 0;
}

int instance_refresh(struct instance *instance)
{
    struct data *data = instance->data;
    int c;

    if (!data->stale || data->phase == INSTANTIATED || data->phase == TERMINATED)
        return 0;
    if (data->phase == INITIALIZATION && begin(instance))
        return -1;
    for (c = 0; instance->exchange && c < data->corners; c++)
        if (instance_evaluate(instance, c))
            return -1;
    data->stale = 0;
    return 0;
}

int instance_enter_initialization(struct instance *instance, double start)
{
    if (instance->data->phase != INSTANTIATED)
        return instance_complain(instance, "initialization mode is entered once, after instantiation or reset");
    if (!isfinite(start))
        return instance_complain(instance, "the start time is not finite");
    instance->data->phase = INITIALIZATION;
    instance_values(instance->data)[0] = start;
    instance->data->stale = 1;
    return 0;
}

int instance_exit_initialization(struct instance *instance)
{
    if (instance->data->phase != INITIALIZATION)
        return instance_complain(instance, "initialization mode was not entered");
    instance->data->stale = 1;
    if (instance_refresh(instance))
        return -1;
    instance->data->phase = instance->exchange ? EVENT : RUNNING;
    return 0;
}

int instance_terminate(struct instance *instance)
{
    enum phase phase = instance->data->phase;

    if (phase != RUNNING && phase != EVENT)
        return instance_complain(instance, phase == TERMINATED ? "terminated twice"
                                                               : "there is nothing to terminate before the initialization mode "
                                                                 "has ended");
    instance->data->phase = TERMINATED;
    return 0;
}

/* ---- variables ------------------------------------------------------------------------------------------------- */

static enum type type_of(enum kind kind)
{
    return kind == STATUS || kind == CHOICE || kind == BETWEEN_POINTS ? INTEGER
           : kind == HAS_DISPLACEMENT                                 ? BOOLEAN
                                                                      : REAL;
}

static double state_of_step(const dashpot_state *state, int index)
{
    switch (index) {
    case TRAVEL: return state->displacement;
    case DEFLECTION: return state->mass_displacement - state->displacement;
    case MASS_VELOCITY: return state->mass_velocity;
    default: return state->internal[index - FIRST_INTERNAL];
    }
}

/* Replaces fmin(), which needs the math library: an importer that compiles these sources may not link it. */
static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double read(struct instance *instance, const struct variable *v, double stored)
{
    struct data *data = instance->data;
    const struct part *part;
    const dashpot_output *output;
    double motion, force, v_now;

    if (v->corner < 0)
        return stored;
    part = &data->part[v->corner];
    output = &part->corner.now.output;
    motion = instance_given(data, v->corner, MOTION_SCALE);
    force = instance_given(data, v->corner, FORCE_SCALE);
    switch (v->kind) {
    case FORCE: return force * output->force;
    case D_FORCE_D_DISPLACEMENT: return force * output->d_force_d_displacement * motion;
    case D_FORCE_D_VELOCITY: return force * output->d_force_d_velocity * motion;
    case STATUS: return part->status;
    case SPEED_MARGIN:
        v_now = part->corner.now.state.velocity;
        return part->low == part->high ? 1.0 : smaller(v_now - part->low, part->high - v_now);
    case STATE: return instance->exchange ? part->state[v->index] : state_of_step(&part->corner.now.state, v->index);
    case RATE: return part->rate[v->index];
    default: return stored;
    }
}

/* Returns 1 if read() computes the variable instead of returning the stored value. */
static int is_calculated(enum kind kind)
{
    return (kind >= FORCE && kind <= STATUS) || kind == SPEED_MARGIN || kind == STATE || kind == RATE;
}

static const struct variable *variable(struct instance *instance, uint32_t reference, enum type type)
{
    if (reference < instance->contents->variables && type_of(instance->contents->variable[reference].kind) == type)
        return &instance->contents->variable[reference];
    instance_complain(instance, "value reference %u is no variable of that type", (unsigned)reference);
    return NULL;
}

int instance_get(struct instance *instance, uint32_t reference, enum type type, double *value)
{
    const struct variable *v = variable(instance, reference, type);

    /* Only computed values need a valid evaluation; a stored value can be read even if parameters are inconsistent. */
    if (!v || (is_calculated(v->kind) && instance_refresh(instance)))
        return -1;
    *value = read(instance, v, instance_values(instance->data)[reference]);
    return 0;
}

int instance_set(struct instance *instance, uint32_t reference, enum type type, double value)
{
    struct data *data = instance->data;
    const struct variable *v = variable(instance, reference, type);

    if (!v)
        return -1;
    if (data->phase == TERMINATED)
        return instance_complain(instance, "the instance is terminated; reset it first");
    switch (v->kind) {
    case BETWEEN_POINTS:
        if (value < AUTOMATIC || value > EXTRAPOLATE)
            return instance_complain(instance, "inputs_between_points is 0 (automatic), 1 (hold) or 2 (extrapolate)");
        goto fixed;
    case MOTION_SCALE:
    case FORCE_SCALE:
        if (!(isfinite(value) && value != 0.0))
            return instance_complain(instance, "a scale must be finite and not 0");
        goto fixed;
    case POSITION_OFFSET:
        /* One meter is longer than any damper's stroke, so a larger number is probably in mm. */
        if (!(fabs(value) <= 1.0))
            return instance_complain(instance, "position_offset is in m and lies between -1 and 1");
        goto fixed;
    case HAS_DISPLACEMENT:
    case INITIAL_POSITION:
    case CHOICE:
    fixed:
        if (data->phase > INITIALIZATION)
            return instance_complain(instance, "value reference %u is fixed once the run has begun", (unsigned)reference);
        data->retune |= v->kind == CHOICE;
        break;
    case PARAMETER:
        if (!(value >= v->low && value <= v->high))
            return instance_complain(instance, "%s: %g is outside its bounds, %g to %g", v->name, value, v->low, v->high);
        data->retune = 1;
        break;
    case DISPLACEMENT:
    case VELOCITY:
        instance_input_set(instance, v->corner);
        break;
    case SIDE_FORCE:
    case TEMPERATURE:
        break;
    case SETTING:
        data->part[v->corner].derivatives &= ~(1u << OF_SETTING);
        break;
    default:
        return instance_complain(instance, "value reference %u cannot be set", (unsigned)reference);
    }
    if (v->kind >= DISPLACEMENT && v->kind <= TEMPERATURE)
        data->part[v->corner].derivatives &= ~(1u << (v->kind - DISPLACEMENT));
    instance_values(data)[reference] = value;
    /* In co-simulation the outputs remain those of the last communication point until the next step. */
    data->stale |= instance->exchange || data->phase == INITIALIZATION;
    return 0;
}

/* ---- serialized state ------------------------------------------------------------------------------------------ */

static const char MAGIC[8] = "dashpot";
#define SUM (sizeof MAGIC + sizeof((struct contents *)0)->guid)
#define HEAD (SUM + sizeof(uint64_t))

/* Returns the FNV-1a checksum. A damaged state is rejected, because it contains counts and choices that the kernel does
 * not check again. */
static uint64_t sum_of(const unsigned char *bytes, size_t size)
{
    uint64_t sum = 0xcbf29ce484222325u;
    size_t i;

    for (i = 0; i < size; i++)
        sum = (sum ^ bytes[i]) * 0x100000001b3u;
    return sum;
}

size_t instance_bytes(const struct instance *instance)
{
    return HEAD + instance_data_bytes(instance);
}

void instance_serialize(const struct instance *instance, const struct data *data, unsigned char *bytes)
{
    uint64_t sum;

    memcpy(bytes, MAGIC, sizeof MAGIC);
    memcpy(bytes + sizeof MAGIC, instance->contents->guid, sizeof instance->contents->guid);
    memcpy(bytes + HEAD, data, instance_data_bytes(instance));
    sum = sum_of(bytes + HEAD, instance_data_bytes(instance));
    memcpy(bytes + SUM, &sum, sizeof sum);
}

int instance_deserialize(struct instance *instance, struct data *data, const unsigned char *bytes, size_t size)
{
    uint64_t sum;

    if (size != instance_bytes(instance) || memcmp(bytes, MAGIC, sizeof MAGIC) ||
        memcmp(bytes + sizeof MAGIC, instance->contents->guid, sizeof instance->contents->guid))
        return instance_complain(instance, "the bytes are no state of this FMU");
    memcpy(&sum, bytes + SUM, sizeof sum);
    if (sum != sum_of(bytes + HEAD, size - HEAD))
        return instance_complain(instance, "the bytes are a damaged state");
    memcpy(data, bytes + HEAD, instance_data_bytes(instance));
    return 0;
}
