/* A damper from a model file, driven by velocities from standard input: one number a line, in m/s, at a fixed step.
 *
 *   cc -O2 -I include examples/damper.c -L target/release -ldashpot -Wl,-rpath,$PWD/target/release -o damper
 *   printf '0.1\n0.2\n0.1\n' | ./damper demo/damper.toml 0.001 -0.02
 *
 * Arguments: model file, step in s, initial position in m. Prints the force in N for every velocity. */
#include "dashpot.h"
#include <stdio.h>
#include <stdlib.h>

static char text[65536];
static dashpot_params params = DASHPOT_PARAMS_INIT;
static dashpot_model model;

static int refused(const char *what, int32_t status)
{
    fprintf(stderr, "%s: %s\n", what, dashpot_status_text(status));
    return EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    dashpot_state state;
    dashpot_fault fault;
    FILE *file;
    size_t length;
    double dt, velocity, force;
    int32_t status;

    if (argc != 4) {
        fprintf(stderr, "usage: %s MODEL STEP INITIAL_POSITION < velocities\n", argv[0]);
        return EXIT_FAILURE;
    }
    file = fopen(argv[1], "rb");
    if (!file) {
        perror(argv[1]);
        return EXIT_FAILURE;
    }
    length = fread(text, 1, sizeof text, file);
    fclose(file);

    status = dashpot_params_read(&params, text, length, &fault);
    if (status < 0) {
        fprintf(stderr, "%s, line %u: %s %s\n", argv[1], (unsigned)fault.line, fault.parameter,
                dashpot_status_text(status));
        return EXIT_FAILURE;
    }
    status = dashpot_model_init(&model, &params);
    if (status < 0)
        return refused(argv[1], status);
    dt = strtod(argv[2], NULL);
    status = dashpot_state_init(&model, strtod(argv[3], NULL), &state);
    if (status < 0)
        return refused("initial position", status);

    while (scanf("%lf", &velocity) == 1) {
        status = dashpot_force(&model, &state, velocity, dt, &force);
        if (status < 0)
            return refused("step", status);
        printf("%.17g\n", force);
    }
    return EXIT_SUCCESS;
}
