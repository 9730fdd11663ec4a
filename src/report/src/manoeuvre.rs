//! Report of a simulated manoeuvre of a vehicle.
//!
//! The report compares two simulations: one with the full damper model, and one with the model's FV curve alone. It also contains the road,
//! the motion of the chassis, the operating region of the dampers, and the vehicle data.

use super::blocks::{Block, Column, Figure, Section, Table};
use super::made::{self, Made};
use super::numbers::{self, digits};
use crate::Workbook;
use crate::cells::Cell;
use crate::plot::axes::{Axis, Marks, Plane, Series};
use crate::plot::palette::Role;
use crate::words::Words;
use dashpot_core::Model;
use dashpot_records::Record;
use dashpot_simulation::chatter::RINGS;
use dashpot_simulation::vehicle::{CORNERS, Car, Quiet, Run, SLOW, Sample};
use serde::Serialize;

/// Ranges, from the smallest to the largest value, of the displacement and velocity of a damper.
#[derive(Serialize, Debug, Clone, Copy)]
pub struct Region {
    /// Smallest and largest displacement, m.
    pub displacement_m: [f64; 2],
    /// Smallest and largest velocity, m/s.
    pub velocity_m_s: [f64; 2],
}

/// Operating region, forces and energy of one damper.
#[derive(Serialize, Debug, Clone)]
pub struct CornerFigures {
    /// Name of the corner of the vehicle at which the damper is.
    pub corner: &'static str,
    /// Ranges of displacement and velocity that the damper reached in the manoeuvre.
    pub saw: Region,
    /// Largest magnitude of the force in the simulation with the full model, N.
    pub largest_force_n: f64,
    /// Largest magnitude of the force in the simulation with the FV curve alone, N.
    pub largest_force_fv_n: f64,
    /// rms difference between the forces of the full model and of the FV curve alone, N. If the coupling chatters in the host's step, both
    /// forces come from simulations in the shorter step [`Figures::quiet_step_s`].
    pub rms_force_difference_n: f64,
    /// rms error of the force, N, due to chatter in the host's step: for the full model, and for the FV curve alone. `None` if the coupling
    /// does not chatter.
    pub rms_chatter_n: Option<[f64; 2]>,
    /// rms of the full model's force after subtraction of its mean, N.
    pub rms_force_n: f64,
    /// Energy that the damper dissipates in the simulation with the full model, J.
    pub energy_j: f64,
    /// Energy that the damper dissipates in the simulation with the FV curve alone, J.
    pub energy_fv_j: f64,
    /// Fraction of the time in which displacement and velocity are close to those of a rig test. The limit is a tenth of the tests' range,
    /// for both quantities. `None` without rig tests.
    pub fraction_inside_tests: Option<f64>,
    /// Velocities, m/s, at which the model's FV curve ends, or `None` for a curve without ends.
    pub curve_ends_m_s: Option<[f64; 2]>,
    /// Fraction of the time in which the velocity is beyond the ends of the FV curve, where the force is extrapolated linearly.
    pub fraction_beyond_curve: f64,
}

/// Key figures of a simulated manoeuvre; `dashpot manoeuvre` writes them as JSON.
#[derive(Serialize, Debug, Clone)]
pub struct Figures {
    /// Name of the manoeuvre.
    pub manoeuvre: String,
    /// Time step, s, at which the host (the vehicle simulation) exchanges motion and force with the dampers.
    pub step_s: f64,
    /// Largest magnitude of the body's heave acceleration, m/s²: with the full model, and with the FV curve alone.
    pub largest_heave_acceleration_m_s2: [f64; 2],
    /// rms heave acceleration of the body, m/s²: with the full model, and with the FV curve alone.
    pub rms_heave_acceleration_m_s2: [f64; 2],
    /// rms difference of the body's heave, m, between the simulations with the full model and with the FV curve alone. If the coupling
    /// chatters, both come from simulations in the shorter step.
    pub rms_heave_difference_m: f64,
    /// Shorter coupling step, s, for the comparison of the full model with the FV curve alone. `None` if the coupling of force and motion
    /// chatters in neither of the two simulations in the host's step.
    pub quiet_step_s: Option<f64>,
    /// Largest ratio c h/m of the coupling: damping c at the wheel, N s/m, times coupling step h, s, divided by unsprung mass m, kg.
    pub coupling: f64,
    /// Largest ratio c h/m, as in [`Figures::coupling`], at damper velocities above [`SLOW`].
    pub coupling_moving: f64,
    /// Ranges of displacement and velocity that the rig tests covered. `None` without rig tests.
    pub rig_tests: Option<Region>,
    /// Key figures of every corner.
    pub corners: Vec<CornerFigures>,
}

