//! The one place of unsafe code: owns generated machine code and calls it.

use std::mem::ManuallyDrop;

use cranelift_codegen::Context as Compiler;
use cranelift_codegen::ir::{AbiParam, InstBuilder, Value, types::I64};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Module, default_libcall_names};

use super::memory::Memory;
use crate::base::Diagnostic;

/// What generated code is given: where the areas of a [`Memory`] are. The order is that of [`Area`].
#[repr(C)]
struct Context {
    areas: [*mut u8; 5],
}

/// An area of the memory, as a place in what generated code is given.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Area {
    /// State of the present tick.
    Now,
    /// State of the next tick.
    Next,
    /// Inputs, observed values, values that pass from one function to another.
    Wires,
    /// Words of the writable memories.
    Rams,
    /// Words of the read-only memories.
    Roms,
}

impl Area {
    /// All, in order.
    pub const ALL: [Area; Self::COUNT] = [Area::Now, Area::Next, Area::Wires, Area::Rams, Area::Roms];
    /// How many there are.
    pub const COUNT: usize = 5;

    /// Where its address stands in what generated code is given.
    pub fn offset(self) -> i32 {
        self as i32 * size_of::<*mut u8>() as i32
    }
}

/// A compiled function. It takes the context and two words, and returns a word.
type Function = unsafe extern "C" fn(*const Context, *const u32, u64) -> u64;

/// Compiles functions.
pub(super) struct Assembler {
    module: JITModule,
    compiler: Compiler,
    builder: FunctionBuilderContext,
    functions: Vec<FuncId>,
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

    /// Compiles a function whose body `emit` writes, given its three arguments; `emit` returns the result.
    ///
    /// # Errors
    /// `E001` when Cranelift refuses the code.
    pub fn function(
        &mut self,
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
        self.functions.push(id);
        Ok(self.functions.len() - 1)
    }

    /// The code, ready to be called.
    ///
    /// # Errors
    /// `E001` when the machine gives no memory for code.
    pub fn finish(mut self) -> Result<Code, Diagnostic> {
        self.module.finalize_definitions().map_err(refused)?;
        let pointers = self.functions.iter().map(|&id| {
            let code = self.module.get_finalized_function(id);
            // SAFETY: `code` is a function of just this signature and calling convention, given in `function`.
            unsafe { std::mem::transmute::<*const u8, Function>(code) }
        });
        Ok(Code { functions: pointers.collect(), module: ManuallyDrop::new(self.module) })
    }
}

fn refused(why: impl std::fmt::Display) -> Diagnostic {
    Diagnostic::new("E001", format!("no native code can be made on this machine: {why}"))
        .help("run with `--engine interpreter`")
}

/// Machine code of a program.
pub(super) struct Code {
    functions: Vec<Function>,
    module: ManuallyDrop<JITModule>,
}

impl Code {
    /// Calls a function on a memory.
    ///
    /// `records` and `count` are what the function wants: see who emits it.
    pub fn call(&self, function: usize, memory: &mut Memory, records: &[u32], count: u64) -> u64 {
        let areas = [&mut memory.now, &mut memory.next, &mut memory.wires, &mut memory.rams, &mut memory.roms]
            .map(|area| area.pointer());
        let context = Context { areas };
        // SAFETY: the function lives as long as `self.module`. It reads and writes nothing but the areas and the
        // records: its addresses are offsets that `Layout` gave out (of a memory made from the same layout, because
        // an engine owns both), element addresses of memories that are limited to the element after the last, and
        // `count` records of the length that its shape has. All areas are borrowed mutably here, so nobody else
        // sees them change; they are vectors of `u64`, so every word is aligned and every bit pattern is a value.
        unsafe { self.functions[function](&raw const context, records.as_ptr(), count) }
    }
}

impl Drop for Code {
    fn drop(&mut self) {
        // SAFETY: the module is taken once, here, and no function of it can be called any more.
        unsafe { ManuallyDrop::take(&mut self.module).free_memory() }
    }
}
