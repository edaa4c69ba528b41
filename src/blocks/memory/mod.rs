//! Memory: registers, triggers, counters, stores.

pub mod angle_converter;
pub mod binary_counter;
pub mod checksum;
mod glyphs;
pub mod instruction_counter;
pub mod instruction_memory;
pub mod lfsr;
pub mod pointer_table;
pub mod position_counter;
pub mod presettable_memory;
pub mod register;
pub mod reversible_counter;
pub mod rom;
pub mod shift_register;
pub mod subtracting_counter;
pub mod table_memory;
pub mod trajectory_counter;
pub mod trigger;
