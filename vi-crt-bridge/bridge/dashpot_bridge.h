/* dashpot as an external damper of a fixed-step vehicle simulator: one corner or four, over dashpot.h.
 *
 *     dashpot_bridge_fault fault;
 *     const char *models[4] = {"front.toml", "front.toml", "rear.toml", "rear.toml"};
 *     dashpot_bridge *car = dashpot_bridge_create(4, models, NULL, &fault);   // NULL: no channel map, SI
 *     if (!car) { puts(fault.text); exit(1); }
 *     dashpot_bridge_init(car, in, out);                                      // at the static position
 *     while (running)
 *         dashpot_bridge_step(car, dt, in, out);
 *     dashpot_bridge_destroy(car);
 *
 * Corners come in the order L1, R1, L2, R2 (front left, front right, rear left, rear right).
 *
 * Only dashpot_bridge_create() reads files and allocates memory; dashpot_bridge_destroy() frees it. Every other function
 * runs in bounded time and takes no lock. A bridge has no global state; different bridges may run in different threads.
 *
 * The signs and units of inputs and outputs are those of the channel map. Without a map they are SI, with jounce and force
 * positive in compression: a damper under compression pushes wheel and body apart with a positive force.
 *
 * The kernel divides a host step into substeps. With `substeps = 0` in the model file (the default) their number follows
 * from the model's stiffness and the host's step. The force is then within 0.1 % rms of the converged one at host steps
 * from 0.25 to 2 ms (tests/tests/system/hosts/bridge_accuracy.rs). */
#ifndef DASHPOT_BRIDGE_H
#define DASHPOT_BRIDGE_H

#include "channel_map.h"
#include "corner.h"

