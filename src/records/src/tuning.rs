//! Tuning constants of reading and checking records: thresholds, priors, limits. Each file that uses such constants has
//! a module here.
//!
//! Every constant has its unit and its reason, and names a test. The test fails when the constant is doubled
//! or halved, or changed by a factor of five if doubling and halving have no effect. `tests/tests/source/tuning.rs`
//! checks the form. Budgets of readers, names and physical constants are in the files that use them.

/// Constants of `campaign/date_agreement.rs`.
pub(crate) mod date_agreement {
    /// Smallest ratio of two time spans of a campaign at which the order of day and month with the shorter span is
    /// used. One span is computed with the day first, the other with the month first.
    ///
    /// A campaign takes days. With day and month exchanged, its tests are scattered over the year. At a smaller ratio,
    /// the default order for the separator of the date is used.
    ///
    /// Test: `dates_decide_only_where_one_reading_lies_much_closer_together`.
    pub(crate) const CLOSER: f64 = 5.0;

    /// Time span of a campaign's tests, s, above which the order of day and month with this span counts as wrong. The
    /// ratio [`CLOSER`] must be exceeded too. With day and month exchanged, the tests of a campaign are scattered over
    /// the year.
    ///
    /// Test: `tests_of_one_campaign_lie_close_together`.
    pub(crate) const APART: f64 = 20.0 * 86_400.0;
}

/// Constants of `campaign/rig_sign.rs`.
pub(crate) mod rig_sign {
    /// Confidence in a campaign's sign above which other campaigns have no influence on it.
    ///
    /// If two campaigns have this confidence and opposite signs, they come from two rigs or two exports. A note reports
    /// them, and neither is reversed.
    ///
    /// Test: `the_surest_decides_for_those_that_hardly_tell`.
    pub(crate) const OWN: f64 = 0.9;
}

/// Constants of `campaign/common_clock.rs`.
pub(crate) mod common_clock {
    /// Longest time span of a campaign, s, for which its records get a common clock if the files state only the time of
    /// day. Beyond half a day, the order of two tests is uncertain.
    ///
    /// Test: `what_is_no_one_clock_is_said`.
    pub(crate) const WITHOUT_DATE: f64 = 0.5 * 86_400.0;

    /// Longest time span of a campaign, s, for which its records get a common clock if the files state the date: a
    /// year. In a longer campaign, a date is likely wrong.
    ///
    /// Test: `a_campaign_with_dates_lasts_a_year_at_most`.
    pub(crate) const WITH_DATE: f64 = 366.0 * 86_400.0;
}

/// Constants of `signal/consistency.rs`.
pub(crate) mod consistency {
    /// Largest time shift of a recorded velocity relative to the displacement, as a fraction of the sampling interval,
    /// at which the velocity is used. A converter samples the two channels one after the other. If both this limit and
    /// [`LAG_OF_PHASE`] are exceeded, the velocity is derived from the displacement.
    ///
    /// Test: `a_lag_within_conversion_or_noise_is_none`.
    pub(crate) const LAG_OF_SAMPLE: f64 = 0.25;

    /// Largest phase shift of a recorded velocity relative to the displacement, rad, at which the velocity is used.
    ///
    /// A shift of 0.01 rad opens the force-velocity loop at zero velocity by 1 % of the force, which equals the noise
    /// of good rigs. The limit is twice that shift. At 200 samples per cycle, the limit exceeds half a sample.
    ///
    /// Test: `a_lag_within_conversion_or_noise_is_none`.
    pub(crate) const LAG_OF_PHASE: f64 = 0.02;

    /// Fraction of the displacement's variance that the integral of a velocity must explain for the lag of the velocity
    /// to be reliable. At a smaller fraction, the lag is ignored.
    ///
    /// Test: `gain_and_lag_are_found`.
    pub(crate) const SAME_MOTION: f64 = 0.98;
}

/// Constants of `signal/delay.rs`.
pub(crate) mod delay {
    /// Longest delay in the search, s. Filters and bus systems of rigs have shorter delays. A longer delay indicates
    /// channels that do not belong together.
    ///
    /// Test: `a_turned_sign_is_told_from_a_delay`.
    pub(crate) const LONGEST: f64 = 0.060;

    /// Step of the search for the delay, s. A parabola interpolates between the steps.
    ///
    /// Test: `a_delay_is_found_to_a_tenth_of_a_millisecond`.
    pub(crate) const STEP: f64 = 0.001;

    /// Smallest ratio of [`LONGEST`] to the period of a test at which the search for a delay uses the test. In slower
    /// tests, friction would mask a delay.
    ///
    /// Test: `slow_tests_tell_no_delay_and_long_ones_are_thinned_out`.
    pub(crate) const TELLING: f64 = 0.02;

    /// Smallest number of samples of a longer test after decimation. The number after decimation is less than twice
    /// this number.
    ///
    /// Test: `slow_tests_tell_no_delay_and_long_ones_are_thinned_out`.
    pub(crate) const SAMPLES: usize = 1500;

    /// Nodes of the force-velocity curve for one sign of velocity, relative to the highest velocity of all tests. They
    /// are dense near zero, where friction reverses.
    ///
    /// Test: `nodes_of_the_curve_join`.
    pub(crate) const NODES: [f64; 7] = [0.015, 0.03, 0.06, 0.12, 0.25, 0.5, 1.0];

    /// Absolute value of the normalized power, 0 to 1, below which a test counts neither as dissipating nor as feeding
    /// energy. The normalized power is the correlation of force and velocity.
    ///
    /// Test: `power_near_zero_is_neither_dissipation_nor_its_contrary`.
    pub(crate) const UNCLEAR: f64 = 0.1;

    /// Shortest delay that a note reports, s. Shorter delays are indistinguishable from the effects of series
    /// compliance and filters.
    ///
    /// Test: `delays_are_found_to_a_millisecond_and_their_absence_too`.
    pub(crate) const SHORTEST_REPORTED: f64 = 0.005;

