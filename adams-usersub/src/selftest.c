/* Self-test without a solver: load the library with dlopen() and call dashpot_adams_selftest(), which returns FINE (0) or
 * the number of the first failed check. */
#include "damper_model.h"
#include "entry.h"

enum {
    FINE = 0,
    OTHER_INTERFACE = 1, /* built with dashpot.h of another version */
    NO_MODEL = 2,        /* the default damper is rejected */
    NO_FORCE = 3,        /* a step is rejected */
    WRONG_SIGN = 4,      /* rebound does not give a negative SFORCE */
    WRONG_STATES = 5     /* the model does not use the two states of the internal mass */
};

int dashpot_adams_selftest(void)
{
    static const unit_scales MM_N_S = {1e-3, 1.0, 1.0};
    static dashpot_params params;
    static damper_model damper;
    dashpot_state state;
    double force = 0.0;
    int i;
    params.struct_size = sizeof params;
    params.abi_version = DASHPOT_ABI_VERSION;
    if (dashpot_abi_version() != DASHPOT_ABI_VERSION)
        return OTHER_INTERFACE;
    if (dashpot_params_default(&params) < 0 || dashpot_model_init(&damper.model, &params) < 0 ||
        dashpot_state_init(&damper.model, 0.0, &state) < 0)
        return NO_MODEL;
    for (i = 0; i < 50; i++)
        if (dashpot_force(&damper.model, &state, 0.3, 1e-3, &force) < 0)
            return NO_FORCE;
    if (!(force > 0.0 && units_sforce(&MM_N_S, force) < 0.0))
        return WRONG_SIGN;
    damper_model_find_states(&damper);
    return damper.states >= 2 && damper.used[0] && damper.used[1] ? FINE : WRONG_STATES;
}
