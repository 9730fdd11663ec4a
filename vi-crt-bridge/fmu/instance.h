/* One instance of the damper FMU, whatever the FMI version: its variables, its phases, its step and its derivatives. */
#ifndef DASHPOT_INSTANCE_H
#define DASHPOT_INSTANCE_H

#include "contents.h"
#include "corner.h"

enum type { REAL, INTEGER, BOOLEAN };

enum phase { INSTANTIATED, INITIALIZATION, EVENT, RUNNING, TERMINATED };

/* How inputs run between two instants at which the host sets them. */
enum between { AUTOMATIC, HOLD, EXTRAPOLATE };

/* States of a corner, in the order of the value `index` of a STATE: travel, deflection of the internal mass from the driven end, its
 * velocity, and the private states. */
#define TRAVEL 0
#define DEFLECTION 1
#define MASS_VELOCITY 2
#define FIRST_MEMORY 3
#define STATES_OF_CORNER (FIRST_MEMORY + (int)(sizeof((dashpot_state *)0)->memory / sizeof(double)))
typedef char states_as_in_the_table[STATES_OF_CORNER == MOST_STATES ? 1 : -1];

/* What the host has told of one corner's velocity, and when: see inputs.c. */
enum { TOLD = 4 };
struct told {
    int fresh;   /* set since the last evaluation */
    double when; /* instant of a fresh one, or NaN where only the next evaluation tells it */
    double at[TOLD], velocity[TOLD]; /* the last ones, the newest first; NaN: not known */
};

struct part {
    dashpot_corner corner;
    dashpot_state from; /* where the last step began: for derivatives by difference */
    double state[STATES_OF_CORNER]; /* model exchange */
    double rate[STATES_OF_CORNER];
    struct told told;
    double derivative[TEMPERATURE - DISPLACEMENT + 1]; /* of the inputs, for the next step */
    uint32_t derivatives;                              /* a bit for each that is given */
    double low, high;                                  /* speeds that the identified curve covers; equal: all */
    int32_t status;
};

/* Everything that changes. It holds no pointers: a copy is the FMU state, and its bytes are the serialised one. The values that the
 * host has set, by value reference, follow the last part. */
struct data {
    enum phase phase;
    int corners;
    int retune; /* parameters were set and the models not yet prepared anew */
    int stale;  /* outputs and rates are older than inputs and states */
    int moved;  /* the time was set since the last evaluation */
    double dt;  /* length of the last step */
    struct part part[];
};

struct instance;
typedef void instance_log(struct instance *instance, int error, const char *text);

struct instance {
    struct data *data;
    struct contents *contents;
    int exchange; /* model exchange: the host integrates the states */
    int logging;
    instance_log *log;
    void *environment;
    void *logger;
    char name[128];
};

/* All answer 0, or -1 after a word to the log. */
struct instance *instance_new(const char *name, const char *token, const char *resources, int exchange, int logging,
                              instance_log *log, void *logger, void *environment);
void instance_free(struct instance *instance);
int instance_reset(struct instance *instance);
int instance_enter_initialization(struct instance *instance, double start);
int instance_exit_initialization(struct instance *instance);
int instance_terminate(struct instance *instance);
int instance_get(struct instance *instance, uint32_t reference, enum type type, double *value);
int instance_set(struct instance *instance, uint32_t reference, enum type type, double value);
int instance_settle_parameters(struct instance *instance);
/* Brings outputs and rates up to date with inputs and states. */
int instance_refresh(struct instance *instance);
int instance_complain(struct instance *instance, const char *format, ...);

/* step.c. 1 where an input was refused and the force is held. */
int instance_step(struct instance *instance, double time, double dt);
int instance_set_derivative(struct instance *instance, uint32_t reference, int order, double value);

/* exchange.c. */
int instance_enter_event_mode(struct instance *instance);
int instance_enter_continuous_time(struct instance *instance);
int instance_set_time(struct instance *instance, double time);
int instance_states(struct instance *instance, double *states);
int instance_set_states(struct instance *instance, const double *states);
int instance_rates(struct instance *instance, double *rates);
int instance_nominals(struct instance *instance, double *nominals);
int instance_indicators(struct instance *instance, double *indicators);
/* Force and rates of a corner at its inputs and states. */
int instance_evaluate(struct instance *instance, int corner);

/* partial.c. d(unknown)/d(known) at the present point. */
int instance_partial(struct instance *instance, uint32_t unknown, uint32_t known, double *partial);

/* inputs.c. */
double *instance_values(const struct data *data);
double instance_given(const struct data *data, int corner, enum kind kind);
int instance_displacement_given(const struct data *data, int corner);
/* The kernel's input, as the host has set it. */
dashpot_input instance_input(const struct data *data, int corner);
/* The same as it is now, where the host set it a while ago. */
dashpot_input instance_input_now(const struct instance *instance, int corner);
/* The same at the end of a step that begins now. */
dashpot_input instance_input_ahead(const struct instance *instance, int corner, double dt);
void instance_input_set(struct instance *instance, int corner);
void instance_input_seen(struct instance *instance, int corner);
void instance_input_forget(struct told *told);

/* FMU state, in one block; and serialised. */
size_t instance_data_bytes(const struct instance *instance);
size_t instance_bytes(const struct instance *instance);
void instance_serialize(const struct instance *instance, const struct data *data, unsigned char *bytes);
int instance_deserialize(struct instance *instance, struct data *data, const unsigned char *bytes, size_t size);

#endif
