//! Names, remarks and files for exports, shared by the command and the graphical user interface.

use crate::adams::akima::Difference;
use crate::adams::folder::{self, SineTest};
use crate::adams::property::{self, Form, Properties};
use crate::plain_curve::{PlainCurve, Source};
use crate::runtimes;
use anyhow::{Context as _, bail};
use dashpot_core::{Model, Params};
use dashpot_core::{element, number};
use dashpot_identification::model_file::ModelFile;
use std::path::{Path, PathBuf};

/// Returns the name of an FMU from the name of its model file.
pub fn fmu_name(model_file: &Path, four_corners: bool) -> String {
    let stem = model_file.file_stem().map_or_else(|| "damper".into(), |stem| stem.to_string_lossy().into_owned());
    if four_corners { format!("dashpot vehicle, four dampers ({stem})") } else { format!("dashpot {stem}") }
}

/// Returns the path of the static library from which an FMU can be compiled.
///
/// Cargo puts the library next to the program. Packages have it in `lib` next to the program's folder. If neither folder contains the
/// library, the path next to the program is returned, although no such file exists.
///
/// # Errors
/// The path of the program is unknown.
pub fn static_library() -> anyhow::Result<PathBuf> {
    Ok(static_library_of(&std::env::current_exe()?))
}

fn static_library_of(program: &Path) -> PathBuf {
    let beside = program.with_file_name("libdashpot.a");
    let of_package = program.parent().and_then(Path::parent).map(|folder| folder.join("lib").join("libdashpot.a"));
    of_package.filter(|library| library.is_file() && !beside.is_file()).unwrap_or(beside)
}

/// Name of the user subroutine that every model of `export adams` and `export adm` calls.
const ROUTINE: &[u8] = b"Dashpot_sfosub";

/// Returns the file name of a library for Adams in a run folder. The name depends on the platform of the library.
///
/// # Errors
/// The library does not contain dashpot's user subroutine.
pub fn adams_library_name(content: &[u8]) -> anyhow::Result<&'static str> {
    if !content.windows(ROUTINE.len()).any(|part| part == ROUTINE) {
        bail!(
            "this is no dashpot library for Adams: the name of the routine, {}, does not stand in it. It is made by `make -C adams-usersub`",
            String::from_utf8_lossy(ROUTINE)
        );
    }
    // The name depends on the library, not on the computer, because a user on Linux may export for Windows.
    Ok(if content.starts_with(b"MZ") { "dashpot_adams.dll" } else { "dashpot_adams.so" })
}

/// Contents of a property file before it is written.
pub struct PropertyFile {
    /// Text of the file.
    pub text: String,
    /// Number of points of the curve in the file.
    pub points: usize,
    /// Elements of the model that the file cannot represent.
    pub left_out: Vec<&'static str>,
    /// Remarks on the origin of the curve, omitted elements, Adams's interpolation, and chatter in other programs.
    pub remarks: Vec<String>,
}

/// Makes the property file of a model. The extension of `path`, the file to write, selects the format.
///
/// With `own`, the property file contains the model's own curve even if the model file has a plain FV curve.
///
/// `named` is the name of the model file. Property files require ASCII, so a name with other characters is omitted. `text` is the text of
/// the model file. `chatters` returns messages if a damper that consists of the FV curve alone chatters. A host that reads a property file
/// has no other damping of the model.
///
/// # Errors
/// The model has no curve, or its curve is invalid.
pub fn property_file(
    file: &ModelFile,
    own: bool,
    path: &Path,
    (named, text): (&str, &[u8]),
    chatters: &dyn Fn(&Params) -> Vec<String>,
) -> anyhow::Result<PropertyFile> {
    let Some(plain) = PlainCurve::from_model_file(file, own)? else {
        bail!("the element fv_curve is off, so there is no curve to export");
    };
    let xml = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("xml"));
    let mut left_out = plain.omitted_elements.clone();
    left_out.retain(|name| !(xml && *name == element!("gas_preload").name()));
    let mut remarks = Vec::new();
    if plain.source == Source::Fitted || !left_out.is_empty() {
        remarks.push(plain.note().to_owned());
    }
    if !left_out.is_empty() {
        remarks.push(format!("Left out, for a property file has no place for it: {}.", left_out.join(", ")));
    }
    let (curve, own_points, left) = plain.for_akima()?;
    remarks.push(followed(own_points, curve.velocities.len() - own_points, &left));
    let mut alone = plain.params;
    alone.enable(element!("gas_preload"), false);
    // Adams Car evaluates the force implicitly, so it does not chatter. The remarks are for other programs that read property files and
    // hold the force over a step.
    let held = "In a program that takes the force once a fixed step and holds it:";
    remarks.extend(chatters(&alone).into_iter().map(|chatter| format!("{held} {chatter}")));
    let named = if named.is_ascii() && !named.is_empty() { named } else { "a model file" };
    let mut notes = vec![format!(
        "Written by dashpot {} from {named} (check sum {:08x}). Rebound and tension are positive.",
        env!("CARGO_PKG_VERSION"),
        crc32fast::hash(text)
    )];
    notes.extend(remarks.iter().cloned());
    let has_gas = xml && plain.params.is_on(element!("gas_preload"));
    let gas_force = if has_gas { plain.params.number(number!("gas_force")) } else { 0.0 };
    let points = curve.velocities.len();
    let properties = Properties { curve, linear: false, gas_force, notes };
    let text = property::write(&properties, if xml { Form::Xml } else { Form::TeimOrbit });
    Ok(PropertyFile { text, points, left_out, remarks })
}

