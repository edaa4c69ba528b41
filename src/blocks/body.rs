//! A block made of ops, for one set of parameters.

use crate::base::{Graph, Op, ValueId};

/// What a block turns into: ops, with inputs and outputs in the order of the block's ports of each direction.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Body {
    /// Ops and state. `Op::Input(i)` is `inputs[i]`.
    pub graph: Graph,
    /// Width of each input.
    pub inputs: Vec<u32>,
    /// Value of each output.
    pub outputs: Vec<ValueId>,
    /// Named values inside, for the waveform.
    pub signals: Vec<InnerSignal>,
}

/// A named value inside a block.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct InnerSignal {
    /// Sub-scopes from the block inwards, then the name.
    pub path: Vec<String>,
    /// Whether the word is two's complement.
    pub signed: bool,
    /// Where the value is.
    pub value: ValueId,
}

/// What one copy of a body takes when a circuit is written out.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Cost {
    /// Ops.
    pub ops: u64,
    /// Bits of its registers.
    pub register_bits: u64,
    /// Words of its writable memories. Copies share the words of read-only ones.
    pub ram_words: u64,
}

impl Body {
    /// What one copy takes.
    #[must_use]
    pub fn cost(&self) -> Cost {
        Cost {
            ops: self.graph.nodes.len() as u64,
            register_bits: self.graph.registers.iter().map(|register| u64::from(register.width)).sum(),
            ram_words: self.graph.rams.iter().map(|ram| ram.image.depth() as u64).sum(),
        }
    }

    /// Words of the images that all copies share.
    #[must_use]
    pub fn image_words(&self) -> u64 {
        let roms = self.graph.roms.iter().map(|rom| &rom.image);
        let images = roms.chain(self.graph.rams.iter().map(|ram| &ram.image));
        images.map(|image| image.depth() as u64).sum()
    }

    /// For each output, which inputs it depends on within the same tick. Registers break the dependency: only
    /// ops are followed, so this needs no knowledge of any block by name.
    #[must_use]
    pub fn combinational_edges(&self) -> Vec<Vec<bool>> {
        self.outputs.iter().map(|&output| self.inputs_read_by(output)).collect()
    }

    fn inputs_read_by(&self, output: ValueId) -> Vec<bool> {
        let mut read = vec![false; self.inputs.len()];
        let mut seen = vec![false; self.graph.nodes.len()];
        let mut open = vec![output];
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut seen[id.index()], true) {
                continue;
            }
            let op = self.graph.node(id).op;
            if let Op::Input(input) = op {
                read[input as usize] = true;
            }
            op.operands(|operand| open.push(operand));
        }
        read
    }
}
