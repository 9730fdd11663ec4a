/* Makes many steps, so that their instructions can be counted: cost <steps> [force] [setting] [+<element> | -<element> | <parameter>
 * <value>]... Run it with two numbers of steps; the difference of the counts, divided by the difference of the steps, is the cost of one
 * dashpot_step(), or dashpot_force(). With `setting`, the FV curve and the friction depend on a setting that changes in every step. */
#include "dashpot.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { INPUTS = 64, SETTINGS = 5 };

/* Makes the FV curve and the friction depend on a setting with five values. */
static int32_t depend_on_a_setting(dashpot_params *params) {
  static const double grid[SETTINGS] = {0.0, 0.4, 0.8, 1.2, 1.6};
  double forces[63], stronger[63], friction[SETTINGS];
  uint32_t count, i;
  int32_t status = dashpot_params_get_list(params, "fv_force", forces, 63, &count);
  int k;
  if (status >= 0) status = dashpot_params_set_grid(params, grid, SETTINGS);
  for (k = 0; k < SETTINGS && status == DASHPOT_OK; k++) {
    for (i = 0; i < count; i++) stronger[i] = forces[i] * (1.0 + 0.2 * k * k);
    friction[k] = 40.0 + 5.0 * k;
    status = dashpot_params_set_list_over(params, "fv_force", (uint32_t)k, stronger, count);
  }
  return status == DASHPOT_OK ? dashpot_params_set_over(params, "stribeck_coulomb_force", friction, SETTINGS) : status;
}

int main(int argc, char **argv) {
  static dashpot_params params = DASHPOT_PARAMS_INIT;
  static dashpot_model model;
  static dashpot_input inputs[INPUTS];
  static dashpot_state state;
  static dashpot_output output;
  long steps = argc > 1 ? atol(argv[1]) : 0, i;
  double sum = 0.0, x = 0.0;
  int32_t status = dashpot_params_default(&params);
  const int force_alone = argc > 2 && strcmp(argv[2], "force") == 0;
  int k;
  for (k = 2 + force_alone; k < argc && status == DASHPOT_OK; k++) {
    const char *word = argv[k];
    if (strcmp(word, "setting") == 0) {
      status = depend_on_a_setting(&params);
    } else if (word[0] == '+' || word[0] == '-') {
      status = dashpot_params_enable(&params, word + 1, word[0] == '+');
    } else if (k + 1 < argc) {
      status = dashpot_params_set(&params, word, atof(argv[++k]));
    }
  }
  if (status == DASHPOT_OK) status = dashpot_model_init(&model, &params);
  if (status == DASHPOT_OK) status = dashpot_state_init(&model, 0.0, &state);
  /* A periodic motion in steps of 1 ms over the whole FV curve. */
  for (k = 0; k < INPUTS; k++) {
    const double t = (k < INPUTS / 2 ? k : k - INPUTS / 2) / (INPUTS / 2.0), v = (k < INPUTS / 2 ? 6.0 : -6.0) * t * (1.0 - t);
    x += 1e-3 * v;
    inputs[k] = dashpot_input_with_setting(dashpot_input_motion(x, v), 0.025 * k);
  }
  for (i = 0; i < steps && status == DASHPOT_OK; i++) {
    if (force_alone) {
      status = dashpot_force(&model, &state, inputs[i % INPUTS].velocity, 1e-3, &output.force);
    } else {
      status = dashpot_step(&model, &state, &inputs[i % INPUTS], 1e-3, &state, &output);
    }
    sum += output.force;
  }
  printf("%.17g %s\n", sum, dashpot_status_text(status));
  return status != DASHPOT_OK;
}
