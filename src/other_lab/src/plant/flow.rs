//! Flow laws of damper valves in one direction: flow, expressed as a piston velocity, over hydraulic force.

use crate::draw::Draw;

/// Computes the flow w through a partly laminar, partly turbulent passage: `h = a w + b w²`, for h ≥ 0. Here, h is the
/// hydraulic force, N, and w the flow as a piston velocity, m/s. The resistances are a, N s/m, and b, N s²/m².
///
/// (Merritt, Hydraulic Control Systems, 1967.)
pub fn passage(h: f64, a: f64, b: f64) -> f64 {
    2.0 * h / (a + (a * a + 4.0 * b * h).sqrt())
}

/// Computes the positive part of x, with the corner at x = 0 rounded over `width`, in the unit of x.
pub fn ramp(x: f64, width: f64) -> f64 {
    0.5 * (x + (x * x + width * width).sqrt())
}

/// Computes the flow, as a piston velocity, m/s, through a check valve with a light spring for a hydraulic force h ≥ 0,
/// N. The valve opens gradually about the force `lifts`, N; `a` and `b` are those of [`passage`].
pub fn check_valve(h: f64, lifts: f64, a: f64, b: f64) -> f64 {
    passage(h * h / (h + lifts), a, b)
}

/// Valves of one direction.
#[derive(Debug, Clone)]
pub enum Valves {
    /// Bleed with a power law `w = w_1 (h/h_1)^p`, in parallel with a blow-off valve that opens smoothly above a force.
    /// Here, w is the flow as a piston velocity, m/s, and h the hydraulic force, N.
    PowerAndBlowOff {
        /// Bleed: w_1, m/s, h_1, N, and p.
        bleed: [f64; 3],
        /// Blow-off: opening force, N, w at twice that force, m/s, exponent, width of the transition, N.
        blow_off: [f64; 4],
    },
    /// Inverse of the law `h = F_1 tanh(w/w_1) + c w + q w²` of the hydraulic force h, N, tabulated over the piston
    /// velocity w, m/s.
    Sum {
        /// Forces h, N, and derivatives dw/dh over a grid of velocities w up to 4 m/s.
        table: Vec<[f64; 2]>,
    },
    /// Bleed orifice, laminar and turbulent, in parallel with a spring-loaded shim.
    ///
    /// Above its preload, the shim lifts in proportion to pressure up to a stop. Its opening acts as an orifice
    /// (Talbott & Starkey, SAE 2002-01-3337).
    OrificeAndShim {
        /// Coefficients a and b of the bleed ([`passage`]).
        bleed: [f64; 2],
        /// Preload, N, additional force up to the stop, N, and flow of the fully open shim at 1 kN, as a piston
        /// velocity, m/s.
        shim: [f64; 3],
    },
}

/// Largest piston velocity of the table in [`Valves::Sum`], m/s; beyond it, the law is linear.
const FASTEST: f64 = 4.0;
const POINTS: usize = 500;

impl Valves {
    /// Draws a bleed with a power law and a blow-off valve, with about the force `h`, N, at 0.5 m/s.
    pub fn power_and_blow_off(d: &mut Draw, h: f64) -> Valves {
        let knee = d.between(0.3, 0.6) * h;
        let knee_speed = d.between(0.06, 0.16);
        let p = d.between(0.55, 0.85);
        let exponent = d.between(1.0, 1.35);
        // At the force h, the flow through the blow-off valve is 0.5 m/s minus the flow through the bleed.
        let rest = 0.5 - knee_speed * libm::pow(h / knee, p);
        let open = rest.max(0.1) / libm::pow((h - knee) / knee, exponent);
        Valves::PowerAndBlowOff {
            bleed: [knee_speed, knee, p],
            blow_off: [knee, open, exponent, d.between(0.08, 0.25) * knee],
        }
    }

    /// Draws a law of [`Valves::Sum`] with about the force `h`, N, at 0.5 m/s.
    pub fn sum(d: &mut Draw, h: f64) -> Valves {
        let (step, linear) = (d.between(0.3, 0.6), d.between(0.2, 0.4));
        let speed = d.between(0.05, 0.14);
        let (f1, c, q) = (step * h, linear * h / 0.5, (1.0 - step - linear) * h / 0.25);
        let force = |w: f64| f1 * libm::tanh(w / speed) + c * w + q.max(0.0) * w * w;
        let table = (0..=POINTS).map(|i| FASTEST * (i as f64 / POINTS as f64).powi(3)).map(|w| {
            let t = libm::tanh(w / speed);
            [force(w), 1.0 / (f1 / speed * (1.0 - t * t) + c + 2.0 * q.max(0.0) * w)]
        });
        Valves::Sum { table: table.collect() }
    }