    /// Largest ratio of the unexplained force variance with the delay to that without it at which the delay is
    /// reported.
    ///
    /// Test: `a_delay_that_explains_little_of_the_force_is_not_reported`.
    pub(crate) const BETTER: f64 = 0.6;

    /// Ratio of two unexplained force variances below which the cause with the smaller variance is selected. One
    /// variance assumes a delay of the force, the other a reversed sign. At a larger ratio, the error names both
    /// causes.
    ///
    /// Test: `a_turned_sign_is_told_from_a_delay`.
    pub(crate) const CLEARLY: f64 = 0.7;
}

/// Constants of `signal/derivative.rs`.
pub(crate) mod derivative {
    /// Largest number of samples on each side of the center of a differentiating window. More samples cost time and
    /// hardly reduce the noise.
    ///
    /// Test: `a_window_holds_a_bounded_number_of_samples`.
    pub(crate) const REACH: usize = 250;

    /// Tolerance of the agreement between the derivatives of a long and a shorter window at one sample, in standard
    /// deviations of their noise.
    ///
    /// With 4, one sample in a thousand of a smooth motion has a shorter window by chance, and thus a noisy derivative.
    /// At a corner of the motion, the difference is tens of standard deviations.
    ///
    /// Test: `a_triangle_keeps_its_velocity_up_to_its_corners`.
    pub(crate) const SAME: f64 = 5.0;

    /// Ratio of the lengths of successive differentiating windows, from the shortest to the longest. A smaller ratio
    /// costs time. With a larger ratio, some samples have a window that is too short by up to this ratio.
    ///
    /// Test: `windows_grow_by_less_than_half_and_are_few`.
    pub(crate) const LONGER: f64 = 1.4;
}

/// Constants of `signal/noise.rs`.
pub(crate) mod noise {
    /// Smallest number of samples for a noise estimate from sample differences. It is also the smallest number of
    /// deviations for an estimate from repeated cycles. With fewer deviations, sample differences are used. With fewer
    /// samples, the noise is unknown.
    ///
    /// Test: `without_cycles_differences_of_samples_serve`.
    pub(crate) const FEWEST: usize = 12;
}

/// Constants of `quantities/load_cell.rs`.
pub(crate) mod load_cell {
    /// Expected zero offset of a load cell, N, for a car damper.
    ///
    /// The value is 0.1 % of the range of a 15 kN cell. A smaller force at standstill is no evidence of gas. A smaller
    /// deviation of a test from the others is not significant.
    ///
    /// Test: `a_cell_is_chosen_for_its_damper`.
    pub(crate) const OFFSET: f64 = 15.0;

    /// Range of the largest force of a car damper, N. In this range the expected offset is constant, so that the
    /// criteria are equal for soft and firm dampers.
    ///
    /// The range covers the virtual rigs and the measured dampers of the project's book, 0.4 to 6 kN. A narrower range
    /// would change the results for cars. Laboratories use a smaller cell for weaker dampers and a larger cell for
    /// stronger dampers. Outside this range, the expected offset is therefore proportional to the largest force.
    ///
    /// Test: `a_cell_is_chosen_for_its_damper`.
    pub const OF_CARS: (f64, f64) = (300.0, 8000.0);
}

/// Constants of `checks/force_offset.rs`.
pub(crate) mod force_offset {
    /// Smallest number of other tests at a velocity for their median to represent the damper. A velocity with fewer
    /// other tests is not compared.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const FEWEST: usize = 3;

    /// Smallest number of velocities shared with other tests for an offset to count as constant.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const VELOCITIES: usize = 3;

    /// Smallest number of velocities shared with other tests for a sign reversal to be detected.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const TWO: usize = 2;

    /// Acceptable deviation of a test's force from that of the others, in multiples of the scatter of the others. The
    /// offset of a load cell is allowed in addition.
    ///
    /// Creep of the load cell and warming of the gas cause scatter.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const OF_SCATTER: f64 = 3.0;

    /// Multiple of the acceptable force deviation above which a test counts as reversed. The reversal must also reduce
    /// the deviation to an acceptable value.
    ///
    /// Test: `a_small_mean_force_proves_no_turned_test`.
    pub(crate) const STRONG: f64 = 2.0;

    /// Largest ratio of scatter to offset at which a changed zero of the load cell explains the deviation of a test.
    /// The offset is the median deviation over the velocities, and the scatter is the median absolute deviation from
    /// this median. A larger scatter indicates an effect of stroke or position.
    ///
    /// The offset at the ends of the strokes may differ from that in the middle by this fraction.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const CONSTANT: f64 = 0.3;

    /// Largest fraction of deviating tests in a campaign at which a note reports them. If more tests deviate, the other
    /// tests may be wrong, so no note is made.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const FEW: f64 = 0.34;
}

/// Constants of `checks/truncated_test.rs`.
pub(crate) mod truncated_test {
    /// Smallest distance between two turning points that counts as a stroke, as a fraction of the range of the motion.
    /// The search for cycles begins with the same fraction.
    ///
    /// Test: `a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not`.
    pub(crate) const STROKE: f64 = 0.3;

    /// Smallest number of stroke ends in a whole cycle, including the ends of the record. A test with fewer stroke ends
    /// that ends in motion counts as truncated.
    ///
    /// Test: `a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not`.
    pub(crate) const OF_A_CYCLE: usize = 4;

    /// Fraction of the peak velocity above which the last velocity of a test means that the test ends in motion. A sine
    /// is below this fraction for a fifth of its time.
    ///
    /// Test: `a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not`.
    pub(crate) const MOVING: f64 = 0.3;

    /// Number of last samples from which the median velocity at the end is computed.
    ///
    /// Test: `a_test_that_ends_within_its_first_stroke_is_told_and_a_ramp_to_rest_is_not`.
    pub(crate) const LAST: usize = 5;
}

