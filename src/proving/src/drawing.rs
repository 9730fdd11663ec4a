//! Drawing (stated dimensions) of a damper of the second laboratory. The stated values have errors, and the true values
//! are known.

use dashpot_dimensions::{Dimensions, Entry, orifice, read};
use dashpot_other_lab::Kind;
use dashpot_other_lab::plant::{Built, Plant, flow::Valves};
use std::path::Path;

/// A damper with its drawing.
pub struct Drawing {
    built: Built,
    kind: Kind,
    mount: f64,
    /// True discharge coefficient of the valves. `density` is the true density of the oil, kg/m³.
    discharge: f64,
    density: f64,
    errors: Vec<f64>,
}

/// Factor from bar to Pa. [`GPA`] is the factor from GPa to Pa.
const BAR: f64 = 1e5;
const GPA: f64 = 1e9;
/// Atmospheric pressure in the laboratory, bar.
const AIR: f64 = 1.0;

/// Entries of a drawing with their relative tolerances, which contain 95 % of the errors. The order determines the
/// random error of each entry.
const ENTRIES: [(Entry, f64); 9] = [
    (Entry::Bore, 0.005),
    (Entry::Rod, 0.005),
    (Entry::ReboundChamber, 0.05),
    (Entry::CompressionChamber, 0.05),
    (Entry::GasPressure, 0.05),
    (Entry::GasVolume, 0.08),
    (Entry::OilModulus, 0.1),
    (Entry::EyeStiffness, 0.2),
    (Entry::AirContent, 0.5),
];

/// Returns a number between 0 and 1 from a seed and an index `place` (splitmix64).
fn uniform(seed: u64, place: u64) -> f64 {
    let mut z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add((place + 1).wrapping_mul(0xbf58_476d_1ce4_e5b9));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
}

/// Returns a sample of the standard normal distribution from a seed and an index.
fn normal(seed: u64, place: u64) -> f64 {
    let radius = libm::sqrt(-2.0 * libm::log(1.0 - uniform(seed, 2 * place)));
    radius * libm::cos(std::f64::consts::TAU * uniform(seed, 2 * place + 1))
}

impl Drawing {
    /// Makes the drawing of the damper that a seed selects. Returns `None` if the damper has no chambers.
    pub fn new(kind: Kind, seed: u64) -> Option<Drawing> {
        let plant = Plant::new(kind, seed);
        let errors = (0..ENTRIES.len() as u64).map(|place| normal(seed, 10 + place)).collect();
        Some(Drawing {
            built: plant.built?,
            kind,
            mount: plant.mount.stiffness,
            discharge: 0.6 + 0.2 * uniform(seed, 0),
            density: 800.0 + 90.0 * uniform(seed, 1),
            errors,
        })
    }

    /// Returns the true value of an entry, in the unit of its key.
    fn entry(&self, entry: Entry) -> f64 {
        let built = &self.built;
        match entry {
            Entry::Bore => 1e3 * built.bore_m,
            Entry::Rod => 1e3 * built.rod_m,
            Entry::ReboundChamber => 1e3 * built.lengths_m[0],
            Entry::CompressionChamber => 1e3 * built.lengths_m[1],
            Entry::GasPressure => built.gas_bar - AIR,
            Entry::GasVolume => 1e6 * built.gas_m3,
            Entry::OilModulus => built.oil_bar * BAR / GPA,
            Entry::EyeStiffness => 1e-3 * self.mount,
            Entry::AirContent => 100.0 * built.air,
            _ => f64::NAN,
        }
    }

    /// Makes the drawing with the given entries. Each entry has a random error, which is within the tolerance of the
    /// entry in 95 % of the dampers. The tube of the drawing is nearly rigid, like the tubes of the laboratory.
    ///
    /// # Panics
    /// Panics if the reader of dimensions rejects the drawing.
    pub fn with(&self, entries: &[Entry]) -> Dimensions {
        let mut text = format!("design = \"{}\"\n", if self.kind == Kind::Monotube { "monotube" } else { "twin_tube" });
        for ((entry, tolerance), error) in ENTRIES.iter().zip(&self.errors).filter(|((e, _), _)| entries.contains(e)) {
            let value = self.entry(*entry) * libm::exp(error * tolerance / 1.96);
            text += &format!("{} = {value}\n", entry.key());
        }
        if entries.contains(&Entry::Bore) {
            text += "tube_wall_mm = 50\ntube_modulus_gpa = 400\n";
        }
        read::parse(&text, Path::new("drawing.toml")).expect("a drawing of the laboratory")
    }

    /// Returns the true value of a quantity of an explanation, in the unit of the explanation. `force` is the largest
    /// force of the FV table in the stroke of the quantity, N. Returns `None` for an unknown quantity, or if the damper
    /// has no valves with orifice and shim.
    pub fn truth(&self, quantity: &str, force: f64) -> Option<f64> {
        let built = &self.built;
        let stroke = usize::from(quantity.starts_with("compression"));
        let (valves, area) = (&built.valves[stroke], built.areas_m2[stroke]);
        let Valves::OrificeAndShim { bleed: [a, b], shim: [..] } = valves else { return None };
        Some(match quantity {
            "gas_pressure" => built.gas_bar - AIR,
            "gas_volume" => 1e6 * built.gas_m3,
            "oil_modulus_effective" | "oil_modulus" => built.modulus_bar() * BAR / GPA,
            "air_content" => 100.0 * built.air,
            _ if quantity.ends_with("bleed_area") => {
                1e6 * orifice::passage_of_quadratic(*b, area, self.discharge, self.density)
            }
            _ if quantity.ends_with("leak") => 1e11 * orifice::leak_of_linear(*a, area),
            _ if quantity.ends_with("blow_off_area") => {
                let through_valve = valves.velocity(force, 1.0) - valves.bleed(force, 1.0);
                1e6 * orifice::passage_area(area * through_valve, force / area, self.discharge, self.density)
            }
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn physical_dampers_have_a_drawing_and_it_is_theirs() {
        assert!(Drawing::new(Kind::ThesisLike, 1).is_none());
        for kind in [Kind::Monotube, Kind::TwinTube] {
            for seed in 1..10 {
                let drawing = Drawing::new(kind, seed).unwrap();
                let read = drawing.with(&ENTRIES.map(|(entry, _)| entry));
                let rod = 1e3 * read.stated(Entry::Rod).unwrap().value;
                assert!((rod / drawing.entry(Entry::Rod) - 1.0).abs() < 0.02, "{rod}");
                assert!(drawing.truth("rebound_bleed_area", 0.0).unwrap() > 0.1);
            }
        }
    }
}
