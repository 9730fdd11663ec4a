//! Changes of the setting return no energy if every number that depends on it only dissipates energy. Other numbers
//! that depend on the setting may return energy, and the tests detect this energy.

use crate::common::energy::stored;
use crate::common::{WITH_STATES, any_params, describe, params, sine};
use crate::family::{family, numbers_of, over};
use dashpot_core::family::{Axis, Delay};
use dashpot_core::parameter::{Element, Number};
use dashpot_core::{Input, Output, Params, list, number};
use dashpot_test_support::drawn;
use proptest::prelude::*;

/// Interpolates linearly between the points (`v`, `f`), and extrapolates beyond them.
fn between(v: &[f64], f: &[f64], at: f64) -> f64 {
    let i = v.iter().filter(|v| **v <= at).count().clamp(1, v.len() - 1);
    f[i - 1] + (f[i] - f[i - 1]) * (at - v[i - 1]) / (v[i] - v[i - 1])
}

/// Elements that store or supply energy at rest. The tests leave them off, because their work would count as that of
/// the setting.
const LEFT_OUT: [&str; 5] = ["parallel_spring", "gas_preload", "gas_warming", "gas_spring", "lagged_polynomial"];

/// Makes the FV curve odd. With a force at zero velocity, the damper would store energy that depends on the setting.
fn make_odd(params: &mut Params) {
    let (v, f) = (params.list(list!("fv_velocity")).to_vec(), params.list(list!("fv_force")).to_vec());
    let positive: Vec<f64> = v.iter().copied().filter(|v| *v > 0.0).collect();
    let symmetric: Vec<f64> = positive.iter().rev().map(|v| -v).chain([0.0]).chain(positive.iter().copied()).collect();
    let odd: Vec<f64> = symmetric.iter().map(|at| 0.5 * (between(&v, &f, *at) - between(&v, &f, -at))).collect();
    params.set_list(list!("fv_velocity"), &symmetric).unwrap();
    params.set_list(list!("fv_force"), &odd).unwrap();
    params.set(number!("fv_form"), 0.0).unwrap();
    params.set(number!("fv_interpolation"), 1.0).unwrap();
}

/// Returns whether a change of this number only changes how much energy is dissipated.
fn dissipates(params: &Params, number: Number) -> bool {
    let mut axis = Axis::NONE;
    axis.set_grid(&[0.0, 1.0]).unwrap();
    axis.set_values(number, &[params.number(number); 2]).is_ok() && axis.stores_energy().next().is_none()
}

/// Result of a motion with a changing setting, J.
struct Work {
    /// Work of the moving end on the damper.
    done: f64,
    /// Sum of the magnitudes of the work of each step.
    gross: f64,
    /// Energy in springs and masses at the end.
    stored: f64,
}

/// Moves a damper over a setting along `motion`, displacements, m, and velocities, m/s, at a time, s, in `steps` steps of
/// `dt`, s, from rest. `command` returns the setting of a step from its index, the velocity, m/s, and the last force, N.
/// Returns `None` if the parameters are no family.
fn work(
    params: &Params,
    axis: &Axis,
    motion: impl Fn(f64) -> (f64, f64),
    (steps, dt): (u32, f64),
    mut command: impl FnMut(u32, f64, f64) -> f64,
) -> Option<Work> {
    let family = family(params, axis).ok()?;
    let mut state = family.steady_state(&Input::motion(motion(0.0).0, 0.0), None);
    let mut delay = Delay::UNSET;
    let (mut done, mut gross, mut last) = (0.0, 0.0, 0.0);
    for i in 1..=steps {
        let (x, v) = motion(f64::from(i) * dt);
        let setting = command(i, v, last);
        let before = state.displacement;
        let mut output = Output::ZERO;
        let to = Input::motion(x, v);
        assert!(family.step_in_place(&mut state, &mut delay, &to, Some(setting), dt, &mut output, true));
        // The force of a switched damper jumps, so the work of a step is computed with the force at its end.
        let of_step = output.force * (state.displacement - before);
        done += of_step;
        gross += of_step.abs();
        last = output.force;
    }
    Some(Work { done, gross, stored: stored(family.model(), params, &state) })
}

