/* The bridge as a host uses it. Arguments: model file, channel map. The third argument, 1 or 4, selects a run with so many corners. It
 * prints their motion and forces, for comparison with other hosts of the kernel. Without this argument the program checks the bridge and
 * prints only failures. */
#include "check.h"
#include "dashpot_bridge.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TAU 6.283185307179586476925286766559
#define DT 1e-3

static const char *files[4];

static dashpot_bridge *made(uint32_t corners, const char *map)
{
    dashpot_bridge_fault fault;
    dashpot_bridge *bridge = dashpot_bridge_create(corners, files, map, &fault);

    if (!bridge) {
        fprintf(stderr, "%s\n", fault.text);
        exit(1);
    }
    return bridge;
}

/* Returns the motion of corner i at time t, compression positive, m and m/s. */
static dashpot_corner_input motion(uint32_t i, double t)
{
    dashpot_corner_input in = {0};
    double w = TAU * (1.0 + 2.5 * i);

    in.jounce = 0.015 * sin(w * t) - 0.003 * i;
    in.jounce_rate = 0.015 * w * cos(w * t);
    in.known = DASHPOT_CORNER_KNOWS_JOUNCE;
    return in;
}

static void motions(double t, dashpot_corner_input *in)
{
    uint32_t i;
    for (i = 0; i < 4; i++)
        in[i] = motion(i, t);
}

static int same(const void *a, const void *b, size_t n)
{
    return memcmp(a, b, n) == 0;
}

/* Checks that a bridge with four corners equals four kernels bit for bit, apart from the signs of a host without a channel map. */
static void agrees_with_the_kernel(void)
{
    dashpot_bridge *car = made(4, NULL);
    static dashpot_corner kernel[4];
    dashpot_corner_input in[4];
    dashpot_corner_output out[4];
    dashpot_fault fault;
    uint32_t i, k;

    motions(0.0, in);
    CHECK(dashpot_bridge_init(car, in, out) == 0);
    for (i = 0; i < 4; i++) {
        CHECK(dashpot_corner_load(&kernel[i], files[i], &fault) == 0);
        CHECK(dashpot_corner_rest(&kernel[i], -in[i].jounce) == 0);
    }
    for (k = 1; k <= 1000; k++) {
        motions(k * DT, in);
        CHECK((dashpot_bridge_step(car, DT, in, out) & DASHPOT_BRIDGE_LAST_FORCE) == 0);
        for (i = 0; i < 4; i++) {
            dashpot_input input = dashpot_input_motion(-in[i].jounce, -in[i].jounce_rate);
            dashpot_output o;
            double force;

            CHECK(dashpot_step(&kernel[i].model, &kernel[i].now.state, &input, DT, &kernel[i].now.state, &o) >= 0);
            force = -o.force;
            CHECK(same(&force, &out[i].force, sizeof force));
            CHECK(out[i].d_force_d_rate == o.d_force_d_velocity && out[i].d_force_d_jounce == o.d_force_d_displacement);
        }
    }
    dashpot_bridge_destroy(car);
}

static void saves_and_restores(void)
{
    dashpot_bridge *car = made(4, NULL);
    dashpot_bridge_state saved;
    dashpot_corner_input in[4];
    dashpot_corner_output first[4], again[4];
    int k;

    memset(first, 0, sizeof first);
    memset(again, 0, sizeof again);
    motions(0.0, in);
    dashpot_bridge_init(car, in, first);
    for (k = 1; k < 300; k++) {
        motions(k * DT, in);
        dashpot_bridge_step(car, DT, in, first);
    }
    dashpot_bridge_save(car, &saved);
    for (; k < 600; k++) {
        motions(k * DT, in);
        dashpot_bridge_step(car, DT, in, first);
    }
    dashpot_bridge_restore(car, &saved);
    for (k = 300; k < 600; k++) {
        motions(k * DT, in);
        dashpot_bridge_step(car, DT, in, again);
    }
    CHECK(same(first, again, sizeof first));
    dashpot_bridge_destroy(car);
}

