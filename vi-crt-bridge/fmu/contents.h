/* Contents of an FMU: its GUID, its corners, the table of its variables and the text of its models. They are read once, when
 * an instance is made, from the FMU's resources. A binary compiled from the FMU's own sources takes them from model_data.c. */
#ifndef DASHPOT_FMU_CONTENTS_H
#define DASHPOT_FMU_CONTENTS_H

#include <stddef.h>
#include <stdint.h>

#define MAX_CORNERS 4
#define MAX_STATES 11 /* states of a corner */
#define LONGEST_LIST 256 /* largest number of values of a list parameter */

/* Kinds of variables. contents.txt uses the same names. */
#define KINDS(X)                                                                                                       \
    X(TIME)                  /* value reference 0; then, per corner, DISPLACEMENT to SPEED_MARGIN; then all others */  \
    X(DISPLACEMENT)          /* input, host's unit and sign */                                                         \
    X(VELOCITY)              /* input */                                                                               \
    X(SIDE_FORCE)            /* input, N */                                                                            \
    X(TEMPERATURE)           /* input, degrees Celsius */                                                              \
    X(FORCE)                 /* output, host's sign */                                                                 \
    X(D_FORCE_D_DISPLACEMENT) /* output */                                                                             \
    X(D_FORCE_D_VELOCITY)    /* output */                                                                              \
    X(STATUS)                /* output, integer */                                                                     \
    X(MOTION_SCALE)          /* damper extension per unit of the host's displacement */                                \
    X(FORCE_SCALE)           /* the host's force per N of tension */                                                   \
    X(POSITION_OFFSET)       /* the damper's extension, from the rig's zero, at the host's displacement 0, m */        \
    X(HAS_DISPLACEMENT)      /* boolean: the host gives displacement, else it is integrated */                         \
    X(INITIAL_POSITION)      /* start of the integrated displacement, m of extension */                                \
    X(SPEED_MARGIN)          /* m/s to the nearer end of the identified curve: the event indicator */                  \
    X(BETWEEN_POINTS)        /* enumeration: course of inputs between two times at which the host sets them */         \
    X(SETTING)               /* input of a damper that depends on a setting, in the unit of the setting */             \
    X(STATE)                 /* continuous state with the number `index` */                                            \
    X(RATE)                  /* time derivative of the state with the number `index` */                                \
    X(PARAMETER)             /* value `index` of the list parameter `name`; index -1: a parameter with one value */    \
    X(CHOICE)                /* option of the choice `name`, by its number */

enum kind {
#define ONE(name) name,
    KINDS(ONE)
#undef ONE
    KIND_COUNT
};

#define BLOCK (SPEED_MARGIN - DISPLACEMENT + 1)

struct variable {
    enum kind kind;
    int corner; /* -1: the variable belongs to the whole FMU */
    int index;
    char name[48];
    /* Bounds of a parameter, from the kernel's table. */
    double low, high;
};

struct contents {
    char guid[64];
    int corners;
    double motion_scale, force_scale, position_offset, displacement; /* start values */
    double between_points; /* start value of BETWEEN_POINTS */
    double explicit_step;  /* longest stable step, s, of an explicit solver that integrates the states; 0: not known */
    int states;                       /* number of states of all corners */
    double nominal[MAX_CORNERS][MAX_STATES]; /* nominal values of the states, for the tolerances of hosts */
    uint32_t between;                 /* value reference of BETWEEN_POINTS */
    uint32_t setting[MAX_CORNERS];   /* value reference of SETTING; 0 if the damper depends on no setting */
    uint32_t variables;
    struct variable *variable;
    char *text; /* all models, one after the other, each terminated by a zero */
    const char *model[MAX_CORNERS];
};

/* Contents and models of one FMU, in a binary built from its sources. Null in the precompiled binary for every FMU. */
extern const char *const EMBEDDED_CONTENTS;
extern const char *const EMBEDDED_MODEL[MAX_CORNERS];

/* Reads the contents. `resources` is the URI or path that the importer gave. On failure it returns null with the reason in
 * `why`. */
struct contents *contents_read(const char *resources, char *why, size_t room);
void contents_free(struct contents *contents);

#endif
