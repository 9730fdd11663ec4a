//! XML property files of Adams Car: root element `afc` with bibliography, units and the damper. They can represent a gas force.

use super::units::{self, Units};
use super::{Curve, Properties, row};
use anyhow::{Context as _, bail};
use roxmltree::{Document, Node};
use std::fmt::Write as _;

/// Writes the properties as a file in mm, s and N.
pub fn write(properties: &Properties) -> String {
    let mut rows = String::new();
    for (v, f) in properties.curve.velocities.iter().zip(&properties.curve.forces) {
        let _ = writeln!(rows, "        {:?} {f:?}", 1e3 * v);
    }
    let notes: String = properties.notes.iter().map(|note| format!("  <!-- {} -->\n", apart(note))).collect();
    let gas = properties.gas_force;
    include_str!("../templates/damper.xml")
        .replace("{version}", env!("CARGO_PKG_VERSION"))
        .replace("{rows}", rows.trim_end())
        .replace("{gas_method}", if gas == 0.0 { "none" } else { "constant" })
        .replace("{gas_force}", &format!("{gas:?}"))
        // The notes are inserted last, because a note may contain any text, including a placeholder.
        .replace("{notes}", &notes)
}

/// Separates consecutive hyphens in a note, because they would end the comment.
fn apart(note: &str) -> String {
    let mut out = super::as_comment(note);
    while out.contains("--") {
        out = out.replace("--", "- -");
    }
    out
}

/// Reads a property file.
///
/// # Errors
/// The errors of [`super::read`].
pub fn read(text: &str) -> anyhow::Result<Properties> {
    let document = Document::parse(text)?;
    let file = File { document: &document, damper: find_damper(&document)?, units: units_of(&document)? };
    let mut notes = file.describe_unknown();
    let (curve, linear) = file.curve()?;
    let gas_force = file.gas_force(&mut notes)?;
    Ok(Properties { curve, linear, gas_force, notes })
}

/// Returns the line of a node, from 1.
fn line(document: &Document, node: &Node) -> usize {
    document.text_pos_at(node.range().start).row as usize
}

/// Finds the only damper of a document.
fn find_damper<'a>(document: &'a Document<'a>) -> anyhow::Result<Node<'a, 'a>> {
    let is_damper = |n: &Node| n.is_element() && ["DamperProperties", "StrutProperties"].contains(&n.tag_name().name());
    let dampers: Vec<Node> = document.descendants().filter(is_damper).collect();
    match dampers[..] {
        [damper] => Ok(damper),
        [] => {
            let root = document.root_element().tag_name().name().to_owned();
            let held: Vec<&str> = document
                .descendants()
                .filter_map(|n| n.is_element().then(|| n.tag_name().name()).filter(|n| n.ends_with("Properties")))
                .collect();
            bail!(
                "this is no damper: there is neither DamperProperties nor StrutProperties in <{root}>{}",
                if held.is_empty() { String::new() } else { format!(", but {}", held.join(", ")) }
            )
        }
        // A file with several dampers describes a whole vehicle, such as the send file of VI-CarRealTime.
        _ => {
            let lines: Vec<String> = dampers.iter().map(|d| line(document, d).to_string()).collect();
            bail!(
                "there are {} dampers in it, at lines {}, and which is meant is not known; give the damper's own property file",
                dampers.len(),
                lines.join(", ")
            )
        }
    }
}

/// Reads the units of a document.
fn units_of(document: &Document) -> anyhow::Result<Units> {
    let setting = |name: &str| {
        document.descendants().find(|n| n.tag_name().name() == "UnitSetting" && n.attribute("name") == Some(name))
    };
    let unit = |name: &str, factor: fn(&str) -> anyhow::Result<f64>| {
        let node = setting(name).with_context(|| format!("its units lack {name}"))?;
        let at = || format!("line {}", line(document, &node));
        factor(node.attribute("current").unwrap_or_default()).with_context(at)
    };
    Ok(Units {
        length: unit("length", units::length)?,
        time: unit("time", units::time)?,
        force: unit("force", units::force)?,
    })
}

/// Property file with its damper.
struct File<'a> {
    document: &'a Document<'a>,
    damper: Node<'a, 'a>,
    units: Units,
}

impl<'a> File<'a> {
    /// Returns the line of the damper.
    fn line(&self) -> usize {
        line(self.document, &self.damper)
    }

