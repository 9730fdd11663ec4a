//! Tests that exports for Adams are valid and match the README.txt in their folder, and that imports from Adams restore
//! the model.

use dashpot_test_support::skipped;
use dashpot_tests::adams::{library, run, solver};
use dashpot_tests::cli::{done, refused};
use dashpot_tests::dataset::{self, Dataset, value, values};
use dashpot_tests::expression::Expression;
use std::collections::BTreeMap;
use std::path::Path;

const MODEL: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \"gas_preload\", \
                     \"lagged_polynomial\"]\npolynomial = [3.0, 400.0, -25.0, 60.0]\ngas_force = 141.5\n";

/// Returns the statements of an Adams dataset by `NAME/id`, with continuation lines joined and comments omitted.
fn statements(text: &str) -> BTreeMap<String, String> {
    let mut all: Vec<(String, String)> = Vec::new();
    for line in text.lines().filter(|l| !l.starts_with('!')) {
        if let Some(more) = line.strip_prefix(',') {
            let last = all.last_mut().expect("a statement before a continuation line");
            last.1 += &format!(",{}", more.trim_end_matches('\\'));
        } else if let Some((name, rest)) = line.split_once('/') {
            let (id, rest) = rest.split_once(',').unwrap_or((rest, ""));
            all.push((format!("{name}/{}", id.trim()), rest.into()));
        }
    }
    let count = all.len();
    let map: BTreeMap<String, String> = all.into_iter().collect();
    assert!(map.len() + 200 > count, "ids are used once");
    map
}

/// Asserts that every command of an Adams View command file has only options of the command reference.
fn only_documented_options(cmd: &str) {
    let known: &[(&str, &str)] = &[
        ("data_element create string", "string_name string"),
        ("data_element create variable", "variable_name function"),
        ("data_element create array u_input_array", "array_name size variable_name"),
        ("data_element create array x_state_array", "array_name size"),
        ("data_element create array y_output_array", "array_name size"),
        ("data_element create array ic_array", "array_name size numbers"),
        (
            "part create equation general_state_equation",
            "general_state_equation_name state_equation_count discrete_state_equation_count output_equation_count \
             x_state_array_name u_input_array_name y_output_array_name ic_array_name static_hold implicit user_function \
             interface_routines",
        ),
        (
            "force create direct single_component_force",
            "single_component_force_name type_of_freedom action_only i_marker_name j_marker_name function",
        ),
    ];
    let mut seen = Vec::new();
    for line in cmd.replace("&\n", " ").lines().filter(|l| !l.starts_with('!')) {
        let (command, allowed) = known.iter().find(|k| line.starts_with(&format!("{} ", k.0))).expect(line);
        let rest = &line[command.len()..];
        let mut quoted = false;
        let plain: String = rest
            .chars()
            .filter(|c| {
                quoted ^= *c == '"';
                !quoted
            })
            .collect();
        for word in plain.split_whitespace().filter(|w| w.contains('=')) {
            let option = word.split('=').next().unwrap();
            assert!(allowed.split_whitespace().any(|a| a == option), "{command} has no {option}");
        }
        seen.push(*command);
    }
    assert!(known.iter().all(|k| seen.contains(&k.0)), "{seen:?}");
}

/// Returns the options of the Adams View command that begins with `command`.
fn options(text: &str, command: &str) -> BTreeMap<String, String> {
    let joined = text.replace("&\n", " ");
    let line = joined.lines().find(|l| l.starts_with(command)).unwrap_or_else(|| panic!("no {command}"));
    line.split_whitespace().filter_map(|w| w.split_once('=')).map(|(k, v)| (k.into(), v.into())).collect()
}

fn export(folder: &Path) {
    std::fs::write(folder.join("damper.toml"), MODEL).unwrap();
    let library = library().to_str().unwrap();
    done(folder, &["export", "adams", "damper.toml", "-o", "run", "--length", "412.5", "--library", library]);
}

