//! Valve hysteresis: a blow-off valve that opens and closes with a lag.

mod conductance;

use crate::dual::{Dual, Real};
use crate::element::Prepare;
use crate::elements::fv_curve::FvCurve;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};
use crate::tables::{Conduction, ForceLaw, Owned, Tables};
use conductance::by_raised;
pub(crate) use conductance::{Conductance, tabulated};
use core::cell::Cell;

/// Lagging blow-off valve, which changes the force F, N, of the FV curve to F_h, in three forms. F_h is called the
/// force behind the valve.
///
/// *Opening*: F_h = F (1 + η (y_∞(F) − y)), τ dy/dt = S((|F| − F_0 + Δ (2y − 1))/b) − y, y_∞ = S((|F| − F_0)/b).
///
/// y is the valve's opening, from 0 to 1, and τ its time constant. η is the fraction of the force that the lag can add.
/// S = ½ (1 + tanh) is the characteristic, and b its width, N. The FV curve includes the steady opening y_∞. A valve
/// whose opening lags behind y_∞ increases the force while opening, and reduces the force while closing. Even in slow
/// motion, it opens at F_0 + Δ and closes at F_0 − Δ: F_0 is the mean of both forces, Δ half their difference.
///
/// *Play* and *spool*: the valve has the position that it would have in the steady state under a force p, and acts as
/// an orifice:
///
/// ```text
/// F_h g(h(p)) = F g(h(F)),   g(h) = W(h)²/h,   h(x) = F_0 + ½ (x − F_0 + √((x − F_0)² + b²))
/// ```
///
/// All forces are relative to the force at standstill. W(h) is the velocity at which the FV curve has the force h. So
/// g, velocity squared per force, m²/(N s²), is the quadratic conductance of the whole passage. In these forms F_0 is
/// the opening force: below it the valve is closed, and it opens over the width b. The leakage of a closed valve limits
/// F_h to 101 F. A force against the stroke does not open the valve. The force F_h moves the valve. With play, p
/// follows F_h beyond the play P, with the time constant τ. The law is τ dp/dt = ⟨|F_h − p| − P |F_h|/(|F_h| + P)⟩
/// sgn(F_h − p). ⟨x⟩ is x²/(x + P_0) for a positive x and 0 otherwise, with P_0 = 10 N. A spool has mass, so p
/// oscillates with the damping ratio ζ: τ² d²p/dt² + 2 ζ τ dp/dt + p = F_h.
#[derive(Clone, Copy, Debug)]
pub struct ValveHysteresis<T: Tables = Owned> {
    form: Form,
    play: f64,
    /// Damping ratio ζ of the spool.
    damping: f64,
    share: f64,
    middle: f64,
    half_width: f64,
    per_width: f64,
    pub(crate) per_time: f64,
    conductance: T::Conductance,
}

/// Form of the valve, by the cause of its lag: time of opening, friction (play), or mass (spool).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Opening,
    Play,
    Spool,
}

/// Force behind the valve and state of the valve, as numbers that may carry derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ValveResponse<R> {
    /// Force F_h behind the lagging valve, N.
    pub force: R,
    /// Opening y in the opening form. In the play and spool forms, the force p, N, under which the valve's position
    /// would be steady.
    pub stands: R,
    /// The two velocities, m/s, at which the FV curve was evaluated for the conductances at the forces F and p; 0 in
    /// the opening form.
    pub read: [f64; 2],
}

/// Conductance of the passage with the valve in its steady position under a force x, N.
#[derive(Clone, Copy)]
struct Passage {
    /// Conductance g, m²/(N s²).
    g: f64,
    /// Force h(x), N, with which the conductance is read: x with a smooth lower limit at the opening force.
    h: f64,
    /// Derivative of the conductance with respect to the force x.
    d_g_d_x: f64,
}

