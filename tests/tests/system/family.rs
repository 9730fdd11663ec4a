//! Tests of the fit of an adjustable damper to synthetic records of a damper with known parameters.
//!
//! The fit finds which parameters depend on the setting. At least nine tenths of the confidence intervals of the
//! parameters contain the true values. The model predicts the force at a setting between the measured settings.

use dashpot_core::family::axis::ENTRIES;
use dashpot_core::family::{Axis, Definition};
use dashpot_core::parameter::Number;
use dashpot_core::{Input, Model, Params, list, number};
use dashpot_estimation::first_guess;
use dashpot_estimation::samples::segments;
use dashpot_identification::family::{ActuatorFit, FamilyFit, at_setting, fit_family};
use dashpot_identification::model_file::{FvOnly, ModelFile, prepared_family};
use dashpot_identification::{Estimate, FitOptions, Standing};
use dashpot_other_lab::Protocol;
use dashpot_other_lab::semi_active::{LEFT_OUT, SemiActivePlant, SemiActiveTest, random, sines, steps};
use dashpot_proving::semi_active::{evaluate_tests, measure};
use dashpot_records::{Noise, Options, Record, Setting, SettingSignal, load};
use dashpot_tests::cli::{done, json, refused};
use dashpot_tests::kernel_campaign::{self, Sine};
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::LazyLock;

/// Currents of the records, A; [`BETWEEN`] is a current without records.
const CURRENTS: [f64; 4] = [0.0, 0.4, 0.8, 1.2];
const BETWEEN: f64 = 0.6;

/// Limits of the relative errors on one small campaign of a semi-active damper.
///
/// [`RANDOM`] applies to the force at a random current. [`LAG`] applies to the lag of the valve at all steps of the
/// current but the worst. [`WORST_LAG`] applies to the worst step, for which the book states 19 % with the whole
/// protocol.
const RANDOM: f64 = 0.03;
const LAG: f64 = 0.1;
const WORST_LAG: f64 = 0.2;

/// Returns six sines, one of them slow.
fn matrix() -> Vec<Sine> {
    let of = |(amplitude, peak): (f64, f64)| Sine::new(amplitude, peak / (TAU * amplitude));
    [(0.025, 0.005), (0.025, 0.13), (0.025, 0.52), (0.025, 1.05), (0.005, 0.26), (0.005, 0.52)].map(of).to_vec()
}

/// Simulates records of a damper at a current, A, with force noise of 1 % of the rms force.
fn records_at(damper: &Definition, current: f64, seed: u64) -> Vec<Record> {
    let mut records = kernel_campaign::campaign(&damper.params_at(current), &matrix(), seed, 0.01);
    for record in &mut records {
        record.name = format!("{}_{current}A", record.name);
        record.setting = Some(Setting { name: "current".into(), unit: "A".into(), value: current });
    }
    records
}

/// Makes a damper whose force and knee velocity grow with the current. `friction` is the Coulomb friction at each of
/// [`CURRENTS`], N, or `None` for a constant friction.
///
/// Its FV table has the velocities that a fit of its records chooses. A table at other velocities would interpolate to
/// another curve.
fn truth(friction: Option<[f64; 4]>) -> Definition {
    let mut params = kernel_campaign::base();
    let any = kernel_campaign::campaign(&params, &matrix(), 1, 0.0);
    let velocities = first_guess::velocities(&segments(&any.iter().collect::<Vec<_>>()));
    params.set_list(list!("fv_velocity"), &velocities).unwrap();
    let mut axis = Axis::NONE;
    axis.set_grid(&CURRENTS).unwrap();
    for (index, current) in CURRENTS.iter().enumerate() {
        let knee = 0.1 + 0.1 * current;
        let force = |v: f64| {
            let slope = if v > 0.0 { 2500.0 } else { 1500.0 };
            slope * (1.0 + current) * knee * (v / knee).tanh() + 600.0 * v
        };
        let forces: Vec<f64> = velocities.iter().map(|v| force(*v)).collect();
        axis.set_forces(index, &forces).unwrap();
    }
    if let Some(friction) = friction {
        axis.set_values(number!("coulomb_force"), &friction).unwrap();
    }
    axis.put(&mut params, 0.0);
    Definition { params, axis }
}

