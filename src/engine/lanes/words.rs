//! The ops on words as gates on their bits, low bit first.

use super::gates::{Bit, Gates};

impl Gates {
    pub(super) fn each(&mut self, a: &[Bit], b: &[Bit], gate: fn(&mut Self, Bit, Bit) -> Bit) -> Vec<Bit> {
        a.iter().zip(b).map(|(&a, &b)| gate(self, a, b)).collect()
    }

    /// `a + b + carry`, and the carry out.
    fn sum(&mut self, a: &[Bit], b: impl Iterator<Item = Bit>, mut carry: Bit) -> (Vec<Bit>, Bit) {
        let mut sum = Vec::with_capacity(a.len());
        for (&a, b) in a.iter().zip(b) {
            let (bit, next) = self.full_adder(a, b, carry);
            sum.push(bit);
            carry = next;
        }
        (sum, carry)
    }

    pub(super) fn add(&mut self, a: &[Bit], b: &[Bit]) -> Vec<Bit> {
        self.sum(a, b.iter().copied(), Bit::FALSE).0
    }

    pub(super) fn sub(&mut self, a: &[Bit], b: &[Bit]) -> Vec<Bit> {
        self.sum(a, b.iter().map(|&b| !b), Bit::TRUE).0
    }

    /// Shift and add. The operand with more constant bits selects the rows, so that a factor known at
    /// compile time leaves few of them.
    pub(super) fn mul(&mut self, a: &[Bit], b: &[Bit]) -> Vec<Bit> {
        let zeros = |word: &[Bit]| word.iter().filter(|&&bit| bit == Bit::FALSE).count();
        let (rows, word) = if zeros(a) > zeros(b) { (a, b) } else { (b, a) };
        let mut product = vec![Bit::FALSE; a.len()];
        for (i, &row) in rows.iter().enumerate() {
            let partial: Vec<_> = word[..a.len() - i].iter().map(|&bit| self.and(row, bit)).collect();
            let (sum, _) = self.sum(&product[i..], partial.into_iter(), Bit::FALSE);
            product[i..].copy_from_slice(&sum);
        }
        product
    }

    /// The and of all bits, as a tree.
    pub(super) fn all(&mut self, bits: &[Bit]) -> Bit {
        self.tree(bits, Bit::TRUE, Self::and)
    }

    pub(super) fn any(&mut self, bits: &[Bit]) -> Bit {
        self.tree(bits, Bit::FALSE, Self::or)
    }

    pub(super) fn odd(&mut self, bits: &[Bit]) -> Bit {
        self.tree(bits, Bit::FALSE, Self::xor)
    }

    fn tree(&mut self, bits: &[Bit], of_none: Bit, gate: fn(&mut Self, Bit, Bit) -> Bit) -> Bit {
        let mut level = bits.to_vec();
        while level.len() > 1 {
            level = level.chunks(2).map(|pair| if let [a, b] = *pair { gate(self, a, b) } else { pair[0] }).collect();
        }
        level.first().copied().unwrap_or(of_none)
    }

    pub(super) fn equal(&mut self, a: &[Bit], b: &[Bit]) -> Bit {
        let differences = self.each(a, b, Self::xor);
        !self.any(&differences)
    }

    /// Unsigned `a < b`: the borrow of `a - b`.
    pub(super) fn less(&mut self, a: &[Bit], b: &[Bit]) -> Bit {
        !self.sum(a, b.iter().map(|&b| !b), Bit::TRUE).1
    }

    /// The same in two's complement: with the top bits complemented the order is that of unsigned words.
    pub(super) fn less_signed(&mut self, a: &[Bit], b: &[Bit]) -> Bit {
        let biased = |word: &[Bit]| {
            let mut word = word.to_vec();
            if let Some(top) = word.last_mut() {
                *top = !*top;
            }
            word
        };
        self.less(&biased(a), &biased(b))
    }

    /// `a` moved towards the low end, one stage for each bit of `amount`; what comes in at the top is `fill`.
    pub(super) fn shift_right(&mut self, a: &[Bit], amount: &[Bit], fill: Bit) -> Vec<Bit> {
        let mut word = a.to_vec();
        for (i, &select) in amount.iter().enumerate() {
            let distance = 1usize.checked_shl(i as u32).unwrap_or(usize::MAX).min(word.len());
            let moved: Vec<_> = word[distance..].iter().copied().chain(std::iter::repeat_n(fill, distance)).collect();
            word = self.select(select, &moved, &word);
        }
        word
    }

    pub(super) fn shift_left(&mut self, a: &[Bit], amount: &[Bit]) -> Vec<Bit> {
        let reversed: Vec<_> = a.iter().rev().copied().collect();
        let mut shifted = self.shift_right(&reversed, amount, Bit::FALSE);
        shifted.reverse();
        shifted
    }

    /// A multiplexer of words.
    pub(super) fn select(&mut self, s: Bit, a: &[Bit], b: &[Bit]) -> Vec<Bit> {
        a.iter().zip(b).map(|(&a, &b)| self.mux(s, a, b)).collect()
    }

    /// The word at `address` of a table, 0 beyond its end: a tree of multiplexers.
    pub(super) fn look_up(&mut self, table: &[Vec<Bit>], address: &[Bit], width: usize) -> Vec<Bit> {
        let zero = || vec![Bit::FALSE; width];
        let Some((first, _)) = table.split_first() else { return zero() };
        let Some((&top, rest)) = address.split_last() else { return first.clone() };
        let half = 1usize.checked_shl(rest.len() as u32).unwrap_or(usize::MAX).min(table.len());
        let low = self.look_up(&table[..half], rest, width);
        let high = self.look_up(&table[half..], rest, width);
        self.select(top, &high, &low)
    }
}
