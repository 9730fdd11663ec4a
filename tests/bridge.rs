//! C sources of the bridge to vehicle simulators (`vi-crt-bridge`), and host programs compiled with them.

use crate::library::Language::C;
use crate::library::{Linkage, host, root};
use std::path::{Path, PathBuf};

/// Model file of the bridge's tests.
pub const MODEL: &str = r#"
format = 1
elements = ["fv_curve", "series_compliance", "parallel_spring", "stribeck_friction", "viscous_friction", "side_force_friction", "gas_preload"]
gas_force = 141.5
"#;

/// Lists the C sources of a folder of `vi-crt-bridge`, sorted.
pub fn sources(folder: &str) -> Vec<String> {
    let folder = root().join("vi-crt-bridge").join(folder);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths = entries.map(|entry| entry.expect("an entry").path().to_str().expect("a path in UTF-8").to_owned());
    let mut sources: Vec<String> = paths.filter(|path| path.ends_with(".c")).collect();
    sources.sort();
    sources
}

/// Compiles the host program `tests/hosts/<source>` with the sources of the bridge and further compiler `flags`, in the
/// folder `to`. Returns the path of the program.
pub fn bridge_host(source: &str, flags: &[&str], to: &Path) -> PathBuf {
    let include = format!("-I{}", root().join("vi-crt-bridge/bridge").display());
    let sources = sources("bridge");
    let mut all: Vec<&str> = vec![&include];
    all.extend(sources.iter().map(String::as_str));
    all.extend(flags);
    host(source, C, Linkage::Static, &all, to)
}

/// Writes the channel map of VI-CarRealTime into `folder` and returns its path. The copy names the user-defined force
/// channel, which is empty in the shipped map.
pub fn map(folder: &Path) -> PathBuf {
    let path = root().join("vi-crt-bridge/maps/vi-carrealtime.toml");
    let text = std::fs::read_to_string(path).expect("the map");
    let filled = text.replace("\nforce = \"\"", "\nforce = \"My.Damper_Force.{corner}\"");
    assert_ne!(text, filled, "the map asks for the unknown channel");
    let to = folder.join("map.toml");
    std::fs::write(&to, filled).expect("a file");
    to
}
