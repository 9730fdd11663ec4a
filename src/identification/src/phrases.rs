//! English templates of every sentence that a fit, a validation or a model file reports. A test finds templates without a translation.
//!
//! A model file contains the sentences in English. It also contains the ids of their messages for reports in other languages
//! ([`dashpot_messages::Kept`]).

dashpot_messages::phrases! {
    "identification-";
    // Lists.
    COMMA: ", ";
    SEMICOLON: "; ";
    THAT: ", that ";
    // Tests from which a number was identified.
    SHARE_OF: "{tests} {percent} %";
    NO_TEST: "no test shows it";
    // The inventory.
    CARRIES: "{effect}: {force} N rms, {share} of the force; probability {probability}";
    CARRIES_IN_FORM: "{effect} ({form}): {force} N rms, {share} of the force; probability {probability}";
    // Parameters that the data does not determine.
    NOT_IDENTIFIED: "{name} could not be identified from this data ({why}); its element is off";
    NEEDS_SIDE_FORCES: "it needs slow tests at two or more side forces, with a side-force channel";
    TAKEN_UP: "a free FV curve takes a v² term up";
    HELD: "{name} could not be identified from this data; it is held at {value}";
    AT_BOUND: "{name} ran into the bound of its range at {value}: the data asks for something this element cannot do";
    RARE_VALUE: "{name} is {value}, outside what dampers of this force and rigs show ({low} to {high}): it may make up for something that the model lacks";
    RARE_ASSUMED: "{name} is assumed at {value}, outside what dampers of this force and rigs show ({low} to {high}): it may make up for something that the model lacks";
    // Prior knowledge of the damper.
    EXPECTED: "{name} was expected at {value} {unit} (95 %: {low} to {high}), by the dimensions of the damper: {facts}";
    CONTRADICTS: "{name} contradicts the dimensions of the damper: {value} {unit} are {ratio} times the {expected} {unit} that {facts} give";
    // Effects that the tests of the campaign cannot show, and tests that the search does not use.
    ONE_RATE: "all tests turn at nearly the same rate, so that a late force channel and a soft series path look alike: the channel was taken as on time; the same stroke at a third of the frequency would tell them apart";
    ONE_TEST: "in a single test, a late force channel and a soft series path look alike: the channel was taken as on time; the same stroke at a third of the frequency would tell them apart";
    ROADS: "the long {roads|test|tests} without cycles ({roads}) {roads|is|are} run in {stretches|# stretch|# stretches} of {seconds} s each, chosen to visit every displacement and velocity of {roads|its|theirs}; errors over whole records count every sample";
    SELECTED: "the campaign has {all} tests, more than a search can use: {selected} of them stand for all, of every amplitude, speed, mean displacement, temperature and side force, spread over its whole length. Errors over whole records count all tests; to decide yourself, give --exclude or a smaller folder";
    NO_SLOW_TEST: "there is no slow test with whole cycles (peak below {velocity} mm/s): friction is taken from the slow parts of faster tests";
    NO_SLOW_TEST_NO_FRICTION: "there is no slow test with whole cycles (peak below {velocity} mm/s): such a test shows friction best, and the model has none";
    ONE_AMPLITUDE: "all tests have nearly the same amplitude: the spring and the series stiffness rest on frequency alone";
    ONE_AMPLITUDE_OF_SPRING: "all tests have nearly the same amplitude: the spring rests on frequency alone";
    ONE_AMPLITUDE_OF_SERIES: "all tests have nearly the same amplitude: the series stiffness rests on frequency alone";
    ONE_FAST_AMPLITUDE: "all tests faster than {velocity} mm/s have nearly the same amplitude: the series stiffness rests on frequency alone";
    ZERO_MOVES: "the model leaves another constant force of each test, from {low} to {high} N: the zero of the force channel moves from test to test, or the gas warms up. Set the zero before each test, or measure on one clock, by which a drift is found; friction and gas force are not to be trusted";
    // Measurement errors.
    FOUND_EARLY: "the force channel comes early by {value} ms (95 %: {low} to {high})";
    FOUND_DELAY: "the force channel lags the motion by {value} ms (95 %: {low} to {high})";
    FOUND_MASS: "the load cell moves a mass of its own, of {value} kg (95 %: {low} to {high})";
    FOUND_GAIN_DRIFT: "the gain of the force channel drifts by {value} % a minute (95 %: {low} to {high})";
    FOUND_DRIFT: "the zero of the force channel drifts by {value} N a minute (95 %: {low} to {high})";
    OR_WARM_GAS: "no temperature was recorded in all tests: gas that warms through a campaign lets the force at rest fall as well. The temperature tells the two apart";
    GAS_AT: "gas_force is that at {temperature} °C, the middle of the temperatures that were measured; by gas_warming_rate it grows with them";
    TAKEN_OUT_HERE: "{finding}: taken out here, not in the model; validate and diagnose take it out of these records too{option}";
    DOUBTFUL_ERROR: "{effect} has a probability of {probability} only: an effect of the damper that a fit does not try, such as air in the oil, may look like it. dashpot diagnose tries all effects";
    GIVE_OPTION: "; for other records of this rig give {option}, or write it into their campaign.toml";
    TAKEN_OUT_AS_THE_FIT_DID: "taken out of the records, as the model's fit did: {findings}";
    FOUND_IN_ITS_OWN: "the model's fit found in its own records that {findings}; these are other records, and nothing was taken out of them{option}";
    IF_THE_SAME_RIG: ": if the same rig measured these, give {options}";
    // Numbers of the model file that have no effect, because their element is off.
    IDLE: "the model file gives {names}, but the element {element} is off, so that this does nothing; add it to elements to use it";
    // Errors of a family relative to separate fits, numbers that the model file lacks, and numbers that changed since the fit.
    FAMILY_WORSE: "the family misses by {ratio} times as much as a fit of this setting alone: a number that all share may differ here. Or some of these tests have the label of another setting, or they are too few to show a difference";
    ALONE_WORSE: "a fit of this setting alone misses by {ratio} times as much as the family, so its search ended at a poorer structure: the ratio to it says nothing";
    ON_DEFAULTS: "the element {element} is on, but the model file does not give {names}: it runs on the defaults of docs/parameters.md";
    EDITED: "{names}: outside the 95 % interval that the fit left in the model file, so changed since; what the fit knew of it is left out";
    // Stages of a fit.
    PREPARING: "preparing records";
    PLAIN_CURVE: "plain FV curve";
    FIRST_FIT: "first fit from several starts";
    CHOOSING_STRUCTURE: "comparing friction, springs, series path and measurement errors";
    REFINING: "refining everything together";
    PIECEWISE: "piecewise-linear curve";
    WITH_LAG: "polynomial with lag";
    DONE: "done";
    // Fit of a damper whose parameters depend on a setting: stages, remarks and errors.
    FAMILY_EACH: "each setting by itself";
    FAMILY_JOINT: "all settings together: what they share and what depends on them";
    FAMILY_LEFT_OUT: "each setting predicted by the others";
    FAMILY_ACTUATOR: "response of the valve from tests whose setting changes";
    CHANGING_SETTING: "tests whose setting changes";
    NO_ACTUATOR: "the {count|test|# tests} whose {setting} changes {count|shows|show} no actuator: the force follows the command within samples and noise";
    ACTUATOR_OPEN: "the records do not determine {names}: the values are those that valves usually show";
    ACTUATOR_VAGUE: "the tests leave {names} uncertain by more than {width} ms. Add steps of the {setting}, up and down, between several pairs of settings, in a fast motion";
    ACTUATOR_TWO_SETTINGS: "the times of the valve assume that the force is linear over the {setting} between {low} and {high}: a curved force makes them wrong beyond their intervals. Measure a setting between these two";
    FAMILY_SELECTED: "the campaign has {all} tests, more than a search can use: {selected} of them stand for all: at most {most} of each setting and {changing} whose setting changes. They have every amplitude, speed, mean displacement, temperature and side force. Errors over whole records count all tests; to decide yourself, give --exclude or a smaller folder";
    NO_INTERVAL_BETWEEN: "{names}: no interval here, between two settings; a fit at three or more settings shows how far interpolation is off";
    LABEL_SUSPECT: "{test} states {name} {stated}, but its forces are those of {fitting}: at the stated one the model misses it by {ratio} times as much. Check its label; a corrected value goes into campaign.toml under settings";
    LABEL_STRAY: "{test} states {name} {stated}, but its forces are those of {fitting}, and not those of the settings next to it. Check its label; a corrected value goes into campaign.toml under settings";
    SETTING_DOUBT: "the forces of {test} are those of about {fitting}, not of {stated}: the model misses them by {fitting_error} N there and by {stated_error} N here. Check the setting of the test and its unit";
    LABELS_EXCHANGED: "the damping force does not rise or fall throughout over the {name}; with {one} and {other} exchanged it would. Check the labels of these tests; a damper that is really so is modeled as measured";
    LABELS_OPPOSED: "over the {name} the damping force in {direction} rises near {rising} mm/s and falls near {falling} mm/s. Some tests may count the {name} from the other end: check their labels; a damper that is really so is modeled as measured";
    FAMILY_STORES: "a change of {setting} may do work on the host, because it changes stored energy or a force at rest: {sources}";
    ENERGY_OF_NUMBER: "{name} {range}";
    ENERGY_AT_REST: "the force of the FV curve at zero velocity, {range}";
    ENERGY_OF_LAG: "the lagging force of {element}";
    ENERGY_RANGE: "{low} at {low_at} to {high} at {high_at}";
    FAMILY_NO_SETTING: "no test says its {name}. Write it into the names of all tests (800mA, 12clicks, 150psi), or name its column (--column setting=HEADING). For a column of currents without a unit, give --unit current=A. Or write setting and [settings] into campaign.toml beside the records{unread}";
    FAMILY_UNREAD: "; {note}";
    FAMILY_OTHER_SETTING: "no test says its {name}; the tests have a setting called {known}: give --setting with that name";
    FAMILY_WITHOUT: "no {name} is stated by {tests} (tests: {count}). Leave them out with --exclude, name their column (--column setting=HEADING), or give it in campaign.toml under settings{unread}";
    FAMILY_ONE: "all tests at a constant {name} have the same, {value}: a model over it needs at least two. Fit them without --setting, or check the unit of its column";
    FAMILY_ONLY_CHANGING: "the {name} of {count|the only test|all # tests} changes within the test: a damper over it is fitted to tests at two or more constant settings, and those that change identify its valve";
    FAMILY_TOO_MANY: "the tests have {count} values of {name}, and a model holds {most}: leave some out with --exclude or --hold-out, or state what was set in campaign.toml under [settings]";
    FAMILY_AT: "at {name} = {value}: {why}";
    FAMILY_KERNEL: "the settings make no model: {parameter} {why}";
    FAMILY_NOT_FINITE: "no finite force could be computed for all settings together; fit each by itself to find the test at fault";
    // Errors of a fit.
    NO_TESTS: "there is no test to fit: give a folder or files with at least one record";
    UNKNOWN_ELEMENT: "there is no element called {name}; the elements are {known}";
    NOT_FITTED: "fit does not identify {name}: it is added to a fitted model where dashpot diagnose finds it, or by hand; fit can use {known}";
    OTHER_FAMILY: "{name} is a model of its own and takes no other element; use --model lag";
    ONE_SIDED: "the tests never move in {direction}: a force-velocity curve needs both directions";
    NOT_FINITE: "no finite force could be computed for test {test}; look at its channels (a jump in displacement?)";
}

/// Kinds of tests from which a number may be identified.
pub(crate) const KINDS_OF_TESTS: [&str; 3] = ["slow tests", "small strokes", "large strokes"];
