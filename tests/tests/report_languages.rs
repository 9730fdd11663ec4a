//! The report of a real diagnosis in every language: what stays English in it is listed here, and nothing else does.

use dashpot_core::{Params, parameter};
use dashpot_core::{element, number};
use dashpot_diagnosis::{Diagnosis, EFFECTS, Options, choose_held_out, diagnose};
use dashpot_records::Record;
use dashpot_report::diagnosis::DiagnosisReport;
use dashpot_report::words::Language;
use dashpot_report::{Made, MadeFrom, parameters};
use dashpot_simulation::whole_records::OfDiagnosis;
use dashpot_tests::kernel_campaign::{Sine, base, campaign};
use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::sync::OnceLock;

/// What the reader of the records noticed; it comes in English.
const READING: &str = "The files count rebound positive, as given.";
/// Units, symbols, file formats and the words of commands, in which no language differs.
const SYMBOLS: &str = "mm N Hz ms kg m s J K W N·s/m N/mm mm/s m/s dv dx F v n c h x cm dashpot validate diagnose reference CSV FV SHA SHA-256 \
                       sha256sum rms damper.toml rig/front rig/front/a.csv Dahl F_s F_v tanh";
/// Texts that a language writes as English does.
const SAME: &[(&str, &[&str])] =
    &[("de", &["Name", "Parameter", "Amplitude, mm"]), ("fr", &["compression", "amplitude, mm", "direction"])];

fn tests() -> Vec<Sine> {
    let mut tests = Vec::new();
    for amplitude in [0.05, 0.01, 0.002] {
        for peak in [0.052, 0.26, 1.05] {
            let frequency = peak / (TAU * amplitude);
            if frequency <= 25.1 {
                tests.push(Sine::new(amplitude, frequency));
            }
        }
    }
    tests.push(Sine { mean: 0.02, ..Sine::new(0.02, 1.0) });
    tests.push(Sine { mean: -0.02, ..Sine::new(0.02, 1.0) });
    tests.push(Sine::new(0.01, 0.008));
    tests
}

/// A diagnosis with the records that it is of.
struct Case {
    records: Vec<Record>,
    found: Diagnosis,
}

/// One that names an effect, one that compares with a reference, one that may add nothing.
fn cases() -> &'static [Case] {
    static CASES: OnceLock<Vec<Case>> = OnceLock::new();
    CASES.get_or_init(|| {
        let mut rubbing = base();
        rubbing.enable(element!("presliding_friction"), true);
        let mut firmer = base();
        firmer.set(number!("coulomb_force"), 60.0).unwrap();
        let good = campaign(&base(), &tests()[1..], 3, 0.01);
        let only = |names: &[&str]| Some(names.iter().map(ToString::to_string).collect());
        let of = |truth: &Params, max_effects: usize, reference: Vec<Record>| {
            let records = campaign(truth, &tests(), 5, 0.01);
            let refs: Vec<&Record> = records.iter().collect();
            let candidates = only(&["presliding_friction", "aeration", "channel_delay", "oil_compressibility"]);
            let options = Options { max_effects, candidates, reference };
            let found = diagnose(&refs, &choose_held_out(&refs, 0), &base(), &options, &|_, _| ()).unwrap();
            Case { records, found }
        };
        vec![of(&rubbing, 2, Vec::new()), of(&firmer, 1, good), of(&rubbing, 0, Vec::new())]
    })
}

fn page(case: &Case, language: Language) -> String {
    let words = language.words();
    let records: Vec<&Record> = case.records.iter().collect();
    let file = MadeFrom { name: "rig/front/a.csv".into(), bytes: 12, sha256: "00".into() };
    DiagnosisReport {
        model_file: "damper.toml".into(),
        data: "rig/front".into(),
        found: &case.found,
        records: &records,
        reading: vec![READING.to_owned()],
        over_whole_records: OfDiagnosis::of(&base(), &case.found.base, &case.found.improved, &records).unwrap(),
        parameters: parameters::of_diagnosis(&case.found, words),
        made: Made { version: "9.9".into(), command: "dashpot diagnose".into(), files: vec![file], ..Made::default() },
        words,
    }
    .render()
}

