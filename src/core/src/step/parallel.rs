//! The parallel elements in a step: those with an internal state, and the stops.

use super::tableau::{MOST_STAGES, Tableau};
use crate::assembly::Elements;
use crate::element::{EndState, OperatingPoint, Response, StateVisitor, StatefulForce};
use crate::input::Path;
use crate::math::pair;
use crate::state::{MAX_INTERNAL, Output};
use crate::tables::Tables;

/// Advances all internal states of parallel elements along the path of the moving end.
///
/// Returns the force of these elements and of the stops at the end of the path, with derivatives. Adds the friction,
/// gas and stop forces to `output`.
///
/// Not inlined, so that a damper without such elements has no extra cost.
#[inline(never)]
pub(super) fn advance_extras(
    (method, substeps): (&Tableau, u32),
    elements: &Elements<impl Tables>,
    path: &Path,
    end: &OperatingPoint,
    internal: &mut [f64; MAX_INTERNAL],
    output: &mut Output,
    derivatives: bool,
) -> Response {
    let sum = elements.stops(end);
    output.stop_force = sum.force;
    let on_mass = elements.has_states_on_mass();
    let mut extras = Extras { method, substeps, path, end, internal, output, derivatives, on_mass, sum };
    elements.visit_stateful(&mut extras);
    extras.sum
}

/// Data of one step for the elements with an internal state.
struct Extras<'a> {
    method: &'a Tableau,
    substeps: u32,
    path: &'a Path,
    end: &'a OperatingPoint,
    internal: &'a mut [f64; MAX_INTERNAL],
    output: &'a mut Output,
    derivatives: bool,
    /// Whether the elements that can act on the internal mass act on it. The step of the mass has then already advanced
    /// their states.
    on_mass: bool,
    sum: Response,
}

impl StateVisitor for Extras<'_> {
    #[inline(always)]
    fn visit<M: StatefulForce>(&mut self, place: usize, element: &M) {
        if self.on_mass && element.acts_on_mass() {
            return;
        }
        let Some(slot) = self.internal.get_mut(place) else {
            return;
        };
        let EndState { z, response } = element.propagate(self.path, *slot, self.derivatives).unwrap_or_else(|| {
            let side = (self.end.side_force, self.end.temperature);
            let (z, by_end) =
                advance_state(self.method, self.substeps, element, *slot, self.path, self.derivatives, side);
            EndState::new(z, by_end, &element.evaluate(self.end, z))
        });
        *slot = z;
        self.output.count(element.component(), response.force);
        self.sum.add(response);
    }
}

