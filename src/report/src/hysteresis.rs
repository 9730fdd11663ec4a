//! Hysteresis of every test that has whole cycles.

use super::blocks::{Block, Column, Section, Table};
use super::numbers::{beside, error};
use dashpot_identification::validation::{Hysteresis, OfEach, TestValidation, Validation};

const GAP: &str = "mean gap, N";
const AREA: &str = "loop area ∮F dv, N·m/s";
const ENERGY: &str = "energy ∮F dx, J";

/// The table; `None` where no test has whole cycles.
pub fn section(validation: &Validation) -> Option<Section> {
    let measured: Vec<(&TestValidation, &Hysteresis)> =
        validation.tests.iter().filter_map(|test| Some((test, test.hysteresis.as_ref()?))).collect();
    if measured.is_empty() {
        return None;
    }
    let rows = measured
        .iter()
        .map(|(test, hysteresis)| {
            let mut cells = vec![test.name.clone(), hysteresis.cycles.to_string()];
            cells.extend(each(&hysteresis.mean_gap_n, error));
            cells.extend([error(hysteresis.gap_error_n), error(hysteresis.gap_error_fv_only_n)]);
            cells.extend(each(&hysteresis.area_n_m_s, |value| beside(value, hysteresis.area_n_m_s.measured)));
            cells.extend(each(&hysteresis.energy_j, |value| beside(value, hysteresis.energy_j.measured)));
            cells
        })
        .collect();
    let mut columns = vec![Column::words("test"), Column::figures("cycles")];
    let names = ["measured", "model", "curve"];
    columns.extend(names.map(|name| Column::figures(name).of(GAP)));
    columns.extend(["model", "curve"].map(|name| Column::figures(name).of("gap error, N")));
    columns.extend(names.map(|name| Column::figures(name).of(AREA)));
    columns.extend(names.map(|name| Column::figures(name).of(ENERGY)));
    let caption =
        "Averages over whole cycles. Gap: the difference between the force at rising and at falling velocity, \
                   at equal velocity; its magnitude is averaged over the velocities of the test. Gap error: mean of \
                   |simulated gap − measured gap|. A negative loop area means that the force lags behind the velocity \
                   (gas and oil compressibility), a positive one that it leads (moving mass)."
            .to_owned();
    let table = Table { caption, columns, rows, sortable: true };
    Some(Section::new("hysteresis", "Hysteresis", vec![Block::Table(table)]))
}

fn each(of: &OfEach, text: impl Fn(f64) -> String) -> [String; 3] {
    [text(of.measured), text(of.model), text(of.fv_only)]
}
