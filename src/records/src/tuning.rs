//! The numbers of judgement in reading and checking records: thresholds, priors, bars. A module for each file that uses them.
//!
//! Every number has its unit and its reason, and names a test that fails when it is doubled or halved, or moved by five where that makes
//! no difference. `tests/tests/tuning.rs` holds the form. Budgets of readers, names and physical constants stand where they are used.

/// Numbers of `campaign/date_agreement.rs`.
pub(crate) mod date_agreement {
    /// How much closer together the tests of a campaign must lie by one reading than by the other to decide, as a ratio.
    ///
    /// A campaign takes days, and a month read as a day scatters it over the year.
    ///
    /// Test: `dates_decide_only_where_one_reading_lies_much_closer_together`.
    pub(crate) const CLOSER: f64 = 5.0;

    /// Least distance, s, of the tests by the other reading. A month read as a day scatters a campaign over the year.
    ///
    /// Test: `tests_of_one_campaign_lie_close_together`.
    pub(crate) const APART: f64 = 20.0 * 86_400.0;
}

/// Numbers of `campaign/rig_sign.rs`.
pub(crate) mod rig_sign {
    /// How sure a campaign is from which on it is not overruled.
    ///
    /// Two that are as sure as that and disagree are of two rigs, or of two exports.
    ///
    /// Test: `the_surest_decides_for_those_that_hardly_tell`.
    pub(crate) const OWN: f64 = 0.9;
}

/// Numbers of `campaign/common_clock.rs`.
pub(crate) mod common_clock {
    /// Longest campaign, s, whose files bear the time of day alone: beyond half a day it is not sure which of two came first.
    ///
    /// Test: `what_is_no_one_clock_is_said`.
    pub(crate) const WITHOUT_DATE: f64 = 0.5 * 86_400.0;

    /// Longest campaign, s, whose files bear the date too: a year. Beyond it one of the dates is wrong.
    ///
    /// Test: `a_campaign_with_dates_lasts_a_year_at_most`.
    pub(crate) const WITH_DATE: f64 = 366.0 * 86_400.0;
}

/// Numbers of `signal/consistency.rs`.
pub(crate) mod consistency {
    /// Fraction of a sample by which a velocity may lag behind the displacement, or lead it: the two are converted one after the other.
    ///
    /// Test: `a_lag_within_conversion_or_noise_is_none`.
    pub(crate) const LAG_OF_SAMPLE: f64 = 0.25;

    /// Phase by which it may, rad.
    ///
    /// A hundredth opens the force loop by 1 %, as much as the noise of good rigs; half a sample is within twice that.
    ///
    /// Test: `a_lag_within_conversion_or_noise_is_none`.
    pub(crate) const LAG_OF_PHASE: f64 = 0.02;

    /// Fraction of the displacement's variance that a velocity must explain for its lag to be known.
    ///
    /// Test: `gain_and_lag_are_found`.
    pub(crate) const SAME_MOTION: f64 = 0.98;
}

/// Numbers of `signal/delay.rs`.
pub(crate) mod delay {
    /// Longest delay looked for, s: filters and bus systems of rigs stay below; more is a file whose channels do not belong
    /// together.
    ///
    /// Test: `a_turned_sign_is_told_from_a_delay`.
    pub(crate) const LONGEST: f64 = 0.060;

    /// Delays tried, s apart; between them a parabola is laid.
    ///
    /// Test: none.
    pub(crate) const STEP: f64 = 0.001;

    /// Share of a cycle that the longest delay must be for a test to tell of it; slower tests show friction, which would drown it.
    ///
    /// Test: `slow_tests_tell_no_delay_and_long_ones_are_thinned_out`.
    pub(crate) const TELLING: f64 = 0.02;

    /// Samples of a test that are looked at.
    ///
    /// Test: `slow_tests_tell_no_delay_and_long_ones_are_thinned_out`.
    pub(crate) const SAMPLES: usize = 1500;

    /// Nodes of the curve over velocity on one side, as shares of the highest velocity: dense at zero, where friction turns.
    ///
    /// Test: `nodes_of_the_curve_join`.
    pub(crate) const NODES: [f64; 7] = [0.015, 0.03, 0.06, 0.12, 0.25, 0.5, 1.0];

