//! English texts of an explanation, in one place. A test finds missing translations.

use dashpot_messages::Template;

dashpot_messages::phrases! {
    "dimensions-";
    // Reasons why a quantity cannot be determined.
    NO_GAS_FORCE: "the model has no gas force; a slow test shows it";
    GAS_FORCE_OPEN: "the records leave the gas force open; a slow test shows it";
    GAS_ON_ROD: "the gas pushes on the area of the rod";
    NO_GAS_SPRING: "the model has no gas spring; slow strokes over the whole travel show it";
    GAS_SPRING_OPEN: "the records leave the gas stiffness open; slow strokes over the whole travel show it";
    VOLUME_FROM: "it follows from the pressure and the stiffness of the gas";
    COLUMN_FROM: "the stiffness of the column is one of a chamber with area and length";
    NO_COLUMN: "the model has no oil column and no series spring that the records determine";
    EYES_TOO_SOFT: "the eyes as stated are, within their tolerance, softer than eyes and oil together in the model";
    NO_MODULUS: "the effective modulus is not known";
    TUBE_EXPANDS: "the tube expands with the oil";
    STROKE_FROM: "the stroke that air yields goes with its pressure and the length of the chamber";
    AIR_FROM: "it is what the modulus of the oil lacks, or the stroke of the element aeration";
    PASSAGE_FROM: "a passage follows from the FV table and the area of the piston";
    FEW_SLOW_POINTS: "fewer than two points of the FV table lie below the knee of this stroke";
    NO_KNEE: "the FV table of this stroke has no knee: no valve has opened";
    BLEED_PASSES_ALL: "the bleed passes all of the flow";
    // Remarks on a quantity.
    BY_COMPRESSION: "by the column in compression";
    LESS_THE_EYES: "the series spring less the eyes";
    COLUMN_BOUND: "a bound: the oil column holds the eyes too; eye_stiffness_n_mm or a series spring in the model separates them";
    COLUMN_LESS_THE_EYES: "the oil column less the eyes, for the model has no series spring";
    A_BOUND: "a bound: the series spring holds eyes and oil; eye_stiffness_n_mm or an oil column in the model separates them";
    WITH_AIR: "with the air in it";
    NO_ORIFICE: "no orifice shows beside the leak";
    OF_ALL_PASSAGES: "of all laminar passages together, so a gap leaks at most this";
    SPRING_IS_MORE_THAN_GAS: "if the parallel spring is the gas; the drawn {drawn} cm³ give about {percent} % of that spring, and another spring the rest";
    IF_SPRING_IS_GAS: "if the parallel spring is the gas";
    NO_LEAK: "no leak shows beside the orifice";
    OPENING_AT: "opening at the largest force of the table";
    HAD_PRIOR: "the fit had a prior of the dimensions for it";
    DOUBTFUL_EFFECT: "only if the damper has {effect}, which has a probability of {probability} in the fit";
    COMMA: ", ";
    IN_DOUBT: "uses {entries} as drawn, which the contradiction below puts in doubt";
    SEMICOLON: "; ";
    // Contradictions.
    CONTRADICTS_ONE: "The {noun} of the model, {model}, is {ratio} times the {dimensions} that {facts} gives. {cause}";
    CONTRADICTS_SEVERAL: "The {noun} of the model, {model}, is {ratio} times the {dimensions} that {facts} give. {cause}";
    CONTRADICTS_ZERO: "The {noun} of the model, {model}, contradicts the {dimensions} of {facts}. {cause}";
    EXPLAINED_BY: "The smallest single change of the drawing that explains it is {entry} = {value}.";
    NO_CAUSE: "No single entry of the drawing explains it.";
    PRESSURE_ON_ROD: "{pressure} bar on a rod of {diameter} mm";
}

/// English names of the quantities.
pub(crate) const QUANTITIES: [(&str, &str); 11] = [
    ("gas_pressure", "gas pressure"),
    ("gas_volume", "gas volume"),
    ("oil_modulus_effective", "effective modulus of the oil"),
    ("oil_modulus", "modulus of the oil"),
    ("air_content", "air content of the oil"),
    ("rebound_bleed_area", "bleed area in rebound"),
    ("compression_bleed_area", "bleed area in compression"),
    ("rebound_leak", "leak in rebound"),
    ("compression_leak", "leak in compression"),
    ("rebound_blow_off_area", "blow-off area in rebound"),
    ("compression_blow_off_area", "blow-off area in compression"),
];

/// English names, in contradictions, of the parameters that a drawing implies.
pub(crate) const NOUNS: [&str; 12] = [
    "gas force",
    "growth of the gas force with temperature",
    "gas stiffness",
    "length of the gas column",
    "cavitation cap",
    "stiffness of the oil column",
    "shortening of the oil column",
    "stiffness of the oil column in compression over that in rebound",
    "force that halves the air's stroke",
    "stroke that the air yields",
    "series stiffness",
    "parallel spring",
];

/// Texts that messages contain as values and that need a translation: units with words, and missing parameters of a
/// model.
const WORDS: [&str; 5] = [
    "bar gauge",
    "% at 1.013 bar absolute",
    "fv_force at two slow speeds",
    "fv_force at a fast speed",
    "oil_stiffness or aeration_stroke",
];

/// Returns the templates of all messages.
pub fn templates() -> &'static [Template] {
    TEMPLATES
}

/// Returns the words that messages contain as values: quantities, parameters, and units with words.
pub fn words() -> impl Iterator<Item = &'static str> {
    QUANTITIES.iter().map(|(_, noun)| *noun).chain(NOUNS).chain(WORDS)
}
