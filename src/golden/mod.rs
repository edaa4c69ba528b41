//! Golden traces: read and compare waveforms, find the first divergence, bless.