/// Constants of `checks/deviating_tests`.
pub(crate) mod deviating_tests {
    /// Absolute natural logarithm of the force ratio below which two tests agree.
    ///
    /// The limit includes a damper that is 30 % softer when warm, and the two sides of a hysteresis loop. Two tests of
    /// faultless campaigns, even of real dampers, mostly differ by less than 0.1. With free play, they differ by up to
    /// 0.3.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const AGREE: f64 = 0.4;

    /// Absolute natural logarithm of the force ratio above which the damper cannot cause the difference: a factor of
    /// 3.5. A wrong unit is then likely.
    ///
    /// The pound-force is the unit of force closest to the newton. The logarithm of their ratio is 1.49. Free play and
    /// presliding cause differences of up to 0.7.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const OFF: f64 = 1.25;

    /// Ratio of two units above which the damper cannot cause the deviation of a test from the other tests. The force
    /// of an adjustable damper changes by a factor of up to 15.
    ///
    /// Test: `a_unit_that_no_damper_explains_may_leave_a_residual`.
    pub(crate) const BEYOND_DAMPERS: f64 = 50.0;

    /// Largest deviation of a test from the others, with its likely unit or label, at which this unit or label explains
    /// its forces. A deviation is the natural logarithm of the force ratio. Two tests that agree deviate by up to this
    /// value.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const CLOSE: f64 = 0.3;

    /// Value that replaces [`CLOSE`] if the ratio of the two units exceeds [`BEYOND_DAMPERS`], as a natural logarithm
    /// of the force ratio. The value is a factor of two.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const CLOSE_BEYOND: f64 = 0.7;

    /// Smallest ratio of a test's deviation to the median deviation of all tests at which the label of the test is
    /// doubted. A deviation is that from the other tests at the same setting. With a smaller ratio, heat and hysteresis
    /// would be mistaken for another setting.
    ///
    /// Test: `labels_of_little_difference_are_seen_by_the_scatter`.
    pub(crate) const TIMES_SCATTER: f64 = 5.0;

    /// Smallest deviation of a test from the tests at its setting at which its label is doubted, as a natural logarithm
    /// of the force ratio. A damper repeats within a few percent from test to test.
    ///
    /// Test: `labels_of_little_difference_are_seen_by_the_scatter`.
    pub(crate) const LEAST_CONTRAST: f64 = 0.1;

    /// Largest ratio of a test's deviation from the tests at another setting to that from the tests at its own setting.
    /// At a larger ratio, its label is not doubted.
    ///
    /// Test: `labels_of_little_difference_are_seen_by_the_scatter`.
    pub(crate) const OF_OWN: f64 = 0.35;

    /// Disagreement of two motions due to the scatter of repeated tests, as a natural logarithm of the force ratio. The
    /// value is added to two disagreements before their ratio is computed. Otherwise, the ratio of two small
    /// disagreements would seem to prove mirrored labels.
    ///
    /// Test: `motions_counted_from_the_other_end_are_named_up_to_half_of_them`.
    pub(crate) const REPEATED: f64 = 0.02;

    /// Largest relative difference of amplitude and peak velocity between equal motions.
    ///
    /// Test: `labels_of_little_difference_are_seen_by_the_scatter`.
    pub(crate) const SAME_MOTION: f64 = 0.1;

    /// Largest difference between the force residuals of a test with two units at which both units are likely. A
    /// residual is the root mean square of natural logarithms of force ratios. A wrong label is reported unless the
    /// residual with a wrong unit is smaller by this value. The logarithms of kilogram-force and decanewton differ by
    /// 0.02.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const AS_LIKELY: f64 = 0.05;

    /// Smallest number of velocities shared with the other tests at which the unit of a test is checked. A triangular
    /// motion rarely has more than two.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const FEWEST: usize = 2;

    /// Acceptable deviation of the mean force of the two directions from that of the others, in multiples of its
    /// scatter between tests. [`load_cell::OFFSET`](super::load_cell::OFFSET) is accepted in addition.
    ///
    /// Test: `the_scatter_of_the_gas_force_excuses_a_factor`.
    pub(crate) const OF_SCATTER: f64 = 3.0;

    /// Smallest ratio of a test's amplitude to that of some other test at which their forces are comparable.
    ///
    /// Mounts, oil compressibility and free play absorb a fraction of short strokes.
    ///
    /// Test: `a_test_is_compared_with_strokes_of_up_to_one_and_a_half_times`.
    pub(crate) const AS_LONG: f64 = 0.67;
}

/// Constants of `checks/plausibility.rs`.
pub(crate) mod plausibility {
    /// Largest displacement amplitude, m, that is not rejected as implausible. The amplitude of the longest suspensions
    /// is half of that.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const LARGEST_AMPLITUDE: f64 = 0.5;

    /// Highest peak velocity, m/s, that is not rejected as implausible. Curb strikes reach about 10 m/s.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const HIGHEST_SPEED: f64 = 20.0;

    /// Largest force, N, that is not rejected as implausible. Dampers of heavy vehicles reach a third of that.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const LARGEST_FORCE: f64 = 2e5;

    /// Force range, N, that at least one test of every damper exceeds. Otherwise, the campaign is rejected. Even the
    /// dampers of toys and drawers reach a newton.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const LEAST_FORCE: f64 = 0.05;

    /// Amplitude of the largest test, m, below which a note doubts the unit.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const SMALL_AMPLITUDE: f64 = 2e-4;

    /// Peak velocity of the fastest test, m/s, below which a note doubts the units.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const SMALL_SPEED: f64 = 6e-3;

    /// Peak-to-peak force of the strongest test, N, below which a note doubts the unit.
    ///
    /// Test: `limits_of_what_a_damper_can_show`.
    pub(crate) const SMALL_FORCE: f64 = 20.0;

    /// Range of the force, in standard deviations of its noise, below which the force contains only noise.
    /// [`NOISE_SPREAD`] must be met too. White noise of a hundred thousand samples stays within this range.
    ///
    /// Test: `noise_is_known_by_its_range_and_its_spread`.
    pub(crate) const NOISE_RANGE: f64 = 10.0;

