/* Error messages for the host's log. */
#ifndef DASHPOT_COMPLAIN_H
#define DASHPOT_COMPLAIN_H

#include "data.h"

/* Writes an error message to the host's log. Returns -1. */
int instance_complain(struct instance *instance, const char *format, ...);

#endif
