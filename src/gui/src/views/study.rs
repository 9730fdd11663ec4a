//! Panel for the variation of one parameter and for the preview of an effect over the measured loops. Chapter 3 of
//! Jonnalagadda & Vyas 2020 varies parameters in this way.

use crate::session::Session;
use crate::session::model::Reach;
use crate::session::study::{Member, Question, Study};
use crate::units::{Units, read};
use crate::views::legend::{self, Entry, Mark};
use crate::views::{Corner, View, hue, named_list, translate_name};
use crate::views::{grid, results};
use crate::words::Words;
use dashpot_core::parameter::{self, Element, Number, Row, Shape};
use dashpot_estimation::scale::Scale;
use eframe::egui::{self, ComboBox, RichText, Slider, Ui, WidgetInfo};
use egui_plot::{Line, Plot, PlotPoints};

/// Input fields of the study.
pub struct Form {
    number: Option<Number>,
    /// First and last value, SI; `None` selects the range of the slider.
    range: Option<[f64; 2]>,
    count: usize,
}

impl Default for Form {
    fn default() -> Self {
        // Seven loops are distinguishable, and the fourth of them is in the middle of the range.
        Form { number: None, range: None, count: 7 }
    }
}

/// Draws the panel.
pub fn show(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    let Some(model) = &session.model else {
        ui.label(w.no_model);
        return;
    };
    let params = *model.params();
    let on = |row: &Row| row.element().is_some() && params.counts(row);
    let rows = parameter::table().filter(|r| on(r) && matches!(r.parameter.shape, Shape::Scalar));
    let numbers: Vec<Number> = rows.filter_map(|row| Number::try_from(row).ok()).collect();
    ui.heading(w.study);
    ui.add(egui::Label::new(RichText::new(w.study_hint).weak()).wrap());
    let form = &mut view.question;
    if !form.number.is_some_and(|number| numbers.contains(&number)) {
        form.number = numbers.first().copied();
        form.range = None;
    }
    let (said, units) = (w.of.words(), view.units);
    let shown_name = form.number.map_or_else(String::new, |number| translate_name(number.name(), said));
    let list = ComboBox::from_id_salt("parameter").selected_text(shown_name).width(220.0).show_ui(ui, |ui| {
        for number in &numbers {
            let label = ui.selectable_label(form.number == Some(*number), translate_name(number.name(), said));
            if label.on_hover_text(number.name()).clicked() {
                form.number = Some(*number);
                form.range = None;
            }
        }
    });
    named_list(list, w.study);
    if let Some(number) = form.number {
        let value = params.number(number);
        let reach =
            Reach::new(number.row(), Scale::from_params(&params), value, value, model.interval(number.name(), 0));
        let [low, high] = form.range.unwrap_or(around(value, &reach));
        let unit = units.shown(number.parameter().unit);
        let (mut from, mut to) = (low, high);
        for (text, end) in [(w.from, &mut from), (w.to, &mut to)] {
            ui.horizontal(|ui| {
                ui.label(text);
                let mut shown_value = unit.factor * *end;
                let speed = (shown_value.abs() * 0.01).max(1e-9);
                let field = egui::DragValue::new(&mut shown_value)
                    .speed(speed)
                    .custom_formatter(|v, _| w.typed(v))
                    .custom_parser(read);
                let field = ui.add(field);
                field.widget_info(|| WidgetInfo::labeled(egui::Role::SpinButton, true, text));
                if field.changed() {
                    *end = number.inside(shown_value / unit.factor);
                }
                ui.label(&unit.symbol);
            });
        }
        form.range = Some([from, to]);
        ui.add(Slider::new(&mut form.count, 2..=15).text(w.loops));
        let test = session.selected.iter().next_back().copied();
        let can = session.task.is_none() && session.has_records() && test.is_some() && from < to;
        let count = form.count;
        if ui.add_enabled(can, egui::Button::new(w.compute)).clicked()
            && let Some(test) = test
        {
            view.corner = Corner::Study;
            session.study(Question { number, range: [from, to], factors: reach.factors, count, test });
        }
    }
    if let Some(study) = &session.study {
        if study.is_old(session) {
            results::out_of_date(ui, w);
        }
        table(ui, study, units, w);
    }
    ui.separator();
    effect(ui, session, view, w);
}

/// Returns an informative range around a value. On a logarithmic scale, this is a factor of three to either side,
/// otherwise the range of the slider.
fn around(value: f64, reach: &Reach) -> [f64; 2] {
    if reach.factors && value > 0.0 {
        [(value / 3.0).max(reach.low), (3.0 * value).min(reach.high)]
    } else {
        [reach.low, reach.high]
    }
}

