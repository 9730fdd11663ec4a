/* Force and rates of a corner at its inputs and states. */
#ifndef DASHPOT_EVALUATE_H
#define DASHPOT_EVALUATE_H

#include "data.h"

/* 0, or -1 after a word to the log. */
int instance_evaluate(struct instance *instance, int corner);

/* Says that the states have left all bounds, and what kind of solver this damper needs; answers -1. */
int instance_states_lost(struct instance *instance);

#endif
