//! Tests of the interface between the library for Adams and the solver: utility functions, units, partial derivatives,
//! flags of the call (iflag), coordinate frames, threads.

use dashpot_core::Input;
use dashpot_test_support::skipped;
use dashpot_tests::adams::{
    FULL, FULL_STATES, PLAIN, ROUTINES, Run, Surroundings, deviation, kernel, library, model_of, run, run_library,
    solver, solver_without, started, utilities, watched_for_races, with, written,
};
use dashpot_tests::library::{root, succeed};
use std::process::Command;

#[test]
fn exports_only_entry_names_and_they_hold_both_cases() {
    let listed = Command::new("nm").args(["-D", "--defined-only"]).arg(library()).output().unwrap();
    let text = String::from_utf8(listed.stdout).unwrap();
    let mut names: Vec<&str> = text.lines().filter_map(|l| l.split(' ').nth(2)).collect();
    names.sort_unstable();
    let entries = ["gfosub", "gse_deriv", "gse_output", "gse_samp", "gse_update", "reqsub", "sfosub"];
    let mut want: Vec<String> = entries.iter().map(|e| format!("Dashpot_{e}")).collect();
    want.push("dashpot_adams_selftest".into());
    assert_eq!(names, want);
}

#[test]
fn asks_for_no_recent_system() {
    let listed = Command::new("nm").args(["-D", "--undefined-only"]).arg(library()).output().unwrap();
    let text = String::from_utf8(listed.stdout).unwrap();
    for line in text.lines().filter(|l| l.contains("@GLIBC_2.")) {
        let minor: u32 = line.split("@GLIBC_2.").nth(1).unwrap().split('.').next().unwrap().parse().unwrap();
        assert!(minor <= 28, "{line}");
    }
}

#[test]
fn misuse_stops_the_run_with_a_message_that_helps() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), PLAIN);
    let bad = folder.path().join("bad.toml");
    std::fs::write(&bad, "format = 1\nelements = []\ngas_force = 1e9\n").unwrap();
    let wrong_file = format!("model={}", bad.display());
    let missing_file = "model=nowhere.toml";
    let all: &[(&[&str], &[&str])] = &[
        (&["string=0"], &["STRING/7", "model file"]),
        (&["par=7.5"], &["first USER value", "7.5", "STRING"]),
        (&["par=nan"], &["first USER value", "STRING"]),
        (&[missing_file], &["nowhere.toml", "cannot open"]),
        (&["model=mdids://acar_shared/dampers.tbl/a.toml"], &["mdids", "path"]),
        (&[&wrong_file], &["bad.toml, line 3", "gas_force"]),
        (&["npar=-1"], &["USER", "string"]),
        (&["npar=2"], &["USER", "string"]),
        (&["units=0"], &["UNITS"]),
        (&["told=0"], &["units"]),
    ];
    for routine in ROUTINES {
        for (settings, words) in all {
            let run = run(&solver, routine, &with(&path, settings));
            assert_eq!(run.code, Some(3), "{routine} {settings:?}: {}", run.text);
            for word in *words {
                assert!(run.text.contains(word), "{routine} {settings:?} says nothing of {word}: {}", run.text);
            }
        }
    }
    for (setting, word) in [("ns=1", "NS=2"), ("ns=5", "NS=2"), ("ni=1", "NI=1"), ("no=0", "NO=0"), ("no=10", "NO=10")]
    {
        let run = run(&solver, "gse", &with(&path, &[setting]));
        assert!(run.code == Some(3) && run.text.contains(word), "{setting}: {}", run.text);
    }
    let ends: &[(&str, &[&str], &[&str])] = &[
        ("sfo", &["type=ROTATIONAL"], &["TRANSLATIONAL", "ROTATIONAL"]),
        ("gfo", &["other=0"], &["first three USER values", "marker ids"]),
        ("gfo", &["other=12.5"], &["first three USER values", "marker ids"]),
        ("gfo", &["joint=-1"], &["first three USER values", "marker ids"]),
        ("gfo", &["other=99"], &["no motion between markers 11 and 99"]),
        ("sfo", &["kind=3", "end=0.001"], &["USER(kind, element", "1 for an SFORCE"]),
        ("sfo", &["page=3", "end=0.001"], &["page is 1 or 2"]),
        ("sfo", &["save=2", "mass=1", "end=0.01"], &["saved state", "another version"]),
        ("sfo", &["amplitude=nan"], &["force", "NaN"]),
        ("gse", &["amplitude=nan"], &["NaN"]),
        ("gfo", &["amplitude=nan"], &["direction"]),
    ];
    for (routine, settings, words) in ends {
        let run = run(&solver, routine, &with(&path, settings));
        assert_eq!(run.code, Some(3), "{routine} {settings:?}: {}", run.text);
        for word in *words {
            assert!(run.text.contains(word), "{routine} {settings:?} says nothing of {word}: {}", run.text);
        }
    }
    for iflag in ["iflag=2", "iflag=4", "iflag=11", "iflag=99"] {
        for routine in ROUTINES {
            let run = run(&solver, routine, &with(&path, &[iflag]));
            assert!(run.code == Some(0) && run.text.contains("force 0\n"), "{routine} {iflag}: {}", run.text);
        }
    }
}

