//! Place: every instance of every template written out, in the order of the text, an instance's inside after it.

use std::sync::Arc;

use super::size::Size;
use crate::base::{Sources, Span};
use crate::blocks::Direction;
use crate::netlist::checked::{Cell, CellId, Drive, Net, NetId, Netlist, Part, Scope, ScopeId, Source};
use crate::netlist::elaborate::{LocalInstance, LocalNet, LocalSource, Piece, Template, TemplateId};

/// The flat netlist, its roots not yet found. `given` are the parameters that are not at their defaults.
pub(super) fn place(
    sources: Arc<Sources>,
    templates: &[Template<'_>],
    given: &[(String, i64)],
    sizes: &[Size],
) -> Netlist {
    let netlist = Netlist {
        sources,
        scopes: Vec::with_capacity(sizes[0].scopes as usize),
        nets: Vec::with_capacity(sizes[0].nets as usize),
        cells: Vec::with_capacity(sizes[0].cells as usize),
        parameters: templates[0].parameters.clone(),
        given: given.to_vec(),
        inputs: ports(&templates[0], Direction::Input),
        outputs: ports(&templates[0], Direction::Output),
    };
    let mut placer = Placer { templates, sizes, netlist, stack: Vec::new() };
    placer.stack.push(Site { template: TemplateId::new(0), instance: None, nets: 0 });
    while let Some(site) = placer.stack.pop() {
        placer.site(&site);
    }
    placer.netlist
}

/// The ports of the top module, without the clock.
fn ports(top: &Template<'_>, direction: Direction) -> Vec<NetId> {
    let ports = top.nets[..top.ports].iter().enumerate();
    ports.filter(|(_, net)| net.port == Some(direction) && !net.is_clock).map(|(i, _)| NetId::new(i)).collect()
}

/// A template to be placed.
struct Site<'a> {
    template: TemplateId,
    /// The instance it is, and where the one around it stands; `None` for the top.
    instance: Option<(&'a LocalInstance, Base)>,
    /// Where its nets will begin.
    nets: usize,
}

/// Where the tables of a placed template begin.
#[derive(Clone, Copy)]
struct Base {
    scopes: usize,
    nets: usize,
    cells: usize,
}

impl Base {
    fn scope(self, local: u32) -> ScopeId {
        ScopeId::new(self.scopes + local as usize)
    }

    fn net(self, local: u32) -> NetId {
        NetId::new(self.nets + local as usize)
    }
}

struct Placer<'a, 't> {
    templates: &'a [Template<'t>],
    sizes: &'a [Size],
    netlist: Netlist,
    stack: Vec<Site<'a>>,
}

impl<'a> Placer<'a, '_> {
    fn site(&mut self, site: &Site<'a>) {
        let template = &self.templates[site.template.index()];
        let netlist = &self.netlist;
        let base = Base { scopes: netlist.scopes.len(), nets: netlist.nets.len(), cells: netlist.cells.len() };
        debug_assert_eq!(base.nets, site.nets, "the sizes tell where each instance's nets begin");
        self.scopes(site, template, base);
        // Instances are placed after this one, one after the other.
        let mut next = base.nets + template.nets.len();
        let mut children = Vec::with_capacity(template.instances.len());
        for instance in &template.instances {
            children.push(next);
            next += self.sizes[instance.template.index()].nets as usize;
        }
        self.nets(site, template, base, &children);
        self.cells(template, base);
        for (instance, &nets) in template.instances.iter().zip(&children).rev() {
            self.stack.push(Site { template: instance.template, instance: Some((instance, base)), nets });
        }
    }

    fn scopes(&mut self, site: &Site<'_>, template: &Template<'_>, base: Base) {
        for local in &template.scopes {
            let mut scope = Scope {
                name: local.name.clone(),
                parent: local.parent.map(|parent| base.scope(parent)),
                module: Arc::clone(&local.module),
                span: local.span,
            };
            if let (None, Some((instance, around))) = (local.parent, site.instance) {
                scope.name.clone_from(&instance.name);
                scope.parent = Some(around.scope(instance.scope));
                scope.span = instance.span;
            }
            self.netlist.scopes.push(scope);
        }
    }

    fn nets(&mut self, site: &Site<'_>, template: &Template<'_>, base: Base, children: &[usize]) {
        let mut input = 0;
        for (place, local) in template.nets.iter().enumerate() {
            let drives = if local.port == Some(Direction::Input) && !local.is_clock {
                input += 1;
                outside(site, place, local, input - 1)
            } else {
                local
                    .drives
                    .iter()
                    .map(|drive| inside(drive.source, base, children, drive.low, drive.width, drive.span))
                    .collect()
            };
            self.netlist.nets.push(Net {
                scope: base.scope(local.scope),
                name: local.name.clone(),
                width: local.width,
                signed: local.signed,
                fraction: local.fraction,
                port: local.port,
                is_clock: local.is_clock,
                drives,
                roots: Vec::new(),
                span: local.span,
            });
        }
    }

    fn cells(&mut self, template: &Template<'_>, base: Base) {
        for local in &template.cells {
            let part = |piece: &Piece| match *piece {
                Piece::Net { net, low, width } => Part::Net { net: base.net(net), low, width },
                Piece::Const { value, width } => Part::Const { value, width },
            };
            self.netlist.cells.push(Cell {
                scope: base.scope(local.scope),
                name: local.name.clone(),
                kind: local.kind.clone(),
                inputs: local.inputs.iter().map(|pieces| pieces.iter().map(part).collect()).collect(),
                body: Arc::clone(&local.body),
                span: local.span,
            });
        }
    }
}

/// What drives an input port from outside its module.
fn outside(site: &Site<'_>, place: usize, net: &LocalNet, input: u32) -> Vec<Drive> {
    let Some((instance, around)) = site.instance else {
        return vec![Drive { low: 0, width: net.width, source: Source::Input { input, low: 0 }, span: net.span }];
    };
    let (pieces, span) = &instance.inputs[place];
    let mut low = 0;
    let drive = |piece: &Piece| {
        let (source, width) = match *piece {
            Piece::Net { net, low, width } => (Source::Net { net: around.net(net), low }, width),
            Piece::Const { value, width } => (Source::Const(value), width),
        };
        low += width;
        Drive { low: low - width, width, source, span: *span }
    };
    pieces.iter().map(drive).collect()
}

/// What drives a net inside its module.
fn inside(source: LocalSource, base: Base, children: &[usize], low: u32, width: u32, span: Span) -> Drive {
    let source = match source {
        LocalSource::Cell { cell, output, low } => {
            Source::Cell { cell: CellId::new(base.cells + cell as usize), output, low }
        }
        LocalSource::Instance { instance, port, low } => {
            Source::Net { net: NetId::new(children[instance as usize] + port as usize), low }
        }
        LocalSource::Net { net, low } => Source::Net { net: base.net(net), low },
        LocalSource::Const(value) => Source::Const(value & crate::base::word::mask(width)),
        // Inputs are driven from outside, see above; what is wrong has stopped us before.
        LocalSource::Outside | LocalSource::Wrong => Source::Const(0),
    };
    Drive { low, width, source, span }
}
