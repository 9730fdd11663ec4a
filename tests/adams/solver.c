/* A stand-in for Adams Solver: the utility functions that a user subroutine calls, with their documented behavior, and a small simulation
 * by a variable-step implicit integrator. It loads the library with dlopen, by name, as Adams does.
 *
 *     solver LIBRARY ROUTINE key=value ...
 *
 * ROUTINE is gse, sfo or gfo; set() lists the keys. The program prints "at t x v sforce" in s, mm, mm/s, N for each accepted time point,
 * then a line "calls ..." with counters. If a user subroutine stops the run, the program prints its message and exits with 3. Values pass
 * to and from a user subroutine in the units of the model, which are arguments. Each call must request the same quantities as the call that
 * declared the dependencies.
 *
 * The damper is between marker 11 on a body and marker 12 on an actuator, on an inclined line. The body is fixed; with mass=1 it hangs on a
 * spring. The actuator moves so that the damper's displacement with a fixed body is -A cos(w t). With dataset=FILE.acf the program instead
 * runs that command file and its dataset. */
#define _GNU_SOURCE
#include "../../adams-usersub/src/entry.h"
#include "dataset.h"

#include <dlfcn.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SFORCE = 1, GFORCE = 1, GSE = 1, STRING = 7, JFLOAT = 13, RM = 14, GUIDE_I = 21, GUIDE_J = 22 };
enum { MOST = 16 };
static int I_MARKER = 11, J_MARKER = 12;
static double LENGTH = 400.0; /* mm at zero displacement */
static const double AXIS[3] = {0.6, 0.0, 0.8};
/* Axes of marker RM in the global frame, as columns, rotated about all three global axes. */
static double RM_AXES[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0.0}, {0.48, 0.64, 0.6}};

/* Settings. */
static char routine[16], string_text[4096];
static int with_mass, with_partials, has_string = 1, ns = 2, ni = 2, no = 7, npar_change, only_iflag = -1, threads, save_at_half,
    bad_first_step, linear_mode, has_units = 1, units_given, release = 2023, late, space, request_page, simulations = MOST_COMMANDS;
/* Id of the VARIABLE with the setting of the damper; 0: none. Its value changes from setting_first to setting_later at half of the run; a
 * negative setting_later means no change. */
enum { VARIABLE_NONE = 0 };
static double variable = VARIABLE_NONE, setting_first, setting_later = -1;
static double request_element = 1, request_kind, temperature = 20, joint_marker = GUIDE_I, end_marker = 12, amplitude = 20, frequency = 1, end_time = 1, hmax = 1e-3, tolerance = 1e-5, side_force, first_par = STRING, told_length = -1;
/* Length, m, force, N, and time, s, of one unit of the solver's model. */
static double length_unit = 1e-3, force_unit = 1, time_unit = 1;
static const char *type = "TRANSLATIONAL";
static dataset model;

/* State of the solver at a call of a user subroutine. */
static double clock_accepted;
static int mode = 4, recording, partials_wanted;
static __thread int is_threaded;
static __thread double gse_x_now[MOST], gse_u_now[5];
static double body, body_speed, actuator, actuator_speed;
static long calls, differencing, iterations, rejected, dependencies, threadsafe;
static char dependency_log[2][512];
static double partial_dm, partial_vr, partial_variable, partial_space[3][18], par_x[MOST * MOST], par_u[MOST * 5], partials_off;
static int got_par_x, got_par_u, got_syspar, got_variable;
static double saved[256];
static int saved_count, saved_read;

/* ---- the utility functions ---- */
#define UTILITY __attribute__((visibility("default")))

static int is(const char *name) { return strcmp(routine, name) == 0; }

/* Time for which a call requests the force, s. */
static double instant;

static double setting_now(void) { return setting_later >= 0 && instant > 0.5 * end_time ? setting_later : setting_first; }

static double damper_length(void) { return LENGTH + body - actuator; }

/* Convert mm, s, N to the units of the model. */
static double of_length(double mm) { return mm * 1e-3 / length_unit; }
static double of_speed(double mm_s) { return mm_s * 1e-3 / length_unit * time_unit; }
static double of_force(double newton) { return newton / force_unit; }
static double of_time(double second) { return second / time_unit; }

/* Position, mm, and velocity, mm/s, of marker I relative to J, and force of the rod guide, N, in the global frame. */
static double place_i[3], speed_i[3], guide_force[3];

static void stand_on_axis(void)
{
    int k;
    for (k = 0; k < 3; k++) {
        place_i[k] = damper_length() * AXIS[k];
        speed_i[k] = (body_speed - actuator_speed) * AXIS[k];
        /* The side force acts across the damper's axis. The force of 50 N along the axis must have no effect. */
        guide_force[k] = (k == 1 ? side_force : 0.0) + 50.0 * AXIS[k];
    }
}

/* Returns component k of a vector in the axes of marker RM. */
static double in_rm(const double v[3], int k) { return v[0] * RM_AXES[0][k] + v[1] * RM_AXES[1][k] + v[2] * RM_AXES[2][k]; }

/* Requests of a user subroutine in one call, each as a hash. The requests of the call that declares the dependencies are stored for each of
 * the two subroutines of a GSE. */
enum { MOST_QUESTIONS = 64 };
static unsigned asked[MOST_QUESTIONS], declared[2][MOST_QUESTIONS];
static int asked_count, declared_count[2];

static void ask(const char *name, const int *ids, int n)
{
    unsigned h = 2166136261u;
    int i;
    for (; *name; name++)
        h = (h ^ (unsigned char)*name) * 16777619u;
    for (i = 0; i < n; i++)
        h = (h ^ (unsigned)ids[i]) * 16777619u;
    if (!is_threaded && asked_count < MOST_QUESTIONS)
        asked[asked_count++] = h;
}

