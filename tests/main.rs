//! The one integration-test binary; each module tests one concern from outside.

mod outside;
mod tidy;
