//! Tests that a window of 1280 pixels shows every text of its panels, in every language.

use super::drawn::each_shape;
use super::*;
use crate::units::{Force, Units, Velocity};
use crate::views::Corner;
use eframe::egui::Shape;

/// Lists the widgets of a role that begin between two edges and extend beyond the right edge.
pub(super) fn cut_off(harness: &Harness<'_, App>, role: Role, (left, right): (f32, f32)) -> Vec<String> {
    let of_panel = harness.query_all(by().role(role)).filter(|node| (left..right).contains(&node.rect().left()));
    of_panel.filter(|node| node.rect().right() > right + 1.0).map(|node| format!("{node:?}")).collect()
}

#[test]
fn nothing_of_a_panel_is_cut_off_and_choices_are_words() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 12, vec![]);
    harness.key_press(Key::F7);
    until(&mut harness, "the diagnosis", |app| app.session.results.diagnosis.is_some());
    // The validation belongs to the model before the fit. Its table remains, with the mark of an outdated result.
    harness.key_press(Key::F6);
    until(&mut harness, "the validation", |app| app.session.results.validation.is_some());
    harness.key_press(Key::F5);
    until(&mut harness, "the fit", |app| app.session.results.fit.is_some() && app.session.task.is_none());
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        let words = crate::words::texts(language);
        harness.step();
        harness.step();
        let panel = widget(&harness, Role::Button, words.tune).rect().left() - 8.0;
        for side in [words.tune, words.result, words.records, words.study] {
            press(&mut harness, side);
            harness.step();
            for role in [Role::Label, Role::Button, Role::ComboBox] {
                let cut = cut_off(&harness, role, (panel, 1280.0));
                assert!(cut.is_empty(), "{language:?}, {side}: {cut:#?}");
            }
        }
        // The rows of the validation are in the language of the window.
        press(&mut harness, words.result);
        let row = format!("{} {} mm", words.amplitude, language.words().number("40.0"));
        assert!(says(&harness, &row), "{language:?}: {row}");
        // A drop-down list truncates texts that are wider than the list, so these texts must be short.
        for word in [words.from_data, words.as_file_says] {
            assert!(word.chars().count() <= 18, "{language:?}: {word}");
        }
        // The cells of the error matrix end before the margin of the plots.
        let cut = cut_off(&harness, Role::Button, (280.0, panel - 8.0));
        assert!(cut.is_empty(), "{language:?}: {cut:#?}");
        // The buttons of the tables, and every column of the forces at given velocities, also end before that margin.
        press(&mut harness, words.tables);
        harness.step();
        let cut = cut_off(&harness, Role::Button, (280.0, panel - 8.0));
        assert!(cut.is_empty(), "{language:?}: {cut:#?}");
        let headings = harness.query_all(by().role(Role::Label).label_contains(words.closing_speed));
        let ends: Vec<f32> = headings.map(|heading| heading.rect().right()).collect();
        assert!(ends.len() == 2 && ends.iter().all(|end| *end <= panel - 7.0), "{language:?}: {ends:?} of {panel}");
        press(&mut harness, words.error_matrix);
        press(&mut harness, words.tune);
        harness.step();
        let table = language.words().choice("table").into_owned();
        let chosen = harness.query_all(by().role(Role::ComboBox)).filter_map(|node| node.value());
        assert!(chosen.into_iter().any(|value| value == table), "{language:?}: no list shows {table:?}");
    }
}

/// Returns the texts of the last frame that are cut off at the edge of the panel that lists the rig tests. Also returns texts of any panel
/// with a line break within a word.
pub(super) fn spoilt(harness: &Harness<'_, App>) -> Vec<String> {
    /// Largest right edge of a text in the panel of the tests, px.
    const PANEL: f32 = 275.0;
    let mut found = Vec::new();
    each_shape(harness, |shape, clip| {
        let Shape::Text(text) = shape else { return };
        let rect = text.galley.rect.translate(text.pos.to_vec2());
        let is_cut = clip.right() < PANEL && rect.right() > clip.right() + 0.5;
        let is_shown = rect.intersects(clip);
        let is_letter = |row: &egui::epaint::text::PlacedRow, last: bool| {
            let glyph = if last { row.glyphs.last() } else { row.glyphs.first() };
            // Chinese breaks between any two characters.
            glyph.is_some_and(|glyph| glyph.chr.is_alphabetic() && glyph.chr < '\u{2e80}')
        };
        let breaks = |pair: &[egui::epaint::text::PlacedRow]| {
            !pair[0].ends_with_newline && is_letter(&pair[0], true) && is_letter(&pair[1], false)
        };
        if is_shown && (is_cut || text.galley.rows.windows(2).any(breaks)) {
            found.push(text.galley.job.text.clone());
        }
    });
    found
}

#[test]
fn no_text_of_tests_and_tables_is_cut_off_or_broken_within_a_word() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    harness.state_mut().view.corner = Corner::Tables;
    for (_, language) in Language::ALL {
        for (velocity, force) in Velocity::ALL.into_iter().flat_map(|v| Force::ALL.map(|f| (v, f))) {
            harness.state_mut().view.language = language;
            harness.state_mut().view.units = Units { velocity, force };
            harness.run_steps(3);
            let w = crate::words::texts(language);
            let panel = widget(&harness, Role::Button, w.tune).rect().left() - 8.0;
            let spoilt = spoilt(&harness);
            assert!(spoilt.is_empty(), "{language:?} {velocity:?} {force:?}: {spoilt:#?}");
            let headings = harness.query_all(by().role(Role::Label).label_contains(w.closing_speed));
            let ends: Vec<f32> = headings.map(|heading| heading.rect().right()).collect();
            assert!(ends.len() == 2 && ends.iter().all(|end| *end <= panel - 7.0), "{language:?}: {ends:?} of {panel}");
        }
    }
}
