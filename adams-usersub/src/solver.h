/* The side of Adams Solver that this library sees: element structures and utility functions, in its C interface.
 *
 * Own declarations, so that nothing from an Adams installation is needed to build. Structures are laid out as in Adams
 * 2017.2 and 2023.1; the assertions below stop the build where a compiler disagrees. */
#ifndef SOLVER_H
#define SOLVER_H

#include <stddef.h>

/* SFORCE. */
typedef struct {
    int id, npar;
    const double *par;
    int i, j, action_only;
    const char *type;
} adams_sforce;

/* GFORCE. */
typedef struct {
    int id, npar;
    const double *par;
    int i, rm, jfloat;
} adams_gforce;

/* REQUEST. */
typedef struct {
    int id, npar;
    const double *par;
    const char *comment;
    const char *title[8];
} adams_request;

/* GSE, up to the member where the releases part: 2023.1 has one more int after it. */
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

/* What a call is for. */
enum {
    SOLVER_EVALUATE = 0,
    SOLVER_INITIALISE = 1,
    SOLVER_DEPENDENCIES = 3,
    SOLVER_DESTROY = 5,
    SOLVER_SAVE = 7,
    SOLVER_RELOAD = 9
};

/* Analysis modes, as c_getmod() tells them. */
enum { SOLVER_STATICS = 5, SOLVER_QUASI_STATICS = 6, SOLVER_LINEAR = 7 };

/* The utility functions, resolved from the process at run time. Those that a caller needs are named to solver_has(). */
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

/* The functions that were found; a null member was not. */
const solver_functions *solver(void);

/* Which functions a routine needs. */
enum {
    SOLVER_FOR_LINE = 1,     /* a force that asks for distance and speed */
    SOLVER_FOR_SPACE = 2,    /* a force that asks for positions, velocities and forces in space */
    SOLVER_FOR_GSE = 4,
    SOLVER_FOR_REQUESTS = 8,
    SOLVER_FOR_SAVING = 16
};

/* Name of the first needed function that the process lacks; null where all are there. */
const char *solver_lacks(int needs);

#endif
