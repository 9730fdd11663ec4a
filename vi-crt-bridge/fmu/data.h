/* What an instance of the damper FMU is made of. */
#ifndef DASHPOT_DATA_H
#define DASHPOT_DATA_H

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
#define FIRST_INTERNAL 3
#define STATES_OF_CORNER (FIRST_INTERNAL + (int)(sizeof((dashpot_state *)0)->internal / sizeof(double)))
typedef char states_as_in_the_table[STATES_OF_CORNER == MAX_STATES ? 1 : -1];

/* What the host has told of one corner's velocity, and when: see inputs.h. */
enum { TOLD = 4 };
struct told {
    int fresh;   /* set since the last evaluation */
    double when; /* instant of a fresh one, or NaN where only the next evaluation tells it */
    double at[TOLD], velocity[TOLD]; /* the last ones, the newest first; NaN: not known */
};

/* The derivative of the setting, behind those of the inputs of a block. */
#define OF_SETTING (TEMPERATURE - DISPLACEMENT + 1)

struct part {
    dashpot_corner corner;
    dashpot_state from; /* where the last step began: for derivatives by difference */
    double state[STATES_OF_CORNER]; /* model exchange */
    double rate[STATES_OF_CORNER];
    struct told told;
    double derivative[OF_SETTING + 1]; /* of the inputs, for the next step */
    uint32_t derivatives;                              /* a bit for each that is given */
    uint32_t setting;                                  /* value reference of its setting; 0: it depends on none */
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

#endif
