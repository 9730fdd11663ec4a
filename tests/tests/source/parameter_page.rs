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
fn prior(row: Row) -> String {
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
         `UPDATE_DOCS=1 cargo test --profile tests -p dashpot-tests --test source parameter_page` writes this page from the kernel's parameter table.\n\n\
         All numbers are in SI units. Extension (rebound) velocity and tension force are positive. The model file,\n\
         `dashpot_params_set` in C and the reports use these names. A model file names the elements that are on. Parameters\n\
         that it does not name keep their defaults.\n\n\
         **Bounds** are those of `dashpot.h`, and every setter checks them. Numbers with a force in their unit (N, kg, J or W)\n\
         must also belong to one size of damper. Their bounds for a car damper are in brackets. All these numbers must lie within\n\
         the bounds in brackets times one common factor, which is between 0.001 and 100.\n\n\
         **Priors** are the distributions over dampers before any record is evaluated. Where records leave a number open, a fit or a\n\
         diagnosis keeps the center of its prior.\n\n\
         | prior | distribution |\n|---|---|\n\
         | size a ×/÷ b | median a of a positive quantity; one damper in three differs from it by more than the factor b |\n\
         | strength a × b | median a of the dampers that have the effect; one in six exceeds it by more than the factor b |\n\
         | a ± b | mean a and standard deviation b |\n\
         | a −b +c | mode a, standard deviation b below and c above it |\n\n\
         All priors come from dampers of passenger cars. If the largest force is below 300 N or above 8 kN, priors with a force in\n\
         their unit are proportional to it. The ranges of a search scale in the same way. The last section lists the\n\
         [sources](#sources-of-the-priors).\n",
    );
    for (g, group) in GROUPS.iter().enumerate() {
        let on = match Element::of_group(g) {
            None => "no element, always present",
            Some(element) if default.is_on(element) => "on by default",
            Some(_) => "off by default",
        };
        let _ = write!(out, "\n## `{}`\n\n{}; {on}.\n\n", group.name, group.meaning);
        out += "| parameter | meaning | unit | default | bounds | prior |\n|---|---|---|---|---|---|\n";
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
                prior(row)
            );
        }
    }
    out += "\n## Sources of the priors\n\n| parameters | source |\n|---|---|\n";
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
    let page = page();
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
