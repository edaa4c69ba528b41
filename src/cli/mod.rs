//! The command line: the only room that prints and opens files by name.
