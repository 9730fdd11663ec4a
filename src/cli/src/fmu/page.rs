//! The FMU's documentation page.

use super::variables::{Kind, Variable};
use std::fmt::Write as _;

/// `documentation/index.html`.
pub fn page(variables: &[Variable]) -> String {
    let mut out = String::from(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>dashpot damper</title></head><body>\n\
         <h1>dashpot damper</h1>\n\
         <p>A suspension damper identified from rig records. Motion in, force out. The damper starts at rest in its first \
         position; a step runs from one communication point to the next, and the input is the one at its end. An input that \
         is not finite holds the last force, and the status says so. A step of length 0 is a static answer.</p>\n\
         <p><b>Signs.</b> motion_scale and force_scale change from the host's signs, units and motion ratio to the damper's \
         (extension and tension positive, SI). Force times velocity, both as the damper counts them, must be positive on \
         average: if your vehicle swings up, one of the two signs is wrong.</p>\n\
         <p>Number parameters are tunable: they act from the next step on. A set that does not fit together (such as a curve \
         that falls) is refused with a message, and the old one stays.</p>\n<table border=\"1\">\n\
         <tr><th>name</th><th>unit</th><th>start</th><th>meaning</th></tr>\n",
    );
    for v in variables.iter().filter(|v| !matches!(v.kind, Kind::State | Kind::Rate | Kind::Time)) {
        let start = v.start.map_or(String::new(), |s| s.to_string());
        let meaning = v.meaning.replace('&', "&amp;").replace('<', "&lt;");
        let _ = writeln!(out, "<tr><td>{}</td><td>{}</td><td>{start}</td><td>{meaning}</td></tr>", v.name, v.unit);
    }
    out.push_str("</table>\n</body></html>\n");
    out
}
