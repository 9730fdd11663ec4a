/* dashpot as the dampers of a CarSim or TruckSim vehicle, by the VehicleSim (VS) API: the imports IMP_FD_L1, IMP_FD_R1,
 * IMP_FD_L2 and IMP_FD_R2 replace the forces of the solver's own dampers.
 *
 * It compiles with the VS headers of your installation, which DASHPOT_VS_HEADER names. The wrapper program calls it after
 * vs_get_api(), which fills the API's function pointers, and before vs_run():
 *
 *     if (vs_get_api(vsDLL, pathDLL)) return 1;
 *     if (dashpot_vs_install("front.toml", "rear.toml", "carsim.toml")) return 1;
 *     vs_run(simfile);
 *     dashpot_vs_end();
 *
 * A wrapper that installs its own calc function after dashpot_vs_install() calls dashpot_vs_calculate() from it. The channel
 * map (maps/carsim.toml) contains units, signs and position_offset. Set OPT_IO_SYNC_FM in the vehicle, so that the force
 * belongs to the kinematics of the same step. ../FACTS.md lists the parts of the API that this file uses, with sources. */
#include DASHPOT_VS_HEADER
#include "dashpot_bridge.h"
#include <stdio.h>

/* Static variables suffice, because the VS solver runs one vehicle per process. Its call-backs pass no user pointer. */
static dashpot_bridge *bridge;
static vs_real *input[DASHPOT_BRIDGE_CORNERS * DASHPOT_CHANNEL_INPUTS];
static vs_real *output[DASHPOT_BRIDGE_CORNERS];
static vs_real last_time;
static int ready;

/* Reports an error and stops the run. */
static void stop(const char *text, const char *name)
{
    vs_printf_error("dashpot: %s%s\n", text, name);
    vs_set_stop_run(1.0, "dashpot: %s%s", text, name);
}

static vs_real *variable(const char *name)
{
    /* In most releases vs_get_var_ptr() takes a char * that is not const, although it does not write to it. */
    char copy[DASHPOT_CHANNEL_NAME];

    snprintf(copy, sizeof copy, "%s", name);
    return vs_get_var_ptr(copy);
}

static void import_forces(void)
{
    uint32_t i;

    for (i = 0; i < dashpot_bridge_output_count(bridge); i++) {
        char line[DASHPOT_CHANNEL_NAME + 16];
        snprintf(line, sizeof line, "%s vs_replace 0", dashpot_bridge_output_name(bridge, i));
        vs_statement("IMPORT", line, 1);
    }
}

/* Finds the solver's variables of all channels. Returns 1, or 0 after stopping the run if the solver lacks one. */
static int find_channels(void)
{
    uint32_t i;

    for (i = 0; i < dashpot_bridge_input_count(bridge); i++)
        if (!(input[i] = variable(dashpot_bridge_input_name(bridge, i)))) {
            stop("the channel map names a variable that the solver does not have: ", dashpot_bridge_input_name(bridge, i));
            return 0;
        }
    for (i = 0; i < dashpot_bridge_output_count(bridge); i++)
        if (!(output[i] = variable(dashpot_bridge_output_name(bridge, i)))) {
            stop("the channel map names an import that the solver does not have: ", dashpot_bridge_output_name(bridge, i));
            return 0;
        }
    return 1;
}

static void dampers(vs_real time, int first)
{
    double u[DASHPOT_BRIDGE_CORNERS * DASHPOT_CHANNEL_INPUTS], y[DASHPOT_BRIDGE_CORNERS];
    uint32_t inputs = dashpot_bridge_input_count(bridge), outputs = dashpot_bridge_output_count(bridge), i;

    for (i = 0; i < inputs; i++)
        u[i] = *input[i];
    if (first)
        dashpot_bridge_init_vector(bridge, u, inputs, y, outputs);
    else
        /* A repeated call at the same time is a static evaluation (dt = 0). */
        dashpot_bridge_step_vector(bridge, time > last_time ? time - last_time : 0.0, u, inputs, y, outputs);
    last_time = time;
    for (i = 0; i < outputs; i++)
        *output[i] = y[i];
}

void dashpot_vs_calculate(vs_real time, vs_ext_loc where)
{
    if (!bridge)
        return;
    switch (where) {
    case VS_EXT_AFTER_READ:
        import_forces();
        break;
    case VS_EXT_EQ_INIT:
        ready = find_channels();
        if (ready)
            dampers(time, 1);
        break;
    case VS_EXT_EQ_IN:
        if (ready)
            dampers(time, 0);
        break;
    default:
        break;
    }
}

int dashpot_vs_install(const char *front, const char *rear, const char *map)
{
    const char *models[4] = {front, front, rear, rear};
    static dashpot_bridge_fault fault;

    ready = 0;
    /* The API's functions are pointers, which are null before vs_get_api(). */
    if (!vs_install_calc_function || !vs_printf_error) {
        fputs("dashpot: call dashpot_vs_install() behind vs_get_api()\n", stderr);
        return -2;
    }
    bridge = dashpot_bridge_create(4, models, map, &fault);
    if (!bridge) {
        vs_printf_error("dashpot: %s\n", fault.text);
        return -1;
    }
    vs_install_calc_function(dashpot_vs_calculate);
    return 0;
}

void dashpot_vs_end(void)
{
    dashpot_bridge_destroy(bridge);
    bridge = NULL;
}
