//! Tests that the figures of the elements in the book match the forces of the kernel; `UPDATE_DOCS=1` redraws the
//! figures.

use dashpot_core::parameter::{ELEMENTS, GROUPS};
use dashpot_core::parameter::{Element, Number};
use dashpot_core::{Input, Model, Params, step};
use dashpot_tests::library::root;
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Figure of an element: the force under one sine motion, with the element and without it.
struct Case {
    element: &'static str,
    set: &'static [(&'static str, f64)],
    /// Amplitude, mm, and frequency, Hz.
    motion: (f64, f64),
    over: Over,
}

/// Quantity on the horizontal axis of a figure.
#[derive(Clone, Copy, PartialEq)]
enum Over {
    Velocity,
    Displacement,
}

use Over::{Displacement, Velocity};

const fn case(element: &'static str, set: &'static [(&'static str, f64)], motion: (f64, f64), over: Over) -> Case {
    Case { element, set, motion, over }
}

/// Cases of all elements, with parameters that make the effect of the element visible.
const CASES: &[Case] = &[
    case("fv_curve", &[], (25.0, 4.0), Velocity),
    case("series_compliance", &[("series_stiffness", 1e6)], (5.0, 15.0), Velocity),
    case("free_play", &[("free_play_gap", 5e-4)], (2.0, 4.0), Displacement),
    case(
        "bushing",
        &[("series_stiffness", 5e5), ("bushing_hardening", 3e-4), ("bushing_loss_stiffness", 3.0)],
        (1.0, 20.0),
        Displacement,
    ),
    case("oil_compressibility", &[("oil_stiffness", 8e5)], (3.0, 15.0), Velocity),
    case("aeration", &[("aeration_stroke", 1e-3)], (5.0, 6.0), Displacement),
    case("cavitation", &[("cavitation_force", 350.0)], (25.0, 4.0), Displacement),
    case("position_dependent_damping", &[("bypass_share", 0.5)], (50.0, 2.0), Displacement),
    case("temperature_fade", &[("fade_coefficient", 6e-3)], (25.0, 4.0), Velocity),
    case("frequency_selective_damping", &[("fsd_share", 0.5)], (8.0, 8.0), Velocity),
    case("valve_hysteresis", &[("valve_hysteresis_share", 0.6), ("valve_time", 0.015)], (25.0, 4.0), Velocity),
    case("parallel_spring", &[("spring_linear", 6e3)], (40.0, 0.5), Displacement),
    case("coulomb_friction", &[("coulomb_force", 60.0)], (10.0, 0.5), Velocity),
    case("stribeck_friction", &[("stribeck_breakaway_force", 120.0)], (10.0, 0.5), Velocity),
    case("viscous_friction", &[("viscous_coefficient", 400.0)], (25.0, 6.0), Velocity),
    case("side_force_friction", &[], (10.0, 0.5), Velocity),
    case("gas_preload", &[("gas_force", 250.0)], (25.0, 1.0), Velocity),
    case("gas_warming", &[("gas_warming_rate", 2.0)], (25.0, 1.0), Velocity),
    case("lagged_polynomial", &[], (5.0, 15.0), Velocity),
    case("presliding_friction", &[("presliding_force", 80.0)], (1.0, 0.5), Displacement),
    case("gas_spring", &[("gas_stiffness", 4e3), ("gas_length", 0.15)], (50.0, 0.5), Displacement),
    case("moving_mass", &[("moving_mass", 5.0)], (5.0, 15.0), Displacement),
    case("bump_stop", &[("bump_stop_clearance", 0.02)], (40.0, 1.0), Displacement),
    case("rebound_stop", &[("rebound_stop_clearance", 0.02)], (40.0, 1.0), Displacement),
];

/// Side force in all figures, N, so that the elements that respond to side force have an effect.
const SIDE_FORCE: f64 = 1500.0;
/// Temperature in all figures, °C. It differs from 20 °C, the temperature of the FV curve, so that the effect of
/// `temperature_fade` is visible.
const TEMPERATURE: f64 = 80.0;

/// Computes displacement, m, velocity, m/s, and force, N, over the last of three sine cycles. The motion has an
/// amplitude in mm and a frequency in Hz.
fn cycle(params: &Params, (mm, hertz): (f64, f64)) -> Vec<[f64; 3]> {
    const STEPS: u32 = 4000;
    let model = Model::new(params).expect("a model");
    let dt = 1.0 / (hertz * f64::from(STEPS));
    let at = |i: u32| {
        let phase = TAU * f64::from(i % STEPS) / f64::from(STEPS);
        let (x, v) = (1e-3 * mm * phase.sin(), 1e-3 * mm * TAU * hertz * phase.cos());
        Input { side_force: SIDE_FORCE, temperature: TEMPERATURE, ..Input::motion(x, v) }
    };
    let mut state = model.steady_state(&at(0));
    let mut points = Vec::new();
    for i in 1..=3 * STEPS {
        let (next, output) = step(&model, &state, &at(i), dt);
        state = next;
        if i >= 2 * STEPS && i % 20 == 0 {
            points.push([at(i).displacement.unwrap_or(0.0), at(i).velocity, output.force]);
        }
    }
    points
}

fn model(on: &[&str], set: &[(&str, f64)]) -> Params {
    let mut params = Params::new();
    params.disable_all();
    on.iter().for_each(|element| params.enable(Element::find(element).expect("an element"), true));
    set.iter()
        .for_each(|(name, value)| params.set(Number::find(name).expect("a parameter"), *value).expect("in bounds"));
    params
}

/// Returns a round distance of grid lines for an axis from −`span` to `span`. It is `span` divided by five, rounded up
/// to 1, 2 or 5 times a power of ten.
fn grid(span: f64) -> f64 {
    let rough = span / 5.0;
    let power = 10f64.powf(rough.log10().floor());
    power * [1.0, 2.0, 5.0, 10.0].into_iter().find(|f| f * power >= rough).unwrap_or(10.0)
}

/// Draws two force loops: of the damper without the element in gray, and with the element in color.
fn drawing(case: &Case) -> String {
    let (base, with): (&[&str], Vec<&str>) = match case.element {
        "fv_curve" => (&[], vec!["fv_curve"]),
        "series_compliance" => (&["fv_curve"], vec!["fv_curve", "series_compliance"]),
        element => (&["fv_curve", "series_compliance"], vec!["fv_curve", "series_compliance", element]),
    };
    let with = cycle(&model(&with, case.set), case.motion);
    let without = if base.is_empty() { Vec::new() } else { cycle(&model(base, &[]), case.motion) };
    let across = |p: &[f64; 3]| if case.over == Velocity { p[1] } else { 1e3 * p[0] };
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0f64, |m, v| m.max(v.abs()));
    let wide = 1.08 * most(&mut with.iter().map(across));
    let high = 1.08 * most(&mut with.iter().chain(&without).map(|p| p[2]));
    let (left, top, width, height) = (62.0, 14.0, 420.0, 236.0);
    let x = |value: f64| left + width * (0.5 + 0.5 * value / wide);
    let y = |value: f64| top + height * (0.5 - 0.5 * value / high);
    let mut out = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 500 300\" font-family=\"sans-serif\" font-size=\"11\" fill=\"#3a4550\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
    );
    let places = |most: f64| {
        let step = grid(2.0 * most);
        let count = (most / step).floor() as i32;
        (-count..=count).map(move |i| f64::from(i) * step).collect::<Vec<_>>()
    };
    // Positions of grid lines are multiples of a round step. Rounding to six decimals removes floating-point errors
    // from their labels.
    let number = |value: f64| format!("{}", (1e6 * value).round() / 1e6);
    for value in places(wide) {
        let (at, end) = (x(value), top + height);
        let _ = writeln!(
            out,
            "<path d=\"M{at:.1} {top} V{end}\" stroke=\"#dde3e8\"/><text x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            end + 15.0,
            number(value)
        );
    }
    for value in places(high) {
        let (at, end) = (y(value), left + width);
        let _ = writeln!(
            out,
            "<path d=\"M{left} {at:.1} H{end}\" stroke=\"#dde3e8\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            left - 6.0,
            at + 4.0,
            number(value)
        );
    }
    for (points, colour, thick) in [(&without, "#9aa5b0", 1.4), (&with, "#1f6fb4", 2.0)] {
        if points.is_empty() {
            continue;
        }
        let text: Vec<String> = points.iter().map(|p| format!("{:.1} {:.1}", x(across(p)), y(p[2]))).collect();
        let _ = writeln!(
            out,
            "<path d=\"M{} Z\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{thick}\"/>",
            text.join(" L")
        );
    }
    let below = if case.over == Velocity { "velocity, m/s" } else { "displacement, mm" };
    let _ = writeln!(
        out,
        "<text x=\"{:.0}\" y=\"290\" text-anchor=\"middle\">{below}   (sine of {} mm, {} Hz)</text>\
         <text transform=\"translate(13 {:.0}) rotate(-90)\" text-anchor=\"middle\">force, N</text>\n</svg>",
        left + width / 2.0,
        case.motion.0,
        case.motion.1,
        top + height / 2.0
    );
    out
}

#[test]
fn every_element_has_its_figure_in_the_book() {
    let page = std::fs::read_to_string(root().join("docs/book/src/model.md")).expect("the page of the model");
    for group in &GROUPS[..ELEMENTS] {
        let name = group.name;
        let case =
            CASES.iter().find(|c| c.element == name).unwrap_or_else(|| panic!("no figure for the element {name}"));
        assert!(page.contains(&format!("figures/element-{name}.svg")), "model.md does not show the element {name}");
        let path = root().join(format!("docs/book/src/figures/element-{name}.svg"));
        let drawn = drawing(case);
        if std::env::var_os("UPDATE_DOCS").is_some() {
            std::fs::write(&path, &drawn).unwrap();
        }
        let written = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(written == drawn, "{} is out of date; run this test with UPDATE_DOCS=1", path.display());
    }
}
