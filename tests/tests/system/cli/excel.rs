//! Tests of the option `--excel`: the tables of a report as a workbook, which the tests read again.

use calamine::{Data, Range, Reader as _, Xlsx, open_workbook};
use dashpot_records::reading_unit;
use dashpot_tests::bridge::MODEL;
use dashpot_tests::cli::{done, json, number, refused, small_campaign};
use std::path::Path;

/// Reads the sheets of a workbook with their names.
pub fn sheets(path: &Path) -> Vec<(String, Range<Data>)> {
    let mut book: Xlsx<_> = open_workbook(path).expect("a workbook");
    book.worksheets()
}

/// Returns the cells below a heading of a sheet.
pub fn column(sheet: &Range<Data>, heading: &str) -> Vec<Data> {
    let headings: Vec<String> = sheet.rows().next().expect("a row").iter().map(ToString::to_string).collect();
    let place = headings.iter().position(|h| h == heading).unwrap_or_else(|| panic!("no {heading} in {headings:?}"));
    sheet.rows().skip(1).map(|row| row[place].clone()).collect()
}

/// Returns the sheet with this name.
pub fn sheet<'a>(all: &'a [(String, Range<Data>)], name: &str) -> &'a Range<Data> {
    let found = all.iter().find(|(n, _)| n == name);
    &found.unwrap_or_else(|| panic!("no sheet {name} in {:?}", all.iter().map(|s| &s.0).collect::<Vec<_>>())).1
}

/// Returns the text of all cells of the first sheet, one line each.
fn first(all: &[(String, Range<Data>)]) -> String {
    all[0].1.rows().flatten().map(|cell| cell.to_string() + "\n").collect()
}

/// Asserts that the sheet of the inventory contains the forces of the effects in the JSON, with all digits.
fn assert_inventory(book: &[(String, Range<Data>)], found: &serde_json::Value) {
    let items = found["inventory"].as_array().expect("an inventory");
    assert!(!items.is_empty());
    let forces = column(sheet(book, "Inventory"), "force, N rms");
    let wanted: Vec<Data> = items.iter().map(|item| Data::Float(number(item, "force_n_rms"))).collect();
    assert_eq!(forces, wanted);
}

