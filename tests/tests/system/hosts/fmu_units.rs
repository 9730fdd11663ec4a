//! Tests of the units that an FMU declares. At any motion and force scale, an importer that converts units must get the
//! damper in SI units, or the FMU must declare no unit.

use dashpot_tests::fmu::exported;
use dashpot_tests::library::{root, succeed};
use dashpot_tests::python::{has_python, python};
use std::process::Command;

/// Model file with springs in addition to the FV curve, so that the force depends on the displacement.
const MODEL: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"presliding_friction\", \"gas_spring\"]\ngas_stiffness = 700\n";

/// Motion scale, force scale, and the expected units of displacement, velocity, force, stiffness and damping.
const CASES: [(&str, &str, &str); 6] = [
    ("0.001", "0.001", "mm,mm/s,kN,kN/mm,kN s/mm"),
    ("-0.001", "-1", "mm,mm/s,N,N/mm,N s/mm"),
    ("0.0254", "0.22480894309971", "in,in/s,lbf,lbf/in,lbf s/in"),
    ("0.3048", "-1000", "ft,ft/s,mN,mN/ft,mN s/ft"),
    ("-0.00085", "1", "-,-,N,-,-"),
    ("1", "-0.7", "m,m/s,-,-,-"),
];

fn declares(fmi: &str, four: bool) {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    let export = |name: &str, scales: [&str; 2], more: &[&str]| {
        exported(at, MODEL, fmi, four, &[&["--motion-scale", scales[0], "--force-scale", scales[1]], more].concat());
        std::fs::rename(at.join("damper.fmu"), at.join(name)).expect("renamed");
    };
    export("si.fmu", ["1", "1"], &["--no-sources"]);
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu_units.py")).arg("si.fmu");
    // With four corners, the cases of the three code paths suffice, one of them without units of motion.
    for (i, (motion, force, units)) in CASES.iter().enumerate().filter(|(i, _)| !four || [0, 1, 4].contains(i)) {
        // Cases 0, 1 and the others use the three different code paths that produce a description.
        let more: &[&str] = match i {
            0 => &["--from-source"],
            1 => &["--hide-parameters", "--no-sources"],
            _ => &["--no-sources"],
        };
        let name = format!("{i}.fmu");
        export(&name, [motion, force], more);
        host.args([name.as_str(), *units]);
    }
    // A change of sign, as for CarMaker, does not change the units.
    export("signs.fmu", ["1", "-1"], &["--no-sources"]);
    host.args(["signs.fmu", "m,m/s,N,N/m,N s/m"]);
    print!("{}", succeed(host.current_dir(at)));
}

dashpot_tests::each_fmu!(declares);
