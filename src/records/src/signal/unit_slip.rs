//! Finds the channels for which another unit explains a contradiction between displacement and velocity.
//!
//! The derivative of the displacement has a unit of length and a unit of time. A wrong unit of displacement, velocity
//! or time therefore changes the ratio of velocity and derivative alike. Only the size and frequency of the resulting
//! test distinguish the causes.

use std::f64::consts::TAU;

use crate::messages::phrases;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::tuning::unit_slip::{EXACTNESS, TYPICAL_AMPLITUDE, TYPICAL_FREQUENCY, TYPICAL_SPEED};
use dashpot_messages::{Sentence, format_decimals};

/// Size of a motion as it was read.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MotionSize {
    /// Amplitude of the displacement, m.
    pub amplitude: f64,
    /// Peak of the velocity channel, m/s.
    pub speed: f64,
}

/// Another unit of a channel with which displacement and velocity agree.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    channel: Channel,
    /// Unit in which the channel was read.
    read: Unit,
    /// Unit with which the channels agree.
    likely: Unit,
    /// Amplitude of the test in that unit, m.
    amplitude: f64,
    /// Peak velocity of the test in that unit, m/s.
    speed: f64,
}

impl Candidate {
    /// Returns the frequency, Hz, of a sine with this amplitude and peak velocity.
    fn frequency(&self) -> f64 {
        self.speed / (TAU * self.amplitude)
    }

    /// Returns how far the resulting test is from a typical damper test, as the sum of logarithmic distances.
    fn distance_to_typical(&self) -> f64 {
        let sizes =
            [(self.amplitude, TYPICAL_AMPLITUDE), (self.speed, TYPICAL_SPEED), (self.frequency(), TYPICAL_FREQUENCY)];
        sizes.iter().map(|(value, typical)| libm::log(value / typical).abs()).sum()
    }

    fn sentence(&self) -> Sentence {
        Sentence::from(phrases::UNIT_CANDIDATE)
            .with_sentence("channel", self.channel.message())
            .with("likely", self.likely)
            .with("read", self.read)
            .with("amplitude", digits(1e3 * self.amplitude))
            .with("frequency", digits(self.frequency()))
            .with("velocity", digits(1e3 * self.speed))
            .with("option", format!("--unit {}={}", self.channel, self.likely))
    }
}

/// Formats a positive number with about three digits.
fn digits(value: f64) -> String {
    let decimals = (2.0 - libm::floor(libm::log10(value))).clamp(0.0, 6.0);
    format_decimals(value, decimals as usize)
}

/// Returns the sentences on the units that explain a velocity of `gain` times the derivative of the displacement. The
/// unit with the most typical test is first. `units` are the units in which the channels were read.
pub(crate) fn candidates(gain: f64, size: MotionSize, units: &[(Channel, Unit)]) -> Vec<Sentence> {
    let mut found: Vec<Candidate> =
        units.iter().flat_map(|(channel, read)| of_channel(gain, size, *channel, *read)).collect();
    found.sort_by(|a, b| a.distance_to_typical().total_cmp(&b.distance_to_typical()));
    found.iter().map(Candidate::sentence).collect()
}

fn of_channel(gain: f64, size: MotionSize, channel: Channel, read: Unit) -> impl Iterator<Item = Candidate> {
    let others = Unit::ALL.into_iter().filter(move |other| *other != read && other.dimension() == read.dimension());
    others.filter_map(move |likely| {
        let factor = likely.to_si(1.0) / read.to_si(1.0);
        let MotionSize { amplitude, speed } = size;
        let (gain, amplitude, speed) = match channel {
            // The derivative of the displacement decreases as the times grow.
            Channel::Time => (gain * factor, amplitude, speed),
            Channel::Displacement => (gain / factor, amplitude * factor, speed),
            Channel::Velocity => (gain * factor, amplitude, speed * factor),
            _ => return None,
        };
        ((gain - 1.0).abs() < EXACTNESS).then_some(Candidate { channel, read, likely, amplitude, speed })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the sentences for a test of 25 mm and 0.262 m/s. A rig wrote it in the units `written`, and the reader
    /// assumed the units `read`. The units are those of time, displacement and velocity.
    fn explain(written: [Unit; 3], read: [Unit; 3]) -> Vec<String> {
        let factor = |k: usize| read[k].to_si(1.0) / written[k].to_si(1.0);
        let size = MotionSize { amplitude: 0.025 * factor(1), speed: 0.262 * factor(2) };
        let gain = 1.02 * factor(2) * factor(0) / factor(1);
        let channels = [Channel::Time, Channel::Displacement, Channel::Velocity];
        let units: Vec<(Channel, Unit)> = channels.into_iter().zip(read).collect();
        candidates(gain, size, &units).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn the_unit_with_a_typical_test_is_first() {
        use Unit::{Centimetre as Cm, Inch, InchPerSecond as InS, Metre as M, MetrePerSecond as MS, Millimetre as Mm};
        use Unit::{Millimetre, MillimetrePerSecond as MmS, Millisecond as Ms, Second as S};
        for (written, read, first) in [
            ([S, M, MS], [Ms, M, MS], "the unit of time is s where ms was read"),
            ([Ms, Mm, MmS], [S, Mm, MmS], "the unit of time is ms where s was read"),
            ([S, M, MS], [S, Millimetre, MS], "the unit of displacement is m where mm was read"),
            ([S, Mm, MS], [S, M, MS], "the unit of displacement is mm where m was read"),
            ([S, Mm, MmS], [S, Mm, MS], "the unit of velocity is mm/s where m/s was read"),
            ([S, M, MS], [S, M, MmS], "the unit of velocity is m/s where mm/s was read"),
            ([S, Inch, InS], [S, Mm, InS], "the unit of displacement is in where mm was read"),
            ([S, Cm, MmS], [S, Mm, MmS], "the unit of displacement is cm where mm was read"),
        ] {
            let found = explain(written, read);
            assert!(found.first().is_some_and(|text| text.starts_with(first)), "{first}: {found:?}");
            assert!(found[0].contains("25.0 mm at 1.67 Hz and 262 mm/s"), "{found:?}");
            let words: Vec<&str> = first.split(' ').collect();
            assert!(found[0].ends_with(&format!("give --unit {}={}", words[3], words[5])), "{found:?}");
        }
    }

    #[test]
    fn every_channel_that_explains_the_ratio_is_named() {
        use Unit::{Metre, MetrePerSecond, Millimetre, Millisecond, Second};
        let found = explain([Second, Metre, MetrePerSecond], [Second, Millimetre, MetrePerSecond]);
        assert_eq!(found.len(), 3, "{found:?}");
        assert!(
            found[1..].iter().any(|text| text.starts_with("the unit of velocity is mm/s where m/s was read")),
            "{found:?}"
        );
        assert!(found[1..].iter().any(|text| text.starts_with("the unit of time is ms where s was read")), "{found:?}");
        // No unit of velocity is a thousand times m/s.
        let found = explain([Second, Metre, MetrePerSecond], [Millisecond, Metre, MetrePerSecond]);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!(found[1].contains("0.0250 mm at 1668 Hz"), "{found:?}");
        assert!(explain([Second, Metre, MetrePerSecond], [Second, Metre, MetrePerSecond]).is_empty());
    }
}
