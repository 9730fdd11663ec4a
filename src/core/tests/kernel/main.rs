//! The tests of the kernel (the damper model of this crate) through its public interface. They form one program, so
//! that long tests run in parallel.

mod accuracy;
mod common;
mod elements;
mod equations;
mod examples;
mod family;
mod family_passivity;
mod order;
mod parallel_elements;
mod partials;
mod passivity;
mod paths;
mod paths_accuracy;
mod semi_implicit;
mod sizes;
mod stability;
mod state;
mod stiff_springs;
mod without_slopes;