/// Returns fit options with the elements of [`truth`] only. A test of the valve needs no search for further effects,
/// which would take most of the test's time.
fn elements_of_truth() -> FitOptions {
    let elements = ["fv_curve", "coulomb_friction", "gas_preload", "series_compliance", "parallel_spring"];
    FitOptions { elements: Some(elements.map(str::to_owned).to_vec()), ..FitOptions::default() }
}

fn fitted(damper: &Definition, seed: u64) -> FamilyFit {
    fitted_with(&FitOptions::default(), damper, seed)
}

fn fitted_with(options: &FitOptions, damper: &Definition, seed: u64) -> FamilyFit {
    let records: Vec<Record> =
        CURRENTS.iter().enumerate().flat_map(|(k, current)| records_at(damper, *current, seed + k as u64)).collect();
    fit_family(&records.iter().collect::<Vec<_>>(), "current", options, |_| ()).unwrap()
}

/// Coulomb friction at each of [`CURRENTS`], N, of the damper with growing friction.
const GROWING: [f64; 4] = [20.0, 60.0, 110.0, 150.0];

/// Returns the fit of the damper with growing friction, computed once.
fn with_growing_friction() -> &'static FamilyFit {
    static FIT: LazyLock<FamilyFit> = LazyLock::new(|| fitted(&truth(Some(GROWING)), 31));
    &FIT
}

fn varies(found: &FamilyFit, name: &str) -> Option<bool> {
    found.dependences.iter().find(|of| of.name == name).map(|of| of.varies)
}

/// Returns the number of intervals of a fit over the setting that contain the true value, and the number of all its
/// intervals.
fn held(found: &FamilyFit, truth: &Definition) -> (usize, usize) {
    let (mut held, mut all) = (0, 0);
    for of in found.estimates.iter().filter(|of| of.estimate.standing == Standing::Identified) {
        let at: Params = truth.params_at(of.setting.unwrap_or(0.0));
        let (Some(low), Some(high)) = (of.estimate.low, of.estimate.high) else { continue };
        let value = match of.estimate.index {
            None => at.number(Number::find(of.estimate.name).unwrap()),
            Some(point) if of.estimate.name == "fv_force" => {
                let velocity = found.damper.params.list(list!("fv_velocity"))[point];
                Model::new(&at).unwrap().elements().paths.fv_curve.evaluate(velocity).value
            }
            Some(_) => continue,
        };
        all += 1;
        held += usize::from((low..=high).contains(&value));
    }
    (held, all)
}

/// Returns the largest difference between the forces of two dampers over the tests of [`matrix`], relative to the
/// largest force of `a`.
fn apart(a: &Params, b: &Params) -> f64 {
    let forces = |params: &Params| -> Vec<f64> {
        kernel_campaign::campaign(params, &matrix(), 1, 0.0).iter().flat_map(|r| r.force.clone()).collect()
    };
    let (a, b) = (forces(a), forces(b));
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0f64, |most, value| most.max(value.abs()));
    let top = most(&mut a.iter().copied());
    most(&mut a.iter().zip(&b).map(|(a, b)| a - b)) / top
}

#[test]
fn a_curve_that_depends_on_the_current_is_told_from_what_all_currents_share() {
    let truth = truth(None);
    let found = fitted(&truth, 11);
    assert_eq!(varies(&found, "fv_force"), Some(true), "{:?}", found.dependences);
    for shared in ["gas_force", "spring_linear", "coulomb_force", "series_stiffness"] {
        assert_eq!(varies(&found, shared), Some(false), "{shared}: {:?}", found.dependences);
        let own: Vec<_> = found.estimates.iter().filter(|of| of.estimate.name == shared).collect();
        assert!(own.len() == 1 && own[0].setting.is_none(), "{shared}: {own:?}");
    }
    assert_eq!(found.damper.axis.numbers().len(), 0);
    assert_eq!(found.damper.axis.name(), "current");
    let (held, all) = held(&found, &truth);
    assert!(all > 40 && 10 * held >= 9 * all, "{held} of {all} intervals hold the truth");
    // The comparison is at a setting without records.
    let apart = apart(&truth.params_at(BETWEEN), &found.damper.params_at(BETWEEN));
    assert!(apart < 0.03, "{apart}");
    for of in &found.settings {
        assert!(of.family.error_percent < 1.5, "{of:?}");
        // The limit for a left-out setting is larger, because the knee moves too far between its neighbors for an
        // accurate cubic interpolation.
        assert!(of.left_out.is_none_or(|error| error.error_percent < 2.0), "{of:?}");
    }
    let ends: Vec<bool> = found.settings.iter().map(|of| of.left_out.is_some()).collect();
    assert_eq!(ends, [false, true, true, false]);
}