/* Checks, after a call of subroutine `which`, that its requests are those that it declared, or none if iflag allows none. */
static void check_questions(int which, int iflag)
{
    if (iflag == 1) {
        memcpy(declared[which], asked, sizeof asked);
        declared_count[which] = asked_count;
    }
    if ((iflag == 0 && declared_count[which]) || iflag == 1 || iflag == 3) {
        if (asked_count != declared_count[which] || memcmp(asked, declared[which], (size_t)asked_count * sizeof *asked) != 0) {
            fprintf(stderr, "a call with iflag %d asks for other things than it declared\n", iflag);
            exit(1);
        }
    } else if (iflag != 0 && asked_count) {
        fprintf(stderr, "a call with iflag %d asks for states\n", iflag);
        exit(1);
    }
    asked_count = 0;
}

static void depends(const char *name, const int *ids, int n)
{
    int i;
    ask(name, ids, n);
    if (!recording)
        return;
    dependencies++;
    sprintf(dependency_log[recording - 1] + strlen(dependency_log[recording - 1]), "%s", name);
    for (i = 0; i < n; i++)
        sprintf(dependency_log[recording - 1] + strlen(dependency_log[recording - 1]), ",%d", ids[i]);
    strcat(dependency_log[recording - 1], ";");
}

UTILITY void c_sysfnc(const char *name, const int *ids, int n, double *value, int *failed)
{
    depends(name, ids, n);
    *value = 0;
    if (strcmp(name, "VARVAL") == 0) {
        *failed = n != 1 || ids[0] != (int)variable;
        *value = recording ? 0 : setting_now();
        return;
    }
    *failed = !(n >= 2 && ids[0] == I_MARKER && ids[1] == J_MARKER);
    if (*failed || recording)
        return;
    if (strcmp(name, "DM") == 0)
        *value = of_length(damper_length());
    else if (strcmp(name, "VR") == 0)
        *value = of_speed(body_speed - actuator_speed);
    else
        *failed = 1;
}

UTILITY void c_sysary(const char *name, const int *ids, int n, double *values, int *count, int *failed)
{
    int k;
    depends(name, ids, n);
    *failed = 0;
    *count = 3;
    for (k = 0; k < 3; k++) {
        if (recording)
            values[k] = 0;
        else if (strcmp(name, "TDISP") == 0 && n == 3 && ids[0] == I_MARKER && ids[1] == J_MARKER && ids[2] == RM)
            values[k] = of_length(in_rm(place_i, k));
        else if (strcmp(name, "TVEL") == 0 && n == 4 && ids[0] == I_MARKER && ids[1] == J_MARKER && ids[2] == RM && ids[3] == 0)
            values[k] = of_speed(in_rm(speed_i, k));
        else if (strcmp(name, "TFORCE") == 0 && n == 3 && ids[0] == GUIDE_I && ids[1] == GUIDE_J && ids[2] == RM)
            values[k] = of_force(in_rm(guide_force, k));
        else
            *failed = 1;
    }
}

UTILITY void c_syspar(const char *name, const int *ids, int n, const double *partial, int np, int *failed)
{
    static const struct { const char *name; int ids, size; } known[] = {{"DM", 2, 1}, {"VR", 2, 1}, {"TDISP", 3, 18}, {"TVEL", 4, 18}, {"TFORCE", 3, 18}};
    int i = 0;
    if (strcmp(name, "VARVAL") == 0) {
        /* The partial derivative has as many values as the element has components. */
        *failed = n != 1 || ids[0] != (int)variable || np != (is("gfo") ? 6 : 1);
        if (*failed) {
            fprintf(stderr, "partials of %s: %d ids, %d values\n", name, n, np);
            exit(1);
        }
        partial_variable = np == 1 ? partial[0] : in_rm(AXIS, 0) * partial[0] + in_rm(AXIS, 1) * partial[1] + in_rm(AXIS, 2) * partial[2];
        got_variable = 1;
        return;
    }
    while (i < 5 && strcmp(known[i].name, name) != 0)
        i++;
    *failed = i == 5 || n != known[i].ids || np != known[i].size || ids[0] != (i == 4 ? GUIDE_I : I_MARKER);
    if (*failed) {
        fprintf(stderr, "partials of %s: %d ids, %d values\n", name, n, np);
        exit(1);
    }
    if (i < 2)
        *(i == 0 ? &partial_dm : &partial_vr) = *partial;
    else
        memcpy(partial_space[i - 2], partial, sizeof partial_space[0]);
    got_syspar |= 1 << i;
}

UTILITY void c_errmes(int flag, const char *text, int id, const char *end)
{
    if (!flag)
        return;
    printf("errmes %d %s\n", id, text);
    if (strcmp(end, "STOP") == 0) {
        fflush(stdout);
        _Exit(3);
    }
}

UTILITY void c_usrmes(int flag, const char *text, int id, const char *type)
{
    if (flag)
        printf("usrmes %d %s %s\n", id, type, text);
}

UTILITY void c_timget(double *time) { *time = of_time(clock_accepted); }
UTILITY void c_getmod(int *m) { *m = mode; }

UTILITY void c_gtstrg(int id, char *text, int *length, int *status)
{
    *status = id != STRING || !has_string;
    *length = 0;
    if (*status)
        return;
    /* The text is not terminated, as in a Fortran host. */
    *length = (int)strlen(string_text);
    memcpy(text, string_text, (size_t)*length);
}

