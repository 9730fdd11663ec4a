//! The entries of a drawing: key, unit, bounds, tolerance and meaning of each.

/// A numerical entry of a drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Entry {
    /// Inner diameter of the tube in which the piston runs.
    Bore,
    /// Diameter of the rod.
    Rod,
    /// Length of the oil between the piston and the rod guide.
    ReboundChamber,
    /// Length of the oil between the piston and the base valve or floating piston.
    CompressionChamber,
    /// Total volume of oil and gas in the reserve.
    ReserveVolume,
    /// Volume of the oil in the reserve.
    ReserveOil,
    /// Volume of the gas.
    GasVolume,
    /// Gauge pressure of the gas.
    GasPressure,
    /// Temperature at which the gas has the stated pressure.
    GasTemperature,
    /// Volume of all oil.
    OilVolume,
    /// Bulk modulus of the oil without air.
    OilModulus,
    /// Density of the oil.
    OilDensity,
    /// Volume fraction of the free air in the oil at atmospheric pressure.
    AirContent,
    /// Wall thickness of the tube in which the piston runs.
    TubeWall,
    /// Young's modulus of the tube in which the piston runs.
    TubeModulus,
    /// Stiffness of eyes and mounts in series with the damper.
    EyeStiffness,
    /// Discharge coefficient of the valves' passages.
    DischargeCoefficient,
}

/// Properties of an entry.
#[derive(Debug, Clone, Copy)]
pub struct EntryRow {
    /// The entry.
    pub entry: Entry,
    /// Key in the file, with the unit.
    pub key: &'static str,
    /// Factor from the file's unit to SI; temperatures stay in °C.
    pub to_si: f64,
    /// Bounds in the unit of the file. A number outside the bounds is an error.
    pub bounds: (f64, f64),
    /// Half-width of the 95 % interval of a single number, as a fraction of the number.
    pub tolerance: f64,
    /// Meaning of the entry.
    pub meaning: &'static str,
}

const fn row(
    entry: Entry,
    key: &'static str,
    to_si: f64,
    bounds: (f64, f64),
    tolerance: f64,
    meaning: &'static str,
) -> EntryRow {
    EntryRow { entry, key, to_si, bounds, tolerance, meaning }
}

/// The table of entries, in the order of [`Entry`]. Tolerances are those of production (bore and rod to ISO 286 IT 9)
/// and of filling with oil and gas. Lengths have a wider tolerance, because the lengths of a drawing do not account for
/// valves and washers. With tighter tolerances, ordinary differences of measurement would be reported as
/// contradictions.
pub const ENTRIES: [EntryRow; 17] = [
    row(Entry::Bore, "bore_mm", 1e-3, (5.0, 300.0), 0.005, "inner diameter of the tube in which the piston runs"),
    row(Entry::Rod, "rod_mm", 1e-3, (1.0, 150.0), 0.005, "diameter of the rod"),
    row(
        Entry::ReboundChamber,
        "rebound_chamber_mm",
        1e-3,
        (5.0, 2000.0),
        0.05,
        "length of the oil between piston and rod guide at displacement zero",
    ),
    row(
        Entry::CompressionChamber,
        "compression_chamber_mm",
        1e-3,
        (5.0, 2000.0),
        0.05,
        "length of the oil between piston and base valve or floating piston at displacement zero",
    ),
    row(
        Entry::ReserveVolume,
        "reserve_volume_cm3",
        1e-6,
        (1.0, 20_000.0),
        0.03,
        "volume of the reserve, oil and gas together",
    ),
    row(Entry::ReserveOil, "reserve_oil_cm3", 1e-6, (0.0, 20_000.0), 0.05, "volume of the oil in the reserve"),
    row(Entry::GasVolume, "gas_volume_cm3", 1e-6, (0.5, 20_000.0), 0.08, "volume of the gas at displacement zero"),
    row(
        Entry::GasPressure,
        "gas_pressure_bar",
        1e5,
        (0.0, 200.0),
        0.05,
        "gauge pressure of the gas at displacement zero",
    ),
    row(
        Entry::GasTemperature,
        "gas_temperature_c",
        1.0,
        (-40.0, 150.0),
        0.0,
        "temperature at which the gas has the stated pressure; default 20",
    ),
    row(Entry::OilVolume, "oil_volume_cm3", 1e-6, (1.0, 50_000.0), 0.05, "volume of all oil"),
    row(Entry::OilModulus, "oil_modulus_gpa", 1e9, (0.2, 4.0), 0.1, "bulk modulus of the oil without air"),
    row(Entry::OilDensity, "oil_density_kg_m3", 1.0, (600.0, 1500.0), 0.03, "density of the oil"),
    row(
        Entry::AirContent,
        "air_percent",
        1e-2,
        (1e-3, 20.0),
        0.5,
        "free air in the oil, percent of its volume at 1.013 bar absolute",
    ),
    row(
        Entry::TubeWall,
        "tube_wall_mm",
        1e-3,
        (0.2, 50.0),
        0.05,
        "wall thickness of the tube in which the piston runs",
    ),
    row(
        Entry::TubeModulus,
        "tube_modulus_gpa",
        1e9,
        (10.0, 400.0),
        0.03,
        "Young's modulus of the tube in which the piston runs; default 206 (steel)",
    ),
    row(
        Entry::EyeStiffness,
        "eye_stiffness_n_mm",
        1e3,
        (10.0, 1e6),
        0.2,
        "stiffness of eyes and mounts on the rig, in series",
    ),
    row(
        Entry::DischargeCoefficient,
        "discharge_coefficient",
        1.0,
        (0.3, 1.0),
        0.05,
        "discharge coefficient of the valves' passages; default 0.6 to 0.8",
    ),
];

impl Entry {
    /// Returns the row of the entry in the table.
    pub fn row(self) -> &'static EntryRow {
        // A test checks that rows have the order of the entries.
        &ENTRIES[self as usize]
    }

    /// Returns the key of the entry in the file.
    pub fn key(self) -> &'static str {
        self.row().key
    }
}

/// Key of the only entry with a word as its value.
pub const DESIGN: &str = "design";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_the_entries_and_have_room() {
        for (place, row) in ENTRIES.iter().enumerate() {
            assert_eq!(row.entry as usize, place, "{}", row.key);
            assert!(row.bounds.0 < row.bounds.1 && row.to_si > 0.0 && !row.meaning.is_empty());
        }
    }
}