    /// Normalised power below which a test neither dissipates nor feeds energy clearly.
    ///
    /// Test: `power_near_zero_is_neither_dissipation_nor_its_contrary`.
    pub(crate) const UNCLEAR: f64 = 0.1;

    /// Shorter delays are told neither from series compliance nor from filters, s.
    ///
    /// Test: `delays_are_found_to_a_millisecond_and_their_absence_too`.
    pub(crate) const SHORTEST_REPORTED: f64 = 0.005;

    /// Share of the unexplained variance that must go with the delay.
    ///
    /// Test: none.
    pub(crate) const BETTER: f64 = 0.6;

    /// How much less one explanation must leave than the other to be preferred.
    ///
    /// Test: `a_turned_sign_is_told_from_a_delay`.
    pub(crate) const CLEARLY: f64 = 0.7;
}

/// Numbers of `signal/derivative.rs`.
pub(crate) mod derivative {
    /// Most samples on either side of the window; more costs time and gains little.
    ///
    /// Test: `a_window_holds_a_bounded_number_of_samples`.
    pub(crate) const REACH: usize = 250;

    /// Deviations of its noise within which the derivative over a long window equals that over a shorter one.
    ///
    /// With 4, one sample in a thousand of a smooth motion gets a shorter window by chance, and a derivative with all its
    /// noise. A corner differs by tens.
    ///
    /// Test: `a_triangle_keeps_its_velocity_up_to_its_corners`.
    pub(crate) const SAME: f64 = 5.0;

    /// How much longer each window is than the one before: closer ones cost time, wider ones leave a sample a window that much too short.
    ///
    /// Test: none.
    pub(crate) const LONGER: f64 = 1.4;
}

/// Numbers of `signal/noise.rs`.
pub(crate) mod noise {
    /// Samples needed for a figure from sample differences.
    ///
    /// Test: `without_cycles_differences_of_samples_serve`.
    pub(crate) const FEWEST: usize = 12;
}

/// Numbers of `quantities/load_cell.rs`.
pub(crate) mod load_cell {
    /// Zero offset to be expected of a load cell, N, with a damper of a car.
    ///
    /// A tenth of a percent of a cell of 15 kN. A smaller force at rest tells nothing of gas, and a test that lies so far
    /// off the others is no other.
    ///
    /// Test: `a_cell_is_chosen_for_its_damper`.
    pub(crate) const OFFSET: f64 = 15.0;

    /// Largest force, N, of the dampers of cars: between these nothing depends on it, so that a soft and a firm damper are judged alike. From the
    /// virtual rigs and the measured dampers of the book, 0.4 to 6 kN; a narrower range would change what is said of cars. Weaker dampers are
    /// measured with a smaller cell, stronger ones with a larger one.
    ///
    /// Test: `a_cell_is_chosen_for_its_damper`.
    pub const OF_CARS: (f64, f64) = (300.0, 8000.0);
}

/// Numbers of `checks/force_offset.rs`.
pub(crate) mod force_offset {
    /// Fewest other tests at a velocity for their median to stand for the damper.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const FEWEST: usize = 3;

    /// Fewest velocities at which a test must be seen beside others for its offset to be the same at all.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const VELOCITIES: usize = 3;

    /// Fewest at which it must be seen to be turned round.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const TWO: usize = 2;

    /// What a test may lie off the others beside the offset of a load cell, in times of their scatter.
    ///
    /// Load cells creep and gas warms up.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const OF_SCATTER: f64 = 3.0;

    /// How many times that a test must lie off as it was read, where turning it round brings it within.
    ///
    /// Test: none.
    pub(crate) const STRONG: f64 = 2.0;

    /// Fraction of its offset that a test's own scatter may be, so that it is one offset and no other stroke or position.
    ///
    /// It may differ by as much toward the ends of the strokes.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const CONSTANT: f64 = 0.3;

    /// Largest share of the tests that are told of: of more, they would be the others.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const FEW: f64 = 0.34;
}

/// Numbers of `checks/truncated_test.rs`.
pub(crate) mod truncated_test {
    /// Share of the range of a motion that counts as a stroke, as where cycles are looked for.
    ///
    /// Test: `a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not`.
    pub(crate) const STROKE: f64 = 0.3;

