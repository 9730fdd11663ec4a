/* Your loop, our three calls: one wheel's sprung mass on a spring and a damper from a model file, driven by a road, in the three loops
 * that host programs have. your-loop.md explains them.
 *
 *   cc -O2 -I include examples/your_loop.c -L target/release -ldashpot -Wl,-rpath,$PWD/target/release -lm -o your_loop
 *   ./your_loop demo/damper.toml implicit 0.001
 *
 * Arguments: model file, explicit, trial or implicit, step in s. Prints time (s), body position (m) and damper force (N) every 10 ms. */
#include "dashpot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double MASS = 380.0, STIFFNESS = 24000.0; /* kg; N/m */
static const double END = 2.0;                         /* s */

static dashpot_params params = DASHPOT_PARAMS_INIT;
static dashpot_model model;

/* Body position, m, relative to its equilibrium, and velocity, m/s, upward positive. The damper is between body and wheel, so it extends if
 * the body rises. */
struct body {
    double position, velocity;
};

static double road(double t)
{
    return 0.01 * (1.0 - cos(9.0 * t));
}

static double road_rate(double t)
{
    return 0.09 * sin(9.0 * t);
}

static void check(int32_t status)
{
    if (status < 0) {
        fprintf(stderr, "%s\n", dashpot_status_text(status));
        exit(EXIT_FAILURE);
    }
}

static dashpot_input motion(const struct body *body, double t)
{
    return dashpot_input_motion(body->position - road(t), body->velocity - road_rate(t));
}

/* Returns the acceleration of the body, m/s^2. Tension pulls the body down. `rest` is the damper's static force, N, which the spring's
 * preload balances. */
static double acceleration(const struct body *body, double t, double force, double rest)
{
    return (-STIFFNESS * (body->position - road(t)) - (force - rest)) / MASS;
}

/* 1. The host advances the body with the force of the last step, and then computes the next force: one call per step, on one state. */
static double explicit_step(struct body *body, dashpot_state *state, double t, double dt, double force, double rest)
{
    dashpot_output output;
    dashpot_input input;

    body->velocity += dt * acceleration(body, t, force, rest);
    body->position += dt * body->velocity;
    input = motion(body, t + dt);
    check(dashpot_step(&model, state, &input, dt, state, &output));
    return output.force;
}

/* 2. The host tries a step, and commits it or tries a shorter one. Trials start at the committed state and write to another state, so that
 * any number of them is possible. A commit is an assignment. */
static double trial_step(struct body *body, dashpot_state *state, double t, double dt, double force, double rest)
{
    double done = 0.0, h = dt;

    while (done < dt - 1e-12) {
        struct body tried = *body;
        dashpot_state reached;
        dashpot_output output;
        dashpot_input input;

        if (h > dt - done)
            h = dt - done;
        tried.velocity += h * acceleration(body, t + done, force, rest);
        tried.position += h * tried.velocity;
        input = motion(&tried, t + done + h);
        check(dashpot_step(&model, state, &input, h, &reached, &output));
        if (fabs(output.force - force) > 1.0 && h > dt / 16) {
            h /= 2;
            continue;
        }
        *body = tried;
        *state = reached;
        force = output.force;
        done += h;
        h *= 2;
    }
    return force;
}

/* 3. The host solves for the velocity at the end of the step with the force at this time. It uses Newton's method with the damper's
 * derivatives. */
static double implicit_step(struct body *body, dashpot_state *state, double t, double dt, double rest)
{
    struct body next = *body;
    dashpot_state reached;
    dashpot_output output;
    int k;

    for (k = 0; k < 20; k++) {
        dashpot_input input;
        double off, slope;

        next.position = body->position + dt * next.velocity;
        input = motion(&next, t + dt);
        check(dashpot_step(&model, state, &input, dt, &reached, &output));
        off = next.velocity - body->velocity - dt * acceleration(&next, t + dt, output.force, rest);
        slope = 1.0 + dt / MASS * (output.d_force_d_velocity + dt * (output.d_force_d_displacement + STIFFNESS));
        if (fabs(off) < 1e-10)
            break;
        next.velocity -= off / slope;
    }
    *body = next;
    *state = reached;
    return output.force;
}

int main(int argc, char **argv)
{
    static char text[1 << 20];
    struct body body = {0.0, 0.0};
    dashpot_state state;
    dashpot_output output;
    dashpot_input still = dashpot_input_motion(0.0, 0.0);
    double dt = argc == 4 ? strtod(argv[3], NULL) : 0.0, force, rest;
    FILE *file = argc == 4 ? fopen(argv[1], "rb") : NULL;
    long k, steps, every;

    if (!file || !(dt > 0.0 && dt <= 0.01)) {
        fprintf(stderr, "usage: %s MODEL explicit|trial|implicit STEP\n", argv[0]);
        return EXIT_FAILURE;
    }
    check(dashpot_params_read(&params, text, fread(text, 1, sizeof text, file), NULL));
    fclose(file);
    check(dashpot_model_init(&model, &params));
    check(dashpot_state_init(&model, 0.0, &state));
    /* A step with dt = 0 gives the static force. */
    check(dashpot_step(&model, &state, &still, 0.0, &state, &output));
    rest = force = output.force;
    steps = (long)(END / dt + 0.5);
    every = (long)(0.01 / dt + 0.5);
    for (k = 0; k < steps; k++) {
        double t = (double)k * dt;

        if (!strcmp(argv[2], "explicit"))
            force = explicit_step(&body, &state, t, dt, force, rest);
        else if (!strcmp(argv[2], "trial"))
            force = trial_step(&body, &state, t, dt, force, rest);
        else
            force = implicit_step(&body, &state, t, dt, rest);
        if ((k + 1) % every == 0)
            printf("%.2f %.9g %.9g\n", t + dt, body.position, force);
    }
    return EXIT_SUCCESS;
}
