//! Presliding friction: contacts that deflect before they slide (Dahl), as seal lip and rod guide do after every
//! reversal.

use crate::dual::{Dual, Real};
use crate::element::{EndState, ForceComponent, OperatingPoint, Prepare, Response, StateResponse, StatefulForce};
use crate::fault::Fault;
use crate::input::{Path, Travel};
use crate::math::{max, min, power};
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Presliding friction with the force F = F_c z/z_0, N, where dz/dt = v − |v|_c (z/z_0) |z/z_0|^(n−1).
///
/// z is the deflection of the contact, m, and v the sliding velocity, m/s. F_c is the friction level after long travel,
/// and z_0 the deflection that belongs to it. In this file, ζ is the relative deflection z/z_0. The force reverses
/// within a displacement of a few z_0 at any velocity. With n = 1 (Dahl) the contact slips from the start; with a
/// larger n it first deflects elastically. With an elastic return, a deflected contact does not slip during unloading
/// (Bouc and Wen with β = γ). |v|_c = √(v² + v_c²). Below the velocity v_c the contact creeps, and the friction of a
/// long slow motion is less than F_c.
#[derive(Clone, Copy, Debug)]
pub struct PreslidingFriction {
    /// Stiffness of the contact, F_c/z_0, N/m: friction level over the deflection that belongs to it.
    stiffness: f64,
    /// Deflection z_0 of the contact at the full friction level, m.
    length: f64,
    /// One over the deflection z_0 at the full friction level, 1/m.
    per_length: f64,
    /// Exponent n of the law of the contact, minus 1.
    power: f64,
    returns_elastically: bool,
    /// Square of the creep velocity v_c, m²/s².
    creep_squared: f64,
}

