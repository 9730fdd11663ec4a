//! The variables of a damper FMU, in the order of their value references.

use dashpot_core::elements::{self, GROUPS};
use dashpot_core::parameter::{self, Parameter, Shape};
use dashpot_core::{Params, State};

/// Numbers of a corner's state that a solver integrates: all but the velocity of the last step.
pub const STATES: usize = size_of::<State>() / size_of::<f64>() - 1;

/// What a variable is; the names are those of `enum kind` in the FMU's sources.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Kind {
    Time,
    Displacement,
    Velocity,
    SideForce,
    Temperature,
    Force,
    ForceByDisplacement,
    ForceByVelocity,
    Status,
    MotionScale,
    ForceScale,
    DisplacementGiven,
    InitialPosition,
    State,
    Rate,
    Parameter,
    Choice,
}

impl Kind {
    /// The name in C.
    pub fn c(self) -> String {
        let mut name = String::new();
        for c in format!("{self:?}").chars() {
            if c.is_uppercase() && !name.is_empty() {
                name.push('_');
            }
            name.push(c.to_ascii_uppercase());
        }
        name
    }

    /// Whether it is an output.
    pub fn is_output(self) -> bool {
        matches!(self, Kind::Force | Kind::ForceByDisplacement | Kind::ForceByVelocity | Kind::Status)
    }

    /// Whether it is an input.
    pub fn is_input(self) -> bool {
        matches!(self, Kind::Displacement | Kind::Velocity | Kind::SideForce | Kind::Temperature)
    }
}

/// One variable.
pub struct Variable {
    /// What it is.
    pub kind: Kind,
    /// Its corner; none for the time.
    pub corner: Option<usize>,
    /// Its number among the states, or in the list of a parameter.
    pub index: Option<usize>,
    /// Its name in the FMU.
    pub name: String,
    /// The row it comes from.
    pub parameter: Option<&'static Parameter>,
    /// Start value, where it has one.
    pub start: Option<f64>,
    /// Unit; "-" for a pure number.
    pub unit: &'static str,
    /// One sentence.
    pub meaning: String,
}

/// How host and damper count motion and force.
#[derive(Clone, Copy)]
pub struct Scales {
    /// Damper extension per unit of the host's displacement.
    pub motion: f64,
    /// The host's force per N of tension.
    pub force: f64,
}

const CORNERS: [&str; 4] = ["L1", "R1", "L2", "R2"];

/// All variables of an FMU with these corners.
pub fn variables(corners: &[Params], scales: Scales) -> Vec<Variable> {
    let mut all = vec![Variable {
        kind: Kind::Time,
        corner: None,
        index: None,
        name: "time".into(),
        parameter: None,
        start: None,
        unit: "s",
        meaning: "time".into(),
    }];
    let four = corners.len() > 1;
    for c in 0..corners.len() {
        all.extend(fixed_block(c, four, scales));
    }
    for c in 0..corners.len() {
        all.extend(states(c, four));
    }
    for (c, params) in corners.iter().enumerate() {
        all.extend(parameters(c, four, params));
    }
    all
}

fn prefix(corner: usize, four: bool) -> String {
    if four { format!("{}.", CORNERS[corner]) } else { String::new() }
}

