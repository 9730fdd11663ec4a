//! The hydraulic path: valve force from the oil velocity, and flow of the oil column from the force.

use super::Paths;
use super::STATES;
use super::acting::acts;
use super::bits::{AIR, FADE, LENGTH, POSITION, SELECTIVE, VALVE};
use super::place;
use crate::dual::{Dual, Real};
use crate::elements::soft_gap::SoftGap;
use crate::tables::Tables;
use core::cell::Cell;

/// Inputs of the hydraulic path at one instant, in SI units; the temperature is in °C.
#[derive(Clone, Copy, Debug)]
pub struct Around<R> {
    /// Displacement of the moving end, m.
    pub x: R,
    /// Velocity of the moving end, m/s.
    pub v: R,
    /// Side force that the host gives, N.
    pub side_force: f64,
    /// Temperature that the host gives, °C.
    pub temperature: f64,
}

/// Force of the valves, the target of the state of frequency-selective damping, and the valve's state derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Flow<R> {
    /// Force F_h of the valves, N.
    pub force: R,
    /// Value toward which the state of frequency-selective damping (filter and stroke forms) relaxes.
    pub selective_target: R,
    /// Force of the FV curve with its position and temperature factors, relative to that at standstill, N: before the
    /// lagging valve.
    pub before_valve: R,
    /// Time derivatives of the two states of the valve; 0 without a valve, and the second one 0 without mass.
    pub valve_rates: [R; 2],
}

/// Resistance, N s/m, added to the FV curve if there is an oil column. It makes the oil velocity at a given force
/// unique where the curve is horizontal. The resistance is far too small to be measured.
const LEAKAGE: f64 = 0.01;

/// Computes the hydraulic force F_h = N(s F_d(w)) at given states, where `curve` is the FV force F_d(w), N, at the oil
/// velocity `w`, m/s. N stands for the lagging valve and frequency-selective damping, and s is the product of the
/// factors for position and temperature.
///
/// `standing` is the FV curve's force at standstill. No flow causes it, so s and N do not change it.
#[inline(always)]
pub fn flow<R: Real>(
    e: &Paths<impl Tables>,
    curve: R,
    standing: R,
    w: R,
    around: &Around<R>,
    states: &[R; STATES],
) -> Flow<R> {
    let mut above = curve - standing;
    if e.has_position() {
        above = above * e.position_dependent_damping.factor(around.x, above.value() >= 0.0);
    }
    if e.has_fade() {
        above = e.temperature_fade.force(above, e.temperature_fade.factor(around.temperature, states[place::HEAT]));
    }
    let before_valve = above;
    let (mut valve_rates, mut selective_target) = ([R::constant(0.0); 2], states[place::SELECTIVE]);
    if e.has_valve() {
        let stands = [states[place::VALVE], states[place::VALVE_RATE]];
        (above, valve_rates) = e.valve_hysteresis.now(&e.fv_curve, above, stands);
    }
    if e.has_frequency_selective() {
        selective_target = e.frequency_selective_damping.target(above, w);
        above = e.frequency_selective_damping.force(above, w, states[place::SELECTIVE]);
    }
    let mut force = above + standing;
    if e.has_column() {
        force = force + w * LEAKAGE;
    }
    Flow { force, selective_target, before_valve, valve_rates }
}

/// The factors on the FV force in a stage, for position and temperature. They do not depend on the unknowns of the
/// stage.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Factors {
    /// Position factors for the compression and the rebound stroke, each with its derivative with respect to
    /// displacement, 1/m.
    strokes: [[f64; 2]; 2],
    /// Temperature factor, with its derivative with respect to the temperature rise by self-heating, 1/K.
    fade: [f64; 2],
}

impl Factors {
    #[inline(always)]
    pub fn new<const ON: u32>(e: &Paths<impl Tables>, x: f64, temperature: f64, rise: f64) -> Factors {
        let mut factors = Factors { strokes: [[1.0, 0.0]; 2], fade: [1.0, 0.0] };
        if acts::<ON>(e, POSITION) {
            let x = Dual::<1>::along(x, 0);
            factors.strokes = e.position_dependent_damping.factors(x).map(|s| [s.value, s.derivative(0)]);
        }
        if acts::<ON>(e, FADE) {
            let s = e.temperature_fade.factor(temperature, Dual::<1>::along(rise, 0));
            factors.fade = [s.value, s.derivative(0)];
        }
        factors
    }
}

