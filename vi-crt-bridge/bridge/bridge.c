/* Create, init, step, save and restore, and the conversion between the host's signs and units and the kernel's. */
#include "bridge.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *refused(dashpot_bridge *bridge, dashpot_bridge_fault *fault, const char *file, uint32_t line,
                     const char *name, const char *what)
{
    char place[32] = "";

    if (line)
        snprintf(place, sizeof place, ", line %u", (unsigned)line);
    snprintf(fault->text, sizeof fault->text, "%s%s: %s%s%s", file, place, name, *name ? " " : "", what);
    free(bridge);
    return NULL;
}

static int read_map(dashpot_channel_map *map, const char *path, dashpot_channel_map_fault *fault)
{
    static const size_t longest = 1 << 16;
    FILE *file = fopen(path, "rb");
    char *text = malloc(longest);
    size_t length = file && text ? fread(text, 1, longest, file) : 0;
    int answer = -1;

    fault->line = 0;
    strcpy(fault->text, "cannot be read as a channel map");
    if (file && text && !ferror(file) && length < longest)
        answer = dashpot_channel_map_read(map, text, length, fault);
    free(text);
    if (file)
        fclose(file);
    return answer;
}

dashpot_bridge *dashpot_bridge_create(uint32_t corners, const char *const *models, const char *map,
                                      dashpot_bridge_fault *fault)
{
    dashpot_bridge *bridge;
    dashpot_channel_map_fault map_fault;
    uint32_t i;

    if (corners != 1 && corners != DASHPOT_BRIDGE_CORNERS)
        return refused(NULL, fault, "dashpot_bridge_create", 0, "", "a bridge has 1 or 4 corners");
    /* calloc() zeroes the memory here, so that the first step causes no page fault. */
    bridge = calloc(1, sizeof *bridge);
    if (!bridge)
        return refused(NULL, fault, "dashpot_bridge_create", 0, "", "out of memory");
    bridge->corners = corners;
    dashpot_channel_map_default(&bridge->map);
    if (map && read_map(&bridge->map, map, &map_fault))
        return refused(bridge, fault, map, map_fault.line, "", map_fault.text);
    if (dashpot_bridge_name_vectors(bridge))
        return refused(bridge, fault, map ? map : "channel map", 0, "", "a channel name is too long");
    for (i = 0; i < corners; i++) {
        dashpot_fault at;
        int32_t status = dashpot_corner_load(&bridge->corner[i], models[i], &at);

        if (status == DASHPOT_CORNER_NO_FILE)
            return refused(bridge, fault, models[i], 0, "", "cannot be read");
        if (status == DASHPOT_CORNER_FILE_TOO_LONG)
            return refused(bridge, fault, models[i], 0, "", "is longer than any model file");
        if (status < 0)
            return refused(bridge, fault, models[i], at.line, at.parameter, dashpot_status_text(status));
    }
    return bridge;
}

void dashpot_bridge_destroy(dashpot_bridge *bridge)
{
    free(bridge);
}

uint32_t dashpot_bridge_corners(const dashpot_bridge *bridge)
{
    return bridge->corners;
}

dashpot_input dashpot_bridge_to_kernel(const dashpot_bridge *bridge, uint32_t corner, const dashpot_corner_input *in)
{
    double scale = bridge->map.motion_scale[corner];
    dashpot_input input = dashpot_input_velocity(scale * in->jounce_rate);

    if (in->known & DASHPOT_CORNER_KNOWS_JOUNCE) {
        input.known |= DASHPOT_KNOWS_DISPLACEMENT;
        input.displacement = scale * in->jounce + bridge->map.position_offset[corner];
    }
    if (in->known & DASHPOT_CORNER_KNOWS_SIDE_FORCE) {
        input.known |= DASHPOT_KNOWS_SIDE_FORCE;
        input.side_force = bridge->map.side_force_scale * in->side_force;
    }
    if (in->known & DASHPOT_CORNER_KNOWS_TEMPERATURE) {
        input.known |= DASHPOT_KNOWS_TEMPERATURE;
        input.temperature = in->temperature;
    }
    if (in->known & DASHPOT_CORNER_KNOWS_SETTING)
        input = dashpot_input_with_setting(input, in->setting);
    return input;
}

void dashpot_bridge_to_host(const dashpot_bridge *bridge, uint32_t corner, int32_t status, dashpot_corner_output *out)
{
    const dashpot_output *answer = &bridge->corner[corner].now.output;
    double motion = bridge->map.motion_scale[corner], force = bridge->map.force_scale[corner];

    out->force = force * answer->force;
    out->d_force_d_rate = force * answer->d_force_d_velocity * motion;
    out->d_force_d_jounce = force * answer->d_force_d_displacement * motion;
    out->status = status;
    out->reserved = 0;
}

int32_t dashpot_bridge_init(dashpot_bridge *bridge, const dashpot_corner_input *in, dashpot_corner_output *out)
{
    int32_t all = 0;
    uint32_t i;

    for (i = 0; i < bridge->corners; i++) {
        int32_t status = dashpot_corner_rest_at(&bridge->corner[i], bridge->map.motion_scale[i] * in[i].jounce + bridge->map.position_offset[i],
                                                in[i].known & DASHPOT_CORNER_KNOWS_SETTING ? &in[i].setting : NULL);

        status = status < 0 ? DASHPOT_BRIDGE_LAST_FORCE : status;
        dashpot_bridge_to_host(bridge, i, status, &out[i]);
        all |= status;
    }
    return all;
}

int32_t dashpot_bridge_step(dashpot_bridge *bridge, double dt, const dashpot_corner_input *in,
                            dashpot_corner_output *out)
{
    int32_t all = 0;
    uint32_t i;

    for (i = 0; i < bridge->corners; i++) {
        dashpot_input input = dashpot_bridge_to_kernel(bridge, i, &in[i]);
        int32_t status = dashpot_corner_step(&bridge->corner[i], &input, dt);

        dashpot_bridge_to_host(bridge, i, status, &out[i]);
        all |= status;
    }
    return all;
}

void dashpot_bridge_save(const dashpot_bridge *bridge, dashpot_bridge_state *state)
{
    uint32_t i;

    /* Copies all corners, so that the saved state of a single-corner bridge has zeros in the unused ones. */
    for (i = 0; i < DASHPOT_BRIDGE_CORNERS; i++)
        state->corner[i] = bridge->corner[i].now;
}

void dashpot_bridge_restore(dashpot_bridge *bridge, const dashpot_bridge_state *state)
{
    uint32_t i;

    for (i = 0; i < DASHPOT_BRIDGE_CORNERS; i++)
        bridge->corner[i].now = state->corner[i];
}
