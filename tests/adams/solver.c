/* A stand-in for Adams Solver: the utility functions that a user subroutine calls, with their documented behaviour, and a
 * small run by a variable-step implicit integrator. It loads the library with dlopen, by name, as Adams does.
 *
 *     solver LIBRARY ROUTINE key=value ...
 *
 * ROUTINE: gse, sfo, gfo, car (the Fortran-style entry). Keys: see `settings`. Prints "t x v sforce" in model units (mm, N, s)
 * at accepted instants, then "calls ..." with counts. Ends with 3 where a routine stopped the run; its message is printed.
 *
 * The damper lies between marker 11 on a body and marker 12 on an actuator, on an inclined line. rig: the body stands still.
 * mass: the body hangs on a spring. The actuator moves so that the damper's displacement, where the body stands, is
 * -A cos(w t). */
#define _GNU_SOURCE
#include "../../adams-usersub/src/entry.h"

#include <dlfcn.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SFORCE = 1, GFORCE = 1, GSE = 1, STRING = 7, I_MARKER = 11, J_MARKER = 12, JFLOAT = 13, RM = 14, GUIDE_I = 21, GUIDE_J = 22 };
enum { MOST = 16 };
static const double LENGTH = 400.0; /* mm at zero displacement */
static const double AXIS[3] = {0.6, 0.0, 0.8};

/* Settings. */
static char routine[16], string_text[4096];
static int with_mass, with_partials, has_string = 1, ns = 2, ni = 2, no = 7, npar_change, only_iflag = -1, threads, save_at_half,
    bad_first_step, has_units = 1;
static double request_element = 1, amplitude = 20, frequency = 1, end_time = 1, hmax = 1e-3, tolerance = 1e-5, side_force, first_par = STRING, mm = 1e-3;

/* What the solver knows at the moment of a call. */
static double clock_accepted;
static int mode = 4, recording, partials_wanted;
static __thread double gse_x_now[MOST], gse_u_now[4];
static double body, body_speed, actuator, actuator_speed;
static long calls, differencing, iterations, rejected, dependencies, threadsafe;
static char dependency_log[2][512];
static double partial_dm, partial_vr, par_x[MOST * MOST], par_u[MOST * 4];
static int got_par_x, got_par_u, got_syspar;
static double saved[256];
static int saved_count, saved_read;

/* ---- the utility functions ---- */
#define UTILITY __attribute__((visibility("default")))

static double damper_length(void) { return LENGTH + body - actuator; }

static void depends(const char *name, const int *ids, int n)
{
    int i;
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
    *failed = !(n >= 2 && ids[0] == I_MARKER && ids[1] == J_MARKER);
    if (*failed || recording)
        return;
    if (strcmp(name, "DM") == 0)
        *value = damper_length();
    else if (strcmp(name, "VR") == 0)
        *value = body_speed - actuator_speed;
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
            values[k] = damper_length() * AXIS[k];
        else if (strcmp(name, "TVEL") == 0 && n == 4 && ids[0] == I_MARKER && ids[1] == J_MARKER && ids[2] == RM)
            values[k] = (body_speed - actuator_speed) * AXIS[k];
        else if (strcmp(name, "TFORCE") == 0 && n == 3 && ids[0] == GUIDE_I && ids[1] == GUIDE_J)
            /* Across the axis, and something along it that must not count. */
            values[k] = (k == 1 ? side_force : 0.0) + 50.0 * AXIS[k];
        else
            *failed = 1;
    }
}

