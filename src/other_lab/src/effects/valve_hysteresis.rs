//! Injected effect of valve hysteresis: valves that open and close at different forces.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect = Effect {
    name: "valve_hysteresis",
    laws: &[("popping_poppet", popping_poppet as Make), ("stiction_film", stiction_film)],
};

/// A poppet with a pressure area that grows after lift, so that it opens suddenly and closes at a lower pressure.
///
/// The poppet is in parallel with the valves of one direction (Hős et al., J. Loss Prev. Process Ind. 31, 2014, on
/// direct spring operated relief valves).
struct PoppingPoppet {
    opens: f64,
    grows: f64,
    stiffness: f64,
    flow: f64,
    time: f64,
    rebound: bool,
}

impl PoppingPoppet {
    fn load(&self, here: &Here) -> f64 {
        if self.rebound { here.hydraulic.max(0.0) } else { (-here.hydraulic).max(0.0) }
    }
}

impl EffectModel for PoppingPoppet {
    fn tolerances(&self) -> &[f64] {
        &[5e-4]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        let lift = s[0];
        let r0 = self.load(here) / self.opens;
        // The pressure area of the poppet grows with its lift, and saturates at a relative lift of about 0.3.
        let area = 1.0 + self.grows * (1.0 - libm::exp(-(lift / 0.15).max(0.0)));
        let push = (r0 * area - 1.0) / self.stiffness;
        let end = 1.0 / libm::cbrt(1.0 + push.max(0.0).powi(3));
        r[0] = (push.max(0.0) * end - lift) / self.time;
    }
    fn taken(&self, here: &Here, s: &[f64]) -> f64 {
        let sign = if self.rebound { 1.0 } else { -1.0 };
        sign * self.flow * s[0].max(0.0) * (self.load(here) / self.opens).sqrt()
    }
}

fn popping_poppet(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let rebound = d.choice(2) == 0;
    Box::new(PoppingPoppet {
        opens: d.between(0.5, 0.9) * if rebound { scale.rebound_n } else { scale.compression_n },
        grows: d.between(0.25, 0.5),
        stiffness: d.between(0.3, 0.6),
        flow: strength * d.between(0.12, 0.3),
        time: d.scale(1.5e-3, 4e-3),
        rebound,
    })
}

/// An oil film between valve shim and seat. Oil must fill the film before the shim lifts, and the closing shim squeezes
/// it out slowly.
///
/// The flow through the valves is reduced until the shim is free (Resch & Scheidl, Proc. IMechE I 228, 2014, fluid
/// stiction of separating plates).
struct StictionFilm {
    holds: f64,
    force: f64,
    frees: f64,
    settles: f64,
}

impl EffectModel for StictionFilm {
    fn tolerances(&self) -> &[f64] {
        &[1e-3]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        // The state is 0 if the shim is on its seat, and 1 if the shim is free.
        let load = (here.hydraulic.abs() / self.force).powi(3);
        let lifts = load / (1.0 + load);
        r[0] = lifts * (1.0 - s[0]) / self.frees - (1.0 - lifts) * s[0] / self.settles;
    }
    fn gain(&self, here: &Here, s: &[f64]) -> f64 {
        let load = (here.hydraulic.abs() / self.force).powi(3);
        1.0 / (1.0 + self.holds * (1.0 - s[0]) * load / (1.0 + load))
    }
}

fn stiction_film(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(StictionFilm {
        holds: strength * d.between(0.5, 1.2),
        force: d.between(0.3, 0.6) * scale.compression_n,
        frees: d.scale(3e-3, 1e-2),
        settles: d.scale(1e-2, 4e-2),
    })
}
