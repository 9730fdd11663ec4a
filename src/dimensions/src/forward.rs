//! Forward formulas: priors of the model's parameters from a drawing.

use crate::dimensions::{Design, Dimensions};
use crate::entry::Entry;
use crate::gas;
use crate::geometry::annulus;
use crate::oil;
use crate::uncertain::{Uncertain, through};
use dashpot_core::number;
use dashpot_core::parameter::Number;
use dashpot_estimation::distribution::Distribution;
use dashpot_estimation::prior_set::{DamperPrior, PriorSet};

/// A parameter with the value that a drawing implies.
#[derive(Debug, Clone, PartialEq)]
pub struct Expectation {
    /// The parameter.
    pub number: Number,
    /// Name of the parameter as English text.
    pub noun: &'static str,
    /// Implied value in the unit of the parameter. The 95 % interval includes the errors of the entries and of the
    /// formula.
    pub expected: Uncertain,
    /// Keys of the stated entries from which the value follows.
    pub from: Vec<&'static str>,
    /// Source of the formula.
    pub source: &'static str,
}

/// Shape of a parameter's distribution.
#[derive(Clone, Copy)]
enum Shape {
    /// Symmetric in the logarithm, for parameters whose logarithm is searched.
    Size,
    /// Symmetric in the parameter itself.
    Place,
}

/// A formula from entries to a parameter.
struct Rule {
    number: Number,
    noun: &'static str,
    needs: &'static [Entry],
    /// Entries that must be stated. Without them, the result would depend only on handbook values.
    states: &'static [Entry],
    design: Option<Design>,
    formula: fn(&[f64]) -> f64,
    /// Form error: in 95 of 100 dampers, fitted parameter and formula agree within this factor.
    form: f64,
    shape: Shape,
    source: &'static str,
}

use Entry::{
    AirContent, Bore, CompressionChamber, EyeStiffness, GasPressure, GasTemperature, GasVolume, OilModulus, OilVolume,
    ReboundChamber, Rod, TubeModulus, TubeWall,
};

const GAS: &str = "Dixon 2007, chapter 5";
const COLUMN: &str = "Merritt 1967, chapter 2; Lamé's tube";
const TWIN: &str = "Segel & Lang 1981; Duym & Reybrouck 1998";
const EYES: &str = "springs in line";

/// Computes the modulus of oil and tube together, Pa. Both moduli are in Pa, the bore and the wall thickness in m. Air
/// is a separate element.
fn modulus(oil_modulus: f64, bore: f64, wall: f64, tube: f64) -> f64 {
    1.0 / (1.0 / oil_modulus + oil::tube_compliance(bore, wall, tube))
}

