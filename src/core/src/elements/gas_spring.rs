//! Gas spring: change of the gas force with rod displacement; isothermal in slow motion, adiabatic in fast motion.

use crate::dual::{Dual, Real};
use crate::element::{EndState, ForceComponent, OperatingPoint, Prepare, Response, StateResponse, StatefulForce};
use crate::fault::Fault;
use crate::input::{Path, Travel};
use crate::math::{max, power_inlined, relaxation};
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Gas spring with the force F = k L (1 − p/p_0), N, and the gas volume V/V_0 = ξ = 1 + x/L.
///
/// x is the displacement, m. k is the isothermal stiffness at x = 0, N/m, and L the gas volume at x = 0 over the rod
/// area, m. p, V and T are pressure, volume and temperature of the gas; the index 0 means at x = 0 and wall
/// temperature. The constant part of the gas force, −p_0 A_rod with the area A_rod of the rod, is `gas_preload`.
///
/// The state is z = p V^γ/(p_0 V_0^γ) − 1, which is constant in adiabatic motion; γ is the adiabatic index. The gas
/// temperature is θ = T/T_0 = (1 + z) ξ^(1−γ). Heat through the wall, dT/dt = (T_0 − T)/τ at constant volume with the
/// thermal time τ, gives dz/dt = (ξ^(γ−1) − 1 − z)/τ.
#[derive(Clone, Copy, Debug)]
pub struct GasSpring {
    /// Isothermal stiffness k times gas length L, N.
    push: f64,
    /// One over the gas length L, 1/m.
    per_length: f64,
    /// Adiabatic index γ, minus 1.
    excess: f64,
    /// Binomial series of ξ^(γ−1) in a small change of the relative volume ξ: the ratio of each coefficient to the
    /// previous one, last term first.
    series: [f64; 4],
    /// One over the thermal time τ, 1/s.
    per_time: f64,
}

/// Smallest gas volume, as a fraction of that at x = 0. Below this volume the pressure is extrapolated linearly, so
/// that it rises further. The steady-state temperature remains that of the smallest volume, because the law gives no
/// temperature for zero volume.
const SMALLEST: f64 = 0.05;

impl Describe for GasSpring {
    const MEANING: &'static str = "change of the gas force with the rod displacement, isothermal to adiabatic";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("gas_stiffness", "N/m", &[500.0], (0.0, 1e6), "isothermal gas stiffness at x = 0, k"),
        Parameter::scalar(
            "gas_length",
            "m",
            &[0.4],
            (0.05, 10.0),
            "gas volume at x = 0 over the rod area, L; shorter: more progressive",
        ),
        Parameter::scalar(
            "gas_adiabatic_index",
            "-",
            &[1.4],
            (1.0, 1.67),
            "adiabatic index: ratio of adiabatic to isothermal stiffness, gamma",
        ),
        Parameter::scalar(
            "gas_thermal_time",
            "s",
            &[3.0],
            (0.01, 1e3),
            "thermal time constant between gas and wall, tau",
        ),
    ];
}

impl Prepare for GasSpring {
    const OFF: Self = GasSpring { push: 0.0, per_length: 0.0, excess: 0.0, series: [0.0; 4], per_time: 0.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let (stiffness, length) = (p.number(own!("gas_stiffness")), p.number(own!("gas_length")));
        let (index, time) = (p.number(own!("gas_adiabatic_index")), p.number(own!("gas_thermal_time")));
        Ok(GasSpring::new(stiffness, length, index, time))
    }
}

/// The gas at one rod displacement, with the relative volume ξ and the adiabatic index γ. `per_inside` is 1/ξ and
/// `value` is ξ^(γ−1), with ξ clamped to at least [`SMALLEST`]. `below` is ξ − [`SMALLEST`] if that is negative,
/// otherwise 0.
struct Gas {
    below: f64,
    per_inside: f64,
    value: f64,
}

/// Largest relative change of the gas volume over a step for which a binomial series replaces the second power
/// function. The first neglected term of the series is below 3e-11.
const NEAR: f64 = 1.0 / 64.0;

impl GasSpring {
    fn new(stiffness: f64, length: f64, index: f64, time: f64) -> GasSpring {
        let excess = index - 1.0;
        GasSpring {
            push: stiffness * length,
            per_length: 1.0 / length,
            excess,
            series: [3.0, 2.0, 1.0, 0.0].map(|n| (excess - n) / (n + 1.0)),
            per_time: 1.0 / time,
        }
    }

    #[inline(always)]
    fn gas(&self, x: f64) -> Gas {
        let ratio = 1.0 + x * self.per_length;
        let inside = max(ratio, SMALLEST);
        let value = power_inlined(inside, self.excess);
        Gas { below: ratio - inside, per_inside: 1.0 / inside, value }
    }

