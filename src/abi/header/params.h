/** A parameter set before dashpot_params_default(): dashpot_params params = DASHPOT_PARAMS_INIT; */
#define DASHPOT_PARAMS_INIT {sizeof(dashpot_params), DASHPOT_ABI_VERSION, {0}}