static void holds_the_force_of_a_bad_input(void)
{
    const double bad[] = {NAN, INFINITY, -INFINITY, 1e30};
    dashpot_bridge *car = made(4, NULL);
    dashpot_bridge_state before, after;
    dashpot_corner_input in[4];
    dashpot_corner_output good[4], held[4];
    size_t b;
    int k;

    motions(0.0, in);
    dashpot_bridge_init(car, in, good);
    for (k = 1; k < 100; k++) {
        motions(k * DT, in);
        dashpot_bridge_step(car, DT, in, good);
    }
    for (b = 0; b < sizeof bad / sizeof *bad; b++) {
        double *const place[] = {&in[1].jounce, &in[1].jounce_rate};
        int p;
        for (p = 0; p < 2; p++) {
            motions(k * DT, in);
            *place[p] = bad[b];
            dashpot_bridge_save(car, &before);
            CHECK(dashpot_bridge_step(car, DT, in, held) & DASHPOT_BRIDGE_LAST_FORCE);
            dashpot_bridge_save(car, &after);
            /* The corner with the bad input keeps its state, and the others advance. */
            CHECK(same(&before.corner[1], &after.corner[1], sizeof before.corner[1]));
            CHECK(!same(&before.corner[0], &after.corner[0], sizeof before.corner[0]));
            CHECK(held[1].status == DASHPOT_BRIDGE_LAST_FORCE && held[0].status == 0);
            CHECK(held[1].force == good[1].force);
            dashpot_bridge_restore(car, &before);
        }
    }
    CHECK(dashpot_bridge_step(car, NAN, in, held) & DASHPOT_BRIDGE_LAST_FORCE);
    CHECK(dashpot_bridge_step(car, -1e-3, in, held) & DASHPOT_BRIDGE_LAST_FORCE);
    dashpot_bridge_destroy(car);
}

static void answers_statically_at_dt_zero(void)
{
    dashpot_bridge *car = made(4, NULL);
    dashpot_bridge_state before, after;
    dashpot_corner_input in[4];
    dashpot_corner_output rest[4], held[4];
    int i;

    motions(0.1, in);
    dashpot_bridge_init(car, in, rest);
    dashpot_bridge_save(car, &before);
    for (i = 0; i < 4; i++)
        in[i].jounce_rate = 0.0;
    CHECK(dashpot_bridge_step(car, 0.0, in, held) == 0);
    dashpot_bridge_save(car, &after);
    for (i = 0; i < 4; i++) {
        CHECK(same(&before.corner[i].state, &after.corner[i].state, sizeof before.corner[i].state));
        CHECK(held[i].force == rest[i].force);
        in[i].jounce_rate = 0.3;
    }
    dashpot_bridge_step(car, 0.0, in, held);
    for (i = 0; i < 4; i++)
        CHECK(held[i].force > rest[i].force);
    dashpot_bridge_destroy(car);
}

/* Checks that flat vectors with the channels of the map give the same forces as structures. */
static void vectors_are_the_same_run(const char *map)
{
    dashpot_bridge *car = made(4, map), *twin = made(4, map);
    dashpot_corner_input in[4];
    dashpot_corner_output out[4];
    double u[20], y[4];
    uint32_t n = dashpot_bridge_input_count(car), i;
    int k;

    CHECK(n == 12 && dashpot_bridge_output_count(car) == 4);
    CHECK(!strcmp(dashpot_bridge_input_name(car, 0), "Damper.Jounce.L1"));
    CHECK(!strcmp(dashpot_bridge_input_name(car, 4), "Damper.Jounce_Rate.R1"));
    CHECK(!strcmp(dashpot_bridge_input_name(car, 11), "Damper.Jounce_Acceleration.R2"));
    CHECK(!strcmp(dashpot_bridge_output_name(car, 2), "My.Damper_Force.L2"));
    CHECK(!dashpot_bridge_input_name(car, n) && !dashpot_bridge_output_name(car, 4));
    for (k = 0; k <= 300; k++) {
        motions(k * DT, in);
        for (i = 0; i < 4; i++) {
            u[3 * i] = in[i].jounce;
            u[3 * i + 1] = in[i].jounce_rate;
            u[3 * i + 2] = 0.0;
        }
        CHECK(dashpot_bridge_step_vector(car, DT, u, n - 1, y, 4) == DASHPOT_BRIDGE_LAST_FORCE);
        if (k == 0) {
            dashpot_bridge_init(twin, in, out);
            dashpot_bridge_init_vector(car, u, n, y, 4);
        } else {
            dashpot_bridge_step(twin, DT, in, out);
            dashpot_bridge_step_vector(car, DT, u, n, y, 4);
        }
        for (i = 0; i < 4; i++)
            CHECK(y[i] == out[i].force);
    }
    dashpot_bridge_destroy(car);
    dashpot_bridge_destroy(twin);
}

