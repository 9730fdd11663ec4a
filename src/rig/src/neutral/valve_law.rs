//! The force-velocity law of the neutral damper, as flow (expressed as a piston velocity) over force.
//!
//! With flow as a function of force, the flows of parallel passages add, so that an injected bypass is an additional
//! term.

use crate::draw::Draw;

/// Approximate velocity of the last knot of a randomly drawn force-velocity curve, m/s.
const TOP_M_S: f64 = 1.6;

/// Flow through the valves as a function of force, in rebound and compression.
#[derive(Debug, Clone)]
pub(crate) struct ValveLaw {
    pub rebound: OneWay,
    pub compression: OneWay,
}

/// Flow as a function of force in one direction. Force, N, and flow, as the piston velocity, m/s, are magnitudes.
#[derive(Debug, Clone)]
pub(crate) enum OneWay {
    /// A bleed (laminar and orifice in series) in parallel with a blow-off valve that opens near the force `lift_n`, N.
    Passages { laminar_n_s_m: f64, orifice_n_s2_m2: f64, opening_m_s_n: f64, lift_n: f64, knee_n: f64 },
    /// Straight lines between knots, with kinks.
    Lines(Knots),
    /// A monotone cubic curve through knots (Fritsch & Carlson).
    Curve(Knots),
}

/// Knots of an increasing curve of flow over force, which begins at the origin.
#[derive(Debug, Clone)]
pub(crate) struct Knots {
    force_n: Vec<f64>,
    flow_m_s: Vec<f64>,
    /// Derivatives of flow with respect to force at the knots, m/(s N).
    slope: Vec<f64>,
}

/// Shape of the force over velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Style {
    Digressive,
    Linear,
    Progressive,
}

impl ValveLaw {
    /// Computes the flow as a piston velocity, m/s, at a force, N; both are signed, rebound positive.
    pub fn flow_m_s(&self, force_n: f64) -> f64 {
        let way = if force_n > 0.0 { &self.rebound } else { &self.compression };
        way.flow_m_s(force_n.abs()).copysign(force_n)
    }

    /// Computes the force, N, at a flow as a piston velocity, m/s: the inverse of [`ValveLaw::flow_m_s`].
    pub fn force_n(&self, flow_m_s: f64) -> f64 {
        let way = if flow_m_s > 0.0 { &self.rebound } else { &self.compression };
        let target = flow_m_s.abs();
        let (mut low, mut high) = (0.0, 1.0);
        while way.flow_m_s(high) < target {
            high *= 2.0;
        }
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if way.flow_m_s(middle) < target {
                low = middle;
            } else {
                high = middle;
            }
        }
        (0.5 * (low + high)).copysign(flow_m_s)
    }

    /// Draws a law at random: the force at 1 m/s and the style in each direction, and the form of the curve.
    pub fn draw(draw: &mut Draw) -> Self {
        let rebound_n = draw.ratio("rebound_at_1_m_s_n", 1300.0, 3600.0);
        let compression_n = rebound_n * draw.between("compression_share", 0.35, 0.75);
        let style = |draw: &mut Draw, name: &str| {
            // Most car dampers have digressive valves.
            let (style, code) = match draw.choice(5) {
                0..=2 => (Style::Digressive, 0.0),
                3 => (Style::Linear, 1.0),
                _ => (Style::Progressive, 2.0),
            };
            draw.values.push((name.into(), code));
            style
        };
        let (rebound_style, compression_style) = (style(draw, "rebound_style"), style(draw, "compression_style"));
        let form = draw.choice(4);
        draw.values.push(("curve_form".into(), form as f64));
        let mut way = |at_1_m_s: f64, style: Style| {
            let passages = OneWay::passages(draw, at_1_m_s, style);
            match form {
                0 | 1 => passages,
                2 => OneWay::Lines(Knots::on(draw, &passages, 5)),
                _ => OneWay::Curve(Knots::on(draw, &passages, 9)),
            }
        };
        let rebound = way(rebound_n, rebound_style);
        let compression = way(compression_n, compression_style);
        Self { rebound, compression }
    }
}

impl OneWay {
    fn passages(draw: &mut Draw, at_1_m_s_n: f64, style: Style) -> Self {
        // `share` is the ratio of the force at 0.1 m/s to the force at 1 m/s. For a linear damper it is 0.1.
        let (share, laminar_share, knee) = match style {
            Style::Digressive => (draw.between("share", 0.32, 0.55), draw.between("laminar", 0.25, 0.7), 0.12),
            Style::Linear => (draw.between("share", 0.13, 0.20), draw.between("laminar", 0.6, 0.9), 0.5),
            Style::Progressive => (draw.between("share", 0.045, 0.08), draw.between("laminar", 0.5, 0.8), 0.3),
        };
        let low_n = share * at_1_m_s_n;
        let laminar_n_s_m = laminar_share * low_n / 0.1;
        let orifice = (1.0 - laminar_share) * low_n / 0.01;
        // A progressive valve consists of its bleed alone, so the laminar and the orifice force add up to the drawn
        // force at 1 m/s. The orifice force is at least a tenth of it.
        let orifice_n_s2_m2 =
            if style == Style::Progressive { (at_1_m_s_n - laminar_n_s_m).max(0.1 * at_1_m_s_n) } else { orifice };
        let lift_n = low_n * draw.between("lift", 0.8, 1.1);
        let knee_n = knee * lift_n * draw.between("knee", 0.7, 1.4);
        let closed = Self::Passages { laminar_n_s_m, orifice_n_s2_m2, opening_m_s_n: 0.0, lift_n, knee_n };
        let missing = 1.0 - closed.flow_m_s(at_1_m_s_n);
        let opening_m_s_n = (missing / opening(at_1_m_s_n, lift_n, knee_n)).max(0.0);
        Self::Passages { laminar_n_s_m, orifice_n_s2_m2, opening_m_s_n, lift_n, knee_n }
    }

