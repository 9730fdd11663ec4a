/* Dampers that are called as a plain force: what they were at the last accepted instant, and what they would be now.
 *
 * A solver asks for the force many times a step: predictor, iterations, differencing, a rejected step, the step again.
 * The answer is a pure function of the committed state, the time and the motion asked about. The committed state moves on
 * only when the solver says that it accepted a time (c_timget), never on a trial. */
#ifndef COMMITTED_H
#define COMMITTED_H

#include "damper_model.h"

/* Motion and surroundings at one instant, SI. */
typedef struct {
    double time;
    dashpot_input input;
} request;

/* Kinds of elements; ids are unique within a kind only. */
enum { KIND_SFORCE = 1, KIND_GFORCE = 2 };

/* What a call gets. The partials are those of the whole answer, all that happens since the committed instant included;
 * they are computed only where they are asked for. */
typedef struct {
    double force;            /* N, tension positive */
    double by_displacement;  /* N/m */
    double by_velocity;      /* N s/m */
    double by_side_force;    /* - */
    double by_setting;       /* N by the unit of the setting; 0 where none was given */
} force_answer;

/* What the solver analyses. Statics: velocities are zero and time stands still. LINEAR: the force is that of steady motion without dry
 * friction, whose last force is added as a constant. */
enum { ANALYSIS_DYNAMIC, ANALYSIS_STATIC, ANALYSIS_LINEAR };

/* The force of element `element` at `asked`, when the solver has accepted the time `accepted`. `is_difference`: the solver differences; nothing is stored. `with_partials`: the
 * partials are wanted too. Returns 0, or -1 after a message. */
int committed_force(int kind, int element, const damper_model *damper, const request *asked, double accepted,
                    int analysis, int is_difference, int with_partials, force_answer *answer);

/* The last answer of an element that was no difference, and the state there; for requests. Returns 0, or -1 where the
 * element was never asked. */
int committed_last(int kind, int element, dashpot_output *output, dashpot_state *state);

/* Forgets an element. */
void committed_forget(int kind, int element);

/* Save and reload. */
void committed_save(int kind, int element);
void committed_reload(int kind, int element);

#endif
