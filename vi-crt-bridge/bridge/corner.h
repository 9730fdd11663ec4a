/* One damper at one corner: its parameters, its prepared model, and all that it remembers. */
#ifndef DASHPOT_CORNER_H
#define DASHPOT_CORNER_H

#include "dashpot.h"

/* Status bit beside those of dashpot.h: the input was refused (not finite, or absurdly large); the last force is held
 * and the states stand still. */
#define DASHPOT_BRIDGE_LAST_FORCE 0x10000

/* All that a running corner remembers; copying it is saving it. */
typedef struct dashpot_corner_state {
    dashpot_state state;
    /* The last answer: what is held when an input is refused. */
    dashpot_output output;
} dashpot_corner_state;

typedef struct dashpot_corner {
    dashpot_params params;
    dashpot_model model;
    dashpot_corner_state now;
} dashpot_corner;

/* Reads a model file into a corner and prepares its model. The only function here that reads files. Returns a status of
 * dashpot.h and tells line and parameter in *fault, or DASHPOT_CORNER_NO_FILE. */
#define DASHPOT_CORNER_NO_FILE (-1000)
#define DASHPOT_CORNER_FILE_TOO_LONG (-1001)
int32_t dashpot_corner_load(dashpot_corner *corner, const char *path, dashpot_fault *fault);

/* The same from the text of a model file. */
int32_t dashpot_corner_read(dashpot_corner *corner, const char *text, size_t length, dashpot_fault *fault);

/* Puts the corner at rest at `position` (m, extension positive), settled, and works out its static force. */
int32_t dashpot_corner_rest(dashpot_corner *corner, double position);

/* Puts the corner where it would be after a long steady motion as the input says, and works out its force there. With velocity 0 that is
 * dashpot_corner_rest() under the input's side force and temperature. */
int32_t dashpot_corner_begin(dashpot_corner *corner, const dashpot_input *input);

/* The same at a commanded setting, for a damper that depends on one; null: its start. */
int32_t dashpot_corner_rest_at(dashpot_corner *corner, double position, const double *setting);

/* One step of dt to `input`; dt = 0 answers statically and leaves the states. Always returns, allocates nothing, and
 * answers with a warning of dashpot.h or DASHPOT_BRIDGE_LAST_FORCE, never with a refusal. */
int32_t dashpot_corner_step(dashpot_corner *corner, const dashpot_input *input, double dt);

#endif
