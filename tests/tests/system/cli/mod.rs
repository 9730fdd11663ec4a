//! Tests of the program `dashpot` as its users run it.

mod about;
mod accuracy;
mod against;
mod bounds;
mod changes;
mod check;
mod contract;
mod diagnose;
mod excel;
mod family;
mod limits;
mod manoeuvre;
mod mistakes;
mod nothing_lost;
mod one_clock;
mod one_sign;
mod records;
mod same_result;
mod simulate;
