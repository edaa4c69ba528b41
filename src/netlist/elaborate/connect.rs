//! Connections: which bits an expression names, and what drives them.

use super::constant::Const;
use super::evaluate::{evaluate, select, times, unknown, unsized_part};
use super::inside::Inside;
use super::names::{Meaning, Names};
use super::pieces::{Bits, append, as_sources, bit_count, mismatch, width};
use super::template::{LocalDrive, LocalSource, Piece};
use crate::base::{Diagnostic, Span};
use crate::blocks::Direction;
use crate::netlist::limits;
use crate::netlist::syntax::{Binary, Expr, ExprKind, Name, Unary};

type Result<T> = std::result::Result<T, Diagnostic>;

impl Inside<'_, '_, '_> {
    /// The bits that an expression names. It may route, not compute.
    pub(super) fn bits(&self, expr: &Expr) -> Result<Bits> {
        match &expr.kind {
            ExprKind::Name(name) => self.named_bits(name, expr),
            ExprKind::Bit(name, _) | ExprKind::Part(name, _) | ExprKind::Indexed { name, .. } => {
                self.selected_bits(name, expr)
            }
            ExprKind::Concat(parts) => self.joined_bits(parts, 1, expr.span),
            ExprKind::Replicate(count, parts) => self.joined_bits(parts, times(&self.names, count)?, expr.span),
            _ if mentions_net(&self.names, expr) => Err(computing(expr)),
            _ => constant_bits(expr, evaluate(&self.names, expr)?),
        }
    }

    fn named_bits(&self, name: &str, expr: &Expr) -> Result<Bits> {
        match self.names.find(name) {
            Some(Meaning::Net(net)) => {
                let width = self.net(net, expr.span)?;
                Ok(vec![Piece::Net { net, low: 0, width }])
            }
            Some(Meaning::Instance) => {
                let diagnostic = Diagnostic::new("N010", format!("`{name}` is an instance, not a net"));
                Err(diagnostic.at(expr.span, "a net is wanted").help("connect its output to a net and use that"))
            }
            Some(Meaning::Constant(_) | Meaning::Genvar | Meaning::Wrong) => {
                constant_bits(expr, evaluate(&self.names, expr)?)
            }
            None => Err(unknown(&self.names, name, expr.span)),
        }
    }

    /// The width of a net that is no clock.
    fn net(&self, net: u32, span: Span) -> Result<u32> {
        let net = &self.template.nets[net as usize];
        if net.is_clock {
            let diagnostic = Diagnostic::new("N023", "the clock is no signal").at(span, "used as one here");
            return Err(diagnostic.help("`clk` goes to ports called `clk` only, as in `.clk(clk)`"));
        }
        Ok(net.width)
    }

    fn selected_bits(&self, name: &Name, expr: &Expr) -> Result<Bits> {
        let Some(Meaning::Net(net)) = self.names.find(&name.text) else {
            return constant_bits(expr, evaluate(&self.names, expr)?);
        };
        let whole = self.net(net, name.span)?;
        let declared = &self.template.nets[net as usize];
        if !declared.is_vector {
            let diagnostic = Diagnostic::new("N019", format!("`{}` is one bit and has no index", name.text));
            return Err(diagnostic.at(expr.span, "selected here").at(declared.span, "declared without a range"));
        }
        let selected = select(&self.names, &expr.kind, expr.span, (declared.lsb, whole));
        let (low, width) = selected.map_err(|error| match error.code {
            "N019" => error.at(declared.span, "declared here"),
            _ => error,
        })?;
        Ok(vec![Piece::Net { net, low, width }])
    }

    /// Parts, the first one highest, repeated.
    fn joined_bits(&self, parts: &[Expr], times: u64, span: Span) -> Result<Bits> {
        let mut once = Bits::new();
        let mut total = 0;
        for part in parts.iter().rev() {
            let part = self.bits(part)?;
            total += u64::from(width(&part));
            if total.saturating_mul(times) > u64::from(limits::CONCATENATION_BITS) {
                let message = format!("a concatenation of more than {} bits", limits::CONCATENATION_BITS);
                return Err(Diagnostic::new("N006", message).at(span, "too long").help("use several nets"));
            }
            part.into_iter().for_each(|piece| append(&mut once, piece));
        }
        let mut all = Bits::new();
        for _ in 0..times {
            once.iter().for_each(|piece| append(&mut all, *piece));
        }
        Ok(all)
    }

    /// The bits of nets that an expression names in order to drive them.
    pub(super) fn target(&self, expr: &Expr) -> Result<Bits> {
        let bits = self.bits(expr)?;
        for piece in &bits {
            let Piece::Net { net, .. } = piece else {
                let diagnostic =
                    Diagnostic::new("N029", "a constant cannot be driven").at(expr.span, "a net is wanted");
                return Err(diagnostic);
            };
            let net = &self.template.nets[*net as usize];
            if net.port == Some(Direction::Input) {
                let message = format!("`{}` is an input and is driven from outside", net.name);
                let diagnostic = Diagnostic::new("N029", message).at(expr.span, "driven here again");
                return Err(diagnostic.at(net.span, "declared as an input"));
            }
        }
        Ok(bits)
    }

    /// Lets the bits of `target` be driven by `sources`, low first, which have as many.
    pub(super) fn drive(&mut self, target: &[Piece], sources: &[(LocalSource, u32)], span: Span) {
        self.elaborator.count_parts((target.len() + sources.len()) as u64, span);
        let mut sources = sources.iter().copied();
        let mut present = sources.next();
        for piece in target {
            let Piece::Net { net, mut low, width } = *piece else { continue };
            let end = low + width;
            while let Some((source, bits)) = present.filter(|_| low < end) {
                let width = bits.min(end - low);
                self.template.nets[net as usize].drives.push(LocalDrive { low, width, source, span });
                low += width;
                present = if width == bits { sources.next() } else { Some((source.above(width), bits - width)) };
            }
        }
    }

    /// Connects two expressions: an assign.
    pub(super) fn assign(&mut self, target: &Expr, value: &Expr) {
        let (bits, source) = (self.target(target), self.bits(value));
        let Some(bits) = self.keep(bits) else {
            self.unsure = true;
            self.keep(source);
            return;
        };
        let span = target.span.to(value.span);
        let (wanted, sources) = (width(&bits), self.keep(source));
        let sources = sources.filter(|source| {
            let given = width(source);
            if given != wanted {
                self.report(mismatch(value.span, given, wanted).at(target.span, bit_count(wanted)));
            }
            given == wanted
        });
        match sources {
            Some(sources) => self.drive(&bits, &as_sources(&sources), span),
            None => self.drive(&bits, &[(LocalSource::Wrong, wanted)], span),
        }
    }
}

