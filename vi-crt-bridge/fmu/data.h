/* Data of an instance of the damper FMU. */
#ifndef DASHPOT_DATA_H
#define DASHPOT_DATA_H

#include "contents.h"
#include "corner.h"

enum type { REAL, INTEGER, BOOLEAN };

enum phase { INSTANTIATED, INITIALIZATION, EVENT, RUNNING, TERMINATED };

/* Course of the inputs between two times at which the host sets them. AUTOMATIC: EXTRAPOLATE in model exchange, else HOLD. */
enum between { AUTOMATIC, HOLD, EXTRAPOLATE };

/* States of a corner: values of `index` of a STATE. They are the travel, deflection (relative to the moving end) and velocity
 * of the internal mass, and the internal states of the elements. */
#define TRAVEL 0
#define DEFLECTION 1
#define MASS_VELOCITY 2
#define FIRST_INTERNAL 3
#define STATES_OF_CORNER (FIRST_INTERNAL + (int)(sizeof((dashpot_state *)0)->internal / sizeof(double)))
typedef char states_as_in_the_table[STATES_OF_CORNER == MAX_STATES ? 1 : -1];

/* The last velocities of one corner that the host has set, and their times: see inputs.c. */
enum { TOLD = 4 };
struct told {
    int fresh;   /* 1 if the host has set the motion since the last evaluation */
    double when; /* time of that setting; NaN: the time of the next evaluation */
    double at[TOLD], velocity[TOLD]; /* times and velocities, newest first; NaN: not known */
};

/* Index of the setting's time derivative, after those of the four inputs of a block. */
#define OF_SETTING (TEMPERATURE - DISPLACEMENT + 1)

struct part {
    dashpot_corner corner;
    dashpot_state from; /* state before the last step: for finite differences */
    double state[STATES_OF_CORNER]; /* states in model exchange */
    double rate[STATES_OF_CORNER];
    struct told told;
    double derivative[OF_SETTING + 1]; /* time derivatives of the inputs, for the next step */
    uint32_t derivatives;                              /* a bit for each time derivative that is given */
    uint32_t setting;                                  /* value reference of the setting; 0: no dependence on a setting */
    double low, high;                                  /* velocity range of the identified curve; equal: no limits */
    int32_t status;
};

/* All data of an instance that change. They contain no pointers, so that a copy is the FMU state and its bytes are the
 * serialized state. After the last part follow the values that the host has set, by value reference. */
struct data {
    enum phase phase;
    int corners;
    int retune; /* parameters were set, but the models are not yet prepared with them */
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
    int exchange; /* 1: model exchange, the host integrates the states; 0: co-simulation */
    int logging;
    instance_log *log;
    void *environment;
    void *logger;
    char name[128];
};

#endif
