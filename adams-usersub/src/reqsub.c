/* Internal quantities of a damper that is called as a force, as a REQUEST (a GSE has outputs instead):
 *
 *     REQUEST/1, FUNCTION=USER(kind, element [, page [, length unit, force unit, time unit]])\
 *     , ROUTINE=dashpot_adams::Dashpot_reqsub
 *
 * kind 1: SFORCE/element, 2: GFORCE/element. A REQUEST has eight results, so there are two pages, tension positive:
 *
 * page 1 (or left out): force, series deflection, velocity of the internal mass, force of the primary damper, springs,
 *     friction (hysteresis included), gas, displacement
 * page 2: force of the stops, oil temperature, displacement and velocity of the moving end, displacement of the
 *     internal mass, first three internal states of the elements (SI, for example of the hysteresis)
 */
#include "committed.h"
#include "entry.h"
#include "messages.h"

enum { RESULTS = 8, FORCES = 1, MOTIONS = 2 };

static int is_right(int npar, const double *par)
{
    if (npar != 2 && npar != 3 && npar != 6)
        return 0;
    if (par[0] != KIND_SFORCE && par[0] != KIND_GFORCE)
        return 0;
    return npar == 2 || par[2] == FORCES || par[2] == MOTIONS;
}

void Dashpot_reqsub(const adams_request *req, double time, int iflag, double *output)
{
    unit_scales u;
    dashpot_output o;
    dashpot_state state;
    const char *lacks = solver_lacks(SOLVER_FOR_REQUESTS);
    int i;
    (void)time;
    for (i = 0; i < RESULTS; i++)
        output[i] = 0.0;
    if (iflag != SOLVER_EVALUATE)
        return;
    if (lacks) {
        message_stop(req->id, "the solver has no function %s, which a request needs", lacks);
        return;
    }
    if (!is_right(req->npar, req->par)) {
        message_stop(req->id, "a damper's request takes USER(kind, element [, page [, length unit, force unit, time unit]]); "
                              "kind is 1 for an SFORCE, 2 for a GFORCE; page is 1 or 2");
        return;
    }
    if (units_read(req->id, req->npar == 6 ? req->par + 3 : NULL, &u))
        return;
    /* Before the first force request no output is stored, and the results stay 0. */
    if (committed_last((int)req->par[0], (int)req->par[1], &o, &state))
        return;
    if (req->npar > 2 && req->par[2] == MOTIONS) {
        output[0] = o.stop_force / u.force;
        output[1] = o.oil_temperature;
        output[2] = state.displacement / u.length;
        output[3] = state.velocity * u.time / u.length;
        output[4] = (state.displacement - o.series_deflection) / u.length;
        output[5] = state.internal[0];
        output[6] = state.internal[1];
        output[7] = state.internal[2];
        return;
    }
    output[0] = o.force / u.force;
    output[1] = o.series_deflection / u.length;
    output[2] = state.mass_velocity * u.time / u.length;
    output[3] = o.primary_force / u.force;
    output[4] = o.spring_force / u.force;
    output[5] = o.friction_force / u.force;
    output[6] = o.gas_force / u.force;
    output[7] = state.displacement / u.length;
}
