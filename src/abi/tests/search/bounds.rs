//! Bounds of the force of a case: the sum of the forces of its elements along its motion, and the forces in short steps.

use crate::case::{Case, Failure, Given, Run, prepare};
use dashpot_core::parameter::{Acts, Element, Number, acts};

/// Bounds with which a force is compared.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Against {
    /// Two bounds: the elements' forces along the motion, and the forces in short steps. A force that exceeds both is an
    /// error.
    Possible,
    /// The forces in short steps alone. Forces below the sum of the single elements' forces are not compared.
    ///
    /// This bound detects a mass whose natural frequency long steps shift to the frequency of the imposed motion.
    ShortSteps,
}

/// Returns whether the force of an element depends only on the motion of the moving end. Such a force needs no solution of an equation.
fn is_parallel(name: &str) -> bool {
    matches!(place_of(name), Some(Acts::Friction | Acts::Preload | Acts::Stateful | Acts::Stop))
}

/// Returns whether an element is friction whose force depends on the instantaneous velocity.
fn is_friction(name: &str) -> bool {
    place_of(name) == Some(Acts::Friction)
}

/// Returns the position of an element in the model; `None` for a name of no element.
fn place_of(name: &str) -> Option<Acts> {
    Element::find(name).ok().map(|element| acts(element.place()))
}

/// Numbers of substeps with which implicit Euler is tried if a force exceeds the bound from implicit Euler with 32 substeps.
///
/// Implicit Euler dissipates the energy of every oscillation, and less with shorter steps. For a mass with free play, short steps of all
/// other methods gave 24 kN. Implicit Euler gave 1 kN with 32 substeps and 20 kN with 2048.
const FINEST: [usize; 2] = [512, 2048];

/// Largest allowed ratio of a run's force to the force in short steps. A fifth of the elements' force is allowed in addition.
const SHORT_STEPS: f64 = 1.5;

fn largest(forces: &[f64]) -> f64 {
    forces.iter().fold(0.0, |top, f| f.abs().max(top))
}

/// Divides each step of the case into `parts` substeps along the same cubic paths.
fn finer(case: &Case, parts: usize) -> Case {
    let (mut x0, mut v0) = (case.start, 0.0);
    let mut fine = Case { motion: Vec::with_capacity(case.motion.len() * parts), ..case.clone() };
    for g in &case.motion {
        let x1 = g.x.unwrap_or(x0 + 0.5 * g.dt * (v0 + g.v));
        let (dx, p1, q1) = (x1 - x0, g.dt * v0, g.dt * g.v);
        let (p2, p3) = (3.0 * dx - 2.0 * p1 - q1, p1 + q1 - 2.0 * dx);
        for part in 1..=parts {
            let t = part as f64 / parts as f64;
            let x = x0 + t * (p1 + t * (p2 + t * p3));
            let v = if part == parts { g.v } else { (p1 + t * (2.0 * p2 + t * 3.0 * p3)) / g.dt };
            fine.motion.push(Given { x: Some(x), v, dt: g.dt / parts as f64, ..*g });
        }
        (x0, v0) = (x1, g.v);
    }
    fine
}

/// Returns the highest speed, m/s, of the moving end on its cubic paths.
fn fastest(case: &Case) -> f64 {
    finer(case, 4).motion.iter().fold(0.0, |top, g| g.v.abs().max(top))
}

/// Elements that multiply the force of the FV curve instantaneously.
///
/// They multiply the force of a cold damper by up to twenty. If the bound ignored them, this force would count as an error.
const SCALING: [&str; 2] = ["temperature_fade", "position_dependent_damping"];

/// Returns the largest force, N, of the FV curve at 0 and ±`speed`, m/s, at the positions and temperatures of the run.
fn curve(case: &Case, found: &Run, speed: f64) -> f64 {
    let mut alone = Case { motion: Vec::new(), start: 0.0, ..case.clone() };
    alone.on.retain(|name| *name == "fv_curve" || SCALING.contains(name));
    for (place, g) in found.places.iter().zip(&case.motion) {
        alone.motion.extend([speed, -speed, 0.0].map(|v| Given { x: Some(*place), v, side: 0.0, dt: 1e-3, ..*g }));
    }
    run(&alone).map_or(0.0, |run| largest(&run.forces))
}

