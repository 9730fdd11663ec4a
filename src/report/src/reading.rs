//! What was noticed when the records were read: the sign that was worked out, gaps, channels that do not fit.

use crate::blocks::Block;
use dashpot_records::{Campaign, Positive, SignFinding};

/// Confidence below which the reader of a report must be warned of the sign that was worked out.
const SURE_OF_SIGN: f64 = 0.9;

/// For a report: the sign first, as a warning where it is doubtful, then the remarks, and more of them.
pub fn blocks(campaign: &Campaign, more: &[String]) -> Vec<Block> {
    let sign = sign_in_words(&campaign.sign);
    let doubtful = !campaign.sign.given && campaign.sign.confidence < SURE_OF_SIGN;
    let mut blocks = vec![if doubtful { Block::Warning(sign) } else { Block::Paragraph(sign) }];
    let notes: Vec<String> = campaign.notes.iter().map(|n| n.text.clone()).chain(more.iter().cloned()).collect();
    if !notes.is_empty() {
        blocks.push(Block::List(notes));
    }
    blocks
}

/// The sign and the remarks, a sentence each.
pub fn sentences(campaign: &Campaign) -> Vec<String> {
    let notes = campaign.notes.iter().map(|n| n.text.clone());
    std::iter::once(sign_in_words(&campaign.sign)).chain(notes).collect()
}

/// The sign that was found or given, in a sentence.
pub fn sign_in_words(sign: &SignFinding) -> String {
    let direction = match sign.positive {
        Positive::Rebound => "rebound",
        Positive::Compression => "compression",
    };
    if sign.given {
        return format!("The files count {direction} positive, as given.");
    }
    let reasons = if sign.reasons.is_empty() { String::new() } else { format!(": {}", sign.reasons.join("; ")) };
    format!("The files count {direction} positive ({:.0} % sure){reasons}.", 100.0 * sign.confidence)
}
