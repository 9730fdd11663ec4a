//! A tilted cross-head or eye: a fraction of the axial force acts on the guides, and the friction of the guides adds to
//! the force.

use dashpot_core::Input;

/// Speed within which the friction of the guides reverses, m/s.
const TURNS: f64 = 2e-3;

/// Force that acts on the guides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Load {
    /// The whole force, including the gas force.
    Whole,
    /// The force minus the force at rest. It applies if the tilt occurred under the static force, or if the load cell
    /// was zeroed under this force.
    BeyondRest,
}

/// Adds the friction of the guides to the forces, N, as the fraction `share` of the load. With `along`, the fraction is
/// proportional to the displacement, and `share` has the unit 1/m.
pub(super) fn guide(share: f64, along: bool, load: Load, inputs: &[Input], forces: &mut [f64]) {
    let rest = match load {
        Load::Whole => 0.0,
        Load::BeyondRest => at_rest(inputs, forces),
    };
    for (force, input) in forces.iter_mut().zip(inputs) {
        let grows = if along { input.displacement.unwrap_or(0.0) } else { 1.0 };
        *force += share * grows * (*force - rest).abs() * libm::tanh(input.velocity / TURNS);
    }
}

/// Computes the mean of the forces on both sides of each reversal of the motion, N, or 0 without a reversal.
fn at_rest(inputs: &[Input], forces: &[f64]) -> f64 {
    let turns = inputs.windows(2).zip(forces.windows(2)).filter(|(i, _)| i[0].velocity * i[1].velocity <= 0.0);
    let (sum, count) = turns.fold((0.0, 0.0), |(sum, count), (_, f)| (sum + 0.5 * (f[0] + f[1]), count + 1.0));
    sum / f64::max(count, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_opposes_the_motion_as_a_share_of_the_load() {
        let inputs: Vec<Input> = (0..=400)
            .map(|k| {
                let phase = std::f64::consts::TAU * (f64::from(k) + 0.5) / 200.0;
                Input::motion(0.01 * libm::sin(phase), 0.5 * libm::cos(phase))
            })
            .collect();
        let gas = -150.0;
        let pure: Vec<f64> = inputs.iter().map(|i| gas + 2000.0 * i.velocity).collect();
        for (load, rest) in [(Load::Whole, 0.0), (Load::BeyondRest, gas)] {
            let mut read = pure.clone();
            guide(0.05, false, load, &inputs, &mut read);
            for ((input, pure), read) in
                inputs.iter().zip(&pure).zip(&read).filter(|((i, _), _)| i.velocity.abs() > 0.02)
            {
                let wanted = 0.05 * (pure - rest).abs() * input.velocity.signum();
                assert!((read - pure - wanted).abs() < 0.05 * 20.0, "{}: {}, {wanted}", input.velocity, read - pure);
            }
        }
    }
}