#[test]
fn the_sources_are_cpp_too() {
    let folder = tempfile::tempdir().unwrap();
    let sources = dashpot_tests::library::root().join("adams-usersub/src");
    for source in std::fs::read_dir(&sources).unwrap().map(|e| e.unwrap().path()) {
        if source.extension().is_some_and(|e| e == "c") {
            let mut compiler = Command::new(std::env::var_os("CXX").unwrap_or("g++".into()));
            compiler.args(["-x", "c++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-c", "-I"]);
            compiler.arg(dashpot_tests::library::root().join("include")).arg(&source);
            dashpot_tests::library::succeed(compiler.arg("-o").arg(folder.path().join("x.o")));
        }
    }
}

/// Lists the solver's utility functions that a user subroutine of the library requires; all others are optional.
fn needed(routine: &str) -> &'static [&'static str] {
    match routine {
        "gse" => {
            &["c_errmes", "c_gtstrg", "c_gtunts", "c_getmod", "c_gse_ns", "c_gse_ni", "c_gse_no", "c_gse_x", "c_gse_u"]
        }
        "gfo" => &["c_errmes", "c_gtstrg", "c_gtunts", "c_sysary", "c_timget", "c_getmod"],
        _ => &["c_errmes", "c_gtstrg", "c_gtunts", "c_sysfnc", "c_timget", "c_getmod"],
    }
}

#[test]
fn a_missing_utility_is_named_and_one_that_is_not_needed_is_not_missed() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), PLAIN);
    let all = utilities();
    assert_eq!(all.len(), 22, "{all:?}");
    for utility in &all {
        let lacking = solver_without(utility);
        for routine in ROUTINES {
            // Without the utility c_errmes, the library cannot stop the run. In this case, the solver makes one call,
            // and the message goes to standard error.
            let (silent, save) = (utility == "c_errmes", utility.contains("serialize") && routine != "gse");
            let what = if silent {
                "iflag=0"
            } else if save {
                "save=1"
            } else {
                "save=0"
            };
            let run = run(&lacking, routine, &with(&path, &["mass=1", "end=0.001", what]));
            if needed(routine).contains(&utility.as_str()) || save {
                assert!(run.text.contains(&format!("no function {utility}")), "{routine} {utility}: {}", run.text);
                assert_eq!(run.code, Some(if silent { 0 } else { 3 }), "{routine} {utility}: {}", run.text);
            } else {
                assert_eq!(run.code, Some(0), "{routine} does without {utility}: {}", run.text);
                assert!(run.accepted().len() > 3);
            }
        }
    }
}

