//! Fast tests of the parts of the installation packages.
//!
//! The bytes of archives depend only on their files, every license may be shipped, and the scripts are valid. Building
//! the packages takes long; `dist/check` tests the built packages.

use dashpot_test_support::skipped;
use dashpot_tests::library::{root, succeed};
use std::path::Path;
use std::process::Command;

fn has(program: &str) -> bool {
    let there = Command::new(program).arg("--version").output().is_ok();
    if !there {
        skipped(format!("no {program}"));
    }
    there
}

fn pack(kind: &str, folder: &Path, archive: &Path) -> Vec<u8> {
    let mut python = Command::new("python3");
    python.arg(root().join("dist/archive.py")).args([
        kind.as_ref(),
        folder.as_os_str(),
        "name-1".as_ref(),
        archive.as_os_str(),
    ]);
    succeed(python.env("SOURCE_DATE_EPOCH", "1700000000"));
    std::fs::read(archive).expect("an archive")
}

#[test]
fn the_same_files_give_the_same_archive_whatever_their_order_and_times() {
    if !has("python3") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let files = [("b/zwei.txt", "2"), ("a.txt", "1"), ("b/a/drei", "3")];
    let lay = |name: &str, order: [usize; 3], age: u64| {
        let tree = folder.path().join(name);
        for i in order {
            let path = tree.join(files[i].0);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(&path, files[i].1).unwrap();
            let time = std::time::SystemTime::UNIX_EPOCH + std::time::Duration::from_secs(age);
            std::fs::File::options().write(true).open(&path).unwrap().set_modified(time).unwrap();
        }
        tree
    };
    let (one, two) = (lay("one", [0, 1, 2], 1_000_000_000), lay("two", [2, 0, 1], 1_600_000_000));
    for kind in ["tar", "zip"] {
        let first = pack(kind, &one, &folder.path().join("first"));
        assert!(first == pack(kind, &two, &folder.path().join("second")), "{kind}");
        std::fs::write(two.join("a.txt"), "other").unwrap();
        assert!(first != pack(kind, &two, &folder.path().join("second")), "{kind}: other files, the same archive");
        std::fs::write(two.join("a.txt"), "1").unwrap();
    }
    let mut list = Command::new("tar");
    let told = succeed(list.arg("-tzf").arg({
        pack("tar", &one, &folder.path().join("first"));
        folder.path().join("first")
    }));
    assert_eq!(
        told.lines().collect::<Vec<_>>(),
        ["name-1/", "name-1/b/", "name-1/b/a/", "name-1/a.txt", "name-1/b/a/drei", "name-1/b/zwei.txt"]
    );
}

/// Python program that checks a wheel as an installer does. The list RECORD in the wheel must contain every file with
/// its checksum, and no other file.
const INSTALLS: &str = r#"
import base64, csv, hashlib, io, sys, zipfile
wheel = zipfile.ZipFile(sys.argv[1])
rows = list(csv.reader(io.StringIO(wheel.read("name-1.dist-info/RECORD").decode())))
assert [row[0] for row in rows] == wheel.namelist() and len(rows) == 5, rows
for name, checksum, size in rows[:-1]:
    content = wheel.read(name)
    assert checksum == "sha256=" + base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("="), name
    assert int(size) == len(content), name
assert rows[-1] == ["name-1.dist-info/RECORD", "", ""], rows
assert [name.startswith("name-1.dist-info/") for name in wheel.namelist()] == [False, False, True, True, True]
"#;

