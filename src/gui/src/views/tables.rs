//! Tables of the forces at the peak velocities of all tests (PVP) and at given velocities within a cycle (CVP). Dynos print both tables.

use crate::dialogs::Ask;
use crate::session::Session;
use crate::session::velocities::{Pair, at_peaks, within_cycle};
use crate::views::{View, text_width};
use eframe::egui::{self, RichText, Ui};

/// Largest width of a heading, px, unless one of its words is longer. Five columns fit into a window of 1280 px.
const HEADING: f32 = 64.0;

/// A table in the selected units: headings, then rows of texts.
struct Table {
    headings: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// Draws the tables of the forces at peak velocities and at given velocities.
pub fn show(ui: &mut Ui, session: &Session, view: &mut View) {
    let w = view.words();
    let selected = session.selected.iter().next_back().copied();
    egui::ScrollArea::vertical().id_salt("tables").auto_shrink([false, false]).show(ui, |ui| {
        if let Some(test) = selected {
            let name = session.record(test).map_or("", |record| &record.name);
            let title = format!("{} · {name}", w.cvp);
            draw(ui, view, "cvp", &title, "cvp.csv", &cvp(session, view, test));
            ui.add_space(8.0);
        }
        draw(ui, view, "pvp", w.pvp, "pvp.csv", &pvp(session, view));
    });
}

fn force(view: &View, pair: Option<Pair>) -> [String; 2] {
    let (w, factor) = (view.words(), view.units.force().factor);
    let said = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |f| w.digits(factor * f));
    [said(pair.map(|p| p.0)), said(pair.and_then(|p| p.1))]
}

/// Returns the heading of the model's forces. Provisional forces have a mark.
fn model_heading(session: &Session, view: &View) -> String {
    let mark = if session.are_errors_provisional() { "≈\u{a0}" } else { "" };
    format!("{mark}{} [{}]", view.words().model, view.units.force().symbol)
}

fn pvp(session: &Session, view: &View) -> Table {
    let (w, units) = (view.words(), view.units);
    let (v, x, f) = (units.velocity(), units.length(), units.force());
    let mut headings = vec![w.test.to_owned(), format!("{} [{}]", w.amplitude, x.symbol)];
    for side in [w.rebound, w.compression] {
        headings.push(format!("{side} [{}]", v.symbol));
        headings.push(format!("{} [{}]", w.measured, f.symbol));
        headings.push(model_heading(session, view));
    }
    let rows = at_peaks(session).into_iter().map(|row| {
        let mut cells = vec![row.test, w.digits(x.factor * row.amplitude)];
        for side in row.sides {
            cells.push(side.map_or_else(|| "–".to_owned(), |(velocity, _)| w.digits(v.factor * velocity)));
            cells.extend(force(view, side.map(|s| s.1)));
        }
        cells
    });
    Table { headings, rows: rows.collect() }
}

fn cvp(session: &Session, view: &View, test: usize) -> Table {
    let (w, units) = (view.words(), view.units);
    let (v, f) = (units.velocity(), units.force());
    let mut headings = vec![format!("{} [{}]", w.velocity, v.symbol)];
    for way in [w.opening, w.closing_speed] {
        headings.push(format!("{way}, {} [{}]", w.measured, f.symbol));
        headings.push(format!("{way}, {}", model_heading(session, view)));
    }
    let rows = within_cycle(session, test, v.factor).into_iter().map(|row| {
        let mut cells = vec![w.digits(v.factor * row.velocity)];
        row.forces.into_iter().for_each(|pair| cells.extend(force(view, pair)));
        cells
    });
    Table { headings, rows: rows.collect() }
}

fn draw(ui: &mut Ui, view: &mut View, id: &str, title: &str, file: &'static str, table: &Table) {
    let w = view.words();
    ui.horizontal_wrapped(|ui| {
        ui.strong(title);
        if ui.small_button(w.save_table).clicked() {
            view.asks.push(Ask::Text(file, text(table, w.of.words().decimal_sign)));
        }
    });
    egui::ScrollArea::horizontal().id_salt(id).show(ui, |ui| {
        egui::Grid::new(id).num_columns(table.headings.len()).striped(true).spacing([4.0, 2.0]).show(ui, |ui| {
            for heading in &table.headings {
                // A heading in one line would be wider than its numbers, and only two columns would be visible.
                let words = heading.split([' ', '\n']);
                let longest = words.map(|word| text_width(ui, word, egui::TextStyle::Small)).fold(HEADING, f32::max);
                ui.scope(|ui| {
                    ui.set_max_width(longest.ceil());
                    let heading = RichText::new(heading.replace(", ", "\n")).small().strong();
                    ui.add(egui::Label::new(heading).wrap());
                });
            }
            ui.end_row();
            for row in &table.rows {
                for (k, cell) in row.iter().enumerate() {
                    let text = RichText::new(cell).small();
                    if k == 0 {
                        ui.label(text);
                    } else {
                        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| ui.label(text));
                    }
                }
                ui.end_row();
            }
        });
    });
}

/// Formats a table as CSV. Numbers have a decimal point in every language, because other programs read the file.
fn text(table: &Table, decimal_sign: &str) -> String {
    let quoted = |cell: &String| format!("\"{}\"", cell.replace('"', "\"\""));
    let plain = |cell: &String| {
        let number = cell.replace('\u{2212}', "-").replace(decimal_sign, ".");
        if number.parse::<f64>().is_ok() {
            number
        } else if cell == "–" {
            String::new()
        } else {
            quoted(cell)
        }
    };
    let mut out = table.headings.iter().map(quoted).collect::<Vec<_>>().join(",") + "\n";
    for row in &table.rows {
        // Every cell that looks like a number is written as a number, even the name of a test in the first column.
        out += &(row.iter().map(plain).collect::<Vec<_>>().join(",") + "\n");
    }
    out
}
