//! Text file `NAME.pluginfo` next to an FMU. With this file, IPG CarMaker uses the FMU as the damper of a suspension (model class
//! `Susp_Damper`).
//!
//! The file maps quantities of CarMaker to variables of the FMU. Its format follows the templates of IPG: see `vi-crt-bridge/FACTS.md`.

use super::scales::Scales;
use crate::damper_length::{LONGEST, SHORTEST};
use crate::plain_curve::PlainCurve;
use anyhow::bail;
use dashpot_messages::format_number;
use std::fmt::Write as _;

impl Scales {
    /// Returns the scales for CarMaker.
    ///
    /// CarMaker passes the length of the damper, m, and its velocity, m/s, positive in extension. It expects a force, N, that is positive
    /// if the damper pushes. `length`, m, is the length of the damper where the displacement of the test records is 0. It is also the start
    /// value of the host's displacement.
    ///
    /// # Errors
    /// The length is impossible for a damper.
    pub fn carmaker(length: f64) -> anyhow::Result<Scales> {
        if !(SHORTEST..=LONGEST).contains(&length) {
            bail!(
                "--carmaker takes the length of the damper in m, {SHORTEST} to {LONGEST}, not {}",
                format_number(length)
            );
        }
        Ok(Scales { motion: 1.0, force: -1.0, position_offset: -length, start: length })
    }
}

/// Returns a remark that lists the elements missing when CarMaker computes the equilibrium of the vehicle, or `None` if none is missing.
///
/// The pluginfo file can describe a spring for this equilibrium, but no source states the reference length of its table. Thus, the file
/// contains a spring without force.
pub fn not_in_the_equilibrium(curve: &PlainCurve) -> Option<String> {
    (!curve.omitted_elements.is_empty()).then(|| {
        format!(
            "Not in the damper that CarMaker looks for its equilibrium with: {}. The FMU has them in the run, so where they hold a force at rest (gas, springs, \
             stops) the vehicle moves to another height after the start: let it come to rest first.",
            curve.omitted_elements.join(", ")
        )
    })
}

/// Lines that link CarMaker's input for controlled dampers, `CtrlIn`, to the setting of the FMU.
const SETTING: &str = "FMUIn.setting.Link = IFVar\nFMUIn.setting.Rel = CtrlIn\n";

/// Writes the text of `NAME.pluginfo` for the FMU `NAME.fmu` of one damper. CarMaker computes its equilibrium with the curve of `shown`, if
/// given.
///
/// `written` is a comment on the origin of the file. If the damper depends on a setting, CarMaker's `CtrlIn` is that setting.
///
/// # Errors
/// The model is invalid, or the name contains a line break, which would begin another key.
pub fn plug_info(
    (name, guid): (&str, &str),
    has_setting: bool,
    shown: Option<&PlainCurve>,
    written: &str,
) -> anyhow::Result<String> {
    if name.chars().any(char::is_control) {
        bail!("{name:?} is no name for an FMU in CarMaker: it has a line break or another control character");
    }
    // `written` contains the name of a model file, which may contain any character.
    let written: String = written.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let mut out = format!(
        "#INFOFILE1.1 - Do not remove this line!\n\
         FileIdent = CarMaker-PlugInfo 2\n\
         FileCreator = dashpot {}\n\
         # {written}\n\n\
         FMU.Name = {name}\n\
         FMU.Modelclass = Susp_Damper\n\
         FMU.GUID = {guid}\n\n\
         FMU.Inputs.ShowInDDict = 1\n\
         FMU.Outputs.ShowInDDict = 1\n\
         FMU.MakePluginfo = 0\n\
         FMU.DebugLogging = 0\n\
         FMU.InitParamStartValues = 1\n\n\
         FMUIn.displacement.Link = IFVar\n\
         FMUIn.displacement.Rel = length\n\
         FMUIn.velocity.Link = IFVar\n\
         FMUIn.velocity.Rel = vel\n{}\n\
         IFVar.Force.Link = FMUVar\n\
         IFVar.Force.Rel = force\n\n\
         # What CarMaker takes for the damper where it looks for its equilibrium: no spring, and the curve where one stands here.\n\
         Susp.Damper.SubstModel.Spring.l0 = 0.0\n\
         Susp.Damper.SubstModel.Spring:\n\t0.0 0.0\n\t1.0 0.0\n",
        env!("CARGO_PKG_VERSION"),
        if has_setting { SETTING } else { "" }
    );
    if let Some(plain) = shown {
        let curve = plain.curve()?;
        let _ = writeln!(out, "# {}", plain.note());
        if let Some(left_out) = not_in_the_equilibrium(plain) {
            let _ = writeln!(out, "# {left_out}");
        }
        out += "Susp.Damper.SubstModel.Damper:\n";
        for (v, f) in curve.velocities.iter().zip(&curve.forces) {
            let _ = writeln!(out, "\t{v:?} {f:?}");
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_equilibrium_lacks_is_said() {
        let with = |elements: &str| {
            let text = format!("format = 1\nelements = [{elements}]\n");
            let file = dashpot_identification::model_file::of_text(&text, std::path::Path::new("m.toml")).unwrap();
            let curve = PlainCurve::from_model_file(&file, false).unwrap().unwrap();
            plug_info(("front", "{1}"), false, Some(&curve), "x").unwrap()
        };
        assert!(with("\"fv_curve\", \"gas_preload\"").contains("looks for its equilibrium with: gas_preload."));
        assert!(!with("\"fv_curve\"").contains("Not in the damper"));
    }

    #[test]
    fn a_length_in_millimetres_and_a_name_of_two_lines_are_refused() {
        for length in [412.5, 0.0, -0.4, f64::NAN] {
            assert!(Scales::carmaker(length).is_err(), "{length}");
        }
        let scales = Scales::carmaker(0.4125).unwrap();
        // At the start value, the damper has zero displacement.
        assert_eq!(scales.motion * scales.start + scales.position_offset, 0.0);

        assert!(plug_info(("a\nFMU.Name = b", "{1}"), false, None, "x").is_err());
        let text = plug_info(("front", "{1}"), false, None, "from a\nFMU.Name = b").unwrap();
        assert_eq!(text.lines().filter(|line| line.starts_with("FMU.Name")).count(), 1, "{text}");
        assert!(!text.contains("CtrlIn"), "{text}");
        let text = plug_info(("front", "{1}"), true, None, "x").unwrap();
        assert!(text.contains("FMUIn.setting.Rel = CtrlIn\n\nIFVar.Force"), "{text}");
    }
}
