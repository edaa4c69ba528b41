//! A network of single-bit and/xor gates in which equal gates exist once and complements cost nothing.

use std::collections::HashMap;
use std::ops::Not;

/// The output of a gate, or its complement.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(super) struct Bit(u32);

impl Bit {
    pub(super) const FALSE: Bit = Bit(0);
    pub(super) const TRUE: Bit = Bit(1);

    /// The output of the gate at `index`.
    pub(super) fn of(index: usize) -> Self {
        Self(u32::try_from(index * 2).expect("networks hold fewer than 2^31 gates"))
    }

    pub(super) fn constant(value: bool) -> Self {
        Self(value.into())
    }

    pub(super) fn gate(self) -> usize {
        (self.0 >> 1) as usize
    }

    pub(super) fn is_complement(self) -> bool {
        self.0 & 1 == 1
    }

    fn is_constant(self) -> bool {
        self.gate() == 0
    }

    fn complemented_if(self, condition: bool) -> Self {
        Self(self.0 ^ u32::from(condition))
    }
}

impl Not for Bit {
    type Output = Self;

    fn not(self) -> Self {
        self.complemented_if(true)
    }
}

/// A gate. Operands come before it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Gate {
    /// Constant 0, only at index 0.
    False,
    /// A bit from elsewhere, known from the given stage on.
    Leaf,
    /// Both operands; the lesser first.
    And(Bit, Bit),
    /// One of the operands but not both; neither is a complement; the lesser first.
    Xor(Bit, Bit),
}

/// The network.
#[derive(Clone, Debug)]
pub(super) struct Gates {
    gates: Vec<Gate>,
    /// By gate: how many rounds of memory look-ups must be over before it can be computed.
    stages: Vec<u32>,
    known: HashMap<Gate, usize>,
}

impl Gates {
    pub(super) fn new() -> Self {
        Self { gates: vec![Gate::False], stages: vec![0], known: HashMap::new() }
    }

    pub(super) fn len(&self) -> usize {
        self.gates.len()
    }

    pub(super) fn gate(&self, index: usize) -> Gate {
        self.gates[index]
    }

    pub(super) fn stage(&self, bit: Bit) -> u32 {
        self.stages[bit.gate()]
    }

    /// A new bit from elsewhere that is known from `stage` on.
    pub(super) fn leaf(&mut self, stage: u32) -> Bit {
        self.push(Gate::Leaf, stage)
    }

    fn push(&mut self, gate: Gate, stage: u32) -> Bit {
        self.gates.push(gate);
        self.stages.push(stage);
        Bit::of(self.gates.len() - 1)
    }

    fn share(&mut self, gate: Gate, a: Bit, b: Bit) -> Bit {
        if let Some(&index) = self.known.get(&gate) {
            return Bit::of(index);
        }
        let bit = self.push(gate, self.stage(a).max(self.stage(b)));
        self.known.insert(gate, bit.gate());
        bit
    }

    pub(super) fn and(&mut self, a: Bit, b: Bit) -> Bit {
        let (a, b) = (a.min(b), a.max(b));
        match (a, b) {
            (Bit::FALSE, _) => Bit::FALSE,
            (Bit::TRUE, _) => b,
            _ if a == b => a,
            _ if a == !b => Bit::FALSE,
            _ => match self.absorbed(a, b).or_else(|| self.absorbed(b, a)) {
                Some(simple) => simple,
                None => self.share(Gate::And(a, b), a, b),
            },
        }
    }

    /// What `a & b` is when `b` is itself an and, or the complement of one, that has `a` among its operands.
    fn absorbed(&mut self, a: Bit, b: Bit) -> Option<Bit> {
        let Gate::And(x, y) = self.gates[b.gate()] else { return None };
        match b.is_complement() {
            false if x == a || y == a => Some(b),
            false if x == !a || y == !a => Some(Bit::FALSE),
            true if x == !a || y == !a => Some(a),
            true if x == a => Some(self.and(a, !y)),
            true if y == a => Some(self.and(a, !x)),
            _ => None,
        }
    }

    pub(super) fn or(&mut self, a: Bit, b: Bit) -> Bit {
        !self.and(!a, !b)
    }

    pub(super) fn xor(&mut self, a: Bit, b: Bit) -> Bit {
        let complement = a.is_complement() != b.is_complement();
        let (a, b) = (a.complemented_if(a.is_complement()), b.complemented_if(b.is_complement()));
        let plain = match self.known_xor(a, b) {
            Some(bit) => bit,
            None => self.share(Gate::Xor(a.min(b), a.max(b)), a, b),
        };
        plain.complemented_if(complement)
    }

    /// `a ^ b` of bits that are no complements, when it needs no new gate.
    fn known_xor(&self, a: Bit, b: Bit) -> Option<Bit> {
        let (a, b) = (a.min(b), a.max(b));
        if a == b {
            return Some(Bit::FALSE);
        }
        if a.is_constant() {
            return Some(b);
        }
        let other = |whole: Bit, part: Bit| match self.gates[whole.gate()] {
            Gate::Xor(x, y) if x == part => Some(y),
            Gate::Xor(x, y) if y == part => Some(x),
            _ => None,
        };
        let known = || self.known.get(&Gate::Xor(a, b)).map(|&index| Bit::of(index));
        other(b, a).or_else(|| other(a, b)).or_else(known)
    }

    /// `s` 1: `a`; 0: `b`.
    pub(super) fn mux(&mut self, s: Bit, a: Bit, b: Bit) -> Bit {
        if a == b || s == Bit::TRUE {
            return a;
        }
        if s == Bit::FALSE {
            return b;
        }
        if a == !b {
            return self.xor(s, b);
        }
        let plain = |bit: Bit| bit.complemented_if(bit.is_complement());
        // A word that toggles (a counter with enable) has the difference at hand.
        if !a.is_constant() && !b.is_constant() && self.known_xor(plain(a), plain(b)).is_some() {
            let difference = self.xor(a, b);
            let change = self.and(s, difference);
            return self.xor(b, change);
        }
        let (then, otherwise) = (self.and(s, a), self.and(!s, b));
        self.or(then, otherwise)
    }

    /// Sum and carry of three bits.
    pub(super) fn full_adder(&mut self, a: Bit, b: Bit, carry: Bit) -> (Bit, Bit) {
        let half = self.xor(a, b);
        let (both, passed) = (self.and(a, b), self.and(half, carry));
        (self.xor(half, carry), self.or(both, passed))
    }
}
