//! What reading found in the records, for the terminal.

use super::data::is_shown_first;
use dashpot_records::Campaign;
use dashpot_report::words::TERMINAL;

/// Damaged tests that are told one by one.
const TOLD: usize = 10;

/// What cleaning had to repair, by test.
fn repairs(campaign: &Campaign) -> Vec<String> {
    let mut lines: Vec<String> = campaign
        .records
        .iter()
        .filter_map(|r| {
            let texts: Vec<String> = r.notes.iter().filter(|n| n.is_of_damage()).map(|n| n.text.to_string()).collect();
            (!texts.is_empty()).then(|| format!("{}: {}", r.name, texts.join("; ")))
        })
        .collect();
    if lines.len() > TOLD {
        let more = lines.len() - TOLD;
        lines.truncate(TOLD);
        lines.push(format!("{more} more tests were repaired; the report of dashpot validate names them"));
    }
    lines
}

/// What the reader found in the records.
pub fn print_record_notes(campaign: &Campaign, say: &impl Fn(&str) -> anyhow::Result<()>) -> anyhow::Result<()> {
    say(&dashpot_report::reading::sign_in_words(&campaign.sign, &TERMINAL))?;
    for note in campaign.notes.iter().filter(|n| !is_shown_first(n)) {
        say(&format!("note: {}", note.text))?;
    }
    for line in repairs(campaign) {
        say(&format!("note: {line}"))?;
    }
    Ok(())
}
