//! Where model and records disagree before anything is added.

use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::cells::Cell;
use crate::numbers::beside;
use crate::plot::{residual, residual_map};
use dashpot_diagnosis::{Diagnosis, Region};

/// Regions, maps and curves.
pub fn section(found: &Diagnosis) -> Section {
    let mut blocks = Vec::new();
    if found.regions.is_empty() {
        blocks.push(Block::Paragraph("No region stands out of the noise.".into()));
    } else {
        blocks.push(Block::Table(table(&found.regions)));
    }
    let samples = residual::samples(&found.tests);
    blocks.extend(residual_map::maps(&samples).map(|svg| {
        Block::Wide(Figure::new("residual-map", svg).saying(
            "Measured less computed force, averaged over all tests, in every place of velocity and displacement they reach; \
             both maps have one colour scale. A stripe along zero velocity is friction, a slope along displacement a spring \
             or gas, opposite signs at equal velocity a lag. Both axes give the part near zero more room.",
        ))
    }));
    let mut curves =
        vec![Figure::new("residual-size", residual::size_over_velocity(&samples)).saying(
            "How large the rest is at each velocity. Where red lies on the pale line, nothing but noise is left.",
        )];
    curves.extend(residual::mean_since_reversal(&samples).map(|svg| {
        Figure::new("residual-reversal", svg).saying(
            "What follows a reversal: below zero the damper builds its force up later than computed (compliance, play, \
             presliding, late channel), above zero it resists more (break-away).",
        )
    }));
    for (name, speeding_up) in [("residual-speeding-up", true), ("residual-slowing-down", false)] {
        curves.push(Figure::new(name, residual::mean_over_velocity(&samples, speeding_up)).saying(if speeding_up {
            "The same velocity while the stroke gathers speed …"
        } else {
            "… and while it loses it. Where the two differ, a hysteresis is missing or too large."
        }));
    }
    blocks.push(Block::Figures(curves));
    Section::new("where", "Where they disagree", blocks)
}

fn table(regions: &[Region]) -> Table {
    let in_words = |word: &str| word.replace('_', " ");
    let span = |ends: [f64; 2]| match ends[0].is_finite() && ends[1].is_finite() {
        true => {
            let widest = 1e3 * ends[0].abs().max(ends[1].abs());
            Cell::span(ends.map(|end| 1e3 * end), |end| beside(end, widest))
        }
        false => Cell::none(),
    };
    let rows = regions
        .iter()
        .map(|r| {
            vec![
                if r.test == "all" { "all that go there".into() } else { r.test.as_str().into() },
                r.direction.into(),
                span(r.velocity_m_s),
                span(r.displacement_m),
                in_words(r.acceleration).into(),
                Cell::digits(r.mean_n, 3),
                Cell::digits(r.rmse_n, 3),
                Cell::digits(r.noise_n, 3),
                r.text.as_str().into(),
            ]
        })
        .collect();
    let columns = vec![
        Column::words("tests"),
        Column::words("direction"),
        Column::figures("velocity, mm/s"),
        Column::figures("displacement, mm"),
        Column::words("speed"),
        Column::figures("mean,\u{a0}N"),
        Column::figures("rms,\u{a0}N"),
        Column::figures("noise,\u{a0}N"),
        Column::words("in words"),
    ];
    let caption =
        "Measured less computed force of the model as it came (refitted), over the fitted tests: regions that stand \
                   out of the noise, those of all tests first, then the worst."
            .to_owned();
    Table { caption, columns, rows, sortable: true }
}
