/* What an FMU is made of: its GUID, its corners, the table of its variables and the text of its models. Read once, when an instance
 * is made: from the FMU's resources, or, in a binary compiled from the FMU's own sources, from what lies in model_data.c. */
#ifndef DASHPOT_FMU_CONTENTS_H
#define DASHPOT_FMU_CONTENTS_H

#include <stddef.h>
#include <stdint.h>

#define MAX_CORNERS 4
#define MAX_STATES 11 /* of a corner */
#define LONGEST_LIST 256 /* numbers of a parameter */

/* What a variable is. The names are those of the lines of contents.txt. */
#define KINDS(X)                                                                                                       \
    X(TIME)                  /* value reference 0; then, corner by corner, DISPLACEMENT to SPEED_MARGIN; then all others */ \
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
    X(POSITION_OFFSET)       /* the damper's extension, from the rig's zero, where the host's displacement is 0, m */  \
    X(HAS_DISPLACEMENT)      /* boolean: the host gives displacement, else it is integrated */                         \
    X(INITIAL_POSITION)      /* where it is integrated from, m of extension */                                         \
    X(SPEED_MARGIN)          /* m/s to the end of the identified curve: the event indicator */                         \
    X(BETWEEN_POINTS)        /* enumeration: how inputs run between two instants at which the host sets them */        \
    X(SETTING)               /* input of a damper that depends on a setting, in its unit */                            \
    X(STATE)                 /* continuous state number `index` */                                                     \
    X(RATE)                  /* its derivative */                                                                      \
    X(PARAMETER)             /* number `index` of the parameter `name`; -1 where it is a single number */              \
    X(CHOICE)                /* the choice `name` */

enum kind {
#define ONE(name) name,
    KINDS(ONE)
#undef ONE
    KIND_COUNT
};

#define BLOCK (SPEED_MARGIN - DISPLACEMENT + 1)

struct variable {
    enum kind kind;
    int corner; /* -1: of the whole FMU */
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
    double explicit_step;  /* longest step, s, of an explicit solver that integrates the states; 0: not known */
    int states;                       /* of all corners */
    double nominal[MAX_CORNERS][MAX_STATES]; /* what a state is usually like, for the tolerances of hosts */
    uint32_t between;                 /* value reference of BETWEEN_POINTS */
    uint32_t setting[MAX_CORNERS];   /* of SETTING; 0 where the damper depends on none */
    uint32_t variables;
    struct variable *variable;
    char *text; /* all models, one after the other, each closed by a zero */
    const char *model[MAX_CORNERS];
};

/* Compiled into a binary that was built from one FMU's sources; null in the runtime that serves every FMU. */
extern const char *const EMBEDDED_CONTENTS;
extern const char *const EMBEDDED_MODEL[MAX_CORNERS];

/* Null, and the reason in `why`, where there are none. `resources` is what the importer gave: a URI or a path. */
struct contents *contents_read(const char *resources, char *why, size_t room);
void contents_free(struct contents *contents);

#endif
