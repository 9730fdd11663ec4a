//! The file `modelDescription.xml`, for FMI 2.0 and 3.0.

use super::sources::Version;
use super::units::Unit;
use super::variables::{BETWEEN_POINTS, Kind, Variable};
use dashpot_core::parameter::Shape;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Model identifier in the description, which is also the file name of the binaries.
pub const IDENTIFIER: &str = "dashpot_damper";

/// Writes the description of an FMU with these variables. `name` is the name of the model. `sources` are the names of the files that an
/// importer compiles.
pub fn description(version: Version, variables: &[Variable], guid: &str, name: &str, sources: &[String]) -> String {
    let name = escaped(name);
    let generator = concat!("dashpot ", env!("CARGO_PKG_VERSION"));
    let attributes = "canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\"";
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let about = "automotive suspension damper with hysteresis and friction, identified from rig records";
    match version {
        Version::Two => {
            let attributes = attributes.replace("FMUState", "FMUstate");
            let files: String = sources.iter().map(|s| format!("      <File name=\"{}\"/>\n", escaped(s))).collect();
            let files = if files.is_empty() {
                String::new()
            } else {
                format!("\n    <SourceFiles>\n{files}    </SourceFiles>\n  ")
            };
            let corners = variables.iter().filter(|v| v.kind == Kind::SpeedMargin).count();
            let _ = write!(
                out,
                "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"{name}\" guid=\"{guid}\" description=\"{about}\" \
                 generationTool=\"{generator}\" variableNamingConvention=\"structured\" numberOfEventIndicators=\"{corners}\">\n  \
                 <ModelExchange modelIdentifier=\"{IDENTIFIER}\" completedIntegratorStepNotNeeded=\"true\" {attributes} \
                 providesDirectionalDerivative=\"true\">{files}</ModelExchange>\n  \
                 <CoSimulation modelIdentifier=\"{IDENTIFIER}\" canHandleVariableCommunicationStepSize=\"true\" \
                 canInterpolateInputs=\"true\" {attributes} providesDirectionalDerivative=\"true\">{files}</CoSimulation>\n"
            );
        }
        Version::Three => {
            let _ = write!(
                out,
                "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{name}\" instantiationToken=\"{guid}\" \
                 description=\"{about}\" generationTool=\"{generator}\" variableNamingConvention=\"structured\">\n  \
                 <ModelExchange modelIdentifier=\"{IDENTIFIER}\" {attributes} providesDirectionalDerivatives=\"true\" \
                 providesAdjointDerivatives=\"true\"/>\n  \
                 <CoSimulation modelIdentifier=\"{IDENTIFIER}\" canHandleVariableCommunicationStepSize=\"true\" {attributes} \
                 providesDirectionalDerivatives=\"true\" providesAdjointDerivatives=\"true\"/>\n"
            );
        }
    }
    units(&mut out, variables);
    types(&mut out, variables, version);
    out.push_str(
        "  <LogCategories>\n    <Category name=\"logStatusWarning\"/>\n    <Category name=\"logStatusError\"/>\n  \
         </LogCategories>\n  <DefaultExperiment startTime=\"0\" stopTime=\"1\" stepSize=\"0.001\"/>\n  <ModelVariables>\n",
    );
    // FMI 2.0 needs no variable for the time. The FMI Library, which many hosts use, rejects such a variable, because the library requires
    // a start value that the standard forbids. Without the time, the index of every variable, counted from 1, equals its value reference.
    let is_described = |v: &Variable| version == Version::Three || v.kind != Kind::Time;
    for (reference, v) in variables.iter().enumerate().filter(|(_, v)| is_described(v)) {
        variable(&mut out, version, variables, reference, v);
    }
    out.push_str("  </ModelVariables>\n");
    structure(&mut out, version, variables);
    out.push_str("</fmiModelDescription>\n");
    out
}

