/* One instance of the damper FMU, whatever the FMI version: its variables, its phases, its step and its derivatives. */
#ifndef DASHPOT_INSTANCE_H
#define DASHPOT_INSTANCE_H

#include "complain.h"
#include "inputs.h"

/* Functions that return int return 0, or -1 after a message to the log. instance_new() returns null on failure. */
struct instance *instance_new(const char *name, const char *token, const char *resources, int exchange, int logging,
                              instance_log *log, void *logger, void *environment);
void instance_free(struct instance *instance);
int instance_reset(struct instance *instance);
int instance_enter_initialization(struct instance *instance, double start);
int instance_exit_initialization(struct instance *instance);
int instance_terminate(struct instance *instance);
int instance_get(struct instance *instance, uint32_t reference, enum type type, double *value);
int instance_set(struct instance *instance, uint32_t reference, enum type type, double value);
int instance_settle_parameters(struct instance *instance);
/* Brings outputs and rates up to date with inputs and states. */
int instance_refresh(struct instance *instance);

/* step.c. instance_step() returns 1 if an input was rejected and the last force is kept. */
int instance_step(struct instance *instance, double time, double dt);
int instance_set_derivative(struct instance *instance, uint32_t reference, int order, double value);

/* exchange.c. */
int instance_enter_event_mode(struct instance *instance);
int instance_enter_continuous_time(struct instance *instance);
int instance_set_time(struct instance *instance, double time);
int instance_states(struct instance *instance, double *states);
int instance_set_states(struct instance *instance, const double *states);
int instance_rates(struct instance *instance, double *rates);
int instance_nominals(struct instance *instance, double *nominals);
int instance_indicators(struct instance *instance, double *indicators);

/* partial.c. Computes d(unknown)/d(known) at the present time, inputs and states. */
int instance_partial(struct instance *instance, uint32_t unknown, uint32_t known, double *partial);

/* The FMU state as one block of memory, and its serialized form. */
size_t instance_data_bytes(const struct instance *instance);
size_t instance_bytes(const struct instance *instance);
void instance_serialize(const struct instance *instance, const struct data *data, unsigned char *bytes);
int instance_deserialize(struct instance *instance, struct data *data, const unsigned char *bytes, size_t size);

#endif
