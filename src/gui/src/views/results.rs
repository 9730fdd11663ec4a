//! Panel of the results of fit, validation and diagnosis, with the texts of the reports.

use crate::dialogs::Ask;
use crate::format::Format;
use crate::restated::heading as heading_in;
use crate::session::Session;
use crate::session::papers::Paper;
use crate::session::replacing::Replacement;
use crate::session::results::Kind;
use crate::views::{View, setting_name, translate_name};
use crate::words::Words;
use dashpot_diagnosis::{Diagnosis, InventoryItem};
use dashpot_identification::family::{FamilyEstimate, FamilyFit};
use dashpot_identification::validation::{Errors, Validation};
use dashpot_identification::{Fit, Standing};
use dashpot_report::diagnosis::changed_name;
use dashpot_report::diagnosis::headline;
use dashpot_report::family::errors;
use dashpot_report::inventory::{probability, status_text};
use dashpot_report::numbers::{digits, fraction};
use dashpot_report::parameters::assumed_of;
use dashpot_report::quality;
use dashpot_simulation::whole_records::Quality;
use eframe::egui::{self, RichText, Ui};

/// Draws the panel: results that belong to the data on screen before those that are out of date, each newest first.
pub fn show(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    let mut area = egui::ScrollArea::vertical().id_salt("answer").auto_shrink([false, false]);
    // A new result is at the top of the panel. The user may have scrolled down, so the panel scrolls back to the top.
    if std::mem::take(&mut view.is_result_new) {
        area = area.vertical_scroll_offset(0.0);
    }
    area.show(ui, |ui| {
        let order = session.results.order(session);
        if order.is_empty() {
            wrapped(ui, RichText::new(w.no_result));
        }
        let mut take = false;
        for (k, kind) in order.into_iter().enumerate() {
            if k > 0 {
                ui.separator();
            }
            match kind {
                Kind::Fit => of_fit(ui, session, view),
                Kind::FamilyFit => of_family_fit(ui, session, view),
                Kind::Validation => of_validation(ui, session, view),
                Kind::Diagnosis => take = of_diagnosis(ui, session, view),
            }
        }
        if take {
            session.replace(Replacement::Improved);
        }
    });
}

/// Draws the result of a diagnosis. Returns whether the user adopts the improved model.
fn of_diagnosis(ui: &mut Ui, session: &Session, view: &mut View) -> bool {
    let Some(answer) = &session.results.diagnosis else { return false };
    let (w, format, free) = (view.words(), view.format(), session.task.is_none());
    let (found, old) = (&answer.found.found, answer.is_old(session));
    heading(ui, w.diagnosis_result, old, w);
    if let Some(setting) = &answer.found.only_at {
        let tests = answer.found.left_out.len().to_string();
        let setting = w.of.words().number(setting);
        wrapped(ui, RichText::new(w.fill(w.diagnosed_at, &[("tests", &tests), ("setting", &setting)])).strong());
    }
    wrapped(ui, RichText::new(format.restate(&headline(found, format.words()))).strong());
    // The buttons stand above the details, because the details exceed the height of the window.
    let take = ui.horizontal_wrapped(|ui| {
        let added = found.findings.iter().any(|f| !f.of_the_rig);
        let take = ui.add_enabled(free && added && !old, egui::Button::new(w.take_improved)).clicked();
        let offered = [(w.write_report, Paper::DiagnosisReport), (w.save_tables, Paper::DiagnosisTables)];
        papers(ui, free && !old, view, &offered);
        take
    });
    diagnosis(ui, found, format, &mut view.asks);
    take.inner
}

/// Draws the result of a validation.
fn of_validation(ui: &mut Ui, session: &Session, view: &mut View) {
    let Some(answer) = &session.results.validation else { return };
    let (w, free, old) = (view.words(), session.task.is_none(), answer.is_old(session));
    heading(ui, w.validation_result, old, w);
    let rating = quality::sentence(&Quality::of_validation(&answer.found), view.words().of.words());
    wrapped(ui, RichText::new(view.format().restate(&rating)).strong());
    between_settings(ui, session, view.format());
    let unit = session.model.as_ref().and_then(|model| Some(model.over_setting()?.0.unit()));
    validation(ui, &answer.found, unit.unwrap_or_default(), view.format());
    let offered = [(w.write_report, Paper::ValidationReport), (w.save_tables, Paper::ValidationTables)];
    ui.horizontal_wrapped(|ui| papers(ui, free && !old, view, &offered));
}

