//! The law of a rubber or hydraulic stop, used by `bump_stop` and `rebound_stop`.

use crate::element::Response;
use crate::math::tanh;

/// Force of a stop at depth d beyond the clearance and at speed s into the stop:
///
/// ```text
/// P = k d̃ (1 + d̃/p) (1 + η tanh(s/s_0)) + c ½ (d̃/p) (1 + d̃/p) f(s),   d̃ = d²/(d + d_0)
/// f = s₊²/(s₊ + s_0), or s₊²/v_1 through an orifice
/// ```
///
/// P is the force, N, d the depth, m, and s the speed, m/s. k is the stiffness at first contact, and p the depth at
/// which the spring has twice its linear force. η is the fraction of the spring force that is lost, and c the damping,
/// N s/m; s₊ = max(s, 0). The spring stiffens and returns less energy than it absorbs. Oil is displaced only while the
/// depth grows. The derivatives are continuous, because d̃ sets in smoothly over d_0 and the oil force over s_0. v_1 is
/// 1 m/s.
#[derive(Clone, Copy, Debug)]
pub struct EndStop {
    /// Displacement toward the stop at which the contact begins, m.
    pub clearance: f64,
    /// Stiffness k at first contact, N/m.
    pub stiffness: f64,
    /// One over the depth p at which the spring has twice its linear force, 1/m.
    pub per_progression: f64,
    /// Fraction η of the spring force that is lost in either direction.
    pub loss: f64,
    /// Hydraulic damping c on the way into the stop, N s/m, at the depth p.
    pub damping: f64,
    /// Whether the oil flows through an orifice.
    pub is_orifice: bool,
}

/// Length d_0 of the soft onset of the contact, m.
const CONTACT: f64 = 5e-4;
/// Speed s_0, m/s, over which the losses change sign.
const TURNING: f64 = 0.02;

impl EndStop {
    /// A stop without force.
    pub const OFF: EndStop =
        EndStop { clearance: 0.0, stiffness: 0.0, per_progression: 0.0, loss: 0.0, damping: 0.0, is_orifice: false };

    /// Computes the force P, N, at displacement `x`, m, toward the stop and speed `s`, m/s, into it, with ∂P/∂x and
    /// ∂P/∂s.
    pub fn push(&self, x: f64, s: f64) -> Response {
        let beyond = x - self.clearance;
        if beyond <= 0.0 {
            return Response::NONE;
        }
        let per = 1.0 / (beyond + CONTACT);
        let depth = beyond * beyond * per;
        let depth_by_x = beyond * (beyond + 2.0 * CONTACT) * per * per;
        let spring = self.stiffness * depth * (1.0 + depth * self.per_progression);
        let spring_by_depth = self.stiffness * (1.0 + 2.0 * depth * self.per_progression);
        let turned = tanh(s * (1.0 / TURNING));
        let gain = 1.0 + self.loss * turned;
        let gain_by_s = self.loss * (1.0 - turned * turned) * (1.0 / TURNING);
        let (mut flow, mut flow_by_s) = (0.0, 0.0);
        if s > 0.0 && self.is_orifice {
            (flow, flow_by_s) = (s * s, 2.0 * s);
        } else if s > 0.0 {
            let per = 1.0 / (s + TURNING);
            flow = s * s * per;
            flow_by_s = s * (s + 2.0 * TURNING) * per * per;
        }
        let oil = 0.5 * self.damping * self.per_progression;
        let covered = depth * (1.0 + depth * self.per_progression);
        let covered_by_depth = 1.0 + 2.0 * depth * self.per_progression;
        Response {
            force: spring * gain + oil * covered * flow,
            d_force_d_x: (spring_by_depth * gain + oil * covered_by_depth * flow) * depth_by_x,
            d_force_d_v: spring * gain_by_s + oil * covered * flow_by_s,
        }
    }
}
