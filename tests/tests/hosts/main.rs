//! The damper in its hosts: C interface, Adams, FMI, real-time bridge and the shims for other simulators. One program, so that the long ones run
//! beside each other.

mod abi_hosts;
mod abi_symbols;
mod adams;
mod adams_export;
mod adams_interface;
mod adams_rig;
mod adams_windows;
mod bridge_accuracy;
mod c_example;
mod cosim;
mod damaged;
mod fmu;
mod fmu_habits;
mod fmu_matrix;
mod fmu_partials;
mod fmu_solvers;
mod fmu_starts;
mod fmu_tuned;
mod fmu_units;
mod mujoco;
mod octave;
mod python_hosts;
mod setting;
mod simulator_shims;
mod static_library;
mod vehicle_bridge;
mod vi_crt_bridge;
mod your_loop;
