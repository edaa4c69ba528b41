//! Gate primitives: terminals by position, the output first.

use super::inside::Inside;
use super::names::Meaning;
use super::pieces::{Bits, width};
use super::ports::PortPlace;
use super::template::LocalSource;
use crate::base::Diagnostic;
use crate::blocks::Gate;
use crate::netlist::checked::CellKind;
use crate::netlist::syntax::{Expr, GateInstance};

impl<'t> Inside<'_, '_, 't> {
    pub(super) fn gate(&mut self, gate: &'t GateInstance) {
        self.elaborator.count_parts(1 + gate.terminals.len() as u64, gate.span);
        gate.name.iter().for_each(|name| self.elaborator.count_named(name));
        let name = match &gate.name {
            Some(name) => {
                self.declare(name, Meaning::Instance);
                name.text.to_string()
            }
            None => {
                self.unnamed += 1;
                format!("{}_unnamed_{}", gate.gate.keyword(), self.unnamed)
            }
        };
        let [output, inputs @ ..] = &gate.terminals[..] else { return };
        let single = matches!(gate.gate, Gate::Buf | Gate::Not);
        if inputs.is_empty() || (single && inputs.len() > 1) {
            let keyword = gate.gate.keyword();
            let wanted = if single { "just one input" } else { "at least one input" };
            let diagnostic = Diagnostic::new("N017", format!("`{keyword}` has {wanted}, here {}", inputs.len()));
            let example = if single { "out, a" } else { "out, a, b" };
            self.report(
                diagnostic.at(gate.span, "this gate").help(format!("output first: `{keyword} g_1 ({example});`")),
            );
            self.unsure = true;
            return;
        }
        let keyword = gate.gate.keyword();
        let place = |name| PortPlace { name, owner: keyword, width: 1, declared: None, formula: None };
        let bits: Vec<_> = inputs.iter().map(|input| self.terminal(&place("input"), input)).collect();
        let target = self.target(output);
        let Some(target) = self.keep(target) else {
            self.unsure = true;
            return;
        };
        let wanted = width(&target);
        let good = self.same_width(&place("output"), output, wanted, false);
        let cell = LocalSource::Cell { cell: self.template.cells.len() as u32, output: 0, low: 0 };
        self.drive(&target, &[(if good { cell } else { LocalSource::Wrong }, wanted)], output.span);
        let body = self.elaborator.gate(gate.gate, inputs.len());
        let span = gate.name.as_ref().map_or(gate.span, |name| name.span);
        let inputs = bits.into_iter().map(Option::unwrap_or_default).collect();
        self.cell(name, CellKind::Gate(gate.gate), inputs, body, span);
    }

    fn terminal(&mut self, place: &PortPlace<'_>, expr: &Expr) -> Option<Bits> {
        let bits = self.bits(expr);
        let bits = self.keep(bits)?;
        self.same_width(place, expr, width(&bits), true).then_some(bits)
    }
}
