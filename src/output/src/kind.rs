//! Kinds of files. An output may only replace an older file of its own kind.

use std::fmt;
use std::io::Read as _;

/// Kind of a file, detected from its content.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Kind {
    /// An empty file, for example from `touch` or `mktemp`.
    Empty,
    /// A model file of dashpot.
    Model,
    /// A profile with known facts about records, in the folder of the records.
    Profile,
    /// A model of the literature. It is not a model file and serves only for comparison.
    Comparison,
    /// Results of a command of dashpot as JSON.
    Figures,
    /// A report of dashpot.
    Report,
    /// A picture.
    Picture,
    /// A damper property file of dashpot, as text or XML.
    Property,
    /// A file with which CarMaker uses an FMU of dashpot as its damper.
    PlugInfo,
    /// A dataset or commands for Adams with dashpot's routines.
    Adams,
    /// A table with this header line.
    Table(String),
    /// A workbook with the tables of a report.
    Workbook,
    /// An FMU.
    Fmu,
    /// A program or library; the first four bytes indicate its format.
    Program([u8; 4]),
    /// Another text, identified by its first line.
    Text(String),
    /// Any other file.
    Other(&'static str),
}

/// Sets of top-level keys in the JSON of dashpot's commands. A JSON file of another program contains none of these
/// sets.
const OWN_KEYS: [&[&str]; 11] = [
    &["quantities", "contradictions"],
    &["effects", "settings"],
    &["parameters"],
    &["misfit"],
    &["overall"],
    &["findings"],
    &["suspects"],
    &["left_aside"],
    &["explicit_step_s"],
    &["corners"],
    &["rms_percent_1ms"],
];
/// Key of a model of the literature in its file, and under `numbers` in the JSON of `fit --model`.
const LITERATURE: &str = "literature_model";
/// Author in every workbook of dashpot. A program that changes a workbook records its own user, so an edited workbook
/// does not count as an output of dashpot.
pub const AUTHOR: &str = "dashpot";
/// Size of the largest list of properties of a workbook that is read, bytes. The list of dashpot is less than one
/// kilobyte.
const PROPERTIES: u64 = 1 << 16;
/// Generator tag in the HTML head of every report of dashpot.
pub const GENERATOR: &str = "<meta name=\"generator\" content=\"dashpot\">";

/// Beginning of the first comment in every property file of dashpot. In XML, the first line does not identify dashpot,
/// because files of other programs begin with the same declaration.
pub const WRITTEN: &str = "Written by dashpot ";
/// Text in every Adams dataset with dashpot's routines. The first line of a dataset, its title, does not identify
/// dashpot, because most Adams models have the same title.
const ROUTINES: &str = "dashpot_adams::";

/// Extensions that imply a kind. Another kind with this extension would be misinterpreted, for example a model in
/// `out.csv` as a record.
const PROMISES: [(&str, &[Kind]); 7] = [
    ("toml", &[Kind::Model, Kind::Profile, Kind::Comparison]),
    ("json", &[Kind::Figures]),
    ("html", &[Kind::Report]),
    ("svg", &[Kind::Picture]),
    ("xlsx", &[Kind::Workbook]),
    ("fmu", &[Kind::Fmu]),
    ("csv", &[]),
];
/// Kinds that have a customary extension, so that the extension of another kind is rejected.
const NAMED: [Kind; 7] =
    [Kind::Model, Kind::Profile, Kind::Comparison, Kind::Figures, Kind::Report, Kind::Workbook, Kind::Fmu];

