//! Pulses: trains of one-tick strobes and their rates.
