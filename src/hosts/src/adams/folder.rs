//! Contents of all text files of an Adams run folder for a damper.

use super::native;
use dashpot_core::{Model, Params};
use std::fmt::Write as _;

/// A sine test that the rig model of the run folder simulates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SineTest {
    /// Amplitude, m.
    pub amplitude_m: f64,
    /// Frequency, Hz.
    pub frequency_hz: f64,
}

/// A text file of the run folder.
pub struct File {
    /// Name of the file.
    pub name: &'static str,
    /// Text of the file.
    pub text: String,
}

/// Makes the files for a model with length `length`, mm, at zero displacement. If Adams's own elements cannot represent the model,
/// native.adm is omitted, and the function also returns the reason.
pub fn files(
    params: &Params,
    model: &Model,
    model_file: &str,
    length: f64,
    tests: &[SineTest],
) -> (Vec<File>, Option<String>) {
    let states = model.states();
    let fill = |template: &str| {
        let zeros = vec!["0.0"; states].join(", ");
        template
            .replace("{length}", &format!("{length:?}"))
            .replace("{states}", &states.to_string())
            .replace("{zeros}", &zeros)
            .replace("{model_file}", model_file)
    };
    let native = native::fragment(params, model, length);
    let read_me = match &native {
        Ok(_) => fill(include_str!("templates/README.txt")).replace("{native}", NATIVE),
        // The note on the missing native.adm follows the title, because the export recognizes an older README.txt by its title.
        Err(reason) => {
            let lacks = wrapped(&format!("There is no native.adm of Adams's own elements, because {reason}."));
            let text = fill(include_str!("templates/README.txt")).replace("{native}\n", "");
            text.replacen("\n\n", &format!("\n\n{lacks}\n\n"), 1)
        }
    };
    let mut files = vec![
        File { name: "damper.cmd", text: fill(include_str!("templates/damper.cmd")) },
        File { name: "damper.adm", text: fill(include_str!("templates/damper.adm")) },
        File { name: "rig.adm", text: fill(include_str!("templates/rig.adm")) },
        File { name: "rig.acf", text: acf(tests) },
        File { name: "README.txt", text: read_me },
    ];
    match native {
        Ok(text) => {
            files.push(File { name: "native.adm", text });
            (files, None)
        }
        Err(reason) => (files, Some(reason)),
    }
}

/// Text of README.txt about native.adm.
const NATIVE: &str = "\
native.adm        the same damper from Adams's own elements, without the library: paste it into a model, put in the model's two
                  markers, the length and free ids; the lines at its head say where";

/// Inserts important remarks before the text of README.txt, because later users of the folder did not see the messages of the export.
pub fn above(remarks: &[String], text: &str) -> String {
    remarks.iter().map(|remark| format!("{}\n\n", wrapped(remark))).collect::<String>() + text
}

/// Appends the remarks on chatter to the text of README.txt, and states which users the remarks concern.
///
/// Adams solves for the force with the derivatives of dashpot's user subroutines and chooses its own steps, so the damper does not chatter
/// in Adams. It may chatter in a program that evaluates the force once a step.
pub fn below(text: &str, chatters: &[String]) -> String {
    if chatters.is_empty() {
        return text.to_owned();
    }
    let concerns = "If this model or Adams itself is coupled to a program that takes the force once a fixed step and holds it (co-simulation, real \
                    time), read this; a run of Adams alone is not concerned, because its solver takes the force with its slopes and chooses \
                    its steps.";
    let told = chatters.iter().map(|chatter| format!("{}\n", wrapped(chatter))).collect::<String>();
    format!("{text}\n{}\n{told}", wrapped(concerns))
}

/// Wraps a text to the line length of a plain text file.
fn wrapped(text: &str) -> String {
    /// Longest line of README.txt, characters.
    const WIDTH: usize = 100;
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) if line.len() + word.len() < WIDTH => *line += &format!(" {word}"),
            _ => lines.push(word.to_owned()),
        }
    }
    lines.join("\n")
}

/// Writes the command file that simulates the tests with the rig model.
///
/// Every test begins and ends at rest at zero displacement, so that the next test can follow.
fn acf(tests: &[SineTest]) -> String {
    let mut out =
        String::from("rig\nrig\n! Statics, then every test of the matrix: 1 cycle in, 2 cycles, 1 cycle out.\n");
    out += "INTEGRATOR/GSTIFF, SI2, ERROR=1.0E-5\nSIMULATE/STATICS\n";
    let mut begin = 0.0;
    for test in tests {
        let (period, amplitude) = (1.0 / test.frequency_hz, 1e3 * test.amplitude_m);
        let [rise, fall, end] = [1.0, 3.0, 4.0].map(|cycles| begin + cycles * period);
        let w = std::f64::consts::TAU / period;
        let [a, b, r, f, e] = [amplitude, begin, rise, fall, end].map(short);
        let _ = write!(
            out,
            "! {amplitude:.3} mm, {:.6} Hz\n\
             MOTION/1, FUNCTION = {a}*SIN({w:.12}*(TIME-{b}))*STEP(TIME,{b},0,{r},1)*STEP(TIME,{f},1,{e},0)\n\
             SIMULATE/DYNAMICS, END={e}, STEPS=800\n",
            1.0 / period
        );
        begin = end;
    }
    out + "STOP\n"
}

/// Formats a number with up to nine decimals and without trailing zeros, so that command lines stay short.
fn short(value: f64) -> String {
    let text = format!("{value:.9}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}
