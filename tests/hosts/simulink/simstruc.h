/* The public calls of Simulink's S-function interface that the block uses, in our own declarations. The tests compile the block with them.
 * In Simulink they are macros that access its own structure. */
#ifndef SIMSTRUC_H
#define SIMSTRUC_H

#include <stddef.h>

typedef int int_T;
typedef double real_T;
typedef double time_T;
typedef struct mxArray mxArray;
typedef struct SimStruct SimStruct;
enum { SS_DOUBLE = 0, SS_UINT8 = 3 };
enum { USE_DEFAULT_SIM_STATE = 1 };

int mxGetString(const mxArray *array, char *text, size_t room);
int mxIsDouble(const mxArray *array);
size_t mxGetNumberOfElements(const mxArray *array);
double mxGetScalar(const mxArray *array);

int_T ssSetNumSFcnParams(SimStruct *S, int_T n);
int_T ssGetNumSFcnParams(SimStruct *S);
int_T ssGetSFcnParamsCount(SimStruct *S);
void ssSetSFcnParamTunable(SimStruct *S, int_T i, int_T tunable);
const mxArray *ssGetSFcnParam(SimStruct *S, int_T i);
int_T ssSetNumInputPorts(SimStruct *S, int_T n);
void ssSetInputPortWidth(SimStruct *S, int_T port, int_T width);
void ssSetInputPortRequiredContiguous(SimStruct *S, int_T port, int_T contiguous);
void ssSetInputPortDirectFeedThrough(SimStruct *S, int_T port, int_T through);
int_T ssSetNumOutputPorts(SimStruct *S, int_T n);
void ssSetOutputPortWidth(SimStruct *S, int_T port, int_T width);
void ssSetNumSampleTimes(SimStruct *S, int_T n);
void ssSetSampleTime(SimStruct *S, int_T i, time_T time);
void ssSetOffsetTime(SimStruct *S, int_T i, time_T time);
void ssSetNumPWork(SimStruct *S, int_T n);
void **ssGetPWork(SimStruct *S);
void *ssGetPWorkValue(SimStruct *S, int_T i);
void *ssSetPWorkValue(SimStruct *S, int_T i, void *value);
int_T ssSetNumDWork(SimStruct *S, int_T n);
void ssSetDWorkWidth(SimStruct *S, int_T i, int_T width);
void ssSetDWorkDataType(SimStruct *S, int_T i, int_T type);
void *ssGetDWork(SimStruct *S, int_T i);
void ssSetSimStateCompliance(SimStruct *S, int_T compliance);
const real_T *ssGetInputPortRealSignal(SimStruct *S, int_T port);
real_T *ssGetOutputPortRealSignal(SimStruct *S, int_T port);
void ssSetErrorStatus(SimStruct *S, const char *text);

#endif
