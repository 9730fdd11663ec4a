/* One damper at one corner: its parameters, its prepared model, its state and its last output. */
#ifndef DASHPOT_CORNER_H
#define DASHPOT_CORNER_H

#include "dashpot.h"

/* Status bit in addition to those of dashpot.h: the input was rejected (for example not finite, or too large). Force and
 * states stay those of the last step. */
#define DASHPOT_BRIDGE_LAST_FORCE 0x10000

/* All data of a corner that change during a run. A copy saves the corner. */
typedef struct dashpot_corner_state {
    dashpot_state state;
    /* The last output, which stays valid if an input is rejected. */
    dashpot_output output;
} dashpot_corner_state;

typedef struct dashpot_corner {
    dashpot_params params;
    dashpot_model model;
    dashpot_corner_state now;
} dashpot_corner;

/* Reads a model file into a corner, prepares its model and puts it at rest at position 0. No other function of this
 * header reads files. Returns a status of dashpot.h, with line and parameter in *fault, or one of these two: */
#define DASHPOT_CORNER_NO_FILE (-1000)
#define DASHPOT_CORNER_FILE_TOO_LONG (-1001)
int32_t dashpot_corner_load(dashpot_corner *corner, const char *path, dashpot_fault *fault);

/* Like dashpot_corner_load(), from the text of a model file. */
int32_t dashpot_corner_read(dashpot_corner *corner, const char *text, size_t length, dashpot_fault *fault);

/* Puts the corner at rest at `position` (m, extension positive), in equilibrium, and computes its static force. */
int32_t dashpot_corner_rest(dashpot_corner *corner, double position);

/* Puts the corner into the steady state of the input's motion and computes its force. With velocity 0 the result is that
 * of dashpot_corner_rest() under the input's side force and temperature. */
int32_t dashpot_corner_begin(dashpot_corner *corner, const dashpot_input *input);

/* Like dashpot_corner_rest(), at the setting *setting for a damper that depends on one. Null: the start setting of the
 * model file. */
int32_t dashpot_corner_rest_at(dashpot_corner *corner, double position, const double *setting);

/* Advances the corner by dt, in s; `input` is the input at the end of the step. dt = 0 is a static evaluation and keeps
 * the states. It allocates nothing. Returns 0, warnings of dashpot.h or DASHPOT_BRIDGE_LAST_FORCE, never an error. */
int32_t dashpot_corner_step(dashpot_corner *corner, const dashpot_input *input, double dt);

#endif
