//! Figures as SVG text, with one function per figure. Each function returns a complete SVG document.
//!
//! The crate has its own SVG writer, because engineers read the shape of the force loops. The writer keeps this shape: coordinates have a
//! resolution of a tenth of a pixel, and thinning of points does not change a path visibly.
//!
//! | file | figures |
//! |---|---|
//! | [`of_test`] | force and error over velocity, displacement and time; hysteresis gap |
//! | [`in_space`] | three-dimensional cross-plot of force over velocity and displacement, and its error |
//! | [`overview`] | error of every test; error by amplitude and peak velocity |
//! | [`peaks`] | peak force over peak velocity with the identified curve and limits |
//! | [`before_after`] | error and loops of single tests, before and after a diagnosis |
//! | [`inventory`] | force of every effect by amplitude and peak velocity |
//! | [`residual`], [`residual_map`] | residual force over velocity, time since the last reversal of motion, and displacement |
//!
//! In every figure the measurement is blue, the model red, and the force–velocity curve green and dashed. A model before its improvement is
//! gray and dashed. Each mark has a color for a light background. It also has a class, so that a page can recolor the figure for a dark
//! background ([`palette::page_css`]).

pub mod axes;
pub mod before_after;
pub mod in_space;
pub mod inventory;
pub mod of_test;
pub mod overview;
pub mod palette;
pub mod peaks;
pub mod residual;
pub mod residual_map;
pub mod simplify;
pub mod svg;
pub mod ticks;
