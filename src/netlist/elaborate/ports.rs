//! Ports of an instance: which connection goes to which, and whether it fits.

use std::collections::HashMap;

use super::inside::Inside;
use super::names::Meaning;
use super::pieces::{Bits, bit_count, mismatch, width};
use super::template::LocalSource;
use crate::base::{Diagnostic, Span};
use crate::netlist::syntax::{Connection, Expr, ExprKind, Name};

/// Connections of one instance that no port has taken yet.
pub(super) type Open<'t> = HashMap<&'t str, &'t Connection>;

/// A port as a connection sees it.
pub(super) struct PortPlace<'a> {
    pub(super) name: &'a str,
    /// For messages: `summer.sum`.
    pub(super) owner: &'a str,
    pub(super) width: u32,
    /// Where it is declared, if that is in a text.
    pub(super) declared: Option<Span>,
    /// How its width comes about, if that is more than a number.
    pub(super) formula: Option<String>,
}

impl<'t> Inside<'_, '_, 't> {
    /// The connections by name; a name twice is an error.
    pub(super) fn open(&mut self, list: &'t [Connection], what: &str) -> Open<'t> {
        let mut open = Open::new();
        for connection in list {
            if let Some(first) = open.insert(&connection.name.text, connection) {
                let diagnostic = Diagnostic::new("N011", format!("{what} `{}` is given twice", connection.name.text));
                self.report(diagnostic.at(connection.span, "again here").at(first.span, "first here"));
            }
        }
        open
    }

    /// Checks that a clock port gets the clock.
    pub(super) fn clock(&mut self, connection: Option<&Connection>, instance: &Name, module: &str) {
        let value = connection.and_then(|connection| connection.value.as_ref());
        let is_clock = value.is_some_and(|expr| match &expr.kind {
            ExprKind::Name(name) => match self.names.find(name) {
                Some(Meaning::Net(net)) => self.template.nets[net as usize].is_clock,
                _ => false,
            },
            _ => false,
        });
        if !is_clock {
            let message = format!("`{module}` wants the clock at its port `clk`");
            let place = connection.map_or(instance.span, |connection| connection.span);
            let diagnostic = Diagnostic::new("N023", message).at(place, "`.clk(clk)` wanted here");
            self.report(
                diagnostic.help("there is one clock: `input wire clk` in the header, `.clk(clk)` at the instance"),
            );
        }
    }

    /// The bits that an input port gets.
    pub(super) fn input(
        &mut self,
        port: &PortPlace<'_>,
        connection: Option<&'t Connection>,
        instance: &Name,
    ) -> Option<Bits> {
        let Some(value) = connection.and_then(|connection| connection.value.as_ref()) else {
            let diagnostic = Diagnostic::new("N016", format!("the input `{}` of `{}` is open", port.name, port.owner));
            let place = connection.map_or(instance.span, |connection| connection.span);
            let help = format!("connect it; to a constant if it is not used: `.{}({}'d0)`", port.name, port.width);
            self.report(diagnostic.at(place, format!("`{}` has nothing", port.name)).help(help));
            return None;
        };
        let bits = self.bits(value);
        let bits = self.keep(bits)?;
        self.elaborator.count_parts(bits.len() as u64, value.span);
        self.same_width(port, value, width(&bits), true).then_some(bits)
    }

    /// Connects an output port, which may be left open.
    pub(super) fn output(&mut self, port: &PortPlace<'_>, connection: Option<&'t Connection>, source: LocalSource) {
        let Some(value) = connection.and_then(|connection| connection.value.as_ref()) else { return };
        let target = self.target(value);
        let Some(target) = self.keep(target) else {
            self.unsure = true;
            return;
        };
        let wanted = width(&target);
        let source = if self.same_width(port, value, wanted, false) { source } else { LocalSource::Wrong };
        self.drive(&target, &[(source, wanted)], value.span);
    }

    /// Whether a connection has as many bits as its port, which it feeds or is fed by.
    pub(super) fn same_width(&mut self, port: &PortPlace<'_>, value: &Expr, given: u32, feeds: bool) -> bool {
        if given == port.width {
            return true;
        }
        let mut diagnostic = mismatch(value.span, given, port.width);
        diagnostic.message = format!(
            "`{}.{}` has {}, but is connected to {}",
            port.owner,
            port.name,
            bit_count(port.width),
            bit_count(given)
        );
        if !feeds {
            diagnostic.help = vec![match port.width {
                1 => "an output goes to a net of its width: one bit".to_owned(),
                width => format!("an output goes to a net of its width: `wire [{}:0] x`", width - 1),
            }];
        }
        if let Some(declared) = port.declared {
            diagnostic = diagnostic.at(declared, bit_count(port.width));
        }
        if let Some(formula) = &port.formula {
            diagnostic = diagnostic.help(format!("the width of `{}` is {formula} = {}", port.name, port.width));
        }
        self.report(diagnostic);
        false
    }

    pub(super) fn unknown_ports(&mut self, open: Open<'t>, owner: &str, names: &[&str], declared: Option<Span>) {
        let mut left: Vec<_> = open.into_values().collect();
        left.sort_by_key(|connection| connection.span);
        for connection in left {
            let name = &*connection.name.text;
            let message = format!("`{owner}` has no port `{name}`");
            let mut diagnostic = Diagnostic::new("N013", message).at(connection.span, "unknown");
            if let Some(span) = declared {
                diagnostic = diagnostic.at(span, "the module");
            }
            diagnostic = if name == "clk" {
                diagnostic.help(format!("`{owner}` holds no state and has no clock: leave `.clk` out"))
            } else {
                diagnostic.nearest(name, names.iter().copied()).help(format!("its ports: {}", names.join(", ")))
            };
            self.unsure = true;
            self.report(diagnostic);
        }
    }
}
