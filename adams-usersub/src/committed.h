/* Dampers that the solver calls as a plain force: their state at the last accepted time, and the force of a trial.
 *
 * A solver requests the force many times a step: predictor, iterations, differencing, a rejected step, the repeated step.
 * The result is a pure function of the committed state, the requested time and the requested motion. The committed state
 * advances only when the solver reports a newly accepted time (c_timget), never with a trial. */
#ifndef COMMITTED_H
#define COMMITTED_H

#include "damper_model.h"

/* Time and kernel input (motion, side force, temperature, setting) of one force request, SI. */
typedef struct {
    double time;
    dashpot_input input;
} request;

/* Kinds of Adams elements. The id of an element is unique only among the elements of its kind. */
enum { KIND_SFORCE = 1, KIND_GFORCE = 2 };

/* Result of a force request. The partial derivatives include the integration from the committed time to the request.
 * They are computed only if requested. */
typedef struct {
    double force;            /* N, tension positive */
    double by_displacement;  /* N/m */
    double by_velocity;      /* N s/m */
    double by_side_force;    /* - */
    double by_setting;       /* N per unit of the setting; 0 if no setting was given */
} force_answer;

/* Analysis of the solver. STATIC: velocities are zero and the time is constant. LINEAR: the force is that of steady
 * motion without dry friction; the last friction force is added as a constant. */
enum { ANALYSIS_DYNAMIC, ANALYSIS_STATIC, ANALYSIS_LINEAR };

/* Computes the force of element `element` for the request `asked`; `accepted` is the time that the solver accepted last.
 * `is_difference`: the call serves a finite difference of the solver, so that nothing is stored. `with_partials`: the
 * partial derivatives are computed too. Returns 0, or -1 after a message. */
int committed_force(int kind, int element, const damper_model *damper, const request *asked, double accepted,
                    int analysis, int is_difference, int with_partials, force_answer *answer);

/* Returns the last stored output of an element and its state, for REQUEST elements. Calls for a finite difference and
 * for a linear analysis store none. Returns 0, or -1 if no output is stored. */
int committed_last(int kind, int element, dashpot_output *output, dashpot_state *state);

/* Deletes the stored state of an element. */
void committed_forget(int kind, int element);

/* Write the stored state of an element to the solver's save file, and read it back. A failure gives a message. */
void committed_save(int kind, int element);
void committed_reload(int kind, int element);

#endif