/// The valve force after an implicit stage, with the derivatives of each of the three effects in series.
///
/// The effects are, in this order: the position and temperature factors of the FV force F_d; the lagging valve;
/// frequency-selective damping.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Valves {
    /// Force F_h of the valves, N.
    pub force: f64,
    /// State of the valve after the stage.
    pub valve: f64,
    /// State of frequency-selective damping after the stage.
    pub selective: f64,
    /// Derivatives of the valve force F_h with respect to the FV force F_d and to the oil velocity w.
    pub by_curve: f64,
    pub by_w: f64,
    /// Derivatives of the FV force with its position and temperature factors, with respect to the FV force,
    /// displacement and temperature rise.
    scaled_by: [f64; 3],
    /// Derivatives of the force after the lagging valve. `valve_by` contains those of the valve's state.
    ///
    /// The variables are the force before the valve, the known part of its state, and the FV curve's forces at `read`.
    /// `read` contains the two velocities at which the valve evaluates the curve.
    late_by: [f64; 4],
    valve_by: [f64; 4],
    pub read: [f64; 2],
    /// Derivatives of the force after frequency-selective damping. `selective_by` contains those of its state. The
    /// three variables are: the force before the element; the oil velocity w; the known part of the state.
    selected_by: [f64; 3],
    selective_by: [f64; 3],
}

/// Derivatives of the inputs of the valve force with respect to one variable (a direction).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moves {
    pub curve: f64,
    pub standing: f64,
    pub w: f64,
    pub x: f64,
    pub rise: f64,
    /// The known part of the valve's state, and the forces of the FV curve at the two velocities [`Valves::read`].
    pub valve: f64,
    pub read: [f64; 2],
    pub selective: f64,
}

impl Moves {
    pub const NONE: Moves =
        Moves { curve: 0.0, standing: 0.0, w: 0.0, x: 0.0, rise: 0.0, valve: 0.0, read: [0.0; 2], selective: 0.0 };
}

impl Valves {
    /// No force.
    pub const NONE: Valves = Valves {
        force: 0.0,
        valve: 0.0,
        selective: 0.0,
        by_curve: 0.0,
        by_w: 0.0,
        scaled_by: [0.0; 3],
        late_by: [0.0; 4],
        valve_by: [0.0; 4],
        read: [0.0; 2],
        selected_by: [0.0; 3],
        selective_by: [0.0; 3],
    };

    /// Computes the valve force from the `known` parts of the states and the force and velocity of the current
    /// iteration.
    ///
    /// In the stage, `g` is the weight of the state derivatives, s; `since` is that of a lagging valve. `raised` is the
    /// factor by which the valve increased the force in the previous solution. `leaks` is true with an oil column.
    #[inline(always)]
    pub fn stage<const ON: u32>(
        e: &Paths<impl Tables>,
        factors: &Factors,
        [curve, standing, w]: [f64; 3],
        known: &[f64; STATES],
        [g, since]: [f64; 2],
        raised: &Cell<f64>,
        leaks: bool,
    ) -> Valves {
        let above = curve - standing;
        let [on_stroke, by_x] = factors.strokes[usize::from(above >= 0.0)];
        let [fade, by_rise] = factors.fade;
        // Only the laminar part fades: see `temperature_fade`.
        let placed = on_stroke * above;
        let laminar = if acts::<ON>(e, FADE) { e.temperature_fade.laminar(placed) } else { 1.0 };
        let faded = 1.0 + (fade - 1.0) * laminar;
        let faded_by = 1.0 + (fade - 1.0) * laminar * laminar;
        let factor = on_stroke * faded_by;
        let (mut force, mut by_curve, mut by_w) = (faded * placed + standing, factor, 0.0);
        let mut valves = Valves {
            force,
            valve: known[place::VALVE],
            selective: known[place::SELECTIVE],
            by_curve,
            by_w,
            scaled_by: [factor, above * by_x * faded_by, placed * laminar * by_rise],
            late_by: [1.0, 0.0, 0.0, 0.0],
            valve_by: [0.0, 1.0, 0.0, 0.0],
            read: [0.0; 2],
            selected_by: [1.0, 0.0, 0.0],
            selective_by: [0.0, 0.0, 1.0],
        };
        if acts::<ON>(e, VALVE) {
            let element = &e.valve_hysteresis;
            let stands = element.known(known[place::VALVE], known[place::VALVE_RATE], since);
            let late = element.stage(&e.fv_curve, force - standing, stands, since, raised);
            (force, valves.late_by) = (late.force.value + standing, late.force.derivatives);
            (valves.valve, valves.valve_by) = (late.stands.value, late.stands.derivatives);
            valves.read = late.read;
            by_curve *= late.force.derivative(0);
        }
        if acts::<ON>(e, SELECTIVE) {
            let element = &e.frequency_selective_damping;
            let (before, w) = (Dual::<3>::along(force - standing, 0), Dual::<3>::along(w, 1));
            let per = g * element.per_time;
            let state = Dual::<3>::along(valves.selective, 2) + element.target(before, w) * per;
            let state = state * (1.0 / (1.0 + per));
            let selected = element.force(before, w, state);
            (force, valves.selected_by) = (selected.value + standing, selected.derivatives);
            (valves.selective, valves.selective_by) = (state.value, state.derivatives);
            by_curve *= selected.derivative(0);
            by_w = selected.derivative(1);
        }
        if leaks {
            force += LEAKAGE * w;
            by_w += LEAKAGE;
        }
        (valves.force, valves.by_curve, valves.by_w) = (force, by_curve, by_w);
        valves
    }