    /// Ends of strokes, those of the record among them, that a whole cycle has at least.
    ///
    /// Test: `a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not`.
    pub(crate) const OF_A_CYCLE: usize = 4;

    /// Share of its peak velocity at which a test is no longer coming to rest. A sine is slower for a fifth of its time.
    ///
    /// Test: `a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not`.
    pub(crate) const MOVING: f64 = 0.3;

    /// Last samples of which the velocity at the end is the median.
    ///
    /// Test: `a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not`.
    pub(crate) const LAST: usize = 5;
}

/// Numbers of `checks/file_units.rs`.
pub(crate) mod file_units {
    /// Natural logarithm of the ratio of forces up to which two tests agree.
    ///
    /// A damper that is 30 % softer when warm does, and so do the two sides of a hysteresis. Between two tests of sound
    /// campaigns, of real dampers too, it is mostly below 0.1; with free play up to 0.3.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const AGREE: f64 = 0.4;

    /// Logarithm from which a test differs for another reason than its damper: three and a half times.
    ///
    /// The smallest step between two units of force is that of pound-force and newton, 1.49; free play and presliding
    /// reach 0.7.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const OFF: f64 = 1.25;

    /// Ratio of units from which on no damper comes near it: the force of an adjustable damper changes by up to fifteen times.
    ///
    /// Test: none.
    pub(crate) const BEYOND_DAMPERS: f64 = 50.0;

    /// How close, as the same logarithm, a test must lie to the others in its likely unit: as two tests that agree.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const CLOSE: f64 = 0.3;

    /// How close it must lie where no damper comes near the ratio of the units: twice that.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const CLOSE_BEYOND: f64 = 0.7;

    /// Worse than the best unit by this, another unit is still as likely: kilogram-force and decanewton are 0.02 apart.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const AS_LIKELY: f64 = 0.05;

    /// Velocities at which a test must be seen beside the others: a triangle has hardly more than two.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const FEWEST: usize = 2;

    /// Force between the directions, N, that indicates gas and not only the zero of the load cell.
    ///
    /// Test: none.
    pub(crate) const CELL_OFFSET: f64 = 15.0;

    /// Ratio of that force to the scatter from test to test.
    ///
    /// Test: none.
    pub(crate) const OF_SCATTER: f64 = 3.0;

    /// How much shorter than that of the others the stroke of a test may be to be held against them in all.
    ///
    /// Mounts, oil under pressure and free play take a share of short strokes.
    ///
    /// Test: none.
    pub(crate) const AS_LONG: f64 = 0.67;

    /// Longest displacement amplitude, m, that a unit is taken to mean, as in what no damper has.
    ///
    /// Test: none.
    pub(crate) const LARGEST_AMPLITUDE: f64 = 0.5;
}

/// Numbers of `checks/plausibility.rs`.
pub(crate) mod plausibility {
    /// Largest displacement amplitude, m; the longest suspensions travel half of it.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const LARGEST_AMPLITUDE: f64 = 0.5;

    /// Highest speed, m/s; kerb strikes reach about 10.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const HIGHEST_SPEED: f64 = 20.0;

    /// Largest force, N; dampers of heavy vehicles reach a third of it.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const LARGEST_FORCE: f64 = 2e5;

    /// Range of the force, N, below which no damper's stays in every test: the smallest, of toys and of drawers, have a newton.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const LEAST_FORCE: f64 = 0.05;

    /// Amplitude, m, below which in every test a unit is likely wrong.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const SMALL_AMPLITUDE: f64 = 2e-4;

    /// Peak velocity, m/s, below which in every test a unit is likely wrong.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const SMALL_SPEED: f64 = 6e-3;

    /// Peak force, N, below which in every test a unit is likely wrong.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const SMALL_FORCE: f64 = 20.0;

    /// Range of the force, in standard deviations of its noise, below which it shows noise alone: white noise of a hundred
    /// thousand samples stays inside.
    ///
    /// Test: `noise_is_known_by_its_range_and_its_spread`.
    pub(crate) const NOISE_RANGE: f64 = 10.0;

    /// Standard deviation of the force, in those of its noise, below which it shows noise alone.
    ///
    /// Test: `noise_is_known_by_its_range_and_its_spread`.
    pub(crate) const NOISE_SPREAD: f64 = 1.1;

