/* Checks that the library rejects all invalid calls, and then changes no output. */
#include "check.h"
#include "dashpot.h"

#include <math.h>
#include <string.h>

static dashpot_params params = DASHPOT_PARAMS_INIT;
static dashpot_model model;
static dashpot_model never_set;
static dashpot_state state;

/* Outputs with a pattern that no computation gives. */
static struct {
  dashpot_state state;
  dashpot_output output;
  dashpot_partials partials;
  dashpot_parameter row;
  dashpot_fault fault;
  double number;
  double list[4];
  uint32_t count;
} out, pattern;

#define REFUSED(call, code)                               \
  do {                                                    \
    int32_t status;                                       \
    memcpy(&out, &pattern, sizeof out);                   \
    status = (call);                                      \
    CHECK(status == (code));                              \
    CHECK(memcmp(&out, &pattern, sizeof out) == 0);       \
    CHECK(strncmp(dashpot_status_text(status), "unknown", 7) != 0); \
  } while (0)

/* A pointer that is misaligned by one byte. */
#define OFF(type, pointer) ((type *)(void *)((char *)(pointer) + 1))

static const double bad_numbers[] = {NAN, INFINITY, -INFINITY, 1.1e9, -1.1e9, 1e300};
/* Velocities, m/s, and displacements, m, beyond those of any damper. */
static const double bad_motions[] = {1001.0, -1001.0};
enum { BAD_NUMBERS = sizeof bad_numbers / sizeof bad_numbers[0] };

