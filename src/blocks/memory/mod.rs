//! Memory: registers, triggers, counters, stores.
