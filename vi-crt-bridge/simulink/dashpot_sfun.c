/* dashpot as a Simulink S-function (level 2), for one corner or four: the bridge's flat vectors as a block.
 *
 *   mex -Iinclude -Ivi-crt-bridge/bridge vi-crt-bridge/simulink/dashpot_sfun.c vi-crt-bridge/bridge/bridge.c ... -Ltarget/release -ldashpot
 *
 * (../README.md contains the whole line.) An S-Function block named dashpot_sfun has four parameters:
 *
 *   1  model files, separated by ';': one (a single corner), two (front and rear axle) or four (L1;R1;L2;R2)
 *   2  channel map file, or '' for SI with compression positive
 *   3  sample time, s
 *   4  1: the block outputs the force one step later, which breaks the algebraic loop; 0: without delay
 *
 * The input vector follows the channels of the map corner by corner (jounce_L1, jounce_rate_L1, jounce_R1, ... without a
 * map), the output vector is the forces L1, R1, L2, R2.
 *
 * The state of the block is in its work vectors, so that Simulink's saved operating points contain it. mdlOutputs computes
 * a trial step, as often as an algebraic loop needs it; mdlUpdate commits the step. */
#define S_FUNCTION_NAME dashpot_sfun
#define S_FUNCTION_LEVEL 2
#include "simstruc.h"

#include "dashpot_bridge.h"
#include <stdio.h>
#include <string.h>

enum parameter { MODELS, MAP, SAMPLE_TIME, DELAYED, PARAMETERS };
enum work { MEMORY, STARTED, FORCES, WORKS };
#define LONGEST 4096

static void refuse(SimStruct *S, const char *text)
{
    /* Static, because Simulink reads the text after the call-back has returned. */
    static char kept[700];

    snprintf(kept, sizeof kept, "dashpot: %s", text);
    ssSetErrorStatus(S, kept);
}

static double number(SimStruct *S, enum parameter which)
{
    const mxArray *array = ssGetSFcnParam(S, which);

    return mxIsDouble(array) && mxGetNumberOfElements(array) == 1 ? mxGetScalar(array) : -1.0;
}

static dashpot_bridge *create(SimStruct *S)
{
    static char models[LONGEST], map[LONGEST];
    const char *file[DASHPOT_BRIDGE_CORNERS], *corner[DASHPOT_BRIDGE_CORNERS];
    dashpot_bridge_fault fault;
    dashpot_bridge *bridge;
    char *at = models;
    uint32_t files = 0, i;

    if (mxGetString(ssGetSFcnParam(S, MODELS), models, sizeof models) ||
        mxGetString(ssGetSFcnParam(S, MAP), map, sizeof map)) {
        refuse(S, "model files and channel map are texts");
        return NULL;
    }
    while (at && files < DASHPOT_BRIDGE_CORNERS) {
        file[files++] = at;
        at = strchr(at, ';');
        if (at)
            *at++ = '\0';
    }
    if (at || files == 3) {
        refuse(S, "give one model file, two (front;rear) or four (L1;R1;L2;R2)");
        return NULL;
    }
    for (i = 0; i < DASHPOT_BRIDGE_CORNERS; i++)
        corner[i] = file[files == 4 ? i : files == 2 ? i / 2 : 0];
    bridge = dashpot_bridge_create(files == 1 ? 1 : DASHPOT_BRIDGE_CORNERS, corner, map[0] ? map : NULL, &fault);
    if (!bridge)
        refuse(S, fault.text);
    return bridge;
}

static dashpot_bridge *held(SimStruct *S)
{
    return ssGetPWorkValue(S, 0);
}

