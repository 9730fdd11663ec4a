#include "damper_model.h"
#include "lock.h"
#include "messages.h"
#include "solver.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_MODELS = 64, LONGEST_PATH = 4096, LONGEST_FILE = 1 << 20 };

typedef struct {
    int used, element, string;
    damper_model damper;
} known_model;

/* One entry per element, because each element may give its own units. */
static known_model models[4 * MOST_MODELS];
static volatile long models_lock;

static int fail_at(int element, const char *path, const dashpot_fault *fault, int32_t status)
{
    if (fault->line)
        message_stop(element, "%s, line %u: %s %s", path, (unsigned)fault->line, fault->parameter,
                     dashpot_status_text(status));
    else
        message_stop(element, "%s: %s %s", path, fault->parameter, dashpot_status_text(status));
    return -1;
}

static int path_of(int element, int string, char *path)
{
    int length = 0, status = 0;
    memset(path, 0, LONGEST_PATH);
    solver()->gtstrg(string, path, &length, &status);
    if (status != 0 || length <= 0 || length >= LONGEST_PATH) {
        message_stop(element, "there is no STRING/%d; the first USER value must be the id of a STRING with the path of "
                              "the model file", string);
        return -1;
    }
    /* The solver may pad the text with blanks, as Fortran does. */
    path[length] = 0;
    while (length > 0 && (path[length - 1] == ' ' || path[length - 1] == '\t'))
        path[--length] = 0;
    if (strncmp(path, "mdids://", 8) == 0) {
        message_stop(element, "STRING/%d is %s; Adams Car database paths are not resolved here, write the path of the "
                              "file itself", string, path);
        return -1;
    }
    return 0;
}

/* Parameters that scale the dry friction. At 0 the friction elements keep their states but give no force. */
static const char *const DRY_FRICTION[] = {"coulomb_force", "stribeck_breakaway_force", "stribeck_coulomb_force", "presliding_force",
                                           "side_force_coefficient"};

static int32_t without_friction(dashpot_params *params, dashpot_model *model)
{
    size_t i;
    for (i = 0; i < sizeof DRY_FRICTION / sizeof DRY_FRICTION[0]; i++) {
        int32_t status = dashpot_params_set(params, DRY_FRICTION[i], 0.0);
        if (status < 0)
            return status;
    }
    return dashpot_model_init(model, params);
}

static int read_model(int element, int string, damper_model *damper)
{
    static dashpot_params params; /* under models_lock */
    char path[LONGEST_PATH];
    char *text;
    dashpot_fault fault;
    size_t length;
    int32_t status;
    FILE *file;

    if (path_of(element, string, path))
        return -1;
    file = fopen(path, "rb");
    if (!file) {
        message_stop(element, "cannot open the model file %s of STRING/%d; a path without folder is looked for where the "
                              "solver runs", path, string);
        return -1;
    }
    text = (char *)malloc(LONGEST_FILE);
    if (!text) {
        fclose(file);
        message_stop(element, "no memory for the model file %s", path);
        return -1;
    }
    length = fread(text, 1, LONGEST_FILE, file);
    if (ferror(file) || length == LONGEST_FILE) {
        message_stop(element, "%s cannot be read, or is longer than a model file can be", path);
        fclose(file);
        free(text);
        return -1;
    }
    fclose(file);
    memset(&fault, 0, sizeof fault);
    params.struct_size = sizeof params;
    params.abi_version = DASHPOT_ABI_VERSION;
    status = dashpot_params_read(&params, text, length, &fault);
    free(text);
    if (status < 0)
        return fail_at(element, path, &fault, status);
    status = dashpot_params_check(&params, &fault);
    if (status < 0)
        return fail_at(element, path, &fault, status);
    status = dashpot_model_init(&damper->model, &params);
    if (status < 0)
        return fail_at(element, path, &fault, status);
    status = without_friction(&params, &damper->linear);
    if (status < 0)
        return fail_at(element, path, &fault, status);
    damper_model_find_states(damper);
    message_info(element, "model file %s, %d states; 1 length unit is %g m, 1 force unit %g N, 1 time unit %g s", path,
                 damper->states, damper->units.length, damper->units.force, damper->units.time);
    return 0;
}

void damper_model_find_states(damper_model *damper)
{
    dashpot_state state;
    dashpot_partials partials;
    const dashpot_input input = dashpot_input_motion(0.003, 0.02);
    int i;
    damper->states = (int)dashpot_model_states(&damper->model);
    memset(damper->used, 0, sizeof damper->used);
    for (i = 0; i < damper->states && i < MAX_STATES; i++)
        damper->used[i] = 1;
    /* Without the series compliance the internal mass moves with the moving end, so that its velocity state does not affect
     * the rate of its displacement. */
    if (dashpot_state_init(&damper->model, 0.0, &state) >= 0 &&
        dashpot_jacobian(&damper->model, &state, &input, &partials) >= 0 && partials.d_rate_d_state[0][1] == 0)
        damper->used[0] = damper->used[1] = 0;
}

const damper_model *damper_model_of(int element, int npar, const double *par, int units_at, int again)
{
    known_model *place = NULL;
    const damper_model *answer = NULL;
    int string, i;
    const int most = (int)(sizeof models / sizeof models[0]);
    if (!(fabs(par[0]) < 2e9) || par[0] != floor(par[0]) || par[0] <= 0) {
        message_stop(element, "the first USER value is %g; it must be the id of a STRING with the path of the model file",
                     par[0]);
        return NULL;
    }
    string = (int)par[0];
    lock(&models_lock);
    for (i = 0; i < most && models[i].used; i++)
        if (models[i].element == element && models[i].string == string) {
            place = &models[i];
            break;
        }
    if (place && !again) {
        answer = &place->damper;
    } else if (!place && i == most) {
        message_stop(element, "more than %d dampers in one process", most);
    } else {
        damper_model *damper;
        if (!place)
            place = &models[i];
        damper = &place->damper;
        if (units_read(element, npar >= units_at + 3 ? par + units_at : NULL, &damper->units) == 0 &&
            read_model(element, string, damper) == 0) {
            place->element = element;
            place->string = string;
            place->used = 1;
            answer = damper;
        } else if (place->used) {
            /* The file was readable before but no longer is. Drop the entry, so that the next call reads the file again. */
            place->element = -1;
        }
    }
    unlock(&models_lock);
    return answer;
}
