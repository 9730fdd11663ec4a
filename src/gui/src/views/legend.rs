//! The legend above a plot. Every entry begins with the mark that the plot draws for it: a line, dashes, a dot or a ring.

use eframe::egui::{self, Color32, Pos2, Rect, RichText, Ui, WidgetInfo};

/// Font size of legends and remarks on plots, px.
pub const FONT_SIZE: f32 = 11.5;
/// Largest number of marks of entries without a name. The hues of tests repeat after so many.
const MARKS: usize = 8;

/// What the plot draws for an entry of its legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A solid line.
    Line,
    /// A dashed line.
    Dashes,
    /// Filled points.
    Dot,
    /// Points without filling.
    Ring,
}

/// An entry of a legend.
#[derive(Debug, Clone)]
pub struct Entry {
    /// Color of the line or the points.
    pub colour: Color32,
    /// Kind of line or points.
    pub mark: Mark,
    /// Name of what is drawn.
    pub name: String,
}

impl Entry {
    /// Makes an entry.
    pub fn new(colour: Color32, mark: Mark, name: impl Into<String>) -> Entry {
        Entry { colour, mark, name: name.into() }
    }

    /// Draws the mark into the left part of a rectangle, with this width, px.
    fn draw(&self, ui: &Ui, rect: Rect, width: f32) {
        let left = rect.left_center();
        let ends: [Pos2; 2] = [left, left + egui::vec2(width, 0.0)];
        let middle = left + egui::vec2(0.5 * width, 0.0);
        let stroke = egui::Stroke::new(2.0, self.colour);
        match self.mark {
            Mark::Line => _ = ui.painter().line_segment(ends, stroke),
            Mark::Dashes => ui.painter().extend(egui::Shape::dashed_line(&ends, stroke, 4.0, 2.5)),
            Mark::Dot => _ = ui.painter().circle_filled(middle, 3.0, self.colour),
            Mark::Ring => _ = ui.painter().circle_stroke(middle, 4.0, egui::Stroke::new(1.0, self.colour)),
        }
    }
}

/// Draws a legend. At most `most` entries show their names, further ones only their marks, and a tooltip lists their names.
pub fn show(ui: &mut Ui, entries: &[Entry], most: usize) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(4.0, 0.0);
        let ink = ui.visuals().text_color();
        for of in entries.iter().take(most) {
            let galley = ui.painter().layout_no_wrap(of.name.clone(), egui::FontId::proportional(FONT_SIZE), ink);
            // One allocation prevents a line break between the mark and its name.
            let (rect, entry) = ui.allocate_exact_size(galley.size() + egui::vec2(24.0, 2.0), egui::Sense::hover());
            entry.widget_info(|| WidgetInfo::labeled(egui::Role::Label, true, &of.name));
            of.draw(ui, rect, 16.0);
            ui.painter().galley(rect.left_top() + egui::vec2(20.0, 1.0), galley, ink);
        }
        let Some(rest) = entries.get(most..).filter(|rest| !rest.is_empty()) else { return };
        for of in rest.iter().take(MARKS) {
            let (rect, entry) = ui.allocate_exact_size(egui::vec2(12.0, FONT_SIZE + 4.0), egui::Sense::hover());
            entry.widget_info(|| WidgetInfo::labeled(egui::Role::Label, true, &of.name));
            of.draw(ui, rect, 10.0);
            entry.on_hover_text(&of.name);
        }
        let names: Vec<&str> = rest.iter().map(|entry| entry.name.as_str()).collect();
        ui.label(RichText::new(format!("+{}", rest.len())).size(FONT_SIZE)).on_hover_text(names.join("\n"));
    });
}
