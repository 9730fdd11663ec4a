//! Figures of the force over velocity and over the setting.

use super::{axis_title, named, named_summary};
use crate::blocks::Figure;
use crate::plot::axes::{Axis, Marks, Plane, SIZE, Series};
use crate::plot::in_space::{SpaceSeries, surface};
use crate::plot::palette::Role;
use crate::words::Words;
use dashpot_core::family::Definition;
use dashpot_core::{Model, element};
use dashpot_identification::validation::{PeakForce, SettingSummary, Validation};
use dashpot_simulation::comparison::at_constant_velocity;
use dashpot_simulation::prediction::at_velocities;

/// Width and height of the figure of the FV curves by setting, px, for the full width of a printed page.
const WIDE: [f64; 2] = [880.0, 400.0];
/// Number of points of a line over the setting.
const POINTS: usize = 61;
/// Velocities of the lines of force over setting, as fractions of the largest peak velocity of the tests in each direction.
const FRACTIONS: [f64; 3] = [1.0, 0.5, 0.1];

/// Plotted series whose legend names come from the data instead of the report's texts.
#[derive(Default)]
struct Named {
    series: Vec<Series>,
    names: Vec<String>,
}

impl Named {
    fn add(&mut self, role: Role, name: String, points: Vec<[f64; 2]>, marks: Marks) {
        if !points.is_empty() {
            self.series.push(Series { role, label: "", lines: vec![points], marks });
            self.names.push(name);
        }
    }

    fn draw(self, title: &str, [x, y]: [String; 2], size: [f64; 2], words: &Words) -> Option<String> {
        if self.series.is_empty() {
            return None;
        }
        let all = || self.series.iter().flat_map(|series| &series.lines).flatten().copied();
        let (x, y) = (Axis::around(x, all().map(|p| p[0])), Axis::around(y, all().map(|p| p[1])));
        let plane = Plane { title: title.to_owned(), x, y, series: self.series };
        Some(plane.draw_named(&self.names, size, words))
    }
}

/// Draws the force at constant velocity for each setting. The measured peak forces have the color of their setting.
pub fn by_setting(damper: &Definition, validation: &Validation, words: &Words) -> Option<Figure> {
    let line = |setting: f64| -> Vec<[f64; 2]> {
        let Ok(model) = Model::new(&damper.params_at(setting)) else { return Vec::new() };
        at_constant_velocity(&model, validation).into_iter().map(|[v, f]| [1e3 * v, f]).collect()
    };
    let mut all = Named::default();
    let grid = damper.axis.grid();
    for of in &validation.settings {
        let place = grid.iter().position(|value| dashpot_records::is_same_setting(*value, of.setting));
        let role = place.map_or(Role::Before, |k| Role::Group(k as u8));
        let own = of.places.iter().filter_map(|place| validation.tests.get(*place)).flat_map(|test| &test.peaks);
        // The FV curve of the same setting, in the same color, already has the legend entry.
        all.add(role, String::new(), own.map(measured).collect(), Marks::Dots);
    }
    for (k, setting) in grid.iter().enumerate() {
        all.add(Role::Group(k as u8), named(damper, *setting, words), line(*setting), Marks::Line);
    }
    for of in validation.settings.iter().filter(|of| !of.is_of_grid) {
        all.add(Role::Before, named_summary(damper, of, words), line(of.setting), Marks::Line);
    }
    let axes = [words.axis_velocity, words.axis_force].map(str::to_owned);
    let svg = all.draw(words.plot_family, axes, WIDE, words)?;
    Some(Figure::new("curves-by-setting", svg).saying(words.family_caption))
}

fn measured(peak: &PeakForce) -> [f64; 2] {
    [1e3 * peak.velocity_m_s, peak.force_n.measured]
}

/// Number of lines of constant velocity, and of settings between two grid values, in the figure of the surface.
const MESH: [usize; 2] = [13, 3];

/// Draws the force over velocity and setting as a surface. The settings of the grid and their measured peak forces have the color of their
/// setting. Returns `None` without a force.
pub fn over_both(damper: &Definition, validation: &Validation, words: &Words) -> Option<Figure> {
    let line = |setting: f64| -> Vec<[f64; 3]> {
        let Ok(model) = Model::new(&damper.params_at(setting)) else { return Vec::new() };
        at_constant_velocity(&model, validation).into_iter().map(|[v, f]| [1e3 * v, setting, f]).collect()
    };
    let dots = |setting: f64| -> Vec<[f64; 3]> {
        let is_own = |of: &&SettingSummary| dashpot_records::is_same_setting(setting, of.setting);
        let places = validation.settings.iter().filter(is_own).flat_map(|of| &of.places);
        let peaks = places.filter_map(|place| validation.tests.get(*place)).flat_map(|test| &test.peaks);
        peaks.map(measured).map(|[v, force]| [v, setting, force]).collect()
    };
    draw_surface(damper, &line, &dots, words)
}

