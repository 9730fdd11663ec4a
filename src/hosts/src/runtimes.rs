//! What the command holds compiled for those who have no compiler; empty where it was built without (`vi-crt-bridge/runtimes.sh`).

include!(concat!(env!("OUT_DIR"), "/runtimes.rs"));

/// How to get a command that holds them.
pub const HOW: &str =
    "build the command with it: `sh vi-crt-bridge/runtimes.sh`, then `cargo build --release -p dashpot-cli`";

/// One file, by its platform's name in FMI 2.0.
pub fn compiled(platform: &str, file: &str) -> Option<&'static [u8]> {
    COMPILED.iter().find(|(p, f, _)| *p == platform && *f == file).map(|(_, _, content)| *content)
}
