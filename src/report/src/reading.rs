//! Remarks from reading the records: the detected sign convention, gaps, and inconsistent channels.

use crate::blocks::Block;
use crate::words::Words;
use dashpot_identification::model_file::ModelFile;
use dashpot_records::{Campaign, Positive, SignFinding};

/// Smallest confidence of a detected sign convention at which the report states it without a warning.
const SURE_OF_SIGN: f64 = 0.9;

/// Builds the blocks of a report on the data: first the sign convention, as a warning if it is doubtful. A list
/// follows, with the remarks from reading the records, of the fit, and on the model file.
pub fn blocks(campaign: &Campaign, model: &ModelFile, words: &Words) -> Vec<Block> {
    let sign = sign_in_words(&campaign.sign, words);
    let doubtful = !campaign.sign.is_stated && campaign.sign.confidence < SURE_OF_SIGN;
    let mut blocks = vec![if doubtful { Block::Warning(sign) } else { Block::Paragraph(sign) }];
    let notes = campaign.notes.iter().map(|note| words.say(&note.text));
    let known = &model.identification;
    let of_fit = known.notes.iter().map(|text| words.say_kept(text, &known.messages));
    let of_file = model.remarks().into_iter().map(|remark| words.say(&remark));
    let notes: Vec<String> = notes.chain(of_fit).chain(of_file).collect();
    if !notes.is_empty() {
        blocks.push(Block::List(notes));
    }
    blocks
}

/// Returns one sentence about the sign convention, and the remarks from reading the records.
pub fn sentences(campaign: &Campaign, words: &Words) -> Vec<String> {
    let notes = campaign.notes.iter().map(|note| words.say(&note.text));
    std::iter::once(sign_in_words(&campaign.sign, words)).chain(notes).collect()
}

/// Formats the detected or given sign convention (whether rebound or compression is positive) as a sentence.
pub fn sign_in_words(sign: &SignFinding, words: &Words) -> String {
    let direction = match sign.positive {
        Positive::Rebound => words.rebound,
        Positive::Compression => words.compression,
    };
    if sign.is_stated {
        return words.fill(words.sign_given, &[("direction", direction)]);
    }
    let percent = format!("{:.0}", 100.0 * sign.confidence);
    let reasons: Vec<String> = sign.reasons.iter().map(|reason| words.say(reason)).collect();
    let figures = [("direction", direction), ("percent", &percent), ("reasons", &reasons.join(words.semicolon))];
    words.fill(if reasons.is_empty() { words.sign_found } else { words.sign_found_by }, &figures)
}