fn constant_bits(expr: &Expr, value: Const) -> Result<Bits> {
    if !value.shape.sized {
        return Err(unsized_part(expr));
    }
    Ok(vec![Piece::Const { value: value.word, width: value.shape.width }])
}

fn mentions_net(names: &Names<'_>, expr: &Expr) -> bool {
    let is_net = |name: &str| matches!(names.find(name), Some(Meaning::Net(_)));
    let here = match &expr.kind {
        ExprKind::Name(name) => is_net(name),
        ExprKind::Bit(name, _) | ExprKind::Part(name, _) | ExprKind::Indexed { name, .. } => is_net(&name.text),
        _ => false,
    };
    here || expr.kind.parts().into_iter().any(|part| mentions_net(names, part))
}

/// Operators on nets.
fn computing(expr: &Expr) -> Diagnostic {
    let (symbol, instead) = match &expr.kind {
        ExprKind::Unary(op, _) => (op.symbol(), instead_of_unary(*op)),
        ExprKind::Binary(op, _) => (op.symbol(), instead_of_binary(*op)),
        ExprKind::Conditional(_) => ("?:", "place a multiplexer block"),
        _ => ("$clog2", "it is for constants"),
    };
    let message = format!("the operator `{symbol}` on nets computes, but a connection only routes bits");
    Diagnostic::new("N022", message).at(expr.span, "computed here").help(instead)
}

fn instead_of_unary(op: Unary) -> &'static str {
    match op {
        Unary::Not | Unary::LogicalNot => "place a gate: `not not_1 (out, a);`",
        Unary::ReduceAnd => "place a gate: `and and_1 (out, a[0], a[1]);`",
        Unary::ReduceNand => "place a gate: `nand nand_1 (out, a[0], a[1]);`",
        Unary::ReduceOr => "place a gate: `or or_1 (out, a[0], a[1]);`",
        Unary::ReduceNor => "place a gate: `nor nor_1 (out, a[0], a[1]);`",
        Unary::ReduceXor => "place a gate: `xor xor_1 (out, a[0], a[1]);`",
        Unary::ReduceXnor => "place a gate: `xnor xnor_1 (out, a[0], a[1]);`",
        Unary::Plus | Unary::Minus => "place a block that does it (see `stepwright list blocks`)",
    }
}

fn instead_of_binary(op: Binary) -> &'static str {
    match op {
        Binary::And | Binary::LogicalAnd => "place a gate: `and and_1 (out, a, b);`",
        Binary::Or | Binary::LogicalOr => "place a gate: `or or_1 (out, a, b);`",
        Binary::Xor => "place a gate: `xor xor_1 (out, a, b);`",
        Binary::Xnor => "place a gate: `xnor xnor_1 (out, a, b);`",
        Binary::ShiftLeft | Binary::ShiftRight | Binary::ShiftRightSigned => {
            "a shift by a constant is routing: `{a[2:0], 1'b0}`"
        }
        Binary::Add | Binary::Subtract => "place a block: `summer`",
        _ => "place a block that does it (see `stepwright list blocks`)",
    }
}
