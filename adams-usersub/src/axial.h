/* Functions common to Dashpot_sfosub() and Dashpot_gfosub(): a force along the line between two markers. */
#ifndef AXIAL_H
#define AXIAL_H

#include "committed.h"

/* USER values of the line force: string, length at zero displacement [, temperature [, length unit, force unit, time
 * unit]] [, id of a VARIABLE with the setting]. There are 2, 3 or 6 values, with a VARIABLE 4 or 7. */
typedef struct {
    const damper_model *damper;
    double zero_length; /* m */
    double temperature; /* degrees Celsius */
    int variable;       /* id of the VARIABLE whose value is the setting; 0: none */
} axial_damper;

/* Purpose of a call, from iflag. AXIAL_CALCULATE: compute the force. AXIAL_ASK_ONLY: call the solver's functions, so
 * that it records the dependencies, but compute no force. AXIAL_DONE: return. */
enum { AXIAL_CALCULATE, AXIAL_ASK_ONLY, AXIAL_DONE };

/* Handles iflag: saves, reloads or deletes the stored state of the element. Returns AXIAL_.... */
int axial_begin(int kind, int element, int iflag);

/* Reads the USER values and finds the damper's model. Returns 0, or -1 after a message. */
int axial_parameters(int element, int npar, const double *par, int iflag, axial_damper *damper);

/* Returns the id of the VARIABLE with the setting from the USER values; 0 if there is none or it is not a valid id. */
int axial_variable(int npar, const double *par);

/* Gets the value of a VARIABLE from the solver. Returns 0, or -1 after a message. */
int axial_setting(int element, int variable, double *setting);

/* Passes d(force)/d(VARIABLE) to the solver. `by_setting` is in the model's force unit per unit of the setting. */
void axial_setting_partial(int variable, double by_setting);

/* Returns the solver's analysis (ANALYSIS_...) and stores the time that it accepted last, in s, in *accepted. */
int axial_progress(const axial_damper *damper, double *accepted);

/* Returns 1 if the solver requests partial derivatives in this call and has a function that accepts them. */
int axial_wants_partials(void);

/* Computes the force of an SFORCE between markers i and j, and its partial derivatives if the solver requests them. */
void axial_sforce(int kind, int element, int npar, const double *par, int i, int j, double time, int dflag, int iflag,
                  double *result);

#endif