    /// Returns the derivatives in the direction `by` of three results: the force, the valve's state, and the state of
    /// frequency-selective damping.
    #[inline(always)]
    pub fn along<const ON: u32>(&self, e: &Paths<impl Tables>, by: &Moves, leaks: bool) -> [f64; 3] {
        let [factor, by_x, by_rise] = self.scaled_by;
        let mut force = factor * by.curve + (1.0 - factor) * by.standing;
        if acts::<ON>(e, POSITION) {
            force += by_x * by.x;
        }
        if acts::<ON>(e, FADE) {
            force += by_rise * by.rise;
        }
        let (mut valve, mut selective) = (0.0, 0.0);
        if acts::<ON>(e, VALVE) {
            let above = force - by.standing;
            let all = |[by_force, by_valve, first, second]: [f64; 4]| {
                by_force * above + by_valve * by.valve + first * by.read[0] + second * by.read[1]
            };
            valve = all(self.valve_by);
            force = all(self.late_by) + by.standing;
        }
        if acts::<ON>(e, SELECTIVE) {
            let above = force - by.standing;
            let all = |[by_force, by_w, by_state]: [f64; 3]| by_force * above + by_w * by.w + by_state * by.selective;
            selective = all(self.selective_by);
            force = all(self.selected_by) + by.standing;
        }
        if leaks {
            force += LEAKAGE * by.w;
        }
        [force, valve, selective]
    }
}

/// Returns the law of the air in the oil column and the compliance of the oil, m/N. They are those in compression for a
/// negative `side` (force or deflection), otherwise those in rebound.
#[inline(always)]
fn column(e: &Paths<impl Tables>, side: f64) -> (SoftGap, f64) {
    (e.aeration.under(side), e.oil_compressibility.compliance(side))
}

/// Computes the deflection of the oil column, m, under the hydraulic force `force`, N.
#[inline(always)]
pub fn deflection<R: Real>(e: &Paths<impl Tables>, force: R) -> R {
    let (air, compliance) = column(e, force.value());
    if e.has_aeration() { air.deflection(compliance, force) } else { force * compliance }
}

/// Computes the state of an oil column under the force `force`, N, at displacement `x`, m.
///
/// The state is the deflection. With two chambers whose length changes, it is the part of the piston stroke that the
/// column absorbs.
pub(crate) fn column_state(e: &Paths<impl Tables>, x: f64, force: f64) -> f64 {
    let q = deflection(e, force);
    if e.counts_stroke() { e.oil_compressibility.taken_up(x, q) } else { q }
}

