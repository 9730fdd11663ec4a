/* Replaces Simulink's file simulink.c, which a block includes. It is a host that calls the block's call-backs in the order that Simulink
 * documents. It requests outputs several times within a step, as an algebraic loop does, and compares them with a bridge. Arguments: model
 * file, channel map, model file of a damper over a setting, map with its channel. */
#include "check.h"
#include <math.h>
#include <stdlib.h>

#define DT 1e-3

struct mxArray {
    const char *text; /* or a number */
    double number;
};

struct SimStruct {
    mxArray parameter[8];
    int parameters, wanted, inputs, outputs, through, samples, pworks, dworks, compliant;
    double sample_time, offset, u[32], y[8];
    void *pwork[2], *dwork[8];
    int width[8], type[8];
    const char *error;
};

int mxGetString(const mxArray *a, char *text, size_t room)
{
    if (!a->text || strlen(a->text) >= room)
        return 1;
    strcpy(text, a->text);
    return 0;
}
int mxIsDouble(const mxArray *a) { return !a->text; }
size_t mxGetNumberOfElements(const mxArray *a) { return a->text ? strlen(a->text) : 1; }
double mxGetScalar(const mxArray *a) { return a->number; }

int_T ssSetNumSFcnParams(SimStruct *S, int_T n) { return S->wanted = n; }
int_T ssGetNumSFcnParams(SimStruct *S) { return S->wanted; }
int_T ssGetSFcnParamsCount(SimStruct *S) { return S->parameters; }
void ssSetSFcnParamTunable(SimStruct *S, int_T i, int_T tunable) { CHECK(i < S->wanted && !tunable); }
const mxArray *ssGetSFcnParam(SimStruct *S, int_T i) { return &S->parameter[i]; }
int_T ssSetNumInputPorts(SimStruct *S, int_T n) { (void)S; return n == 1; }
void ssSetInputPortWidth(SimStruct *S, int_T port, int_T width) { CHECK(port == 0); S->inputs = width; }
void ssSetInputPortRequiredContiguous(SimStruct *S, int_T port, int_T c) { (void)S; CHECK(port == 0 && c); }
void ssSetInputPortDirectFeedThrough(SimStruct *S, int_T port, int_T through) { CHECK(port == 0); S->through = through; }
int_T ssSetNumOutputPorts(SimStruct *S, int_T n) { (void)S; return n == 1; }
void ssSetOutputPortWidth(SimStruct *S, int_T port, int_T width) { CHECK(port == 0); S->outputs = width; }
void ssSetNumSampleTimes(SimStruct *S, int_T n) { S->samples = n; }
void ssSetSampleTime(SimStruct *S, int_T i, time_T t) { CHECK(i == 0); S->sample_time = t; }
void ssSetOffsetTime(SimStruct *S, int_T i, time_T t) { CHECK(i == 0); S->offset = t; }
void ssSetNumPWork(SimStruct *S, int_T n) { S->pworks = n; }
void **ssGetPWork(SimStruct *S) { return S->pwork; }
void *ssGetPWorkValue(SimStruct *S, int_T i) { return S->pwork[i]; }
void *ssSetPWorkValue(SimStruct *S, int_T i, void *value) { return S->pwork[i] = value; }
int_T ssSetNumDWork(SimStruct *S, int_T n) { return S->dworks = n; }
void ssSetDWorkWidth(SimStruct *S, int_T i, int_T width) { S->width[i] = width; }
void ssSetDWorkDataType(SimStruct *S, int_T i, int_T type) { S->type[i] = type; }
void *ssGetDWork(SimStruct *S, int_T i) { return S->dwork[i]; }
void ssSetSimStateCompliance(SimStruct *S, int_T c) { S->compliant = c; }
const real_T *ssGetInputPortRealSignal(SimStruct *S, int_T port)
{
    (void)port;
    /* In Simulink, mdlOutputs of a block without direct feedthrough must not read the input. This is not checked. */
    return S->u;
}
real_T *ssGetOutputPortRealSignal(SimStruct *S, int_T port) { (void)port; return S->y; }
void ssSetErrorStatus(SimStruct *S, const char *text) { S->error = text; }

/* Initializes a block up to the start of a run. Stops at the first error, as Simulink does. */
static void begin(SimStruct *S, const char *models, const char *map, double delayed)
{
    int i;

    memset(S, 0, sizeof *S);
    S->parameters = 4;
    S->parameter[0].text = models;
    S->parameter[1].text = map;
    S->parameter[2].number = DT;
    S->parameter[3].number = delayed;
    mdlInitializeSizes(S);
    if (S->error)
        return;
    CHECK(S->samples == 1 && S->pworks == 1 && S->compliant == USE_DEFAULT_SIM_STATE);
    mdlInitializeSampleTimes(S);
    CHECK(S->sample_time == DT && S->offset == 0.0);
    for (i = 0; i < S->dworks; i++)
        S->dwork[i] = calloc((size_t)S->width[i], S->type[i] == SS_DOUBLE ? sizeof(double) : 1);
    mdlStart(S);
    mdlInitializeConditions(S);
}

static void end(SimStruct *S)
{
    int i;

    mdlTerminate(S);
    for (i = 0; i < S->dworks; i++)
        free(S->dwork[i]);
}

