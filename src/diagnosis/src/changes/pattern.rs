//! How the FV curve moved as a whole: by one force against the motion, as dry friction makes, or by one share of the force of a side.

use super::super::phrases;
use super::CHANGED;
use dashpot_records::Sentence;
use serde::Serialize;

/// A point of the FV curve on both dampers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    /// m/s, rebound positive.
    pub velocity: f64,
    /// On the reference damper, N.
    pub before: f64,
    /// On this one.
    pub after: f64,
    /// Standard deviation of the difference.
    pub deviation: f64,
}

impl Point {
    /// Whether it is another by more than both dampers leave open.
    pub fn has_moved(&self) -> bool {
        (self.after - self.before).abs() > CHANGED * self.deviation
    }
}

/// What all points of the curve moved by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum MovedBy {
    /// One force against the motion, N, on both sides alike.
    DryForce,
    /// One share of the force of the reference damper.
    Share,
}

/// How all points of the FV curve moved that the tests reach.
#[derive(Debug, Clone, Serialize)]
pub struct CurveMoved {
    /// What is alike at all of them.
    pub by: MovedBy,
    /// `rebound`, `compression` or `both`.
    pub side: &'static str,
    /// Mean over the points: N, or a share, negative where force was lost.
    pub value: f64,
    /// Least of the points.
    pub low: f64,
    /// Most of them.
    pub high: f64,
    /// Speeds that they span, m/s.
    pub speed_m_s: [f64; 2],
}

/// By how much a point may miss what is alike at all of them, as a share of that, beside three of its deviations. The FV curve is drawn through a
/// dozen points and friction sets in over a few mm/s: half of this told no pattern where 25 N of friction had been added.
const ALIKE: f64 = 0.2;
/// Fewer points than this on a side tell no pattern.
const POINTS: usize = 4;
/// Speeds of a side have to span this factor.
const SPAN: f64 = 10.0;
/// m/s: a force that is there at lower speeds already is none of a valve that opens later, whose bleed alone flows then (knees of shim valves lie at
/// 0.03 to 0.2 m/s).
const BELOW_THE_KNEE: f64 = 0.02;

/// What is alike at all points, given what each of them says of it and how well.
fn alike(points: &[Point], of: impl Fn(&Point) -> (f64, f64)) -> Option<[f64; 3]> {
    let speeds = points.iter().map(|p| p.velocity.abs());
    let (slow, fast) = speeds.fold((f64::INFINITY, 0.0f64), |(slow, fast), v| (slow.min(v), fast.max(v)));
    if points.len() < POINTS || fast < SPAN * slow {
        return None;
    }
    let values: Vec<(f64, f64)> = points.iter().map(of).collect();
    let mean = values.iter().map(|(value, _)| value).sum::<f64>() / values.len() as f64;
    let fits = |(value, deviation): &(f64, f64)| (value - mean).abs() <= CHANGED * deviation + ALIKE * mean.abs();
    // Where all of it lies within the deviations nothing is known to have moved.
    let is_there = values.iter().filter(|(value, deviation)| value.abs() > CHANGED * deviation).count();
    let low = values.iter().map(|(value, _)| *value).fold(f64::INFINITY, f64::min);
    let high = values.iter().map(|(value, _)| *value).fold(f64::NEG_INFINITY, f64::max);
    (values.iter().all(fits) && 2 * is_there > values.len()).then_some([mean, low, high])
}

/// One force against the motion at every point of a side.
fn dry_force(points: &[Point]) -> Option<[f64; 3]> {
    alike(points, |p| (p.velocity.signum() * (p.after - p.before), p.deviation))
}

/// One share of the force at every point of a side.
fn share(points: &[Point]) -> Option<[f64; 3]> {
    alike(points, |p| ((p.after - p.before) / p.before, p.deviation / p.before.abs()))
}

