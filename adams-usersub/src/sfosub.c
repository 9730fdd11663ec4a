/* The damper as an SFORCE:
 *
 *     SFORCE/1, TRANSLATIONAL, I=11, J=12
 *     , FUNCTION=USER(string, length at zero displacement [, temperature [, length unit, force unit, time unit]
 *                     [, id of a VARIABLE with the setting]])\
 *     , ROUTINE=dashpot_adams::Dashpot_sfosub
 */
#include "axial.h"
#include "entry.h"
#include "messages.h"

#include <ctype.h>
#include <stddef.h>

void Dashpot_sfosub(const adams_sforce *sforce, double time, int dflag, int iflag, double *result)
{
    *result = 0.0;
    if (sforce->type != NULL && toupper((unsigned char)sforce->type[0]) == 'R') {
        message_stop(sforce->id, "a damper is an SFORCE of type TRANSLATIONAL, this one is %.20s", sforce->type);
        return;
    }
    axial_sforce(KIND_SFORCE, sforce->id, sforce->npar, sforce->par, sforce->i, sforce->j, time, dflag, iflag, result);
}
