//! Logic: decisions made without memory.
