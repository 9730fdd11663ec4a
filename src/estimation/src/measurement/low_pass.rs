//! Low-pass filter of a force channel's amplifier.

use super::second_order::SecondOrder;

/// Damping ratio ζ of a second-order Bessel filter, which delays all frequencies nearly equally.
const DAMPING: f64 = 0.866_025_403_784_438_6;

/// Filters forces with the time steps `dt`, s. At low frequency, the filter delays the forces by `tau` = 2 ζ/ω, s,
/// where ω is its natural frequency, rad/s.
pub fn low_pass(tau: f64, dt: &[f64], forces: &mut [f64]) {
    if tau <= 0.0 {
        return;
    }
    let filter = SecondOrder { omega: 2.0 * DAMPING / tau, damping: DAMPING };
    filter.follow(dt, forces, |force, y, _| *force = y);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slow_force_comes_late_by_tau() {
        let (tau, h) = (1.2e-3, 5e-5);
        let wave = |t: f64| 1000.0 * libm::sin(30.0 * t);
        let mut forces: Vec<f64> = (0..8000).map(|k| wave(k as f64 * h)).collect();
        low_pass(tau, &vec![h; 8000], &mut forces);
        for (k, force) in forces.iter().enumerate().skip(4000) {
            let late = wave(k as f64 * h - tau);
            assert!((force - late).abs() < 1.0, "{k}: {force}, {late}");
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