/// Largest number of fixed-point iterations for the opening y, whose target depends on y itself.
const ITERATIONS: usize = 4;
/// Force beyond the play, N, over which the motion of a valve with play begins smoothly.
const SOFT: f64 = 10.0;
/// Largest length of a substep, relative to the valve's time constant, at which the stages of a valve with play build
/// on each other. In a longer substep, each stage computes the state directly from the start of the substep.
const LONG: f64 = 1.0;
/// Leakage of the valve: its quadratic conductance, relative to that of the passage with the valve in its steady
/// position under F. It limits F_h to 101 F.
const LEAKS: f64 = 0.01;
/// Largest number of Newton steps or bisections for the force F_h behind the valve.
const STEPS: usize = 60;
/// Newton step for the force F_h behind the valve, relative to F_h, at or below which the iteration ends. The remaining
/// relative error is about the square of this step.
const CLOSE: f64 = 1e-7;
/// Force, N, below which the lag of the valve is neglected.
const NOTHING: f64 = 1e-9;
/// Largest relative difference between the FV force and the force p of the valve's position that counts as a rounding
/// error. The valve is then in its steady position.
const STEADY: f64 = 1e-12;
/// Contraction factors of the iteration for the opening: below the first, three iterations suffice; below the second,
/// two.
const SHRINKS: [f64; 2] = [0.06, 2e-3];

impl Describe for ValveHysteresis {
    const MEANING: &'static str = "blow-off valve that opens and closes with a lag: higher force while the speed rises";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "valve_hysteresis_share",
            "-",
            &[0.15],
            (0.0, 1.0),
            "opening form: largest force that the lag adds, as a fraction of the FV force, eta",
        )
        .in_form("valve_form", &["opening"]),
        Parameter::scalar("valve_opening_force", "N", &[600.0], (1.0, 1e5), "force at which the valve opens"),
        Parameter::scalar(
            "valve_closing_ratio",
            "-",
            &[0.85],
            (0.3, 1.0),
            "opening form: ratio of the closing force to the opening force; 1: lag by the time constant alone",
        )
        .in_form("valve_form", &["opening"]),
        Parameter::scalar(
            "valve_time",
            "s",
            &[2e-3],
            (1e-4, 1.0),
            "time constant of the valve motion, tau; spool form: natural period over 2 pi",
        ),
        Parameter::scalar("valve_width", "N", &[100.0], (10.0, 1e5), "force range over which the valve opens, b"),
        Parameter::choice(
            "valve_form",
            &["opening", "play", "spool"],
            "one opening that lags, or a valve whose position lags at every force, by friction or by its mass",
        ),
        Parameter::scalar(
            "valve_play",
            "N",
            &[0.0],
            (0.0, 1e4),
            "play form: change of force that does not move the valve (friction), P",
        )
        .in_form("valve_form", &["play"]),
        Parameter::scalar("valve_damping", "-", &[0.7], (0.05, 10.0), "spool form: damping ratio of the valve, zeta")
            .in_form("valve_form", &["spool"]),
    ];
}

impl Prepare for ValveHysteresis {
    const OFF: Self = ValveHysteresis {
        form: Form::Opening,
        play: 0.0,
        damping: 0.0,
        share: 0.0,
        middle: 0.0,
        half_width: 0.0,
        per_width: 0.0,
        per_time: 0.0,
        conductance: Conductance::UNSET,
    };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(ValveHysteresis::from_view(p, Conductance::UNSET))
    }

    fn check(_: &View<Self>) -> Result<(), Fault> {
        // The bounds of the single parameters exclude every error of the preparation.
        Ok(())
    }
}

impl<T: Tables> ValveHysteresis<T> {
    /// Makes the valve from the parameters `p`, with the given conductance of its passage.
    pub(crate) fn from_view(p: &View<ValveHysteresis>, conductance: T::Conductance) -> Self {
        let form = match p.number(own!("valve_form")) {
            1.0 => Form::Play,
            2.0 => Form::Spool,
            _ => Form::Opening,
        };
        let closing = if form == Form::Opening { p.number(own!("valve_closing_ratio")) } else { 1.0 };
        let (opens, closes) = (p.number(own!("valve_opening_force")), p.number(own!("valve_opening_force")) * closing);
        ValveHysteresis {
            form,
            play: p.number(own!("valve_play")),
            damping: p.number(own!("valve_damping")),
            share: p.number(own!("valve_hysteresis_share")),
            middle: 0.5 * (opens + closes),
            half_width: 0.5 * (opens - closes),
            per_width: 1.0 / p.number(own!("valve_width")),
            per_time: 1.0 / p.number(own!("valve_time")),
            conductance,
        }
    }

