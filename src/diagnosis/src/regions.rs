//! Regions where model and records disagree: combinations of direction, speed and acceleration with a residual above
//! the noise.

use super::outcome::Region;
use super::phrases;
use dashpot_estimation::samples::Test;
use dashpot_messages::Sentence;
use dashpot_records::newtons::newtons;

/// Bounds of the speed bands, m/s.
const SPEEDS: [f64; 7] = [0.0, 0.05, 0.15, 0.3, 0.6, 1.2, f64::INFINITY];
/// Largest number of reported regions.
const TOLD: usize = 12;
/// Smallest ratio of the root mean square residual to the noise at which a region is reported.
const STANDS_OUT: f64 = 1.5;
/// Smallest number of samples for which a region is evaluated.
const FEWEST: usize = 5;

struct Cell {
    direction: f64,
    band: usize,
    rising: bool,
}

/// Finds the regions where model and records disagree, worst first. `residual` is measured minus computed force, N, of
/// every scored sample of each test.
pub fn regions(tests: &[Test], residual: &[Vec<f64>]) -> Vec<Region> {
    let mut all = Vec::new();
    for (which, name) in std::iter::once((None, "all".to_owned()))
        .chain(tests.iter().enumerate().map(|(k, t)| (Some(k), t.segment.name.clone())))
    {
        for direction in [1.0, -1.0] {
            for band in 0..SPEEDS.len() - 1 {
                let mut halves = [true, false]
                    .map(|rising| region(tests, residual, which, &name, &Cell { direction, band, rising }));
                // If the mean errors while speeding up and slowing down differ by less than half of the larger error,
                // both form one region.
                if let [Some(up), Some(down)] = &mut halves
                    && (up.mean_n - down.mean_n).abs() < 0.5 * up.mean_n.abs().max(down.mean_n.abs())
                {
                    all.push(joined(up, down));
                    continue;
                }
                all.extend(halves.into_iter().flatten());
            }
        }
    }
    all.retain(|r| r.rmse_n > STANDS_OUT * r.noise_n);
    // Regions are ordered by the ratio of residual to noise. The ratio of a region of all tests counts ten times, so
    // that it precedes most regions of single tests.
    let weight = |r: &Region| (r.rmse_n / r.noise_n.max(1e-9)) * if r.test == "all" { 10.0 } else { 1.0 };
    all.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
    all.truncate(TOLD);
    all
}

fn region(tests: &[Test], residual: &[Vec<f64>], which: Option<usize>, name: &str, cell: &Cell) -> Option<Region> {
    let (mut sum, mut square, mut noise, mut count) = (0.0, 0.0, 0.0, 0usize);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut fast = 0.0f64;
    for (k, test) in tests.iter().enumerate().filter(|(k, _)| which.is_none_or(|w| w == *k)) {
        let inputs = test.inputs();
        let n = inputs.len();
        for i in 0..n {
            let v = inputs[i].velocity;
            let speed = v.abs();
            let before = inputs[if i == 0 { n - 1 } else { i - 1 }].velocity.abs();
            let after = inputs[if i + 1 == n { 0 } else { i + 1 }].velocity.abs();
            if v * cell.direction <= 0.0
                || !(SPEEDS[cell.band]..SPEEDS[cell.band + 1]).contains(&speed)
                || (after >= before) != cell.rising
            {
                continue;
            }
            let r = residual[k][i];
            sum += r;
            square += r * r;
            noise += test.mean_noise * test.mean_noise;
            count += 1;
            fast = fast.max(speed);
            if let Some(x) = inputs[i].displacement {
                (low, high) = (low.min(x), high.max(x));
            }
        }
    }
    if count < FEWEST {
        return None;
    }
    let n = count as f64;
    let top = if SPEEDS[cell.band + 1].is_finite() { SPEEDS[cell.band + 1] } else { fast };
    let velocity = if cell.direction > 0.0 { [SPEEDS[cell.band], top] } else { [-top, -SPEEDS[cell.band]] };
    let mut region = Region {
        test: name.to_owned(),
        velocity_m_s: velocity,
        displacement_m: [low, high],
        direction: if cell.direction > 0.0 { "rebound" } else { "compression" },
        acceleration: if cell.rising { "speeding_up" } else { "slowing_down" },
        rmse_n: (square / n).sqrt(),
        mean_n: sum / n,
        noise_n: (noise / n).sqrt(),
        text: Sentence::default(),
    };
    region.text = words(&region, ((square / n - (sum / n).powi(2)).max(0.0) / n).sqrt());
    Some(region)
}

fn joined(a: &Region, b: &Region) -> Region {
    let mut both = Region {
        displacement_m: [a.displacement_m[0].min(b.displacement_m[0]), a.displacement_m[1].max(b.displacement_m[1])],
        acceleration: "both",
        rmse_n: (0.5 * (a.rmse_n.powi(2) + b.rmse_n.powi(2))).sqrt(),
        mean_n: 0.5 * (a.mean_n + b.mean_n),
        noise_n: (0.5 * (a.noise_n.powi(2) + b.noise_n.powi(2))).sqrt(),
        ..a.clone()
    };
    both.text = words(&both, 0.5 * (a.mean_n - b.mean_n).abs());
    both
}

fn words(r: &Region, error: f64) -> Sentence {
    let (slow, fast) =
        (r.velocity_m_s[0].abs().min(r.velocity_m_s[1].abs()), r.velocity_m_s[0].abs().max(r.velocity_m_s[1].abs()));
    let direction = if r.direction == "rebound" { phrases::REBOUND } else { phrases::COMPRESSION };
    let phase = match r.acceleration {
        "speeding_up" => Some(phrases::SPEEDING_UP.into()),
        "slowing_down" => Some(phrases::SLOWING_DOWN.into()),
        _ => None,
    };
    let place = if r.test == "all" {
        phrases::IN_ALL_TESTS.into()
    } else {
        Sentence::from(phrases::IN_TEST).with("test", &r.test)
    };
    let tenths = |newton: f64| newtons(newton, 1);
    let missing = if r.mean_n.abs() > 0.5 * r.rmse_n {
        let sense = if r.mean_n > 0.0 { phrases::MORE_TENSILE } else { phrases::MORE_COMPRESSIVE };
        Sentence::from(sense).with("mean", tenths(r.mean_n.abs())).with("error", tenths(error))
    } else {
        phrases::OFF_BOTH_WAYS.into()
    };
    Sentence::from(phrases::REGION)
        .with_sentence("direction", direction)
        .with("slow", format!("{:.0}", 1e3 * slow))
        .with("fast", format!("{:.0}", 1e3 * fast))
        .with_any("phase", phase)
        .with_sentence("place", place)
        .with_sentence("missing", missing)
        .with("rms", tenths(r.rmse_n))
        .with("noise", tenths(r.noise_n))
}
