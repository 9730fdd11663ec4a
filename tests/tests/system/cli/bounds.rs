//! Tests of numbers that are impossible for any damper, in every option and in every file that accepts numbers. Each
//! number must be rejected in a sentence that names the option or the entry.

use dashpot_tests::cli::{Ran, campaign_folder, done, run};
use std::path::Path;

/// Placeholders in `--help` of values that are or contain numbers.
const NUMBERS: [&str; 17] = [
    "S",
    "N",
    "M",
    "KG",
    "HZ",
    "PERCENT",
    "MM",
    "MM/S",
    "R",
    "C",
    "SEED",
    "LENGTH",
    "SETTING",
    "VALUE",
    "VALUE|NAME",
    "N|all|family",
    "[CHANNEL=]FACTOR",
];

/// Placeholders in `--help` of values that contain numbers after a name.
const NAMED_NUMBERS: [&str; 2] = ["NAME[=SEVERITY]", "NAME=LENGTH[,PATH]"];

/// Placeholders in `--help` of values without numbers. Placeholders of files are recognized by their point and not
/// listed.
const TEXTS: [&str; 20] = [
    "rebound|compression",
    "force|motion",
    "day-first|month-first",
    "de|fr|zh|en",
    "CHANNEL=UNIT",
    "CHANNEL=HEADING",
    "COLUMN=HEADING",
    "CHANNEL",
    "GLOB",
    "NAME",
    "MODEL",
    "DATA",
    "DIR",
    "GOOD",
    "BY",
    "DATE",
    "FILE",
    "PATH",
    "PLATFORM=FILE",
    "INSTANT",
];

/// Numbers that no option and no entry accepts.
const ABSURD: [&str; 5] = ["1e308", "-1e308", "nan", "inf", "-inf"];

/// Numbers that are sensible for some quantities, such as a delay.
const SMALL: [&str; 2] = ["0", "1e-308"];

/// Options that also reject [`SMALL`].
const POSITIVE: [&str; 15] = [
    "--host-step",
    "--wheel-mass",
    "--for-step",
    "--step",
    "--sample-rate",
    "--gain",
    "--amplitudes",
    "--peak-velocities",
    "--frequency-limit",
    "--motion-scale",
    "--force-scale",
    "--carmaker",
    "--length",
    "--damper",
    "--fmi",
];

/// Longest line of a message, characters.
const LONGEST: usize = 400;

const MODEL: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\ngas_force = 150.0\n";

const FAMILY: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\n\
     setting_name = \"current\"\nsetting_unit = \"A\"\ngas_force = [150.0, 160.0]\n";

/// A verb with arguments to which an option can be added.
struct Verb {
    /// Words of the verb.
    words: &'static [&'static str],
    /// Other arguments.
    more: &'static [&'static str],
    /// Whether a run with a valid number takes less than a second, so that [`SMALL`] is tried.
    is_quick: bool,
}

const fn quick(words: &'static [&'static str], more: &'static [&'static str]) -> Verb {
    Verb { words, more, is_quick: true }
}

const fn slow(words: &'static [&'static str], more: &'static [&'static str]) -> Verb {
    Verb { words, more, is_quick: false }
}

const VERBS: [Verb; 17] = [
    slow(&["fit"], &["records", "-o", "out.toml"]),
    slow(&["validate"], &["family.toml", "records"]),
    slow(&["check"], &["m.toml"]),
    slow(&["diagnose"], &["family.toml", "records"]),
    quick(&["explain"], &["family.toml", "--dimensions", "d.toml"]),
    quick(&["setting"], &["family.toml", "0.5", "-o", "-"]),
    quick(&["simulate"], &["m.toml", "motion.csv", "-o", "-"]),
    quick(&["matrix"], &[]),
    slow(&["rig"], &["-o", "rig", "--matrix", "one.csv"]),
    slow(&["demo"], &["-o", "demo"]),
    slow(&["bench"], &[]),
    slow(&["export", "fmu"], &["m.toml", "-o", "m.fmu"]),
    slow(&["export", "adams"], &["m.toml", "-o", "adams"]),
    quick(&["export", "adm"], &["car.adm", "-o", "out.adm", "--model-file", "m.toml"]),
    quick(&["import", "peaks"], &["peaks.csv", "-o", "-"]),
    quick(&["import-profile"], &["records", "-o", "-"]),
    slow(&["manoeuvre"], &["bump", "m.toml"]),
];

/// Verbs without an option for a number.
const WITHOUT: [&str; 8] =
    ["open", "completions", "man", "help", "export help", "import help", "export dpr", "import dpr"];

