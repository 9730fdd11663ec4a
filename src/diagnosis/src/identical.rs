//! Detection of measurements that are also in the reference. Such measurements cannot show a change.

use super::phrases;
use dashpot_messages::Sentence;
use dashpot_records::Record;

/// Returns a sentence that lists the tests whose values are identical in the reference, or `None` if there are none.
pub(super) fn identical(records: &[&Record], reference: &[Record]) -> Option<Sentence> {
    let known: Vec<String> = reference.iter().map(Record::fingerprint).collect();
    let same: Vec<String> = records
        .iter()
        .filter(|record| known.contains(&record.fingerprint()))
        .map(|record| record.name.clone())
        .collect();
    (!same.is_empty()).then(|| {
        Sentence::from(phrases::IDENTICAL).with_names("tests", same.iter().map(String::as_str), phrases::COMMA)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_measurement_is_found_whatever_its_name() {
        let of = |name: &str, force: f64| Record {
            name: name.to_owned(),
            time: vec![0.0, 1.0],
            displacement: vec![0.0, 0.1],
            velocity: vec![0.1; 2],
            force: vec![force; 2],
            ..Record::default()
        };
        let (own, other) = (of("own", 1.0), of("other", 2.0));
        let said = identical(&[&own, &other], &[of("copy", 1.0)]).unwrap().to_string();
        assert!(said.contains("in the reference: own;"), "{said}");
        assert_eq!(identical(&[&other], &[own]), None);
        assert_eq!(identical(&[&other], &[]), None);
    }
}
