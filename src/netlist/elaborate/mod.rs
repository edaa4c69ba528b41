//! From syntax tree to templates: parameters get values, names get nets, connections get bits.

mod connect;
mod constant;
mod drives;
mod evaluate;
mod gate;
mod header;
mod images;
mod inside;
mod instance;
mod names;
mod pieces;
mod ports;
mod range;
mod template;

use std::collections::{HashMap, HashSet, VecDeque};
use std::rc::Rc;
use std::sync::Arc;

pub(super) use images::Images;
pub(super) use template::{LocalCell, LocalInstance, LocalNet, LocalSource, Piece, Template, TemplateId};

use self::constant::Const;
use self::names::Names;
use self::template::{Override, TemplatePort};
use super::errors::Errors;
use super::limits;
use super::syntax::{Module, Name};
use crate::base::Span;
use crate::blocks::{Block, Body, Builder, Gate, Parameters};

/// All modules in reach, by name.
pub(super) type Modules<'t> = HashMap<&'t str, &'t Module>;

/// Elaborates `top` and all it instantiates; the first template is the top's. Of `others`, those that `top` has no
/// use for are elaborated too, so that their errors are told. Memory images come through `images`.
pub(super) fn elaborate<'t>(
    modules: &Modules<'t>,
    top: &'t Module,
    others: &'t [Module],
    parameters: &'t [(String, i64)],
    images: Images<'_>,
    errors: &mut Errors,
) -> Vec<Template<'t>> {
    let mut elaborator = Elaborator {
        modules,
        templates: Vec::new(),
        ports: Vec::new(),
        waiting: VecDeque::new(),
        known: HashMap::new(),
        used: HashSet::new(),
        bodies: HashMap::new(),
        gates: HashMap::new(),
        images,
        errors,
        parts: 0,
        ops: 0,
        image_words: 0,
        exhausted: false,
    };
    let given = parameters.iter().map(|(name, value)| Override { name, value: Const::integer(*value), span: None });
    elaborator.template(top, given.collect());
    elaborator.run();
    for module in others {
        if !elaborator.used.contains(&*module.name.text) {
            elaborator.template(module, Vec::new());
            elaborator.run();
        }
    }
    elaborator.templates
}

/// A module's name and the parameters given to it, sorted.
type Key<'t> = (&'t str, Vec<(&'t str, Const)>);

/// A template whose header is known and whose inside is still to be elaborated.
struct Waiting<'t> {
    id: TemplateId,
    names: Names<'t>,
    overrides: Vec<Override<'t>>,
    /// Whether its header is wrong.
    unsure: bool,
}

struct Elaborator<'e, 't> {
    modules: &'e Modules<'t>,
    templates: Vec<Template<'t>>,
    /// The ports of each template.
    ports: Vec<Rc<[TemplatePort]>>,
    waiting: VecDeque<Waiting<'t>>,
    /// Templates by what they are made of; `None` when the header is wrong.
    known: HashMap<Key<'t>, Option<TemplateId>>,
    /// Modules with a template.
    used: HashSet<&'t str>,
    bodies: HashMap<(&'static str, Parameters), Arc<Body>>,
    gates: HashMap<(Gate, usize), Arc<Body>>,
    images: Images<'e>,
    errors: &'e mut Errors,
    /// What has been written out, as [`limits::PARTS`] counts.
    parts: u64,
    /// Ops of the bodies, and words of their images, each body once.
    ops: u64,
    image_words: u64,
    /// Whether one of these has passed its limit.
    exhausted: bool,
}

/// How many parts something counts as for its name.
fn parts_of(name: &Name) -> u64 {
    1 + name.text.len() as u64 / 64
}

impl<'t> Elaborator<'_, 't> {
    /// Elaborates all that waits.
    fn run(&mut self) {
        while let Some(waiting) = self.waiting.pop_front() {
            if !self.errors.is_full() && !self.exhausted {
                inside::elaborate(self, waiting);
            }
        }
    }

    /// The template of a module with some of its parameters given; its inside is elaborated later. `None` when
    /// its header is wrong, which has been told.
    fn template(&mut self, module: &'t Module, overrides: Vec<Override<'t>>) -> Option<TemplateId> {
        let mut key: Vec<_> = overrides.iter().map(|given| (given.name, given.value)).collect();
        key.sort_unstable_by_key(|(name, _)| *name);
        let key = (&*module.name.text, key);
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let parameters = module.parameters.iter().map(|parameter| &parameter.name);
        let names = parameters.chain(module.ports.iter().map(|port| &port.name));
        self.count_parts(names.map(parts_of).sum(), module.name.span);
        self.used.insert(&module.name.text);
        let id = TemplateId::new(self.templates.len());
        let errors = self.errors.count;
        let (template, names) = header::elaborate(module, &overrides, self.errors);
        self.ports.push(template.nets.iter().map(TemplatePort::of).collect());
        self.templates.push(template);
        let unsure = self.errors.count > errors;
        self.waiting.push_back(Waiting { id, names, overrides, unsure });
        let result = (!unsure).then_some(id);
        self.known.insert(key, result);
        result
    }

    /// The ops of a block, shared by all its instances of equal parameters.
    fn body(&mut self, block: &'static Block, parameters: &Parameters) -> Result<Arc<Body>, String> {
        let key = (block.description().name, parameters.clone());
        if let Some(body) = self.bodies.get(&key) {
            return Ok(Arc::clone(body));
        }
        let body = Arc::new(Builder::build(block, parameters)?);
        self.ops += body.cost().ops;
        self.image_words += body.image_words();
        self.bodies.insert(key, Arc::clone(&body));
        Ok(body)
    }

    fn gate(&mut self, gate: Gate, inputs: usize) -> Arc<Body> {
        Arc::clone(self.gates.entry((gate, inputs)).or_insert_with(|| Arc::new(gate.body(inputs))))
    }

    /// Counts what is written out.
    fn count_parts(&mut self, parts: u64, span: Span) {
        self.parts = self.parts.saturating_add(parts);
        self.tell_excess(span);
    }

    /// Counts something with a name, which is kept for each anew.
    fn count_named(&mut self, name: &Name) {
        self.count_parts(parts_of(name), name.span);
    }

    /// Tells once when there is too much.
    fn tell_excess(&mut self, span: Span) {
        let excess = || {
            let parts = limits::PARTS.exceeded(self.parts);
            let ops = || limits::OPS.exceeded(self.ops);
            parts.or_else(ops).or_else(|| limits::MEMORY_WORDS.exceeded(self.image_words))
        };
        if !self.exhausted
            && let Some(diagnostic) = excess()
        {
            self.exhausted = true;
            self.errors.push(diagnostic.at(span, "the limit is passed here"));
        }
    }
}