    /// Computes [`GasSpring::rests`] at displacement `x`, m, by a series about the gas `known` if both gas volumes are
    /// close.
    #[inline(always)]
    fn rests_near(&self, known: &Gas, x: f64) -> (f64, f64) {
        let inside = 1.0 + x * self.per_length;
        let change = inside * known.per_inside - 1.0;
        // Near the smallest volume, the volume at either end of the step may be clamped, so that the series does not
        // apply.
        if known.per_inside > (1.0 - NEAR) / SMALLEST || change.abs() > NEAR {
            return self.rests(&self.gas(x));
        }
        let mut series = 1.0;
        for factor in self.series {
            series = 1.0 + factor * change * series;
        }
        let value = known.value * series;
        (value, self.excess * value * self.per_length / inside)
    }

    /// Returns ξ^(γ−1), the steady state of 1 + z for the state z, and its derivative with respect to displacement,
    /// 1/m. Here ξ is the relative gas volume, and γ the adiabatic index.
    #[inline(always)]
    fn rests(&self, at: &Gas) -> (f64, f64) {
        let rises = if at.below < 0.0 { 0.0 } else { self.excess * at.value * at.per_inside * self.per_length };
        (at.value, rises)
    }

    /// Returns the second derivative of the steady state with respect to displacement, 1/m²; `rises` is the first
    /// derivative, 1/m.
    #[inline(always)]
    fn bends(&self, at: &Gas, rises: f64) -> f64 {
        if at.below < 0.0 { 0.0 } else { (self.excess - 1.0) * rises * at.per_inside * self.per_length }
    }

    /// Returns the relative pressure ξ^−γ = 1/(ξ ξ^(γ−1)) of gas with the state z = 0, and its derivative with respect
    /// to displacement, 1/m. Here ξ is the relative gas volume, and γ the adiabatic index.
    #[inline(always)]
    fn pressure(&self, at: &Gas) -> (f64, f64) {
        let value = at.per_inside / at.value;
        let derivative = -(self.excess + 1.0) * value * at.per_inside;
        (value + derivative * at.below, derivative * self.per_length)
    }
}

/// Returns the weights of three quantities in the state after relaxation toward a moving target. The quantities are the
/// target's derivatives at start and end of the step, and its change.
///
/// The argument holds the moments from [`relaxation`]. The target, like the path, is the cubic through the values and
/// derivatives at start and end of the step. The coefficients p_1 to p_3 of the cubic are s, 3 d − 2 s − e and s + e −
/// 2 d. Here d is the difference of the values. s and e are the derivatives at start and end, times the step length.
#[inline(always)]
fn weights([_, first, second, third]: [f64; 4]) -> [f64; 3] {
    let (of_end, of_change) = (third - second, 3.0 * second - 2.0 * third);
    [first - second + of_end, of_end, of_change]
}

impl StatefulForce for GasSpring {
    fn component(&self) -> ForceComponent {
        ForceComponent::Gas
    }

    fn evaluate(&self, at: &OperatingPoint, z: f64) -> StateResponse {
        let gas = self.gas(at.displacement);
        let (isothermal, isothermal_by_x) = self.rests(&gas);
        let (pressure, pressure_by_x) = self.pressure(&gas);
        StateResponse {
            force: self.push * (1.0 - (1.0 + z) * pressure),
            d_force_d_x: -self.push * (1.0 + z) * pressure_by_x,
            d_force_d_z: -self.push * pressure,
            rate: (isothermal - 1.0 - z) * self.per_time,
            d_rate_d_x: isothermal_by_x * self.per_time,
            d_rate_d_z: -self.per_time,
            ..StateResponse::NONE
        }
    }

    fn acts_on_mass(&self) -> bool {
        true
    }

    /// Computes state and force after a motion of the mass, exactly if the state's target is a cubic in time.
    fn propagate_on_mass(&self, from: Dual<2>, travel: &Travel<Dual<2>>, z: Dual<2>) -> [Dual<2>; 2] {
        let (kept, takes) = relaxation(travel.time * self.per_time);
        let end = from + travel.moved;
        let drawn = |x: Dual<2>| {
            let gas = self.gas(x.value());
            let (value, by_x) = self.rests(&gas);
            (x.chain(value - 1.0, by_x), x.chain(by_x, self.bends(&gas, by_x)))
        };
        let ((to, to_by_x), (from, from_by_x)) = (drawn(end), drawn(from));
        let [of_start, of_end, of_change] = weights(takes);
        let rates = travel.v0 * from_by_x * of_start + travel.v1 * to_by_x * of_end;
        let z = z * kept + from * takes[0] + (to - from) * of_change + rates * travel.time;
        let (pressure, pressure_by_x) = self.pressure(&self.gas(end.value()));
        let force = z.plus(1.0) * end.chain(pressure, pressure_by_x) * -self.push;
        [z, force.plus(self.push)]
    }

