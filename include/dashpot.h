// Written from src/abi by `UPDATE_HEADER=1 cargo test --profile tests -p dashpot-tests --test source abi_header`; do not edit.

// dashpot: an automotive suspension damper for simulators.
//
// Give the damper a velocity, get its force:
//
//     static dashpot_params params = DASHPOT_PARAMS_INIT;
//     static dashpot_model model;
//     dashpot_state state;
//     double force;
//
//     dashpot_params_default(&params);                           // a passenger car damper
//     dashpot_params_set(&params, "gas_force", 120.0);           // or dashpot_params_read() a model file
//     dashpot_model_init(&model, &params);                       // checks and prepares
//     dashpot_state_init(&model, -0.02, &state);                 // initial position, m
//     while (running)
//         dashpot_force(&model, &state, velocity, dt, &force);   // m/s and s in, N out
//
// Every function returns a status that a program should check: 0 is success, positive is a warning,
// negative is an error. dashpot_status_text() returns the message.
//
// Units and signs. SI throughout: m, m/s, N, kg, s; temperature in degrees Celsius. Extension (rebound) velocity is
// positive, compression negative. Tension is positive: a damper that resists extension has a positive
// force, and gas that pushes the rod out a negative one. This is stated here once and holds everywhere below.
//
// Linking. Compile with -I include. Shared: program.c libdashpot.so (Windows: dashpot.dll and its import library).
// Static: program.c libdashpot.a, in any order with other libraries of C and C++. The static one is a single object.
// All its names are local, except dashpot_*. To build the static library from sources, run sh src/dll/static.sh, which
// writes it to target/lib. Neither the shared nor the static library needs another library. Both import only memcpy,
// memmove, memset, memcmp and bcmp, which compilers call by themselves and every C runtime has. They use no allocator,
// file, lock or thread.
//
// Memory. The library allocates nothing and stores nothing. The caller owns all blocks, as globals, on the stack or
// on the heap. There is nothing to free. dashpot_params, dashpot_model and dashpot_state hold no pointers; they may
// be copied with = or memcpy. dashpot_params and dashpot_model must lie at an address divisible by 16. The compiler
// ensures that. (Before C++17, new guarantees only the alignment of malloc, which is 16 on 64-bit systems.)
//
// Sizes. A state is 272 bytes, an output 80, a parameter set 16 KB, a model 48 KB. No function uses more than 16 KB of the
// caller's stack (dashpot_jacobian() 14 KB, a step 12 KB). Keep models and parameter sets off a small stack. A list has at
// most 63 numbers (see capacity in dashpot_parameter), a name 47 characters. The size of a file is not limited.
//
// Null. Only these pointers may be null: fault of dashpot_params_read(), values of dashpot_params_get_list() (which then returns only
// the length), and an array of no elements.
//
// Errors. A function that returns a negative status leaves outputs and state unchanged.
// These are errors: null pointers, addresses that are not aligned, structures of another size, another interface version,
// blocks that were never initialized, and numbers that are NaN, infinite or absurdly large (see DASHPOT_BAD_INPUT).
// After any other status all outputs are finite.
//
// Threads. There is no hidden state. Functions may run at the same time in any number of threads as long as no two
// of them write the same block and none writes what another reads. One model serves any number of dampers; each
// damper needs its own state. Every call returns in bounded time, uses no lock and preserves the floating-point mode.
//
// Results are the same to the last bit on every 64-bit platform, whatever compiler built the host.

#ifndef DASHPOT_H
#define DASHPOT_H

#include <stddef.h>
#include <stdint.h>

#if defined(_MSC_VER)
#define DASHPOT_ALIGNED(n) __declspec(align(n))
#else
#define DASHPOT_ALIGNED(n) __attribute__((aligned(n)))
#endif

