//! The internal mass in the stages of the plain step, where only springs and the FV curve act on it.

use super::cheap;
use super::follow::{Follow, Line, LineOrigin, Stage};
use super::primary::{Plain, Primary};
use super::reach::{line_by_place, springs, within_reach};
use super::tableau::{EULER, MOST_STAGES, SECOND, THIRD, THREE_STAGE, Tableau};
use crate::assembly::Elements;
use crate::curve::Value;
use crate::element::{OperatingPoint, Response};
use crate::input::Path;
use crate::math::pair;
use crate::tables::Tables;

/// Displacement, m, and velocity, m/s, of the internal mass, and the valve force and spring force on it, N.
#[derive(Clone, Copy)]
pub(super) struct Mass {
    pub x: f64,
    pub v: f64,
    pub primary: f64,
    pub inner: f64,
}

/// One substep in progress.
struct Substep<'a, T: Tables, P> {
    elements: &'a Elements<T>,
    primary: P,
    path: &'a Path,
    /// Start of the substep. `part` is its length. Both are fractions of the step.
    theta: f64,
    part: f64,
    /// Whether the substep ends the step.
    ends_step: bool,
    /// Length of the substep, s, and its reciprocal.
    h: f64,
    per_h: f64,
    side: (f64, f64),
    start: Mass,
    predicted: f64,
    /// Gains of each stage: g × velocity, m, and g × acceleration, m/s, of the mass, with the weight g of the stage, s.
    gains: [[f64; 2]; MOST_STAGES],
}

impl<T: Tables, P: Primary> Substep<'_, T, P> {
    /// Runs all stages, at most four, in an unrolled loop, so that the stage indices are constants. `MAY_BEND` means
    /// that some springs may be nonlinear.
    #[inline(always)]
    fn written_out<const MAY_BEND: bool>(&mut self, method: &Tableau, follow: &mut impl Follow<T>) -> Mass {
        let mut mass = self.stage::<MAY_BEND>(method, 0, follow);
        if method.stages > 1 {
            mass = self.stage::<MAY_BEND>(method, 1, follow);
        }
        if method.stages > 2 {
            mass = self.stage::<MAY_BEND>(method, 2, follow);
        }
        if method.stages > 3 {
            mass = self.stage::<MAY_BEND>(method, 3, follow);
        }
        mass
    }

    /// Runs all stages in a loop. `MAY_BEND` means that some springs may be nonlinear.
    #[inline(always)]
    fn run<const MAY_BEND: bool>(&mut self, method: &Tableau, follow: &mut impl Follow<T>) -> Mass {
        let mut mass = self.start;
        for index in 0..method.stages {
            mass = self.stage::<MAY_BEND>(method, index, follow);
        }
        mass
    }

    /// Runs all stages with springs that may be nonlinear, compiled once for all callers.
    #[inline(never)]
    fn run_apart(&mut self, method: &Tableau, follow: &mut impl Follow<T>) -> Mass {
        self.run::<true>(method, follow)
    }

    /// Runs one stage. `MAY_BEND` means that some springs may be nonlinear.
    #[inline(always)]
    fn stage<const MAY_BEND: bool>(&mut self, method: &Tableau, index: usize, follow: &mut impl Follow<T>) -> Mass {
        let e = &self.elements.paths.series_compliance;
        let (Some(row), Some(place)) = (method.weights.get(index), method.c.get(index)) else {
            return self.start;
        };
        let g = method.gamma * self.h;
        let mass_rate = e.mass * (method.per_gamma * self.per_h);
        let resistance = mass_rate + e.damping + g * e.stiffness;
        let last = index + 1 == method.stages;
        let point =
            if last && self.ends_step { self.path.last() } else { self.path.point(self.theta + place * self.part) };
        let mut known = [self.start.x, self.start.v];
        for (a, gain) in row.iter().zip(&self.gains).take(index) {
            known = pair(|k| known[k] + a * gain[k]);
        }
        let [known_x, known_v] = known;
        let inner_at = within_reach(known_x + g * self.predicted, point.x);
        let (side_force, temperature) = self.side;
        let at = OperatingPoint { displacement: inner_at, velocity: self.predicted, side_force, temperature };
        let inner = if MAY_BEND { self.elements.inner(&at) } else { self.elements.linear_force(&at) };
        // The spring force F_p is linearized about x̂ = `inner_at`, with X = `known_x`. Then F_p(X + g u) ≈ F_p(x̂) +
        // F_p' (X + g u − x̂) = known part + (g F_p' + ∂F_p/∂v) u.
        let inner_known = inner.force + inner.d_force_d_x * (known_x - inner_at) - inner.d_force_d_v * self.predicted;
        let inner_derivative = inner.d_force_d_v + g * inner.d_force_d_x;
        let a = resistance + inner_derivative;
        let drive = e.stiffness * (point.x - known_x) + e.damping * point.v;
        let r = mass_rate * known_v + drive - inner_known;
        // After the three Householder steps of `solve`, the error of u is below the error of the integration method.
        let (mut u, mut fd) = self.primary.solve(self.elements, a, r);
        let (mut a, mut inner, mut inner_at) = (a, inner, inner_at);
        let (mut inner_known, mut inner_derivative) = (inner_known, inner_derivative);
        let mut line = Line::CONSTANT;
        let missed =
            |made: f64| (made - inner_known - inner_derivative * u).abs() > MISSED * (made.abs() + fd.value.abs());
        let is_nonlinear = MAY_BEND && self.elements.is_nonlinear();
        if is_nonlinear && missed(springs(self.elements, known_x + g * u, u, point.x, self.side).1) {
            let mut balance = Balance { u, fd, inner, inner_at, inner_known, inner_derivative };
            let held = Held { g, resistance, known: known_x, driven: point.x, r: r + inner_known };
            self.settle(&held, &mut balance);
            Balance { u, fd, inner, inner_at, inner_known, inner_derivative } = balance;
            a = resistance + inner_derivative;
            line.origin = LineOrigin::Solution;
        } else if is_nonlinear && inner_at != known_x + g * self.predicted {
            line.origin = LineOrigin::Reach;
        }
        if is_nonlinear && follow.wants_derivatives() {
            line.by_place =
                line_by_place(self.elements, &OperatingPoint { displacement: inner_at, ..at }, known_x + g * u);
        }
        let moved = g * u;
        if let Some(gain) = self.gains.get_mut(index) {
            *gain = [moved, u - known_v];
        }
        self.predicted = u;
        let x_m = known_x + moved;
        follow.stage(
            self.elements,
            &Stage {
                index,
                last,
                g,
                row,
                path: point,
                known_velocity: known_v,
                x_m,
                u,
                denominator: g * (a + fd.derivative),
                resistance: a + fd.derivative,
                inner,
                inner_at,
                by_guess: 0.0,
                guess_by_end: [0.0; 2],
                line,
            },
        );
        Mass { x: x_m, v: u, primary: fd.value, inner: inner_known + inner_derivative * u }
    }
}