/// Draws the result of a fit.
fn of_fit(ui: &mut Ui, session: &Session, view: &mut View) {
    let Some(answer) = &session.results.fit else { return };
    let (w, format, free) = (view.words(), view.format(), session.task.is_none());
    let old = answer.is_old(session);
    heading(ui, w.fit_result, old, w);
    // The sentence and the buttons stand above the numbers, because the numbers exceed the height of the window.
    if let Some(quality) = &answer.found.quality {
        wrapped(ui, RichText::new(format.restate(&quality::sentence(quality, format.words()))).strong());
    }
    papers(ui, free && !old, view, &[(w.save_tables, Paper::FitTables)]);
    fit(ui, &answer.found.fit, format);
}

/// Draws the result of a fit of an adjustable damper.
fn of_family_fit(ui: &mut Ui, session: &Session, view: &View) {
    let Some(answer) = &session.results.family_fit else { return };
    let w = view.words();
    heading(ui, w.fit_result, answer.is_old(session), w);
    between_settings(ui, session, view.format());
    family_fit(ui, &answer.found, view.format());
}

/// Reports how well the last fit of an adjustable damper predicts a left-out setting. Reports nothing if the model, the records or the
/// ticked tests have changed since that fit.
fn between_settings(ui: &mut Ui, session: &Session, format: Format) {
    let fit = session.results.family_fit.as_ref().filter(|fit| !fit.is_old(session));
    if let Some(fit) = fit {
        wrapped(ui, RichText::new(format.restate(&errors::between(&fit.found, format.words()))).strong());
    }
}

/// Draws the title of a result. Marks the result if model, records or tests have changed since.
fn heading(ui: &mut Ui, title: &str, old: bool, w: &Words) {
    ui.heading(title);
    if old {
        out_of_date(ui, w);
    }
}

/// Draws the mark of a result that does not belong to the data on screen.
pub fn out_of_date(ui: &mut Ui, w: &Words) {
    let text = RichText::new(format!("⚠ {}", w.old_result)).color(ui.visuals().warn_fg_color);
    ui.add(egui::Label::new(text).wrap());
}

/// Draws the buttons that write reports or workbooks of a result.
fn papers(ui: &mut Ui, free: bool, view: &mut View, offered: &[(&str, Paper)]) {
    for (text, paper) in offered {
        if ui.add_enabled(free, egui::Button::new(*text)).clicked() {
            view.asks.push(Ask::Paper(*paper));
        }
    }
}

fn wrapped(ui: &mut Ui, text: RichText) {
    ui.add(egui::Label::new(text).wrap());
}

fn fit(ui: &mut Ui, found: &Fit, format: Format) {
    let (w, said) = (format.texts(), format.words());
    wrapped(ui, RichText::new(format!("{} {}", found.tests.len(), w.tests_fitted)));
    inventory(ui, &found.inventory, false, format);
    for e in found.estimates.iter().filter(|e| e.index.is_none()) {
        let is_open = matches!(e.standing, Standing::NotIdentified);
        let figures = match (e.low, e.high) {
            _ if is_open => format.restate(&assumed_of(e, &found.params, said).unwrap_or_default()),
            (Some(low), Some(high)) => format.with_interval(e.value, low, high, e.unit),
            _ => format.quantity(e.value, e.unit),
        };
        let line = RichText::new(format!("{}{}{figures}", translate_name(e.name, said), said.colon)).small();
        ui.add(egui::Label::new(if is_open { line.weak() } else { line }).wrap()).on_hover_text(e.name);
    }
    // Notes on unidentified parameters are omitted, because the list above already contains these parameters.
    for note in found.further_notes() {
        wrapped(ui, RichText::new(format!("• {}", format.say(note))).weak());
    }
}

