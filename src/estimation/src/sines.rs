//! Synthetic tests with the forces of known hypotheses, for the unit tests of this crate.

use crate::hypothesis::Hypothesis;
use crate::samples::Test;
use crate::segment::Segment;
use dashpot_core::Input;

/// Makes sine tests with the given amplitudes, m, and frequencies, Hz. The forces are those of a hypothesis. Each test
/// has two cycles of 80 samples, and the second is scored.
pub fn measured(of: &Hypothesis, sines: &[(f64, f64)]) -> Vec<Test> {
    let test = |&(amplitude, frequency): &(f64, f64)| {
        let (count, omega) = (160, std::f64::consts::TAU * frequency);
        let dt = 1.0 / (80.0 * frequency);
        let motion = |k: usize| {
            let phase = omega * dt * k as f64;
            Input::motion(amplitude * libm::sin(phase), amplitude * omega * libm::cos(phase))
        };
        Test {
            record: 0,
            segment: Segment {
                name: String::new(),
                dt: vec![dt; count],
                input: (0..count).map(motion).collect(),
                setting: None,
                force: vec![0.0; count],
                from: 80,
                scale: 5.0,
                top: 3000.0,
                peak_velocity: amplitude * omega,
                amplitude,
                clock: 0.0,
            },
            allowed: vec![5.0; 80],
            mean_noise: 5.0,
            independence: 1.0,
            growth: 0.0,
            noise_freedom: 1000.0,
            frequency,
            weight: 1.0,
        }
    };
    let mut tests: Vec<Test> = sines.iter().map(test).collect();
    let forces = of.forces(&tests, &of.start()).unwrap();
    for (test, scored) in tests.iter_mut().zip(forces) {
        let from = test.segment.from;
        test.segment.force[from..].copy_from_slice(&scored);
    }
    tests
}
