//! Tests that no file of the user is lost: outputs replace only older outputs of their kind.

use dashpot_tests::cli::{done, program, refused, run, small_campaign};
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// Makes a folder with `records/`, a model `m.toml` and figures `f.json`, which are computed once and copied.
fn folder() -> tempfile::TempDir {
    static MADE: OnceLock<tempfile::TempDir> = OnceLock::new();
    let made = MADE.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        small_campaign(folder.path());
        done(folder.path(), &["fit", "records", "-o", "m.toml", "--model", "fv", "--json", "f.json"]);
        folder
    });
    let folder = tempfile::tempdir().unwrap();
    copy(made.path(), folder.path());
    folder
}

fn copy(from: &Path, to: &Path) {
    for entry in fs::read_dir(from).unwrap() {
        let (source, place) = (entry.as_ref().unwrap().path(), to.join(entry.unwrap().file_name()));
        if source.is_dir() {
            fs::create_dir(&place).unwrap();
            copy(&source, &place);
        } else {
            fs::copy(&source, &place).unwrap();
        }
    }
}

const RECORD: &str = "records/a50mm_v0262mm_s.csv";
const OTHER: &str = "records/a15mm_v0262mm_s.csv";

#[test]
fn no_output_replaces_an_input_or_a_file_of_another_kind() {
    let folder = folder();
    let dir = folder.path();
    fs::write(dir.join("letter.txt"), "Dear Anna,\n").unwrap();
    fs::write(dir.join("package.json"), "{\"name\": \"x\"}").unwrap();
    fs::write(dir.join("mine.csv"), "t;x\n0;1\n").unwrap();
    fs::write(dir.join("page.html"), "<!DOCTYPE html>\n<title>mine</title>").unwrap();
    let fv = ["--model", "fv"];
    let cases: &[&[&str]] = &[
        &["fit", RECORD, OTHER, "-o", OTHER],
        &["fit", "records", "-o", OTHER],
        &["fit", "records", "-o", "letter.txt"],
        &["fit", "records", "-o", "new.toml", "--json", "m.toml"],
        &["fit", "records", "-o", "new.toml", "--json", "package.json"],
        &["fit", "records", "-o", "same", "--json", "same"],
        &["fit", "records", "-o", "same", "--json", "records/../same"],
    ];
    for args in cases {
        refused(dir, &[args, &fv[..]].concat());
    }
    for args in [
        &["simulate", "m.toml", RECORD, "-o", RECORD][..],
        &["simulate", "m.toml", RECORD, "-o", OTHER],
        &["simulate", "m.toml", RECORD, "-o", "m.toml"],
        &["simulate", "m.toml", RECORD, "-o", "mine.csv"],
        &["validate", "m.toml", "records", "--report", OTHER],
        &["validate", "m.toml", "records", "--report", "page.html"],
        &["validate", "m.toml", "records", "--json", "m.toml"],
        &["validate", "m.toml", "records", "--excel", OTHER],
        &["diagnose", "m.toml", "records", "-o", "m.toml"],
        &["export", "dpr", "m.toml", "-o", "m.toml"],
        &["export", "dpr", "m.toml", "-o", "letter.txt"],
        &["matrix", "-o", "mine.csv"],
        &["matrix", "-o", RECORD],
    ] {
        let message = refused(dir, args);
        assert!(message.contains("--force"), "{args:?}: {message}");
    }
}

#[test]
fn outputs_replace_their_own_kind_and_force_replaces_anything() {
    let folder = folder();
    let dir = folder.path();
    let fit = ["fit", RECORD, "-o", "m.toml", "--json", "f.json", "--model", "fv"];
    done(dir, &fit);
    for _ in 0..2 {
        done(dir, &["simulate", "m.toml", RECORD, "-o", "s.csv"]);
        done(dir, &["validate", "m.toml", RECORD, "--report", "r.html", "--svg", "figures", "--json", "v.json"]);
        done(dir, &["export", "dpr", "m.toml", "-o", "d.dpr"]);
        done(dir, &["matrix", "-o", "all.csv"]);
    }
    fs::write(dir.join("letter.txt"), "Dear Anna,\n").unwrap();
    done(dir, &["fit", RECORD, "-o", "letter.txt", "--model", "fv", "--force"]);
    assert!(fs::read_to_string(dir.join("letter.txt")).unwrap().contains("format = 1"));
    done(dir, &["--force", "simulate", "m.toml", RECORD, "-o", RECORD]);
}