    /// Ratio of the standard deviation of the force to that of its noise below which the force contains only noise.
    /// [`NOISE_RANGE`] must be met too.
    ///
    /// Test: `noise_is_known_by_its_range_and_its_spread`.
    pub(crate) const NOISE_SPREAD: f64 = 1.1;

    /// Peak velocity, m/s, below which a damper counts as at standstill, so that a force is not required.
    ///
    /// Test: `noise_is_known_by_its_range_and_its_spread`.
    pub(crate) const STANDSTILL: f64 = 1e-4;
}

/// Constants of `data/rig_frame.rs`.
pub(crate) mod rig_frame {
    /// Relative margin by which a test may exceed the range of the recorded tests. Amplitudes of a test list are
    /// rounded, whereas amplitudes of a record are measured.
    ///
    /// Test: `tests_are_given_as_the_rig_counts_and_within_its_reach`.
    pub(crate) const BEYOND: f64 = 0.02;
}

/// Constants of `checks/sign.rs`.
pub(crate) mod sign {
    /// Uncertainty of the standstill force due to hysteresis, as a fraction of half the force range of the test.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const HYSTERESIS: f64 = 0.1;

    /// Fraction of the rigs with a force zero that was set with the damper mounted, or never set.
    ///
    /// On such rigs, the force at standstill is no evidence of gas. The value is a conservative guess. It limits the
    /// odds of the gas force to seven to one, as [`MOST_BY_SHAPE`] limits those of the asymmetry. Neither is then
    /// certain if the other contradicts it.
    ///
    /// Test: `a_shifted_zero_of_the_load_cell_is_never_sure`.
    pub(crate) const TARED: f64 = 0.25;

    /// Prior mean of the natural logarithm of the ratio of the force in rebound to that in compression, for
    /// passenger-car dampers.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const PRIOR_RATIO: f64 = 0.6;

    /// Standard deviation between dampers of the natural logarithm of the ratio of the force in rebound to that in
    /// compression.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const RATIO_SCATTER: f64 = 0.5;

    /// Largest contribution of the asymmetry to the estimated direction, as log odds: seven to one.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const MOST_BY_SHAPE: f64 = 2.0;

    /// Largest log odds of an estimated direction, which equal a confidence of 99 %.
    ///
    /// Test: `no_direction_that_was_worked_out_is_certain`.
    pub(crate) const SUREST: f64 = 4.595;

    /// Confidence in an estimated direction below which a note warns that the direction is uncertain.
    ///
    /// Test: `the_surest_decides_for_those_that_hardly_tell`.
    pub(crate) const UNSURE: f64 = 0.8;

    /// Fraction of a test's peak velocity above which a sample belongs to the force at high speed.
    ///
    /// At this velocity, the force of a damper exceeds the force at low velocities by more than the hysteresis.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const FAST: f64 = 0.9;

    /// Fractions of a test's peak velocity between which a sample belongs to the force at low speed. They exclude the
    /// turning points, where friction changes its sign.
    ///
    /// Test: `friction_tells_no_direction_however_unlike_its_sides_are`.
    pub(crate) const SLOW: [f64; 2] = [0.15, 0.35];

    /// Smallest number of samples whose median counts as the force at a speed.
    ///
    /// Test: `the_force_at_a_speed_is_the_median_of_ten_samples`.
    pub(crate) const FEWEST: usize = 10;
}

/// Constants of `signal/unit_slip.rs`.
pub(crate) mod unit_slip {
    /// Largest relative deviation of a measured ratio from the ratio of two units at which another unit explains the
    /// measured ratio. The measured ratio is that of the velocity channel to the derivative of the displacement.
    /// Sensors have smaller errors, and no two units are so close.
    ///
    /// Test: `the_unit_with_a_typical_test_is_first`.
    pub(crate) const EXACTNESS: f64 = 0.06;

    /// Amplitude of a typical damper test, m. If several units explain a contradiction, the unit that gives the most
    /// typical test is the likely one. A wrong unit is wrong by a factor of ten or more, so a factor of two is
    /// irrelevant here.
    ///
    /// Test: `the_unit_with_a_typical_test_is_first`.
    pub(crate) const TYPICAL_AMPLITUDE: f64 = 0.02;

    /// Peak velocity of a typical damper test, m/s.
    ///
    /// Test: `the_unit_with_a_typical_test_is_first`.
    pub(crate) const TYPICAL_SPEED: f64 = 0.2;

    /// Frequency of a typical damper test, Hz.
    ///
    /// Test: `the_unit_with_a_typical_test_is_first`.
    pub(crate) const TYPICAL_FREQUENCY: f64 = 1.5;
}

/// Constants of `checks/unit_magnitude.rs`.
pub(crate) mod unit_magnitude {
    /// Current, A, above which values in mA were likely read as A. Damper valves use up to 3 A, and the coils of
    /// magneto-rheological dampers up to 10 A.
    ///
    /// Test: `milliamperes_that_are_called_amperes_are_refused`.
    pub(crate) const MOST_CURRENT: f64 = 30.0;

    /// Damping of the fastest test, N s/m, below which kN were likely read as N. The damping is half the force range
    /// divided by the peak velocity.
    ///
    /// A damper of 20 N at 1 m/s has 20 N s/m. If the force of a passenger-car damper in kN is read as N, the damping
    /// seems to be a few N s/m.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const WEAKEST: f64 = 10.0;

    /// Half the force range of the strongest test, N, above which the unit of force counts as correct. A wrong unit of
    /// time or displacement is reported only above this force. The smallest dampers reach twice that force.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const WEAK: f64 = 8.0;

    /// Peak velocity of the fastest test, m/s, above which the force is not only friction but also damping. The damping
    /// of slower tests is no evidence of a wrong unit of force.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const MOVING: f64 = 0.02;

