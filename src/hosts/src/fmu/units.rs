//! Units that an FMU declares.
//!
//! Parameters and states have the units of the parameter table. Motion and force have the units of the host.
//!
//! An importer converts values with the declared units, and then the FMU scales them by `motion_scale` and `force_scale`. So the FMU must
//! declare the units that its values have before these scales. If the FMU declared meters for a host in millimeters, the values would be
//! converted twice.

use super::scales::Scales;

/// A unit that an FMU may declare.
#[derive(Debug, Clone, PartialEq)]
pub struct Unit {
    /// Name of the unit. It is "-" for a pure number, and if the host's unit has no name.
    pub name: String,
    /// Size of the unit in `si`.
    pub factor: f64,
    /// SI unit of the same quantity, or degC for a temperature. It determines the dimensions.
    pub si: &'static str,
}

impl From<&'static str> for Unit {
    fn from(si: &'static str) -> Unit {
        Unit { name: si.to_owned(), factor: 1.0, si }
    }
}

/// Known units of a setting: name, size in SI units, and SI unit. The size of psi follows from pound-force and inch.
const OF_A_SETTING: [(&str, f64, &str); 14] = [
    ("A", 1.0, "A"),
    ("mA", 1e-3, "A"),
    ("V", 1.0, "V"),
    ("mV", 1e-3, "V"),
    ("Pa", 1.0, "Pa"),
    ("kPa", 1e3, "Pa"),
    ("MPa", 1e6, "Pa"),
    ("bar", 1e5, "Pa"),
    ("psi", 4.4482216152605 / (0.0254 * 0.0254), "Pa"),
    ("s", 1.0, "s"),
    ("m", 1.0, "m"),
    ("N", 1.0, "N"),
    ("kg", 1.0, "kg"),
    ("degC", 1.0, "degC"),
];

impl Unit {
    /// Returns the unit of a setting from its name in the model file, or "-" for an empty name.
    pub fn of_setting(name: &str) -> Unit {
        match OF_A_SETTING.iter().find(|(known, ..)| *known == name) {
            Some((_, factor, si)) => Unit { name: name.to_owned(), factor: *factor, si },
            None if name.is_empty() => "-".into(),
            None => Unit { name: name.to_owned(), factor: 1.0, si: "" },
        }
    }

    /// Returns whether the FMU declares the unit. It declares every unit with a name.
    pub fn is_declared(&self) -> bool {
        self.name != "-"
    }

    /// Returns the dimensions of the unit in SI as attributes of FMI's `BaseUnit`, if known. Other units are declared by name only.
    pub fn dimensions(&self) -> Option<&'static str> {
        Some(match self.si {
            "s" => "s=\"1\"",
            "A" => "A=\"1\"",
            "V" => "kg=\"1\" m=\"2\" s=\"-3\" A=\"-1\"",
            "Pa" => "kg=\"1\" m=\"-1\" s=\"-2\"",
            "m" => "m=\"1\"",
            "m/s" => "m=\"1\" s=\"-1\"",
            "m/s^2" => "m=\"1\" s=\"-2\"",
            "s/m" => "m=\"-1\" s=\"1\"",
            "N" => "kg=\"1\" m=\"1\" s=\"-2\"",
            "N/m" => "kg=\"1\" s=\"-2\"",
            "N/m^2" => "kg=\"1\" m=\"-1\" s=\"-2\"",
            "N/m^3" => "kg=\"1\" m=\"-2\" s=\"-2\"",
            "N/m^4" => "kg=\"1\" m=\"-3\" s=\"-2\"",
            "N s/m" => "kg=\"1\" s=\"-1\"",
            "N s^2/m" => "kg=\"1\"",
            "N s^2/m^2" => "kg=\"1\" m=\"-1\"",
            "kg" => "kg=\"1\"",
            "degC" => "K=\"1\" offset=\"273.15\"",
            "1/K" => "K=\"-1\"",
            "J/K" => "kg=\"1\" m=\"2\" s=\"-2\" K=\"-1\"",
            "W/K" => "kg=\"1\" m=\"2\" s=\"-3\" K=\"-1\"",
            _ => return None,
        })
    }
}

/// Units of length with their size in m.
///
/// The list contains the SI prefixes of lengths, and the two customary units of vehicle drawings outside the SI.
const LENGTHS: [(&str, f64); 8] =
    [("m", 1.0), ("dm", 0.1), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("km", 1e3), ("in", 0.0254), ("ft", 0.3048)];

/// Units of force with their size in N. The pound-force is 0.45359237 kg times 9.80665 m/s^2. Both values are exact by definition.
const FORCES: [(&str, f64); 8] = [
    ("N", 1.0),
    ("daN", 10.0),
    ("kN", 1e3),
    ("MN", 1e6),
    ("mN", 1e-3),
    ("uN", 1e-6),
    ("lbf", 4.4482216152605),
    ("kgf", 9.80665),
];

/// Largest relative difference between a scale and the size of a unit at which the scale is interpreted as this unit.
///
/// A user may type 0.22481 for the reciprocal of the pound-force, which differs by 5e-6. With a larger tolerance, a motion ratio near 1
/// would be ignored.
const NEAR: f64 = 1e-5;

