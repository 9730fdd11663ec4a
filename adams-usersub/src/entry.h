/* The entry points that Adams Solver calls by name, for example with ROUTINE=dashpot_adams::Dashpot_sfosub.
 *
 * Their names contain a capital letter, because the solver calls an all-lowercase name with the Fortran convention and
 * passes pointers instead of values. */
#ifndef ENTRY_H
#define ENTRY_H

#include "solver.h"

#if defined(_WIN32)
#define ENTRY_POINT __declspec(dllexport)
#else
#define ENTRY_POINT __attribute__((visibility("default")))
#endif

ENTRY_POINT void Dashpot_gse_deriv(const adams_gse *, double time, int dflag, int iflag, int n, double *rates);
ENTRY_POINT void Dashpot_gse_output(const adams_gse *, double time, int dflag, int iflag, int n, double *outputs);
ENTRY_POINT void Dashpot_gse_update(const adams_gse *, double time, int dflag, int iflag, int n, double *states);
ENTRY_POINT void Dashpot_gse_samp(const adams_gse *, double time, int iflag, double *interval);
ENTRY_POINT void Dashpot_sfosub(const adams_sforce *, double time, int dflag, int iflag, double *result);
ENTRY_POINT void Dashpot_gfosub(const adams_gforce *, double time, int dflag, int iflag, double *result);
ENTRY_POINT void Dashpot_reqsub(const adams_request *, double time, int iflag, double *output);
/* Checks the library without a solver. Returns 0 if it computes correctly, otherwise an error number of selftest.c. */
ENTRY_POINT int dashpot_adams_selftest(void);

#endif