/// Computes the hydraulic force, N, and the deflection, m, of an oil column in a given state at displacement `x`, m.
#[inline(always)]
pub fn column_force<R: Real>(e: &Paths<impl Tables>, x: R, state: R) -> (R, R) {
    let q = if e.counts_stroke() { e.oil_compressibility.deflection(x, state) } else { state };
    let (air, compliance) = column(e, q.value());
    (air.force(R::constant(1.0 / compliance), q).0, q)
}

/// Computes the state derivative, m/s, of an oil column that absorbs the velocity `pressed`, m/s: piston velocity minus
/// oil velocity. The moving end has displacement x and velocity v, and the column has the deflection `deflection`, m.
#[inline(always)]
pub fn column_rate<R: Real>(e: &Paths<impl Tables>, [x, v]: [R; 2], deflection: R, pressed: R) -> R {
    if e.counts_stroke() {
        return pressed + v * e.oil_compressibility.taken_up_by_place(x, deflection);
    }
    if e.has_length() { pressed * e.oil_compressibility.length(x).inverse() } else { pressed }
}

/// The oil column after an implicit stage.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Column {
    /// State of the column, m, and its derivatives with respect to the hydraulic force and the displacement.
    pub state: f64,
    pub by_force: f64,
    pub d_state_d_x: f64,
    /// Contribution of the column to the piston velocity u minus the oil velocity w, times the weight g of the stage,
    /// and its derivatives.
    ///
    /// The variables are the hydraulic force, the known part of the state, the displacement of the moving end, and that
    /// before the stage.
    pub change: f64,
    pub change_by: [f64; 4],
}

impl Column {
    /// A stage without an oil column.
    pub const NONE: Column = Column { state: 0.0, by_force: 0.0, d_state_d_x: 0.0, change: 0.0, change_by: [0.0; 4] };

    /// Computes the column after a stage under the hydraulic force `force`, N, from the `known` part of its state. The
    /// piston has the velocity u, and the oil at the valves the velocity w; g is the weight of the stage. In all three
    /// kinds of column, u − w increases with the force:
    ///
    /// ```text
    /// q − Q = g (u − w),   ℓ(x) (q − Q) = g (u − w),   s(X, q) − S = g (u − w)
    /// ```
    ///
    /// The three equations apply to a column of constant length, to one chamber of variable length, and to two chambers
    /// of variable length. q is the deflection, s the absorbed part of the piston stroke, and ℓ the relative length of
    /// the column. Q and S are the known parts of q and s. The last equation is the stage of ds/dt = u − w + v ∂s/∂x,
    /// where v is the velocity of the moving end, dx/dt. In the stage, the moving end goes from X, the argument `from`,
    /// to x. The term v ∂s/∂x is discretized as s(x, q) − s(X, q). The equation therefore contains s(X, q), and the new
    /// state is s(x, q).
    #[inline(always)]
    pub fn stage<const ON: u32>(e: &Paths<impl Tables>, force: f64, [from, x]: [f64; 2], known: f64) -> Column {
        let (air, compliance) = column(e, force);
        let [q, per_force] = if acts::<ON>(e, AIR) {
            let q = air.deflection(compliance, Dual::<1>::along(force, 0));
            [q.value, q.derivative(0)]
        } else {
            [force * compliance, compliance]
        };
        let change = q - known;
        if !acts::<ON>(e, LENGTH) {
            let change_by = [per_force, -1.0, 0.0, 0.0];
            return Column { state: q, by_force: per_force, d_state_d_x: 0.0, change, change_by };
        }
        if !e.counts_stroke() {
            let length = e.oil_compressibility.length(Dual::<1>::along(x, 0));
            let change_by = [length.value * per_force, -length.value, length.derivative(0) * change, 0.0];
            return Column {
                state: q,
                by_force: per_force,
                d_state_d_x: 0.0,
                change: length.value * change,
                change_by,
            };
        }
        let q = Dual::<2>::along(q, 0);
        let after = e.oil_compressibility.taken_up(Dual::along(x, 1), q);
        let before = e.oil_compressibility.taken_up(Dual::along(from, 1), q);
        Column {
            state: after.value,
            by_force: after.derivative(0) * per_force,
            d_state_d_x: after.derivative(1),
            change: before.value - known,
            change_by: [before.derivative(0) * per_force, -1.0, 0.0, before.derivative(1)],
        }
    }
}