#[test]
fn the_run_folder_holds_what_its_page_says_and_runs() {
    let folder = tempfile::tempdir().unwrap();
    export(folder.path());
    let run_folder = folder.path().join("run");
    let read = |name: &str| std::fs::read_to_string(run_folder.join(name)).unwrap();
    for name in ["damper.toml", "damper.cmd", "damper.adm", "rig.adm", "rig.acf", "dashpot_adams.so"] {
        assert!(run_folder.join(name).is_file(), "{name}");
    }
    for name in ["damper.cmd", "damper.adm", "rig.adm", "rig.acf", "README.txt"] {
        assert!(!read(name).contains('{') && !read(name).contains('}'), "a placeholder is left in {name}");
        assert!(read(name).lines().all(|l| l.len() < 200), "{name}");
    }
    assert_eq!(read("damper.toml"), MODEL);

    for name in ["damper.adm", "rig.adm"] {
        let adm = statements(&read(name));
        assert!(adm["SFORCE/1"].contains("FUNCTION = USER(7, 412.5)"), "{adm:?}");
        assert!(adm["SFORCE/1"].contains("ROUTINE = dashpot_adams::Dashpot_sfosub"));
        assert!(adm["STRING/7"].contains("STRING = damper.toml"));
    }
    let rig = statements(&read("rig.adm"));
    for element in ["PART/1", "PART/2", "PART/3", "PART/4", "MOTION/1", "BUSHING/1", "BUSHING/2", "JOINT/1", "JOINT/2"]
    {
        assert!(rig.contains_key(element), "{element}");
    }
    // The markers of all elements exist.
    for element in ["SFORCE/1", "BUSHING/1", "BUSHING/2", "JOINT/1", "JOINT/2"] {
        for part in rig[element].split(',').filter_map(|p| p.split_once('=')) {
            if matches!(part.0.trim(), "I" | "J") {
                assert!(rig.contains_key(&format!("MARKER/{}", part.1.trim())), "{element}: {}", part.1);
            }
        }
    }
    let acf = read("rig.acf");
    let matrix = dashpot_rig::Matrix::default();
    assert_eq!(acf.matches("SIMULATE/DYNAMICS").count(), matrix.points().len());
    assert!(acf.starts_with("rig\nrig\n") && acf.trim_end().ends_with("STOP"));

    // The GSE (general state equation) of the command file has the numbers of states and outputs of the library.
    let cmd = read("damper.cmd");
    let gse = options(&cmd, "part create equation general_state_equation");
    assert_eq!(gse["output_equation_count"], "9", "all that the library gives");
    assert_eq!(options(&cmd, "data_element create array y_output_array")["size"], "9");
    assert_eq!(gse["discrete_state_equation_count"], "0");
    assert_eq!(
        gse["interface_routines"],
        ["deriv", "update", "output", "samp"].map(|r| format!("\"dashpot_adams::Dashpot_gse_{r}\"")).join(",")
    );
    let u = options(&cmd, "data_element create array u_input_array");
    assert_eq!((u["size"].as_str(), u["variable_name"].as_str()), ("2", "dashpot_displacement,dashpot_velocity"));
    only_documented_options(&cmd);
    let x = options(&cmd, "data_element create array x_state_array");
    assert_eq!(x["size"], gse["state_equation_count"]);
    assert!(cmd.contains("function=\"ARYVAL(dashpot_y,1)\"") && cmd.contains("DM(damper_i,damper_j)-412.5"));
    let settings = [
        format!("model={}", run_folder.join("damper.toml").display()),
        format!("ns={}", gse["state_equation_count"]),
        format!("no={}", gse["output_equation_count"]),
        "end=0.01".into(),
    ];
    let ran = run(&solver(), "gse", &settings);
    assert_eq!(ran.code, Some(0), "{}", ran.text);
}

#[test]
fn a_property_file_comes_back_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("damper.toml"), MODEL).unwrap();
    done(folder.path(), &["export", "dpr", "damper.toml", "-o", "a.dpr"]);
    done(folder.path(), &["import", "dpr", "a.dpr", "-o", "back.toml"]);
    done(folder.path(), &["export", "dpr", "back.toml", "-o", "b.dpr"]);
    let rows = |name: &str| -> Vec<Vec<f64>> {
        let text = std::fs::read_to_string(folder.path().join(name)).unwrap();
        let table = text.split("force}\n").nth(1).unwrap().lines();
        table.map(|l| l.split(' ').map(|n| n.parse().unwrap()).collect()).collect()
    };
    let (a, b) = (rows("a.dpr"), rows("b.dpr"));
    assert!(a.len() > 4 && a.len() == b.len());
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        assert!((a - b).abs() <= 1e-12 * a.abs(), "{a} {b}");
    }
    // Velocities are in mm/s, and rebound velocity and tension are positive.
    let last = a.last().unwrap();
    assert!(last[0] > 100.0 && last[1] > 0.0 && a[0][0] < -100.0 && a[0][1] < 0.0);

    done(folder.path(), &["export", "dpr", "damper.toml", "-o", "a.xml"]);
    let xml = std::fs::read_to_string(folder.path().join("a.xml")).unwrap();
    assert!(xml.contains("gasPreloadMethod=\"constant\" gasPreloadConstant=\"141.5\""));
}

