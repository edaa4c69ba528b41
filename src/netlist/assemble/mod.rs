//! From templates to the flat netlist: every instance written out, drivers followed to their roots, loops found.

mod loops;
mod place;
mod roots;
mod size;

use std::sync::Arc;

use super::checked::Netlist;
use super::elaborate::Template;
use super::errors::Errors;
use crate::base::Sources;

/// Writes out the first of `templates`, whose parameters were `given`. `None` when something is wrong, which has been
/// noted.
pub(super) fn assemble(
    sources: &Sources,
    templates: &[Template<'_>],
    given: &[(String, i64)],
    errors: &mut Errors,
) -> Option<Netlist> {
    let sizes = size::measure(templates, errors)?;
    let mut netlist = place::place(Arc::new(sources.clone()), templates, given, &sizes);
    roots::find(&mut netlist, errors);
    if errors.is_empty() {
        loops::find(&netlist, errors);
    }
    errors.is_empty().then_some(netlist)
}
