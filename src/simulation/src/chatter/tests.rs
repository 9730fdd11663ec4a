use super::situation::{COLD, SIDE_FORCE};
use super::*;
use dashpot_core::parameter::{Element, Number};
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params};
use dashpot_core::{element, list, number};
use dashpot_messages::format_number;

fn steep() -> Params {
    let mut params = Params::new();
    // Without gas force, the equilibrium position of the host's mass depends only on the host's spring.
    for off in [element!("stribeck_friction"), element!("series_compliance"), element!("gas_preload")] {
        params.enable(off, false);
    }
    params.enable(element!("coulomb_friction"), true);
    params.set(number!("coulomb_force"), 40.0).unwrap();
    params.set(number!("coulomb_steepness"), 5000.0).unwrap();
    params
}

const HOST: Host = Host { step: 1e-3, mass: 40.0 };

/// Simulates a mass on a damper and a spring with a zero-order hold of the force. Returns the largest change of the
/// damper force, N, from step to step in the last hundred steps.
fn swings(params: &Params, host: Host) -> f64 {
    swings_under(params, host, 0.0)
}

fn swings_under(params: &Params, host: Host, side_force: f64) -> f64 {
    let model = Model::new(params).unwrap();
    let mut state = model.steady_state(&Input::motion(0.0, 0.0));
    let (mut x, mut v, mut force) = (0.0, 1e-3, 0.0);
    let mut last = 0.0f64;
    for k in 0..6000 {
        v -= host.step / host.mass * (force + 200.0 * x);
        x += host.step * v;
        let to = Input { side_force, ..Input::motion(x, v) };
        let (next, output) = step(&model, &state, &to, host.step);
        let change = (output.force - force).abs();
        (state, force) = (next, output.force);
        if k > 5900 {
            last = last.max(change);
        }
    }
    last
}

#[test]
fn what_is_said_is_what_a_held_force_does() {
    let steep = steep();
    let found = chatter(&steep, HOST).unwrap();
    assert!(
        found.gain > GROWS && found.element.is_some_and(|(element, _)| element == element!("coulomb_friction")),
        "{found:?}"
    );
    assert!(swings(&steep, HOST) > 1.0, "{}", swings(&steep, HOST));
    let soft = softened(&steep, HOST).unwrap().unwrap();
    assert!(soft.gain < RINGS && soft.softer[0].element() == element!("coulomb_friction"));
    assert!(swings(&soft.params, HOST) < 0.05, "{}", swings(&soft.params, HOST));
    // At 0.9 times the longest step reported without chatter, the steep damper does not chatter.
    let quiet = Host { step: 0.9 * found.quiet_step.unwrap(), ..HOST };
    assert!(chatter(&steep, quiet).unwrap().gain < RINGS);
    assert!(swings(&steep, quiet) < 0.5, "{}", swings(&steep, quiet));
}

#[test]
fn what_chatters_under_side_force_in_a_stop_or_off_the_middle_alone_is_found() {
    let of = |on: Element, numbers: &[(Number, f64)]| {
        let mut params = Params::new();
        params.enable(element!("stribeck_friction"), false);
        params.enable(on, true);
        numbers.iter().for_each(|(number, value)| params.set(*number, *value).unwrap());
        chatter(&params, HOST).unwrap()
    };
    let plain = of(element!("gas_preload"), &[]);
    assert!(!plain.rings() && plain.describe(HOST, false).contains("side force"), "{}", plain.describe(HOST, false));
    let pushed = of(element!("side_force_friction"), &[]);
    assert!(pushed.rings() && pushed.situation.side_force == SIDE_FORCE, "{pushed:?}");
    assert!(pushed.describe(HOST, false).contains("under 2000 N of side force"), "{}", pushed.describe(HOST, false));
    let stopped = of(element!("bump_stop"), &[(number!("bump_stop_damping"), 1e5)]);
    assert!(stopped.rings() && stopped.situation.place < -0.05, "{stopped:?}");
    assert!(stopped.element.is_some_and(|(element, _)| element == element!("bump_stop")), "{stopped:?}");
    let cold = of(element!("temperature_fade"), &[]);
    assert_eq!(cold.situation.temperature, COLD, "{cold:?}");
}

#[test]
fn friction_under_side_force_is_made_quiet_and_its_error_is_told() {
    let mut params = Params::new();
    params.enable(element!("stribeck_friction"), false);
    params.enable(element!("side_force_friction"), true);
    let soft = softened(&params, HOST).unwrap().unwrap();
    let [Softer::LessSteep { before, after }] = soft.softer[..] else { panic!("{soft:?}") };
    assert!(after < before && soft.gain < RINGS && soft.largest_error > 1.0, "{soft:?}");
    let pushed = |params: &Params| swings_under(params, HOST, SIDE_FORCE);
    assert!(pushed(&params) > 10.0 && pushed(&soft.params) < 0.5, "{} {}", pushed(&params), pushed(&soft.params));
}

#[test]
fn two_frictions_are_both_replaced() {
    let mut params = steep();
    params.enable(element!("stribeck_friction"), true);
    params.set(number!("stribeck_coulomb_force"), 30.0).unwrap();
    let soft = softened(&params, HOST).unwrap().unwrap();
    assert_eq!(soft.softer.len(), 2, "{soft:?}");
    assert_eq!(soft.params.number(number!("presliding_force")), 70.0);
    assert!(swings(&soft.params, HOST) < 0.05, "{}", swings(&soft.params, HOST));
}

