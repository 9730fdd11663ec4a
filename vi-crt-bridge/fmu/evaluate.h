/* Force and rates of a corner at its inputs and states. */
#ifndef DASHPOT_EVALUATE_H
#define DASHPOT_EVALUATE_H

#include "data.h"

/* 0, or -1 after a word to the log. */
int instance_evaluate(struct instance *instance, int corner);

#endif
