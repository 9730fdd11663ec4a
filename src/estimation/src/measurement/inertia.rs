//! A mass between load cell and damper: eye, clamp and joint that move with the damper's end.
//!
//! The load cell measures the inertia force of this mass too.

use dashpot_core::Input;

/// Adds the inertia force M a of a mass M, kg, to the forces, N. The acceleration a is the derivative of the parabola
/// through three velocities.
///
/// At fifty samples per cycle, the acceleration is 0.3 % too small. The fitted motion contains no noise that
/// differentiation could amplify.
pub(super) fn inertia(mass: f64, dt: &[f64], input: &[Input], forces: &mut [f64]) {
    let n = input.len();
    let slope = |k: usize| (input[k].velocity - input[k - 1].velocity) / dt[k].max(f64::MIN_POSITIVE);
    for (k, force) in forces.iter_mut().enumerate() {
        let acceleration = match (k, k + 1) {
            _ if n < 2 => 0.0,
            (0, _) => slope(1),
            (_, next) if next == n => slope(k),
            // The difference to the closer neighbor has the larger weight.
            (_, next) => (slope(k) * dt[next] + slope(next) * dt[k]) / (dt[k] + dt[next]).max(f64::MIN_POSITIVE),
        };
        *force += mass * acceleration;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mass_takes_its_acceleration_at_even_and_uneven_steps() {
        for uneven in [0.0, 0.4] {
            let (n, omega) = (200, 30.0);
            let dt: Vec<f64> =
                (0..n).map(|k| if k == 0 { 0.0 } else { 2e-3 * (1.0 + uneven * f64::from(k as u32 % 3)) }).collect();
            let mut t = 0.0;
            let times: Vec<f64> = dt
                .iter()
                .map(|h| {
                    t += h;
                    t
                })
                .collect();
            let input: Vec<Input> = times
                .iter()
                .map(|t| Input::motion(0.01 * libm::sin(omega * t), 0.01 * omega * libm::cos(omega * t)))
                .collect();
            let mut forces = vec![100.0; n];
            inertia(2.0, &dt, &input, &mut forces);
            let top = 2.0 * 0.01 * omega * omega;
            for (force, t) in forces.iter().zip(&times).take(n - 1).skip(1) {
                let wanted = 100.0 - top * libm::sin(omega * t);
                assert!((force - wanted).abs() < 2e-3 * top, "{force} {wanted}");
            }
        }
        let mut none: [f64; 1] = [3.0];
        inertia(1.0, &[0.0], &[Input::motion(0.0, 1.0)], &mut none);
        assert_eq!(none, [3.0]);
    }
}
