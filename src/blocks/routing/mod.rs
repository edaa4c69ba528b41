//! Routing: which word goes where.