/// Returns the largest friction, N, behind the series spring up to `speed`, m/s, or 0 if the friction does not act there.
///
/// The friction acts on the internal mass. Whatever the motion of the host, the mass passes every velocity between zero and the given velocity.
/// Friction that decreases with velocity has two equilibria with the spring, stuck and sliding. The step size decides between them, and
/// both are forces of the element.
fn stuck(case: &Case, speed: f64) -> f64 {
    if !case.values.iter().any(|(name, value)| *name == "series_load" && value[0] == 1.0) {
        return 0.0;
    }
    let mut alone = Case { motion: Vec::new(), start: 0.0, ..case.clone() };
    alone.on.retain(|name| is_friction(name));
    // Side force and temperature are constant in an ordinary motion.
    let Some(given) = case.motion.first() else { return 0.0 };
    let mut v = speed;
    // The lowest break-away velocity that the parameter table allows is 1e-5 m/s. With a ratio of 1.1 between velocities, the result lacks
    // at most a hundredth of the largest friction.
    while v > 1e-7 {
        alone.motion.extend([v, -v].map(|v| Given { x: Some(0.0), v, dt: 1e-3, ..*given }));
        v /= 1.1;
    }
    run(&alone).map_or(0.0, |run| largest(&run.forces))
}

/// Returns a parameter of a case: its value, or its default.
fn number(case: &Case, name: &str) -> f64 {
    let set = case.values.iter().find(|(n, _)| *n == name).map(|(_, v)| v[0]);
    set.unwrap_or_else(|| dashpot_core::Params::new().number(Number::find(name).unwrap()))
}

/// Returns the force, N, with which the series spring and its damper stop the internal mass from `speed`, m/s.
///
/// The mass includes the moving mass if that is attached to the internal mass.
fn caught(case: &Case, speed: f64) -> f64 {
    if !case.on.contains(&"series_compliance") {
        return 0.0;
    }
    let number = |name: &str| number(case, name);
    let (mut mass, mut stiffness) = (number("internal_mass"), number("series_stiffness"));
    if case.on.contains(&"moving_mass") && number("moving_mass_place") == 1.0 {
        mass += number("moving_mass");
    }
    if case.on.contains(&"bushing") {
        stiffness *=
            1.0 + ["loss", "slow", "stop"].iter().map(|s| number(&format!("bushing_{s}_stiffness"))).sum::<f64>();
    }
    speed * ((stiffness * mass).sqrt() + number("series_damping"))
}

/// Returns the total variation, m/s, of the moving end's velocity along its cubic paths.
fn turned(case: &Case) -> f64 {
    let mut last = 0.0;
    finer(case, 8).motion.iter().fold(0.0, |sum, g| sum + (g.v - std::mem::replace(&mut last, g.v)).abs())
}

/// Returns the force, N, of the series path if its spring stores all energy that the imposed motion can supply to the mass.
///
/// Relative to the moving end, the mass gains at most the velocity change of that end, whatever the spring. The estimate assumes no
/// damping.
fn thrown(case: &Case) -> f64 {
    let speed = turned(case);
    let straight = caught(case, speed);
    if straight == 0.0 || !case.on.contains(&"bushing") {
        return straight;
    }
    // Rubber has the stiffness k and the hardening deflection d_h. At a deflection d, its energy is ½ k d² (1 + ½ d²/d_h²) and its force k
    // d (1 + d²/d_h²).
    let stiffness = number(case, "series_stiffness");
    let unit = stiffness * number(case, "bushing_hardening");
    let (times, square) = (straight / unit, (straight / unit) * (straight / unit));
    let deflection = ((1.0 + 2.0 * square).sqrt() - 1.0).sqrt();
    unit * (times + deflection * (1.0 + deflection * deflection))
}

/// Approximate largest ratio of the force of a lagging valve to the FV curve. The leakage of a closed valve limits it to 101.
const SHUT: f64 = 100.0;

/// Returns the largest force, N, of the elements along the motion, with the worst timing.
///
/// It assumes that no damper absorbs the energy of the mass. It also assumes that a valve with an internal state is closed at the highest
/// speed of the piston.
///
/// As in [`check`], the sum is doubled, because the mass may be twice as fast as the moving end and the forces of elements add up.
fn most(case: &Case, found: &Run) -> f64 {
    let speed = fastest(case);
    let late = case.on.contains(&"valve_hysteresis") && number(case, "valve_form") > 0.0;
    let curve = if late { SHUT } else { 1.0 } * curve(case, found, 3.0 * speed);
    2.0 * (parallel(case).max(stuck(case, 3.0 * speed)) + curve + thrown(case)) + 100.0
}

