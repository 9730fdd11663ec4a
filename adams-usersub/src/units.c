#include "units.h"
#include "messages.h"
#include "solver.h"

#include <string.h>

/* Indices of the scale factors that c_gtunts() returns. */
enum { TIME, LENGTH, FORCE, MASS, SCALES };

int units_read(int element, const double *given, unit_scales *scales)
{
    if (given) {
        scales->length = given[0];
        scales->force = given[1];
        scales->time = given[2];
    } else {
        double found[16];
        char names[256];
        int exists = 0;
        if (!solver()->gtunts) {
            message_stop(element, "the solver has no function c_gtunts, which tells the model's units; give length, force "
                                  "and time unit in SI as the last three USER values (0.001, 1, 1 for mm, N, s)");
            return -1;
        }
        memset(found, 0, sizeof found);
        memset(names, 0, sizeof names);
        solver()->gtunts(&exists, found, names);
        if (!exists) {
            message_stop(element, "the model has no UNITS; add a UNITS statement, or give length, force and time unit "
                                  "in SI as the last three USER values (0.001, 1, 1 for mm, N, s)");
            return -1;
        }
        scales->length = found[LENGTH];
        scales->force = found[FORCE];
        scales->time = found[TIME];
    }
    /* The negated form also rejects NaN. */
    if (!(scales->length > 0 && scales->force > 0 && scales->time > 0 && scales->length < 1e9 && scales->force < 1e9 &&
          scales->time < 1e9)) {
        message_stop(element, "units of length %g m, force %g N, time %g s cannot be; give them as the last three USER "
                              "values (0.001, 1, 1 for mm, N, s)",
                     scales->length, scales->force, scales->time);
        return -1;
    }
    return 0;
}

double units_displacement(const unit_scales *u, double model) { return model * u->length; }
double units_velocity(const unit_scales *u, double model) { return model * u->length / u->time; }
double units_force(const unit_scales *u, double model) { return model * u->force; }
double units_time(const unit_scales *u, double model) { return model * u->time; }
double units_sforce(const unit_scales *u, double tension) { return -tension / u->force; }