static void parameters(void) {
  static dashpot_params other = DASHPOT_PARAMS_INIT, before;
  static const double points[3] = {-1.0, 0.0, 1.0}, falling[3] = {0.0, 1.0, 0.5};
  double huge[64] = {0};
  int i;

  CHECK(dashpot_params_default(NULL) == DASHPOT_NULL);
  CHECK(dashpot_params_default(OFF(dashpot_params, &other)) == DASHPOT_MISALIGNED);
  CHECK(dashpot_params_set(&other, "gas_force", 1.0) == DASHPOT_NOT_INITIALIZED);
  REFUSED(dashpot_params_get(&other, "gas_force", &out.number), DASHPOT_NOT_INITIALIZED);
  REFUSED(dashpot_params_check(&other, &out.fault), DASHPOT_NOT_INITIALIZED);
  CHECK(dashpot_model_init(&never_set, &other) == DASHPOT_NOT_INITIALIZED);

  other.struct_size--;
  CHECK(dashpot_params_default(&other) == DASHPOT_STRUCT_SIZE);
  other.struct_size++;
  other.abi_version++;
  CHECK(dashpot_params_default(&other) == DASHPOT_ABI_MISMATCH);
  other.abi_version--;
  CHECK(dashpot_params_default(&other) == DASHPOT_OK);

  /* The size and the version of the parameters are also checked in calls after their initialization. */
  other.struct_size++;
  CHECK(dashpot_params_set(&other, "gas_force", 1.0) == DASHPOT_STRUCT_SIZE);
  CHECK(dashpot_model_init(&never_set, &other) == DASHPOT_STRUCT_SIZE);
  other.struct_size--;
  other.abi_version = 0;
  CHECK(dashpot_params_set(&other, "gas_force", 1.0) == DASHPOT_ABI_MISMATCH);
  CHECK(dashpot_model_init(&never_set, &other) == DASHPOT_ABI_MISMATCH);
  other.abi_version = DASHPOT_ABI_VERSION;

  memcpy(&before, &other, sizeof before);
  CHECK(dashpot_params_set(NULL, "gas_force", 1.0) == DASHPOT_NULL);
  CHECK(dashpot_params_set(&other, NULL, 1.0) == DASHPOT_NULL);
  CHECK(dashpot_params_set(&other, "", 1.0) == DASHPOT_UNKNOWN_NAME);
  CHECK(dashpot_params_set(&other, "gas_forc", 1.0) == DASHPOT_UNKNOWN_NAME);
  CHECK(dashpot_params_set(&other, "gas_forces", 1.0) == DASHPOT_UNKNOWN_NAME);
  CHECK(dashpot_params_set(&other, "gas_force", NAN) == DASHPOT_NOT_FINITE);
  CHECK(dashpot_params_set(&other, "gas_force", -INFINITY) == DASHPOT_NOT_FINITE);
  CHECK(dashpot_params_set(&other, "series_stiffness", -1.0) == DASHPOT_OUT_OF_BOUNDS);
  CHECK(dashpot_params_set(&other, "fv_form", 0.5) == DASHPOT_NOT_A_CHOICE);
  CHECK(dashpot_params_set(&other, "fv_force", 1.0) == DASHPOT_WRONG_SHAPE);
  CHECK(dashpot_params_set_list(&other, "gas_force", points, 3) == DASHPOT_WRONG_SHAPE);
  CHECK(dashpot_params_set_list(&other, "fv_force", NULL, 3) == DASHPOT_NULL);
  CHECK(dashpot_params_set_list(&other, "fv_force", OFF(const double, points), 2) == DASHPOT_MISALIGNED);
  CHECK(dashpot_params_set_list(&other, "fv_force", huge, 64) == DASHPOT_POINT_COUNT);
  CHECK(dashpot_params_enable(&other, "warp_drive", 1) == DASHPOT_UNKNOWN_NAME);
  CHECK(dashpot_params_enable(&other, NULL, 1) == DASHPOT_NULL);
  REFUSED(dashpot_params_get(&other, "gas_force", NULL), DASHPOT_NULL);
  REFUSED(dashpot_params_get(&other, "fv_force", &out.number), DASHPOT_WRONG_SHAPE);
  REFUSED(dashpot_params_get(&other, "no_such", &out.number), DASHPOT_UNKNOWN_NAME);
  REFUSED(dashpot_params_get_list(&other, "gas_force", out.list, 4, &out.count), DASHPOT_WRONG_SHAPE);
  REFUSED(dashpot_params_get_list(&other, "fv_force", out.list, 4, &out.count), DASHPOT_BUFFER_TOO_SHORT);
  REFUSED(dashpot_params_get_list(&other, "fv_force", out.list, 4, NULL), DASHPOT_NULL);
  REFUSED(dashpot_params_is_on(&other, "warp_drive", &out.count), DASHPOT_UNKNOWN_NAME);
  REFUSED(dashpot_params_read(NULL, "", 0, &out.fault), DASHPOT_NULL);
  REFUSED(dashpot_params_read(&other, NULL, 1, &out.fault), DASHPOT_NULL);
  CHECK(dashpot_params_read(&other, "", 0, NULL) == DASHPOT_FILE_FORMAT);
  CHECK(memcmp(&before, &other, sizeof before) == 0);

  /* A file is rejected with line and parameter, and changes nothing. */
  {
    static const char text[] = "format = 1\nelements = [\"fv_curve\"]\ngas_force = 70.0\nseries_stiffness = -1.0\n";
    dashpot_fault fault;
    CHECK(dashpot_params_read(&other, text, sizeof text - 1, &fault) == DASHPOT_OUT_OF_BOUNDS);
    CHECK(fault.status == DASHPOT_OUT_OF_BOUNDS && fault.line == 4 && strcmp(fault.parameter, "series_stiffness") == 0);
    CHECK(memcmp(&before, &other, sizeof before) == 0);
  }

  /* An FV curve with falling forces: each number is allowed, but the list is not. */
  CHECK(dashpot_params_set_list(&other, "fv_velocity", points, 3) == DASHPOT_OK);
  CHECK(dashpot_params_set_list(&other, "fv_force", falling, 3) == DASHPOT_OK);
  {
    static dashpot_model kept;
    dashpot_fault fault;
    memcpy(&kept, &model, sizeof kept);
    CHECK(dashpot_model_init(&kept, &other) == DASHPOT_FORCE_DECREASES);
    CHECK(memcmp(&kept, &model, sizeof kept) == 0);
    CHECK(dashpot_params_check(&other, &fault) == DASHPOT_FORCE_DECREASES);
    CHECK(fault.status == DASHPOT_FORCE_DECREASES && fault.line == 0 && strcmp(fault.parameter, "fv_force") == 0);
    CHECK(dashpot_params_check(&params, &fault) == DASHPOT_OK);
    CHECK(fault.status == DASHPOT_OK && fault.line == 0 && fault.parameter[0] == 0);
  }
  CHECK(dashpot_model_init(NULL, &params) == DASHPOT_NULL);
  CHECK(dashpot_model_init(&model, NULL) == DASHPOT_NULL);
  CHECK(dashpot_model_init(OFF(dashpot_model, &model), &params) == DASHPOT_MISALIGNED);

  pattern.row.struct_size = sizeof(dashpot_parameter);
  REFUSED(dashpot_parameter_info(dashpot_parameter_count(), &out.row), DASHPOT_NO_SUCH_ROW);
  REFUSED(dashpot_parameter_info(0, NULL), DASHPOT_NULL);
  pattern.row.struct_size++;
  REFUSED(dashpot_parameter_info(0, &out.row), DASHPOT_STRUCT_SIZE);
  for (i = 0; i < (int)dashpot_parameter_count(); i++) {
    dashpot_parameter row;
    row.struct_size = sizeof row;
    CHECK(dashpot_parameter_info((uint32_t)i, &row) == DASHPOT_OK);
    CHECK(row.row == (uint32_t)i && row.low <= row.default_value && row.default_value <= row.high);
    CHECK(strlen(row.name) > 0 && strlen(row.unit) > 0 && strlen(row.element) > 0 && strlen(row.meaning) > 0);
  }
}