    /// Peak velocity, m/s, below which a damper stands still and need show no force.
    ///
    /// Test: `noise_is_known_by_its_range_and_its_spread`.
    pub(crate) const STANDSTILL: f64 = 1e-4;
}

/// Numbers of `data/rig_frame.rs`.
pub(crate) mod rig_frame {
    /// By how much a test may go beyond what was reached: amplitudes of a list are round, those of a record are measured.
    ///
    /// Test: `tests_are_given_as_the_rig_counts_and_within_its_reach`.
    pub(crate) const BEYOND: f64 = 0.02;
}

/// Numbers of `checks/sign.rs`.
pub(crate) mod sign {
    /// Uncertainty of the standstill force from hysteresis, as a share of half the force range of the test.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const HYSTERESIS: f64 = 0.1;

    /// Fraction of the rigs whose force was zeroed with the damper mounted, or never.
    ///
    /// Their force at standstill says nothing about the gas. This is a guess on the safe side. Without it one number
    /// would be certain, whatever was done to the rig.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const TARED: f64 = 0.05;

    /// Prior of the logarithm of the force in rebound over that in compression, of passenger-car dampers.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const PRIOR_RATIO: f64 = 0.6;

    /// Standard deviation of that logarithm from damper to damper.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const RATIO_SCATTER: f64 = 0.5;

    /// Most that it counts for, as a logarithm of odds: seven to one.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const MOST_BY_SHAPE: f64 = 2.0;

    /// Most that a direction that was worked out is sure of: 99 %.
    ///
    /// Test: `no_direction_that_was_worked_out_is_certain`.
    pub(crate) const SUREST: f64 = 4.595;

    /// How sure a direction must be to be taken without a warning.
    ///
    /// Test: `the_surest_decides_for_those_that_hardly_tell`.
    pub(crate) const UNSURE: f64 = 0.8;

    /// Fraction of a test's peak velocity from which on it counts as fast.
    ///
    /// Far enough from slow for a damper's force to grow by more than hysteresis.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const FAST: f64 = 0.9;

    /// Fractions of a test's peak velocity between which it counts as slow, clear of the turning points, where friction changes its sign.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const SLOW: [f64; 2] = [0.15, 0.35];

    /// Samples that a force at some speed needs.
    ///
    /// Test: none.
    pub(crate) const FEWEST: usize = 10;
}

/// Numbers of `checks/unit_magnitude.rs`.
pub(crate) mod unit_magnitude {
    /// Current, A, from which mA were likely read as A. Valves of dampers take up to 3 A, coils of magneto-rheological ones up to 10 A.
    ///
    /// Test: `milliamperes_that_are_called_amperes_are_refused`.
    pub(crate) const MOST_CURRENT: f64 = 30.0;

    /// Damping of the fastest test, N s/m, below which a force is likely written in kN.
    ///
    /// A damper of 20 N at 1 m/s has 20, one of a passenger car in kN some units.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const WEAKEST: f64 = 10.0;

    /// Force of the strongest test, N, from which it is taken for what it is; the smallest dampers reach twice that.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const WEAK: f64 = 8.0;

    /// Speed, m/s, from which a damper shows damping and not friction alone.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const MOVING: f64 = 0.02;

    /// Damping, N s/m, beyond which a displacement in m was likely read as mm. A heavy damper has 20 kN at 50 mm/s.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const STIFFEST: f64 = 3e5;

    /// Amplitude, m, below which that is likely. Friction alone reaches more only in strokes of some tenths of a millimeter, which are longer.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const SHORTEST: f64 = 1.5e-4;

    /// Velocity of the fastest test, m/s, below which milliseconds may have been read as seconds.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const SLOWEST: f64 = 6e-3;

    /// Slowest sampling, s, that speaks for milliseconds read as seconds.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const RARELY: f64 = 0.05;

    /// Length of the longest test, s, that speaks for milliseconds read as seconds.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const LONG: f64 = 3600.0;

    /// Frequency, Hz, that no damper rig reaches with an amplitude of a tenth of a millimetre and more.
    ///
    /// Test: `a_frequency_that_no_rig_reaches_is_another_unit_of_time`.
    pub(crate) const FASTEST: f64 = 150.0;

