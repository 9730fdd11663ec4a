//! Second-order filter with output y and input force F: y'' + 2 ζ ω y' + ω² y = ω² F.
//!
//! ζ is the damping ratio, and ω the natural frequency, rad/s. The solution is exact for a force that is linear between
//! samples.

/// Filter of the second order.
pub(super) struct SecondOrder {
    /// Natural frequency, rad/s.
    pub omega: f64,
    /// Damping ratio ζ, below 1.
    pub damping: f64,
}

/// Relative difference below which two time steps count as equal. The relative error of the force has the same order of
/// magnitude.
const ALIKE: f64 = 1e-9;

impl SecondOrder {
    /// Filters the forces with the time steps `dt`, s, and calls `then` for each sample after the first. The arguments
    /// of `then` are the force, the filter's output and the rate of the output.
    pub fn follow(&self, dt: &[f64], forces: &mut [f64], mut then: impl FnMut(&mut f64, f64, f64)) {
        let SecondOrder { omega, damping } = *self;
        let (falls, turns) = (damping * omega, omega * (1.0 - damping * damping).sqrt());
        let late = 2.0 * damping / omega;
        let mut last = forces.first().copied().unwrap_or(0.0);
        let (mut y, mut rate) = (last, 0.0);
        let (mut at, mut stays, mut sin, mut cos) = (f64::NAN, 1.0, 0.0, 1.0);
        for (force, h) in forces.iter_mut().zip(dt).skip(1) {
            // Most samples are equally spaced except for rounding. Reuse the coefficients, because the transcendental
            // functions dominate the cost.
            if !((h - at).abs() <= ALIKE * h) {
                at = *h;
                stays = libm::exp(-falls * h);
                (sin, cos) = libm::sincos(turns * h);
            }
            let slope = (*force - last) / h;
            // `off` and `off_rate` are the deviations of the output and of its rate from the steady response to the
            // current ramp of the force.
            let (off, off_rate) = (y - (last - late * slope), rate - slope);
            let after = stays * (off * cos + (off_rate + falls * off) / turns * sin);
            let after_rate = stays * (off_rate * cos - (falls * off_rate + omega * omega * off) / turns * sin);
            last = *force;
            (y, rate) = (last - late * slope + after, slope + after_rate);
            then(force, y, rate);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_comes_out_as_the_transfer_function_has_it() {
        for (frequency, damping, driven) in [(60.0, 0.15, 20.0), (60.0, 0.15, 60.0), (30.0, 0.8, 70.0)] {
            let filter = SecondOrder { omega: std::f64::consts::TAU * frequency, damping };
            let w = std::f64::consts::TAU * driven;
            let (n, h) = (8000, 5e-5);
            let mut forces: Vec<f64> = (0..n).map(|k| 1000.0 * libm::sin(w * k as f64 * h)).collect();
            let ratio = driven / frequency;
            let (real, imaginary) = (1.0 - ratio * ratio, 2.0 * damping * ratio);
            let (size, lag) = (1000.0 / libm::hypot(real, imaginary), libm::atan2(imaginary, real));
            let mut k = 0;
            filter.follow(&vec![h; n], &mut forces, |_, y, rate| {
                k += 1;
                let phase = w * k as f64 * h - lag;
                if k > n / 2 {
                    assert!((y - size * phase.sin()).abs() < 1e-3 * size, "{k}: {y}");
                    assert!((rate - size * w * phase.cos()).abs() < 1e-3 * size * w, "{k}: {rate}");
                }
            });
        }
    }
}
