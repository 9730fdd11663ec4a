//! Conductance of the passage of a lagging valve, g(h) = W(h)²/h, stored as a table. W is the velocity at which the FV
//! curve has the force h.

use crate::tables::{Conducted as At, Conduction, ForceLaw};

/// Resistance, N s/m, added to the FV curve, so that the velocity W at a given force is unique where the curve is
/// horizontal.
const LEVEL: f64 = 5.0;
/// Squared velocity, m²/s², added to W² in the conductance g = W²/h, which is therefore above zero at W = 0.
const LEAST: f64 = 1e-12;
/// Largest number of Householder steps for the velocity W at a given force of the FV curve. Most of them run when a
/// model is prepared, where their time matters little. They also run for forces beyond the table, and in each step of a
/// family whose FV curve or valve depends on the setting.
const STEPS: usize = 8;
/// Number of nodes of the table per power of two of the force.
const PER_OCTAVE: usize = 16;
/// Number of low bits of a force, as a double, that give its position between two nodes of the table. The bits above
/// count the nodes.
const BEHIND: u32 = 48;
/// Number of powers of two of the force that the table covers, from the opening force on. At larger forces the
/// conductance is computed from the FV curve itself.
const OCTAVES: usize = 12;
const PLACES: usize = OCTAVES * PER_OCTAVE;

/// Table of the conductance g = W²/h over the force h, for both strokes, with cubics between its nodes. W is the
/// velocity, m/s, at which the FV curve has the force h, N. The nodes divide every octave (factor of two) of the force
/// into equal intervals.
///
/// Each cubic stays between the values at its ends.
#[derive(Clone, Copy, Debug)]
pub struct Conductance {
    /// The leading bits of the first node's force, as a double without its [`BEHIND`] low bits.
    first: u64,
    strokes: [[At; PLACES + 1]; 2],
}

/// Computes the velocity W, m/s, at which the FV curve has the force `h`, N, and the derivative of the curve there, N
/// s/m. `stroke` is 1 for rebound and −1 for compression.
#[inline(always)]
fn velocity(curve: &impl ForceLaw, h: f64, stroke: f64) -> (f64, f64) {
    let (w, read) = curve.solve::<STEPS>(LEVEL, h * stroke + curve.at_zero());
    (w, read.derivative)
}

/// Computes the conductance g at the force `h`, N, and dg/dh from the FV curve instead of the table. `stroke` is 1 for
/// rebound and −1 for compression.
pub(crate) fn exact(curve: &impl ForceLaw, h: f64, stroke: f64) -> At {
    let (w, derivative) = velocity(curve, h, stroke);
    let g = (w * w + LEAST) / h;
    At { g, by_h: (2.0 * w * stroke / (LEVEL + derivative) - g) / h }
}

/// Limits the derivative of the conductance g at a node, so that the adjacent cubics stay between their end values.
///
/// `limits` are three times the derivatives of the adjacent chords (Fritsch & Carlson, SIAM J. Numer. Anal. 17, 1980).
/// `None` stands for the missing chord of the first and the last node.
fn limited(derivative: f64, limits: [Option<f64>; 2]) -> f64 {
    limits.into_iter().flatten().fold(derivative, |derivative, limit| {
        if derivative * limit <= 0.0 { 0.0 } else { derivative.abs().min(limit.abs()).copysign(derivative) }
    })
}

/// Returns three times the mean derivative of the conductance g between a node and the next.
fn limit(first: u64, node: usize, from: &At, to: &At) -> f64 {
    3.0 * (to.g - from.g) / (force_of(first, node + 1) - force_of(first, node))
}

/// Returns the force, N, of a node of the table whose first node has the leading bits `first`.
fn force_of(first: u64, node: usize) -> f64 {
    f64::from_bits((first + node as u64) << BEHIND)
}

/// Returns the interval of the table that contains the force `h`, N, and the position of h there as a fraction of the
/// interval. `None` outside the table.
#[inline(always)]
fn interval_of(first: u64, h: f64) -> Option<(usize, f64)> {
    const ONE: u64 = 1.0_f64.to_bits();
    let bits = h.to_bits();
    let interval = (bits >> BEHIND).wrapping_sub(first) as usize;
    // The bits below the node number are the position of the force h between two nodes.
    let s = f64::from_bits(ONE | (bits & ((1 << BEHIND) - 1)) << (52 - BEHIND)) - 1.0;
    (interval < PLACES).then_some((interval, s))
}

/// Evaluates the cubic between two nodes at the force `h`, N, which lies at the position `s` from 0 to 1 between them.
#[inline(always)]
fn cubic(from: &At, to: &At, h: f64, s: f64) -> At {
    let octave = f64::from_bits(h.to_bits() & !((1 << 52) - 1));
    let width = octave * (1.0 / PER_OCTAVE as f64);
    let (rise, m0, m1) = (to.g - from.g, from.by_h * width, to.by_h * width);
    let (c2, c3) = (3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise);
    At { g: from.g + s * (m0 + s * (c2 + s * c3)), by_h: (m0 + s * (2.0 * c2 + 3.0 * s * c3)) / width }
}

/// Computes the conductance at the force `h` that a table beginning at the force `opens` would give, without building
/// the table. Both forces are in N.
///
/// Used for an FV curve or a valve that changes from step to step with the setting of a family.
pub(crate) fn tabulated(curve: &impl ForceLaw, opens: f64, h: f64, stroke: f64) -> At {
    let first = opens.to_bits() >> BEHIND;
    let Some((interval, s)) = interval_of(first, h) else { return exact(curve, h, stroke) };
    let node = |node: usize| exact(curve, force_of(first, node), stroke);
    let before = interval.checked_sub(1).map(node);
    let (mut from, mut to) = (node(interval), node(interval + 1));
    let after = (interval + 2 <= PLACES).then(|| node(interval + 2));
    let own = limit(first, interval, &from, &to);
    let earlier = before.map(|before| limit(first, interval - 1, &before, &from));
    let later = after.map(|after| limit(first, interval + 1, &to, &after));
    from.by_h = limited(from.by_h, [Some(own), earlier]);
    to.by_h = limited(to.by_h, [later, Some(own)]);
    cubic(&from, &to, h, s)
}

