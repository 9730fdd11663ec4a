/* What SFOSUB, GFOSUB and the Fortran entry share: a force along the line between two markers. */
#ifndef AXIAL_H
#define AXIAL_H

#include "committed.h"

/* USER values of the line force, from `first` on: string, length at zero displacement [, temperature [, length unit,
 * force unit, time unit]] [, id of a VARIABLE with the setting]: with a variable 4 or 7 values. */
typedef struct {
    const damper_model *damper;
    double zero_length; /* m */
    double temperature; /* degrees Celsius */
    int variable;       /* id of the VARIABLE whose value is the setting; 0: none */
} axial_damper;

/* What a call with iflag asks; the entry points go on for the first, return for the last. */
enum { AXIAL_CALCULATE, AXIAL_ASK_ONLY, AXIAL_DONE };

/* Handles iflag: saves, reloads, forgets. */
int axial_begin(int kind, int element, int iflag);

/* Reads the USER values. Returns 0, or -1 after a message. */
int axial_parameters(int element, int npar, const double *par, int iflag, axial_damper *damper);

/* The id of the VARIABLE with the setting among the USER values; 0 where there is none, or none that can be one. */
int axial_variable(int npar, const double *par);

/* Asks for the value of a VARIABLE. Returns 0, or -1 after a message. */
int axial_setting(int element, int variable, double *setting);

/* Hands over the partial by the VARIABLE. `by_setting` in the force unit of the model. */
void axial_setting_partial(int variable, double by_setting);

/* What the solver analyses (ANALYSIS_...), and the time it has accepted, in s. */
int axial_progress(const axial_damper *damper, double *accepted);

/* Whether the solver wants partials now and can take them. */
int axial_wants_partials(void);

/* The whole of an SFOSUB between markers i and j. */
void axial_sforce(int kind, int element, int npar, const double *par, int i, int j, double time, int dflag, int iflag,
                  double *result);

#endif
