//! Comparison of a model with models of the literature.
//!
//! The requested models are identified from the tests that the fit of the given model used. All models are then compared on the same
//! records.

use dashpot_identification::literature::file::{self, FileError};
use dashpot_identification::literature::{Literature, LiteratureError, MODELS, observation};
use dashpot_identification::model_file::ModelFile;
use dashpot_identification::validation::{Against, Compared, Validation};
use dashpot_records::{Campaign, Record};
use rayon::prelude::*;
use std::path::Path;

/// Note for a comparison in which [`Rivals::fitted_to_all`] is true.
pub const FITTED_TO_ALL: &str = "the model file names no tests; the models compared with are fitted to all tests given";

/// Reason why a comparison with models of the literature failed.
#[derive(Debug, thiserror::Error)]
pub enum AgainstError {
    /// The model is unknown, or its fit failed.
    #[error(transparent)]
    Literature(#[from] LiteratureError),
    /// A file contains no model of the literature.
    #[error(transparent)]
    File(#[from] FileError),
    /// The data contains none of the tests that the fit of the model used.
    #[error(
        "--against identifies its models from the tests that the model was fitted to, and none of those {count} is in the data given, such as \
         {first:?}: give them beside the others"
    )]
    OtherTests {
        /// Number of tests of the fit.
        count: usize,
        /// Name of one of these tests.
        first: String,
    },
}

/// Model of the literature in a comparison, with its forces on every record.
#[derive(Debug, Clone)]
pub struct Rival {
    /// The model with its parameters.
    pub literature: Literature,
    /// Forces of the model at the samples of each record, N.
    pub forces: Vec<Vec<f64>>,
}

/// Models of the literature for a comparison.
#[derive(Debug, Clone, Default)]
pub struct Rivals {
    /// Models in the requested order.
    pub all: Vec<Rival>,
    /// Whether the models were fitted to all given tests, because the model file contains no test names.
    pub fitted_to_all: bool,
}

/// Returns each requested model once. Requests are names, `all`, or files that `dashpot fit --model` wrote. This function checks the
/// requests before the fits, which take minutes.
///
/// # Errors
/// Returns an error if a request is neither the name of a model nor an existing file.
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
    /// Identifies or reads the requested models, and simulates every record with each of them. `progress` receives the completed fraction
    /// and the name of the next model.
    ///
    /// # Errors
    /// Returns an [`AgainstError`] if the comparison fails.
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
        let motions: Vec<observation::SampledMotion> =
            campaign.records.par_iter().map(observation::SampledMotion::from_record).collect();
        for (k, name) in names.iter().enumerate() {
            progress(k as f64 / names.len() as f64, name);
            let literature = if is_model(name) { Literature::fit(name, &tests)? } else { file::read(Path::new(name))? };
            let forces = motions.par_iter().map(|motion| literature.forces(motion)).collect();
            rivals.all.push(Rival { literature, forces });
        }
        Ok(rivals)
    }

    /// Appends the errors of the validated model and of the models of the literature to `validation`. `compared` contains the records of
    /// this validation.
    pub fn put_into(&self, validation: &mut Validation, compared: &[Compared<'_>]) {
        let own = validation.as_against();
        validation.against.push(own);
        for Rival { literature, forces } in &self.all {
            let against = of_forces(literature.name(), compared, forces);
            validation.against.push(Against { numbers: Some(literature.clone()), ..against });
        }
    }
}

/// Computes the errors of a model of the literature on the compared records from its forces, N.
pub fn of_forces(name: &str, compared: &[Compared<'_>], forces: &[Vec<f64>]) -> Against {
    let meaning = MODELS.iter().find(|m| m.0 == name).map_or("", |m| m.1);
    Against::measure(name, meaning, compared, forces)
}
