/* Conversion between the units of the Adams model and SI, and between the signs of Adams and dashpot.
 *
 * An SFORCE is positive if it pushes its markers apart; dashpot's force is positive in tension. Only units_sforce()
 * changes the sign. */
#ifndef UNITS_H
#define UNITS_H

/* SI units per model unit: length is 0.001 for a model in mm. */
typedef struct {
    double length, force, time;
} unit_scales;

/* Gets the model's units from the solver, or from `given` (length, force, time) if it is not null. Returns 0, or -1 after
 * a message. */
int units_read(int element, const double *given, unit_scales *scales);

double units_displacement(const unit_scales *u, double model);
double units_velocity(const unit_scales *u, double model);
double units_force(const unit_scales *u, double model);
double units_time(const unit_scales *u, double model);
/* Converts a tension in N to the value of an SFORCE: rebound gives a negative number. */
double units_sforce(const unit_scales *u, double tension);

#endif