fn named(units: &[(&'static str, f64)], size: f64) -> Option<(&'static str, f64)> {
    units.iter().copied().find(|(_, factor)| (size / factor - 1.0).abs() < NEAR)
}

/// Units in which a host states motion and force. A unit is `None` if a scale corresponds to no unit.
pub struct HostUnits {
    length: Option<(&'static str, f64)>,
    force: Option<(&'static str, f64)>,
}

impl HostUnits {
    /// Returns the units of a host with these scales; the signs of the scales have no effect. A scale that includes a motion ratio usually
    /// corresponds to no unit.
    pub fn from_scales(scales: Scales) -> HostUnits {
        HostUnits { length: named(&LENGTHS, scales.motion.abs()), force: named(&FORCES, 1.0 / scales.force.abs()) }
    }

    /// Returns the host's unit of displacement.
    pub fn displacement(&self) -> Unit {
        self.length.map_or("-".into(), |(name, factor)| Unit { name: name.into(), factor, si: "m" })
    }

    /// Returns the host's unit of velocity.
    pub fn velocity(&self) -> Unit {
        self.length.map_or("-".into(), |(name, factor)| Unit { name: format!("{name}/s"), factor, si: "m/s" })
    }

    /// Returns the host's unit of force.
    pub fn force(&self) -> Unit {
        self.force.map_or("-".into(), |(name, factor)| Unit { name: name.into(), factor, si: "N" })
    }

    /// Returns the unit of the derivative of force with respect to displacement.
    pub fn stiffness(&self) -> Unit {
        self.slope("/", "N/m")
    }

    /// Returns the unit of the derivative of force with respect to velocity.
    pub fn damping(&self) -> Unit {
        self.slope(" s/", "N s/m")
    }

    fn slope(&self, between: &str, si: &'static str) -> Unit {
        match (self.force, self.length) {
            (Some((force, newtons)), Some((length, metres))) => {
                Unit { name: format!("{force}{between}{length}"), factor: newtons / metres, si }
            }
            _ => "-".into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(motion: f64, force: f64) -> HostUnits {
        HostUnits::from_scales(Scales { motion, force, position_offset: 0.0, start: 0.0 })
    }

    #[test]
    fn scales_stand_for_units_whatever_their_sign() {
        for (motion, force, names, factors) in [
            (1.0, 1.0, ["m", "m/s", "N", "N/m", "N s/m"], [1.0, 1.0, 1.0, 1.0, 1.0]),
            (-0.001, -0.001, ["mm", "mm/s", "kN", "kN/mm", "kN s/mm"], [1e-3, 1e-3, 1e3, 1e6, 1e6]),
            (0.01, 0.1, ["cm", "cm/s", "daN", "daN/cm", "daN s/cm"], [1e-2, 1e-2, 10.0, 1e3, 1e3]),
            (0.001, 1.0, ["mm", "mm/s", "N", "N/mm", "N s/mm"], [1e-3, 1e-3, 1.0, 1e3, 1e3]),
            (
                -0.0254,
                0.22481,
                ["in", "in/s", "lbf", "lbf/in", "lbf s/in"],
                [0.0254, 0.0254, 4.4482216152605, 4.4482216152605 / 0.0254, 4.4482216152605 / 0.0254],
            ),
        ] {
            let units = of(motion, force);
            let all = [units.displacement(), units.velocity(), units.force(), units.stiffness(), units.damping()];
            assert_eq!(all.clone().map(|u| u.name), names);
            assert_eq!(all.clone().map(|u| u.factor), factors, "{names:?}");
            assert!(all.iter().all(|u| u.is_declared() && u.dimensions().is_some()));
        }
    }

    /// An importer that confuses mA with A commands a thousandth of the current.
    #[test]
    fn units_of_settings_have_their_dimensions() {
        for (name, factor, dimensions) in [
            ("mA", 1e-3, "A=\"1\""),
            ("V", 1.0, "kg=\"1\" m=\"2\" s=\"-3\" A=\"-1\""),
            ("bar", 1e5, "kg=\"1\" m=\"-1\" s=\"-2\""),
        ] {
            let unit = Unit::of_setting(name);
            assert_eq!((unit.name.as_str(), unit.factor, unit.dimensions()), (name, factor, Some(dimensions)));
        }
        assert!((Unit::of_setting("psi").factor - 6894.757293168).abs() < 1e-6);
        assert!(!Unit::of_setting("").is_declared() && Unit::of_setting("%").dimensions().is_none());
    }

    #[test]
    fn a_scale_with_a_motion_ratio_in_it_stands_for_no_unit() {
        let units = of(-0.85, -1.0);
        assert_eq!(
            [units.displacement(), units.velocity(), units.stiffness(), units.damping()],
            [(); 4].map(|()| "-".into())
        );
        assert_eq!(units.force().name, "N");
        let units = of(0.001, 0.7);
        assert_eq!(
            (units.displacement().name.as_str(), units.force().is_declared(), units.damping().is_declared()),
            ("mm", false, false)
        );
    }

    #[test]
    fn no_two_units_lie_so_near_that_one_scale_stands_for_both() {
        for units in [LENGTHS, FORCES] {
            for (i, (name, factor)) in units.iter().enumerate() {
                assert_eq!(named(&units, *factor).map(|u| u.0), Some(units[i].0), "{name}");
            }
        }
    }
}
