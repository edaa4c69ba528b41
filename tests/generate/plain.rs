//! A plain reading of a graph as arithmetic on whole numbers; it shares nothing with the engines.

use stepwright::base::{Graph, Op, Register, ValueId};

/// A graph whose ops stand after their operands, at some tick.
pub struct Plain<'a> {
    graph: &'a Graph,
    /// Words of the inputs.
    pub inputs: Vec<u64>,
    registers: Vec<u128>,
    rams: Vec<Vec<u128>>,
    values: Vec<u128>,
}

impl<'a> Plain<'a> {
    /// The graph at tick 0, its inputs 0.
    pub fn new(graph: &'a Graph, inputs: usize) -> Self {
        let mut plain = Self {
            graph,
            inputs: vec![0; inputs],
            registers: graph.registers.iter().map(|register| register.init.into()).collect(),
            rams: graph.rams.iter().map(|ram| ram.image.words().iter().copied().map(u128::from).collect()).collect(),
            values: Vec::new(),
        };
        plain.settle();
        plain
    }

    /// The word of a value.
    pub fn value(&self, id: ValueId) -> u64 {
        self.values[id.index()] as u64
    }

    /// Computes every value.
    pub fn settle(&mut self) {
        self.values.clear();
        for node in &self.graph.nodes {
            let value = self.number(node.op, node.width).rem_euclid(1 << node.width);
            self.values.push(value as u128);
        }
    }

    /// Ends the tick.
    pub fn commit(&mut self) {
        for (i, ram) in self.graph.rams.iter().enumerate() {
            let [enable, address, data] = [ram.write.enable, ram.write.address, ram.write.data].map(|id| self.of(id));
            if enable == 1 && address < self.rams[i].len() as u128 {
                self.rams[i][address as usize] = data;
            }
        }
        let next = |(register, &old): (&Register, &u128)| match (register.clear, register.enable) {
            (Some(clear), _) if self.of(clear) == 1 => register.init.into(),
            (_, Some(enable)) if self.of(enable) == 0 => old,
            _ => self.of(register.next),
        };
        self.registers = self.graph.registers.iter().zip(&self.registers).map(next).collect();
    }

    fn of(&self, id: ValueId) -> u128 {
        self.values[id.index()]
    }

    /// The number an op stands for, before it is taken modulo 2^width.
    fn number(&self, op: Op, width: u32) -> i128 {
        let n = |id: ValueId| self.of(id) as i128;
        let size = |id: ValueId| self.graph.width(id);
        let signed = |id: ValueId| if n(id) >= 1 << (size(id) - 1) { n(id) - (1 << size(id)) } else { n(id) };
        let bits = |id: ValueId| (0..size(id)).map(move |i| n(id) >> i & 1);
        let bitwise = |a: ValueId, b: ValueId, f: fn(i128, i128) -> bool| {
            bits(a).zip(bits(b)).enumerate().map(|(i, (x, y))| i128::from(f(x, y)) << i).sum::<i128>()
        };
        let word = |words: &[u128], at: ValueId| words.get(usize::try_from(self.of(at)).unwrap_or(usize::MAX)).copied();
        match op {
            Op::Const(value) => value.into(),
            Op::Input(i) => self.inputs[i as usize].into(),
            Op::Register(id) => self.registers[id.index()] as i128,
            Op::Copy(a) | Op::ZeroExtend(a) => n(a),
            Op::Not(a) => (1 << width) - 1 - n(a),
            Op::And(a, b) => bitwise(a, b, |x, y| x + y == 2),
            Op::Or(a, b) => bitwise(a, b, |x, y| x + y > 0),
            Op::Xor(a, b) => bitwise(a, b, |x, y| x + y == 1),
            Op::Add(a, b) => n(a) + n(b),
            Op::Sub(a, b) => n(a) - n(b),
            Op::Mul(a, b) => (self.of(a) * self.of(b) % (1 << width)) as i128,
            Op::Eq(a, b) => (n(a) == n(b)).into(),
            Op::LtU(a, b) => (n(a) < n(b)).into(),
            Op::LtS(a, b) => (signed(a) < signed(b)).into(),
            Op::Shl(a, by) if n(by) < 64 => (self.of(a) << n(by) & u128::from(u64::MAX)) as i128,
            Op::Shl(..) => 0,
            Op::ShrU(a, by) => n(a) >> n(by).min(64),
            Op::ShrS(a, by) => signed(a).div_euclid(1 << n(by).min(64)),
            Op::Mux(s, a, b) => [n(b), n(a)][n(s) as usize],
            Op::Slice(a, low) => n(a) / (1 << low),
            Op::Concat(high, low) => n(high) * (1 << size(low)) + n(low),
            Op::SignExtend(a) => signed(a),
            Op::ReduceAnd(a) => bits(a).product(),
            Op::ReduceOr(a) => (bits(a).sum::<i128>() > 0).into(),
            Op::ReduceXor(a) => bits(a).sum(),
            Op::RomRead(rom, at) => {
                let words: Vec<_> =
                    self.graph.roms[rom.index()].image.words().iter().copied().map(u128::from).collect();
                word(&words, at).unwrap_or(0) as i128
            }
            Op::RamRead(ram, at) => word(&self.rams[ram.index()], at).unwrap_or(0) as i128,
        }
    }
}
