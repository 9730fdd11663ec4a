//! Unknowns of a fit, and the conversion of a vector of their values to a parameter set.

use crate::scale::Scale;
use dashpot_core::Params;
use dashpot_core::parameter::{List, Number};
use dashpot_core::{list, number};

/// List of unknowns over a base parameter set.
#[derive(Debug, Clone)]
pub struct Unknowns {
    /// Fixed parameters, and enabled elements.
    pub base: Params,
    /// The unknowns, in the order of the vector of their values.
    pub list: Vec<Unknown>,
}

/// One element of the vector of unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unknown {
    /// The logarithm of a positive parameter.
    Log(Number),
    /// A parameter itself.
    Linear(Number),
    /// Excess of a parameter over another, as a fraction of the other, for example of a break-away peak over the
    /// Coulomb force.
    Above(Number, Number),
    /// Absolute change of force of a curve from one point to the next, away from the anchor of the curve near the
    /// origin.
    Rise {
        /// The curve.
        curve: CurveName,
        /// Index of the point at the outer end of the rise, in the list of the curve.
        point: usize,
    },
    /// One entry of a list parameter.
    Entry(List, usize),
}

/// Largest value in a fit, m/s, of the velocities in [`WIDTHS`], which are the widths of a Stribeck peak.
const STRIBECK_WIDEST: f64 = 0.05;
const WIDTHS: [Number; 2] = [number!("stribeck_velocity"), number!("stribeck_breakaway_velocity")];

/// Highest break-away peak of a fit: the excess over the Coulomb force, as a fraction of this force.
///
/// Seals show 0.1 to 0.6. Without a bound, the peak would become part of the FV curve.
const HIGHEST_PEAK: f64 = 1.0;

/// The curves whose points can be fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurveName {
    /// FV curve, with the lists `fv_velocity` and `fv_force`.
    Fv,
    /// Curve of the lookup spring, with the lists `spring_displacement` and `spring_force`.
    Spring,
}

impl CurveName {
    /// Returns the list parameter with the abscissae of the points: velocities, m/s, or displacements, m.
    pub fn abscissae(self) -> List {
        match self {
            CurveName::Fv => list!("fv_velocity"),
            CurveName::Spring => list!("spring_displacement"),
        }
    }

    /// Returns the list parameter with the forces at the points, N.
    pub fn forces(self) -> List {
        match self {
            CurveName::Fv => list!("fv_force"),
            CurveName::Spring => list!("spring_force"),
        }
    }
}

/// Returns the index of the point of a curve that stays at zero force: the point nearest the origin.
pub fn anchor(abscissae: &[f64]) -> usize {
    (0..abscissae.len()).min_by(|a, b| abscissae[*a].abs().total_cmp(&abscissae[*b].abs())).unwrap_or(0)
}

/// Returns the index of the next point of a curve toward its anchor, whose index is `zero`. A rise is the difference of
/// force between the two points.
pub fn towards_zero(point: usize, zero: usize) -> usize {
    if point > zero { point - 1 } else { point + 1 }
}

impl Unknowns {
    /// Returns an [`Unknown::Rise`] for every point of a curve except its anchor.
    pub fn rises(base: &Params, curve: CurveName) -> Vec<Unknown> {
        let u = base.list(curve.abscissae());
        let zero = anchor(u);
        (0..u.len()).filter(|point| *point != zero).map(|point| Unknown::Rise { curve, point }).collect()
    }

    /// Returns the values of the unknowns in the base set, as a vector.
    pub fn start(&self) -> Vec<f64> {
        self.list
            .iter()
            .map(|unknown| match unknown {
                Unknown::Log(number) => libm::log(self.base.number(*number).max(1e-12)),
                Unknown::Linear(number) => self.base.number(*number),
                Unknown::Above(number, below) => self.base.number(*number) / self.base.number(*below).max(1e-9) - 1.0,
                Unknown::Entry(list, i) => self.base.list(*list)[*i],
                Unknown::Rise { curve, point } => {
                    let f = self.base.list(curve.forces());
                    let zero = anchor(self.base.list(curve.abscissae()));
                    let inner = towards_zero(*point, zero);
                    (f[*point] - f[inner]).abs()
                }
            })
            .collect()
    }

