//! A cycle passes every place twice: what both ways have in common, and what they do not. In a slow test that is gas and springs on one
//! hand, seal drag and friction on the other.

/// What a cycle shows at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Where, m.
    pub at: f64,
    /// Mean force of both ways, N.
    pub mean: f64,
    /// Force of the way out less that of the way in, N.
    pub difference: f64,
}

/// Places along a cycle.
///
/// As many as a thinned slow cycle of 300 samples fills with two samples of each way, even where it is fastest.
const PLACES: usize = 24;
/// Share of the travel at either end that is left out: there the way turns, and friction turns with it.
const ENDS: f64 = 0.08;

/// Parts a cycle by where it is and by the sign of its velocity; places that one way does not pass are left out.
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
        // 150 N of gas that push the rod out and grow by 1000 N/m, 25 N of seal drag.
        let force: Vec<f64> = x.iter().zip(&v).map(|(x, v)| -150.0 + 1000.0 * x + 25.0 * v.signum()).collect();
        let places = two_ways(&x, &v, &force);
        assert!(places.len() >= PLACES - 1, "{}", places.len());
        for p in &places {
            assert!((p.mean - (-150.0 + 1000.0 * p.at)).abs() < 0.6 && (p.difference - 50.0).abs() < 1.2, "{p:?}");
        }
        assert!(two_ways(&[], &[], &[]).is_empty() && two_ways(&[1.0; 9], &[1.0; 9], &[1.0; 9]).is_empty());
    }
}
