/* The C interface of Adams Solver as far as this library uses it: element structures and utility functions.
 *
 * The declarations are our own, so that the build needs no file of an Adams installation. The structures have the layout of
 * Adams 2017.2 and 2023.1. The assertions below stop the build if a compiler lays them out differently. */
#ifndef SOLVER_H
#define SOLVER_H

#include <stddef.h>

/* An SFORCE element. */
typedef struct {
    int id, npar;
    const double *par;
    int i, j, action_only;
    const char *type;
} adams_sforce;

/* A GFORCE element. */
typedef struct {
    int id, npar;
    const double *par;
    int i, rm, jfloat;
} adams_gforce;

/* A REQUEST element. */
typedef struct {
    int id, npar;
    const double *par;
    const char *comment;
    const char *title[8];
} adams_request;

/* A GSE element, up to the last member that all releases share. Adams 2023.1 has one more int after it. */
typedef struct {
    int id, npar;
    const double *par;
    int ni, no, u, y, ns, x, ic, static_hold, implicit;
} adams_gse;

#define SOLVER_ASSERT(name, condition) typedef char solver_assert_##name[(condition) ? 1 : -1]
SOLVER_ASSERT(int_is_32_bits, sizeof(int) == 4);
SOLVER_ASSERT(pointers_are_64_bits, sizeof(void *) == 8);
SOLVER_ASSERT(sforce_par, offsetof(adams_sforce, par) == 8);
SOLVER_ASSERT(sforce_i, offsetof(adams_sforce, i) == 16);
SOLVER_ASSERT(sforce_j, offsetof(adams_sforce, j) == 20);
SOLVER_ASSERT(sforce_action_only, offsetof(adams_sforce, action_only) == 24);
SOLVER_ASSERT(sforce_type, offsetof(adams_sforce, type) == 32);
SOLVER_ASSERT(sforce_size, sizeof(adams_sforce) == 40);
SOLVER_ASSERT(gforce_i, offsetof(adams_gforce, i) == 16);
SOLVER_ASSERT(gforce_rm, offsetof(adams_gforce, rm) == 20);
SOLVER_ASSERT(gforce_jfloat, offsetof(adams_gforce, jfloat) == 24);
SOLVER_ASSERT(gforce_size, sizeof(adams_gforce) == 32);
SOLVER_ASSERT(request_comment, offsetof(adams_request, comment) == 16);
SOLVER_ASSERT(request_title, offsetof(adams_request, title) == 24);
SOLVER_ASSERT(request_size, sizeof(adams_request) == 88);
SOLVER_ASSERT(gse_ni, offsetof(adams_gse, ni) == 16);
SOLVER_ASSERT(gse_no, offsetof(adams_gse, no) == 20);
SOLVER_ASSERT(gse_u, offsetof(adams_gse, u) == 24);
SOLVER_ASSERT(gse_y, offsetof(adams_gse, y) == 28);
SOLVER_ASSERT(gse_ns, offsetof(adams_gse, ns) == 32);
SOLVER_ASSERT(gse_x, offsetof(adams_gse, x) == 36);
SOLVER_ASSERT(gse_ic, offsetof(adams_gse, ic) == 40);
SOLVER_ASSERT(gse_static_hold, offsetof(adams_gse, static_hold) == 44);
SOLVER_ASSERT(gse_implicit, offsetof(adams_gse, implicit) == 48);

/* Purposes of a call: values of iflag. */
enum {
    SOLVER_EVALUATE = 0,
    SOLVER_INITIALISE = 1,
    SOLVER_DEPENDENCIES = 3,
    SOLVER_DESTROY = 5,
    SOLVER_SAVE = 7,
    SOLVER_RELOAD = 9
};

/* Analysis modes that c_getmod() returns. */
enum { SOLVER_STATICS = 5, SOLVER_QUASI_STATICS = 6, SOLVER_LINEAR = 7 };

/* The utility functions, found in the process at run time. A caller checks with solver_lacks() that those it needs are
 * available. */
typedef struct {
    void (*sysary)(const char *, const int *, int, double *, int *, int *);
    void (*sysfnc)(const char *, const int *, int, double *, int *);
    void (*syspar)(const char *, const int *, int, const double *, int, int *);
    void (*errmes)(int, const char *, int, const char *);
    void (*usrmes)(int, const char *, int, const char *);
    void (*timget)(double *);
    void (*getmod)(int *);
    void (*gtstrg)(int, char *, int *, int *);
    void (*gtunts)(int *, double *, char *);
    void (*needs_partials)(int *);
    void (*declare_threadsafe)(void);
    void (*serialize_integers)(const int *, int);
    void (*serialize_doubles)(const double *, int);
    void (*unserialize_integers)(int *, int);
    void (*unserialize_doubles)(double *, int);
    int (*gse_ns)(void);
    int (*gse_ni)(void);
    int (*gse_no)(void);
    void (*gse_x)(double *, int);
    void (*gse_u)(double *, int);
    void (*gsepar_x)(const double *, int);
    void (*gsepar_u)(const double *, int);
} solver_functions;

/* Returns the table of functions. A member is null if its function was not found. */
const solver_functions *solver(void);

/* Groups of utility functions, by the caller that needs them: bits for solver_lacks(). */
enum {
    SOLVER_FOR_LINE = 1,     /* a force that needs distance and speed (SFORCE) */
    SOLVER_FOR_SPACE = 2,    /* a force that needs vectors of position, velocity and force (GFORCE) */
    SOLVER_FOR_GSE = 4,
    SOLVER_FOR_REQUESTS = 8,
    SOLVER_FOR_SAVING = 16
};

/* Returns the name of the first function of the groups `needs` that was not found; null if all were found. */
const char *solver_lacks(int needs);

#endif
