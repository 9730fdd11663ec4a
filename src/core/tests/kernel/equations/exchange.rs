//! Sends cases to the program with the equations of the book and reads its results.

use super::draw::Case;
use super::kernel::states;
use super::python;
use dashpot_core::parameter::names;
use dashpot_core::parameter::{Element, Shape, table};
use std::fmt::Debug;

/// Section and name of a constant on the book's page of equations.
pub type Constant = (String, String);

/// A case to compute with the program of the book's equations, with an optional factor on one of the page's constants.
pub struct Question<'a> {
    pub case: &'a Case,
    pub shift: Option<(&'a Constant, f64)>,
}

/// One number that the program of the book's equations computed for a question.
pub struct Answer {
    pub question: usize,
    pub kind: String,
    pub name: String,
    pub value: f64,
}

/// Formats a JSON object. Names and words of the parameter table need no escapes, and numbers keep their last digit.
fn object(members: impl Iterator<Item = (impl Debug, String)>) -> String {
    let members: Vec<String> = members.map(|(name, value)| format!("{name:?}: {value}")).collect();
    format!("{{{}}}", members.join(", "))
}

fn json(question: &Question) -> String {
    let Question { case, shift } = question;
    let on: Vec<_> = names().filter(|name| case.params.is_on(Element::find(name).expect("an element"))).collect();
    let parameters = object(table().map(|row| {
        let values = case.params.get(&row);
        let value = match row.parameter.shape {
            Shape::Choice(words) => format!("{:?}", words[values[0] as usize]),
            Shape::Scalar => format!("{:?}", values[0]),
            Shape::List(_) => format!("{values:?}"),
        };
        (row.parameter.name, value)
    }));
    let states = object(states(&case.model, &case.state).map(|(name, value)| (name, format!("{value:?}"))));
    let input = &case.input;
    let mut members = vec![
        ("elements", format!("{on:?}")),
        ("parameters", parameters),
        ("states", states),
        ("x", format!("{:?}", input.displacement.expect("a displacement"))),
        ("v", format!("{:?}", input.velocity)),
        ("side_force", format!("{:?}", input.side_force)),
        ("temperature", format!("{:?}", input.temperature)),
    ];
    if let Some(((section, name), factor)) = shift {
        members.push(("shift", format!("[{section:?}, {name:?}, {factor:?}]")));
    }
    object(members.into_iter())
}

/// Computes the results of the questions with the equations of the book's page. Without Python, reports the skipped
/// test and returns `None`.
pub fn answers(questions: &[Question]) -> Option<Vec<Answer>> {
    let text: Vec<String> = questions.iter().map(json).collect();
    let said = python::run("answer.py", &format!("[{}]", text.join(",\n")))?;
    let answer = |line: &str| {
        let [question, kind, name, value] = line.split(' ').collect::<Vec<_>>().try_into().expect("four words");
        let number = "a number";
        Answer {
            question: question.parse().expect(number),
            kind: kind.to_owned(),
            name: name.to_owned(),
            value: value.parse().expect(number),
        }
    };
    Some(said.lines().map(answer).collect())
}
