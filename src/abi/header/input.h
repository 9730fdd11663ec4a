/** The input of a host that knows the velocity (m/s) alone. */
static inline dashpot_input dashpot_input_velocity(double velocity) {
  dashpot_input input;
  input.struct_size = (uint32_t)sizeof(dashpot_input);
  input.known = 0;
  input.displacement = 0.0;
  input.velocity = velocity;
  input.side_force = 0.0;
  input.temperature = 0.0;
  input.setting = 0.0;
  return input;
}

/** The input with the commanded setting of a damper that depends on one. */
static inline dashpot_input dashpot_input_with_setting(dashpot_input input, double setting) {
  input.known |= DASHPOT_KNOWS_SETTING;
  input.setting = setting;
  return input;
}

/** The input of a host that knows displacement (m) and velocity (m/s). */
static inline dashpot_input dashpot_input_motion(double displacement, double velocity) {
  dashpot_input input = dashpot_input_velocity(velocity);
  input.known = DASHPOT_KNOWS_DISPLACEMENT;
  input.displacement = displacement;
  return input;
}