/// Checks the points of an FV curve in a property file. Adams interpolates with Akima's method, which exceeded a curve
/// with too few points next to a knee by 60 %.
///
/// The exported curve has enough points, and the export states the largest remaining deviation. An import of another
/// program's file gives the curve that Adams interpolates from that file.
#[test]
fn adams_reads_the_curve_of_the_model_from_a_property_file_and_the_other_way_round() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    let model = "format = 1\nelements = [\"fv_curve\"]\nfv_form = \"piecewise\"\nfv_rebound_c1 = 20000\nfv_rebound_v1 = 0.02\n\
                 fv_rebound_c2 = 800\nfv_rebound_v2 = 0.4\nfv_rebound_c3 = 1500\nfv_compression_c1 = 12000\nfv_compression_v1 = 0.02\n\
                 fv_compression_c2 = 500\n";
    std::fs::write(folder.path().join("damper.toml"), model).unwrap();
    for name in ["a.dpr", "a.xml"] {
        let said = done(folder.path(), &["export", "dpr", "damper.toml", "-o", name]);
        for text in [&said, &at(name)] {
            assert!(
                text.contains("Akima") && text.contains("points were added") && text.contains("by at most"),
                "{text}"
            );
        }
        done(folder.path(), &["import", "dpr", name, "-o", "back.toml"]);
        done(folder.path(), &["export", "dpr", "back.toml", "-o", &format!("b{name}")]);
        let rows = |text: String| {
            text.lines().filter(|l| l.trim().starts_with(|c: char| c == '-' || c.is_ascii_digit())).count()
        };
        assert_eq!(rows(at(name)), rows(at(&format!("b{name}"))));
    }
    let car = "[MDI_HEADER]\nFILE_TYPE='dpr'\n[UNITS]\nLENGTH='mm'\nFORCE='newton'\nTIME='second'\n[CURVE]\n-1270 -1495.5\n-254 -809.5\n\
               -25 -120\n0 0\n25 200\n254 1423.4\n1270 2900\n";
    std::fs::write(folder.path().join("car.dpr"), car).unwrap();
    let said = done(folder.path(), &["import", "dpr", "car.dpr", "-o", "car.toml"]);
    for text in [&said, &at("car.toml")] {
        assert!(text.contains("Akima") && text.contains("were added to those of the file"), "{text}");
    }
    // This property file has more rows than an FV curve of a model may have points.
    let force = |v: f64| if v < 0.0 { 0.5 } else { 1.0 } * 1000.0 * (v / 90.0).tanh() + 0.6 * v;
    let rows: String = (-100..=100).map(|i| 12.5 * f64::from(i)).map(|v| format!("{v} {:.3}\n", force(v))).collect();
    let car = car.split("-1270").next().unwrap().to_owned() + &rows;
    std::fs::write(folder.path().join("long.dpr"), car).unwrap();
    let said = done(folder.path(), &["import", "dpr", "long.dpr", "-o", "long.toml"]);
    for text in [&said, &at("long.toml")] {
        assert!(text.contains("The file has 201 points and a model's curve at most 63"), "{text}");
    }
    let model = dashpot_identification::model_file::read(&folder.path().join("long.toml")).unwrap();
    let model = dashpot_core::Model::new(&model.params).unwrap();
    for v in [-1200.0, -300.0, -40.0, 0.0, 12.5, 77.0, 700.0] {
        let off = (model.elements().paths.fv_curve.evaluate(1e-3 * v).value - force(v)).abs();
        assert!(off < 0.006 * 1750.0, "{v} mm/s: {off} N");
    }
}