    /// Describes the attributes and elements of the damper that have no counterpart in the properties.
    fn describe_unknown(&self) -> Vec<String> {
        const ATTRIBUTES: [&str; 8] = [
            "active",
            "definition",
            "userDefined",
            "method",
            "dampingMethod",
            "rate",
            "gasPreloadMethod",
            "gasPreloadConstant",
        ];
        let attributes = self.damper.attributes().filter(|attribute| !ATTRIBUTES.contains(&attribute.name()));
        let mut notes: Vec<String> =
            attributes.map(|attribute| format!("{} = {}", attribute.name(), attribute.value())).collect();
        for other in self.damper.children().filter(Node::is_element) {
            let name = other.attribute("name").unwrap_or_default();
            if other.tag_name().name() != "Spline" || !["spline_data", "gasPreloadForceCurve"].contains(&name) {
                notes.push(format!("<{}> {name}", other.tag_name().name()));
            }
        }
        notes
    }

    /// Reads a number from an attribute of the damper, 0 if it is missing.
    fn number(&self, name: &str) -> anyhow::Result<f64> {
        let text = self.damper.attribute(name).unwrap_or("0").trim();
        let value = text.parse::<f64>().ok().filter(|n| n.is_finite());
        value.with_context(|| format!("line {}: {name} = \"{text}\" is no number", self.line()))
    }

    fn spline(&self, name: &str) -> anyhow::Result<Node<'a, 'a>> {
        let is_it = |n: &Node| n.tag_name().name() == "Spline" && n.attribute("name") == Some(name);
        let found = self.damper.children().find(is_it);
        found.with_context(|| format!("line {}: no Spline named {name}", self.line()))
    }

    /// Reads the FV curve, and whether it is interpolated linearly.
    fn curve(&self) -> anyhow::Result<(Curve, bool)> {
        // Files contain the attribute `dampingMethod` or the older attribute `method`. If a file has both, `dampingMethod` takes
        // precedence.
        let method = self.damper.attribute("dampingMethod").or(self.damper.attribute("method"));
        match method.unwrap_or("non_linear") {
            "linear" => {
                let units = &self.units;
                let rate = self.number("rate")? * units.force * units.time / units.length;
                if !(rate > 0.0) {
                    bail!("line {}: a linear damper needs a rate above 0", self.line());
                }
                // The curve is extrapolated linearly beyond its points, so any velocities suffice.
                Ok((Curve { velocities: vec![-1.0, 0.0, 1.0], forces: vec![-rate, 0.0, rate] }, true))
            }
            "non_linear" => {
                let node = self.spline("spline_data")?;
                let mut curve = table(self.document, &node, &self.units, true)?;
                if curve.velocities.len() < 2 {
                    bail!("line {}: spline_data has fewer than two rows", line(self.document, &node));
                }
                curve.velocities.shrink_to_fit();
                Ok((curve, node.attribute("interpolation_method") == Some("linear")))
            }
            other => bail!("line {}: dampingMethod \"{other}\" is not known (linear, non_linear)", self.line()),
        }
    }

    /// Reads the gas force, N. Adds a note if the force of the file changes with the length.
    fn gas_force(&self, notes: &mut Vec<String>) -> anyhow::Result<f64> {
        match self.damper.attribute("gasPreloadMethod").unwrap_or("none") {
            "none" => Ok(0.0),
            "constant" => Ok(self.number("gasPreloadConstant")? * self.units.force),
            "non_linear" => {
                let node = self.spline("gasPreloadForceCurve")?;
                let gas = table(self.document, &node, &self.units, false)?;
                let at = gas.velocities.iter().position(|x| *x >= 0.0).unwrap_or(0);
                let Some(force) = gas.forces.get(at) else {
                    bail!("line {}: gasPreloadForceCurve has no row", line(self.document, &node));
                };
                if gas.forces.iter().any(|f| f != force) {
                    notes.push(format!(
                        "how the gas force changes with length, {:?} to {:?} N (it is taken as {force:?} N throughout, its value at 0; \
                         give gas_spring a stiffness for the rest)",
                        gas.forces[0],
                        gas.forces[gas.forces.len() - 1]
                    ));
                }
                Ok(*force)
            }
            other => {
                bail!("line {}: gasPreloadMethod \"{other}\" is not known (none, constant, non_linear)", self.line())
            }
        }
    }
}