static void states(void) {
  int i;
  REFUSED(dashpot_state_init(NULL, 0.0, &out.state), DASHPOT_NULL);
  REFUSED(dashpot_state_init(&never_set, 0.0, &out.state), DASHPOT_NOT_INITIALIZED);
  REFUSED(dashpot_state_init(OFF(dashpot_model, &model), 0.0, &out.state), DASHPOT_MISALIGNED);
  REFUSED(dashpot_state_init(&model, 0.0, NULL), DASHPOT_NULL);
  for (i = 0; i < BAD_NUMBERS; i++) REFUSED(dashpot_state_init(&model, bad_numbers[i], &out.state), DASHPOT_BAD_INPUT);
}

/* The four functions that take an input, with one signature. */
static int32_t by_step(const dashpot_model *m, const dashpot_state *s, const dashpot_input *i) {
  return dashpot_step(m, s, i, 1e-3, &out.state, &out.output);
}
static int32_t by_evaluation(const dashpot_model *m, const dashpot_state *s, const dashpot_input *i) {
  return dashpot_evaluate(m, s, i, &out.output, &out.state);
}
static int32_t by_jacobian(const dashpot_model *m, const dashpot_state *s, const dashpot_input *i) {
  return dashpot_jacobian(m, s, i, &out.partials);
}
static int32_t by_batch(const dashpot_model *m, const dashpot_state *s, const dashpot_input *i) {
  return dashpot_step_batch(1, &m, s, i, 1e-3, &out.state, &out.output);
}

static void inputs(int32_t (*call)(const dashpot_model *, const dashpot_state *, const dashpot_input *)) {
  dashpot_input good = dashpot_input_motion(0.01, 0.1), input = good;
  dashpot_state broken;
  size_t k;
  int i;
  REFUSED(call(NULL, &state, &good), DASHPOT_NULL);
  REFUSED(call(&model, NULL, &good), DASHPOT_NULL);
  REFUSED(call(&model, &state, NULL), DASHPOT_NULL);
  REFUSED(call(&never_set, &state, &good), DASHPOT_NOT_INITIALIZED);
  REFUSED(call(OFF(const dashpot_model, &model), &state, &good), DASHPOT_MISALIGNED);
  REFUSED(call(&model, OFF(const dashpot_state, &state), &good), DASHPOT_MISALIGNED);
  REFUSED(call(&model, &state, OFF(const dashpot_input, &good)), DASHPOT_MISALIGNED);
  input.struct_size = 0;
  REFUSED(call(&model, &state, &input), DASHPOT_STRUCT_SIZE);
  input = good;
  input.struct_size++;
  REFUSED(call(&model, &state, &input), DASHPOT_STRUCT_SIZE);
  input = good;
  input.known |= 1u << 31;
  REFUSED(call(&model, &state, &input), DASHPOT_UNKNOWN_FLAG);
  for (i = 0; i < BAD_NUMBERS; i++) {
    input = good;
    input.velocity = bad_numbers[i];
    REFUSED(call(&model, &state, &input), DASHPOT_BAD_INPUT);
    input = good;
    input.displacement = bad_numbers[i];
    REFUSED(call(&model, &state, &input), DASHPOT_BAD_INPUT);
    /* Members whose bit in `known` is not set are not checked. */
    input = dashpot_input_velocity(0.1);
    input.displacement = input.side_force = input.temperature = bad_numbers[i];
    CHECK(call(&model, &state, &input) == DASHPOT_OK);
    input.displacement = 0.0;
    input.temperature = 20.0;
    input.known = DASHPOT_KNOWS_SIDE_FORCE;
    REFUSED(call(&model, &state, &input), DASHPOT_BAD_INPUT);
    input.side_force = 0.0;
    input.temperature = bad_numbers[i];
    input.known = DASHPOT_KNOWS_TEMPERATURE;
    REFUSED(call(&model, &state, &input), DASHPOT_BAD_INPUT);
  }
  for (i = 0; i < 2; i++) {
    input = good;
    input.velocity = bad_motions[i];
    REFUSED(call(&model, &state, &input), DASHPOT_BAD_INPUT);
    input = good;
    input.displacement = bad_motions[i];
    REFUSED(call(&model, &state, &input), DASHPOT_BAD_INPUT);
  }
  /* Only a damper that depends on a setting and has a dead time reads the commands after these members. */
  for (k = 0; k < offsetof(dashpot_state, commands) / sizeof(double); k++) {
    static const double wrong[] = {NAN, INFINITY, -INFINITY, 1e61, -1e61};
    for (i = 0; i < 5; i++) {
      broken = state;
      memcpy((char *)&broken + k * sizeof(double), &wrong[i], sizeof wrong[i]);
      REFUSED(call(&model, &broken, &good), DASHPOT_BAD_STATE);
    }
  }
}

