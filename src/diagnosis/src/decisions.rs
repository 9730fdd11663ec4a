//! Every number that decides, with its reason and the test that fails when it moves.

/// Odds before any record is seen: nothing is missing, something without a name is, or one of the effects, each alike. From a trial on 332
/// campaigns of other authors; a factor of two in any of them moves a verdict in one case of fifty.
pub const NOTHING: f64 = 0.3;
/// See [`NOTHING`].
pub const WITHOUT_NAME: f64 = 0.2;
/// See [`NOTHING`].
pub const WITH_NAME: f64 = 0.5;
/// The same of nothing more once something has a name: two changes at once are rarer than one.
pub const NOTHING_MORE: f64 = 0.6;

/// Independent samples that a test counts as, for what is suspected. No model has the form of the damper, and the error of its form is
/// alike all through a test: samples beyond the first few say the same once more.
pub const SUSPECTED: f64 = 2.0;
/// The same for what is sure.
pub const SURE: f64 = 1.0;

/// Probability from which an effect is added: at [`SUSPECTED`], and of the name being right by the calibration, before that is held to
/// what was right where the rule was surest. Below it the name is more likely wrong than right.
pub const NAMED: f64 = 0.5;

/// Largest error of the model's form that counts as nothing missing, in units of what noise and curves through a dozen points leave.
pub const FORM: f64 = 0.5;
/// Share of what the names so far explain that their own forms may leave, in amplitude: right names closed 0.75 to 0.85 of the gap on
/// dampers of other authors. Below it a second name stands for the form of the first: without it every second single effect got one.
pub const OWN_FORM: f64 = 0.3;
/// Largest error of form that something may leave, in the same units: beyond it all are alike.
pub const MOST_FORM: f64 = 30.0;

/// Share of a test's largest force in rebound or in compression by which a number that is another on the reference damper has to move the force to stand in the answer: dampers
/// of one series differ by as much, and windows of force allow it. Smaller differences stand in the table alone (`changes::tests`). With a
/// tenth of the number itself as the bar, 3 of 18 healthy dampers had a `spring_linear` in the answer that moved their force by 3 N.
pub const MATERIAL: f64 = 0.1;