/// C program that loads the library without a solver and calls all user subroutines.
const OUTSIDE: &str = r#"
#define _GNU_SOURCE
#include "../adams-usersub/src/entry.h"
#include <dlfcn.h>
#include <stdio.h>
#define GET(type, name) type = (void *)dlsym(library, #name)
int main(int count, char **words)
{
    void *library = dlopen(words[1], RTLD_NOW);
    static double par[6] = {7, 400, 20, 1e-3, 1, 1}, r[8];
    adams_sforce s = {1, 2, par, 11, 12, 0, "TRANSLATIONAL"};
    adams_gforce g = {2, 5, par, 11, 14, 13};
    adams_request q = {3, 2, par, "", {0}};
    adams_gse e = {4, 1, par, 2, 1, 0, 0, 2, 0, 0, 0, 0};
    if (!library || count != 2)
        return 9;
    GET(int (*selftest)(void), dashpot_adams_selftest);
    GET(void (*sfo)(const adams_sforce *, double, int, int, double *), Dashpot_sfosub);
    GET(void (*gfo)(const adams_gforce *, double, int, int, double *), Dashpot_gfosub);
    GET(void (*req)(const adams_request *, double, int, double *), Dashpot_reqsub);
    GET(void (*deriv)(const adams_gse *, double, int, int, int, double *), Dashpot_gse_deriv);
    GET(void (*output)(const adams_gse *, double, int, int, int, double *), Dashpot_gse_output);
    GET(void (*update)(const adams_gse *, double, int, int, int, double *), Dashpot_gse_update);
    GET(void (*samp)(const adams_gse *, double, int, double *), Dashpot_gse_samp);
    printf("selftest %d\n", selftest());
    for (int iflag = 0; iflag < 12; iflag++) {
        sfo(&s, 0, 0, iflag, r);
        gfo(&g, 0, 0, iflag, r);
        req(&q, 0, iflag, r);
        deriv(&e, 0, 0, iflag, 2, r);
        output(&e, 0, 0, iflag, 1, r);
        update(&e, 0, 0, iflag, 0, r);
        samp(&e, 0, iflag, r + 1);
    }
    printf("force %g, sample %d\n", r[0], r[1] > 1e6);
    return 0;
}
"#;

#[test]
fn outside_adams_it_loads_and_answers_its_selftest() {
    let folder = tempfile::tempdir().unwrap();
    let (source, program) = (folder.path().join("outside.c"), folder.path().join("outside"));
    std::fs::write(&source, OUTSIDE).unwrap();
    let mut c = Command::new(std::env::var_os("CC").unwrap_or("gcc".into()));
    c.args(["-std=gnu99", "-I"]).arg(root().join("tests")).arg(&source).arg("-o").arg(&program).arg("-ldl");
    succeed(&mut c);
    let ran = Command::new(&program).arg(library()).output().unwrap();
    assert!(ran.status.success(), "{ran:?}");
    assert_eq!(String::from_utf8(ran.stdout).unwrap(), "selftest 0\nforce 0, sample 1\n");
    let words = String::from_utf8(ran.stderr).unwrap();
    for name in ["c_sysary", "c_sysfnc", "c_errmes"] {
        assert!(words.contains(&format!("no function {name}")), "{words}");
    }
}

/// Checks that the library finds the utility functions of a solver that loads them locally, like an extension of an
/// interpreter.
///
/// The process contains the utility functions, but the global scope of symbols does not.
#[test]
fn utilities_loaded_for_another_library_alone_are_found() {
    const UTILITIES: &str = "#include <stdio.h>\nvoid c_errmes(int e, const char *t, int id, const char *s) { (void)id; printf(\"%d %s %s\\n\", e, s, t); }\n";
    const HOST: &str = r#"
#include "../adams-usersub/src/solver.h"
#include <dlfcn.h>
#include <stddef.h>
int main(int count, char **words)
{
    void *utilities = dlopen(words[2], RTLD_NOW | RTLD_LOCAL), *library = dlopen(words[1], RTLD_NOW | RTLD_LOCAL);
    static double par[2] = {7, 400}, r[8];
    adams_sforce s = {1, 2, par, 11, 12, 0, "TRANSLATIONAL"};
    void (*sfo)(const adams_sforce *, double, int, int, double *);
    if (count != 3 || !utilities || !library || dlsym(RTLD_DEFAULT, "c_errmes"))
        return 9;
    *(void **)&sfo = dlsym(library, "Dashpot_sfosub");
    sfo(&s, 0, 0, 0, r);
    return 0;
}
"#;
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("utilities.c"), UTILITIES).unwrap();
    std::fs::write(at("host.c"), format!("#define _GNU_SOURCE\n{HOST}")).unwrap();
    let gcc = || Command::new(std::env::var_os("CC").unwrap_or("gcc".into()));
    succeed(gcc().args(["-shared", "-fPIC"]).arg(at("utilities.c")).arg("-o").arg(at("libutilities.so")));
    succeed(
        gcc()
            .args(["-std=gnu99", "-I"])
            .arg(root().join("tests"))
            .arg(at("host.c"))
            .arg("-o")
            .arg(at("host"))
            .arg("-ldl"),
    );
    let told = succeed(Command::new(at("host")).arg(library()).arg(at("libutilities.so")));
    // The utility c_errmes prints the message about missing functions. The message does not name c_errmes itself.
    assert!(told.contains("no function") && !told.contains("c_errmes"), "{told}");
}

