//! Traces: which signals, sampled how, written as VCD, FST, save file or table.
//!
//! ```
//! use stepwright::base::{Signal, ValueId};
//! use stepwright::trace::{Plan, Sampler, VcdWriter, Window};
//!
//! let path = |net: &str| vec!["top".to_owned(), "counter_14".to_owned(), net.to_owned()];
//! let signal = |net, width, value| Signal {
//!     path: path(net), width, signed: false, fraction: None, value: ValueId::new(value),
//! };
//! let plan = Plan::new(&[signal("count", 4, 0), signal("overflow", 1, 1)]);
//! let mut sampler = Sampler::new(&plan, Window::ALL);
//! let mut vcd = VcdWriter::new(Vec::new(), &plan)?;
//! for tick in 0..3 {
//!     let words = [tick % 16, u64::from(tick == 2)];
//!     if let Some(changes) = sampler.sample(tick, |id| words[id.index()]) {
//!         vcd.tick(tick, changes)?;
//!     }
//! }
//! let text = String::from_utf8(vcd.finish()?).unwrap();
//! assert!(text.ends_with("#1\nb0001 !\n#2\nb0010 !\n1\"\n#3\n"));
//! # Ok::<(), std::io::Error>(())
//! ```

mod ascii;
mod fst;
mod gtkw;
mod plan;
mod sampler;
mod select;
mod table;
mod vcd;

pub use fst::FstWriter;
pub use gtkw::SaveFile;
pub use plan::{Item, Plan, Slot, SlotId};
pub use sampler::{Change, Sampler, Window};
pub use select::Select;
pub use table::Table;
pub use vcd::VcdWriter;