UTILITY void c_gtunts(int *exists, double *scales, char *names)
{
    *exists = has_units;
    /* If the USER values give the units, the library must not use these, so they are wrong. */
    scales[0] = units_given ? 7.0 : time_unit;
    scales[1] = units_given ? 7.0 : told_length >= 0 ? told_length : length_unit;
    scales[2] = units_given ? 7.0 : force_unit;
    scales[3] = 1.0;
    memcpy(names, "mm", 3);
}

UTILITY void c_adams_needs_partials(int *wanted) { *wanted = partials_wanted; }
UTILITY void c_adams_declare_threadsafe(void) { threadsafe++; }

static void keep(double value) { saved[saved_count++] = value; }
UTILITY void c_adams_serialize_integers(const int *data, int n) { while (n-- > 0) keep(*data++); }
UTILITY void c_adams_serialize_doubles(const double *data, int n) { while (n-- > 0) keep(*data++); }
UTILITY void c_adams_unserialize_integers(int *data, int n) { while (n-- > 0) *data++ = (int)saved[saved_read++]; }
UTILITY void c_adams_unserialize_doubles(double *data, int n) { while (n-- > 0) *data++ = saved[saved_read++]; }

UTILITY int c_gse_ns(void) { return ns; }
UTILITY int c_gse_ni(void) { return ni; }
UTILITY int c_gse_no(void) { return no; }
UTILITY void c_gse_x(double *x, int n) { ask("gse_x", &n, 1); memcpy(x, gse_x_now, (size_t)n * sizeof *x); }
UTILITY void c_gse_u(double *u, int n) { ask("gse_u", &n, 1); memcpy(u, gse_u_now, (size_t)n * sizeof *u); }
UTILITY void c_gsepar_x(const double *p, int n) { memcpy(par_x, p, (size_t)n * sizeof *p); got_par_x = n; }
UTILITY void c_gsepar_u(const double *p, int n) { memcpy(par_u, p, (size_t)n * sizeof *p); got_par_u = n; }

/* ---- the routines under test ---- */
static void (*deriv)(const adams_gse *, double, int, int, int, double *);
static void (*output)(const adams_gse *, double, int, int, int, double *);
static void (*sfosub)(const adams_sforce *, double, int, int, double *);
static void (*gfosub)(const adams_gforce *, double, int, int, double *);
static void (*reqsub)(const adams_request *, double, int, double *);


static void *entry(void *library, const char *name)
{
    void *address = dlsym(library, name);
    if (!address) {
        fprintf(stderr, "no entry %s: %s\n", name, dlerror());
        exit(1);
    }
    return address;
}

static void inputs(void)
{
    gse_u_now[0] = of_length(body - actuator);
    gse_u_now[1] = of_speed(body_speed - actuator_speed);
    gse_u_now[2] = of_force(side_force);
    gse_u_now[3] = temperature;
    gse_u_now[4] = setting_now();
}

/* Returns the structure of a GSE, written number by number in the layout of Adams 2017.2 or 2023.1. */
static const adams_gse *gse(void)
{
    static union { unsigned char bytes[80]; double aligned; } block;
    static double par[4];
    const double *pointer = par;
    const int before[11] = {ni, no, 0, 0, ns, 0, 0, 0, 0, 0, 0}; /* ni no u y ns x ic static_hold implicit */
    const int head[2] = {GSE, (units_given ? 4 : 1) + npar_change};
    par[0] = first_par;
    par[1] = length_unit;
    par[2] = force_unit;
    par[3] = time_unit;
    memset(block.bytes, 0xA5, sizeof block.bytes);
    memcpy(block.bytes, head, 8);
    memcpy(block.bytes + 8, &pointer, 8);
    memcpy(block.bytes + 16, before, 36);
    if (release == 2017) {
        const int after[3] = {0, 0, 0}; /* nd xd icd */
        const double offset = 0;
        memcpy(block.bytes + 52, after, 12);
        memcpy(block.bytes + 64, &offset, 8);
    } else {
        const int after[4] = {1, 0, 0, 0}; /* statics_only nd xd icd */
        const double offset = 0;
        memcpy(block.bytes + 52, after, 16);
        memcpy(block.bytes + 72, &offset, 8);
    }
    return (const adams_gse *)(const void *)block.bytes;
}

/* Writes the USER values of a force from index `first` on. Returns the number of all USER values. */
static int line_values(double *par, int first)
{
    int n = first;
    if (model.is_read) {
        memcpy(par + first, model.sforce.par, (size_t)model.sforce.npar * sizeof *par);
        return first + model.sforce.npar;
    }
    par[n++] = first_par;
    par[n++] = of_length(LENGTH);
    if (temperature != 20 || units_given || variable != VARIABLE_NONE)
        par[n++] = temperature;
    if (units_given) {
        par[n++] = length_unit;
        par[n++] = force_unit;
        par[n++] = time_unit;
    }
    if (variable != VARIABLE_NONE)
        par[n++] = variable;
    return n + npar_change;
}

/* Computes the force on I in the global frame, N, and the sum of the absolute moment components of the GFORCE. */
static void force_in_space(double t, int dflag, int iflag, double f[3], double *moment)
{
    double par[16] = {end_marker, joint_marker, GUIDE_J}, r[6];
    adams_gforce g = {GFORCE, 0, par, I_MARKER, RM, JFLOAT};
    int k;
    if (joint_marker == 0)
        par[2] = 0;
    g.npar = line_values(par, 3);
    gfosub(&g, of_time(t), dflag, iflag, r);
    check_questions(0, iflag);
    for (k = 0; k < 3; k++)
        f[k] = force_unit * (r[0] * RM_AXES[k][0] + r[1] * RM_AXES[k][1] + r[2] * RM_AXES[k][2]);
    *moment = fabs(r[3]) + fabs(r[4]) + fabs(r[5]);
}

