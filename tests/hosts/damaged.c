/* Passes damaged files to the readers in C, compiled with memory checks (-fsanitize=address,undefined). Arguments: number of damaged files;
 * "map" and a channel map, or "fmu", the resources folder of a one-corner FMU and its GUID. Accepted files are also used. */
#include "channel_map.h"
#include "fmi2_calls.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state = 5;

/* Returns a random number from 0 to below n (xorshift64*, Vigna 2016). */
static size_t below(size_t n)
{
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return n ? (size_t)((state * 0x2545f4914f6cdd1du) >> 33) % n : 0;
}

static char *file(const char *path)
{
    FILE *from = fopen(path, "rb");
    char *text = calloc(1, 1 << 20);

    if (!from || !text || fread(text, 1, (1 << 20) - 1, from) == 0) {
        fprintf(stderr, "%s cannot be read\n", path);
        exit(3);
    }
    fclose(from);
    return text;
}

static size_t is_part(char c)
{
    return c && !strchr(" \t\r\n,=[]\"", c);
}

/* Returns a damaged copy in a block of its own size, so that access beyond the text leaves the block. *length becomes the length of the
 * text. */
static char *damaged(const char *text, size_t *length)
{
    static const char *const POISON[] = {"0", "-1", "1", "2", "11", "255", "256", "99999", "4294967296", "-2147483648", "1e308", "nan",
                                         "\"", "{corner}", "=", "PARAMETER", "STATE", "RATE", "DISPLACEMENT", "TIME",
                                         "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"};
    char *out = calloc(1, 3 * strlen(text) + 4096);
    size_t edits = 1 + below(3), size;

    strcpy(out, text);
    while (edits--) {
        size_t at = below(size = strlen(out)), end, line;
        const char *poison = POISON[below(sizeof POISON / sizeof *POISON)];

        if (!size)
            break;
        switch (below(6)) {
        case 0: out[at] = (char)(1 + below(255)); break;
        case 1: out[at] = 0; break;
        case 2: /* a line twice */
            for (line = at; line && out[line - 1] != '\n'; line--)
                ;
            for (end = at; out[end] && out[end] != '\n'; end++)
                ;
            if (out[end] && size < 2 * strlen(text)) {
                memmove(out + end + 1 + (end + 1 - line), out + end + 1, size - end);
                memcpy(out + end + 1, out + line, end + 1 - line);
            }
            break;
        case 3: /* a line less */
            for (line = at; line && out[line - 1] != '\n'; line--)
                ;
            for (end = at; out[end] && out[end] != '\n'; end++)
                ;
            memmove(out + line, out + end, size - end + 1);
            break;
        default: /* another word */
            while (at && is_part(out[at - 1]))
                at--;
            for (end = at; is_part(out[end]); end++)
                ;
            memmove(out + at + strlen(poison), out + end, size - end + 1);
            memcpy(out + at, poison, strlen(poison));
        }
    }
    *length = strlen(out);
    return realloc(out, *length + 1);
}

static void write_file(const char *folder, const char *name, const char *text)
{
    char path[4096];
    FILE *to;

    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (!(to = fopen(path, "wb")) || fwrite(text, 1, strlen(text), to) != strlen(text) || fclose(to))
        exit(4);
}

static int map(const char *text, size_t length)
{
    dashpot_channel_map found;
    dashpot_channel_map_fault fault;
    char *bytes = malloc(length ? length : 1), name[300];
    int answer, channel;

    /* The block has no closing zero, so that the reader must respect the length. */
    memcpy(bytes, text, length);
    dashpot_channel_map_default(&found);
    answer = dashpot_channel_map_read(&found, bytes, length, &fault);
    for (channel = 0; channel < DASHPOT_CHANNELS; channel++)
        dashpot_channel_map_name(&found, (enum dashpot_channel)channel, below(4), name, below(sizeof name));
    if (answer && !memchr(fault.text, 0, sizeof fault.text))
        exit(5);
    free(bytes);
    return !answer;
}

