//! Documentation page of an FMU.

use super::variables::{Kind, Variable};
use std::fmt::Write as _;

/// Escapes a text for HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

/// Text at the beginning of the page, equal for every damper.
const SIGNS_AND_INSTANTS: &str = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>dashpot damper</title></head><body>\n\
     <h1>dashpot damper</h1>\n\
     <p>A suspension damper identified from rig records. Motion in, force out. The damper starts as if it had \
     long moved with its first inputs: at rest where their velocity is 0, else in steady motion; a step runs from one communication point to the next. An input that \
     is not finite holds the last force, and the status says so. A step of length 0 is a static answer.</p>\n\
     <p><b>Signs.</b> motion_scale and force_scale change from the host's signs, units and motion ratio to the damper's \
     (extension and tension positive, SI). Force times velocity, both as the damper counts them, must be positive on \
     average: if your vehicle swings up, one of the two signs is wrong.</p>\n\
     <p><b>Units.</b> Displacement, velocity, force and its slopes are declared in the unit that the start values of motion_scale and \
     force_scale stand for, such as mm at 0.001 and kN at 0.001; an importer that knows units converts from there. Where a scale stands \
     for no unit, because a motion ratio is in it, none is declared and the meaning says the factor. Set a motion ratio in the \
     importer, and the declared units stay right; a change of unit needs another export. Everything else is in SI (temperatures in \
     degrees Celsius), states and side force too, whatever the scales.</p>\n\
     <p><b>Zero.</b> position_offset is the damper's extension, in m from the zero of the rig where it was measured, at the \
     importer's displacement 0.</p>\n\
     <p><b>Inputs between communication points</b> (inputs_between_points). <i>hold</i>: the values set before a step count at \
     its end. An importer that sets what it knows at the step's end loses nothing; one that sets what it knows at its \
     beginning, as the standard has it, gets the force one step late. <i>extrapolate</i>: the values set before a step count \
     at its beginning, and run on along the line through the last two: the force is in time, and a jump of velocity overshoots \
     for one step. <i>automatic</i>: held in co-simulation, extrapolated in model exchange, where the time of each input is known. \
     In FMI 2.0 fmi2SetRealInputDerivatives (order 1) goes before either. Directional derivatives of a step are those \
     by the motion at its end.</p>\n\
     <table border=\"1\">\n<tr><th>call</th><th>instant</th><th>what it does</th></tr>\n\
     <tr><td>set inputs, initialise</td><td>0</td><td>settled at the inputs: at rest, or in steady motion</td></tr>\n\
     <tr><td>get force</td><td>0</td><td>static force</td></tr>\n\
     <tr><td>set inputs</td><td>t (extrapolate, derivatives) or t + h (hold)</td><td>nothing yet</td></tr>\n\
     <tr><td>doStep(t, h)</td><td></td><td>moves the damper from t to t + h</td></tr>\n\
     <tr><td>get force</td><td>t + h</td><td>the force at the step's end</td></tr>\n</table>\n";

/// Paragraph about the parameters of the elements, for an FMU whose variables include these parameters.
const TUNABLE: &str = "<p><b>Parameters.</b> The numbers of the damper are tunable: they act from the next step on. A number outside its bounds is \
     refused when it is set, and the old one stays. Numbers that must fit together, such as the points of a curve, which must not fall, may be set \
     one after the other: each is kept as it is written and can be read back. The set is judged as a whole at the end of the initialization mode \
     (and where an output is asked for in it), at the next step, and in model exchange at the end of event mode. Where it does not fit together, \
     that call is an error, the log names the parameter and says what is wrong, and nothing has moved: set numbers that fit, and the same call \
     succeeds. A reset or a saved state leads back to the numbers of its time. No step is made with half of a set. Importers may end a run at an \
     error, so set what belongs together between two steps.</p>\n";
/// Paragraph about the parameters of the elements, for an FMU that conceals them.
const HIDDEN: &str = "<p>The identified numbers of this damper are not among its variables: it runs with those that it was exported with.</p>\n";

/// Beginning of the table of variables.
const HEADINGS: &str = "<table border=\"1\">\n<tr><th>name</th><th>unit</th><th>start</th><th>meaning</th></tr>\n";

/// Writes `documentation/index.html`. `remarks` are important notes on this damper. A remark that repeats for several corners appears once.
pub fn page(variables: &[Variable], remarks: &[String]) -> String {
    let mut out = String::from(SIGNS_AND_INSTANTS);
    for (i, remark) in remarks.iter().enumerate() {
        if !remarks[..i].contains(remark) {
            let _ = writeln!(out, "<p><b>This damper.</b> {}</p>", escaped(remark));
        }
    }
    let is_open = variables.iter().any(|v| matches!(v.kind, Kind::Parameter | Kind::Choice));
    out.push_str(if is_open { TUNABLE } else { HIDDEN });
    out.push_str(HEADINGS);
    for v in variables.iter().filter(|v| !matches!(v.kind, Kind::State | Kind::Rate | Kind::Time | Kind::SpeedMargin)) {
        let start = v.start.map_or(String::new(), |s| s.to_string());
        let meaning = escaped(&v.meaning);
        let _ = writeln!(out, "<tr><td>{}</td><td>{}</td><td>{start}</td><td>{meaning}</td></tr>", v.name, v.unit.name);
    }
    out.push_str("</table>\n</body></html>\n");
    out
}
