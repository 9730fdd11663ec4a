//! Compressibility of the oil column between piston and valves.

use crate::dual::Real;
use crate::element::Prepare;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Compressible oil column with the equations F_h = k_o q, ℓ dq/dt = u − w, F_d(w) = F_h, where F_d is the FV curve.
///
/// F_h is the hydraulic force, N. q is the deflection of the column, m, and k_o its stiffness, N/m. The velocity w at
/// the valves is the piston velocity u minus the deflection rate of the oil column.
///
/// ℓ is the length of the column relative to that at displacement x = 0, and λ, 1/m, one over its length there. The
/// rebound chamber becomes shorter with extension: ℓ = 1 − λ x. With two chambers, the chamber under pressure deflects:
/// ℓ = 1 − λ x q/√(q² + q_c²). For a negative q the compression chamber is under pressure, which becomes longer with
/// extension. q_c is a small deflection over which the length changes smoothly between the chambers.
///
/// With one chamber, the state is q, which stays constant while the chamber moves under constant pressure. With two
/// chambers, the state is the part of the piston stroke that the oil absorbs, s = ∫ ℓ dq from 0 at displacement x. v is
/// the velocity of the moving end, dx/dt:
///
/// ```text
/// ds/dt = u − w + v ∂s/∂x
/// ```
///
/// With q as the state, an implicit stage would solve ℓ(q) (q − Q)/g = u − w. Q is the known part of q, and g, s, the
/// weight of dq/dt in the stage. The left side falls with q where the longer chamber begins to act, so there are three
/// solutions. If the stages of one step had deflections q of both signs, their combination would also give a wrong q.
///
/// In compression k_o is r_o times that in rebound. In a twin tube, the force in compression acts on the oil below the
/// piston through the rod area alone. The oil below therefore deflects more under the same force than the oil above.
///
/// The cylinder expansion is included: 1/k_o is the compliance of the oil plus that of the tube. No rig test can
/// separate the two. The series compliance is a separate element, because it also carries the force of the springs on
/// the internal mass. The oil does not carry that force.
#[derive(Clone, Copy, Debug)]
pub struct OilCompressibility {
    /// Compliance of the oil column at zero displacement, 1/k_o, in rebound and in compression, m/N.
    compliance: [f64; 2],
    shortening: f64,
    has_two_chambers: bool,
    /// Deflection q_c, m, over which the length changes smoothly between the two chambers.
    changes: f64,
}

/// Force, N, on the stiffer chamber over which the column changes smoothly from one chamber to the other. It is far
/// below all forces that matter.
const CHANGES: f64 = 50.0;
/// Smallest relative length of a chamber, at which its length is clamped.
const SHORTEST: f64 = 0.1;

impl Describe for OilCompressibility {
    const MEANING: &'static str =
        "compressibility of the oil column upstream of the valves, expansion of the cylinder included";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "oil_stiffness",
            "N/m",
            &[3e6],
            (2e4, 1e9),
            "stiffness of the oil column at x = 0, cylinder expansion included, k_o",
        ),
        Parameter::scalar(
            "oil_shortening",
            "1/m",
            &[0.0],
            (-50.0, 50.0),
            "reciprocal of the oil column length at x = 0, lambda; 0: stiffness independent of the position",
        ),
        Parameter::choice(
            "oil_chambers",
            &["rebound", "both"],
            "chamber whose oil column is compressible: always the rebound chamber, or the chamber under pressure",
        ),
        Parameter::scalar(
            "oil_compression",
            "-",
            &[1.0],
            (0.01, 100.0),
            "ratio of the oil column stiffness in compression to that in rebound, r_o",
        ),
    ];
}

impl Prepare for OilCompressibility {
    /// An oil column of 3e7 N/m for models with aeration alone. It is ten times stiffer than that of most dampers, so
    /// its effect is small compared with that of the air.
    const OFF: Self =
        OilCompressibility { compliance: [1.0 / 3e7; 2], shortening: 0.0, has_two_chambers: false, changes: 1.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let rebound = 1.0 / p.number(own!("oil_stiffness"));
        let compression = 1.0 / (p.number(own!("oil_stiffness")) * p.number(own!("oil_compression")));
        Ok(OilCompressibility {
            compliance: [rebound, compression],
            shortening: p.number(own!("oil_shortening")),
            has_two_chambers: p.number(own!("oil_chambers")) == 1.0,
            changes: CHANGES * rebound.min(compression),
        })
    }
}

impl OilCompressibility {
    /// Returns the compliance of the oil column, 1/k_o, m/N: that in compression for a negative `side`, otherwise that
    /// in rebound. `side` is the force or the deflection, which have the same sign.
    #[inline(always)]
    pub(crate) fn compliance(&self, side: f64) -> f64 {
        let [rebound, compression] = self.compliance;
        if side < 0.0 { compression } else { rebound }
    }