/* Computes the damper's force, N, with the sign of an SFORCE: positive if it pushes the markers apart. */
static double force(double t, int dflag, int iflag)
{
    double r[MOST] = {0};
    calls++;
    differencing += dflag;
    if (is("gse")) {
        inputs();
        output(gse(), of_time(t), dflag, iflag, no, r);
        check_questions(0, iflag);
        return r[0] * force_unit;
    }
    if (is("sfo")) {
        double par[16];
        adams_sforce s = {SFORCE, 0, par, I_MARKER, J_MARKER, 0, type};
        s.npar = line_values(par, 0);
        sfosub(&s, of_time(t), dflag, iflag, r);
        check_questions(0, iflag);
        return r[0] * force_unit;
    }
    {
        double f[3], moment, along, across;
        int k;
        stand_on_axis();
        force_in_space(t, dflag, iflag, f, &moment);
        along = f[0] * AXIS[0] + f[1] * AXIS[1] + f[2] * AXIS[2];
        across = moment;
        for (k = 0; k < 3; k++)
            across += fabs(f[k] - along * AXIS[k]);
        if (across > 1e-9 * (1 + fabs(along))) {
            fprintf(stderr, "the GFORCE leaves its axis by %g\n", across);
            exit(1);
        }
        return along;
    }
}

/* ---- the mechanical system ---- */
/* Unknowns: position and speed of the body (mass=1) or of the free parts of the dataset, then the states of the GSE. */
static int mechanical(void) { return model.is_read ? 2 * model.free_parts : with_mass ? 2 : 0; }
static int unknowns(void) { return mechanical() + (is("gse") ? ns : 0); }
static const double MASS = 40.0, SPRING = 30.0; /* kg, N/mm */

/* Returns the integrator's units (mm, mm/s) per model unit of state i of a GSE. */
static double state_unit(int i) { return length_unit / 1e-3 / (i == 1 ? time_unit : 1); }

static void place(double t, const double *y)
{
    const double w = 2 * M_PI * frequency;
    int i;
    instant = t;
    if (model.is_read) {
        dataset_place(&model, t, mode != 4, y);
        body = dataset_distance(&model) - LENGTH;
        body_speed = dataset_speed(&model);
        actuator = actuator_speed = 0;
        return;
    }
    body = with_mass ? y[0] : 0;
    body_speed = with_mass ? y[1] : 0;
    actuator = mode == 4 ? amplitude * cos(w * t) : amplitude;
    actuator_speed = mode == 4 ? -amplitude * w * sin(w * t) : 0;
    for (i = 0; is("gse") && i < ns; i++)
        gse_x_now[i] = y[mechanical() + i] / state_unit(i);
}

static double last_force;

static void rates(double t, const double *y, double *f, int dflag)
{
    int m = mechanical(), i;
    place(t, y);
    /* A rig without unknowns also requests the force, because the program prints it. */
    last_force = force(t, dflag, 0);
    if (model.is_read) {
        dataset_rates(&model, last_force, f);
    } else if (with_mass) {
        f[0] = y[1];
        f[1] = 1000.0 * (last_force - SPRING * y[0]) / MASS;
    }
    if (is("gse")) {
        inputs();
        calls++;
        differencing += dflag;
        deriv(gse(), of_time(t), dflag, 0, ns, f + m);
        check_questions(1, 0);
        for (i = 0; i < ns; i++)
            f[m + i] *= state_unit(i) / time_unit;
    }
}

/* Computes d(rates)/d(unknowns) from the partial derivatives that the user subroutine supplies. */
static void handed_jacobian(double t, const double *y, double J[MOST][MOST])
{
    /* Factors from partial derivatives per model unit to those per mm and per mm/s. */
    const double by_mm = 1e-3 / length_unit, by_mm_s = by_mm * time_unit;
    double ox[MOST * MOST], ou[MOST * 5], by_length, by_speed;
    int i, j, m = mechanical();
    place(t, y);
    partials_wanted = 1;
    got_par_x = got_par_u = got_syspar = got_variable = 0;
    force(t, 0, 0);
    if (variable != VARIABLE_NONE && !got_variable && !is("gse")) {
        fprintf(stderr, "no partial by the variable\n");
        exit(1);
    }
    by_length = partial_dm;
    by_speed = partial_vr;
    if (is("gse")) {
        double r[MOST];
        if (got_par_x != no * ns || got_par_u != no * ni) {
            fprintf(stderr, "no partials of the outputs\n");
            exit(1);
        }
        memcpy(ox, par_x, sizeof ox);
        memcpy(ou, par_u, sizeof ou);
        by_length = ou[0];
        by_speed = ou[no];
        deriv(gse(), of_time(t), 0, 0, ns, r);
        check_questions(1, 0);
        if (got_par_x != ns * ns || got_par_u != ns * ni) {
            fprintf(stderr, "no partials of the rates\n");
            exit(1);
        }
        for (i = 0; i < ns; i++)
            for (j = 0; j < ns; j++)
                J[m + i][m + j] = par_x[i + j * ns] * state_unit(i) / state_unit(j) / time_unit;
    } else if (is("gfo")) {
        int row, column;
        if (got_syspar != (joint_marker ? 28 : 12)) {
            fprintf(stderr, "partials of a GFORCE are missing\n");
            exit(1);
        }
        by_length = by_speed = 0;
        for (row = 0; row < 3; row++)
            for (column = 0; column < 3; column++) {
                double both = in_rm(AXIS, row) * in_rm(AXIS, column);
                by_length += both * partial_space[0][row + 6 * column];
                by_speed += both * partial_space[1][row + 6 * column];
            }
    } else if (got_syspar != 3) {
        fprintf(stderr, "partials of an SFORCE are missing\n");
        exit(1);
    }
    partials_wanted = 0;
    if (!with_mass)
        return;
    J[0][1] = 1;
    J[1][0] = 1000.0 * (by_length * force_unit * by_mm - SPRING) / MASS;
    J[1][1] = 1000.0 * by_speed * force_unit * by_mm_s / MASS;
    for (j = 0; is("gse") && j < ns; j++) {
        J[1][m + j] = 1000.0 * ox[j * no] * force_unit / state_unit(j) / MASS;
        J[m + j][0] = par_u[j] * state_unit(j) / time_unit * by_mm;
        J[m + j][1] = par_u[j + ns] * state_unit(j) / time_unit * by_mm_s;
    }
}