    /// Damping of the fastest test, N s/m, above which a displacement in m was likely read as mm. A heavy damper may
    /// exceed this limit (20 kN at 50 mm/s are 4e5 N s/m), but not at amplitudes below [`SHORTEST`].
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const STIFFEST: f64 = 3e5;

    /// Largest amplitude of a campaign, m, below which a displacement in m was likely read as mm. [`STIFFEST`] must be
    /// exceeded too. In strokes of some tenths of a millimeter, friction alone can give such damping. Those strokes are
    /// longer than this limit.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const SHORTEST: f64 = 1.5e-4;

    /// Peak velocity of the fastest test, m/s, below which milliseconds may have been read as seconds. The sampling
    /// interval must also exceed [`RARELY`], and the length of the longest test [`LONG`].
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const SLOWEST: f64 = 6e-3;

    /// Sampling interval, s, above which milliseconds may have been read as seconds (with [`SLOWEST`] and [`LONG`]).
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const RARELY: f64 = 0.05;

    /// Length of the longest test, s, above which milliseconds may have been read as seconds (with [`SLOWEST`] and
    /// [`RARELY`]).
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const LONG: f64 = 3600.0;

    /// Frequency of a test, Hz, above which seconds were likely read as milliseconds. No damper rig reaches this
    /// frequency at an amplitude of more than 0.1 mm.
    ///
    /// Test: `a_frequency_that_no_rig_reaches_is_another_unit_of_time`.
    pub(crate) const FASTEST: f64 = 150.0;

    /// Frequency of a test, Hz, above which seconds were read as milliseconds at any amplitude. Then millimeters may
    /// also have been read as micrometers. Electrodynamic shakers for dampers end at some hundred hertz.
    ///
    /// Test: `a_frequency_that_no_rig_reaches_is_another_unit_of_time`.
    pub(crate) const BEYOND_ANY_RIG: f64 = 1000.0;

    /// Absolute correlation of force and velocity above which a force is that of a damper, and a small force suggests a
    /// wrong unit. At a smaller correlation, the load cell may be dead.
    ///
    /// Test: `units_are_doubted_only_where_all_figures_speak_for_it`.
    pub(crate) const FOLLOWS: f64 = 0.3;
}

/// Constants of `checks/force_levels.rs`.
pub(crate) mod force_levels {
    /// Ratio of the limits of successive velocity levels, at which the forces of a test are evaluated.
    ///
    /// Within a level, the velocity changes by this ratio. The force of most dampers changes by at most this ratio. A
    /// sine has nine levels in the upper 90 % of its velocity range.
    ///
    /// Test: `a_sine_shows_force_against_motion_and_between_at_its_velocities`.
    pub(crate) const STEP: f64 = 1.3;

    /// Fraction of a test's peak velocity below which samples are not evaluated, because the noise of a derived
    /// velocity dominates.
    ///
    /// Test: `a_sine_shows_force_against_motion_and_between_at_its_velocities`.
    pub(crate) const LOWEST: f64 = 0.1;

    /// Fraction of the peak velocity above which a sample lies in the middle of a stroke.
    ///
    /// A sine is then within seven eighths of the distance from its middle to its end.
    ///
    /// Test: `a_test_that_is_turned_round_and_a_zero_that_moved_are_told`.
    pub(crate) const MIDDLE: f64 = 0.5;

    /// Smallest number of samples in each direction whose median represents the force at a velocity.
    ///
    /// Test: `a_file_in_another_unit_is_named_with_the_unit`.
    pub(crate) const FEWEST: usize = 5;
}

/// Constants of `options.rs`.
pub(crate) mod options {
    /// Largest delay that the options accept, s.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const LONGEST_DELAY: f64 = 1.0;

    /// Sampling rates that the options accept, 1/s: from a slow test of a day to the fastest force acquisition.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const SAMPLE_RATES: (f64, f64) = (1e-3, 1e7);

    /// Calibration factors that the options accept. They allow a unit wrong by a factor of 1000, and a further factor
    /// of ten for a sensor error.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const GAINS: (f64, f64) = (1e-4, 1e4);

    /// Largest zero offset of a force that the options accept, N: the range of a load cell for heavy vehicles.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const LARGEST_FORCE_ZERO: f64 = 1e6;

    /// Largest zero offset of a displacement that the options accept, m: the travel of the longest drive.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const LARGEST_POSITION: f64 = 10.0;

    /// Largest magnitude of a setting that the rules accept, in its own unit. It equals the largest of a model file,
    /// which values in revolutions per minute or pascals do not reach.
    ///
    /// Test: `settings_beyond_their_bounds_are_rejected`.
    pub(crate) const LARGEST_SETTING: f64 = 1e9;

    /// Largest mass on a load cell that the options accept, kg. A heavy truck damper with its clamps has a smaller
    /// mass. A larger number is likely in grams.
    ///
    /// Test: `numbers_that_cannot_be_are_rejected_where_the_limits_are_stated`.
    pub(crate) const LARGEST_MASS: f64 = 100.0;
}

/// Constants of `cleaning/duplicates.rs`.
pub(crate) mod duplicates {
    /// Smallest number of rows of a block that counts as repeated with new time stamps. Measured rows rarely agree to
    /// the last digit over such a length.
    ///
    /// Test: `a_short_block_is_no_repetition`.
    pub(crate) const BLOCK: usize = 10;
}

/// Constants of `cleaning/order.rs`.
pub(crate) mod order {
    /// Largest distance, in rows, over which a misplaced row is moved to its position in time. A row that is further
    /// away belongs to another block of data, and the record is rejected.
    ///
    /// Test: `a_row_far_out_of_its_place_is_another_block`.
    pub(crate) const REACH: usize = 10;

    /// Largest fraction of rows from an earlier run, in the buffer of a logger, at which these rows are removed.
    ///
    /// More rows may be a separate test.
    ///
    /// Test: `rows_of_an_earlier_run_are_left_out`.
    pub(crate) const STALE: f64 = 0.1;
}

