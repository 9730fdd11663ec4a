/* Measures how much stack each function of the interface uses, with several sets of elements. Each call runs on its own stack, which was
 * filled with a pattern. Prints one line per function with its name and the bytes, and exits with 1 if a function uses more than 16 KB. */
#define _GNU_SOURCE
#include "dashpot.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE = 1 << 20, MOST = 16384, PATTERN = 0x5a };

static dashpot_params params = DASHPOT_PARAMS_INIT;
static dashpot_model model, other;
static const dashpot_model *models[2] = {&model, &model};
static dashpot_state states[2], rate;
static dashpot_input inputs[2];
static dashpot_output outputs[2];
static dashpot_partials partials;
static dashpot_setting_derivatives by_setting;
static dashpot_fault fault;
static double force;
static int32_t status;
static const char text[] = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"bushing\"]\nfv_force = [-900.0, 0.0, 900.0]\n"
                           "fv_velocity = [-1.0, 0.0, 1.0]\nbushing_slip = 1e-4\n";

static void *nothing(void *unused) { return unused; }
static void *defaults(void *unused) { status = dashpot_params_default(&params); return unused; }
static void *set(void *unused) { status = dashpot_params_set(&params, "gas_force", 80.0); return unused; }
static void *check(void *unused) { status = dashpot_params_check(&params, &fault); return unused; }
static void *init(void *unused) { status = dashpot_model_init(&other, &params); return unused; }
static void *settle(void *unused) { status = dashpot_state_init(&model, 0.01, &rate); return unused; }
static void *one(void *unused) { status = dashpot_force(&model, &states[1], 0.3, 1e-3, &force); return unused; }
static void *step(void *unused) { status = dashpot_step(&model, states, inputs, 1e-3, &rate, outputs); return unused; }
static void *hold(void *unused) { status = dashpot_step(&model, states, inputs, 0.0, &rate, outputs); return unused; }
static void *one_set(void *unused) { status = dashpot_force_with_setting(&model, &states[1], 0.3, 1.1, 1e-3, &force); return unused; }
static void *actual(void *unused) { status = dashpot_actuator_setting(&model, states, inputs, &force); return unused; }
static void *gain(void *unused) { status = dashpot_d_force_d_setting(&model, states, inputs, 1e-3, &force); return unused; }
static void *by(void *unused) { status = dashpot_jacobian_setting(&model, states, inputs, &by_setting); return unused; }
static void *moving(void *unused) { status = dashpot_state_init_motion(&model, inputs, &rate); return unused; }
static void *batch(void *unused) { status = dashpot_step_batch(2, models, states, inputs, 1e-3, states, outputs); return unused; }
static void *evaluate(void *unused) { status = dashpot_evaluate(&model, states, inputs, outputs, &rate); return unused; }
static void *jacobian(void *unused) { status = dashpot_jacobian(&model, states, inputs, &partials); return unused; }
static void *info(void *unused) {
  static dashpot_parameter row;
  row.struct_size = sizeof row;
  status = dashpot_parameter_info(3, &row);
  return unused;
}
static void *read_setting(void *unused) {
  static dashpot_setting setting;
  setting.struct_size = sizeof setting;
  status = dashpot_params_setting(&params, &setting);
  return unused;
}
static void *grid(void *unused) {
  static dashpot_params family = DASHPOT_PARAMS_INIT;
  static const double settings[2] = {0.0, 1.6}, gas[2] = {80.0, 85.0}, forces[3] = {-900.0, 0.0, 900.0};
  status = dashpot_params_default(&family);
  if (status == 0) status = dashpot_params_set_grid(&family, settings, 2);
  if (status == 0) status = dashpot_params_set_over(&family, "gas_force", gas, 2);
  if (status == 0) status = dashpot_params_set_list_over(&family, "fv_force", 0, forces, 3);
  return unused;
}
static void *read_file(void *unused) {
  static dashpot_params file = DASHPOT_PARAMS_INIT;
  status = dashpot_params_read(&file, text, sizeof text - 1, &fault);
  return unused;
}