UTILITY void c_syspar(const char *name, const int *ids, int n, const double *partial, int np, int *failed)
{
    *failed = n != 2 || ids[0] != I_MARKER || np != 1;
    *(strcmp(name, "DM") == 0 ? &partial_dm : &partial_vr) = *partial;
    got_syspar++;
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

#ifndef WITHOUT_TIMGET
UTILITY void c_timget(double *time) { *time = clock_accepted; }
#endif
UTILITY void c_getmod(int *m) { *m = mode; }

UTILITY void c_gtstrg(int id, char *text, int *length, int *status)
{
    *status = id != STRING || !has_string;
    *length = 0;
    if (*status)
        return;
    /* Not terminated, as a Fortran host would leave it. */
    *length = (int)strlen(string_text);
    memcpy(text, string_text, (size_t)*length);
}

UTILITY void c_gtunts(int *exists, double *scales, char *names)
{
    *exists = has_units;
    scales[0] = 1.0;
    scales[1] = mm;
    scales[2] = 1.0;
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
UTILITY void c_gse_x(double *x, int n) { memcpy(x, gse_x_now, (size_t)n * sizeof *x); }
UTILITY void c_gse_u(double *u, int n) { memcpy(u, gse_u_now, (size_t)n * sizeof *u); }
UTILITY void c_gsepar_x(const double *p, int n) { memcpy(par_x, p, (size_t)n * sizeof *p); got_par_x = n; }
UTILITY void c_gsepar_u(const double *p, int n) { memcpy(par_u, p, (size_t)n * sizeof *p); got_par_u = n; }

/* ---- the routines under test ---- */
static void (*deriv)(const adams_gse *, double, int, int, int, double *);
static void (*output)(const adams_gse *, double, int, int, int, double *);
static void (*sfosub)(const adams_sforce *, double, int, int, double *);
static void (*gfosub)(const adams_gforce *, double, int, int, double *);
static void (*reqsub)(const adams_request *, double, int, double *);
static void (*car)(const int *, const double *, const double *, const int *, const int *, const int *, double *);

static int is(const char *name) { return strcmp(routine, name) == 0; }

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
    gse_u_now[0] = body - actuator;
    gse_u_now[1] = body_speed - actuator_speed;
    gse_u_now[2] = side_force;
    gse_u_now[3] = 20.0;
}

/* A whole GSE as a later release lays it out: what lies behind IMPLICIT must not matter. */
static struct { adams_gse gse; int statics_only, nd, xd, icd; double sample_offset; } later;

static const adams_gse *gse(void)
{
    static double par[4];
    adams_gse *g = &later.gse;
    par[0] = first_par;
    g->id = GSE;
    g->npar = 1 + npar_change;
    g->par = par;
    g->ni = ni;
    g->no = no;
    g->ns = ns;
    return g;
}

/* The SFORCE's value now. */
static double force(double t, int dflag, int iflag)
{
    double r[8] = {0};
    calls++;
    differencing += dflag;
    if (is("gse")) {
        inputs();
        output(gse(), t, dflag, iflag, no, r);
        return r[0];
    }
    if (is("sfo")) {
        double par[8] = {first_par, LENGTH, 20.0, 1e-3, 1.0, 1.0};
        adams_sforce s = {SFORCE, 2 + npar_change, par, I_MARKER, J_MARKER, 0, "TRANSLATIONAL"};
        sfosub(&s, t, dflag, iflag, r);
        return r[0];
    }
    if (is("car")) {
        double par[8] = {2001, I_MARKER, J_MARKER, first_par, LENGTH};
        int id = SFORCE, npar = 5 + npar_change;
        car(&id, &t, par, &npar, &dflag, &iflag, r);
        return r[0];
    }
    {
        double par[8] = {J_MARKER, GUIDE_I, GUIDE_J, first_par, LENGTH};
        adams_gforce g = {GFORCE, 5 + npar_change, par, I_MARKER, RM, JFLOAT};
        double along, across = 0;
        int k;
        gfosub(&g, t, dflag, iflag, r);
        along = r[0] * AXIS[0] + r[1] * AXIS[1] + r[2] * AXIS[2];
        for (k = 0; k < 6; k++)
            across += fabs(r[k] - (k < 3 ? along * AXIS[k] : 0.0));
        if (across > 1e-9 * (1 + fabs(along))) {
            fprintf(stderr, "the GFORCE leaves its axis by %g\n", across);
            exit(1);
        }
        return along;
    }
}

/* ---- the mechanical system ---- */
/* Unknowns: body and its speed (mass only), then the GSE's states. */
static int unknowns(void) { return (with_mass ? 2 : 0) + (is("gse") ? ns : 0); }
static const double MASS = 40.0, SPRING = 30.0; /* kg, N/mm */

static void place(double t, const double *y)
{
    const double w = 2 * M_PI * frequency;
    body = with_mass ? y[0] : 0;
    body_speed = with_mass ? y[1] : 0;
    actuator = mode == 4 ? amplitude * cos(w * t) : amplitude;
    actuator_speed = mode == 4 ? -amplitude * w * sin(w * t) : 0;
    if (is("gse"))
        memcpy(gse_x_now, y + (with_mass ? 2 : 0), (size_t)ns * sizeof(double));
}

static double last_force;

static void rates(double t, const double *y, double *f, int dflag)
{
    int m = with_mass ? 2 : 0;
    place(t, y);
    /* A rig without unknowns still asks. */
    last_force = force(t, dflag, 0);
    if (with_mass) {
        f[0] = y[1];
        f[1] = 1000.0 * (last_force - SPRING * y[0]) / MASS;
    }
    if (is("gse")) {
        inputs();
        calls++;
        differencing += dflag;
        deriv(gse(), t, dflag, 0, ns, f + m);
    }
}

/* d(rates)/d(unknowns), from partials where they are handed over, otherwise by differencing the routines. */
static void jacobian(double t, const double *y, double J[MOST][MOST])
{
    int n = unknowns(), i, j, m = with_mass ? 2 : 0;
    double f0[MOST], f1[MOST], z[MOST];
    memset(J, 0, sizeof(double) * MOST * MOST);
    if (with_partials) {
        double ox[MOST * MOST], ou[MOST * 4];
        place(t, y);
        partials_wanted = 1;
        got_par_x = got_par_u = got_syspar = 0;
        force(t, 0, 0);
        if (is("gse")) {
            double r[MOST];
            if (got_par_x != no * ns || got_par_u != no * ni) {
                fprintf(stderr, "no partials of the outputs\n");
                exit(1);
            }
            memcpy(ox, par_x, sizeof ox);
            memcpy(ou, par_u, sizeof ou);
            deriv(gse(), t, 0, 0, ns, r);
            if (got_par_x != ns * ns || got_par_u != ns * ni) {
                fprintf(stderr, "no partials of the rates\n");
                exit(1);
            }
            for (i = 0; i < ns; i++)
                for (j = 0; j < ns; j++)
                    J[m + i][m + j] = par_x[i + j * ns];
        }
        if (with_mass) {
            J[0][1] = 1;
            J[1][0] = 1000.0 * ((is("gse") ? ou[0] : partial_dm) - SPRING) / MASS;
            J[1][1] = 1000.0 * (is("gse") ? ou[no] : partial_vr) / MASS;
            for (j = 0; is("gse") && j < ns; j++) {
                J[1][m + j] = 1000.0 * ox[j * no] / MASS;
                J[m + j][0] = par_u[j];
                J[m + j][1] = par_u[j + ns];
            }
        }
        partials_wanted = 0;
        return;
    }
    rates(t, y, f0, 1);
    for (j = 0; j < n; j++) {
        double h = 1e-7 * (1 + fabs(y[j]));
        memcpy(z, y, sizeof z);
        z[j] += h;
        rates(t, z, f1, 1);
        for (i = 0; i < n; i++)
            J[i][j] = (f1[i] - f0[i]) / h;
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

/* Newton on y = known + beta f(t, y). Returns the number of iterations, 0 where it does not converge. */
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

typedef struct { double t, h_before, y[MOST], before[MOST], f[MOST]; int steps; } integrator;

/* One accepted step of the variable-step second-order backward formula. */
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
        /* Now and then a solver tries too far, and comes back. */
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
            error = fmax(error, fabs(y[i] - guess[i]) / (tolerance * (1 + 0.001 * fabs(y[i]))) / 3);
        if (error > 1 && *h > 1e-9) {
            rejected++;
            *h *= fmax(0.2, 0.8 / cbrt(error));
            continue;
        }
        rates(t, y, f, 0);
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
    if (is("gse"))
        deriv(gse(), clock_accepted, 0, iflag, ns, r);
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

/* What a REQUEST shows at the accepted instant. */
static void request(void)
{
    double par[2], r[8];
    adams_request q = {3, 2, par, "", {0}};
    int i;
    par[0] = is("gfo") ? 2 : 1;
    par[1] = request_element;
    reqsub(&q, clock_accepted, 0, r);
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

static void dynamics(integrator *s, double until)
{
    double h = 1e-5;
    while (s->t < until - 1e-12)
        advance(s, &h);
}

/* A thread with its own motion, against the same done alone. */
static void *thread(void *argument)
{
    double *sums = (double *)argument;
    int i, k, seed = (int)sums[1];
    for (i = 0; i < 20000; i++) {
        double r[MOST];
        for (k = 0; k < ns; k++)
            gse_x_now[k] = 1e-3 * sin(0.01 * i + seed + k);
        gse_u_now[0] = 20 * sin(0.02 * i + seed);
        gse_u_now[1] = 500 * cos(0.02 * i + seed);
        output(&later.gse, 0, 0, 0, no, r);
        sums[0] += r[0];
        deriv(&later.gse, 0, 0, 0, ns, r);
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
    gse();
    for (i = 0; i < N; i++) {
        alone[i][0] = together[i][0] = 0;
        alone[i][1] = together[i][1] = i;
        thread(alone[i]);
    }
    for (i = 0; i < N; i++)
        pthread_create(&ids[i], NULL, thread, together[i]);
    for (i = 0; i < N; i++) {
        pthread_join(ids[i], NULL);
        printf("thread %.17g %.17g\n", alone[i][0], together[i][0]);
    }
}

static void set(const char *setting)
{
    static const struct { const char *key; int *number; double *real; } settings[] = {
        {"mass", &with_mass, 0}, {"partials", &with_partials, 0}, {"string", &has_string, 0}, {"ns", &ns, 0}, {"ni", &ni, 0},
        {"no", &no, 0}, {"npar", &npar_change, 0}, {"iflag", &only_iflag, 0}, {"threads", &threads, 0},
        {"save", &save_at_half, 0}, {"bad", &bad_first_step, 0}, {"units", &has_units, 0}, {"amplitude", 0, &amplitude},
        {"frequency", 0, &frequency}, {"end", 0, &end_time}, {"hmax", 0, &hmax}, {"tolerance", 0, &tolerance},
        {"side", 0, &side_force}, {"par", 0, &first_par}, {"request", 0, &request_element}, {"mm", 0, &mm}};
    size_t i, length = strcspn(setting, "=");
    if (strncmp(setting, "model=", 6) == 0) {
        snprintf(string_text, sizeof string_text, "%s", setting + 6);
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
    *(void **)&car = entry(library, "Dashpot_sfo2001");
    *(void **)&reqsub = entry(library, "Dashpot_reqsub");
    {
        int (*selftest)(void);
        *(void **)&selftest = entry(library, "dashpot_adams_selftest");
        printf("selftest %d\n", selftest());
    }
    if (only_iflag >= 0) {
        printf("force %.17g\n", force(0, 0, only_iflag));
        return 0;
    }
    initialise();
    printf("depends %s\n", dependency_log[0]);
    if (threads) {
        run_threads();
        return 0;
    }
    statics(&s);
    if (save_at_half) {
        dynamics(&s, end_time / 2);
        half = s;
        call_all(7);
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
    printf("calls %ld differencing %ld iterations %ld rejected %ld threadsafe %ld\n", calls, differencing, iterations, rejected,
           threadsafe);
    return 0;
}
