//! The C sources of the FMU: those that ship with the command, and the tables of this model.

use super::variables::{STATES, Scales, Variable};
use std::fmt::Write as _;

/// FMI 2.0 or 3.0.
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

/// Every source of one FMI version.
pub fn bundled(version: Version) -> Vec<(&'static str, &'static str)> {
    let common = bundled![
        "dashpot.h" from "include",
        "corner.h" from "vi-crt-bridge/bridge",
        "corner.c" from "vi-crt-bridge/bridge",
        "instance.h" from "vi-crt-bridge/fmu",
        "instance.c" from "vi-crt-bridge/fmu",
        "partial.c" from "vi-crt-bridge/fmu",
    ];
    let face = match version {
        Version::Two => bundled!["fmi2.h" from "vi-crt-bridge/fmu", "fmi2.c" from "vi-crt-bridge/fmu"],
        Version::Three => bundled!["fmi3.h" from "vi-crt-bridge/fmu", "fmi3.c" from "vi-crt-bridge/fmu"],
    };
    common.into_iter().chain(face).collect()
}

/// The icon.
pub const ICON: &[u8] = include_bytes!("../../../../vi-crt-bridge/fmu/model.png");

/// `model_data.h`: model files and variables.
pub fn model_data(texts: &[String], variables: &[Variable], scales: Scales, guid: &str) -> String {
    let mut out = format!(
        "/* Written by dashpot export. */\n#define MODEL_GUID \"{guid}\"\n#define CORNERS {}\n#define VARIABLES {}\n\
         #define EXPORTED_STATES {STATES}\n#define MOTION_SCALE_START {:?}\n#define FORCE_SCALE_START {:?}\n\
         /* A series spring deflects by about a millimetre. */\n#define STATE_NOMINAL 1e-3\n\n\
         extern const char *const MODEL_TEXT[CORNERS];\nextern const struct variable VARIABLE[VARIABLES];\n",
        texts.len(),
        variables.len(),
        scales.motion,
        scales.force
    );
    out.push_str("\n#ifdef MODEL_DATA\nconst char *const MODEL_TEXT[CORNERS] = {\n");
    for text in texts {
        for line in text.lines() {
            let _ = writeln!(out, "    \"{}\\n\"", line.replace('\\', "\\\\").replace('"', "\\\""));
        }
        out.push_str("    ,\n");
    }
    out.push_str("};\n\nconst struct variable VARIABLE[VARIABLES] = {\n");
    for v in variables {
        let corner = v.corner.map_or(-1, |c| c as i64);
        let index = v.index.map_or(-1, |i| i as i64);
        let name = v.parameter.map_or("0".to_owned(), |p| format!("\"{}\"", p.name));
        let _ = writeln!(out, "    {{{}, {corner}, {index}, {name}}},", v.kind.c());
    }
    out.push_str("};\n#endif\n");
    out
}

/// How a simulator team compiles the FMU for its own target.
pub const BUILD: &str = include_str!("../../../../vi-crt-bridge/fmu/build.sh");

/// What the build script is, in words.
pub const README: &str = "The damper FMU from its sources, which are all in this folder:\n\n\
     \x20   sh build.sh\n\n\
     compiles it into ../binaries with a C compiler alone, on the platform where the FMU was exported: lib holds the kernel\n\
     for that platform. For any other target the kernel is compiled from its Rust sources in kernel (one dependency, libm);\n\
     the first lines of build.sh say how. No other library is needed. Where no shell runs, the two commands are:\n\n\
     \x20   cargo build --release --manifest-path kernel/Cargo.toml -p dashpot-dll --target YOUR-TARGET\n\
     \x20   cc -std=c99 -O2 -fPIC -shared -fvisibility=hidden -I. *.c libdashpot.a -lm -o dashpot_damper.so\n";

/// Defines what `model_data.h` declares.
pub const MODEL_DATA_C: &str = "#define MODEL_DATA\n#include \"instance.h\"\n";