static void mdlInitializeSizes(SimStruct *S)
{
    dashpot_bridge *bridge;
    int i;

    ssSetNumSFcnParams(S, PARAMETERS);
    if (ssGetNumSFcnParams(S) != ssGetSFcnParamsCount(S))
        return; /* Simulink itself reports the wrong number of parameters. */
    for (i = 0; i < PARAMETERS; i++)
        ssSetSFcnParamTunable(S, i, 0);
    if (!(number(S, SAMPLE_TIME) > 0.0)) {
        refuse(S, "the sample time is one number above 0");
        return;
    }
    if (number(S, DELAYED) != 0.0 && number(S, DELAYED) != 1.0) {
        refuse(S, "the fourth parameter is 0 (force at once) or 1 (one step later)");
        return;
    }
    bridge = create(S);
    if (!bridge)
        return;
    if (ssSetNumInputPorts(S, 1) && ssSetNumOutputPorts(S, 1)) {
        ssSetInputPortWidth(S, 0, (int_T)dashpot_bridge_input_count(bridge));
        ssSetInputPortRequiredContiguous(S, 0, 1);
        ssSetInputPortDirectFeedThrough(S, 0, number(S, DELAYED) == 0.0);
        ssSetOutputPortWidth(S, 0, (int_T)dashpot_bridge_output_count(bridge));
        ssSetNumSampleTimes(S, 1);
        ssSetNumPWork(S, 1);
        ssSetNumDWork(S, WORKS);
        ssSetDWorkWidth(S, MEMORY, (int_T)sizeof(dashpot_bridge_state));
        ssSetDWorkDataType(S, MEMORY, SS_UINT8);
        ssSetDWorkWidth(S, STARTED, 1);
        ssSetDWorkDataType(S, STARTED, SS_UINT8);
        ssSetDWorkWidth(S, FORCES, DASHPOT_BRIDGE_CORNERS);
        ssSetDWorkDataType(S, FORCES, SS_DOUBLE);
        ssSetSimStateCompliance(S, USE_DEFAULT_SIM_STATE);
    }
    dashpot_bridge_destroy(bridge);
}

static void mdlInitializeSampleTimes(SimStruct *S)
{
    ssSetSampleTime(S, 0, number(S, SAMPLE_TIME));
    ssSetOffsetTime(S, 0, 0.0);
}

static void keep(SimStruct *S)
{
    dashpot_bridge_state state;

    dashpot_bridge_save(held(S), &state);
    memcpy(ssGetDWork(S, MEMORY), &state, sizeof state);
}

/* Steps the bridge from the committed state to the present input and writes the forces to y. */
static void step(SimStruct *S, double *y)
{
    dashpot_bridge *bridge = held(S);
    const double *u = ssGetInputPortRealSignal(S, 0);
    uint32_t inputs = dashpot_bridge_input_count(bridge), outputs = dashpot_bridge_output_count(bridge);
    dashpot_bridge_state state;

    memcpy(&state, ssGetDWork(S, MEMORY), sizeof state);
    dashpot_bridge_restore(bridge, &state);
    if (*(const unsigned char *)ssGetDWork(S, STARTED))
        dashpot_bridge_step_vector(bridge, number(S, SAMPLE_TIME), u, inputs, y, outputs);
    else
        dashpot_bridge_init_vector(bridge, u, inputs, y, outputs);
}

#define MDL_START
static void mdlStart(SimStruct *S)
{
    ssSetPWorkValue(S, 0, create(S));
}

/* Puts the dampers at rest. The first step after it starts at rest at its input. Simulink also calls this when an enabled
 * subsystem restarts. */
#define MDL_INITIALIZE_CONDITIONS
static void mdlInitializeConditions(SimStruct *S)
{
    dashpot_corner_input rest[DASHPOT_BRIDGE_CORNERS];
    dashpot_corner_output out[DASHPOT_BRIDGE_CORNERS];
    double *forces = ssGetDWork(S, FORCES);
    uint32_t i;

    if (!held(S))
        return;
    memset(rest, 0, sizeof rest);
    dashpot_bridge_init(held(S), rest, out);
    for (i = 0; i < dashpot_bridge_corners(held(S)); i++)
        forces[i] = out[i].force;
    *(unsigned char *)ssGetDWork(S, STARTED) = 0;
    keep(S);
}

static void mdlOutputs(SimStruct *S, int_T task)
{
    double *y = ssGetOutputPortRealSignal(S, 0);

    (void)task;
    if (!held(S))
        return;
    if (number(S, DELAYED) != 0.0)
        memcpy(y, ssGetDWork(S, FORCES), dashpot_bridge_output_count(held(S)) * sizeof *y);
    else
        step(S, y);
}

#define MDL_UPDATE
static void mdlUpdate(SimStruct *S, int_T task)
{
    (void)task;
    if (!held(S))
        return;
    step(S, ssGetDWork(S, FORCES));
    *(unsigned char *)ssGetDWork(S, STARTED) = 1;
    keep(S);
}

static void mdlTerminate(SimStruct *S)
{
    if (ssGetPWork(S) && held(S))
        dashpot_bridge_destroy(held(S));
}

#ifdef MATLAB_MEX_FILE
#include "simulink.c"
#else
#include "cg_sfun.h"
#endif