/// Describes how Adams interpolates the points of a property file.
fn followed(own: usize, added: usize, left: &Difference) -> String {
    let reads = "Adams Car joins the points by Akima's method (AKISPL), the model by its own.";
    let now = format!("The two curves differ by {}.", left.describe());
    match added {
        0 => format!("{reads} {now}"),
        _ if left.is_small() => format!("{reads} {added} points were added to the {own} of the model for that. {now}"),
        _ => format!(
            "{reads} {added} points were added to the {own} of the model for that, and more than {} a file is not given: the curve is too steep \
             somewhere. {now}",
            dashpot_core::curve::MAX_POINTS
        ),
    }
}

/// Largest accepted size of a library for Adams, bytes. A library has about a megabyte.
const LARGEST_LIBRARY: u64 = 256 << 20;
/// Name of the library for Adams on this platform.
const ADAMS: &str = if cfg!(windows) { "dashpot_adams.dll" } else { "dashpot_adams.so" };

/// Returns names and contents of the libraries for Adams: the given library, or else the embedded ones, or else the one next to the
/// program. The list is empty if there is none.
///
/// # Errors
/// A library cannot be read, or the given library does not contain dashpot's user subroutine.
pub fn adams_libraries(named: Option<&Path>) -> anyhow::Result<Vec<(String, Vec<u8>)>> {
    let read = |path: &Path| {
        dashpot_records::read_regular(path, LARGEST_LIBRARY).with_context(|| format!("cannot read {}", path.display()))
    };
    if let Some(path) = named {
        let content = read(path)?;
        let name = adams_library_name(&content).with_context(|| path.display().to_string())?;
        return Ok(vec![(name.into(), content)]);
    }
    let held: Vec<(String, Vec<u8>)> = [("linux64", "dashpot_adams.so"), ("win64", "dashpot_adams.dll")]
        .into_iter()
        .filter_map(|(platform, name)| Some((name.to_owned(), runtimes::compiled(platform, name)?.to_vec())))
        .collect();
    if !held.is_empty() {
        return Ok(held);
    }
    let beside = std::env::current_exe().ok().map(|program| program.with_file_name(ADAMS)).filter(|p| p.is_file());
    Ok(beside.map(|path| read(&path)).transpose()?.map(|content| (ADAMS.to_owned(), content)).into_iter().collect())
}

/// Describes how to obtain a library for Adams.
pub fn no_adams_library() -> String {
    format!(
        "This program holds no Adams library and there is no {ADAMS} beside it: {}; or `make -C adams-usersub` and --library FILE.",
        runtimes::HOW
    )
}

/// Assumed length of a damper at zero displacement, mm, if the user gives none. It is typical of a passenger car. With a wrong length, the
/// damper in the vehicle starts far from the zero displacement of its test records.
pub const ASSUMED_LENGTH: f64 = 400.0;

/// Contents of a run folder for Adams before it is written.
pub struct RunFolder {
    /// Names and contents of the files.
    pub files: Vec<(String, Vec<u8>)>,
    /// Reason why native.adm is missing.
    pub no_native: Option<String>,
    has_library: bool,
    is_length_assumed: bool,
    replaced: Vec<String>,
    chatters: Vec<String>,
}