/// Draws the fit of an adjustable damper: dependences on the setting, errors at each setting, and parameters.
fn family_fit(ui: &mut Ui, found: &FamilyFit, format: Format) {
    let (w, said) = (format.texts(), format.words());
    let at = |setting: f64| format!("{} {}", w.typed(setting), found.setting.unit).trim_end().to_owned();
    wrapped(ui, RichText::new(format!("{} {}", found.tests.len(), w.tests_fitted)));
    ui.strong(said.family_errors_section);
    egui::Grid::new("family_errors").num_columns(4).striped(true).show(ui, |ui| {
        let name = setting_name(&found.setting.name, said);
        for heading in [name, said.family_own_fit, said.family_fit, said.family_without] {
            ui.add(egui::Label::new(RichText::new(heading).small().strong()).wrap());
        }
        ui.end_row();
        for of in &found.settings {
            ui.label(at(of.setting));
            for error in [Some(&of.own_fit), Some(&of.family), of.left_out.as_ref()] {
                let Some(error) = error else {
                    ui.label("–");
                    continue;
                };
                ui.label(format!("{} %", w.fixed(error.error_percent, 2)))
                    .on_hover_text(format.quantity(error.mean_error_n, "N"));
            }
            ui.end_row();
        }
    });
    wrapped(ui, RichText::new(said.family_dependences).small().weak());
    for of in &found.dependences {
        let how = if of.varies { said.yes } else { said.no };
        let figures = [how, &probability(of.probability)].join(said.semicolon);
        let line = format!("{}{}{figures}", translate_name(of.name, said), said.colon);
        ui.add(egui::Label::new(RichText::new(line).small()).wrap()).on_hover_text(of.name);
    }
    let items: Vec<InventoryItem> = found.inventory.iter().map(|of| of.item.clone()).collect();
    inventory(ui, &items, false, format);
    for FamilyEstimate { setting, estimate: e } in found.estimates.iter().filter(|e| e.estimate.index.is_none()) {
        let (Some(low), Some(high)) = (e.low, e.high) else { continue };
        let of = setting.map_or_else(String::new, |setting| format!(" ({})", at(setting)));
        let figures = format.with_interval(e.value, low, high, e.unit);
        let line = RichText::new(format!("{}{of}{}{figures}", translate_name(e.name, said), said.colon)).small();
        ui.add(egui::Label::new(line).wrap()).on_hover_text(e.name);
    }
    for note in &found.notes {
        wrapped(ui, RichText::new(format!("• {}", format.say(note))).weak());
    }
}

/// Draws each effect with its force and probability. If `status` is set, also draws whether the effect was kept, added, replaced or
/// removed.
fn inventory(ui: &mut Ui, items: &[InventoryItem], status: bool, format: Format) {
    if items.is_empty() {
        return;
    }
    let said = format.words();
    ui.strong(said.inventory_section);
    // Each effect has one line, because a table of four columns would be wider than the panel in most languages.
    let force = heading_in(said.col_force_rms, format.units);
    let headings = [force.as_str(), said.col_probability, said.col_status];
    let headings = headings[..if status { 3 } else { 2 }].join(said.semicolon);
    wrapped(ui, RichText::new(format!("{}{}{headings}", said.col_effect, said.colon)).small().weak());
    for item in items {
        let form = said.word(item.form);
        let hint = if form.is_empty() { item.effect.to_owned() } else { format!("{}: {form}", item.effect) };
        let mut parts = vec![format.error(item.force_n_rms), probability(item.probability).replace(' ', "\u{a0}")];
        if status {
            parts.push(status_text(item, said));
        }
        let line = format!("{}{}{}", translate_name(item.effect, said), said.colon, parts.join(said.semicolon));
        ui.add(egui::Label::new(RichText::new(line).small()).wrap()).on_hover_text(hint);
    }
}

/// Draws the errors of a validation. `setting_unit` is the unit of the setting of an adjustable damper.
fn validation(ui: &mut Ui, found: &Validation, setting_unit: &str, format: Format) {
    /// Width of a column of figures with its heading, px.
    const FIGURES: f32 = 64.0;
    let w = format.texts();
    let name_width = (ui.available_width() - 3.0 * FIGURES).max(80.0);
    egui::Grid::new("validation").num_columns(4).striped(true).show(ui, |ui| {
        for heading in ["", w.tests, w.model, w.fv_curve] {
            ui.label(RichText::new(heading).small().strong());
        }
        ui.end_row();
        let mut row = |name: &str, tests: usize, e: &Errors| {
            // A long name is wrapped, because it would push the figures out of the panel.
            ui.scope(|ui| {
                ui.set_max_width(name_width);
                ui.add(egui::Label::new(name).wrap());
            });
            ui.label(tests.to_string());
            ui.label(format!("{} %", w.fixed(e.model.error_percent, 2)))
                .on_hover_text(format.quantity(e.model.mean_error_n, "N"));
            ui.label(format!("{} %", w.fixed(e.fv_only.error_percent, 2)))
                .on_hover_text(format.quantity(e.fv_only.mean_error_n, "N"));
            ui.end_row();
        };
        let length = format.units.length();
        for r in &found.matrix.by_amplitude {
            let value = w.of.words().number(&digits(length.factor * r.value, 3));
            row(&format!("{} {value} {}", w.amplitude, length.symbol), r.tests, &r.errors);
        }
        for (name, of) in [(w.slow_tests, &found.matrix.slow), (w.not_periodic, &found.matrix.not_periodic)] {
            if let Some(r) = of {
                row(name, r.tests, &r.errors);
            }
        }
        for (name, summary) in [(w.used_in_fit, &found.used_in_fit), (w.left_out, &found.left_out)] {
            if let Some(s) = summary {
                row(name, s.tests, &s.errors);
            }
        }
        for of in &found.settings {
            row(format!("{} {setting_unit}", w.typed(of.setting)).trim_end(), of.summary.tests, &of.summary.errors);
        }
        if let Some(of) = &found.changing {
            row(w.of.words().family_changing, of.summary.tests, &of.summary.errors);
        }
        row(w.all_tests, found.overall.tests, &found.overall.errors);
    });
    wrapped(ui, RichText::new(w.percent_of).small().weak());
}

