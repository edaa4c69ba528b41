//! The one integration-test binary; each module tests one concern from outside.

/// Engines agree with each other and with the meaning of the ops.
mod engines;
/// Random circuits and stimuli.
mod generate;
mod outside;
mod simulation;
mod tidy;
mod us3809868;