    /// Correlation of force and velocity above which the one follows the other, in whatever unit it is written.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const FOLLOWS: f64 = 0.3;
}

/// Numbers of `checks/force_levels.rs`.
pub(crate) mod force_levels {
    /// Ratio of one velocity to the next at which a test is looked at.
    ///
    /// The force grows by no more than that between two of them, and a sine has nine of them in the upper nine tenths of
    /// its velocities.
    ///
    /// Test: `a_sine_shows_force_against_motion_and_between_at_its_velocities`.
    pub(crate) const STEP: f64 = 1.3;

    /// Share of a test's peak velocity below which it is not looked at: there the noise of a derived velocity decides.
    ///
    /// Test: `a_sine_shows_force_against_motion_and_between_at_its_velocities`.
    pub(crate) const LOWEST: f64 = 0.1;

    /// Share of its peak velocity from which on a test is in the middle of its stroke.
    ///
    /// A sine then has gone less than seven eighths of the way to its end.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const MIDDLE: f64 = 0.5;

    /// Samples in each direction from which on a median stands for a velocity.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const FEWEST: usize = 5;
}

/// Numbers of `options.rs`.
pub(crate) mod options {
    /// Longest delay taken for one, s.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const LONGEST_DELAY: f64 = 1.0;

    /// Sampling rates that rigs have, 1/s: a slow test of a day, and the fastest acquisition of force.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const SAMPLE_RATES: (f64, f64) = (1e-3, 1e7);

    /// Factors taken for a calibration: three digits of a unit either way, and a thousandth more for what a sensor is off by.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const GAINS: (f64, f64) = (1e-4, 1e4);

    /// Largest zero of a force, N: what a load cell of heavy vehicles can show.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const LARGEST_FORCE_ZERO: f64 = 1e6;

    /// Largest zero of a displacement, m: what the longest drive can show.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const LARGEST_POSITION: f64 = 10.0;

    /// Largest mass taken for one that hangs on a load cell, kg: a heavy truck's damper with its clamps has less. A larger number was meant in
    /// grams. Below zero it gives back what a rig's own compensation took too much.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const LARGEST_MASS: f64 = 100.0;
}

/// Numbers of `cleaning/duplicates.rs`.
pub(crate) mod duplicates {
    /// Shortest block with new time stamps that counts as repeated; measured rows do not agree to the last digit so often.
    ///
    /// Test: `a_short_block_is_no_repetition`.
    pub(crate) const BLOCK: usize = 10;
}

/// Numbers of `cleaning/order.rs`.
pub(crate) mod order {
    /// How far, in samples, a row may be out of its place to be put back; further is another block of data.
    ///
    /// Test: `a_row_far_out_of_its_place_is_another_block`.
    pub(crate) const REACH: usize = 10;

    /// Most rows of an earlier run that a logger's buffer may still hold, as a share of all.
    ///
    /// More may be a test of its own.
    ///
    /// Test: `rows_of_an_earlier_run_are_left_out`.
    pub(crate) const STALE: f64 = 0.1;
}

/// Numbers of `cleaning/trim.rs`.
pub(crate) mod trim {
    /// A last cycle that deviates from the others by so many times their typical deviation is left out.
    ///
    /// Test: `a_disturbed_last_cycle_is_left_out`.
    pub(crate) const NOISY: f64 = 3.0;
}

/// Numbers of `cleaning/missing.rs`.
pub(crate) mod missing {
    /// Largest share of rows that may be dropped.
    ///
    /// Test: `a_small_fraction_and_a_short_run_may_be_missing`.
    pub(crate) const FRACTION: f64 = 0.02;

    /// Longest run of rows that may be dropped; a longer hole is no stray cell.
    ///
    /// Test: `a_small_fraction_and_a_short_run_may_be_missing`.
    pub(crate) const RUN: usize = 10;
}

/// Numbers of `cleaning/rests.rs`.
pub(crate) mod rests {
    /// Shortest rest between tests, s. A shorter pause is one within a test, or the turn of a slow one.
    ///
    /// Test: `tests_one_after_the_other_are_told_apart_and_named`.
    pub(crate) const REST: f64 = 1.0;