/// Points of displacement and velocity that the rig tests covered.
#[derive(Debug, Clone)]
pub struct Covered {
    /// Ranges of displacement and velocity of all rig tests.
    pub region: Region,
    /// Loops of the tests: points of displacement, m, and velocity, m/s.
    pub loops: Vec<Vec<[f64; 2]>>,
}

fn region(points: impl Iterator<Item = [f64; 2]>) -> Region {
    let empty = [f64::INFINITY, f64::NEG_INFINITY];
    let (x, v) =
        points.fold((empty, empty), |(x, v), [px, pv]| ([x[0].min(px), x[1].max(px)], [v[0].min(pv), v[1].max(pv)]));
    Region { displacement_m: x, velocity_m_s: v }
}

impl Covered {
    /// Makes the loops of displacement and velocity, and their ranges, from the records of rig tests.
    pub fn from_records(records: &[Record]) -> Self {
        let points = |r: &Record| r.displacement.iter().zip(&r.velocity).map(|(x, v)| [*x, *v]).collect();
        let loops: Vec<Vec<[f64; 2]>> = records.iter().map(points).collect();
        Covered { region: region(loops.iter().flatten().copied()), loops }
    }

    /// Returns a function that states whether a point of displacement and velocity is close to a test. The largest distance is a tenth of
    /// the tests' range, for both quantities.
    fn near(&self) -> impl Fn([f64; 2]) -> bool {
        const CELLS: usize = 20;
        let r = self.region;
        let cell = move |value: f64, range: [f64; 2]| -> Option<usize> {
            let place = (value - range[0]) / (range[1] - range[0]);
            (0.0..=1.0).contains(&place).then_some(((place * CELLS as f64) as usize).min(CELLS - 1))
        };
        let mut seen = [[false; CELLS]; CELLS];
        for [x, v] in self.loops.iter().flatten() {
            if let (Some(i), Some(j)) = (cell(*x, r.displacement_m), cell(*v, r.velocity_m_s)) {
                for row in &mut seen[i.saturating_sub(1)..=(i + 1).min(CELLS - 1)] {
                    row[j.saturating_sub(1)..=(j + 1).min(CELLS - 1)].fill(true);
                }
            }
        }
        move |[x, v]| match (cell(x, r.displacement_m), cell(v, r.velocity_m_s)) {
            (Some(i), Some(j)) => seen[i][j],
            _ => false,
        }
    }
}

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, n) = values.fold((0.0, 0_usize), |(s, n), v| (s + v * v, n + 1));
    (sum / n.max(1) as f64).sqrt()
}

