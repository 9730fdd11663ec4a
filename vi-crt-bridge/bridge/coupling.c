/* Stability of an explicit exchange between host and damper. */
#include "bridge.h"
#include <math.h>

dashpot_coupling dashpot_bridge_coupling(double d_force_d_rate, double effective_mass, double dt, double *ratio)
{
    /* The host's velocity v follows v[k+1] = (1 - a) v[k] from step k to k + 1. With one more step of delay it follows
     * v[k+1] = v[k] - a v[k-1]. */
    double a = fabs(d_force_d_rate) * dt / effective_mass;

    if (ratio)
        *ratio = a;
    if (a <= 0.25)
        return DASHPOT_COUPLING_CALM;
    if (a <= 1.0)
        return DASHPOT_COUPLING_DELAY_RINGS;
    /* If the ratio is NaN or infinite (mass 0 or NaN), the comparisons fail and the result is UNSTABLE. */
    return a < 2.0 ? DASHPOT_COUPLING_RINGS : DASHPOT_COUPLING_UNSTABLE;
}

double dashpot_bridge_max_derivative(const dashpot_bridge *bridge, uint32_t corner, double dt)
{
    const dashpot_corner *damper = &bridge->corner[corner];
    double steepest = 0.0;
    int k;

    if (corner >= bridge->corners)
        return 0.0;
    /* Speed 0, and 0.13 mm/s to 3.2 m/s in both directions: friction is steep near zero, the force curve beyond. */
    for (k = -45; k <= 45; k++) {
        double speed = k == 0 ? 0.0 : 1e-4 * pow(10.0, (k < 0 ? -k : k) / 10.0);
        dashpot_input input = dashpot_input_velocity(k < 0 ? -speed : speed);
        dashpot_state state = damper->now.state;
        dashpot_output output;

        state.velocity = input.velocity;
        if (dashpot_step(&damper->model, &state, &input, dt, &state, &output) >= 0)
            steepest = fmax(steepest, fabs(output.d_force_d_velocity));
    }
    return steepest * fabs(bridge->map.force_scale[corner] * bridge->map.motion_scale[corner]);
}