/* Computes d(rates)/d(unknowns) by central differences. */
static void differenced_jacobian(double t, const double *y, double J[MOST][MOST])
{
    int n = unknowns(), i, j, k;
    double f[2][MOST], z[MOST];
    for (j = 0; j < n; j++) {
        double h = 1e-6 * (1 + 0.1 * fabs(y[j]));
        for (k = 0; k < 2; k++) {
            memcpy(z, y, sizeof z);
            z[j] += k ? h : -h;
            rates(t, z, f[k], 1);
        }
        for (i = 0; i < n; i++)
            J[i][j] = (f[1][i] - f[0][i]) / (2 * h);
    }
}

/* Computes the Jacobian, with partials=1 from the supplied partial derivatives, otherwise from differences. With partials=2 it also
 * compares both. */
static void jacobian(double t, const double *y, double J[MOST][MOST])
{
    int n = unknowns(), i, j;
    memset(J, 0, sizeof(double) * MOST * MOST);
    if (with_partials == 1) {
        handed_jacobian(t, y, J);
        return;
    }
    differenced_jacobian(t, y, J);
    if (with_partials == 2) {
        double handed[MOST][MOST] = {{0}};
        handed_jacobian(t, y, handed);
        for (i = 0; i < n; i++) {
            double largest = 0;
            for (j = 0; j < n; j++)
                largest = fmax(largest, fabs(J[i][j]));
            for (j = 0; j < n; j++)
                partials_off = fmax(partials_off, fabs(J[i][j] - handed[i][j]) / (largest + 1e-9));
        }
    }
}

/* Solves A x = b in place. */
static void solve(int n, double A[MOST][MOST], double *b)
{
    int i, j, k;
    for (k = 0; k < n; k++) {
        int p = k;
        for (i = k + 1; i < n; i++)
            if (fabs(A[i][k]) > fabs(A[p][k]))
                p = i;
        if (A[p][k] == 0) {
            fprintf(stderr, "singular matrix\n");
            exit(1);
        }
        for (j = 0; j < n; j++) {
            double s = A[k][j];
            A[k][j] = A[p][j];
            A[p][j] = s;
        }
        {
            double s = b[k];
            b[k] = b[p];
            b[p] = s;
        }
        for (i = k + 1; i < n; i++) {
            double q = A[i][k] / A[k][k];
            for (j = k; j < n; j++)
                A[i][j] -= q * A[k][j];
            b[i] -= q * b[k];
        }
    }
    for (k = n; k-- > 0;) {
        for (j = k + 1; j < n; j++)
            b[k] -= A[k][j] * b[j];
        b[k] /= A[k][k];
    }
}

/* Solves y = known + beta f(t, y), or f = 0 in statics, by Newton's method. Returns the number of iterations, or 0 without convergence. */
static int newton(double t, double beta, const double *known, double *y, int is_static)
{
    int n = unknowns(), k, i, j;
    for (k = 1; k <= 12; k++) {
        double f[MOST], J[MOST][MOST], r[MOST], change = 0;
        iterations++;
        rates(t, y, f, 0);
        if (n == 0)
            return k;
        jacobian(t, y, J);
        for (i = 0; i < n; i++) {
            r[i] = is_static ? f[i] : known[i] + beta * f[i] - y[i];
            for (j = 0; j < n; j++)
                J[i][j] = is_static ? -J[i][j] : (i == j ? 1.0 : 0.0) - beta * J[i][j];
        }
        solve(n, J, r);
        for (i = 0; i < n; i++) {
            y[i] += r[i];
            change = fmax(change, fabs(r[i]) / (1 + 0.001 * fabs(y[i])));
        }
        if (!(change < 1e12))
            return 0;
        if (change < 0.01 * tolerance)
            return k;
    }
    return 0;
}

static void print_state(double t) { printf("at %.17g %.17g %.17g %.17g\n", t, body - actuator, body_speed - actuator_speed, last_force); }

/* Returns the error tolerance of unknown i relative to that of a position: 100 for the speeds of a dataset's parts. */
static double speed_share(int i) { return model.is_read && i < mechanical() && i % 2 ? 100 : 1; }

typedef struct { double t, h_before, y[MOST], before[MOST], f[MOST]; int steps; } integrator;