#ifdef __cplusplus
extern "C" {
#endif

#define DASHPOT_BRIDGE_CORNERS 4

typedef struct dashpot_bridge dashpot_bridge;

/* Bits of dashpot_corner_input.known. */
#define DASHPOT_CORNER_KNOWS_JOUNCE 1u
#define DASHPOT_CORNER_KNOWS_ACCELERATION 2u
#define DASHPOT_CORNER_KNOWS_SIDE_FORCE 4u
#define DASHPOT_CORNER_KNOWS_TEMPERATURE 8u
#define DASHPOT_CORNER_KNOWS_SETTING 16u

/* The host's input of a corner, in its own signs and units. `known` has a bit for each optional input that the host gives.
 * jounce_rate is always needed. If jounce is not given, it is integrated from the jounce at init. The acceleration has no
 * effect, because no element needs it. */
typedef struct dashpot_corner_input {
    double jounce;
    double jounce_rate;
    double jounce_acceleration;
    double side_force;
    double temperature; /* degrees Celsius */
    double setting;     /* setting of a damper that depends on one, in the unit of its model file */
    uint32_t known;
    uint32_t reserved;
} dashpot_corner_input;

/* The output of a corner for the host, in its own signs and units. */
typedef struct dashpot_corner_output {
    double force;
    double d_force_d_rate;   /* derivative of the force with respect to the jounce rate */
    double d_force_d_jounce; /* derivative of the force with respect to jounce */
    int32_t status;         /* 0, warnings of dashpot.h, or DASHPOT_BRIDGE_LAST_FORCE */
    uint32_t reserved;
} dashpot_corner_output;

/* Reason why dashpot_bridge_create() failed. */
typedef struct dashpot_bridge_fault {
    char text[600];
} dashpot_bridge_fault;

/* All data of a bridge that change during a run, for dashpot_bridge_save() and dashpot_bridge_restore(). */
typedef struct dashpot_bridge_state {
    dashpot_corner_state corner[DASHPOT_BRIDGE_CORNERS];
} dashpot_bridge_state;

/* Makes a bridge of `corners` (1 or 4) dampers. `models` are the model files, one per corner; they may be the same file.
 * `map` is the channel map file, or null for SI. On failure it returns null with the reason in *fault. */
dashpot_bridge *dashpot_bridge_create(uint32_t corners, const char *const *models, const char *map,
                                      dashpot_bridge_fault *fault);

void dashpot_bridge_destroy(dashpot_bridge *bridge);

uint32_t dashpot_bridge_corners(const dashpot_bridge *bridge);

/* Puts every damper at rest at its jounce, in equilibrium, and outputs the static forces. Returns the statuses of all
 * corners combined with "or", as dashpot_bridge_step() does. */
int32_t dashpot_bridge_init(dashpot_bridge *bridge, const dashpot_corner_input *in, dashpot_corner_output *out);

/* Advances all dampers by dt seconds; the inputs are those at the end of the step. dt = 0 is a static evaluation and keeps
 * the states. A corner whose input is rejected (not finite, too large) keeps its last force. Returns the statuses of all
 * corners combined with "or". */
int32_t dashpot_bridge_step(dashpot_bridge *bridge, double dt, const dashpot_corner_input *in,
                            dashpot_corner_output *out);

/* Save and restore the state. A run continued from a restored state repeats the first run bit by bit. */
void dashpot_bridge_save(const dashpot_bridge *bridge, dashpot_bridge_state *state);
void dashpot_bridge_restore(dashpot_bridge *bridge, const dashpot_bridge_state *state);

/* Flat vectors, for hosts that select channels by name. Their entries are the channels that the map names, corner by
 * corner. Without a map they are jounce_L1, jounce_rate_L1, jounce_R1, ... and force_L1, force_R1, ... */
uint32_t dashpot_bridge_input_count(const dashpot_bridge *bridge);
uint32_t dashpot_bridge_output_count(const dashpot_bridge *bridge);
const char *dashpot_bridge_input_name(const dashpot_bridge *bridge, uint32_t i);  /* null if i is too large */
const char *dashpot_bridge_output_name(const dashpot_bridge *bridge, uint32_t i); /* null if i is too large */

/* dashpot_bridge_init() and dashpot_bridge_step() with flat vectors. `inputs` and `outputs` must equal the counts above;
 * otherwise the functions return DASHPOT_BRIDGE_LAST_FORCE and change nothing. */
int32_t dashpot_bridge_init_vector(dashpot_bridge *bridge, const double *u, uint32_t inputs, double *y,
                                   uint32_t outputs);
int32_t dashpot_bridge_step_vector(dashpot_bridge *bridge, double dt, const double *u, uint32_t inputs, double *y,
                                   uint32_t outputs);

/* Stability of an explicit exchange of motion and force, by the ratio a = c h / m. c is the derivative of the damper's
 * force with respect to the rate. m is the effective mass (kg) at the host's point, h the host's step. During a run c is
 * d_force_d_rate + h d_force_d_jounce of an output, because jounce changes with its rate during a step. For a bound before
 * the run c is dashpot_bridge_max_derivative(). */
typedef enum dashpot_coupling {
    DASHPOT_COUPLING_CALM = 0,        /* a <= 0.25: no oscillation even with one step of delay */
    DASHPOT_COUPLING_DELAY_RINGS = 1, /* a <= 1: decaying oscillation with one step of delay */
    DASHPOT_COUPLING_RINGS = 2,       /* a < 2: decaying oscillation without delay, unstable with one step of delay */
    DASHPOT_COUPLING_UNSTABLE = 3     /* a >= 2: unstable */
} dashpot_coupling;
dashpot_coupling dashpot_bridge_coupling(double d_force_d_rate, double effective_mass, double dt, double *ratio);

/* Returns the largest |d(force)/d(rate)| of a corner for a step dt at damper speeds up to 3.2 m/s, friction included, in
 * the host's units. It is an input of dashpot_bridge_coupling() for a check before the first run. */
double dashpot_bridge_max_derivative(const dashpot_bridge *bridge, uint32_t corner, double dt);

/* Result of the self-test for one corner. The test moves every corner by +-20 mm at 1 Hz in the host's signs and units. */
typedef struct dashpot_self_test {
    uint32_t dissipates;    /* 1 if force and motion take energy out of the host */
    int32_t sign_at_jounce; /* sign of force - static force while jounce grows: +1 or -1 */
    double energy;          /* J per cycle taken out of the host; negative if the damper supplies energy */
    double peak_force;      /* largest |force - static force|, host's units */
} dashpot_self_test;

/* Runs the self-test. push_positive is 1 if a positive force of the host pushes wheel and body apart, rate_compresses 1 if
 * a positive rate compresses. Pass the convention of the host itself, because the test checks the map against it.
 * length_unit is the host's unit of motion in m (0.001 for mm), force_unit its unit of force in N. The bridge's state does
 * not change. Returns 1 if every corner dissipates. */
int dashpot_bridge_self_test(const dashpot_bridge *bridge, int push_positive, int rate_compresses, double length_unit,
                             double force_unit, dashpot_self_test result[DASHPOT_BRIDGE_CORNERS]);

#ifdef __cplusplus
}
#endif

#endif
