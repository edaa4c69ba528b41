//! Roots: each bit followed through the nets that only pass it on, to what really drives it.
//!
//! Bit by bit, because a vector may route its own lower bits to its higher ones, which is no loop.

use std::collections::HashSet;

use crate::base::Diagnostic;
use crate::netlist::checked::{Drive, Netlist, Source};
use crate::netlist::errors::Errors;

/// Fills in `Net::roots`; notes bits that drive themselves.
pub(super) fn find(netlist: &mut Netlist, errors: &mut Errors) {
    let mut bits = Bits::new(netlist);
    bits.resolve();
    bits.report(netlist, errors);
    for (net, first) in netlist.nets.iter_mut().zip(&bits.first) {
        net.roots = grouped(&net.drives, &bits.sources[*first..*first + net.width as usize]);
    }
}

/// Every bit of every net.
struct Bits {
    /// Where the bits of each net begin.
    first: Vec<usize>,
    /// What drives each bit, followed as far as it has been; the low bit of a source is the bit itself.
    sources: Vec<Source>,
    /// For each bit, whether it is its own root, round some nets.
    looped: Vec<usize>,
}

impl Bits {
    fn new(netlist: &Netlist) -> Self {
        let mut first = Vec::with_capacity(netlist.nets.len());
        let mut sources = Vec::new();
        for net in &netlist.nets {
            first.push(sources.len());
            sources.resize(sources.len() + net.width as usize, Source::Const(0));
            let bits = sources.len() - net.width as usize;
            for drive in &net.drives {
                for bit in 0..drive.width {
                    sources[bits + (drive.low + bit) as usize] = above(drive.source, bit);
                }
            }
        }
        Bits { first, sources, looped: Vec::new() }
    }

    /// The bit that drives a bit, if that is a net's.
    fn next(&self, bit: usize) -> Option<usize> {
        match self.sources[bit] {
            Source::Net { net, low } => Some(self.first[net.index()] + low as usize),
            _ => None,
        }
    }

    /// Follows every bit; those on the way get the same root, so that each is passed once.
    fn resolve(&mut self) {
        // Which walk has passed a bit, counted from 1.
        let mut passed = vec![0_u32; self.sources.len()];
        let mut way = Vec::new();
        for start in 0..self.sources.len() {
            let walk = start as u32 + 1;
            let mut bit = start;
            way.clear();
            while let Some(next) = self.next(bit) {
                if passed[bit] == walk {
                    self.looped.push(bit);
                    break;
                }
                if passed[bit] != 0 {
                    break;
                }
                passed[bit] = walk;
                way.push(bit);
                bit = next;
            }
            let root = self.sources[bit];
            if !matches!(root, Source::Net { .. }) {
                way.iter().for_each(|&bit| self.sources[bit] = root);
            }
        }
    }

    /// Notes each loop once, with all nets on it.
    fn report(&self, netlist: &Netlist, errors: &mut Errors) {
        let mut told = HashSet::new();
        for &start in &self.looped {
            let mut diagnostic = Diagnostic::new("N025", "this net drives itself");
            let mut bit = start;
            let mut hops = 0;
            loop {
                let at = self.first.partition_point(|&first| first <= bit) - 1;
                let (net, low) = (&netlist.nets[at], (bit - self.first[at]) as u32);
                if !told.insert(bit) {
                    break;
                }
                let drive = net.drives.iter().find(|drive| (drive.low..drive.low + drive.width).contains(&low));
                if let Some(drive) = drive.filter(|_| hops < 20) {
                    diagnostic = diagnostic.at(drive.span, format!("bit {low} of `{}` is driven here", net.name));
                }
                hops += 1;
                match self.next(bit) {
                    Some(next) => bit = next,
                    None => break,
                }
            }
            if hops > 0 {
                let help = "no gate or block is in this round trip: one of its nets must be driven by something else";
                errors.push(diagnostic.help(help));
            }
        }
    }
}

/// A source's bit further up.
fn above(source: Source, bits: u32) -> Source {
    match source {
        Source::Input { input, low } => Source::Input { input, low: low + bits },
        Source::Cell { cell, output, low } => Source::Cell { cell, output, low: low + bits },
        Source::Net { net, low } => Source::Net { net, low: low + bits },
        Source::Const(value) => Source::Const(value.checked_shr(bits).unwrap_or(0) & 1),
    }
}

/// Bits that go on from one another, as one.
fn grouped(drives: &[Drive], bits: &[Source]) -> Vec<Drive> {
    let mut roots: Vec<Drive> = Vec::with_capacity(drives.len());
    for drive in drives {
        for bit in drive.low..drive.low + drive.width {
            let source = bits[bit as usize];
            match roots.last_mut() {
                Some(Drive { low, width, source: Source::Const(value), span })
                    if *span == drive.span && *low + *width == bit =>
                {
                    if let Source::Const(next) = source {
                        *value |= next << *width;
                        *width += 1;
                        continue;
                    }
                }
                Some(Drive { width, source: last, .. }) if above(*last, *width) == source => {
                    *width += 1;
                    continue;
                }
                _ => {}
            }
            roots.push(Drive { low: bit, width: 1, source, span: drive.span });
        }
    }
    roots
}
