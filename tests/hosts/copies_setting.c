/* Checks bit for bit that copies of a state repeat the run of a damper that depends on a setting, with and without an actuator. The actuator has
 * a dead time, lags, rate limits and a hysteresis, so the whole state counts, with the commands of the dead time. */
#include "check.h"
#include "dashpot.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 4, STEPS = 400 };
static const double DT = 1e-3;

static dashpot_params params = DASHPOT_PARAMS_INIT;
static dashpot_model ordinary, direct, valve;

/* Returns a velocity, m/s: a triangle wave that differs by corner and needs no library function. */
static double velocity(int corner, int i) {
  const int period = 40 + 6 * corner, phase = i % period;
  const double rise = (phase < period / 2 ? phase : period - phase) / (double)period;
  return 4.0 * rise - 1.0;
}

/* Returns a command, A: steps up and down, shorter and longer than the dead time, and beyond the grid at times. */
static double command(int corner, int i) {
  static const double levels[5] = {0.0, 1.6, 0.4, 2.0, 1.1};
  return levels[(i / (2 + 5 * corner) + i / 90) % 5];
}

static int same(const void *a, const void *b, size_t size) { return memcmp(a, b, size) == 0; }

/* Makes the parameters of a family. Its force at speed and its friction grow with the setting. */
static void depend_on_a_setting(void) {
  static const double grid[3] = {0.0, 0.8, 1.6}, times[3] = {1.0, 1.5, 2.5}, friction[3] = {20.0, 30.0, 45.0};
  double forces[63], own[63];
  uint32_t count, i, k;
  CHECK(dashpot_params_get_list(&params, "fv_force", forces, 63, &count) == DASHPOT_OK);
  CHECK(dashpot_params_set_grid(&params, grid, 3) == DASHPOT_OK);
  for (i = 0; i < 3; i++) {
    for (k = 0; k < count; k++) own[k] = times[i] * forces[k];
    CHECK(dashpot_params_set_list_over(&params, "fv_force", i, own, count) == DASHPOT_OK);
  }
  CHECK(dashpot_params_enable(&params, "coulomb_friction", 1) == DASHPOT_OK);
  CHECK(dashpot_params_set_over(&params, "coulomb_force", friction, 3) == DASHPOT_OK);
}

static void prepare(void) {
  static const struct {
    const char *name;
    double value;
  } actuator[] = {{"setting_dead_time", 6e-3}, {"setting_time_up", 8e-3},  {"setting_time_down", 2e-2},
                  {"setting_rate_up", 120.0},  {"setting_rate_down", 60.0}, {"setting_hysteresis", 0.05}};
  size_t k;
  CHECK(dashpot_params_default(&params) == DASHPOT_OK);
  CHECK(dashpot_params_enable(&params, "oil_compressibility", 1) == DASHPOT_OK);
  CHECK(dashpot_model_init(&ordinary, &params) == DASHPOT_OK);
  depend_on_a_setting();
  CHECK(dashpot_model_init(&direct, &params) == DASHPOT_OK);
  for (k = 0; k < sizeof actuator / sizeof actuator[0]; k++)
    CHECK(dashpot_params_set(&params, actuator[k].name, actuator[k].value) == DASHPOT_OK);
  CHECK(dashpot_model_init(&valve, &params) == DASHPOT_OK);
}

static dashpot_input moved(double x, double v, double setting) {
  return dashpot_input_with_setting(dashpot_input_motion(x, v), setting);
}

/* A batch of four corners, in place, equals four single calls that are not in place. One of the dampers depends on no setting. */
static void check_batch(void) {
  const dashpot_model *models[CORNERS] = {&valve, &ordinary, &direct, &valve};
  dashpot_state state[CORNERS], batch[CORNERS], next;
  dashpot_output output, answers[CORNERS];
  dashpot_input inputs[CORNERS];
  double setting;
  int corner, i, outside = 0;
  for (corner = 0; corner < CORNERS; corner++) {
    CHECK(dashpot_state_init(models[corner], -0.01 * corner, &state[corner]) == DASHPOT_OK);
    batch[corner] = state[corner];
  }
  for (i = 0; i < STEPS; i++) {
    int32_t single = 0, together;
    for (corner = 0; corner < CORNERS; corner++)
      inputs[corner] = dashpot_input_with_setting(dashpot_input_velocity(velocity(corner, i)), command(corner, i));
    together = dashpot_step_batch(CORNERS, models, batch, inputs, DT, batch, answers);
    for (corner = 0; corner < CORNERS; corner++) {
      single |= dashpot_step(models[corner], &state[corner], &inputs[corner], DT, &next, &output);
      /* A damper without a setting writes no commands. */
      CHECK(same(&next, &batch[corner], models[corner] == &ordinary ? offsetof(dashpot_state, commands) : sizeof next));
      CHECK(same(&output, &answers[corner], sizeof output));
      state[corner] = next;
    }
    CHECK(together == single && together >= 0);
    outside |= (together & DASHPOT_OUTSIDE_SETTING) != 0;
  }
  CHECK(outside);
  /* The dampers with a valve differ by the course of their commands alone. */
  CHECK(dashpot_actuator_setting(&valve, &state[0], &inputs[0], &setting) == DASHPOT_OK);
  CHECK(setting > 0.0 && setting < 1.6 && !same(state[0].commands, state[3].commands, sizeof next.commands));
}

