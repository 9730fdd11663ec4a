//! Injected effect of cavitation: voids that open in one stroke and must close before the force of the other stroke
//! builds up.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "cavitation", laws: &[("gas_release", gas_release as Make), ("starved_intake", starved_intake)] };

/// Gas release: below a threshold pressure, gas leaves the oil at a finite rate and returns more slowly.
///
/// The volume of the void is proportional to the released gas (Zhou, Vacca & Manhartsgruber, J. Fluids Eng. 135, 2013,
/// after Singhal's full cavitation model, 2002).
struct GasRelease {
    /// Hydraulic compression force at which gas release begins, N. `width` is the range of forces over which the
    /// release begins, N.
    onset: f64,
    width: f64,
    /// Rate of the void's growth at twice the force `onset`, as a piston velocity, m/s.
    rate: f64,
    back: f64,
}

/// Length of a void below which its closing slows down, m.
const CLOSED: f64 = 2e-5;

impl GasRelease {
    fn opens(&self, here: &Here, s: &[f64]) -> f64 {
        let beyond = (-here.hydraulic - self.onset) / self.width;
        let void = s[0].max(0.0);
        let releases = self.rate * softplus(beyond) * self.width / self.onset;
        // At a pressure above the threshold of release, the gas is compressed, and it dissolves with the time constant
        // `back`.
        let closes =
            (softplus(-beyond) * self.width / self.onset * self.rate + void / self.back) * void / (void + CLOSED);
        releases - closes
    }
}

fn softplus(x: f64) -> f64 {
    if x > 30.0 { x } else { libm::log1p(libm::exp(x)) }
}

impl EffectModel for GasRelease {
    fn tolerances(&self) -> &[f64] {
        &[5e-7]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = self.opens(here, s);
    }
    fn taken(&self, here: &Here, s: &[f64]) -> f64 {
        -self.opens(here, s)
    }
}

fn gas_release(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let onset = scale.compression_n * d.between(0.55, 0.8);
    Box::new(GasRelease { onset, width: 0.04 * onset, rate: strength * d.between(0.3, 0.8), back: d.scale(0.05, 0.3) })
}

/// A starved intake: the pressure of the reserve chamber limits the flow through the intake valve.
///
/// In a fast rebound stroke, the compression chamber stays partly unfilled. The intake continues to fill the chamber,
/// but the compression stroke begins with a void (Dixon 2007, ch. 6; Duym, Stiens & Reybrouck, Veh. Syst. Dyn. 27,
/// 1997).
struct StarvedIntake {
    /// Largest piston velocity at which the intake fills the compression chamber completely, m/s. `edge` is the width
    /// of the transition, m/s.
    follows: f64,
    edge: f64,
    share: f64,
}

impl StarvedIntake {
    fn opens(&self, here: &Here, s: &[f64]) -> f64 {
        let void = s[0].max(0.0);
        let lags = self.share * softplus((here.v - self.follows) / self.edge) * self.edge;
        let is_open = void / (void + CLOSED);
        let still_fills = 0.1 * self.share * self.follows;
        // In compression (v < 0) the piston closes the void at its own velocity.
        lags - is_open * (still_fills + (-here.v).max(0.0))
    }
}

impl EffectModel for StarvedIntake {
    fn tolerances(&self) -> &[f64] {
        &[5e-7]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        r[0] = self.opens(here, s);
    }
    fn taken(&self, here: &Here, s: &[f64]) -> f64 {
        let void = s[0].max(0.0);
        -(void / (void + CLOSED)) * (-here.v).max(0.0)
    }
}

fn starved_intake(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let follows = d.scale(0.15, 0.45);
    Box::new(StarvedIntake { follows, edge: 0.15 * follows, share: strength * d.between(0.03, 0.1) })
}