/// Checks that both forms of a property file (text and XML) state the omitted effects and the model. An import of
/// dashpot's own XML restores FV curve and gas force.
#[test]
fn what_a_property_file_leaves_out_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    std::fs::write(folder.path().join("damper.toml"), MODEL).unwrap();
    for (name, held) in [("a.dpr", false), ("a.xml", true)] {
        let said = done(folder.path(), &["export", "dpr", "damper.toml", "-o", name]);
        for text in [&said, &at(name)] {
            let left_out = text.lines().find(|l| l.to_lowercase().contains("left out")).expect("told");
            assert!(left_out.contains("series_compliance") && left_out.contains("stribeck_friction"), "{left_out}");
            assert_eq!(left_out.contains("gas_preload"), !held, "{left_out}");
        }
        assert!(at(name).contains("damper.toml"));
        done(folder.path(), &["import", "dpr", name, "-o", "back.toml"]);
        let back = at("back.toml");
        assert_eq!(back.contains("gas_force = 141.5"), held, "{back}");
        assert!(back.contains(&format!("# Read from {name}.")), "{back}");
        // An export of the imported model writes the same numbers.
        let again = format!("again-{name}");
        done(folder.path(), &["export", "dpr", "back.toml", "-o", &again]);
        let numbers = |text: String| -> Vec<f64> {
            let table = text.split(if held { "<![CDATA[" } else { "force}" }).nth(1).expect("a table").to_owned();
            let end = table.split("]]>").next().unwrap_or_default().to_owned();
            end.split_whitespace().map(|n| n.parse().expect("a number")).collect()
        };
        for (a, b) in numbers(at(name)).iter().zip(numbers(at(&again))) {
            assert!((a - b).abs() <= 1e-12 * a.abs(), "{a} {b}");
        }
    }
    assert!(at("a.xml").contains("<afc ") && at("a.xml").contains("gasPreloadMethod=\"constant\""));
}

/// Table in a model file with the fit of the FV curve alone.
///
/// This curve includes the friction. In the model, friction is a separate element.
const FIT: &str = "\n[identification.fv_only]\nvelocity = [-1.0, -0.01, 0.0, 0.01, 1.0]\nforce = [-640.0, -50.0, 0.0, 50.4, 1340.0]\n\
                   gas_force = 150.0\n";

/// Checks the FV curve that a property file contains, because its host supports only a curve. It is the best fit of an
/// FV curve alone, with a note on its origin. An option selects the curve of the whole model instead.
#[test]
fn a_property_file_holds_the_plain_curve_of_the_fit() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    std::fs::write(folder.path().join("damper.toml"), format!("{MODEL}{FIT}")).unwrap();
    for name in ["a.dpr", "a.xml"] {
        let said = done(folder.path(), &["export", "dpr", "damper.toml", "-o", name]);
        for text in [&said, &at(name)] {
            assert!(
                text.contains("plain FV curve fitted to the same tests") && text.contains("stribeck_friction"),
                "{text}"
            );
        }
        assert!(said.contains("were added to the 5 of the model"), "{said}");
        assert!(at(name).lines().any(|line| line.trim() == "10.0 50.4"), "{}", at(name));
        let said = done(folder.path(), &["export", "dpr", "damper.toml", "-o", name, "--model-curve"]);
        assert!(said.contains("own fv_curve, as asked for") && !at(name).contains("50.4"), "{said}");
    }
    done(folder.path(), &["export", "dpr", "damper.toml", "-o", "a.xml"]);
    assert!(at("a.xml").contains("gasPreloadMethod=\"constant\" gasPreloadConstant=\"150.0\""), "{}", at("a.xml"));

    // A manually tuned model file still contains the tables of its fit. The FV curve alone in these tables does not fit
    // the tuned damper, so the export does not use it.
    let intervals = "\n[identification.intervals]\ngas_force = [100.0, 120.0]\n";
    std::fs::write(folder.path().join("tuned.toml"), format!("{MODEL}{intervals}{FIT}")).unwrap();
    let said = done(folder.path(), &["export", "dpr", "tuned.toml", "-o", "b.dpr"]);
    assert!(said.contains("were changed after its fit") && !at("b.dpr").contains("50.4"), "{said}");

    // For Adams with the library, which also runs the other elements, the export keeps the FV curve of the whole model.
    done(folder.path(), &["export", "adams", "damper.toml", "-o", "run", "--library", library().to_str().unwrap()]);
    assert_eq!(at("run/damper.toml"), format!("{MODEL}{FIT}"));
}

