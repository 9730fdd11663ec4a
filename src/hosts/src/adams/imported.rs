//! Import of a model from an Adams Car property file, TeimOrbit or XML.

use super::akima::{self, Difference};
use super::property;
use anyhow::{Context as _, anyhow};
use dashpot_core::Params;
use dashpot_core::curve::{Interpolation, MAX_POINTS};
use dashpot_core::elements::fv_curve::choice_of_interpolation;
use dashpot_core::parameter::Number;
use dashpot_core::{element, list, number};
use dashpot_identification::model_file;
use dashpot_identification::model_file::prepared;
use std::path::Path;

/// Model file made from a property file.
pub struct Imported {
    /// Text of the model file.
    pub text: String,
    /// Number of points of the model's curve.
    pub points: usize,
    /// Message about the gas force of the model, and about the elements that are off.
    pub other_contents: String,
    /// Remarks on a force at rest that became gas force, on the difference from Adams's interpolation, and on omitted contents. The text
    /// contains these remarks as comments.
    pub remarks: Vec<String>,
}

/// Makes a model file from a property file: its FV curve, and its gas force if it has one.
///
/// # Errors
/// The file cannot be read, or it does not give a valid model.
pub fn of_property_file(path: &Path) -> anyhow::Result<Imported> {
    let named = || path.display().to_string();
    let bytes = dashpot_records::read_small(path).with_context(|| format!("cannot read {}", named()))?;
    let mut read = property::read(&bytes).with_context(named)?;
    let rows = read.curve.velocities.len();
    let constant = constant_force(&mut read);
    // Adams does not use Akima's method for a linear rate, or for a spline whose `interpolation_method` is linear.
    let (curve, interpolation, remark) = if read.linear {
        let (curve, left) = akima::read_linear(read.curve);
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
    let choice = choice_of_interpolation(interpolation);
    if choice != number!("fv_interpolation").default() {
        set(&mut params, number!("fv_interpolation"), choice)?;
    }
    if read.gas_force != 0.0 {
        params.enable(element!("gas_preload"), true);
        let fault =
            |error| if constant.is_some() { constant_too_large(&named(), read.gas_force, error) } else { error };
        set(&mut params, number!("gas_force"), read.gas_force).map_err(fault)?;
    }
    prepared(&params).with_context(named)?;
    let flat = model_file::flat(&params, |row| format!("{}; {}", row.parameter.unit, row.parameter.meaning));
    let file = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let mut text = format!("# Read from {}.\n", file.escape_debug());
    for note in &read.notes {
        text += &format!("# Left out: {}.\n", note.escape_debug());
    }
    for remark in constant.iter().chain(&remark) {
        text += &format!("# {remark}\n");
    }
    let other_contents = if read.gas_force == 0.0 {
        "friction, gas and series stiffness are off".to_owned()
    } else {
        format!("a gas force of {} N; friction and series stiffness are off", read.gas_force)
    };
    let left_out = read.notes.iter().map(|note| format!("left out: {note}"));
    Ok(Imported {
        text: text + "\n" + &flat,
        points: curve.velocities.len(),
        other_contents,
        remarks: constant.into_iter().chain(remark).chain(left_out).collect(),
    })
}

/// Largest force at zero velocity, relative to the largest force of the curve, that counts as a rounding error and stays in the curve.
const AT_REST: f64 = 1e-6;

/// Moves the force of the curve at zero velocity to the gas force, and returns a remark on it. Returns `None`, and moves nothing, if this
/// force is a rounding error.
///
/// The FV curve of a damper is zero at zero velocity. A force that acts at rest also acts at every velocity, so it is not damping.
fn constant_force(read: &mut property::Properties) -> Option<String> {
    let rest = akima::at_rest(&read.curve, read.linear);
    let largest = read.curve.forces.iter().fold(0.0f64, |most, f| most.max(f.abs()));
    if rest.abs() <= AT_REST * largest {
        return None;
    }
    read.curve.forces.iter_mut().for_each(|f| *f -= rest);
    read.gas_force -= rest;
    Some(format!(
        "The curve of the file has {rest:.1} N at rest. That is no damping: it stands in gas_force, {:.1} N where it pushes the rod out, and the curve \
         is what is left.",
        read.gas_force
    ))
}

fn constant_too_large(named: &str, force: f64, error: anyhow::Error) -> anyhow::Error {
    error.context(format!("{named}: the curve leaves a force of {force:.1} N at rest, which is taken for the gas force; look at its row at velocity 0"))
}

/// Describes the difference between the model's curve and Adams's interpolation of the points in the file.
fn as_adams_reads_it(rows: usize, points: usize, left: &Difference) -> String {
    let so = format!("The model's curve differs from that of Adams by {}.", left.describe());
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

/// Describes the difference between the curves of file and model, if the curve of the model has fewer points.
fn fewer(rows: usize, points: usize, left: &Difference) -> String {
    format!(
        "The file has {rows} points and a model's curve at most {MAX_POINTS}: {points} points of its curve stand for them, and differ from it by {}.",
        left.describe()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn imported(text: &str) -> Imported {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("damper.dpr");
        std::fs::write(&path, text).unwrap();
        of_property_file(&path).unwrap()
    }

    const HEAD: &str = "[UNITS]\nLENGTH='mm'\nFORCE='newton'\nTIME='second'\n[CURVE]\n";

    /// The sum of the model's curve and gas force equals the curve of the file, with and without a row at zero velocity.
    #[test]
    fn a_force_at_rest_is_gas_and_the_curve_has_none() {
        for (rows, forces) in [
            ("-500 -720\n-100 -470\n0 -120\n100 80\n500 780\n", Some(120.0)),
            ("-500 -720\n-100 -470\n-50 -295\n50 55\n100 80\n500 780\n", None),
            ("-500 -600\n-100 -350\n0 0\n100 200\n500 900\n", Some(0.0)),
        ] {
            let made = imported(&format!("{HEAD}{rows}"));
            let mut params = Params::new();
            dashpot_core::model_file::read(made.text.as_bytes(), &mut params).unwrap();
            let model = dashpot_core::Model::new(&params).unwrap();
            let gas = if params.is_on(element!("gas_preload")) { params.number(number!("gas_force")) } else { 0.0 };
            let fv = model.elements().paths.fv_curve;
            assert!(fv.evaluate(0.0).value.abs() < 1.0, "{}", fv.evaluate(0.0).value);
            if let Some(wanted) = forces {
                assert!((gas - wanted).abs() < 1e-9, "{gas}");
            }
            assert_eq!(gas != 0.0, made.remarks[0].contains("at rest"), "{:?}", made.remarks);
            for row in rows.lines() {
                let numbers: Vec<f64> = row.split(' ').map(|n| n.parse().unwrap()).collect();
                let own = fv.evaluate(1e-3 * numbers[0]).value - gas;
                assert!((own - numbers[1]).abs() < 0.02 * 780.0, "{row}: {own}");
            }
        }
    }
}