/// Solution of a stage: the velocity of the mass, the FV curve at this velocity, and the linearized springs.
struct Balance {
    u: f64,
    fd: Value,
    inner: Response,
    inner_at: f64,
    /// The linearized spring force is `inner_known` + `inner_derivative` u, with the velocity u of the mass.
    inner_known: f64,
    inner_derivative: f64,
}

/// Quantities of a stage that stay constant while its nonlinear springs are linearized again.
struct Held {
    g: f64,
    resistance: f64,
    /// Known part of the mass's displacement in the stage, m.
    known: f64,
    /// Displacement of the moving end, m.
    driven: f64,
    /// The right side r of the stage equation a u + F_d(u) = r, N, without the springs on the mass.
    r: f64,
}

/// Largest error of the springs' linearization, relative to the forces on the mass, at which a stage is accepted.
///
/// It equals the error limit of the automatic choice of the method, a thousandth. A larger value would accept forces
/// that the springs cannot have.
const MISSED: f64 = 1e-3;
/// Additional allowed residual of the force balance on the mass, relative to its right side, for rounding errors of
/// large forces that cancel.
const ROUNDING: f64 = 1e-12;
/// Largest number of iterations of a stage with nonlinear springs. After [`PATIENCE`] of them, every other iteration
/// bisects the bracket of the velocity.
const ITERATIONS: usize = 60;
const PATIENCE: usize = 6;

