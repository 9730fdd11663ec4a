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
//! Every function returns a status that a program should check: 0 is success, positive is a warning,
//! negative is an error. dashpot_status_text() returns the message.
//!
//! Units and signs. SI throughout: m, m/s, N, kg, s; temperature in degrees Celsius. Extension (rebound) velocity is
//! positive, compression negative. Tension is positive: a damper that resists extension has a positive
//! force, and gas that pushes the rod out a negative one. This is stated here once and holds everywhere below.
//!
//! Linking. Compile with -I include. Shared: program.c libdashpot.so (Windows: dashpot.dll and its import library).
//! Static: program.c libdashpot.a, in any order with other libraries of C and C++. The static one is a single object.
//! All its names are local, except dashpot_*. To build the static library from sources, run sh src/dll/static.sh, which
//! writes it to target/lib. Neither the shared nor the static library needs another library. Both import only memcpy,
//! memmove, memset, memcmp and bcmp, which compilers call by themselves and every C runtime has. They use no allocator,
//! file, lock or thread.
//!
//! Memory. The library allocates nothing and stores nothing. The caller owns all blocks, as globals, on the stack or
//! on the heap. There is nothing to free. dashpot_params, dashpot_model and dashpot_state hold no pointers; they may
//! be copied with = or memcpy. dashpot_params and dashpot_model must lie at an address divisible by 16. The compiler
//! ensures that. (Before C++17, new guarantees only the alignment of malloc, which is 16 on 64-bit systems.)
//!
//! Sizes. A state is 272 bytes, an output 80, a parameter set 16 KB, a model 48 KB. No function uses more than 16 KB of the
//! caller's stack (dashpot_jacobian() 14 KB, a step 12 KB). Keep models and parameter sets off a small stack. A list has at
//! most 63 numbers (see capacity in dashpot_parameter), a name 47 characters. The size of a file is not limited.
//!
//! Null. Only these pointers may be null: fault of dashpot_params_read(), values of dashpot_params_get_list() (which then returns only
//! the length), and an array of no elements.
//!
//! Errors. A function that returns a negative status leaves outputs and state unchanged.
//! These are errors: null pointers, addresses that are not aligned, structures of another size, another interface version,
//! blocks that were never initialized, and numbers that are NaN, infinite or absurdly large (see DASHPOT_BAD_INPUT).
//! After any other status all outputs are finite.
//!
//! Threads. There is no hidden state. Functions may run at the same time in any number of threads as long as no two
//! of them write the same block and none writes what another reads. One model serves any number of dampers; each
//! damper needs its own state. Every call returns in bounded time, uses no lock and preserves the floating-point mode.
//!
//! Results are the same to the last bit on every 64-bit platform, whatever compiler built the host.

#![no_std]
#![allow(non_camel_case_types)]
// The manual above states the requirements on callers once: pointers are valid or null.
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
