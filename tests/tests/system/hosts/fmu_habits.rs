//! Tests of exported FMUs in importers with unusual behavior.
//!
//! Such importers pass a wrong path of the resources folder or none, remove the logger, or set no start values. They also request outputs
//! at earlier times, or call functions out of order.

use dashpot_tests::cli::{done, refused};
use dashpot_tests::fmu::exported;
use dashpot_tests::library::{directory, root, succeed};
use dashpot_tests::python::python;
use std::process::Command;

const MODEL: &str =
    "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"presliding_friction\", \"gas_spring\"]\n";

#[test]
fn it_runs_where_an_importer_is_careless() {
    for fmi in ["2", "3"] {
        for scales in [&[][..], &["--position-offset", "0.012", "--motion-scale", "0.9", "--force-scale", "1.1"]] {
            let folder = tempfile::tempdir().expect("a directory");
            exported(folder.path(), MODEL, fmi, false, &[&["--no-sources"], scales].concat());
            let mut host = Command::new(python());
            host.arg(root().join("tests/hosts/fmu_habits.py")).arg(folder.path().join("damper.fmu"));
            succeed(host.current_dir(folder.path()));
        }
    }
}

/// Checks that CarMaker's input for controlled dampers is the setting of an adjustable damper.
#[test]
fn it_is_a_controlled_damper_of_carmaker() {
    let text = std::fs::read_to_string(root().join("examples/semi_active.toml")).expect("the example");
    for fmi in ["2", "3"] {
        let folder = tempfile::tempdir().expect("a directory");
        let at = folder.path();
        exported(at, &text, fmi, false, &["--carmaker", "0.4125", "--no-sources"]);
        let library = directory().join("libdashpot.so");
        let mut host = Command::new(python());
        host.arg(root().join("tests/hosts/fmu_carmaker.py")).args([
            "damper.fmu".as_ref(),
            library.as_os_str(),
            "model.toml".as_ref(),
            "0.4125".as_ref(),
        ]);
        print!("{}", succeed(host.current_dir(at)));
    }
}

/// Checks that an FMU in CarMaker's convention gives the forces of the C library. Its .pluginfo file must have the form of CarMaker's
/// templates.
#[test]
fn it_is_a_damper_of_carmaker() {
    for fmi in ["2", "3"] {
        let folder = tempfile::tempdir().expect("a directory");
        let at = folder.path();
        exported(
            at,
            &MODEL.replace("\"gas_spring\"", "\"gas_preload\", \"gas_spring\""),
            fmi,
            false,
            &["--carmaker", "0.4125", "--no-sources"],
        );
        let library = directory().join("libdashpot.so");
        let mut host = Command::new(python());
        host.arg(root().join("tests/hosts/fmu_carmaker.py")).args([
            "damper.fmu".as_ref(),
            library.as_os_str(),
            "model.toml".as_ref(),
            "0.4125".as_ref(),
        ]);
        print!("{}", succeed(host.current_dir(at)));

        let export = ["export", "fmu", "model.toml", "-o", "other.fmu", "--carmaker"];
        let words = refused(at, &[&export[..], &["412.5"]].concat());
        assert!(words.contains("412.5 m long") && words.contains("412.5mm"), "{words}");
        assert!(refused(at, &[&export[..], &["0.4", "--four"]].concat()).contains("--four"));
        let two = ["export", "fmu", "model.toml", "model.toml", "-o", "other.fmu", "--carmaker", "0.4"];
        assert!(refused(at, &two).contains("one model"));
        // With `--hide-parameters`, the .pluginfo file does not reveal parameters.
        let plug_info = |name: &str| std::fs::read_to_string(at.join(name)).expect("the file beside the FMU");
        assert!(plug_info("damper.pluginfo").contains("Susp.Damper.SubstModel.Damper:\n\t-"));
        done(at, &["export", "fmu", "model.toml", "-o", "hidden.fmu", "--carmaker", "0.4", "--hide-parameters"]);
        assert!(!plug_info("hidden.pluginfo").contains("SubstModel.Damper"));
        // CarMaker uses the FMU only in motion. For the equilibrium, CarMaker uses an FV curve in the .pluginfo file: the fit of the FV
        // curve alone, if the model file contains one.
        assert!(plug_info("damper.pluginfo").contains("the model file has no plain FV curve of a fit"));
        let fit = "[identification.fv_only]\nvelocity = [-1.0, 0.0, 0.01, 1.0]\nforce = [-640.0, 0.0, 50.4, 1340.0]\ngas_force = 150.0\n";
        std::fs::write(at.join("fitted.toml"), format!("{MODEL}{fit}")).expect("a model file");
        let fitted = ["export", "fmu", "fitted.toml", "-o", "fitted.fmu", "--carmaker", "412.5mm"];
        let said = done(at, &fitted);
        assert!(
            said.contains("fitted to the same tests") && plug_info("fitted.pluginfo").contains("\n\t0.01 50.4\n"),
            "{said}"
        );
        done(at, &[&fitted[..], &["--model-curve"]].concat());
        assert!(!plug_info("fitted.pluginfo").contains("50.4"));
        // All .pluginfo files of CarMaker have the same beginning. A file that a user has written is not replaced.
        std::fs::write(at.join("other.pluginfo"), "#INFOFILE1.1 - Do not remove this line!\nFMU.Name = other\n")
            .expect("a file");
        assert!(refused(at, &[&export[..], &["0.4"]].concat()).contains("a file of CarMaker"));
        assert!(!at.join("other.fmu").exists());
    }
}
