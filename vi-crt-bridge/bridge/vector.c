/* Flat input and output vectors, for hosts that choose channels by name (names.c). */
#include "bridge.h"
#include <string.h>

static const uint32_t KNOWN[DASHPOT_CHANNEL_INPUTS] = {DASHPOT_CORNER_KNOWS_JOUNCE, 0, DASHPOT_CORNER_KNOWS_ACCELERATION,
                                                       DASHPOT_CORNER_KNOWS_SIDE_FORCE,
                                                       DASHPOT_CORNER_KNOWS_TEMPERATURE, DASHPOT_CORNER_KNOWS_SETTING};

/* Fills the corners' inputs from a flat vector. Every corner has the same number of channels. */
static void unpack(const dashpot_bridge *bridge, const double *u, dashpot_corner_input *in)
{
    uint32_t i, each = bridge->inputs / bridge->corners;

    memset(in, 0, bridge->corners * sizeof *in);
    for (i = 0; i < bridge->inputs; i++) {
        dashpot_corner_input *corner = &in[i / each];
        double *const place[DASHPOT_CHANNEL_INPUTS] = {&corner->jounce, &corner->jounce_rate,
                                                       &corner->jounce_acceleration, &corner->side_force,
                                                       &corner->temperature, &corner->setting};

        *place[bridge->input_channel[i]] = u[i];
        corner->known |= KNOWN[bridge->input_channel[i]];
    }
}

static void pack(const dashpot_bridge *bridge, const dashpot_corner_output *out, double *y)
{
    uint32_t i;

    for (i = 0; i < bridge->corners; i++)
        y[i] = out[i].force;
}

int32_t dashpot_bridge_init_vector(dashpot_bridge *bridge, const double *u, uint32_t inputs, double *y,
                                   uint32_t outputs)
{
    dashpot_corner_input in[DASHPOT_BRIDGE_CORNERS];
    dashpot_corner_output out[DASHPOT_BRIDGE_CORNERS];
    int32_t status;

    if (inputs != bridge->inputs || outputs != bridge->corners)
        return DASHPOT_BRIDGE_LAST_FORCE;
    unpack(bridge, u, in);
    status = dashpot_bridge_init(bridge, in, out);
    pack(bridge, out, y);
    return status;
}

int32_t dashpot_bridge_step_vector(dashpot_bridge *bridge, double dt, const double *u, uint32_t inputs, double *y,
                                   uint32_t outputs)
{
    dashpot_corner_input in[DASHPOT_BRIDGE_CORNERS];
    dashpot_corner_output out[DASHPOT_BRIDGE_CORNERS];
    int32_t status;

    if (inputs != bridge->inputs || outputs != bridge->corners)
        return DASHPOT_BRIDGE_LAST_FORCE;
    unpack(bridge, u, in);
    status = dashpot_bridge_step(bridge, dt, in, out);
    pack(bridge, out, y);
    return status;
}
