//! Variables of a damper FMU, in the order of their value references.

use super::scales::Scales;
use super::units::{HostUnits, Unit};
use dashpot_core::family::{Definition, Delay, Family};
use dashpot_core::parameter::{self, Number, Parameter, Shape};
use dashpot_core::{Input, Model, Output, Params, list, step};

/// Indices of the states of a corner, which is one damper. The C sources of the FMU use the same indices.
const TRAVEL: usize = 0;
const DEFLECTION: usize = 1;
const MASS_VELOCITY: usize = 2;
const FIRST_INTERNAL: usize = 3;

/// Choices for the inputs between two communication points. The index of a choice is its value in the C sources of the FMU.
pub const BETWEEN_POINTS: [&str; 3] = ["automatic", "hold", "extrapolate"];

/// Instant at which the importer sets the inputs of a co-simulation step. It determines the start value of `inputs_between_points`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Inputs {
    /// Unspecified: zero-order hold in co-simulation, extrapolation in model exchange.
    #[default]
    Unspecified,
    /// The inputs belong to the beginning of the step. The FMU extrapolates to the end.
    Begin,
    /// The inputs belong to the end of the step.
    End,
}

impl Inputs {
    /// Returns the start value, an index of [`BETWEEN_POINTS`]: `extrapolate` for inputs at the beginning of a step, otherwise `automatic`.
    /// In co-simulation, `automatic` is a zero-order hold, as inputs at the end of a step need.
    pub fn start_value(self) -> f64 {
        if self == Inputs::Begin { 2.0 } else { 0.0 }
    }
}

/// Kind of a variable. The names correspond to those of `enum kind` in the C sources of the FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Kind {
    Time,
    Displacement,
    Velocity,
    SideForce,
    Temperature,
    Force,
    DForceDDisplacement,
    DForceDVelocity,
    Status,
    MotionScale,
    ForceScale,
    PositionOffset,
    HasDisplacement,
    InitialPosition,
    SpeedMargin,
    BetweenPoints,
    Setting,
    State,
    Rate,
    Parameter,
    Choice,
}

impl Kind {
    /// Returns the name of the kind in C.
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

    /// Returns whether the variable is an output.
    pub fn is_output(self) -> bool {
        matches!(self, Kind::Force | Kind::DForceDDisplacement | Kind::DForceDVelocity | Kind::Status)
    }

    /// Returns whether the variable is an input.
    pub fn is_input(self) -> bool {
        matches!(self, Kind::Displacement | Kind::Velocity | Kind::SideForce | Kind::Temperature | Kind::Setting)
    }
}

/// One variable of an FMU.
pub struct Variable {
    /// Kind of the variable.
    pub kind: Kind,
    /// Index of the corner, or `None` for a variable of the whole FMU, such as the time.
    pub corner: Option<usize>,
    /// Index of a state among the states of its corner, or of an element in the list of a parameter.
    pub index: Option<usize>,
    /// Name in the FMU.
    pub name: String,
    /// Row of the parameter table, for a parameter of the model.
    pub parameter: Option<&'static Parameter>,
    /// Start value, if any.
    pub start: Option<f64>,
    /// Unit. Its name is "-" for a pure number, and if the host's unit has no name.
    pub unit: Unit,
    /// Description for `modelDescription.xml` and the documentation page.
    pub meaning: String,
    /// Nominal value of a state.
    pub nominal: Option<f64>,
}

const CORNERS: [&str; 4] = ["L1", "R1", "L2", "R2"];

/// Returns the file name of a corner's model in the resources of the FMU. The C sources of the FMU use the same name.
pub fn model_file_name(corner: usize, corners: usize) -> String {
    if corners == 1 { "model.toml".into() } else { format!("model_{}.toml", CORNERS[corner]) }
}

/// Returns all variables of an FMU with these corners.
pub fn variables(corners: &[Definition], scales: Scales, inputs: Inputs) -> Vec<Variable> {
    let mut all = vec![Variable {
        kind: Kind::Time,
        corner: None,
        index: None,
        name: "time".into(),
        parameter: None,
        start: None,
        unit: "s".into(),
        meaning: "time".into(),
        nominal: None,
    }];
    let four = corners.len() > 1;
    for c in 0..corners.len() {
        all.extend(fixed_block(c, four, scales));
    }
    all.push(Variable {
        kind: Kind::BetweenPoints,
        corner: None,
        index: None,
        name: "inputs_between_points".into(),
        parameter: None,
        start: Some(inputs.start_value()),
        unit: "-".into(),
        meaning: "inputs between two instants at which the importer sets them: constant (hold), extrapolated along the line through \
                  the last two, or automatic (constant in co-simulation, extrapolated in model exchange)"
            .into(),
        nominal: None,
    });
    for (c, damper) in corners.iter().enumerate() {
        all.extend(setting(c, four, damper));
    }
    for (c, damper) in corners.iter().enumerate() {
        all.extend(states(c, four, damper));
    }
    for (c, damper) in corners.iter().enumerate() {
        all.extend(parameters(c, four, damper));
    }
    all
}

