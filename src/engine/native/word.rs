//! Words in generated code: which machine type holds one, and how many of its low bits can be set.

use cranelift_codegen::ir::types::{I8, I32, I64};
use cranelift_codegen::ir::{InstBuilder, Type, Value};
use cranelift_frontend::FunctionBuilder;

use crate::base::word::mask;

/// The machine type of a word of `width` bits.
pub(super) fn machine_type(width: u32) -> Type {
    match width {
        1 => I8,
        2..=32 => I32,
        _ => I64,
    }
}

/// A value of generated code that stands for a word. Its machine type is that of the word's width.
///
/// Masking is put off: bits above the word's width may hold rubbish, as far as `bits` says. A one-bit word never
/// holds any.
#[derive(Clone, Copy, Debug)]
pub(super) struct Word {
    /// The machine value.
    pub value: Value,
    /// It is less than `2^bits`.
    pub bits: u32,
}

/// A constant of a machine type, cut to it.
pub(super) fn constant(b: &mut FunctionBuilder<'_>, ty: Type, value: u64) -> Value {
    b.ins().iconst(ty, (value & mask(ty.bits())) as i64)
}

/// A value in another machine type: cut, or widened with zeros.
pub(super) fn resize(b: &mut FunctionBuilder<'_>, value: Value, to: Type) -> Value {
    let from = b.func.dfg.value_type(value);
    match from.bits().cmp(&to.bits()) {
        std::cmp::Ordering::Less => b.ins().uextend(to, value),
        std::cmp::Ordering::Equal => value,
        std::cmp::Ordering::Greater => b.ins().ireduce(to, value),
    }
}

/// The value with all bits from `width` on cleared.
pub(super) fn cut(b: &mut FunctionBuilder<'_>, value: Value, width: u32) -> Value {
    let ty = b.func.dfg.value_type(value);
    let mask = constant(b, ty, mask(width));
    b.ins().band(value, mask)
}
