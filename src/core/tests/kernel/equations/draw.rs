//! Random dampers with random states and inputs at one instant.

use dashpot_core::parameter::names;
use dashpot_core::parameter::{Element, List, Number, Shape, table};
use dashpot_core::{Input, Model, Params, State};
use dashpot_core::{element, list};
use dashpot_test_support::Random;

/// A damper with its input and its state at one instant.
pub struct Case {
    pub params: Params,
    pub model: Model,
    pub input: Input,
    pub state: State,
}

/// Distribution of a random number between two bounds.
enum Span {
    /// Uniform.
    Even(f64, f64),
    /// Uniform in the logarithm.
    Decade(f64, f64),
    /// Magnitude uniform in the logarithm, of either sign.
    Either(f64, f64),
    /// 0 in one case of four, otherwise uniform in the logarithm.
    Perhaps(f64, f64),
    /// The default in one case of three, otherwise uniform in the logarithm.
    Else(f64, f64),
}

/// Distributions of the parameters whose default does not indicate their magnitude, or that have an effect only far
/// from the default.
const SPANS: &[(&str, Span)] = &[
    ("fv_rebound_v2", Span::Decade(0.3, 2.0)),
    ("fv_rebound_v1", Span::Decade(0.02, 0.25)),
    ("free_play_load", Span::Even(-300.0, 300.0)),
    ("bushing_slip", Span::Else(1e-5, 1e-3)),
    ("bushing_stop", Span::Decade(1e-4, 3e-3)),
    ("bushing_hardening", Span::Decade(2e-4, 1e-2)),
    ("bushing_stop_stiffness", Span::Perhaps(0.1, 20.0)),
    ("bushing_slow_stiffness", Span::Perhaps(0.05, 5.0)),
    ("oil_shortening", Span::Even(-12.0, 12.0)),
    ("cavitation_return", Span::Even(0.0, 1.0)),
    ("cavitation_onset", Span::Else(0.05, 1.0)),
    ("bypass_share", Span::Even(-2.0, 0.95)),
    ("bypass_centre", Span::Even(-0.05, 0.05)),
    ("bypass_half_width", Span::Decade(5e-3, 0.1)),
    ("fade_coefficient", Span::Either(1e-4, 0.1)),
    ("fade_reference", Span::Even(-40.0, 200.0)),
    ("fade_laminar_force", Span::Else(50.0, 5e3)),
    ("fade_slackening", Span::Perhaps(3e-3, 0.03)),
    ("fsd_share", Span::Even(0.0, 0.9)),
    ("valve_hysteresis_share", Span::Even(0.0, 1.0)),
    ("valve_closing_ratio", Span::Even(0.3, 1.0)),
    ("valve_play", Span::Perhaps(10.0, 500.0)),
    ("spring_linear", Span::Perhaps(100.0, 1e5)),
    ("spring_quadratic", Span::Perhaps(1e3, 1e5)),
    ("spring_cubic", Span::Perhaps(1e4, 1e6)),
    ("spring_quartic", Span::Perhaps(1e5, 1e7)),
    ("stribeck_fall", Span::Even(1.0, 4.0)),
    ("stribeck_rise_power", Span::Even(1.0, 4.0)),
    ("gas_force", Span::Even(-300.0, 800.0)),
    ("gas_length", Span::Decade(0.05, 1.0)),
    ("gas_adiabatic_index", Span::Even(1.0, 1.67)),
    ("lag_v1", Span::Even(0.0, 0.3)),
    ("lag_v2", Span::Decade(0.31, 3.0)),
    ("presliding_power", Span::Else(1.0, 10.0)),
    ("presliding_creep", Span::Else(1e-5, 0.1)),
    ("bump_stop_clearance", Span::Even(0.0, 0.06)),
    ("rebound_stop_clearance", Span::Even(0.0, 0.06)),
    ("bump_stop_loss", Span::Even(0.0, 0.9)),
    ("rebound_stop_loss", Span::Even(0.0, 0.9)),
    ("bump_stop_damping", Span::Perhaps(100.0, 2e4)),
    ("rebound_stop_damping", Span::Perhaps(100.0, 2e4)),
];

/// Largest factor between the drawn value of a parameter without an entry in [`SPANS`] and its default.
const AROUND: f64 = 5.0;

fn value(r: &mut Random, number: Number) -> f64 {
    let default = number.default();
    if let Shape::Choice(words) = number.parameter().shape {
        return r.one_of(words.len()) as f64;
    }
    let span = SPANS.iter().find(|(name, _)| *name == number.name()).map(|(_, span)| span);
    number.inside(match *span.unwrap_or(&Span::Decade(default / AROUND, default * AROUND)) {
        Span::Even(low, high) => r.between(low, high),
        Span::Decade(low, high) => r.decade(low, high),
        Span::Either(low, high) => [-1.0, 1.0][r.one_of(2)] * r.decade(low, high),
        Span::Perhaps(low, high) => {
            if r.chance(0.25) {
                0.0
            } else {
                r.decade(low, high)
            }
        }
        Span::Else(low, high) => {
            if r.chance(1.0 / 3.0) {
                default
            } else {
                r.decade(low, high)
            }
        }
    })
}

/// Abscissae and forces of the points of a curve.
type Points = (Vec<f64>, Vec<f64>);