/// Checks that the export of a newly identified damper replaces its own older property file. A file of another program
/// with the same beginning is kept.
#[test]
fn a_property_file_replaces_its_own_older_version_alone() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let vendor = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<afc>\n</afc>\n";
    std::fs::write(at("vendor.xml"), vendor).unwrap();
    for name in ["a.dpr", "a.xml"] {
        for gas in ["141.5", "152"] {
            std::fs::write(at("damper.toml"), MODEL.replace("141.5", gas)).unwrap();
            done(folder.path(), &["export", "dpr", "damper.toml", "-o", name]);
        }
    }
    assert!(
        refused(folder.path(), &["export", "dpr", "damper.toml", "-o", "vendor.xml"]).contains("XML of other origin")
    );
    assert_eq!(std::fs::read_to_string(at("vendor.xml")).unwrap(), vendor);

    // Two Adams models with the same title may be different models, so one must not replace the other.
    let car = |tail: &str| {
        format!(
            "Adams View model name: MODEL_1\nSFORCE/1\n, TRANSLATIONAL\n, I = 11\n, J = 12\n, FUNCTION = \
             akispl(vr(11,12),0,9)\nSPLINE/9\n, X = -100, 0, 100\n, Y = 500, 0, -900\n{tail}END\n"
        )
    };
    std::fs::write(at("car.adm"), car("")).unwrap();
    std::fs::write(at("other.adm"), car("PART/2\n")).unwrap();
    let export = ["export", "adm", "car.adm", "-o"];
    for length in ["SFORCE/1=400", "SFORCE/1=401"] {
        done(folder.path(), &[&export[..], &["new.adm", "--damper", length]].concat());
    }
    refused(folder.path(), &[&export[..], &["other.adm", "--damper", "SFORCE/1=400"]].concat());
    assert_eq!(std::fs::read_to_string(at("other.adm")).unwrap(), car("PART/2\n"));
}

/// Checks that a closed standard output is an error, whereas an output to `/dev/null` is not.
#[test]
fn a_closed_standard_output_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("damper.toml"), MODEL).unwrap();
    for (to, code) in [(">&-", 2), (">/dev/null", 0)] {
        let line = format!("\"$0\" export dpr damper.toml -o - {to}");
        let ran = std::process::Command::new("sh")
            .args(["-c", &line])
            .arg(dashpot_tests::cli::program())
            .current_dir(folder.path())
            .output()
            .expect("a shell");
        assert_eq!(ran.status.code(), Some(code), "{to}: {}", String::from_utf8_lossy(&ran.stderr));
    }
}

