//! Tests of `dashpot check` and of the exports' remarks on chatter: messages, figures, and the damper adapted to a
//! host's step.

use dashpot_tests::cli::{done, json, number, refused, run};
use std::path::Path;

/// Model file of a damper whose friction force reaches its full value at about 1 mm/s.
const STEEP: &str = "format = 1\nelements = [\"fv_curve\", \"coulomb_friction\"]\nfv_velocity = [-1.0, 0.0, 1.0]\n\
     fv_force = [-900.0, 0.0, 1500.0]\ncoulomb_force = 40.0\ncoulomb_steepness = 5000.0\n";

fn steep() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("steep.toml"), STEEP).unwrap();
    folder
}

fn checked(dir: &Path, more: &[&str]) -> serde_json::Value {
    done(dir, &[&["check", "steep.toml", "--json", "c.json"], more].concat());
    json(&dir.join("c.json"))
}

#[test]
fn steep_friction_is_named_and_its_gain_is_that_of_the_formula() {
    let folder = steep();
    let found = checked(folder.path(), &["--host-step", "0.001", "--wheel-mass", "40"]);
    // The gain is c h/m, with the host step h, s, and the wheel mass m, kg. The damping c, N s/m, is the derivative of
    // friction and FV curve with respect to velocity at standstill.
    let slope = 40.0 * 5000.0 + 0.5 * (900.0 + 1500.0);
    assert!((number(&found, "gain") / (slope * 1e-3 / 40.0) - 1.0).abs() < 0.05, "{found}");
    assert!(found["element"] == "coulomb_friction" && found["chatters"] == true && found["swings"] == true, "{found}");
    // The damper does not chatter at half of the reported step, and chatters at twice this step.
    let quiet = number(&found, "quiet_step_s");
    for (times, chatters) in [(0.5, false), (2.0, true)] {
        let step = format!("{}", times * quiet);
        assert_eq!(checked(folder.path(), &["--host-step", &step])["chatters"], chatters, "{times}");
    }
    // With a wheel of 1000 kg, this friction does not chatter.
    assert_eq!(checked(folder.path(), &["--wheel-mass", "1000"])["chatters"], false);
}

#[test]
fn a_damper_made_ready_for_a_step_says_what_that_costs_and_every_verb_reads_it() {
    let folder = steep();
    let dir = folder.path();
    let told = done(dir, &["check", "steep.toml", "--for-step", "0.001", "-o", "ready.toml"]);
    assert!(
        told.contains("coulomb_friction was replaced") && told.contains("N rms") && told.contains("does not chatter"),
        "{told}"
    );
    let text = std::fs::read_to_string(dir.join("ready.toml")).unwrap();
    assert!(text.contains("presliding_friction") && text.contains("# coulomb_friction was replaced"), "{text}");
    let again = done(dir, &["check", "ready.toml"]);
    assert!(again.contains("does not chatter") && !again.contains("--for-step"), "{again}");
}

/// Checks that the exit code of `dashpot check --strict` reports chatter to scripts. With `--for-step`, the code refers
/// to the adapted damper.
#[test]
fn a_script_is_told_by_the_exit_code() {
    let folder = steep();
    let dir = folder.path();
    let code = |args: &[&str]| run(dir, &[&["check", "steep.toml"], args].concat()).code;
    assert_eq!(code(&[]), Some(0), "without the option it only tells");
    assert_eq!(code(&["--strict"]), Some(1));
    assert_eq!(code(&["--strict", "--json", "found.json"]), Some(1));
    assert_eq!(json(&dir.join("found.json"))["chatters"], true);
    assert_eq!(code(&["--strict", "--host-step", "0.00001"]), Some(0));
    assert_eq!(code(&["--strict", "--for-step", "0.001"]), Some(0));
    assert_eq!(code(&["--strict", "--host-step", "0"]), Some(2), "not judged is not passed");
}

#[test]
fn exports_say_it_too_and_take_the_same_option() {
    let folder = steep();
    let dir = folder.path();
    let told = done(dir, &["export", "adams", "steep.toml", "-o", "run"]);
    assert!(told.contains("coulomb_friction makes it") && told.contains("--for-step"), "{told}");
    assert_eq!(std::fs::read_to_string(dir.join("run/damper.toml")).unwrap(), STEEP);
    let told = done(dir, &["export", "adams", "steep.toml", "-o", "soft", "--for-step", "0.001"]);
    assert!(told.contains("was replaced"), "{told}");
    assert!(std::fs::read_to_string(dir.join("soft/damper.toml")).unwrap().contains("presliding_friction"));
    let readme = |folder: &str| std::fs::read_to_string(dir.join(folder).join("README.txt")).unwrap();
    assert!(readme("soft").starts_with("coulomb_friction was replaced"));
    // Adams adapts its steps and uses the derivatives of the force, so the remark on fixed host steps does not apply to
    // Adams. The README states this before the remark.
    let (text, below) = (readme("run"), "a run of Adams alone is not concerned");
    assert!(text.contains("A damper for Adams"), "{text}");
    let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(flat.find(below).unwrap() < flat.find("At a host step of 1 ms").unwrap(), "{text}");
}

