//! The added effects with their parameters, the evidence against the alternatives, and the changed parameters.

use super::{both_curves, capital};
use crate::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use crate::inventory::probability;
use crate::numbers::{error, fraction, with_unit};
use crate::words::Words;
use dashpot_diagnosis::{Change, Diagnosis, Finding, Rival, Verdict};

/// Builds the section of findings, suspected causes of unexplained residuals, measurement corrections and changed
/// parameters. Returns `None` if there are none of them.
pub fn section(found: &Diagnosis, words: &Words) -> Option<Section> {
    let mut blocks = Vec::new();
    for (k, finding) in found.findings.iter().enumerate() {
        blocks.extend(one(k + 1, finding, words));
    }
    if !found.suspects.is_empty() {
        let caption = match found.verdict {
            Verdict::Ambiguous => words.suspects_cannot_tell,
            Verdict::Named => words.suspects_beside,
            _ => words.suspects_nearest,
        };
        blocks.push(Block::Table(rivals(caption, &found.suspects, words)));
    }
    if !found.corrections.is_empty() {
        let all: Vec<String> = found
            .corrections
            .iter()
            .map(|(name, value)| {
                format!("{} {}", words.named(name), words.number(&with_unit(*value, unit_of(found, name))))
            })
            .collect();
        blocks.push(Block::Warning(words.fill(words.rig_added, &[("all", &all.join(words.comma))])));
    }
    // If the section contains only changed parameters, its title names them, and the heading above their table is
    // omitted.
    let changed_alone = blocks.is_empty() && found.shifts.is_empty() && !found.changes.is_empty();
    if !found.changes.is_empty() {
        blocks.extend((!changed_alone).then(|| Block::Heading(words.changed_section.into())));
        blocks.extend(both_curves::figure(found, words).map(Block::Wide));
        blocks.push(Block::Table(changed(found, words)));
    }
    if !found.shifts.is_empty() {
        blocks.push(Block::Heading(words.shifts_section.into()));
        blocks.push(Block::Table(shifts(found, words)));
    }
    if blocks.is_empty() {
        return None;
    }
    let title = match found.findings.is_empty() {
        true if changed_alone => words.changed_section,
        true => words.suspects_section,
        false => words.findings_section,
    };
    Some(Section::new("findings", title, blocks))
}

/// Returns the unit of the measurement error `effect`: the unit of the first parameter of its finding. Without a
/// finding or parameter, the unit is N.
fn unit_of(found: &Diagnosis, effect: &str) -> &'static str {
    let finding = found.findings.iter().find(|finding| finding.effect == effect);
    finding.and_then(|finding| finding.parameters.values().next()).map_or("N", |value| value.unit)
}

fn one(place: usize, finding: &Finding, words: &Words) -> Vec<Block> {
    let form = match finding.form {
        "" => String::new(),
        form => words.fill(words.finding_form, &[("form", words.word(form))]),
    };
    // The error on left-out tests is stronger evidence than the error on fitted tests, so it is stated if it is known.
    let gap = match finding.gap_closed {
        Some(gap) => words.fill(words.finding_gap, &[("gap", &fraction(gap))]),
        None => words.fill(words.finding_disagreement, &[("gap", &fraction(finding.fraction))]),
    };
    let added = if finding.of_the_rig { words.finding_of_rig } else { words.finding_added };
    let (number, sure) = (place.to_string(), fraction(finding.confidence));
    let heading = [("place", number.as_str()), ("effect", finding.effect), ("form", &form), ("sure", &sure)];
    let meaning = capital(words.meaning_of_element(finding.effect));
    let why = [
        ("path", words.word(finding.path)),
        ("family", words.word(finding.family)),
        ("family_sure", &fraction(finding.family_confidence)),
        ("tests", &fraction(finding.evidence.tests_better)),
    ];
    let mut blocks = vec![
        Block::Heading(words.fill(words.finding_heading, &heading)),
        Block::Paragraph(words.fill(words.finding_what, &[("meaning", &meaning), ("added", added), ("gap", &gap)])),
        Block::Paragraph(words.fill(words.finding_why, &why)),
    ];
    if !finding.parameters.is_empty() {
        blocks.push(Block::Table(parameters(finding, words)));
    }
    if !finding.rivals.is_empty() {
        blocks.push(Block::Table(rivals(words.rivals_caption, &finding.rivals, words)));
    }
    blocks
}