fn escaped(text: &str) -> String {
    // XML cannot represent control characters, even in escaped form.
    let text = text.replace(char::is_control, " ");
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn units(out: &mut String, variables: &[Variable]) {
    let used: BTreeMap<&str, &Unit> =
        variables.iter().map(|v| &v.unit).filter(|u| u.is_declared()).map(|u| (u.name.as_str(), u)).collect();
    out.push_str("  <UnitDefinitions>\n");
    for (name, unit) in used {
        let name = escaped(name);
        let factor = if unit.factor == 1.0 { String::new() } else { format!(" factor=\"{:?}\"", unit.factor) };
        let _ = match unit.dimensions() {
            Some(exponents) => {
                writeln!(out, "    <Unit name=\"{name}\">\n      <BaseUnit {exponents}{factor}/>\n    </Unit>")
            }
            None => writeln!(out, "    <Unit name=\"{name}\"/>"),
        };
    }
    out.push_str("  </UnitDefinitions>\n");
}

fn choices(variables: &[Variable]) -> Vec<(&'static str, &'static [&'static str])> {
    let mut found: Vec<(&str, &[&str])> = vec![("inputs_between_points", &BETWEEN_POINTS)];
    for p in variables.iter().filter_map(|v| v.parameter) {
        if let Shape::Choice(words) = p.shape {
            if !found.iter().any(|(name, _)| *name == p.name) {
                found.push((p.name, words));
            }
        }
    }
    found
}

fn types(out: &mut String, variables: &[Variable], version: Version) {
    let choices = choices(variables);
    out.push_str("  <TypeDefinitions>\n");
    for (name, words) in choices {
        let (open, close) = match version {
            Version::Two => (
                format!("<SimpleType name=\"{name}_type\">\n      <Enumeration>"),
                "</Enumeration>\n    </SimpleType>".to_owned(),
            ),
            Version::Three => (format!("<EnumerationType name=\"{name}_type\">"), "</EnumerationType>".to_owned()),
        };
        let _ = writeln!(out, "    {open}");
        for (value, word) in words.iter().enumerate() {
            let _ = writeln!(out, "      <Item name=\"{word}\" value=\"{value}\"/>");
        }
        let _ = writeln!(out, "    {close}");
    }
    out.push_str("  </TypeDefinitions>\n");
}

fn variable(out: &mut String, version: Version, all: &[Variable], reference: usize, v: &Variable) {
    let (causality, variability, initial) = match v.kind {
        Kind::Time => ("independent", "continuous", None),
        k if k.is_input() => ("input", "continuous", None),
        Kind::Status => ("output", "discrete", Some("calculated")),
        k if k.is_output() => ("output", "continuous", Some("calculated")),
        Kind::State | Kind::Rate | Kind::SpeedMargin => ("local", "continuous", Some("calculated")),
        Kind::Parameter => ("parameter", "tunable", Some("exact")),
        _ => ("parameter", "fixed", Some("exact")),
    };
    let initial = initial.map_or(String::new(), |i| format!(" initial=\"{i}\""));
    let common = format!(
        "name=\"{}\" valueReference=\"{reference}\" causality=\"{causality}\" variability=\"{variability}\"{initial} \
         description=\"{}\"",
        escaped(&v.name),
        escaped(&v.meaning)
    );
    let mut typed = String::new();
    let tag = match v.kind {
        Kind::Status => "Integer",
        Kind::HasDisplacement => "Boolean",
        Kind::Choice | Kind::BetweenPoints => "Enumeration",
        _ => "Real",
    };
    if v.unit.is_declared() && tag == "Real" {
        let _ = write!(typed, " unit=\"{}\"", escaped(&v.unit.name));
    }
    if let Some(p) = v.parameter {
        if tag == "Real" {
            let _ = write!(typed, " min=\"{:?}\" max=\"{:?}\"", p.low, p.high);
        } else {
            let _ = write!(typed, " declaredType=\"{}_type\"", p.name);
        }
    }
    if v.kind == Kind::BetweenPoints {
        typed.push_str(" declaredType=\"inputs_between_points_type\"");
    }
    if let Some(nominal) = v.nominal {
        let _ = write!(typed, " nominal=\"{nominal:?}\"");
    }
    if v.kind == Kind::Rate {
        let state = all.iter().position(|s| s.kind == Kind::State && (s.corner, s.index) == (v.corner, v.index));
        let _ = write!(typed, " derivative=\"{}\"", state.unwrap_or(0));
    }
    if let Some(start) = v.start {
        let _ = match tag {
            "Boolean" => write!(typed, " start=\"{}\"", start != 0.0),
            "Enumeration" => write!(typed, " start=\"{start:.0}\""),
            _ => write!(typed, " start=\"{start:?}\""),
        };
    }
    let _ = match version {
        Version::Two => {
            writeln!(out, "    <ScalarVariable {common}>\n      <{tag}{typed}/>\n    </ScalarVariable>")
        }
        Version::Three => {
            let tag = match tag {
                "Real" => "Float64",
                "Integer" => "Int32",
                other => other,
            };
            writeln!(out, "    <{tag} {common}{typed}/>")
        }
    };
}

/// Lists the variables on which an output or a state derivative `v` depends: the inputs and states of its corner, which is one damper.
fn dependencies(all: &[Variable], v: &Variable) -> String {
    let on: Vec<String> = all
        .iter()
        .enumerate()
        .filter(|(_, d)| d.corner == v.corner && (d.kind.is_input() || d.kind == Kind::State))
        .map(|(i, _)| i.to_string())
        .collect();
    on.join(" ")
}

fn structure(out: &mut String, version: Version, all: &[Variable]) {
    let two = version == Version::Two;
    let unknown = |out: &mut String, tag: &str, i: usize, depends: bool| {
        let key = if two { "index" } else { "valueReference" };
        let depends = if depends { format!(" dependencies=\"{}\"", dependencies(all, &all[i])) } else { String::new() };
        let _ = writeln!(out, "    <{tag} {key}=\"{i}\"{depends}/>");
    };
    let group = |out: &mut String, name: &str, tag: &str, depends: bool, of: &dyn Fn(Kind) -> bool| {
        if two {
            let _ = writeln!(out, "    <{name}>");
        }
        for (i, _) in all.iter().enumerate().filter(|(_, v)| of(v.kind)) {
            unknown(out, if two { "Unknown" } else { tag }, i, depends);
        }
        if two {
            let _ = writeln!(out, "    </{name}>");
        }
    };
    out.push_str("  <ModelStructure>\n");
    group(out, "Outputs", "Output", true, &Kind::is_output);
    group(out, "Derivatives", "ContinuousStateDerivative", true, &|k| k == Kind::Rate);
    group(out, "InitialUnknowns", "InitialUnknown", false, &|k| k.is_output() || matches!(k, Kind::State | Kind::Rate));
    if !two {
        group(out, "", "EventIndicator", false, &|k| k == Kind::SpeedMargin);
    }
    out.push_str("  </ModelStructure>\n");
}

/// Writes `sources/buildDescription.xml` of FMI 3.0. The kernel in `sources` is an object file for one platform.
pub fn build_description(platform: &str, sources: &[String]) -> String {
    let files: String = sources.iter().map(|s| format!("      <SourceFile name=\"{}\"/>\n", escaped(s))).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">\n  \
         <BuildConfiguration modelIdentifier=\"{IDENTIFIER}\" platform=\"{platform}\" description=\"the kernel in lib is compiled for \
         {platform}; for any other platform run build.sh\">\n    <SourceFileSet language=\"C99\">\n{files}    </SourceFileSet>\n  \
         </BuildConfiguration>\n</fmiBuildDescription>\n"
    )
}