/// Value of `fv_interpolation` for straight lines between the points.
const LINEAR: f64 = 1.0;

/// Makes a damper with a sharp knee whose velocity grows with the current.
fn with_sharp_knees() -> Definition {
    let mut params = kernel_campaign::base();
    let knee = |current: f64| 0.06 + 0.15 * current;
    let mut speeds: Vec<f64> = CURRENTS.iter().map(|current| knee(*current)).collect();
    speeds.push(1.2);
    let velocities: Vec<f64> = speeds.iter().rev().map(|v| -v).chain([0.0]).chain(speeds.iter().copied()).collect();
    params.set_list(list!("fv_velocity"), &velocities).unwrap();
    params.set(number!("fv_interpolation"), LINEAR).unwrap();
    let mut axis = Axis::NONE;
    axis.set_grid(&CURRENTS).unwrap();
    for (index, current) in CURRENTS.iter().enumerate() {
        let force = |v: f64| {
            let below = v.abs().min(knee(*current));
            v.signum() * (1.0 + current) * (2600.0 * below + 250.0 * (v.abs() - below))
        };
        let forces: Vec<f64> = velocities.iter().map(|v| if *v == 0.0 { 0.0 } else { force(*v) }).collect();
        axis.set_forces(index, &forces).unwrap();
    }
    axis.put(&mut params, 0.0);
    Definition { params, axis }
}

#[test]
fn a_knee_that_moves_with_the_current_is_as_sharp_as_in_a_fit_of_one_current() {
    let found = fitted_with(&elements_of_truth(), &with_sharp_knees(), 51);
    for of in &found.settings {
        let (family, alone) = (of.family.mean_error_n, of.own_fit.mean_error_n);
        assert!(family < 1.2 * alone, "{} A: {family} N, alone {alone} N", of.setting);
    }
}

#[test]
fn friction_that_grows_with_the_current_is_found_to() {
    let found = with_growing_friction();
    assert_eq!(varies(found, "coulomb_force"), Some(true), "{:?}", found.dependences);
    assert_eq!(varies(found, "gas_force"), Some(false), "{:?}", found.dependences);
    for (current, friction) in CURRENTS.iter().zip(GROWING) {
        let own = found
            .estimates
            .iter()
            .find(|of| of.estimate.name == "coulomb_force" && of.setting == Some(*current))
            .unwrap_or_else(|| panic!("{:?}", found.estimates));
        assert!((own.estimate.value - friction).abs() < 10.0, "{own:?}");
    }
}

#[test]
fn a_test_with_the_label_of_another_setting_is_named() {
    let said = |found: &FamilyFit| -> Vec<String> {
        found.notes.iter().map(ToString::to_string).filter(|note| note.contains("Check its label")).collect()
    };
    assert_eq!(said(with_growing_friction()), [""; 0]);
    let damper = truth(None);
    let mut records: Vec<Record> = [0.0, 0.8].iter().flat_map(|current| records_at(&damper, *current, 51)).collect();
    let is_fast = |record: &&mut Record| record.peak_velocity > 0.3;
    let wrong = records.iter_mut().rfind(is_fast).unwrap();
    wrong.setting.as_mut().unwrap().value = 0.0;
    let of_hard = wrong.name.clone();
    // A wrong current that no other test states becomes a separate setting, which the fit determines from this test
    // alone.
    let slipped = records.iter_mut().find(is_fast).unwrap();
    slipped.setting.as_mut().unwrap().value = 4.0;
    let of_soft = slipped.name.clone();
    let found = fit_family(&records.iter().collect::<Vec<_>>(), "current", &FitOptions::default(), |_| ()).unwrap();
    let notes = said(&found);
    assert_eq!(notes.len(), 2, "{notes:?}");
    assert!(notes[0].starts_with(&format!("{of_hard} states current 0 A")), "{notes:?}");
    assert!(notes[0].contains("those of 0.8 A"), "{notes:?}");
    assert!(notes[1].starts_with(&format!("{of_soft} states current 4 A")), "{notes:?}");
    assert!(notes[1].contains("those of 0 A, and not"), "{notes:?}");
    assert!(!found.label_doubts.is_empty() && with_growing_friction().label_doubts.is_empty());
}

