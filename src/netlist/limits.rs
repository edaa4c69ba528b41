//! How large a circuit may be: every limit is named in the message of who meets it, and none is met by honest work.

/// Bytes of one circuit file.
pub(super) const TEXT_BYTES: usize = 64 << 20;
/// Bytes of the text of one memory image.
pub(super) const IMAGE_BYTES: usize = 4 << 20;
/// Letters of a name.
pub(super) const NAME_BYTES: usize = 1024;
/// Errors listed in one run.
pub(super) const ERRORS: usize = 60;
/// Operators, brackets and concatenations inside one another.
pub(super) const EXPRESSION_DEPTH: u32 = 100;
/// `for` blocks inside one another.
pub(super) const GENERATE_DEPTH: u32 = 8;
/// Turns of one `for`.
pub(super) const TURNS: usize = 1 << 16;
/// Modules inside one another.
pub(super) const MODULE_DEPTH: u32 = 64;
/// Bits of one concatenation.
pub(super) const CONCATENATION_BITS: u32 = 1 << 12;
/// Nets, cells, module instances and pieces of connections, as written out by parameters and `for`.
pub(super) const PARTS: u64 = 1_000_000;
/// Bits of all nets of the whole circuit.
pub(super) const BITS: u64 = 16_000_000;
