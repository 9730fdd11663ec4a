//! Handles empty and not-a-number cells: drops the rows if they are few, otherwise rejects the record.

use crate::data::samples::Samples;
use crate::error::{RecordError, SampleError};
use crate::messages::phrases;
use crate::quantities::channel::Channel;
use crate::quantities::motion_limit::motion_limit;
use crate::tuning::missing::{FRACTION, RUN};
use dashpot_messages::{Sentence, format_decimals};

/// Makes single values missing that no sensor measures, such as the 9.9e37 of a voltmeter that overflows. A channel with
/// many such values stays unchanged, because its unit is then the likely cause.
pub(crate) fn forget_overflows(samples: &mut Samples) {
    for channel in [Channel::Force, Channel::Displacement, Channel::Velocity] {
        let limit = motion_limit(channel);
        // The message is in the unit of the file, because the user searches the value there.
        let own = samples.units.iter().find(|(of, _)| *of == channel).map(|(_, unit)| *unit);
        let (factor, unit) = own.map_or((1.0, channel.si()), |unit| (unit.to_si(1.0), unit.name()));
        let Some(values) = samples.channel_mut(channel) else { continue };
        let beyond: Vec<usize> = (0..values.len()).filter(|&i| values[i].abs() > limit).collect();
        let (Some(&first), true) = (beyond.first(), is_few(beyond.len(), values.len())) else { continue };
        let (count, value) = (beyond.len(), format_decimals(values[first] / factor, 0));
        beyond.into_iter().for_each(|i| values[i] = f64::NAN);
        let text = Sentence::from(phrases::OVERFLOWS)
            .with("count", count)
            .with_sentence("channel", channel.message())
            .with("line", samples.lines[first])
            .with("value", value)
            .with("unit", unit);
        samples.note("missing", text);
    }
}

/// Returns whether so few of the `rows` lack a value that they are dropped.
fn is_few(count: usize, rows: usize) -> bool {
    count as f64 <= (FRACTION * rows as f64).max(3.0)
}

/// Drops rows in which time, force or motion is missing.
///
/// Interpolates missing values of side force and temperature, which are slow and often logged at a lower rate.
///
/// # Errors
/// [`SampleError::Missing`] if too many rows, or too many in succession, lack a value.
pub(crate) fn drop_rows(samples: &mut Samples) -> Result<(), RecordError> {
    forget_empty_columns(samples);
    let rows = samples.len();
    let missing: Vec<bool> = (0..rows)
        .map(|i| NEEDED.iter().any(|&c| samples.channel(c).is_some_and(|values| values[i].is_nan())))
        .collect();
    let count = missing.iter().filter(|&&m| m).count();
    if count > 0 {
        let longest = missing.chunk_by(|a, b| a == b).filter(|run| run[0]).map(<[bool]>::len).max().unwrap_or(0);
        let first = missing.iter().position(|&m| m).unwrap_or(0);
        if !is_few(count, rows) || longest > RUN {
            let channel = NEEDED
                .into_iter()
                .find(|&c| samples.channel(c).is_some_and(|values| values[first].is_nan()))
                .unwrap_or(Channel::Force);
            let (at, line) = (samples.at.clone(), samples.lines[first]);
            return Err(SampleError::Missing { at, line, channel, count, rows }.into());
        }
        let mut lines: Vec<String> =
            missing.iter().zip(&samples.lines).filter(|(m, _)| **m).take(5).map(|(_, l)| l.to_string()).collect();
        if count > lines.len() {
            lines.push("...".to_string());
        }
        samples.note(
            "missing",
            Sentence::from(phrases::ROWS_DROPPED).with("count", count).with("rows", rows).with_names(
                "lines",
                lines,
                phrases::COMMA,
            ),
        );
        samples.retain(|i| !missing[i]);
    }
    for channel in [Channel::SideForce, Channel::Temperature] {
        let Samples { time, side_force, temperature, .. } = samples;
        let values = if channel == Channel::SideForce { side_force } else { temperature };
        if let Some(values) = values {
            let bridged = bridge(time, values);
            if bridged > 0 {
                let filled = Sentence::from(phrases::FILLED).with("count", bridged);
                samples.note("missing", filled.with_sentence("channel", channel.message()));
            }
        }
    }
    Ok(())
}

const NEEDED: [Channel; 4] = [Channel::Time, Channel::Force, Channel::Displacement, Channel::Velocity];