/// Reads real files of Adams Car from a user-defined folder (such as dampers.tbl of the public
/// wokomm/PropertyView-mechanics).
///
/// All files must be readable, and their exports, too. The test prints the messages of each import.
#[test]
fn real_property_files_are_read() {
    let Some(from) = std::env::var_os("DASHPOT_ADAMS_PROPERTY_FILES") else {
        skipped("DASHPOT_ADAMS_PROPERTY_FILES names no folder of real .dpr and .xml files");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let mut read = 0;
    for entry in std::fs::read_dir(&from).expect("the folder") {
        let path = entry.expect("an entry").path();
        if !path.extension().is_some_and(|e| e == "dpr" || e == "xml") {
            continue;
        }
        let said = done(folder.path(), &["import", "dpr", path.to_str().unwrap(), "-o", "m.toml"]);
        println!("{}: {}", path.file_name().unwrap().to_string_lossy(), said.replace('\n', " | "));
        for out in ["m.dpr", "m.xml"] {
            done(folder.path(), &["export", "dpr", "m.toml", "-o", out]);
            done(folder.path(), &["import", "dpr", out, "-o", "again.toml"]);
        }
        read += 1;
    }
    println!("{read} real property files read");
    assert!(read > 0);
}

/// Checks that `dashpot export adams` writes the Adams library without a compiler. If the program did not contain the
/// library, the README.txt of the run folder would state this.
#[test]
fn a_run_folder_holds_its_library() {
    dashpot_tests::fmu::runtimes();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("damper.toml"), MODEL).unwrap();
    let ran =
        dashpot_tests::cli::run_with(folder.path(), &["export", "adams", "damper.toml", "-o", "run"], &[("PATH", "")]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let library = std::fs::read(folder.path().join("run/dashpot_adams.so")).expect("the library");
    assert!(library.starts_with(b"\x7fELF"));
    assert!(!std::fs::read_to_string(folder.path().join("run/README.txt")).unwrap().contains("NOT HERE"));
}

#[test]
fn several_models_go_in_at_once_and_what_is_lost_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let sforce = |id: u32, tail: &str| {
        format!(
            "SFORCE/{id}\n, TRANSLATIONAL\n, I = {id}1\n, J = {id}2\n, FUNCTION = akispl(vr({id}1,{id}2),0,9){tail}\n"
        )
    };
    let spline = "SPLINE/9\n, X = -100, 0, 100\n, Y = 500, 0, -900\nEND\n";
    std::fs::write(folder.path().join("car.adm"), format!("Car\n{}{}{spline}", sforce(1, ""), sforce(2, "+150")))
        .unwrap();
    let named = ["export", "adm", "car.adm", "-o", "new.adm"];
    let with = |more: &[&'static str]| -> Vec<&'static str> { named.iter().chain(more).copied().collect() };
    let words = refused(folder.path(), &with(&["--damper", "SFORCE/2=400"]));
    assert!(words.contains("adds 150") && words.contains("--replace-preload"), "{words}");
    let with_friction = format!("Car\n{}{spline}", sforce(2, "-2*abs(vr(21,22))"));
    std::fs::write(folder.path().join("damped.adm"), with_friction).unwrap();
    let words = refused(
        folder.path(),
        &["export", "adm", "damped.adm", "-o", "d.adm", "--damper", "SFORCE/2=400", "--replace-preload"],
    );
    assert!(words.contains("no force at rest"), "{words}");
    let words = refused(folder.path(), &with(&["--damper", "SFORCE/1=400", "--model-file", "a\n, X = 1"]));
    assert!(words.contains("line break"), "{words}");
    let both = ["--damper", "SFORCE/1=400,front.toml", "--damper", "SFORCE/2=388", "--replace-preload"];
    let said = done(folder.path(), &with(&both));
    assert!(said.contains("at rest, 150"), "{said}");
    let new = statements(&std::fs::read_to_string(folder.path().join("new.adm")).unwrap());
    assert!(new["SFORCE/1"].contains("USER(1, 400") && new["STRING/1"].contains("front.toml"), "{new:?}");
    assert!(new["SFORCE/2"].contains("USER(2, 388") && new["STRING/2"].contains("damper.toml"), "{new:?}");
    // The solver searches the model files in its working folder; a message names missing files.
    assert!(said.contains("no model file front.toml") && said.contains("no model file damper.toml"), "{said}");
    std::fs::write(folder.path().join("front.toml"), MODEL).unwrap();
    std::fs::write(folder.path().join("damper.toml"), "gas_force = 3\n").unwrap();
    let said = done(folder.path(), &with(&both));
    assert!(!said.contains("front.toml") && said.contains("will refuse the model file: damper.toml"), "{said}");
    // With a decimal comma, the text could mean the length 412 mm and the model file `5`, so a message rejects it.
    for comma in ["SFORCE/1=412,5,front.toml", "SFORCE/1=412,5"] {
        let words = refused(folder.path(), &with(&["--damper", comma]));
        assert!(words.contains("decimal comma; write 412.5"), "{words}");
    }
    // An expression with 28,000 nested brackets gives an error and no stack overflow.
    let deep = format!("Car\n{}{spline}", sforce(1, &format!("*{}1{}", "(".repeat(28_000), ")".repeat(28_000))));
    std::fs::write(folder.path().join("car.adm"), deep).unwrap();
    let words = refused(folder.path(), &with(&["--damper", "SFORCE/1=400"]));
    assert!(words.contains("nested"), "{words}");
}

/// Checks the unit of the option `--length`. Adams uses mm, so a length in m is rejected unless its unit is stated.
#[test]
fn a_length_says_its_unit_or_is_one_that_a_damper_has() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("damper.toml"), MODEL).unwrap();
    let export = ["export", "adams", "damper.toml", "-o", "run", "--library", library().to_str().unwrap(), "--length"];
    let words = refused(folder.path(), &[&export[..], &["0.4125"]].concat());
    assert!(words.contains("0.4125 mm long") && words.contains("0.4125m"), "{words}");
    done(folder.path(), &[&export[..], &["0.4125m"]].concat());
    let adm = std::fs::read_to_string(folder.path().join("run/damper.adm")).unwrap();
    assert!(adm.contains("USER(7, 412.5)"), "{adm}");
}

