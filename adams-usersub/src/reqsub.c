/* What goes on inside a damper that is called as a force (a GSE has its outputs for this):
 *
 *     REQUEST/1, FUNCTION=USER(kind, element [, length unit, force unit, time unit])\
 *     , ROUTINE=dashpot_adams::Dashpot_reqsub
 *
 * kind 1: SFORCE/element, 2: GFORCE/element. Results, tension positive: force, series deflection, velocity of the internal
 * mass, force of the primary damper, springs, friction, gas, displacement. */
#include "committed.h"
#include "entry.h"
#include "messages.h"

void Dashpot_reqsub(const adams_request *req, double time, int iflag, double *output)
{
    unit_scales u;
    dashpot_output o;
    dashpot_state state;
    const char *lacks = solver_lacks(SOLVER_FOR_FORCES);
    int i;
    (void)time;
    for (i = 0; i < 8; i++)
        output[i] = 0.0;
    if (iflag != SOLVER_EVALUATE)
        return;
    if (lacks) {
        message_stop(req->id, "the solver has no function %s, which a request needs", lacks);
        return;
    }
    if ((req->npar != 2 && req->npar != 5) || (req->par[0] != KIND_SFORCE && req->par[0] != KIND_GFORCE)) {
        message_stop(req->id, "a damper's request takes USER(kind, element [, length unit, force unit, time unit]); kind is "
                              "1 for an SFORCE, 2 for a GFORCE");
        return;
    }
    if (units_read(req->id, req->npar == 5 ? req->par + 2 : NULL, &u))
        return;
    /* Before the first force there is nothing to tell. */
    if (committed_last((int)req->par[0], (int)req->par[1], &o, &state))
        return;
    output[0] = o.force / u.force;
    output[1] = o.series_deflection / u.length;
    output[2] = state.mass_velocity * u.time / u.length;
    output[3] = o.primary_force / u.force;
    output[4] = o.spring_force / u.force;
    output[5] = o.friction_force / u.force;
    output[6] = o.gas_force / u.force;
    output[7] = state.displacement / u.length;
}
