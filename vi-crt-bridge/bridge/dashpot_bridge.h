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
 * Only create and destroy allocate and read files. Every other function takes a bounded time, allocates nothing, takes
 * no lock and always returns. A bridge has no global state; different bridges may run in different threads.
 *
 * Signs and units are the host's, as the channel map says. Without a map: SI, jounce and force positive in compression,
 * that is, a damper that is being compressed pushes wheel and body apart with a positive force.
 *
 * Substeps inside a host step are the kernel's: `substeps = 0` in the model file (the default) takes as many as the
 * model's stiffness and the host's step ask for, so that the force keeps within 0.1 % rms of the converged one at host steps
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

/* What the host knows of a corner, in its own signs and units. jounce_rate is always needed. Where jounce is not known
 * it is integrated from the jounce given at init. The acceleration is taken and not used: no element needs it. */
typedef struct dashpot_corner_input {
    double jounce;
    double jounce_rate;
    double jounce_acceleration;
    double side_force;
    double temperature; /* degrees Celsius */
    double setting;     /* of a damper that depends on one, in the unit of its model file */
    uint32_t known;
    uint32_t reserved;
} dashpot_corner_input;

/* What the host gets, in its own signs and units. */
typedef struct dashpot_corner_output {
    double force;
    double d_force_d_rate;   /* change of force per change of jounce rate */
    double d_force_d_jounce; /* change of force per change of jounce */
    int32_t status;         /* 0, warnings of dashpot.h, or DASHPOT_BRIDGE_LAST_FORCE */
    uint32_t reserved;
} dashpot_corner_output;

/* What create refused. */
typedef struct dashpot_bridge_fault {
    char text[600];
} dashpot_bridge_fault;

/* All that a bridge remembers while it runs; copying it is saving it. */
typedef struct dashpot_bridge_state {
    dashpot_corner_state corner[DASHPOT_BRIDGE_CORNERS];
} dashpot_bridge_state;

/* Makes a bridge of `corners` (1 or 4) dampers from model files, one per corner, which may be the same, and a channel map
 * file, or null for SI. Returns null with the reason in *fault. */
dashpot_bridge *dashpot_bridge_create(uint32_t corners, const char *const *models, const char *map,
                                      dashpot_bridge_fault *fault);

void dashpot_bridge_destroy(dashpot_bridge *bridge);

uint32_t dashpot_bridge_corners(const dashpot_bridge *bridge);

/* Puts every damper at rest at its jounce, settled, and answers with the static forces. Returns as step does. */
int32_t dashpot_bridge_init(dashpot_bridge *bridge, const dashpot_corner_input *in, dashpot_corner_output *out);

/* One step of dt seconds to the inputs at its end. dt = 0 is a static answer and leaves the states. An input that is not
 * finite holds that corner's last force. Returns the statuses of all corners together. */
int32_t dashpot_bridge_step(dashpot_bridge *bridge, double dt, const dashpot_corner_input *in,
                            dashpot_corner_output *out);

/* Saves and restores. A run continued from a restored state repeats the first to the last bit. */
void dashpot_bridge_save(const dashpot_bridge *bridge, dashpot_bridge_state *state);
void dashpot_bridge_restore(dashpot_bridge *bridge, const dashpot_bridge_state *state);

/* For hosts that choose channels by name: flat vectors, whose entries follow the channels that the map names, corner by
 * corner. Without a map: jounce_L1, jounce_rate_L1, jounce_R1, ... and force_L1, force_R1, ... */
uint32_t dashpot_bridge_input_count(const dashpot_bridge *bridge);
uint32_t dashpot_bridge_output_count(const dashpot_bridge *bridge);
const char *dashpot_bridge_input_name(const dashpot_bridge *bridge, uint32_t i);  /* null where there is none */
const char *dashpot_bridge_output_name(const dashpot_bridge *bridge, uint32_t i); /* null where there is none */

/* init and step with flat vectors of exactly the counts above; another count is answered with DASHPOT_BRIDGE_LAST_FORCE and
 * changes nothing. */
int32_t dashpot_bridge_init_vector(dashpot_bridge *bridge, const double *u, uint32_t inputs, double *y,
                                   uint32_t outputs);
int32_t dashpot_bridge_step_vector(dashpot_bridge *bridge, double dt, const double *u, uint32_t inputs, double *y,
                                   uint32_t outputs);

/* How near an explicit exchange of motion and force is to instability: a = c h / m with the damper's slope c, the
 * effective mass m (kg) at the host's point that the user gives, and the host's step h. c is d_force_d_rate + h d_force_d_jounce of an
 * answer, since jounce moves with its rate through a step, or dashpot_bridge_max_derivative(). */
typedef enum dashpot_coupling {
    DASHPOT_COUPLING_CALM = 0,        /* a <= 0.25: no oscillation even with one step of delay */
    DASHPOT_COUPLING_DELAY_RINGS = 1, /* a <= 1: with one step of delay it oscillates, and dies out */
    DASHPOT_COUPLING_RINGS = 2,       /* a < 2: oscillates without delay, unstable with one step of delay */
    DASHPOT_COUPLING_UNSTABLE = 3     /* a >= 2: unstable */
} dashpot_coupling;
dashpot_coupling dashpot_bridge_coupling(double d_force_d_rate, double effective_mass, double dt, double *ratio);

/* Steepest slope |change of force per change of rate| that a corner answers with over the speeds its curve knows,
 * friction included, in the host's units; what dashpot_bridge_coupling() wants for a check before the first run. */
double dashpot_bridge_max_derivative(const dashpot_bridge *bridge, uint32_t corner, double dt);

/* The self-test: drives every corner through strokes of +-20 mm at 1 Hz as the host would give them. */
typedef struct dashpot_self_test {
    uint32_t dissipates;    /* 1 where the host's force and motion take energy out of the host */
    int32_t sign_at_jounce; /* sign of the force the host receives while jounce grows: +1 or -1 */
    double energy;          /* J per stroke cycle taken out of the host; negative where the damper feeds it */
    double peak_force;      /* largest |force - static force|, host's units */
} dashpot_self_test;

/* Runs the self-test with the host's own meaning of its signs: push_positive is 1 where the host takes a positive force as
 * pushing wheel and body apart, rate_compresses 1 where a positive rate compresses. Give what the host does, not what
 * the map says: that is what is tested. length_unit is the m in the host's unit of motion (0.001 for mm), force_unit the N
 * in its unit of force. The bridge's state is as before. Returns 1 where every corner dissipates. */
int dashpot_bridge_self_test(const dashpot_bridge *bridge, int push_positive, int rate_compresses, double length_unit,
                             double force_unit, dashpot_self_test result[DASHPOT_BRIDGE_CORNERS]);

#ifdef __cplusplus
}
#endif

#endif
