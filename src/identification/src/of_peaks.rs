//! Creation of an initial model from a table of forces at peak velocities (PVP) or at given velocities within a cycle (CVP). The forces of
//! such a table include gas force and friction. If the user states gas force and friction, they are subtracted.

use crate::family::setting_labels::exchanged_settings;
use crate::model_file::{self, NoModel, prepared};
use dashpot_core::family::interpolation::MAX_GRID;
use dashpot_core::family::{Axis, Definition};
use dashpot_core::{Fault, Params, element, list, number};
use dashpot_records::{
    PeakOptions, Peaks, Positive, RecordError, Stroke, StrokeSource, Taken, peak_clicks, read_peaks,
};
use std::path::Path;

/// Largest accepted gas force or friction of a damper, N. The strut of an airliner's landing gear has a tenth of it.
const LARGEST: f64 = 1e6;

/// Reason why no model can be made from a table.
#[derive(Debug, thiserror::Error)]
pub enum OfPeaksError {
    /// The table cannot be read.
    #[error(transparent)]
    Table(#[from] RecordError),
    /// A gas force or friction is negative, not finite, or larger than any damper's.
    #[error("{name} is {value:e} N; it must be 0 N to {LARGEST:e} N")]
    Impossible {
        /// Name of the option.
        name: &'static str,
        /// Given value.
        value: f64,
    },
    /// The force without gas force and friction decreases while the speed increases.
    #[error(
        "{file}, line {line}: at {} mm/s the damper's own force is {force:.1} N and thus weaker than at a lower speed ({end:.1} N); \
         check the row, or give --gas-force and --friction as they are in the table",
        1e3 * velocity
    )]
    Weaker {
        /// Name of the table.
        file: String,
        /// Line in the table.
        line: usize,
        /// Velocity at that line, m/s.
        velocity: f64,
        /// Force at that line, N.
        force: f64,
        /// Force at the next lower speed, N.
        end: f64,
    },
    /// The parameter table rejects a number.
    #[error("{file}: {name} {reason}")]
    Rejected {
        /// Name of the table.
        file: String,
        /// The parameter.
        name: &'static str,
        /// Reason of the rejection.
        reason: &'static str,
    },
    /// The table has one click or none, or more clicks than a model can contain.
    #[error(
        "{file}: has {count} clicks, and a model over clicks holds 2 to {MAX_GRID}: --clicks all makes a model of each, --clicks N of one"
    )]
    Clicks {
        /// Name of the table.
        file: String,
        /// Number of clicks in the table.
        count: usize,
    },
    /// The speeds of one click end far below the speeds of another click.
    #[error(
        "{file}: click {click} has forces up to {:.0} mm/s, another one up to {:.0} mm/s: a model over all {clicks} clicks would end there. Complete the table, or make a model of each click with --clicks all",
        1e3 * top,
        1e3 * fastest
    )]
    SlowClick {
        /// Name of the table.
        file: String,
        /// The click with the smaller speeds.
        click: f64,
        /// Largest speed of the click with the smaller speeds, m/s.
        top: f64,
        /// Largest speed of all clicks, m/s.
        fastest: f64,
        /// Number of clicks.
        clicks: usize,
    },
    /// The numbers together do not form a valid model.
    #[error("{file}")]
    NoModel {
        /// Name of the table.
        file: String,
        /// Invalid parameter, and the reason.
        source: NoModel,
    },
}

/// Model file made from a table of peak forces, with what the user should know about it.
#[derive(Debug, Clone)]
pub struct Begun {
    /// Text of the model file.
    pub text: String,
    /// Number of points of the FV curve, including zero velocity.
    pub points: usize,
    /// Columns that were used, with their quantity and unit.
    pub columns: String,
    /// Description of the columns or the sign that were interpreted as rebound. Contains the ratio of the forces in rebound and compression
    /// if it is known.
    pub direction: String,
    /// Whether the forces contradict the interpretation in `direction`.
    pub is_doubtful: bool,
    /// Velocities that were left out because one of the clicks does not reach them, m/s.
    pub left_out: Vec<f64>,
    /// Largest distance from a velocity of the model to the nearest velocity in the rows of a click, relative to the velocity.
    pub interpolated: f64,
    /// Two clicks whose exchange would make the damping force monotonic over the clicks, or `None` if there are no such clicks.
    pub exchanged: Option<(f64, f64)>,
}

