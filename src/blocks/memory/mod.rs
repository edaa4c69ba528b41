//! Memory: registers, triggers, counters, stores.

pub mod register;
pub mod rom;
pub mod shift_register;
pub mod subtracting_counter;
pub mod trigger;
