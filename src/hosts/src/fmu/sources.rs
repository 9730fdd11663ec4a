//! C sources of an FMU: the sources embedded in the command, and the data of one model.

use super::scales::Scales;
use super::variables::{Inputs, Variable};
use std::fmt::Write as _;

/// Version of FMI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Version {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    Three,
}

macro_rules! bundled {
    ($($name:literal from $folder:literal),* $(,)?) => {
        [$(($name, include_str!(concat!("../../../../", $folder, "/", $name)))),*]
    };
}

/// Returns name and text of the C sources that all FMUs share.
pub fn bundled() -> Vec<(&'static str, &'static str)> {
    let all = bundled![
        "dashpot.h" from "include",
        "corner.h" from "vi-crt-bridge/bridge",
        "corner.c" from "vi-crt-bridge/bridge",
        "contents.h" from "vi-crt-bridge/fmu",
        "contents.c" from "vi-crt-bridge/fmu",
        "resources.h" from "vi-crt-bridge/fmu",
        "resources.c" from "vi-crt-bridge/fmu",
        "veil.h" from "vi-crt-bridge/fmu",
        "veil.c" from "vi-crt-bridge/fmu",
        "data.h" from "vi-crt-bridge/fmu",
        "complain.h" from "vi-crt-bridge/fmu",
        "complain.c" from "vi-crt-bridge/fmu",
        "inputs.h" from "vi-crt-bridge/fmu",
        "inputs.c" from "vi-crt-bridge/fmu",
        "evaluate.h" from "vi-crt-bridge/fmu",
        "evaluate.c" from "vi-crt-bridge/fmu",
        "instance.h" from "vi-crt-bridge/fmu",
        "instance.c" from "vi-crt-bridge/fmu",
        "step.c" from "vi-crt-bridge/fmu",
        "exchange.c" from "vi-crt-bridge/fmu",
        "partial.c" from "vi-crt-bridge/fmu",
        "fmi2.h" from "vi-crt-bridge/fmu",
        "fmi2.c" from "vi-crt-bridge/fmu",
        "fmi3.h" from "vi-crt-bridge/fmu",
        "fmi3.c" from "vi-crt-bridge/fmu",
    ];
    all.into()
}

/// Icon of the FMU.
pub const ICON: &[u8] = include_bytes!("../../../../vi-crt-bridge/fmu/model.png");

/// Writes `contents.txt`, from which the runtime reads the data of an FMU.
pub fn contents(
    corners: usize,
    variables: &[Variable],
    scales: Scales,
    (inputs, explicit_step): (Inputs, f64),
    guid: &str,
) -> String {
    // Numbers are written as the bits of a double, because the locale of the host affects how C parses decimal numbers.
    let bits = |value: f64| format!("{:016x}", value.to_bits());
    let mut out = format!(
        "dashpot-fmu 3\nguid {guid}\ncorners {corners}\nscales {} {} {} {}\nsolver {} {}\n",
        bits(scales.motion),
        bits(scales.force),
        bits(scales.position_offset),
        bits(scales.start),
        bits(inputs.start_value()),
        bits(explicit_step)
    );
    for v in variables {
        let corner = v.corner.map_or(-1, |c| c as i64);
        let index = v.index.map_or(-1, |i| i as i64);
        let name = v.parameter.map_or("-", |p| p.name);
        let _ = writeln!(out, "variable {} {corner} {index} {name}", v.kind.c());
        if let Some(nominal) = v.nominal {
            let _ = writeln!(out, "nominal {corner} {index} {}", bits(nominal));
        }
    }
    out
}

/// Writes `model_data.c`, which contains `contents` and the model files as string constants. A binary compiled with it
/// serves this FMU only.
pub fn model_data(contents: &str, texts: &[String]) -> String {
    let mut out = String::from("/* Written by dashpot export. */\n#include \"contents.h\"\n\n");
    let text = |out: &mut String, text: &str| {
        for line in text.lines() {
            let _ = writeln!(out, "    \"{}\\n\"", line.replace('\\', "\\\\").replace('"', "\\\""));
        }
    };
    out.push_str("const char *const EMBEDDED_CONTENTS =\n");
    text(&mut out, contents);
    out.push_str("    ;\n\nconst char *const EMBEDDED_MODEL[MAX_CORNERS] = {\n");
    for model in texts {
        text(&mut out, model);
        out.push_str("    ,\n");
    }
    out.push_str("};\n");
    out
}

/// Shell script that compiles the FMU for another platform.
pub const BUILD: &str = include_str!("../../../../vi-crt-bridge/fmu/build.sh");

/// Text of README.txt, which explains the build script.
pub const README: &str = "The damper FMU from its sources, which are all in this folder:\n\n\
     \x20   sh build.sh\n\n\
     compiles it into ../binaries with a C compiler alone, on the platform that lib/platform names: lib holds the kernel compiled\n\
     for it. For any other target the kernel is compiled from its Rust sources in kernel (one dependency, libm);\n\
     the first lines of build.sh say how. No other library is needed. Where no shell runs, the two commands are:\n\n\
     \x20   cargo build --release --manifest-path kernel/Cargo.toml -p dashpot-dll --target YOUR-TARGET\n\
     \x20   cc -std=c99 -O2 -fPIC -shared -fvisibility=hidden -I. *.c libdashpot.a -o dashpot_damper.so\n";