/// Constants of `cleaning/trim.rs`.
pub(crate) mod trim {
    /// Ratio above which the last cycle is removed: its force deviation from the other cycles, relative to the median
    /// of the other cycles' deviations.
    ///
    /// Test: `a_disturbed_last_cycle_is_left_out`.
    pub(crate) const NOISY: f64 = 3.0;
}

/// Constants of `cleaning/missing.rs`.
pub(crate) mod missing {
    /// Largest fraction of rows that may be dropped because a value is missing. If more values are missing, the record
    /// is rejected. Three rows may be dropped from any record.
    ///
    /// Test: `a_small_fraction_and_a_short_run_may_be_missing`.
    pub(crate) const FRACTION: f64 = 0.02;

    /// Longest run of consecutive rows that may be dropped because a value is missing. A longer run has another cause
    /// than single bad cells, so the record is rejected.
    ///
    /// Test: `a_small_fraction_and_a_short_run_may_be_missing`.
    pub(crate) const RUN: usize = 10;
}

/// Constants of `cleaning/rests.rs`.
pub(crate) mod rests {
    /// Shortest standstill between tests, s. A shorter pause is within a test, or is the turning point of a slow test.
    ///
    /// Test: `tests_one_after_the_other_are_told_apart_and_named`.
    pub(crate) const REST: f64 = 1.0;

    /// Number of pieces into which the shortest standstill is divided. Each piece must be still.
    ///
    /// Test: `a_standstill_longer_by_a_quarter_is_found_at_every_place`.
    pub(crate) const PIECES: usize = 4;

    /// Largest range of the displacement at standstill, in standard deviations of its noise. Ten thousand samples of
    /// noise stay within eight standard deviations.
    ///
    /// Test: `pauses_between_equal_cycles_part_nothing`.
    pub(crate) const STILL: f64 = 10.0;

    /// Range of the displacement, relative to its whole range, that always counts as standstill. Sensors are accurate
    /// to a few ten-thousandths of their range.
    ///
    /// Test: `a_channel_that_holds_its_value_at_rest_is_split_too`.
    pub(crate) const STILL_OF_RANGE: f64 = 3e-4;

    /// Fraction of a piece's samples at each extreme that may be spikes. The range of the piece leaves them out.
    ///
    /// Test: `a_few_spikes_are_no_motion`.
    pub(crate) const SPIKES: f64 = 0.02;

    /// Largest difference between the extreme displacements of two equal motions, relative to the stroke.
    ///
    /// The amplitudes of a test list differ by more. At one setting, the amplitudes of a drive differ by less.
    ///
    /// Test: `equal_motions_have_the_same_ends_within_a_tenth`.
    pub(crate) const SAME_ENDS: f64 = 0.1;

    /// Largest relative difference between the mean speeds of two equal motions.
    ///
    /// The frequencies of a test list differ by more. At one setting, the frequencies of a drive differ by less.
    ///
    /// Test: `tests_one_after_the_other_are_told_apart_and_named`.
    pub(crate) const SAME_SPEED: f64 = 0.15;

    /// Number of standstill samples on each side that stay with a motion. The search for cycles requires them if a
    /// cycle begins at standstill.
    ///
    /// Test: `a_motion_keeps_two_still_samples_on_either_side`.
    pub(crate) const MARGIN: usize = 2;

    /// Ratio of a pause to the apparent standstill of a slow motion at its turning points above which the pause is a
    /// real standstill.
    ///
    /// The search for standstills works piece by piece, and noise makes the apparent standstill longer. The ratio
    /// therefore exceeds one.
    ///
    /// Test: `tests_one_after_the_other_are_told_apart_and_named`.
    pub(crate) const TURN: f64 = 3.0;

    /// Smallest distance between two turning points that counts as a stroke, as a fraction of the range of the motion.
    ///
    /// Test: `tests_one_after_the_other_are_told_apart_and_named`.
    pub(crate) const STROKE: f64 = 0.3;
}

/// Constants of `cleaning/cycles.rs`.
pub(crate) mod cycles {
    /// Lower and upper limit of the relative tolerance of stroke and period about their medians. Between the limits,
    /// the tolerance follows from the scatter of most cycles. A motion outside the tolerance is not a cycle of the
    /// test.
    ///
    /// Test: `a_small_sine_after_a_long_way_to_its_start_is_found`.
    pub(crate) const TOLERANCE: (f64, f64) = (0.03, 0.15);

    /// Smallest relative tolerance of stroke and period of the first and the last cycle after refinement of the
    /// crossings. This tolerance is smaller than [`TOLERANCE`], because the end of a run-up causes only a small
    /// deviation.
    ///
    /// Test: `a_small_sine_after_a_long_way_to_its_start_is_found`.
    pub(crate) const END_TOLERANCE: f64 = 0.003;

    /// Median correlation of the shapes of neighboring cycles above which a test is periodic.
    ///
    /// Test: `a_record_that_is_whole_cycles_already_keeps_them_all`.
    pub(crate) const LIKENESS: f64 = 0.97;

    /// Smallest fraction of a cycle's variance in its fundamental at which the cycle counts. It applies to tests of one
    /// or two cycles, whose shapes cannot be compared. A triangular motion has 0.985.
    ///
    /// Test: `rest_run_up_and_run_down_are_no_cycles`.
    pub(crate) const LONELY: f64 = 0.98;

    /// Fraction of the stroke below which a reversal within a stroke is ignored in tests of one or two cycles. A larger
    /// reversal means that the motion is not periodic.
    ///
    /// Test: `a_lone_cycle_has_no_reversal_within_a_stroke`.
    pub(crate) const WIGGLE: f64 = 0.01;
}

/// Constants of `cleaning/clipped.rs`.
pub(crate) mod clipped {
    /// Smallest number of consecutive equal samples at the extreme of a channel that may be a flat top.
    ///
    /// Test: `a_rounded_peak_is_none_where_other_tests_go_further`.
    pub(crate) const RUN: usize = 4;