/// Reads the rows of a spline, and converts them to SI units. Its abscissa is a velocity if `over_velocity` is set, and a length otherwise.
fn table(document: &Document, node: &Node, units: &Units, over_velocity: bool) -> anyhow::Result<Curve> {
    let first = document.text_pos_at(node.range().start).row as usize;
    // A spline may have its own units, which replace the units of the file.
    let own = |name: &str| node.attribute(name).map(str::trim).filter(|u| !u.is_empty());
    let mut units = *units;
    let at = || format!("line {first}");
    if let Some(unit) = own("xUnit") {
        let (length, time) = unit.split_once('/').unwrap_or((unit, ""));
        units.length = units::length(length.trim()).with_context(at)?;
        if !time.is_empty() {
            units.time = units::time(time.trim()).with_context(at)?;
        }
    }
    if let Some(unit) = own("yUnit") {
        units.force = units::force(unit).with_context(at)?;
    }
    let mut rows = Vec::new();
    for part in node.children().filter(Node::is_text) {
        let from = document.text_pos_at(part.range().start).row as usize;
        for (i, line) in part.text().unwrap_or_default().lines().enumerate() {
            if !line.trim().is_empty() {
                let [x, y] = row(line.trim(), from + i, "the spline")?;
                let x = if over_velocity { units.velocity(x) } else { units.metres(x) };
                rows.push(([x, y * units.force], from + i));
            }
        }
    }
    super::curve(rows, over_velocity)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n\
        <afc xmlns=\"http://www.mscsoftware.com/:vfc\" xmlns:afc=\"http://www.mscsoftware.com/:afc\">\n\
        <afc:Bibliography>\n<Revision version=\"2\" />\n</afc:Bibliography>\n<afc:Units>\n\
        <afc:UnitSetting name=\"force\" current=\"newton\" />\n<afc:UnitSetting\n name=\"length\"\n current=\"mm\"\n/>\n\
        <afc:UnitSetting name=\"time\" current=\"second\" />\n</afc:Units>\n\
        <DamperProperties active=\"true\" method=\"non_linear\" upperDiameter=\"60\" rate=\"0.5\" dampingMethod=\"non_linear\" \
        gasPreloadMethod=\"non_linear\" gasPreloadConstant=\"1000\">\n\
        <Spline name=\"spline_data\" interpolation_method=\"akima\">\n<![CDATA[\n -1270  -1495.5\n 0 0\n 254   1423.4\n]]>\n</Spline>\n\
        <Spline name=\"gasPreloadForceCurve\">\n<![CDATA[\n 0 2000\n 500 1000\n]]>\n</Spline>\n</DamperProperties>\n</afc>\n";

    #[test]
    fn a_file_like_those_of_the_program() {
        let read_it = read(FILE).unwrap();
        assert_eq!(read_it.curve.velocities, [-1.27, 0.0, 0.254]);
        assert_eq!(read_it.gas_force, 2000.0);
        assert_eq!(read_it.notes.len(), 2, "{:?}", read_it.notes);
        let linear = read(&FILE.replace("dampingMethod=\"non_linear\"", "dampingMethod=\"linear\"")).unwrap();
        assert_eq!((linear.curve.forces[2], linear.linear), (500.0, true));
        let constant = read(&FILE.replace("\"non_linear\" gasPreloadC", "\"constant\" gasPreloadC")).unwrap();
        assert_eq!((constant.gas_force, constant.notes.len()), (1000.0, 1));
        let own = read(&FILE.replace("\"akima\"", "\"akima\" xUnit=\"m/sec\" yUnit=\"kN\"")).unwrap();
        assert_eq!((own.curve.velocities[2], own.curve.forces[2]), (254.0, 1_423_400.0));
    }

    #[test]
    fn a_file_of_a_whole_vehicle_is_refused() {
        let begin = FILE.find("<DamperProperties").unwrap();
        let end = FILE.rfind("</afc>").unwrap();
        let twice = FILE.replacen("</afc>", &format!("{}</afc>", &FILE[begin..end]), 1);
        let error = format!("{:#}", read(&twice).unwrap_err());
        assert!(error.contains("2 dampers in it, at lines 14, 29"), "{error}");
    }

    #[test]
    fn a_bad_file_is_refused_in_words() {
        for (from, to, word) in [
            ("254   1423.4", "254   x", "line 19"),
            ("254   1423.4", "-9   1423.4", "out of order"),
            ("\"mm\"", "\"cubit\"", "line 8"),
            ("name=\"time\"", "name=\"tide\"", "lack time"),
            ("DamperProperties", "SpringProperties", "SpringProperties"),
            ("spline_data", "spline", "spline_data"),
            ("gasPreloadMethod=\"non_linear\"", "gasPreloadMethod=\"magic\"", "magic"),
            ("</afc>", "", "never closed"),
        ] {
            assert!(FILE.contains(from));
            let error = format!("{:#}", read(&FILE.replace(from, to)).unwrap_err());
            assert!(error.to_lowercase().contains(&word.to_lowercase()), "{word}: {error}");
        }
    }
}
