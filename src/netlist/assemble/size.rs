//! How much a template becomes when it is written out, known before any of it is.

use crate::base::Diagnostic;
use crate::netlist::elaborate::Template;
use crate::netlist::errors::Errors;
use crate::netlist::limits;

/// What a template and all inside it come to.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Size {
    pub(super) scopes: u64,
    pub(super) nets: u64,
    pub(super) cells: u64,
    bits: u64,
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
    let Size { scopes, nets, cells, bits, depth } = sizes[0];
    let parts = scopes.saturating_add(nets).saturating_add(cells);
    let message = if parts > limits::PARTS {
        format!("the circuit has {parts} nets, cells and instances; at most {} are possible", limits::PARTS)
    } else if bits > limits::BITS {
        format!("the nets of the circuit have {bits} bits; at most {} are possible", limits::BITS)
    } else if depth > limits::MODULE_DEPTH {
        format!("instances stand {depth} deep; at most {} levels are possible", limits::MODULE_DEPTH)
    } else {
        return Some(sizes);
    };
    errors.push(Diagnostic::new("N006", message).at(templates[0].module.name.span, "in this circuit"));
    None
}

fn sum(template: &Template<'_>, sizes: &[Option<Size>]) -> Size {
    let mut size = Size {
        scopes: template.scopes.len() as u64,
        nets: template.nets.len() as u64,
        cells: template.cells.len() as u64,
        bits: template.nets.iter().map(|net| u64::from(net.width)).sum(),
        depth: 0,
    };
    for instance in &template.instances {
        let inner = sizes[instance.template.index()].unwrap_or_default();
        size.scopes = size.scopes.saturating_add(inner.scopes);
        size.nets = size.nets.saturating_add(inner.nets);
        size.cells = size.cells.saturating_add(inner.cells);
        size.bits = size.bits.saturating_add(inner.bits);
        size.depth = size.depth.max(inner.depth);
    }
    // Generate blocks inside one another are few enough not to count.
    size.depth = size.depth.saturating_add(1);
    size
}