    /// Pieces of the shortest rest, each of which must be still.
    ///
    /// Test: none.
    pub(crate) const PIECES: usize = 4;

    /// Range of a channel at rest in standard deviations of its noise: ten thousand samples stay within eight.
    ///
    /// Test: `pauses_between_equal_cycles_part_nothing`.
    pub(crate) const STILL: f64 = 10.0;

    /// Stillness as a fraction of the range of the channel: sensors are good to a few ten thousandths of their range.
    ///
    /// Test: `a_channel_that_holds_its_value_at_rest_is_split_too`.
    pub(crate) const STILL_OF_RANGE: f64 = 3e-4;

    /// Share of a piece's samples on either side that may be spikes.
    ///
    /// Test: none.
    pub(crate) const SPIKES: f64 = 0.02;

    /// Fraction of the stroke by which the ends of two motions may differ to be the same motion again.
    ///
    /// Amplitudes of a list differ by more, and those that a drive makes of one setting by less.
    ///
    /// Test: none.
    pub(crate) const SAME_ENDS: f64 = 0.1;

    /// Fraction by which the mean speeds of two motions may differ to be the same motion again.
    ///
    /// Frequencies of a list differ by more, and those that a drive makes of one setting by less.
    ///
    /// Test: `tests_one_after_the_other_are_told_apart_and_named`.
    pub(crate) const SAME_SPEED: f64 = 0.15;

    /// Samples of the rest on either side that stay with a motion: a cycle that begins out of rest is found so.
    ///
    /// Test: none.
    pub(crate) const MARGIN: usize = 2;

    /// How many times as long as a turn a pause must be to be a rest.
    ///
    /// It is found in pieces, and noise keeps it still for longer.
    ///
    /// Test: `tests_one_after_the_other_are_told_apart_and_named`.
    pub(crate) const TURN: f64 = 3.0;

    /// Share of its range that a motion goes to count as a stroke.
    ///
    /// Test: `tests_one_after_the_other_are_told_apart_and_named`.
    pub(crate) const STROKE: f64 = 0.3;
}

/// Numbers of `cleaning/cycles.rs`.
pub(crate) mod cycles {
    /// Allowed deviation of stroke and period from their medians: what the bulk scatters, but at least and at most this.
    ///
    /// Test: `a_small_sine_after_a_long_way_to_its_start_is_found`.
    pub(crate) const TOLERANCE: (f64, f64) = (0.03, 0.15);

    /// Tolerance of the first and the last cycle once the crossings are exact: the tail of a run-up is small.
    ///
    /// Test: `a_small_sine_after_a_long_way_to_its_start_is_found`.
    pub(crate) const END_TOLERANCE: f64 = 0.003;

    /// Correlation of neighboring cycles that makes a test periodic.
    ///
    /// Test: `a_record_that_is_whole_cycles_already_keeps_them_all`.
    pub(crate) const LIKENESS: f64 = 0.97;

    /// Share of the fundamental that one or two cycles must have, with nothing to compare them with: a triangle has 0.985.
    ///
    /// Test: `rest_run_up_and_run_down_are_no_cycles`.
    pub(crate) const LONELY: f64 = 0.98;

    /// Share of their stroke by which they may turn on the way.
    ///
    /// Test: none.
    pub(crate) const WIGGLE: f64 = 0.01;
}

/// Numbers of `cleaning/clipped.rs`.
pub(crate) mod clipped {
    /// Fewest equal samples at the extreme that make a flat top.
    ///
    /// Test: `a_rounded_peak_is_none_where_other_tests_go_further`.
    pub(crate) const RUN: usize = 4;

    /// Share of clipped force samples up to which the record is still used without them.
    ///
    /// Test: `a_little_clipped_force_is_masked_and_much_is_refused`.
    pub(crate) const FORCE_FRACTION: f64 = 0.05;

    /// Share of the samples that a rounded peak may take; more is an end of the range, for a range may be switched between tests.
    ///
    /// Test: `a_rounded_peak_is_none_where_other_tests_go_further`.
    pub(crate) const ROUNDED_FRACTION: f64 = 0.05;

    /// Share of the overshoot of a clipped channel that the other one shows at least: a parabola has two thirds of it in the mean.
    ///
    /// Test: `a_clipped_motion_channel_gives_way_to_the_other`.
    pub(crate) const SHOWN: f64 = 1.0 / 3.0;
}

