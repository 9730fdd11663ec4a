//! Advice on rig tests, in the unit, the sign and the zero of the files. It also states which demands of a test exceed
//! the range of the recorded tests.

use super::phrases;
use dashpot_estimation::situation::Situation;
use dashpot_messages::{Sentence, Template};
use dashpot_records::{Record, RigFrame, Unit, round_figure};
use std::f64::consts::TAU;

/// Range of the recorded tests, and the coordinates of their files.
#[derive(Debug, Clone)]
pub struct Advice {
    /// Coordinates of the files.
    pub frame: RigFrame,
    /// Lowest and highest displacement of the tests, m, in internal coordinates.
    pub reach_m: (f64, f64),
    /// Highest speed of the tests, m/s.
    pub speed_m_s: f64,
    /// Highest frequency of the tests, Hz. Infinite if a test has no cycles, because its frequencies are unknown.
    pub frequency_hz: f64,
    /// Largest side force of the tests, N.
    pub side_force_n: f64,
    /// Strength of the damper relative to that of a car. Side forces in the advice are proportional to it.
    pub strength: f64,
}

/// A figure of a proposed test, in SI units. A `SideForce` is the value for a car's damper.
#[derive(Debug, Clone, Copy)]
enum Figure {
    Amplitude(f64),
    Speed(f64),
    Frequency(f64),
    SideForce(f64),
    /// Amplitude of half the range of the tests.
    WholeTravel,
}
use Figure::{Amplitude, Frequency, SideForce, Speed, WholeTravel};

/// Figures of the tests that messages propose, with the placeholders that show them. A figure with an empty placeholder
/// does not appear in the message, but counts as a demand of the test.
const FIGURES: &[(Template, &[(&str, Figure)])] = &[
    (phrases::SHOW_SLOW, &[("slow", Speed(0.0005)), ("fast", Speed(0.03))]),
    (phrases::SHOW_SPRING, &[("", WholeTravel), ("", Frequency(1.0))]),
    (
        phrases::SHOW_MOUNT,
        &[("small", Amplitude(5e-5)), ("large", Amplitude(5e-4)), ("low", Frequency(1.0)), ("high", Frequency(30.0))],
    ),
    (
        phrases::SHOW_PRESLIDING,
        &[("small", Amplitude(1e-4)), ("large", Amplitude(2e-3)), ("low", Frequency(0.1)), ("high", Frequency(1.0))],
    ),
    (phrases::SHOW_SIDE_FORCE, &[("half", SideForce(500.0)), ("full", SideForce(1000.0))]),
    (phrases::SHOW_POSITION, &[("small", Amplitude(5e-3)), ("large", Amplitude(1e-2))]),
    (phrases::SHOW_FREQUENCY, &[("low", Frequency(0.5)), ("high", Frequency(10.0))]),
    (phrases::NEEDS_FREQUENCIES, &[("low", Frequency(0.5)), ("high", Frequency(10.0))]),
];

/// Largest ratio of a demand of a test to the value that the recorded tests reached at which the demand counts as
/// within their range.
const MARGIN: f64 = 1.02;

impl Default for Advice {
    fn default() -> Self {
        Advice {
            frame: RigFrame::default(),
            reach_m: (f64::NEG_INFINITY, f64::INFINITY),
            speed_m_s: f64::INFINITY,
            frequency_hz: f64::INFINITY,
            side_force_n: f64::INFINITY,
            strength: 1.0,
        }
    }
}

impl Advice {
    /// Infers the range of the tests from the records of a campaign and their situation.
    pub fn new(records: &[&Record], situation: &Situation) -> Advice {
        let most = |of: &dyn Fn(&Record) -> f64| records.iter().map(|record| of(record)).fold(0.0, f64::max);
        let has_cycles = records.iter().all(|record| record.frequency > 0.0);
        let side_force =
            |record: &Record| record.side_force.iter().flatten().fold(0.0, |most: f64, force| most.max(force.abs()));
        Advice {
            frame: records.first().map(|record| record.frame).unwrap_or_default(),
            reach_m: situation.reach,
            speed_m_s: most(&|record| record.peak_velocity),
            frequency_hz: if has_cycles { most(&|record| record.frequency) } else { f64::INFINITY },
            side_force_n: most(&side_force),
            strength: situation.scale.force(),
        }
    }

