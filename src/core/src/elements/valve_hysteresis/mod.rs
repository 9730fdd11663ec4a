//! Valve hysteresis: a blow-off valve that opens late and closes late.

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

/// F_h = F (1 + η (y_∞(F) − y)), τ dy/dt = S((|F| − F_0 + Δ (2y − 1))/b) − y, y_∞ = S((|F| − F_0)/b).
///
/// y is the valve's opening, S = ½ (1 + tanh) its characteristic. The FV curve holds the opening y_∞; a valve that is
/// behind it makes the force larger while it opens, and smaller while it closes. It opens at F_0 + Δ and closes at
/// F_0 − Δ however slow the motion.
///
/// *Play* and *spool*: the valve stands where a force p had it, and passes oil there as an orifice does,
///
/// ```text
/// F_h g(h(p)) = F g(h(F)),   g(h) = W(h)²/h,   h(x) = F_0 + ½ (x − F_0 + √((x − F_0)² + b²))
/// ```
///
/// All forces are counted from that at standstill. W(h) is the velocity at which the FV curve has the force h, so g is what
/// the whole passage conducts; below the opening force F_0 it is shut, over b it opens; one that is shut still lets a
/// hundredth through. Forces against the stroke leave it shut. The pressure F_h moves it: with play, p follows by a play of P
/// beyond which it takes the time τ, τ dp/dt = ⟨|F_h − p| − P |F_h|/(|F_h| + P)⟩ sgn(F_h − p); a spool has mass,
/// τ² d²p/dt² + 2 ζ τ dp/dt + p = F_h.
#[derive(Clone, Copy, Debug)]
pub struct ValveHysteresis<T: Tables = Owned> {
    form: Form,
    play: f64,
    /// ζ.
    damping: f64,
    share: f64,
    middle: f64,
    half_width: f64,
    per_width: f64,
    pub(crate) per_time: f64,
    conductance: T::Conductance,
}

/// How it is late.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Opening,
    Play,
    Spool,
}

/// What it answers, as numbers that may be differentiated by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Late<R> {
    /// F_h.
    pub force: R,
    /// The opening y, or the force p.
    pub stands: R,
    /// The velocities W(h(F)) and W(h(p)).
    pub read: [f64; 2],
}

/// What the passage conducts where the valve stands.
#[derive(Clone, Copy)]
struct Passage {
    /// g(h(x)).
    g: f64,
    /// h.
    h: f64,
    /// Slope of g over x.
    d_force_d_x: f64,
}

/// Most rounds in which opening and what it feeds back on itself are brought together.
const ITERATIONS: usize = 4;
/// P_0, N.
const SOFT: f64 = 10.0;
/// Substep over τ from which play is taken at once.
const LONG: f64 = 1.0;
/// Share of the oil that finds its way through a valve that is shut: late valves make at most a hundred times the force.
const LEAKS: f64 = 0.01;
/// Most steps in which F_h is found, and the relative step that is the last: it leaves the square of it.
const STEPS: usize = 60;
const CLOSE: f64 = 1e-7;
/// Force, N, below which the valve makes nothing late.
const NOTHING: f64 = 1e-9;
/// Share of the force by which a valve stands apart from where that has it, at least: below it the difference is rounding.
const STEADY: f64 = 1e-12;
/// What a round may leave of the last so that three, and two, rounds do.
const SHRINKS: [f64; 2] = [0.06, 2e-3];

impl Describe for ValveHysteresis {
    const MEANING: &'static str = "blow-off valve that opens late and closes late: more force while speed rises";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "valve_hysteresis_share",
            "-",
            &[0.15],
            (0.0, 1.0),
            "opening form: share of the force that lateness adds, eta",
        )
        .in_form("valve_form", &["opening"]),
        Parameter::scalar("valve_opening_force", "N", &[600.0], (1.0, 1e5), "force at which the valve opens"),
        Parameter::scalar(
            "valve_closing_ratio",
            "-",
            &[0.85],
            (0.3, 1.0),
            "opening form: force at which it closes over that at which it opens; 1: the time alone makes it late",
        )
        .in_form("valve_form", &["opening"]),
        Parameter::scalar(
            "valve_time",
            "s",
            &[2e-3],
            (1e-4, 1.0),
            "time in which it moves, tau; spool: over 2 pi that of its swing",
        ),
        Parameter::scalar("valve_width", "N", &[100.0], (10.0, 1e5), "force over which it opens, b"),
        Parameter::choice(
            "valve_form",
            &["opening", "play", "spool"],
            "one opening that comes and goes late, or a valve that lags at every opening by friction or by its mass",
        ),
        Parameter::scalar("valve_play", "N", &[0.0], (0.0, 1e4), "play form: force that the valve does not follow, P")
            .in_form("valve_form", &["play"]),
        Parameter::scalar("valve_damping", "-", &[0.7], (0.05, 10.0), "spool form: damping ratio, zeta")
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
        Ok(ValveHysteresis::of(p, Conductance::UNSET))
    }

    fn check(_: &View<Self>) -> Result<(), Fault> {
        // The bounds of its numbers are all that it asks for.
        Ok(())
    }
}

