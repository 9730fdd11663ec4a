//! Evaluation of a damper family at one setting: an ordinary damper, with those results of the fit that hold at this setting.

use super::interpolation_error::InterpolationError;
use crate::model_file::{FvOnly, FvOnlyAt, Interval, IntervalOverSetting, ModelFile};
use crate::phrases;
use dashpot_core::Params;
use dashpot_core::family::Axis;
use dashpot_core::family::axis::ENTRIES;
use dashpot_core::list;
use dashpot_core::parameter::Number;
use dashpot_messages::{Kept, Sentence};
use dashpot_records::is_same_setting;

/// Returns the ordinary damper at a setting, with the 95 % intervals that hold at this setting.
///
/// Between two settings of the fit, the distances of the interval ends from the value are interpolated linearly. The [error of
/// interpolation](InterpolationError) is added as an independent error. If this error is unknown, the number has no interval, and a note
/// names the number.
pub fn at_setting(file: &ModelFile, setting: f64) -> ModelFile {
    let params = file.definition().params_at(setting);
    let mut identification = file.identification.clone();
    let place = GridPlace::new(file.axis.grid(), setting);
    let error = InterpolationError::new(&file.definition());
    let mut without = Vec::new();
    for (name, over) in std::mem::take(&mut identification.intervals_over_setting) {
        if error.of_value(setting, |_| 0.0).is_none() {
            without.push(name);
        } else if let Some(interval) = place.interval(&name, &over, (&file.axis, &params), &error) {
            identification.intervals.insert(name, interval);
        }
    }
    // An ordinary damper has no actuator, so the intervals of its numbers are removed.
    identification.intervals.retain(|name, _| ENTRIES.iter().all(|entry| entry.name != name));
    let curves = std::mem::take(&mut identification.fv_only_over_setting);
    // If the user changed the file, the stored plain FV curves are those of another damper.
    let curve = if file.was_changed() { None } else { place.curve(file.axis.grid(), &curves) };
    identification.fv_only = curve.or(identification.fv_only);
    // A number that was not identified at a neighboring setting has no measured value between the two neighbors.
    let mut open: Vec<String> = Vec::new();
    for name in &identification.not_identified {
        let (bare, is_here) = match name.rsplit_once('@') {
            Some((bare, at)) => (bare, at.parse().is_ok_and(|at: f64| place.neighbors(file.axis.grid()).contains(&at))),
            None => (name.as_str(), true),
        };
        if is_here && !open.iter().any(|known| known == bare) {
            open.push(bare.to_owned());
        }
    }
    identification.not_identified = open;
    identification.notes.retain(|note| place.is_of(note, &file.axis));
    if !without.is_empty() {
        let names = without.iter().map(String::as_str);
        let said = Sentence::from(phrases::NO_INTERVAL_BETWEEN).with_names("names", names, phrases::COMMA);
        identification.notes.push(said.to_string());
        identification.messages.push(Kept::from(&said));
    }
    let (specified, edited) = (file.specified.clone(), file.edited.clone());
    ModelFile { params, axis: Axis::NONE, identification, specified, edited }
}

/// Returns whether a setting is one of a damper's grid, so that its numbers were measured and not interpolated.
pub fn is_of_grid(grid: &[f64], setting: f64) -> bool {
    grid.iter().any(|of| is_same_setting(*of, setting))
}

/// Returns the two settings of the grid between which a damper is interpolated; `None` on the grid and outside of it.
pub fn interpolated_between(grid: &[f64], setting: f64) -> Option<[f64; 2]> {
    let pair = grid.windows(2).find(|pair| pair[0] < setting && setting < pair[1])?;
    (!is_of_grid(pair, setting)).then(|| [pair[0], pair[1]])
}

/// Position of a setting on a grid, with the indices of the neighboring settings of the grid below and above it.
struct GridPlace {
    setting: f64,
    left: usize,
    right: usize,
    /// Fraction of the distance from the left to the right neighbor, 0..=1.
    part: f64,
}

impl GridPlace {
    fn new(grid: &[f64], setting: f64) -> GridPlace {
        let last = grid.len().saturating_sub(1);
        let right = grid.partition_point(|value| *value < setting).min(last);
        let left = if grid.get(right).is_some_and(|value| *value <= setting) { right } else { right.saturating_sub(1) };
        let width = grid.get(right).zip(grid.get(left)).map_or(0.0, |(right, left)| right - left);
        // Beyond the grid, the damper equals the damper at the end of the grid.
        let part = if width > 0.0 { ((setting - grid[left]) / width).clamp(0.0, 1.0) } else { 0.0 };
        GridPlace { setting, left, right, part }
    }