#[test]
fn the_tables_of_fit_validate_and_diagnose_are_read_back_in_full() {
    let folder = tempfile::tempdir().expect("a folder");
    let dir = folder.path();
    small_campaign(dir);
    done(dir, &["fit", "records", "-o", "m.toml", "--json", "f.json", "--excel", "f.xlsx"]);
    let fitted = sheets(&dir.join("f.xlsx"));
    let values = column(sheet(&fitted, "Model parameters"), "value");
    let estimates = json(&dir.join("f.json"));
    let estimates = estimates["parameters"].as_array().expect("parameters");
    assert_eq!(values.len(), estimates.len());
    let units = column(sheet(&fitted, "Model parameters"), "unit");
    for ((cell, unit), estimate) in values.iter().zip(&units).zip(estimates) {
        // The sheet has the units of the reports, such as N/mm, and the JSON has SI units.
        let value = number(estimate, "value");
        let (factor, shown) = reading_unit(value, estimate["unit"].as_str().expect("a unit"));
        match cell {
            Data::Float(cell) => {
                assert_eq!(*cell, factor * value, "{estimate}");
                assert_eq!(unit.to_string(), shown, "{estimate}");
            }
            _ => assert_eq!(estimate["standing"], "not_identified", "{estimate}"),
        }
    }

    assert_inventory(&fitted, &json(&dir.join("f.json")));

    let validate = ["validate", "m.toml", "records", "--json", "v.json", "--excel", "v.xlsx"];
    assert!(done(dir, &validate).contains("workbook: v.xlsx"));
    let validated = sheets(&dir.join("v.xlsx"));
    let version = env!("CARGO_PKG_VERSION");
    for text in [
        version,
        "m.toml",
        "records/a50mm_v0262mm_s.csv",
        "dashpot validate m.toml records --json v.json --excel v.xlsx\n",
    ] {
        assert!(first(&validated).contains(text), "{text}");
    }
    // The first sheet lists the others, and each of these begins with its headings. Numbers equal those of the JSON,
    // with all digits.
    for (name, range) in &validated[1..] {
        assert!(first(&validated).contains(name.as_str()) && range.height() > 1, "{name}");
        assert!(range.rows().next().expect("a row").iter().all(|cell| matches!(cell, Data::String(_))), "{name}");
    }
    let figures = json(&dir.join("v.json"));
    let tests = figures["tests"].as_array().expect("tests");
    let errors = column(sheet(&validated, "Errors of every test"), "model: mean error, N");
    assert_eq!(errors.len(), tests.len());
    for (cell, test) in errors.iter().zip(tests) {
        assert_eq!(*cell, Data::Float(number(test, "mean_error_n")), "{test}");
    }
    let before = std::fs::read(dir.join("v.xlsx")).expect("a file");
    done(dir, &validate);
    assert!(std::fs::read(dir.join("v.xlsx")).expect("a file") == before, "the same bytes");
    done(dir, &[&validate[..], &["--language", "zh"]].concat());
    assert!(sheets(&dir.join("v.xlsx")).iter().any(|(name, _)| name == "各试验的误差"));

    done(dir, &["diagnose", "m.toml", "records", "--json", "d.json", "--excel", "d.xlsx"]);
    let diagnosed = sheets(&dir.join("d.xlsx"));
    let found = json(&dir.join("d.json"));
    let rows = |list: &serde_json::Value| list.as_array().expect("a list").len();
    // The sheet of the tested hypotheses lists the findings first, then the candidates of the first iteration.
    let tried = rows(&found["findings"]) + rows(&found["iterations"][0]);
    assert_eq!(column(sheet(&diagnosed, "Everything that was tried"), "probability, %").len(), tried);
    assert_inventory(&diagnosed, &json(&dir.join("d.json")));
}

#[test]
fn a_manoeuvre_has_a_workbook_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let dir = folder.path();
    std::fs::write(dir.join("m.toml"), MODEL).expect("a model file");
    done(dir, &["manoeuvre", "bump", "m.toml", "--json", "b.json", "--excel", "b.xlsx"]);
    let book = sheets(&dir.join("b.xlsx"));
    let corners = sheet(&book, "Corners in figures");
    let low = json(&dir.join("b.json"))["corners"][0]["saw"]["displacement_m"][0].as_f64().expect("a number");
    assert_eq!(column(corners, "displacement, mm (low)")[0], Data::Float(1e3 * low));
}

#[test]
fn a_workbook_takes_the_place_of_an_older_one_of_ours_and_of_nothing_else() {
    let folder = tempfile::tempdir().expect("a folder");
    let dir = folder.path();
    std::fs::write(dir.join("m.toml"), MODEL).expect("a model file");
    let args = ["manoeuvre", "bump", "m.toml", "--excel", "b.xlsx"];
    for foreign in [&b"PK\x03\x04xl/workbook.xml"[..], b"Dear Anna,\n"] {
        std::fs::write(dir.join("b.xlsx"), foreign).expect("a file");
        assert!(refused(dir, &args).contains("a workbook of dashpot"));
        assert_eq!(std::fs::read(dir.join("b.xlsx")).expect("a file"), foreign);
    }
    for (args, told) in [
        (&["manoeuvre", "bump", "m.toml", "--excel", "m.toml"][..], "--force"),
        (&["manoeuvre", "bump", "m.toml", "--excel", "-"], "--excel needs a file name"),
        (&["manoeuvre", "bump", "m.toml", "--excel", "no/b.xlsx"], "there is no folder"),
        (&["fit", "m.toml", "-o", "n.toml", "--model", "dahl", "--excel", "n.xlsx"], "--json"),
    ] {
        let message = refused(dir, args);
        assert!(message.contains(told), "{args:?}: {message}");
    }
}