/// Formulas from entries to parameters. If the form error of a formula is too small, sound dampers have contradictions.
/// If the form error is too large, the prior does not help to distinguish effects.
const RULES: &[Rule] = &[
    Rule {
        number: number!("gas_force"),
        noun: "gas force",
        needs: &[GasPressure, Rod],
        states: &[GasPressure, Rod],
        design: None,
        formula: |x| gas::force(x[0], x[1]),
        // The form error covers gas that is up to 25 K warmer than during filling, and a load cell offset of some
        // newtons.
        form: 1.15,
        shape: Shape::Place,
        source: GAS,
    },
    Rule {
        number: number!("gas_warming_rate"),
        noun: "growth of the gas force with temperature",
        needs: &[GasPressure, GasTemperature, Rod, OilVolume, GasVolume],
        states: &[GasPressure, Rod],
        design: None,
        formula: |x| gas::warming(x[0], x[1], x[2], x[3] / x[4]),
        form: 2.0,
        shape: Shape::Place,
        source: GAS,
    },
    Rule {
        number: number!("gas_stiffness"),
        noun: "gas stiffness",
        needs: &[GasPressure, GasVolume, Rod],
        states: &[GasPressure, Rod],
        design: None,
        formula: |x| gas::stiffness(x[0], x[1], x[2]),
        // The formula gives the slow stiffness. The stiffness in a fast test is up to 1.4 times as large.
        form: 1.5,
        shape: Shape::Place,
        source: GAS,
    },
    Rule {
        number: number!("gas_length"),
        noun: "length of the gas column",
        needs: &[GasVolume, Rod],
        states: &[Rod],
        design: None,
        formula: |x| gas::length(x[0], x[1]),
        form: 1.5,
        shape: Shape::Size,
        source: GAS,
    },
    Rule {
        number: number!("cavitation_force"),
        noun: "cavitation cap",
        needs: &[GasPressure, Bore, Rod],
        states: &[GasPressure, Bore, Rod],
        design: Some(Design::Monotube),
        formula: |x| gas::cavitation_force(x[0], x[1], x[2]),
        form: 1.4,
        shape: Shape::Size,
        source: GAS,
    },
    Rule {
        number: number!("oil_stiffness"),
        noun: "stiffness of the oil column",
        needs: &[OilModulus, Bore, Rod, ReboundChamber, TubeWall, TubeModulus],
        states: &[Bore, Rod, ReboundChamber],
        design: None,
        formula: |x| oil::rebound_stiffness(modulus(x[0], x[1], x[4], x[5]), x[1], x[2], x[3]),
        // If the model has no element for the air, the air makes the fitted column softer than the formula.
        form: 1.6,
        shape: Shape::Size,
        source: COLUMN,
    },
    Rule {
        number: number!("oil_shortening"),
        noun: "shortening of the oil column",
        needs: &[ReboundChamber],
        states: &[ReboundChamber],
        design: None,
        formula: |x| 1.0 / x[0],
        form: 1.5,
        shape: Shape::Place,
        source: COLUMN,
    },
    Rule {
        number: number!("oil_compression"),
        noun: "stiffness of the oil column in compression over that in rebound",
        needs: &[Bore, Rod, ReboundChamber, CompressionChamber],
        states: &[Bore, Rod, ReboundChamber, CompressionChamber],
        design: Some(Design::TwinTube),
        formula: |x| oil::compression_ratio(Design::TwinTube, x[0], x[1], [x[2], x[3]]),
        form: 2.0,
        shape: Shape::Size,
        source: TWIN,
    },
    Rule {
        number: number!("aeration_force"),
        noun: "force that halves the air's stroke",
        needs: &[GasPressure, Bore, Rod],
        states: &[GasPressure, Bore, Rod],
        design: None,
        // Free air means a loss of gas pressure. Therefore, the formula uses the geometric mean of atmospheric pressure
        // and the pressure of the drawing.
        formula: |x| libm::sqrt((x[0] + oil::ATMOSPHERE) * oil::ATMOSPHERE) * annulus(x[1], x[2]),
        form: 4.0,
        shape: Shape::Size,
        source: COLUMN,
    },
    Rule {
        number: number!("aeration_stroke"),
        noun: "stroke that the air yields",
        needs: &[AirContent, GasPressure, Bore, Rod, ReboundChamber],
        states: &[AirContent, GasPressure, Bore, Rod, ReboundChamber],
        design: None,
        formula: |x| oil::air_stroke(x[0], x[1] + oil::ATMOSPHERE, x[2], x[3], x[4]).0,
        form: 2.0,
        shape: Shape::Size,
        source: COLUMN,
    },
    Rule {
        number: number!("series_stiffness"),
        noun: "series stiffness",
        needs: &[EyeStiffness],
        states: &[EyeStiffness],
        design: None,
        formula: |x| x[0],
        // In a model without an oil column, the series spring also contains the compliance of the oil. It is then
        // softer than the eyes, so the form error is large.
        form: 2.0,
        shape: Shape::Size,
        source: EYES,
    },
];

/// Returns the model parameters that a drawing implies.
pub fn expectations(of: &Dimensions) -> Vec<Expectation> {
    let follows = |rule: &&Rule| {
        rule.states.iter().all(|entry| of.stated(*entry).is_some())
            && (rule.design.is_none() || rule.design == of.design)
    };
    RULES.iter().filter(follows).filter_map(|rule| rule.expectation(of)).collect()
}

