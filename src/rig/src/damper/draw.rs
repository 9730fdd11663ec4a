//! Random variation of the default damper, similar to the variation between products.

use std::f64::consts::TAU;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use super::{ATMOSPHERE_PA, Damper};

/// Highest velocity of the tests of `Matrix::thesis`, m/s: a sine of 50 mm amplitude at 5 Hz.
///
/// The forces of a drawn damper must be plausible at this velocity.
const TOP_VELOCITY_M_S: f64 = TAU * 0.05 * 5.0;
/// Smallest plausible absolute pressure in the rebound chamber during compression, Pa. At lower pressures, the damper
/// could cavitate.
const LEAST_PRESSURE_PA: f64 = 4.0e5;

/// Draws random parameters of a damper from a seed until they are plausible. Seed 0 gives the default damper.
pub(super) fn damper(seed: u64) -> Damper {
    if seed == 0 {
        return Damper::default();
    }
    let mut stream = ChaCha8Rng::seed_from_u64(seed);
    loop {
        let candidate = candidate(&mut stream);
        if is_plausible(&candidate) {
            return candidate;
        }
    }
}

fn candidate(stream: &mut ChaCha8Rng) -> Damper {
    // `vary` returns a factor, log-normal about 1 and clamped at two and a half standard deviations.
    let mut vary = |spread: f64| {
        let unit: f64 = StandardNormal.sample(stream);
        libm::exp(spread * unit.clamp(-2.5, 2.5))
    };
    let mut damper = Damper::default();
    // The order of the draws defines the damper of a seed: append new draws instead of inserting them.
    let tube = &mut damper.tube;
    tube.bore_m *= vary(0.04);
    tube.rod_m *= vary(0.08);
    tube.rebound_length_m *= vary(0.06);
    tube.compression_length_m *= vary(0.06);
    tube.wall_modulus_pa *= vary(0.15);
    damper.oil.bulk_modulus_pa *= vary(0.08);
    damper.oil.air_fraction *= vary(0.25);
    damper.gas.pressure_pa *= vary(0.15);
    damper.gas.volume_m3 *= vary(0.12);
    damper.gas.exponent *= vary(0.04);
    damper.valves.bleed.area_m2 *= vary(0.20);
    damper.valves.bleed.laminar_pa_s_m3 *= vary(0.25);
    for valve in [&mut damper.valves.rebound, &mut damper.valves.compression] {
        valve.preload_pa *= vary(0.20);
        valve.opening_m2_pa *= vary(0.20);
        valve.port_m2 *= vary(0.15);
        valve.knee_pa *= vary(0.30);
    }
    let seal = &mut damper.seal;
    let friction = vary(0.12);
    seal.sliding_n *= friction;
    seal.break_away_n *= friction * vary(0.03);
    seal.stribeck_m_s *= vary(0.25);
    seal.bristle_n_m *= vary(0.25);
    seal.side_force_ratio *= vary(0.25);
    if let Some(mount) = &mut damper.mount {
        mount.stiffness_n_m *= vary(0.20);
        mount.damping_n_s_m *= vary(0.20);
        mount.rod_mass_kg *= vary(0.15);
    }
    damper
}

/// Returns whether the drawn parameters describe a realistic car damper.
fn is_plausible(damper: &Damper) -> bool {
    let gas = (damper.gas.pressure_pa - ATMOSPHERE_PA) * damper.tube.rod_area_m2();
    let flow = damper.tube.annulus_m2() * TOP_VELOCITY_M_S;
    let drop = damper.valves.pressure_drop_pa(-flow, damper.oil.density_kg_m3).abs();
    let rebound = damper.steady_force_n(TOP_VELOCITY_M_S);
    let compression = -damper.steady_force_n(-TOP_VELOCITY_M_S);
    (60.0..=220.0).contains(&gas)
        && (28.0..=52.0).contains(&damper.seal.sliding_n)
        && damper.seal.break_away_n > damper.seal.sliding_n
        && damper.gas.pressure_pa - drop >= LEAST_PRESSURE_PA
        && (2000.0..=5500.0).contains(&rebound)
        && (1000.0..=2800.0).contains(&compression)
        && rebound > 1.2 * compression
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seed_zero_is_the_default_and_seeds_repeat() {
        assert_eq!(Damper::seeded(0), Damper::default());
        assert_eq!(Damper::seeded(7), Damper::seeded(7));
        assert_ne!(Damper::seeded(7), Damper::seeded(8));
        assert_ne!(Damper::seeded(7), Damper::default());
    }

    #[test]
    fn draws_spread_around_the_default() {
        let forces: Vec<f64> = (1..=200).map(|seed| Damper::seeded(seed).steady_force_n(0.5)).collect();
        let default = Damper::default().steady_force_n(0.5);
        let below = forces.iter().filter(|force| **force < default).count();
        assert!((60..=140).contains(&below), "{below} of 200 below the default");
        let mean = forces.iter().sum::<f64>() / 200.0;
        let spread = (forces.iter().map(|f| (f - mean).powi(2)).sum::<f64>() / 199.0).sqrt() / mean;
        assert!((0.05..0.35).contains(&spread), "{spread}");
        assert!((1..=200).all(|seed| is_plausible(&Damper::seeded(seed))));
    }
}