proptest! {
    #![proptest_config(drawn(60))]

    /// If no parameter that depends on the setting stores energy, the damper only dissipates energy, for any changes of
    /// the setting.
    ///
    /// The dampers have any elements except those of [`LEFT_OUT`]. The FV curve depends on the setting, and so does a
    /// random selection of the numbers that only affect dissipation.
    #[test]
    fn changes_of_the_setting_return_no_energy(
        params in any_params(),
        amplitude in 0.0005..0.05f64,
        dt in (-4.0..-2.7f64).prop_map(|d| 10f64.powf(d)),
        changes in prop::collection::vec(0.0..1.6f64, 64),
        which in any::<u64>(),
        follows in any::<bool>(),
    ) {
        let mut params = params;
        for element in dashpot_core::parameter::names() {
            // With further elements with internal states, the model would have too many states. Therefore these
            // elements stay on or off as drawn.
            let drawn = !WITH_STATES.contains(&element) || params.is_on(Element::find(element).unwrap());
            params.enable(Element::find(element).unwrap(), drawn && !LEFT_OUT.contains(&element));
        }
        make_odd(&mut params);
        // A bushing that hardens within a millimeter oscillates too fast to compute its work from values at the ends of
        // steps.
        params.set(number!("bushing_hardening"), 1.0).unwrap();
        // The filter form stores the lagging force: see `a_lagging_force_returns_energy`.
        if params.number(number!("fsd_form")) == 0.0 {
            params.set(number!("fsd_form"), 1.0).unwrap();
        }
        // The Stribeck peak is at least the Coulomb level at every setting, because a peak below it could drive the
        // motion.
        let (peak, level) = (params.number(number!("stribeck_breakaway_force")), params.number(number!("stribeck_coulomb_force")));
        params.set(number!("stribeck_breakaway_force"), peak.max(level)).unwrap();
        let together = [number!("stribeck_breakaway_force"), number!("stribeck_coulomb_force")];
        let numbers: Vec<Number> = numbers_of(&params)
            .into_iter()
            .enumerate()
            .filter(|(i, number)| dissipates(&params, *number) && (which >> (i % 64) & 1 == 1 || together.contains(number)))
            .map(|(_, number)| number)
            .take(32)
            .collect();
        let axis = over(&params, &numbers);
        prop_assert_eq!(axis.stores_energy().count(), 0);
        // The setting changes at random, or as with the worst controller: soft while the damper resists, firm while the
        // force assists the motion.
        let command = |i: u32, v: f64, last: f64| match follows {
            true if v * last > 0.0 => 0.0,
            true => 1.6,
            false => changes[i as usize % 64],
        };
        let per_cycle = 256u32;
        let frequency = 1.0 / (f64::from(per_cycle) * dt);
        // The velocity is at most 5 m/s, the end of a car damper's curve.
        let motion = sine(amplitude.min(5.0 / (std::f64::consts::TAU * frequency)), frequency);
        let moved = work(&params, &axis, motion, (4 * per_cycle, dt), command);
        let Some(Work { done, gross, stored }) = moved else { return Ok(()) };
        let names: Vec<&str> = numbers.iter().map(|number| number.name()).collect();
        prop_assert!(done >= -stored - 0.005 * gross, "returned {done} J of {gross} J, {stored} J were stored, over {names:?}: {}", describe(&params));
    }
}

/// Makes a damper of some elements whose curve saturates at ±`firm`, N, from 10 mm/s on.
fn saturating(elements: &[&str], firm: f64, changes: &[(&str, f64)]) -> Params {
    let mut params = params(changes);
    params.disable_all();
    for element in ["fv_curve", "series_compliance"].iter().chain(elements) {
        params.enable(Element::find(element).unwrap(), true);
    }
    params.set_list(list!("fv_velocity"), &[-1.0, -0.01, 0.0, 0.01, 1.0]).unwrap();
    params.set_list(list!("fv_force"), &[-firm, -firm, 0.0, firm, firm]).unwrap();
    params.set(number!("fv_interpolation"), 1.0).unwrap();
    params
}