    fn neighbors(&self, grid: &[f64]) -> Vec<f64> {
        [self.left, self.right].iter().filter_map(|place| grid.get(*place)).copied().collect()
    }

    /// Returns whether a note of the fit holds at this setting. Notes on settings other than the neighbors do not hold. Notes on the force
    /// of an effect over all settings do not hold either.
    fn is_of(&self, note: &str, axis: &Axis) -> bool {
        let own = note.strip_prefix("at ").and_then(|rest| rest.strip_prefix(axis.name())?.strip_prefix(" = "));
        match own {
            Some(rest) => {
                let value: Option<f64> = rest.split(':').next().and_then(|value| value.trim().parse().ok());
                value.is_none_or(|value| self.neighbors(axis.grid()).contains(&value))
            }
            None => !note.contains(" N rms, "),
        }
    }

    /// Returns the plain FV curve at the setting. Returns `None` unless the file has a plain curve for both neighbors.
    fn curve(&self, grid: &[f64], all: &[FvOnlyAt]) -> Option<FvOnly> {
        let of = |place: usize| {
            let setting = grid.get(place)?;
            all.iter().find(|of| of.setting == *setting).map(|of| &of.curve)
        };
        of(self.left)?.between(of(self.right)?, self.part)
    }

    /// Returns the interval of a number or a list at the setting. Returns `None` if the error of interpolation is unknown or the intervals
    /// do not match the grid. Also returns `None` for a number without an interval at a neighbor.
    fn interval(
        &self,
        name: &str,
        over: &IntervalOverSetting,
        (axis, at): (&Axis, &Params),
        error: &InterpolationError,
    ) -> Option<Interval> {
        match over {
            IntervalOverSetting::Number(ends) => {
                let number = Number::find(name).ok()?;
                let values = axis.values(number)?;
                let both = [self.left, self.right].map(|place| Some((*values.get(place)?, *ends.get(place)?)));
                // The ends of an interval are NaN if the number was changed since the fit. The number then has no interval.
                let error = error.of_value(self.setting, |params| params.number(number))?;
                let ends = self.between(at.number(number), both, error)?;
                ends.iter().all(|end| !end.is_nan()).then(|| Interval::Number(ends.map(|end| number.inside(end))))
            }
            IntervalOverSetting::List(ends) => {
                let now = at.list(list!("fv_force"));
                let points = (0..now.len()).map(|point| {
                    let both = [self.left, self.right]
                        .map(|place| Some((*axis.forces(place)?.get(point)?, *ends.get(place)?.get(point)?)));
                    let force =
                        |params: &Params| params.list(list!("fv_force")).get(point).copied().unwrap_or(f64::NAN);
                    self.between(now[point], both, error.of_value(self.setting, force)?)
                });
                Some(Interval::List(points.collect::<Option<_>>()?))
            }
        }
    }