impl<T: Tables, P: Primary> Substep<'_, T, P> {
    /// Solves a stage with nonlinear springs.
    ///
    /// The linearization about the predicted position is inaccurate beyond the next point of a lookup table. It is also
    /// inaccurate for a cubic or quartic spring far from zero displacement. With the wrong force, the mass would
    /// overshoot.
    ///
    /// The spring force rises with displacement and the FV curve rises with velocity. The residual of the force balance
    /// therefore rises with the mass's velocity u, and its sign shortens a bracket of u. Bisection replaces a solution
    /// outside the bracket, and every other solution after [`PATIENCE`] iterations.
    #[inline(never)]
    fn settle(&self, held: &Held, balance: &mut Balance) {
        let Held { g, resistance, known, driven, r } = *held;
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for round in 0..ITERATIONS {
            let Balance { u, fd, .. } = *balance;
            let (inner, held, at) = springs(self.elements, known + g * u, u, driven, self.side);
            let derivative = inner.d_force_d_v + g * inner.d_force_d_x;
            *balance = Balance {
                u,
                fd,
                inner,
                inner_at: at,
                inner_known: held - derivative * u,
                inner_derivative: derivative,
            };
            let left = resistance * u + held + fd.value - r;
            if left.abs() <= MISSED * (held.abs() + fd.value.abs()) + ROUNDING * r.abs() {
                break;
            }
            if left > 0.0 {
                high = u;
            } else {
                low = u;
            }
            (balance.u, balance.fd) =
                self.primary.solve(self.elements, resistance + derivative, r - balance.inner_known);
            let inside = balance.u > low && balance.u < high;
            let halved = round >= PATIENCE && round % 2 == 0 && low.is_finite() && high.is_finite();
            if !inside || halved {
                balance.u = if low.is_finite() && high.is_finite() { 0.5 * (low + high) } else { u };
                balance.fd = self.primary.evaluate(self.elements, balance.u);
            }
        }
    }
}

impl<'a, T: Tables, P: Primary> Substep<'a, T, P> {
    /// Makes the substep that starts at the fraction `theta` of the step and has the length `part`.
    #[inline(always)]
    fn new(drive: &Drive<'a, T, P>, theta: f64, part: f64, ends_step: bool, start: Mass) -> Substep<'a, T, P> {
        let h = drive.path.length() * part;
        Substep {
            elements: drive.elements,
            primary: drive.primary,
            path: drive.path,
            theta,
            part,
            ends_step,
            h,
            per_h: 1.0 / h,
            side: drive.side,
            start,
            predicted: start.v,
            gains: [[0.0; 2]; MOST_STAGES],
        }
    }
}

/// Inputs of the internal mass during a step.
#[derive(Clone, Copy)]
pub(super) struct Drive<'a, T: Tables, P> {
    pub elements: &'a Elements<T>,
    pub primary: P,
    pub path: &'a Path,
    pub side: (f64, f64),
}

/// Moves the internal mass in one substep over the whole path of the moving end, by a method of up to four stages.
#[inline(always)]
pub(super) fn move_mass_at_once<T: Tables, const MAY_BEND: bool>(
    method: &Tableau,
    drive: &Drive<T, impl Primary>,
    mass: Mass,
    follow: &mut impl Follow<T>,
) -> Mass {
    Substep::new(drive, 0.0, 1.0, true, mass).written_out::<MAY_BEND>(method, follow)
}

/// Moves the internal mass in all substeps over the whole path of the moving end.
#[inline(always)]
pub(super) fn move_mass<T: Tables>(
    method: &Tableau,
    drive: &Drive<T, impl Primary>,
    substeps: u32,
    mass: Mass,
    follow: &mut impl Follow<T>,
) -> Mass {
    let Drive { elements, ref primary, path, side } = *drive;
    if method.along_lines {
        return move_mass_cheaply(drive, substeps, mass, follow);
    }
    if elements.is_nonlinear() || !primary.is_plain() {
        return move_mass_apart(method, drive, substeps, mass, follow);
    }
    let drive = Drive { elements, primary: Plain, path, side };
    match method.stages {
        2 => in_two_stages(&drive, substeps, mass, follow),
        3 => in_three_stages(&drive, substeps, mass, follow),
        4 => in_four_stages(&drive, substeps, mass, follow),
        _ => in_substeps(substeps, mass, |theta, part, last, mass| {
            Substep::new(&drive, theta, part, last, mass).run::<false>(method, follow)
        }),
    }
}