/// Draws a surface. At a setting, `line` and `dots` return the points: velocity, mm/s, setting, and force, N.
fn draw_surface(
    damper: &Definition,
    line: &dyn Fn(f64) -> Vec<[f64; 3]>,
    dots: &dyn Fn(f64) -> Vec<[f64; 3]>,
    words: &Words,
) -> Option<Figure> {
    let grid = damper.axis.grid();
    let between = |pair: &[f64]| {
        let [from, to] = [pair[0], pair[1]];
        (1..=MESH[1]).map(move |k| from + (to - from) * k as f64 / (MESH[1] + 1) as f64).collect::<Vec<f64>>()
    };
    let mut settings: Vec<f64> = grid.windows(2).flat_map(between).chain(grid.iter().copied()).collect();
    settings.sort_by(f64::total_cmp);
    let lines: Vec<Vec<[f64; 3]>> = settings.iter().map(|setting| line(*setting)).filter(|of| of.len() > 1).collect();
    let count = lines.iter().map(Vec::len).min()?;
    // All lines of constant setting have the same velocities. A line of constant velocity therefore joins their points of equal index.
    let across = |k: usize| lines.iter().map(|of| of[k * (count - 1) / (MESH[0] - 1)]).collect();
    let mesh = lines.iter().cloned().chain((0..MESH[0]).map(across)).collect();
    let mut series = vec![SpaceSeries { role: Role::Shadow, name: String::new(), lines: mesh, dots: Vec::new() }];
    for (k, setting) in grid.iter().enumerate() {
        series.push(SpaceSeries {
            role: Role::Group(k as u8),
            name: named(damper, *setting, words),
            lines: vec![line(*setting)],
            dots: dots(*setting),
        });
    }
    let all = || series.iter().flat_map(|of| of.lines.iter().flatten().chain(&of.dots));
    let axes = [
        Axis::around(words.axis_velocity, all().map(|at| at[0])),
        Axis::around(axis_title(damper, words), grid.iter().copied()),
        Axis::around(words.axis_force, all().map(|at| at[2])),
    ];
    let svg = surface(words.plot_surface, &axes, &series, words);
    Some(Figure::new("force-surface", svg).saying(words.surface_caption))
}

/// Draws the force over the setting, and the force ratio of the hardest to the softest setting over velocity.
pub fn over_setting(damper: &Definition, validation: &Validation, words: &Words) -> Vec<Figure> {
    let peaks: Vec<f64> = validation.tests.iter().flat_map(|test| &test.peaks).map(|peak| peak.velocity_m_s).collect();
    // Slowest and fastest peak velocity of the tests in one direction, m/s, or 0 without peaks.
    let reach = |is_own: fn(&f64) -> bool| {
        let own = || peaks.iter().copied().filter(is_own);
        let slowest = own().reduce(|a, b| if b.abs() < a.abs() { b } else { a }).unwrap_or(0.0);
        [slowest, own().fold(0.0, |a, b| if b.abs() > a.abs() { b } else { a })]
    };
    let (compression, rebound) = (reach(|v| *v < 0.0), reach(|v| *v > 0.0));
    let mut figures: Vec<Figure> = Vec::new();
    figures.extend(force_over_setting(damper, [compression[1], rebound[1]], words));
    figures.extend(ratio(damper, [compression, rebound], words));
    figures
}

fn force_over_setting(damper: &Definition, [low, high]: [f64; 2], words: &Words) -> Option<Figure> {
    let (from, to) = damper.axis.range();
    let mut velocities: Vec<f64> =
        FRACTIONS.iter().flat_map(|part| [part * high, part * low]).filter(|v| *v != 0.0).collect();
    // The legend lists the velocities in the vertical order of the lines.
    velocities.sort_by(|a, b| b.total_cmp(a));
    let mut lines: Vec<Vec<[f64; 2]>> = vec![Vec::new(); velocities.len()];
    for k in 0..POINTS {
        let setting = from + (to - from) * k as f64 / (POINTS - 1) as f64;
        let Ok(model) = Model::new(&damper.params_at(setting)) else { continue };
        for (line, velocity) in lines.iter_mut().zip(&velocities) {
            line.extend(at_velocities(&model, &[*velocity]).iter().map(|[_, force]| [setting, *force]));
        }
    }
    let mut all = Named::default();
    for (k, (line, velocity)) in lines.into_iter().zip(&velocities).enumerate() {
        let name = words.number(&format!("{:.0} mm/s", 1e3 * velocity));
        all.add(Role::Group(k as u8), name, line, Marks::Line);
    }
    let axes = [axis_title(damper, words), words.axis_force.to_owned()];
    let svg = all.draw(words.plot_over_setting, axes, SIZE, words)?;
    Some(Figure::new("force-over-setting", svg).saying(words.over_setting_caption))
}

/// Returns the model at a setting without its static gas force, because that force would distort a ratio of damping forces.
fn without_gas(damper: &Definition, setting: f64) -> Option<Model> {
    let mut params = damper.params_at(setting);
    params.enable(element!("gas_preload"), false);
    Model::new(&params).ok()
}