#[test]
fn it_needs_no_more_than_the_c_library_and_nothing_of_a_locale() {
    let listed = succeed(Command::new("objdump").arg("-p").arg(library()));
    let needed: Vec<&str> = listed.lines().filter_map(|l| l.trim().strip_prefix("NEEDED")).map(str::trim).collect();
    assert!(
        !needed.is_empty() && needed.iter().all(|n| ["libc.so.6", "libm.so.6", "libdl.so.2"].contains(n)),
        "{needed:?}"
    );
    let undefined = succeed(Command::new("nm").args(["-D", "--undefined-only"]).arg(library()));
    for name in ["strtod", "atof", "scanf", "setlocale", "localeconv"] {
        assert!(!undefined.contains(name), "{name}");
    }
}

#[test]
fn either_layout_of_a_gse_gives_the_same_run() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), FULL);
    let states = format!("ns={FULL_STATES}");
    let runs = ["release=2017", "release=2023"]
        .map(|release| started(&solver(), "gse", &with(&path, &["mass=1", "end=0.2", &states, release])).accepted());
    assert!(runs[0].len() > 50);
    assert_eq!(runs[0], runs[1]);
}

#[test]
fn any_units_give_the_same_run_asked_or_given() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), FULL);
    let states = format!("ns={FULL_STATES}");
    // The unit systems of the solver's model are m, N and s; inch, pound-force and ms; mm, kN and s.
    let systems = [(1.0, 1.0, 1.0), (0.0254, 4.448_221_615_260_5, 1e-3), (1e-3, 1e3, 1.0)];
    let run_in = |routine: &str, (length, force, time): (f64, f64, f64), given: &str| {
        let units = [format!("length_unit={length:?}"), format!("force_unit={force:?}"), format!("time_unit={time:?}")];
        let [l, f, t] = &units;
        let more = ["mass=1", "frequency=3", "end=0.3", "side=300", "ni=3", &states, l, f, t, given, "page=1"];
        started(&solver, routine, &with(&path, &more))
    };
    for routine in ROUTINES {
        let plain = run_in(routine, (1e-3, 1.0, 1.0), "given=0");
        let largest = plain.accepted().iter().fold(0.0_f64, |m, a| m.max(a.sforce.abs()));
        for (system, given) in systems.iter().flat_map(|s| [(s, "given=0"), (s, "given=1")]) {
            let other = run_in(routine, *system, given);
            assert_eq!(plain.accepted().len(), other.accepted().len(), "{routine} {system:?} {given}");
            for (a, b) in plain.accepted().iter().zip(other.accepted()) {
                assert!(
                    (a.t - b.t).abs() < 1e-7 && (a.sforce - b.sforce).abs() < 1e-5 * largest,
                    "{routine} {a:?} {b:?}"
                );
            }
            if routine != "gse" {
                let (length, force, time) = *system;
                let si = [force, length, length / time, force, force, force, force, length];
                for ((a, b), (unit, mm)) in plain
                    .request()
                    .iter()
                    .zip(other.request())
                    .zip(si.iter().zip([1.0, 1e-3, 1e-3, 1.0, 1.0, 1.0, 1.0, 1e-3]))
                {
                    assert!((a * mm - b * unit).abs() < 1e-5 * (a * mm).abs() + 1e-6, "{routine} request {a} {b}");
                }
            }
        }
    }
}