/* Checks that the self-test detects a map whose signs are not those of the host. */
static void the_self_test_tells_wrong_signs(const char *map)
{
    dashpot_bridge *car = made(4, map);
    dashpot_bridge_state before, after;
    dashpot_self_test result[4];
    int push, compresses, i;

    dashpot_bridge_save(car, &before);
    for (push = 0; push < 2; push++)
        for (compresses = 0; compresses < 2; compresses++) {
            int passes = dashpot_bridge_self_test(car, push, compresses, 1.0, 1.0, result);
            /* In the map, motion and force are positive in compression. */
            CHECK(passes == (push == compresses));
            for (i = 0; i < 4; i++) {
                CHECK((int)result[i].dissipates == passes);
                CHECK((result[i].energy > 0.0) == (push == compresses) && fabs(result[i].energy) > 1.0);
                CHECK(result[i].sign_at_jounce == 1 && result[i].peak_force > 10.0);
            }
        }
    dashpot_bridge_save(car, &after);
    CHECK(same(&before, &after, sizeof before));
    dashpot_bridge_destroy(car);
}

/* Iterates v[k+1] = v[k] - a v[k - delay] 400 times. Returns the last |v|, and counts the changes of sign. */
static double ringing(double a, int delay, int *crossings)
{
    double v[2] = {1.0, 1.0};
    int k;
    *crossings = 0;
    for (k = 0; k < 400; k++) {
        double next = v[1] - a * v[1 - delay];
        *crossings += next * v[1] < 0.0;
        v[0] = v[1];
        v[1] = next;
    }
    return fabs(v[1]);
}

static void coupling_limits_are_where_they_are_said(void)
{
    const double near[] = {0.05, 0.24, 0.3, 0.95, 1.05, 1.9, 2.1};
    const int expected[] = {0, 0, 1, 1, 2, 2, 3};
    size_t i;

    for (i = 0; i < sizeof near / sizeof *near; i++) {
        double ratio, plain, delayed;
        int plain_crossings, delayed_crossings;
        dashpot_coupling c = dashpot_bridge_coupling(-near[i] * 40.0 / DT, 40.0, DT, &ratio);

        CHECK((int)c == expected[i] && fabs(ratio - near[i]) < 1e-12);
        plain = ringing(near[i], 0, &plain_crossings);
        delayed = ringing(near[i], 1, &delayed_crossings);
        CHECK((c == DASHPOT_COUPLING_CALM) == (delayed_crossings == 0));
        CHECK((c <= DASHPOT_COUPLING_DELAY_RINGS) == (delayed < 1e-3));
        CHECK((c <= DASHPOT_COUPLING_RINGS) == (plain < 1e-3));
    }
    CHECK(dashpot_bridge_coupling(1e4, 0.0, DT, NULL) == DASHPOT_COUPLING_UNSTABLE);
    CHECK(dashpot_bridge_coupling(NAN, 40.0, DT, NULL) == DASHPOT_COUPLING_UNSTABLE);
}

static void the_steepest_slope_bounds_a_run(void)
{
    dashpot_bridge *car = made(1, NULL);
    dashpot_corner_input in;
    dashpot_corner_output out;
    double steepest = dashpot_bridge_max_derivative(car, 0, DT), seen = 0.0;
    int k;

    in = motion(0, 0.0);
    dashpot_bridge_init(car, &in, &out);
    for (k = 1; k < 2000; k++) {
        in = motion(0, k * DT);
        dashpot_bridge_step(car, DT, &in, &out);
        seen = fmax(seen, fabs(out.d_force_d_rate + DT * out.d_force_d_jounce));
    }
    CHECK(seen > 0.0 && steepest > 0.7 * seen);
    dashpot_bridge_destroy(car);
}

static void refuses_bad_files(const char *map)
{
    dashpot_bridge_fault fault;
    const char *missing[4] = {"no-such-model.toml", files[0], files[0], files[0]};
    const char *wrong[4] = {map, map, map, map};

    CHECK(!dashpot_bridge_create(2, files, NULL, &fault) && strstr(fault.text, "1 or 4"));
    CHECK(!dashpot_bridge_create(4, missing, NULL, &fault) && strstr(fault.text, "no-such-model.toml"));
    CHECK(!dashpot_bridge_create(4, wrong, NULL, &fault) && strstr(fault.text, "line"));
    CHECK(!dashpot_bridge_create(4, files, "no-such-map.toml", &fault) && strstr(fault.text, "no-such-map.toml"));
    CHECK(!dashpot_bridge_create(4, files, files[0], &fault) && strstr(fault.text, "line"));
}

