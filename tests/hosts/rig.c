/* Runs a rig test in a C host: reads the motion and writes the outputs. Both are the bits of doubles, so that no digit
 * is lost.
 *
 *   rig step|force [model file] < motion > answers
 *
 * A line of motion: known (decimal), displacement, velocity, side force, temperature, dt (each 16 hexadecimal digits).
 * A line of answers: status, then the output's and the state's numbers; with `force` the force and the state.
 */
#include "dashpot.h"

#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double number(uint64_t bits) {
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static void print(const void *doubles, size_t bytes) {
  const unsigned char *at = (const unsigned char *)doubles;
  size_t i;
  for (i = 0; i < bytes; i += sizeof(uint64_t)) {
    uint64_t bits;
    memcpy(&bits, at + i, sizeof bits);
    printf(" %016" PRIx64, bits);
  }
}

static void need(int32_t status, const char *what) {
  if (status < 0) {
    fprintf(stderr, "%s: %s\n", what, dashpot_status_text(status));
    exit(1);
  }
}

static void read_model(dashpot_params *params, const char *path) {
  static char text[65536];
  dashpot_fault fault;
  FILE *file = fopen(path, "rb");
  size_t length;
  if (!file) {
    perror(path);
    exit(1);
  }
  length = fread(text, 1, sizeof text, file);
  fclose(file);
  if (dashpot_params_read(params, text, length, &fault) != DASHPOT_OK) {
    fprintf(stderr, "%s, line %u: %s %s\n", path, (unsigned)fault.line, fault.parameter,
            dashpot_status_text(fault.status));
    exit(1);
  }
}

int main(int argc, char **argv) {
  static dashpot_params params = DASHPOT_PARAMS_INIT;
  static dashpot_model model;
  dashpot_state state;
  uint32_t known;
  uint64_t x, v, side, temperature, dt;
  int by_step;
  if (argc < 2) return 2;
  by_step = strcmp(argv[1], "step") == 0;
  need(dashpot_params_default(&params), "defaults");
  if (argc > 2) read_model(&params, argv[2]);
  need(dashpot_model_init(&model, &params), "model");
  need(dashpot_state_init(&model, 0.0, &state), "state");
  while (scanf("%" SCNu32 " %" SCNx64 " %" SCNx64 " %" SCNx64 " %" SCNx64 " %" SCNx64, &known, &x, &v, &side,
               &temperature, &dt) == 6) {
    if (by_step) {
      dashpot_input input = dashpot_input_velocity(number(v));
      dashpot_output output;
      input.known = known;
      input.displacement = number(x);
      input.side_force = number(side);
      input.temperature = number(temperature);
      printf("%d", (int)dashpot_step(&model, &state, &input, number(dt), &state, &output));
      print(&output, sizeof output);
    } else {
      double force;
      printf("%d", (int)dashpot_force(&model, &state, number(v), number(dt), &force));
      print(&force, sizeof force);
    }
    print(&state, offsetof(dashpot_state, commands)); /* only a damper over a setting uses what follows */
    printf("\n");
  }
  return 0;
}
