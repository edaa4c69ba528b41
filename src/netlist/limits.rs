//! How large a circuit may be: every limit is named in the message of who meets it, and none is met by honest work.

use crate::base::Diagnostic;

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

/// A limit on what a circuit comes to, as written out by parameters and `for`: checked before the memory is taken.
#[derive(Debug)]
pub(super) struct Limit {
    code: &'static str,
    most: u64,
    what: &'static str,
    help: &'static str,
}

/// Nets, cells, module instances, parameters and pieces of connections; a long name counts as several.
pub(super) const PARTS: Limit = Limit {
    code: "N033",
    most: 1_000_000,
    what: "parts",
    help: "nets, instances, their parameters and pieces of connections count, each turn of a `for` anew",
};
/// Bits of all nets.
pub(super) const BITS: Limit =
    Limit { code: "N034", most: 4_000_000, what: "bits of nets", help: "fewer turns or instances, or narrower nets" };
/// Ops that blocks and gates are made of.
pub(super) const OPS: Limit = Limit {
    code: "N035",
    most: 4_000_000,
    what: "ops in its blocks",
    help: "fewer blocks, or smaller parameters: what `stepwright show` lists is made of ops",
};
/// Bits of all registers inside blocks.
pub(super) const REGISTER_BITS: Limit = Limit {
    code: "N036",
    most: 4_000_000,
    what: "bits of registers",
    help: "fewer blocks with state, or narrower words",
};
/// Words of all writable memories, and of all tables that differ.
pub(super) const MEMORY_WORDS: Limit = Limit {
    code: "N037",
    most: 16_000_000,
    what: "words of memory",
    help: "fewer memories, or fewer address bits; tables of equal parameters count once",
};
/// Bytes of the names of all that can be traced, each from the top down.
pub(super) const NAMES: Limit = Limit {
    code: "N038",
    most: 256 << 20,
    what: "bytes of signal names",
    help: "each signal is named from the top down: shorter names, fewer levels or fewer instances",
};

impl Limit {
    /// What to tell when a circuit has `found` of what is limited.
    pub(super) fn exceeded(&self, found: u64) -> Option<Diagnostic> {
        let Limit { code, most, what, help } = self;
        let message = || format!("the circuit has {found} {what}; at most {most} are possible");
        (found > *most).then(|| Diagnostic::new(code, message()).help(*help))
    }
}