/// Computes the key figures from the simulations with the full model and with the FV curve alone. `step` is the host's step, s. `quiet`
/// contains both simulations in shorter steps.
pub fn figures(
    name: &str,
    step: f64,
    [model, curve]: [&Run; 2],
    quiet: Option<&Quiet>,
    covered: Option<&Covered>,
    models: [&Model; 4],
) -> Figures {
    let [calm_model, calm_curve] = compared([model, curve], quiet);
    let near = covered.map(Covered::near);
    let largest = |run: &Run, of: &dyn Fn(&Sample) -> f64| run.samples.iter().fold(0.0_f64, |m, s| m.max(of(s).abs()));
    let acceleration = |s: &Sample| s.body.heave_acceleration;
    let apart = |a: &Run, b: &Run, of: &dyn Fn(&Sample) -> f64| {
        rms(a.samples.iter().zip(&b.samples).map(|(a, b)| of(a) - of(b)))
    };
    let corners = (0..4)
        .map(|i| {
            let energy = |run: &Run| run.samples.iter().map(|s| s.corner[i].force * s.corner[i].velocity).sum::<f64>();
            let points = || model.samples.iter().map(|s| [s.corner[i].displacement, s.corner[i].velocity]);
            CornerFigures {
                corner: CORNERS[i],
                saw: region(points()),
                largest_force_n: largest(model, &|s| s.corner[i].force),
                largest_force_fv_n: largest(curve, &|s| s.corner[i].force),
                rms_force_difference_n: apart(calm_model, calm_curve, &|s| s.corner[i].force),
                rms_chatter_n: quiet.map(|_| {
                    [(model, calm_model), (curve, calm_curve)]
                        .map(|(run, calm)| apart(run, calm, &|s| s.corner[i].force))
                }),
                rms_force_n: {
                    let force = || model.samples.iter().map(|s| s.corner[i].force);
                    let mean = force().sum::<f64>() / model.samples.len().max(1) as f64;
                    rms(force().map(|f| f - mean))
                },
                energy_j: energy(model) * step,
                energy_fv_j: energy(curve) * step,
                curve_ends_m_s: {
                    let (low, high) = models[i].elements().paths.fv_curve.range();
                    (low < high).then_some([low, high])
                },
                fraction_beyond_curve: points().filter(|[_, v]| !models[i].covers(*v)).count() as f64
                    / model.samples.len().max(1) as f64,
                fraction_inside_tests: near
                    .as_ref()
                    .map(|near| points().filter(|p| near(*p)).count() as f64 / model.samples.len() as f64),
            }
        })
        .collect();
    Figures {
        manoeuvre: name.to_owned(),
        step_s: step,
        largest_heave_acceleration_m_s2: [largest(model, &acceleration), largest(curve, &acceleration)],
        rms_heave_acceleration_m_s2: [model, curve].map(|run| rms(run.samples.iter().map(acceleration))),
        rms_heave_difference_m: apart(calm_model, calm_curve, &|s| s.body.position[0]),
        quiet_step_s: quiet.map(|quiet| quiet.step),
        coupling: model.coupling,
        coupling_moving: model.coupling_moving,
        rig_tests: covered.map(|c| c.region),
        corners,
    }
}

/// Selects the simulations to compare, with the full model and with the FV curve: those in shorter steps, if there are any. In shorter
/// steps, their difference comes from the dampers and not from chatter.
fn compared<'a>(host: [&'a Run; 2], quiet: Option<&'a Quiet>) -> [&'a Run; 2] {
    quiet.map_or(host, |quiet| quiet.runs.each_ref())
}

/// Input of the report of a manoeuvre.
#[derive(Debug, Clone)]
pub struct ManoeuvreInput<'a> {
    /// Key figures of the manoeuvre.
    pub figures: &'a Figures,
    /// Name of the model file.
    pub model_file: String,
    /// Simulation with the full damper model.
    pub model: &'a Run,
    /// Simulation with the model's FV curve alone.
    pub curve: &'a Run,
    /// Both simulations in shorter steps, if the coupling of force and motion chatters in the host's step.
    pub quiet: Option<&'a Quiet>,
    /// Displacements and velocities of the rig tests, if available.
    pub covered: Option<&'a Covered>,
    /// Parameters of the simulated vehicle.
    pub car: &'a Car,
    /// Speed of the vehicle, m/s.
    pub speed: f64,
    /// Origin of the report.
    pub made: &'a Made,
    /// Texts in the language of the report.
    pub words: &'a Words,
}

