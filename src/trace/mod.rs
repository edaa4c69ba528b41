//! Traces: what looks at a run, and what it makes of it: waveforms, save files, tables, paths.
//!
//! ```
//! use stepwright::base::{Signal, ValueId};
//! use stepwright::trace::{Frame, Observer, VCD, Wave};
//!
//! let path = |net: &str| vec!["top".to_owned(), "counter_14".to_owned(), net.to_owned()];
//! let signal = |net, width, value| Signal {
//!     path: path(net), width, signed: false, fraction: None, value: ValueId::new(value),
//! };
//! let mut text = Vec::new();
//! let mut wave = Wave::new(VCD, Box::new(std::io::Cursor::new(&mut text)));
//! wave.begin(&[signal("count", 4, 0), signal("overflow", 1, 1)])?;
//! for tick in 0..3 {
//!     let words = |tick| [tick % 16, u64::from(tick == 2)];
//!     let before = (tick > 0).then(|| words(tick - 1));
//!     wave.tick(Frame { tick, words: &words(tick), before: before.as_ref().map(|words| &words[..]) })?;
//! }
//! wave.end()?;
//! drop(wave);
//! assert!(text.ends_with(b"#1\nb0001 !\n#2\nb0010 !\n1\"\n#3\n"));
//! # Ok::<(), stepwright::base::Report>(())
//! ```

mod ascii;
mod csv;
mod edges;
mod formats;
mod fst;
mod gtkw;
mod observer;
mod part;
mod path;
mod picture;
mod plan;
mod sampler;
mod select;
mod table;
mod vcd;
mod wave;
mod writer;

pub use csv::CsvTable;
pub use edges::Edges;
pub use formats::FORMATS;
pub use fst::FstWriter;
pub use gtkw::{SaveFile, SaveText};
pub use observer::{Frame, Observer};
pub use part::{Last, When};
pub use path::{Coordinate, Path};
pub use picture::Picture;
pub use plan::{Item, Plan, Slot, SlotId};
pub use sampler::{Change, Sampler, Window};
pub use select::Select;
pub use table::{Rows, Table};
pub use vcd::VcdWriter;
pub use wave::Wave;
pub use writer::{Format, WaveWriter};

/// The format that everything reads.
pub static VCD: &Format = &vcd::FORMAT;
