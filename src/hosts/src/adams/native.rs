//! Dataset fragment of a damper from Adams's own elements, which needs no user subroutine.
//!
//! The damper has splines for the FV curve, the parallel spring and friction, and two differential equations for the internal mass. A third
//! equation models presliding friction, which reverses within a short travel.
//!
//! The mass is not a PART, because a part needs a joint to the tube and a position in the model. The export does not know this position,
//! and a wrong position would violate the joint. Instead, equations move the mass along the line between the damper's markers, as in the
//! kernel. The displacement of the mass is relative to the moving end, so the initial value 0 holds at any length of the damper.

use dashpot_core::parameter::Element;
use dashpot_core::{Input, Model, Params, State, evaluate::force};
use dashpot_core::{element, number};
use std::fmt::Write as _;

/// Number of points of each spline.
const POINTS: usize = 161;
/// Largest displacement of the splines, mm.
const STROKE: f64 = 150.0;
/// Highest velocity of the splines, mm/s.
const FASTEST: f64 = 5000.0;
/// Velocity scale of the spacing of the splines' points, mm/s. The points are uniform in asinh(v / `FINE`), where v is the velocity, mm/s.
/// So half of them lie within ±71 mm/s.
const FINE: f64 = 2.0;

/// Elements that a spring, a damper, a mass and splines of velocity and displacement can represent. [`fragment`] rejects a model with any
/// other element, because the file would silently omit the element.
const HELD: [Element; 8] = [
    element!("fv_curve"),
    element!("series_compliance"),
    element!("parallel_spring"),
    element!("coulomb_friction"),
    element!("stribeck_friction"),
    element!("viscous_friction"),
    element!("presliding_friction"),
    element!("gas_preload"),
];

/// Writes the dataset fragment of a model whose length is `length`, mm, at zero displacement.
///
/// # Errors
/// Adams's elements cannot represent the model, and the error states the reason. A spline of velocity or displacement cannot represent an
/// element, or `series_compliance` is off, or friction and gas force act on the internal mass.
pub fn fragment(params: &Params, model: &Model, length: f64) -> Result<String, String> {
    if !params.is_on(element!("series_compliance")) {
        return Err("the element series_compliance is off".into());
    }
    let beyond: Vec<&str> =
        Element::all().filter(|e| params.is_on(*e) && !HELD.contains(e)).map(Element::name).collect();
    if !beyond.is_empty() {
        return Err(format!("splines of velocity and displacement cannot hold {}", beyond.join(", ")));
    }
    if model.elements().carries_whole() {
        return Err("with series_load = \"whole\" friction and gas force act on the internal mass".into());
    }
    // The internal mass gets the motion of the moving end, so that `force` returns the forces of the elements at this motion.
    let at = |x: f64, v: f64| {
        let state = State {
            mass_displacement: 1e-3 * x,
            mass_velocity: 1e-3 * v,
            ..model.steady_state(&Input::motion(0.0, 0.0))
        };
        force(model, &state, &Input::motion(1e-3 * x, 1e-3 * v))
    };
    let velocities = spaced(|s| FINE * libm::sinh(s * libm::asinh(FASTEST / FINE)));
    let displacements = spaced(|s| STROKE * s);
    let primary = spline(1, &velocities, |v| at(0.0, v).primary_force);
    let spring = spline(2, &displacements, |x| at(x, 0.0).spring_force);
    // The friction spline contains only velocity-dependent friction, because a differential equation models presliding friction.
    let mut of_velocity = *params;
    of_velocity.enable(element!("presliding_friction"), false);
    let sliding = Model::new(&of_velocity).map_err(|fault| fault.reason.text().to_owned())?;
    let friction = spline(3, &velocities, |v| {
        let state = sliding.steady_state(&Input::motion(0.0, 0.0));
        force(&sliding, &State { mass_velocity: 1e-3 * v, ..state }, &Input::motion(0.0, 1e-3 * v)).friction_force
    });
    let (contact, bent) = presliding(params).unwrap_or_default();
    Ok(include_str!("templates/native.adm")
        .replace("{contact}\n", &contact)
        .replace("{bent}", &bent)
        .replace("{splines}", format!("{primary}{spring}{friction}").trim_end())
        .replace("{series_stiffness}", &format!("{:?}", 1e-3 * params.number(number!("series_stiffness"))))
        .replace("{series_damping}", &format!("{:?}", 1e-3 * params.number(number!("series_damping"))))
        .replace("{mass}", &format!("{:?}", params.number(number!("internal_mass"))))
        .replace("{gas}", &format!("{:?}", -at(0.0, 0.0).gas_force))
        .replace("{length}", &format!("{length:?}")))
}

/// Returns presliding friction: the equation of its contact deflection in mm, and the force that it adds to the SFORCE. Returns `None` if
/// the element is off.
fn presliding(params: &Params) -> Option<(String, String)> {
    if !params.is_on(element!("presliding_friction")) {
        return None;
    }
    let [level, length, power, elastic, creep] = [
        number!("presliding_force"),
        number!("presliding_length"),
        number!("presliding_power"),
        number!("presliding_return"),
        number!("presliding_creep"),
    ]
    .map(|number| params.number(number));
    let (length, creep) = (1e3 * length, 1e3 * creep);
    let shape = if power == 1.0 { String::new() } else { format!("*ABS(DIF(3)/{length:?})**{:?}", power - 1.0) };
    // With elastic return, `slips` is 1 if velocity and contact deflection have the same sign (loading), and 0 otherwise (unloading).
    let slips = if elastic == 1.0 { "(0.5+SIGN(0.5,VR(11,12)*DIF(3)))*" } else { "" };
    let rate = format!("VR(11,12)\n, -{slips}SQRT(VR(11,12)**2+{:?})*DIF(3)/{length:?}{shape}", creep * creep);
    let contact = format!(
        "! Friction that turns over within a short travel: the bent contact, which statics leave as it is.\nDIFF/3\n, IC = 0\n, STATIC_HOLD\n, FUNCTION = {rate}\n"
    );
    Some((contact, format!("-{:?}*DIF(3)", level / length)))
}

/// Returns [`POINTS`] abscissae that are symmetric about 0. The function `of` maps the range −1 to 1 to the abscissae.
fn spaced(of: impl Fn(f64) -> f64) -> Vec<f64> {
    let half = (POINTS / 2) as f64;
    (0..POINTS).map(|i| of((i as f64 - half) / half)).collect()
}

fn spline(id: usize, x: &[f64], y: impl Fn(f64) -> f64) -> String {
    let mut out = format!("SPLINE/{id}\n");
    for (name, values) in [("X", x.to_vec()), ("Y", x.iter().map(|x| y(*x)).collect())] {
        for (i, values) in values.chunks(5).enumerate() {
            let row: Vec<String> = values.iter().map(|v| format!("{v:.9e}")).collect();
            let _ = writeln!(out, ", {}{}", if i == 0 { format!("{name} = ") } else { String::new() }, row.join(", "));
        }
    }
    out
}