impl<T: Tables> ValveHysteresis<T> {
    /// From the parameters, with a passage whose conductance is kept there.
    pub(crate) fn of(p: &View<ValveHysteresis>, conductance: T::Conductance) -> Self {
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

    /// Force from which on the conductance is tabulated, N.
    pub(crate) fn tabulated_from(&self) -> f64 {
        self.middle
    }

    /// Borrows the conductance of the passage.
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

    /// What its passage conducts.
    pub(crate) fn conductance(&self) -> &T::Conductance {
        &self.conductance
    }
}

/// S.
#[inline(always)]
fn opening<R: Real>(x: R) -> R {
    (x.tanh().plus(1.0)) * 0.5
}

impl ValveHysteresis {
    /// Reads what its passage conducts off the FV curve.
    pub(crate) fn join(&mut self, curve: &FvCurve) {
        if self.form != Form::Opening {
            self.conductance.set(curve, self.middle);
        }
    }
}

impl<T: Tables> ValveHysteresis<T> {
    /// Whether its state is the force at which it stands, and not an opening.
    pub(crate) fn holds_force(&self) -> bool {
        self.form != Form::Opening
    }

    /// Whether it has mass, and with it a second state: its rate times τ, N.
    #[inline(always)]
    pub(crate) fn is_spool(&self) -> bool {
        self.form == Form::Spool
    }

    /// Where its state lies: an opening between shut and open.
    #[inline(always)]
    pub(crate) fn range(&self) -> (f64, f64) {
        if self.form == Form::Opening { (0.0, 1.0) } else { (f64::NEG_INFINITY, f64::INFINITY) }
    }

    /// Opening form: what the opening is drawn to.
    #[inline(always)]
    fn target<R: Real>(&self, force: R, y: R) -> R {
        let pressed = force.abs() + y * (2.0 * self.half_width);
        opening(pressed.plus(-self.middle - self.half_width) * self.per_width)
    }

    /// Opening form: the opening at the end of an implicit stage that is `known` at its start; inside 0 to 1 as that is.
    #[inline(always)]
    fn opened<R: Real>(&self, force: R, known: R, g: f64) -> R {
        let per = g * self.per_time;
        let divide = 1.0 / (1.0 + per);
        // The characteristic is nowhere steeper than ½.
        let shrinks = self.half_width * self.per_width * per * divide;
        let spared = SHRINKS.iter().filter(|enough| shrinks < **enough).count();
        let rounds = if shrinks > 0.0 { ITERATIONS - spared } else { 1 };
        let mut y = known;
        for _ in 0..rounds {
            y = (known + self.target(force, y) * per) * divide;
        }
        y
    }

    /// Opening form: F_h at an opening.
    #[inline(always)]
    fn at_opening<R: Real>(&self, force: R, y: R) -> R {
        let steady = opening(force.abs().plus(-self.middle) * self.per_width);
        force * ((steady - y) * self.share).plus(1.0)
    }

    /// Play form: ⟨y⟩ sgn(F − p) at the end of a stage that p begins at.
    ///
    /// y = |F − p| − P |F|/(|F| + P), `per` is g/τ, and ⟨y⟩ = y²/(y + P_0) begins smoothly.
    #[inline(always)]
    fn beyond<R: Real>(&self, force: R, p: R, per: f64) -> R {
        let behind = force - p;
        let size = force.abs();
        let play = size * size.plus(self.play + 1e-9).inverse() * self.play;
        let y = behind.abs() - play;
        if y.value() <= 0.0 {
            return R::constant(0.0);
        }
        // x = y − (g/τ) ⟨x⟩: what is left of y when the stage ends.
        let half = y.plus(-SOFT) * 0.5;
        let root = (half * half + y * ((1.0 + per) * SOFT)).sqrt();
        let left = (half + root) * (1.0 / (1.0 + per));
        let moved = left * left * left.plus(SOFT).inverse();
        if behind.value() < 0.0 { -moved } else { moved }
    }

    /// Whether a substep of length `h` moves the valve from its start to each stage directly.
    ///
    /// Otherwise play would store the stages of a long step, which go to and fro.
    #[inline(always)]
    pub(crate) fn jumps(&self, h: f64) -> bool {
        self.form == Form::Play && h * self.per_time > LONG
    }

    /// The known part of a stage, from those of its states: a number that the force alone has to be added to.
    #[inline(always)]
    pub(crate) fn known(&self, stands: f64, rate: f64, g: f64) -> f64 {
        if !self.is_spool() {
            return stands;
        }
        let per = g * self.per_time;
        stands * (1.0 + 2.0 * self.damping * per) + per * rate
    }

    /// p at the end of an implicit stage at whose end the force is `force`.
    #[inline(always)]
    fn follows<R: Real>(&self, force: R, known: R, g: f64) -> R {
        let per = g * self.per_time;
        if self.is_spool() {
            let square = per * per;
            return (known + force * square) * (1.0 / (1.0 + 2.0 * self.damping * per + square));
        }
        known + self.beyond(force, known, per) * per
    }

