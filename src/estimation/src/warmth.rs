//! Range of temperatures at which the tests of a campaign were measured.

use dashpot_records::Record;

/// Smallest temperature range, K, at which a temperature channel is used. At this range, the gas force differs by 1 %,
/// and the damping by less.
const VARIES: f64 = 3.0;

/// Returns the lowest and the highest temperature, °C. Returns `None` if a record has no temperature channel, or if the
/// temperatures vary by at most 3 K.
pub fn temperatures(records: &[&Record]) -> Option<(f64, f64)> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for record in records {
        for t in record.temperature.as_ref()?.iter().filter(|t| t.is_finite()) {
            (low, high) = (low.min(*t), high.max(*t));
        }
    }
    (high - low > VARIES).then_some((low, high))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_channel_says_something_where_all_records_have_it_and_it_varies() {
        let of = |all: &[Option<&[f64]>]| {
            let record = |t: &Option<&[f64]>| Record { temperature: t.map(<[f64]>::to_vec), ..Record::default() };
            let records: Vec<Record> = all.iter().map(record).collect();
            temperatures(&records.iter().collect::<Vec<_>>())
        };
        assert_eq!(of(&[Some(&[20.0, f64::NAN, 24.0]), Some(&[40.0])]), Some((20.0, 40.0)));
        assert_eq!(of(&[Some(&[20.0, 24.0]), None]), None);
        assert_eq!(of(&[Some(&[20.0, 22.0])]), None);
        assert_eq!(of(&[]), None);
    }
}