#[test]
fn a_damper_without_steep_friction_is_left_as_it_is() {
    let mut smooth = steep();
    smooth.enable(element!("coulomb_friction"), false);
    assert!(chatter(&smooth, HOST).unwrap().gain < RINGS);
    assert!(softened(&smooth, HOST).unwrap().is_none());
}

#[test]
fn the_error_of_the_replacement_is_that_of_reversals() {
    let soft = softened(&steep(), HOST).unwrap().unwrap();
    let [Softer::Replaced { force, .. }] = soft.softer[..] else { panic!("{soft:?}") };
    assert!(soft.largest_error <= 2.2 * force && soft.rms_error < 0.6 * force, "{soft:?}");
    assert!(soft.describe().contains("presliding"));
}

fn with(elements: &[Element], numbers: &[(Number, f64)]) -> Params {
    let mut params = Params::new();
    params.disable_all();
    elements.iter().for_each(|element| params.enable(*element, true));
    numbers.iter().for_each(|(number, value)| params.set(*number, *value).unwrap());
    params
}

/// Series path of a damper whose internal mass has no damping.
const UNDAMPED: [(Number, f64); 3] =
    [(number!("series_stiffness"), 3e6), (number!("series_damping"), 0.0), (number!("internal_mass"), 0.1)];

#[test]
fn a_moving_mass_above_the_wheels_is_no_quiet_damper() {
    let elements = [element!("fv_curve"), element!("series_compliance"), element!("moving_mass")];
    for (mass, rings) in [(2.0, false), (5.0, false), (10.0, true), (45.0, true), (60.0, true)] {
        let params = with(&elements, &[UNDAMPED.as_slice(), &[(number!("moving_mass"), mass)]].concat());
        let found = chatter(&params, HOST).unwrap();
        assert_eq!(found.rings(), rings, "{mass} {found:?}");
        let told = found.describe(HOST, false);
        assert!(!rings || told.contains("moving_mass makes it") && !told.contains("does not chatter"), "{told}");
        assert!(found.gain > 0.0 || told.contains("says nothing by itself"), "{told}");
        assert!(told.contains("advanced with the new velocity"), "{told}");
    }
}

#[test]
fn an_open_void_and_an_inner_mass_that_rings_are_found() {
    let elements =
        [element!("fv_curve"), element!("series_compliance"), element!("gas_preload"), element!("cavitation")];
    let capped = |force: f64, more: &[(Number, f64)]| {
        let cap = [(number!("cavitation_force"), force)];
        chatter(&with(&elements, &[UNDAMPED.as_slice(), &cap, more].concat()), HOST).unwrap()
    };
    let stays_open = capped(800.0, &[(number!("cavitation_return"), 0.0)]);
    assert!(stays_open.gain > RINGS, "{stays_open:?}");
    let rings = capped(500.0, &[]);
    assert!(rings.gain < RINGS && rings.turning.is_some() && rings.calming.is_some(), "{rings:?}");
    assert!(rings.element.is_some_and(|(e, _)| e == element!("cavitation")), "{rings:?}");
    assert!(!capped(3000.0, &[]).rings());
}

#[test]
fn a_narrow_steep_piece_of_the_curve_is_found() {
    let mut params = with(&[element!("fv_curve")], &[(number!("fv_interpolation"), 1.0)]);
    params.set_list(list!("fv_velocity"), &[-1.5, 0.0, 5e-4, 3e-3, 1.5]).unwrap();
    params.set_list(list!("fv_force"), &[-1500.0, 0.0, 1.0, 401.0, 2500.0]).unwrap();
    let found = chatter(&params, HOST).unwrap();
    assert!((found.gain - 4.0).abs() < 0.01 && found.swings(), "{found:?}");
}

#[test]
fn friction_is_replaced_whatever_else_rings() {
    let base = [element!("fv_curve"), element!("series_compliance"), element!("coulomb_friction")];
    for beside in [element!("rebound_stop"), element!("presliding_friction")] {
        let params = with(&[base.as_slice(), &[beside]].concat(), &[]);
        let soft = softened(&params, HOST).unwrap().unwrap();
        assert_eq!(soft.softer[0].element(), element!("coulomb_friction"), "{soft:?}");
        assert!(!soft.params.is_on(element!("coulomb_friction")) && soft.params.is_on(beside));
        let left = chatter(&soft.params, HOST).unwrap();
        let told = left.describe(HOST, true);
        assert!(
            !told.contains("--for-step") && !left.element.is_some_and(|e| e.0 == element!("coulomb_friction")),
            "{told}"
        );
        assert_eq!(left.rings(), beside == element!("rebound_stop"), "{told}");
    }
}

#[test]
fn hosts_beyond_their_bounds_are_rejected_with_option_and_bounds() {
    let params = with(&[element!("fv_curve")], &[]);
    for value in [1e308, -1e308, 1e-308, 0.0, f64::NAN, f64::INFINITY] {
        for (ready, option) in [
            (Ready::prepare(&params, value, 40.0, None), "--host-step"),
            (Ready::prepare(&params, 1e-3, value, None), "--wheel-mass"),
            (Ready::prepare(&params, 1e-3, 40.0, Some(value)), "--for-step"),
        ] {
            let message = ready.err().expect("no such host").to_string();
            assert!(message.starts_with(option) && message.contains("lies between"), "{message}");
            assert!(message.contains(&format_number(value)) && message.len() < 300, "{message}");
        }
    }
}