/* Takes one accepted step of the variable-step second-order backward differentiation formula. */
static void advance(integrator *s, double *h)
{
    int n = unknowns(), i;
    for (;;) {
        double y[MOST] = {0}, guess[MOST] = {0}, known[MOST] = {0}, f[MOST] = {0}, beta, error = 0, t, w;
        *h = fmin(*h, fmin(hmax, end_time - s->t));
        t = s->t + *h;
        w = s->steps ? *h / s->h_before : 0;
        beta = *h * (1 + w) / (1 + 2 * w);
        for (i = 0; i < n; i++) {
            known[i] = ((1 + w) * (1 + w) * s->y[i] - w * w * s->before[i]) / (1 + 2 * w);
            guess[i] = s->y[i] + *h * (1 + w) * s->f[i] - w * w * (s->y[i] - s->before[i]);
        }
        memcpy(y, guess, sizeof y);
        /* Solvers sometimes try a later time and then return to an earlier one. */
        if (bad_first_step && s->steps % 5 == 2) {
            rates(t + *h, y, f, 0);
            rates(t + 0.3 * *h, y, f, 0);
        }
        if (!newton(t, beta, known, y, 0)) {
            rejected++;
            *h *= 0.25;
            continue;
        }
        for (i = 0; i < n; i++)
            error = fmax(error, fabs(y[i] - guess[i]) / (tolerance * (speed_share(i) + 0.001 * fabs(y[i]))) / 3);
        if (error > 1 && *h > 1e-9) {
            rejected++;
            *h *= fmax(0.2, 0.8 / cbrt(error));
            continue;
        }
        /* late=1: the last evaluation precedes the last Newton correction, so the force at the accepted time point is never requested. */
        if (late)
            place(t, y);
        else
            rates(t, y, f, 0);
        if (late && n) {
            double w_known = 1 / beta;
            for (i = 0; i < n; i++)
                f[i] = (y[i] - known[i]) * w_known;
        }
        memcpy(s->before, s->y, sizeof y);
        memcpy(s->y, y, sizeof y);
        memcpy(s->f, f, sizeof f);
        s->h_before = *h;
        s->t = t;
        s->steps++;
        clock_accepted = t;
        print_state(t);
        *h *= n ? fmin(1.6, fmax(0.5, 0.8 / cbrt(error + 1e-12))) : (s->steps % 7 == 3 ? 0.4 : 1.3);
        return;
    }
}

static void call_all(int iflag)
{
    double r[MOST] = {0};
    force(clock_accepted, 0, iflag);
    if (is("gse")) {
        deriv(gse(), of_time(clock_accepted), 0, iflag, ns, r);
        check_questions(1, iflag);
    }
}

static void initialise(void)
{
    dependency_log[0][0] = dependency_log[1][0] = 0;
    recording = 1;
    call_all(1);
    recording = 2;
    call_all(3);
    recording = 0;
    if (strcmp(dependency_log[0], dependency_log[1]) != 0) {
        fprintf(stderr, "dependencies differ: %s and %s\n", dependency_log[0], dependency_log[1]);
        exit(1);
    }
}

/* Prints the results of a REQUEST at the accepted time point. */
static void request(void)
{
    double par[6], r[8];
    adams_request q = {3, 2, par, "", {0}};
    int i;
    par[0] = request_kind ? request_kind : is("gfo") ? 2 : 1;
    par[1] = request_element;
    par[2] = request_page;
    par[3] = length_unit;
    par[4] = force_unit;
    par[5] = time_unit;
    if (request_page)
        q.npar = units_given ? 6 : 3;
    reqsub(&q, of_time(clock_accepted), 0, r);
    printf("request");
    for (i = 0; i < 8; i++)
        printf(" %.17g", r[i]);
    puts("");
}

static void statics(integrator *s)
{
    double f[MOST];
    memset(s, 0, sizeof *s);
    clock_accepted = 0;
    mode = 5;
    if (!newton(0, 1, s->y, s->y, 1)) {
        fprintf(stderr, "no static equilibrium\n");
        exit(1);
    }
    rates(0, s->y, f, 0);
    printf("static %.17g %.17g\n", body - actuator, last_force);
    mode = 4;
    rates(0, s->y, s->f, 0);
    print_state(0);
}

/* Prints the matrix of the linear system at the operating point, from differences and from the supplied partial derivatives. The user
 * subroutine gets linear_mode as the analysis mode. */
static void linearise(const integrator *s)
{
    double J[2][MOST][MOST];
    int n = unknowns(), i, j, k;
    mode = linear_mode;
    memset(J, 0, sizeof J);
    differenced_jacobian(s->t, s->y, J[0]);
    handed_jacobian(s->t, s->y, J[1]);
    for (k = 0; k < 2; k++) {
        printf(k ? "handed" : "differenced");
        for (i = 0; i < n; i++)
            for (j = 0; j < n; j++)
                printf(" %.17g", J[k][i][j]);
        puts("");
    }
    mode = 4;
}

static void dynamics(integrator *s, double until)
{
    double h = 1e-5;
    while (s->t < until - 1e-12)
        advance(s, &h);
}

static const adams_gse *gse_of_threads;

/* Body of a thread: sums outputs and rates of a GSE over a motion of its own. */
static void *thread(void *argument)
{
    double *sums = (double *)argument;
    int i, k, seed = (int)sums[1];
    const adams_gse *g = gse_of_threads;
    is_threaded = 1;
    for (i = 0; i < 20000; i++) {
        double r[MOST];
        for (k = 0; k < ns; k++)
            gse_x_now[k] = 1e-3 * sin(0.01 * i + seed + k);
        gse_u_now[0] = 20 * sin(0.02 * i + seed);
        gse_u_now[1] = 500 * cos(0.02 * i + seed);
        output(g, 0, 0, 0, no, r);
        sums[0] += r[0];
        deriv(g, 0, 0, 0, ns, r);
        for (k = 0; k < ns; k++)
            sums[0] += 1e-6 * r[k];
    }
    return NULL;
}

