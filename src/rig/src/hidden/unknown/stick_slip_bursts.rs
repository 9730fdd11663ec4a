//! Injected unknown effect: the rod sticks and releases with short bursts of vibration, at times unrelated to the
//! motion.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["bursts"];
/// Length, s, of a time slot with at most one burst. The time since the start of the campaign determines the bursts, so
/// their rate does not depend on the test.
const SLOT_S: f64 = 0.25;

struct Bursts {
    size_n: f64,
    omega: f64,
    decay_s: f64,
    seed: u64,
}

impl Bursts {
    /// Returns start (s since the start of the campaign) and relative size of the burst in a time slot. Returns `None`
    /// for the 65 % of the slots without a burst.
    fn burst(&self, slot: i64) -> Option<(f64, f64)> {
        // The hash SplitMix64 of the slot number gives random numbers.
        let mut z = self.seed.wrapping_add((slot as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        let part = |shift: u32| ((z >> shift) & 0xffff) as f64 / 65536.0;
        (part(0) < 0.35).then(|| (slot as f64 * SLOT_S + 0.5 * SLOT_S * part(16), 0.4 + 0.6 * part(32)))
    }
}

impl DamperEffect for Bursts {
    fn cell_n(&self, force_n: f64, here: &Here, _states: &[f64]) -> f64 {
        let clock = here.line.clock_s;
        let slot = (clock / SLOT_S).floor() as i64;
        let v = here.line.velocity_m_s;
        let moving = v / libm::hypot(v, 2e-3);
        let rattle: f64 = [slot - 1, slot]
            .into_iter()
            .filter_map(|slot| self.burst(slot))
            .filter(|(start, _)| *start <= clock)
            .map(|(start, size)| {
                let since = clock - start;
                size * libm::exp(-since / self.decay_s) * libm::cos(self.omega * since)
            })
            .sum();
        force_n + self.size_n * moving * rattle
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(Bursts {
        size_n: strength * draw.between("size_n", 60.0, 150.0),
        omega: std::f64::consts::TAU * draw.between("frequency_hz", 60.0, 140.0),
        decay_s: draw.between("decay_s", 0.02, 0.05),
        seed: (draw.unit() * 2f64.powi(53)) as u64,
    })
}