#[test]
fn impossible_hosts_are_refused() {
    let folder = steep();
    let dir = folder.path();
    for (args, wanted) in [
        (["--host-step", "0"], "--host-step is in s"),
        (["--host-step", "5"], "--host-step is in s"),
        (["--wheel-mass", "0"], "--wheel-mass is in kg"),
        (["--for-step", "nan"], "such as 5ms"),
        (["--for-step", "0"], "--for-step is in s"),
    ] {
        let message = refused(dir, &[&["check", "steep.toml"][..], &args].concat());
        assert!(message.contains(wanted), "{message}");
    }
    assert!(refused(dir, &["check", "steep.toml", "-o", "x.toml"]).contains("--for-step"));
}

/// Checks that `dashpot check` treats an adjustable damper at each setting like an ordinary damper.
#[test]
fn a_family_is_checked_at_every_setting() {
    let folder = steep();
    let dir = folder.path();
    let family = STEEP.replace(
        "format = 1\n",
        "format = 1\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n",
    );
    let family = family.replace("coulomb_force = 40.0", "coulomb_force = [0.1, 40.0]");
    std::fs::write(dir.join("family.toml"), family).unwrap();
    let told = done(dir, &["check", "family.toml", "--json", "f.json"]);
    assert!(told.contains("over 2 settings, the largest at 1 A; it chatters at 1 of them"), "{told}");
    assert!(told.contains("current = 1 A: ") && !told.contains("current = 0 A: "), "{told}");
    let all = json(&dir.join("f.json"));
    assert_eq!((all[0]["setting"].as_f64(), all[0]["chatters"].as_bool()), (Some(0.0), Some(false)), "{all}");
    assert_eq!((all[1]["setting"].as_f64(), all[1]["chatters"].as_bool()), (Some(1.0), Some(true)), "{all}");
    done(dir, &["setting", "family.toml", "1", "-o", "one.toml"]);
    done(dir, &["check", "one.toml", "--json", "one.json"]);
    let one = json(&dir.join("one.json"));
    assert!(one.get("setting").is_none() && one["gain"] == all[1]["gain"], "{one}");
    assert_eq!(run(dir, &["check", "family.toml", "--strict"]).code, Some(1));
    let message = refused(dir, &["check", "family.toml", "--for-step", "0.001", "-o", "ready.toml"]);
    assert!(message.contains("dashpot setting"), "{message}");
}

/// Checks the note on a family, made by hand, that may do work on the host when its setting changes.
#[test]
fn a_family_that_may_supply_energy_is_named_with_the_number() {
    let folder = steep();
    let dir = folder.path();
    let over = "format = 1\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n";
    let passive = STEEP.replace("format = 1\n", over).replace("coulomb_force = 40.0", "coulomb_force = [20.0, 40.0]");
    let curve = passive.replace("[-900.0, 0.0, 1500.0]", "[[-900.0, 100.0, 1500.0], [-1500.0, 300.0, 2500.0]]");
    let contact = passive.replace("coulomb_friction\"", "coulomb_friction\", \"presliding_friction\"");
    let contact = format!("{contact}presliding_force = [38.0, 900.0]\n");
    for (name, text, number) in [
        ("passive", passive, None),
        ("curve", curve, Some("zero velocity, 100.0 N at 0 A to 300.0 N at 1 A")),
        ("contact", contact, Some("presliding_force 38.00 N at 0 A to 900.0 N at 1 A")),
    ] {
        let file = format!("{name}.toml");
        std::fs::write(dir.join(&file), text).unwrap();
        let told = done(dir, &["check", &file]);
        let note = told.lines().find(|line| line.starts_with("note: a change of current may do work"));
        assert_eq!(note.is_some(), number.is_some(), "{name}: {told}");
        let read = run(dir, &["setting", &file, "0.5", "-o", &format!("{name}_one.toml")]);
        assert_eq!(read.code, Some(0), "{}", read.err);
        for said in [note, number.map(|_| read.err.as_str())].into_iter().flatten() {
            assert!(number.is_some_and(|number| said.contains(number)), "{name}: {said}");
        }
        assert_eq!(read.err.contains("may do work"), number.is_some(), "{name}: {}", read.err);
        // The note appears only on standard output, so the reader of the model file must not repeat it on standard
        // error.
        assert!(!run(dir, &["check", &file]).err.contains("may do work"), "{name}");
    }
}
