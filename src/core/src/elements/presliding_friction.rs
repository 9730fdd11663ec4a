//! Presliding friction: contacts that bend before they slide (Dahl; effect of seal lip and guide after every reversal).

use crate::dual::{Dual, Real};
use crate::element::{Memory, Motion, Prepare, Recall, Share};
use crate::fault::Fault;
use crate::input::Path;
use crate::math::power;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// F = F_c z/z_0, dz/dt = v − |v|_c (z/z_0) |z/z_0|^(n−1): the force turns over within a few z_0 of travel, whatever the speed.
/// n = 1 is Dahl's contact, which slips from the first; a larger n bends elastically first. Where the return is elastic a
/// bent contact does not slip while it is unbent (Bouc and Wen with β = γ). |v|_c = √(v² + v_c²): below the speed v_c the
/// contact creeps, and the friction of a long slow motion is less than F_c.
#[derive(Clone, Copy, Debug)]
pub struct PreslidingFriction {
    /// F_c/z_0.
    stiffness: f64,
    /// z_0.
    length: f64,
    /// 1/z_0.
    per_length: f64,
    /// n − 1.
    power: f64,
    returns_elastically: bool,
    /// v_c².
    creep_squared: f64,
}

impl Describe for PreslidingFriction {
    const MEANING: &'static str = "friction that turns over within a short travel after each reversal (Dahl)";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("presliding_force", "N", &[40.0], (0.0, 1e4), "friction level after long travel, F_c"),
        Parameter::scalar(
            "presliding_length",
            "m",
            &[3e-4],
            (1e-5, 5e-3),
            "travel in which the force approaches its level by a factor e, z_0",
        ),
        Parameter::scalar(
            "presliding_power",
            "-",
            &[1.0],
            (1.0, 10.0),
            "1: slips from the first (Dahl); larger: bends elastically before it slips, n",
        ),
        Parameter::choice(
            "presliding_return",
            &["slips", "elastic"],
            "after a reversal a bent contact slips at once, or first springs back",
        ),
        Parameter::scalar("presliding_creep", "m/s", &[1e-9], (1e-9, 0.1), "speed below which the contact creeps, v_c"),
    ];
}

impl Prepare for PreslidingFriction {
    const OFF: Self = PreslidingFriction {
        stiffness: 0.0,
        length: 1.0,
        per_length: 1.0,
        power: 0.0,
        returns_elastically: false,
        creep_squared: 0.0,
    };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let length = p.number(own!("presliding_length"));
        Ok(PreslidingFriction {
            stiffness: p.number(own!("presliding_force")) / length,
            length,
            per_length: 1.0 / length,
            power: p.number(own!("presliding_power")) - 1.0,
            returns_elastically: p.number(own!("presliding_return")) == 1.0,
            creep_squared: p.number(own!("presliding_creep")) * p.number(own!("presliding_creep")),
        })
    }
}

/// Steps of the contact inside one stretch of travel where its law has no closed form.
const PARTS: usize = 4;
/// Speed, as a share of the creep, above which creep is nothing: it shortens the travel by half the square of this.
const FAST: f64 = 1e6;

impl PreslidingFriction {
    /// dζ/dσ = r − ζ|ζ|^(n−1) over the slip σ, in units of z_0: where ζ ends. It never crosses the value it is drawn to, so a
    /// contact is never bent further than its law allows, however long the slip.
    #[inline(never)]
    fn bends<R: Real>(&self, bent: R, r: R, slip: R) -> R {
        let (mut bent, mut slip) = (bent, slip);
        if self.returns_elastically && bent.value() * r.value() < 0.0 {
            let unbent = bent + r * slip;
            if unbent.value() * bent.value() >= 0.0 {
                return unbent;
            }
            // What is left of the slip once the contact is straight.
            (slip, bent) = (unbent * r.inverse(), R::constant(0.0));
        }
        if self.power == 0.0 {
            return r + (bent - r) * (-slip).exp();
        }
        let level = {
            let size = r.value().abs();
            let level = power(size, 1.0 / (1.0 + self.power));
            let slope = if size > 0.0 { level / (size * (1.0 + self.power)) } else { 0.0 };
            r.chain(level.copysign(r.value()), slope)
        };
        let part = slip * (1.0 / PARTS as f64);
        let below = bent.value() < level.value();
        for _ in 0..PARTS {
            let size = bent.abs();
            let at = size.value();
            let raised = if at > 0.0 { power(at, self.power) } else { 0.0 };
            let raised_slope = if at > 0.0 { self.power * raised / at } else { 0.0 };
            let raised = size.chain(raised, raised_slope);
            let falls = raised * (1.0 + self.power);
            // (1 − e^−J h)/J h: what of the slip counts.
            let through = falls * part;
            let share = if through.value() > 1e-4 {
                (-(-through).exp()).plus(1.0) * through.inverse()
            } else {
                (-(through * 0.5)).plus(1.0)
            };
            bent = bent + (r - bent * raised) * part * share;
            if (bent.value() < level.value()) != below {
                return level;
            }
        }
        bent
    }

