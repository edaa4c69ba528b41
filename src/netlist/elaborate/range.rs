//! Ranges of parameters: `(* MODE_min = 0, MODE_max = 4 *) module ...`, which holds for every instance. They stand before
//! the module, because Verilog has no attributes inside `#( )`.

use std::collections::HashSet;

use super::evaluate::number;
use super::names::Names;
use super::template::Override;
use crate::base::{Diagnostic, Span};
use crate::netlist::syntax::{Attribute, Module, Parameter};

/// Which parameter and which end of its range an attribute is about.
fn end_of(attribute: &str) -> Option<(&str, &'static str)> {
    ["_min", "_max"].into_iter().find_map(|end| Some((attribute.strip_suffix(end)?, end)))
}

/// What is wrong with the ranges of a module whatever the values.
pub(super) fn check_attributes(module: &Module) -> Vec<Diagnostic> {
    let parameters = module.all_parameters().filter(|parameter| !parameter.local);
    let names: HashSet<&str> = parameters.map(|parameter| &*parameter.name.text).collect();
    let check = |Attribute { name, value }: &Attribute| {
        let (parameter, _) = end_of(&name.text)?;
        if !names.contains(parameter) {
            let message = format!("`{}` has no parameter `{parameter}` to have a range", module.name.text);
            let diagnostic = Diagnostic::new("N039", message).at(name.span, "no parameter");
            Some(diagnostic.nearest(parameter, names.iter().copied()))
        } else if value.is_none() {
            let diagnostic = Diagnostic::new("N039", format!("`{}` is given no number", name.text));
            Some(diagnostic.at(name.span, "no number").help(format!("as in `(* {} = 1 *)`", name.text)))
        } else {
            None
        }
    };
    module.attributes.values().filter_map(check).collect()
}

/// An end of a range, and where it is stated.
pub(super) struct End {
    pub bound: i64,
    span: Span,
}

/// The least and the greatest value that a module states for a parameter.
pub(super) fn stated(
    names: &Names<'_>,
    module: &Module,
    parameter: &Parameter,
) -> Result<[Option<End>; 2], Diagnostic> {
    let end = |end| {
        let attribute = module.attributes.get(&*format!("{}{end}", parameter.name.text));
        let Some(Attribute { name, value: Some(bound) }) = attribute.filter(|_| !parameter.local) else {
            return Ok(None);
        };
        Ok(Some(End { bound: number(names, bound)?, span: name.span }))
    };
    Ok([end("_min")?, end("_max")?])
}

/// Whether a parameter's value is within the range that its module states.
pub(super) fn check(
    names: &Names<'_>,
    module: &Module,
    parameter: &Parameter,
    value: i128,
    given: &[Override<'_>],
) -> Result<(), Diagnostic> {
    let name = &*parameter.name.text;
    let [least, most] = stated(names, module, parameter)?;
    let least = least.filter(|end| value < end.bound.into()).map(|end| (end, "at least"));
    let most = most.filter(|end| value > end.bound.into()).map(|end| (end, "at most"));
    let Some((End { bound, span }, words)) = least.or(most) else {
        return Ok(());
    };
    let message = format!("`{name}` of `{}` is {value}, but is {words} {bound}", module.name.text);
    let place = given.iter().find(|given| given.name == name).and_then(|given| given.span);
    let diagnostic = Diagnostic::new("N015", message);
    Err(diagnostic.at(place.unwrap_or(parameter.name.span), value.to_string()).at(span, "its range"))
}