    /// Returns the force from which on the conductance is tabulated, N.
    pub(crate) fn tabulated_from(&self) -> f64 {
        self.middle
    }

    /// Returns this valve with another, possibly borrowed, conductance.
    pub(crate) fn with_conductance<U: Tables>(&self, conductance: U::Conductance) -> ValveHysteresis<U> {
        ValveHysteresis {
            form: self.form,
            play: self.play,
            damping: self.damping,
            share: self.share,
            middle: self.middle,
            half_width: self.half_width,
            per_width: self.per_width,
            per_time: self.per_time,
            conductance,
        }
    }

    /// Returns the conductance of the valve's passage: a table, or its replacement in a family.
    pub(crate) fn conductance(&self) -> &T::Conductance {
        &self.conductance
    }
}

/// Computes the characteristic of the valve, S(x) = ½ (1 + tanh x).
#[inline(always)]
fn opening<R: Real>(x: R) -> R {
    (x.tanh().plus(1.0)) * 0.5
}

impl ValveHysteresis {
    /// Fills the table of the passage's conductance from the FV curve, unless the valve has the opening form.
    pub(crate) fn join(&mut self, curve: &FvCurve) {
        if self.form != Form::Opening {
            self.conductance.set(curve, self.middle);
        }
    }
}

impl<T: Tables> ValveHysteresis<T> {
    /// Returns whether the state is a force p, N, as in the play and spool forms, instead of an opening.
    pub(crate) fn holds_force(&self) -> bool {
        self.form != Form::Opening
    }

    /// Returns whether the valve has mass and thus a second state: its time constant times the rate of its first state,
    /// N.
    #[inline(always)]
    pub(crate) fn is_spool(&self) -> bool {
        self.form == Form::Spool
    }

    /// Returns the range of the state. An opening ranges from 0, closed, to 1, open. The force of the other forms has
    /// no limits.
    #[inline(always)]
    pub(crate) fn range(&self) -> (f64, f64) {
        if self.form == Form::Opening { (0.0, 1.0) } else { (f64::NEG_INFINITY, f64::INFINITY) }
    }

    /// Returns the value toward which the opening `y` relaxes under the FV force `force`, N, in the opening form.
    #[inline(always)]
    fn target<R: Real>(&self, force: R, y: R) -> R {
        let pressed = force.abs() + y * (2.0 * self.half_width);
        opening(pressed.plus(-self.middle - self.half_width) * self.per_width)
    }

    /// Computes the opening y after an implicit stage of the opening form: y − g dy/dt equals `known`. `force` is the
    /// FV force, N, and `g` the weight of dy/dt in the stage, s. y and `known` lie between 0 and 1.
    #[inline(always)]
    fn opened<R: Real>(&self, force: R, known: R, g: f64) -> R {
        let per = g * self.per_time;
        let divide = 1.0 / (1.0 + per);
        // This is the contraction factor of the iteration: the derivative of the characteristic S is at most ½.
        let shrinks = self.half_width * self.per_width * per * divide;
        let spared = SHRINKS.iter().filter(|enough| shrinks < **enough).count();
        let rounds = if shrinks > 0.0 { ITERATIONS - spared } else { 1 };
        let mut y = known;
        for _ in 0..rounds {
            y = (known + self.target(force, y) * per) * divide;
        }
        y
    }

    /// Computes the force F_h behind the valve, N, from the FV force `force` at the opening `y`, in the opening form.
    #[inline(always)]
    fn at_opening<R: Real>(&self, force: R, y: R) -> R {
        let steady = opening(force.abs().plus(-self.middle) * self.per_width);
        force * ((steady - y) * self.share).plus(1.0)
    }