impl Begun {
    /// Returns notes on the clicks of a table that made one model over the clicks.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if !self.left_out.is_empty() {
            let speeds: Vec<String> = self.left_out.iter().map(|speed| format!("{:.1}", 1e3 * speed)).collect();
            notes.push(format!("not every click reaches {} mm/s; left out", speeds.join(", ")));
        }
        if let Some((one, other)) = self.exchanged {
            notes.push(format!(
                "the damping force does not rise or fall throughout over the clicks; with {one} and {other} exchanged it would. Check the table"
            ));
        }
        if self.interpolated > NO_DISTANCE {
            notes.push(format!(
                "the clicks have other speeds than one another; forces are interpolated linearly over up to {:.1} % of the speed",
                100.0 * self.interpolated
            ));
        }
        notes
    }
}

/// Largest relative distance of two speeds that counts as rounding.
const NO_DISTANCE: f64 = 1e-6;

/// Smallest accepted ratio of the largest speed of a click to the largest speed of all clicks. A smaller ratio is an error, because the
/// model would end far below the largest speed of the table. Test: `a_table_of_clicks_is_one_model_over_the_clicks`, where a click ends at
/// a ratio of 0.6.
const REACHED: f64 = 0.8;
/// Ratio of the lower to the higher of two speeds above which they count as the same speed. A dyno repeats its commanded speeds to about a
/// percent. Test: `a_table_of_clicks_is_one_model_over_the_clicks`, where the speeds scatter by 0.7 %.
const SAME_SPEED: f64 = 0.98;

/// Returns the force, N, of a curve at a velocity, m/s. The force is linear between the points of the curve, and constant beyond its ends.
fn force_at(curve: &[(f64, f64)], velocity: f64) -> f64 {
    let after = curve.partition_point(|(own, _)| *own < velocity);
    match (after.checked_sub(1).and_then(|before| curve.get(before)), curve.get(after)) {
        (Some((v0, f0)), Some((v1, f1))) => f0 + (f1 - f0) * (velocity - v0) / (v1 - v0),
        (Some((_, force)), None) | (None, Some((_, force))) => *force,
        (None, None) => 0.0,
    }
}

/// Returns the distance from a velocity to the nearest point of a curve, relative to the velocity; 0 at zero velocity.
fn distance_to_point(curve: &[(f64, f64)], velocity: f64) -> f64 {
    let nearest = curve.iter().map(|(own, _)| (own - velocity).abs()).fold(f64::INFINITY, f64::min);
    if velocity == 0.0 { 0.0 } else { nearest / velocity.abs() }
}

/// Force of a damper over velocity without gas force and friction, and the table from which it was read.
struct Read {
    peaks: Peaks,
    /// Velocity, m/s, and force, N, sorted by velocity, including zero velocity.
    curve: Vec<(f64, f64)>,
}

/// Makes a model file from a table. Subtracts gas force and friction, N, from the forces of the table.
///
/// # Errors
/// The table does not give a model: [`OfPeaksError`].
pub fn of_peaks(path: &Path, options: &PeakOptions, gas_force: f64, friction: f64) -> Result<Begun, OfPeaksError> {
    let read = read_curve(path, options, gas_force, friction)?;
    let params = params_of(path, &read.curve, gas_force, friction)?;
    Ok(begun(path, &read, &Definition { params, axis: Axis::NONE }, (Vec::new(), 0.0)))
}