/// Makes a setting from 0 to 1 with the curves, if any, and the numbers over it.
fn between_two(curves: Option<[&[f64]; 2]>, numbers: &[(Number, [f64; 2])]) -> Axis {
    let mut axis = Axis::NONE;
    axis.set_grid(&[0.0, 1.0]).unwrap();
    for (index, forces) in curves.iter().flatten().enumerate() {
        axis.set_forces(index, forces).unwrap();
    }
    for (number, values) in numbers {
        axis.set_values(*number, values).unwrap();
    }
    axis
}

/// Each of these dependences on the setting returns energy over closed cycles, if the setting assists the motion.
///
/// The test of random dampers can therefore detect such energy. The remarks on a model file must name these numbers.
#[test]
fn a_stored_force_of_the_setting_returns_energy() {
    let curve = |rest: f64| [-20.0 + rest, rest - 10.0, rest, rest + 10.0, rest + 20.0];
    let (low, high) = (curve(100.0), curve(300.0));
    let cases = [
        (
            "gas_force",
            saturating(&["gas_preload"], 10.0, &[]),
            between_two(None, &[(number!("gas_force"), [80.0, 300.0])]),
            0.02,
        ),
        ("curve", saturating(&[], 10.0, &[]), between_two(Some([&low, &high]), &[]), 0.02),
        (
            "presliding_force",
            saturating(&["presliding_friction"], 1.0, &[("presliding_length", 3e-4)]),
            between_two(None, &[(number!("presliding_force"), [38.0, 900.0])]),
            1e-4,
        ),
    ];
    for (name, params, axis, amplitude) in cases {
        // Firm while the force assists the motion, and soft while it resists.
        let command = |_: u32, v: f64, last: f64| if v * last > 0.0 { 0.0 } else { 1.0 };
        let Work { done, gross, stored } = work(&params, &axis, sine(amplitude, 1.0), (4000, 1e-3), command).unwrap();
        assert!(done < -stored - 0.1 * gross, "{name}: {done} J of {gross} J, {stored} J");
        let constant = work(&params, &axis, sine(amplitude, 1.0), (4000, 1e-3), |_, _, _| 1.0).unwrap();
        assert!(constant.done > 0.0, "{name}: {} J at a constant setting", constant.done);
    }
}

/// The filter form of frequency-selective damping keeps a fraction of the force as a state. After slow loading at a
/// firm setting and a fast return at a soft setting, it returns more energy than it absorbed.
#[test]
fn a_lagging_force_returns_energy() {
    let changes = [("fsd_form", 0.0), ("fsd_share", 0.9), ("fsd_time", 10.0)];
    let params = saturating(&["frequency_selective_damping"], 1000.0, &changes);
    let soft = [-10.0, -10.0, 0.0, 10.0, 10.0];
    let axis = between_two(Some([&soft, &[-1000.0, -1000.0, 0.0, 1000.0, 1000.0]]), &[]);
    assert_eq!(axis.stores_energy().count(), 0, "no number of the axis shows it");
    // Rebound at 10 mm/s for 5 s, then compression at 1 m/s over the same 50 mm.
    let motion = |t: f64| if t <= 5.0 { (0.01 * t, 0.01) } else { (0.05 - (t - 5.0), -1.0) };
    let moved = |firm_at_the_end: bool| {
        let command = |i: u32, _: f64, _: f64| if i <= 5000 || firm_at_the_end { 1.0 } else { 0.0 };
        work(&params, &axis, motion, (5050, 1e-3), command).unwrap()
    };
    let (switched, constant) = (moved(false), moved(true));
    println!("taken: {:.2} J after a switch, {:.2} J at a constant setting", switched.done, constant.done);
    assert!(switched.done < -1.0 && constant.done > 0.0, "{} J, {} J", switched.done, constant.done);
}

#[test]
fn what_stores_energy_is_told() {
    let params = params(&[]);
    let of = |number: Number| over(&params, &[number]).stores_energy().map(|number| number.name()).collect::<Vec<_>>();
    assert_eq!(of(number!("gas_force")), ["gas_force"]);
    assert_eq!(of(number!("series_stiffness")), ["series_stiffness"]);
    for number in [number!("series_damping"), number!("viscous_coefficient"), number!("stribeck_coulomb_force")] {
        assert_eq!(of(number), Vec::<&str>::new());
    }
}
