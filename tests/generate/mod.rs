//! Random circuits and stimuli, for the tests and for the fuzz targets, and a plain reading of what they mean.

pub mod circuits;
pub mod composites;
pub mod graphs;
pub mod listing;
pub mod plain;
pub mod replicas;
pub mod stimulus;
