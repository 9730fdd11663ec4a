//! Tests the reports in every language: reports of three diagnoses, and of a validation with flawed records.
//!
//! This file lists all texts that stay English in the translated reports.

use dashpot_core::{Params, parameter};
use dashpot_core::{element, number};
use dashpot_diagnosis::{Diagnosis, EFFECTS, Options, choose_left_out, diagnose};
use dashpot_estimation::priors::PRIORS;
use dashpot_identification::model_file::{self, ModelFile};
use dashpot_identification::validation::validate;
use dashpot_identification::{FitOptions, fit};
use dashpot_records::{Campaign, Positive, Record, load};
use dashpot_report::diagnosis::DiagnosisReport;
use dashpot_report::words::Language;
use dashpot_report::{Made, MadeFrom, ReportInput, parameters, reading, render};
use dashpot_simulation::comparison::compare;
use dashpot_simulation::whole_records::OfDiagnosis;
use dashpot_tests::kernel_campaign::{Sine, base, campaign};
use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::OnceLock;

/// Units, symbols, file formats and words of command lines, which are equal in all languages.
const SYMBOLS: &str = "mm N Hz ms kg m s J K W N·s/m N/mm mm/s m/s dv dx F v n c h x cm dashpot validate diagnose reference CSV FV SHA SHA-256 \
                       sha256sum rms lambda damper.toml rig/front rig/front/a.csv Dahl F_s F_v tanh";
/// Texts, by language, that may be equal to the English text.
const SAME: &[(&str, &[&str])] = &[
    ("de", &["Name", "Parameter", "Amplitude, mm"]),
    ("fr", &["compression", "amplitude, mm", "direction", "Identification", "cycles"]),
];

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

/// A diagnosis with its records.
struct Case {
    records: Vec<Record>,
    found: Diagnosis,
}

/// Makes three cases: a diagnosis that finds an effect, a diagnosis with a reference, and a diagnosis that may add no
/// effect.
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
            let options = Options { max_effects, candidates, reference, ..Options::default() };
            let found = diagnose(&refs, &choose_left_out(&refs, 0), &base(), &options, &|_, _| ()).unwrap();
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
        reading: Vec::new(),
        over_whole_records: OfDiagnosis::evaluate(
            &base(),
            &case.found.base,
            &case.found.improved,
            &case.found.measured,
            &records,
        )
        .unwrap(),
        parameters: parameters::of_diagnosis(&case.found, words),
        made: Made { version: "9.9".into(), command: "dashpot diagnose".into(), files: vec![file], ..Made::default() },
        print: dashpot_report::Print::Brief,
        words,
    }
    .render()
}

/// Returns every visible text of a page that contains letters, including the texts in drawings.
fn visible(page: &str) -> Vec<String> {
    every_text(page).into_iter().filter(|text| text.chars().any(char::is_alphabetic)).collect()
}

/// Returns every visible text of a page, including pure numbers.
fn every_text(page: &str) -> Vec<String> {
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
    texts.map(plain).filter(|text| !text.is_empty()).collect()
}

/// Returns the words of a text in Latin letters, including names and units.
fn latin(text: &str) -> impl Iterator<Item = &str> {
    let parts = text.split(|c: char| !(c.is_ascii_alphanumeric() || "_-./·".contains(c)));
    parts
        .map(|word| word.trim_matches(|c: char| "-./·".contains(c)))
        .filter(|w| w.chars().any(|c| c.is_ascii_alphabetic()))
}

