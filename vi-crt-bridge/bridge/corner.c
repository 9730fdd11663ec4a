#include "corner.h"
#include <stdio.h>
#include <stdlib.h>

/* Longest model file, bytes: enough for 800 parameters with a page of comment each. */
#define LONGEST_FILE ((size_t)1 << 22)

int32_t dashpot_corner_read(dashpot_corner *corner, const char *text, size_t length, dashpot_fault *fault)
{
    const dashpot_params empty = DASHPOT_PARAMS_INIT;
    int32_t status;

    corner->params = empty;
    status = dashpot_params_read(&corner->params, text, length, fault);
    if (status < 0)
        return status;
    status = dashpot_params_check(&corner->params, fault);
    if (status < 0)
        return status;
    status = dashpot_model_init(&corner->model, &corner->params);
    return status < 0 ? status : dashpot_corner_rest(corner, 0.0);
}

int32_t dashpot_corner_load(dashpot_corner *corner, const char *path, dashpot_fault *fault)
{
    FILE *file = fopen(path, "rb");
    char *text;
    size_t length;
    int32_t status;

    fault->status = DASHPOT_CORNER_NO_FILE;
    fault->line = 0;
    fault->parameter[0] = '\0';
    if (!file)
        return DASHPOT_CORNER_NO_FILE;
    text = malloc(LONGEST_FILE);
    length = text ? fread(text, 1, LONGEST_FILE, file) : 0;
    if (!text || ferror(file))
        status = DASHPOT_CORNER_NO_FILE;
    else if (length == LONGEST_FILE)
        status = DASHPOT_CORNER_FILE_TOO_LONG;
    else
        status = dashpot_corner_read(corner, text, length, fault);
    fault->status = status;
    free(text);
    fclose(file);
    return status;
}

int32_t dashpot_corner_rest(dashpot_corner *corner, double position)
{
    return dashpot_corner_rest_at(corner, position, NULL);
}

int32_t dashpot_corner_rest_at(dashpot_corner *corner, double position, const double *setting)
{
    dashpot_input still = dashpot_input_motion(position, 0.0);

    if (setting)
        still = dashpot_input_with_setting(still, *setting);
    return dashpot_corner_begin(corner, &still);
}

int32_t dashpot_corner_begin(dashpot_corner *corner, const dashpot_input *input)
{
    dashpot_corner_state start;
    int32_t status = dashpot_state_init_motion(&corner->model, input, &start.state);

    if (status < 0)
        return status;
    status = dashpot_step(&corner->model, &start.state, input, 0.0, &start.state, &start.output);
    if (status >= 0)
        corner->now = start;
    return status;
}

int32_t dashpot_corner_step(dashpot_corner *corner, const dashpot_input *input, double dt)
{
    /* A rejected step changes neither state nor output, so that the last force remains. */
    int32_t status =
        dashpot_step(&corner->model, &corner->now.state, input, dt, &corner->now.state, &corner->now.output);

    return status < 0 ? DASHPOT_BRIDGE_LAST_FORCE : status;
}
