/* Compares a semi-active damper under a skyhook controller with the same damper at a constant setting. Quarter cars drive on a rough road:
 * one corner, or all four corners of a car in one batch call. The controller runs at 1 ms.
 *
 *   cc -O2 -I include examples/skyhook.c target/release/libdashpot.a -lm -o skyhook
 *   ./skyhook examples/semi_active.toml 1        quarter car
 *   ./skyhook examples/semi_active.toml 4        four corners, each at a setting of its own
 *
 * The controller requests the force of a dashpot between body and sky, as far as a damper can give it. It finds the setting by one step of
 * Newton's method with dashpot_d_force_d_setting(). The program prints the rms of the body's acceleration, in total and in frequency bands,
 * and of the tire's deflection. */
#include "dashpot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { CORNERS = 4, STEPS = 20000, BANDS = 3 };

static const double BODY = 400.0, WHEEL = 45.0, SPRING = 22e3, TIRE = 210e3; /* kg, N/m */
static const double STEP = 1e-3, SKY = 2200.0;                              /* s, N s/m */
static const double EDGE[BANDS + 1] = {0.5, 3.0, 8.0, 25.0};                /* Hz */

static dashpot_params params = DASHPOT_PARAMS_INIT;
static dashpot_model model;

struct corner {
    double body, body_rate, wheel, wheel_rate, road, setting;
    uint32_t seed;
};

struct result {
    double acceleration, tire, band[BANDS];
};

static void check(int32_t status)
{
    if (status < 0) {
        fprintf(stderr, "%s\n", dashpot_status_text(status));
        exit(EXIT_FAILURE);
    }
}

/* Returns the rate of the road's height, m/s: white noise, and a term that keeps the mean height at zero. It is an average road at 20 m/s,
 * with equal numbers on every platform. */
static double road_rate(struct corner *corner)
{
    corner->seed = corner->seed * 1664525u + 1013904223u;
    return ((double)(corner->seed >> 8) / 8388608.0 - 1.0) * 1.1 - 0.8 * corner->road;
}

/* Returns the setting at which the damper gives the skyhook force, from the force at the present setting. */
static double command(const dashpot_state *state, const struct corner *corner, const dashpot_setting *grid, double force)
{
    const double low = grid->grid[0], high = grid->grid[grid->count - 1], rate = corner->body_rate - corner->wheel_rate;
    dashpot_input at = dashpot_input_with_setting(dashpot_input_motion(corner->body - corner->wheel, rate), corner->setting);
    double gain, wanted = SKY * corner->body_rate, setting = low;

    check(dashpot_d_force_d_setting(&model, state, &at, STEP, &gain));
    /* A damper can give the requested force only if it dissipates energy. Otherwise it is as soft as possible. */
    if (wanted * rate > 0.0)
        setting = fabs(gain) > 1.0 ? corner->setting + (wanted - force) / gain : high;
    return setting < low ? low : setting > high ? high : setting;
}

/* Returns the mean square of the acceleration between two frequencies, Hz, by a discrete Fourier sum over the last 16.384 s. */
static double band(const double *acceleration, double from, double to)
{
    enum { LENGTH = 16384 };
    const double *last = acceleration + STEPS - LENGTH;
    double sum = 0.0;
    int line, i;

    for (line = (int)ceil(from * LENGTH * STEP); line < to * LENGTH * STEP; line++) {
        const double turn = 6.283185307179586 * line / LENGTH, real = cos(turn), imaginary = sin(turn);
        double c = 1.0, s = 0.0, a = 0.0, b = 0.0, next;

        for (i = 0; i < LENGTH; i++) {
            a += last[i] * c;
            b += last[i] * s;
            next = c * real - s * imaginary;
            s = c * imaginary + s * real;
            c = next;
        }
        sum += 2.0 * (a * a + b * b) / ((double)LENGTH * LENGTH);
    }
    return sum;
}

