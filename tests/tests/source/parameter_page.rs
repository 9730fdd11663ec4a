//! Tests that the page of elements and parameters in the book matches the kernel's parameter table; `UPDATE_DOCS=1`
//! rewrites the page.

use dashpot_core::Params;
use dashpot_core::parameter::GROUPS;
use dashpot_core::parameter::{self, Element, Number, Parameter, Row, Shape};
use dashpot_estimation::priors::{self, Distribution, PRIORS};
use dashpot_estimation::scale::Scale;
use dashpot_tests::header::{bounds, short};
use std::fmt::Write as _;
use std::path::Path;

/// Formats the prior of a parameter. Returns an empty text for a parameter without a prior.
fn usual(row: Row) -> String {
    match Number::try_from(row).ok().and_then(|number| priors::distribution(number, Scale::CAR)) {
        Some(Distribution::Size(median, factor)) => format!("size {median} ×/÷ {factor}"),
        Some(Distribution::Strength(median, factor)) => format!("strength {median} × {factor}"),
        Some(Distribution::Place(mean, deviation)) => format!("{mean} ± {deviation}"),
        Some(Distribution::Skewed(mode, below, above)) => format!("{mode} −{below} +{above}"),
        None => String::new(),
    }
}

/// Formats the bounds of a parameter for a car damper. Returns an empty text if these bounds equal the general bounds.
fn in_proportion(p: &Parameter) -> String {
    let (low, high) = p.of_a_car;
    if (low, high) == (p.low, p.high) { String::new() } else { format!(" (car: {} to {})", short(low), short(high)) }
}

fn page() -> String {
    let default = Params::new();
    let mut out = String::from(
        "# Elements and parameters\n\n\
         Written from the kernel's parameter table by `UPDATE_DOCS=1 cargo test --release --test source parameter_page`.\n\n\
         SI units; extension (rebound) velocity and tension force positive. Names are those of the model file, of\n\
         `dashpot_params_set` in C, and of reports. A model file names the elements that are on; parameters that it does\n\
         not name keep their defaults.\n\n\
         Bounds are those of `dashpot.h`, which setting a number checks. Numbers with a force in their unit (N, kg, J or W) must also be of one size: each\n\
         within what it may be in a car's damper (in brackets), all of them a thousandth to a hundred times as large.\n\n\
         Usual is what dampers show before any record is seen: a size (median, and the factor by which one damper in three lies\n\
         off it), a strength (median of those that have the effect, and the factor by which one in six lies above it) or a place\n\
         (mean ± standard deviation, or the most frequent value with one to each side). A fit or a diagnosis stays there where records leave a number open. All of it was learned of the dampers of passenger\n\
         cars; with a largest force below 300 N or above 8 kN, what has a force in its unit (N, kg, J or W) is taken in proportion to\n\
         that force. A search goes no further than it would with a damper of a car, in proportion. Sources stand below.\n",
    );
    for (g, group) in GROUPS.iter().enumerate() {
        let on = match Element::of_group(g) {
            None => "no element: always there",
            Some(element) if default.is_on(element) => "on by default",
            Some(_) => "off by default",
        };
        let _ = write!(out, "\n## `{}`\n\n{}; {on}.\n\n", group.name, group.meaning);
        out += "| parameter | meaning | unit | default | bounds | usual |\n|---|---|---|---|---|---|\n";
        for row in parameter::table().filter(|r| r.group == g) {
            let p = row.parameter;
            let (default, bounds) = match p.shape {
                Shape::Choice(words) => (words[0].to_owned(), words.join(", ")),
                Shape::Scalar => (short(p.default[0]), bounds(p) + &in_proportion(p)),
                Shape::List(n) => (
                    if p.default.is_empty() { "none".to_owned() } else { format!("{} points", p.default.len()) },
                    format!("up to {n}, each {}", bounds(p)),
                ),
            };
            let _ = writeln!(
                out,
                "| `{}` | {} | {} | {default} | {bounds} | {} |",
                p.name,
                p.meaning.replace('|', "\\|"),
                p.unit.replace('|', "\\|"),
                usual(row)
            );
        }
    }
    out += "\n## What is usual, and where that comes from\n\n| parameters | source |\n|---|---|\n";
    let mut sources: Vec<&str> = Vec::new();
    for prior in PRIORS {
        if !sources.contains(&prior.source) {
            sources.push(prior.source);
        }
    }
    for source in sources {
        let names: Vec<String> =
            PRIORS.iter().filter(|p| p.source == source).map(|p| format!("`{}`", p.number)).collect();
        let _ = writeln!(out, "| {} | {source} |", names.join(", "));
    }
    out
}

#[test]
fn the_page_follows_the_table() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/parameters.md");
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(&path, page()).unwrap();
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(written == page(), "docs/parameters.md is out of date; run this test with UPDATE_DOCS=1");
}

/// Checks that the parameter page and the C header contain equal bounds for every parameter.
#[test]
fn the_header_and_the_page_have_the_same_bounds() {
    let header = std::fs::read_to_string(dashpot_tests::header::path()).unwrap();
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/parameters.md")).unwrap();
    let mut compared = 0;
    for p in parameter::table().map(|row| row.parameter).filter(|p| !matches!(p.shape, Shape::Choice(_))) {
        let line = header
            .lines()
            .find(|l| l.starts_with(&format!("//   {} ", p.name)))
            .unwrap_or_else(|| panic!("{}", p.name));
        let range = line.rsplit_once('[').unwrap().1;
        let in_header = range.split(", ").find(|part| part.contains(" to ")).unwrap();
        let row =
            page.lines().find(|l| l.starts_with(&format!("| `{}` ", p.name))).unwrap_or_else(|| panic!("{}", p.name));
        let in_page = row.replace("\\|", "").split('|').nth(5).unwrap().trim().replace("up to ", "");
        let in_page = in_page.split(" (car").next().unwrap().rsplit("each ").next().unwrap().to_owned();
        assert_eq!(in_header, in_page, "{}", p.name);
        let ends: Vec<f64> = in_page.split(" to ").map(|end| end.parse().unwrap()).collect();
        assert_eq!(ends, [p.low, p.high], "{}", p.name);
        compared += 1;
    }
    assert!(compared > 100, "{compared}");
}