    /// Computes the flow as a piston velocity, m/s, at a force, N. Both are magnitudes.
    pub fn flow_m_s(&self, force_n: f64) -> f64 {
        match self {
            Self::Passages { laminar_n_s_m, orifice_n_s2_m2, opening_m_s_n, lift_n, knee_n } => {
                let r = *laminar_n_s_m;
                let bleed = 2.0 * force_n / (r + (r * r + 4.0 * orifice_n_s2_m2 * force_n).sqrt());
                bleed + opening_m_s_n * opening(force_n, *lift_n, *knee_n)
            }
            Self::Lines(knots) => knots.line(force_n),
            Self::Curve(knots) => knots.curve(force_n),
        }
    }
}

/// Computes a measure of the blow-off flow, N: the lift of the valve, expressed as a force, times sqrt(F / (F +
/// F_lift)). F is the force `force_n` and F_lift the opening force `lift_n`.
fn opening(force_n: f64, lift_n: f64, knee_n: f64) -> f64 {
    let softplus = |x: f64| if x > 30.0 { x } else { libm::log1p(libm::exp(x)) };
    let lift = knee_n * (softplus((force_n - lift_n) / knee_n) - softplus(-lift_n / knee_n));
    lift * (force_n / (force_n + lift_n)).sqrt()
}

impl Knots {
    /// Draws `count` knots near a curve, in addition to the origin. Their velocities have nearly equal ratios, from
    /// about 12 mm/s to [`TOP_M_S`]. Their forces deviate by at most 5 % from the curve, unless they would not
    /// increase.
    fn on(draw: &mut Draw, curve: &OneWay, count: usize) -> Self {
        let law = ValveLaw { rebound: curve.clone(), compression: curve.clone() };
        let (mut force_n, mut flow_m_s) = (vec![0.0], vec![0.0]);
        for index in 0..count {
            let place = (index as f64 + 0.35 * (draw.unit() - 0.5)) / (count - 1) as f64;
            let flow = 0.012 * libm::pow(TOP_M_S / 0.012, place);
            let force = law.force_n(flow) * draw.between("knot_off", 0.95, 1.05);
            let least = force_n[index] + 0.15 * (law.force_n(flow) - law.force_n(flow_m_s[index]));
            force_n.push(force.max(least));
            flow_m_s.push(flow);
        }
        let n = force_n.len();
        let secant: Vec<f64> =
            (1..n).map(|i| (flow_m_s[i] - flow_m_s[i - 1]) / (force_n[i] - force_n[i - 1])).collect();
        let mut slope = vec![secant[0]; n];
        for i in 1..n - 1 {
            // The harmonic mean is at most twice the smaller secant slope. This keeps the curve monotone.
            slope[i] = 2.0 / (1.0 / secant[i - 1] + 1.0 / secant[i]);
        }
        slope[n - 1] = secant[n - 2];
        Self { force_n, flow_m_s, slope }
    }

    fn interval(&self, force: f64) -> usize {
        self.force_n.partition_point(|f| *f <= force).min(self.force_n.len() - 1).max(1)
    }

    fn line(&self, force: f64) -> f64 {
        let i = self.interval(force);
        let slope = (self.flow_m_s[i] - self.flow_m_s[i - 1]) / (self.force_n[i] - self.force_n[i - 1]);
        self.flow_m_s[i - 1] + slope * (force - self.force_n[i - 1])
    }

    fn curve(&self, force: f64) -> f64 {
        let last = self.force_n.len() - 1;
        if force >= self.force_n[last] {
            return self.flow_m_s[last] + self.slope[last] * (force - self.force_n[last]);
        }
        let i = self.interval(force);
        let h = self.force_n[i] - self.force_n[i - 1];
        let s = (force - self.force_n[i - 1]) / h;
        let (y0, y1) = (self.flow_m_s[i - 1], self.flow_m_s[i]);
        let (m0, m1) = (h * self.slope[i - 1], h * self.slope[i]);
        let (s2, s3) = (s * s, s * s * s);
        (2.0 * s3 - 3.0 * s2 + 1.0) * y0 + (s3 - 2.0 * s2 + s) * m0 + (3.0 * s2 - 2.0 * s3) * y1 + (s3 - s2) * m1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_rise_pass_the_origin_and_invert() {
        for seed in 0..60 {
            let law = ValveLaw::draw(&mut Draw::new(seed, "law"));
            assert_eq!(law.flow_m_s(0.0), 0.0);
            let mut last = f64::NEG_INFINITY;
            for i in -300..=300 {
                let force = 20.0 * f64::from(i);
                let flow = law.flow_m_s(force);
                assert!(flow > last, "seed {seed}: {force} N");
                last = flow;
                assert!((law.force_n(flow) - force).abs() < 1e-6 * force.abs() + 1e-9);
            }
        }
    }

    #[test]
    fn laws_have_the_forces_of_car_dampers_and_differ_by_direction() {
        for seed in 0..200 {
            let law = ValveLaw::draw(&mut Draw::new(seed, "law"));
            let (rebound, compression) = (law.force_n(1.0), -law.force_n(-1.0));
            assert!((900.0..5500.0).contains(&rebound), "seed {seed}: {rebound}");
            assert!(compression > 300.0 && compression < rebound, "seed {seed}: {compression} of {rebound}");
            let top = law.force_n(1.6);
            assert!(top < 15e3, "seed {seed}: {top} N at 1.6 m/s");
        }
    }
}