fn parameters(finding: &Finding, words: &Words) -> Table {
    let rows = finding
        .parameters
        .iter()
        .map(|(name, v)| {
            let [value, interval] = Cell::with_interval(v.value, v.low, v.high, v.unit, words);
            let judged = if v.plausible { words.plausible } else { words.not_plausible };
            vec![words.named(name).into(), value, interval, judged.into()]
        })
        .collect();
    let columns = vec![
        Column::words(words.col_parameter),
        Column::figures(words.col_value),
        Column::figures(words.col_interval),
        Column::words(words.col_judged),
    ];
    Table { caption: String::new(), columns, rows, sortable: false }
}

fn rivals(caption: &str, rivals: &[Rival], words: &Words) -> Table {
    let rows = rivals
        .iter()
        .map(|r| {
            vec![
                words.named(r.effect).into(),
                Cell::fraction(r.confidence),
                Cell::fraction(r.fraction),
                words.say(&r.why).into(),
            ]
        })
        .collect();
    let columns = vec![
        Column::words(words.col_effect),
        Column::figures(words.col_confidence),
        Column::figures(words.col_explains),
        Column::words(words.col_why),
    ];
    Table { caption: caption.to_owned(), columns, rows, sortable: false }
}

/// Formats the name of a changed parameter. For a point of the FV curve, the name includes the velocity.
pub fn changed_name(change: &Change, words: &Words) -> String {
    let name = words.named(change.name);
    match change.velocity_m_s {
        Some(velocity) => format!("{name}, {} mm/s", words.number(&format!("{:.0}", 1e3 * velocity))),
        None => name,
    }
}

fn changed(found: &Diagnosis, words: &Words) -> Table {
    let row = |c: &Change| {
        let [value, interval] = Cell::with_interval(c.value, c.low, c.high, c.unit, words);
        let reference = Cell::measured(c.reference, c.unit);
        let probability = Cell { text: probability(c.probability), ..Cell::fraction(c.probability) };
        vec![changed_name(c, words).into(), reference, value, interval, Cell::number(c.force_n_rms, error), probability]
    };
    let columns = vec![
        Column::words(words.col_parameter),
        Column::figures(words.col_reference),
        Column::figures(words.col_this_damper),
        Column::figures(words.col_interval),
        Column::figures(words.col_force_rms),
        Column::figures(words.col_probability),
    ];
    let rows = found.changes.iter().map(row).collect();
    Table { caption: words.changed_caption.to_owned(), columns, rows, sortable: false }
}

fn shifts(found: &Diagnosis, words: &Words) -> Table {
    let rows = found
        .shifts
        .iter()
        .map(|s| {
            let change = if s.before == 0.0 { Cell::none() } else { Cell::fraction(s.after / s.before - 1.0) };
            vec![
                words.named(s.parameter).into(),
                Cell::measured(s.before, s.unit),
                Cell::measured(s.after, s.unit),
                change,
            ]
        })
        .collect();
    let columns = vec![
        Column::words(words.col_parameter),
        Column::figures(words.before),
        Column::figures(words.after),
        Column::figures(words.col_change),
    ];
    Table { caption: words.shifts_caption.to_owned(), columns, rows, sortable: false }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{DE, EN};

    /// The sentence of a change states the numbers of its row, in each language, for every size and width.
    #[test]
    fn a_sentence_on_a_change_has_the_digits_and_the_unit_of_its_row() {
        let units: [(&str, f64, Option<f64>, &'static str); 5] = [
            ("gas_force", 84.85, None, "N"),
            ("series_stiffness", 2.067e6, None, "N/m"),
            ("presliding_length", 1.5e-4, None, "m"),
            ("rebound_curve", 2329.0, Some(0.359), "N"),
            ("compression_low_speed", -41.03, Some(-0.046), "N"),
        ];
        for (name, reference, velocity_m_s, unit) in units {
            for factor in [0.0913, 0.3571, 1.17, 3.468, 12.3] {
                for width in [0.0, 1e-4, 0.013, 0.31, 2.4] {
                    let value = factor * reference;
                    let half = width * value.abs();
                    let change = Change {
                        name,
                        reference,
                        value,
                        low: value - half,
                        high: value + 0.7 * half,
                        unit,
                        velocity_m_s,
                        probability: 0.9,
                        force_n_rms: 1.0,
                    };
                    for words in [&EN, &DE] {
                        let said = words.say(&change.sentence()).replace('\u{a0}', " ");
                        let [shown, _] = Cell::with_interval(value, change.low, change.high, unit, words);
                        let shown = words.number(&shown.text).replace('\u{a0}', " ");
                        // For a force at a velocity, the sentence states the unit only once, after the second force.
                        assert!(said.contains(&shown), "{said}: {shown}");
                        let before = words.number(&crate::numbers::with_unit(reference, unit)).replace('\u{a0}', " ");
                        let digits = before.split(' ').next().unwrap();
                        assert!(said.contains(digits), "{said}: {before}");
                    }
                }
            }
        }
    }
}