/// Takes substeps of two stages in an unrolled loop. With the tableau as a variable instead of a constant, the substeps
/// take 12 % longer. The method of five stages has no unrolled loop, because a plain step uses it only on request.
#[inline(never)]
fn in_two_stages<T: Tables>(drive: &Drive<T, Plain>, substeps: u32, mass: Mass, follow: &mut impl Follow<T>) -> Mass {
    in_substeps(substeps, mass, |theta, part, last, mass| {
        Substep::new(drive, theta, part, last, mass).written_out::<false>(&SECOND, follow)
    })
}

/// Takes substeps of three stages: see [`in_two_stages`].
#[inline(never)]
fn in_three_stages<T: Tables>(drive: &Drive<T, Plain>, substeps: u32, mass: Mass, follow: &mut impl Follow<T>) -> Mass {
    in_substeps(substeps, mass, |theta, part, last, mass| {
        Substep::new(drive, theta, part, last, mass).written_out::<false>(&THREE_STAGE, follow)
    })
}

/// Takes substeps of four stages: see [`in_two_stages`].
#[inline(never)]
fn in_four_stages<T: Tables>(drive: &Drive<T, Plain>, substeps: u32, mass: Mass, follow: &mut impl Follow<T>) -> Mass {
    in_substeps(substeps, mass, |theta, part, last, mass| {
        Substep::new(drive, theta, part, last, mass).written_out::<false>(&THIRD, follow)
    })
}

/// Runs [`move_mass`] for nonlinear springs or a fading curve. A separate function, so that other dampers have no extra
/// cost.
#[inline(never)]
fn move_mass_apart<T: Tables>(
    method: &Tableau,
    drive: &Drive<T, impl Primary>,
    substeps: u32,
    mass: Mass,
    follow: &mut impl Follow<T>,
) -> Mass {
    in_substeps(substeps, mass, |theta, part, last, mass| {
        Substep::new(drive, theta, part, last, mass).run_apart(method, follow)
    })
}

/// Takes all substeps in sequence. `take` receives start and length of the substep as fractions of the step, and
/// whether the substep is the last one.
#[inline(always)]
fn in_substeps(substeps: u32, mut mass: Mass, mut take: impl FnMut(f64, f64, bool, Mass) -> Mass) -> Mass {
    let part = 1.0 / substeps as f64;
    let mut theta = 0.0;
    for left in (0..substeps).rev() {
        mass = take(theta, part, left == 0, mass);
        theta += part;
    }
    mass
}

/// Runs [`move_mass`] by cheap steps ([`cheap`]), and by backward Euler where their linearization is too inaccurate.
#[inline(never)]
fn move_mass_cheaply<T: Tables>(
    drive: &Drive<T, impl Primary>,
    substeps: u32,
    mut mass: Mass,
    follow: &mut impl Follow<T>,
) -> Mass {
    let (elements, path) = (drive.elements, drive.path);
    let part = 1.0 / substeps as f64;
    let h = path.length() * part;
    let mut from = path.point(0.0);
    for sub in 1..=substeps {
        let last = sub == substeps;
        let to = if last { path.last() } else { path.point(sub as f64 * part) };
        let before = cheap::Before { x: mass.x, v: mass.v, gain: to.v - from.v, h, side: drive.side };
        let at = before.springs_at(&to);
        let (inner, inner_at) = (elements.inner(&at), at.displacement);
        let after = cheap::take(elements, &before, &to, inner_at, inner);
        if !(after.holds() && after.springs_hold(elements, &to, drive.side)) {
            mass = Substep::new(drive, (sub - 1) as f64 * part, part, last, mass).run_apart(&EULER, follow);
            from = to;
            continue;
        }
        let denominator = 1.0 / after.by_impulse;
        let mut line = Line::CONSTANT;
        if elements.is_nonlinear() && follow.wants_derivatives() {
            line.by_place = line_by_place(elements, &at, after.x);
            if at.displacement != mass.x + h * mass.v {
                line.origin = LineOrigin::Reach;
            }
        }
        follow.stage(
            elements,
            &Stage {
                index: 0,
                last: true,
                g: h,
                row: &[],
                path: to,
                known_velocity: mass.v,
                x_m: after.x,
                u: after.v,
                denominator,
                resistance: denominator / h,
                inner,
                inner_at,
                by_guess: after.by_guess,
                guess_by_end: pair(|k| to.v_by_end[k] - from.v_by_end[k]),
                line,
            },
        );
        mass = Mass { x: after.x, v: after.v, primary: after.primary, inner: after.spring };
        from = to;
    }
    mass
}
