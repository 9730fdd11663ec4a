/* A word to the host's log. */
#ifndef DASHPOT_COMPLAIN_H
#define DASHPOT_COMPLAIN_H

#include "data.h"

/* Says what is wrong; answers -1. */
int instance_complain(struct instance *instance, const char *format, ...);

#endif
