//! Load: a text, and the modules it needs from elsewhere, to a checked netlist.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use super::checked::Netlist;
use super::elaborate::{self, Modules};
use super::errors::{Errors, FOLLOWS};
use super::syntax::{self, Item, Module};
use super::{Library, assemble, limits};
use crate::base::{Diagnostic, Report, Sources, Span};
use crate::blocks;

/// Reads a circuit.
///
/// `name` is what messages show for `text`, usually its path. `top` is the module to take; without it the one that
/// is named as the file, or else the only one that no other module of the file instantiates. Modules that are not in
/// the file come from `library`. `parameters` are those of the top module that are to differ from their defaults.
///
/// # Errors
/// All that is wrong, with places.
pub fn load(
    name: &str,
    text: &str,
    top: Option<&str>,
    library: &dyn Library,
    parameters: &[(String, i64)],
) -> Result<Netlist, Report> {
    let mut loader = Loader { sources: Sources::default(), errors: Errors::default() };
    let netlist = loader.load(name, text, top, library, parameters);
    match netlist {
        Some(netlist) if loader.errors.is_empty() => Ok(netlist),
        _ => Err(Report::new(loader.sources, loader.errors.into_list())),
    }
}

struct Loader {
    sources: Sources,
    errors: Errors,
}

impl Loader {
    fn load(
        &mut self,
        name: &str,
        text: &str,
        top: Option<&str>,
        library: &dyn Library,
        parameters: &[(String, i64)],
    ) -> Option<Netlist> {
        let mut files = self.parse(name, text);
        let (main, is_broken) = (files.len(), !self.errors.is_empty());
        self.close(&mut files, library);
        let modules = self.by_name(&files);
        let top = match choose_top(name, top, &files[..main]) {
            Ok(top) => top,
            Err(error) => {
                // Without a readable module the errors told so far are the reason.
                if !is_broken || main > 0 {
                    self.errors.push(error);
                }
                return None;
            }
        };
        if self.is_recursive(&modules, &files[..main]) {
            return None;
        }
        let images = elaborate::Images::new(library, &mut self.sources);
        let templates = elaborate::elaborate(&modules, top, &files[..main], parameters, images, &mut self.errors);
        if !self.errors.is_empty() {
            return None;
        }
        assemble::assemble(&self.sources, &templates, parameters, &mut self.errors)
    }

    fn parse(&mut self, name: &str, text: &str) -> Vec<Module> {
        if text.len() > limits::TEXT_BYTES {
            let message = format!("{name} has {} bytes; at most {} are read", text.len(), limits::TEXT_BYTES);
            self.errors.push(Diagnostic::new("N001", message));
            return Vec::new();
        }
        let source = self.sources.add(name, text);
        // A text that is short enough has places of 32 bits.
        let span = |start: usize, end: usize| Span { source, start: start as u32, end: end as u32 };
        let strange = text.char_indices().find(|(_, c)| c.is_control() && !c.is_whitespace());
        if let Some((at, c)) = strange {
            let diagnostic = Diagnostic::new("N001", format!("{name} is no text"));
            let label = format!("the character `{}`", c.escape_default());
            self.errors.push(diagnostic.at(span(at, at + c.len_utf8()), label));
            return Vec::new();
        }
        let modules = syntax::parse(source, text, &mut self.errors);
        if modules.is_empty() && self.errors.is_empty() {
            let message = if text.trim().is_empty() { "is empty" } else { "holds no module" };
            let diagnostic = Diagnostic::new("N001", format!("{name} {message}"));
            self.errors.push(diagnostic.at(span(text.len(), text.len()), "a module is wanted"));
        }
        modules
    }

    /// Adds the modules that are used but not there.
    fn close(&mut self, files: &mut Vec<Module>, library: &dyn Library) {
        let mut known: HashSet<Box<str>> = files.iter().map(|module| module.name.text.clone()).collect();
        let mut unreadable = HashSet::new();
        let mut next = 0;
        while next < files.len() {
            for (name, span) in instances(&files[next]) {
                if unreadable.contains(&name) {
                    self.errors.push(Diagnostic::new(FOLLOWS, "a file that is told already").at(span, ""));
                }
                if blocks::find(&name).is_some() || !known.insert(name.clone()) {
                    continue;
                }
                match library.find(&format!("{name}.v")) {
                    Some(Ok((file, text))) => {
                        let found = self.parse(&file, &text);
                        known.extend(found.iter().map(|module| module.name.text.clone()));
                        files.extend(found);
                    }
                    Some(Err(report)) => {
                        for Diagnostic { message, .. } in report.diagnostics {
                            self.errors.push(Diagnostic::new("N001", message).at(span, "wanted here"));
                        }
                        self.errors.push(Diagnostic::new(FOLLOWS, "a module that is not known").at(span, ""));
                        unreadable.insert(name);
                    }
                    None => {}
                }
            }
            next += 1;
        }
    }

