//! Drawing of a damper: stated entries in SI units, and handbook values for missing entries.

use crate::entry::{ENTRIES, Entry};
use crate::geometry::{annulus, area};
use crate::uncertain::{Uncertain, through};

/// Design of the damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Design {
    /// One tube. The gas is behind a floating piston or in contact with the oil.
    Monotube,
    /// A pressure tube with a base valve in a second tube, which is the reserve.
    TwinTube,
}

/// Entries of a drawing. Every entry is optional.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Dimensions {
    /// Design of the damper.
    pub design: Option<Design>,
    entries: [Option<Uncertain>; ENTRIES.len()],
}

/// Bulk modulus of damper oil without air, Pa: 1.2 to 1.7 GPa warm and cold (Duym & Reybrouck, Eur. J. Mech. Eng. 43,
/// 1998), and down to 0.9 GPa hot (Dixon, The Shock Absorber Handbook, 2007, chapter 5). A narrower interval would give
/// contradictions for warm oil.
const OIL_MODULUS: Uncertain = Uncertain { value: 1.25e9, low: 0.88e9, high: 1.75e9 };
/// Density of damper oil, kg/m³: 825 to 890 at 15 °C, and 4 % less at 70 °C (Dixon 2007, chapter 5).
const OIL_DENSITY: Uncertain = Uncertain { value: 850.0, low: 800.0, high: 890.0 };
/// Young's modulus of steel, Pa.
const TUBE_MODULUS: Uncertain = Uncertain { value: 206e9, low: 200e9, high: 212e9 };
/// Wall thickness of pressure tubes, m: 1.2 to 1.5 mm in twin tubes, 2 to 2.5 mm in monotubes (Dixon 2007, chapter 1).
/// The tube contributes a tenth of the oil column's compliance.
const TUBE_WALL: Uncertain = Uncertain { value: 1.8e-3, low: 1.1e-3, high: 3e-3 };
/// Discharge coefficient of sharp and slightly rounded passages (Merritt, Hydraulic Control Systems, 1967, chapter 3;
/// Dixon 2007, chapter 6). Computed areas are inversely proportional to the coefficient.
const DISCHARGE: Uncertain = Uncertain { value: 0.7, low: 0.6, high: 0.8 };
/// Temperature of a workshop, °C.
const WORKSHOP: Uncertain = Uncertain { value: 20.0, low: 15.0, high: 25.0 };

impl Dimensions {
    /// Returns the stated value of an entry, or `None` if these dimensions do not state it.
    pub fn stated(&self, entry: Entry) -> Option<Uncertain> {
        self.entries[entry as usize]
    }

    /// Returns these dimensions with `entry` stated as `value`, in SI units (a temperature in °C).
    pub fn with(mut self, entry: Entry, value: Uncertain) -> Dimensions {
        self.entries[entry as usize] = Some(value);
        self
    }

    /// Returns the stated value of an entry, or its value from handbooks or other entries. Returns `None` if the value
    /// is unknown.
    pub fn known(&self, entry: Entry) -> Option<Uncertain> {
        self.stated(entry).or_else(|| match entry {
            Entry::OilModulus => Some(OIL_MODULUS),
            Entry::OilDensity => Some(OIL_DENSITY),
            Entry::TubeModulus => Some(TUBE_MODULUS),
            Entry::TubeWall => Some(TUBE_WALL),
            Entry::DischargeCoefficient => Some(DISCHARGE),
            Entry::GasTemperature => Some(WORKSHOP),
            _ => self.by_others(entry),
        })
    }

    /// Computes a volume, m³, from the other stated entries. The oil volume is that of the chambers, plus the reserve's
    /// oil if that is stated. Returns `None` for entries that are no volumes of gas or oil, and if the volume is
    /// unknown.
    pub fn by_others(&self, entry: Entry) -> Option<Uncertain> {
        match entry {
            Entry::GasVolume => {
                let both = [self.stated(Entry::ReserveVolume)?, self.stated(Entry::ReserveOil)?];
                bounded(&both, |x| x[0] - x[1])
            }
            Entry::OilVolume => {
                let chambers = [Entry::Bore, Entry::Rod, Entry::ReboundChamber, Entry::CompressionChamber];
                let mut all = chambers.into_iter().map(|entry| self.stated(entry)).collect::<Option<Vec<_>>>()?;
                all.extend(self.stated(Entry::ReserveOil));
                bounded(&all, |x| annulus(x[0], x[1]) * x[2] + area(x[0]) * x[3] + x.get(4).unwrap_or(&0.0))
            }
            _ => None,
        }
    }

    /// Returns whether these dimensions have no entries.
    pub fn is_empty(&self) -> bool {
        self.design.is_none() && self.entries.iter().all(Option::is_none)
    }

    /// Returns the keys of those entries in `needed` whose values are unknown.
    pub fn missing(&self, needed: &[Entry]) -> Vec<&'static str> {
        needed.iter().filter(|entry| self.known(**entry).is_none()).map(|entry| entry.key()).collect()
    }

    /// Returns the values of the entries in `needed`, or `None` if one of them is unknown.
    pub fn all(&self, needed: &[Entry]) -> Option<Vec<Uncertain>> {
        needed.iter().map(|entry| self.known(*entry)).collect()
    }
}

/// Computes a positive number from the values of entries. Returns `None` if its interval reaches zero or is unbounded.
fn bounded(inputs: &[Uncertain], formula: impl Fn(&[f64]) -> f64) -> Option<Uncertain> {
    let found = through(inputs, formula);
    let (value, low, high) = (found.value?, found.low?, found.high?);
    (low > 0.0).then_some(Uncertain { value, low, high })
}