/// Draws the points of a non-decreasing curve. `steps` bounds the distance of two abscissae, and `steepness` the mean
/// derivative between them. Abscissa and force 0 lie between the first and the last point.
fn points(r: &mut Random, steps: (f64, f64), steepness: (f64, f64)) -> Points {
    let count = 2 + r.one_of(15);
    let (mut u, mut f) = (vec![0.0], vec![0.0]);
    for _ in 1..count {
        let step = r.decade(steps.0, steps.1);
        let rise = if r.chance(0.08) { 0.0 } else { step * r.decade(steepness.0, steepness.1) };
        u.push(u[u.len() - 1] + step);
        f.push(f[f.len() - 1] + rise);
    }
    let (right, up) = (r.between(0.2, 0.8) * u[count - 1], r.between(0.2, 0.8) * f[count - 1]);
    u.iter_mut().for_each(|u| *u -= right);
    f.iter_mut().for_each(|f| *f -= up);
    (u, f)
}

/// Moves the first point of a curve at an abscissa of at least 0 to the origin, and shifts the other forces
/// accordingly.
fn through_zero((mut u, mut f): Points) -> Points {
    let middle = u.iter().filter(|u| **u < 0.0).count();
    let up = f[middle];
    (u[middle], f[middle]) = (0.0, 0.0);
    for (k, f) in f.iter_mut().enumerate().filter(|(k, _)| *k != middle) {
        *f = if k < middle { f.min(up) } else { *f } - up;
    }
    (u, f)
}

fn params(r: &mut Random, first: Element) -> Params {
    let mut params = Params::new();
    params.disable_all();
    let share = [0.0, 0.15, 0.4][r.one_of(3)];
    for name in names() {
        params.enable(Element::find(name).unwrap(), r.chance(share));
    }
    params.enable(first, true);
    params.enable(element!("fv_curve"), r.chance(0.95));
    params.enable(element!("series_compliance"), r.chance(0.7));
    for row in table() {
        if let Ok(n) = Number::find(row.parameter.name)
            && row.element().is_some()
        {
            params.set(n, value(r, n)).unwrap();
        }
    }
    let mut curve = points(r, (0.01, 0.6), (300.0, 8e3));
    if r.chance(0.5) {
        curve = through_zero(curve);
    }
    let mut set = |u: List, f: List, points: Points| {
        params.set_list(u, &points.0).unwrap();
        params.set_list(f, &points.1).unwrap();
    };
    set(list!("fv_velocity"), list!("fv_force"), curve);
    if r.chance(0.5) {
        set(list!("spring_displacement"), list!("spring_force"), points(r, (2e-3, 0.05), (100.0, 5e4)));
    }
    let terms = 1 + r.one_of(6);
    let terms: Vec<f64> = (0..terms).map(|_| r.between(-3e3, 3e3)).collect();
    params.set_list(list!("polynomial"), &terms).unwrap();
    params
}

/// Draws a velocity, m/s, of any magnitude and either sign; sometimes 0.
fn speed(r: &mut Random) -> f64 {
    let size = if r.chance(0.3) { r.decade(1e-6, 3.0) } else { r.between(0.0, 2.0) };
    [size, -size][r.one_of(2)] * f64::from(u8::from(!r.chance(0.03)))
}

/// Draws a state with this name and unit, of a magnitude that occurs in dampers; `x` is the displacement, m. A void is
/// sometimes slightly negative, as after rounding.
fn state(r: &mut Random, (name, unit): (&str, &str), x: f64) -> f64 {
    match (name, unit) {
        ("internal_mass", _) => x + r.between(-1.0, 1.0) * r.decade(1e-6, 3e-3),
        ("cavitation_void", _) => {
            if r.chance(0.1) {
                -1e-6
            } else {
                r.decade(1e-7, 3e-3)
            }
        }
        ("valve_hysteresis", "-") => r.share(),
        ("oil_temperature_rise", _) => r.between(0.0, 80.0),
        (_, "m") => r.between(-1.0, 1.0) * r.decade(1e-6, 2e-3),
        (_, "m/s") => speed(r),
        (_, "N") => r.between(-3e3, 3e3),
        _ => r.between(-1.0, 1.0),
    }
}

/// Draws the case with this index. The index selects one element that is always on, so that each element is on in turn.
pub fn case(r: &mut Random, index: usize) -> Case {
    let names: Vec<&str> = names().collect();
    let first = Element::find(names[index % names.len()]).unwrap();
    loop {
        let params = params(r, first);
        // An inconsistent parameter set is rejected and drawn again.
        let Ok(model) = Model::new(&params) else { continue };
        let (x, v) = (r.between(-0.1, 0.1), speed(r));
        let side_force = if r.chance(0.1) { 0.0 } else { r.between(-3e3, 3e3) };
        let input = Input { displacement: Some(x), velocity: v, side_force, temperature: r.between(-30.0, 120.0) };
        let drawn: Vec<f64> = (0..model.states()).map(|i| state(r, model.state_name(i).unwrap(), x)).collect();
        let mut state = State { mass_displacement: drawn[0], mass_velocity: drawn[1], ..State::ZERO };
        state.internal[..drawn.len() - 2].copy_from_slice(&drawn[2..]);
        return Case { params, model, input, state };
    }
}
