//! Tables of limits, and their check on records, like `dashpot validate --limits`.

use crate::campaign::Campaign;
use crate::errors::{ValidationError, raise, say};
use crate::work;
use dashpot_identification::limits::{self, Limit, Quantity};
use dashpot_records::Record;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Limit as a Python tuple: name, quantity, velocity (m/s), low and high (N, or s for response times), amplitude (m), setting. A missing
/// bound is infinite or `None`.
pub type Row = (String, String, Option<f64>, Option<f64>, Option<f64>, Option<f64>, Option<f64>);

/// Makes limits from rows. An error message states the number of the first invalid row, from 1.
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
        // A limit without a name in the file has the name of its quantity. Return such a name as an empty text.
        let name =
            if Quantity::named(&name).is_ok_and(|q| quantity_name(q) == quantity) { String::new() } else { name };
        Ok((name, quantity.to_owned(), velocity_m_s, low, high, amplitude_m, setting))
    };
    found.into_iter().map(row).collect()
}

/// Raises an exception if one of the limits is invalid.
#[pyfunction]
pub fn check_limits(limits: Vec<Row>) -> PyResult<()> {
    of_rows(limits).map(|_| ())
}

/// Returns whether two values are the same setting.
#[pyfunction]
pub fn is_same_setting(a: f64, b: f64) -> bool {
    dashpot_records::is_same_setting(a, b)
}

/// Converts a value of a setting to another unit. Returns `None` if the units belong to different quantities.
#[pyfunction]
pub fn restate_setting(value: f64, unit: &str, to: &str) -> Option<f64> {
    let (mut value, mut unit) = (value, unit.to_owned());
    (unit == to || (!to.is_empty() && dashpot_records::restate_in_unit(&mut unit, to, [&mut value]))).then_some(value)
}

/// Figures of a campaign from which every limit on a force can be checked.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Figures {
    of: limits::Figures,
}

#[pymethods]
impl Figures {
    /// Measures the figures of a campaign's records.
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

    /// Restores figures from their [`text`](Figures::text).
    #[staticmethod]
    fn parse(text: &str) -> PyResult<Figures> {
        Ok(Figures { of: serde_json::from_str(text).map_err(raise::<ValidationError>)? })
    }

    /// Returns the figures as text, for storage and later checks of other limits.
    #[getter]
    fn text(&self) -> PyResult<String> {
        serde_json::to_string(&self.of).map_err(raise::<ValidationError>)
    }

    /// Compares the figures with limits. Returns the entry `limits` in the output of `dashpot validate --limits --json`, without the model.
    fn judge(&self, limits: Vec<Row>) -> PyResult<String> {
        let limits = of_rows(limits)?;
        limits::check_without_setting(&limits).map_err(raise::<ValidationError>)?;
        serde_json::to_string(&self.of.judge(&limits, None)).map_err(raise::<ValidationError>)
    }
}

/// Figures of a damper over a setting from which every limit can be checked.
#[pyclass(frozen, module = "dashpot._native")]
pub struct SettingsFigures {
    /// The figures.
    pub of: limits::SettingsFigures,
}

#[pymethods]
impl SettingsFigures {
    /// Measures the figures of records that have one setting.
    #[staticmethod]
    #[pyo3(signature = (campaign, setting, progress=None))]
    fn at(py: Python<'_>, campaign: &Campaign, setting: f64, progress: Option<Py<PyAny>>) -> PyResult<SettingsFigures> {
        let records: Vec<&Record> = campaign.records();
        let settings = vec![Some(setting); records.len()];
        let of = work::run(py, progress, |progress| {
            progress.say(0.0, "measuring");
            limits::SettingsFigures::measure((&records, &settings), &[])
        })?;
        Ok(SettingsFigures { of })
    }

    /// Restores figures from their [`text`](SettingsFigures::text).
    #[staticmethod]
    fn parse(text: &str) -> PyResult<SettingsFigures> {
        Ok(SettingsFigures { of: serde_json::from_str(text).map_err(raise::<ValidationError>)? })
    }

    /// Returns the figures as text, for storage and later checks of other limits.
    #[getter]
    fn text(&self) -> PyResult<String> {
        serde_json::to_string(&self.of).map_err(raise::<ValidationError>)
    }

    /// Compares the figures with limits. Returns the entry `limits` in the output of `dashpot validate --limits --json`, without the model.
    fn judge(&self, limits: Vec<Row>) -> PyResult<String> {
        let found = self.of.judge(&of_rows(limits)?, None).map_err(raise::<ValidationError>)?;
        serde_json::to_string(&found).map_err(raise::<ValidationError>)
    }
}