#[test]
fn the_model_file_reads_back_as_the_fitted_family() {
    let found = with_growing_friction();
    let text = dashpot_identification::family::model_file::write(found);
    let file = dashpot_identification::model_file::family_of_text(&text, "family.toml".as_ref()).unwrap();
    for setting in [0.0, 0.5, 1.2] {
        assert!(apart(&file.definition().params_at(setting), &found.damper.params_at(setting)) == 0.0, "{setting}");
    }
    assert!(!file.was_changed());
    let over = &file.identification.intervals_over_setting;
    assert!(over.contains_key("fv_force") && over.contains_key("coulomb_force"), "{text}");
    assert!(file.identification.intervals.contains_key("gas_force"), "{text}");
    // A value edited outside of its interval counts as changed.
    let mut axis = file.axis;
    axis.set_values(number!("coulomb_force"), &[20.0, 60.0, 110.0, 500.0]).unwrap();
    let changed = ModelFile::new(file.params, axis, file.identification.clone(), file.specified.clone());
    assert!(changed.was_changed() && changed.edited.contains(&"coulomb_force@1.2".to_owned()), "{:?}", changed.edited);
    // The file contains the fit of the FV curve alone at each setting. Between the settings, this curve is
    // interpolated.
    let curve = |setting: f64| at_setting(&file, setting).identification.fv_only.unwrap();
    let (soft, middle, hard) = (curve(0.4), curve(0.6), curve(0.8));
    let top = |curve: &FvOnly| *curve.force.last().unwrap();
    assert!(top(&soft) < top(&middle) && top(&middle) < top(&hard));
}

/// Reads records from a folder of data next to the project. Returns `None` if this machine does not have the folder.
fn measured(folder: &str) -> Option<Vec<Record>> {
    let path = dashpot_tests::measured::records(folder)?;
    let options = Options { subfolders: true, ..Options::default() };
    Some(load(&[path], &options, &|_| ()).unwrap().records)
}

#[test]
fn a_current_in_a_channel_and_in_names_make_the_same_family() {
    let fits = ["current_column", "currents_in_names"].map(|folder| {
        let records = measured(&format!("reports/{folder}"))?;
        Some(fit_family(&records.iter().collect::<Vec<_>>(), "current", &FitOptions::default(), |_| ()).unwrap())
    });
    let [Some(column), Some(names)] = fits else { return };
    assert_eq!(column.settings_grid(), [0.0, 0.4, 0.8, 1.2, 1.6]);
    assert_eq!(column.damper.axis.numbers().len(), 0, "{:?}", column.dependences);
    for of in &column.settings {
        assert!(of.family.error_percent < 0.5 && of.left_out_ratio.is_none_or(|ratio| ratio < 1.3), "{of:?}");
    }
    assert!(apart(&column.damper.params_at(1.0), &names.damper.params_at(1.0)) < 1e-9);
}

#[test]
fn a_measured_magneto_rheological_damper_is_followed_at_all_currents() {
    let Some(records) = measured("mr_mts_utfsm") else { return };
    let found = fit_family(&records.iter().collect::<Vec<_>>(), "current", &FitOptions::default(), |_| ()).unwrap();
    assert_eq!(varies(&found, "fv_force"), Some(true));
    assert_eq!(varies(&found, "gas_force"), Some(false), "{:?}", found.dependences);
    for of in &found.settings {
        // The limits are the errors stated in the book, with a margin for changes of the search. The ratio of the
        // left-out error to the error of the setting's own fit has no limit, because a better own fit increases this
        // ratio.
        assert!(of.family.mean_error_n < 1.25 * of.own_fit.mean_error_n, "{of:?}");
        assert!(of.left_out.is_none_or(|error| error.error_percent < 12.0), "{of:?}");
    }
}

/// Returns sine tests at four currents, and two tests with steps of the current.
fn sines_and_steps(seed: u64) -> Vec<SemiActiveTest> {
    let mut tests = sines(&[0.0, 0.5, 1.0, 1.6]);
    tests.extend(steps(seed).into_iter().take(2));
    tests
}

