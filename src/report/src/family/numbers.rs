//! Parameters of the damper over the setting, with their intervals.

use super::{axis_title, named};
use crate::blocks::{Column, Figure, Table};
use crate::cells::Cell;
use crate::inventory::probability;
use crate::numbers::{digits, error};
use crate::plot::axes::{Axis, Marks, Plane, SIZE, Series};
use crate::plot::palette::Role;
use crate::words::Words;
use dashpot_core::number;
use dashpot_core::parameter::{self, Number, Row};
use dashpot_identification::family::{FamilyFit, FamilyItem, ForceAtSetting};
use dashpot_identification::model_file::{Interval, IntervalOverSetting, ModelFile};

/// Parameters that have a figure even if they do not depend on the setting: friction forces and the gas force.
const ALWAYS: [Number; 5] = [
    number!("coulomb_force"),
    number!("stribeck_coulomb_force"),
    number!("stribeck_breakaway_force"),
    number!("presliding_force"),
    number!("gas_force"),
];
/// Number of points of a line over the setting.
const POINTS: usize = 61;

/// Draws a figure for each parameter of an enabled element that depends on the setting or is in [`ALWAYS`].
pub fn figures(model: &ModelFile, words: &Words) -> Vec<Figure> {
    let varies = |number: Number| model.axis.values(number).is_some();
    let wanted = |row: &Row| {
        let number = Number::try_from(*row).ok()?;
        let is_on = row.element().is_none_or(|element| model.params.is_on(element));
        (is_on && (varies(number) || ALWAYS.contains(&number))).then_some(number)
    };
    parameter::table().filter_map(|row| wanted(&row)).map(|number| figure(model, number, words)).collect()
}

/// Returns the 95 % interval of a parameter at the grid setting with index `place`, or `None` if the fit has no
/// interval.
fn interval(model: &ModelFile, number: Number, place: usize) -> Option<[f64; 2]> {
    let known = &model.identification;
    let found = match known.intervals_over_setting.get(number.name()) {
        Some(IntervalOverSetting::Number(all)) => all.get(place).copied(),
        _ => match known.intervals.get(number.name()) {
            Some(Interval::Number(ends)) => Some(*ends),
            _ => None,
        },
    };
    // Equal ends mean that there is no interval.
    found.filter(|[low, high]| low < high)
}

fn value_at(model: &ModelFile, number: Number, setting: f64) -> f64 {
    model.definition().params_at(setting).number(number)
}

fn figure(model: &ModelFile, number: Number, words: &Words) -> Figure {
    let (low, high) = model.axis.range();
    let grid = model.axis.grid();
    let between = |k: usize| low + (high - low) * k as f64 / (POINTS - 1) as f64;
    let line = (0..POINTS).map(between).map(|setting| [setting, value_at(model, number, setting)]).collect();
    let points = grid.iter().map(|setting| [*setting, value_at(model, number, *setting)]).collect();
    let bars: Vec<Vec<[f64; 2]>> = grid
        .iter()
        .enumerate()
        .filter_map(|(place, setting)| Some(interval(model, number, place)?.map(|end| [*setting, end]).to_vec()))
        .collect();
    let mut series = vec![
        Series { role: Role::Model, label: words.model, lines: vec![line], marks: Marks::Line },
        Series { role: Role::Model, label: words.model, lines: vec![points], marks: Marks::Dots },
    ];
    let mut names = vec![words.model.to_owned(), String::new()];
    if !bars.is_empty() {
        series.push(Series { role: Role::Limit, label: words.col_interval, lines: bars, marks: Marks::Both });
        names.push(words.col_interval.to_owned());
    }
    let definition = model.definition();
    let parameter = number.parameter();
    let all = || series.iter().flat_map(|series| &series.lines).flatten().copied();
    // The axis includes zero, so that a nearly constant parameter looks constant.
    let values = all().map(|p| p[1]).chain([0.0]);
    let plane = Plane {
        title: words.named(number.name()),
        x: Axis::around(axis_title(&definition, words), all().map(|p| p[0])),
        y: Axis::around(
            format!("{}, {}", words.name_of(number.name()).unwrap_or(number.name()), parameter.unit),
            values,
        ),
        series: series.clone(),
    };
    let how = match model.axis.values(number) {
        Some(_) => words.number_varies,
        None => words.number_shared,
    };
    let caption = format!("{} {how}", words.meaning_of_parameter(parameter.name));
    let svg = plane.draw_named(&names, SIZE, words);
    Figure::new(format!("number-{}", number.name()), svg).saying(caption)
}