#ifdef __cplusplus
extern "C" {
#endif


// ==============================================================================================================
// Version
// ==============================================================================================================

// The interface version counts changes of the structures and functions below. Programs built for one interface version run
// with every library of the same interface version. With another one every function that takes a parameter set rejects it
// (DASHPOT_ABI_MISMATCH), and the program has to be built again. Parameters and elements may be added within one
// interface version. A model file or a program that does not name them gets the same results as before. The digits of a force may
// change from one library version to the next, within the stated accuracy. Do not exchange states and
// models between versions; exchange parameter sets as model files.

// Version of this interface.
#define DASHPOT_ABI_VERSION 9

// Version of the library that this header belongs to: DASHPOT_VERSION_MAJOR.DASHPOT_VERSION_MINOR.DASHPOT_VERSION_PATCH.
#define DASHPOT_VERSION_MAJOR 0

// See DASHPOT_VERSION_MAJOR.
#define DASHPOT_VERSION_MINOR 1

// See DASHPOT_VERSION_MAJOR.
#define DASHPOT_VERSION_PATCH 0

// The interface version of the library that is loaded; compare it with DASHPOT_ABI_VERSION.
uint32_t dashpot_abi_version(void);

// The version of the library as text, "major.minor.patch". Never null; lives as long as the library.
const char *dashpot_version(void);


// ==============================================================================================================
// Status
// ==============================================================================================================

// Every function returns a status: 0 success, positive a warning (the result is usable), negative an error
// (nothing was changed). Warnings are bits and may be combined. Numbers never change their meaning.

// Success.
#define DASHPOT_OK 0

// Warning bit: the velocity lies outside the identified force-velocity curve, which is extrapolated linearly.
#define DASHPOT_OUTSIDE_RANGE 1

// Warning bit: the step is longer than 0.01 s; fast motion inside it is not resolved.
#define DASHPOT_LONG_STEP 2

// Warning bit: the setting lies outside the grid of the family and is clamped to it.
#define DASHPOT_OUTSIDE_SETTING 4

// A pointer is null.
#define DASHPOT_NULL -1

// An address is not aligned for what it points to.
#define DASHPOT_MISALIGNED -2

// The struct_size of a structure is not the size that this library expects.
#define DASHPOT_STRUCT_SIZE -3

// abi_version is not the interface version of this library.
#define DASHPOT_ABI_MISMATCH -4

// The parameters or the model were not initialized, or by another build of the library.
#define DASHPOT_NOT_INITIALIZED -5

// An input is NaN, infinite, or far beyond all dampers.
//
// The limits are 1000 for displacement plus velocity (m, m/s), 1e9 N for the side force and 1e5 degrees for the temperature.
#define DASHPOT_BAD_INPUT -6

// The state holds NaN, infinity or a number beyond 1e60: it was not initialized.
#define DASHPOT_BAD_STATE -7

// dt is NaN, negative, above 100 s, or above 0 but below 1e-15 s.
#define DASHPOT_BAD_TIME_STEP -8

// The member known of an input has a bit that this library does not define.
#define DASHPOT_UNKNOWN_FLAG -9

// No parameter or element has this name.
#define DASHPOT_UNKNOWN_NAME -10

// A parameter is NaN or infinite.
#define DASHPOT_NOT_FINITE -11

// A parameter is outside the bounds of the parameter table.
#define DASHPOT_OUT_OF_BOUNDS -12

// A parameter is none of the choices of the parameter table.
#define DASHPOT_NOT_A_CHOICE -13

// A list where one number belongs, or one number where a list belongs.
#define DASHPOT_WRONG_SHAPE -14

// A list has too few or too many points.
#define DASHPOT_POINT_COUNT -15

// The two lists of a curve have different lengths.
#define DASHPOT_CURVE_LENGTHS -16

// A list of velocities or displacements does not increase.
#define DASHPOT_NOT_INCREASING -17

// A list of forces decreases: the damper would push where it should resist.
#define DASHPOT_FORCE_DECREASES -18

// A limit that must exceed another does not.
#define DASHPOT_ORDER -19

// The caller's array is too short.
#define DASHPOT_BUFFER_TOO_SHORT -20

// A line of the model file is not of the form name = value.
#define DASHPOT_FILE_SYNTAX -21

// A value in the model file is neither a number nor a word in double quotes nor a list of them.
#define DASHPOT_FILE_VALUE -22

// A name appears twice in the model file.
#define DASHPOT_FILE_REPEATED -23

// The model file does not say format = 1.
#define DASHPOT_FILE_FORMAT -24

// The model file does not name its elements.
#define DASHPOT_FILE_NO_ELEMENTS -25

// The model file names an element that this library does not have.
#define DASHPOT_FILE_UNKNOWN_ELEMENT -26

// A list in the model file has more numbers than any parameter takes.
#define DASHPOT_FILE_TOO_LONG -27

// The parameter table has no row with this number.
#define DASHPOT_NO_SUCH_ROW -28

// The series spring is softer than the parallel spring somewhere within 100 mm.
#define DASHPOT_SOFTER_THAN_INNER -29

// The elements that are on have more than 8 internal states.
#define DASHPOT_TOO_MANY_STATES -30

// Free play or a bushing is on, and series_compliance, which they belong to, is off.
#define DASHPOT_NEEDS_SERIES -31

// Two points of a curve are closer than 1e-6 m/s or m.
#define DASHPOT_TOO_CLOSE -32

// A curve rises from one point to the next by more than 1e8 N s/m or N/m.
#define DASHPOT_TOO_STEEP -33

// The step cannot be computed: an input or a state is far outside the range of dampers.
#define DASHPOT_NOT_COMPUTABLE -34

// The model has no state with this number.
#define DASHPOT_NO_SUCH_STATE -35

// The model file is truncated: it ends before the [...] that its first comment announces.
#define DASHPOT_FILE_CUT_OFF -36

// The parameter's magnitude is inconsistent with the others.
//
// Parameters with a force in their unit may be a thousandth to a hundred times those of a car's damper, if one factor
// scales all. A rod of 1 g is consistent with a damper of 10 N, not with one of 1 kN.
#define DASHPOT_OUT_OF_PROPORTION -37

// A table of the model file is named as an element; parameters belong above the first `[table]`.
#define DASHPOT_FILE_ELEMENT_TABLE -38

// The grid of a setting is not 2 to 8 increasing numbers, or a setting is used without a grid.
#define DASHPOT_SETTING_GRID -39

// The number of values differs from the number of settings in the grid.
#define DASHPOT_SETTING_COUNT -40

// A parameter that cannot depend on the setting: a word, a list other than fv_force, or one of the integration.
#define DASHPOT_SETTING_FIXED -41

// More than 32 numbers depend on the setting.
#define DASHPOT_SETTING_TOO_MANY -42

// A parameter is 0 at one setting and not at another. A state would then exist only at some settings.
#define DASHPOT_SETTING_STATES -43

// Returns the message of a status. Never null; valid as long as the library is loaded.
//
// A message about a parameter continues the parameter's name: "fv_force" "falls from one point to the next; ...".
const char *dashpot_status_text(int32_t status);


// ==============================================================================================================
// Parameters
// ==============================================================================================================

// A parameter set is filled with defaults first, then changed by name, or read from a model file. The names, with
// units, bounds and meaning, are listed at the end of this header.

// A parameter set. Start with DASHPOT_PARAMS_INIT, or set the first two members by hand, and call
// dashpot_params_default().
typedef struct DASHPOT_ALIGNED(16) dashpot_params {
  // sizeof(dashpot_params).
  uint32_t struct_size;
  // DASHPOT_ABI_VERSION.
  uint32_t abi_version;
  // Internal data of the library.
  uint64_t opaque[2047];
} dashpot_params;

// An error and its position.
typedef struct dashpot_fault {
  // The status; 0 without an error.
  int32_t status;
  // Line of the model file, from 1; 0 if no line is at fault.
  uint32_t line;
  // Name of the parameter or element, zero-terminated; empty if none is at fault.
  char parameter[48];
} dashpot_fault;

// Fills a parameter set with the defaults of the table. params->struct_size and params->abi_version must be set.
int32_t dashpot_params_default(dashpot_params *params);

// Sets one number, or a choice by its index from 0. A number that depended on the setting is then constant.
int32_t dashpot_params_set(dashpot_params *params, const char *name, double value);

// Sets a list of count numbers. The two lists of a curve may be set in any order; whether they fit together is
// checked by dashpot_params_check() and dashpot_model_init().
int32_t dashpot_params_set_list(dashpot_params *params, const char *name, const double *values, uint32_t count);

// Reads one number, or the index of a choice from 0, into *value.
int32_t dashpot_params_get(const dashpot_params *params, const char *name, double *value);

// Reads a list into values, which has room for capacity numbers, and its length into *count. If values is null, only the
// length is returned.
int32_t dashpot_params_get_list(const dashpot_params *params,
                                const char *name,
                                double *values,
                                uint32_t capacity,
                                uint32_t *count);

// Switches an element of the model on (on not 0) or off (0).
int32_t dashpot_params_enable(dashpot_params *params, const char *element, uint32_t on);

// Reads whether an element of the model is on: *on becomes 1 or 0.
int32_t dashpot_params_is_on(const dashpot_params *params, const char *element, uint32_t *on);

// Reads a model file: text contains the length bytes of the file, without a terminating zero.
//
// All parameters are set: those that the file does not name get their defaults, so dashpot_params_default() is not needed before.
// On an error *fault contains the line and the parameter; fault may be null.
//
// Numbers are read the same way whatever the locale: the decimal sign is a point.
int32_t dashpot_params_read(dashpot_params *params,
                            const char *text,
                            size_t length,
                            dashpot_fault *fault);

// Checks the set as dashpot_model_init() does, and names the parameter at fault in *fault.
int32_t dashpot_params_check(const dashpot_params *params, dashpot_fault *fault);

/** A parameter set before dashpot_params_default(): dashpot_params params = DASHPOT_PARAMS_INIT; */
#define DASHPOT_PARAMS_INIT {sizeof(dashpot_params), DASHPOT_ABI_VERSION, {0}}


// ==============================================================================================================
// Model
// ==============================================================================================================

// A model is a parameter set that was checked and prepared. It is constant while it runs, and one model serves any
// number of dampers.

// Maximum number of states of a model; the capacity of dashpot_partials.
#define DASHPOT_MAX_STATES 10

// A prepared model. The host neither reads nor writes its contents.
typedef struct DASHPOT_ALIGNED(16) dashpot_model {
  // Internal data of the library.
  uint64_t opaque[6144];
} dashpot_model;

// Name and unit of one state. Set struct_size before the call.
typedef struct dashpot_state_name {
  // sizeof(dashpot_state_name).
  uint32_t struct_size;
  // Index of the state, from 0.
  uint32_t state;
  // Name, zero-terminated.
  char name[48];
  // SI unit; "-" for a pure number.
  char unit[16];
} dashpot_state_name;

// Returns the number of states that a solver of the host integrates (see Evaluation), from 2 to DASHPOT_MAX_STATES.
//
// These are the states of the internal mass and the internal states of the elements that are on. A negative result is an error.
int32_t dashpot_model_states(const dashpot_model *model);

// Writes the name and the unit of state `state` of a model, counted from 0, to *name. State k is rate->mass_displacement,
// rate->mass_velocity, rate->internal[k - 2].
int32_t dashpot_model_state_name(const dashpot_model *model,
                                 uint32_t state,
                                 dashpot_state_name *name);

// Checks a parameter set and prepares a model from it.
//
// On an error dashpot_params_check() names the parameter at fault. A running model may be prepared again between two steps, for
// example by a slider, with elements switched on and off: the states stay valid. A parameter set with a setting yields a model of
// all settings (see Setting).
int32_t dashpot_model_init(dashpot_model *model,
                           const dashpot_params *params);


// ==============================================================================================================
// Input
// ==============================================================================================================

// The inputs of the damper at one instant. dashpot_force() needs none of this.

// The host provides the displacement; without this bit it is integrated from the initial position.
#define DASHPOT_KNOWS_DISPLACEMENT 1

// The host provides the side force; without this bit it is 0.
#define DASHPOT_KNOWS_SIDE_FORCE 2

// The host provides the temperature; without this bit it is 20 degrees Celsius.
#define DASHPOT_KNOWS_TEMPERATURE 4

// The host provides the setting of a damper that depends on one; without this bit it is the start setting of the model file.
#define DASHPOT_KNOWS_SETTING 8

// Input at one instant. Start with dashpot_input_velocity() or dashpot_input_motion(). Displacement, side force,
// temperature and setting are each ignored if their bit is missing in the member known.
typedef struct dashpot_input {
  // sizeof(dashpot_input).
  uint32_t struct_size;
  // Sum of the DASHPOT_KNOWS_... bits that apply.
  uint32_t known;
  // Displacement, m, extension positive. A host that knows the displacement should provide it, because an integrated
  // displacement drifts.
  double displacement;
  // Velocity, m/s, extension positive. Always needed.
  double velocity;
  // Side force on the rod, N.
  double side_force;
  // Damper temperature, degrees Celsius.
  double temperature;
  // Commanded setting (current, clicks, ...) in the unit of the model file, constant during a step. Ignored if the damper depends on none.
  double setting;
} dashpot_input;

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


// ==============================================================================================================
// State
// ==============================================================================================================

// The state contains the whole history of a damper, friction hysteresis included, as numbers that the host owns. Copy the structure to
// try a step and roll it back, or to save a run and resume it. A run resumed from a copy repeats the original run to the last bit.
//
// A state may be used with another model, for example when a model is prepared again while it
// runs. Internal states follow their elements, and an element that was off before starts in equilibrium.
//
// Derivatives of a step are exact where its force is smooth. A knee is a point of a piecewise linear curve, a stop, a
// reversal or a void that closes. At a knee the derivatives are those of the side on which the step was solved, or lie
// between those of both sides. An implicit host should bound its Newton steps there. In a search over random steps,
// most of them far from real dampers, one derivative in a thousand has an error above 2 %. With a nonlinear spring
// nearly as stiff as the series spring and an element of the oil, a step of 10 ms gives the derivative of the tangent
// at its last iterate.

// State of one damper.
typedef struct dashpot_state {
  // Displacement of the moving end, m: provided by the host, or integrated from the initial position.
  double displacement;
  // Velocity of the moving end at the last step, m/s.
  double velocity;
  // Displacement of the internal mass, m.
  double mass_displacement;
  // Velocity of the internal mass, m/s.
  double mass_velocity;
  // Internal states of the elements that are on.
  double internal[8];
  // Number that identifies the layout of the internal states; written by the library. 0: the layout of the model
  // that the state is passed to.
  double layout;
  // 0.
  double reserved;
  // Commands of the last dead time, for a damper that depends on a setting; written by the library.
  double commands[20];
} dashpot_state;

// Output at one instant.
typedef struct dashpot_output {
  // Damper force, N, tension positive.
  double force;
  // Derivative of the force with respect to the input displacement, N/m, at constant states. After a step: the total
  // derivative at the end of the step.
  double d_force_d_displacement;
  // Derivative of the force with respect to the input velocity, N s/m, at constant states. After a step: the total
  // derivative at the end of the step. Without an input displacement, that derivative includes the effect of the
  // integrated displacement.
  double d_force_d_velocity;
  // Force of the primary damper (the force-velocity curve), N.
  double primary_force;
  // Force of the springs on the internal mass, N.
  double spring_force;
  // Friction, presliding included, N.
  double friction_force;
  // Gas force, gas spring included, N; negative where it pushes the rod out.
  double gas_force;
  // Deflection of the series spring, m.
  double series_deflection;
  // Force of the stops at the ends of the stroke, N.
  double stop_force;
  // Temperature of the oil at which the forces are computed, degrees Celsius.
  double oil_temperature;
} dashpot_output;

// Initializes the state of a damper at rest in equilibrium at initial_position (m, extension positive).
//
// A step at constant position then returns the static force. A damper that depends on a setting is in equilibrium at the start setting.
int32_t dashpot_state_init(const dashpot_model *model,
                           double initial_position,
                           dashpot_state *state);

// Initializes the steady state of a damper at the constant velocity of *input.
//
// Use it where a simulation starts in motion, to avoid a jump of the velocity in the first steps. Without DASHPOT_KNOWS_DISPLACEMENT the
// displacement is 0.
int32_t dashpot_state_init_motion(const dashpot_model *model,
                                  const dashpot_input *input,
                                  dashpot_state *state);


// ==============================================================================================================
// Step
// ==============================================================================================================

// For hosts with a fixed step. A step runs from the time of a state to a time later by dt. The input is the one at the
// end of the step. The input at the start of the step is not needed again, because the state contains its displacement
// and velocity.
//
// dt = 0 is a static evaluation: the equilibrium force at constant displacement and velocity. Presliding friction keeps its
// deflection from the motion before. The state does not change.

// Computes the force (N) from the velocity (m/s) and advances *state by dt (s).
//
// The displacement is integrated from the initial position. A damper that depends on a setting is at its start setting; see
// dashpot_force_with_setting(). The force equals that of dashpot_step() to the bit, at a cost lower by a tenth to a quarter, because no
// partial derivatives are computed.
int32_t dashpot_force(const dashpot_model *model,
                      dashpot_state *state,
                      double velocity,
                      double dt,
                      double *force);

// Advances the state *from by one step of dt (s), at whose end the input is *to_input. Writes the new state to *to and
// the output at the end of the step to *output.
//
// from and to may be the same state; otherwise *from is not changed, so a step may be tried and repeated.
int32_t dashpot_step(const dashpot_model *model,
                     const dashpot_state *from,
                     const dashpot_input *to_input,
                     double dt,
                     dashpot_state *to,
                     dashpot_output *output);

// Advances count dampers by one step of dt (s), such as the four corners of a car.
//
// models holds count pointers, which may point to the same model. from, to_inputs, to and outputs hold count elements each. from and to
// may be the same array. The results equal those of count calls of dashpot_step() to the last bit. All arguments are checked first: an
// error of one damper leaves every output unchanged. Only DASHPOT_NOT_COMPUTABLE occurs later: the dampers before the failed one are then
// advanced, and the failed one and all after it are unchanged. Returns all warnings combined.
int32_t dashpot_step_batch(uint32_t count,
                           const dashpot_model *const *models,
                           const dashpot_state *from,
                           const dashpot_input *to_inputs,
                           double dt,
                           dashpot_state *to,
                           dashpot_output *outputs);


// ==============================================================================================================
// Partial derivatives
// ==============================================================================================================

// The outputs of dashpot_jacobian() and dashpot_jacobian_setting().

// All partial derivatives at one instant. The states have the order of dashpot_evaluate(); the inputs are displacement and
// velocity.
typedef struct dashpot_partials {
  // dF/d(input).
  double d_force_d_input[2];
  // dF/d(state).
  double d_force_d_state[10];
  // d(rate of state i)/d(input).
  double d_rate_d_input[10][2];
  // d(rate of state i)/d(state j).
  double d_rate_d_state[10][10];
} dashpot_partials;

// Derivatives of force and state rates with respect to the commanded setting, at constant states.
typedef struct dashpot_setting_derivatives {
  // dF/d(setting). 0 if the actuator has a lag, because the force then depends on the actuator's states instead.
  double d_force_d_setting;
  // d(rate of state i)/d(setting), in the order of dashpot_partials.
  double d_rate_d_setting[10];
} dashpot_setting_derivatives;


// ==============================================================================================================
// Evaluation
// ==============================================================================================================

// For hosts whose own solver integrates the states: force, rates and partial derivatives at one instant. The functions
// read the state and do not change it.
//
// The states that the solver integrates are, in this order: displacement of the internal mass, its velocity, and the
// internal states. dashpot_model_states() returns their number, dashpot_model_state_name() their names. All entries after
// them in a structure are 0 and stay 0. Without series_compliance the internal mass moves with the moving end: its two
// rates are 0. A host without a displacement integrates that too (rate->displacement is the velocity). state->velocity is
// the last input of a step and no state: it is ignored, and its rate is 0.
//
// The states are stiff: the small mass behind the valves follows at rates of 1e4 to 1e6 1/s, which `dashpot check` reports for
// a model file. An implicit solver with the partial derivatives (CVODE, DASSL, Radau) takes long steps. An explicit one
// (Euler, Runge-Kutta) needs steps of microseconds; longer steps may yield a wrong force with status 0. dashpot_step() is
// stable at every step.

// Evaluates force and state derivatives at *state and *input: writes the output to *output, d(state)/dt to *rate.
int32_t dashpot_evaluate(const dashpot_model *model,
                         const dashpot_state *state,
                         const dashpot_input *input,
                         dashpot_output *output,
                         dashpot_state *rate);

// Writes all partial derivatives of force and rates at *state and *input to *partials.
int32_t dashpot_jacobian(const dashpot_model *model,
                         const dashpot_state *state,
                         const dashpot_input *input,
                         dashpot_partials *partials);


// ==============================================================================================================
// Setting
// ==============================================================================================================

// Many dampers depend on a setting: the current of a semi-active valve, the click of an adjuster, a gas pressure. A
// parameter set may contain one value of a number for each setting of a grid of 2 to 8 settings. The same holds for
// the forces of the FV table. A model file contains, for example, these lines:
//
//     setting = [0.0, 0.8, 1.6]
//     setting_name = "current"
//     setting_unit = "A"
//     gas_force = [80.0, 82.0, 85.0]
//     fv_force = [[...], [...], [...]]
//
// Its model reads the commanded setting from every input (DASHPOT_KNOWS_SETTING), separately for each damper. Numbers and forces are
// interpolated by monotone cubics, exact on the grid. A setting outside the grid is clamped to its ends (warning DASHPOT_OUTSIDE_SETTING).
// At every setting the damper equals one without a setting that has the interpolated numbers.
//
// The actuator has a dead time, time constants for a rising and for a falling setting, rate limits and hysteresis.
// dashpot_params_set() sets them by the names "setting_dead_time", "setting_time_up", "setting_time_down",
// "setting_rate_up", "setting_rate_down", "setting_hysteresis" and "setting_hysteresis_rest". "setting_start" is the
// setting if the host provides none. The actual setting of the valve is part of the state.
//
// An evaluation (see Evaluation) ignores the dead time, because it stores no previous commands. A host that integrates the
// states must delay the command itself.

// Maximum number of settings of a grid.
#define DASHPOT_MAX_SETTINGS 8

// The setting of a parameter set. Set struct_size before the call.
typedef struct dashpot_setting {
  // sizeof(dashpot_setting).
  uint32_t struct_size;
  // Number of settings of the grid; 0 if the damper depends on none.
  uint32_t count;
  // The grid, increasing.
  double grid[8];
  // Setting if the host provides none.
  double start;
  // Name, zero-terminated, such as current; empty where none is given.
  char name[32];
  // Unit, zero-terminated, such as A; empty where none is given.
  char unit[32];
} dashpot_setting;

// Sets the grid of the setting: count increasing numbers. All values over the previous grid are removed.
//
// With count 0 the damper no longer depends on a setting.
int32_t dashpot_params_set_grid(dashpot_params *params, const double *grid, uint32_t count);

// Makes a number depend on the setting: values contains one value for each setting of the grid.
int32_t dashpot_params_set_over(dashpot_params *params, const char *name, const double *values, uint32_t count);

// Sets the forces of the FV table, fv_force, at the setting with this index of the grid, from 0. All settings of the grid need them.
int32_t dashpot_params_set_list_over(dashpot_params *params,
                                     const char *name,
                                     uint32_t index,
                                     const double *values,
                                     uint32_t count);

// Reads the setting that a parameter set depends on.
int32_t dashpot_params_setting(const dashpot_params *params, dashpot_setting *setting);

// Computes the force as dashpot_force() does, with the commanded setting. A damper that depends on none ignores it.
int32_t dashpot_force_with_setting(const dashpot_model *model,
                                   dashpot_state *state,
                                   double velocity,
                                   double setting,
                                   double dt,
                                   double *force);

// Writes the actual setting of the valve to *setting: the command clamped to the grid, after the dynamics of the actuator.
//
// 0 for a damper that depends on no setting.
int32_t dashpot_actuator_setting(const dashpot_model *model,
                                 const dashpot_state *state,
                                 const dashpot_input *input,
                                 double *setting);

// Writes the derivative of the force with respect to the actual setting of the valve to *derivative.
//
// It is the total derivative of the force of dashpot_step() from *from to *to_input; with dt = 0, of the equilibrium force. A controller divides
// by this derivative. The call costs two steps. 0 for a damper that depends on no setting.
int32_t dashpot_d_force_d_setting(const dashpot_model *model,
                                  const dashpot_state *from,
                                  const dashpot_input *to_input,
                                  double dt,
                                  double *derivative);

// Writes the derivatives of force and state rates with respect to the commanded setting to *by_setting.
//
// They apply at *state and *input. dashpot_jacobian() does not contain them. They are 0 for a damper without a setting.
int32_t dashpot_jacobian_setting(const dashpot_model *model,
                                 const dashpot_state *state,
                                 const dashpot_input *input,
                                 dashpot_setting_derivatives *by_setting);


// ==============================================================================================================
// Parameter table
// ==============================================================================================================

// For programs that list the parameters, such as a dialogue: name, unit, bounds, default and meaning of every row.

// The parameter is one number.
#define DASHPOT_SHAPE_NUMBER 0

// The parameter is one of several words, set by number from 0; meaning lists them.
#define DASHPOT_SHAPE_CHOICE 1

// The parameter is a list of numbers.
#define DASHPOT_SHAPE_LIST 2

// One row of the parameter table. Set struct_size before the call.
typedef struct dashpot_parameter {
  // sizeof(dashpot_parameter).
  uint32_t struct_size;
  // DASHPOT_SHAPE_NUMBER, DASHPOT_SHAPE_CHOICE or DASHPOT_SHAPE_LIST.
  uint32_t shape;
  // Capacity: 1, or the maximum length of a list.
  uint32_t capacity;
  // Row of this parameter in the table.
  uint32_t row;
  // Default; for a list its first number (dashpot_params_get_list() on a default set returns all).
  double default_value;
  // Smallest allowed value.
  double low;
  // Largest allowed value.
  double high;
  // Name.
  char name[48];
  // SI unit; "-" for a pure number.
  char unit[16];
  // Name of the parameter's element, or of the group of settings.
  char element[48];
  // Meaning in one sentence.
  char meaning[256];
} dashpot_parameter;

// Number of rows of the parameter table.
uint32_t dashpot_parameter_count(void);

// Describes row `row` of the parameter table, from 0.
int32_t dashpot_parameter_info(uint32_t row, dashpot_parameter *info);


// ==============================================================================================================
// Parameters, their units, bounds and defaults
// ==============================================================================================================

// Names for dashpot_params_set(), dashpot_params_set_list() and model files.
//
// fv_curve (element, on by default): primary damper: the force-velocity (FV) curve
//   fv_form                      source of the FV curve: table, or damping coefficients and knee velocities [0 table, 1 piecewise]
//   fv_interpolation             interpolation between the points of the FV table [0 monotone_cubic, 1 linear, 2 cubic_each_side]
//   fv_velocity                  velocities of the FV table, rebound positive, increasing [m/s, -20 to 20, at most 63 numbers]
//   fv_force                     forces of the FV table, tension positive, non-decreasing [N, -1e6 to 1e6, at most 63 numbers]
//   fv_rebound_c1                Cr1: rebound damping coefficient below the first knee [N s/m, 0 to 1e8, default 6000]
//   fv_rebound_c2                Cr2: rebound damping coefficient between the knees [N s/m, 0 to 1e8, default 2500]
//   fv_rebound_c3                Cr3: rebound damping coefficient above the second knee [N s/m, 0 to 1e8, default 1600]
//   fv_rebound_v1                velocity of the first rebound knee [m/s, 1e-4 to 10, default 0.13]
//   fv_rebound_v2                velocity of the second rebound knee [m/s, 1e-4 to 10, default 0.4]
//   fv_compression_c1            Cc1: compression damping coefficient below the knee [N s/m, 0 to 1e8, default 3500]
//   fv_compression_c2            Cc2: compression damping coefficient above the knee [N s/m, 0 to 1e8, default 950]
//   fv_compression_v1            speed at the compression knee, positive [m/s, 1e-4 to 10, default 0.13]
//
// series_compliance (element, on by default): series spring and damper with the internal mass: compliance of gas, oil and mounts
//   series_stiffness             stiffness of the series spring, k_s [N/m, 10 to 1e10, default 3e6]
//   series_damping               damping coefficient parallel to the series spring, c_s [N s/m, 0 to 1e7, default 200]
//   internal_mass                internal moving mass of rod, oil and gas, m [kg, 5e-6 to 2000, default 0.5]
//   series_load                  forces that the series spring carries: hydraulic and parallel spring force, or friction and gas force as well (eye or mount) [0 hydraulic, 1 whole]
//
// free_play (element, off by default): free play in an eye or mount; needs series_compliance
//   free_play_gap                total free play from contact to contact, 2 g [m, 0 to 0.005, default 2e-4]
//   free_play_force              softness of the contact: force, beyond F_1, that closes half of the gap, F_0 [N, 1e-4 to 1e6, default 20]
//   free_play_load               load at the middle of the gap, F_1: weight on the eye, gas force, clamping [N, -1e6 to 1e6, default 0]
//
// bushing (element, off by default): rubber bushing in series with the damper: stiffening spring with hysteresis; needs series_compliance
//   bushing_hardening            deflection at which stiffening doubles the force of the series spring, d_h [m, 2e-4 to 1, default 0.002]
//   bushing_loss_stiffness       stiffness of the fast relaxing (Maxwell) branch over the series stiffness, k_1/k_s [-, 0 to 30, default 0.3]
//   bushing_loss_time            relaxation time of the fast branch, tau [s, 1e-4 to 1000, default 0.01]
//   bushing_slip                 deflection over which filler friction relaxes the fast branch, d_f; large: relaxation in time only [m, 1e-6 to 1000, default 1000]
//   bushing_stop                 deflection at which the rubber meets a stop, in either direction, L [m, 1e-5 to 1, default 0.001]
//   bushing_stop_stiffness       stiffness that the stop adds, over the series stiffness, k_e/k_s; 0: no stop [-, 0 to 100, default 0]
//   bushing_slow_stiffness       stiffness of the slowly relaxing (Maxwell) branch over the series stiffness, k_2/k_s; 0: no such branch [-, 0 to 30, default 0]
//   bushing_slow_time            relaxation time of the slow branch, tau_2 [s, 0.001 to 1000, default 0.1]
//
// oil_compressibility (element, off by default): compressibility of the oil column upstream of the valves, expansion of the cylinder included
//   oil_stiffness                stiffness of the oil column at x = 0, cylinder expansion included, k_o [N/m, 20 to 1e11, default 3e6]
//   oil_shortening               reciprocal of the oil column length at x = 0, lambda; 0: stiffness independent of the position [1/m, -50 to 50, default 0]
//   oil_chambers                 chamber whose oil column is compressible: always the rebound chamber, or the chamber under pressure [0 rebound, 1 both]
//   oil_compression              ratio of the oil column stiffness in compression to that in rebound, r_o [-, 0.01 to 100, default 1]
//
// aeration (element, off by default): free air in the oil: low stiffness of the oil column at small forces
//   aeration_stroke              stroke that the compression of the air absorbs in rebound, d_a [m, 0 to 0.005, default 3e-4]
//   aeration_force               force at which the air has absorbed half of its stroke, F_a [N, 0.001 to 1e6, default 150]
//   aeration_compression         ratio of the stroke that the air absorbs in compression to that in rebound, r_a [-, 0 to 20, default 1]
//
// cavitation (element, off by default): cavitation: one stroke opens a void, which the return stroke must close
//   cavitation_force             largest hydraulic force on the cavitating stroke, C [N, 0.01 to 1e8, default 1500]
//   cavitation_side              stroke on which cavitation occurs [0 compression, 1 rebound]
//   cavitation_return            fraction of C that acts on the return while the void closes; 1: gas still pushes, 0: no force [-, 0 to 1, default 0]
//   cavitation_form              cause of the void: limited force on the cavitating stroke, or a foot valve that does not refill the chamber behind the piston [0 cap, 1 foot_valve]
//   cavitation_velocity          foot valve: speed on the cavitating stroke above which the chamber is not refilled completely, v_f [m/s, 0 to 10, default 0.3]
//   cavitation_unfilled          foot valve: fraction of the flow above v_f that is not refilled, a [-, 1e-4 to 1, default 0.05]
//   cavitation_onset             cap: force at which the void opens, as a fraction of C, alpha; 1: at C [-, 0 to 1, default 1]
//   cavitation_expansion         cap: void depth at which the expanding gas has raised the force halfway from alpha C to C, e_1 [m, 1e-5 to 0.1, default 5e-4]
//
// position_dependent_damping (element, off by default): position-dependent damping: lower (bypass) or higher over a part of the stroke
//   bypass_share                 fraction by which the FV force is reduced in the zone, a; negative: increased [-, -4 to 0.95, default 0.3]
//   bypass_centre                displacement at the center of the zone, c [m, -1 to 1, default 0]
//   bypass_half_width            half of the length of the zone, w [m, 0.001 to 1, default 0.02]
//   bypass_blend                 transition length at either end of the zone, b [m, 5e-4 to 0.5, default 0.005]
//   bypass_strokes               strokes on which the zone acts [0 both, 1 rebound, 2 compression]
//   bypass_form                  factor on the FV force, or bypass flow parallel to the valves [0 factor, 1 groove]
//   bypass_flow                  groove: bypass flow in the zone at a hydraulic force of 1 kN, as a piston velocity, q_b [m/s, 0 to 10, default 0.2]
//
// temperature_fade (element, off by default): temperature fade: damping that decreases with the oil temperature, measured or from self-heating
//   fade_source                  oil temperature: measured, or ambient temperature plus computed self-heating [0 measured, 1 self_heating]
//   fade_coefficient             relative decrease of the damping per kelvin, alpha [1/K, -0.02 to 0.2, default 0.003]
//   fade_reference               reference temperature of the FV curve, T_0 [degC, -60 to 200, default 20]
//   heat_capacity                heat capacity of the oil and the damper body, C_h [J/K, 0.05 to 1e7, default 1500]
//   heat_transfer                heat flow to the surroundings per kelvin of temperature difference, h [W/K, 0 to 1e5, default 6]
//   fade_laminar_force           FV force of which half is laminar and fades, F_l; large: all of it fades [N, 0.01 to 1e9, default 1e9]
//   fade_slackening              temperature dependence of the decrease, kappa; 0: exponential law, 1/(T_0 + 95 degC): Vogel's law [1/K, 0 to 0.03, default 0]
//
// frequency_selective_damping (element, off by default): frequency-selective damping: lower damping at high than at low stroke frequency, at equal speed
//   fsd_form                     fraction of the force that lags, fraction that builds up within each stroke, or bypass flow that ends within each stroke [0 filter, 1 stroke, 2 bypass]
//   fsd_share                    fraction of the force lost at high frequency, a [-, 0 to 0.9, default 0.3]
//   fsd_time                     time constant of the lag, or of filling the control chamber, tau [s, 0.001 to 10, default 0.05]
//   fsd_velocity                 stroke form: speed above which the control chamber fills at its full rate, u_0 [m/s, 0.001 to 1, default 0.02]
//   fsd_flow                     bypass form: bypass flow at a hydraulic force of 1 kN, as a piston velocity, q_s [m/s, 0 to 10, default 0.2]
//   fsd_force                    bypass form: hydraulic force above which the control chamber fills at its full rate, F_0 [N, 0.001 to 1e6, default 50]
//   fsd_laminar_force            bypass form: hydraulic force below which the bypass flow is laminar, F_l [N, 0.001 to 1e7, default 20]
//
// valve_hysteresis (element, off by default): blow-off valve that opens and closes with a lag: higher force while the speed rises
//   valve_hysteresis_share       opening form: largest force that the lag adds, as a fraction of the FV force, eta [-, 0 to 1, default 0.15]
//   valve_opening_force          force at which the valve opens [N, 0.001 to 1e7, default 600]
//   valve_closing_ratio          opening form: ratio of the closing force to the opening force; 1: lag by the time constant alone [-, 0.3 to 1, default 0.85]
//   valve_time                   time constant of the valve motion, tau; spool form: natural period over 2 pi [s, 1e-4 to 1, default 0.002]
//   valve_width                  force range over which the valve opens, b [N, 0.01 to 1e7, default 100]
//   valve_form                   one opening that lags, or a valve whose position lags at every force, by friction or by its mass [0 opening, 1 play, 2 spool]
//   valve_play                   play form: change of force that does not move the valve (friction), P [N, 0 to 1e6, default 0]
//   valve_damping                spool form: damping ratio of the valve, zeta [-, 0.05 to 10, default 0.7]
//
// parallel_spring (element, on by default): spring parallel to the primary damper: linear, quadratic, cubic, quartic or lookup table
//   spring_linear                linear stiffness, k_p of k_p x [N/m, 0 to 1e9, default 0]
//   spring_quadratic             quadratic stiffness, k_p of k_p x|x| [N/m^2, 0 to 1e8, default 10000]
//   spring_cubic                 cubic stiffness, k_p of k_p x^3 [N/m^3, 0 to 1e9, default 0]
//   spring_quartic               quartic stiffness, k_p of k_p x^3|x| [N/m^4, 0 to 1e10, default 0]
//   spring_displacement          displacements of the spring's lookup table, increasing; empty: no table [m, -10 to 10, at most 63 numbers]
//   spring_force                 forces of the spring's lookup table, non-decreasing [N, -1e6 to 1e6, at most 63 numbers]
//
// coulomb_friction (element, off by default): Coulomb friction: dry friction of constant magnitude, F_s tanh(K v)
//   coulomb_force                magnitude of the friction force, F_s [N, 0 to 1e6, default 40]
//   coulomb_steepness            steepness of the sign change at zero velocity, K [s/m, 1 to 1e5, default 2000]
//
// stribeck_friction (element, on by default): Stribeck friction: dry friction with a breakaway peak
//   stribeck_form                form of the Stribeck curve [0 simplified, 1 full]
//   stribeck_breakaway_force     breakaway force (peak), F_brk or F_t [N, 0 to 1e6, default 50]
//   stribeck_coulomb_force       Coulomb friction force beyond the peak, F_c or F_s [N, 0 to 1e6, default 40]
//   stribeck_breakaway_velocity  velocity at the breakaway peak, v_brk or V_fs [m/s, 1e-5 to 1, default 0.005]
//   stribeck_velocity            full form: Stribeck velocity, the scale of the decrease after the peak, V_s [m/s, 1e-5 to 5, default 0.01]
//   stribeck_fall                full form: exponent of the decrease after the peak, a (1 Tustin, 2 Gauss) [-, 1 to 4, default 2]
//   stribeck_rise                full form: steepness of the rise to the peak, c; large: the peak reaches F_t [-, 0.1 to 20, default 3]
//   stribeck_rise_power          full form: exponent of the rise to the peak, d [-, 1 to 4, default 1]
//
// viscous_friction (element, on by default): viscous friction, quadratic in the velocity, F_v v|v|
//   viscous_coefficient          friction coefficient, F_v of F_v v|v| [N s^2/m^2, 0 to 1e7, default 10]
//
// side_force_friction (element, off by default): dry friction proportional to the side force on the rod
//   side_force_coefficient       friction coefficient: friction force over side force, k_avg [-, 0 to 2, default 0.05]
//   side_force_steepness         steepness of the sign change at zero velocity, K [s/m, 1 to 1e5, default 2000]
//
// gas_preload (element, on by default): constant gas force
//   gas_force                    gas force, positive when it pushes the rod out [N, -1e6 to 1e6, default 80]
//
// gas_warming (element, off by default): gas force that increases with the temperature of the damper
//   gas_warming_rate             increase of the gas force per kelvin, c [N/K, 0 to 5000, default 0.8]
//   gas_warming_reference        temperature at which this element adds no gas force, T_0 [degC, -60 to 200, default 20]
//
// lagged_polynomial (element, off by default): polynomial FV curve with a first-order lag, whose time constant depends on the speed
//   polynomial                   coefficients of the polynomial FV curve, of v^0, v^1, ... [N (s/m)^k, -1e9 to 1e9, at most 12 numbers]
//   lag_slow                     time constant of the lag at low speed [s, 1e-5 to 1, default 0.004]
//   lag_fast                     time constant of the lag at high speed [s, 1e-5 to 1, default 0.001]
//   lag_v1                       speed below which the time constant is that of low speed [m/s, 0 to 10, default 0.05]
//   lag_v2                       speed above which the time constant is that of high speed [m/s, 1e-4 to 20, default 0.5]
//
// presliding_friction (element, off by default): presliding friction (Dahl): friction that changes sign over a short travel after each reversal
//   presliding_force             friction force after long travel, F_c [N, 0 to 1e6, default 40]
//   presliding_length            presliding displacement: travel over which the difference to F_c falls by a factor e, z_0 [m, 1e-5 to 0.005, default 3e-4]
//   presliding_power             exponent of the slip, n; 1: slip from the start (Dahl), larger: elastic deflection before slip [-, 1 to 10, default 1]
//   presliding_return            unloading after a reversal: with slip, or elastic [0 slips, 1 elastic]
//   presliding_creep             speed below which the contact creeps, v_c [m/s, 1e-9 to 0.1, default 1e-9]
//
// gas_spring (element, off by default): change of the gas force with the rod displacement, isothermal to adiabatic
//   gas_stiffness                isothermal gas stiffness at x = 0, k [N/m, 0 to 1e8, default 500]
//   gas_length                   gas volume at x = 0 over the rod area, L; shorter: more progressive [m, 0.05 to 10, default 0.4]
//   gas_adiabatic_index          adiabatic index: ratio of adiabatic to isothermal stiffness, gamma [-, 1 to 1.67, default 1.4]
//   gas_thermal_time             thermal time constant between gas and wall, tau [s, 0.01 to 1000, default 3]
//
// moving_mass (element, off by default): inertia of a mass between load cell and damper, which the moving end drives, or of one that the piston drives
//   moving_mass                  moving mass, M [kg, 0 to 10000, default 2]
//   moving_mass_time             lag of the inertia force, tau; short compared with the motion [s, 1e-4 to 0.01, default 2e-4]
//   moving_mass_place            point that drives the mass: moving end of the damper, or piston behind the series stiffness [0 driven end, 1 inside]
//
// bump_stop (element, off by default): bump stop at the end of the compression stroke, rubber or hydraulic
//   bump_stop_clearance          compression from x = 0 to first contact with the stop, positive [m, 0 to 1, default 0.05]
//   bump_stop_stiffness          stiffness of the stop at first contact [N/m, 0 to 1e9, default 50000]
//   bump_stop_progression        deflection of the stop at which its spring force is twice the linear force [m, 0.001 to 1, default 0.02]
//   bump_stop_loss               fraction of the spring force lost on loading, and again on unloading [-, 0 to 0.9, default 0.15]
//   bump_stop_damping            hydraulic damping coefficient on loading, at the deflection of the progression [N s/m, 0 to 1e8, default 0]
//   bump_stop_flow               hydraulic force proportional to the speed (gap) or to its square (orifice), equal at 1 m/s [0 gap, 1 orifice]
//
// rebound_stop (element, off by default): rebound stop at the end of the rebound stroke, rubber or hydraulic
//   rebound_stop_clearance       extension from x = 0 to first contact with the stop [m, 0 to 1, default 0.05]
//   rebound_stop_stiffness       stiffness of the stop at first contact [N/m, 0 to 1e9, default 1e5]
//   rebound_stop_progression     deflection of the stop at which its spring force is twice the linear force [m, 0.001 to 1, default 0.02]
//   rebound_stop_loss            fraction of the spring force lost on loading, and again on unloading [-, 0 to 0.9, default 0.15]
//   rebound_stop_damping         hydraulic damping coefficient on loading, at the deflection of the progression [N s/m, 0 to 1e8, default 0]
//   rebound_stop_flow            hydraulic force proportional to the speed (gap) or to its square (orifice), equal at 1 m/s [0 gap, 1 orifice]
//
// integration: settings of the fixed-step integration
//   method                       integration method within a step; automatic: the cheapest with an error below a thousandth in a step of 1 ms [0 automatic, 1 second_order, 2 euler, 3 third_order, 4 fourth_order, 5 three_stage]
//   substeps                     substeps within one step of the host; 0: as many as stiffness and damping of the model require [-, 0 to 64, default 0]


#ifdef __cplusplus
}
#endif

#endif