#[test]
fn the_valve_of_a_physical_damper_is_identified_from_steps_of_its_current() {
    let seed = 3;
    let plant = SemiActivePlant::new(seed);
    let mut tests = sines_and_steps(seed);
    tests.push(random(&format!("{LEFT_OUT}random"), seed, plant.most, true));
    let found = evaluate_tests(&plant, &tests, seed).unwrap();
    assert!(found.random_error < RANDOM, "{found:?}");
    let near = found.valve.iter().filter(|lag| lag.error().abs() < LAG).count();
    assert!(near + 1 >= found.valve.len() && found.worst_lag() < WORST_LAG, "{found:?}");
    assert!(found.actuator.contains("setting_time_up") && found.actuator.contains("dead_time"), "{found:?}");
}

#[test]
fn a_damper_without_an_actuator_gets_none() {
    let truth = truth(None);
    let mut records: Vec<Record> =
        CURRENTS.iter().enumerate().flat_map(|(k, current)| records_at(&truth, *current, 11 + k as u64)).collect();
    records.push(stepped(&truth));
    let found = fit_family(&records.iter().collect::<Vec<_>>(), "current", &elements_of_truth(), |_| ()).unwrap();
    let actuator = found.actuator.as_ref().unwrap();
    assert!(actuator.estimates.is_empty() && actuator.parts.iter().all(|part| !part.is_present), "{actuator:?}");
    assert!(!found.damper.axis.actuator().has_lag() && found.damper.axis.actuator().dead_time == 0.0);
    assert!(found.tests.contains(&"stepped".to_owned()));
    assert!(found.notes.iter().any(|note| note.to_string().contains("no actuator")), "{:?}", found.notes);
}

/// Checks the identification of the hysteresis position in tests at constant current. A rig mostly reaches each current
/// from zero, and the valve is then at one end of its hysteresis.
#[test]
fn the_place_in_the_hysteresis_is_found_from_steps() {
    let mut valve = truth(None);
    let numbers = [
        ("setting_time_up", 0.03),
        ("setting_time_down", 0.018),
        ("setting_hysteresis", 0.05),
        ("setting_hysteresis_rest", 1.0),
    ];
    for (name, value) in numbers {
        let index = ENTRIES.iter().position(|entry| entry.name == name).unwrap();
        valve.axis.set_number(index, value).unwrap();
    }
    let at = |(k, current): (usize, &f64)| records_at(&truth(None), *current, 61 + k as u64);
    let mut records: Vec<Record> = CURRENTS.iter().enumerate().flat_map(at).collect();
    records.push(stepped(&valve));
    let found = fit_family(&records.iter().collect::<Vec<_>>(), "current", &elements_of_truth(), |_| ()).unwrap();
    let estimates = &found.actuator.as_ref().unwrap().estimates;
    let rest =
        estimates.iter().find(|of| of.name == "setting_hysteresis_rest").unwrap_or_else(|| panic!("{estimates:?}"));
    assert!(rest.value > 0.7 && rest.high.is_none_or(|high| high <= 1.0), "{rest:?}");
    assert_eq!(found.damper.axis.actuator().rest, rest.value);
}