impl ManoeuvreInput<'_> {
    /// Renders the report as one HTML document.
    pub fn render(&self) -> String {
        let [title, subtitle] = self.titles();
        crate::render_sections(&title, &subtitle, &self.sections(), self.words)
    }

    /// Returns the tables of the report as a workbook.
    pub fn workbook(&self) -> Workbook<'_> {
        let [title, subtitle] = self.titles();
        Workbook { title, subtitle, sections: self.sections(), made: self.made.clone(), words: self.words }
    }

    fn titles(&self) -> [String; 2] {
        let (words, f) = (self.words, self.figures);
        let step = digits(f.step_s, 3);
        [
            words.fill(words.manoeuvre_title, &[("name", &f.manoeuvre)]),
            words.fill(words.manoeuvre_subtitle, &[("model", &self.model_file), ("step", &step)]),
        ]
    }

    fn sections(&self) -> Vec<Section> {
        let words = self.words;
        let mut first = vec![Block::Lead(self.answer()), Block::Paragraph(self.chassis_in_words())];
        first.extend(quiet_note(self.figures, words).map(Block::Warning));
        first.extend(coupling_note(self.figures, self.car, words).map(Block::Warning));
        first.extend(beyond_note(self.figures, words).map(Block::Warning));
        vec![
            Section::new("answer", words.answer, first),
            self.forces(),
            self.road(),
            self.chassis(),
            self.region(),
            Section::new("corners", words.corners_table, vec![Block::Table(self.table())]),
            self.vehicle(),
            made::section(self.made, words),
        ]
    }

    /// Describes the largest rms difference between the forces of the full model and of the FV curve, over the corners.
    fn answer(&self) -> String {
        let by = |c: &CornerFigures| c.rms_force_difference_n;
        let worst = self.figures.corners.iter().max_by(|a, b| by(a).total_cmp(&by(b)));
        match worst.filter(|c| by(c) > 0.0) {
            None => self.words.manoeuvre_answer_same.to_owned(),
            Some(c) => self.words.fill(
                self.words.manoeuvre_answer,
                &[
                    ("force", &numbers::force(c.largest_force_n)),
                    ("curve", &numbers::force(c.largest_force_fv_n)),
                    ("corner", c.corner),
                    ("difference", &numbers::error(by(c))),
                    ("share", &numbers::error(100.0 * by(c) / c.rms_force_n.max(f64::MIN_POSITIVE))),
                ],
            ),
        }
    }

    fn chassis_in_words(&self) -> String {
        let f = self.figures;
        let [peak, peak_curve] = f.largest_heave_acceleration_m_s2.map(|a| digits(a, 3));
        let [rms, rms_curve] = f.rms_heave_acceleration_m_s2.map(|a| digits(a, 3));
        let heave = digits(1e3 * f.rms_heave_difference_m, 3);
        let figures = [
            ("peak", peak.as_str()),
            ("peak_curve", &peak_curve),
            ("rms", &rms),
            ("rms_curve", &rms_curve),
            ("heave", &heave),
        ];
        self.words.fill(self.words.manoeuvre_chassis, &figures)
    }

    /// Returns the lines of the simulations with the FV curve and with the full model, in drawing order. The line of the full model is on
    /// top.
    fn both(&self, point: &dyn Fn(&Sample) -> [f64; 2]) -> Vec<Series> {
        vec![
            series(Role::FvOnly, self.words.fv_curve, self.curve, point),
            series(Role::Model, self.words.model, self.model, point),
        ]
    }

    /// Draws a figure of quantities over the whole time of the run.
    fn over_time(&self, title: String, y: &str, series: Vec<Series>) -> String {
        let mut plane = plane(title, self.words.axis_time, y, series);
        let end = self.model.samples.last().map_or(1.0, |s| s.time);
        plane.x = Axis::exactly(self.words.axis_time, 0.0, end);
        plane.draw_long(self.words)
    }

    fn forces(&self) -> Section {
        let words = self.words;
        let mut figures = Vec::new();
        for (i, name) in CORNERS.into_iter().enumerate() {
            let title = |text| words.fill(text, &[("corner", name)]);
            let time = self.both(&|s: &Sample| [s.time, s.corner[i].force]);
            let svg = self.over_time(title(words.corner_force_time), words.axis_force, time);
            figures.push(Figure::new(format!("force-time-{name}"), svg));
            let less = |(m, c): (&Sample, &Sample)| [m.time, m.corner[i].force - c.corner[i].force];
            let [model, curve] = compared([self.model, self.curve], self.quiet);
            let lines = vec![model.samples.iter().zip(&curve.samples).map(less).collect()];
            let less = Series { role: Role::Model, label: words.model, lines, marks: Marks::Line };
            let svg = self.over_time(title(words.corner_difference), words.axis_difference, vec![less]);
            figures.push(Figure::new(format!("difference-time-{name}"), svg));
            // The simulation with the FV curve is drawn last, because its loop is narrow and the loops of the full model would cover it.
            let loops =
                self.both(&|s: &Sample| [1e3 * s.corner[i].velocity, s.corner[i].force]).into_iter().rev().collect();
            let plane = plane(title(words.corner_force_velocity), words.axis_velocity, words.axis_force, loops);
            figures.push(Figure::new(format!("force-velocity-{name}"), plane.draw_traces(words)));
        }
        Section::new("forces", words.corner_section, vec![Block::Figures(figures)])
    }

    fn road(&self) -> Section {
        let words = self.words;
        let side = |role, label, i: usize| series(role, label, self.model, &|s: &Sample| [s.time, 1e3 * s.road[i]]);
        let lines = vec![side(Role::Measured, words.wheel_left, 0), side(Role::FvOnly, words.wheel_right, 1)];
        let svg = self.over_time(words.plot_road.to_owned(), words.axis_road, lines);
        let about = words.fill(words.road_caption, &[("speed", &digits(3.6 * self.speed, 3))]);
        Section::new(
            "road",
            words.road_section,
            vec![Block::Paragraph(about), Block::Figures(vec![Figure::new("road", svg)])],
        )
    }

    fn chassis(&self) -> Section {
        let words = self.words;
        type Of = fn(&Sample) -> f64;
        let of: [(&str, &str, &str, Of); 4] = [
            ("heave", words.plot_heave, words.axis_heave, |s| 1e3 * s.body.position[0]),
            ("acceleration", words.plot_heave_acceleration, words.axis_heave_acceleration, |s| {
                s.body.heave_acceleration
            }),
            ("roll", words.plot_roll, words.axis_roll, |s| s.body.position[1].to_degrees()),
            ("lateral", words.plot_lateral, words.axis_lateral, |s| s.body.lateral_acceleration),
        ];
        let figures = of.map(|(file, title, y, value)| {
            let lines = self.both(&|s: &Sample| [s.time, value(s)]);
            Figure::new(file, self.over_time(title.to_owned(), y, lines))
        });
        Section::new("chassis", words.chassis_section, vec![Block::Figures(figures.into())])
    }

    fn region(&self) -> Section {
        let words = self.words;
        let figures = (0..4)
            .map(|i| {
                let point = |s: &Sample| [1e3 * s.corner[i].displacement, 1e3 * s.corner[i].velocity];
                let mut all = Vec::new();
                if let Some(c) = self.covered {
                    let milli = |line: &Vec<[f64; 2]>| line.iter().map(|p| [1e3 * p[0], 1e3 * p[1]]).collect();
                    let lines = c.loops.iter().map(milli).collect();
                    all.push(Series { role: Role::Measured, label: words.rig_tests, lines, marks: Marks::Line });
                }
                all.push(series(Role::Model, words.in_vehicle, self.model, &point));
                let title = words.fill(words.plot_region, &[("corner", CORNERS[i])]);
                let plane = plane(title, words.axis_displacement, words.axis_velocity, all);
                Figure::new(format!("region-{}", CORNERS[i]), plane.draw_traces(words))
            })
            .collect();
        let told = if self.covered.is_some() { words.region_with_tests } else { words.region_without_tests };
        Section::new("region", words.region_section, vec![Block::Paragraph(told.into()), Block::Figures(figures)])
    }

    fn table(&self) -> Table {
        let words = self.words;
        let mut columns = vec![Column::words(words.col_corner)];
        columns.extend([words.saw_displacement, words.saw_velocity].map(Column::figures));
        let two = [words.model, words.col_curve];
        columns.extend(two.map(|name| Column::figures(name).in_group(words.group_largest_force)));
        columns.push(Column::figures(words.col_rms_difference));
        columns.extend(two.map(|name| Column::figures(name).in_group(words.group_energy_j)));
        let near = self.covered.is_some();
        columns.extend(near.then(|| Column::figures(words.col_near_tests)));
        let rows = self.figures.corners.iter().map(|c| {
            let mut row = vec![
                c.corner.into(),
                span(c.saw.displacement_m),
                span(c.saw.velocity_m_s),
                Cell::number(c.largest_force_n, numbers::force),
                Cell::number(c.largest_force_fv_n, numbers::force),
                Cell::number(c.rms_force_difference_n, numbers::error),
                Cell::number(c.energy_j, numbers::error),
                Cell::number(c.energy_fv_j, numbers::error),
            ];
            row.extend(near.then(|| Cell::number(100.0 * c.fraction_inside_tests.unwrap_or(0.0), numbers::error)));
            row
        });
        Table { caption: words.corners_caption.to_owned(), columns, rows: rows.collect(), sortable: false }
    }

    fn vehicle(&self) -> Section {
        let words = self.words;
        let values = self.car.values();
        let rows = values.iter().map(|v| vec![v.name.into(), Cell::digits(v.value, 4), v.unit.into()]);
        let columns =
            vec![Column::words(words.col_name), Column::figures(words.col_value), Column::words(words.col_unit)];
        let table = Table { caption: words.vehicle_caption.to_owned(), columns, rows: rows.collect(), sortable: false };
        Section::new("vehicle", words.vehicle_section, vec![Block::Table(table)])
    }
}