impl RunFolder {
    /// Returns remarks about the run folder, which the caller writes to `folder`.
    pub fn notes(&self, folder: &Path) -> Vec<String> {
        let mut notes = Vec::new();
        if self.is_length_assumed {
            notes.push(format!(
                "no length at zero displacement was given, and {ASSUMED_LENGTH} mm is assumed: give the distance of your damper's markers there (--length, or as README.txt says)"
            ));
        }
        if let Some(reason) = &self.no_native {
            notes.push(format!("no native.adm, because {reason}"));
            let old = folder.join("native.adm");
            if old.exists() {
                notes.push(format!("{} is of an earlier export and not of this model: delete it", old.display()));
            }
        }
        if !self.has_library {
            notes.push(format!("the library is not in the folder. {}", no_adams_library()));
        }
        notes.extend_from_slice(&self.replaced);
        notes
    }

    /// Returns remarks on chatter for users who couple Adams to a program with fixed steps. The remarks do not concern Adams itself,
    /// because it solves for the force with its derivatives.
    pub fn if_coupled(&self) -> impl Iterator<Item = String> {
        let coupled = "if Adams is coupled to a program of fixed steps (a run of Adams alone is not concerned)";
        self.chatters.iter().map(move |note| format!("{coupled}: {note}"))
    }
}

/// Input for a run folder.
pub struct RunFolderInput<'a> {
    /// Parameters of the damper.
    pub params: &'a Params,
    /// Model prepared from the parameters.
    pub model: &'a Model,
    /// Text of the model file.
    pub text: &'a [u8],
    /// Distance between the damper's markers at zero displacement, mm. `None` selects [`ASSUMED_LENGTH`] and adds a note.
    pub length: Option<f64>,
    /// Tests that the rig model of the folder simulates.
    pub tests: &'a [SineTest],
    /// Names and contents of the libraries for Adams.
    pub libraries: Vec<(String, Vec<u8>)>,
    /// Sentences about elements that were replaced in the model. They stand at the beginning of README.txt.
    pub replaced: Vec<String>,
    /// Sentences about chatter of the model in a program with fixed steps. They stand at the end of README.txt, because Adams itself
    /// chooses its steps.
    pub chatters: Vec<String>,
}

/// Makes the run folder of a model.
pub fn run_folder(input: RunFolderInput<'_>) -> RunFolder {
    let RunFolderInput { params, model, text, length, tests, libraries, replaced, chatters } = input;
    let (texts, no_native) = folder::files(params, model, "damper.toml", length.unwrap_or(ASSUMED_LENGTH), tests);
    let has_library = !libraries.is_empty();
    let missing =
        if has_library { String::new() } else { format!("THE LIBRARY IS NOT HERE. {}\n\n", no_adams_library()) };
    let mut files = vec![("damper.toml".to_owned(), text.to_vec())];
    for file in texts {
        let is_first = file.name == "README.txt";
        let text = if is_first {
            folder::above(&replaced, &(missing.clone() + &folder::below(&file.text, &chatters)))
        } else {
            file.text
        };
        files.push((file.name.to_owned(), text.into_bytes()));
    }
    files.extend(libraries);
    RunFolder { files, no_native, has_library, is_length_assumed: length.is_none(), replaced, chatters }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_that_was_not_given_is_said_to_be_assumed() {
        let params = Params::new();
        let model = Model::new(&params).unwrap();
        let folder = |length| {
            run_folder(RunFolderInput {
                params: &params,
                model: &model,
                text: b"",
                length,
                tests: &[],
                libraries: Vec::new(),
                replaced: Vec::new(),
                chatters: Vec::new(),
            })
        };
        let is_assumed =
            |length| folder(length).notes(Path::new("run")).iter().any(|note| note.contains("400 mm is assumed"));
        assert_eq!([is_assumed(None), is_assumed(Some(412.5))], [true, false]);
    }

    #[test]
    fn the_static_library_of_a_package_lies_in_its_lib() {
        let folder = tempfile::tempdir().unwrap();
        let program = folder.path().join("bin").join("dashpot");
        for place in ["bin", "lib"] {
            std::fs::create_dir(folder.path().join(place)).unwrap();
        }
        assert!(!static_library_of(&program).is_file());
        for place in ["lib", "bin"] {
            let library = folder.path().join(place).join("libdashpot.a");
            std::fs::write(&library, "").unwrap();
            assert_eq!(static_library_of(&program), library);
        }
    }

    #[test]
    fn a_library_for_adams_holds_the_routine() {
        assert_eq!(adams_library_name(b"MZ..Dashpot_sfosub..").unwrap(), "dashpot_adams.dll");
        assert_eq!(adams_library_name(b"\x7fELF..Dashpot_sfosub").unwrap(), "dashpot_adams.so");
        assert!(adams_library_name(b"format = 1").unwrap_err().to_string().contains("Dashpot_sfosub"));
    }
}