/// Returns the input variable for the setting, or `None` for a damper without a setting.
fn setting(corner: usize, four: bool, damper: &Definition) -> Option<Variable> {
    let axis = &damper.axis;
    if !axis.is_some() {
        return None;
    }
    let (low, high) = axis.range();
    let unit = axis.unit();
    let of = if axis.name().is_empty() { "setting".to_owned() } else { format!("setting: {}", axis.name()) };
    let delays = if axis.actuator().dead_time > 0.0 {
        format!("; in model exchange behind the dead time of {:?} s", axis.actuator().dead_time)
    } else {
        String::new()
    };
    Some(Variable {
        kind: Kind::Setting,
        corner: Some(corner),
        index: None,
        name: if four { format!("Damper_Setting_{}", CORNERS[corner]) } else { "setting".into() },
        parameter: None,
        start: Some(axis.start()),
        unit: Unit::of_setting(unit),
        meaning: format!(
            "{of}, {low:?} to {high:?} {unit}; outside it is clamped, with warning bit 4 of the status{delays}"
        ),
        nominal: None,
    })
}

fn prefix(corner: usize, four: bool) -> String {
    if four { format!("{}.", CORNERS[corner]) } else { String::new() }
}

/// Variables that every corner has, independent of the elements of its damper.
struct FixedBlock {
    corner: usize,
    four: bool,
    scales: Scales,
    units: HostUnits,
}

/// Kind, name, start value, unit and description of a variable.
type BlockRow = (Kind, String, Option<f64>, Unit, String);

fn fixed_block(corner: usize, four: bool, scales: Scales) -> Vec<Variable> {
    let block = FixedBlock { corner, four, scales, units: HostUnits::from_scales(scales) };
    let rows = block.inputs().into_iter().chain(block.outputs()).chain(block.constants());
    rows.map(|(kind, name, start, unit, meaning)| Variable {
        kind,
        corner: Some(corner),
        index: None,
        name,
        parameter: None,
        start,
        unit,
        meaning,
        nominal: None,
    })
    .collect()
}

impl FixedBlock {
    /// Returns the name of an input or an output: `one` for a single damper, and `many` with its corner for a vehicle.
    fn in_out(&self, one: &str, many: &str) -> String {
        if self.four { format!("{many}_{}", CORNERS[self.corner]) } else { one.to_owned() }
    }

    /// Returns the name of a constant.
    fn inner(&self, name: &str) -> String {
        prefix(self.corner, self.four) + name
    }

    fn inputs(&self) -> [BlockRow; 4] {
        let motion = if self.scales.motion > 0.0 { "extension positive" } else { "compression positive" };
        let m = self.scales.motion.abs();
        let of_displacement = undeclared(&self.units.displacement(), format!("; 1 stands for {m:?} m of the damper"));
        let of_velocity = undeclared(&self.units.velocity(), format!("; 1 stands for {m:?} m/s of the damper"));
        [
            (
                Kind::Displacement,
                self.in_out("displacement", "Damper_Jounce"),
                Some(self.scales.start),
                self.units.displacement(),
                format!("displacement of the damper, {motion}{of_displacement}"),
            ),
            (
                Kind::Velocity,
                self.in_out("velocity", "Damper_Jounce_Rate"),
                Some(0.0),
                self.units.velocity(),
                format!("velocity of the damper, {motion}{of_velocity}"),
            ),
            (
                Kind::SideForce,
                self.in_out("side_force", "Damper_Side_Force"),
                Some(0.0),
                "N".into(),
                "side force on the rod".into(),
            ),
            (
                Kind::Temperature,
                self.in_out("temperature", "Damper_Temperature"),
                Some(20.0),
                "degC".into(),
                "temperature of the damper".into(),
            ),
        ]
    }

