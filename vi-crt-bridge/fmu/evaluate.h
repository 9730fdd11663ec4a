/* Evaluation of the force and the state derivatives of a corner, for model exchange. */
#ifndef DASHPOT_EVALUATE_H
#define DASHPOT_EVALUATE_H

#include "data.h"

/* Evaluates force and state derivatives of a corner at its inputs and states. Returns 0, or -1 after a message. */
int instance_evaluate(struct instance *instance, int corner);

/* Reports that the states have left all bounds, and what solver the damper needs. Returns -1. */
int instance_states_lost(struct instance *instance);

#endif
