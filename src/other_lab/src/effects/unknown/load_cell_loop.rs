//! Injected unknown effect: a load cell with hysteresis.

use super::{Draw, Effect, EffectModel, Make, Scale};

pub(super) const EFFECT: Effect = Effect { name: "load_cell_loop", laws: &[("stops", stops as Make)] };

const STOPS: usize = 4;

/// Hysteresis as a sum of stop operators (elastic, perfectly plastic elements) of several widths (Prandtl & Ishlinskii;
/// Krejčí 1996).
struct Stops {
    share: f64,
    widths: [f64; STOPS],
}

impl EffectModel for Stops {
    fn channel(&self, _: u64, _: &[f64], force: &mut Vec<f64>) {
        let mut stops = [0.0; STOPS];
        let mut last = force[0];
        for f in force {
            let moved = *f - last;
            last = *f;
            for (stop, width) in stops.iter_mut().zip(self.widths) {
                *stop = (*stop + moved).min(width).max(-width);
            }
            *f += self.share * stops.iter().sum::<f64>();
        }
    }
}

fn stops(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let widest = d.between(0.3, 0.7) * scale.rebound_n;
    Box::new(Stops {
        share: strength * d.between(0.03, 0.06),
        widths: std::array::from_fn(|i| widest * 0.5f64.powi(i as i32)),
    })
}