/// Returns whether a word is a name from a file, a unit or a symbol.
fn is_name(word: &str) -> bool {
    let is_parameter = || parameter::table().any(|row| row.parameter.name == word);
    // These names in reports are not in the parameter table: the parameters of the damper's heating, and
    // `cylinder_expansion`, which no rig can identify.
    let of_measurement = ["cooling_rate", "heat_capacity", "cylinder_expansion"].contains(&word);
    // A hypothesis of an unnamed effect has the names of its components instead of an effect's name.
    let is_tried =
        || cases().iter().flat_map(|c| c.found.iterations.iter().flatten()).any(|tried| tried.effect == word);
    let is_test = cases().iter().flat_map(|c| &c.records).any(|record| record.name == word);
    let in_symbols = |word: &str| SYMBOLS.split_whitespace().any(|symbol| symbol == word);
    let is_figure = |part: &str| !part.chars().any(|c| c.is_ascii_alphabetic());
    let is_symbol = || in_symbols(word) || word.split(['/', '·']).all(|part| in_symbols(part) || is_figure(part));
    // The meaning of a parameter contains symbols of the model's equations (k_p, v_0, x), which are equal in every
    // language. Such symbols have one letter, or an underscore after the first letter.
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

/// Returns whether a text may stay English, because it is the meaning of a parameter.
fn stays(text: &str) -> bool {
    parameter::table().any(|row| row.parameter.meaning == text)
}

#[test]
fn every_text_of_a_chinese_report_is_chinese() {
    let mut foreign = BTreeSet::new();
    for case in cases() {
        let texts = visible(&page(case, Language::Chinese));
        foreign
            .extend(texts.into_iter().filter(|text| !stays(text) && !without_options(text).into_iter().all(is_name)));
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

/// Returns the words of a text that contain a decimal point between digits.
fn with_point(text: &str) -> impl Iterator<Item = &str> {
    let has_point = |word: &&str| {
        let parts: Vec<&str> = word.split('.').collect();
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        parts.windows(2).any(|p| digit(p[0].chars().last()) && digit(p[1].chars().next()))
    };
    text.split_whitespace().filter(has_point)
}

#[test]
fn numbers_of_german_and_french_reports_have_a_decimal_comma_and_every_minus_is_one() {
    let mut wrong = BTreeSet::new();
    let mut commas = 0;
    for case in cases() {
        for (_, language) in Language::ALL {
            for text in every_text(&page(case, language)) {
                // The version number of dashpot and the options of commands keep their decimal points.
                let plain = text.contains("dashpot 9.9") || text.contains("--");
                if matches!(language, Language::German | Language::French) && !plain {
                    wrong.extend(with_point(&text).map(str::to_owned));
                }
                commas += usize::from(language == Language::German && text.contains(','));
                let letters: Vec<char> = text.chars().collect();
                let hyphen = letters.windows(2).enumerate().any(|(k, pair)| {
                    pair[0] == '-' && pair[1].is_ascii_digit() && (k == 0 || letters[k - 1].is_whitespace())
                });
                if hyphen && !plain {
                    wrong.insert(text);
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(commas > 100, "{commas}");
}

#[test]
fn the_cases_have_every_section() {
    let pages: String = cases().iter().map(|case| page(case, Language::English)).collect();
    for text in [
        "What is missing",
        "Tests worth running next",
        "others than on the reference",
        "FV curves of both dampers",
        "Numbers of the model that moved",
    ] {
        assert!(
            pages.contains(text),
            "{text}: {}",
            cases().iter().map(|c| c.found.summary.to_string() + "\n").collect::<String>()
        );
    }
}

/// One row of a synthetic record: time in s, displacement in mm, velocity in mm/s, force in N; `None` is an empty cell.
type Row = [Option<f64>; 4];

const RATE: f64 = 1000.0;

/// Makes the rows of a sine test of 20 mm at 2 Hz on a damper with friction and gas. The force has noise of up to 1 N.
fn rows() -> Vec<Row> {
    let mut noise = 0.4f64;
    let mut row = |k: usize| {
        let t = k as f64 / RATE;
        let (x, v) = (20.0 * (TAU * 2.0 * t).sin(), 20.0 * TAU * 2.0 * (TAU * 2.0 * t).cos());
        noise = (137.0 * noise + 0.71).fract();
        [t, x, v, 1.4 * v + 60.0 * (v / 3.0).tanh() - 150.0 + if v > 0.0 { 0.6 * v } else { 0.0 } + 2.0 * (noise - 0.5)]
            .map(Some)
    };
    (0..4000).map(&mut row).collect()
}

/// Writes a record with the selected columns 0 (time), 1 (displacement), 2 (velocity) and 3 (force) under their
/// headings.
fn write(folder: &Path, name: &str, columns: &[usize], rows: &[Row]) {
    let headings = ["time [s]", "displacement [mm]", "velocity [mm/s]", "force [N]"];
    let mut text = columns.iter().map(|c| headings[*c]).collect::<Vec<_>>().join(",") + "\n";
    for row in rows {
        let cells = columns.iter().map(|c| row[*c].map_or_else(String::new, |value| format!("{value:.6}")));
        let _ = writeln!(text, "{}", cells.collect::<Vec<_>>().join(","));
    }
    std::fs::write(folder.join(name), text).unwrap();
}

/// Writes a record for every kind of flaw that is simple to produce.
fn flawed(folder: &Path) {
    let with = |change: &dyn Fn(usize, &mut Row)| {
        let mut rows = rows();
        rows.iter_mut().enumerate().for_each(|(k, row)| change(k, row));
        rows
    };
    let moved = |row: &mut Row, column: usize, by: f64| row[column] = row[column].map(|value| value + by);
    let plain = rows();
    write(folder, "plain.csv", &[0, 1, 3], &plain);
    write(folder, "twin.csv", &[0, 1, 3], &plain);
    write(folder, "both.csv", &[0, 1, 2, 3], &with(&|k, row| moved(row, 3, 0.01 * k as f64)));
    write(folder, "integrated.csv", &[0, 2, 3], &with(&|_, row| moved(row, 2, 3.0)));
    write(
        folder,
        "drift.csv",
        &[0, 1, 3],
        &with(&|k, row| (moved(row, 1, 5e-4 * k as f64), moved(row, 3, 0.05 * k as f64)).0),
    );
    write(
        folder,
        "spikes.csv",
        &[0, 1, 3],
        &with(&|k, row| {
            if k % 1500 == 700 {
                moved(row, 3, 4000.0)
            }
        }),
    );
    write(
        folder,
        "holes.csv",
        &[0, 1, 3],
        &with(&|k, row| {
            if k == 900 || k == 2100 {
                row[3] = None
            }
        }),
    );
    write(folder, "clipped.csv", &[0, 1, 3], &with(&|_, row| row[3] = row[3].map(|f| f.min(410.0))));
    write(folder, "stamps.csv", &[0, 1, 3], &with(&|k, row| row[0] = Some((k / 2 * 2) as f64 / RATE)));
    write(folder, "gap.csv", &[0, 1, 3], &with(&|k, row| moved(row, 0, if k < 2000 { 0.0 } else { 3.0 })));
    write(
        folder,
        "rest.csv",
        &[0, 1, 3],
        &with(&|k, row| {
            if k < 500 {
                *row = [row[0], Some(0.0), Some(0.0), Some(-150.0 + (k % 7) as f64)]
            }
        }),
    );
    let mut swapped = plain.clone();
    swapped.swap(1000, 1001);
    write(folder, "swapped.csv", &[0, 1, 3], &swapped);
    let mut repeated = plain.clone();
    repeated.splice(1500..1500, plain[1450..1500].to_vec());
    write(folder, "repeated.csv", &[0, 1, 3], &repeated);
    let wandering = |k: usize| (0..9).map(|n| ((0.7 + 0.9 * n as f64) * k as f64 / RATE + n as f64).sin()).sum::<f64>();
    write(
        folder,
        "wandering.csv",
        &[0, 1, 3],
        &with(&|k, row| {
            let (x, v) = (6.0 * wandering(k), 6.0 * RATE * (wandering(k + 1) - wandering(k)));
            (row[1], row[3]) = (Some(x), Some(1.4 * v + 60.0 * (v / 3.0).tanh() - 150.0));
        }),
    );
    // The records from here on are unusable; the campaign omits them.
    write(folder, "short.csv", &[0, 1, 3], &plain[..12]);
    write(
        folder,
        "frozen.csv",
        &[0, 1, 3],
        &with(&|k, row| {
            if k > 1000 {
                row[3] = Some(77.0)
            }
        }),
    );
    write(folder, "still.csv", &[0, 1, 3], &with(&|_, row| row[1] = Some(1.0)));
    write(folder, "no_clock.csv", &[0, 1, 3], &with(&|_, row| row[0] = Some(7.0)));
    write(folder, "no_rows.csv", &[0, 1, 3], &[]);
    write(
        folder,
        "many_holes.csv",
        &[0, 1, 3],
        &with(&|k, row| {
            if k % 9 == 0 {
                row[3] = None
            }
        }),
    );
    write(folder, "contradiction.csv", &[0, 1, 2, 3], &with(&|_, row| row[2] = row[2].map(|v| 25.4 * v)));
    write(folder, "cut.csv", &[0, 1, 3], &with(&|_, row| row[1] = row[1].map(|x| x.clamp(-9.0, 9.0))));
    std::fs::write(folder.join("empty.csv"), "").unwrap();
    std::fs::write(folder.join("paper.csv"), "%PDF-1.7\n").unwrap();
    std::fs::write(folder.join("words.csv"), "one,two\nthree,four\n").unwrap();
    std::fs::write(folder.join("readme.doc"), "").unwrap();
    std::fs::write(folder.join("damaged.xlsx"), "PK").unwrap();
    std::fs::write(
        folder.join("campaign.toml"),
        "format = \"dashpot campaign profile 1\"\nforce_zero_n = 10.0\ngain = 1.01\n",
    )
    .unwrap();
}

/// A flawed campaign, and a model file with the notes of its fit.
struct Flawed {
    /// Folder of the files of the case. Its name appears untranslated in texts.
    folder: String,
    campaign: Campaign,
    model: ModelFile,
}

fn flawed_cases() -> &'static [Flawed] {
    static CASES: OnceLock<Vec<Flawed>> = OnceLock::new();
    CASES.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        flawed(folder.path());
        let worked_out = dashpot_records::Options::default();
        let given = dashpot_records::Options {
            positive: Some(Positive::Compression),
            displacement_zero_m: 1e-4,
            rig_mass_kg: 0.5,
            delay_s: 1e-3,
            ..dashpot_records::Options::default()
        };
        let campaigns =
            [worked_out, given].map(|options| load(&[folder.path().to_path_buf()], &options, &|_| ()).unwrap());
        // The fit of four tests includes a cross-validation, the fit of one test does not.
        let fitted = [&tests()[..4], &tests()[..1]].map(|tests| {
            let records = campaign(&base(), tests, 7, 0.01);
            let refs: Vec<&Record> = records.iter().collect();
            model_file::write(&fit(&refs, &FitOptions::default(), |_| ()).unwrap())
        });
        let read = |text: &String| model_file::of_text(text, Path::new("m.toml")).unwrap();
        campaigns
            .into_iter()
            .zip(fitted.iter().map(read))
            .map(|(campaign, model)| Flawed { folder: folder.path().display().to_string(), campaign, model })
            .collect()
    })
}

/// Returns a function from a language code to the texts of the validation report on records and fit, including the
/// reasons for omitted tests.
fn remarks(case: &Flawed) -> impl Fn(&str) -> Vec<String> {
    let compared = compare(&case.model, &case.campaign, &|_, _| ()).unwrap();
    let validation = validate(&compared).unwrap();
    move |code| {
        let words = code.parse::<Language>().unwrap().words();
        let page =
            render(&ReportInput::from_validation(&case.model, &case.campaign, &compared, &validation, words).unwrap());
        let all = visible(&page).into_iter().chain(reading::sentences(&case.campaign, words));
        let plain = |text: String| text.replace(&case.folder, "").replace('\u{a0}', " ");
        // The title of a publication is not translated.
        all.map(|text| PRIORS.iter().fold(plain(text), |text, prior| text.replace(prior.citation(), ""))).collect()
    }
}

/// Returns the words of a text in Latin letters, without the options of commands and their values.
fn without_options(text: &str) -> Vec<&str> {
    let mut words: Vec<&str> = Vec::new();
    let mut parts = text.split(|c: char| !(c.is_ascii_alphanumeric() || "_-./·".contains(c))).peekable();
    while let Some(part) = parts.next() {
        match part.strip_prefix("--") {
            // The word after an option is its value.
            Some(_) => drop(parts.next()),
            None => words.push(part),
        }
    }
    words.into_iter().flat_map(latin).collect()
}

/// Returns whether a word is a name in the flawed campaign, a file format or a unit.
fn is_flawed_name(word: &str) -> bool {
    const FORMATS: &str = "PDF xlsx dB in SI PK v2 FV zip campaign.toml";
    let stems = "plain twin both integrated drift spikes holes clipped stamps gap rest swapped repeated wandering short frozen still no_clock \
                 no_rows many_holes contradiction cut empty paper words readme.doc damaged";
    let is = |list: &str| {
        list.split_whitespace().any(|name| name == word.trim_end_matches(".csv").trim_end_matches(".xlsx"))
    };
    // These words come from a quoted heading and from a message of the zip library. `in` is the inch, a likely unit.
    let quoted = "one two invalid Zip archive Could not find EOCD in";
    // The segments of a record with a gap have English names.
    is_name(word) || is(stems) || is(FORMATS) || is(quoted) || word == "part"
}

#[test]
fn what_was_noticed_of_records_and_in_a_fit_is_said_in_every_language() {
    let mut foreign = BTreeSet::new();
    for case in flawed_cases() {
        let remarks = remarks(case);
        let texts = remarks("zh");
        foreign.extend(texts.into_iter().filter(|t| !stays(t) && !without_options(t).into_iter().all(is_flawed_name)));
        let english: BTreeSet<String> = remarks("en").into_iter().collect();
        for (code, known) in SAME {
            let texts = remarks(code);
            let is_same = |text: &String| english.contains(text) && !stays(text) && !known.contains(&text.as_str());
            foreign.extend(texts.into_iter().filter(|t| is_same(t) && !latin(t).all(is_flawed_name)));
        }
    }
    assert!(foreign.is_empty(), "{foreign:#?}");
}

#[test]
fn the_flawed_campaign_shows_its_flaws() {
    let mut kinds = BTreeSet::new();
    for case in flawed_cases() {
        let records = case.campaign.records.iter().flat_map(|record| &record.notes);
        kinds.extend(case.campaign.notes.iter().chain(records).map(|note| note.kind));
    }
    for kind in
        "clipped consistency converted corrected derived drift duplicated gap ignored left_out missing out_of_order \
                 outlier profile time_resolution trimmed"
            .split_whitespace()
    {
        assert!(kinds.contains(kind), "{kind} in {kinds:?}");
    }
    let notes: usize = flawed_cases().iter().map(|case| case.model.identification.notes.len()).sum();
    assert!(notes >= 8, "{notes}");
    let unusable: usize = flawed_cases().iter().map(|case| case.campaign.unusable.len()).sum();
    assert!(unusable >= 20, "{unusable}");
}