/// Numbers of `cleaning/gaps.rs`.
pub(crate) mod gaps {
    /// How many times longer than the steps around it a step is that counts as a gap. Loggers that change their rate do so for
    /// many samples; lost telegrams cost a few.
    ///
    /// Test: `lost_samples_and_a_change_of_rate_are_no_gaps`.
    pub(crate) const LONGER: f64 = 12.0;

    /// Steps on each side that a step is compared with.
    ///
    /// Test: none.
    pub(crate) const AROUND: usize = 15;

    /// Ratio by which a stump may go beyond the strokes of the cycles.
    ///
    /// Test: none.
    pub(crate) const BEYOND: f64 = 1.1;

    /// Most turns of such a stump. A motion of another kind has more.
    ///
    /// Test: none.
    pub(crate) const TURNS: usize = 5;
}

/// Numbers of `cleaning/still.rs`.
pub(crate) mod still {
    /// Standard deviation, in standard deviations of the noise, up to which a channel shows noise alone.
    ///
    /// The smallest sine that stands out has an amplitude of two thirds of the noise.
    ///
    /// Test: `rest_is_told_from_the_smallest_motion`.
    pub(crate) const SPREAD: f64 = 1.1;

    /// Range, in standard deviations of the noise, up to which a channel shows noise alone: white noise of a hundred thousand samples stays inside.
    ///
    /// Test: `rest_is_told_from_the_smallest_motion`.
    pub(crate) const RANGE: f64 = 10.0;

    /// A resting sensor flickers between two or three values of its last digit.
    ///
    /// Test: none.
    pub(crate) const FLICKER: usize = 3;
}

/// Numbers of `cleaning/stairs.rs`.
pub(crate) mod stairs {
    /// Fraction of the whole range that a stroke has at least: the slowest speeds may have short ones.
    ///
    /// Test: `every_speed_of_a_friction_program_is_a_test`.
    pub(crate) const STROKE: f64 = 0.1;

    /// Root mean square by which a stroke may deviate from a line, as a fraction of its length. Half a sine deviates by 0.043.
    ///
    /// Test: none.
    pub(crate) const LINE_DEVIATION: f64 = 0.015;

    /// Fraction of all strokes that must be straight.
    ///
    /// Test: `every_speed_of_a_friction_program_is_a_test`.
    pub(crate) const MOST: f64 = 0.9;

    /// By how much speeds of one test may differ, as a ratio.
    ///
    /// Drives keep them to a few percent, time stamps of slow loggers are rounded.
    ///
    /// Test: `every_speed_of_a_friction_program_is_a_test`.
    pub(crate) const SAME: f64 = 1.15;

    /// Strokes of a test: one to and one fro.
    ///
    /// Test: `every_speed_of_a_friction_program_is_a_test`.
    pub(crate) const FEWEST_STROKES: usize = 2;

    /// Samples of a stroke up to which its speed is that of the whole stroke.
    ///
    /// A window of a few samples would reach around both its turns.
    ///
    /// Test: none.
    pub(crate) const COARSE: usize = 40;
}

/// Numbers of `cleaning/swapped_columns.rs`.
pub(crate) mod swapped_columns {
    /// Largest range of displacement, m, that a damper rig has.
    ///
    /// Test: none.
    pub(crate) const LONGEST: f64 = 1.0;

    /// Share of steps forward that a time column has at least.
    ///
    /// Test: `swapped_headings_are_told_with_the_evidence`.
    pub(crate) const FORWARD: f64 = 0.9;

    /// How much rougher than a force a displacement must be to be one; a motion is smooth, a force is not.
    ///
    /// Test: none.
    pub(crate) const ROUGHER: f64 = 2.5;

    /// Overtones of a motion from which on it is none that a rig drives as a sine.
    ///
    /// Test: `exchanged_channels_are_told_before_a_sign_or_a_delay_is_blamed`.
    pub(crate) const NO_SINE: f64 = 0.03;