    /// Draws a bleed orifice and a shim with about the force `h`, N, at 0.5 m/s.
    pub fn orifice_and_shim(d: &mut Draw, h: f64) -> Valves {
        let preload = d.between(0.25, 0.5) * h;
        let knee_speed = d.between(0.05, 0.15);
        let laminar = d.between(0.25, 0.6);
        let a = laminar * preload / knee_speed;
        let b = (1.0 - laminar) * preload / (knee_speed * knee_speed);
        let opening = d.between(0.8, 2.0) * h;
        let lift = ramp(h - preload, 0.05 * preload) / opening;
        let missing = (0.5 - passage(h, a, b)).max(0.1);
        let full = missing / (lift / libm::pow(1.0 + lift.powi(4), 0.25) * (h / 1e3).sqrt());
        Valves::OrificeAndShim { bleed: [a, b], shim: [preload, opening, full] }
    }

    /// Computes the part of [`Valves::velocity`], m/s, that flows through a bleed orifice, which is open in both
    /// directions. The result is 0 for laws without a bleed orifice.
    pub fn bleed(&self, h: f64, viscosity: f64) -> f64 {
        match self {
            Valves::OrificeAndShim { bleed: [a, b], .. } => passage(h, a * viscosity, *b),
            _ => 0.0,
        }
    }

    /// Computes the flow as a piston velocity, m/s, at the hydraulic force `h` ≥ 0, N. `viscosity` is the ratio of the
    /// oil's viscosity to that at 25 °C.
    pub fn velocity(&self, h: f64, viscosity: f64) -> f64 {
        match self {
            Valves::PowerAndBlowOff { bleed: [w, h1, p], blow_off: [open_at, open, m, width] } => {
                // The power law is linear below about 0.03 of the force h_1, to prevent an infinite derivative at zero
                // force.
                let low = 0.03;
                let r = h / h1;
                let bled = w * (r * libm::pow(r * r + low * low, 0.5 * (p - 1.0))) / (0.4 + 0.6 * viscosity);
                let beyond = ramp(h - open_at, *width) - ramp(-open_at, *width);
                bled + open * libm::pow(beyond.max(0.0) / open_at, *m)
            }
            Valves::Sum { table } => inverse(table, h / (0.6 + 0.4 * viscosity)),
            Valves::OrificeAndShim { bleed: [a, b], shim: [preload, opening, full] } => {
                let width = 0.05 * preload;
                let lift = (ramp(h - preload, width) - ramp(-preload, width)).max(0.0) / opening;
                let lift = lift / libm::pow(1.0 + lift.powi(4), 0.25);
                passage(h, a * viscosity, *b) + full * lift * (h / 1e3).max(0.0).sqrt()
            }
        }
    }
}

/// Interpolates the piston velocity, m/s, at the force `h`, N, in the table of forces and derivatives with Hermite's
/// cubic. Extrapolates linearly beyond the table.
fn inverse(table: &[[f64; 2]], h: f64) -> f64 {
    let speed = |i: usize| FASTEST * (i as f64 / POINTS as f64).powi(3);
    let [last, slope] = table[POINTS];
    if h >= last {
        return FASTEST + slope * (h - last);
    }
    let i = table.partition_point(|row| row[0] <= h).clamp(1, POINTS) - 1;
    let ([from, m0], [to, m1]) = (table[i], table[i + 1]);
    let width = to - from;
    let u = (h - from) / width;
    let (w0, w1) = (speed(i), speed(i + 1));
    let (u2, u3) = (u * u, u * u * u);
    (2.0 * u3 - 3.0 * u2 + 1.0) * w0
        + (u3 - 2.0 * u2 + u) * width * m0
        + (3.0 * u2 - 2.0 * u3) * w1
        + (u3 - u2) * width * m1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valves_pass_more_the_more_drives_and_reach_their_force() {
        type Make = fn(&mut Draw, f64) -> Valves;
        for (name, make) in
            [("power", Valves::power_and_blow_off as Make), ("sum", Valves::sum), ("shim", Valves::orifice_and_shim)]
        {
            for seed in 0..30 {
                let valves = make(&mut Draw::new(seed, "valves"), 1000.0);
                assert!(valves.velocity(0.0, 1.0).abs() < 1e-9, "{name}");
                let at: Vec<f64> = (0..400).map(|i| valves.velocity(10.0 * f64::from(i), 1.0)).collect();
                assert!(at.windows(2).all(|w| w[1] > w[0]), "{name} {seed}");
                let reached = valves.velocity(1000.0, 1.0);
                assert!((0.4..0.75).contains(&reached), "{name} {seed}: {reached}");
                assert!(valves.velocity(200.0, 2.0) < valves.velocity(200.0, 1.0), "{name} {seed}");
            }
        }
    }

    #[test]
    fn tabulated_sum_is_the_inverse_of_its_law() {
        let mut d = Draw::new(3, "sum");
        let Valves::Sum { table } = Valves::sum(&mut d, 1500.0) else { unreachable!() };
        for i in [1usize, 57, 333] {
            let w = FASTEST * (i as f64 / POINTS as f64).powi(3);
            assert!((inverse(&table, table[i][0]) - w).abs() < 1e-9);
        }
    }
}