/// Every text that a reader sees, figures included.
fn visible(page: &str) -> Vec<String> {
    let without = |page: &str, tag: &str| -> String {
        let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
        page.split(&open).map(|part| part.rsplit(&close).next().unwrap_or("")).collect()
    };
    let page = without(&without(page, "style"), "script");
    let texts = page.split('<').filter_map(|part| part.split_once('>')).map(|(_, text)| text);
    let plain = |text: &str| {
        let signs = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&amp;", "&")];
        signs.iter().fold(text.trim().to_owned(), |text, (from, to)| text.replace(from, to))
    };
    texts.map(plain).filter(|text| text.chars().any(char::is_alphabetic)).collect()
}

/// Words of a text in Latin letters, names and units too.
fn latin(text: &str) -> impl Iterator<Item = &str> {
    let parts = text.split(|c: char| !(c.is_ascii_alphanumeric() || "_-./·".contains(c)));
    parts
        .map(|word| word.trim_matches(|c: char| "-./·".contains(c)))
        .filter(|w| w.chars().any(|c| c.is_ascii_alphabetic()))
}

/// Whether a word is a name in a file, a unit or a symbol.
fn is_name(word: &str) -> bool {
    let is_parameter = || parameter::table().any(|row| row.parameter.name == word);
    // Numbers of the heating and the one effect that no rig can tell have no row of their own.
    let of_measurement = ["cooling_rate", "heat_capacity", "cylinder_expansion"].contains(&word);
    // What looks like something without a name is called by what it is made of.
    let is_tried = || cases().iter().flat_map(|c| c.found.rounds.iter().flatten()).any(|tried| tried.effect == word);
    let is_test = cases().iter().flat_map(|c| &c.records).any(|record| record.name == word);
    let in_symbols = |word: &str| SYMBOLS.split_whitespace().any(|symbol| symbol == word);
    let is_figure = |part: &str| !part.chars().any(|c| c.is_ascii_alphabetic());
    let is_symbol = || in_symbols(word) || word.split(['/', '·']).all(|part| in_symbols(part) || is_figure(part));
    // Symbols of the model's equations (k_p, v_0, x), which the meaning of a parameter names in every language: no word is that short.
    let is_short = word.len() == 1 || word.as_bytes().get(1) == Some(&b'_');
    let is_of_an_equation =
        || is_short && parameter::table().any(|row| latin(row.parameter.meaning).any(|w| w == word));
    EFFECTS.contains(&word)
        || is_of_an_equation()
        || of_measurement
        || is_test
        || is_symbol()
        || is_parameter()
        || is_tried()
}

/// What comes in English from elsewhere: meanings of parameters, and what reading noticed.
fn stays(text: &str) -> bool {
    text == READING || parameter::table().any(|row| row.parameter.meaning == text)
}

#[test]
fn every_text_of_a_chinese_report_is_chinese() {
    let mut foreign = BTreeSet::new();
    for case in cases() {
        let texts = visible(&page(case, Language::Chinese));
        foreign.extend(texts.into_iter().filter(|text| !stays(text) && !latin(text).all(is_name)));
    }
    assert!(foreign.is_empty(), "{foreign:#?}");
}

#[test]
fn german_and_french_reports_have_no_text_of_the_english_one() {
    let mut same = BTreeSet::new();
    for case in cases() {
        let english: BTreeSet<String> = visible(&page(case, Language::English)).into_iter().collect();
        for (code, known) in SAME {
            let texts = visible(&page(case, code.parse().unwrap()));
            let is_same = |text: &String| english.contains(text) && !stays(text) && !known.contains(&text.as_str());
            same.extend(texts.into_iter().filter(|t| is_same(t) && !latin(t).all(is_name)).map(|t| (*code, t)));
        }
    }
    assert!(same.is_empty(), "{same:#?}");
}

#[test]
fn the_cases_have_every_section() {
    let pages: String = cases().iter().map(|case| page(case, Language::English)).collect();
    for text in [
        "What is missing",
        "Tests worth running next",
        "others than on the reference",
        "Numbers of the model that moved",
    ] {
        assert!(
            pages.contains(text),
            "{text}: {}",
            cases().iter().map(|c| c.found.summary.to_string() + "\n").collect::<String>()
        );
    }
}