fn table(ui: &mut Ui, study: &Study, units: Units, w: &Words) {
    let (force, work) = (units.force(), units.energy());
    let unit = units.shown(study.question.number.parameter().unit);
    egui::Grid::new("study").num_columns(3).striped(true).show(ui, |ui| {
        ui.strong(format!("{} [{}]", translate_name(study.question.number.name(), w.of.words()), unit.symbol));
        ui.strong(format!("{} [{}]", w.area, work.symbol));
        ui.strong(format!("{} [{}]", w.gap, force.symbol));
        ui.end_row();
        for (k, member) in study.members.iter().enumerate() {
            ui.label(RichText::new(w.digits(unit.factor * member.value)).color(hue(k)));
            ui.label(w.digits(work.factor * member.area));
            ui.label(w.digits(force.factor * member.gap));
            ui.end_row();
        }
        ui.label(w.measured);
        ui.label(w.digits(work.factor * study.measured[0]));
        ui.label(w.digits(force.factor * study.measured[1]));
        ui.end_row();
    });
}

fn effect(ui: &mut Ui, session: &Session, view: &mut View, w: &Words) {
    let Some(model) = &session.model else { return };
    ui.heading(w.effect_inspect);
    ui.add(egui::Label::new(RichText::new(w.effect_hint).weak()).wrap());
    let mut chosen = view.effect.map(|(element, _)| element);
    let list = ComboBox::from_id_salt("effect")
        .selected_text(chosen.map_or(w.none.to_owned(), |element| translate_name(element.name(), w.of.words())))
        .width(220.0)
        .show_ui(ui, |ui| {
            ui.selectable_value(&mut chosen, None, w.none);
            for element in Element::all().filter(|element| !model.params().is_on(*element)) {
                ui.selectable_value(&mut chosen, Some(element), translate_name(element.name(), w.of.words()))
                    .on_hover_text(w.of.words().meaning_of_element(element.group().name));
            }
        });
    named_list(list, w.effect_inspect);
    let mut strength = view.effect.map_or(1.0, |(_, s)| s);
    if chosen.is_some() {
        let slider = ui.add(Slider::new(&mut strength, 0.05..=10.0).logarithmic(true).text(w.strength));
        slider.widget_info(|| WidgetInfo::slider(true, strength, w.strength));
    }
    if let Some(element) = chosen {
        let meaning = w.of.words().meaning_of_element(element.group().name);
        ui.add(egui::Label::new(RichText::new(meaning).small().weak()).wrap());
    }
    view.effect = chosen.map(|element| (element, strength));
}

/// Draws the measured loop, and the loops for all values of the parameter.
pub fn plot(ui: &mut Ui, session: &Session, units: Units, w: &'static Words) {
    let (Some(study), Some(loaded)) = (&session.study, &session.campaign) else {
        ui.label(w.study_hint);
        return;
    };
    let Some(seen) = loaded.tests.get(study.question.test) else { return };
    let unit = units.shown(study.question.number.parameter().unit);
    let (speed, newtons) = (units.velocity(), units.force());
    ui.strong(format!(
        "{} · {}",
        translate_name(study.question.number.name(), w.of.words()),
        loaded.campaign.records[study.question.test].name
    ));
    if study.is_old(session) {
        results::out_of_date(ui, w);
    }
    let weak = ui.visuals().weak_text_color();
    let name = |member: &Member| format!("{} {}", w.digits(unit.factor * member.value), unit.symbol);
    let of_members = study.members.iter().enumerate();
    let mut entries = vec![Entry::new(weak, Mark::Line, w.measured)];
    entries.extend(of_members.map(|(k, member)| Entry::new(hue(k), Mark::Line, name(member))));
    legend::show(ui, &entries, entries.len());
    let velocity = &seen.cycle_motion.velocity;
    let step = seen.cycle_samples.div_ceil(400).max(1);
    let points = |force: &[f64]| -> Vec<[f64; 2]> {
        (0..force.len().min(seen.cycle_samples))
            .step_by(step)
            .chain([0])
            .map(|i| [speed.factor * velocity[i], newtons.factor * force[i]])
            .collect()
    };
    let lower = format!("{} [{}]", w.velocity, speed.symbol);
    let left = format!("{} [{}]", w.force, newtons.symbol);
    grid::with_axes(Plot::new("study"), lower, left, w).show(ui, |plot| {
        let measured = points(&seen.cycle.force[..seen.cycle_samples]);
        plot.line(Line::new(w.measured, PlotPoints::from(measured)).color(weak).width(2.0));
        for (k, member) in study.members.iter().enumerate() {
            plot.line(Line::new(name(member), PlotPoints::from(points(&member.force))).color(hue(k)).width(1.2));
        }
    });
}