    /// Computes τ dp/dt, N, at the end of an implicit stage of the play form: ⟨y⟩ sgn(F − p).
    ///
    /// Here y = |F − p| − P |F|/(|F| + P) is the force beyond the play P, and ⟨y⟩ = y²/(y + P_0) begins smoothly. F is
    /// the force behind the valve, `p` the known part of the state, and `per` the weight g of the stage over τ.
    #[inline(always)]
    fn beyond<R: Real>(&self, force: R, p: R, per: f64) -> R {
        let behind = force - p;
        let size = force.abs();
        let play = size * size.plus(self.play + 1e-9).inverse() * self.play;
        let y = behind.abs() - play;
        if y.value() <= 0.0 {
            return R::constant(0.0);
        }
        // The remaining y at the end of the stage is the solution x of x = y − (g/τ) ⟨x⟩.
        let half = y.plus(-SOFT) * 0.5;
        let root = (half * half + y * ((1.0 + per) * SOFT)).sqrt();
        let left = (half + root) * (1.0 / (1.0 + per));
        let moved = left * left * left.plus(SOFT).inverse();
        if behind.value() < 0.0 { -moved } else { moved }
    }

    /// Returns whether each stage of a substep of length `h` computes the valve directly from the start of the substep.
    ///
    /// If the stages of a long substep built on each other, the play would preserve an oscillation from stage to stage.
    #[inline(always)]
    pub(crate) fn jumps(&self, h: f64) -> bool {
        self.form == Form::Play && h * self.per_time > LONG
    }

    /// Computes the part of the equation for p after an implicit stage that does not depend on the force, N. `stands`
    /// and `rate` are the known parts of p and of τ dp/dt, and `g` is the weight of the stage, s.
    #[inline(always)]
    pub(crate) fn known(&self, stands: f64, rate: f64, g: f64) -> f64 {
        if !self.is_spool() {
            return stands;
        }
        let per = g * self.per_time;
        stands * (1.0 + 2.0 * self.damping * per) + per * rate
    }

    /// Computes the valve's state p, N, after an implicit stage of weight `g`, s; `force` is the final force behind the
    /// valve, N.
    #[inline(always)]
    fn follows<R: Real>(&self, force: R, known: R, g: f64) -> R {
        let per = g * self.per_time;
        if self.is_spool() {
            let square = per * per;
            return (known + force * square) * (1.0 / (1.0 + 2.0 * self.damping * per + square));
        }
        known + self.beyond(force, known, per) * per
    }

    /// Computes the conductance of the passage with the valve in its steady position under the force `x`, N, along the
    /// stroke. `stroke` is 1 for rebound and −1 for compression.
    #[inline(always)]
    fn conducts(&self, curve: &impl ForceLaw, x: f64, stroke: f64) -> Passage {
        let beyond = x - self.middle;
        let width = 1.0 / self.per_width;
        let root = libm::sqrt(beyond * beyond + width * width);
        let h = self.middle + 0.5 * (beyond + root);
        let at = self.conductance.conducted(curve, h, stroke);
        Passage { g: at.g, h, d_g_d_x: 0.5 * (1.0 + beyond / root) * at.by_h }
    }

    /// Computes the factor by which the valve increases the FV force `force`, and the derivative of the factor with
    /// respect to `ratio`. The valve has its steady position under the force `p`.
    ///
    /// `ratio` is the conductance of the passage in the steady position under `force`, divided by that under `p`.
    /// `widens` is the derivative of the conductance at `p` with respect to the force along the stroke.
    #[inline(always)]
    fn raises(&self, force: f64, p: f64, ratio: f64, widens: f64) -> (f64, f64) {
        let ahead = (force - p) * force;
        // For equal forces, the sign of the difference is a rounding error, so the sign of the conductance's derivative
        // decides.
        let opens = if ahead.abs() <= STEADY * force * force { widens > 0.0 } else { (ratio > 1.0) == (ahead > 0.0) };
        // Where the FV curve rises faster than the square of the velocity, no valve opens.
        if !opens {
            return (1.0, 0.0);
        }
        let divide = 1.0 / (1.0 + LEAKS * ratio);
        (ratio * (1.0 + LEAKS) * divide, (1.0 + LEAKS) * divide * divide)
    }

    /// Computes the force F_h behind the valve and its state after an implicit stage. `force` is the FV force F, N,
    /// `known` the known part of the state, and `g` the weight of the stage, s. `raised` is F_h/F of the previous
    /// solution, which is also the initial guess.
    #[inline(always)]
    pub(crate) fn stage(
        &self,
        curve: &impl ForceLaw,
        force: f64,
        known: f64,
        g: f64,
        raised: &Cell<f64>,
    ) -> ValveResponse<Dual<4>> {
        let (before, from) = (Dual::<4>::along(force, 0), Dual::along(known, 1));
        if self.form == Form::Opening {
            let stands = self.opened(before, from, g);
            return ValveResponse { force: self.at_opening(before, stands), stands, read: [0.0; 2] };
        }
        let (late, now) = self.stage_by_force(curve, force, known, g, raised.get());
        raised.set(now);
        late
    }

