//! Compiled runtimes that are embedded in the program, for users without a compiler. They are missing if
//! `vi-crt-bridge/runtimes.sh` did not run before the build.

include!(concat!(env!("OUT_DIR"), "/runtimes.rs"));

/// Instructions for building a command with embedded runtimes.
pub const HOW: &str =
    "build the command with it: `sh vi-crt-bridge/runtimes.sh`, then `cargo build --release -p dashpot-cli`";

/// Returns the content of an embedded file for a platform, or `None` if the file is not embedded. `platform` is a name of FMI 2.0, such as
/// `linux64`.
pub fn compiled(platform: &str, file: &str) -> Option<&'static [u8]> {
    COMPILED.iter().find(|(p, f, _)| *p == platform && *f == file).map(|(_, _, content)| *content)
}
