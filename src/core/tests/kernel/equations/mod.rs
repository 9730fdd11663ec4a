//! Checks that the equations of the book (docs/book/src/equations.md) are those of the kernel.
//!
//! A Python program that follows the page alone (`damper.py`) must agree with the kernel for random dampers at random
//! instants. The formulas of the page, evaluated as printed, must agree with that program. The page must name every
//! element, parameter, form and state of the kernel.

mod draw;
mod exchange;
mod kernel;
mod page;
mod python;

use dashpot_core::parameter::names;
use dashpot_core::parameter::{Element, Shape, table};
use dashpot_test_support::Random;
use dashpot_test_support::drawn;
use draw::Case;
use exchange::{Constant, Question, answers};
use proptest::test_runner::RngSeed;
use std::collections::{BTreeMap, BTreeSet};

/// Allowed difference between the book's program and the kernel due to rounding, relative to the number plus 1.
const SHARE: f64 = 1e-9;
/// Relative tolerance for numbers that depend on an oil velocity that is the root of an equation.
///
/// The error of Newton's method in the kernel is mostly below 1e-13 m/s, but sometimes larger near a knee. One number
/// in `RARE` may therefore differ by up to this tolerance.
const SOLVED: f64 = 1e-6;
const RARE: usize = 10_000;
/// Absolute tolerance of steady states, whose values may be small. The kernel's tanh and exp are accurate to about
/// 1e-16 of their largest value.
const ROUNDING: f64 = 1e-13;

/// Distance from the longest allowed steady-state void of 1 m, m, within which a rounding error decides whether the
/// result is this void or 0.
const LIMIT: f64 = 1e-9;

/// Returns whether two values of a number agree; `kind` is "part", "rate" or "settled". `share` is the tolerance
/// relative to the larger magnitude plus 1, or to this magnitude for a steady state ("settled").
fn agree(kind: &str, one: f64, other: f64, share: f64) -> bool {
    let size = one.abs().max(other.abs());
    (one - other).abs() <= if kind == "settled" { share * size + ROUNDING } else { share * (size + 1.0) }
}

fn on(case: &Case) -> Vec<&'static str> {
    names().filter(|name| case.params.is_on(Element::find(name).expect("an element"))).collect()
}

/// Draws cases from a seed that differs in every run.
fn cases(count: u32) -> Vec<Case> {
    let config = drawn(count);
    let RngSeed::Fixed(seed) = config.rng_seed else { panic!("a seed") };
    let mut random = Random(seed);
    (0..config.cases as usize).map(|index| draw::case(&mut random, index)).collect()
}

#[test]
fn the_page_and_the_kernel_answer_alike() {
    let cases = cases(2000);
    let questions: Vec<Question> = cases.iter().map(|case| Question { case, shift: None }).collect();
    let Some(answers) = answers(&questions) else { return };
    let mut book: BTreeMap<(usize, String, String), f64> =
        answers.into_iter().map(|a| ((a.question, a.kind, a.name), a.value)).collect();
    let (mut compared, mut near, mut apart) = (0, Vec::new(), Vec::new());
    for (number, case) in cases.iter().enumerate() {
        let answers = kernel::answers(case);
        let void = book.get(&(number, "settled".to_owned(), "cavitation_void".to_owned())).copied();
        let voids = answers.iter().filter(|a| (a.0, a.1) == ("settled", "cavitation_void")).map(|a| a.2).chain(void);
        let is_at_limit = voids.into_iter().any(|void| void > 1.0 - LIMIT);
        for (kind, name, value) in answers {
            let of_book = book.remove(&(number, kind.to_owned(), name.to_owned()));
            if is_at_limit && kind == "settled" {
                continue;
            }
            compared += 1;
            if !of_book.is_some_and(|of_book| agree(kind, of_book, value, SHARE)) {
                let told = format!("{kind} {name}: kernel {value:e}, book {of_book:?}; case {number}, {:?}", on(case));
                let is_near = of_book.is_some_and(|of_book| agree(kind, of_book, value, SOLVED));
                if is_near { &mut near } else { &mut apart }.push(told);
            }
        }
    }
    apart.extend(book.keys().map(|key| format!("the kernel has no {key:?}")));
    println!("{compared} numbers compared, {} differ by more than {SHARE:e}", near.len() + apart.len());
    near.iter().for_each(|told| println!("{told}"));
    assert!(apart.is_empty(), "{} of {compared} numbers differ:\n{}", apart.len(), apart.join("\n"));
    assert!(
        near.len() * RARE <= compared,
        "{} of {compared} numbers differ a little:\n{}",
        near.len(),
        near.join("\n")
    );
    // Check that each form of each element was drawn, because a form that is never drawn is not tested.
    let mut forms = BTreeSet::new();
    for case in &cases {
        for row in table() {
            if row.element().is_some_and(|element| case.params.is_on(element)) {
                forms.insert((row.parameter.name, case.params.get(&row).first().map(|value| *value as usize)));
            }
        }
    }
    for row in table().filter(|row| row.element().is_some()) {
        if let Shape::Choice(words) = row.parameter.shape {
            for (place, word) in words.iter().enumerate() {
                assert!(
                    forms.contains(&(row.parameter.name, Some(place))),
                    "{} = {word} was not drawn",
                    row.parameter.name
                );
            }
        }
    }
}