#[test]
fn a_property_file_that_is_none_is_refused_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let text = "[UNITS]\nLENGTH='mm'\nFORCE='newton'\nTIME='second'\n[CURVE]\n-100 -500\n0 0\n100 x\n";
    std::fs::write(folder.path().join("a.dpr"), text).unwrap();
    let words = refused(folder.path(), &["import", "dpr", "a.dpr", "-o", "b.toml"]);
    assert!(words.contains("a.dpr") && words.contains("line 8"), "{words}");
}

#[test]
fn a_compiled_model_is_patched() {
    let folder = tempfile::tempdir().unwrap();
    let adm = "Car\n!  adams_view_name='susp.dal_ride_damper.force'\nSFORCE/1\n, TRANSLATIONAL\n, I = 75\n, J = 76\n\
               , FUNCTION = step(vr(75,76),-1e-4,1,1e-4,1)*akispl(vr(75,76),0,9)\nSPLINE/9\n, X = -100, 0, 100\n\
               , Y = 500, 0, -900\nEND\n";
    std::fs::write(folder.path().join("car.adm"), adm).unwrap();
    let named = ["export", "adm", "car.adm", "-o", "new.adm", "--damper"];
    done(folder.path(), &[&named[..], &["dal_ride_damper.force=412.5"]].concat());
    let new = statements(&std::fs::read_to_string(folder.path().join("new.adm")).unwrap());
    assert!(new["SFORCE/1"].contains("USER(1, 412.5)") && new["STRING/1"].contains("damper.toml"), "{new:?}");
    assert_eq!(new["SPLINE/9"], statements(adm)["SPLINE/9"]);
    let words = refused(
        folder.path(),
        &[&["export", "adm", "car.adm", "-o", "x.adm", "--damper"][..], &["no.force=1"]].concat(),
    );
    assert!(words.contains("no.force"), "{words}");
}

/// Interpolates linearly between the points of a spline.
fn between(points: &[(f64, f64)], at: f64) -> f64 {
    let i = points.partition_point(|p| p.0 <= at).clamp(1, points.len() - 1);
    let (a, b) = (points[i - 1], points[i]);
    a.1 + (b.1 - a.1) * (at - a.0) / (b.0 - a.0)
}

fn spline(dataset: &Dataset, id: u64) -> Vec<(f64, f64)> {
    let given = &dataset[&("SPLINE".into(), id)];
    let points: Vec<(f64, f64)> = values(given, "X").into_iter().zip(values(given, "Y")).collect();
    assert!(points.len() > 100);
    points
}

/// Checks the export of native elements of Adams, which represent only some elements of the model.
///
/// A message names every other element as the reason for the missing native.adm. A native.adm of an earlier export is
/// reported as outdated.
#[test]
fn no_element_is_left_out_of_the_native_elements_without_a_word() {
    const HELD: [&str; 8] = [
        "fv_curve",
        "series_compliance",
        "parallel_spring",
        "coulomb_friction",
        "stribeck_friction",
        "viscous_friction",
        "presliding_friction",
        "gas_preload",
    ];
    let folder = tempfile::tempdir().unwrap();
    let export = |elements: &[&str], more: &str| {
        let text = format!("format = 1\nelements = {elements:?}\n{more}");
        std::fs::write(folder.path().join("damper.toml"), text).unwrap();
        let said = done(folder.path(), &["export", "adams", "damper.toml", "-o", "run"]);
        let read_me = std::fs::read_to_string(folder.path().join("run/README.txt")).unwrap();
        (said, read_me.replace('\n', " "))
    };
    let (said, read_me) = export(&HELD, "");
    assert!(!said.contains("native.adm") && read_me.contains("native.adm  "), "{said}");
    for element in dashpot_core::parameter::names().filter(|name| !HELD.contains(name)) {
        let (said, read_me) = export(&["fv_curve", "series_compliance", element], "");
        let why = format!("no native.adm, because splines of velocity and displacement cannot hold {element}");
        assert!(said.contains(&why), "{said}");
        assert!(said.contains("is of an earlier export"), "{said}");
        assert!(read_me.contains(&format!("cannot hold {element}.")), "{read_me}");
        // In the README.txt, the reason for the missing native.adm precedes the list of files.
        let (why, list) =
            (read_me.find("There is no native.adm").unwrap(), read_me.find("the identified damper").unwrap());
        assert!(why < list, "{read_me}");
    }
    let (said, _) = export(&HELD, "series_load = \"whole\"\n");
    assert!(said.contains("act on the internal mass"), "{said}");
}

