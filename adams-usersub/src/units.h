/* Model units to SI and back, and the sign of Adams: the only place where either changes.
 *
 * An SFORCE is positive where it pushes its markers apart; dashpot's force is positive in tension. */
#ifndef UNITS_H
#define UNITS_H

/* SI units in one model unit: 0.001 for a length in mm. */
typedef struct {
    double length, force, time;
} unit_scales;

/* The model's units from the solver; where `given` is not null it holds length, force and time instead. Returns 0, or
 * -1 after a message. */
int units_read(int element, const double *given, unit_scales *scales);

double units_displacement(const unit_scales *u, double model);
double units_velocity(const unit_scales *u, double model);
double units_force(const unit_scales *u, double model);
double units_time(const unit_scales *u, double model);
/* From a tension in N to what an SFORCE takes: rebound gives a negative number. */
double units_sforce(const unit_scales *u, double tension);

#endif