/// Checks that one test with steps of the current identifies the lags of rise and fall and the dead time. This must
/// hold although one common lag for both directions fits worse than no lag. Without a fall of the current, the lag of a
/// fall is reported as not identified.
#[test]
fn one_test_with_steps_shows_both_lags_of_a_valve_and_one_without_falls_says_so() {
    let mut valve = truth(None);
    for (name, value) in [("setting_time_up", 0.03), ("setting_time_down", 0.018), ("setting_dead_time", 0.004)] {
        let index = ENTRIES.iter().position(|entry| entry.name == name).unwrap();
        valve.axis.set_number(index, value).unwrap();
    }
    let mut records: Vec<Record> = CURRENTS
        .iter()
        .enumerate()
        .flat_map(|(k, current)| records_at(&truth(None), *current, 11 + k as u64))
        .collect();
    let found_with = |records: &[Record]| {
        let found = fit_family(&records.iter().collect::<Vec<_>>(), "current", &elements_of_truth(), |_| ()).unwrap();
        found.actuator.unwrap().estimates
    };
    let whole = stepped(&valve);
    records.push(whole.clone());
    let found = found_with(&records);
    for (name, value) in [("setting_time_up", 0.03), ("setting_time_down", 0.018), ("setting_dead_time", 0.004)] {
        let of = found.iter().find(|of| of.name == name).unwrap_or_else(|| panic!("{name}: {found:?}"));
        // The tolerance is 10 % instead of the interval. The interval covers the noise and the uncertain time of the
        // command within a sample, but not the model error at intermediate currents.
        assert!((of.value - value).abs() < 0.1 * value && of.standing == Standing::Identified, "{of:?}");
    }
    // This record ends at the first fall of the current.
    let rise = 950;
    let signal = whole.setting_signal.as_ref().unwrap();
    *records.last_mut().unwrap() = Record {
        time: whole.time[..rise].to_vec(),
        displacement: whole.displacement[..rise].to_vec(),
        velocity: whole.velocity[..rise].to_vec(),
        force: whole.force[..rise].to_vec(),
        setting_signal: Some(signal.select(0..rise)),
        ..whole
    };
    let found = found_with(&records);
    let of = |name: &str| found.iter().find(|of| of.name == name).unwrap_or_else(|| panic!("{name}: {found:?}"));
    assert!(of("setting_time_down").standing == Standing::NotIdentified, "{found:?}");
    assert!((of("setting_time_up").value / 0.03 - 1.0).abs() < 0.2, "{found:?}");
}

/// Checks that a family that lacks elements of the damper does not exclude the lag of its valve. On a grid of two settings, a note states
/// the assumption on which the estimated times depend.
#[test]
fn a_poor_family_does_not_exclude_the_lag_of_its_valve() {
    let mut valve = truth(None);
    let times = [("setting_time_up", 8e-3), ("setting_time_down", 12e-3), ("setting_dead_time", 3e-3)];
    for (name, value) in times {
        let index = ENTRIES.iter().position(|entry| entry.name == name).unwrap();
        valve.axis.set_number(index, value).unwrap();
    }
    let elements = ["fv_curve", "coulomb_friction", "gas_preload"].map(str::to_owned).to_vec();
    let options = FitOptions { elements: Some(elements), ..FitOptions::default() };
    let steps = stepped(&valve);
    let fitted_at = |currents: &[f64]| {
        let constant =
            currents.iter().enumerate().flat_map(|(k, current)| records_at(&truth(None), *current, 21 + k as u64));
        let records: Vec<Record> = constant.chain([steps.clone()]).collect();
        fit_family(&records.iter().collect::<Vec<_>>(), "current", &options, |_| ()).unwrap()
    };
    let found = fitted_at(&CURRENTS);
    let actuator = found.actuator.as_ref().unwrap();
    let lag = actuator.parts.iter().find(|part| part.name == "lag").unwrap();
    assert!(lag.is_present && lag.probability > 0.9, "{actuator:?}");
    for (name, value) in times {
        if let Some(Estimate { low: Some(low), high: Some(high), .. }) =
            actuator.estimates.iter().find(|of| of.name == name)
        {
            assert!((*low..=*high).contains(&value), "{actuator:?}");
        }
    }
    let assumes =
        |found: &FamilyFit| found.notes.iter().any(|note| note.to_string().contains("assume that the force is linear"));
    assert!(!assumes(&found) && assumes(&fitted_at(&[0.0, 1.2])), "{:?}", found.notes);
}

