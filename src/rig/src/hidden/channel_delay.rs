//! Injected measurement error: the force channel lags the displacement and velocity channels.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["pure", "second_order_filter"];

struct ChannelDelay {
    form: usize,
    delay_s: f64,
    damping: f64,
}

impl ChannelDelay {
    /// Returns the natural frequency omega, rad/s, of the second-order filter of the force. At low frequency, the
    /// filter lags by `2 zeta / omega`, with its damping ratio zeta; this lag is `delay_s`.
    fn omega(&self) -> f64 {
        2.0 * self.damping / self.delay_s
    }
}

impl DamperEffect for ChannelDelay {
    fn tolerances(&self) -> &[f64] {
        // The states are the filtered force, N, and its rate, N/s.
        if self.form == 1 { &[1e-2, 1e1] } else { &[] }
    }

    fn begin(&self, rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
        if let Some(force_n) = states.first_mut() {
            *force_n = rest.rod_n;
        }
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        if self.form == 1 {
            let omega = self.omega();
            rates[0] = states[1];
            rates[1] = omega * (omega * (here.rod_n - states[0]) - 2.0 * self.damping * states[1]);
        }
    }

    fn delay_s(&self) -> f64 {
        if self.form == 0 { self.delay_s } else { 0.0 }
    }

    fn cell_n(&self, force_n: f64, here: &Here, states: &[f64]) -> f64 {
        // Only the true force on the rod, `rod_n`, is filtered. Contributions of other measurement errors stay in
        // `force_n`.
        if self.form == 1 { force_n - here.rod_n + states[0] } else { force_n }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    Box::new(ChannelDelay {
        form,
        delay_s: recipe.strength * recipe.draw.ratio("delay_s", 0.6e-3, 1.5e-3),
        damping: recipe.draw.between("filter_damping", 0.6, 0.9),
    })
}