    fn outputs(&self) -> [BlockRow; 4] {
        let force = if self.scales.force > 0.0 { "tension positive" } else { "push positive" };
        let n = self.scales.force.abs();
        let of_force = undeclared(&self.units.force(), format!("; 1 N of the damper is {n:?} here"));
        [
            (Kind::Force, self.in_out("force", "Damper_Force"), None, self.units.force(), format!("damper force, {force}{of_force}")),
            (
                Kind::DForceDDisplacement,
                self.in_out("d_force_d_displacement", "Damper_Force_by_Jounce"),
                None,
                self.units.stiffness(),
                format!("partial derivative of the force with respect to the displacement{}", self.of_slope("N/m")),
            ),
            (
                Kind::DForceDVelocity,
                self.in_out("d_force_d_velocity", "Damper_Force_by_Jounce_Rate"),
                None,
                self.units.damping(),
                format!("partial derivative of the force with respect to the velocity{}", self.of_slope("N s/m")),
            ),
            (
                Kind::Status,
                self.in_out("status", "Damper_Status"),
                None,
                "-".into(),
                "0, warning bits of dashpot.h (1: faster than the identified curve), or 65536: input rejected, force unchanged"
                    .into(),
            ),
        ]
    }

    /// Describes the unit of a derivative of the force whose unit in SI is `si`.
    fn of_slope(&self, si: &str) -> String {
        let factor = self.scales.force * self.scales.motion;
        let words = format!(", both as they are counted here; 1 {si} of the damper is {factor:?} here");
        undeclared(&self.units.stiffness(), words)
    }

    fn constants(&self) -> [BlockRow; 6] {
        [
            (
                Kind::MotionScale,
                self.inner("motion_scale"),
                Some(self.scales.motion),
                "-".into(),
                "m of damper extension per unit of displacement: sign, unit and motion ratio; displacement and velocity are declared in the unit of its start value"
                    .into(),
            ),
            (
                Kind::ForceScale,
                self.inner("force_scale"),
                Some(self.scales.force),
                "-".into(),
                "force per N of damper tension: sign, unit and motion ratio; the force is declared in the unit of its start value"
                    .into(),
            ),
            (
                Kind::PositionOffset,
                self.inner("position_offset"),
                Some(self.scales.position_offset),
                "m".into(),
                "extension of the damper, from the rig's zero, where the importer's displacement is 0".into(),
            ),
            (
                Kind::HasDisplacement,
                self.inner("displacement_given"),
                Some(1.0),
                "-".into(),
                "true: the displacement is an input; false: it is integrated from initial_position".into(),
            ),
            (
                Kind::InitialPosition,
                self.inner("initial_position"),
                Some(0.0),
                "m".into(),
                "extension at the start, from the rig's zero, if the displacement is no input".into(),
            ),
            (
                Kind::SpeedMargin,
                self.inner("speed_margin"),
                None,
                "m/s".into(),
                "distance of the damper's velocity to the end of the identified curve; negative outside; 1 if the curve has no end"
                    .into(),
            ),
        ]
    }
}

/// Returns `words` if the FMU does not declare the unit, and an empty text otherwise. The description of the variable then states the
/// conversion factor.
fn undeclared(unit: &Unit, words: String) -> String {
    if unit.is_declared() { String::new() } else { words }
}

/// Returns the nominal values of the states. Each is the power of ten at or below the state's largest absolute value on a typical stroke.
///
/// Hosts multiply their relative tolerance by the nominal value. An internal state may be a length, a velocity, a force or a temperature,
/// so its magnitude is measured in a simulation.
fn usual(damper: &Definition) -> [f64; 11] {
    if damper.axis.is_some() { usual_of_family(damper) } else { usual_of(&damper.params) }
}

/// Returns the nominal values of the states of a damper that depends on a setting. The simulation starts at the setting for `None` and then
/// alternates every 0.1 s between both ends of the setting range.
fn usual_of_family(damper: &Definition) -> [f64; 11] {
    let mut family = Box::new(Family::OFF);
    if family.set(&damper.params, &damper.axis).is_err() {
        return [1e-4; 11];
    }
    let (low, high) = damper.axis.range();
    let mut state = family.steady_state(&motion(0.0), None);
    let (mut delay, mut largest) = (Delay::default(), [0.0_f64; 11]);
    for k in 1..=900 {
        let setting = if k / 100 % 2 == 0 { high } else { low };
        let mut output = Output::ZERO;
        family.step_in_place(
            &mut state,
            &mut delay,
            &motion(f64::from(k) * STEP),
            Some(setting),
            STEP,
            &mut output,
            false,
        );
        let moved = [state.displacement, state.mass_displacement - state.displacement, state.mass_velocity];
        for (most, now) in largest.iter_mut().zip(moved.iter().chain(&state.internal)) {
            *most = most.max(now.abs());
        }
    }
    decades(largest)
}

/// Time step of the simulation of the typical stroke, s.
const STEP: f64 = 1e-3;