#[test]
fn partials_are_those_of_differences() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let states = format!("ns={FULL_STATES}");
    for (text, states) in [(PLAIN, "ns=2"), (FULL, states.as_str())] {
        let path = written(folder.path(), text);
        for routine in ROUTINES {
            let more = ["mass=1", "frequency=3", "end=0.4", "ni=4", "no=9", "side=300", states, "partials=2"];
            let off = started(&solver, routine, &with(&path, &more)).partials_off();
            assert!(off < 1e-3, "{routine}: {off}");
        }
    }
}

#[test]
fn a_gforce_in_space_acts_along_the_line_between_its_ends() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), FULL);
    let model = model_of(FULL);
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let size = |a: [f64; 3]| dot(a, a).sqrt();
    let cases = started(&solver(), "gfo", &with(&path, &["space=1"])).in_space();
    assert_eq!(cases.len(), 200);
    let mut largest_side = 0.0_f64;
    for case in cases {
        let three = |i: usize| [case[i], case[i + 1], case[i + 2]];
        let (i, j, vi, vj, guide, force) = (three(0), three(3), three(6), three(9), three(12), three(15));
        let apart = minus(i, j);
        let axis = apart.map(|c| c / size(apart));
        // The expected tension is the kernel's steady force for this length, velocity and side force.
        let input = Input {
            side_force: size(cross(guide, axis)),
            ..Input::motion(1e-3 * (size(apart) - 400.0), 1e-3 * dot(minus(vi, vj), axis))
        };
        let mut state = model.steady_state(&input);
        state.mass_velocity = input.velocity;
        let tension = dashpot_core::evaluate::force(&model, &state, &input).force;
        let want = axis.map(|c| -tension * c);
        assert!(size(minus(force, want)) < 1e-4 * (10.0 + tension.abs()), "{force:?} {want:?}");
        // The force on marker I and its reaction, which acts at this point of J's part, give no torque about marker J.
        let reaction = force.map(|c| -c);
        let torque = cross(minus(i, j), reaction);
        assert!(size(torque) < 1e-9 * size(force) * size(apart), "{torque:?}");
        assert_eq!(case[18], 0.0, "no moment of its own");
        assert!(case[19] < 1e-4, "partials off by {}", case[19]);
        largest_side = largest_side.max(input.side_force);
    }
    assert!(largest_side > 500.0, "the side force is among what was tried");
}

#[test]
fn the_temperature_of_the_element_reaches_the_damper() {
    let text = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"temperature_fade\"]\n";
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), text);
    let model = model_of(text);
    let around = Surroundings { temperature: 85.0, ..Surroundings::NONE };
    for routine in ROUTINES {
        let more = ["amplitude=15", "frequency=4", "end=0.4", "ni=4", "temperature=85"];
        let got = started(&solver(), routine, &with(&path, &more)).accepted();
        assert!(deviation(&got, &kernel(&model, &got, 15.0, 4.0, around)) < 1e-3, "{routine}");
        assert!(deviation(&got, &kernel(&model, &got, 15.0, 4.0, Surroundings::NONE)) > 0.05, "{routine}");
    }
}

#[test]
fn the_same_question_gets_the_same_answer_in_any_order() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), FULL);
    let states = format!("ns={FULL_STATES}");
    for routine in ROUTINES {
        let run = started(&solver(), routine, &with(&path, &["mass=1", "frequency=3", "end=0.4", &states, "save=3"]));
        assert!(run.text.contains("shuffled 60 0\n"), "{routine}: {}", run.text);
    }
}

#[test]
fn only_an_iflag_that_may_asks_for_states() {
    let folder = tempfile::tempdir().unwrap();
    let path = written(folder.path(), FULL);
    let states = format!("ns={FULL_STATES}");
    // The stand-in solver fails if a call requests other states than it has declared. It also fails at any request of
    // states while saving or reloading.
    for iflag in ["iflag=1", "iflag=3", "iflag=5", "iflag=7", "iflag=9", "iflag=2", "iflag=99"] {
        for routine in ROUTINES {
            let run = started(&solver(), routine, &with(&path, &[iflag, &states]));
            assert!(run.text.contains("force 0\n"), "{routine} {iflag}: {}", run.text);
        }
    }
}

