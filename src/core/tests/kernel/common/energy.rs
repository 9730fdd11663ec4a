//! Energy stored in the springs and masses of a damper, for the tests of passivity.

use dashpot_core::paths::hydraulic::column_force;
use dashpot_core::paths::series::static_force as held_by;
use dashpot_core::{Model, Params, State, element, number};

/// Computes the energy stored in the springs and masses of the damper, J.
///
/// These are the series spring with gap and bushing, the oil column, and all masses that move with the piston or the
/// moving end. The parallel spring is not included.
pub fn stored(model: &Model, params: &Params, s: &State) -> f64 {
    let e = &model.elements().paths;
    let series = &e.series_compliance;
    let stretched = s.displacement - s.mass_displacement;
    let number = |id| params.number(id);
    let in_series = match model.elements().has_paths() && e.has_series() {
        true => under(|d| held_by(e, d).0, stretched),
        false => 0.5 * series.stiffness * stretched * stretched,
    };
    let kinetic = 0.5 * series.mass * s.mass_velocity * s.mass_velocity;
    let of_the_end = match params.is_on(element!("moving_mass")) && number(number!("moving_mass_place")) == 0.0 {
        true => 0.5 * number(number!("moving_mass")) * s.velocity * s.velocity,
        false => 0.0,
    };
    let mut sum = in_series + kinetic + of_the_end;
    for index in 2..model.states() {
        let z = s.internal[index - 2];
        sum += match model.state_name(index).unwrap().0 {
            "bushing" => 0.5 * number(number!("bushing_loss_stiffness")) * series.stiffness * z * z,
            "bushing_slow" => 0.5 * number(number!("bushing_slow_stiffness")) * series.stiffness * z * z,
            "oil_column" => under(|q| column(params, q), column_force(e, s.displacement, z).1),
            _ => 0.0,
        };
    }
    sum
}

/// Computes the work, J, of a force that depends on the deflection, from 0 to the deflection `to`, m.
fn under(force: impl Fn(f64) -> f64, to: f64) -> f64 {
    const PIECES: i32 = 1000;
    (0..PIECES).map(|k| force(to * (f64::from(k) + 0.5) / f64::from(PIECES)) * to / f64::from(PIECES)).sum()
}

/// Computes the force y of the oil column, including air, N, at a deflection `q`, m. Solves q = y/k + d y/(y + F_a) by
/// bisection, with the oil's stiffness k and the air's stroke d and force F_a.
fn column(params: &Params, q: f64) -> f64 {
    let number = |id| params.number(id);
    let side = |share: f64| if q < 0.0 { share } else { 1.0 };
    let k = match params.is_on(element!("oil_compressibility")) {
        true => number(number!("oil_stiffness")) * side(number(number!("oil_compression"))),
        false => 3e7,
    };
    let gap = match params.is_on(element!("aeration")) {
        true => number(number!("aeration_stroke")) * side(number(number!("aeration_compression"))),
        false => 0.0,
    };
    let (mut low, mut high) = (0.0, k * q.abs());
    for _ in 0..60 {
        let y = 0.5 * (low + high);
        let more = y / k + gap * y / (y + number(number!("aeration_force"))) > q.abs();
        if more { high = y } else { low = y }
    }
    low.copysign(q)
}