/// Simulates a sine test during which the current steps between 0 and 1.2 A every 0.5 s.
fn stepped(damper: &Definition) -> Record {
    let family = prepared_family(damper).unwrap();
    let (rate, count, w) = (1000.0, 6000, TAU * 0.7);
    let mut current = Vec::new();
    let mut record = Record {
        name: "stepped".into(),
        amplitude: 0.03,
        peak_velocity: 0.03 * w,
        noise: Noise { force_rms: 4.0, ..Default::default() },
        ..Record::default()
    };
    let input = |t: f64| Input::motion(0.03 * (w * t).sin(), 0.03 * w * (w * t).cos());
    let mut random = kernel_campaign::Random::new(4);
    let (mut state, mut delay) = (family.steady_state(&input(0.0), Some(0.0)), family.steady_delay(Some(0.0)));
    let mut output = family.evaluate(&state, &input(0.0), Some(0.0)).0;
    let commanded = |i: i32| if (i / 500) % 2 == 0 { 0.0 } else { 1.2 };
    for i in 0..count {
        let (t, command) = (f64::from(i) / rate, commanded(i));
        // The command of the current changes in the middle of a sample interval, and the valve is integrated in tenths
        // of this interval.
        for part in 1..=10 {
            let (dt, since) = (0.1 / rate, f64::from(part - 10) * 0.1 / rate);
            let command = Some(commanded(if part > 5 { i } else { i - 1 }));
            let done = i == 0
                || family.step_in_place(&mut state, &mut delay, &input(t + since), command, dt, &mut output, false);
            assert!(done);
        }
        record.time.push(t);
        record.displacement.push(0.03 * (w * t).sin());
        record.velocity.push(0.03 * w * (w * t).cos());
        record.force.push(output.force + 4.0 * random.normal());
        current.push(command);
    }
    record.setting_signal = Some(SettingSignal::new("current", "A", &current));
    record
}

/// Model file of a damper that depends on a pilot pressure, bar. The time constant of its valve is 12 ms for rising and
/// 20 ms for falling pressure.
const PILOTED: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\", \"coulomb_friction\"]\nsetting = [2.0, 10.0]\n\
     setting_name = \"pressure\"\nsetting_unit = \"bar\"\nsetting_time_up = 0.012\nsetting_time_down = 0.020\ngas_force = 150.0\n\
     coulomb_force = 25.0\nfv_velocity = [-1.0, -0.3, -0.1, 0.0, 0.1, 0.3, 1.0]\n\
     fv_force = [[-700.0, -300.0, -150.0, 0.0, 250.0, 500.0, 1100.0], [-1700.0, -900.0, -500.0, 0.0, 900.0, 1700.0, 3000.0]]\n";

/// Simulates a sine test with pairs of start time, s, and commanded pressure, bar, and writes a record. The record has
/// a pressure column if the pressure changes.
///
/// The valve receives a command in the step that ends at the time of the command. The column contains the command
/// already `late` seconds before that time.
fn measure_piloted(
    dir: &Path,
    name: &str,
    (amplitude, frequency, step): (f64, f64, f64),
    commands: &[(f64, f64)],
    late: f64,
) {
    let count = (4.0 / frequency / step) as usize;
    let rows = (0..=count).map(|k| k as f64 * step).map(|t| {
        let phase = TAU * frequency * t;
        format!("{t},{},{}\n", amplitude * phase.sin(), amplitude * TAU * frequency * phase.cos())
    });
    std::fs::write(dir.join("m.csv"), format!("time_s,displacement_m,velocity_m_s\n{}", rows.collect::<String>()))
        .unwrap();
    let setting: Vec<String> = commands.iter().map(|(time, value)| format!("{time}:{value}")).collect();
    done(dir, &["simulate", "piloted.toml", "m.csv", "--setting", &setting.join(","), "-o", "f.csv"]);
    let text = std::fs::read_to_string(dir.join("f.csv")).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place = |name: &str| header.iter().position(|h| *h == name).unwrap();
    let wanted = ["time_s", "displacement_m", "velocity_m_s", "force_N"].map(place);
    let has_column = commands.len() > 1;
    let mut out =
        format!("time_s,displacement_m,velocity_m_s,force_N{}\n", if has_column { ",p pilot [bar]" } else { "" });
    for (k, line) in lines.enumerate() {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        let [time, x, v, force] = wanted.map(|place| cells[place]);
        // The noise is deterministic, up to 3 N.
        let noise = 6.0 * (((k * 7919) % 1000) as f64 / 1000.0 - 0.5);
        out += &format!("{time},{x},{v},{}", force + noise);
        if has_column {
            let now = commands
                .iter()
                .rev()
                .find(|(from, _)| *from <= time + late + 1e-9)
                .map_or(commands[0].1, |(_, value)| *value);
            out += &format!(",{now}");
        }
        out += "\n";
    }
    std::fs::write(dir.join("records").join(format!("{name}.csv")), out).unwrap();
}

