//! Messages about chatter.

use super::host::Host;
use super::host_loop::HALVINGS;
use super::in_host::{Chatter, GROWS, RINGS};
use super::situation::{COLD, PLACES, SIDE_FORCE, STOP_FORCE};
use super::softened::{FRICTION, Softened, Softer};
use crate::limit::plain;
use dashpot_core::element;

impl Chatter {
    /// Returns whether a disturbance of the velocity changes sign from step to step, according to the gain or to the
    /// simulated host loop.
    pub fn rings(&self) -> bool {
        self.gain >= RINGS || self.turning.is_some()
    }

    /// Returns whether a disturbance of the velocity that changes sign from step to step does not decay.
    pub fn swings(&self) -> bool {
        self.gain >= GROWS || self.turning.is_some()
    }

    /// Describes the chatter in sentences for the user. `softened` states whether `--for-step` was given.
    pub fn describe(&self, host: Host, softened: bool) -> String {
        let Host { step, mass } = host;
        let head = format!(
            "At a host step of {} ms and {mass} kg the damper's gain c·h/m is {:.2} at most (c {:.0} N s/m, k {:.0} N/m, at {:.1} mm/s{})",
            1e3 * step,
            self.gain,
            self.d_force_d_velocity,
            self.d_force_d_displacement,
            1e3 * self.velocity,
            self.situation.describe()
        );
        let below = if self.gain < 0.0 {
            "; a gain below 0 says nothing by itself, for it comes from a mass in the damper, which acts on in the next step"
        } else {
            ""
        };
        if !self.rings() {
            return format!(
                "{head}{below}: it does not chatter in a host that holds its force over a step, nor in such a loop that was run here ({mass} kg on a \
                 tyre, its displacement advanced with the new velocity). Looked at were motions up to 50 mm and 1 m/s about the middle, and, where they change this damper, places up to {:.0} mm from it, \
                 {SIDE_FORCE} N of side force, stops up to {:.0} kN and {COLD} °C.",
                1e3 * PLACES[7],
                1e-3 * STOP_FORCE
            );
        }
        let is_friction = self.element.is_some_and(|(element, _)| {
            element == element!("side_force_friction") || FRICTION.iter().any(|f| f.0 == element)
        });
        let softer =
            if is_friction && !softened { format!(", or make it ready with --for-step {step}") } else { String::new() };
        let steps = match self.quiet_step {
            Some(quiet) => format!("Take steps of {} ms or less", plain(1e3 * quiet)),
            None => format!("No step down to {} ms was quiet", plain(1e3 * step * 0.5f64.powi(HALVINGS))),
        };
        let in_the_loop = self.turning.map(|turning| turning.describe(host));
        if self.gain < RINGS {
            let by = match self.element {
                Some((element, _)) => format!("; {element} makes it, without it the loop is quiet"),
                None => "; no element makes it alone".to_owned(),
            };
            let calming = match self.calming {
                Some(damping) => format!(
                    ", or give series_damping, which is 0, a value: with {damping:.0} N s/m the loop is quiet. The mass inside rings on its spring, which nothing damps"
                ),
                None => String::new(),
            };
            return format!("{head}{below}. But {}{by}. {steps}{calming}{softer}.", in_the_loop.unwrap_or_default());
        }
        let by = match self.element {
            Some((element, left)) => format!("; {element} makes it, without it the gain is {left:.2}"),
            None => "; no element makes it alone".to_owned(),
        };
        let how = if self.gain < GROWS {
            "a disturbance changes sign at every step and dies out"
        } else {
            "the force swings from step to step"
        };
        let seen = in_the_loop.map_or_else(String::new, |seen| format!("; {seen}"));
        format!(
            "{head}{by}: in a host that holds the force over a step (explicit) {how}{seen}. {steps}, let the host solve with the slopes that \
             dashpot_step gives (implicit){softer}."
        )
    }
}

impl Softened {
    /// Describes the replacements and the force differences that they cause.
    pub fn describe(&self) -> String {
        let done = self.softer.iter().map(|one| match one {
            Softer::Replaced { element, force, length } => format!(
                "{element} was replaced by presliding friction of {force:.1} N that turns over {:.4} mm",
                1e3 * length
            ),
            Softer::LessSteep { before, after } => {
                format!("side_force_steepness was lowered from {before:.0} to {after:.0} s/m")
            }
        });
        let done: Vec<String> = done.collect();
        format!(
            "{}: the gain is {:.2} now{}; the force differs by {:.2} N rms and {:.1} N at most over motions of 0.2 to 50 mm at 2 mm/s to 1 m/s{}, at reversals.",
            done.join("; "),
            self.gain,
            if self.gain < RINGS { "" } else { ", which comes from what was not replaced" },
            self.rms_error,
            self.largest_error,
            if self.softer.iter().any(|one| matches!(one, Softer::LessSteep { .. })) {
                format!(" under {SIDE_FORCE} N of side force")
            } else {
                String::new()
            }
        )
    }
}
