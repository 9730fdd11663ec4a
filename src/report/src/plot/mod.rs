//! Figures as SVG text: one function per figure, each returning a complete SVG document.
//!
//! Own writer because the loops of a damper are read for their shape: coordinates keep a tenth of a pixel, and paths
//! are thinned without moving further than the eye can see.
//!
//! | file | figures |
//! |---|---|
//! | [`of_test`] | force and error over velocity, displacement and time; hysteresis gap |
//! | [`in_space`] | the force–velocity–displacement cross-plot and its error |
//! | [`overview`] | error of every test; error by amplitude and peak velocity |
//! | [`peaks`] | peak force over peak velocity with the identified curve and limits |
//! | [`before_after`] | error and loops of single tests, before and after a diagnosis |
//! | [`inventory`] | force of every effect by amplitude and peak velocity |
//! | [`residual`], [`residual_map`] | what a model leaves, over velocity, time since reversal and displacement |
//!
//! Measured is blue, the model red, the force–velocity curve green and dashed, a model before its improvement grey and dashed,
//! in every figure. Each mark carries a
//! light-background colour and a class, so that a page may recolour the same figure for a dark background
//! ([`palette::page_css`]).

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
