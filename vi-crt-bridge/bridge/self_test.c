/* Self-test: checks that each damper dissipates energy in the host's own signs of force and motion. */
#include "bridge.h"
#include <math.h>

#define TAU 6.283185307179586476925286766559
#define STEP 1e-3
#define AMPLITUDE 0.02

int dashpot_bridge_self_test(const dashpot_bridge *bridge, int push_positive, int rate_compresses, double length_unit,
                             double force_unit, dashpot_self_test result[DASHPOT_BRIDGE_CORNERS])
{
    /* Sign of the dissipated power. The power is positive if wheel and body approach under a force that pushes them apart. */
    double sense = (push_positive ? 1.0 : -1.0) * (rate_compresses ? 1.0 : -1.0);
    int all = 1, k;
    uint32_t i;

    for (i = 0; i < bridge->corners; i++) {
        const dashpot_corner *damper = &bridge->corner[i];
        dashpot_self_test *test = &result[i];
        dashpot_corner_input in = {0};
        dashpot_corner_state now;
        dashpot_input input;
        double force = bridge->map.force_scale[i];
        double rest, growing = 0.0, before = 0.0;

        test->dissipates = 0;
        test->sign_at_jounce = 0;
        test->energy = test->peak_force = 0.0;
        in.known = DASHPOT_CORNER_KNOWS_JOUNCE;
        input = dashpot_bridge_to_kernel(bridge, i, &in);
        if (dashpot_state_init(&damper->model, 0.0, &now.state) < 0 ||
            dashpot_step(&damper->model, &now.state, &input, 0.0, &now.state, &now.output) < 0) {
            all = 0;
            continue;
        }
        rest = force * now.output.force;
        /* One cycle to reach the periodic state, one to measure. */
        for (k = 1; k <= 2000; k++) {
            double phase = TAU * k * STEP, host;

            in.jounce = AMPLITUDE / length_unit * sin(phase);
            in.jounce_rate = AMPLITUDE / length_unit * TAU * cos(phase);
            input = dashpot_bridge_to_kernel(bridge, i, &in);
            if (dashpot_step(&damper->model, &now.state, &input, STEP, &now.state, &now.output) < 0)
                break;
            host = force * now.output.force;
            if (k > 1000) {
                test->energy += sense * host * force_unit * in.jounce_rate * length_unit * STEP;
                test->peak_force = fmax(test->peak_force, fabs(host - rest));
                growing += host - rest > 0.0 ? (in.jounce_rate > 0.0) : 0.0;
                before += host - rest > 0.0 ? (in.jounce_rate < 0.0) : 0.0;
            }
        }
        test->sign_at_jounce = growing > before ? 1 : -1;
        test->dissipates = k > 2000 && test->energy > 0.0;
        all &= (int)test->dissipates;
    }
    return all;
}
