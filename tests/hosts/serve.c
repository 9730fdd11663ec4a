/* A bridge behind a pipe, for hosts that are not written in C. Arguments: one model file, or four.
 *
 * Reads requests of doubles: dt, s, then jounce and jounce rate of every corner; a negative dt is init. Each output has, for every corner,
 * the force, d(force)/d(rate) + dt d(force)/d(jounce), and the status. There is no channel map, so units are SI and compression is
 * positive. */
#include "dashpot_bridge.h"
#include <stdio.h>
#include <unistd.h>

/* Reads a whole block from a pipe that may deliver it in pieces. Returns 0 if the input ends before. */
static int take(void *block, size_t size)
{
    size_t got = 0;

    while (got < size) {
        ssize_t n = read(0, (char *)block + got, size - got);
        if (n <= 0)
            return 0;
        got += (size_t)n;
    }
    return 1;
}

int main(int argc, char **argv)
{
    uint32_t corners = (uint32_t)(argc - 1), i;
    dashpot_bridge_fault fault;
    dashpot_bridge *bridge = dashpot_bridge_create(corners, (const char *const *)(argv + 1), NULL, &fault);
    dashpot_corner_input in[DASHPOT_BRIDGE_CORNERS] = {0};
    dashpot_corner_output out[DASHPOT_BRIDGE_CORNERS];
    double request[1 + 2 * DASHPOT_BRIDGE_CORNERS], answer[3 * DASHPOT_BRIDGE_CORNERS];

    if (!bridge) {
        fprintf(stderr, "%s\n", fault.text);
        return 1;
    }
    while (take(request, (1 + 2 * corners) * sizeof *request)) {
        for (i = 0; i < corners; i++) {
            in[i].jounce = request[1 + 2 * i];
            in[i].jounce_rate = request[2 + 2 * i];
            in[i].known = DASHPOT_CORNER_KNOWS_JOUNCE;
        }
        if (request[0] < 0.0)
            dashpot_bridge_init(bridge, in, out);
        else
            dashpot_bridge_step(bridge, request[0], in, out);
        for (i = 0; i < corners; i++) {
            answer[3 * i] = out[i].force;
            answer[3 * i + 1] = out[i].d_force_d_rate + request[0] * out[i].d_force_d_jounce;
            answer[3 * i + 2] = out[i].status;
        }
        if (write(1, answer, 3 * corners * sizeof *answer) != (ssize_t)(3 * corners * sizeof *answer))
            return 1;
    }
    dashpot_bridge_destroy(bridge);
    return 0;
}