impl Kind {
    /// Returns the extension of a path if the extension implies another kind.
    pub fn contradicting_extension(&self, path: &std::path::Path) -> Option<&'static str> {
        let extension = path.extension()?.to_str()?;
        let (known, promised) = PROMISES.iter().find(|(known, _)| known.eq_ignore_ascii_case(extension))?;
        (NAMED.contains(self) && !promised.contains(self)).then_some(known)
    }

    /// Detects the kind from the content of a file.
    pub fn detect(bytes: &[u8]) -> Kind {
        if bytes.iter().all(u8::is_ascii_whitespace) {
            return Kind::Empty;
        }
        let has = |wanted: &str| bytes.windows(wanted.len()).any(|w| w == wanted.as_bytes());
        if bytes.starts_with(b"PK") {
            return match () {
                () if has("modelDescription.xml") => Kind::Fmu,
                () if is_own_workbook(bytes) => Kind::Workbook,
                () => Kind::Other("a workbook or an archive"),
            };
        }
        match bytes {
            [0x7f, b'E', b'L', b'F', ..] | [b'M', b'Z', ..] | [0xcf, 0xfa, 0xed, 0xfe, ..] => {
                let mut magic = [0; 4];
                magic.copy_from_slice(&bytes[..4]);
                // For Windows programs, only the bytes `MZ` are significant.
                if magic.starts_with(b"MZ") {
                    magic = *b"MZ  ";
                }
                return Kind::Program(magic);
            }
            _ => {}
        }
        let Ok(text) = std::str::from_utf8(bytes) else { return Kind::Other("no text") };
        if text.contains('\0') {
            return Kind::Other("no text");
        }
        let text = text.trim_start_matches('\u{feff}').trim_start();
        let begins = |wanted: &str| text.get(..wanted.len()).is_some_and(|t| t.eq_ignore_ascii_case(wanted));
        if begins("<!doctype html") || begins("<html") {
            return if text.contains(GENERATOR) { Kind::Report } else { Kind::Other("a web page of other origin") };
        }
        if begins("<svg") || (begins("<?xml") && text.contains("<svg")) {
            return Kind::Picture;
        }
        let commented = |mark: &str| text.contains(&format!("{mark} {WRITTEN}"));
        if begins("<?xml") {
            return if commented("<!--") { Kind::Property } else { Kind::Other("XML of other origin") };
        }
        if text.starts_with(&format!("$ {WRITTEN}")) {
            return Kind::Property;
        }
        // All info files of CarMaker begin with the same line, so the comment identifies those of dashpot.
        if begins("#INFOFILE") {
            return if commented("#") { Kind::PlugInfo } else { Kind::Other("a file of CarMaker") };
        }
        if text.contains(ROUTINES) {
            return Kind::Adams;
        }
        if begins("{") || begins("[") {
            if let Ok(value) = serde_json::from_str::<serde_json::Value>(text) {
                let first = value.as_array().and_then(|rows| rows.first()).unwrap_or(&value);
                let own = first
                    .as_object()
                    .is_some_and(|o| OWN_KEYS.iter().any(|keys| keys.iter().all(|key| o.contains_key(*key))));
                return if own || first["numbers"].get(LITERATURE).is_some() {
                    Kind::Figures
                } else {
                    Kind::Other("JSON of other origin")
                };
            }
        }
        let says = |key: &str| text.lines().any(|line| line.split('=').next().is_some_and(|k| k.trim() == key));
        if says("format") && text.contains(dashpot_records::profile::FORMAT) {
            return Kind::Profile;
        }
        if says(LITERATURE) {
            return Kind::Comparison;
        }
        if says("format") && says("elements") {
            return Kind::Model;
        }
        let first = text.lines().next().unwrap_or_default().trim_end();
        if first.contains(',') && first.chars().any(char::is_alphabetic) {
            return Kind::Table(first.to_owned());
        }
        Kind::Text(first.to_owned())
    }
}

/// Returns whether a workbook is an output of dashpot that no other program has saved. Its author and last editor
/// indicate this.
fn is_own_workbook(bytes: &[u8]) -> bool {
    let properties = || -> Option<String> {
        let mut archive = zip::ZipArchive::new(std::io::Cursor::new(bytes)).ok()?;
        let mut text = String::new();
        archive.by_name("docProps/core.xml").ok()?.take(PROPERTIES).read_to_string(&mut text).ok()?;
        Some(text)
    };
    let named = |text: &str, tag: &str| text.contains(&format!("<{tag}>{AUTHOR}</{tag}>"));
    properties().is_some_and(|text| named(&text, "dc:creator") && named(&text, "cp:lastModifiedBy"))
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Kind::Empty => f.write_str("nothing"),
            Kind::Model => f.write_str("a model file"),
            Kind::Comparison => f.write_str("a model of the literature, to be compared with alone"),
            Kind::Profile => f.write_str("the profile of a campaign"),
            Kind::Figures => f.write_str("figures as JSON"),
            Kind::Report => f.write_str("a report"),
            Kind::Picture => f.write_str("a picture"),
            Kind::Property => f.write_str("a damper property file of dashpot"),
            Kind::PlugInfo => f.write_str("a description of dashpot's FMU for CarMaker"),
            Kind::Adams => f.write_str("a file for Adams with dashpot's routines"),
            Kind::Table(header) => write!(f, "a table that begins with {:?}", short(header)),
            Kind::Workbook => f.write_str("a workbook of dashpot"),
            Kind::Fmu => f.write_str("an FMU"),
            Kind::Program(_) => f.write_str("a program or library"),
            Kind::Text(first) => write!(f, "a text that begins with {:?}", short(first)),
            Kind::Other(what) => f.write_str(what),
        }
    }
}

