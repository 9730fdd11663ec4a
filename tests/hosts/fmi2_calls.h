/* Functions of FMI 2.0, for programs that are linked with the FMU runtime itself (damaged.c, ../fuzz/c/fmu.c). */
#ifndef FMI2_CALLS_H
#define FMI2_CALLS_H

#include "fmi2.h"

extern fmi2Component fmi2Instantiate(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *, fmi2Boolean,
                                     fmi2Boolean);
extern void fmi2FreeInstance(fmi2Component);
extern fmi2Status fmi2SetupExperiment(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real);
extern fmi2Status fmi2EnterInitializationMode(fmi2Component), fmi2ExitInitializationMode(fmi2Component);
extern fmi2Status fmi2GetReal(fmi2Component, const fmi2ValueReference[], size_t, fmi2Real[]);
extern fmi2Status fmi2SetReal(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Real[]);
extern fmi2Status fmi2DoStep(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean);
extern fmi2Status fmi2GetFMUstate(fmi2Component, fmi2FMUstate *), fmi2SetFMUstate(fmi2Component, fmi2FMUstate);
extern fmi2Status fmi2FreeFMUstate(fmi2Component, fmi2FMUstate *);
extern fmi2Status fmi2SerializedFMUstateSize(fmi2Component, fmi2FMUstate, size_t *);
extern fmi2Status fmi2SerializeFMUstate(fmi2Component, fmi2FMUstate, fmi2Byte[], size_t);
extern fmi2Status fmi2DeSerializeFMUstate(fmi2Component, const fmi2Byte[], size_t, fmi2FMUstate *);

#endif
