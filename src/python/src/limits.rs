//! Limits: a table of them, what records say of each, pass or fail. All of it is what `dashpot validate --limits` does.

use crate::campaign::Campaign;
use crate::errors::{ValidationError, raise, say};
use crate::work;
use dashpot_identification::limits::{self, Limit, Quantity};
use dashpot_records::Record;
use pyo3::prelude::*;
use std::path::PathBuf;

/// One limit as Python hands it over: name, quantity, velocity (m/s), low and high (N), amplitude (m), setting. What has no bound is infinite or none.
pub type Row = (String, String, Option<f64>, Option<f64>, Option<f64>, Option<f64>, Option<f64>);

/// Limits from rows; the first that cannot be kept is named by its place.
pub fn of_rows(rows: Vec<Row>) -> PyResult<Vec<Limit>> {
    let limit = |(k, row): (usize, Row)| {
        let (name, quantity, velocity_m_s, low, high, amplitude_m, setting) = row;
        let made = Quantity::named(&quantity).and_then(|quantity| {
            let limit = Limit {
                name: if name.is_empty() { quantity_name(quantity).to_owned() } else { name },
                quantity,
                velocity_m_s,
                amplitude_m,
                low: low.filter(|low| *low != f64::NEG_INFINITY),
                high: high.filter(|high| *high != f64::INFINITY),
                setting,
                setting_unit: String::new(),
                line: k as u64 + 1,
            };
            limit.check().map(|()| limit)
        });
        made.map_err(|cause| say::<ValidationError>(format!("limit {} of those given: {cause}", k + 1)))
    };
    rows.into_iter().enumerate().map(limit).collect()
}

fn quantity_name(of: Quantity) -> &'static str {
    Quantity::NAMES.iter().find(|(_, quantity)| *quantity == of).map_or("", |(name, _)| name)
}

/// Reads a table of limits.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn read_limits(path: PathBuf) -> PyResult<Vec<Row>> {
    let found = limits::read(&path).map_err(raise::<ValidationError>)?;
    let row = |limit: Limit| {
        let Limit { name, quantity, velocity_m_s, amplitude_m, low, high, setting, setting_unit, line } = limit;
        if !setting_unit.is_empty() {
            return Err(say::<ValidationError>(format!(
                "{}, line {line}: the setting is in {setting_unit}; write it as a number in the unit of the damper",
                path.display()
            )));
        }
        let quantity = quantity_name(quantity);
        // A limit without a name is called by its quantity, as the file writes it.
        let name =
            if Quantity::named(&name).is_ok_and(|q| quantity_name(q) == quantity) { String::new() } else { name };
        Ok((name, quantity.to_owned(), velocity_m_s, low, high, amplitude_m, setting))
    };
    found.into_iter().map(row).collect()
}

/// Whether these can be limits.
#[pyfunction]
pub fn check_limits(limits: Vec<Row>) -> PyResult<()> {
    of_rows(limits).map(|_| ())
}

/// Everything that a limit may ask of a campaign, taken from its records.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Figures {
    of: limits::Figures,
}

#[pymethods]
impl Figures {
    /// Measures records.
    #[staticmethod]
    #[pyo3(signature = (campaign, progress=None))]
    fn measure(py: Python<'_>, campaign: &Campaign, progress: Option<Py<PyAny>>) -> PyResult<Figures> {
        let records: Vec<&Record> = campaign.records();
        let of = work::run(py, progress, |progress| {
            progress.say(0.0, "measuring");
            limits::Figures::measure(&records, None)
        })?;
        Ok(Figures { of })
    }

    /// From what [`text`](Figures::text) gave.
    #[staticmethod]
    fn parse(text: &str) -> PyResult<Figures> {
        Ok(Figures { of: serde_json::from_str(text).map_err(raise::<ValidationError>)? })
    }

    /// As text, to be kept and asked for other limits later.
    #[getter]
    fn text(&self) -> PyResult<String> {
        serde_json::to_string(&self.of).map_err(raise::<ValidationError>)
    }

    /// Compares them with limits: `limits` in what `dashpot validate --limits --json` writes, without the model.
    fn judge(&self, limits: Vec<Row>) -> PyResult<String> {
        let limits = of_rows(limits)?;
        limits::check_without_setting(&limits).map_err(raise::<ValidationError>)?;
        serde_json::to_string(&self.of.judge(&limits, None)).map_err(raise::<ValidationError>)
    }
}
