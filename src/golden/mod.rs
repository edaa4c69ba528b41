//! Golden traces: read and compare waveforms, find the first divergence and its cause, bless.
//!
//! Waveforms are compared by meaning: the same signals with the same values at every tick. Identifier codes, order,
//! dates and dump commands do not matter.
//!
//! ```
//! use stepwright::golden::{Signals, compare, read};
//!
//! let golden = "$scope module top $end $var wire 1 ! busy $end $upscope $end $enddefinitions $end\n\
//!               #0\n0!\n#5\n1!\n#9\n";
//! let expected = read("golden.vcd", golden.as_bytes())?;
//! let got = read("run.vcd", golden.replace("#5", "#6").as_bytes())?;
//! let comparison = compare(&expected, &got, Signals::All);
//! let divergence = comparison.divergence.as_ref().expect("they differ at tick 5");
//! assert_eq!((divergence.tick, divergence.nets[0].name.as_str()), (5, "top.busy"));
//! assert!(comparison.to_string().starts_with("tick 5: top.busy expected 1, got 0\n"));
//! # Ok::<(), stepwright::base::Report>(())
//! ```

mod bless;
mod cause;
mod codes;
mod compare;
mod cone;
mod declared;
mod diff;
mod drivers;
mod fst;
mod fst_blocks;
mod fst_numbers;
mod fst_values;
mod header;
mod how;
mod input;
mod merge;
mod pairs;
mod planes;
mod read;
mod sample;
mod show;
mod source;
mod state;
mod tails;
mod tokens;
mod track;
mod values;
mod vcd;
mod wave;
mod wrong;

pub use bless::Summary;
pub use cause::Cause;
pub use compare::{Changed, Comparison, Differing, Divergence, compare};
pub use diff::{check, diff, edges, explain};
pub use drivers::{Driven, Driver, Drivers};
pub use how::{Edge, How, Names, Signals, Unknown};
pub use input::Input;
pub use read::{read, read_golden};
pub use track::{Track, Value};
pub use wave::Waveform;
