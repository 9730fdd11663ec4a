//! English templates of every sentence that a diagnosis reports. A test finds missing translations of the templates.

dashpot_messages::phrases! {
    "diagnosis-";
    // Steps of a diagnosis, reported as its progress.
    PREPARING: "preparing records";
    FITTING_REFERENCE: "fitting the model to the reference";
    REFITTING: "refitting the model as it is";
    EACH_EFFECT: "refitting everything with each effect";
    WEIGHING: "weighing each name with the others in";
    WHAT_IS_LEFT: "looking at what is left";
    DONE: "done";
    // Errors of a diagnosis.
    NO_TESTS: "there is no test to diagnose: give a folder or files with at least one record, and leave some of them in";
    UNKNOWN_NAME: "there is no effect called {name}; the effects are {known}";
    NOTHING_TO_COMPARE: "the reference campaign has none of the tests of this one (same amplitude, frequency, mean displacement and side force, within 5 %): run the same matrix on both dampers{turned}";
    BESIDES: "; {said}";
    OPPOSITE: "the campaign was read as counting {own} positive and the reference as counting {good} positive; where both come from one rig, read both with --positive rebound, or both with --positive compression";
    IDENTICAL: "the same measurements, value for value, are in the reference: {tests}; of these nothing can have changed, so look whether the reference is the right folder";
    NOT_FINITE: "the model gives no finite force for these records: run dashpot validate to see where";
    // Lists.
    COMMA: ", ";
    AND: " and ";
    // Summary.
    TIMES: "{times} times the error that noise and the form of curves leave";
    NAME_AND_SURE: "{effect} ({percent} sure{instead})";
    INSTEAD_OF: ", instead of {effect}";
    HAS_EFFECT: "this damper shows {names}; {residual}, {rest}{also}";
    RESIDUAL_FALLS: "the residual falls from {before} to {after} times noise and curve error";
    RESIDUAL_STAYS: "the residual does not fall ({before} before and {after} after, in units of noise and curve error)";
    LEAVES_NOTHING: "which leaves nothing unexplained";
    LEAVES_A_PART: "which leaves a part unexplained";
    NEW_EFFECT: "new on this damper: {names}; {residual}, {rest}{also}";
    ALSO_CHANGED: "; also changed: {changes}";
    AT_ALL_SETTINGS: "at every setting this damper shows {effect} ({sure} sure{instead})";
    AT_SOME_SETTINGS: "{effect} ({sure} sure{instead}) is missing in the model at {names}; at the other settings it is not named";
    AT_NO_SETTING: "no effect is missing in the model that these records can name, at any setting";
    ONLY_TOGETHER: "no setting alone needs {effects}; one setting tells less than all together, so the fit over all settings (dashpot fit --setting) decides whether the model keeps it";
    CHANGED_AT_ALL_SETTINGS: "{name} changed at every setting ({sure} sure)";
    CHANGED_AT_SOME_SETTINGS: "{name} changed at {names} ({sure} sure); at the other settings no change of it shows";
    CHANGED_AT_NO_SETTING: "nothing has changed that these records can name, at any setting";
    SETTINGS_NOT_IN_MODEL: "the model was not measured at {names}: its numbers there are interpolated, and the diagnosis fits them to these records first. So it does not judge the interpolation; dashpot validate does";
    NO_NAME_AT_ALL_SETTINGS: "at every setting something is missing that has no name yet";
    NO_NAME_AT_SOME_SETTINGS: "at {names} something is missing that has no name yet";
    NEEDLESS: "none of the examined effects is missing; these records do not need {effects}";
    NOT_EXPLAINED: "{percent} of the disagreement is not explained by what was named: another form of it, or something else";
    IMMATERIAL: "the improved model has {effects} besides, not named: in no test is the force beyond the noise and 0.5 % of the measured force";
    TEST_AND_TIMES: "{test} ({times} times)";
    DETECTION_LIMIT: "the model misses the mean cycles by {residual} N rms, and their noise is {noise} N: the difference counts as the form of the FV curve, and an effect of that size cannot be told from it";
    STILL_MISSED: "too rare or too small to be named, but these tests are missed: {tests}";
    NOTHING_MISSING: "no known effect is missing that these records can show: the model is off by {times}{rest}{likeliest}{not_seen}{not_confirmed}";
    NONE_OF_ASKED: "none of the effects asked for ({effects}) is missing that these records can show: the model is off by {times}{rest}{likeliest}{not_seen}{not_confirmed}";
    UNCHANGED: "nothing has changed that these records can show: the reference's model is off by {times}{rest}{likeliest}{not_seen}{not_confirmed}";
    UNCHANGED_OF_ASKED: "no number has changed and none of the effects asked for ({effects}) is new that these records can show: the reference's model is off by {times}{rest}{likeliest}{not_seen}{not_confirmed}";
    WITHOUT_CAUSE: "; {percent} of the mean square error has no known cause";
    LIKELIEST: "; the likeliest of the effects not in it is {effect} ({percent} sure)";
    WARMER: "tests were up to {kelvin} K {sense} than on the reference ({test}: {here} and {there} °C in the mean): gas force grows by 0.34 % a kelvin, and oil damps less when warm. A part of the differences may be the temperature, above all a drift of the force zero; compare campaigns of like temperature";
    WARMER_SENSE: "warmer";
    COLDER_SENSE: "colder";
    CHANGED: "{numbers}{more}";
    NOTHING_ELSE: "; nothing else changed";
    NOTHING_ELSE_LARGE: "; nothing else changed by more than 0.5 % of the force";
    MORE_MAY_HAVE_CHANGED: "; more may have changed, for the model is still off by {times}";
    CHANGED_BOTH: "damping force {percent} % in rebound and compression ({reference} -> {value} N at {velocity} mm/s)";
    CHANGED_REBOUND: "rebound force {percent} % at all speeds ({reference} -> {value} N at {velocity} mm/s)";
    CHANGED_COMPRESSION: "compression force {percent} % at all speeds ({reference} -> {value} N at {velocity} mm/s)";
    CHANGED_REBOUND_LOW: "rebound force at low speed {percent} % ({reference} -> {value} N at {velocity} mm/s)";
    CHANGED_COMPRESSION_LOW: "compression force at low speed {percent} % ({reference} -> {value} N at {velocity} mm/s)";
    CHANGED_REBOUND_HIGH: "rebound force at high speed {percent} % ({reference} -> {value} N at {velocity} mm/s)";
    CHANGED_COMPRESSION_HIGH: "compression force at high speed {percent} % ({reference} -> {value} N at {velocity} mm/s)";
    OTHER_NUMBER: "{name} {reference} -> {value}";
    UNCERTAIN_CHANGE: "{change} (uncertain: the 95 % interval, {low} to {high} {unit}, contains the reference)";
    MORE_NUMBERS: " and {count} more";
    CANNOT_SHOW: "; they cannot show {effects}";
    NOT_CONFIRMED: "; no test was left out to confirm it";
    CANNOT_TELL: "something is missing: the model is off by {times}, and {why}";
    TOO_FEW_TESTS: "{effect} is the likeliest name, but too few tests speak for it to give it";
    NOT_APART: "these records cannot tell {effects} apart";
    UNKNOWN_EFFECT: "the model is off by {times}, and none of the known effects is likely enough to explain that{nearest}";
    LOOKS_LIKE: "; it looks like {what}";
    NEAREST: "; the nearest, {effect}, explains {percent}";
    EXPLAINS: "explains {percent} of the disagreement";
    // Descriptions of unnamed disagreements.
    LIKE_GUIDES: "friction that grows with the force, as a tilted cross-head or eye makes in the guides";
    LIKE_LOAD_CELL: "a loop over force whatever the speed, as a load cell with hysteresis draws";
    LIKE_RESONANCE: "a resonance in the path of the force, as of a frame or of oil in a hose";
    // Regions.
    REGION: "{direction}, {slow}–{fast} mm/s{phase}, {place}: {missing} (rms {rms} N, noise {noise} N)";
    REBOUND: "rebound";
    COMPRESSION: "compression";
    SPEEDING_UP: " while it speeds up";
    SLOWING_DOWN: " while it slows down";
    IN_ALL_TESTS: "in all tests that go there";
    IN_TEST: "in test {test}";
    MORE_TENSILE: "measured force is {mean} N ± {error} more tensile than computed";
    MORE_COMPRESSIVE: "measured force is {mean} N ± {error} more compressive than computed";
    OFF_BOTH_WAYS: "measured force is above and below the computed one";
    // Proposed tests.
    RUN_SINE: "run a sine of {amplitude} {unit} at {frequency} Hz{about}{under}: {a} and {b} differ there by {difference} N rms";
    ABOUT_MEAN: " about {mean} {unit} as the files count";
    UNDER_SIDE_FORCE: " under {force} N side force";
    SHOWS_BEST: "{effect} shows best in: {remedy}";
    NO_TRACE: "at a usual strength it would leave no trace in these tests: {remedy}";
    SUM_ALONE: "the tube widens in proportion to pressure like the oil column yields: a rig shows their sum, which oil_compressibility stands for";
    // Test that shows an effect best.
    SHOW_MORE: "more amplitudes and frequencies";
    SHOW_SLOW: "slow triangles at {slow} to {fast} {speed_unit}, two strokes, two temperatures";
    SHOW_SPRING: "stroke the whole travel slowly, and once at 1 Hz, at two mean positions";
    SHOW_GAS_WARMING: "the force at rest in the middle of the stroke, cold and after hard work, with the temperature recorded";
    SHOW_MOUNT: "{small} to {large} {unit} sines at {low} to {high} Hz";
    SHOW_ZERO: "read the force at rest, with and without the damper hooked in";
    SHOW_PRESLIDING: "strokes of {small} to {large} {unit} at {low} and {high} Hz: equal loops speak for it";
    SHOW_SIDE_FORCE: "the same sine at 0, {half} and {full} N side force";
    SHOW_OIL: "one peak velocity at several strokes and frequencies, at two mean positions";
    SHOW_AERATION: "one test after a night's rest and after 200 cycles";
    SHOW_CAVITATION: "one peak velocity at several strokes, with the gas pressure raised";
    SHOW_FADE: "a reference test repeated cold and hot, in shuffled order, with the temperature recorded";
    SHOW_POSITION: "{small} to {large} {unit} sines at five or more mean positions";
    SHOW_BUMP_STOP: "push slowly into the stop, towards {lowest} {unit} as the files count, then at two speeds";
    SHOW_REBOUND_STOP: "pull slowly into the stop, towards {highest} {unit} as the files count, then at two speeds";
    SHOW_FREE_PLAY: "small strokes with a preload that keeps the force from crossing zero, and without";
    SHOW_FREQUENCY: "one peak velocity at five frequencies from {low} to {high} Hz";
    SHOW_VALVE: "slow ramps of velocity through the knee, up and down";
    SHOW_MASS: "run the rig without the damper";
    SHOW_DELAY: "run a spring in place of the damper: its loop must close";
    SHOW_DRIFT: "repeat a reference test at the start, middle and end";
    // Demands of a test that the records have not reached.
    SEMICOLON: "; ";
    BEYOND: "{test} (beyond what these tests reached: {demands})";
    BEYOND_AMPLITUDE: "±{value} {unit} where they reached ±{reached} {unit}";
    BEYOND_SPEED: "{value} {unit} where they reached {reached} {unit}";
    BEYOND_FREQUENCY: "{value} {unit} where they reached {reached} {unit}";
    BEYOND_SIDE_FORCE: "a side force of {value} {unit} where they reached {reached} {unit}";
    // Reasons why records cannot show an effect.
    NEEDS_SERIES: "it is part of the series path: the model needs series_compliance first";
    SERIES_ADDED: "it needs series_compliance, which this diagnosis has just added: run dashpot diagnose once more, on the improved model";
    NEEDS_FIXED_CURVE: "a free FV curve takes a v² term up: it needs the curve fixed by a specification";
    NEEDS_SIDE_FORCE: "the side force does not vary: run the same sine under two or more side forces, with the channel recorded";
    NEEDS_TEMPERATURE: "no temperature channel varies, and the records' clocks show no heating: record the oil or tube temperature, or repeat one test cold and after hard work";
    NEEDS_MEASURED_TEMPERATURE: "no temperature channel varies: record the temperature of the oil or the tube in all tests";
    NEEDS_PLACES: "all tests pass the same places at the same speeds: run one small sine at five or more mean positions, or one peak velocity at several strokes";
    ONLY_WITHIN_COMPRESSION: "only up to {lowest} {unit} in compression, as the files count: push slowly beyond what these tests reached to see a stop there";
    ONLY_WITHIN_EXTENSION: "only up to {highest} {unit} in extension, as the files count: pull slowly beyond what these tests reached to see a stop there";
    NEEDS_FREQUENCIES: "the tests' frequencies are nearly the same: run one peak velocity at five frequencies from {low} to {high} Hz";
    NEEDS_ZERO: "a zero error of the load cell and the gas force are the same constant: read the load cell with the damper unhooked, before and after";
    NEEDS_ONE_CLOCK: "every record starts its clock anew: keep one clock through the campaign and repeat a reference test";
    // Notes in the file of the improved model, the source of its estimates, and a remark on a force drift.
    DIAGNOSIS: "diagnosis: {answer}";
    ADDED: "{effect} ({percent} sure) added to this model";
    OF_THE_RIG: "{effect} ({percent} sure) of the rig: corrected in the comparison, not in the damper of this model";
    OR_WARM_GAS: "no temperature varies in all records: gas that warms through a campaign lets the force at rest fall as a zero that drifts does, and cannot be told from it. Record the temperature of the oil or the tube";
    ALL_FITTED_TESTS: "all fitted tests";
    // Method of comparison.
    WITHOUT_REFERENCE: "without a reference campaign a name may stand for what is always wrong in the form of the model; where a good damper was measured on the same rig, --reference asks what changed";
    AGAINST_REFERENCE: "compared with the reference campaign: what the model leaves of the same tests there is taken out{nearest}{aside}";
    BY_NEAREST_MOTION: "; tests without a counterpart of the same motion were compared by the form error of the nearest one: {tests}";
    WITHOUT_COUNTERPART: "; the reference has no motion like these, so that the form error of the model is in them: {tests}";
}

