//! How much a template becomes when it is written out, known before any of it is.

use crate::base::Diagnostic;
use crate::netlist::checked::CellKind;
use crate::netlist::elaborate::{LocalCell, Template};
use crate::netlist::errors::Errors;
use crate::netlist::limits;

/// What a template and all inside it come to.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Size {
    pub(super) scopes: u64,
    pub(super) nets: u64,
    pub(super) cells: u64,
    bits: u64,
    ops: u64,
    register_bits: u64,
    ram_words: u64,
    /// What can be traced: nets, ports of blocks, words named inside them.
    signals: u64,
    /// Bytes of the names of these, from the template down.
    names: u64,
    depth: u32,
}

/// The sizes of all templates that the first one needs, unless it is too large.
pub(super) fn measure(templates: &[Template<'_>], errors: &mut Errors) -> Option<Vec<Size>> {
    let mut sizes = vec![None; templates.len()];
    let mut stack = vec![(0, false)];
    while let Some((at, inside_done)) = stack.pop() {
        if inside_done {
            sizes[at] = Some(sum(&templates[at], &sizes));
        } else if sizes[at].is_none() {
            stack.push((at, true));
            stack.extend(templates[at].instances.iter().map(|instance| (instance.template.index(), false)));
        }
    }
    let sizes: Vec<Size> = sizes.into_iter().map(Option::unwrap_or_default).collect();
    let excess = sizes[0].excess();
    let is_small = excess.is_empty();
    for diagnostic in excess {
        errors.push(diagnostic.at(templates[0].module.name.span, "in this circuit"));
    }
    is_small.then_some(sizes)
}

impl Size {
    /// Every limit that is passed.
    fn excess(&self) -> Vec<Diagnostic> {
        let parts = self.scopes.saturating_add(self.nets).saturating_add(self.cells);
        let limits = [
            (&limits::PARTS, parts),
            (&limits::BITS, self.bits),
            (&limits::OPS, self.ops),
            (&limits::REGISTER_BITS, self.register_bits),
            (&limits::MEMORY_WORDS, self.ram_words),
            (&limits::NAMES, self.names),
        ];
        let depth = (self.depth > limits::MODULE_DEPTH).then(|| {
            let message = format!("instances stand {} deep", self.depth);
            Diagnostic::new("N006", format!("{message}; at most {} levels are possible", limits::MODULE_DEPTH))
        });
        limits.into_iter().filter_map(|(limit, found)| limit.exceeded(found)).chain(depth).collect()
    }

    /// Adds what stands inside, whose names get `prefix` more bytes.
    fn add(&mut self, other: &Size, prefix: u64) {
        let add = |sum: &mut u64, more: u64| *sum = sum.saturating_add(more);
        add(&mut self.scopes, other.scopes);
        add(&mut self.nets, other.nets);
        add(&mut self.cells, other.cells);
        add(&mut self.bits, other.bits);
        add(&mut self.ops, other.ops);
        add(&mut self.register_bits, other.register_bits);
        add(&mut self.ram_words, other.ram_words);
        add(&mut self.signals, other.signals);
        add(&mut self.names, other.names.saturating_add(other.signals.saturating_mul(prefix)));
        self.depth = self.depth.max(other.depth);
    }
}

/// What a name takes as one part of a path.
fn path_part(name: &str) -> u64 {
    (size_of::<String>() + name.len()) as u64
}

fn sum(template: &Template<'_>, sizes: &[Option<Size>]) -> Size {
    let mut size = Size { scopes: template.scopes.len() as u64, ..Size::default() };
    // What leads to each scope, without the template's own name: that is its instance's.
    let mut paths: Vec<u64> = Vec::with_capacity(template.scopes.len());
    for scope in &template.scopes {
        paths.push(scope.parent.map_or(0, |parent| paths[parent as usize] + path_part(&scope.name)));
    }
    for net in &template.nets {
        let names = path_part(&net.name);
        let one = Size { nets: 1, bits: net.width.into(), signals: 1, names, ..Size::default() };
        size.add(&one, paths[net.scope as usize]);
    }
    for cell in &template.cells {
        size.add(&of_cell(cell), paths[cell.scope as usize]);
    }
    for instance in &template.instances {
        let inner = sizes[instance.template.index()].unwrap_or_default();
        size.add(&inner, paths[instance.scope as usize] + path_part(&instance.name));
    }
    // Generate blocks inside one another are few enough not to count.
    size.depth = size.depth.saturating_add(1);
    size
}

fn of_cell(cell: &LocalCell) -> Size {
    let cost = cell.body.cost();
    let mut size = Size {
        cells: 1,
        ops: cost.ops,
        register_bits: cost.register_bits,
        ram_words: cost.ram_words,
        ..Size::default()
    };
    if let CellKind::Block { block, .. } = &cell.kind {
        let ports = block.description().ports.iter().map(|port| path_part(port.name));
        let inner = cell.body.signals.iter().map(|signal| signal.path.iter().map(|name| path_part(name)).sum());
        for names in ports.chain(inner) {
            size.signals += 1;
            size.names += path_part(&cell.name) + names;
        }
    }
    size
}