    /// Largest fraction of clipped force samples at which the record is used without these samples. With more, it is
    /// rejected.
    ///
    /// Test: `a_little_clipped_force_is_masked_and_much_is_refused`.
    pub(crate) const FORCE_FRACTION: f64 = 0.05;

    /// Largest fraction of a record's samples in flat tops that may be rounded peaks if other tests go further. More
    /// samples indicate the end of a measuring range, because a range may be switched between tests.
    ///
    /// Test: `a_rounded_peak_is_none_where_other_tests_go_further`.
    pub(crate) const ROUNDED_FRACTION: f64 = 0.05;

    /// Fraction of the estimated overshoot of a flat top that the other motion channel must show to prove the clipping.
    /// The estimate is the largest overshoot of a parabola; its mean overshoot is two thirds of that.
    ///
    /// Test: `a_clipped_motion_channel_gives_way_to_the_other`.
    pub(crate) const SHOWN: f64 = 1.0 / 3.0;
}

/// Constants of `cleaning/gaps.rs`.
pub(crate) mod gaps {
    /// Ratio of a time step to the neighboring steps above which the step is a gap. After a change of the logging rate,
    /// the steps on one side are as long as the step itself, so there is no gap. Lost telegrams are only a few samples,
    /// so they are no gap either.
    ///
    /// Test: `lost_samples_and_a_change_of_rate_are_no_gaps`.
    pub(crate) const LONGER: f64 = 12.0;

    /// Number of time steps before and after a candidate gap. The candidate is compared with the median of each side.
    ///
    /// Test: `a_slower_rate_is_no_gap_from_sixteen_steps_on`.
    pub(crate) const AROUND: usize = 15;

    /// Largest relative range of a piece without a whole cycle at which the piece is removed. The range is relative to
    /// the largest stroke of the cycles of the record.
    ///
    /// Test: `a_larger_motion_without_a_cycle_is_no_stump`.
    pub(crate) const BEYOND: f64 = 1.1;

    /// Largest number of turning points of a piece without a whole cycle at which the piece is left out. A motion of
    /// another kind has more turning points.
    ///
    /// Test: `a_motion_of_many_turns_without_a_cycle_is_no_stump`.
    pub(crate) const TURNS: usize = 5;
}

/// Constants of `cleaning/still.rs`.
pub(crate) mod still {
    /// Ratio of a channel's standard deviation to that of its noise below which the channel contains only noise.
    ///
    /// The smallest detectable sine has an amplitude of two thirds of the standard deviation of the noise.
    ///
    /// Test: `rest_is_told_from_the_smallest_motion`.
    pub(crate) const SPREAD: f64 = 1.1;

    /// Range of a channel, in standard deviations of its noise, below which the channel contains only noise. White
    /// noise of a hundred thousand samples stays within this range.
    ///
    /// Test: `rest_is_told_from_the_smallest_motion`.
    pub(crate) const RANGE: f64 = 10.0;

    /// Largest number of distinct values of a channel that always counts as at rest. A sensor at rest changes its last
    /// digit.
    ///
    /// Test: `three_distinct_values_are_rest_and_four_are_motion`.
    pub(crate) const FLICKER: usize = 3;
}

/// Constants of `cleaning/stairs.rs`.
pub(crate) mod stairs {
    /// Smallest distance between two turning points that counts as a stroke, as a fraction of the range of the
    /// displacement. The slowest speeds may have short strokes.
    ///
    /// Test: `every_speed_of_a_friction_program_is_a_test`.
    pub(crate) const STROKE: f64 = 0.1;

    /// Largest root mean square deviation of a stroke of constant speed from a straight line over time, relative to the
    /// length of the stroke. Half a cycle of a sine deviates by 0.043.
    ///
    /// Test: `a_stroke_may_deviate_little_from_a_straight_line`.
    pub(crate) const LINE_DEVIATION: f64 = 0.015;

    /// Smallest fraction of strokes of constant speed in a friction program. Other records are not split by speed.
    ///
    /// Test: `every_speed_of_a_friction_program_is_a_test`.
    pub(crate) const MOST: f64 = 0.9;

    /// Largest ratio of the speeds of two strokes of one test.
    ///
    /// Drives keep the speed constant within a few percent. Slow loggers round their time stamps, which changes the
    /// computed speed.
    ///
    /// Test: `every_speed_of_a_friction_program_is_a_test`.
    pub(crate) const SAME: f64 = 1.15;

    /// Smallest number of strokes of a test: one in each direction. If a speed has fewer strokes, the record is not
    /// split.
    ///
    /// Test: `every_speed_of_a_friction_program_is_a_test`.
    pub(crate) const FEWEST_STROKES: usize = 2;

    /// Largest number of samples of the shortest stroke at which the mean speed of each stroke becomes its velocity.
    ///
    /// A differentiating window would include both turning points of such a short stroke.
    ///
    /// Test: `short_strokes_get_their_mean_speed_as_velocity`.
    pub(crate) const COARSE: usize = 40;
}

/// Constants of `cleaning/swapped_columns.rs`.
pub(crate) mod swapped_columns {
    /// Largest displacement range of a damper rig, m. A larger range is one of the criteria for exchanged columns of
    /// force and displacement.
    ///
    /// Test: `a_rough_displacement_of_more_than_a_meter_is_a_force`.
    pub(crate) const LONGEST: f64 = 1.0;

    /// Fraction of increasing steps above which another column is likely the time, if the time column does not
    /// increase.
    ///
    /// Test: `swapped_headings_are_told_with_the_evidence`.
    pub(crate) const FORWARD: f64 = 0.9;

    /// Ratio of the roughness of the displacement to that of the force above which the two channels may be exchanged. A
    /// motion is smoother than a force.
    ///
    /// Test: `a_rough_displacement_of_more_than_a_meter_is_a_force`.
    pub(crate) const ROUGHER: f64 = 2.5;

