/* Calls the CarSim shim as the solver does, in mm and N. Arguments: model file, channel map [, channel map that also
 * names a variable for the setting]. */
#include "check.h"
#include "corner.h"
#include "vs_declarations.h"
#include <math.h>
#include <string.h>

int dashpot_vs_install(const char *front, const char *rear, const char *map);
void dashpot_vs_end(void);

static void (*call)(vs_real, vs_ext_loc);
enum { NAMES = 16, FIRST_SETTING = 12 };
static const char *const names[NAMES] = {"CMPD_L1", "CMPRD_L1", "CMPD_R1", "CMPRD_R1", "CMPD_L2",   "CMPRD_L2",
                                         "CMPD_R2", "CMPRD_R2", "IMP_FD_L1", "IMP_FD_R1", "IMP_FD_L2", "IMP_FD_R2",
                                         "CURRENT_L1", "CURRENT_R1", "CURRENT_L2", "CURRENT_R2"};
static vs_real values[NAMES];
static int imports, errors;

void (*vs_install_calc_function)(void (*)(vs_real, vs_ext_loc));
vs_real *(*vs_get_var_ptr)(char *);
int (*vs_statement)(const char *, const char *, int);
void (*vs_printf_error)(const char *, ...);
void (*vs_set_stop_run)(vs_real, const char *, ...);
static int stops, hidden;

static void install(void (*calculate)(vs_real, vs_ext_loc))
{
    call = calculate;
}

static vs_real *variable(char *name)
{
    int i;
    for (i = 0; i < NAMES; i++)
        if (!(hidden && i == FIRST_SETTING - 1) && !strcmp(names[i], name))
            return &values[i];
    return NULL;
}

static int statement(const char *keyword, const char *line, int stop)
{
    CHECK(!strcmp(keyword, "IMPORT") && !strncmp(line, "IMP_FD_", 7) && strstr(line, " vs_replace") && stop == 1);
    imports++;
    return 0;
}

static void error(const char *format, ...)
{
    (void)format;
    errors++;
}

static void stop_run(vs_real now, const char *format, ...)
{
    (void)format;
    stops += now > 0.0;
}

static void get_api(void)
{
    vs_install_calc_function = install;
    vs_get_var_ptr = variable;
    vs_statement = statement;
    vs_printf_error = error;
    vs_set_stop_run = stop_run;
}

/* Checks each corner at its own setting, which is a variable of the solver. */
static void over_a_setting(const char *model, const char *map)
{
    static dashpot_corner kernel[4];
    dashpot_fault fault;
    int k, i;

    CHECK(dashpot_vs_install(model, model, map) == 0);
    memset(values, 0, sizeof values);
    for (i = 0; i < 4; i++) {
        values[FIRST_SETTING + i] = 0.4 * i;
        CHECK(dashpot_corner_load(&kernel[i], model, &fault) == 0);
        CHECK(dashpot_corner_rest_at(&kernel[i], 0.0, &values[FIRST_SETTING + i]) >= 0);
    }
    call(0.0, VS_EXT_AFTER_READ);
    call(0.0, VS_EXT_EQ_INIT);
    for (k = 1; k <= 500; k++) {
        double t = k * 1e-3, w = 12.566370614359172;

        for (i = 0; i < 4; i++) {
            values[2 * i] = 20.0 * sin(w * t);
            values[2 * i + 1] = 20.0 * w * cos(w * t);
            values[FIRST_SETTING + i] = k < 250 ? 0.4 * i : 0.4 * (3 - i);
        }
        call(t, VS_EXT_EQ_IN);
        for (i = 0; i < 4; i++) {
            dashpot_input input = dashpot_input_motion(-1e-3 * values[2 * i], -1e-3 * values[2 * i + 1]);

            input = dashpot_input_with_setting(input, values[FIRST_SETTING + i]);
            dashpot_corner_step(&kernel[i], &input, 1e-3);
            CHECK(fabs(values[8 + i] + kernel[i].now.output.force) < 1e-6 * (1.0 + fabs(values[8 + i])));
        }
    }
    CHECK(fabs(values[8] - values[11]) > 50.0);
    dashpot_vs_end();
}

int main(int argc, char **argv)
{
    static dashpot_corner kernel;
    dashpot_fault fault;
    double energy = 0.0;
    int k, i;

    if (argc == 4) {
        get_api();
        over_a_setting(argv[1], argv[3]);
        return failures != 0;
    }
    if (argc != 3)
        return 2;
    /* Before get_api() has set the function pointers, nothing can be installed. */
    CHECK(dashpot_vs_install(argv[1], argv[1], argv[2]) == -2);
    get_api();
    CHECK(dashpot_vs_install("missing.toml", argv[1], argv[2]) < 0 && errors == 1 && !call);
    /* If the solver lacks an import, the shim stops the run with a message. */
    CHECK(dashpot_vs_install(argv[1], argv[1], argv[2]) == 0 && call);
    hidden = 1;
    call(0.0, VS_EXT_EQ_INIT);
    CHECK(stops == 1 && errors == 2);
    hidden = 0;
    dashpot_vs_end();
    CHECK(dashpot_vs_install(argv[1], argv[1], argv[2]) == 0);
    CHECK(dashpot_corner_load(&kernel, argv[1], &fault) == 0);
    if (!call)
        return 1;
    call(0.0, VS_EXT_AFTER_READ);
    CHECK(imports == 4);
    call(0.0, VS_EXT_EQ_INIT);
    CHECK(values[8] == -kernel.now.output.force);
    for (k = 1; k <= 2000; k++) {
        double t = k * 1e-3, w = 12.566370614359172;
        dashpot_input input;

        for (i = 0; i < 4; i++) {
            values[2 * i] = 20.0 * sin(w * t);
            values[2 * i + 1] = 20.0 * w * cos(w * t);
        }
        call(t, VS_EXT_EQ_IN);
        call(t, VS_EXT_EQ_OUT);
        input = dashpot_input_motion(-1e-3 * values[0], -1e-3 * values[1]);
        dashpot_corner_step(&kernel, &input, 1e-3);
        for (i = 0; i < 4; i++)
            CHECK(fabs(values[8 + i] + kernel.now.output.force) < 1e-6 * (1.0 + fabs(values[8 + i])));
        /* A compressive force takes energy while the damper is compressed. */
        energy += values[8] * 1e-3 * values[1] * 1e-3;
    }
    CHECK(energy > 10.0);
    dashpot_vs_end();
    return failures != 0;
}