/* A run that is repeated from a saved state, not in place, equals the run in place. The state is saved as bytes in memory of its own, as a host does
 * that writes it to a file. Queries and trial steps between the steps change nothing. */
static void check_saved(const dashpot_model *model, int has_states) {
  dashpot_state state, again, next, probe;
  dashpot_output kept, output;
  dashpot_setting_derivatives by_setting;
  dashpot_input input;
  double setting, by;
  unsigned char *saved = malloc(sizeof state);
  int i;
  CHECK(saved != NULL);
  if (!saved) return;
  CHECK(dashpot_state_init(model, 0.02, &state) == DASHPOT_OK);
  for (i = 0; i < STEPS; i++) {
    input = moved(state.displacement + DT * velocity(0, i), velocity(0, i), command(0, i));
    CHECK(dashpot_step(model, &state, &input, DT, &state, &kept) >= 0);
    if (i == STEPS / 2) memcpy(saved, &state, sizeof state);
  }
  /* The restored state replaces one of another run. */
  CHECK(dashpot_state_init(model, -0.03, &again) == DASHPOT_OK);
  memcpy(&again, saved, sizeof again);
  free(saved);
  for (i = STEPS / 2 + 1; i < STEPS; i++) {
    input = moved(again.displacement + DT * velocity(0, i), velocity(0, i), command(0, i));
    probe = again;
    CHECK(dashpot_actuator_setting(model, &again, &input, &setting) >= 0);
    CHECK(dashpot_d_force_d_setting(model, &again, &input, DT, &by) >= 0);
    CHECK(dashpot_jacobian_setting(model, &again, &input, &by_setting) >= 0);
    CHECK(same(&probe, &again, sizeof again));
    CHECK(dashpot_step(model, &again, &input, DT, &next, &output) >= 0);
    /* A trial step with another command has another result, which is dropped. Behind a dead time, only the stored commands differ. */
    input.setting = input.setting > 1.0 ? 0.0 : 1.6;
    CHECK(dashpot_step(model, &again, &input, DT, &probe, &output) >= 0);
    CHECK(!has_states || !same(&probe, &next, sizeof next));
    input.setting = command(0, i);
    CHECK(dashpot_step(model, &again, &input, DT, &next, &output) >= 0);
    again = next;
  }
  CHECK(same(&again, &state, sizeof state) && same(&output, &kept, sizeof output));
}

/* dashpot_force_with_setting() equals dashpot_step() with velocity and setting as inputs. dashpot_force() has the start setting. */
static void check_force(const dashpot_model *model) {
  dashpot_state state, again, other;
  dashpot_output output;
  dashpot_input input;
  double force;
  int i;
  CHECK(dashpot_state_init(model, 0.02, &again) == DASHPOT_OK);
  state = other = again;
  for (i = 0; i < STEPS; i++) {
    int32_t status;
    input = dashpot_input_with_setting(dashpot_input_velocity(velocity(0, i)), command(0, i));
    status = dashpot_step(model, &state, &input, DT, &state, &output);
    CHECK(status >= 0 && dashpot_force_with_setting(model, &again, velocity(0, i), command(0, i), DT, &force) == status);
    CHECK(same(&state, &again, sizeof state) && same(&force, &output.force, sizeof force));
    CHECK(dashpot_force(model, &other, velocity(0, i), DT, &force) >= 0);
  }
  CHECK(!same(&state, &other, sizeof state));
}

/* dt = 0 gives the equilibrium force at the command, and keeps the state with its commands. */
static void check_at_rest(const dashpot_model *model) {
  dashpot_state state, again;
  dashpot_output output, soft;
  dashpot_input input = moved(0.0, 0.3, 1.6);
  CHECK(dashpot_state_init_motion(model, &input, &state) == DASHPOT_OK);
  again = state;
  CHECK(dashpot_step(model, &state, &input, 0.0, &state, &output) == DASHPOT_OK);
  CHECK(same(&state, &again, sizeof state));
  input.setting = 0.0;
  CHECK(dashpot_step(model, &state, &input, 0.0, &state, &soft) == DASHPOT_OK);
  CHECK(same(&state, &again, sizeof state) && soft.force < 0.7 * output.force);
}

int main(void) {
  const dashpot_model *families[2] = {&direct, &valve};
  int k;
  prepare();
  check_batch();
  for (k = 0; k < 2; k++) {
    check_saved(families[k], k);
    check_force(families[k]);
    check_at_rest(families[k]);
  }
  return failures != 0;
}
