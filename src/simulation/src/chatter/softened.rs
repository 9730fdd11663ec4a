//! Replacement of steep friction by presliding friction, so that the damper does not chatter in a host.

use super::gain::{STEPS, largest, motions};
use super::host::Host;
use super::in_host::{ITS_DOING, RINGS, chatter};
use super::situation::{SIDE_FORCE, Situation};
use dashpot_core::parameter::{Element, Number};
use dashpot_core::step::step;
use dashpot_core::{Fault, Model, Params};
use dashpot_core::{element, number};

/// Elements that [`softened`] can replace, with the parameter of their friction force.
pub(super) const FRICTION: [(Element, Number); 2] = [
    (element!("coulomb_friction"), number!("coulomb_force")),
    (element!("stribeck_friction"), number!("stribeck_coulomb_force")),
];

/// Damper whose steep friction was replaced, with the errors of the replacement.
#[derive(Debug, Clone)]
pub struct Softened {
    /// Parameters of the damper after the replacement.
    pub params: Params,
    /// Change of each friction element that chattered.
    pub softer: Vec<Softer>,
    /// Root mean square difference of the force before and after the replacement over typical motions, N.
    pub rms_error: f64,
    /// Largest difference of the force before and after the replacement over typical motions, N.
    pub largest_error: f64,
    /// Largest gain ([`Chatter::gain`](super::Chatter::gain)) of the damper after the replacement. Elements that were not replaced may
    /// still chatter.
    pub gain: f64,
}

/// Change of one friction element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Softer {
    /// Presliding friction replaces the element.
    Replaced {
        /// The replaced element.
        element: Element,
        /// Force of the presliding friction, N. It covers all elements that the presliding friction replaces.
        force: f64,
        /// Length over which the presliding friction reverses, m.
        length: f64,
    },
    /// The steepness of the side-force friction at zero velocity is reduced, s/m. Presliding friction cannot replace this friction, because
    /// its force depends on the side force from the host.
    LessSteep {
        /// Steepness before the reduction, s/m.
        before: f64,
        /// Steepness after the reduction, s/m.
        after: f64,
    },
}

impl Softer {
    /// Returns the friction elements in which a damper and its softened version differ.
    fn all(before: &Params, soft: &Params) -> Vec<Softer> {
        let (force, length) = (soft.number(number!("presliding_force")), soft.number(number!("presliding_length")));
        let replaced = FRICTION.iter().filter(|(element, _)| before.is_on(*element) && !soft.is_on(*element));
        let mut all: Vec<Softer> =
            replaced.map(|(element, _)| Softer::Replaced { element: *element, force, length }).collect();
        let [before, after] = [before, soft].map(|params| params.number(number!("side_force_steepness")));
        if after < before {
            all.push(Softer::LessSteep { before, after });
        }
        all
    }

    /// Returns the changed element.
    pub fn element(&self) -> Element {
        match self {
            Softer::Replaced { element, .. } => *element,
            Softer::LessSteep { .. } => element!("side_force_friction"),
        }
    }
}

/// Typical length over which presliding friction of seals reverses, m (Deubel & Prokop, J. Automob. Eng. 2023: tenths of a millimeter).
///
/// It is the longest tried length. Shorter lengths are closer to friction that reverses instantaneously. So the length is halved while the
/// gain stays below [`QUIET`] or does not rise.
const LENGTH: f64 = 2e-4;
/// Largest gain at which presliding friction counts as safely free of chatter. Below this gain, a shorter length is tried even if the gain
/// rises.
const QUIET: f64 = 0.3;
/// Longest step, s, for the comparison of the dampers before and after the replacement in fast motions. Slow motions have longer steps, so
/// that no motion has more than 24 000 steps.
const FINE: f64 = 1e-4;
/// Largest number of friction elements that are replaced or made less steep: those whose force changes its sign steeply.
const MOST: usize = FRICTION.len() + 1;