static void motion(double t, int inputs, int each, double *u)
{
    int i;

    memset(u, 0, (size_t)inputs * sizeof *u);
    for (i = 0; i < inputs / each; i++) {
        double w = 6.283185307179586 * (1.0 + 2.5 * i);
        u[each * i] = 0.015 * sin(w * t) - 0.003 * i;
        u[each * i + 1] = 0.015 * w * cos(w * t);
    }
}

/* Checks that the forces of the block are those of the bridge, without delay or one step later, whatever trial inputs come in between. A
 * step repeated from saved work vectors must give equal forces. */
static void is_the_bridge(const char *models, uint32_t corners, const char *file, const char *map, int each, int delayed)
{
    const char *files[4] = {file, file, file, file};
    dashpot_bridge_fault fault;
    dashpot_bridge *twin = dashpot_bridge_create(corners, files, *map ? map : NULL, &fault);
    static SimStruct S;
    static double before[4], force[4], again[2][4];
    unsigned char saved[4096];
    int k, tries, inputs;
    uint32_t i;

    begin(&S, models, map, delayed);
    CHECK(!S.error && twin);
    if (S.error || !twin) {
        fprintf(stderr, "%s\n", S.error ? S.error : fault.text);
        return;
    }
    inputs = (int)dashpot_bridge_input_count(twin);
    CHECK(S.inputs == inputs && S.inputs == each * (int)corners && S.outputs == (int)corners && S.through == !delayed);
    memcpy(before, S.dwork[2], sizeof before);
    for (k = 0; k <= 500; k++) {
        motion(k * DT, inputs, each, S.u);
        if (k == 0)
            dashpot_bridge_init_vector(twin, S.u, (uint32_t)inputs, force, corners);
        else
            dashpot_bridge_step_vector(twin, DT, S.u, (uint32_t)inputs, force, corners);
        for (tries = 0; tries < 3; tries++) {
            S.u[1] += tries < 2 ? 0.01 : -0.02;
            mdlOutputs(&S, 0);
        }
        motion(k * DT, inputs, each, S.u);
        mdlOutputs(&S, 0);
        for (i = 0; i < corners; i++)
            CHECK(S.y[i] == (delayed ? before : force)[i]);
        mdlUpdate(&S, 0);
        memcpy(before, force, sizeof before);
        if (k == 300)
            memcpy(saved, S.dwork[0], (size_t)S.width[0]);
        if (k == 301)
            memcpy(again[0], S.dwork[2], sizeof again[0]);
    }
    memcpy(S.dwork[0], saved, (size_t)S.width[0]);
    motion(301 * DT, inputs, each, S.u);
    mdlUpdate(&S, 0);
    memcpy(again[1], S.dwork[2], sizeof again[1]);
    CHECK(!memcmp(again[0], again[1], sizeof again[0]));
    end(&S);
    dashpot_bridge_destroy(twin);
}

/* Checks that another setting, the last channel of a corner, gives another force. */
static void follows_the_setting(const char *model, const char *map)
{
    static SimStruct S;
    double forces[2];
    int which, k, i, each;

    for (which = 0; which < 2; which++) {
        begin(&S, model, map, 0.0);
        CHECK(!S.error && S.inputs == 3);
        if (S.error)
            return;
        each = S.inputs;
        for (k = 0; k <= 200; k++) {
            motion(k * DT, S.inputs, each, S.u);
            S.u[each - 1] = which ? 1.6 : 0.0;
            mdlOutputs(&S, 0);
            mdlUpdate(&S, 0);
        }
        forces[which] = S.y[0];
        for (i = 0; i < S.outputs; i++)
            CHECK(isfinite(S.y[i]));
        end(&S);
    }
    CHECK(fabs(forces[1]) > fabs(forces[0]) + 50.0);
}

static void refused(const char *models, const char *map, double delayed, const char *says)
{
    static SimStruct S;

    begin(&S, models, map, delayed);
    CHECK(S.error && strstr(S.error, says));
    if (!S.error || !strstr(S.error, says))
        fprintf(stderr, "%s, not %s\n", S.error ? S.error : "no error", says);
    if (!S.error)
        end(&S);
    else
        mdlTerminate(&S);
}

int main(int argc, char **argv)
{
    static char two[8192], four[16384], three[16384];
    const char *model = argv[1], *map = argv[2];
    int delayed;

    if (argc != 5)
        return 2;
    snprintf(two, sizeof two, "%s;%s", model, model);
    snprintf(three, sizeof three, "%s;%s", two, model);
    snprintf(four, sizeof four, "%s;%s", two, two);
    for (delayed = 0; delayed < 2; delayed++) {
        is_the_bridge(model, 1, model, "", 2, delayed);
        is_the_bridge(two, 4, model, "", 2, delayed);
        is_the_bridge(four, 4, model, map, 3, delayed);
    }
    for (delayed = 0; delayed < 2; delayed++)
        is_the_bridge(argv[3], 1, argv[3], argv[4], 3, delayed);
    follows_the_setting(argv[3], argv[4]);
    refused("none.toml", "", 0.0, "none.toml");
    refused(three, "", 0.0, "one model file, two");
    refused(model, "no-map.toml", 0.0, "no-map.toml");
    refused(model, "", 3.0, "fourth parameter");
    return failures != 0;
}