static void steps(void) {
  static const double bad_steps[] = {-1e-3, NAN, INFINITY, -INFINITY, 101.0, 1.1e9, 1e-16};
  dashpot_input good = dashpot_input_motion(0.01, 0.1);
  dashpot_state kept = state;
  const dashpot_model *models[2];
  dashpot_state from[2];
  dashpot_input two[2];
  struct {
    dashpot_state to[2];
    dashpot_output outputs[2];
  } batch, before;
  size_t i;
  for (i = 0; i < sizeof bad_steps / sizeof bad_steps[0]; i++) {
    REFUSED(dashpot_step(&model, &state, &good, bad_steps[i], &out.state, &out.output), DASHPOT_BAD_TIME_STEP);
    REFUSED(dashpot_force(&model, &state, 0.1, bad_steps[i], &out.number), DASHPOT_BAD_TIME_STEP);
  }
  for (i = 0; i < BAD_NUMBERS; i++) REFUSED(dashpot_force(&model, &state, bad_numbers[i], 1e-3, &out.number), DASHPOT_BAD_INPUT);
  REFUSED(dashpot_step(&model, &state, &good, 1e-3, NULL, &out.output), DASHPOT_NULL);
  REFUSED(dashpot_step(&model, &state, &good, 1e-3, &out.state, NULL), DASHPOT_NULL);
  REFUSED(dashpot_step(&model, &state, &good, 1e-3, OFF(dashpot_state, &out.state), &out.output), DASHPOT_MISALIGNED);
  REFUSED(dashpot_step(&model, &state, &good, 1e-3, &out.state, OFF(dashpot_output, &out.output)), DASHPOT_MISALIGNED);
  REFUSED(dashpot_force(NULL, &state, 0.1, 1e-3, &out.number), DASHPOT_NULL);
  REFUSED(dashpot_force(&model, NULL, 0.1, 1e-3, &out.number), DASHPOT_NULL);
  REFUSED(dashpot_force(&model, &state, 0.1, 1e-3, NULL), DASHPOT_NULL);
  REFUSED(dashpot_force(&never_set, &state, 0.1, 1e-3, &out.number), DASHPOT_NOT_INITIALIZED);
  REFUSED(dashpot_evaluate(&model, &state, &good, NULL, &out.state), DASHPOT_NULL);
  REFUSED(dashpot_evaluate(&model, &state, &good, &out.output, NULL), DASHPOT_NULL);
  REFUSED(dashpot_jacobian(&model, &state, &good, NULL), DASHPOT_NULL);
  CHECK(memcmp(&kept, &state, sizeof state) == 0);

  /* If one damper of a batch is invalid, none changes. */
  memset(&batch, 0x5a, sizeof batch);
  memset(&before, 0x5a, sizeof before);
  models[0] = models[1] = &model;
  from[0] = from[1] = state;
  two[0] = two[1] = good;
  two[1].velocity = NAN;
  CHECK(dashpot_step_batch(2, models, from, two, 1e-3, batch.to, batch.outputs) == DASHPOT_BAD_INPUT);
  two[1] = good;
  models[1] = NULL;
  CHECK(dashpot_step_batch(2, models, from, two, 1e-3, batch.to, batch.outputs) == DASHPOT_NULL);
  models[1] = &never_set;
  CHECK(dashpot_step_batch(2, models, from, two, 1e-3, batch.to, batch.outputs) == DASHPOT_NOT_INITIALIZED);
  models[1] = &model;
  from[1].internal[7] = INFINITY;
  CHECK(dashpot_step_batch(2, models, from, two, 1e-3, batch.to, batch.outputs) == DASHPOT_BAD_STATE);
  from[1] = state;
  CHECK(dashpot_step_batch(2, NULL, from, two, 1e-3, batch.to, batch.outputs) == DASHPOT_NULL);
  CHECK(dashpot_step_batch(2, models, NULL, two, 1e-3, batch.to, batch.outputs) == DASHPOT_NULL);
  CHECK(dashpot_step_batch(2, models, from, NULL, 1e-3, batch.to, batch.outputs) == DASHPOT_NULL);
  CHECK(dashpot_step_batch(2, models, from, two, 1e-3, NULL, batch.outputs) == DASHPOT_NULL);
  CHECK(dashpot_step_batch(2, models, from, two, 1e-3, batch.to, NULL) == DASHPOT_NULL);
  CHECK(dashpot_step_batch(2, models, from, two, -1.0, batch.to, batch.outputs) == DASHPOT_BAD_TIME_STEP);
  CHECK(memcmp(&batch, &before, sizeof batch) == 0);
}