    /// Ratio of the harmonics to the fundamental of a displacement above which the displacement is not the sine of a
    /// drive.
    ///
    /// Test: `exchanged_channels_are_told_before_a_sign_or_a_delay_is_blamed`.
    pub(crate) const NO_SINE: f64 = 0.03;

    /// Ratio of the displacement's harmonics to those of the force above which the two channels seem exchanged.
    /// Harmonics are relative to the fundamental.
    ///
    /// A force proportional to the motion or to its velocity has at least the harmonics of the motion. A vibrating rig
    /// has harmonics in both channels.
    ///
    /// Test: `exchanged_channels_are_told_before_a_sign_or_a_delay_is_blamed`.
    pub(crate) const PURER: f64 = 3.0;

    /// Highest harmonic that is evaluated. Friction and knees of the force mainly cause harmonics up to this one,
    /// whereas noise contributes to all harmonics.
    ///
    /// Test: `exchanged_channels_are_told_before_a_sign_or_a_delay_is_blamed`.
    pub(crate) const HIGHEST: usize = 7;
}

/// Constants of `cleaning/mod.rs`.
pub(crate) mod cleaning {
    /// Fewest samples of a test. A test with fewer samples is rejected.
    ///
    /// Test: `too_few_samples_are_refused`.
    pub(crate) const FEWEST: usize = 20;

    /// Length of the differentiating window relative to the period of the cycles. The relative error of the velocity is
    /// 2e-5 for the fundamental and 1 % for its fifth harmonic.
    ///
    /// Test: `a_derived_velocity_has_a_window_of_a_twelfth_of_a_cycle_or_of_17_ms`.
    pub(crate) const WINDOW_OF_CYCLE: f64 = 1.0 / 12.0;

    /// Length of the differentiating window if there are no cycles, s. The relative error of the velocity is 1 % at 25
    /// Hz, the upper end of road motion at a damper.
    ///
    /// Test: `a_derived_velocity_has_a_window_of_a_twelfth_of_a_cycle_or_of_17_ms`.
    pub(crate) const WINDOW_NO_CYCLE: f64 = 0.017;

    /// Fraction of samples with a shorter differentiating window below which no note is added. In a smooth motion, some
    /// thousandths of the samples have a shorter window by chance.
    ///
    /// Test: `windows_that_corners_shorten_are_noted_from_a_hundredth_of_the_samples_on`.
    pub(crate) const BY_CHANCE: f64 = 0.01;
}

/// Constants of `cleaning/frozen.rs`.
pub(crate) mod frozen {
    /// Smallest number of consecutive equal samples at which a channel may count as frozen.
    ///
    /// Test: `clipped_force_samples_are_left_out`.
    pub(crate) const RUN: usize = 30;
}

/// Constants of `cleaning/outliers.rs`.
pub(crate) mod outliers {
    /// Largest number of samples of a spike. A longer deviation stays unchanged.
    ///
    /// Test: `spikes_are_replaced_and_nothing_else`.
    pub(crate) const LONGEST: usize = 3;

    /// Fraction of samples in spikes above which the channel counts as noisy and stays unchanged.
    ///
    /// Test: `a_channel_full_of_spikes_is_left_alone_but_told`.
    pub(crate) const FRACTION: f64 = 0.01;
}

/// Constants of `cleaning/settings.rs`.
pub(crate) mod settings {
    /// Smallest distance between two turning points that counts in the search for cycles, relative to the range of the
    /// displacement. If a record contains large and small tests, the small ones are found down to this limit.
    ///
    /// Test: `a_small_test_is_found_down_to_a_hundredth_of_the_range`.
    pub(crate) const SMALLEST: f64 = 0.01;

    /// Largest deviation of stroke and period within one setting of the drive from their median, as a natural
    /// logarithm.
    ///
    /// Drives keep both constant within a few percent.
    ///
    /// Test: `what_changes_little_by_little_or_all_the_time_is_one_test`.
    pub(crate) const SAME: f64 = 0.05;

    /// Smallest number of successive similar cycles that form a setting of the drive. If a drive has four cycles at
    /// each setting, the first and the last contain the change, so two remain. On a road, two similar cycles are rare.
    ///
    /// Test: `what_changes_little_by_little_or_all_the_time_is_one_test`.
    pub(crate) const STAYS: usize = 2;

    /// Number of preceding cycles whose median is compared with the next cycle.
    ///
    /// Test: `a_cycle_is_compared_with_the_three_before_it`.
    pub(crate) const BEFORE: usize = 3;

    /// Smallest fraction of all cycles in settings of the drive at which a record is split. A motion that changes all
    /// the time, such as a road, has no setting.
    ///
    /// Test: `frequencies_and_amplitudes_that_are_stepped_through_are_tests_of_their_own`.
    pub(crate) const COVERED: f64 = 0.7;

    /// Smallest ratio of a jump of stroke or period to the scatter between cycles at which the jump separates two
    /// tests.
    ///
    /// Test: `a_jump_exceeds_the_scatter_of_the_cycles_by_a_factor_of_five`.
    pub(crate) const JUMPS: f64 = 5.0;
}

/// Constants of `formats/lvm.rs`.
pub(crate) mod lvm {
    /// Largest gap or overlap between consecutive packets of one record, relative to the length of a packet. After a
    /// larger one, another test begins.
    ///
    /// The acquisition system reads the clock once per packet, so small gaps and overlaps are not real.
    ///
    /// Test: `packets_join_over_a_gap_of_a_fiftieth_of_their_length`.
    pub(crate) const TOGETHER: f64 = 0.02;
}

/// Constants of `formats/mdf/mod.rs`.
pub(crate) mod mdf {
    /// Smallest common time of force and motion, relative to the shorter of the two, at which their groups are joined.
    ///
    /// Test: `force_and_motion_of_two_rates_are_joined_at_the_slower_times`.
    pub(crate) const TOGETHER: f64 = 0.5;
}
