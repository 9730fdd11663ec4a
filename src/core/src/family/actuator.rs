//! The actuator: from the commanded to the actual setting of the valve.
//!
//! ```text
//! dead time   u(t) = command(t − t_d)
//! lag, rate   dy/dt = (u − y)/τ within the rate limits, τ and limit those of rising or of falling
//! hysteresis  s = y − h (z − z_r),   dz/dt = (dy/dt − |dy/dt| z)/(2 h)
//! ```
//!
//! u is the command after the dead time t_d, and y the setting behind the lag with the time constant τ. h is the
//! hysteresis: half the distance between the branches. z is the state of a Dahl element driven by y: it tends to 1
//! while y rises and to −1 while y falls. The actual setting s is therefore 2 h smaller after a long rise of y than
//! after a long fall. After a reversal ds/dy begins at 0 and tends to 1: s never moves against y.
//!
//! z_r is the state z at which the damper's parameters over the setting apply. It is 1 if the valve reached each
//! setting from below, −1 if from above, and 0 midway between.

use crate::math::{exp_below_bound, max, min};

/// Shortest time constant in [`Actuator::rates`], s. It replaces a shorter or missing time constant.
pub const QUICKEST: f64 = 1e-4;

/// Dynamics between the commanded and the actual setting of a valve. Rising means toward larger settings.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Actuator {
    /// Time constants of the lag while the setting rises and while it falls, s.
    pub time: [f64; 2],
    /// Largest rates while the setting rises and while it falls, in the setting's unit per second; 0: no limit.
    pub rate: [f64; 2],
    /// Dead time, s.
    pub dead_time: f64,
    /// Hysteresis h, in the setting's unit: half the distance between the rising and the falling branch.
    pub hysteresis: f64,
    /// State z_r of the hysteresis at which the damper's parameters over the setting apply, from −1 to 1.
    pub rest: f64,
}

/// State of the actuator, from which the actual setting of the valve follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// Setting y behind the lag, in the setting's unit.
    pub lagged: f64,
    /// State z of the hysteresis, from −1 (after a long fall) to 1 (after a long rise).
    pub turned: f64,
}

/// State derivatives of the actuator, and their partial derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Time derivatives of the lagged setting y and of the hysteresis state z.
    pub rate: [f64; 2],
    /// Derivatives of dy/dt with respect to the lagged setting y and the command u.
    pub lagged_by: [f64; 2],
    /// Derivatives of dz/dt with respect to the lagged setting y, the hysteresis state z and the command u.
    pub turned_by: [f64; 3],
}

impl Actuator {
    /// No dynamics: the actual setting equals the command.
    pub const NONE: Actuator = Actuator { time: [0.0; 2], rate: [0.0; 2], dead_time: 0.0, hysteresis: 0.0, rest: 0.0 };

    /// Returns whether the lagged setting is a state: with a time constant, a rate limit or a hysteresis.
    #[inline(always)]
    pub fn has_lag(&self) -> bool {
        let [up, down] = self.time;
        let [rising, falling] = self.rate;
        up + down + rising + falling + self.hysteresis > 0.0
    }

    /// Returns whether the actuator has a hysteresis and thus its state.
    #[inline(always)]
    pub fn has_hysteresis(&self) -> bool {
        self.hysteresis > 0.0
    }

    /// Returns the actual setting of the valve in a state of the actuator.
    #[inline(always)]
    pub fn setting(&self, stand: &Stand) -> f64 {
        stand.lagged - self.hysteresis * (stand.turned - self.rest)
    }

    /// Returns the state of the actuator in which the damper's parameters at the setting `u` apply.
    #[inline(always)]
    pub fn still(&self, u: f64) -> Stand {
        Stand { lagged: u, turned: if self.has_hysteresis() { self.rest } else { 0.0 } }
    }

    /// Returns the steady state under a constant command `u` after the dead time. The hysteresis depends on the change
    /// of the lagged setting since the state `from`.
    pub fn at_rest(&self, from: &Stand, u: f64) -> Stand {
        Stand { lagged: u, turned: self.turned(from.turned, u - from.lagged) }
    }

