/* Model files that STRING elements name: read once, then only looked at. */
#ifndef DAMPER_MODEL_H
#define DAMPER_MODEL_H

#include "dashpot.h"
#include "units.h"

/* States of the kernel beyond displacement and velocity of the driven end: internal mass, then private ones. */
enum {
    PRIVATE_STATES = sizeof(((dashpot_state *)0)->internal) / sizeof(double),
    MAX_STATES = 2 + PRIVATE_STATES
};

typedef struct {
    dashpot_model model;
    /* The same without dry friction, for LINEAR: stuck friction is no linear element, and its slope would lock the damper. Same states. */
    dashpot_model linear;
    unit_scales units;
    /* States that a GSE integrates: the internal mass and the private states that the model uses. */
    int states;
    /* Whether state i moves at all; those that do not are held at zero. */
    int used[MAX_STATES];
} damper_model;

/* The model of an element whose USER values are par. par[0] is the id of the STRING with the path of the model file;
 * units_at is the place of the three values that override the model's units, which may be left out. With `again` the
 * file is read even if it is known. Null after a message. */
const damper_model *damper_model_of(int element, int npar, const double *par, int units_at, int again);

/* Finds which states a model uses; for the self-test also without a solver. */
void damper_model_find_states(damper_model *damper);

#endif
