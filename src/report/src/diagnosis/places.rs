//! Regions where model and records disagree before any effect is added.

use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::cells::Cell;
use crate::numbers::comparable;
use crate::plot::{residual, residual_map};
use crate::words::Words;
use dashpot_diagnosis::{Diagnosis, Region};

/// Builds the section of the residuals: table of regions, maps over velocity and displacement, and mean curves.
pub fn section(found: &Diagnosis, words: &Words) -> Section {
    let mut blocks = Vec::new();
    if found.regions.is_empty() {
        blocks.push(Block::Paragraph(words.no_region.into()));
    } else {
        blocks.push(Block::Table(table(&found.regions, words)));
    }
    let samples = residual::samples(&found.tests);
    let map = residual_map::maps(&samples, words);
    blocks.extend(map.map(|svg| Block::Wide(Figure::new("residual-map", svg).saying(words.left_map_caption))));
    let size = residual::size_over_velocity(&samples, words);
    let mut curves = vec![Figure::new("residual-size", size).saying(words.left_size_caption)];
    let reversal = residual::mean_since_reversal(&samples, words);
    curves.extend(reversal.map(|svg| Figure::new("residual-reversal", svg).saying(words.left_reversal_caption)));
    for (name, speeding_up, caption) in [
        ("residual-speeding-up", true, words.speeding_up_caption),
        ("residual-slowing-down", false, words.slowing_down_caption),
    ] {
        let svg = residual::mean_over_velocity(&samples, speeding_up, words);
        curves.push(Figure::new(name, svg).saying(caption));
    }
    blocks.push(Block::Figures(curves));
    Section::new("where", words.where_section, blocks)
}

fn table(regions: &[Region], words: &Words) -> Table {
    let direction = |r: &Region| if r.direction == "rebound" { words.rebound } else { words.compression };
    let speed = |r: &Region| match r.acceleration {
        "speeding_up" => words.speeding_up,
        "slowing_down" => words.slowing_down,
        _ => words.both,
    };
    let span = |ends: [f64; 2]| match ends[0].is_finite() && ends[1].is_finite() {
        true => {
            let widest = 1e3 * ends[0].abs().max(ends[1].abs());
            Cell::span(ends.map(|end| 1e3 * end), |end| comparable(end, widest))
        }
        false => Cell::none(),
    };
    let rows = regions
        .iter()
        .map(|r| {
            vec![
                if r.test == "all" { words.all_there.into() } else { r.test.as_str().into() },
                direction(r).into(),
                span(r.velocity_m_s),
                span(r.displacement_m),
                speed(r).into(),
                Cell::digits(r.mean_n, 3),
                Cell::digits(r.rmse_n, 3),
                Cell::digits(r.noise_n, 3),
                words.say(&r.text).into(),
            ]
        })
        .collect();
    let columns = vec![
        Column::words(words.col_tests),
        Column::words(words.col_direction),
        Column::figures(words.axis_velocity),
        Column::figures(words.axis_displacement),
        Column::words(words.col_speed),
        Column::figures(words.col_mean_n),
        Column::figures(words.col_rms_n),
        Column::figures(words.col_noise_n),
        Column::words(words.col_in_words),
    ];
    Table { caption: words.regions_caption.to_owned(), columns, rows, sortable: true }
}