static void run_threads(void)
{
    enum { N = 4 };
    double alone[N][2], together[N][2];
    pthread_t ids[N];
    int i;
    gse_of_threads = gse();
    for (i = 0; i < N; i++) {
        alone[i][0] = together[i][0] = 0;
        alone[i][1] = together[i][1] = i;
        pthread_create(&ids[i], NULL, thread, together[i]);
    }
    for (i = 0; i < N; i++)
        pthread_join(ids[i], NULL);
    for (i = 0; i < N; i++) {
        thread(alone[i]);
        printf("thread %.17g %.17g\n", alone[i][0], together[i][0]);
    }
}

static double random_number(void);

/* Requests the same forces in two orders, some of them for differencing, and prints the number of differing results. */
static void shuffle(double t)
{
    enum { QUESTIONS = 60, TWICE = 2 * QUESTIONS };
    double ask_time[QUESTIONS], ask_body[QUESTIONS], ask_speed[QUESTIONS], first[QUESTIONS];
    int i, k, differences = 0;
    for (i = 0; i < QUESTIONS; i++) {
        ask_time[i] = t + (i % 7 ? 0.004 * (1 + random_number()) : 0);
        ask_body[i] = body + 0.5 * random_number();
        ask_speed[i] = body_speed + 100 * random_number();
    }
    for (i = 0; i < TWICE; i++) {
        double f;
        k = i < QUESTIONS ? i : (int)(0.5 * (1 + random_number()) * QUESTIONS) % QUESTIONS;
        body = ask_body[k];
        body_speed = ask_speed[k];
        f = force(ask_time[k], i >= QUESTIONS && i % 3 == 0, 0);
        if (i < QUESTIONS)
            first[k] = f;
        else if (f != first[k])
            differences++;
    }
    printf("shuffled %d %d\n", QUESTIONS, differences);
}

static double random_number(void)
{
    static unsigned long long state = 88172645463325252ull;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 4503599627370496.0 - 1.0; /* -1 to 1 */
}

/* Prints cases of a GFORCE between bodies that move and rotate in space. A case has positions and velocities of both ends, the guide force
 * and the force on I, all in the global frame. The moment of the GFORCE and the error of its partial derivatives against differences
 * follow. */
