//! The native engine: the program as machine code, made by Cranelift when it is loaded.

mod fused;
mod host;
mod memory;
mod ops;
mod word;

use std::sync::Arc;

use self::host::{Assembler, Code};
use self::memory::{Layout, Memory};
use super::Engine;
use crate::base::{Diagnostic, Op, ValueId};
use crate::compile::Program;

/// Runs a program as machine code.
///
/// Two copies of the state are kept: that of the present tick and that of the next one, so that committing a tick
/// is to exchange them.
pub struct Native {
    program: Arc<Program>,
    layout: Layout,
    memory: Memory,
    code: Code,
    function: usize,
    /// Inputs as set; those in memory are as last settled.
    inputs: Vec<u64>,
    stale: bool,
}

impl Native {
    /// Compiles `program` and puts it at tick 0 with all inputs 0.
    ///
    /// # Errors
    /// `E001` when no code can be made for this machine.
    pub fn new(program: Arc<Program>) -> Result<Self, Diagnostic> {
        let stored = stored(&program);
        let group = vec![0; program.graph.nodes.len()];
        let layout = Layout::new(&program, &group, |id| stored[id.index()]);
        let mut assembler = Assembler::new()?;
        let function = fused::compile(&mut assembler, &program, &layout)?;
        let mut engine = Self {
            memory: Memory::new(&program, &layout),
            code: assembler.finish()?,
            inputs: vec![0; program.inputs.len()],
            stale: false,
            program,
            layout,
            function,
        };
        engine.settle();
        Ok(engine)
    }
}

/// Which ops must be in memory at the end of a tick: what is observed, and what memories are to be written.
fn stored(program: &Program) -> Vec<bool> {
    let graph = &program.graph;
    let mut stored = vec![false; graph.nodes.len()];
    let writes = graph.rams.iter().flat_map(|ram| [ram.write.enable, ram.write.address, ram.write.data]);
    for id in program.observed().into_iter().chain(writes) {
        stored[id.index()] = !graph.node(id).op.is_leaf();
    }
    stored
}

impl Engine for Native {
    fn name(&self) -> &'static str {
        "native"
    }

    fn set_input(&mut self, input: usize, word: u64) {
        self.inputs[input] = word;
        self.stale = true;
    }

    fn settle(&mut self) {
        for (&id, &place) in &self.layout.wires {
            let node = self.program.graph.node(id);
            if let Op::Input(input) = node.op {
                self.memory.wires.write(place, node.width, self.inputs[input as usize]);
            }
        }
        self.stale = false;
        self.code.call(self.function, &mut self.memory, &[0], 0);
    }

    fn advance(&mut self, ticks: u64, until_stop: bool) -> u64 {
        if self.stale {
            self.settle();
        }
        if ticks == 0 {
            return 0;
        }
        self.memory.write_rams(&self.program, &self.layout);
        std::mem::swap(&mut self.memory.now, &mut self.memory.next);
        let left = self.code.call(self.function, &mut self.memory, &[until_stop.into()], ticks - 1);
        ticks - left
    }

    fn value(&self, id: ValueId) -> u64 {
        self.memory.value(&self.program, &self.layout, id)
    }
}
