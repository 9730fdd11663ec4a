//! Notes of the reader on the records, for the terminal.

use super::data::is_shown_first;
use dashpot_records::{Campaign, Note};
use dashpot_report::words::TERMINAL;

/// Largest number of lines that are printed on the channels, and largest number on the repairs.
const LISTED: usize = 10;
/// Kinds of notes on the conversion of columns to channels. Most of these notes are equal in all files, so each is
/// listed once.
const CHANNELS: [&str; 3] = ["ignored", "resampled", "crank"];

/// Describes the conversion of columns to channels. Each text appears once, with the number of its tests.
fn channels(campaign: &Campaign) -> Vec<String> {
    let mut tests: Vec<(String, Vec<&str>)> = Vec::new();
    for record in &campaign.records {
        for note in record.notes.iter().filter(|note| CHANNELS.contains(&note.kind)) {
            let text = note.text.to_string();
            match tests.iter_mut().find(|(known, _)| *known == text) {
                Some((_, names)) => names.push(&record.name),
                None => tests.push((text, vec![&record.name])),
            }
        }
    }
    let of = |names: &[&str]| match names {
        [name] => (*name).to_owned(),
        names if names.len() == campaign.records.len() => "all tests".to_owned(),
        names => format!("{} of {} tests", names.len(), campaign.records.len()),
    };
    let lines = tests.iter().map(|(text, names)| format!("{}: {text}", of(names))).collect();
    limit(lines, "more such notes; the report of dashpot validate has them")
}

/// Truncates a list to [`LISTED`] lines, and adds a line with the number of omitted lines.
fn limit(mut lines: Vec<String>, what: &str) -> Vec<String> {
    if lines.len() > LISTED {
        let more = lines.len() - LISTED;
        lines.truncate(LISTED);
        lines.push(format!("{more} {what}"));
    }
    lines
}

/// Largest number of tests with damage of the same kinds that have a line each. More tests have one line together.
const ALIKE: usize = 3;

/// Formats one line for each test with damaged samples that the reader repaired, at most [`LISTED`] lines. Many tests
/// with damage of the same kinds have one line.
fn repairs(campaign: &Campaign) -> Vec<String> {
    let mut groups: Vec<(Vec<&str>, Vec<(&str, String)>)> = Vec::new();
    for record in &campaign.records {
        let notes: Vec<&Note> = record.notes.iter().filter(|note| note.is_of_damage()).collect();
        let kinds: Vec<&str> = notes.iter().map(|note| note.kind).collect();
        let texts: Vec<String> = notes.iter().map(|note| note.text.to_string()).collect();
        let test = (record.name.as_str(), texts.join("; "));
        match groups.iter_mut().find(|(known, _)| *known == kinds) {
            _ if kinds.is_empty() => {}
            Some((_, tests)) => tests.push(test),
            None => groups.push((kinds, vec![test])),
        }
    }
    let mut lines = Vec::new();
    for (_, tests) in groups {
        let each = tests.iter().map(|(name, text)| format!("{name}: {text}"));
        if tests.len() <= ALIKE {
            lines.extend(each);
        } else {
            let names: Vec<&str> = tests.iter().take(ALIKE).map(|(name, _)| *name).collect();
            let (count, all, first) = (tests.len(), campaign.records.len(), each.take(1).collect::<String>());
            lines.push(format!(
                "{count} of {all} tests ({}, ...) with the same kind of damage, the first: {first}",
                names.join(", ")
            ));
        }
    }
    limit(lines, "more tests were repaired; the report of dashpot validate names them")
}

/// Prints the sign convention of the records and the notes of the reader.
pub fn print_record_notes(campaign: &Campaign, say: &impl Fn(&str) -> anyhow::Result<()>) -> anyhow::Result<()> {
    say(&dashpot_report::reading::sign_in_words(&campaign.sign, &TERMINAL))?;
    for note in campaign.notes.iter().filter(|n| !is_shown_first(n)) {
        say(&format!("note: {}", note.text))?;
    }
    for line in channels(campaign).into_iter().chain(repairs(campaign)) {
        say(&format!("note: {line}"))?;
    }
    Ok(())
}
