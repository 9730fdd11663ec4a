//! The models of the literature beside a model.
//!
//! Those that are asked for, identified from the tests that the model was fitted to, on the same records.

use dashpot_identification::literature::file::{self, FileError};
use dashpot_identification::literature::{Literature, LiteratureError, MODELS, observation};
use dashpot_identification::model_file::ModelFile;
use dashpot_identification::validation::{Against, Compared, Validation};
use dashpot_records::{Campaign, Record};
use rayon::prelude::*;
use std::path::Path;

/// Said where [`Rivals::fitted_to_all`].
pub const FITTED_TO_ALL: &str = "the model file names no tests; the models compared with are fitted to all tests given";

/// Why there is nothing to compare with.
#[derive(Debug, thiserror::Error)]
pub enum AgainstError {
    /// No such model, or none that fits.
    #[error(transparent)]
    Literature(#[from] LiteratureError),
    /// A file that is none.
    #[error(transparent)]
    File(#[from] FileError),
    /// Other tests than those that the model was fitted to.
    #[error(
        "--against identifies its models from the tests that the model was fitted to, and none of those {count} is in the data given, such as \
         {first:?}: give them beside the others"
    )]
    OtherTests {
        /// How many there are.
        count: usize,
        /// One of them.
        first: String,
    },
}

/// A model to compare with, and its forces on every record, N.
#[derive(Debug, Clone)]
pub struct Rival {
    /// The model with its numbers.
    pub literature: Literature,
    /// Its forces, record by record.
    pub forces: Vec<Vec<f64>>,
}

/// Models to compare with.
#[derive(Debug, Clone, Default)]
pub struct Rivals {
    /// In the order in which they were asked for.
    pub all: Vec<Rival>,
    /// Whether the model file names no test, so that they were fitted to all of these.
    pub fitted_to_all: bool,
}

/// The models asked for, each once: names, `all`, or files that `dashpot fit --model` wrote. A mistake is told before minutes of fitting.
///
/// # Errors
/// A name that is neither.
pub fn named(wanted: &[String]) -> Result<Vec<String>, LiteratureError> {
    let mut names: Vec<String> = Vec::new();
    for name in wanted {
        let more = if name == "all" { MODELS.map(|m| m.0.to_owned()).to_vec() } else { vec![name.clone()] };
        names.extend(more.into_iter().filter(|n| !names.contains(n)).collect::<Vec<_>>());
    }
    match names.iter().find(|name| !is_model(name) && !Path::new(name).exists()) {
        Some(name) => Err(LiteratureError::Unknown { name: name.clone() }),
        None => Ok(names),
    }
}

fn is_model(name: &str) -> bool {
    MODELS.iter().any(|m| m.0 == name)
}

impl Rivals {
    /// Identifies the models asked for, or reads them, and simulates every record with each. `progress` is told the share done and the model
    /// that comes now.
    ///
    /// # Errors
    /// [`AgainstError`].
    pub fn compare(
        wanted: &[String],
        file: &ModelFile,
        campaign: &Campaign,
        progress: &dyn Fn(f64, &str),
    ) -> Result<Rivals, AgainstError> {
        let names = named(wanted)?;
        let identification = &file.identification;
        let mut used: Vec<&Record> = campaign.records.iter().filter(|r| identification.used(r)).collect();
        let mut rivals = Rivals::default();
        if used.is_empty() && names.iter().any(|name| is_model(name)) {
            if let Some(first) = identification.tests.first() {
                return Err(AgainstError::OtherTests { count: identification.tests.len(), first: first.clone() });
            }
            used = campaign.records.iter().collect();
            rivals.fitted_to_all = true;
        }
        let tests = observation::of_records(&used);
        let motions: Vec<observation::Motion> =
            campaign.records.par_iter().map(observation::Motion::from_record).collect();
        for (k, name) in names.iter().enumerate() {
            progress(k as f64 / names.len() as f64, name);
            let literature = if is_model(name) { Literature::fit(name, &tests)? } else { file::read(Path::new(name))? };
            let forces = motions.par_iter().map(|motion| literature.forces(motion)).collect();
            rivals.all.push(Rival { literature, forces });
        }
        Ok(rivals)
    }

    /// Puts their errors into a validation of the same records, behind those of the model itself.
    pub fn put_into(&self, validation: &mut Validation, compared: &[Compared<'_>]) {
        let own = validation.as_against();
        validation.against.push(own);
        for Rival { literature, forces } in &self.all {
            let against = of_forces(literature.name(), compared, forces);
            validation.against.push(Against { numbers: Some(literature.clone()), ..against });
        }
    }
}

/// The errors of a model of the literature whose forces are at hand.
pub fn of_forces(name: &str, compared: &[Compared<'_>], forces: &[Vec<f64>]) -> Against {
    let meaning = MODELS.iter().find(|m| m.0 == name).map_or("", |m| m.1);
    Against::measure(name, meaning, compared, forces)
}