static void maps_are_read_strictly(void)
{
    static const struct {
        const char *text, *says;
        uint32_t line;
    } bad[] = {
        {"", "format", 0},
        {"format = 1\nmotion_positive = \"up\"", "motion_positive", 0},
        {"format = 1\njunk", "name = value", 2},
        {"format = 1\ncolour = \"red\"", "no such name", 2},
        {"format = 1\nformat = 1", "twice", 2},
        {"format = 1\nmotion_ratio_1 = 1,5", "number", 2},
        {"format = 1\nforce = My", "quotes", 2},
        {"format = 1\nmotion_positive = \"compression\"\nforce_positive = \"tension\"\njounce_rate = \"r.{corner}\"",
         "force must name", 0},
        {"format = 1\nmotion_positive = \"compression\"\nforce_positive = \"tension\"\njounce_rate = \"r\"\nforce=\"f{corner}\"",
         "{corner}", 0},
        {"format = 1\nmotion_positive = \"compression\"\nforce_positive = \"tension\"\njounce_rate = \"r{corner}\"\nforce=\"f{corner}\"\nmotion_ratio_2 = -1",
         "motion_ratio_2", 0},
    };
    const char *good = "# a host in mm and kN at the wheel\r\nformat = 1\r\nmotion_positive = \"extension\" # says \"#\"\n"
                       "force_positive=\"tension\"\nlength_unit = \"mm\"\nforce_unit = \"kN\"\nmotion_ratio_1 = 8.0e-1\nmotion_ratio_R2=0.7\n"
                       "jounce_rate = \"rate#{corner}\"\nforce = \"force_{corner}_in\"\n";
    dashpot_channel_map map, untouched;
    dashpot_channel_map_fault fault;
    char name[40];
    size_t i;

    dashpot_channel_map_default(&map);
    untouched = map;
    for (i = 0; i < sizeof bad / sizeof *bad; i++) {
        CHECK(dashpot_channel_map_read(&map, bad[i].text, strlen(bad[i].text), &fault) == -1);
        if (!strstr(fault.text, bad[i].says) || fault.line != bad[i].line) {
            fprintf(stderr, "map %d: line %u: %s\n", (int)i, (unsigned)fault.line, fault.text);
            exit(1);
        }
        CHECK(same(&map, &untouched, sizeof map));
    }
    CHECK(dashpot_channel_map_read(&map, good, strlen(good), &fault) == 0);
    for (i = 0; i < 4; i++) {
        /* Ratio of axle 1, ratio 1 of axle 2, which has none, and the ratio of one corner. */
        const double ratio[4] = {0.8, 0.8, 1.0, 0.7};
        CHECK(map.motion_scale[i] == 1e-3 * ratio[i] && map.force_scale[i] == 1e-3 * ratio[i]);
    }
    CHECK(!dashpot_channel_map_name(&map, DASHPOT_CHANNEL_FORCE, 2, name, sizeof name));
    CHECK(!strcmp(name, "force_L2_in"));
    CHECK(dashpot_channel_map_name(&map, DASHPOT_CHANNEL_FORCE, 2, name, 5) == -1);
    CHECK(dashpot_channel_map_name(&map, DASHPOT_CHANNEL_JOUNCE, 2, name, sizeof name) == -1);
}

/* Prints jounce, jounce rate and force of every corner, one line per step, for the tests of the FMU. */
static void trace(uint32_t corners)
{
    dashpot_bridge *car = made(corners, NULL);
    dashpot_corner_input in[4];
    dashpot_corner_output out[4];
    uint32_t i, k;

    motions(0.0, in);
    dashpot_bridge_init(car, in, out);
    for (k = 0; k <= 1000; k++) {
        if (k) {
            motions(k * DT, in);
            dashpot_bridge_step(car, DT, in, out);
        }
        for (i = 0; i < corners; i++)
            printf("%s%.17g %.17g %.17g", i ? " " : "", in[i].jounce, in[i].jounce_rate, out[i].force);
        printf("\n");
    }
    dashpot_bridge_destroy(car);
}

int main(int argc, char **argv)
{
    int i;

    if (argc < 3)
        return 2;
    for (i = 0; i < 4; i++)
        files[i] = argv[1];
    if (argc > 3) {
        trace(argv[3][0] == '1' ? 1 : 4);
        return 0;
    }
    agrees_with_the_kernel();
    saves_and_restores();
    holds_the_force_of_a_bad_input();
    answers_statically_at_dt_zero();
    vectors_are_the_same_run(argv[2]);
    the_self_test_tells_wrong_signs(argv[2]);
    coupling_limits_are_where_they_are_said();
    the_steepest_slope_bounds_a_run();
    refuses_bad_files(argv[2]);
    maps_are_read_strictly();
    return failures != 0;
}
