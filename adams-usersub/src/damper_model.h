/* Models from the model files whose paths STRING elements contain. A file is read once per element and run. */
#ifndef DAMPER_MODEL_H
#define DAMPER_MODEL_H

#include "dashpot.h"
#include "units.h"

/* States of the kernel without displacement and velocity of the moving end: two of the internal mass, then the internal
 * states of the elements. */
enum {
    PRIVATE_STATES = sizeof(((dashpot_state *)0)->internal) / sizeof(double),
    MAX_STATES = 2 + PRIVATE_STATES
};

typedef struct {
    dashpot_model model;
    /* The model without dry friction, for LINEAR analyses: the stiffness of sticking friction would lock the damper. It has
     * the same states. */
    dashpot_model linear;
    unit_scales units;
    /* Number of states that a GSE integrates: two of the internal mass, then the internal states of the model's elements. */
    int states;
    /* 1 if the model uses state i. A GSE lets an unused state decay to zero. */
    int used[MAX_STATES];
} damper_model;

/* Returns the model of an element with the USER values par, or null after a message. par[0] is the id of the STRING with
 * the path of the model file. units_at is the index of three optional values that override the units of the Adams model.
 * `again`: the file is read even if the element's model is stored. */
const damper_model *damper_model_of(int element, int npar, const double *par, int units_at, int again);

/* Sets `states` and `used` from damper->model. It needs no solver, so that the self-test can call it. */
void damper_model_find_states(damper_model *damper);

#endif