fn fixed_block(corner: usize, four: bool, scales: Scales) -> Vec<Variable> {
    let in_out = |one: &str, many: &str| if four { format!("{many}_{}", CORNERS[corner]) } else { one.to_owned() };
    let inner = |name: &str| prefix(corner, four) + name;
    let sign =
        |scale: f64, positive: &'static str, negative: &'static str| if scale > 0.0 { positive } else { negative };
    let motion = sign(scales.motion, "extension positive", "compression positive");
    let force = sign(scales.force, "tension positive", "push positive");
    let rows: [(Kind, String, Option<f64>, &'static str, String); 12] = [
        (
            Kind::Displacement,
            in_out("displacement", "Damper_Jounce"),
            Some(0.0),
            "m",
            format!("displacement of the damper, {motion}"),
        ),
        (Kind::Velocity, in_out("velocity", "Damper_Jounce_Rate"), Some(0.0), "m/s", format!("its velocity, {motion}")),
        (Kind::SideForce, in_out("side_force", "Damper_Side_Force"), Some(0.0), "N", "side force on the rod".into()),
        (
            Kind::Temperature,
            in_out("temperature", "Damper_Temperature"),
            Some(20.0),
            "degC",
            "temperature of the damper".into(),
        ),
        (Kind::Force, in_out("force", "Damper_Force"), None, "N", format!("damper force, {force}")),
        (
            Kind::ForceByDisplacement,
            in_out("force_by_displacement", "Damper_Force_by_Jounce"),
            None,
            "N/m",
            "change of force per change of displacement".into(),
        ),
        (
            Kind::ForceByVelocity,
            in_out("force_by_velocity", "Damper_Force_by_Jounce_Rate"),
            None,
            "N s/m",
            "change of force per change of velocity".into(),
        ),
        (
            Kind::Status,
            in_out("status", "Damper_Status"),
            None,
            "-",
            "0, warning bits of dashpot.h (1: faster than the identified curve), or 65536: input refused, force held"
                .into(),
        ),
        (
            Kind::MotionScale,
            inner("motion_scale"),
            Some(scales.motion),
            "-",
            "m of damper extension per unit of displacement: sign, unit and motion ratio".into(),
        ),
        (
            Kind::ForceScale,
            inner("force_scale"),
            Some(scales.force),
            "-",
            "force per N of damper tension: sign, unit and motion ratio".into(),
        ),
        (
            Kind::DisplacementGiven,
            inner("displacement_given"),
            Some(1.0),
            "-",
            "true: the displacement is an input; false: it is integrated from initial_position".into(),
        ),
        (
            Kind::InitialPosition,
            inner("initial_position"),
            Some(0.0),
            "m",
            "extension at the start, where the displacement is not given".into(),
        ),
    ];
    rows.into_iter()
        .map(|(kind, name, start, unit, meaning)| Variable {
            kind,
            corner: Some(corner),
            index: None,
            name,
            parameter: None,
            start,
            unit,
            meaning,
        })
        .collect()
}

fn states(corner: usize, four: bool) -> Vec<Variable> {
    let name = |k: usize| match k {
        0 => "travel".to_owned(),
        1 => "mass_displacement".to_owned(),
        2 => "mass_velocity".to_owned(),
        _ => format!("memory[{}]", k - 2),
    };
    let meaning = |k: usize| match k {
        0 => "displacement integrated from the velocity; at rest where the displacement is given".to_owned(),
        1 => "displacement of the internal mass".to_owned(),
        2 => "velocity of the internal mass".to_owned(),
        _ => format!("private state {} of the elements; at rest where no element has it", k - 2),
    };
    let one = |k: usize, rate: bool| Variable {
        kind: if rate { Kind::Rate } else { Kind::State },
        corner: Some(corner),
        index: Some(k),
        name: {
            let state = prefix(corner, four) + &name(k);
            if rate { format!("der({state})") } else { state }
        },
        parameter: None,
        start: None,
        unit: match (k, rate) {
            (0 | 1, false) => "m",
            (0 | 1, true) | (2, false) => "m/s",
            (2, true) => "m/s^2",
            _ => "-",
        },
        meaning: if rate { format!("rate of {}", name(k)) } else { meaning(k) },
    };
    (0..STATES).map(|k| one(k, false)).chain((0..STATES).map(|k| one(k, true))).collect()
}

/// The parameters of the elements that are on.
fn parameters(corner: usize, four: bool, params: &Params) -> Vec<Variable> {
    let mut all = Vec::new();
    for row in parameter::table() {
        if row.group < elements::COUNT && !params.is_on(GROUPS[row.group].name) {
            continue;
        }
        let p = row.parameter;
        let values = params.get(&row);
        for (k, value) in values.iter().enumerate() {
            let list = matches!(p.shape, Shape::List(_));
            let name = prefix(corner, four) + p.name;
            all.push(Variable {
                kind: if matches!(p.shape, Shape::Choice(_)) { Kind::Choice } else { Kind::Parameter },
                corner: Some(corner),
                index: list.then_some(k),
                name: if list { format!("{name}[{}]", k + 1) } else { name },
                parameter: Some(p),
                start: Some(*value),
                unit: p.unit,
                meaning: p.meaning.to_owned(),
            });
        }
    }
    all
}