    /// Inserts the figures of a test into the message that proposes it. Adds the demands of the test that exceed the
    /// range of the recorded tests.
    pub fn sentence(&self, template: Template) -> Sentence {
        let figures = FIGURES.iter().find(|(known, _)| *known == template).map_or(&[][..], |(_, figures)| figures);
        let mut test = Sentence::from(template);
        for (place, figure) in figures.iter().filter(|(place, _)| !place.is_empty()) {
            test = test.with(place, self.written(*figure));
        }
        for (place, unit) in [("unit", self.frame.unit), ("speed_unit", self.frame.speed_unit())] {
            if template.english().contains(&format!("{{{place}}}")) {
                test = test.with(place, unit.name());
            }
        }
        for (place, end) in [("lowest", self.reach_m.0), ("highest", self.reach_m.1)] {
            if template.english().contains(&format!("{{{place}}}")) {
                test = test.with(place, self.position(end));
            }
        }
        let beyond = self.beyond(figures);
        if beyond.is_empty() {
            return test;
        }
        let demands = Sentence::list(beyond, phrases::SEMICOLON);
        Sentence::from(phrases::BEYOND).with_sentence("test", test).with_sentence("demands", demands)
    }

    /// Formats a position of the model in the unit, the sign and the zero of the files.
    pub fn position(&self, inside: f64) -> String {
        let decimals = if self.frame.unit == Unit::Inch { 2 } else { 0 };
        format!("{:+.decimals$}", self.frame.position(inside) / self.frame.unit.to_si(1.0))
    }

    /// Returns the demands of a test that exceed the range of the recorded tests.
    fn beyond(&self, figures: &[(&str, Figure)]) -> Vec<Sentence> {
        let half = 0.5 * (self.reach_m.1 - self.reach_m.0);
        let most = |of: &dyn Fn(Figure) -> Option<f64>| figures.iter().filter_map(|f| of(f.1)).fold(0.0, f64::max);
        let amplitude = most(&|figure| match figure {
            Amplitude(value) => Some(value),
            WholeTravel if half.is_finite() => Some(half),
            _ => None,
        });
        let frequency = most(&|figure| if let Frequency(value) = figure { Some(value) } else { None });
        let stated = most(&|figure| if let Speed(value) = figure { Some(value) } else { None });
        let speed = stated.max(TAU * amplitude * frequency);
        let force = most(&|figure| if let SideForce(value) = figure { Some(self.strength * value) } else { None });
        let (length, velocity) = (self.frame.unit, self.frame.speed_unit());
        let all = [
            (amplitude, half, length.to_si(1.0), length.name(), phrases::BEYOND_AMPLITUDE),
            (speed, self.speed_m_s, velocity.to_si(1.0), velocity.name(), phrases::BEYOND_SPEED),
            (frequency, self.frequency_hz, 1.0, "Hz", phrases::BEYOND_FREQUENCY),
            (force, self.side_force_n, 1.0, "N", phrases::BEYOND_SIDE_FORCE),
        ];
        let demand = |(wanted, reached, unit, name, phrase): (f64, f64, f64, &str, Template)| {
            (wanted > MARGIN * reached).then(|| {
                Sentence::from(phrase)
                    .with("value", round_figure(wanted / unit))
                    .with("reached", round_figure(reached / unit))
                    .with("unit", name)
            })
        };
        all.into_iter().filter_map(demand).collect()
    }