/// Formats a note that model and FV curve were compared in shorter steps, with the force error of the host's step. Returns `None` if the
/// comparison used the host's step.
pub fn quiet_note(f: &Figures, words: &Words) -> Option<String> {
    let most =
        |of: usize| f.corners.iter().filter_map(|c| c.rms_chatter_n).map(|chatter| chatter[of]).fold(0.0, f64::max);
    let [host, quiet] = [f.step_s, f.quiet_step_s?].map(|step| digits(1e3 * step, 3));
    let [model, curve] = [most(0), most(1)].map(numbers::error);
    let figures = [("host", host.as_str()), ("quiet", &quiet), ("model", &model), ("curve", &curve)];
    Some(words.fill(words.manoeuvre_quiet, &figures))
}

/// Formats a note that names the damper that spends the most time beyond the velocities of its identified FV curve.
///
/// Returns `None` if no damper leaves these velocities.
pub fn beyond_note(f: &Figures, words: &Words) -> Option<String> {
    let share = |c: &&CornerFigures| c.fraction_beyond_curve;
    let worst =
        f.corners.iter().max_by(|a, b| share(a).total_cmp(&share(b))).filter(|c| c.fraction_beyond_curve > 0.0)?;
    let range = |[low, high]: [f64; 2]| words.number(&format!("{} … {}", digits(1e3 * low, 4), digits(1e3 * high, 4)));
    let (saw, ends) = (range(worst.saw.velocity_m_s), range(worst.curve_ends_m_s?));
    let share = digits(100.0 * worst.fraction_beyond_curve, 2);
    let figures = [("corner", worst.corner), ("saw", saw.as_str()), ("ends", &ends), ("share", &share)];
    Some(words.fill(words.manoeuvre_beyond, &figures))
}