/// Replaces steep friction that chatters by presliding friction, and reduces the steepness of side-force friction that chatters.
///
/// Returns `None` if no steep friction chatters. Presliding friction chatters less, because it acts like a stiff spring at a reversal,
/// while the replaced friction jumps.
///
/// # Errors
/// Returns an error if the parameters do not form a valid model.
pub fn softened(params: &Params, host: Host) -> Result<Option<Softened>, Fault> {
    let mut soft = *params;
    for _ in 0..MOST {
        let Some((element, situation)) = friction_that_rings(&soft, host)? else { break };
        match FRICTION.iter().find(|(friction, _)| *friction == element) {
            Some(friction) => presliding_instead(&mut soft, *friction, situation, host)?,
            None if less_steep(&mut soft, situation, host)? => {}
            None => break,
        }
    }
    let softer = Softer::all(params, &soft);
    if softer.is_empty() {
        return Ok(None);
    }
    let found = chatter(&soft, host)?;
    let (before, after) = (Model::new(params)?, Model::new(&soft)?);
    let (mut squares, mut count, mut largest_error) = (0.0, 0.0, 0.0f64);
    let under_side_force = Situation { side_force: SIDE_FORCE, ..Situation::REFERENCE };
    let has_less_steep = softer.iter().any(|one| matches!(one, Softer::LessSteep { .. }));
    let compared = if has_less_steep { under_side_force } else { Situation::REFERENCE };
    for sine in motions(compared, host) {
        let omega = sine.omega;
        let dt = FINE.min(0.01 / omega).max(0.25 * std::f64::consts::TAU / (omega * STEPS as f64));
        let input = |k: usize| sine.input_at(dt * k as f64);
        let (mut a, mut b) = (before.steady_state(&input(0)), after.steady_state(&input(0)));
        for k in 1..=(1.5 * std::f64::consts::TAU / (omega * dt)) as usize {
            let ((next_a, from), (next_b, to)) = (step(&before, &a, &input(k), dt), step(&after, &b, &input(k), dt));
            (a, b) = (next_a, next_b);
            // Skip the first half cycle, which builds up the friction after a start at rest.
            if omega * dt * k as f64 > 0.5 * std::f64::consts::TAU {
                squares += (to.force - from.force).powi(2);
                count += 1.0;
                largest_error = largest_error.max((to.force - from.force).abs());
            }
        }
    }
    let rms_error = (squares / f64::max(count, 1.0)).sqrt();
    Ok(Some(Softened { params: soft, softer, rms_error, largest_error, gain: found.gain }))
}

/// Finds a steep friction that causes chatter, and the situation in which it chatters. Every situation is tried, because other elements (a
/// stop, the FV curve) may cause the chatter in some situations.
fn friction_that_rings(params: &Params, host: Host) -> Result<Option<(Element, Situation)>, Fault> {
    let model = Model::new(params)?;
    for situation in Situation::all(params, &model) {
        let gain = largest(&model, situation, host).gain;
        let frictions = FRICTION.iter().map(|(friction, _)| *friction).chain([element!("side_force_friction")]);
        let on = frictions.filter(|friction| gain >= RINGS && params.is_on(*friction));
        let mut most = None::<(Element, f64)>;
        for friction in on {
            let mut less = *params;
            less.enable(friction, false);
            let left = largest(&Model::new(&less)?, situation, host).gain;
            if left < (1.0 - ITS_DOING) * gain && most.is_none_or(|(_, least)| left < least) {
                most = Some((friction, left));
            }
        }
        if let Some((friction, _)) = most {
            return Ok(Some((friction, situation)));
        }
    }
    Ok(None)
}

/// Replaces a friction element by presliding friction. The force of the element is added to that of existing presliding friction.
fn presliding_instead(
    soft: &mut Params,
    (element, level): (Element, Number),
    situation: Situation,
    host: Host,
) -> Result<(), Fault> {
    let gain = |params: &Params| Ok(largest(&Model::new(params)?, situation, host).gain);
    let presliding = element!("presliding_friction");
    let has = soft.is_on(presliding);
    let before = if has { soft.number(number!("presliding_force")) } else { 0.0 };
    let force = before + soft.number(level);
    soft.enable(element, false);
    soft.enable(presliding, true);
    soft.set(number!("presliding_force"), force)?;
    // Existing presliding friction keeps its length if it does not chatter with that length.
    if has && gain(soft)? <= QUIET {
        return Ok(());
    }
    let turns = number!("presliding_length");
    soft.set(turns, LENGTH)?;
    let mut now = gain(soft)?;
    while 0.5 * soft.number(turns) >= turns.bounds().0 {
        let mut shorter = *soft;
        shorter.set(turns, 0.5 * soft.number(turns))?;
        let there = gain(&shorter)?;
        if there > QUIET.max(now) {
            break;
        }
        (*soft, now) = (shorter, there);
    }
    Ok(())
}

/// Halves the steepness of side-force friction until it causes no chatter in a situation. Returns `false` if the steepness reaches its
/// lower bound before.
fn less_steep(soft: &mut Params, situation: Situation, host: Host) -> Result<bool, Fault> {
    let steepness = number!("side_force_steepness");
    let mut without = *soft;
    without.enable(element!("side_force_friction"), false);
    let rest = largest(&Model::new(&without)?, situation, host).gain;
    while largest(&Model::new(soft)?, situation, host).gain >= RINGS.max(rest / (1.0 - ITS_DOING)) {
        let half = 0.5 * soft.number(steepness);
        if half < steepness.bounds().0 {
            return Ok(false);
        }
        soft.set(steepness, half)?;
    }
    Ok(true)
}