    fn written(&self, figure: Figure) -> String {
        round_figure(match figure {
            Amplitude(value) => value / self.frame.unit.to_si(1.0),
            Speed(value) => value / self.frame.speed_unit().to_si(1.0),
            Frequency(value) => value,
            SideForce(value) => self.strength * value,
            WholeTravel => 0.5 * (self.reach_m.1 - self.reach_m.0) / self.frame.unit.to_si(1.0),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::{CARDS, remedy};
    use dashpot_core::Params;

    /// Makes the advice after tests of ±8 mm up to 0.2 m/s and 4 Hz, without side force.
    fn small_rig(frame: RigFrame) -> Advice {
        let reached =
            Advice { frame, reach_m: (-0.008, 0.008), speed_m_s: 0.2, frequency_hz: 4.0, ..Advice::default() };
        Advice { side_force_n: 0.0, ..reached }
    }

    /// Returns the numbers before a unit in a text.
    fn numbers_before(text: &str, unit: &str) -> Vec<f64> {
        let words: Vec<&str> = text.split([' ', '(', ')', ',', ';', ':']).filter(|word| !word.is_empty()).collect();
        words.windows(2).filter(|pair| pair[1] == unit).filter_map(|pair| pair[0].parse().ok()).collect()
    }

    #[test]
    fn no_advice_goes_beyond_what_the_rig_reached_without_saying_so() {
        let rig = small_rig(RigFrame::default());
        let mut beyond = 0;
        for card in CARDS {
            let said = remedy(card.name, &rig).to_string();
            for (unit, reached) in [("mm", 8.0), ("mm/s", 200.0), ("Hz", 4.0), ("N", 0.0)] {
                let most = numbers_before(&said, unit).into_iter().fold(0.0, f64::max);
                if most > reached {
                    beyond += 1;
                    let clause = format!("{reached} {unit}");
                    assert!(said.contains("beyond what these tests reached") && said.contains(&clause), "{said}");
                }
            }
            // If the recorded tests reached all demands, the message states none of them.
            let all =
                Advice { reach_m: (-1.0, 1.0), speed_m_s: 10.0, frequency_hz: 100.0, side_force_n: 1e6, ..rig.clone() };
            assert!(!remedy(card.name, &all).to_string().contains("beyond"), "{}", card.name);
        }
        assert!(beyond >= 4, "{beyond}");
        let fast = Advice { speed_m_s: 0.05, frequency_hz: 100.0, reach_m: (-0.1, 0.1), ..rig };
        let mount = remedy("series_compliance", &fast).to_string();
        assert!(mount.contains("94 mm/s where they reached 50 mm/s"), "{mount}");
    }

    #[test]
    fn advice_is_in_the_sign_the_zero_and_the_unit_of_the_files() {
        let files = RigFrame { turn: -1.0, zero_m: 0.1, unit: Unit::Inch, ..RigFrame::default() };
        let (own, counted) = (small_rig(RigFrame::default()), small_rig(files));
        // Compression ends at -8 mm of the model, which the files count as 100 + 8 mm.
        let said = |effect, advice: &Advice| remedy(effect, advice).to_string();
        assert!(said("bump_stop", &own).contains("towards -8 mm as the files count"), "{}", said("bump_stop", &own));
        assert!(said("bump_stop", &counted).contains("towards +4.25 in as the files count"));
        assert!(said("rebound_stop", &counted).contains("towards +3.62 in as the files count"));
        assert!(said("coulomb_friction", &counted).contains("0.02 to 1.2 in/s"));
        for card in CARDS {
            let text = said(card.name, &counted);
            assert!(!text.contains("mm"), "{text}");
            // A placeholder that was not filled would remain in the text in braces.
            assert!(!text.contains('{') && !said(card.name, &own).contains('{'), "{text}");
        }
    }

    #[test]
    fn reasons_are_in_the_sign_the_zero_and_the_unit_of_the_files() {
        let files = RigFrame { turn: -1.0, zero_m: 0.1, unit: Unit::Inch, ..RigFrame::default() };
        let mut situation = Situation::new(&Params::new(), &[], &[]);
        situation.reach = (-0.008, 0.008);
        situation.frequency_ratio = 1.0;
        let reasons = |advice: &Advice| -> Vec<String> {
            CARDS.iter().filter_map(|card| (card.missing)(&situation, advice)).map(|why| why.to_string()).collect()
        };
        let counted = reasons(&small_rig(files));
        assert!(counted.iter().any(|why| why.contains("+4.25 in in compression")), "{counted:?}");
        assert!(counted.iter().any(|why| why.contains("+3.62 in in extension")), "{counted:?}");
        assert!(counted.iter().any(|why| why.contains("10 Hz where they reached 4 Hz")), "{counted:?}");
        assert!(counted.iter().all(|why| !why.contains("mm") && !why.contains('{')), "{counted:?}");
    }

    #[test]
    fn side_forces_are_those_of_the_size_of_the_damper() {
        let small = Advice { strength: 0.01, ..small_rig(RigFrame::default()) };
        let said = remedy("side_force_friction", &small).to_string();
        assert!(said.contains("0, 5 and 10 N side force") && said.contains("10 N where they reached 0 N"), "{said}");
    }
}