    /// Returns whether the column is equally stiff in rebound and compression.
    pub(crate) fn is_even(&self) -> bool {
        let [rebound, compression] = self.compliance;
        rebound == compression
    }

    /// Returns whether the length of the column, and thus its stiffness, depends on the displacement.
    #[inline(always)]
    pub(crate) fn has_length(&self) -> bool {
        self.shortening != 0.0
    }

    /// Returns the relative lengths of the rebound and the compression chamber at displacement `x`, m; they are 1 at
    /// zero displacement. With one chamber, both are that of the rebound chamber.
    #[inline(always)]
    fn lengths<R: Real>(&self, x: R) -> [R; 2] {
        let within = |length: R| if length.value() > SHORTEST { length } else { R::constant(SHORTEST) };
        let away = x * self.shortening;
        let rebound = within((-away).plus(1.0));
        [rebound, if self.has_two_chambers { within(away.plus(1.0)) } else { rebound }]
    }

    /// Computes √(q² + q_c²) − q_c, m, for the deflection q: nearly |q| − q_c if |q| is far above q_c.
    #[inline(always)]
    fn size<R: Real>(&self, deflection: R) -> R {
        (deflection * deflection).plus(self.changes * self.changes).sqrt().plus(-self.changes)
    }

    /// Returns whether the state is the absorbed part s of the piston stroke instead of the deflection q.
    #[inline(always)]
    pub(crate) fn counts_stroke(&self) -> bool {
        self.has_two_chambers && self.has_length()
    }

    /// Returns the length of a single chamber at displacement `x`, m, relative to that at x = 0.
    #[inline(always)]
    pub(crate) fn length<R: Real>(&self, x: R) -> R {
        let [length, _] = self.lengths(x);
        length
    }

    /// Computes s, m, the part of the piston stroke that the oil absorbs, at displacement `x`, m, and deflection q, m.
    #[inline(always)]
    pub(crate) fn taken_up<R: Real>(&self, x: R, deflection: R) -> R {
        let [rebound, compression] = self.lengths(x);
        ((rebound + compression) * deflection + (rebound - compression) * self.size(deflection)) * 0.5
    }

    /// Computes ∂s/∂x at constant deflection q, for the part s of the piston stroke that the oil absorbs.
    #[inline(always)]
    pub(crate) fn taken_up_by_place<R: Real>(&self, x: R, deflection: R) -> R {
        let [rebound, compression] = self.lengths(x).map(|length| length.value() > SHORTEST);
        let per = |moves: bool, sign: f64| if moves { sign * self.shortening } else { 0.0 };
        let [by_rebound, by_compression] = [per(rebound, -0.5), per(compression, 0.5)];
        deflection * (by_rebound + by_compression) + self.size(deflection) * (by_rebound - by_compression)
    }

    /// Returns the deflection q, m, for the absorbed stroke s = `taken_up`, m, the only root of (a + b) q + (a −
    /// b)(√(q² + q_c²) − q_c) = 2 s. Here a and b are the relative lengths of the rebound and the compression chamber
    /// at displacement `x`, and q_c is `changes`.
    #[inline(always)]
    pub(crate) fn deflection<R: Real>(&self, x: R, taken_up: R) -> R {
        let [rebound, compression] = self.lengths(x);
        let product = rebound * compression;
        let (mean, half) = ((rebound + compression) * 0.5, (rebound - compression) * 0.5);
        let all = taken_up + half * self.changes;
        let root = (all * all + product * (self.changes * self.changes)).sqrt();
        (all * mean - half * root) * product.inverse()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deflection_undoes_what_is_taken_up_and_its_derivatives_are_those_of_differences() {
        let oil =
            OilCompressibility { compliance: [1e-7, 3e-8], shortening: 12.0, has_two_chambers: true, changes: 1.5e-6 };
        for x in [-0.09, -0.04, 0.0, 0.03, 0.08] {
            let mut last = f64::NEG_INFINITY;
            for q in [-3e-4, -2e-6, -1e-7, 0.0, 4e-8, 1e-6, 5e-4] {
                let s = oil.taken_up(x, q);
                assert!(s > last, "{s} after {last}");
                last = s;
                assert!((oil.deflection(x, s) - q).abs() <= 1e-12 * (q.abs() + 1e-6), "{q} at {x}");
                let by_x = (oil.taken_up(x + 1e-6, q) - oil.taken_up(x - 1e-6, q)) / 2e-6;
                assert!((oil.taken_up_by_place(x, q) - by_x).abs() <= 1e-8, "{q} at {x}");
            }
        }
    }
}
