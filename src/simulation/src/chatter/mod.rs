//! Whether a damper chatters in a host that holds its force over a step, which element makes it, and a damper that does not.
//!
//! A host that computes the force at the start of a step and moves a mass m by it over the step h,
//!
//! ```text
//! v' = v − (h/m) F(x, v),   x' = x + h v'
//! ```
//!
//! returns a small disturbance of the velocity times 1 − g, with g = (h/m)(∂F/∂v + h ∂F/∂x). Below 1 it dies out smoothly, from 1 on
//! it changes sign at every step, beyond 2 it grows until something bounds it: friction swings between its two levels for ever.
//! The slopes are those of the damper's own step of the length h, so that a series spring and presliding friction soften what they carry.
//!
//! | module | what |
//! |---|---|
//! | [`Host`] | step and mass of the host |
//! | [`Situation`] | where in its stroke a damper is looked at, and under what |
//! | `gain` | the gain over motions and over the FV curve |
//! | [`Turning`] | the loop of the host, run |
//! | [`chatter`] | all of it for one damper, and which element makes it |
//! | [`softened`] | a damper that does not |
//! | [`Ready`] | a damper judged in a host, and made ready for it |
//! | `told` | all of it in words |

mod gain;
mod host;
mod host_loop;
mod in_host;
mod ready;
mod situation;
mod softened;
#[cfg(test)]
mod tests;
mod told;

pub use host::Host;
pub use host_loop::Turning;
pub use in_host::{Chatter, GROWS, RINGS, chatter};
pub use ready::{Figures, HostError, Ready};
pub use situation::Situation;
pub use softened::{Softened, Softer, softened};

use dashpot_core::Params;

/// What must be known beside an export of a damper.
///
/// How it chatters, where it does in that host, and whether its step follows the mass inside.
pub fn remarks(params: &Params, host: Host) -> Vec<String> {
    Ready::prepare(params, host.step, host.mass, None).map(|ready| ready.remarks()).unwrap_or_default()
}