fn run(case: &Case) -> Option<Run> {
    case.run(&*prepare(case)?, false).ok()
}

/// Returns the largest force, N, of the elements that depend only on the motion of the moving end.
fn parallel(case: &Case) -> f64 {
    let mut alone = case.clone();
    alone.on.retain(|name| is_parallel(name));
    run(&alone).map_or(0.0, |run| largest(&run.forces))
}

/// Returns the case with another integration method and number of substeps.
fn by(case: &Case, method: f64, substeps: f64) -> Case {
    let mut other = case.clone();
    other.values.retain(|(name, _)| *name != "method" && *name != "substeps");
    other.values.push(("method", vec![method]));
    other.values.push(("substeps", vec![substeps]));
    other
}

/// Describes the first similar damper whose force in short steps would explain the case. If there is none, describes the similar
/// damper with the largest force.
///
/// An integration method shifts the natural frequency of a mass that its steps hardly resolve. A heavier mass or a softer spring may have,
/// in short steps, the force of the case in long steps. Then the case shows only this shift of a resonance.
fn nearby(fine: &Case, top: f64) -> String {
    let with = |changes: &[(&'static str, f64)]| {
        let mut other = fine.clone();
        for (name, times) in changes {
            let value = times * number(fine, name);
            other.values.retain(|(n, _)| n != name);
            other.values.push((name, vec![value]));
        }
        run(&other).map_or(0.0, |run| largest(&run.forces))
    };
    // Try quarter octaves up to a factor of eight. A step size of a third of the period shifts a natural frequency by this factor.
    let mut best = (0.0, String::new());
    for times in (1..=12).map(|k| f64::powf(2.0, f64::from(k) / 4.0)) {
        for (what, changes) in [
            ("a mass {} times as heavy", vec![("internal_mass", times), ("moving_mass", times)]),
            ("a series spring {} times as soft", vec![("series_stiffness", 1.0 / times)]),
        ] {
            let force = with(&changes);
            if force > best.0 && SHORT_STEPS * best.0 < top {
                best = (force, what.replace("{}", &format!("{times:.2}")));
            }
        }
    }
    format!("; with {} these come to {:.2} of it", best.1, best.0 / top)
}

/// Returns whether the force `top` exceeds the bound from short steps (`same`) or from implicit Euler in short steps (`euler`). Both bounds
/// increase with the sum `elements` of the single elements' forces. All are in N.
fn is_beyond(top: f64, same: f64, euler: f64, elements: f64) -> bool {
    top > SHORT_STEPS * same + 0.2 * elements || top > 10.0 * euler + elements
}

/// Compares the forces of a run with the sum of the single elements' forces, and larger forces with the forces in short steps.
///
/// Unless `thorough` is set, omits [`FINEST`] and the similar dampers, which take a thousand times as long as the run.
pub fn check(case: &Case, found: &Run, against: Against, thorough: bool) -> Result<(), Failure> {
    let top = largest(&found.forces);
    let speed = fastest(case);
    let elements = 2.0
        * (parallel(case).max(stuck(case, 3.0 * speed)) + curve(case, found, 3.0 * speed) + caught(case, 2.0 * speed))
        + 100.0;
    if top <= elements {
        return Ok(());
    }
    let step = found.forces.iter().position(|f| f.abs() == top).unwrap_or(0);
    let parts = 32;
    let until = Case { motion: case.motion[..=step.min(case.motion.len() - 1)].to_vec(), ..case.clone() };
    let fine = finer(&until, parts);
    let largest_of = |case: &Case| run(case).map_or(f64::INFINITY, |run| largest(&run.forces));
    let (same, mut euler) = (largest_of(&fine), largest_of(&by(&fine, 2.0, 1.0)));
    if thorough && is_beyond(top, same, euler, elements) {
        for parts in FINEST {
            euler = euler.max(largest_of(&by(&finer(&until, parts), 2.0, 1.0)));
        }
    }
    let is_possible = against == Against::Possible && top <= most(case, found);
    if is_beyond(top, same, euler, elements) && !is_possible {
        return Err(Failure {
            step,
            by: top / same.min(10.0 * euler),
            what: format!(
                "{top:.4e} N, where the elements make {elements:.4e} N and steps of 1/{parts} come to {same:.4e} N, implicit Euler to {euler:.4e} N{}",
                if thorough { nearby(&fine, top) } else { String::new() }
            ),
        });
    }
    Ok(())
}
