//! dashpot: an automotive suspension damper for simulators.
//!
//! Give the damper a velocity, get its force:
//!
//!     static dashpot_params params = DASHPOT_PARAMS_INIT;
//!     static dashpot_model model;
//!     dashpot_state state;
//!     double force;
//!
//!     dashpot_params_default(&params);                           // a passenger car damper
//!     dashpot_params_set(&params, "gas_force", 120.0);           // or dashpot_params_read() a model file
//!     dashpot_model_init(&model, &params);                       // checks and prepares
//!     dashpot_state_init(&model, -0.02, &state);                 // initial position, m
//!     while (running)
//!         dashpot_force(&model, &state, velocity, dt, &force);   // m/s and s in, N out
//!
//! Every function answers with a status that a program should look at: 0 is success, positive is a warning,
//! negative is a refusal; dashpot_status_text() says it in words.
//!
//! Units and signs. SI throughout: m, m/s, N, kg, s; temperature in degrees Celsius. Extension (rebound) velocity is
//! positive, compression negative. Tension is positive: a damper that resists extension answers with a positive
//! force, gas that pushes the rod out is a negative one. This is stated here once and holds everywhere below.
//!
//! Linking. Compile with -I include. Shared: program.c libdashpot.so (Windows: dashpot.dll and its import library). Static:
//! program.c libdashpot.a, in any order with other libraries of C and C++. The static one is a single object whose names are local
//! but for dashpot_*; a build from sources makes it with sh src/dll/static.sh, in target/lib. Neither needs another library. Both
//! import no function but memcpy, memmove, memset, memcmp and bcmp, which compilers call by themselves and every C
//! runtime has; there is no allocator, file, lock or thread behind them.
//!
//! Memory. The library allocates nothing and keeps nothing: all blocks are the caller's, as globals, on the stack or
//! on the heap. There is nothing to free. dashpot_params, dashpot_model and dashpot_state hold no pointers; they may
//! be copied with = or memcpy. dashpot_params and dashpot_model must lie at an address divisible by 16 (the compiler
//! sees to that; from C++ before C++17, new does not promise more than malloc does, which is 16 on 64-bit systems).
//!
//! Sizes. A state is 272 bytes, an output 80, a parameter set 16 KB, a model 48 KB. No function takes more than 16 KB of the
//! caller's stack (dashpot_jacobian() 14 KB, a step 12 KB); keep models and parameter sets off a small stack. A list has at
//! most 63 numbers (capacity in dashpot_parameter says it for each row), a name 47 characters, a file as many bytes as it has.
//!
//! Null. No pointer may be null but these: fault of dashpot_params_read(), values of dashpot_params_get_list() (only the length is
//! told), and an array of no elements.
//!
//! Refusals. A function that returns a negative status has changed nothing: outputs and state are as they were.
//! Refused are null pointers, addresses that are not aligned, structures of another size, another interface version,
//! blocks that were never initialised, and numbers that are NaN, infinite or absurdly large (DASHPOT_BAD_INPUT says which).
//! An answer that is not a refusal is finite in all its numbers.
//!
//! Threads. There is no hidden state. Functions may run at the same time in any number of threads as long as no two
//! of them write the same block and none writes what another reads. One model serves any number of dampers; each
//! damper needs its own state. Every call takes a bounded time, takes no lock and leaves the floating-point mode alone.
//!
//! Results are the same to the last bit on every 64-bit platform, whatever compiler built the host.

#![no_std]
#![allow(non_camel_case_types)]
// What a caller must keep to is stated once, in the manual above: valid pointers or null.
#![allow(clippy::missing_safety_doc)]

#[cfg(test)]
extern crate std;

pub mod evaluate;
mod family;
pub mod input;
pub mod model;
pub mod params;
pub mod partials;
mod pointer;
pub mod setting;
pub mod state;
pub mod status;
pub mod step;
mod stepping;
pub mod table;
mod text;
pub mod version;