/// Draws the force ratio of the hardest to the softest setting over velocity.
///
/// `compression` and `rebound` are the slowest and fastest peak velocity of each direction, m/s. The ratio is drawn between them: below the
/// slowest peak, no test determines the two forces.
fn ratio(damper: &Definition, [compression, rebound]: [[f64; 2]; 2], words: &Words) -> Option<Figure> {
    let strength = |setting: f64| -> Option<f64> {
        let model = without_gas(damper, setting)?;
        Some(at_velocities(&model, &[compression[1], rebound[1]]).iter().map(|[_, force]| force.abs()).sum())
    };
    let mut known: Vec<(f64, f64)> =
        damper.axis.grid().iter().filter_map(|setting| Some((*setting, strength(*setting)?))).collect();
    known.sort_by(|a, b| a.1.total_cmp(&b.1));
    let (soft, hard) = (known.first()?.0, known.last()?.0);
    let [of_soft, of_hard] = [soft, hard].map(|setting| without_gas(damper, setting));
    let (of_soft, of_hard) = (of_soft?, of_hard?);
    let mut all = Named::default();
    for (role, [from, to], name) in [(0, rebound, words.rebound), (1, compression, words.compression)] {
        let velocities: Vec<f64> = (0..POINTS).map(|k| from + (to - from) * k as f64 / (POINTS - 1) as f64).collect();
        let [soft, hard] = [&of_soft, &of_hard].map(|model| at_velocities(model, &velocities));
        let points = soft.iter().zip(&hard).filter(|(a, b)| a[0] == b[0] && a[0] != 0.0);
        let ratios = points.map(|(soft, hard)| [1e3 * soft[0].abs(), hard[1] / soft[1]]).filter(|p| p[1].is_finite());
        // If all tests have one peak velocity, the ratio is a single point.
        let marks = if from == to { Marks::Dots } else { Marks::Line };
        all.add(Role::Group(role), name.to_owned(), ratios.collect(), marks);
    }
    let axes = [words.axis_speed, words.axis_ratio].map(str::to_owned);
    let svg = all.draw(words.plot_ratio, axes, SIZE, words)?;
    let [hard, soft] = [hard, soft].map(|setting| named(damper, setting, words));
    let caption = words.fill(words.ratio_caption, &[("hard", &hard), ("soft", &soft)]);
    Some(Figure::new("ratio-of-settings", svg).saying(caption))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::Params;
    use dashpot_core::family::Axis as SettingAxis;
    use dashpot_core::{list, number};

    /// Makes a damper whose damping force at every velocity is proportional to one plus the setting. A gas force of 100 N is constant.
    pub fn damper() -> Definition {
        let mut params = Params::new();
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params.enable(element!("gas_preload"), true);
        params.set(number!("gas_force"), 100.0).unwrap();
        params.set_list(list!("fv_velocity"), &[-1.0, 0.0, 1.0]).unwrap();
        let mut axis = SettingAxis::NONE;
        axis.set_grid(&[0.0, 1.0, 2.0]).unwrap();
        for (k, factor) in [1.0, 2.0, 3.0].into_iter().enumerate() {
            axis.set_forces(k, &[-1000.0 * factor, 0.0, 1000.0 * factor]).unwrap();
        }
        axis.put(&mut params, 0.0);
        Definition { params, axis }
    }

    #[test]
    fn the_gas_is_no_part_of_the_ratio() {
        let figure = ratio(&damper(), [[-0.1, -1.0], [0.1, 1.0]], &crate::words::EN).unwrap();
        // The damping forces of the settings 2 and 0 have the ratio 3 at all velocities, so the axis shows a single value.
        assert!(figure.caption.contains('2') && figure.svg.contains("data-plane"), "{}", figure.caption);
        let model = without_gas(&damper(), 2.0).unwrap();
        assert!((at_velocities(&model, &[0.5])[0][1] - 1500.0).abs() < 1e-6);
    }

    #[test]
    fn the_surface_has_a_line_for_every_setting_and_velocity_of_its_mesh() {
        let line = |setting: f64| -> Vec<[f64; 3]> {
            let model = Model::new(&damper().params_at(setting)).unwrap();
            let velocities: Vec<f64> = (-20..=20).map(|k| 0.05 * f64::from(k)).collect();
            at_velocities(&model, &velocities).iter().map(|[v, force]| [1e3 * v, setting, *force]).collect()
        };
        let figure =
            draw_surface(&damper(), &line, &|setting| vec![[500.0, setting, 600.0]], &crate::words::EN).unwrap();
        // Three grid values with three settings in each of two intervals, thirteen velocities, and the three colored lines.
        let drawn = |class: &str| figure.svg.matches(&format!("class=\"l {class}\"")).count();
        assert_eq!(drawn("shadow"), 9 + 13, "{}", figure.svg);
        assert!(!figure.svg.contains("NaN"));
    }

    #[test]
    fn the_force_is_drawn_over_the_whole_grid() {
        let figure = force_over_setting(&damper(), [-1.0, 1.0], &crate::words::EN).unwrap();
        assert!(figure.svg.contains("1000 mm/s") && figure.svg.contains("\u{2212}1000 mm/s"), "{}", figure.svg);
    }
}