    /// What the passage conducts where a force has the valve stand that is x along the stroke, which has the sign `stroke`.
    #[inline(always)]
    fn conducts(&self, curve: &impl ForceLaw, x: f64, stroke: f64) -> Passage {
        let beyond = x - self.middle;
        let width = 1.0 / self.per_width;
        let root = libm::sqrt(beyond * beyond + width * width);
        let h = self.middle + 0.5 * (beyond + root);
        let at = self.conductance.conducted(curve, h, stroke);
        Passage { g: at.g, h, d_force_d_x: 0.5 * (1.0 + beyond / root) * at.by_h }
    }

    /// Increase of F by a valve at p, with its derivative over the ratio of the conductances of the passage at F and
    /// at p.
    ///
    /// `widens` is the derivative of that ratio over the force along the stroke, at p.
    #[inline(always)]
    fn raises(&self, force: f64, p: f64, ratio: f64, widens: f64) -> (f64, f64) {
        let ahead = (force - p) * force;
        // Where it stands where F has it, rounding would choose.
        let opens = if ahead.abs() <= STEADY * force * force { widens > 0.0 } else { (ratio > 1.0) == (ahead > 0.0) };
        // Where the FV curve rises by more than the square no valve opens.
        if !opens {
            return (1.0, 0.0);
        }
        let divide = 1.0 / (1.0 + LEAKS * ratio);
        (ratio * (1.0 + LEAKS) * divide, (1.0 + LEAKS) * divide * divide)
    }

    /// F_h, and where the valve stands, after an implicit stage. `raised` is F_h/F where it was solved last, and is solved
    /// from there.
    #[inline(always)]
    pub(crate) fn stage(
        &self,
        curve: &impl ForceLaw,
        force: f64,
        known: f64,
        g: f64,
        raised: &Cell<f64>,
    ) -> Late<Dual<4>> {
        let (before, from) = (Dual::<4>::along(force, 0), Dual::along(known, 1));
        if self.form == Form::Opening {
            let stands = self.opened(before, from, g);
            return Late { force: self.at_opening(before, stands), stands, read: [0.0; 2] };
        }
        let (late, now) = self.stage_by_force(curve, force, known, g, raised.get());
        raised.set(now);
        late
    }

    /// Stage of a valve at the position of a given force; separate, so that the more common case does not pay for it.
    #[cold]
    #[inline(never)]
    fn stage_by_force(
        &self,
        curve: &impl ForceLaw,
        force: f64,
        known: f64,
        g: f64,
        raised: f64,
    ) -> (Late<Dual<4>>, f64) {
        let (before, from) = (Dual::<4>::along(force, 0), Dual::along(known, 1));
        if force.abs() < NOTHING {
            return (Late { force: before, stands: self.follows(before, from, g), read: [0.0; 2] }, raised);
        }
        let stroke = if force < 0.0 { -1.0 } else { 1.0 };
        let steady = self.conducts(curve, force * stroke, stroke);
        // F_h is F through the valve that F_h itself moves. The more it opens the less it makes, so there is one answer:
        // Newton's steps in the logarithm of its size.
        let mut found = force * raised;
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut left = STEPS;
        loop {
            let p = self.follows(Dual::<2>::along(found, 0), Dual::along(known, 1), g);
            let now = self.conducts(curve, p.value * stroke, stroke);
            let ratio = steady.g / now.g;
            let (by, derivative) = self.raises(force, p.value, ratio, now.d_force_d_x);
            let late = force * by;
            // ∂F_h over what the passage conducts at F, and at p.
            let (by_steady, by_now) = (force * derivative / now.g, -force * derivative * ratio / now.g);
            let by_p = by_now * now.d_force_d_x * stroke;
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
                    // Beside the end of the play the derivative is that of the other side.
                    next = 0.5 * (low + high);
                }
                found = next * stroke;
                continue;
            }
            // So close that the last step goes straight.
            let on = found * step;
            let per = 1.0 / (1.0 - by_p * p.derivative(0));
            let [(first, steady_by), (second, now_by)] = [steady, now].map(|at| by_raised(curve, at.g, at.h, stroke));
            let derivatives = [
                (by + by_steady * steady.d_force_d_x * stroke) * per,
                by_p * p.derivative(1) * per,
                by_steady * steady_by * per,
                by_now * now_by * per,
            ];
            let stands = derivatives.map(|s| p.derivative(0) * s);
            let late = Late {
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

    /// F_h at given states, and the rates of these: `stands` and, for a spool, its rate times τ.
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
        let ratio = force.chain(steady.g, steady.d_force_d_x * stroke)
            * stands.chain(now.g, now.d_force_d_x * stroke).inverse();
        let (by, derivative) = self.raises(f, p, ratio.value(), now.d_force_d_x);
        let late = force * ratio.chain(by, derivative);
        if self.is_spool() {
            let pushed = late - stands - rate * (2.0 * self.damping);
            return (late, [rate * self.per_time, pushed * self.per_time]);
        }
        (late, [self.beyond(late, stands, 0.0) * self.per_time, none])
    }

    /// Where it comes to rest under a steady force, from where it stands.
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
