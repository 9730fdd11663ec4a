//! Formatting of an error as one sentence.

/// Formats an error with its causes, but omits causes that its text already contains.
pub fn format_once(error: &anyhow::Error) -> String {
    error.chain().fold(String::new(), |told, cause| match cause.to_string() {
        cause if told.contains(&cause) => told,
        cause if told.is_empty() => cause,
        cause => format!("{told}: {cause}"),
    })
}