fn diagnosis(ui: &mut Ui, found: &Diagnosis, format: Format, asks: &mut Vec<Ask>) {
    let (w, said) = (format.texts(), format.words());
    inventory(ui, &found.inventory, true, format);
    for finding in &found.findings {
        ui.add_space(4.0);
        let form = if finding.form.is_empty() { String::new() } else { format!(" ({})", said.word(finding.form)) };
        wrapped(
            ui,
            RichText::new(format!("{}{form}, {} {}", said.named(finding.effect), fraction(finding.confidence), w.sure))
                .strong(),
        );
        wrapped(ui, RichText::new(said.meaning_of_element(finding.effect)));
        for (name, value) in &finding.parameters {
            let figures = format.with_interval(value.value, value.low, value.high, value.unit);
            wrapped(ui, RichText::new(format!("{}  {figures}", said.named(name))).small());
        }
        if finding.of_the_rig {
            wrapped(ui, RichText::new(w.of_the_rig).weak());
        }
        for rival in finding.rivals.iter().take(2) {
            wrapped(
                ui,
                RichText::new(format!("• {}{}{}", said.named(rival.effect), said.colon, format.say(&rival.why))).weak(),
            );
        }
    }
    for suspect in &found.suspects {
        wrapped(ui, RichText::new(format!("{}{}{}", said.named(suspect.effect), said.colon, format.say(&suspect.why))));
    }
    ui.add_space(4.0);
    let left = |held: Option<f64>| held.map_or_else(|| "–".to_owned(), |v| format.quantity(v, "N"));
    egui::Grid::new("before_after").num_columns(3).striped(true).show(ui, |ui| {
        for heading in [w.rms, w.fitted, w.left_out] {
            ui.strong(heading);
        }
        ui.end_row();
        for (name, f) in [(w.before, &found.before), (w.after, &found.after)] {
            ui.label(name);
            ui.label(format.quantity(f.rmse_n, "N"));
            ui.label(left(f.left_out_rmse_n));
            ui.end_row();
        }
        ui.label(w.noise);
        ui.label(format.quantity(found.before.noise_n, "N"));
        ui.label(left(found.before.left_out_noise_n));
        ui.end_row();
    });
    for region in found.regions.iter().take(5) {
        wrapped(ui, RichText::new(format!("• {}", format.say(&region.text))).weak());
    }
    if !found.next_tests.is_empty() {
        ui.strong(w.next_test);
    }
    for test in found.next_tests.iter().take(3) {
        wrapped(ui, RichText::new(format.say(&test.text)));
    }
    if let Some((matrix, _)) = found.next_matrix() {
        ui.horizontal_wrapped(|ui| {
            if ui.button(w.copy_rows).on_hover_text(w.copy_rows_hint).clicked() {
                ui.ctx().copy_text(matrix.clone());
            }
            if ui.button(w.save_matrix).on_hover_text(w.save_matrix_hint).clicked() {
                asks.push(Ask::Text("next_tests.csv", matrix));
            }
        });
    }
    if !found.changes.is_empty() {
        ui.strong(w.changed);
    }
    for change in &found.changes {
        let figures = format.with_interval(change.value, change.low, change.high, change.unit);
        let before = format.quantity(change.reference, change.unit);
        let name = format.restate(&changed_name(change, said));
        wrapped(ui, RichText::new(format!("{name}  {before} → {figures}")));
    }
    for note in &found.notes {
        wrapped(ui, RichText::new(format!("• {}", format.say(note))).weak());
    }
}
