//! Tests that only `src/output/src/terminal.rs` writes to the terminal, because this file escapes control characters in
//! texts from files.

use dashpot_test_support::rust_files;
use dashpot_tests::cli::run;
use dashpot_tests::library::root;

#[test]
fn nothing_prints_beside_the_one_place() {
    let (mut seen, mut wrong) = (0, Vec::new());
    for file in rust_files(&root().join("src")).unwrap() {
        let name = file.strip_prefix(root()).unwrap().display().to_string();
        // The test skips tests, programs for developers, build scripts, the crate that may write to the terminal, and
        // the main file of the window (`gui`).
        let own = ["/tests/", "/examples/", "build.rs", "/ui_tests/", "src/output/src/", "src/gui/src/main.rs"];
        if own.iter().any(|own| name.contains(own)) {
            continue;
        }
        seen += 1;
        let text = std::fs::read_to_string(&file).unwrap();
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        for (number, line) in code.lines().enumerate() {
            if ["println!", "print!(", "dbg!", "stdout()", "stderr()"].iter().any(|call| line.contains(call)) {
                wrong.push(format!("{name}:{}: {}", number + 1, line.trim()));
            }
        }
    }
    // `progress.rs` only checks whether a terminal exists. `main.rs` prints clap's help if the user requests help.
    wrong.retain(|line| !line.starts_with("src/cli/src/progress.rs") && !line.starts_with("src/cli/src/main.rs"));
    assert!(seen > 300, "only {seen} files were seen");
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Checks that escape sequences and direction marks in names, headings, profiles and arguments are displayed as text
/// and have no effect.
#[test]
fn texts_of_strangers_do_not_act_on_the_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let (evil, folder) = ("\u{1b}]0;owned\u{7}\u{202e}gpj", folder.path());
    let acts = |c: char| (c.is_control() && c != '\n' && c != '\t') || ('\u{202a}'..='\u{202e}').contains(&c);
    std::fs::write(folder.join("a.csv"), format!("time_s,x_mm,{evil}\n0,1,2\n")).unwrap();
    let profile = "format = \"dashpot campaign profile 1\"\npositive = \"\\u001b]0;owned\\u202egpj\"\n";
    for (within, name, text) in
        [("profile", "campaign.toml", profile), ("profile", "a.csv", "t\n"), ("names", &format!("{evil}.csv"), "t\n")]
    {
        std::fs::create_dir_all(folder.join(within)).unwrap();
        std::fs::write(folder.join(within).join(name), text).unwrap();
    }
    let option = format!("--{evil}");
    for case in [
        &["fit", "a.csv", "-o", "m.toml"][..],
        &["fit", "profile", "-o", "m.toml"],
        &["fit", "names", "-o", "m.toml"],
        &["check", &format!("names/{evil}.csv")],
        &["fit", &option],
    ] {
        let ran = run(folder, case);
        assert!(ran.code == Some(2) && ran.err.contains("202e}"), "{case:?}: {ran:?}");
        assert!(!ran.err.chars().chain(ran.out.chars()).any(acts), "{case:?}: {ran:?}");
    }
}