impl Describe for PreslidingFriction {
    const MEANING: &'static str =
        "presliding friction (Dahl): friction that changes sign over a short travel after each reversal";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("presliding_force", "N", &[40.0], (0.0, 1e4), "friction force after long travel, F_c"),
        Parameter::scalar(
            "presliding_length",
            "m",
            &[3e-4],
            (1e-5, 5e-3),
            "presliding displacement: travel over which the difference to F_c falls by a factor e, z_0",
        ),
        Parameter::scalar(
            "presliding_power",
            "-",
            &[1.0],
            (1.0, 10.0),
            "exponent of the slip, n; 1: slip from the start (Dahl), larger: elastic deflection before slip",
        ),
        Parameter::choice(
            "presliding_return",
            &["slips", "elastic"],
            "unloading after a reversal: with slip, or elastic",
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

/// Number of integration steps over a stretch of motion in one direction, if the law of the friction contact has no
/// closed form.
const PARTS: usize = 4;
/// Ratio of speed to creep velocity above which creep is neglected. The relative error of the slip is then half the
/// inverse square of this ratio.
const FAST: f64 = 1e6;

/// Largest relative difference between the relative deflection ζ and its steady state at which the law is linearized.
/// The relative error is about the square of this difference.
const NEAR: f64 = 1e-3;

/// Computes `size` to the power of `exponent`, for a relative deflection `size` of at least 0.
fn raised<R: Real>(size: R, exponent: f64) -> R {
    let at = size.value();
    let value = if at > 0.0 { power(at, exponent) } else { 0.0 };
    size.chain(value, if at > 0.0 { exponent * value / at } else { 0.0 })
}

/// Solves dζ/dσ = r − c ζ from the relative deflection ζ = `bent` over the slip σ = `slip`, and returns the final ζ.
/// `r` is the ratio of displacement to slip, and `decay` is c.
fn relaxed<R: Real>(bent: R, r: R, decay: R, slip: R) -> R {
    let through = decay * slip;
    // This is (1 − e^−cσ)/(cσ), with its series near 0: the effective fraction of the slip.
    let fraction = if through.value() > 1e-4 {
        (-(-through).exp()).plus(1.0) * through.inverse()
    } else {
        (-(through * 0.5)).plus(1.0)
    };
    bent + (r - bent * decay) * slip * fraction
}

impl PreslidingFriction {
    /// Solves dζ/dσ = r − ζ|ζ|^(n−1) for the relative deflection ζ = z/z_0 over the slip σ, in units of z_0, and
    /// returns the final ζ.
    ///
    /// `bent` is the initial ζ. `r` is the ratio of displacement to slip: ±1, or closer to 0 where the contact creeps.
    /// ζ never crosses its steady state, so the deflection stays bounded for any slip.
    #[inline(never)]
    fn bend<R: Real>(&self, bent: R, r: R, slip: R) -> R {
        let (mut bent, mut slip) = (bent, slip);
        if self.returns_elastically && bent.value() * r.value() < 0.0 {
            let unbent = bent + r * slip;
            if unbent.value() * bent.value() >= 0.0 {
                return unbent;
            }
            // Remaining slip after the deflection has returned to zero.
            (slip, bent) = (unbent * r.inverse(), R::constant(0.0));
        }
        if self.power == 0.0 {
            return r + (bent - r) * (-slip).exp();
        }
        let level = {
            let size = r.value().abs();
            let level = power(size, 1.0 / (1.0 + self.power));
            let derivative = if size > 0.0 { level / (size * (1.0 + self.power)) } else { 0.0 };
            r.chain(level.copysign(r.value()), derivative)
        };
        // Without displacement, the ratio r and the steady state `level` are 0, and the division by `level` below is
        // impossible.
        if level.value() != 0.0 && (bent.value() - level.value()).abs() <= NEAR * level.value().abs() {
            // Near the steady state `level`, the law is linear with a constant decay rate: n |level|^(n−1) = n r/level.
            let decay = (r * level.inverse()) * (1.0 + self.power);
            return level + (bent - level) * (-(decay * slip)).exp();
        }
        let part = slip * (1.0 / PARTS as f64);
        let below = bent.value() < level.value();
        let highest = max(bent.value().abs(), level.value().abs());
        for _ in 0..PARTS {
            // The decay rate of the relative deflection ζ is |ζ|^(n−1), evaluated in the middle of the part. With the
            // rate at the start of the part, an undeflected contact would not decay. The force would then jump between
            // n = 1, which has an exact closed form, and larger n.
            let start = bent.abs();
            let halfway = relaxed(bent, r, raised(start, self.power), part * 0.5);
            let middle = if halfway.value().abs() > highest { R::constant(highest) } else { halfway.abs() };
            bent = relaxed(bent, r, raised(middle, self.power), part);
            if (bent.value() < level.value()) != below {
                return level;
            }
        }
        bent
    }

    /// Computes the relative deflection ζ after a stretch of the path in one direction.
    ///
    /// The arguments are the initial ζ, the displacement over the stretch, m, the velocities at its start, middle and
    /// end, m/s, and its duration, s.
    #[inline(always)]
    fn along<R: Real>(&self, bent: R, moved: R, velocity: [R; 3], time: R) -> R {
        let moved = moved * self.per_length;
        let [first, middle, last] = velocity;
        let fastest = max(max(first.value().abs(), middle.value().abs()), last.value().abs());
        if fastest * fastest > FAST * FAST * self.creep_squared {
            let r = if moved.value() < 0.0 { -1.0 } else { 1.0 };
            return self.bend(bent, R::constant(r), moved.abs());
        }
        self.creeps(bent, moved, velocity, time)
    }

    /// Computes the relative deflection ζ after a stretch of the path in which creep matters; `moved` is in units of
    /// z_0.
    #[inline(never)]
    fn creeps<R: Real>(&self, bent: R, moved: R, [first, middle, last]: [R; 3], time: R) -> R {
        // The slip is the integral of the speed √(v² + v_c²) over time, by Simpson's rule.
        let creeps = |v: R| (v * v).plus(self.creep_squared).sqrt();
        let sum = creeps(first) + creeps(middle) * 4.0 + creeps(last);
        let slip = sum * (time * (self.per_length / 6.0));
        if slip.value() < moved.value().abs() || slip.value() < f64::MIN_POSITIVE {
            let r = if moved.value() < 0.0 { -1.0 } else { 1.0 };
            return self.bend(bent, R::constant(r), moved.abs());
        }
        self.bend(bent, moved * slip.inverse(), slip)
    }

    /// Computes the relative deflection ζ after the motion `travel`; `bent` is the initial ζ.
    #[inline(always)]
    fn after<R: Real>(&self, travel: &Travel<R>, bent: R) -> R {
        let Travel { moved, v0: first, v1: last, time, .. } = *travel;
        let mean = moved * (1.0 / time);
        // The velocity lies between its Bézier coefficients: both end velocities and `between`. If all three have the
        // same sign, the moving end does not reverse.
        let between = (mean * 3.0 - first - last).value();
        let (a, b, c) = (first.value(), last.value(), between);
        if min(min(a, b), c) >= 0.0 || max(max(a, b), c) <= 0.0 {
            let middle = mean * 1.5 - (first + last) * 0.25;
            return self.along(bent, moved, [first, middle, last], R::constant(time));
        }
        self.turns(travel, bent)
    }

    /// Computes the relative deflection ζ after a motion that may reverse, one stretch in one direction after the
    /// other.
    #[inline(never)]
    fn turns<R: Real>(&self, travel: &Travel<R>, bent: R) -> R {
        let velocity = travel.velocity();
        let [p0, p1, p2] = velocity;
        let speed = |theta: R| p0 + (p1 + p2 * theta) * theta;
        let (none, all) = (R::constant(0.0), R::constant(1.0));
        // Zeros of the velocity p_0 + p_1 θ + p_2 θ² over the fraction θ of the step, computed without cancellation.
        let half = p1 * -0.5;
        let square = half * half - p0 * p2;
        let mut turns = [none; 2];
        // Below this discriminant the velocity is negligible, and the derivatives of its zeros would overflow.
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
        let mut bent = bent;
        let mut from = none;
        for to in [turns[0], turns[1], all] {
            if to.value() > from.value() {
                let moved = travel.place(&velocity, to) - travel.place(&velocity, from);
                let speeds = [speed(from), speed((from + to) * 0.5), speed(to)];
                bent = self.along(bent, moved, speeds, (to - from) * travel.time);
                from = to;
            }
        }
        bent
    }
}

impl StatefulForce for PreslidingFriction {
    fn component(&self) -> ForceComponent {
        ForceComponent::Friction
    }

    fn evaluate(&self, at: &OperatingPoint, z: f64) -> StateResponse {
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
        StateResponse {
            force: self.stiffness * z,
            d_force_d_z: self.stiffness,
            rate: v - speed * slips,
            d_rate_d_v: 1.0 - sign * slips,
            d_rate_d_z: -speed * slips_by_bent * self.per_length,
            ..StateResponse::NONE
        }
    }

    /// Computes state and force at the end of the path. The result is exact if the exponent n of the law is 1 and the
    /// contact does not creep.
    ///
    /// With displacement instead of time as the variable, the law of the contact depends on its own state alone. Only
    /// the reversals of the path inside the step matter.
    fn propagate(&self, path: &Path, z: f64, derivatives: bool) -> Option<EndState> {
        let (x1, v1) = path.end();
        let bent = z * self.per_length;
        let after = if derivatives {
            self.after(&path.travel(Dual::<2>::along(x1, 0), Dual::along(v1, 1)), Dual::constant(bent))
        } else {
            Dual::constant(self.after(&path.travel(x1, v1), bent))
        };
        let Dual { value, derivatives: [by_x, by_v] } = after * self.length;
        let k = self.stiffness;
        Some(EndState {
            z: value,
            response: Response { force: k * value, d_force_d_x: k * by_x, d_force_d_v: k * by_v },
        })
    }

    fn acts_on_mass(&self) -> bool {
        true
    }

    fn propagate_on_mass(&self, _: Dual<2>, travel: &Travel<Dual<2>>, z: Dual<2>) -> [Dual<2>; 2] {
        let z = self.after(travel, z * self.per_length) * self.length;
        [z, z * self.stiffness]
    }

    /// Returns the steady deflection z, m, under a constant velocity. At rest it is 0: any deflection is an equilibrium
    /// there, but before any motion there is no deflection.
    fn equilibrium(&self, at: &OperatingPoint) -> f64 {
        if at.velocity == 0.0 {
            return 0.0;
        }
        let share = at.velocity.abs() / libm::sqrt(at.velocity * at.velocity + self.creep_squared);
        (self.length * power(share, 1.0 / (1.0 + self.power))).copysign(at.velocity)
    }

    /// Returns the steady deflection, m. At rest, it results from the deflection `z` and the displacement since `from`,
    /// m.
    fn equilibrium_from(&self, from: f64, z: f64, at: &OperatingPoint) -> f64 {
        if !self.is_path_dependent(at) {
            return self.equilibrium(at);
        }
        let moved = (at.displacement - from) * self.per_length;
        if moved == 0.0 { z } else { self.length * self.bend(z * self.per_length, moved.signum(), moved.abs()) }
    }

    fn is_path_dependent(&self, at: &OperatingPoint) -> bool {
        at.velocity == 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Input;

    fn contact(power: f64, returns_elastically: bool, creep: f64) -> PreslidingFriction {
        PreslidingFriction {
            stiffness: 1.0,
            length: 3e-4,
            per_length: 1.0 / 3e-4,
            power,
            returns_elastically,
            creep_squared: creep * creep,
        }
    }

    /// The force is continuous in the exponent n of the contact law at n = 1. A fit that starts at n = 1 uses the
    /// derivative with respect to n. If the force jumped there, the fit would not leave n = 1, and its confidence
    /// interval would have zero width.
    #[test]
    fn force_does_not_jump_where_power_is_one() {
        for returns_elastically in [false, true] {
            for bent in [-1.0, -0.6, -1e-3, 0.0, 0.3, 0.9] {
                for slip in [0.0, 1e-3, 0.1, 1.0, 4.0, 30.0] {
                    for r in [1.0, -1.0, 0.4, 0.0] {
                        let at = |power| contact(power, returns_elastically, 1e-9).bend(bent, r, slip);
                        let (one, above) = (at(0.0), at(1e-6));
                        assert!((one - above).abs() < 1e-5, "{bent} {slip} {r}: {one} {above}");
                    }
                }
            }
        }
    }

    #[test]
    fn law_without_closed_form_is_near_short_steps() {
        for power in [0.1, 1.0, 3.0] {
            for bent in [-1.0, -0.5, 0.0, 0.5] {
                for slip in [0.05, 0.5, 1.0, 2.0, 4.0, 30.0] {
                    let coarse = contact(power, false, 1e-9).bend(bent, 1.0, slip);
                    let (count, mut exact) = (100_000, bent);
                    let h = slip / f64::from(count);
                    let rate = |z: f64| 1.0 - z * z.abs().powf(power);
                    for _ in 0..count {
                        exact += h * rate(exact + 0.5 * h * rate(exact));
                    }
                    assert!((coarse - exact).abs() < 0.03, "{power} {bent} {slip}: {coarse} {exact}");
                }
            }
        }
    }

    #[test]
    fn a_step_in_one_direction_is_the_same_without_looking_for_turns() {
        let mut one_way = 0;
        for contact in
            [contact(0.0, false, 1e-9), contact(2.0, false, 1e-9), contact(2.0, true, 1e-9), contact(0.0, false, 0.05)]
        {
            for (v0, v1) in [(0.0, 0.1), (0.1, 0.0), (0.2, 0.3), (-0.2, -0.3), (-1.0, -0.01), (1e-5, 2e-5), (0.1, -0.1)]
            {
                // With a mean velocity below a third of the sum of both end velocities, the step could contain a
                // reversal.
                for share in [0.34, 0.5, 0.8, 1.0] {
                    for bent in [-0.9, -0.01, 0.0, 0.5] {
                        let dt = 1e-3;
                        let input = Input::motion(dt * (v0 + v1) * share, v1);
                        let path = Path::new(0.0, v0, &input, dt);
                        let (x1, v1) = path.end();
                        let ends = (Dual::<2>::along(x1, 0), Dual::along(v1, 1));
                        let (travel, bent) = (path.travel(ends.0, ends.1), Dual::constant(bent));
                        let (quick, in_full) = (contact.after(&travel, bent), contact.turns(&travel, bent));
                        assert!((quick.value - in_full.value).abs() < 1e-12, "{contact:?} {v0} {v1} {share} {bent:?}");
                        for k in 0..2 {
                            let size = in_full.derivatives[k].abs().max(1.0);
                            assert!(
                                (quick.derivatives[k] - in_full.derivatives[k]).abs() < 1e-9 * size,
                                "{contact:?} {v0} {v1} {share} {bent:?}"
                            );
                        }
                        one_way += i32::from(quick != in_full);
                    }
                }
            }
        }
        // Results that differ by rounding show that the short and the general computation were both used.
        assert!(one_way > 20, "{one_way}");
    }

    #[test]
    fn a_step_that_turns_inside_is_its_pieces_after_each_other() {
        let contact = contact(0.0, false, 1e-9);
        let dt = 1e-3;
        let carried = |path: &Path, bent: f64| {
            let (x1, v1) = path.end();
            contact.after(&path.travel(Dual::<2>::along(x1, 0), Dual::along(v1, 1)), Dual::constant(bent))
        };
        let mut turns_seen = [0; 3];
        // Final displacement, m, and velocities at start and end, m/s, of motions with no reversal, with one and with
        // two.
        for (x1, v0, v1) in
            [(2e-4, 0.1, 0.3), (1e-4, 0.7, -0.4), (-2e-4, 0.5, -0.9), (0.0, 0.4, 0.4), (1e-4, -0.6, -0.5)]
        {
            for bent in [-0.8, 0.0, 0.6] {
                let path = Path::new(0.0, v0, &Input::motion(x1, v1), dt);
                let whole = carried(&path, bent);
                let (mut pieces, mut turns) = (bent, 0);
                let n = 500;
                for i in 0..n {
                    let (from, to) =
                        (path.point(f64::from(i) / f64::from(n)), path.point(f64::from(i + 1) / f64::from(n)));
                    turns += usize::from(from.v * to.v < 0.0);
                    let piece = Path::new(from.x, from.v, &Input::motion(to.x, to.v), dt / f64::from(n));
                    pieces = carried(&piece, pieces).value;
                }
                turns_seen[turns] += 1;
                assert!((whole.value - pieces).abs() < 1e-10, "{x1} {v0} {v1} {bent}: {} {pieces}", whole.value);
                let at = |x1: f64, v1: f64| carried(&Path::new(0.0, v0, &Input::motion(x1, v1), dt), bent).value;
                let by_x = (at(x1 + 1e-8, v1) - at(x1 - 1e-8, v1)) / 2e-8;
                let by_v = (at(x1, v1 + 1e-5) - at(x1, v1 - 1e-5)) / 2e-5;
                assert!(
                    (whole.derivatives[0] - by_x).abs() < 1e-5 * by_x.abs().max(1.0),
                    "{x1} {v0} {v1} {bent}: {by_x}"
                );
                assert!(
                    (whole.derivatives[1] - by_v).abs() < 1e-5 * by_v.abs().max(1.0),
                    "{x1} {v0} {v1} {bent}: {by_v}"
                );
            }
        }
        assert!(turns_seen.iter().all(|seen| *seen > 0), "{turns_seen:?}");
    }
}