/// Names of the forms of effects.
pub(super) const FORMS: &[&str] = &[
    "changed",
    "full",
    "simplified",
    "slips from the first",
    "bends before it slips",
    "relaxes",
    "friction in the rubber",
    "relaxes over decades and meets a stop",
    "friction in the rubber, and a stop",
    "opens under a load",
    "all of the force goes through it",
    "friction and gas act behind it",
    "relaxes, and all of the force goes through it",
    "friction in the rubber, and all of the force goes through it",
    "rebound chamber",
    "both chambers",
    "one chamber softer than the other",
    "compression capped, gas pushes on",
    "compression capped, dead return",
    "rebound capped, force stays",
    "rebound capped, dead return",
    "compression capped, gas expands in the void",
    "foot valve does not refill",
    "measured temperature",
    "oil warmer than measured",
    "heated by its own work",
    "rebound chamber is not refilled",
    "rebound begins with a lost stroke",
    "compression begins with a lost stroke",
    "isothermal",
    "takes time to cool",
    "both strokes",
    "rebound",
    "compression",
    "groove",
    "groove open in rebound",
    "groove open in compression",
    "bypass",
    "filter",
    "stroke",
    "a valve with play",
    "a valve with mass",
    "opens and closes at different forces",
    "linear",
    "quadratic",
    "cubic",
    "quartic",
    "rubber",
    "hydraulic, gap",
    "hydraulic, orifice",
    "on the load cell",
    "at the load cell",
    "inside, like oil in a long passage",
    "low-pass filter of the force channel",
    "zero set anew during the campaign",
    "settles as the rig warms up",
];
