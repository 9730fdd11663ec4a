/* One instance of the damper FMU, whatever the FMI version: its variables, its phases, its step and its derivatives.
 *
 * model_data.h is written at export: the model files as text, and the table of variables, whose order is the order of the
 * value references. */
#ifndef DASHPOT_INSTANCE_H
#define DASHPOT_INSTANCE_H

#include "corner.h"

/* What a variable is. */
enum kind {
    TIME, /* value reference 0; then, corner by corner, DISPLACEMENT to INITIAL_POSITION; then all others */
    DISPLACEMENT,          /* input, host's unit and sign */
    VELOCITY,              /* input */
    SIDE_FORCE,            /* input, N */
    TEMPERATURE,           /* input, degrees Celsius */
    FORCE,                 /* output, host's sign */
    FORCE_BY_DISPLACEMENT, /* output */
    FORCE_BY_VELOCITY,     /* output */
    STATUS,                /* output, integer */
    MOTION_SCALE,          /* damper extension per unit of the host's displacement */
    FORCE_SCALE,           /* the host's force per N of tension */
    DISPLACEMENT_GIVEN,    /* boolean: the host gives displacement, else it is integrated */
    INITIAL_POSITION,      /* where it is integrated from, m of extension */
    STATE,                 /* continuous state number `index` */
    RATE,                  /* its derivative */
    PARAMETER,             /* number `index` of the parameter `name` */
    CHOICE                 /* the choice `name` */
};

#define BLOCK (INITIAL_POSITION - DISPLACEMENT + 1)

struct variable {
    enum kind kind;
    int corner;
    int index;
    const char *name;
};

#include "model_data.h"

/* Continuous states of a corner: all numbers of dashpot_state but the velocity of the last step, which is an input. */
#define STATES_OF_CORNER ((int)(sizeof(dashpot_state) / sizeof(double)) - 1)
#define STATES (CORNERS * STATES_OF_CORNER)

enum type { REAL, INTEGER, BOOLEAN };

enum phase { INSTANTIATED, INITIALIZATION, RUNNING, TERMINATED };

/* Everything that changes. It holds no pointers: a copy is the FMU state, and its bytes are the serialised one. */
struct data {
    dashpot_corner corner[CORNERS];
    dashpot_state from[CORNERS]; /* where the last step began, and how long it was: for derivatives by difference */
    double dt;
    dashpot_state rate[CORNERS];
    int32_t status[CORNERS];
    double value[VARIABLES]; /* what the host has set: inputs and parameters, by value reference */
    enum phase phase;
    int retune; /* parameters were set and the models not yet prepared anew */
    int stale;  /* outputs and rates are older than inputs and states */
};

struct instance;
typedef void instance_log(struct instance *instance, int error, const char *text);

struct instance {
    struct data data;
    int exchange; /* model exchange: the host integrates the states */
    int logging;
    instance_log *log;
    void *environment;
    void *logger;
    char name[128];
};

/* All answer 0, or -1 after a word to the log. */
struct instance *instance_new(const char *name, const char *token, int exchange, int logging, instance_log *log,
                              void *logger, void *environment);
void instance_free(struct instance *instance);
int instance_reset(struct instance *instance);
int instance_enter_initialization(struct instance *instance, double start);
int instance_exit_initialization(struct instance *instance);
int instance_get(struct instance *instance, uint32_t reference, enum type type, double *value);
int instance_set(struct instance *instance, uint32_t reference, enum type type, double value);
/* 1 where an input was refused and the force is held. */
int instance_step(struct instance *instance, double time, double dt);
int instance_states(struct instance *instance, double *states);
int instance_set_states(struct instance *instance, const double *states);
int instance_rates(struct instance *instance, double *rates);
int instance_settle_parameters(struct instance *instance);
/* d(unknown)/d(known) at the present point. */
int instance_partial(struct instance *instance, uint32_t unknown, uint32_t known, double *partial);
/* For the files of this folder: what the host has set, the kernel's input of it, and state number `index`. */
double instance_given(const struct data *data, int corner, enum kind kind);
dashpot_input instance_input(const struct data *data, int corner);
double *instance_state_number(dashpot_state *state, int index);
/* Serialised FMU state. */
size_t instance_bytes(void);
void instance_serialize(const struct data *data, unsigned char *bytes);
int instance_deserialize(struct instance *instance, struct data *data, const unsigned char *bytes, size_t size);

#endif