fn short(text: &str) -> String {
    text.chars().take(50).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_told_apart_by_their_content() {
        let of = |text: &str| Kind::detect(text.as_bytes());
        assert_eq!(of(" \n"), Kind::Empty);
        assert_eq!(of("# mine\nformat = 1\nelements = []\n"), Kind::Model);
        assert_eq!(of("format = \"dashpot campaign profile 1\"\n"), Kind::Profile);
        assert_eq!(of("{\"parameters\": []}"), Kind::Figures);
        assert_eq!(of("[{\"rms_percent_1ms\": 1}]"), Kind::Figures);
        assert_eq!(of("{\"quantities\": [], \"contradictions\": []}"), Kind::Figures);
        assert_eq!(of("{\"effects\": [], \"settings\": []}"), Kind::Figures);
        assert_eq!(of("{\"effects\": [\"reverb\"]}"), Kind::Other("JSON of other origin"));
        assert_eq!(of("{\"tests\": [], \"numbers\": {\"literature_model\": \"dahl\"}}"), Kind::Figures);
        assert_eq!(of("# mine\nliterature_model = \"dahl\"\nfriction_n = 1.0\n"), Kind::Comparison);
        assert!(matches!(of("{\"name\": \"x\"}"), Kind::Other(_)));
        assert!(matches!(of("{\"numbers\": [1, 2]}"), Kind::Other(_)));
        assert!(matches!(of("<!DOCTYPE html><title>x</title>"), Kind::Other(_)));
        assert_eq!(of(&format!("<!DOCTYPE html>\n{GENERATOR}")), Kind::Report);
        assert_eq!(of("time_s,force_N\n0,1\n"), Kind::Table("time_s,force_N".into()));
        assert_ne!(of("time_s,force_N\n0,1\n"), of("t,x_mm,F\n0,1,2\n"));
        assert!(matches!(Kind::detect(b"PK\x03\x04xl/workbook.xml"), Kind::Other(_)));
        let workbook = |edited_by: &str| {
            let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
            archive.start_file("docProps/core.xml", zip::write::SimpleFileOptions::default()).unwrap();
            let text = format!("<dc:creator>dashpot</dc:creator><cp:lastModifiedBy>{edited_by}</cp:lastModifiedBy>");
            std::io::Write::write_all(&mut archive, text.as_bytes()).unwrap();
            archive.finish().unwrap().into_inner()
        };
        assert_eq!(Kind::detect(&workbook("dashpot")), Kind::Workbook);
        assert!(matches!(Kind::detect(&workbook("Anna")), Kind::Other(_)));
        assert_eq!(Kind::detect(b"PK\x03\x04modelDescription.xml"), Kind::Fmu);
        assert_ne!(Kind::detect(b"\x7fELF12"), Kind::detect(b"MZ\x90\x00"));
        // A newer property file of dashpot replaces an older one, but never a file of another program. Such a file may have the same first
        // line.
        assert_eq!(of("$ Written by dashpot 0.1.0 from a.toml (check sum 1)\n[MDI_HEADER]\n"), Kind::Property);
        assert_eq!(
            of("<?xml version=\"1.0\"?>\n<afc>\n  <!-- Written by dashpot 0.1.0 from b.toml -->\n</afc>\n"),
            Kind::Property
        );
        assert!(matches!(of("<?xml version=\"1.0\"?>\n<afc>\n</afc>\n"), Kind::Other(_)));
        assert_eq!(of("#INFOFILE1.1\nFMU.Name = a\n# Written by dashpot 0.1.0 from a.toml\n"), Kind::PlugInfo);
        assert!(matches!(of("#INFOFILE1.1\nFMU.Name = a\n"), Kind::Other(_)));
        // Most Adams models have the same title.
        let model = "Adams View model name: MODEL_1\n!\nEND\n";
        assert!(matches!(of(model), Kind::Text(_)));
        assert_eq!(of(&model.replace("END", ", ROUTINE = dashpot_adams::Dashpot_sfosub\nEND")), Kind::Adams);
        assert!(matches!(Kind::detect(b"\xff\xfe\x00\x01"), Kind::Other(_)));
    }
}