/* Checks inputs that are accepted with a warning. */
static void warnings(void) {
  dashpot_output output;
  dashpot_state to;
  dashpot_input fast = dashpot_input_velocity(5.0), slow = dashpot_input_velocity(0.1);
  double force = 0.0;
  CHECK(dashpot_step(&model, &state, &slow, 1e-3, &to, &output) == DASHPOT_OK);
  CHECK(dashpot_step(&model, &state, &fast, 1e-3, &to, &output) == DASHPOT_OUTSIDE_RANGE);
  CHECK(dashpot_step(&model, &state, &slow, 0.02, &to, &output) == DASHPOT_LONG_STEP);
  CHECK(dashpot_step(&model, &state, &fast, 0.02, &to, &output) == (DASHPOT_OUTSIDE_RANGE | DASHPOT_LONG_STEP));
  CHECK(dashpot_evaluate(&model, &state, &fast, &output, &to) == DASHPOT_OUTSIDE_RANGE);
  to = state;
  CHECK(dashpot_force(&model, &to, 5.0, 1e-3, &force) == DASHPOT_OUTSIDE_RANGE && isfinite(force));
  /* Inputs near their limits give finite numbers. */
  fast = dashpot_input_motion(400.0, -600.0);
  CHECK(dashpot_step(&model, &state, &fast, 1e-15, &to, &output) > 0);
  CHECK(isfinite(output.force) && isfinite(output.d_force_d_velocity) && isfinite(to.mass_velocity));
  CHECK(dashpot_step(&model, &state, &fast, 100.0, &to, &output) > 0);
  CHECK(isfinite(output.force) && isfinite(output.d_force_d_velocity) && isfinite(to.mass_velocity));
}

int main(void) {
  memset(&pattern, 0xa5, sizeof pattern);
  CHECK(dashpot_abi_version() == DASHPOT_ABI_VERSION);
  CHECK(strchr(dashpot_version(), '.') != NULL);
  CHECK(strncmp(dashpot_status_text(12345), "unknown", 7) == 0);
  CHECK(dashpot_params_default(&params) == DASHPOT_OK);
  CHECK(dashpot_model_init(&model, &params) == DASHPOT_OK);
  CHECK(dashpot_state_init(&model, 0.01, &state) == DASHPOT_OK);
  parameters();
  states();
  inputs(by_step);
  inputs(by_evaluation);
  inputs(by_jacobian);
  inputs(by_batch);
  steps();
  warnings();
  return failures != 0;
}
