/* What the host has set, and what it means at an instant. */
#ifndef DASHPOT_INPUTS_H
#define DASHPOT_INPUTS_H

#include "data.h"

double *instance_values(const struct data *data);
double instance_given(const struct data *data, int corner, enum kind kind);
int instance_displacement_given(const struct data *data, int corner);
/* The kernel's input, as the host has set it. */
dashpot_input instance_input(const struct data *data, int corner);
/* The same as it is now, where the host set it a while ago. */
dashpot_input instance_input_now(const struct instance *instance, int corner);
/* The same at the end of a step that begins now. */
dashpot_input instance_input_ahead(const struct instance *instance, int corner, double dt);
void instance_input_set(struct instance *instance, int corner);
void instance_input_seen(struct instance *instance, int corner);
void instance_input_forget(struct told *told);

#endif
