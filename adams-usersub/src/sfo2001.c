/* The damper for a private Adams Car solver library, whose dispatcher calls a Fortran-style routine by number. The
 * structure is not handed on there, so that the markers are among the values:
 *
 *     USER(2001, i marker, j marker, string, length at zero displacement [, temperature [, units: 3 values]])
 */
#include "axial.h"
#include "entry.h"
#include "messages.h"

#include <math.h>

static int is_id(double value) { return fabs(value) < 2e9 && value == floor(value) && value > 0; }

void Dashpot_sfo2001(const int *id, const double *time, const double *par, const int *npar, const int *dflag,
                     const int *iflag, double *result)
{
    *result = 0.0;
    if (*npar < 5) {
        message_stop(*id, "%d USER values; this damper takes 2001, i marker, j marker, string, length at zero "
                          "displacement [, temperature [, length unit, force unit, time unit]]", *npar);
        return;
    }
    if (!is_id(par[1]) || !is_id(par[2])) {
        message_stop(*id, "USER values 2 and 3 must be the ids of the damper's markers, not %g and %g", par[1], par[2]);
        return;
    }
    axial_sforce(KIND_SFORCE, *id, *npar - 3, par + 3, (int)par[1], (int)par[2], *time, *dflag, *iflag, result);
}
