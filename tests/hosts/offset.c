/* Compares a bridge, whose map states the distance between the zeros of rig and vehicle, with the kernel driven from the rig's zero.
 * Arguments: model file, channel map with position_offset_1 = -0.012 and position_offset_R2 = 0.02. */
#include "check.h"
#include "dashpot_bridge.h"
#include <math.h>

int main(int argc, char **argv)
{
    static const double offset[4] = {-0.012, -0.012, 0.0, 0.02};
    static dashpot_corner kernel[4];
    const char *models[4] = {argv[1], argv[1], argv[1], argv[1]};
    dashpot_corner_input in[4];
    dashpot_corner_output out[4];
    dashpot_bridge_fault fault;
    dashpot_fault reason;
    dashpot_bridge *bridge = argc == 3 ? dashpot_bridge_create(4, models, argv[2], &fault) : NULL;
    int k, i;

    if (!bridge)
        return 2;
    for (i = 0; i < 4; i++) {
        dashpot_corner_input rest = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, DASHPOT_CORNER_KNOWS_JOUNCE, 0};

        in[i] = rest;
        CHECK(dashpot_corner_load(&kernel[i], argv[1], &reason) == 0 && dashpot_corner_rest(&kernel[i], offset[i]) == 0);
    }
    dashpot_bridge_init(bridge, in, out);
    for (i = 0; i < 4; i++)
        CHECK(out[i].force == -kernel[i].now.output.force);
    CHECK(out[0].force != out[2].force); /* the model's spring makes the force depend on the position */
    for (k = 1; k <= 500; k++) {
        double jounce = 0.02 * sin(0.03 * k), rate = 0.6 * cos(0.03 * k);

        for (i = 0; i < 4; i++) {
            in[i].jounce = jounce;
            in[i].jounce_rate = rate;
        }
        dashpot_bridge_step(bridge, 1e-3, in, out);
        for (i = 0; i < 4; i++) {
            dashpot_input input = dashpot_input_motion(-jounce + offset[i], -rate);

            dashpot_corner_step(&kernel[i], &input, 1e-3);
            CHECK(out[i].force == -kernel[i].now.output.force);
        }
    }
    dashpot_bridge_destroy(bridge);
    return failures != 0;
}