static void run_in_space(void)
{
    enum { CASES = 200 };
    static const double STEP[3] = {1e-4, 1e-3, 1e-2}; /* mm, mm/s, N */
    double *const asked_for[3] = {place_i, speed_i, guide_force};
    const double unit[3] = {1e-3 / length_unit, 1e-3 / length_unit * time_unit, 1 / force_unit};
    int n, i, k, what, row, column;
    for (n = 0; n < CASES; n++) {
        double q[4], size = 0, ends[2][3], speeds[2][3], f[3], moment, worst = 0, given[3][18];
        for (i = 0; i < 4; i++) {
            q[i] = random_number();
            size += q[i] * q[i];
        }
        for (i = 0; i < 4; i++)
            q[i] /= sqrt(size);
        {
            double w = q[0], x = q[1], y = q[2], z = q[3];
            double turned[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                   {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                                   {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
            memcpy(RM_AXES, turned, sizeof turned);
        }
        /* Each end is a point of a moving and rotating body, away from the point whose velocity is given. */
        for (i = 0; i < 2; i++) {
            double arm[3], turn[3];
            for (k = 0; k < 3; k++) {
                arm[k] = 300 * random_number();
                turn[k] = 3 * random_number();
                ends[i][k] = (i ? 1000 : 1000 + 230) + 60 * random_number();
            }
            for (k = 0; k < 3; k++)
                speeds[i][k] = 300 * random_number() + turn[(k + 1) % 3] * arm[(k + 2) % 3] - turn[(k + 2) % 3] * arm[(k + 1) % 3];
        }
        for (k = 0; k < 3; k++) {
            place_i[k] = ends[0][k] - ends[1][k];
            speed_i[k] = speeds[0][k] - speeds[1][k];
            guide_force[k] = 800 * random_number();
        }
        /* Each case initializes the element again, so that its force is the steady force at this motion. */
        force_in_space(0, 0, 1, f, &moment);
        partials_wanted = 1;
        force_in_space(0, 0, 0, f, &moment);
        partials_wanted = 0;
        memcpy(given, partial_space, sizeof given);
        printf("space");
        for (i = 0; i < 2; i++)
            for (k = 0; k < 3; k++)
                printf(" %.17g", ends[i][k]);
        for (i = 0; i < 2; i++)
            for (k = 0; k < 3; k++)
                printf(" %.17g", speeds[i][k]);
        for (k = 0; k < 3; k++)
            printf(" %.17g", guide_force[k]);
        for (k = 0; k < 3; k++)
            printf(" %.17g", f[k]);
        for (what = 0; what < 3; what++) {
            double differenced[3][3], largest = 0;
            for (column = 0; column < 3; column++) {
                double high[3], low[3], unused, before[3];
                memcpy(before, asked_for[what], sizeof before);
                for (k = 0; k < 3; k++)
                    asked_for[what][k] = before[k] + STEP[what] * RM_AXES[k][column];
                force_in_space(0, 1, 0, high, &unused);
                for (k = 0; k < 3; k++)
                    asked_for[what][k] = before[k] - STEP[what] * RM_AXES[k][column];
                force_in_space(0, 1, 0, low, &unused);
                memcpy(asked_for[what], before, sizeof before);
                for (row = 0; row < 3; row++) {
                    differenced[row][column] = (in_rm(high, row) - in_rm(low, row)) / (2 * STEP[what]);
                    largest = fmax(largest, fabs(differenced[row][column]));
                }
            }
            for (column = 0; column < 3; column++)
                for (row = 0; row < 6; row++) {
                    double got = given[what][row + 6 * column] * force_unit * unit[what];
                    worst = fmax(worst, fabs(got - (row < 3 ? differenced[row][column] : 0)) / (largest + 1e-9));
                }
        }
        printf(" %.17g %.17g\n", moment, worst);
    }
}

static void set(const char *setting)
{
    static const struct { const char *key; int *number; double *real; } settings[] = {
        {"mass", &with_mass, 0}, {"partials", &with_partials, 0}, {"string", &has_string, 0}, {"ns", &ns, 0}, {"ni", &ni, 0},
        {"no", &no, 0}, {"npar", &npar_change, 0}, {"iflag", &only_iflag, 0}, {"threads", &threads, 0},
        {"save", &save_at_half, 0}, {"bad", &bad_first_step, 0}, {"units", &has_units, 0}, {"amplitude", 0, &amplitude},
        {"frequency", 0, &frequency}, {"end", 0, &end_time}, {"hmax", 0, &hmax}, {"tolerance", 0, &tolerance},
        {"side", 0, &side_force}, {"par", 0, &first_par}, {"request", 0, &request_element}, {"told", 0, &told_length},
        {"given", &units_given, 0}, {"linear", &linear_mode, 0}, {"simulations", &simulations, 0}, {"release", &release, 0}, {"late", &late, 0}, {"space", &space, 0}, {"page", &request_page, 0},
        {"kind", 0, &request_kind}, {"variable", 0, &variable}, {"setting", 0, &setting_first}, {"later", 0, &setting_later}, {"temperature", 0, &temperature}, {"joint", 0, &joint_marker}, {"other", 0, &end_marker},
        {"length_unit", 0, &length_unit}, {"force_unit", 0, &force_unit}, {"time_unit", 0, &time_unit}};
    size_t i, length = strcspn(setting, "=");
    if (strncmp(setting, "model=", 6) == 0) {
        snprintf(string_text, sizeof string_text, "%s", setting + 6);
        return;
    }
    if (strncmp(setting, "dataset=", 8) == 0) {
        dataset_read(&model, setting + 8);
        I_MARKER = model.sforce.i;
        J_MARKER = model.sforce.j;
        LENGTH = model.sforce.par[1];
        snprintf(string_text, sizeof string_text, "%s", dataset_string(&model, (int)model.sforce.par[0]));
        return;
    }
    if (strncmp(setting, "type=", 5) == 0) {
        type = setting + 5;
        return;
    }
    for (i = 0; i < sizeof settings / sizeof settings[0]; i++)
        if (strlen(settings[i].key) == length && strncmp(settings[i].key, setting, length) == 0) {
            if (settings[i].number)
                *settings[i].number = atoi(setting + length + 1);
            else
                *settings[i].real = atof(setting + length + 1);
            return;
        }
    fprintf(stderr, "no setting %s\n", setting);
    exit(1);
}

int main(int argc, char **argv)
{
    static integrator s, half;
    void *library;
    int i;
    if (argc < 3)
        return 1;
    library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    snprintf(routine, sizeof routine, "%s", argv[2]);
    for (i = 3; i < argc; i++)
        set(argv[i]);
    *(void **)&deriv = entry(library, "Dashpot_gse_deriv");
    *(void **)&output = entry(library, "Dashpot_gse_output");
    *(void **)&sfosub = entry(library, "Dashpot_sfosub");
    *(void **)&gfosub = entry(library, "Dashpot_gfosub");
    *(void **)&reqsub = entry(library, "Dashpot_reqsub");
    {
        int (*selftest)(void);
        *(void **)&selftest = entry(library, "dashpot_adams_selftest");
        if (threads < 2) /* 2: the threads make the first calls */
            printf("selftest %d\n", selftest());
    }
    if (only_iflag >= 0) {
        initialise();
        if (only_iflag == 9)
            call_all(7);
        call_all(only_iflag);
        saved_read = 0;
        printf("force %.17g\n", force(0, 0, only_iflag));
        return 0;
    }
    if (threads == 2) {
        run_threads();
        return 0;
    }
    initialise();
    printf("depends %s\n", dependency_log[0]);
    if (threads) {
        run_threads();
        return 0;
    }
    if (space) {
        run_in_space();
        return 0;
    }
    if (model.is_read) {
        int command;
        for (command = 0; command < model.commands && command <= simulations; command++) {
            const simulation *c = &model.command[command];
            if (c->is_static) {
                statics(&s);
                continue;
            }
            dataset_move(&model, c->motion);
            end_time = c->end;
            hmax = (c->end - s.t) / c->steps;
            tolerance = model.error;
            printf("simulation %.17g\n", c->end);
            dynamics(&s, c->end);
        }
        return 0;
    }
    statics(&s);
    if (linear_mode) {
        /* The actuator stays at its position in statics, so the friction sticks. */
        frequency = 0;
        linearise(&s);
        return 0;
    }
    if (save_at_half) {
        dynamics(&s, end_time / 2);
        half = s;
        call_all(7);
        if (save_at_half == 3) {
            shuffle(s.t);
            return 0;
        }
        if (save_at_half == 2)
            saved[0] = 99; /* a wrong version of the saved state */
        puts("first");
        dynamics(&s, end_time);
        call_all(5);
        clock_accepted = half.t;
        initialise();
        call_all(9);
        if (saved_read != saved_count) {
            fprintf(stderr, "%d saved, %d read\n", saved_count, saved_read);
            return 1;
        }
        s = half;
        puts("second");
    }
    dynamics(&s, end_time);
    if (!is("gse"))
        request();
    printf("by_variable %.17g\n", partial_variable);
    printf("partials_off %.17g\n", partials_off);
    printf("calls %ld differencing %ld iterations %ld rejected %ld threadsafe %ld\n", calls, differencing, iterations, rejected,
           threadsafe);
    return 0;
}