/// Makes a model file over the clicks of a table of an adjustable damper.
///
/// # Errors
/// The table does not give a model: [`OfPeaksError`].
pub fn family_of_peaks(
    path: &Path,
    options: &PeakOptions,
    gas_force: f64,
    friction: f64,
) -> Result<Begun, OfPeaksError> {
    let file = || path.display().to_string();
    let mut clicks = peak_clicks(path)?;
    clicks.sort_by(f64::total_cmp);
    if !(2..=MAX_GRID).contains(&clicks.len()) {
        return Err(OfPeaksError::Clicks { file: file(), count: clicks.len() });
    }
    let at =
        |click: &f64| read_curve(path, &PeakOptions { clicks: Some(*click), ..options.clone() }, gas_force, friction);
    let mut all: Vec<Read> = clicks.iter().map(at).collect::<Result<_, _>>()?;
    // The FV points of a model over a setting have the same velocities at every setting, so all clicks need common velocities.
    let (mut common, mut left_out) = (vec![0.0], Vec::new());
    for sign in [-1.0, 1.0] {
        let speeds = |read: &Read| -> Vec<f64> {
            read.curve.iter().map(|(velocity, _)| sign * velocity).filter(|speed| *speed > 0.0).collect()
        };
        let tops: Vec<f64> = all.iter().map(|read| speeds(read).into_iter().fold(0.0, f64::max)).collect();
        let (slowest, top) = tops.iter().copied().enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, 0.0));
        let fastest = tops.iter().copied().fold(0.0, f64::max);
        if top < REACHED * fastest {
            return Err(OfPeaksError::SlowClick {
                file: file(),
                click: clicks[slowest],
                top,
                fastest,
                clicks: clicks.len(),
            });
        }
        // The click with the most points supplies the velocities.
        let densest = all.iter().map(speeds).max_by_key(Vec::len).unwrap_or_default();
        common.extend(
            densest.into_iter().filter(|speed| *speed < SAME_SPEED * top).chain([top]).map(|speed| sign * speed),
        );
        left_out
            .extend(all.iter().flat_map(speeds).filter(|speed| *speed > top / SAME_SPEED).map(|speed| sign * speed));
    }
    common.sort_by(f64::total_cmp);
    let mut off = 0.0f64;
    for read in &mut all {
        let own = std::mem::take(&mut read.curve);
        off = common.iter().map(|velocity| distance_to_point(&own, *velocity)).fold(off, f64::max);
        read.curve = common.iter().map(|velocity| (*velocity, force_at(&own, *velocity))).collect();
    }
    let sets: Vec<Params> =
        all.iter().map(|read| params_of(path, &read.curve, gas_force, friction)).collect::<Result<_, _>>()?;
    let refused = |fault: Fault| OfPeaksError::Rejected { file: file(), name: "clicks", reason: fault.reason.text() };
    let (params, mut axis) = Axis::through(&clicks, &sets).map_err(refused)?;
    axis.set_name("clicks").map_err(refused)?;
    let exchanged = exchanged_settings(&sets).map(|(one, other)| (clicks[one], clicks[other]));
    Ok(Begun { exchanged, ..begun(path, &all[0], &Definition { params, axis }, (left_out, off)) })
}

/// Reads the forces of a damper from a table, and subtracts `gas_force` and `friction`, N.
fn read_curve(path: &Path, options: &PeakOptions, gas_force: f64, friction: f64) -> Result<Read, OfPeaksError> {
    for (name, value) in [("--gas-force", gas_force), ("--friction", friction)] {
        if !(0.0..=LARGEST).contains(&value) {
            return Err(OfPeaksError::Impossible { name, value });
        }
    }
    let peaks = read_peaks(path, options)?;
    let points = &peaks.points;
    let hydraulic = |force: f64, velocity: f64| force + gas_force - friction * velocity.signum();
    let mut curve = vec![(0.0, 0.0)];
    for p in points.iter().rev().filter(|p| p.velocity_m_s < 0.0).chain(points.iter().filter(|p| p.velocity_m_s > 0.0))
    {
        let (force, velocity) = (hydraulic(p.force_n, p.velocity_m_s), p.velocity_m_s);
        let place = if velocity < 0.0 { 0 } else { curve.len() };
        let (_, end) = curve[place.min(curve.len() - 1)];
        if (force - end) * velocity < 0.0 {
            let file = path.display().to_string();
            return Err(OfPeaksError::Weaker { file, line: p.line, velocity, force, end });
        }
        curve.insert(place, (velocity, force));
    }
    Ok(Read { peaks, curve })
}

