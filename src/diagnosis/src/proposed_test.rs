//! Choice of the rig test that best distinguishes rivals, which are competing hypotheses.
//!
//! In this test, the predictions of the refitted rivals differ most relative to the noise (Hunter & Reiner,
//! Technometrics 7, 1965).

use super::advice::Advice;
use super::effects::remedy;
use super::outcome::NextTest;
use super::phrases;
use dashpot_core::element;
use dashpot_core::{Input, Model};
use dashpot_estimation::hypothesis::Hypothesis;
use dashpot_estimation::samples::Test;
use dashpot_estimation::scale::Scale;
use dashpot_estimation::segment::Segment;
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_messages::Sentence;
use dashpot_records::RigSine;
use dashpot_records::newtons::newtons;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// A competing hypothesis.
pub struct Rival<'a> {
    /// Name of the added effect.
    pub effect: &'static str,
    /// The hypothesis.
    pub hypothesis: &'a Hypothesis,
    /// Values of the hypothesis's free parameters.
    pub theta: &'a [f64],
    /// Probability of the hypothesis.
    pub confidence: f64,
}

/// Capabilities of a rig, inferred from the campaign.
pub struct Rig {
    /// Lowest and highest displacement of the tests, m.
    pub reach: (f64, f64),
    /// Highest peak velocity, m/s.
    pub speed: f64,
    /// Lowest and highest side force of the campaign, N, rounded to multiples of 50. The rig can apply these side
    /// forces, because it has applied them before.
    pub side_forces: Vec<f64>,
    /// Largest measured force, N. It is known to be safe for damper and load cell.
    pub force: f64,
}

/// Largest ratio of a proposed test's force to the largest measured force.
const BEYOND: f64 = 1.2;

const AMPLITUDES: [f64; 8] = [0.0003, 0.001, 0.002, 0.005, 0.01, 0.02, 0.03, 0.05];
const FREQUENCIES: [f64; 10] = [0.01, 0.05, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 25.0];
/// Number of samples per cycle of a simulated sine. One cycle is simulated before the evaluated cycle, so that the
/// model reaches its steady state.
const PER_CYCLE: usize = 120;
/// Expected noise of a test with a car damper: a fraction of the root mean square force, and a constant part, N.
const NOISE: (f64, f64) = (0.02, 1.0);
/// Largest number of proposed tests.
const TOLD: usize = 3;

#[derive(Clone, Copy)]
struct Design {
    amplitude: f64,
    frequency: f64,
    mean: f64,
    side_force: f64,
}

fn sine(d: &Design) -> Test {
    let lead = PER_CYCLE;
    let n = lead + PER_CYCLE;
    let dt = 1.0 / (d.frequency * PER_CYCLE as f64);
    let w = TAU * d.frequency;
    let input = (0..n)
        .map(|i| {
            let t = (i as f64 - lead as f64 + 0.37) * dt;
            Input {
                displacement: Some(d.mean + d.amplitude * libm::sin(w * t)),
                velocity: d.amplitude * w * libm::cos(w * t),
                side_force: d.side_force,
                temperature: 20.0,
            }
        })
        .collect();
    Test {
        record: 0,
        segment: Segment {
            name: String::new(),
            dt: vec![dt; n],
            input,
            setting: None,
            force: vec![0.0; n],
            from: lead,
            scale: 1.0,
            top: 1.0,
            peak_velocity: d.amplitude * w,
            amplitude: d.amplitude,
            clock: 0.0,
        },
        allowed: vec![1.0; PER_CYCLE],
        mean_noise: 0.0,
        independence: 1.0,
        growth: 0.0,
        noise_freedom: f64::INFINITY,
        frequency: d.frequency,
        weight: 1.0,
    }
}

/// Returns the sines that the rig can run, with all side forces that matter for the rivals.
fn designs(rivals: &[Rival], rig: &Rig, advice: &Advice) -> Vec<Design> {
    let zero = [0.0];
    let side_matters = rivals.iter().any(|r| r.effect == element!("side_force_friction").name());
    let sides = if side_matters && !rig.side_forces.is_empty() { &rig.side_forces[..] } else { &zero };
    let mut designs = Vec::new();
    let middle = 0.5 * (rig.reach.0 + rig.reach.1);
    let span = 0.5 * (rig.reach.1 - rig.reach.0);
    for amplitude in AMPLITUDES.into_iter().filter(|a| *a <= 1.01 * span) {
        for frequency in FREQUENCIES.into_iter().filter(|f| *f <= 1.02 * advice.frequency_hz) {
            if TAU * amplitude * frequency > 1.05 * rig.speed || TAU * amplitude * frequency < 2e-5 {
                continue;
            }
            let room = span - amplitude;
            let means: &[f64] = if room > 0.2 * span { &[0.0, -1.0, 1.0] } else { &[0.0] };
            for mean in means {
                for side_force in sides {
                    let sine = advice.frame.restrict_sine(RigSine {
                        amplitude_m: amplitude,
                        frequency_hz: frequency,
                        mean_m: middle + mean * room,
                    });
                    designs.push(Design {
                        amplitude: sine.amplitude_m,
                        frequency: sine.frequency_hz,
                        mean: sine.mean_m,
                        side_force: *side_force,
                    });
                }
            }
        }
    }
    designs
}

