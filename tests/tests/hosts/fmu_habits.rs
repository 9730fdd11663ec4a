//! FMUs in the hands of importers with habits of their own: wrong or no resources folder, a logger that goes away, calls out of order.

use dashpot_tests::fmu::exported;
use dashpot_tests::library::{root, succeed};
use dashpot_tests::python::python;
use std::process::Command;

const MODEL: &str =
    "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"presliding_friction\", \"gas_spring\"]\n";

#[test]
fn it_runs_where_an_importer_is_careless() {
    for fmi in ["2", "3"] {
        let folder = tempfile::tempdir().expect("a directory");
        exported(folder.path(), MODEL, fmi, false, &["--no-sources"]);
        let mut host = Command::new(python());
        host.arg(root().join("tests/hosts/fmu_habits.py")).arg(folder.path().join("damper.fmu"));
        succeed(host.current_dir(folder.path()));
    }
}