/// Returns the parameters of a damper with a curve, gas force and friction.
fn params_of(path: &Path, curve: &[(f64, f64)], gas_force: f64, friction: f64) -> Result<Params, OfPeaksError> {
    let file = || path.display().to_string();
    let (velocities, forces): (Vec<f64>, Vec<f64>) = curve.iter().copied().unzip();
    let mut params = Params::new();
    params.disable_all();
    params.enable(element!("fv_curve"), true);
    let refused =
        |name: &'static str, fault: &Fault| OfPeaksError::Rejected { file: file(), name, reason: fault.reason.text() };
    for (list, values) in [(list!("fv_velocity"), &velocities), (list!("fv_force"), &forces)] {
        params.set_list(list, values).map_err(|fault| refused(list.name(), &fault))?;
    }
    for (element, number, value) in [
        (element!("gas_preload"), number!("gas_force"), gas_force),
        (element!("coulomb_friction"), number!("coulomb_force"), friction),
    ] {
        if value > 0.0 {
            params.enable(element, true);
            params.set(number, value).map_err(|fault| refused(number.name(), &fault))?;
        }
    }
    prepared(&params).map_err(|source| OfPeaksError::NoModel { file: file(), source })?;
    Ok(params)
}

/// Makes the model file of a damper from a table.
fn begun(path: &Path, read: &Read, damper: &Definition, (left_out, interpolated): (Vec<f64>, f64)) -> Begun {
    let flat = model_file::flat_family(damper, |row| format!("{}; {}", row.parameter.unit, row.parameter.meaning));
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let (direction, is_doubtful) = direction(&read.peaks);
    Begun {
        text: format!("# Read from {}.\n\n{flat}", name.escape_debug()),
        points: read.curve.len(),
        columns: columns(&read.peaks),
        direction,
        is_doubtful,
        left_out,
        interpolated,
        exchanged: None,
    }
}

/// Describes the columns that were used.
fn columns(peaks: &Peaks) -> String {
    let pairs = peaks.pairs.iter().map(|pair| {
        let stroke = pair.stroke.map_or("both strokes", Stroke::name);
        let column = |taken: &Taken| match taken.heading.as_str() {
            "" => format!("column {} in {}", taken.index + 1, taken.unit),
            heading => format!("'{}' in {}", heading.escape_debug(), taken.unit),
        };
        format!("{stroke} from {} over {}", column(&pair.force), column(&pair.velocity))
    });
    pairs.collect::<Vec<_>>().join(", ")
}

/// Describes the columns or the sign that were interpreted as rebound. Also returns whether the forces contradict this interpretation.
fn direction(peaks: &Peaks) -> (String, bool) {
    /// Smallest ratio of the compression force to the rebound force at which the interpretation is doubtful. Measured ratios of symmetric
    /// dampers differ from 1 by less.
    const CLEARLY: f64 = 1.2;
    let taken = match peaks.source {
        StrokeSource::Headings => "rebound and compression taken as the headings name them",
        StrokeSource::Stated(Positive::Rebound) => "positive velocities and forces taken as rebound, as given",
        StrokeSource::Stated(Positive::Compression) => "negative velocities and forces taken as rebound, as given",
        StrokeSource::Assumed => {
            "positive velocities and forces taken as rebound (--positive compression takes the negative ones)"
        }
    };
    let Some((velocity, ratio)) = peaks.asymmetry() else { return (taken.to_owned(), false) };
    let found = format!(
        "{taken}; at {:.0} mm/s the force in rebound is {ratio:.2} times the force in compression",
        1e3 * velocity
    );
    if ratio * CLEARLY > 1.0 {
        return (found, false);
    }
    let check = match peaks.source {
        StrokeSource::Headings => "check the headings",
        StrokeSource::Stated(Positive::Compression) => "check whether --positive rebound is right",
        _ => "if the table counts compression positive, give --positive compression",
    };
    (format!("{found}. Most dampers resist rebound more: {check}"), true)
}