/// Builds the table of every parameter that depends on the setting, and of the points of the FV curve, at each value of
/// the grid.
pub fn table(model: &ModelFile, words: &Words) -> Option<Table> {
    let definition = model.definition();
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    let known = |value: Option<f64>| value.map_or_else(Cell::none, |value| Cell::digits(value, 4));
    for row in parameter::table() {
        let Some((number, values)) =
            Number::try_from(row).ok().and_then(|number| Some((number, model.axis.values(number)?)))
        else {
            continue;
        };
        for (place, (setting, value)) in model.axis.grid().iter().zip(values).enumerate() {
            let ends = interval(model, number, place);
            rows.push(vec![
                number.name().into(),
                named(&definition, *setting, words).into(),
                Cell::digits(*value, 4),
                row.parameter.unit.into(),
                known(ends.map(|ends| ends[0])),
                known(ends.map(|ends| ends[1])),
            ]);
        }
    }
    rows.extend(curve_rows(model, words));
    if rows.is_empty() {
        return None;
    }
    let columns = vec![
        Column::words(words.col_name),
        Column::words(words.col_setting),
        Column::figures(words.col_value),
        Column::words(words.col_unit),
        Column::figures(words.col_low),
        Column::figures(words.col_high),
    ];
    Some(Table { caption: words.family_numbers_table.to_owned(), columns, rows, sortable: true })
}

/// Builds the rows for the points of the FV curve at each value of the grid.
fn curve_rows(model: &ModelFile, words: &Words) -> Vec<Vec<Cell>> {
    let definition = model.definition();
    let velocities = model.params.list(dashpot_core::list!("fv_velocity"));
    let over = model.identification.intervals_over_setting.get("fv_force");
    let mut rows = Vec::new();
    for (place, setting) in model.axis.grid().iter().enumerate() {
        let Some(forces) = model.axis.forces(place) else { continue };
        for (k, (velocity, force)) in velocities.iter().zip(forces).enumerate() {
            let ends = match over {
                Some(IntervalOverSetting::List(all)) => all.get(place).and_then(|all| all.get(k)).copied(),
                _ => None,
            };
            let known = |end: usize| {
                ends.filter(|[low, high]| low < high).map_or_else(Cell::none, |ends| Cell::digits(ends[end], 4))
            };
            let at = words.number(&format!("{} mm/s", digits(1e3 * velocity, 4)));
            rows.push(vec![
                format!("fv_force ({at})").into(),
                named(&definition, *setting, words).into(),
                Cell::digits(*force, 4),
                "N".into(),
                known(0),
                known(1),
            ]);
        }
    }
    rows
}

/// Builds the table of every effect's force at each setting. Returns `None` if the FV curve is the only effect.
pub fn effects(model: &ModelFile, fit: &FamilyFit, words: &Words) -> Option<Table> {
    let definition = model.definition();
    let rows_of = |of: &FamilyItem| -> Vec<Vec<Cell>> {
        let row = |here: &ForceAtSetting| {
            vec![
                words.named(of.item.effect).into(),
                words.word(of.item.form).into(),
                Cell { text: probability(of.item.probability), ..Cell::fraction(of.item.probability) },
                named(&definition, here.setting, words).into(),
                Cell::number(here.force_n_rms, error),
                Cell::fraction(here.fraction),
            ]
        };
        of.settings.iter().map(row).collect()
    };
    let columns = vec![
        Column::words(words.col_effect),
        Column::words(words.col_form),
        Column::figures(words.col_probability),
        Column::words(words.col_setting),
        Column::figures(words.col_force_rms),
        Column::figures(words.col_share_of_force),
    ];
    let rows: Vec<Vec<Cell>> = fit.inventory.iter().flat_map(rows_of).collect();
    let caption = words.family_effects.to_owned();
    (!rows.is_empty()).then_some(Table { caption, columns, rows, sortable: true })
}

/// Builds the table of dependences on the setting, with their probabilities.
pub fn dependences(fit: &FamilyFit, words: &Words) -> Table {
    let rows = fit.dependences.iter().map(|of| {
        let how = if of.varies { words.yes } else { words.no };
        vec![of.name.into(), how.into(), Cell::digits(of.probability, 2)]
    });
    let columns =
        vec![Column::words(words.col_name), Column::words(words.family_varies), Column::figures(words.col_probability)];
    Table { caption: words.family_dependences.to_owned(), columns, rows: rows.collect(), sortable: false }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{FR, ZH};
    use dashpot_identification::model_file::family_of_text;

    #[test]
    fn axes_have_the_names_of_the_language() {
        let text = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\n\
             setting_unit = \"A\"\ngas_force = [150.0, 160.0]\n";
        let file = family_of_text(text, "m.toml".as_ref()).unwrap();
        for (words, name, setting) in [(&FR, "effort de gaz", "courant"), (&ZH, "气体力", "电流")] {
            let all = figures(&file, words);
            let svg = &all.iter().find(|figure| figure.file == "number-gas_force").unwrap().svg;
            for label in [format!(">{name}, N<"), format!(">{setting}, A<")] {
                assert!(svg.contains(&label), "{label}: {svg}");
            }
            assert!(svg.contains(&words.named("gas_force")));
        }
    }
}