    /// How much purer the force must be. A damper's force bends the motion or follows it: a force in proportion to the motion, or to its
    /// speed, has at least the motion's overtones, and a rig that shakes has them in both.
    ///
    /// Test: `exchanged_channels_are_told_before_a_sign_or_a_delay_is_blamed`.
    pub(crate) const PURER: f64 = 3.0;

    /// The highest that is looked at; friction and knees show below it, noise is spread over all.
    ///
    /// Test: `exchanged_channels_are_told_before_a_sign_or_a_delay_is_blamed`.
    pub(crate) const HIGHEST: usize = 7;
}

/// Numbers of `cleaning/mod.rs`.
pub(crate) mod cleaning {
    /// Fewest samples of a test.
    ///
    /// Test: `too_few_samples_are_refused`.
    pub(crate) const FEWEST: usize = 20;

    /// Length of the differentiating window, as a share of the cycle: bends the fundamental by 2e-5 and its fifth
    /// harmonic by 1 %.
    ///
    /// Test: none.
    pub(crate) const WINDOW_OF_CYCLE: f64 = 1.0 / 12.0;

    /// Length of the differentiating window where there is no cycle, s: bends 25 Hz, the upper end of road motion at a
    /// damper, by 1 %.
    ///
    /// Test: none.
    pub(crate) const WINDOW_NO_CYCLE: f64 = 0.017;

    /// Share of samples with a shorter window up to which nothing is said: of a smooth motion some thousandths get one by chance.
    ///
    /// Test: none.
    pub(crate) const BY_CHANCE: f64 = 0.01;
}

/// Numbers of `cleaning/frozen.rs`.
pub(crate) mod frozen {
    /// Fewest equal samples in a row that can be called frozen.
    ///
    /// Test: `clipped_force_samples_are_left_out`.
    pub(crate) const RUN: usize = 30;
}

/// Numbers of `cleaning/outliers.rs`.
pub(crate) mod outliers {
    /// Longest spike, samples.
    ///
    /// Test: `spikes_are_replaced_and_nothing_else`.
    pub(crate) const LONGEST: usize = 3;

    /// Above this share of samples the channel is not spiky but noisy, and is left alone.
    ///
    /// Test: `a_channel_full_of_spikes_is_left_alone_but_told`.
    pub(crate) const FRACTION: f64 = 0.01;
}

/// Numbers of `cleaning/settings.rs`.
pub(crate) mod settings {
    /// Share of the whole range below which a swing is no cycle of a test: small tests beside large ones are found down to it.
    ///
    /// Test: none.
    pub(crate) const SMALLEST: f64 = 0.01;

    /// By how much, as a logarithm, stroke and period of the cycles of one setting may lie off their median.
    ///
    /// Drives keep both to a few percent.
    ///
    /// Test: `what_changes_little_by_little_or_all_the_time_is_one_test`.
    pub(crate) const SAME: f64 = 0.05;

    /// Fewest cycles of a setting: a drive that makes four of each goes on to the next within the first and the last. On a road two alike are rare, and
    /// nearly all would have to be.
    ///
    /// Test: `what_changes_little_by_little_or_all_the_time_is_one_test`.
    pub(crate) const STAYS: usize = 2;

    /// Cycles by which the next one is judged.
    ///
    /// Test: none.
    pub(crate) const BEFORE: usize = 3;

    /// Share of all cycles that must keep a setting: what changes all the time, as a road does, has none.
    ///
    /// Test: `frequencies_and_amplitudes_that_are_stepped_through_are_tests_of_their_own`.
    pub(crate) const COVERED: f64 = 0.7;

    /// How many times the scatter from cycle to cycle a jump is.
    ///
    /// Test: none.
    pub(crate) const JUMPS: f64 = 5.0;
}

/// Numbers of `formats/lvm.rs`.
pub(crate) mod lvm {
    /// How far a packet may begin from where the one before ended and still go on with it, as a share of its length.
    ///
    /// Clocks of packets are read once a packet.
    ///
    /// Test: none.
    pub(crate) const TOGETHER: f64 = 0.02;
}

/// Numbers of `formats/mdf/mod.rs`.
pub(crate) mod mdf {
    /// Fraction of the shorter time that both must cover.
    ///
    /// Test: `force_and_motion_of_two_rates_are_joined_at_the_slower_times`.
    pub(crate) const TOGETHER: f64 = 0.5;
}