/// How the points in rebound and those in compression moved. A side of which one force and one share say the same, as that of a level curve, has no
/// pattern.
pub(super) fn of(sides: &[Vec<Point>; 2]) -> Vec<CurveMoved> {
    let speeds = |points: &mut dyn Iterator<Item = &Point>| {
        points.map(|p| p.velocity.abs()).fold([f64::INFINITY, 0.0f64], |[slow, fast], v| [slow.min(v), fast.max(v)])
    };
    if let [Some(rebound), Some(compression)] = sides.each_ref().map(|points| dry_force(points)) {
        let value = 0.5 * (rebound[0] + compression[0]);
        let deviation = sides.iter().flatten().map(|p| p.deviation).fold(0.0, f64::max);
        let is_even = (rebound[0] - compression[0]).abs() <= CHANGED * deviation + ALIKE * value.abs();
        let speed_m_s = speeds(&mut sides.iter().flatten());
        let is_level = sides.iter().all(|points| share(points).is_some());
        if is_even && !is_level && speed_m_s[0] <= BELOW_THE_KNEE {
            let (low, high) = (rebound[1].min(compression[1]), rebound[2].max(compression[2]));
            return vec![CurveMoved { by: MovedBy::DryForce, side: "both", value, low, high, speed_m_s }];
        }
    }
    let of_side = |(points, side): (&Vec<Point>, &'static str)| {
        let [value, low, high] = share(points)?;
        let speed_m_s = speeds(&mut points.iter());
        dry_force(points).is_none().then_some(CurveMoved { by: MovedBy::Share, side, value, low, high, speed_m_s })
    };
    sides.iter().zip(["rebound", "compression"]).filter_map(of_side).collect()
}

impl CurveMoved {
    /// Whether it says how the curve moved on the side of a velocity.
    pub(super) fn is_of(&self, velocity: f64) -> bool {
        match self.side {
            "rebound" => velocity > 0.0,
            "compression" => velocity < 0.0,
            _ => true,
        }
    }

    /// In words: by itself where it stands for both sides, else as an aside to the point that moved most.
    pub(super) fn sentence(&self) -> Sentence {
        let more = self.value > 0.0;
        let said = match (self.by, more) {
            (MovedBy::DryForce, true) => phrases::MORE_DRY_FORCE,
            (MovedBy::DryForce, false) => phrases::LESS_DRY_FORCE,
            (MovedBy::Share, true) => phrases::MORE_EVERYWHERE,
            (MovedBy::Share, false) => phrases::LESS_EVERYWHERE,
        };
        let size = self.value.abs();
        match self.by {
            MovedBy::DryForce => Sentence::from(said)
                .with("force", format!("{size:.0}"))
                .with("slow", format!("{:.3}", self.speed_m_s[0]))
                .with("fast", format!("{:.2}", self.speed_m_s[1])),
            MovedBy::Share => Sentence::from(said).with("percent", format!("{:.0}", 100.0 * size)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEEDS: [f64; 8] = [0.003, 0.01, 0.03, 0.08, 0.13, 0.25, 0.6, 1.0];

    /// A digressive curve, moved.
    fn moved(side: f64, by: impl Fn(f64, f64) -> f64, speeds: &[f64]) -> Vec<Point> {
        let point = |v: &f64| {
            let force = 1000.0 * v / (v + 0.1) + 400.0 * v;
            Point { velocity: side * v, before: side * force, after: side * (force + by(*v, force)), deviation: 1.0 }
        };
        speeds.iter().map(point).collect()
    }

    fn both(by: impl Fn(f64, f64) -> f64 + Copy) -> Vec<CurveMoved> {
        of(&[moved(1.0, by, &SPEEDS), moved(-1.0, by, &SPEEDS)])
    }

    #[test]
    fn friction_is_one_force_on_both_sides_and_at_every_speed() {
        for force in [25.0, -12.0] {
            let found = both(|_, _| force);
            assert_eq!(found.len(), 1, "{found:?}");
            assert!(found[0].by == MovedBy::DryForce && (found[0].value - force).abs() < 1e-9, "{found:?}");
        }
        // On one side alone it is none, nor where the valve opens later and its bleed flows as before, nor where no slow test shows that it does.
        let none = |v: f64, _: f64| if v > 0.05 { 25.0 } else { 0.0 };
        assert!(of(&[moved(1.0, |_, _| 25.0, &SPEEDS), moved(-1.0, |_, _| 0.0, &SPEEDS)]).is_empty());
        assert!(both(none).is_empty());
        assert!(of(&[moved(1.0, |_, _| 25.0, &SPEEDS[2..]), moved(-1.0, |_, _| 25.0, &SPEEDS[2..])]).is_empty());
    }

    #[test]
    fn a_valve_that_lost_a_fifth_lost_it_at_every_speed_and_a_wider_bleed_did_not() {
        let found = of(&[moved(1.0, |_, f| -0.2 * f, &SPEEDS), moved(-1.0, |_, _| 0.0, &SPEEDS)]);
        assert_eq!(found.iter().map(|m| (m.side, m.by)).collect::<Vec<_>>(), [("rebound", MovedBy::Share)]);
        assert!((found[0].value + 0.2).abs() < 1e-9);
        assert!(both(|v, f| -0.3 * f * (-v / 0.08).exp()).is_empty());
        assert!(both(|_, _| 0.5).is_empty(), "within what is left open");
    }
}