    fn equilibrium(&self, at: &OperatingPoint) -> f64 {
        self.rests(&self.gas(at.displacement)).0 - 1.0
    }

    /// Computes state and force after the path, exactly if the state's target is a cubic in time.
    #[inline(always)]
    fn propagate(&self, path: &Path, z: f64, derivatives: bool) -> Option<EndState> {
        let h = path.length();
        let (kept, takes) = relaxation(h * self.per_time);
        let ((x0, v0), (x1, v1)) = (path.start(), path.end());
        let gas = self.gas(x1);
        let ((to, to_by_x), (from, from_by_x)) = (self.rests(&gas), self.rests_near(&gas, x0));
        let [of_start, of_end, of_change] = weights(takes);
        let derivatives_take = of_start * v0 * from_by_x + of_end * v1 * to_by_x;
        let end = kept * z + takes[0] * (from - 1.0) + of_change * (to - from) + h * derivatives_take;
        let (pressure, pressure_by_x) = self.pressure(&gas);
        let (pushes, by_end) = (self.push * (1.0 + end), -self.push * pressure);
        let mut response =
            Response { force: self.push - pushes * pressure, d_force_d_x: -pushes * pressure_by_x, d_force_d_v: 0.0 };
        if derivatives {
            let bends = self.bends(&gas, to_by_x);
            response.d_force_d_x += by_end * (of_change * to_by_x + of_end * h * v1 * bends);
            response.d_force_d_v += by_end * of_end * h * to_by_x;
        }
        Some(EndState { z: end, response })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Input;

    #[test]
    fn a_small_change_of_volume_is_as_exact_as_a_power() {
        for excess in [0.01, 0.1, 0.3, 0.4, 0.67] {
            let spring = GasSpring::new(2.5, 0.4, 1.0 + excess, 1.0);
            // The volumes range from far below the smallest allowed volume to four times that at x = 0, with changes on
            // both sides of `NEAR`.
            for volume in [-0.5, 0.0, 0.049, 0.05, 0.0503, 0.0508, 0.051, 0.06, 0.3, 1.0, 4.0] {
                for change in [-0.5, -0.0157, -0.0156, -1e-3, -1e-9, 0.0, 1e-9, 1e-3, 0.0156, 0.0157, 0.5] {
                    let place = |volume: f64| (volume - 1.0) / spring.per_length;
                    let x = place(volume + change * f64::max(volume, 0.05));
                    let (value, derivative) = spring.rests_near(&spring.gas(place(volume)), x);
                    let (want, want_derivative) = spring.rests(&spring.gas(x));
                    assert!(
                        (value - want).abs() < 3.1e-11 * want.abs().max(1.0),
                        "{excess}: {volume}, {change}: {value}, {want}"
                    );
                    assert!(
                        (derivative - want_derivative).abs() < 1e-10 * want_derivative.abs().max(1.0),
                        "{excess}: {volume}, {change}: slope"
                    );
                }
            }
        }
    }

    #[test]
    fn derivatives_of_a_step_are_those_of_differences() {
        // The thermal time is two thirds of the step, and the rod displaces up to a third of the gas volume.
        let spring = GasSpring::new(250.0, 0.4, 1.6, 1.0 / 300.0);
        let (v0, dt, z) = (-20.0, 5e-3, 0.1);
        let carried = |x1: f64, v1: f64| {
            let path = Path::new(0.0, v0, &Input::motion(x1, v1), dt);
            spring.propagate(&path, z, true).unwrap()
        };
        for (x1, v1) in [(-0.13, -40.0), (-0.002, 30.0), (0.05, 3.0)] {
            let answer = carried(x1, v1).response;
            let (dx, dv) = (1e-6, 1e-3);
            let by_x = (carried(x1 + dx, v1).response.force - carried(x1 - dx, v1).response.force) / (2.0 * dx);
            let by_v = (carried(x1, v1 + dv).response.force - carried(x1, v1 - dv).response.force) / (2.0 * dv);
            assert!((answer.d_force_d_x - by_x).abs() < 1e-6 * by_x.abs(), "{x1} {v1}: {} {by_x}", answer.d_force_d_x);
            assert!((answer.d_force_d_v - by_v).abs() < 1e-6 * by_v.abs(), "{x1} {v1}: {} {by_v}", answer.d_force_d_v);
        }
    }
}