/// How well a test distinguishes two rivals.
struct Separation {
    /// Squared difference of the forces over the noise, weighted with the probabilities of the rivals.
    utility: f64,
    /// Root mean square difference of the forces, N.
    difference: f64,
    /// Indices of the two rivals that the test distinguishes best.
    pair: [usize; 2],
    design: Design,
}

/// Rivals with their models, and the rig on which tests are simulated.
struct Simulation<'a> {
    rivals: &'a [Rival<'a>],
    models: Vec<Model>,
    rig: &'a Rig,
    scale: Scale,
}

impl Simulation<'_> {
    /// Simulates a test with all rivals. Returns `None` if a force is not finite, or too large for the rig.
    fn separate(&self, design: &Design) -> Option<Separation> {
        let rivals = self.rivals;
        let test = [sine(design)];
        let with_models = rivals.iter().zip(&self.models);
        let forces: Vec<Vec<f64>> =
            with_models.map(|(r, model)| r.hypothesis.forces_with(model, &test[0], r.theta)).collect();
        let is_safe = |force: &f64| force.is_finite() && force.abs() <= BEYOND * self.rig.force;
        if !forces.iter().flatten().all(is_safe) {
            return None;
        }
        let rms = |f: &mut dyn Iterator<Item = f64>| (f.map(|x| x * x).sum::<f64>() / PER_CYCLE as f64).sqrt();
        let size = rms(&mut forces[0].iter().copied());
        let noise = NOISE.0 * size + NOISE.1 * self.scale.force();
        let mut best = Separation { utility: 0.0, difference: 0.0, pair: [0, 1], design: *design };
        for i in 0..rivals.len() {
            for j in i + 1..rivals.len() {
                let difference = rms(&mut forces[i].iter().zip(&forces[j]).map(|(a, b)| a - b));
                let utility =
                    rivals[i].confidence.max(0.05) * rivals[j].confidence.max(0.05) * (difference / noise).powi(2);
                if utility > best.utility {
                    best = Separation { utility, difference, pair: [i, j], ..best };
                }
            }
        }
        Some(best)
    }
}

impl Separation {
    /// Describes the test, with displacements in the direction and with the zero of the campaign's files.
    fn describe(&self, rivals: &[Rival], advice: &Advice) -> NextTest {
        let (design, frame) = (&self.design, &advice.frame);
        let [a, b] = self.pair.map(|k| rivals[k].effect);
        let (amplitude_m, frequency_hz) = (design.amplitude, design.frequency);
        let sine = frame.count(RigSine { amplitude_m, frequency_hz, mean_m: design.mean });
        let unit = frame.unit;
        let about = (sine.mean_m.abs() > 1e-4).then(|| {
            Sentence::from(phrases::ABOUT_MEAN).with("mean", advice.position(design.mean)).with("unit", unit.name())
        });
        let under = (design.side_force > 0.0)
            .then(|| Sentence::from(phrases::UNDER_SIDE_FORCE).with("force", format!("{:.0}", design.side_force)));
        NextTest {
            text: Sentence::from(phrases::RUN_SINE)
                .with("amplitude", short(sine.amplitude_m / unit.to_si(1.0)))
                .with("unit", unit.name())
                .with("frequency", short(sine.frequency_hz))
                .with_any("about", about)
                .with_any("under", under)
                .with("a", a)
                .with("b", b)
                .with("difference", newtons(self.difference, 1)),
            amplitude_m: Some(sine.amplitude_m),
            frequency_hz: Some(sine.frequency_hz),
            mean_displacement_m: Some(sine.mean_m),
            side_force_n: Some(design.side_force),
            difference_n: Some(self.difference),
            separates: vec![a, b],
        }
    }
}

