//! Detection of opposite positive directions in campaign and reference. The direction of each campaign is determined
//! separately, although campaigns of one rig usually have equal directions. With opposite directions, the diagnosis
//! would compare rebound of one campaign with compression of the other.

use super::phrases;
use dashpot_messages::Sentence;
use dashpot_records::record::Counted;
use dashpot_records::{Positive, Record};

/// Returns a sentence if campaign and reference have opposite positive directions. Returns `None` if they are equal or
/// unknown, or if the user stated both.
pub(super) fn opposite(records: &[&Record], reference: &[Record]) -> Option<Sentence> {
    let (own, good) = (records.first()?.counted?, reference.first()?.counted?);
    let is_meant = own.is_stated && good.is_stated;
    let name = |counted: Counted| match counted.positive {
        Positive::Rebound => phrases::REBOUND,
        Positive::Compression => phrases::COMPRESSION,
    };
    (own.positive != good.positive && !is_meant)
        .then(|| Sentence::from(phrases::OPPOSITE).with_sentence("own", name(own)).with_sentence("good", name(good)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_directions_are_told_unless_the_user_meant_them() {
        let of =
            |positive, given| Record { counted: Some(Counted { positive, is_stated: given }), ..Record::default() };
        let describe = |own: &Record, good: Record| opposite(&[own], &[good]).map(|said| said.to_string());
        let (rebound, compression) = (of(Positive::Rebound, false), of(Positive::Compression, false));
        let said = describe(&compression, rebound.clone()).unwrap();
        assert!(
            said.contains("counting compression positive and the reference as counting rebound positive"),
            "{said}"
        );
        assert_eq!(describe(&rebound, rebound.clone()), None);
        assert!(describe(&rebound, of(Positive::Compression, true)).is_some());
        assert_eq!(describe(&of(Positive::Rebound, true), of(Positive::Compression, true)), None);
        // The default record was not read from a file, so its direction is unknown.
        assert_eq!(describe(&rebound, Record::default()), None);
    }
}
