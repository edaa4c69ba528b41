//! Names: what each means in a module and in the generate blocks inside it.

use std::collections::HashMap;

use super::constant::Const;
use crate::base::{Diagnostic, Span};
use crate::netlist::syntax::Name;

/// What a name means.
#[derive(Clone, Copy, Debug)]
pub(super) enum Meaning {
    Constant(Const),
    /// A net, by its place in the template.
    Net(u32),
    /// A declared genvar, outside its loops.
    Genvar,
    /// An instance, a gate or a generate block: no expression can use it.
    Instance,
    /// Something whose declaration is wrong, which has been told.
    Wrong,
}

/// The names of one scope.
type Scope<'t> = HashMap<&'t str, (Meaning, Span)>;

/// The names that can be seen from a place, innermost scope last.
#[derive(Debug, Default)]
pub(super) struct Names<'t> {
    scopes: Vec<Scope<'t>>,
}

impl<'t> Names<'t> {
    pub(super) fn new() -> Self {
        Self { scopes: vec![Scope::new()] }
    }

    pub(super) fn open(&mut self) {
        self.scopes.push(Scope::new());
    }

    pub(super) fn close(&mut self) {
        self.scopes.pop();
    }

    /// What a name means here.
    pub(super) fn find(&self, name: &str) -> Option<Meaning> {
        self.scopes.iter().rev().find_map(|scope| scope.get(name)).map(|(meaning, _)| *meaning)
    }

    /// Gives a name a meaning in the innermost scope.
    pub(super) fn declare(&mut self, name: &'t Name, meaning: Meaning) -> Result<(), Diagnostic> {
        let Some(scope) = self.scopes.last_mut() else { return Ok(()) };
        match scope.entry(&name.text) {
            std::collections::hash_map::Entry::Occupied(old) => {
                let message = format!("the name `{}` is given twice", name.text);
                let diagnostic = Diagnostic::new("N011", message).at(name.span, "again here");
                Err(diagnostic.at(old.get().1, "first here").help("names of nets, parameters and instances differ"))
            }
            std::collections::hash_map::Entry::Vacant(free) => {
                free.insert((meaning, name.span));
                Ok(())
            }
        }
    }

    /// The names that an expression could use here.
    pub(super) fn usable(&self) -> impl Iterator<Item = &'t str> + '_ {
        let all = self.scopes.iter().flatten();
        all.filter(|(_, (meaning, _))| !matches!(meaning, Meaning::Instance)).map(|(name, _)| *name)
    }
}
