/* Passes resources of an FMU and a damaged saved state to the readers of its runtime (vi-crt-bridge/fmu). An instance is made or rejected,
 * and an instance that was made runs. The input is contents.txt, a zero, the model.toml of every corner, a zero, and the damage to a saved
 * state. Each damage has three bytes: a position of two bytes, low byte first, and the new value. */
#include "../../hosts/fmi2_calls.h"
#include "resources.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Texts of the FMU's resources, which replace its folder (resources.c is not linked). */
static const char *contents, *model;

char *resource(const char *folder, const char *name, char *why, size_t room)
{
    const char *text = strcmp(name, "contents.txt") ? model : contents;
    char *copy = malloc(strlen(text) + 1);

    (void)folder;
    if (!copy)
        snprintf(why, room, "no memory");
    return copy ? strcpy(copy, text) : NULL;
}

/* Number of value references that are read and set, from 0 on. */
enum { VARIABLES = 200 };

static void look(fmi2Component damper, int set)
{
    fmi2ValueReference v;
    double value;

    for (v = 0; v < VARIABLES; v++)
        if (fmi2GetReal(damper, &v, 1, &value) == fmi2OK && set)
            fmi2SetReal(damper, &v, 1, &value);
}

static void save_and_restore(fmi2Component damper, const uint8_t *damage, size_t pairs)
{
    fmi2FMUstate kept = NULL, read = NULL;
    fmi2Byte *bytes;
    size_t size = 0, k;

    if (fmi2GetFMUstate(damper, &kept) != fmi2OK)
        return;
    if (fmi2SerializedFMUstateSize(damper, kept, &size) == fmi2OK && size && (bytes = malloc(size))) {
        fmi2SerializeFMUstate(damper, kept, bytes, size);
        for (k = 0; k + 2 < pairs; k += 3)
            bytes[(damage[k] + 256u * damage[k + 1]) % size] = (fmi2Byte)damage[k + 2];
        if (pairs % 3 == 1)
            size -= damage[pairs - 1] % size;
        if (fmi2DeSerializeFMUstate(damper, bytes, size, &read) == fmi2OK)
            fmi2SetFMUstate(damper, read);
        free(bytes);
        if (read)
            fmi2FreeFMUstate(damper, &read);
    }
    fmi2FreeFMUstate(damper, &kept);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const fmi2ValueReference moved[2] = {1, 2};
    static const double motion[2] = {0.01, 0.2};
    fmi2CallbackFunctions calls = {0};
    fmi2Component damper;
    char *text = malloc(size + 3);
    size_t first, second;
    int k, type;

    if (!text)
        return 0;
    memcpy(text, data, size);
    memset(text + size, 0, 3);
    first = strlen(text) + 1;
    second = first + strlen(text + first) + 1;
    contents = text;
    model = text + first;
    for (type = fmi2ModelExchange; type <= fmi2CoSimulation; type++) {
        damper = fmi2Instantiate("d", (fmi2Type)type, "g", "", &calls, 0, 0);
        if (!damper)
            continue;
        fmi2SetupExperiment(damper, 0, 0.0, 0.0, 0, 0.0);
        look(damper, 1);
        fmi2SetReal(damper, moved, 2, motion);
        fmi2EnterInitializationMode(damper);
        fmi2ExitInitializationMode(damper);
        for (k = 0; k < 3; k++)
            fmi2DoStep(damper, 1e-3 * k, 1e-3, 1);
        save_and_restore(damper, (const uint8_t *)text + (second < size ? second : size), second < size ? size - second : 0);
        look(damper, 0);
        fmi2DoStep(damper, 3e-3, 1e-3, 1);
        fmi2FreeInstance(damper);
    }
    free(text);
    return 0;
}
