//! Timing: clocks, delays, sequences.
