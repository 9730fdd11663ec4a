//! The inventory of a model as a table: each effect with its force and its probability.

use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::cells::Cell;
use crate::numbers::{error, fraction};
use crate::plot::inventory::stacked;
use crate::words::Words;
use dashpot_diagnosis::{InventoryItem, Status, TestOutcome};

/// Builds the section of a diagnosis with the inventory table. Returns `None` if neither the given nor the improved
/// model has an effect other than the FV curve.
pub fn section(items: &[InventoryItem], tests: &[TestOutcome], words: &Words) -> Option<Section> {
    let mut table = table(items, true, words)?;
    words.inventory_caption.clone_into(&mut table.caption);
    let mut blocks = vec![Block::Table(table)];
    let figure =
        stacked(items, tests, words).map(|svg| Figure::new("inventory", svg).saying(words.inventory_bands_caption));
    blocks.extend(figure.map(Block::Wide));
    Some(Section::new("inventory", words.inventory_section, blocks))
}

/// Builds the inventory table. `status` adds a column that states whether an effect was kept, added, replaced or
/// removed. A fit has no such column, because it begins without a given model. Returns `None` without effects.
pub fn table(items: &[InventoryItem], status: bool, words: &Words) -> Option<Table> {
    if items.is_empty() {
        return None;
    }
    let row = |item: &InventoryItem| {
        let mut cells = vec![words.named(item.effect).into(), words.word(item.form).into()];
        cells.extend([
            Cell::number(item.force_n_rms, |force| if force.is_finite() { error(force) } else { "–".into() }),
            Cell::fraction(item.fraction),
            Cell { text: probability(item.probability), ..Cell::fraction(item.probability) },
        ]);
        cells.extend(status.then(|| Cell::from(status_text(item, words))));
        cells
    };
    let mut columns = vec![
        Column::words(words.col_effect),
        Column::words(words.col_form),
        Column::figures(words.col_force_rms),
        Column::figures(words.col_share_of_force),
        Column::figures(words.col_probability),
    ];
    columns.extend(status.then(|| Column::words(words.col_status)));
    Some(Table { caption: String::new(), columns, rows: items.iter().map(row).collect(), sortable: true })
}

/// Formats a probability in percent. If it rounds to 0 or 100, the text states a bound.
pub fn probability(value: f64) -> String {
    match value {
        v if v > 0.995 => format!(">\u{a0}{}", fraction(0.99)),
        v if v < 0.005 => format!("<\u{a0}{}", fraction(0.01)),
        v => fraction(v),
    }
}

/// Formats the status of an effect. If it replaces another effect, or another effect is possible instead, the text
/// names the other effect.
pub fn status_text(item: &InventoryItem, words: &Words) -> String {
    let status = match item.status {
        Status::Kept => words.status_kept,
        Status::Added => words.status_added,
        Status::Replaced => words.status_replaced,
        Status::Removed => words.status_removed,
    };
    let instead = item.or_instead.map(|of| {
        words.fill(words.or_instead, &[("effect", of.effect), ("probability", &probability(of.probability))])
    });
    let replaces = item.replaces.map(|effect| words.fill(words.replaces, &[("effect", effect)])).or(instead);
    replaces.map_or_else(|| status.to_owned(), |replaces| [status, &replaces].join(words.comma))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{DE, EN};

    fn item(status: Status, replaces: Option<&'static str>) -> InventoryItem {
        InventoryItem {
            effect: "aeration",
            form: "",
            force_n_rms: 12.345,
            fraction: 0.034,
            test_forces_n: Vec::new(),
            probability: 0.97,
            status,
            replaces,
            or_instead: None,
        }
    }

    #[test]
    fn a_row_says_what_became_of_the_effect_and_what_it_replaces() {
        let table = table(&[item(Status::Added, Some("bushing"))], true, &EN).unwrap();
        let texts: Vec<&str> = table.rows[0].iter().map(|cell| cell.text.as_str()).collect();
        assert_eq!(
            texts,
            [
                "air in the oil (aeration)",
                "",
                "12.3",
                "3\u{a0}%",
                "97\u{a0}%",
                "added, in place of rubber bush (bushing)"
            ]
        );
        assert_eq!(status_text(&item(Status::Removed, None), &DE), "entfernt");
        assert!(super::table(&[], true, &EN).is_none());
        assert_eq!(super::table(&[item(Status::Added, None)], false, &EN).unwrap().columns.len(), 5);
    }

    #[test]
    fn no_probability_reads_as_certain() {
        assert_eq!(
            [1.0, 0.994, 0.5, 1e-9].map(probability),
            [">\u{a0}99\u{a0}%", "99\u{a0}%", "50\u{a0}%", "<\u{a0}1\u{a0}%"]
        );
    }
}
