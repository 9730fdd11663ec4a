/* Names of the entries of the flat vectors, and the lengths of these vectors. */
#include "bridge.h"

int dashpot_bridge_name_vectors(dashpot_bridge *bridge)
{
    uint32_t corner;
    int channel;

    for (corner = 0; corner < bridge->corners; corner++) {
        for (channel = 0; channel < DASHPOT_CHANNEL_INPUTS; channel++) {
            if (!bridge->map.name[channel][0])
                continue;
            if (dashpot_channel_map_name(&bridge->map, channel, corner, bridge->input_name[bridge->inputs],
                                         DASHPOT_CHANNEL_NAME))
                return -1;
            bridge->input_channel[bridge->inputs++] = channel;
        }
        if (dashpot_channel_map_name(&bridge->map, DASHPOT_CHANNEL_FORCE, corner, bridge->output_name[corner],
                                     DASHPOT_CHANNEL_NAME))
            return -1;
    }
    return 0;
}

uint32_t dashpot_bridge_input_count(const dashpot_bridge *bridge)
{
    return bridge->inputs;
}

uint32_t dashpot_bridge_output_count(const dashpot_bridge *bridge)
{
    return bridge->corners;
}

const char *dashpot_bridge_input_name(const dashpot_bridge *bridge, uint32_t i)
{
    return i < bridge->inputs ? bridge->input_name[i] : NULL;
}

const char *dashpot_bridge_output_name(const dashpot_bridge *bridge, uint32_t i)
{
    return i < bridge->corners ? bridge->output_name[i] : NULL;
}
