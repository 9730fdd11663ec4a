/* Internal declarations of the bridge, for the files of this folder only. */
#ifndef DASHPOT_BRIDGE_INSIDE_H
#define DASHPOT_BRIDGE_INSIDE_H

#include "dashpot_bridge.h"

#define MAX_INPUTS (DASHPOT_BRIDGE_CORNERS * DASHPOT_CHANNEL_INPUTS)

struct dashpot_bridge {
    dashpot_corner corner[DASHPOT_BRIDGE_CORNERS];
    dashpot_channel_map map;
    uint32_t corners;
    /* Channels of the flat vectors; dashpot_bridge_create() makes their names. */
    uint32_t inputs;
    enum dashpot_channel input_channel[MAX_INPUTS];
    char input_name[MAX_INPUTS][DASHPOT_CHANNEL_NAME];
    char output_name[DASHPOT_BRIDGE_CORNERS][DASHPOT_CHANNEL_NAME];
};

/* Names the entries of the flat vectors. Returns 0, or -1 if a name is too long. */
int dashpot_bridge_name_vectors(dashpot_bridge *bridge);

/* Converts the host's input of a corner to the input of the kernel. */
dashpot_input dashpot_bridge_to_kernel(const dashpot_bridge *bridge, uint32_t corner, const dashpot_corner_input *in);

/* Converts the last kernel output of a corner to the output for the host. */
void dashpot_bridge_to_host(const dashpot_bridge *bridge, uint32_t corner, int32_t status, dashpot_corner_output *out);

#endif
