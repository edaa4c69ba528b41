//! The native engine: the program as machine code, made by Cranelift when it is loaded.

mod count;
mod fused;
mod group;
mod host;
mod memory;
mod ops;
mod plan;
mod reads;
mod shape;
mod shared;
mod special;
mod unit;
mod word;

use std::sync::Arc;

use self::count::Counter;
use self::host::{Assembler, Code};
use self::memory::{Layout, Memory};
use self::reads::Reads;
use self::shared::Schedule;
use self::special::Special;
use super::{Engine, EngineFormat, Pulses, Stats};
use crate::base::{Diagnostic, Graph, Op, ValueId};
use crate::compile::Program;

/// The native engine by its name.
pub(super) static ENGINE: EngineFormat = EngineFormat {
    name: "native",
    doc: "Machine code, for one long run",
    runs_many: false,
    build: |program, _| Ok(Box::new(Native::new(program)?)),
};

/// Runs a program as machine code.
///
/// Two copies of the state are kept: that of the present tick and that of the next one, so that committing a tick
/// is to exchange them.
pub struct Native {
    program: Arc<Program>,
    layout: Layout,
    memory: Memory,
    code: Code,
    form: Form,
    special: Special,
    /// Inputs as set; those in memory are as last settled.
    inputs: Vec<u64>,
    stale: bool,
    watched: Reads,
    counters: Vec<Counter>,
}

/// What the code of a program looks like.
enum Form {
    /// One function with the tick loop inside.
    Fused(usize),
    /// Many functions, called once or more for each tick.
    Shared(Schedule),
}

/// Ops of a program from which it is cut into functions. Measured: below, one function runs faster, and is compiled
/// within some milliseconds.
const FUSED_OPS: usize = 1000;

impl Native {
    /// Compiles `program` and puts it at tick 0 with all inputs 0.
    ///
    /// # Errors
    /// `E001` when no code can be made for this machine, `E004` when the program's memory is too large for it.
    pub fn new(program: Arc<Program>) -> Result<Self, Diagnostic> {
        let ops = program.graph.nodes.iter().filter(|node| !node.op.is_leaf()).count();
        Self::in_form(program, ops > FUSED_OPS)
    }

    /// Compiles `program` as many functions whatever its size.
    ///
    /// # Errors
    /// As for [`Native::new`].
    pub fn shared(program: Arc<Program>) -> Result<Self, Diagnostic> {
        Self::in_form(program, true)
    }

    /// Compiles `program` and specialises the code after its first ticks, whatever they were like.
    ///
    /// # Errors
    /// As for [`Native::new`].
    pub fn eager(program: Arc<Program>) -> Result<Self, Diagnostic> {
        let mut engine = Self::new(program)?;
        if let Form::Fused(_) = engine.form {
            engine.special = Special::eager(&engine.program);
        }
        Ok(engine)
    }

    fn in_form(program: Arc<Program>, shared: bool) -> Result<Self, Diagnostic> {
        let mut assembler = Assembler::new()?;
        let (program, counters) = count::with_counters(&program);
        let stored = stored(&program, &counters);
        let program = Arc::new(program);
        let (layout, form) = if shared {
            let (layout, schedule) = shared::compile(&mut assembler, &program, stored)?;
            (layout, Form::Shared(schedule))
        } else {
            let layout = Layout::new(&program, &vec![0; stored.len()], |id| stored[id.index()])?;
            let function = fused::compile(&mut assembler, &program, &layout)?;
            (layout, Form::Fused(function))
        };
        let mut engine = Self {
            memory: Memory::new(&program, &layout),
            code: assembler.finish(&layout)?,
            inputs: vec![0; program.inputs.len()],
            stale: false,
            watched: Reads::default(),
            counters,
            special: if shared { Special::never() } else { Special::new(&program) },
            program,
            layout,
            form,
        };
        engine.settle();
        Ok(engine)
    }

    /// Settles the present tick, and up to `more` ticks after it. Returns how many were left at a stop.
    fn run(&mut self, more: u64, until_stop: bool) -> u64 {
        let mut left = more;
        loop {
            left = self.special.run(&mut self.memory, left, until_stop);
            let burst = left.min(self.special.plain_ticks());
            let unused = self.run_plainly(burst, until_stop);
            left -= burst - unused;
            if unused > 0 || left == 0 {
                return left;
            }
            let (program, layout, memory, inputs) = (&self.program, &self.layout, &self.memory, &self.inputs);
            self.special.watch(program, layout, || memory.twin(program, layout, inputs));
        }
    }

    /// The same with the code of [`Form`].
    fn run_plainly(&mut self, more: u64, until_stop: bool) -> u64 {
        let memory = &mut self.memory;
        let schedule = match &self.form {
            Form::Fused(function) => return self.code.call(*function, memory, &[until_stop.into()], more),
            Form::Shared(schedule) => schedule,
        };
        let stop = self.program.stop.filter(|_| until_stop);
        let mut left = more;
        loop {
            schedule.settle(&self.code, memory);
            if left == 0 || stop.is_some_and(|stop| memory.value(&self.layout, stop) != 0) {
                return left;
            }
            memory.commit(&self.program, &self.layout);
            left -= 1;
        }
    }
}

fn register_nodes(graph: &Graph) -> Vec<ValueId> {
    let mut nodes = vec![ValueId::new(0); graph.registers.len()];
    for (i, node) in graph.nodes.iter().enumerate() {
        if let Op::Register(register) = node.op {
            nodes[register.index()] = ValueId::new(i);
        }
    }
    nodes
}

/// Which ops must be in memory at the end of a tick: what is observed, counts, and what memories are to be
/// written.
fn stored(program: &Program, counters: &[Counter]) -> Vec<bool> {
    let graph = &program.graph;
    let mut stored = vec![false; graph.nodes.len()];
    let writes = graph.rams.iter().flat_map(|ram| [ram.write.enable, ram.write.address, ram.write.data]);
    let counts = counters.iter().flat_map(|counter| counter.values());
    for id in program.observed().into_iter().chain(writes).chain(counts) {
        stored[id.index()] = !graph.node(id).op.is_leaf();
    }
    stored
}

impl Engine for Native {
    fn name(&self) -> &'static str {
        ENGINE.name
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
        self.run(0, false);
    }

    fn advance(&mut self, ticks: u64, until_stop: bool) -> u64 {
        if self.stale {
            self.settle();
        }
        if ticks == 0 {
            return 0;
        }
        self.memory.commit(&self.program, &self.layout);
        ticks - self.run(ticks - 1, until_stop)
    }

    fn value(&self, id: ValueId) -> u64 {
        self.memory.value(&self.layout, id)
    }

    fn pulses(&self) -> Vec<Pulses> {
        self.counters.iter().map(|counter| counter.read(|id| self.value(id))).collect()
    }

    fn watch(&mut self, ids: &[ValueId]) {
        self.watched = Reads::new(&self.layout, ids);
    }

    fn read(&self, words: &mut [u64]) {
        self.watched.fill(&self.memory, words);
    }

    fn stats(&self) -> Option<&Stats> {
        self.special.stats()
    }
}