#[test]
fn a_pressure_that_changes_within_a_test_is_fitted_and_validated_where_its_column_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    std::fs::write(dir.join("piloted.toml"), PILOTED).unwrap();
    std::fs::create_dir(dir.join("records")).unwrap();
    for (name, amplitude, frequency) in [("slow", 0.02, 0.04), ("middle", 0.02, 1.0), ("fast", 0.02, 4.0)] {
        for pressure in [2.0, 10.0] {
            let motion = (amplitude, frequency, 1.0 / (200.0 * frequency));
            measure_piloted(dir, &format!("{name}_{pressure}bar"), motion, &[(0.0, pressure)], 0.0);
        }
    }
    let steps: Vec<(f64, f64)> = (0..20).map(|k| (0.21 * f64::from(k), if k % 2 == 0 { 2.0 } else { 10.0 })).collect();
    measure_piloted(dir, "steps", (0.03, 1.0, 1e-3), &steps, 0.0);
    // Without a valid pressure column, the test has no pressure. A message reports a misspelled name of the column.
    let fit = ["fit", "records", "--setting", "pressure", "-o", "family.toml", "--json", "fit.json"];
    let told = refused(dir, &fit);
    assert!(told.contains("no pressure is stated by steps") && told.contains("--column setting=HEADING"), "{told}");
    let told = refused(dir, &[&fit[..], &["--column", "setting=p pilo"]].concat());
    assert!(told.contains("no test has a column 'p pilo' for the setting"), "{told}");
    let told = done(dir, &[&fit[..], &["--column", "setting=p pilot"]].concat());
    assert!(told.contains("actuator from 1 test ("), "{told}");
    let found = json(&dir.join("fit.json"));
    let is_in_interval = |found: &serde_json::Value| {
        let all = found["actuator"]["estimates"].as_array().unwrap();
        for (name, truth) in [("setting_time_up", 0.012), ("setting_time_down", 0.020)] {
            let of = all.iter().find(|e| e["name"] == name).unwrap_or_else(|| panic!("{name}: {found}"));
            let [value, low, high] = ["value", "low", "high"].map(|key| of[key].as_f64().unwrap());
            assert!((value - truth).abs() < 1e-3 && low < truth && truth < high, "{name}: {of}");
        }
    };
    is_in_interval(&found);
    done(dir, &["validate", "family.toml", "records", "--column", "setting=p pilot", "--json", "errors.json"]);
    let errors = json(&dir.join("errors.json"));
    let responses = errors["step_responses"].as_array().unwrap();
    assert!(responses.len() == 2 && responses.iter().all(|of| of["measured"]["t63_s"].is_number()), "{errors}");
    // A logger that records the command one sample earlier gives valve parameters within the intervals, too.
    measure_piloted(dir, "steps", (0.03, 1.0, 1e-3), &steps, 1e-3);
    done(dir, &[&fit[..], &["--column", "setting=p pilot"]].concat());
    is_in_interval(&json(&dir.join("fit.json")));
}

#[test]
#[ignore = "most of a minute, for the night; the same valve at 1 kHz is identified in every run"]
fn the_valve_of_a_physical_damper_is_known_to_half_a_sample_of_a_slow_logger() {
    let seed = 3;
    let plant = SemiActivePlant::new(seed);
    let tests = sines_and_steps(seed);
    let fitted = |rate: f64| {
        let protocol = Protocol { noise_percent: 1.0, sample_rate_hz: rate, ..Protocol::default() };
        let records = measure(&plant, &tests, &protocol, seed).unwrap();
        fit_family(&records.iter().collect::<Vec<_>>(), "current", &FitOptions::default(), |_| ()).unwrap()
    };
    let (fast, slow) = (fitted(1000.0).actuator.unwrap(), fitted(250.0).actuator.unwrap());
    // The test compares the times of rise and fall to 63 %. They are dead time plus time constant, whose estimates are
    // correlated.
    let sum = |of: &ActuatorFit, name: &str| {
        let value = |name: &str| of.estimates.iter().find(|e| e.name == name).map_or(0.0, |e| e.value);
        value(name) + value("setting_dead_time")
    };
    for name in ["setting_time_up", "setting_time_down"] {
        let half_sample = 0.5 / 250.0;
        let (a, b) = (sum(&fast, name), sum(&slow, name));
        assert!((a - b).abs() < half_sample, "{name}: {a} {b} {fast:?} {slow:?}");
    }
}
