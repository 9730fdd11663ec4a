#include "axial.h"
#include "messages.h"
#include "solver.h"

#include <math.h>

static const double ORDINARY_TEMPERATURE = 20.0;

int axial_begin(int kind, int element, int iflag)
{
    switch (iflag) {
    case SOLVER_EVALUATE:
        return AXIAL_CALCULATE;
    case SOLVER_INITIALISE:
        committed_forget(kind, element);
        return AXIAL_ASK_ONLY;
    case SOLVER_DEPENDENCIES:
        return AXIAL_ASK_ONLY;
    case SOLVER_DESTROY:
        committed_forget(kind, element);
        return AXIAL_DONE;
    case SOLVER_SAVE:
        committed_save(kind, element);
        return AXIAL_DONE;
    case SOLVER_RELOAD:
        committed_reload(kind, element);
        return AXIAL_DONE;
    default:
        return AXIAL_DONE;
    }
}

int axial_parameters(int element, int npar, const double *par, int iflag, axial_damper *damper)
{
    if (npar != 2 && npar != 3 && npar != 4 && npar != 6 && npar != 7) {
        message_stop(element, "%d USER values for the damper; it takes string, length at zero displacement [, temperature "
                              "[, length unit, force unit, time unit] [, id of a VARIABLE with the setting]]", npar);
        return -1;
    }
    damper->variable = axial_variable(npar, par);
    if ((npar == 4 || npar == 7) && damper->variable == 0) {
        message_stop(element, "%d USER values, the last %g; behind string, length at zero displacement, temperature [, length unit, "
                              "force unit, time unit] it must be the id of a VARIABLE with the setting", npar, par[npar - 1]);
        return -1;
    }
    /* If the three units are given, they follow the temperature and precede the variable. */
    damper->damper = damper_model_of(element, npar == 7 ? 6 : npar == 4 ? 3 : npar, par, 3, iflag == SOLVER_INITIALISE);
    if (!damper->damper)
        return -1;
    damper->zero_length = units_displacement(&damper->damper->units, par[1]);
    damper->temperature = npar > 2 ? par[2] : ORDINARY_TEMPERATURE;
    return 0;
}

int axial_variable(int npar, const double *par)
{
    double id = npar == 4 || npar == 7 ? par[npar - 1] : 0.0;
    return id > 0.0 && id < 2e9 && id == floor(id) ? (int)id : 0;
}

int axial_setting(int element, int variable, double *setting)
{
    int failed = 0;
    *setting = 0.0;
    if (!solver()->sysfnc) {
        message_stop(element, "the solver has no function c_sysfnc, which the setting of VARIABLE/%d needs", variable);
        return -1;
    }
    solver()->sysfnc("VARVAL", &variable, 1, setting, &failed);
    if (failed) {
        message_stop(element, "the solver gives no value of VARIABLE/%d, which is to be the setting", variable);
        return -1;
    }
    return 0;
}

void axial_setting_partial(int variable, double by_setting)
{
    int failed = 0;
    solver()->syspar("VARVAL", &variable, 1, &by_setting, 1, &failed);
}

int axial_progress(const axial_damper *damper, double *accepted)
{
    int mode = 0;
    double time = 0.0;
    solver()->getmod(&mode);
    solver()->timget(&time);
    *accepted = units_time(&damper->damper->units, time);
    if (mode == SOLVER_LINEAR)
        return ANALYSIS_LINEAR;
    return mode == SOLVER_STATICS || mode == SOLVER_QUASI_STATICS ? ANALYSIS_STATIC : ANALYSIS_DYNAMIC;
}

int axial_wants_partials(void)
{
    const solver_functions *s = solver();
    int wanted = 0;
    if (s->needs_partials && s->syspar)
        s->needs_partials(&wanted);
    return wanted;
}

void axial_sforce(int kind, int element, int npar, const double *par, int i, int j, double time, int dflag, int iflag,
                  double *result)
{
    const solver_functions *s = solver();
    const char *lacks = solver_lacks(SOLVER_FOR_LINE);
    const unit_scales *u;
    int markers[2], failed = 0, analysis, is_static, wanted, what;
    double length = 0.0, speed = 0.0, setting = 0.0, accepted;
    int variable = axial_variable(npar, par);
    axial_damper damper;
    force_answer answer;
    request asked;

    *result = 0.0;
    if (lacks) {
        message_stop(element, "the solver has no function %s, which a force needs", lacks);
        return;
    }
    what = axial_begin(kind, element, iflag);
    if (what == AXIAL_DONE)
        return;
    /* The solver records these calls of DM and VR as dependencies, so they must be equal for every purpose (iflag) of the call. */
    markers[0] = i;
    markers[1] = j;
    s->sysfnc("DM", markers, 2, &length, &failed);
    if (!failed)
        s->sysfnc("VR", markers, 2, &speed, &failed);
    if (failed) {
        message_stop(element, "the solver gives no distance and speed between markers %d and %d", i, j);
        return;
    }
    if (variable && axial_setting(element, variable, &setting))
        return;
    if (axial_parameters(element, npar, par, iflag, &damper) || what == AXIAL_ASK_ONLY)
        return;
    u = &damper.damper->units;
    analysis = axial_progress(&damper, &accepted);
    is_static = analysis == ANALYSIS_STATIC;
    asked.time = units_time(u, time);
    asked.input = dashpot_input_motion(units_displacement(u, length) - damper.zero_length,
                                       is_static ? 0.0 : units_velocity(u, speed));
    asked.input.known |= DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE;
    asked.input.temperature = damper.temperature;
    if (variable)
        asked.input = dashpot_input_with_setting(asked.input, setting);
    if (is_static)
        asked.time = accepted;
    wanted = axial_wants_partials();
    if (committed_force(kind, element, damper.damper, &asked, accepted, analysis, dflag != 0, wanted, &answer))
        return;
    *result = units_sforce(u, answer.force);
    if (wanted) {
        double by_length = units_sforce(u, answer.by_displacement) * u->length;
        double by_speed = is_static ? 0.0 : units_sforce(u, answer.by_velocity) * u->length / u->time;
        s->syspar("DM", markers, 2, &by_length, 1, &failed);
        s->syspar("VR", markers, 2, &by_speed, 1, &failed);
        if (variable)
            axial_setting_partial(variable, units_sforce(u, answer.by_setting));
    }
}