    /// Advances the state by a step of `dt`, s, in which the command `u` after the dead time is constant. The result is
    /// exact.
    pub fn advance(&self, from: &Stand, u: f64, dt: f64) -> Stand {
        let way = u - from.lagged;
        let falls = usize::from(way < 0.0);
        let (time, rate) = (self.time[falls], self.rate[falls]);
        let (mut left, mut dt) = (way.abs(), dt);
        if rate > 0.0 {
            // The rate stays at its limit until the rate that the lag alone would cause is smaller.
            let slow = rate * time;
            let until = max(left - slow, 0.0) / rate;
            let at_limit = min(until, dt);
            left -= rate * at_limit;
            dt -= at_limit;
        }
        if time > 0.0 {
            left *= exp_below_bound(-dt / time);
        } else if dt > 0.0 {
            left = 0.0;
        }
        let moved = way - left.copysign(way);
        Stand { lagged: u - left.copysign(way), turned: self.turned(from.turned, moved) }
    }

    /// Computes the hysteresis state exactly after a change `moved` of the lagged setting in one direction, from the
    /// state `z`.
    #[inline(always)]
    fn turned(&self, z: f64, moved: f64) -> f64 {
        if self.hysteresis == 0.0 {
            return 0.0;
        }
        let target = 1.0f64.copysign(moved);
        target + (z - target) * exp_below_bound(-moved.abs() / (2.0 * self.hysteresis))
    }

