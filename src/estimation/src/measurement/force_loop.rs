//! Hysteresis of a load cell: a rate-independent loop over the force.

/// Adds `share` of the absolute force while the force rises and subtracts it while the force falls. After a reversal of
/// the force, the sign changes exponentially over a force of `width`, N.
pub(super) fn loop_over_force(share: f64, width: f64, forces: &mut [f64]) {
    let (mut way, mut last) = (0.0, forces.first().copied().unwrap_or(0.0));
    for force in forces {
        let rise = *force - last;
        last = *force;
        let stays = libm::exp(-rise.abs() / width);
        way = way * stays + rise.signum() * (1.0 - stays);
        *force += share * force.abs() * way;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_over_force_does_not_know_the_speed_and_takes_energy_from_its_load() {
        let run = |per_cycle: usize| {
            let pure: Vec<f64> = (0..=2 * per_cycle)
                .map(|i| 1000.0 * libm::sin(std::f64::consts::TAU * i as f64 / per_cycle as f64))
                .collect();
            let mut read = pure.clone();
            loop_over_force(0.03, 100.0, &mut read);
            pure.iter().zip(&read).map(|(p, r)| (*p, r - p)).collect::<Vec<_>>()
        };
        let (slow, fast) = (run(4000), run(400));
        for (k, (_, added)) in fast.iter().enumerate().skip(400) {
            assert!((added - slow[10 * k].1).abs() < 0.5, "{k}");
        }
        // The measured force is larger while the force rises, so the loop encloses a positive area.
        let area: f64 = slow[4000..].windows(2).map(|w| 0.5 * (w[0].1 + w[1].1) * (w[1].0 - w[0].0)).sum();
        assert!(area > 0.5 * 0.03 * 2.0 * 1000.0 * 1000.0, "{area}");
    }
}