    /// Interpolates the distances of the neighbors' interval ends from their values, and adds the error of interpolation. `both` contains
    /// the value and the interval ends at the left and right neighbor. Returns the ends around `value`, or `None` if a neighbor has no
    /// interval.
    fn between(&self, value: f64, both: [Option<(f64, [f64; 2])>; 2], error: f64) -> Option<[f64; 2]> {
        let [(left, ends_left), (right, ends_right)] = [both[0]?, both[1]?];
        Some([0, 1].map(|end| {
            let (from, to) = (ends_left[end] - left, ends_right[end] - right);
            let mean = from + self.part * (to - from);
            let further = libm::hypot(mean, error) - mean.abs();
            value + mean + if end == 0 { -further } else { further }
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model_file::family_of_text;
    use dashpot_core::number;

    /// Family whose Coulomb friction and FV curve depend linearly on the setting. On a grid of three settings, the least error of
    /// interpolation is a quarter of the difference between the values at neighboring settings.
    const FAMILY: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\", \"coulomb_friction\"]\nsetting = [0.0, 1.0, 2.0]\n\
         setting_name = \"current\"\nsetting_unit = \"A\"\ngas_force = 100.0\ncoulomb_force = [20.0, 60.0, 100.0]\n\
         fv_velocity = [-1.0, 0.0, 1.0]\nfv_force = [[-800.0, 0.0, 1200.0], [-2400.0, 0.0, 3600.0], [-4000.0, 0.0, 6000.0]]\n\n[identification]\n\
         not_identified = [\"coulomb_force@1\"]\n\n[identification.intervals]\ngas_force = [90.0, 110.0]\n\n\
         [identification.intervals_over_setting]\ncoulomb_force = [\n    [15.0, 25.0],\n    [40.0, 80.0],\n    [90.0, 110.0],\n]\n\
         fv_force = [\n    [[-810.0, -790.0], [0.0, 0.0], [1190.0, 1210.0]],\n    [[-2430.0, -2370.0], [0.0, 0.0], [3580.0, 3620.0]],\n    [[-4040.0, -3960.0], [0.0, 0.0], [5960.0, 6040.0]],\n]\n";

    fn at(setting: f64) -> ModelFile {
        at_setting(&family_of_text(FAMILY, "f.toml".as_ref()).unwrap(), setting)
    }

    fn number_of(file: &ModelFile, name: &str) -> [f64; 2] {
        match file.identification.intervals.get(name) {
            Some(Interval::Number(ends)) => *ends,
            other => panic!("{name}: {other:?}"),
        }
    }

    #[test]
    fn intervals_on_the_grid_are_those_of_the_file_and_between_them_those_of_both() {
        assert_eq!(number_of(&at(0.0), "coulomb_force"), [15.0, 25.0]);
        assert_eq!(number_of(&at(1.0), "coulomb_force"), [40.0, 80.0]);
        assert_eq!(number_of(&at(0.3), "gas_force"), [90.0, 110.0]);
        let middle = at(0.5);
        let value = middle.params.number(number!("coulomb_force"));
        let [low, high] = number_of(&middle, "coulomb_force");
        let half = libm::hypot(12.5, 10.0);
        assert!((low - (value - half)).abs() < 1e-9 && (high - (value + half)).abs() < 1e-9, "{value} {low} {high}");
        match middle.identification.intervals.get("fv_force") {
            Some(Interval::List(ends)) => {
                assert!((ends[2][1] - ends[2][0] - 2.0 * libm::hypot(15.0, 600.0)).abs() < 1e-9, "{ends:?}");
            }
            other => panic!("{other:?}"),
        }
        assert!(!middle.axis.is_some() && !middle.was_changed());
        // Beyond the grid, the damper equals the damper at the end of the grid.
        assert_eq!(number_of(&at(9.0), "coulomb_force"), [90.0, 110.0]);
    }

    #[test]
    fn the_error_of_interpolation_widens_an_interval_and_where_it_is_unknown_there_is_none() {
        let bent = FAMILY.replace("[20.0, 60.0, 100.0]", "[20.0, 60.0, 140.0]");
        let file = family_of_text(&bent, "f.toml".as_ref()).unwrap();
        let middle = at_setting(&file, 0.5);
        let [low, high] = number_of(&middle, "coulomb_force");
        // At setting 1, the line through the neighbors gives 80 N instead of 60 N. Halfway to a neighbor, half of these 20 N is uncertain.
        assert!(((high - low) / 2.0 - libm::hypot(12.5, 10.0)).abs() < 1e-9, "{low} {high}");
        let two = FAMILY.replace(", 2.0]", "]").replace(", 100.0]", "]").replace(", [-4000.0, 0.0, 6000.0]", "");
        let two = two.replace("    [90.0, 110.0],\n", "");
        let two = two.replace("    [[-4040.0, -3960.0], [0.0, 0.0], [5960.0, 6040.0]],\n", "");
        let middle = at_setting(&family_of_text(&two, "f.toml".as_ref()).unwrap(), 0.5);
        assert!(!middle.identification.intervals.contains_key("coulomb_force"));
        assert!(
            middle.identification.notes.iter().any(|note| note.starts_with("coulomb_force, fv_force: no interval"))
        );
        assert_eq!(number_of(&middle, "gas_force"), [90.0, 110.0]);
    }

    #[test]
    fn what_is_open_at_a_neighbor_is_open_between_them() {
        assert!(at(0.0).identification.not_identified.is_empty());
        assert_eq!(at(0.5).identification.not_identified, ["coulomb_force"]);
        assert_eq!(at(1.0).identification.not_identified, ["coulomb_force"]);
    }
}