#[cfg(unix)]
#[test]
fn links_rights_and_devices_survive() {
    use std::os::unix::fs::{FileTypeExt as _, PermissionsExt as _, symlink};
    let folder = folder();
    let dir = folder.path();
    let fit = |to: &str| run(dir, &["fit", RECORD, "-o", to, "--model", "fv"]);
    fs::create_dir(dir.join("store")).unwrap();
    fs::copy(dir.join("m.toml"), dir.join("store/kept.toml")).unwrap();
    fs::set_permissions(dir.join("store/kept.toml"), fs::Permissions::from_mode(0o640)).unwrap();
    symlink("store/kept.toml", dir.join("link.toml")).unwrap();
    assert_eq!(fit("link.toml").code, Some(0));
    assert!(fs::symlink_metadata(dir.join("link.toml")).unwrap().is_symlink());
    let mode = fs::metadata(dir.join("store/kept.toml")).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
    // A link to a record is protected like the record.
    symlink(RECORD, dir.join("innocent.toml")).unwrap();
    assert!(fit("innocent.toml").err.contains("read by this run"));
    fs::set_permissions(dir.join("m.toml"), fs::Permissions::from_mode(0o444)).unwrap();
    assert!(fit("m.toml").err.contains("write-protected"));
    for (args, code) in [(&[][..], 2), (&["--force"], 0)] {
        let ran = run(dir, &[&["fit", RECORD, "-o", "/dev/null", "--model", "fv"], args].concat());
        assert_eq!(ran.code, Some(code), "{ran:?}");
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    }
}

#[test]
fn temporary_files_of_dead_runs_go_away() {
    let folder = folder();
    let dir = folder.path();
    fs::write(dir.join(".dashpot-Xy12ab"), "half a model").unwrap();
    done(dir, &["fit", RECORD, "-o", "m.toml", "--model", "fv"]);
    assert!(!dir.join(".dashpot-Xy12ab").exists());
}

#[test]
fn two_runs_into_one_folder_exclude_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    let start = |seed: &str| {
        let mut rig = Command::new(program());
        rig.args(["rig", "-o", "c", "--seed", seed]).current_dir(dir).stdout(Stdio::piped()).stderr(Stdio::piped());
        rig.spawn().unwrap()
    };
    let runs: Vec<_> = ["1", "2", "3"].map(start).into_iter().map(|run| run.wait_with_output().unwrap()).collect();
    let won = runs.iter().filter(|run| run.status.success()).count();
    let told = runs.iter().filter(|run| String::from_utf8_lossy(&run.stderr).contains("another run")).count();
    assert!(won >= 1 && won + told == 3, "{runs:?}");
    // The folder contains the campaign of one of the runs, equal to a campaign with the seed of that run alone.
    let text = fs::read_to_string(dir.join("c/campaign.toml")).unwrap();
    let seed = text.lines().find_map(|l| l.strip_prefix("seed = ")).unwrap().to_owned();
    done(dir, &["rig", "-o", "alone", "--seed", &seed]);
    let files = |folder: &str| {
        let mut files: Vec<_> = fs::read_dir(dir.join(folder))
            .unwrap()
            .map(|e| e.unwrap().path())
            .map(|p| (p.file_name().unwrap().to_owned(), fs::read(&p).unwrap()))
            .collect();
        files.sort();
        files
    };
    assert!(files("c") == files("alone"));
}

#[cfg(target_os = "linux")]
#[test]
fn closed_or_full_standard_output_is_an_error() {
    let folder = folder();
    let shell = |line: &str| {
        let line = line.replace("dashpot", &program().display().to_string());
        let ran = Command::new("sh").args(["-c", &line]).current_dir(folder.path()).output().unwrap();
        (ran.status.code(), String::from_utf8_lossy(&ran.stderr).into_owned())
    };
    for line in [
        format!("dashpot simulate m.toml {RECORD} -o - >&-"),
        format!("dashpot simulate m.toml {RECORD} -o - >/dev/full"),
        format!("dashpot simulate m.toml {RECORD} -o s.csv >/dev/full"),
        "dashpot matrix >&-".into(),
        "dashpot matrix >/dev/full".into(),
        "dashpot --help >/dev/full".into(),
    ] {
        let (code, said) = shell(&line);
        assert!(code == Some(2) && !said.contains("panicked"), "{line}: {code:?} {said}");
    }
    let (code, said) = shell(&format!("dashpot simulate m.toml {RECORD} -o /dev/full --force"));
    assert!(code == Some(2) && said.contains("/dev/full"), "{code:?} {said}");
    // A reader of the output that stops early, the null device, and a closed standard error must not cause an error.
    for line in ["dashpot matrix | head -1", "dashpot matrix >/dev/null", "dashpot matrix </dev/null >/dev/null 2>&-"] {
        assert_eq!(shell(line).0, Some(0), "{line}");
    }
}
