//! Check of a damper in a host for chatter, and search for the element that causes it.

use super::gain::{Largest, largest, on_the_curve};
use super::host::Host;
use super::host_loop::{Turning, calming, loop_like_the_hosts, quiet_loop, turning};
use super::situation::Situation;
use dashpot_core::element;
use dashpot_core::parameter::Element;
use dashpot_core::{Fault, Model, Params};

/// Gain ([`Chatter::gain`]) from which on a disturbance of the velocity changes sign at every step of the host.
pub const RINGS: f64 = 1.0;
/// Gain ([`Chatter::gain`]) from which on a disturbance of the velocity does not decay.
pub const GROWS: f64 = 2.0;

/// Smallest fraction of the gain that must disappear if an element is disabled, for this element to count as the cause of the chatter.
pub(super) const ITS_DOING: f64 = 0.3;

/// Result of the check of a damper in a host.
#[derive(Debug, Clone, PartialEq)]
pub struct Chatter {
    /// Largest gain (h/m)(∂F/∂v + h ∂F/∂x) over all situations and motions, with the host's step h, s, and mass m, kg. F is the damper
    /// force, N, v the velocity, m/s, and x the displacement, m.
    pub gain: f64,
    /// Velocity at the largest gain, m/s.
    pub velocity: f64,
    /// Derivative of the force with respect to velocity at the largest gain, N s/m.
    pub d_force_d_velocity: f64,
    /// Derivative of the force with respect to displacement at the largest gain, N/m.
    pub d_force_d_displacement: f64,
    /// Situation with the largest gain.
    pub situation: Situation,
    /// Longest step found without chatter, s, or `None` if none was found.
    pub quiet_step: Option<f64>,
    /// Element that causes the chatter, and the gain without this element. Without it, the gain is smaller by at least 30 %, or the host
    /// loop does not chatter. `None` if no single element is the cause.
    pub element: Option<(Element, f64)>,
    /// Result of the host loop if the loop chatters.
    pub turning: Option<Turning>,
    /// Damping of an undamped series path, N s/m, with which the loop would not chatter, or `None`.
    pub calming: Option<f64>,
}

/// Checks a damper in a host for chatter, about the middle of its stroke. Also checks it at other positions, in its stops, under side force
/// and in the cold, if these conditions affect the damper.
///
/// # Errors
/// Returns an error if the parameters do not form a valid model.
pub fn chatter(params: &Params, host: Host) -> Result<Chatter, Fault> {
    let model = Model::new(params)?;
    let usual = largest(&model, Situation::REFERENCE, host);
    let situations = Situation::all(params, &model);
    let others = situations.iter().skip(1).map(|situation| largest(&model, *situation, host));
    let Largest { gain, velocity, output, situation } = others
        .chain([on_the_curve(params, &model, host)])
        .fold(usual, |most, other| if other.gain > most.gain { other } else { most });
    let turning = situations
        .iter()
        .filter_map(|situation| turning(&model, *situation, host))
        .max_by(|a, b| a.force.total_cmp(&b.force));
    let without = |element: Element| {
        let mut less = *params;
        less.enable(element, false);
        let model = Model::new(&less).ok()?;
        Some((element, largest(&model, situation, host).gain))
    };
    let element = (gain >= RINGS)
        .then(|| {
            let on = Element::all().filter(|e| params.is_on(*e) && *e != element!("series_compliance"));
            on.filter_map(without).min_by(|a, b| a.1.total_cmp(&b.1))
        })
        .flatten()
        .filter(|(_, left)| *left < (1.0 - ITS_DOING) * gain)
        .or_else(|| {
            let turning = turning.filter(|_| gain < RINGS)?;
            // Disabling the series path also removes the internal mass. So a loop without the series path does not show which element
            // causes the chatter.
            let on = Element::all().filter(|e| params.is_on(*e) && *e != element!("series_compliance"));
            let is_quiet = |element: &Element| {
                let mut less = *params;
                less.enable(*element, false);
                Model::new(&less)
                    .is_ok_and(|model| loop_like_the_hosts(&model, turning.situation, turning.height, host).is_none())
            };
            on.filter(is_quiet).find_map(without)
        });
    // Solve g = (h c + h² k)/m = 1 for the step h. Here g is the gain, c = ∂F/∂v, k = ∂F/∂x, and m is the mass of the host.
    let (c, k) = (output.d_force_d_velocity.max(0.0), output.d_force_d_displacement.max(0.0));
    let quiet_step =
        if k > 0.0 { 2.0 * host.mass / (c + (c * c + 4.0 * k * host.mass).sqrt()) } else { host.mass / c.max(1e-9) };
    Ok(Chatter {
        gain,
        velocity,
        d_force_d_velocity: output.d_force_d_velocity,
        d_force_d_displacement: output.d_force_d_displacement,
        situation,
        quiet_step: match turning.filter(|_| gain < RINGS) {
            Some(turning) => quiet_loop(&model, turning.situation, host),
            None => Some(quiet_step),
        },
        element,
        calming: turning.and_then(|turning| calming(params, &turning, host)),
        turning,
    })
}
