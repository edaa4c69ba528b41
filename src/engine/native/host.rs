//! The only unsafe code of this engine: owns generated machine code and calls it.
#![allow(unsafe_code, reason = "machine code that was made while running can be called in no other way")]

use std::mem::ManuallyDrop;

use cranelift_codegen::Context as Compiler;
use cranelift_codegen::ir::{AbiParam, InstBuilder, Value, types::I64};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Module, default_libcall_names};

use super::memory::{Area, Bytes, Layout, Memory};
use crate::base::Diagnostic;

/// What generated code is given: where the areas of a [`Memory`] are. The order is that of [`Area`].
#[repr(C)]
struct Context {
    areas: [*mut u8; Area::COUNT],
}

/// What a function reads as its records.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Records {
    /// So many words, whatever the count.
    One(usize),
    /// So many words for each that is counted.
    Each(usize),
}

impl Records {
    fn words(self, count: u64) -> Option<usize> {
        match self {
            Records::One(words) => Some(words),
            Records::Each(words) => usize::try_from(count).ok().and_then(|count| count.checked_mul(words)),
        }
    }
}

/// A compiled function. It takes the context and two words, and returns a word.
type Function = unsafe extern "C" fn(*const Context, *const u32, u64) -> u64;

/// Compiles functions.
pub(super) struct Assembler {
    module: JITModule,
    compiler: Compiler,
    builder: FunctionBuilderContext,
    functions: Vec<(FuncId, Records)>,
}

impl Assembler {
    /// An assembler for this machine.
    ///
    /// # Errors
    /// `E001` when Cranelift makes no code for it.
    pub fn new() -> Result<Self, Diagnostic> {
        let mut flags = settings::builder();
        for (name, value) in [("opt_level", "speed"), ("enable_verifier", "false"), ("is_pic", "false")] {
            flags.set(name, value).map_err(refused)?;
        }
        let isa = cranelift_native::builder().map_err(refused)?;
        let isa = isa.finish(settings::Flags::new(flags)).map_err(refused)?;
        if isa.pointer_bits() != 64 {
            return Err(refused("its addresses do not have 64 bits"));
        }
        let module = JITModule::new(JITBuilder::with_isa(isa, default_libcall_names()));
        let compiler = module.make_context();
        Ok(Self { module, compiler, builder: FunctionBuilderContext::new(), functions: Vec::new() })
    }

    /// Compiles a function that reads so many `records`, whose body `emit` writes, given its three arguments; `emit`
    /// returns the result.
    ///
    /// # Errors
    /// `E001` when Cranelift refuses the code.
    pub fn function(
        &mut self,
        records: Records,
        emit: impl FnOnce(&mut FunctionBuilder<'_>, [Value; 3]) -> Value,
    ) -> Result<usize, Diagnostic> {
        let signature = &mut self.compiler.func.signature;
        signature.call_conv = self.module.target_config().default_call_conv;
        signature.params = vec![AbiParam::new(I64); 3];
        signature.returns = vec![AbiParam::new(I64)];
        let id = self.module.declare_anonymous_function(&self.compiler.func.signature).map_err(refused)?;
        let mut b = FunctionBuilder::new(&mut self.compiler.func, &mut self.builder);
        let entry = b.create_block();
        b.append_block_params_for_function_params(entry);
        b.switch_to_block(entry);
        let arguments = [0, 1, 2].map(|i| b.block_params(entry)[i]);
        let result = emit(&mut b, arguments);
        b.ins().return_(&[result]);
        b.seal_all_blocks();
        b.finalize(self.module.target_config());
        self.module.define_function(id, &mut self.compiler).map_err(refused)?;
        self.module.clear_context(&mut self.compiler);
        self.functions.push((id, records));
        Ok(self.functions.len() - 1)
    }

    /// The code, ready to be called on a memory of this layout.
    ///
    /// # Errors
    /// `E001` when the machine gives no memory for code.
    pub fn finish(mut self, layout: &Layout) -> Result<Code, Diagnostic> {
        self.module.finalize_definitions().map_err(refused)?;
        let functions = self.functions.iter().map(|&(id, records)| {
            let code = self.module.get_finalized_function(id);
            // SAFETY: `code` is a function of just this signature and calling convention, given in `function`.
            (unsafe { std::mem::transmute::<*const u8, Function>(code) }, records)
        });
        let areas = Area::ALL.map(|area| layout.size(area));
        Ok(Code { functions: functions.collect(), areas, module: ManuallyDrop::new(self.module) })
    }
}

fn refused(why: impl std::fmt::Display) -> Diagnostic {
    Diagnostic::new("E001", format!("no native code can be made on this machine: {why}"))
        .help("run with `--engine interpreter`")
}

/// Machine code of a program.
pub(super) struct Code {
    functions: Vec<(Function, Records)>,
    /// Bytes that the areas must have.
    areas: [usize; Area::COUNT],
    module: ManuallyDrop<JITModule>,
}

impl Code {
    /// Calls a function on a memory.
    ///
    /// `records` and `count` are what the function wants: see who emits it.
    ///
    /// # Panics
    /// When an area of the memory is smaller than the code was made for, or there are too few records.
    pub fn call(&self, function: usize, memory: &mut Memory, records: &[u32], count: u64) -> u64 {
        let (function, wanted) = self.functions[function];
        assert!(wanted.words(count).is_some_and(|words| words <= records.len()), "too few records");
        let areas = memory.areas();
        let large_enough = areas.iter().zip(self.areas).all(|(area, size)| area.as_bytes().len() >= size);
        assert!(large_enough, "a memory of another layout");
        let context = Context { areas: areas.map(Bytes::pointer) };
        // SAFETY: the function lives as long as `self.module`. It reads and writes nothing but the areas and the
        // records: its addresses are offsets that `Layout` gave out, which are below the sizes asserted above,
        // element addresses of memories that are limited to the element after the last, and the records counted
        // above. All areas are borrowed mutably here, so nobody else sees them change; they are vectors of `u64`, so
        // every word is aligned and every bit pattern is a value.
        unsafe { function(&raw const context, records.as_ptr(), count) }
    }
}

impl Drop for Code {
    fn drop(&mut self) {
        // SAFETY: the module is taken once, here, and no function of it can be called any more.
        unsafe { ManuallyDrop::take(&mut self.module).free_memory() }
    }
}