/// Returns the motion of the typical stroke at time `t`, s.
fn motion(t: f64) -> Input {
    // The stroke is a sine with an amplitude of 25 mm and a peak velocity of 0.5 m/s. The simulation of 0.9 s has almost three cycles.
    const AMPLITUDE: f64 = 0.025;
    const SPEED: f64 = 0.5;
    let phase = SPEED / AMPLITUDE * t;
    Input::motion(-AMPLITUDE * libm::cos(phase), SPEED * libm::sin(phase))
}

/// Returns the power of ten at or below each value. A state that is at most 1e-9 during the stroke gets 1e-4.
fn decades(largest: [f64; 11]) -> [f64; 11] {
    largest.map(|most| if most > 1e-9 { decade(most) } else { 1e-4 })
}

fn usual_of(params: &Params) -> [f64; 11] {
    let mut largest = [0.0_f64; 11];
    if let Ok(model) = Model::new(params) {
        let mut state = model.steady_state(&motion(0.0));
        for k in 1..=900 {
            state = step(&model, &state, &motion(f64::from(k) * STEP), STEP).0;
            let moved = [state.displacement, state.mass_displacement - state.displacement, state.mass_velocity];
            for (most, now) in largest.iter_mut().zip(moved.iter().chain(&state.internal)) {
                *most = most.max(now.abs());
            }
        }
    }
    decades(largest)
}

fn states(corner: usize, four: bool, damper: &Definition) -> Vec<Variable> {
    let (usual, params) = (usual(damper), &damper.params);
    let actuator = damper.axis.actuator();
    let own = usize::from(actuator.has_lag()) + usize::from(actuator.has_hysteresis());
    // An invalid model gives (true, 0). These values have no effect, because such a model is rejected before the export.
    let (series, memories) =
        Model::new(params).map_or((true, 0), |m| (m.elements().has_series(), m.elements().memories() + own));
    let name = |k: usize| match k {
        TRAVEL => "travel".to_owned(),
        DEFLECTION => "deflection".to_owned(),
        MASS_VELOCITY => "mass_velocity".to_owned(),
        _ => format!("internal[{}]", k - FIRST_INTERNAL + 1),
    };
    let meaning = |k: usize| match k {
        TRAVEL => "displacement integrated from the velocity; constant if the displacement is an input".to_owned(),
        DEFLECTION => "displacement of the internal mass relative to the moving end".to_owned(),
        MASS_VELOCITY => "velocity of the internal mass".to_owned(),
        _ => format!("internal state {} of the elements", k - FIRST_INTERNAL + 1),
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
            (TRAVEL | DEFLECTION, false) => "m",
            (TRAVEL | DEFLECTION, true) | (MASS_VELOCITY, false) => "m/s",
            (MASS_VELOCITY, true) => "m/s^2",
            _ => "-",
        }
        .into(),
        meaning: if rate { format!("rate of {}", name(k)) } else { meaning(k) },
        nominal: (!rate).then(|| usual[k]),
    };
    let used = || (TRAVEL..FIRST_INTERNAL + memories).filter(move |k| series || *k == TRAVEL || *k >= FIRST_INTERNAL);
    used().map(|k| one(k, false)).chain(used().map(|k| one(k, true))).collect()
}

/// Returns the parameters of the integration and of the enabled elements, without the parameters that depend on the setting.
fn parameters(corner: usize, four: bool, damper: &Definition) -> Vec<Variable> {
    let Definition { params, axis } = damper;
    let mut all = Vec::new();
    for row in parameter::table() {
        if row.element().is_some_and(|element| !params.is_on(element)) {
            continue;
        }
        let is_forces = axis.has_forces() && row == *list!("fv_force").row();
        if is_forces || Number::try_from(row).is_ok_and(|number| axis.values(number).is_some()) {
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
                unit: p.unit.into(),
                meaning: p.meaning.to_owned(),
                nominal: None,
            });
        }
    }
    all
}

/// Returns the power of ten at or below a positive number.
///
/// The power is parsed from digits, because the power functions of math libraries differ in the last bits between systems. So every system
/// writes the same FMU of a model.
fn decade(number: f64) -> f64 {
    let digits = format!("{number:e}");
    let exponent = digits.split_once('e').map_or("0", |(_, exponent)| exponent);
    format!("1e{exponent}").parse().unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_power_of_ten_is_the_number_that_is_written_so() {
        for (number, power) in [(0.0345, 0.01), (1e-4, 1e-4), (9.99e-5, 1e-5), (1.0, 1.0), (1234.5, 1000.0)] {
            assert_eq!(super::decade(number), power);
        }
    }
}
