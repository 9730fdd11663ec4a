//! Compiled files in the command, for users without a compiler. They are missing if the command was built without them
//! (`vi-crt-bridge/runtimes.sh`).

include!(concat!(env!("OUT_DIR"), "/runtimes.rs"));

/// Instructions for building a command that contains these files.
pub const HOW: &str =
    "build the command with it: `sh vi-crt-bridge/runtimes.sh`, then `cargo build --release -p dashpot-cli`";

/// Returns one file for a platform, named as in FMI 2.0.
pub fn compiled(platform: &str, file: &str) -> Option<&'static [u8]> {
    COMPILED.iter().find(|(p, f, _)| *p == platform && *f == file).map(|(_, _, content)| *content)
}