/// Checks that the function expressions of the exported native.adm give the model's force within 1 % of the largest
/// force. The test evaluates the unchanged expressions between two markers that an actuator moves.
#[test]
fn the_native_elements_agree_with_the_model() {
    native_agrees(
        "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"parallel_spring\", \"stribeck_friction\", \
         \"viscous_friction\", \"gas_preload\"]\n",
    );
}

/// Checks the native Adams elements of the model of a default fit of the virtual rig, also with other forms of
/// presliding friction.
#[test]
fn the_native_elements_hold_the_default_fit() {
    let fit = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"parallel_spring\", \"gas_preload\", \"presliding_friction\"]\n\
               presliding_force = 43.8\npresliding_length = 9.4e-5\n";
    native_agrees(fit);
    native_agrees(&format!("{fit}presliding_power = 3.0\n"));
    native_agrees(&format!("{fit}presliding_power = 2.0\npresliding_return = \"elastic\"\npresliding_creep = 0.001\n"));
}

fn native_agrees(text: &str) {
    const LENGTH: f64 = 400.0;
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("damper.toml"), text).unwrap();
    done(folder.path(), &["export", "adams", "damper.toml", "-o", "run", "--length", "400"]);
    let adm = dataset::read(&std::fs::read_to_string(folder.path().join("run/native.adm")).unwrap(), false, &[11, 12]);
    let splines = [1, 2, 3].map(|id| spline(&adm, id));
    let function = |name: &str, id: u64| Expression::read(value(&adm[&(name.into(), id)], "FUNCTION"));
    let (place, speed, force) = (function("DIFF", 1), function("DIFF", 2), function("SFORCE", 1));
    let contact = text.contains("presliding_friction").then(|| function("DIFF", 3));
    assert!((1..=2 + u64::from(contact.is_some())).all(|id| values(&adm[&("DIFF".into(), id)], "IC") == [0.0]));

    let mut params = dashpot_core::Params::new();
    dashpot_core::model_file::read(text.as_bytes(), &mut params).unwrap();
    let model = dashpot_core::Model::new(&params).unwrap();
    for (amplitude, frequency) in [(50.0, 2.0), (15.0, 5.0), (2.0, 20.0)] {
        let w = std::f64::consts::TAU * frequency;
        let motion = |t: f64| (-amplitude * (w * t).cos(), amplitude * w * (w * t).sin());
        let input = |t: f64| dashpot_core::Input::motion(1e-3 * motion(t).0, 1e-3 * motion(t).1);
        let mut state = model.steady_state(&input(0.0));
        // The simulation starts in the static equilibrium of the model, like Adams.
        let mut dif = [1e3 * (state.mass_displacement - state.displacement), 0.0, 0.0];
        let dt = 1e-5;
        let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
        for i in 0..(1.5 / frequency / dt) as usize {
            let to = (i + 1) as f64 * dt;
            let (x, v) = motion(to);
            let at = |expression: &Expression, dif: [f64; 3]| {
                expression.evaluate(&|name, of| match (name, of) {
                    ("DM", [11.0, 12.0]) => LENGTH + x,
                    ("VR", [11.0, 12.0]) => v,
                    ("DIF", [id]) => dif[*id as usize - 1],
                    ("AKISPL", [at, 0.0, id]) => between(&splines[*id as usize - 1], *at),
                    _ => panic!("{name}({of:?})"),
                })
            };
            // The integration of the internal mass is semi-implicit, with a step of a hundredth of its natural period.
            dif[1] += dt * at(&speed, dif);
            dif[0] += dt * at(&place, dif);
            if let Some(contact) = &contact {
                // Substeps are necessary, because at high velocity the contact reacts within a hundredth of a
                // millisecond.
                for _ in 0..20 {
                    dif[2] += 0.05 * dt * at(contact, dif);
                }
            }
            let native = -at(&force, dif);
            let (next, output) = dashpot_core::step(&model, &state, &input(to), dt);
            state = next;
            worst = worst.max((native - output.force).abs());
            largest = largest.max(output.force.abs());
        }
        println!("{amplitude} mm {frequency} Hz: {:.3} % of the largest force", 100.0 * worst / largest);
        assert!(worst < 0.01 * largest, "{amplitude} mm {frequency} Hz: {worst} N of {largest} N");
    }
}
