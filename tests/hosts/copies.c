/* Checks bit for bit that a repeated run, a run in place and a batch of four corners equal plain calls. */
#include "check.h"
#include "dashpot.h"

#include <stddef.h>
#include <string.h>

/* Bytes of the state that an ordinary damper uses. The commands after them belong to a damper that depends on a
 * setting. */
#define STATE offsetof(dashpot_state, commands)

enum { CORNERS = 4, STEPS = 400 };
static const double DT = 1e-3;

static dashpot_params params = DASHPOT_PARAMS_INIT;
static dashpot_model front, rear;

/* Returns a velocity, m/s: a triangle wave that differs by corner and needs no library function. */
static double velocity(int corner, int i) {
  const int period = 40 + 6 * corner, phase = i % period;
  const double rise = (phase < period / 2 ? phase : period - phase) / (double)period;
  return 4.0 * rise - 1.0;
}

static int same(const void *a, const void *b, size_t size) { return memcmp(a, b, size) == 0; }

int main(void) {
  static const double linear = 1.0;
  const dashpot_model *models[CORNERS] = {&front, &front, &rear, &rear};
  dashpot_state state[CORNERS], batch[CORNERS], saved, again;
  dashpot_output output, answers[CORNERS], kept;
  dashpot_input inputs[CORNERS], input;
  double force, list[63];
  uint32_t count, on;
  int corner, i;

  CHECK(dashpot_params_default(&params) == DASHPOT_OK);
  CHECK(dashpot_model_init(&front, &params) == DASHPOT_OK);
  CHECK(dashpot_params_set(&params, "fv_interpolation", linear) == DASHPOT_OK);
  CHECK(dashpot_params_enable(&params, "lagged_polynomial", 1) == DASHPOT_OK);
  CHECK(dashpot_params_enable(&params, "gas_preload", 0) == DASHPOT_OK);
  CHECK(dashpot_params_is_on(&params, "gas_preload", &on) == DASHPOT_OK && on == 0);
  CHECK(dashpot_params_is_on(&params, "lagged_polynomial", &on) == DASHPOT_OK && on == 1);
  CHECK(dashpot_params_get(&params, "fv_interpolation", &force) == DASHPOT_OK && force == linear);
  CHECK(dashpot_params_get_list(&params, "fv_force", NULL, 0, &count) == DASHPOT_OK && count > 1);
  CHECK(dashpot_params_get_list(&params, "fv_force", list, 63, &count) == DASHPOT_OK);
  CHECK(dashpot_params_set_list(&params, "fv_force", list, count) == DASHPOT_OK);
  CHECK(dashpot_model_init(&rear, &params) == DASHPOT_OK);

  /* A batch of four corners, in place, equals four single calls that are not in place. */
  for (corner = 0; corner < CORNERS; corner++) {
    CHECK(dashpot_state_init(models[corner], -0.01 * corner, &state[corner]) == DASHPOT_OK);
    batch[corner] = state[corner];
  }
  for (i = 0; i < STEPS; i++) {
    int32_t single = 0, together;
    for (corner = 0; corner < CORNERS; corner++) inputs[corner] = dashpot_input_velocity(velocity(corner, i));
    together = dashpot_step_batch(CORNERS, models, batch, inputs, DT, batch, answers);
    for (corner = 0; corner < CORNERS; corner++) {
      dashpot_state next;
      single |= dashpot_step(models[corner], &state[corner], &inputs[corner], DT, &next, &output);
      CHECK(same(&next, &batch[corner], STATE) && same(&output, &answers[corner], sizeof output));
      state[corner] = next;
    }
    CHECK(together == single);
  }
  CHECK(state[0].mass_displacement != state[1].mass_displacement && state[3].internal[0] != state[2].internal[0]);
  CHECK(dashpot_step_batch(0, models, batch, inputs, DT, batch, answers) == DASHPOT_OK);

  /* A run repeated from a copy of the state, not in place, equals the run in place. */
  for (corner = 0; corner < CORNERS; corner++) {
    saved = state[corner];
    for (i = 0; i < STEPS; i++) {
      input = dashpot_input_motion(state[corner].displacement + DT * velocity(corner, i), velocity(corner, i));
      CHECK(dashpot_step(models[corner], &state[corner], &input, DT, &state[corner], &kept) == DASHPOT_OK);
    }
    again = saved;
    for (i = 0; i < STEPS; i++) {
      dashpot_state next, probe;
      input = dashpot_input_motion(again.displacement + DT * velocity(corner, i), velocity(corner, i));
      CHECK(dashpot_step(models[corner], &again, &input, DT, &next, &output) == DASHPOT_OK);
      /* A trial step with another velocity, whose result is dropped, has no effect on the next step. */
      input.velocity += 0.125;
      CHECK(dashpot_step(models[corner], &again, &input, DT, &probe, &answers[0]) == DASHPOT_OK);
      CHECK(!same(&probe, &next, STATE));
      again = next;
    }
    CHECK(same(&again, &state[corner], STATE) && same(&output, &kept, sizeof output));
  }

  /* dashpot_force() equals dashpot_step() with the velocity as the only input. */
  CHECK(dashpot_state_init(&rear, 0.02, &again) == DASHPOT_OK);
  saved = again;
  for (i = 0; i < STEPS; i++) {
    input = dashpot_input_velocity(velocity(0, i));
    CHECK(dashpot_step(&rear, &saved, &input, DT, &saved, &output) == DASHPOT_OK);
    CHECK(dashpot_force(&rear, &again, velocity(0, i), DT, &force) == DASHPOT_OK);
    CHECK(same(&saved, &again, STATE) && same(&force, &output.force, sizeof force));
  }

  /* dt = 0 gives the static force and keeps the state. */
  CHECK(dashpot_state_init(&front, 0.0, &again) == DASHPOT_OK);
  saved = again;
  CHECK(dashpot_force(&front, &again, 0.0, 0.0, &force) == DASHPOT_OK);
  CHECK(same(&saved, &again, STATE));
  input = dashpot_input_velocity(0.0);
  CHECK(dashpot_step(&front, &saved, &input, DT, &again, &output) == DASHPOT_OK);
  CHECK(output.force - force < 1e-6 && force - output.force < 1e-6);
  CHECK(dashpot_evaluate(&front, &saved, &input, &kept, &again) == DASHPOT_OK);
  CHECK(kept.force - force < 1e-6 && force - kept.force < 1e-6);
  return failures != 0;
}