/// Formats a warning about a ratio c h/m above [`RINGS`] (damping times coupling step divided by unsprung mass). The coupling then chatters
/// or is unstable in an explicit host. Returns `None` otherwise.
pub fn coupling_note(f: &Figures, car: &Car, words: &Words) -> Option<String> {
    let [all, moving, mass, slow] =
        [f.coupling, f.coupling_moving, car.unsprung_mass, 1e3 * SLOW].map(|value| digits(value, 3));
    let figures = [("all", all.as_str()), ("moving", &moving), ("mass", &mass), ("slow", &slow)];
    if f.coupling_moving > RINGS {
        return Some(words.fill(words.coupling_unstable, &figures));
    }
    (f.coupling > RINGS).then(|| words.fill(words.coupling_chatter, &figures))
}

/// Formats a range of displacement, m, or of velocity, m/s, in mm or mm/s.
fn span(range: [f64; 2]) -> Cell {
    Cell::span(range.map(|end| 1e3 * end), numbers::error)
}

fn plane(title: String, x: &str, y: &str, series: Vec<Series>) -> Plane {
    let along = |k: usize| -> Vec<f64> { series.iter().flat_map(|s| s.lines.concat()).map(|p| p[k]).collect() };
    Plane { title, x: Axis::around(x, along(0)), y: Axis::around(y, along(1)), series }
}

fn series(role: Role, label: &'static str, run: &Run, point: &dyn Fn(&Sample) -> [f64; 2]) -> Series {
    Series { role, label, lines: vec![run.samples.iter().map(point).collect()], marks: Marks::Line }
}
