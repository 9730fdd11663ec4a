//! A campaign of the virtual rig in the form that a user has: read from files, with an identified model.

use crate::SeverityError;
use dashpot_core::parameter::Element;
use dashpot_core::{Params, element, number};
use dashpot_identification::{FitOptions, fit};
use dashpot_records::{self as records, Record};
use dashpot_rig::Campaign;
use std::path::Path;

/// Elements of the fit in [`base_model`]: those of the model of Jonnalagadda and Vyas (KTH, 2020) without the
/// break-away peak.
pub const BASE: [Element; 4] =
    [element!("fv_curve"), element!("series_compliance"), element!("coulomb_friction"), element!("gas_preload")];

/// Identifies the diagnosed model: an ordinary fit to the records, to which side-force friction and a weak linear
/// spring (300 N/m) are added.
pub fn base_model(records: &[&Record]) -> Result<Params, SeverityError> {
    let options =
        FitOptions { elements: Some(BASE.map(|element| element.name().to_owned()).to_vec()), ..FitOptions::default() };
    let mut params = fit(records, &options, |_| ())?.params;
    for element in [
        element!("series_compliance"),
        element!("coulomb_friction"),
        element!("side_force_friction"),
        element!("parallel_spring"),
        element!("gas_preload"),
    ] {
        params.enable(element, true);
    }
    for (number, value) in [
        (number!("spring_linear"), 300.0),
        (number!("spring_quadratic"), 0.0),
        (number!("spring_cubic"), 0.0),
        (number!("spring_quartic"), 0.0),
    ] {
        let _ = params.set(number, value);
    }
    Ok(params)
}

/// Copies a campaign with the forces that sensors without noise would measure.
pub fn without_noise(campaign: &Campaign) -> Campaign {
    let mut clean = campaign.clone();
    for record in &mut clean.records {
        record.force_n.clone_from(&record.clean_force_n);
    }
    clean
}

/// Writes the records to files and loads them, like a user.
pub fn read(campaign: &Campaign) -> Result<Vec<Record>, SeverityError> {
    write_and_read(|path| Ok(campaign.write(path)?))
}

/// Reads the records of a campaign from a folder into which `write` writes them.
pub fn write_and_read<E: From<SeverityError>>(write: impl FnOnce(&Path) -> Result<(), E>) -> Result<Vec<Record>, E> {
    let folder = tempfile::tempdir().map_err(SeverityError::Folder)?;
    let path = folder.path().join("campaign");
    write(&path)?;
    let options = records::Options { positive: Some(records::Positive::Rebound), ..records::Options::default() };
    let loaded = records::load(&[path], &options, &|_| ()).map_err(|e| SeverityError::Records(e.to_string()))?;
    Ok(loaded.records)
}
