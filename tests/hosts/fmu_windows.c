/* Runs the co-simulation of a one-corner FMI 2.0 FMU on Windows. Arguments: library, GUID, trace of the bridge (lines of jounce,
 * rate, force), resources folder as the importer names it. Every force must be the bridge's bit for bit. */
#include "fmi2.h"
#include <stdio.h>
#include <windows.h>

typedef fmi2Component instantiate(fmi2String, fmi2Type, fmi2String, fmi2String, const fmi2CallbackFunctions *, fmi2Boolean,
                                  fmi2Boolean);
typedef fmi2Status simple(fmi2Component);
typedef fmi2Status setup(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, fmi2Boolean, fmi2Real);
typedef fmi2Status set(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Real[]);
typedef fmi2Status get(fmi2Component, const fmi2ValueReference[], size_t, fmi2Real[]);
typedef fmi2Status step(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean);

static void *look(HMODULE library, const char *name)
{
    void *found = (void *)GetProcAddress(library, name);

    if (!found) {
        fprintf(stderr, "no %s\n", name);
        ExitProcess(1);
    }
    return found;
}

int main(int argc, char **argv)
{
    const fmi2ValueReference inputs[2] = {1, 2}, force = 5;
    fmi2CallbackFunctions calls = {0};
    HMODULE library = argc == 5 ? LoadLibraryA(argv[1]) : NULL;
    FILE *trace = argc == 5 ? fopen(argv[3], "r") : NULL;
    fmi2Component damper;
    double row[3], got;
    int k;

    if (!library || !trace)
        return 2;
    damper = ((instantiate *)look(library, "fmi2Instantiate"))("w", fmi2CoSimulation, argv[2], argv[4], &calls, 0, 0);
    if (!damper)
        return 3;
    for (k = 0; fscanf(trace, "%lf %lf %lf", &row[0], &row[1], &row[2]) == 3; k++) {
        /* The motion of the bridge is positive in compression, that of this FMU in extension. */
        double u[2] = {-row[0], -row[1]};

        if (((set *)look(library, "fmi2SetReal"))(damper, inputs, 2, u) != fmi2OK)
            return 4;
        if (k == 0) {
            ((setup *)look(library, "fmi2SetupExperiment"))(damper, 0, 0.0, 0.0, 0, 0.0);
            if (((simple *)look(library, "fmi2EnterInitializationMode"))(damper) != fmi2OK ||
                ((simple *)look(library, "fmi2ExitInitializationMode"))(damper) != fmi2OK)
                return 5;
        } else if (((step *)look(library, "fmi2DoStep"))(damper, (k - 1) * 1e-3, 1e-3, 1) != fmi2OK) {
            return 6;
        }
        if (((get *)look(library, "fmi2GetReal"))(damper, &force, 1, &got) != fmi2OK || got != -row[2]) {
            fprintf(stderr, "step %d: %.17g, the bridge %.17g\n", k, got, -row[2]);
            return 7;
        }
    }
    ((simple *)look(library, "fmi2Terminate"))(damper);
    printf("%d steps\n", k);
    return k == 1001 ? 0 : 8;
}