    /// Computes the implicit stage of the play and spool forms, and the ratio F_h/F. It is a separate function, so that
    /// the opening form has no extra cost.
    #[cold]
    #[inline(never)]
    fn stage_by_force(
        &self,
        curve: &impl ForceLaw,
        force: f64,
        known: f64,
        g: f64,
        raised: f64,
    ) -> (ValveResponse<Dual<4>>, f64) {
        let (before, from) = (Dual::<4>::along(force, 0), Dual::along(known, 1));
        if force.abs() < NOTHING {
            return (ValveResponse { force: before, stands: self.follows(before, from, g), read: [0.0; 2] }, raised);
        }
        let stroke = if force < 0.0 { -1.0 } else { 1.0 };
        let steady = self.conducts(curve, force * stroke, stroke);
        // The valve increases the FV force F to F_h, and F_h moves the valve. A larger opening gives a smaller force,
        // so there is one solution. Newton steps use the logarithm of |F_h|.
        let mut found = force * raised;
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut left = STEPS;
        loop {
            let p = self.follows(Dual::<2>::along(found, 0), Dual::along(known, 1), g);
            let now = self.conducts(curve, p.value * stroke, stroke);
            let ratio = steady.g / now.g;
            let (by, derivative) = self.raises(force, p.value, ratio, now.d_g_d_x);
            let late = force * by;
            // Derivatives of F_h with respect to the conductances of the passage at the forces F and p.
            let (by_steady, by_now) = (force * derivative / now.g, -force * derivative * ratio / now.g);
            let by_p = by_now * now.d_g_d_x * stroke;
            let steep = 1.0 - found * by_p * p.derivative(0) / late;
            let off = late / found;
            let step = 2.0 * (off - 1.0) / ((off + 1.0) * if steep > 0.5 { steep } else { 0.5 });
            left -= 1;
            if step.abs() > CLOSE && left > 0 {
                let size = found.abs();
                (low, high) = if step > 0.0 { (size, high) } else { (low, size) };
                let held = step.clamp(-1.0, 1.0);
                let mut next = size * (2.0 + held) / (2.0 - held);
                if next <= low || next >= high {
                    // Near the end of the play, the derivative may belong to a force on the other side of this end.
                    // Bisection then replaces the Newton step.
                    next = 0.5 * (low + high);
                }
                found = next * stroke;
                continue;
            }
            // The last Newton step is small, so a linear correction by it suffices.
            let on = found * step;
            let per = 1.0 / (1.0 - by_p * p.derivative(0));
            let [(first, steady_by), (second, now_by)] = [steady, now].map(|at| by_raised(curve, at.g, at.h, stroke));
            let derivatives = [
                (by + by_steady * steady.d_g_d_x * stroke) * per,
                by_p * p.derivative(1) * per,
                by_steady * steady_by * per,
                by_now * now_by * per,
            ];
            let stands = derivatives.map(|s| p.derivative(0) * s);
            let late = ValveResponse {
                force: Dual::new(found + on, derivatives),
                stands: Dual::new(
                    p.value + p.derivative(0) * on,
                    [stands[0], stands[1] + p.derivative(1), stands[2], stands[3]],
                ),
                read: [first, second],
            };
            return (late, (found / force).clamp(0.1, 10.0));
        }
    }