    /// A stretch of the path in one direction, from one fraction of the step to another.
    #[inline(never)]
    fn along<R: Real>(&self, path: &Path, velocity: &[R; 3], bent: R, [from, to]: [R; 2]) -> R {
        let moved = (path.place(velocity, to) - path.place(velocity, from)) * self.per_length;
        let [p0, p1, p2] = *velocity;
        let speed = |theta: R| p0 + (p1 + p2 * theta) * theta;
        let (first, middle, last) = (speed(from), speed((from + to) * 0.5), speed(to));
        let fastest = first.value().abs().max(middle.value().abs()).max(last.value().abs());
        if fastest * fastest > FAST * FAST * self.creep_squared {
            let r = if moved.value() < 0.0 { -1.0 } else { 1.0 };
            return self.bends(bent, R::constant(r), moved.abs());
        }
        // By Simpson's rule.
        let creeps = |v: R| (v * v).plus(self.creep_squared).sqrt();
        let sum = creeps(first) + creeps(middle) * 4.0 + creeps(last);
        let slip = sum * ((to - from) * (path.length() * self.per_length / 6.0));
        if slip.value() < moved.value().abs() || slip.value() < f64::MIN_POSITIVE {
            let r = if moved.value() < 0.0 { -1.0 } else { 1.0 };
            return self.bends(bent, R::constant(r), moved.abs());
        }
        self.bends(bent, moved * slip.inverse(), slip)
    }

    /// ζ after the step: stretch by stretch between the turns of the driven end.
    #[inline(never)]
    fn after<R: Real>(&self, path: &Path, x1: R, v1: R, bent: f64) -> R {
        let velocity = path.velocity(x1, v1);
        let [p0, p1, p2] = velocity;
        let (none, all) = (R::constant(0.0), R::constant(1.0));
        // Where p_0 + p_1 θ + p_2 θ² changes its sign, without cancellation.
        let half = p1 * -0.5;
        let square = half * half - p0 * p2;
        let mut turns = [none; 2];
        // Below this the motion is nothing, and slopes of its roots would overflow.
        if square.value() > 1e-200 {
            let root = square.sqrt();
            let q = if half.value() < 0.0 { half - root } else { half + root };
            let of = |top: R, bottom: R| {
                let inside = bottom.value() != 0.0 && {
                    let theta = top.value() / bottom.value();
                    theta > 0.0 && theta < 1.0
                };
                if inside { top * bottom.inverse() } else { none }
            };
            turns = [of(p0, q), of(q, p2)];
            if turns[0].value() > turns[1].value() {
                turns.swap(0, 1);
            }
        }
        let mut bent = R::constant(bent);
        let mut from = none;
        for to in [turns[0], turns[1], all] {
            if to.value() > from.value() {
                bent = self.along(path, &velocity, bent, [from, to]);
                from = to;
            }
        }
        bent
    }
}

impl Memory for PreslidingFriction {
    fn share(&self) -> Share {
        Share::Friction
    }

    fn recall(&self, at: &Motion, z: f64) -> Recall {
        let v = at.velocity;
        let bent = z * self.per_length;
        let speed = libm::sqrt(v * v + self.creep_squared);
        let sign = if v == 0.0 { 0.0 } else { v / speed };
        let (mut slips, mut slips_by_bent) = (bent, 1.0);
        if self.returns_elastically && v * z < 0.0 {
            (slips, slips_by_bent) = (0.0, 0.0);
        } else if self.power > 0.0 {
            let size = bent.abs();
            let raised = if size > 0.0 { power(size, self.power) } else { 0.0 };
            (slips, slips_by_bent) = (bent * raised, (1.0 + self.power) * raised);
        }
        Recall {
            force: self.stiffness * z,
            by_memory: self.stiffness,
            rate: v - speed * slips,
            rate_by_v: 1.0 - sign * slips,
            rate_by_memory: -speed * slips_by_bent * self.per_length,
            ..Recall::NONE
        }
    }

    /// In travel instead of time the contact has a law of its own state alone, so the path inside the step does not matter but for
    /// its turns: for n = 1 the answer is exact.
    fn carried(&self, path: &Path, z: f64, slopes: bool) -> Option<(f64, [f64; 2])> {
        let (x1, v1) = path.end();
        let bent = z * self.per_length;
        if !slopes {
            return Some((self.after(path, x1, v1, bent) * self.length, [0.0; 2]));
        }
        let after = self.after(path, Dual::<2>::along(x1, 0), Dual::along(v1, 1), bent);
        Some((after.value * self.length, after.slopes.map(|s| s * self.length)))
    }

    /// At rest every bend stays; before any motion there is none.
    fn settled(&self, at: &Motion) -> f64 {
        if at.velocity == 0.0 {
            return 0.0;
        }
        let share = at.velocity.abs() / libm::sqrt(at.velocity * at.velocity + self.creep_squared);
        (self.length * power(share, 1.0 / (1.0 + self.power))).copysign(at.velocity)
    }

    /// At rest the bend is what the way there left.
    fn held(&self, from: f64, z: f64, at: &Motion) -> f64 {
        if !self.keeps(at) {
            return self.settled(at);
        }
        let moved = (at.displacement - from) * self.per_length;
        if moved == 0.0 { z } else { self.length * self.bends(z * self.per_length, moved.signum(), moved.abs()) }
    }

    fn keeps(&self, at: &Motion) -> bool {
        at.velocity == 0.0
    }
}