/// Proposes the tests that best distinguish the rivals, the most informative first. The displacements in the result
/// have the direction and the zero of the campaign's files.
///
/// For a single rival, or if no sine distinguishes the rivals, the result names the test that shows each effect best.
pub fn propose(rivals: &[Rival], rig: &Rig, advice: &Advice) -> Vec<NextTest> {
    if rivals.len() < 2 {
        return rivals.iter().map(|r| in_words(r.effect, advice)).collect();
    }
    let models: Option<Vec<_>> = rivals.iter().map(|r| r.hypothesis.model_by(Accuracy::Single, r.theta)).collect();
    let Some(models) = models else { return Vec::new() };
    let simulation = Simulation { rivals, models, rig, scale: Scale::from_params(&rivals[0].hypothesis.base) };
    let designs = designs(rivals, rig, advice);
    let mut separations: Vec<Separation> =
        designs.par_iter().filter_map(|design| simulation.separate(design)).collect();
    separations.sort_by(|a, b| b.utility.total_cmp(&a.utility));
    // Sines that are neighbors in the grid of amplitudes and frequencies are redundant, so only one test of each
    // amplitude is proposed.
    let mut proposed: Vec<NextTest> = Vec::new();
    let mut amplitudes = Vec::new();
    for separation in separations {
        let amplitude = separation.design.amplitude;
        if amplitudes.contains(&amplitude) || separation.difference <= 0.0 {
            continue;
        }
        amplitudes.push(amplitude);
        proposed.push(separation.describe(rivals, advice));
        if proposed.len() == TOLD {
            break;
        }
    }
    if proposed.is_empty() {
        proposed.extend(rivals.iter().take(2).map(|r| in_words(r.effect, advice)));
    }
    proposed
}

/// Formats a number with up to four decimals.
fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Describes the test that shows one effect best.
pub fn in_words(effect: &'static str, advice: &Advice) -> NextTest {
    NextTest {
        text: Sentence::from(phrases::SHOWS_BEST)
            .with("effect", effect)
            .with_sentence("remedy", remedy(effect, advice)),
        amplitude_m: None,
        frequency_hz: None,
        mean_displacement_m: None,
        side_force_n: None,
        difference_n: None,
        separates: vec![effect],
    }
}

impl Rig {
    /// Infers the limits of the rig from the tests of the campaign.
    pub fn from_tests(tests: &[Test]) -> Rig {
        let mut rig =
            Rig { reach: (f64::INFINITY, f64::NEG_INFINITY), speed: 0.0, side_forces: Vec::new(), force: 0.0 };
        for test in tests {
            rig.force = rig.force.max(test.segment.top);
        }
        for input in tests.iter().flat_map(|t| t.inputs()) {
            if let Some(x) = input.displacement {
                rig.reach = (rig.reach.0.min(x), rig.reach.1.max(x));
            }
            rig.speed = rig.speed.max(input.velocity.abs());
            let side = (input.side_force / 50.0).round() * 50.0;
            if !rig.side_forces.contains(&side) {
                rig.side_forces.push(side);
            }
        }
        rig.side_forces.sort_by(f64::total_cmp);
        let (first, last) = (rig.side_forces.first().copied(), rig.side_forces.last().copied());
        rig.side_forces = first.into_iter().chain(last.filter(|_| first != last)).collect();
        rig
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::{Params, number};
    use dashpot_estimation::prior_set::PriorSet;
    use dashpot_records::{RigFrame, Unit};

    fn hypothesis(change: impl Fn(&mut Params)) -> Hypothesis {
        let mut base = Params::new();
        change(&mut base);
        Hypothesis { base, numbers: Vec::new(), heating: None, priors: PriorSet::default() }
    }

    #[test]
    fn proposals_are_stated_as_the_files_count() {
        let plain = hypothesis(|_| ());
        // A nonlinear spring has its largest effect at one end of the stroke.
        let sprung = hypothesis(|p| p.set(number!("spring_cubic"), 5e6).unwrap());
        let rival = |effect, hypothesis| Rival { effect, hypothesis, theta: &[], confidence: 0.5 };
        let rivals = [rival("presliding_friction", &plain), rival("parallel_spring", &sprung)];
        let reach = (-0.02, 0.05);
        let rig = Rig { reach, speed: 0.5, side_forces: vec![0.0], force: 20e3 };
        let inside = RigFrame { reach_m: reach, speed_m_s: 0.5, ..RigFrame::default() };
        let files = RigFrame { turn: -1.0, zero_m: 0.1, unit: Unit::Inch, ..inside };
        let of = |frame| Advice { frame, frequency_hz: 2.0, ..Advice::default() };
        let (own, counted) = (propose(&rivals, &rig, &of(inside)), propose(&rivals, &rig, &of(files)));
        assert!(!own.is_empty() && own.len() == counted.len());
        for (own, counted) in own.iter().zip(&counted) {
            let mean = own.mean_displacement_m.unwrap();
            let (amplitude, frequency) = (own.amplitude_m.unwrap(), own.frequency_hz.unwrap());
            assert!(mean - amplitude > reach.0 - 1e-3 && mean + amplitude < reach.1 + 1e-3, "{own:?}");
            assert!(TAU * amplitude * frequency < 0.51 && frequency <= 2.04, "{own:?}");
            assert!((counted.mean_displacement_m.unwrap() - (0.1 - mean)).abs() < 1e-12, "{counted:?}");
            let text = counted.text.to_string();
            let about = format!(" about {:+.2} in as the files count", (0.1 - mean) / 0.0254);
            assert!(text.contains(&about) && text.contains(" in at "), "{text}");
            assert!(own.text.to_string().contains(" mm at "), "{}", own.text);
        }
    }
}