    /// Computes the force F_h behind the valve, N, and the state derivatives at given states and the FV force `force`,
    /// N. The states are `stands` (the opening or the force p) and, for a spool, `rate` = τ dp/dt.
    #[inline(always)]
    pub(crate) fn now<R: Real>(&self, curve: &impl ForceLaw, force: R, [stands, rate]: [R; 2]) -> (R, [R; 2]) {
        let none = R::constant(0.0);
        if self.form == Form::Opening {
            let moved = self.target(force, stands) - stands;
            return (self.at_opening(force, stands), [moved * self.per_time, none]);
        }
        let (f, p) = (force.value(), stands.value());
        let stroke = if f < 0.0 { -1.0 } else { 1.0 };
        let [steady, now] = [f, p].map(|x| self.conducts(curve, x * stroke, stroke));
        let ratio =
            force.chain(steady.g, steady.d_g_d_x * stroke) * stands.chain(now.g, now.d_g_d_x * stroke).inverse();
        let (by, derivative) = self.raises(f, p, ratio.value(), now.d_g_d_x);
        let late = force * ratio.chain(by, derivative);
        if self.is_spool() {
            let pushed = late - stands - rate * (2.0 * self.damping);
            return (late, [rate * self.per_time, pushed * self.per_time]);
        }
        (late, [self.beyond(late, stands, 0.0) * self.per_time, none])
    }

    /// Returns the state toward which the valve moves under the constant FV force `force`, N. It is the target of the
    /// opening at `stands`, or p = `force` in the other forms.
    #[inline(always)]
    pub(crate) fn rests(&self, force: f64, stands: f64) -> f64 {
        if self.form == Form::Opening { self.target(force, stands) } else { force }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Curve, Interpolation};

    fn valve(form: Form) -> ValveHysteresis {
        let mut valve = ValveHysteresis {
            form,
            play: 80.0,
            damping: 0.6,
            share: 0.0,
            middle: 400.0,
            half_width: 0.0,
            per_width: 1.0 / 60.0,
            per_time: 1.0 / 2e-3,
            conductance: Conductance::UNSET,
        };
        valve.join(&curve());
        valve
    }

    fn curve() -> FvCurve {
        let v = [-1.5, -0.5, -0.1, 0.0, 0.1, 0.5, 1.5];
        let f = [-1500.0, -800.0, -400.0, 0.0, 700.0, 1300.0, 2200.0];
        FvCurve(Curve::new(&v, &f, Interpolation::MonotoneCubic).unwrap())
    }

    #[test]
    fn a_valve_that_stands_where_the_force_has_it_is_not_late() {
        for form in [Form::Play, Form::Spool] {
            for force in [-1800.0, -300.0, 20.0, 900.0, 3000.0] {
                let (late, rates) = valve(form).now(&curve(), force, [force, 0.0]);
                assert!((late - force).abs() < 1e-9 * force.abs());
                assert!(rates.iter().all(|r| r.abs() < 1e-6), "{rates:?}");
            }
        }
    }

    #[test]
    fn oil_through_a_valve_that_stands_still_is_that_through_an_orifice() {
        let (valve, curve) = (valve(Form::Spool), curve());
        let at = |w: f64| valve.now(&curve, curve.evaluate(w).value, [900.0, 0.0]).0;
        let ratio = at(0.5) / at(0.25);
        assert!((ratio - 4.0).abs() < 0.2, "four times the force for twice the flow: {ratio}");
    }

    #[test]
    fn a_stage_answers_its_equations_with_their_derivatives() {
        let curve = curve();
        for form in [Form::Play, Form::Spool] {
            let valve = valve(form);
            for (force, known) in [(900.0, 200.0), (1500.0, 1900.0), (-700.0, 300.0), (-1200.0, -500.0), (150.0, 100.0)]
            {
                let g = 4e-4;
                let late = valve.stage(&curve, force, known, g, &Cell::new(1.0));
                let p = valve.follows(late.force.value, known, g);
                let again = valve.now(&curve, force, [p, 0.0]).0;
                assert!((again - late.force.value).abs() < 1e-9 * force.abs(), "{form:?} {force}: {again}");
                let h = 1e-3;
                let of = |f: f64, k: f64| {
                    let late = valve.stage(&curve, f, k, g, &Cell::new(1.0));
                    [late.force.value, late.stands.value]
                };
                let ways = [(of(force + h, known), of(force - h, known)), (of(force, known + h), of(force, known - h))];
                for (k, (plus, minus)) in ways.into_iter().enumerate() {
                    for (exact, i) in [(late.force.derivative(k), 0), (late.stands.derivative(k), 1)] {
                        let seen = (plus[i] - minus[i]) / (2.0 * h);
                        assert!((exact - seen).abs() < 1e-5 * (1.0 + seen.abs()), "{form:?} {force}: {exact} {seen}");
                    }
                }
            }
        }
    }
}
