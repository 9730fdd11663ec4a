//! Files and folders that the command line names as inputs, for all verbs. Outputs must not replace them.

use clap::ArgMatches;
use std::path::PathBuf;

/// Identifiers of the options, of all verbs, that name an output.
const OUTPUTS: [&str; 7] = ["output", "json", "report", "svg", "certificate", "excel", "next_tests"];

/// Returns every value of the command line that may be a file or a folder, except those of output options.
pub fn named(matches: &ArgMatches) -> Vec<PathBuf> {
    let mut found = Vec::new();
    gather(matches, &mut found);
    found
}

fn gather(matches: &ArgMatches, found: &mut Vec<PathBuf>) {
    for id in matches.ids().filter(|id| !OUTPUTS.contains(&id.as_str())) {
        // The values of a group of options are not readable as text, so the group is skipped. Its options are listed
        // separately.
        let Ok(Some(values)) = matches.try_get_raw(id.as_str()) else { continue };
        for value in values {
            found.push(PathBuf::from(value));
            // The part after `=` may be a file, such as in `--binary win64=file`.
            found.extend(value.to_str().and_then(|v| v.split_once('=')).map(|(_, file)| PathBuf::from(file)));
        }
    }
    if let Some((_, below)) = matches.subcommand() {
        gather(below, found);
    }
}