/// Returns the central value of a parameter that a drawing implies, or `None` if it implies none.
pub(crate) fn central(of: &Dimensions, number: Number) -> Option<f64> {
    let rule = Rule::of(number)?;
    let inputs: Vec<f64> = of.all(rule.needs)?.iter().map(|input| input.value).collect();
    Some((rule.formula)(&inputs))
}

impl Rule {
    fn expectation(&self, of: &Dimensions) -> Option<Expectation> {
        let mut inputs = of.all(self.needs)?;
        inputs.push(Uncertain::within_factor(1.0, self.form));
        let found = through(&inputs, |x| (self.formula)(x) * x[x.len() - 1]);
        let expected = Uncertain { value: found.value?, low: found.low?, high: found.high? };
        let from = self.needs.iter().filter(|entry| of.stated(**entry).is_some()).map(|entry| entry.key()).collect();
        Some(Expectation { number: self.number, noun: self.noun, expected, from, source: self.source })
    }

    fn of(number: Number) -> Option<&'static Rule> {
        RULES.iter().find(|rule| rule.number == number)
    }
}

/// Returns the priors from a drawing. They replace the priors that apply to all dampers.
pub fn priors(of: &Dimensions) -> PriorSet {
    let row = |expectation: Expectation| {
        let Expectation { number, expected, from, source, .. } = expectation;
        let distribution = match Rule::of(number)?.shape {
            Shape::Size => Distribution::Size(expected.value, expected.factor()),
            Shape::Place => Distribution::Place(expected.value, expected.deviation()),
        };
        Some(DamperPrior { number, expected: distribution, source: format!("{}: {source}", from.join(", ")) })
    };
    PriorSet::new(expectations(of).into_iter().filter_map(row).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::parse;
    use std::path::Path;

    fn of(text: &str) -> Vec<Expectation> {
        expectations(&parse(text, Path::new("D.toml")).unwrap())
    }

    fn find(all: &[Expectation], name: &str) -> Option<Uncertain> {
        all.iter().find(|e| e.number.name() == name).map(|e| e.expected)
    }

    #[test]
    fn every_entry_is_optional_and_gives_what_follows_from_it_alone() {
        assert!(of("").is_empty());
        assert!(of("bore_mm = 40\n").is_empty());
        let gas = of("rod_mm = 11\ngas_pressure_bar = 15\n");
        assert_eq!(gas.len(), 1);
        assert!((gas[0].expected.value - 142.5).abs() < 0.1);
        assert_eq!(gas[0].from, ["gas_pressure_bar", "rod_mm"]);
    }

    #[test]
    fn a_monotube_of_a_car_has_the_numbers_of_one() {
        let all = of("design = \"monotube\"\nbore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = 130\n\
             compression_chamber_mm = 150\ngas_pressure_bar = 25\ngas_volume_cm3 = 90\noil_modulus_gpa = 1.2\n");
        let of = |name| find(&all, name).unwrap_or_else(|| panic!("{name}: {all:?}"));
        assert!((8e6..11e6).contains(&of("oil_stiffness").value), "{:?}", of("oil_stiffness"));
        assert!((of("oil_shortening").value - 1.0 / 0.13).abs() < 1e-9);
        assert!((2500.0..3500.0).contains(&of("cavitation_force").value));
        assert!((300.0..500.0).contains(&of("gas_stiffness").value), "{:?}", of("gas_stiffness"));
        assert!((0.7..0.9).contains(&of("gas_length").value));
        assert!(find(&all, "oil_compression").is_none() && find(&all, "aeration_stroke").is_none());
    }

    #[test]
    fn a_tighter_drawing_gives_a_tighter_prior_and_a_softer_tube_a_softer_column() {
        let text = "bore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = 130\n";
        let column = |more: &str| find(&of(&format!("{text}{more}")), "oil_stiffness").unwrap();
        let (wide, narrow) = (column(""), column("oil_modulus_gpa = [1.2, 1.3]\n"));
        assert!(narrow.factor() < wide.factor());
        let thin = column("tube_wall_mm = 0.5\n").value;
        assert!(thin < 0.9 * column("tube_wall_mm = 5\n").value);
    }
}