/// Removes empty columns of side force and temperature. Removes an empty motion column if the other motion channel
/// exists.
fn forget_empty_columns(samples: &mut Samples) {
    let empty = |values: &Option<Vec<f64>>| values.as_ref().is_some_and(|v| v.iter().all(|x| x.is_nan()));
    let both = samples.displacement.is_some() && samples.velocity.is_some();
    let mut forgotten = Vec::new();
    if both && empty(&samples.velocity) {
        samples.velocity = None;
        forgotten.push(Channel::Velocity);
    } else if both && empty(&samples.displacement) {
        samples.displacement = None;
        forgotten.push(Channel::Displacement);
    }
    if empty(&samples.side_force) {
        samples.side_force = None;
        forgotten.push(Channel::SideForce);
    }
    if empty(&samples.temperature) {
        samples.temperature = None;
        forgotten.push(Channel::Temperature);
    }
    for channel in forgotten {
        samples.note("missing", Sentence::from(phrases::EMPTY_COLUMN).with_sentence("channel", channel.message()));
    }
}

/// Fills missing values by linear interpolation over time. Before the first and after the last value, the interpolation
/// is constant. Returns the number of filled values.
fn bridge(time: &[f64], values: &mut [f64]) -> usize {
    let known: Vec<usize> = (0..values.len()).filter(|&i| !values[i].is_nan()).collect();
    let (Some(&first), Some(&last)) = (known.first(), known.last()) else {
        return 0;
    };
    let count = values.len() - known.len();
    let (low, high) = (values[first], values[last]);
    values[..first].fill(low);
    values[last + 1..].fill(high);
    for pair in known.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let (from, to) = (values[a], values[b]);
        for i in a + 1..b {
            values[i] = from + (to - from) * (time[i] - time[a]) / (time[b] - time[a]);
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    #[test]
    fn stray_cells_cost_their_row_and_are_told() {
        let mut samples = SineTest::default().samples();
        let n = samples.len();
        samples.force[10] = f64::NAN;
        samples.displacement.as_mut().unwrap()[500] = f64::NAN;
        let expected: Vec<f64> = (0..n).filter(|i| ![10, 500].contains(i)).map(|i| samples.force[i]).collect();
        drop_rows(&mut samples).unwrap();
        assert_eq!(samples.force, expected);
        let text = samples.notes[0].text.to_string();
        assert!(text.starts_with("2 of ") && text.contains("line 12, 502"));
    }

    #[test]
    fn an_overflow_is_a_missing_value_and_no_swapped_column() {
        for (channel, value) in [(Channel::Force, 1e300), (Channel::Displacement, 9.9e37), (Channel::Velocity, -1e30)] {
            let mut samples = SineTest::default().samples();
            let n = samples.len();
            samples.channel_mut(channel).unwrap()[400] = value;
            let pieces = crate::cleaning::sort_out(samples, &crate::Options::default()).unwrap();
            assert_eq!((pieces.len(), pieces[0].len()), (1, n - 1));
            let text = pieces[0].notes[0].text.to_string();
            assert!(text.contains("line 402") && text.contains(&channel.to_string()), "{text}");
        }
        // A channel of which every value is too large has a wrong unit.
        let mut samples = SineTest::default().samples();
        samples.force.iter_mut().for_each(|force| *force = 1e12 + 1e12 * *force);
        forget_overflows(&mut samples);
        assert!(samples.force.iter().all(|force| force.is_finite()) && samples.notes.is_empty());
    }

    #[test]
    fn many_missing_values_are_refused_with_the_first_line() {
        let mut samples = SineTest::default().samples();
        samples.velocity.as_mut().unwrap()[100..130].fill(f64::NAN);
        let error = drop_rows(&mut samples).unwrap_err().to_string();
        assert!(error.contains("line 102: velocity") && error.contains("30 of"), "{error}");
    }

    #[test]
    fn empty_columns_are_left_out_and_slow_channels_bridged() {
        let mut samples = SineTest::default().samples();
        let n = samples.len();
        samples.velocity = Some(vec![f64::NAN; n]);
        samples.side_force = Some(vec![f64::NAN; n]);
        samples.temperature = Some((0..n).map(|i| if i % 10 == 3 { i as f64 } else { f64::NAN }).collect());
        drop_rows(&mut samples).unwrap();
        assert!(samples.velocity.is_none() && samples.side_force.is_none());
        let temperature = samples.temperature.unwrap();
        assert_eq!((temperature[0], temperature[3], temperature.len()), (3.0, 3.0, n));
        assert!((temperature[57] - 57.0).abs() < 1e-9);
        assert_eq!(samples.notes.len(), 3);
    }

    #[test]
    fn a_small_fraction_and_a_short_run_may_be_missing() {
        let dropped = |missing: &dyn Fn(usize) -> bool| {
            let mut samples = SineTest { per_cycle: 1000, ..SineTest::default() }.samples();
            (0..samples.len()).filter(|i| missing(*i)).for_each(|i| samples.force[i] = f64::NAN);
            drop_rows(&mut samples).is_ok()
        };
        assert!(dropped(&|i| i % 67 == 0) && !dropped(&|i| i % 33 == 0));
        assert!(dropped(&|i| (100..107).contains(&i)) && !dropped(&|i| (100..114).contains(&i)));
    }
}