    /// Returns the lower and upper bounds of the unknowns, scaled to the size of the damper.
    pub fn bounds(&self) -> (Vec<f64>, Vec<f64>) {
        let scale = Scale::from_params(&self.base);
        self.list
            .iter()
            .map(|unknown| match unknown {
                Unknown::Log(number) => {
                    let (low, high) = scale.reach(*number);
                    // A Stribeck peak acts at very low speeds. A wider peak would be a second FV curve.
                    let high = if WIDTHS.contains(number) { high.min(STRIBECK_WIDEST) } else { high };
                    (libm::log(low.max(1e-6 * scale.of_number(*number))), libm::log(high))
                }
                Unknown::Above(..) => (0.0, HIGHEST_PEAK),
                Unknown::Linear(number) => scale.reach(*number),
                Unknown::Entry(list, _) => list.bounds(),
                // Even a curve with the largest number of points stays within the bounds of its forces.
                Unknown::Rise { .. } => (0.0, 3e4 * scale.force()),
            })
            .unzip()
    }

    /// Returns the parameter set for values `theta` of the unknowns.
    pub fn params(&self, theta: &[f64]) -> Params {
        let mut params = self.base;
        for curve in [CurveName::Fv, CurveName::Spring] {
            let u = params.list(curve.abscissae()).to_vec();
            let mut f = params.list(curve.forces()).to_vec();
            let zero = anchor(&u);
            let rises: Vec<(usize, f64)> = self
                .list
                .iter()
                .zip(theta)
                .filter_map(|(unknown, t)| match unknown {
                    Unknown::Rise { curve: c, point } if *c == curve => Some((*point, *t)),
                    _ => None,
                })
                .collect();
            if rises.is_empty() {
                continue;
            }
            f[zero] = 0.0;
            let rise = |point: usize| rises.iter().find(|r| r.0 == point).map_or(0.0, |r| r.1);
            for point in zero + 1..f.len() {
                f[point] = f[point - 1] + rise(point);
            }
            for point in (0..zero).rev() {
                f[point] = f[point + 1] - rise(point);
            }
            // Within the bounds of [`Unknowns::bounds`], every entry is within the range of the table. If the table
            // rejected the list, the base curve would stay unchanged.
            let _ = params.set_list(curve.forces(), &f);
        }
        for (unknown, t) in self.list.iter().zip(theta) {
            match unknown {
                Unknown::Log(number) => set_inside(&mut params, *number, libm::exp(*t)),
                Unknown::Linear(number) => set_inside(&mut params, *number, *t),
                Unknown::Entry(list, i) => {
                    let mut values = params.list(*list).to_vec();
                    values[*i] = *t;
                    let _ = params.set_list(*list, &values);
                }
                // The parameter `below` is already set, because it precedes `number` in every list.
                Unknown::Above(number, below) => {
                    let level = params.number(*below);
                    set_inside(&mut params, *number, level * (1.0 + t));
                }
                Unknown::Rise { .. } => {}
            }
        }
        params
    }
}

/// Sets a scalar, clamped to its bounds: exp(ln(bound)) may exceed a bound by rounding.
fn set_inside(params: &mut Params, number: Number, value: f64) {
    let _ = params.set(number, number.inside(value));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_start_vector_stands_for_the_base_set() {
        let base = Params::new();
        let mut list = Unknowns::rises(&base, CurveName::Fv);
        list.extend([Unknown::Log(number!("series_stiffness")), Unknown::Linear(number!("gas_force"))]);
        let unknowns = Unknowns { base, list };
        let back = unknowns.params(&unknowns.start());
        for (a, b) in back.list(list!("fv_force")).iter().zip(base.list(list!("fv_force"))) {
            assert!((a - b).abs() < 1e-9);
        }
        assert!(
            (back.number(number!("series_stiffness")) / base.number(number!("series_stiffness")) - 1.0).abs() < 1e-12
        );
        assert_eq!(back.number(number!("gas_force")), base.number(number!("gas_force")));
    }
}
