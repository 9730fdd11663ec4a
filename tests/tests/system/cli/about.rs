//! Tests of version, shell completions and manual pages of the program `dashpot`.

use dashpot_abi::version::DASHPOT_ABI_VERSION;
use dashpot_test_support::skipped;
use dashpot_tests::cli::{done, refused};
use std::process::Command;

/// Returns the subcommands that the text of `--help` lists.
fn verbs(help: &str) -> Vec<&str> {
    let list = help.split("Commands:").nth(1).expect("a list of verbs").split("Options:").next().unwrap();
    let names = list.lines().filter_map(|line| line.strip_prefix("  ")?.split_whitespace().next());
    names.filter(|name| *name != "help").collect()
}

#[test]
fn the_version_names_the_interface() {
    let folder = tempfile::tempdir().unwrap();
    let want = format!("dashpot {} (interface version {DASHPOT_ABI_VERSION})\n", env!("CARGO_PKG_VERSION"));
    assert_eq!(done(folder.path(), &["--version"]), want);
    assert_eq!(done(folder.path(), &["-V"]), want);
}

#[test]
fn every_shell_gets_every_verb() {
    let folder = tempfile::tempdir().unwrap();
    let help = done(folder.path(), &["--help"]);
    assert!(verbs(&help).len() > 10, "{help}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let text = done(folder.path(), &["completions", shell]);
        for verb in verbs(&help) {
            assert!(text.contains(verb), "{shell} has no {verb}");
        }
        done(folder.path(), &["completions", shell, "-o", "file"]);
        assert_eq!(std::fs::read_to_string(folder.path().join("file")).unwrap(), text);
        std::fs::remove_file(folder.path().join("file")).unwrap();
    }
    assert!(refused(folder.path(), &["completions", "tcsh"]).contains("bash"));
}

/// Checks that bash completes the beginning of a subcommand with the script that `dashpot completions` writes.
#[test]
fn bash_completes_a_verb() {
    let folder = tempfile::tempdir().unwrap();
    done(folder.path(), &["completions", "bash", "-o", "dashpot.bash"]);
    let script = ". ./dashpot.bash; COMP_WORDS=(dashpot vali); COMP_CWORD=1; _dashpot dashpot vali dashpot; echo ${COMPREPLY[@]}";
    match Command::new("bash").args(["-c", script]).current_dir(folder.path()).output() {
        Ok(out) => assert_eq!(String::from_utf8_lossy(&out.stdout).trim(), "validate", "{out:?}"),
        Err(_) => skipped("no bash"),
    }
}

#[test]
fn every_verb_has_a_manual_page_with_its_example() {
    let folder = tempfile::tempdir().unwrap();
    let help = done(folder.path(), &["--help"]);
    done(folder.path(), &["man", "pages"]);
    let page = |name: &str| std::fs::read_to_string(folder.path().join("pages").join(format!("{name}.1"))).unwrap();
    for verb in verbs(&help) {
        let text = page(&format!("dashpot-{verb}"));
        let examples = if verb == "export" { page("dashpot-export-fmu") } else { text.clone() };
        assert!(examples.contains("dashpot"), "{verb}: no example");
        assert!(text.contains(&format!("(interface version {DASHPOT_ABI_VERSION})")), "{verb}: no version");
    }
    assert!(page("dashpot").contains("dashpot\\-fit(1)"));
    // A second run writes identical manual pages, and replaces the older files.
    let before = dashpot_tests::cli::contents(folder.path());
    done(folder.path(), &["man", "pages"]);
    assert!(dashpot_tests::cli::contents(folder.path()) == before);

    std::fs::write(folder.path().join("pages/dashpot-fit.1"), "my own notes\n").unwrap();
    assert!(refused(folder.path(), &["man", "pages"]).contains("dashpot-fit.1"));
}