/// Advances the internal state of one element, driven by the known motion of the moving end.
///
/// Returns the state z and its derivatives with respect to displacement and velocity at the end of the step, which are
/// 0 without `derivatives`. The rate dz/dt is linearized in z once per stage, which is exact for a rate that is linear
/// in z.
fn advance_state(
    method: &Tableau,
    substeps: u32,
    element: &dyn StatefulForce,
    z0: f64,
    path: &Path,
    derivatives: bool,
    side: (f64, f64),
) -> (f64, [f64; 2]) {
    let n = substeps;
    let part = 1.0 / n as f64;
    let h = path.length() * part;
    let (mut z, mut by_end) = (z0, [0.0; 2]);
    let mut theta = 0.0;
    for sub in 0..n {
        let (mut pushes, mut d_pushes) = ([0.0; MOST_STAGES], [[0.0; 2]; MOST_STAGES]);
        let (mut now, mut d_now) = (z, by_end);
        for (i, (weights, c)) in method.weights.iter().zip(&method.c).enumerate().take(method.stages) {
            let ends_step = i + 1 == method.stages && sub + 1 == n;
            let point = if ends_step { path.last() } else { path.point(theta + c * part) };
            let mut known = z;
            for (push, weight) in pushes.iter().zip(weights).take(i) {
                known += weight * push;
            }
            let at =
                OperatingPoint { displacement: point.x, velocity: point.v, side_force: side.0, temperature: side.1 };
            let response = element.evaluate(&at, known);
            let g = method.gamma * h;
            let divide = 1.0 / (1.0 - g * response.d_rate_d_z);
            now = known + g * response.rate * divide;
            if let Some(push) = pushes.get_mut(i) {
                *push = now - known;
            }
            if !derivatives {
                continue;
            }
            let mut d_known = by_end;
            for (push, weight) in d_pushes.iter().zip(weights).take(i) {
                d_known = pair(|k| d_known[k] + weight * push[k]);
            }
            // An implicit stage uses the rate at its end, so the derivatives of the rate with respect to the input are
            // those at the end.
            let response = element.evaluate(&at, now);
            for k in 0..2 {
                let drive = response.d_rate_d_x * point.x_by_end[k] + response.d_rate_d_v * point.v_by_end[k];
                d_now[k] = (d_known[k] + g * drive) * divide;
            }
            if let Some(push) = d_pushes.get_mut(i) {
                *push = pair(|k| d_now[k] - d_known[k]);
            }
        }
        z = now;
        by_end = d_now;
        theta += part;
    }
    (z, by_end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Input;
    use crate::integration::Method;

    /// An element without a closed form: dz/dt = (x − z)/τ + b v − w z³. The fields are 1/τ, b and w.
    struct Follows {
        per_time: f64,
        by_velocity: f64,
        cubic: f64,
    }

    impl StatefulForce for Follows {
        fn evaluate(&self, at: &OperatingPoint, z: f64) -> crate::element::StateResponse {
            crate::element::StateResponse {
                force: 100.0 * z,
                d_force_d_z: 100.0,
                rate: (at.displacement - z) * self.per_time + self.by_velocity * at.velocity - self.cubic * z * z * z,
                d_rate_d_x: self.per_time,
                d_rate_d_v: self.by_velocity,
                d_rate_d_z: -self.per_time - 3.0 * self.cubic * z * z,
                ..crate::element::StateResponse::NONE
            }
        }

        fn equilibrium(&self, at: &OperatingPoint) -> f64 {
            at.displacement
        }
    }

    const FOLLOWS: Follows = Follows { per_time: 300.0, by_velocity: 0.2, cubic: 0.0 };
    const METHODS: [(Method, i32); 5] = [
        (Method::BackwardEuler, 1),
        (Method::Second, 2),
        (Method::ThreeStage, 2),
        (Method::Third, 3),
        (Method::Fourth, 4),
    ];

    /// Returns the state after a motion of 4 ms from the state 0.003, with its derivatives. The motion leads from 1 mm
    /// and 0.4 m/s to the displacement `x`, m, and velocity `v`, m/s.
    fn after(element: &Follows, method: Method, substeps: u32, [x, v]: [f64; 2]) -> (f64, [f64; 2]) {
        let to = Input { displacement: Some(x), ..Input::motion(x, v) };
        let path = Path::new(1e-3, 0.4, &to, 4e-3);
        advance_state(Tableau::for_method(method), substeps, element, 3e-3, &path, true, (0.0, 20.0))
    }

    const END: [f64; 2] = [2e-3, -0.7];

    #[test]
    fn the_error_of_a_state_falls_with_the_order_of_the_method() {
        let exact = after(&FOLLOWS, Method::Fourth, 2000, END).0;
        for (method, order) in METHODS {
            let error = |substeps| (after(&FOLLOWS, method, substeps, END).0 - exact).abs();
            let (coarse, fine) = (error(4), error(16));
            let found = libm::log2(coarse / fine) / 2.0;
            assert!(found > f64::from(order) - 0.25, "{method:?}: {coarse:e} {fine:e}, order {found}");
        }
    }

    #[test]
    fn the_derivatives_of_a_state_over_the_end_of_the_step_are_its_differences() {
        for (method, _) in METHODS {
            for substeps in [1, 3] {
                let (_, derivatives) = after(&FOLLOWS, method, substeps, END);
                for (k, size) in [1e-4, 1e-2].into_iter().enumerate() {
                    let moved = |by: f64| {
                        let mut end = END;
                        end[k] += by;
                        after(&FOLLOWS, method, substeps, end).0
                    };
                    let difference = (moved(size) - moved(-size)) / (2.0 * size);
                    assert!(
                        (derivatives[k] - difference).abs() < 1e-9 * difference.abs(),
                        "{method:?}: {derivatives:?} {difference}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_rate_that_bends_keeps_the_first_order() {
        let bent = Follows { cubic: 1e7, ..FOLLOWS };
        let exact = after(&bent, Method::BackwardEuler, 20_000, END).0;
        for (method, _) in METHODS {
            let error = |substeps| (after(&bent, method, substeps, END).0 - exact).abs();
            assert!(error(64) < 0.3 * error(16), "{method:?}: {:e} {:e}", error(16), error(64));
        }
    }
}