static int fmu(const char *folder, const char *guid)
{
    static const fmi2ValueReference moved[2] = {1, 2};
    const double motion[2] = {0.01, 0.2};
    fmi2CallbackFunctions calls = {0};
    fmi2Type type = below(2) ? fmi2CoSimulation : fmi2ModelExchange;
    fmi2Component damper = fmi2Instantiate("d", type, guid, folder, &calls, 0, 0);
    fmi2FMUstate kept = NULL, read = NULL;
    fmi2ValueReference v;
    fmi2Byte *bytes;
    size_t size = 0;
    double value;
    int k;

    if (!damper)
        return 0;
    fmi2SetupExperiment(damper, 0, 0.0, 0.0, 0, 0.0);
    for (v = 0; v < 120; v++)
        if (fmi2GetReal(damper, &v, 1, &value) == fmi2OK && below(4) == 0)
            fmi2SetReal(damper, &v, 1, &value);
    fmi2SetReal(damper, moved, 2, motion);
    fmi2EnterInitializationMode(damper);
    fmi2ExitInitializationMode(damper);
    for (k = 0; k < 3; k++)
        fmi2DoStep(damper, 1e-3 * k, 1e-3, 1);
    if (fmi2GetFMUstate(damper, &kept) == fmi2OK && fmi2SerializedFMUstateSize(damper, kept, &size) == fmi2OK) {
        bytes = malloc(size);
        fmi2SerializeFMUstate(damper, kept, bytes, size);
        /* Damage the first 200 bytes of the saved state, which contain the counts, in half of the cases. */
        if (below(2))
            bytes[below(size < 200 ? size : 200)] ^= (fmi2Byte)(1 << below(7));
        if (fmi2DeSerializeFMUstate(damper, bytes, size, &read) == fmi2OK)
            fmi2SetFMUstate(damper, read);
        free(bytes);
        fmi2FreeFMUstate(damper, &read);
    }
    if (kept)
        fmi2FreeFMUstate(damper, &kept);
    for (v = 0; v < 120; v++)
        fmi2GetReal(damper, &v, 1, &value);
    fmi2DoStep(damper, 3e-3, 1e-3, 1);
    fmi2FreeInstance(damper);
    return 1;
}

int main(int argc, char **argv)
{
    long rounds = argc > 3 ? atol(argv[1]) : 0, taken = 0, k;
    int is_map = rounds && !strcmp(argv[2], "map");
    char path[4096], *seed, *model = NULL;
    size_t length;

    if (!rounds || (!is_map && argc < 5))
        return 2;
    snprintf(path, sizeof path, is_map ? "%s" : "%s/contents.txt", argv[3]);
    seed = file(path);
    if (!is_map) {
        snprintf(path, sizeof path, "%s/model.toml", argv[3]);
        model = file(path);
    }
    if (!(is_map ? map(seed, strlen(seed)) : fmu(argv[3], argv[4])))
        return 6; /* the undamaged file must be accepted */
    if (!is_map) {
        /* A case that the fuzzer found: a second line `corners` with fewer corners than the variables before it use. */
        char *twice = malloc(strlen(seed) + 16);

        strcat(strcpy(twice, seed), "corners 1\n");
        write_file(argv[3], "contents.txt", twice);
        free(twice);
        if (fmu(argv[3], argv[4]))
            return 8;
    }
    for (k = 0; k < rounds; k++) {
        char *text = damaged(k % 4 == 3 && model ? model : seed, &length);

        if (is_map) {
            taken += map(text, length);
        } else {
            write_file(argv[3], "contents.txt", k % 4 == 3 ? seed : text);
            write_file(argv[3], "model.toml", k % 4 == 3 ? text : model);
            taken += fmu(argv[3], argv[4]);
        }
        free(text);
    }
    free(seed);
    free(model);
    printf("%ld damaged, %ld taken\n", rounds, taken);
    return taken > 0 && taken < rounds ? 0 : 7;
}
