//! Chatter of a damper in a host with a zero-order hold of the force: detection, cause and remedy.
//!
//! A host that computes the force at the start of a step and moves a mass m by it over the step h,
//!
//! ```text
//! v' = v − (h/m) F(x, v),   x' = x + h v'
//! ```
//!
//! multiplies a small disturbance of the velocity by 1 − g, with g = (h/m)(∂F/∂v + h ∂F/∂x). F is the damper force. v and x are velocity
//! and displacement at the start of the step, v' and x' at its end. For g below 1 the disturbance decays smoothly. For g from 1 to 2 it
//! changes sign at every step and decays. Beyond 2 it grows until a nonlinearity limits it. Friction, for example, then alternates between
//! its two levels forever. The derivatives are those of one step of length h of the model (`dashpot_core::step`). Thus, a series spring and
//! presliding friction reduce them.
//!
//! | module | what |
//! |---|---|
//! | [`Host`] | step and mass of the host |
//! | [`Situation`] | position, side force and temperature of a check |
//! | `gain` | gain over motions and over the FV curve |
//! | [`Turning`] | result of the simulated host loop |
//! | [`chatter`] | full check of one damper, and the element that causes chatter |
//! | [`mod@softened`] | replacement of friction that chatters |
//! | [`Ready`] | damper checked in a host and prepared for it |
//! | `describe` | messages |

mod describe;
mod gain;
mod host;
mod host_loop;
mod in_host;
mod ready;
mod situation;
mod softened;
#[cfg(test)]
mod tests;

pub use host::Host;
pub use host_loop::Turning;
pub use in_host::{Chatter, GROWS, RINGS, chatter};
pub use ready::{Figures, HostError, Ready};
pub use situation::Situation;
pub use softened::{Softened, Softer, softened};

use dashpot_core::Params;

/// Returns the remarks for the export of a damper to a host.
///
/// The remarks report chatter in this host, and an internal mass whose oscillation the host's step does not resolve. There are no remarks
/// if the damper cannot be checked.
pub fn remarks(params: &Params, host: Host) -> Vec<String> {
    Ready::prepare(params, host.step, host.mass, None).map(|ready| ready.remarks()).unwrap_or_default()
}