/* Drives all corners over the road, with the controller if `controlled`, else at the setting `constant`. */
static void drive(int corners, int controlled, double constant, const dashpot_setting *grid, struct result result[CORNERS])
{
    static double acceleration[CORNERS][STEPS];
    const dashpot_model *models[CORNERS] = {&model, &model, &model, &model};
    struct corner corner[CORNERS] = {{0}};
    dashpot_state states[CORNERS];
    dashpot_input inputs[CORNERS];
    dashpot_output outputs[CORNERS];
    double rest[CORNERS];
    int c, i, k;

    for (c = 0; c < corners; c++) {
        inputs[c] = dashpot_input_with_setting(dashpot_input_motion(0.0, 0.0), constant);
        check(dashpot_state_init_motion(&model, &inputs[c], &states[c]));
        corner[c].seed = 1u + (uint32_t)c;
        corner[c].setting = constant;
        result[c].acceleration = result[c].tire = 0.0;
    }
    check(dashpot_step_batch((uint32_t)corners, models, states, inputs, 0.0, states, outputs));
    for (c = 0; c < corners; c++)
        rest[c] = outputs[c].force;
    for (i = 0; i < STEPS; i++) {
        for (c = 0; c < corners; c++) {
            struct corner *at = &corner[c];
            double spring = -SPRING * (at->body - at->wheel), damper = outputs[c].force - rest[c];
            double tire = -TIRE * (at->wheel - at->road);

            acceleration[c][i] = (spring - damper) / BODY;
            result[c].acceleration += acceleration[c][i] * acceleration[c][i] / STEPS;
            result[c].tire += (tire / TIRE) * (tire / TIRE) / STEPS;
            at->body_rate += STEP * acceleration[c][i];
            at->wheel_rate += STEP * (tire - spring + damper) / WHEEL;
            at->body += STEP * at->body_rate;
            at->wheel += STEP * at->wheel_rate;
            at->road += STEP * road_rate(at);
            if (controlled)
                at->setting = command(&states[c], at, grid, outputs[c].force - rest[c]);
            inputs[c] = dashpot_input_with_setting(dashpot_input_motion(at->body - at->wheel, at->body_rate - at->wheel_rate), at->setting);
        }
        check(dashpot_step_batch((uint32_t)corners, models, states, inputs, STEP, states, outputs));
    }
    for (c = 0; c < corners; c++) {
        result[c].acceleration = sqrt(result[c].acceleration);
        result[c].tire = sqrt(result[c].tire);
        for (k = 0; k < BANDS; k++)
            result[c].band[k] = sqrt(band(acceleration[c], EDGE[k], EDGE[k + 1]));
    }
}

int main(int argc, char **argv)
{
    const int corners = argc > 2 && atoi(argv[2]) == CORNERS ? CORNERS : 1;
    static char text[1 << 16];
    static struct result result[CORNERS];
    dashpot_setting grid;
    dashpot_fault fault;
    FILE *file = fopen(argc > 1 ? argv[1] : "examples/semi_active.toml", "rb");
    int c, way;

    if (!file) {
        fprintf(stderr, "usage: skyhook MODEL.toml [1 or 4 corners]\n");
        return EXIT_FAILURE;
    }
    check(dashpot_params_read(&params, text, fread(text, 1, sizeof text, file), &fault));
    fclose(file);
    check(dashpot_model_init(&model, &params));
    grid.struct_size = sizeof grid;
    check(dashpot_params_setting(&params, &grid));
    if (grid.count == 0) {
        fprintf(stderr, "%s depends on no setting\n", argv[1]);
        return EXIT_FAILURE;
    }
    for (way = 0; way < 3; way++) {
        const double constant = way == 0 ? grid.grid[0] : grid.start;

        drive(corners, way == 2, constant, &grid, result);
        for (c = 0; c < corners; c++)
            printf("%-8s corner %d  acceleration %.4f m/s^2 (%.4f, %.4f, %.4f in 0.5-3, 3-8, 8-25 Hz)  tire %.4f mm\n",
                   way == 2 ? "skyhook" : way == 1 ? "start" : "soft", c + 1, result[c].acceleration, result[c].band[0],
                   result[c].band[1], result[c].band[2], 1e3 * result[c].tire);
    }
    return EXIT_SUCCESS;
}
