//! Generates the C header `include/dashpot.h` from the sources of the C interface.
//!
//! `cbindgen` translates one source file at a time, so that the header keeps the order of a manual. Every source file
//! gives a section, which begins with the file's module documentation. Parts that exist only in C (guards,
//! initializers) come from `src/abi/header/`. The last section is a list of the parameters.

use dashpot_core::parameter::{Element, Parameter, Params, Shape};
use std::path::{Path, PathBuf};

use cbindgen::{Builder, Config, DocumentationStyle, Language, Style};
use dashpot_core::parameter::{GROUPS, names};

/// Sections of the header in order, named by the source files in `src/abi/src`.
const SECTIONS: [&str; 11] =
    ["lib", "version", "status", "params", "model", "input", "state", "step", "partials", "evaluate", "setting"];
/// Section of the functions that read the parameter table. The list of the parameters follows this section.
const TABLE: &str = "table";

/// Returns the path of the C header.
pub fn path() -> PathBuf {
    root().join("include/dashpot.h")
}

/// Generates the text of the C header.
pub fn text() -> String {
    let mut header = String::from(
        "// Written from src/abi by `UPDATE_HEADER=1 cargo test --profile tests -p dashpot-tests --test source abi_header`; do not edit.\n\n",
    );
    let mut sections = SECTIONS.iter();
    header += &comment(&manual(sections.next().expect("the title")));
    header += &part("begin");
    for section in sections {
        header += &chapter(section);
    }
    header += &chapter(TABLE);
    header += &rule("Parameters, their units, bounds and defaults");
    header += &comment(&parameters());
    header + "\n" + &part("end")
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn source(section: &str) -> PathBuf {
    root().join(format!("src/abi/src/{section}.rs"))
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn chapter(section: &str) -> String {
    let manual = manual(section);
    let (title, text) = manual.split_once('\n').expect("a title");
    rule(title) + &comment(text.trim_start()) + &translated(section) + &part(section)
}

/// Returns the module documentation of a source file.
fn manual(section: &str) -> String {
    let text = read(&source(section));
    let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
    lines.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
}

/// Returns the text of `src/abi/header/<name>.h` after an empty line, or an empty text if there is no such file.
fn part(name: &str) -> String {
    let path = root().join(format!("src/abi/header/{name}.h"));
    if path.exists() { format!("\n{}", read(&path)) } else { String::new() }
}

fn rule(title: &str) -> String {
    format!("\n\n// {}\n// {title}\n// {}\n\n", "=".repeat(110), "=".repeat(110))
}

fn comment(text: &str) -> String {
    text.lines().map(|line| format!("// {line}").trim_end().to_string() + "\n").collect()
}

/// Translates the public items of one source file to C declarations.
fn translated(section: &str) -> String {
    // cbindgen omits structures that no function of the file uses, unless the configuration lists them.
    let text = read(&source(section));
    let structures = text.lines().filter_map(|line| line.strip_prefix("pub struct ")?.split([' ', '(']).next());
    let mut config = Config {
        language: Language::C,
        style: Style::Both,
        no_includes: true,
        usize_is_size_t: true,
        documentation_style: DocumentationStyle::C99,
        line_length: 120,
        ..Config::default()
    };
    config.export.include = structures.map(String::from).collect();
    config.layout.aligned_n = Some("DASHPOT_ALIGNED".into());
    config.function.args = cbindgen::Layout::Auto;
    let bindings = Builder::new().with_src(source(section)).with_config(config).generate();
    let mut bytes = Vec::new();
    bindings.unwrap_or_else(|error| panic!("{section}: {error}")).write(&mut bytes);
    let text = String::from_utf8(bytes).expect("text");
    // cbindgen writes `struct` only before structures of other files; remove the word, because every structure has a
    // typedef.
    let lines = text.trim().lines().map(|line| match line.starts_with("typedef") {
        true => format!("\n{line}"),
        false => format!("\n{}", line.replace("struct dashpot_", "dashpot_")),
    });
    lines.collect::<String>() + "\n"
}

/// Formats the list of all parameters of the model as text for the C header.
fn parameters() -> String {
    let defaults = Params::new();
    let mut text = String::from("Names for dashpot_params_set(), dashpot_params_set_list() and model files.\n");
    for group in GROUPS {
        let on = match names().any(|name| name == group.name) {
            true if Element::find(group.name).is_ok_and(|element| defaults.is_on(element)) => {
                " (element, on by default)"
            }
            true => " (element, off by default)",
            false => "",
        };
        text += &format!("\n{}{on}: {}\n", group.name, group.meaning);
        for p in group.parameters {
            let range = match p.shape {
                Shape::Choice(words) => {
                    words.iter().enumerate().map(|(i, w)| format!("{i} {w}")).collect::<Vec<_>>().join(", ")
                }
                Shape::Scalar => format!("{}, {}, default {}", p.unit, bounds(p), short(p.default[0])),
                Shape::List(n) => format!("{}, {}, at most {n} numbers", p.unit, bounds(p)),
            };
            text += &format!("  {:<28} {} [{range}]\n", p.name, p.meaning);
        }
    }
    text
}

/// Formats the bounds of a parameter, or of each entry of a list, for the C header and the parameter page of the book.
/// The setter enforces these bounds.
pub fn bounds(p: &Parameter) -> String {
    format!("{} to {}", short(p.low), short(p.high))
}

/// Formats a number with an exponent only outside of 1e-3 to 1e5.
pub fn short(number: f64) -> String {
    let magnitude = number.abs();
    if magnitude != 0.0 && !(1e-3..1e5).contains(&magnitude) { format!("{number:e}") } else { number.to_string() }
}
