//! Mean and difference of the two forces at each position of a cycle, which passes each position in both directions. In a slow test, the
//! mean comes from gas and springs, the difference from seal drag and friction.

/// Forces at one position of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Position, m.
    pub at: f64,
    /// Mean force of both directions, N.
    pub mean: f64,
    /// Force during extension minus force during compression, N.
    pub difference: f64,
}

/// Number of position bins of a cycle. With 300 samples per cycle, each bin contains at least two samples of each direction.
const PLACES: usize = 24;
/// Fraction of the travel that is excluded at either end, because friction reverses at the ends.
const ENDS: f64 = 0.08;

/// Averages the forces of a cycle by position and direction. Omits positions without samples of both directions.
pub fn two_ways(at: &[f64], velocity: &[f64], force: &[f64]) -> Vec<Place> {
    let n = at.len().min(velocity.len()).min(force.len());
    let (low, high) = at[..n].iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
    let (from, to) = (low + ENDS * (high - low), high - ENDS * (high - low));
    if !(to > from) {
        return Vec::new();
    }
    let mut ways = [[(0.0, 0.0, 0.0); PLACES]; 2];
    for i in 0..n {
        let place = (at[i] - from) / (to - from) * PLACES as f64;
        if velocity[i] != 0.0 && (0.0..PLACES as f64).contains(&place) {
            let (count, x, f) = &mut ways[usize::from(velocity[i] > 0.0)][place as usize];
            *count += 1.0;
            *x += at[i];
            *f += force[i];
        }
    }
    let [down, up] = ways;
    down.iter()
        .zip(&up)
        .filter(|(d, u)| d.0 > 0.0 && u.0 > 0.0)
        .map(|(d, u)| {
            let (down, up) = (d.2 / d.0, u.2 / u.0);
            Place { at: 0.5 * (d.1 / d.0 + u.1 / u.0), mean: 0.5 * (up + down), difference: up - down }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn gas_and_drag_of_a_known_cycle_are_told_apart() {
        let phase = |i: usize| TAU * i as f64 / 300.0;
        let x: Vec<f64> = (0..300).map(|i| 0.02 * libm::sin(phase(i))).collect();
        let v: Vec<f64> = (0..300).map(|i| 0.005 * libm::cos(phase(i))).collect();
        // The gas pushes the rod out with 150 N and a stiffness of 1000 N/m; the seal drag is 25 N.
        let force: Vec<f64> = x.iter().zip(&v).map(|(x, v)| -150.0 + 1000.0 * x + 25.0 * v.signum()).collect();
        let places = two_ways(&x, &v, &force);
        assert!(places.len() >= PLACES - 1, "{}", places.len());
        for p in &places {
            assert!((p.mean - (-150.0 + 1000.0 * p.at)).abs() < 0.6 && (p.difference - 50.0).abs() < 1.2, "{p:?}");
        }
        assert!(two_ways(&[], &[], &[]).is_empty() && two_ways(&[1.0; 9], &[1.0; 9], &[1.0; 9]).is_empty());
    }
}
