//! Files and folders that the command line names as inputs, for all verbs.

use clap::ArgMatches;
use std::path::PathBuf;

/// Options of all verbs that name an output.
pub const OUTPUTS: [&str; 7] = ["output", "json", "report", "svg", "certificate", "excel", "next_tests"];

/// Returns every value outside the output options that may be a file or a folder.
pub fn named(matches: &ArgMatches) -> Vec<PathBuf> {
    let mut found = Vec::new();
    gather(matches, &mut found);
    found
}

fn gather(matches: &ArgMatches, found: &mut Vec<PathBuf>) {
    for id in matches.ids().filter(|id| !OUTPUTS.contains(&id.as_str())) {
        // A group of options has values of mixed types.
        let Ok(Some(values)) = matches.try_get_raw(id.as_str()) else { continue };
        for value in values {
            found.push(PathBuf::from(value));
            // Values such as `--binary win64=file`.
            found.extend(value.to_str().and_then(|v| v.split_once('=')).map(|(_, file)| PathBuf::from(file)));
        }
    }
    if let Some((_, below)) = matches.subcommand() {
        gather(below, found);
    }
}
