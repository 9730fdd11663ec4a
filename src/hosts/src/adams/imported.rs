//! A model from an Adams Car property file, TeimOrbit or XML.

use super::akima::{self, Difference};
use super::property;
use anyhow::{Context as _, anyhow};
use dashpot_core::Params;
use dashpot_core::curve::{Interpolation, MAX_POINTS};
use dashpot_core::parameter::Number;
use dashpot_core::{element, list, number};
use dashpot_identification::model_file;
use dashpot_identification::model_file::prepared;
use std::path::Path;

/// A model file made from a property file.
pub struct Imported {
    /// Its text.
    pub text: String,
    /// Points of its curve.
    pub points: usize,
    /// What there is beside the curve, and what not.
    pub beside: String,
    /// How far the curve follows the one that Adams makes of the file, and what was left out; the text has it as comments.
    pub remarks: Vec<String>,
}

/// The model file of a property file: its curve, and the gas force where it has one.
///
/// # Errors
/// What cannot be read, or makes no model.
pub fn of_property_file(path: &Path) -> anyhow::Result<Imported> {
    let named = || path.display().to_string();
    let bytes = std::fs::read(path).with_context(|| format!("cannot read {}", named()))?;
    let read = property::read(&bytes).with_context(named)?;
    let rows = read.curve.velocities.len();
    // A linear rate, or a spline that says it is straight, is not read by Akima.
    let (curve, interpolation, remark) = if read.straight {
        let (curve, left) = akima::read_straight(read.curve);
        let remark = (rows > MAX_POINTS).then(|| fewer(rows, curve.velocities.len(), &left));
        (curve, Interpolation::Linear, remark)
    } else {
        let (curve, interpolation, left) = akima::read(read.curve);
        let remark = as_adams_reads_it(rows, curve.velocities.len(), &left);
        (curve, interpolation, Some(remark))
    };
    let mut params = Params::new();
    params.disable_all();
    params.enable(element!("fv_curve"), true);
    for (list, values) in [(list!("fv_velocity"), &curve.velocities), (list!("fv_force"), &curve.forces)] {
        params.set_list(list, values).map_err(|fault| anyhow!("{}: {list} {}", named(), fault.reason.text()))?;
    }
    let set = |params: &mut Params, number: Number, value: f64| {
        params.set(number, value).map_err(|fault| anyhow!("{}: {number} {}", named(), fault.reason.text()))
    };
    if interpolation == Interpolation::Linear {
        set(&mut params, number!("fv_interpolation"), 1.0)?;
    }
    if read.gas_force != 0.0 {
        params.enable(element!("gas_preload"), true);
        set(&mut params, number!("gas_force"), read.gas_force)?;
    }
    prepared(&params).with_context(named)?;
    let flat = model_file::flat(&params, |row| format!("{}; {}", row.parameter.unit, row.parameter.meaning));
    let file = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let mut text = format!("# Read from {}.\n", file.escape_debug());
    for note in &read.notes {
        text += &format!("# Left out: {}.\n", note.escape_debug());
    }
    if let Some(remark) = &remark {
        text += &format!("# {remark}\n");
    }
    let beside = if read.gas_force == 0.0 {
        "friction, gas and series stiffness are off".to_owned()
    } else {
        format!("a gas force of {} N; friction and series stiffness are off", read.gas_force)
    };
    let left_out = read.notes.iter().map(|note| format!("left out: {note}"));
    Ok(Imported {
        text: text + "\n" + &flat,
        points: curve.velocities.len(),
        beside,
        remarks: remark.into_iter().chain(left_out).collect(),
    })
}

/// How far the model's curve follows the one that Adams makes of the file.
fn as_adams_reads_it(rows: usize, points: usize, left: &Difference) -> String {
    let so = format!("The model's curve differs from that of Adams by {}.", left.told());
    let reads = "Adams Car joins the points of the file by Akima's method (AKISPL).";
    if rows > MAX_POINTS {
        return format!("{reads} {}", fewer(rows, points, left));
    }
    match points - rows {
        0 => format!("{reads} {so}"),
        added if left.is_small() => {
            format!("{reads} {added} points of that curve were added to those of the file. {so}")
        }
        added => format!(
            "{reads} {added} points of that curve were added to those of the file. {so} It cannot come nearer: a model's curve has at most \
             {MAX_POINTS} points and never falls, and Akima's curve may fall between two points, beside a steep place."
        ),
    }
}

/// How far fewer points stand for those of the file.
fn fewer(rows: usize, points: usize, left: &Difference) -> String {
    format!(
        "The file has {rows} points and a model's curve at most {MAX_POINTS}: {points} points of its curve stand for them, and differ from it by {}.",
        left.told()
    )
}