    fn by_name<'t>(&mut self, files: &'t [Module]) -> Modules<'t> {
        let mut modules = Modules::new();
        for module in files {
            let name = &module.name;
            if blocks::find(&name.text).is_some() {
                let diagnostic = Diagnostic::new("N011", format!("`{}` is the name of a block", name.text));
                self.errors.push(diagnostic.at(name.span, "a module here").help("give the module another name"));
            } else if let Some(first) = modules.get(&*name.text) {
                let diagnostic = Diagnostic::new("N011", format!("two modules are called `{}`", name.text));
                self.errors.push(diagnostic.at(name.span, "again here").at(first.name.span, "first here"));
            } else {
                modules.insert(&name.text, module);
            }
        }
        modules
    }

    /// Whether a module in reach of the file stands, at some depth, in itself.
    fn is_recursive<'t>(&mut self, modules: &Modules<'t>, file: &'t [Module]) -> bool {
        let before = self.errors.count;
        // Modules seen; `false` once all inside them is.
        let mut state = HashMap::new();
        for module in file {
            self.recursion_from(module, modules, &mut state);
        }
        self.errors.count > before
    }

    fn recursion_from<'t>(&mut self, from: &'t Module, modules: &Modules<'t>, state: &mut HashMap<&'t str, bool>) {
        if state.insert(&from.name.text, true).is_some() {
            state.insert(&from.name.text, false);
            return;
        }
        let mut open = vec![(from, instances(from))];
        while let Some((module, left)) = open.last_mut() {
            let Some((name, span)) = left.pop() else {
                state.insert(&module.name.text, false);
                open.pop();
                continue;
            };
            let Some(inner) = modules.get(&*name).copied() else { continue };
            match state.get(&*name) {
                None => {
                    state.insert(&inner.name.text, true);
                    open.push((inner, instances(inner)));
                }
                Some(true) => {
                    let way: Vec<_> = open.iter().map(|(module, _)| &*module.name.text).collect();
                    self.errors.push(recursion(&name, span, &way));
                }
                Some(false) => {}
            }
        }
    }
}

fn recursion(name: &str, span: Span, way: &[&str]) -> Diagnostic {
    let start = way.iter().position(|module| *module == name).unwrap_or(0);
    let diagnostic = Diagnostic::new("N026", format!("the module `{name}` contains itself"));
    let diagnostic = diagnostic.at(span, "instantiated inside itself");
    let round: Vec<_> = way[start..].iter().take(20).copied().chain([name]).collect();
    diagnostic.help(format!("{}: hardware ends somewhere", round.join(" > ")))
}

/// The modules that a module instantiates, with places.
fn instances(module: &Module) -> Vec<(Box<str>, Span)> {
    let mut all = Vec::new();
    let mut open: Vec<&Item> = module.items.iter().rev().collect();
    while let Some(item) = open.pop() {
        match item {
            Item::Instance(instance) => all.push((instance.module.text.clone(), instance.module.span)),
            Item::For(inner) => open.extend(inner.items.iter().rev()),
            _ => {}
        }
    }
    all
}

fn used(module: &Module) -> Vec<Box<str>> {
    instances(module).into_iter().map(|(name, _)| name).collect()
}

fn choose_top<'m>(name: &str, top: Option<&str>, modules: &'m [Module]) -> Result<&'m Module, Diagnostic> {
    let find = |wanted: &str| modules.iter().find(|module| *module.name.text == *wanted);
    let names = || modules.iter().map(|module| &*module.name.text);
    if let Some(top) = top {
        return find(top).ok_or_else(|| {
            let diagnostic = Diagnostic::new("N027", format!("{name} holds no module `{top}`"));
            diagnostic.nearest(top, names()).help(format!("its modules: {}", names().collect::<Vec<_>>().join(", ")))
        });
    }
    let stem = Path::new(name).file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
    if let Some(module) = find(stem) {
        return Ok(module);
    }
    let inner: HashSet<Box<str>> = modules.iter().flat_map(used).collect();
    let outer: Vec<_> = modules.iter().filter(|module| !inner.contains(&module.name.text)).collect();
    match outer[..] {
        [module] => Ok(module),
        _ => {
            let list: Vec<_> = outer.iter().map(|module| &*module.name.text).collect();
            let mut diagnostic = Diagnostic::new("N027", format!("which module of {name} is the top?"));
            for module in outer.iter().take(10) {
                diagnostic = diagnostic.at(module.name.span, "instantiated by none");
            }
            diagnostic = diagnostic.help(format!("call the top module as the file: `{stem}`"));
            Err(if list.is_empty() {
                diagnostic
            } else {
                diagnostic.help(format!("or name one of: {}", list.join(", ")))
            })
        }
    }
}