/// Makes the files of [`VERBS`] in a folder with records.
fn inputs() -> tempfile::TempDir {
    let folder = campaign_folder();
    for (name, text) in [
        ("m.toml", MODEL),
        ("family.toml", FAMILY),
        ("d.toml", "bore_mm = 36\nrod_mm = 12\n"),
        ("motion.csv", "time_s,v_m_s\n0,0\n0.1,0.1\n0.2,0\n"),
        ("one.csv", "name,amplitude_mm,frequency_hz,cycles\na,5,5,1\n"),
        ("peaks.csv", "velocity [m/s],force [N]\n-0.5,-400\n0.5,900\n"),
        ("car.adm", "UNITS/FORCE = NEWTON, LENGTH = MILLIMETER\n"),
    ] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// Returns the options of a verb with the placeholders of their values, from `--help`.
fn options_of(folder: &Path, words: &[&str]) -> Vec<(String, String)> {
    let help = done(folder, &[words, &["--help"]].concat());
    let option = |line: &str| {
        let (_, rest) = line.trim_start().split_once("--").filter(|(before, _)| before.len() <= 4)?;
        let (name, placeholder) = rest.split_once(" <")?;
        let name = name.bytes().all(|b| b.is_ascii_lowercase() || b == b'-').then_some(name)?;
        Some((format!("--{name}"), placeholder.split_once('>')?.0.to_owned()))
    };
    help.lines().filter(|line| line.trim_start().starts_with('-')).filter_map(option).collect()
}

/// Returns the names of the subcommands, from `--help`.
fn subcommands(folder: &Path, words: &[&str]) -> Vec<String> {
    let help = done(folder, &[words, &["--help"]].concat());
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let name = |line: &str| [words, &[line.split_whitespace().next().unwrap()]].concat().join(" ");
    listed.map(name).collect()
}

/// Checks that no line of the output of a run is longer than [`LONGEST`].
fn check_lines(args: &[&str], ran: &Ran) {
    for line in ran.out.lines().chain(ran.err.lines()) {
        assert!(line.chars().count() <= LONGEST, "{args:?}: a line of {} characters: {line}", line.chars().count());
    }
}

/// Checks that a run rejects its input, and that the message contains one of the names.
fn check_rejected(args: &[&str], ran: &Ran, names: &[&str]) {
    check_lines(args, ran);
    assert_eq!(ran.code, Some(2), "{args:?}: {ran:?}");
    let text = ran.err.to_lowercase();
    assert!(names.iter().any(|name| text.contains(name)), "{args:?} does not name {names:?}: {}", ran.err);
    assert!(ran.err.chars().count() < 600, "{args:?}: {}", ran.err);
}

/// Tries numbers in one option of a verb.
fn try_option(folder: &Path, verb: &Verb, option: &str) {
    let values: &[&str] = match option {
        "--hide" => &["bushing={}"],
        "--damper" => &["front={}"],
        "--gain" => &["{}", "displacement={}"],
        "--setting" if verb.words == ["simulate"] => &["{}", "0:{}", "0:0.4,{}:0.8"],
        _ => &["{}"],
    };
    let needs: &[&str] = match option {
        "--start-temperature" | "--order" => &["--hide", "nothing"],
        _ => &[],
    };
    // A setting needs a damper over a setting.
    let of_family: Vec<&str> = verb.more.iter().map(|arg| if *arg == "m.toml" { "family.toml" } else { arg }).collect();
    let more = if option == "--setting" { &of_family[..] } else { verb.more };
    let name = option.trim_start_matches('-');
    let spaced = name.replace('-', " ");
    let names = [name, spaced.as_str(), "front: "];
    let names = if option == "--damper" { &names[..] } else { &names[..2] };
    let is_positive = POSITIVE.contains(&option);
    for (value, number) in
        values.iter().flat_map(|value| ABSURD.iter().chain(&SMALL).map(move |number| (value, number)))
    {
        let is_absurd = is_positive || ABSURD.contains(number);
        if !is_absurd && !verb.is_quick {
            continue;
        }
        let given = format!("{option}={}", value.replace("{}", number));
        let args = [verb.words, more, needs, &[given.as_str()]].concat();
        let ran = run(folder, &args);
        match is_absurd {
            true => check_rejected(&args, &ran, names),
            false => check_lines(&args, &ran),
        }
    }
}

/// Tries the numbers in each option for a number that `--help` of any verb names.
#[test]
fn every_option_rejects_absurd_numbers_in_a_sentence_that_names_it() {
    let folder = inputs();
    let dir = folder.path();
    let verbs = subcommands(dir, &[]);
    let all = verbs.iter().flat_map(|verb| match verb.as_str() {
        "export" | "import" => subcommands(dir, &[verb]),
        _ => vec![verb.clone()],
    });
    let known = |words: &str| VERBS.iter().any(|verb| verb.words.join(" ") == words);
    let (mut tried, mut unknown) = (0, Vec::new());
    for words in all.filter(|words| !known(words)) {
        let options =
            if words.ends_with("help") { Vec::new() } else { options_of(dir, &words.split(' ').collect::<Vec<_>>()) };
        let takes_number =
            options.iter().any(|(_, of)| NUMBERS.contains(&of.as_str()) || NAMED_NUMBERS.contains(&of.as_str()));
        if takes_number || !WITHOUT.contains(&words.as_str()) {
            unknown.push(words);
        }
    }
    assert!(unknown.is_empty(), "add these verbs to VERBS or WITHOUT: {unknown:?}");
    for verb in &VERBS {
        for (option, placeholder) in options_of(dir, verb.words) {
            let is_scale = option.ends_with("-scale");
            let is_number = is_scale || [&NUMBERS[..], &NAMED_NUMBERS].concat().contains(&placeholder.as_str());
            let is_text =
                TEXTS.contains(&placeholder.as_str()) || placeholder.contains('.') || placeholder == "F" && !is_scale;
            assert!(is_number || is_text, "add <{placeholder}> of {option} to NUMBERS or TEXTS");
            if is_number {
                try_option(dir, verb, &option);
                tried += 1;
            }
        }
    }
    assert!(tried > 60, "{tried}");
}

#[test]
fn a_setting_as_an_argument_is_bounded_too() {
    let folder = inputs();
    for number in ABSURD {
        let args = ["setting", "family.toml", "-o", "-", "--", number];
        check_rejected(&args, &run(folder.path(), &args), &["setting"]);
    }
}

/// A test of a file: its name, its text with the placeholder `{}` of a number, and the arguments of a verb that reads
/// it. The last element is a text that every message must contain.
type File = (&'static str, &'static str, &'static [&'static str], &'static str);

/// Tries the numbers of [`ABSURD`] at the placeholder of a file.
fn try_file(folder: &Path, (file, text, args, named): File) {
    for number in ABSURD {
        std::fs::write(folder.join(file), text.replace("{}", number)).unwrap();
        let ran = run(folder, args);
        check_rejected(args, &ran, &[named]);
        assert!(ran.err.contains(file), "{args:?} does not name {file}: {}", ran.err);
    }
    std::fs::remove_file(folder.join(file)).unwrap();
}

#[test]
fn every_file_rejects_absurd_numbers_in_a_sentence_that_names_its_entry() {
    let folder = inputs();
    let dir = folder.path();
    let validate = &["validate", "m.toml", "records", "--limits", "limits.csv"][..];
    let bump = &["manoeuvre", "bump", "m.toml", "--vehicle", "car.toml"][..];
    let explain = &["explain", "m.toml", "--dimensions", "drawing.toml"][..];
    let fit = &["fit", "records", "-o", "out.toml"][..];
    let rig = &["rig", "-o", "rig", "--matrix", "points.csv"][..];
    let simulate = &["simulate", "m.toml", "road.csv", "-o", "-"][..];
    let peaks = &["import", "peaks", "pvp.csv", "-o", "-"][..];
    let check = &["check", "own.toml"][..];
    let import = &["import", "dpr", "own.dpr", "-o", "-"][..];
    let files: [File; 32] = [
        (
            "own.dpr",
            "$ c\n[MDI_HEADER]\nFILE_TYPE = 'dpr'\n[UNITS]\nLENGTH = 'mm'\nFORCE = 'newton'\nTIME = 'sec'\n[CURVE]\n{ vel force}\n-10 -1\n10 {}\n",
            import,
            "",
        ),
        (
            "own.dpr",
            "$ c\n[MDI_HEADER]\nFILE_TYPE = 'dpr'\n[UNITS]\nLENGTH = 'mm'\nFORCE = 'newton'\nTIME = 'sec'\n[CURVE]\n{ vel force}\n-10 -1\n{} 1\n",
            import,
            "",
        ),
        ("limits.csv", "quantity,high\nfriction,{}\n", validate, "line 2: high"),
        ("limits.csv", "quantity,low\ngas_force,{}\n", validate, "line 2: low"),
        ("limits.csv", "quantity,velocity_m_s,low\nforce,{},1\n", validate, "line 2: velocity_m_s"),
        ("limits.csv", "quantity,amplitude_m,high\nhysteresis,{},1\n", validate, "line 2: amplitude_m"),
        ("limits.csv", "quantity,setting,high\nfriction,{},1\n", validate, "line 2: setting"),
        ("limits.csv", "quantity,high\nrise_time_up,{}\n", validate, "line 2: high"),
        ("limits.csv", "quantity,nominal,tolerance\nfriction,{},1\n", validate, "line 2: nominal"),
        ("limits.csv", "quantity,nominal,tolerance\nfriction,1,{}\n", validate, "line 2: "),
        ("car.toml", "sprung_mass = {}\n", bump, "line 1: sprung_mass"),
        ("car.toml", "grip = 1\ncornering = {}\n", bump, "line 2: cornering"),
        ("drawing.toml", "bore_mm = {}\n", explain, "line 1: bore_mm"),
        ("drawing.toml", "rod_mm = 12\ngas_pressure_bar = [1, {}]\n", explain, "line 2: gas_pressure_bar"),
        ("points.csv", "name,amplitude_mm,frequency_hz\na,{},1\n", rig, "line 2"),
        ("points.csv", "name,amplitude_mm,frequency_hz\na,5,{}\n", rig, "line 2"),
        ("points.csv", "name,amplitude_mm,peak_velocity_mm_s\na,5,{}\n", rig, "line 2"),
        ("points.csv", "name,amplitude_mm,frequency_hz,mean_displacement_mm\na,5,1,{}\n", rig, "line 2"),
        ("points.csv", "name,amplitude_mm,frequency_hz,side_force_n\na,5,1,{}\n", rig, "line 2"),
        ("points.csv", "name,amplitude_mm,frequency_hz,cycles\na,5,1,{}\n", rig, "line 2"),
        ("road.csv", "time_s,x_m\n0,0\n1,{}\n", simulate, "line 3"),
        ("road.csv", "time_s,v_m_s\n0,0\n1,{}\n", simulate, "line 3"),
        ("pvp.csv", "velocity [m/s],force [N]\n-0.5,-400\n{},900\n", peaks, ""),
        ("pvp.csv", "velocity [m/s],force [N]\n-0.5,-400\n0.5,{}\n", peaks, ""),
        ("own.toml", "format = 1\nelements = [\"gas_preload\"]\ngas_force = {}\n", check, "line 3"),
        (
            "own.toml",
            "format = 1\nelements = [\"fv_curve\"]\nfv_velocity = [-1, 0, {}]\nfv_force = [-1, 0, 1]\n",
            check,
            "line ",
        ),
        (
            "own.toml",
            "format = 1\nelements = [\"fv_curve\"]\nfv_velocity = [-1, 0, 1]\nfv_force = [{}, 0, 1]\n",
            check,
            "line ",
        ),
        ("own.toml", "format = 1\nsetting = [0.0, {}]\nelements = [\"fv_curve\"]\n", check, "line "),
        (
            "own.toml",
            "format = 1\nsetting = [0.0, 1.0]\nsetting_start = {}\nelements = [\"fv_curve\"]\n",
            check,
            "line 3",
        ),
        (
            "own.toml",
            "format = 1\nsetting = [0.0, 1.0]\nsetting_time_up = {}\nelements = [\"fv_curve\"]\n",
            check,
            "line 3",
        ),
        (
            "own.toml",
            "format = 1\nsetting = [0.0, 1.0]\nsetting_rate_up = {}\nelements = [\"fv_curve\"]\n",
            check,
            "line 3",
        ),
        ("own.toml", "format = 1\nelements = [\"gas_spring\"]\ngas_length = {}\n", check, "line 3"),
    ];
    for file in files {
        try_file(dir, file);
    }
    for (entry, named) in [
        ("delay_s = {}", "delay"),
        ("force_zero_n = {}", "force zero"),
        ("displacement_zero_m = {}", "displacement zero"),
        ("gain = {}", "gain"),
        ("rig_mass_kg = {}", "rig mass"),
        ("sample_rate_hz = {}", "sample rate"),
        ("initial_position_m = {}", "initial position"),
        ("gains = { displacement = {} }", "gain of displacement"),
        ("setting = \"current\"\nsettings = { \"*\" = {} }", "settings"),
    ] {
        for number in ABSURD {
            let text = format!("format = \"dashpot campaign profile 1\"\n{}\n", entry.replace("{}", number));
            std::fs::write(dir.join("records/campaign.toml"), text).unwrap();
            let ran = run(dir, fit);
            check_rejected(fit, &ran, &[named]);
            assert!(ran.err.contains("campaign.toml"), "{}", ran.err);
        }
    }
}
