// Runs a rig test in a C++ host; rig.c describes input and output.
#include "dashpot.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

void need(std::int32_t status) {
  if (status < 0) throw std::runtime_error(dashpot_status_text(status));
}

// A damper as a C++ host would wrap it: values, no pointers, copied by the compiler.
class Damper {
public:
  explicit Damper(const std::string &model_file) {
    dashpot_params params = DASHPOT_PARAMS_INIT;
    need(dashpot_params_default(&params));
    if (!model_file.empty()) {
      std::ifstream file(model_file, std::ios::binary);
      const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
      need(dashpot_params_read(&params, text.data(), text.size(), nullptr));
    }
    need(dashpot_model_init(&model_, &params));
    need(dashpot_state_init(&model_, 0.0, &state_));
  }

  std::int32_t step(const dashpot_input &input, double dt, dashpot_output &output) {
    dashpot_state next;
    const std::int32_t status = dashpot_step(&model_, &state_, &input, dt, &next, &output);
    need(status);
    state_ = next;
    return status;
  }

  std::int32_t force(double velocity, double dt, double &force) {
    const std::int32_t status = dashpot_force(&model_, &state_, velocity, dt, &force);
    need(status);
    return status;
  }

  const dashpot_state &state() const { return state_; }

private:
  dashpot_model model_;
  dashpot_state state_;
};

double number(std::uint64_t bits) {
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

template <typename Doubles> void print(const Doubles &doubles, std::size_t bytes = sizeof(Doubles)) {
  std::vector<std::uint64_t> bits(bytes / sizeof(double));
  std::memcpy(bits.data(), &doubles, bytes);
  for (std::uint64_t one : bits) std::cout << ' ' << std::hex << std::setw(16) << std::setfill('0') << one;
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 2) return 2;
  const std::string mode = argv[1];
  static Damper damper(argc > 2 ? argv[2] : "");
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    std::uint32_t known;
    std::uint64_t x, v, side, temperature, dt;
    words >> known >> std::hex >> x >> v >> side >> temperature >> dt;
    std::int32_t status;
    if (mode == "step") {
      dashpot_input input = dashpot_input_motion(number(x), number(v));
      input.known = known;
      input.side_force = number(side);
      input.temperature = number(temperature);
      dashpot_output output;
      status = damper.step(input, number(dt), output);
      std::cout << std::dec << status;
      print(output);
    } else {
      double force;
      status = damper.force(number(v), number(dt), force);
      std::cout << std::dec << status;
      print(force);
    }
    // Only a damper over a setting uses the members that follow.
    print(damper.state(), offsetof(dashpot_state, commands));
    std::cout << '\n';
  }
}