#[test]
fn the_gse_is_declared_threadsafe_and_is() {
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    let path = written(folder.path(), PLAIN);
    // With threads=2, the threads make the first calls of the library in parallel, without an earlier call of one
    // thread.
    for threads in ["threads=1", "threads=2"] {
        let run = started(&solver, "gse", &with(&path, &[threads]));
        assert_eq!(run.threads().len(), 4);
        for (alone, together) in run.threads() {
            assert_eq!(alone.to_bits(), together.to_bits());
        }
    }
    for (routine, declared) in [("gse", true), ("sfo", false), ("gfo", false)] {
        let run = started(&solver, routine, &with(&path, &["end=0.001"]));
        assert_eq!(run.count("threadsafe") > 0, declared, "{routine}");
    }
    let Some((solver, library)) = watched_for_races() else {
        skipped("this compiler cannot watch for races (-fsanitize=thread)");
        return;
    };
    for threads in ["threads=1", "threads=2"] {
        let run = run_library(&solver, &library, "gse", &with(&path, &[threads]));
        assert!(run.code == Some(0) && !run.text.contains("ThreadSanitizer"), "{}", run.text);
    }
}

#[test]
fn a_request_shows_what_makes_the_force() {
    let text = PLAIN.replace("\"gas_preload\"", "\"gas_preload\", \"rebound_stop\", \"lagged_polynomial\"");
    let text = format!("{text}polynomial = [3.0, 400.0, -25.0, 60.0]\n");
    let folder = tempfile::tempdir().unwrap();
    let solver = solver();
    for (text, has_memory) in [(PLAIN, false), (text.as_str(), true)] {
        let path = written(folder.path(), text);
        let model = model_of(text);
        for routine in ["sfo", "gfo"] {
            let page = |more: &[&str]| -> Run {
                started(&solver, routine, &with(&path, &[&["amplitude=20", "frequency=2", "end=0.13"], more].concat()))
            };
            let run = page(&[]);
            let last = *run.accepted().last().unwrap();
            let [force, deflection, mass_velocity, primary, spring, friction, gas, displacement] = run.request()[..]
            else {
                panic!("eight results");
            };
            assert!((force + last.sforce).abs() < 1e-12 * force.abs(), "{routine}");
            assert!((displacement - last.x).abs() < 1e-9 && (mass_velocity - last.v).abs() < 0.05 * last.v.abs());
            let [stop, temperature, x, v, mass, memory, ..] = page(&["page=2"]).request()[..] else {
                panic!("eight results");
            };
            assert_eq!(page(&["page=1"]).request(), run.request());
            assert_eq!((x, temperature), (displacement, 20.0), "{routine}");
            assert!((v - last.v).abs() < 1e-9 * last.v.abs() && (mass + deflection - x).abs() < 1e-9, "{routine}");
            assert_eq!(memory != 0.0, has_memory, "{routine}: {memory}");
            if !has_memory {
                // The series spring and damper (3000 N/mm, 0.2 N s/mm) carry the total force minus the forces of
                // friction, gas and stops.
                let series = 3000.0 * deflection + 0.2 * (last.v - mass_velocity);
                assert!((series + friction + gas + stop - force).abs() < 1e-6 * force.abs(), "{routine}");
                // Primary force and spring force differ from the series force only by the inertia of the internal mass
                // of 0.5 kg, which is small.
                assert!(
                    (primary + spring - series).abs() < 0.02 * force.abs(),
                    "{routine}: {primary} {spring} {series}"
                );
            }
            assert!(gas < 0.0 && friction > 0.0);
            let unknown = started(&solver, routine, &with(&path, &["end=0.01", "request=99"]));
            assert_eq!(unknown.request(), [0.0; 8]);
        }
        // At the end of this run, the displacement is 70 mm. There, the rebound stop of the second model carries force.
        // The first model has no stop.
        let far = ["amplitude=70", "frequency=1", "end=0.5", "page=2"];
        let run = started(&solver, "sfo", &with(&path, &far));
        let last = *run.accepted().last().unwrap();
        let want = model.static_output(&Input::motion(1e-3 * last.x, 0.0)).stop_force;
        assert!((run.request()[0] - want).abs() < 1e-3 * (1.0 + want), "{} {want}", run.request()[0]);
        assert_eq!(want > 10.0, has_memory);
    }
}
