//! Maneuvers: speed, steering and road over time.

/// Maneuver of a vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manoeuvre {
    /// Drive both axles over a bump of 40 mm height and 0.5 m length at 30 km/h.
    Bump,
    /// Steering angle of 2 degrees at the wheels, ramped in 0.15 s, at 90 km/h.
    StepSteer,
    /// Sine steering with an amplitude of 1.5 degrees at the wheels and a frequency of 0.7 Hz, at 90 km/h.
    SineSteer,
    /// Drive a section of track at 110 km/h: a rough road and a series of bends.
    Track,
}

/// Surface of the track: waves of an ISO 8608 road between class B and C, different on the left and on the right.
#[derive(Clone, Debug)]
pub struct Road {
    /// Angular wave number (rad/m), amplitude (m), and phase on the left and on the right of each wave.
    waves: Vec<[f64; 4]>,
}

/// Power spectral density of the road height at 0.1 cycles/m, m³: between class B and class C of ISO 8608.
const UNEVENNESS: f64 = 100e-6;

impl Road {
    /// Makes a random road. Equal seeds give equal roads.
    pub fn new(seed: u64) -> Road {
        let mut state = seed;
        let mut uniform = || {
            // splitmix64
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
        };
        const WAVES: usize = 120;
        let (low, high) = (0.02_f64, 1.0_f64);
        let ratio = libm::pow(high / low, 1.0 / WAVES as f64);
        let waves = (0..WAVES)
            .map(|k| {
                let (from, to) = (low * ratio.powi(k as i32), low * ratio.powi(k as i32 + 1));
                let n = from + uniform() * (to - from);
                let amplitude = (2.0 * UNEVENNESS * (n / 0.1).powi(-2) * (to - from)).sqrt();
                let phase = std::f64::consts::TAU * uniform();
                // Long waves are almost equal on both sides, short waves differ.
                let apart = std::f64::consts::TAU * (uniform() - 0.5) * (n / 0.3).min(1.0);
                [std::f64::consts::TAU * n, amplitude, phase, phase + apart]
            })
            .collect();
        Road { waves }
    }

    /// Returns the height, m, under a wheel at a distance along the road, m. Side 0 is left.
    pub fn height(&self, distance: f64, side: usize) -> f64 {
        self.waves.iter().map(|w| w[1] * libm::sin(w[0] * distance + w[2 + side])).sum()
    }
}

impl Manoeuvre {
    /// All maneuvers, with their names on the command line.
    pub const ALL: [(&'static str, Manoeuvre); 4] = [
        ("bump", Manoeuvre::Bump),
        ("step-steer", Manoeuvre::StepSteer),
        ("sine-steer", Manoeuvre::SineSteer),
        ("track", Manoeuvre::Track),
    ];

    /// Returns the forward speed, m/s.
    pub fn speed(self) -> f64 {
        match self {
            Manoeuvre::Bump => 30.0 / 3.6,
            Manoeuvre::StepSteer | Manoeuvre::SineSteer => 90.0 / 3.6,
            Manoeuvre::Track => 110.0 / 3.6,
        }
    }

    /// Returns the duration, s.
    pub fn duration(self) -> f64 {
        match self {
            Manoeuvre::Bump => 3.0,
            Manoeuvre::StepSteer => 4.0,
            Manoeuvre::SineSteer => 6.0,
            Manoeuvre::Track => 20.0,
        }
    }

    /// Returns the steering angle at the wheels, rad, left positive, at a time, s.
    pub fn steer(self, time: f64) -> f64 {
        let t = time - 0.5;
        if t <= 0.0 {
            return 0.0;
        }
        match self {
            Manoeuvre::Bump => 0.0,
            Manoeuvre::StepSteer => 2.0_f64.to_radians() * (t / 0.15).min(1.0),
            Manoeuvre::SineSteer => 1.5_f64.to_radians() * libm::sin(std::f64::consts::TAU * 0.7 * t),
            Manoeuvre::Track => {
                0.9_f64.to_radians() * libm::sin(1.1 * t)
                    + 0.5_f64.to_radians() * libm::sin(0.43 * t) * libm::sin(2.3 * t)
            }
        }
    }

    /// Returns the height of the road, m, at a time, s, under a wheel that is `ahead`, m, of the center of gravity.
    /// Side 0 is left.
    pub fn road(self, road: &Road, time: f64, ahead: f64, side: usize) -> f64 {
        let distance = self.speed() * time + ahead;
        match self {
            Manoeuvre::Bump => {
                let (x, length) = (distance - 6.0, 0.5);
                if (0.0..length).contains(&x) {
                    0.02 * (1.0 - libm::cos(std::f64::consts::TAU * x / length))
                } else {
                    0.0
                }
            }
            Manoeuvre::Track => {
                // The height of the road increases over 2 s, so that the vehicle starts at rest.
                road.height(distance, side) * (time / 2.0).min(1.0)
            }
            Manoeuvre::StepSteer | Manoeuvre::SineSteer => 0.0,
        }
    }
}
