/* Values that the host has set, and the kernel's input at a given time. */
#ifndef DASHPOT_INPUTS_H
#define DASHPOT_INPUTS_H

#include "data.h"

double *instance_values(const struct data *data);
double instance_given(const struct data *data, int corner, enum kind kind);
int instance_displacement_given(const struct data *data, int corner);
/* Returns the kernel's input from the values that the host has set last. */
dashpot_input instance_input(const struct data *data, int corner);
/* Returns the kernel's input at the present time, extrapolated or interpolated if the host set it for another time. */
dashpot_input instance_input_now(const struct instance *instance, int corner);
/* Returns the kernel's input at the end of a step dt that starts at the present time. */
dashpot_input instance_input_ahead(const struct instance *instance, int corner, double dt);
void instance_input_set(struct instance *instance, int corner);
void instance_input_seen(struct instance *instance, int corner);
void instance_input_forget(struct told *told);

#endif
