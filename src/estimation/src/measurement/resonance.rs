//! A resonance in the force path: a frame, a cross-head, oil in a hose.

use super::second_order::SecondOrder;

/// Damping ratio of a resonance. It makes the peak wide enough to include the next trial frequency of the unnamed
/// errors.
const DAMPING: f64 = 0.15;

/// Adds a fraction of the response of a resonance at `frequency`, Hz, to the force.
///
/// The output y follows the force as a second-order system with natural frequency ω, rad/s. With `across`, the response
/// is the rate of y divided by ω. Otherwise, it is the second derivative of y divided by ω². The second derivative is
/// in phase opposition to the force below resonance.
pub(super) fn resonance(share: f64, frequency: f64, across: bool, dt: &[f64], forces: &mut [f64]) {
    let omega = std::f64::consts::TAU * frequency;
    SecondOrder { omega, damping: DAMPING }.follow(dt, forces, |force, y, rate| {
        let acceleration = *force - y - 2.0 * DAMPING * rate / omega;
        *force += share * if across { rate / omega } else { acceleration };
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_answers_at_its_frequency_and_little_far_below() {
        let gain = |driven: f64, across: bool| {
            let (n, h) = (20_000, 1e-4);
            let wave = |k: usize| libm::sin(std::f64::consts::TAU * driven * k as f64 * h);
            let mut forces: Vec<f64> = (0..n).map(wave).collect();
            resonance(0.1, 20.0, across, &vec![h; n], &mut forces);
            let added = (n / 2..n).map(|k| forces[k] - wave(k));
            added.fold(0.0, |most: f64, a| most.max(a.abs())) / 0.1
        };
        let peak = 1.0 / (2.0 * DAMPING);
        assert!((gain(20.0, true) - peak).abs() < 0.01 * peak && (gain(20.0, false) - peak).abs() < 0.01 * peak);
        assert!((gain(1.0, true) - 0.05).abs() < 0.001, "{}", gain(1.0, true));
        assert!((gain(1.0, false) - 0.0025).abs() < 0.001, "{}", gain(1.0, false));
    }
}
