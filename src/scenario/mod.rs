//! The stimulus language, as data: it knows names, not engines.