    /// Computes the state derivatives at an instant; `u` is the command after the dead time.
    pub fn rates(&self, stand: &Stand, u: f64) -> Rates {
        let way = u - stand.lagged;
        let falls = usize::from(way < 0.0);
        let per_time = 1.0 / max(self.time[falls], QUICKEST);
        let limit = self.rate[falls];
        let (mut rate, mut by_way) = (way * per_time, per_time);
        if limit > 0.0 && rate.abs() > limit {
            (rate, by_way) = (limit.copysign(way), 0.0);
        }
        let mut rates = Rates { rate: [rate, 0.0], lagged_by: [-by_way, by_way], turned_by: [0.0; 3] };
        if self.hysteresis > 0.0 {
            let per = 1.0 / (2.0 * self.hysteresis);
            let toward = 1.0f64.copysign(way) - stand.turned;
            rates.rate[1] = rate.abs() * toward * per;
            let by_way = by_way * 1.0f64.copysign(way) * toward * per;
            rates.turned_by = [-by_way, -rate.abs() * per, by_way];
        }
        rates
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const VALVE: Actuator =
        Actuator { time: [8e-3, 20e-3], rate: [60.0, 0.0], dead_time: 0.0, hysteresis: 0.05, rest: 0.0 };

    /// Integrates the actuator's state derivatives in tiny steps, as a reference for the exact step.
    fn integrated(valve: &Actuator, mut stand: Stand, u: f64, dt: f64) -> Stand {
        let steps = 200_000;
        for _ in 0..steps {
            let [y, z] = valve.rates(&stand, u).rate;
            stand.lagged += y * dt / f64::from(steps);
            stand.turned += z * dt / f64::from(steps);
        }
        stand
    }

    #[test]
    fn a_step_is_the_integral_of_the_rates() {
        let rest = Stand { lagged: 0.3, turned: -1.0 };
        for (u, dt) in [(1.6, 5e-3), (1.6, 40e-3), (0.0, 10e-3), (0.31, 3e-3), (0.3, 1e-3)] {
            let (stepped, exact) = (VALVE.advance(&rest, u, dt), integrated(&VALVE, rest, u, dt));
            assert!((stepped.lagged - exact.lagged).abs() < 2e-5, "{stepped:?} {exact:?}");
            assert!((stepped.turned - exact.turned).abs() < 2e-4, "{stepped:?} {exact:?}");
            let two = VALVE.advance(&VALVE.advance(&rest, u, 0.3 * dt), u, 0.7 * dt);
            assert!((two.lagged - stepped.lagged).abs() < 1e-12 && (two.turned - stepped.turned).abs() < 1e-12);
        }
    }

    #[test]
    fn rising_takes_its_time_and_falling_its_own() {
        let lag = Actuator { rate: [0.0; 2], hysteresis: 0.0, ..VALVE };
        let reached = |from: f64, u: f64, dt: f64| {
            (lag.advance(&Stand { lagged: from, turned: 0.0 }, u, dt).lagged - from) / (u - from)
        };
        let one = 1.0 - libm::exp(-1.0);
        assert!((reached(0.0, 1.0, 8e-3) - one).abs() < 1e-12 && (reached(1.0, 0.0, 20e-3) - one).abs() < 1e-12);
        let limited = Actuator { rate: [10.0, 5.0], time: [0.0; 2], ..lag };
        let stand = limited.advance(&Stand { lagged: 0.0, turned: 0.0 }, 1.0, 30e-3);
        assert!((stand.lagged - 0.3).abs() < 1e-12);
        assert_eq!(limited.advance(&stand, 1.0, 1.0).lagged, 1.0);
    }

    #[test]
    fn hysteresis_lies_between_the_ways_up_and_down_and_never_turns_against_the_current() {
        let valve = Actuator { hysteresis: 0.1, ..Actuator::NONE };
        let (mut stand, mut ways) = (Stand { lagged: 0.0, turned: 0.0 }, [[0.0; 41]; 2]);
        let mut last = valve.setting(&stand);
        for round in 0..3 {
            for (way, of_way) in ways.iter_mut().enumerate() {
                for k in 0..=40 {
                    let u = f64::from(if way == 0 { k } else { 40 - k }) * 0.05;
                    stand = valve.advance(&stand, u, 1e-3);
                    let s = valve.setting(&stand);
                    assert!((s - last) * if way == 0 { 1.0 } else { -1.0 } >= -1e-12, "{round} {way} {k}");
                    assert!((-1e-12..=2.0 + 1e-12).contains(&s));
                    last = s;
                    of_way[if way == 0 { k as usize } else { 40 - k as usize }] = s;
                }
            }
        }
        let [up, down] = ways;
        // Far from both ends of the range, the curves of the rising and the falling setting are twice the hysteresis of
        // 0.1 apart.
        assert!((down[20] - up[20] - 0.2).abs() < 0.01, "{} {}", up[20], down[20]);
        assert!(up.iter().zip(&down).all(|(up, down)| up <= &(down + 1e-12)));
    }

    #[test]
    fn at_rest_the_setting_is_the_command_and_the_way_back_lies_the_whole_hysteresis_apart() {
        for rest in [-1.0, 0.0, 0.6, 1.0] {
            let valve = Actuator { hysteresis: 0.1, rest, ..Actuator::NONE };
            let still = valve.still(1.0);
            assert_eq!(valve.setting(&still), 1.0);
            let far = |u: f64| valve.setting(&valve.at_rest(&valve.at_rest(&still, u), 1.0));
            assert!((far(-2.0) - (1.0 - 0.1 * (1.0 - rest))).abs() < 1e-6, "{rest}: {}", far(-2.0));
            assert!((far(4.0) - (1.0 + 0.1 * (1.0 + rest))).abs() < 1e-6, "{rest}: {}", far(4.0));
        }
        assert_eq!(Actuator { rest: 1.0, ..Actuator::NONE }.still(0.5), Stand { lagged: 0.5, turned: 0.0 });
    }

    #[test]
    fn derivatives_of_the_rates_are_their_differences() {
        for (y, z, u) in [(0.3, -0.4, 1.6), (1.0, 0.7, 0.2), (0.5, 0.1, 0.52)] {
            let rates = VALVE.rates(&Stand { lagged: y, turned: z }, u);
            let e = 1e-7;
            let by = |plus: Rates, minus: Rates| [0, 1].map(|k| (plus.rate[k] - minus.rate[k]) / (2.0 * e));
            let at = |y: f64, z: f64, u: f64| VALVE.rates(&Stand { lagged: y, turned: z }, u);
            let (by_y, by_z, by_u) = (
                by(at(y + e, z, u), at(y - e, z, u)),
                by(at(y, z + e, u), at(y, z - e, u)),
                by(at(y, z, u + e), at(y, z, u - e)),
            );
            let near = |a: f64, b: f64| (a - b).abs() < 1e-4 * (1.0 + b.abs());
            assert!(near(rates.lagged_by[0], by_y[0]) && near(rates.lagged_by[1], by_u[0]), "{rates:?}");
            assert!(
                near(rates.turned_by[0], by_y[1])
                    && near(rates.turned_by[1], by_z[1])
                    && near(rates.turned_by[2], by_u[1]),
                "{rates:?} {by_y:?} {by_z:?} {by_u:?}"
            );
        }
    }
}