#[test]
fn a_wheel_follows_from_its_files_and_lists_them_with_their_checksums() {
    if !has("python3") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let tree = folder.path().join("tree");
    std::fs::create_dir_all(tree.join("name-1.dist-info")).unwrap();
    std::fs::create_dir_all(tree.join("zname")).unwrap();
    let files = ["zname/__init__.py", "zname/Größe.txt", "name-1.dist-info/METADATA", "name-1.dist-info/WHEEL"];
    for name in files {
        std::fs::write(tree.join(name), name).unwrap();
    }
    let pack = |name: &str| {
        let wheel = folder.path().join(name);
        let mut python = Command::new("python3");
        python.arg(root().join("dist/archive.py")).arg("wheel").arg(&tree).arg(&wheel);
        succeed(python.env("SOURCE_DATE_EPOCH", "1700000000"));
        wheel
    };
    let first = pack("first");
    succeed(Command::new("python3").args(["-c", INSTALLS]).arg(&first));
    // The packing ignores a RECORD that already exists in the folder.
    std::fs::write(tree.join("name-1.dist-info/RECORD"), "of an earlier wheel\n").unwrap();
    assert!(std::fs::read(&first).unwrap() == std::fs::read(pack("second")).unwrap());
}

/// Checks that the bytes of the Adams library for Windows do not depend on its folder. The linker for Windows derives a
/// base address from the path of the library, unless an option disables this.
///
/// Every address in the file depends on the base address.
#[test]
fn a_library_for_windows_does_not_depend_on_its_folder() {
    const COMPILER: &str = "x86_64-w64-mingw32-gcc";
    if !has(COMPILER) || !has("make") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    // An object file that defines the kernel's names replaces the kernel here, because Rust for Windows is not always
    // installed.
    let header = std::fs::read_to_string(root().join("include/dashpot.h")).unwrap();
    let name = |word: &str| word.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap().to_owned();
    let names: std::collections::BTreeSet<String> =
        header.split('(').map(name).filter(|n| n.starts_with("dashpot_")).collect();
    let bodies: String = names.iter().map(|n| format!("void *{n}(void) {{ return 0; }}\n")).collect();
    std::fs::write(at.join("names.c"), bodies).unwrap();
    succeed(Command::new(COMPILER).args(["-c", "names.c", "-o", "names.o"]).current_dir(at));
    let made = |name: &str| {
        let library = at.join(name).join("dashpot_adams.dll");
        std::fs::create_dir(at.join(name)).unwrap();
        let mut make = Command::new("make");
        make.arg("-s").arg("-C").arg(root().join("adams-usersub")).arg("windows");
        make.arg(format!("WINDOWS_LIBRARY={}", at.join("names.o").display()));
        succeed(make.arg(format!("WINDOWS_OUTPUT={}", library.display())));
        std::fs::read(library).unwrap()
    };
    let differing = made("one").iter().zip(&made("another_longer_one")).filter(|(a, b)| a != b).count();
    assert_eq!(differing, 0, "bytes that depend on the folder");
    for script in ["vi-crt-bridge/runtimes.sh", "vi-crt-bridge/fmu/build.sh"] {
        let text = std::fs::read_to_string(root().join(script)).unwrap();
        assert!(
            text.contains("--no-insert-timestamp,--disable-auto-image-base"),
            "{script} links without the same care"
        );
    }
}

/// Checks that every license of a used crate is reviewed. An unreviewed license stops the build of a package; this test
/// detects such a license earlier.
#[test]
fn every_licence_may_be_shipped() {
    if !has("python3") {
        return;
    }
    let mut python = Command::new("python3");
    python.arg(root().join("dist/licences.py")).args([
        "texts",
        "x86_64-unknown-linux-gnu",
        "dashpot-cli",
        "dashpot-dll",
    ]);
    let told = succeed(python.current_dir(root()));
    for name in ["clap ", "nalgebra ", "libm ", "Rust standard library"] {
        assert!(told.contains(name), "{name} is missing");
    }
}

#[test]
fn the_scripts_are_scripts() {
    let mut scripts =
        ["build", "check", "archive.py", "licences.py"].map(|name| root().join("dist").join(name)).to_vec();
    for folder in ["dist/steps", "dist/checks"] {
        scripts.extend(std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path()));
    }
    assert!(scripts.len() > 8);
    for script in scripts {
        if script.extension().is_some_and(|name| name == "py") {
            if has("python3") {
                let parse = "import ast, sys; ast.parse(open(sys.argv[1], encoding='utf-8').read())";
                succeed(Command::new("python3").args(["-c", parse]).arg(script));
            }
        } else {
            succeed(Command::new("bash").arg("-n").arg(script));
        }
    }
}
