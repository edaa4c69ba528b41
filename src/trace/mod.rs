//! Traces: which signals, sampled how, written as VCD, FST, save file or table.
