//! What was added, with its numbers, and why not something else.

use crate::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use crate::numbers::{share, with_unit};
use dashpot_diagnosis::{Diagnosis, Finding, Rival, Verdict};

/// The findings, and the suspects of what got no name; `None` where nothing is missing.
pub fn section(found: &Diagnosis) -> Option<Section> {
    let mut blocks = Vec::new();
    for (k, finding) in found.findings.iter().enumerate() {
        blocks.extend(one(k + 1, finding));
    }
    if !found.suspects.is_empty() {
        let caption = match found.verdict {
            Verdict::CannotTell => "One of these is missing, likeliest first.",
            Verdict::Named => "What may be missing beside that, likeliest first; none is likely enough to be added.",
            _ => "What comes nearest; none is likely enough to be named.",
        };
        blocks.push(Block::Table(rivals(caption, &found.suspects)));
    }
    if !found.corrections.is_empty() {
        let all: Vec<String> = found
            .corrections
            .iter()
            .map(|(name, value)| format!("{name} {}", with_unit(*value, unit_of(name))))
            .collect();
        blocks.push(Block::Warning(format!(
            "The rig added to the measurement: {}. That is corrected in this comparison only and is not part of the improved \
             model; put the rig right before the next campaign.",
            all.join(", ")
        )));
    }
    if !found.changed.is_empty() {
        blocks.push(Block::Heading("Numbers that are others than on the reference damper".into()));
        blocks.push(Block::Table(changed(found)));
    }
    if !found.shifts.is_empty() {
        blocks.push(Block::Heading("Numbers of the model that moved".into()));
        blocks.push(Block::Table(shifts(found)));
    }
    if blocks.is_empty() {
        return None;
    }
    let title = if found.findings.is_empty() { "Suspects" } else { "What is missing" };
    Some(Section::new("findings", title, blocks))
}

/// Unit of what the rig added.
pub fn unit_of(effect: &str) -> &'static str {
    match effect {
        "channel_delay" => "s",
        "force_drift" => "N/s",
        _ => "N",
    }
}

fn one(place: usize, finding: &Finding) -> Vec<Block> {
    let form = if finding.form.is_empty() { String::new() } else { format!(", form {}", finding.form) };
    let e = &finding.evidence;
    let gap = finding.gap_closed.map_or_else(String::new, |gap| {
        format!(" By itself it closes {} of the gap on tests that no refit has seen.", share(gap))
    });
    let to_what = if finding.of_the_rig {
        "It is of the rig, not of the damper: corrected in the comparison, not put into the model."
    } else {
        "It is added to the improved model."
    };
    let mut blocks = vec![
        Block::Heading(format!("{place}. {}{form}: {} sure", finding.effect, share(finding.confidence))),
        Block::Paragraph(format!("{}. {to_what}{gap}", capital(&finding.meaning))),
        Block::Paragraph(format!(
            "Where: {} (family {}, {} sure). Why: without it {} of the disagreement opens again; it leaves less of {} of the tests.",
            finding.path,
            finding.family,
            share(finding.family_confidence),
            share(finding.share),
            share(e.tests_better),
        )),
    ];
    if !finding.parameters.is_empty() {
        blocks.push(Block::Table(parameters(finding)));
    }
    if !finding.rivals.is_empty() {
        blocks.push(Block::Table(rivals("What else was tried in its place.", &finding.rivals)));
    }
    blocks
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn parameters(finding: &Finding) -> Table {
    let rows = finding
        .parameters
        .iter()
        .map(|(name, v)| {
            let [value, interval] = Cell::with_interval(v.value, v.low, v.high, v.unit);
            let judged = if v.plausible { "plausible" } else { "outside what dampers and rigs show: treat with care" };
            vec![(*name).into(), value, interval, judged.into()]
        })
        .collect();
    let columns = vec![
        Column::words("parameter"),
        Column::figures("value"),
        Column::figures("95 % interval"),
        Column::words("judged"),
    ];
    Table { caption: String::new(), columns, rows, sortable: false }
}

fn rivals(caption: &str, rivals: &[Rival]) -> Table {
    let rows = rivals
        .iter()
        .map(|r| vec![r.effect.into(), Cell::share(r.confidence), Cell::share(r.share), r.why.as_str().into()])
        .collect();
    let columns =
        vec![Column::words("effect"), Column::figures("confidence"), Column::figures("explains"), Column::words("why")];
    Table { caption: caption.to_owned(), columns, rows, sortable: false }
}

fn changed(found: &Diagnosis) -> Table {
    let row = |c: &dashpot_diagnosis::Change| {
        let [value, interval] = Cell::with_interval(c.value, c.low, c.high, c.unit);
        vec![c.parameter.into(), Cell::measured(c.reference, c.unit), value, interval]
    };
    let columns = vec![
        Column::words("parameter"),
        Column::figures("reference"),
        Column::figures("this damper"),
        Column::figures("95 % interval"),
    ];
    let caption = "Shown are those that differ by more than three standard deviations of both fits.".to_owned();
    Table { caption, columns, rows: found.changed.iter().map(row).collect(), sortable: false }
}

fn shifts(found: &Diagnosis) -> Table {
    let rows = found
        .shifts
        .iter()
        .map(|s| {
            let change = if s.before == 0.0 { Cell::none() } else { Cell::share(s.after / s.before - 1.0) };
            vec![s.parameter.into(), Cell::measured(s.before, s.unit), Cell::measured(s.after, s.unit), change]
        })
        .collect();
    let columns = vec![
        Column::words("parameter"),
        Column::figures("before"),
        Column::figures("after"),
        Column::figures("change"),
    ];
    let caption =
        "Without the effect these numbers had taken a part of it up. Shown are those that moved by more than three \
                   standard deviations."
            .to_owned();
    Table { caption, columns, rows, sortable: false }
}