/// Constants whose effect on the results is below rounding, or occurs at forces that no damper has, so that the test
/// cannot detect it.
const UNSEEN: [&str; 3] = ["STEADY", "LEAST", "OCTAVES"];

/// Every constant of the book's page has an effect on some result. A constant without effect would not be tested by the
/// comparison.
#[test]
fn every_constant_of_the_page_counts() {
    // The cases are always the same, because this test checks the comparison, not the damper.
    let mut random = Random(1);
    let cases: Vec<Case> = (0..2000).map(|index| draw::case(&mut random, index)).collect();
    let constants = page::constants(&page::text());
    assert!(constants.len() > 30, "{constants:?}");
    let mut questions = Vec::new();
    for constant in constants.iter().filter(|(_, name)| !UNSEEN.contains(&&**name)) {
        // The page lists the constants of both stops under `bump_stop`. The leakage past the valves, listed under "The
        // hydraulic path", belongs to the oil column.
        let elements: &[&str] = match &*constant.0 {
            "The hydraulic path" => &["oil_compressibility", "aeration"],
            section => &[section],
        };
        let with = cases.iter().filter(|case| on(case).iter().any(|name| elements.contains(name)));
        questions.extend(with.take(80).map(|case| Question { case, shift: Some((constant, 1.1)) }));
    }
    let Some(answers) = answers(&questions) else { return };
    let mut seen: BTreeSet<&Constant> = BTreeSet::new();
    for answer in &answers {
        let Question { case, shift } = &questions[answer.question];
        let Some((constant, _)) = shift else { continue };
        if !seen.contains(constant) {
            let of_kernel = kernel::answers(case)
                .into_iter()
                .find(|(kind, name, _)| (*kind, *name) == (&*answer.kind, &*answer.name));
            if of_kernel.is_none_or(|(kind, _, value)| !agree(kind, answer.value, value, SHARE)) {
                seen.insert(constant);
            }
        }
    }
    let unseen: Vec<_> = constants.iter().filter(|c| !seen.contains(c) && !UNSEEN.contains(&&*c.1)).collect();
    assert!(unseen.is_empty(), "a tenth more of these changes no answer: {unseen:?}");
}

/// The formulas as printed on the page agree with the program `damper.py`. Without this test, the program could agree
/// with the kernel while the page is wrong.
#[test]
fn the_formulas_of_the_page_are_those_of_the_program() {
    let Some(said) = python::run("formulas.py", "") else { return };
    let compared = said.split(' ').next().and_then(|count| count.parse::<usize>().ok());
    assert!(compared.is_some_and(|count| count >= 120), "{said}");
}

#[test]
fn the_page_has_every_element_parameter_form_and_state() {
    let page = page::text();
    let mut missing = Vec::new();
    let mut ask = |text: &str, name: &str, what: &str, quoted: &[String]| {
        if !quoted.iter().any(|quoted| text.contains(quoted)) {
            missing.push(format!("{what} {name}"));
        }
    };
    let code = |name: &str| vec![format!("`{name}`")];
    for row in table() {
        let name = row.parameter.name;
        let Some(element) = row.element() else {
            ask(&page, name, "setting", &code(name));
            continue;
        };
        let Some(section) = page::section(&page, element.name()) else {
            ask("", element.name(), "the section of", &[]);
            continue;
        };
        ask(section, name, "parameter", &code(name));
        if let Shape::Choice(words) = row.parameter.shape {
            for word in words {
                ask(section, word, &format!("a form of {name},"), &[format!("\"{word}\"")]);
            }
        }
    }
    for case in cases(500) {
        for (name, _) in kernel::states(&case.model, &case.state) {
            ask(&page, name, "state", &[format!("\n| `{name}` | ")]);
        }
    }
    missing.sort();
    missing.dedup();
    assert!(missing.is_empty(), "the page of the equations lacks {}", missing.join(", "));
}
