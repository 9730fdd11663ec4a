//! A force channel behind the low-pass filter of its amplifier.

/// ζ of Bessel's filter of the second order, which delays all frequencies alike.
const DAMPING: f64 = 0.866_025_403_784_438_6;

/// y'' + 2 ζ ω y' + ω² y = ω² F: late by τ = 2 ζ/ω at low frequency. Exact for a force that runs straight between samples.
pub(super) fn low_pass(tau: f64, dt: &[f64], forces: &mut [f64]) {
    if tau <= 0.0 {
        return;
    }
    let omega = 2.0 * DAMPING / tau;
    let (falls, turns) = (DAMPING * omega, omega * (1.0 - DAMPING * DAMPING).sqrt());
    let mut last = forces.first().copied().unwrap_or(0.0);
    // What is behind the ramp that the force is on, and its rate.
    let (mut y, mut rate) = (last, 0.0);
    for (force, h) in forces.iter_mut().zip(dt).skip(1) {
        let slope = (*force - last) / h;
        let (off, off_rate) = (y - (last - tau * slope), rate - slope);
        let stays = (-falls * h).exp();
        let (sin, cos) = (turns * h).sin_cos();
        let after = stays * (off * cos + (off_rate + falls * off) / turns * sin);
        let after_rate = stays * (off_rate * cos - (falls * off_rate + omega * omega * off) / turns * sin);
        last = *force;
        (y, rate) = (last - tau * slope + after, slope + after_rate);
        *force = y;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_comes_out_as_the_transfer_function_has_it() {
        let (tau, w) = (1.2e-3, 2.0 * std::f64::consts::PI * 60.0);
        let dt = vec![5e-5; 8000];
        let wave = |k: usize| 1000.0 * (w * k as f64 * 5e-5).sin();
        let mut forces: Vec<f64> = (0..8000).map(wave).collect();
        low_pass(tau, &dt, &mut forces);
        let ratio = w * tau / (2.0 * DAMPING);
        let (real, imaginary) = (1.0 - ratio * ratio, 2.0 * DAMPING * ratio);
        let size = 1000.0 / real.hypot(imaginary);
        for (k, force) in forces.iter().enumerate().skip(4000) {
            let exact = size * (w * k as f64 * 5e-5 - imaginary.atan2(real)).sin();
            assert!((force - exact).abs() < 0.2, "{k}: {force}, {exact}");
        }
    }

    #[test]
    fn none_is_none() {
        let dt = vec![1e-3; 100];
        let before: Vec<f64> = (0..100).map(|k| f64::from(k % 17)).collect();
        for (tau, allowed) in [(0.0, 0.0), (1e-6, 0.02)] {
            let mut forces = before.clone();
            low_pass(tau, &dt, &mut forces);
            for (after, before) in forces.iter().zip(&before) {
                assert!((after - before).abs() <= allowed, "{after}, {before}");
            }
        }
    }
}