impl Conductance {
    /// Memory for a table, invalid before [`Conductance::set`]. It is all zeros and therefore takes no space in the
    /// program file.
    pub const UNSET: Conductance = Conductance { first: 0, strokes: [[At { g: 0.0, by_h: 0.0 }; PLACES + 1]; 2] };

    /// Fills the table from the force `opens`, N, on. The valve evaluates no smaller force.
    pub fn set(&mut self, curve: &impl ForceLaw, opens: f64) {
        let table = self;
        table.first = opens.to_bits() >> BEHIND;
        for (stroke, nodes) in [-1.0, 1.0].into_iter().zip(&mut table.strokes) {
            for (node, at) in nodes.iter_mut().enumerate() {
                *at = exact(curve, force_of(table.first, node), stroke);
            }
            let mut before = None;
            for node in 0..=PLACES {
                let Some(at) = nodes.get(node).copied() else { break };
                let after = nodes.get(node + 1).map(|next| limit(table.first, node, &at, next));
                if let Some(own) = nodes.get_mut(node) {
                    own.by_h = limited(at.by_h, [after, before]);
                }
                before = after;
            }
        }
    }

    /// Builds the conductance by value.
    #[cfg(test)]
    fn new(curve: &impl ForceLaw, opens: f64) -> Conductance {
        let mut table = Conductance::UNSET;
        table.set(curve, opens);
        table
    }
}

impl Conduction for Conductance {
    #[inline(always)]
    fn conducted(&self, curve: &impl ForceLaw, h: f64, stroke: f64) -> At {
        let nodes = &self.strokes[usize::from(stroke > 0.0)];
        let Some((interval, s)) = interval_of(self.first, h) else { return exact(curve, h, stroke) };
        let (Some(from), Some(to)) = (nodes.get(interval), nodes.get(interval + 1)) else {
            return exact(curve, h, stroke);
        };
        cubic(from, to, h, s)
    }
}

/// Returns the velocity W, m/s, for the conductance `g` at the force `h`, N. Also returns the derivative of g with
/// respect to the FV curve's force at W.
#[inline(always)]
pub(super) fn by_raised(curve: &impl ForceLaw, g: f64, h: f64, stroke: f64) -> (f64, f64) {
    let square = g * h - LEAST;
    let w = libm::sqrt(if square > 0.0 { square } else { 0.0 }) * stroke;
    (w, -2.0 * w / (h * (LEVEL + curve.evaluate(w).derivative)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Curve, Interpolation};
    use crate::elements::fv_curve::FvCurve;

    fn curve(interpolation: Interpolation) -> FvCurve {
        let v = [-1.5, -0.5, -0.3, -0.1, 0.0, 0.1, 0.5, 1.5];
        let f = [-1480.0, -820.0, -820.0, -380.0, 20.0, 720.0, 1320.0, 2220.0];
        FvCurve(Curve::new(&v, &f, interpolation).unwrap())
    }

    #[test]
    fn the_table_is_the_curve_read_backwards() {
        let curve = curve(Interpolation::MonotoneCubic);
        let table = Conductance::new(&curve, 130.0);
        for stroke in [-1.0, 1.0] {
            for k in 0..2000 {
                let h = 130.0 * 1.004_f64.powi(k);
                let (w, derivative) = velocity(&curve, h, stroke);
                let g = table.conducted(&curve, h, stroke).g;
                // Next to a horizontal part of the curve, the table rounds the corner, so the tolerance is larger.
                let close = if derivative > 1500.0 { 3e-3 } else { 0.4 };
                assert!((libm::sqrt(g * h) - w.abs()).abs() < close * w.abs(), "{stroke} {h}: {g}, {w}");
            }
        }
    }

    #[test]
    fn without_a_table_it_is_the_same_to_the_bit() {
        for interpolation in [Interpolation::MonotoneCubic, Interpolation::Linear] {
            let curve = curve(interpolation);
            let table = Conductance::new(&curve, 7.0);
            for stroke in [-1.0, 1.0] {
                for k in 0..4400 {
                    let h = 7.001 * 1.002_f64.powi(k);
                    let (of_table, computed) = (table.conducted(&curve, h, stroke), tabulated(&curve, 7.0, h, stroke));
                    assert_eq!((of_table.g, of_table.by_h), (computed.g, computed.by_h), "{h}");
                }
            }
        }
    }

    #[test]
    fn it_rises_where_its_places_do_with_the_derivative_that_it_says() {
        for interpolation in [Interpolation::MonotoneCubic, Interpolation::Linear] {
            let curve = curve(interpolation);
            let table = Conductance::new(&curve, 7.0);
            for stroke in [-1.0, 1.0] {
                for k in 0..4000 {
                    let h = 7.001 * 1.002_f64.powi(k);
                    let at = table.conducted(&curve, h, stroke);
                    let d = 1e-6 * h;
                    let [below, above] = [h - d, h + d].map(|h| table.conducted(&curve, h, stroke).g);
                    let seen = (above - below) / (2.0 * d);
                    assert!((seen - at.by_h).abs() < 1e-4 * (at.by_h.abs() + at.g / h), "{h}: {seen} {at:?}");
                    assert!(at.g > 0.0 && at.by_h > -2.0 * at.g / h, "g h = W² never falls: {h} {at:?}");
                }
            }
        }
    }
}