static int32_t depend_on_a_setting(void) {
  static const double grid[2] = {0.0, 1.6}, gas[2] = {80.0, 85.0};
  double forces[63];
  uint32_t count, i;
  int32_t answer = dashpot_params_get_list(&params, "fv_force", forces, 63, &count);
  if (answer == 0) answer = dashpot_params_set_grid(&params, grid, 2);
  for (i = 0; i < 2 && answer == 0; i++) answer = dashpot_params_set_list_over(&params, "fv_force", i, forces, count);
  if (answer == 0) answer = dashpot_params_set_over(&params, "gas_force", gas, 2);
  return answer == 0 ? dashpot_params_set(&params, "setting_time_up", 0.01) : answer;
}

static long depth(void *(*call)(void *)) {
  static char *stack;
  pthread_attr_t attributes;
  pthread_t thread;
  long i;
  if (!stack && posix_memalign((void **)&stack, 4096, SIZE) != 0) exit(2);
  memset(stack, PATTERN, SIZE);
  pthread_attr_init(&attributes);
  if (pthread_attr_setstack(&attributes, stack, SIZE) != 0 || pthread_create(&thread, &attributes, call, NULL) != 0) exit(2);
  pthread_join(thread, NULL);
  for (i = 0; i < SIZE && stack[i] == PATTERN; i++) {}
  return SIZE - i;
}

static const char *const sets[][12] = {
    {NULL},
    {"presliding_friction", "gas_spring", "moving_mass", "lagged_polynomial", "bump_stop", NULL},
    {"bushing", NULL},
    {"cavitation", "oil_compressibility", NULL},
    {"free_play", "bushing", "oil_compressibility", "aeration", "cavitation", "position_dependent_damping",
     "frequency_selective_damping", "valve_hysteresis", "bump_stop", NULL},
};

int main(void) {
  static const struct {
    const char *name;
    void *(*call)(void *);
  } calls[] = {
      {"dashpot_params_default", defaults}, {"dashpot_params_set", set},   {"dashpot_params_read", read_file},
      {"dashpot_params_check", check},      {"dashpot_model_init", init},  {"dashpot_state_init", settle},
      {"dashpot_force", one},               {"dashpot_step", step},        {"dashpot_step, dt 0", hold},
      {"dashpot_step_batch", batch},        {"dashpot_evaluate", evaluate}, {"dashpot_jacobian", jacobian},
      {"dashpot_parameter_info", info},     {"dashpot_force_with_setting", one_set},
      {"dashpot_actuator_setting", actual}, {"dashpot_d_force_d_setting", gain},
      {"dashpot_jacobian_setting", by},     {"dashpot_state_init_motion", moving},
      {"dashpot_params_setting", read_setting}, {"dashpot_params_set_grid and values over it", grid},
  };
  long worst[sizeof calls / sizeof calls[0]] = {0}, thread, most = 0;
  size_t k, s, i;
  /* Each set of elements is measured as an ordinary damper, and with a gas force and an FV curve that depend on a setting. */
  for (s = 0; s < 2 * (sizeof sets / sizeof sets[0]); s++) {
    const size_t set = s / 2;
    if (dashpot_params_default(&params) != 0) return 2;
    for (i = 0; sets[set][i]; i++)
      if (dashpot_params_enable(&params, sets[set][i], 1) != 0) return 2;
    if (s % 2 == 1 && depend_on_a_setting() != 0) return 2;
    dashpot_params_set(&params, "valve_form", 1.0);
    dashpot_params_set(&params, "cavitation_onset", 0.5);
    if (dashpot_model_init(&model, &params) != 0 || dashpot_state_init(&model, 0.0, states) != 0) return 2;
    states[1] = states[0];
    inputs[0] = inputs[1] = dashpot_input_with_setting(dashpot_input_motion(1e-4, 0.2), 0.9);
    /* Stack that a thread uses before it calls anything. */
    thread = depth(nothing);
    for (k = 1; k < sizeof calls / sizeof calls[0]; k++) {
      long deep;
      status = -1;
      deep = depth(calls[k].call) - thread;
      if (status < 0) {
        printf("%s answers %d\n", calls[k].name, (int)status);
        return 2;
      }
      if (deep > worst[k]) worst[k] = deep;
    }
  }
  worst[0] = depth(defaults) - depth(nothing);
  for (k = 0; k < sizeof calls / sizeof calls[0]; k++) {
    printf("%s %ld\n", calls[k].name, worst[k]);
    if (worst[k] > most) most = worst[k];
  }
  return most > MOST;
}
