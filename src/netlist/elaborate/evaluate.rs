//! Constant expressions, by Verilog's rules (IEEE 1364-2005, 5.4): widths and signs go up, then down again with values.

use super::constant::{Const, Shape, Undefined, combine, compare, negate, power, shift};
use super::names::{Meaning, Names};
use crate::base::word::{MAX_WIDTH, clog2, mask};
use crate::base::{Diagnostic, Span};
use crate::netlist::errors::FOLLOWS;
use crate::netlist::syntax::{Binary, Expr, ExprKind, Unary};

type Result<T> = std::result::Result<T, Diagnostic>;

/// The value of an expression that stands on its own.
pub(super) fn evaluate(names: &Names<'_>, expr: &Expr) -> Result<Const> {
    let pending = prepare(names, expr)?;
    let shape = pending.shape;
    finish(pending, shape)
}

/// The value of an expression that is assigned to a word of the shape `declared`, whose width it can use.
pub(super) fn evaluate_as(names: &Names<'_>, expr: &Expr, declared: Shape) -> Result<Const> {
    let pending = prepare(names, expr)?;
    let Shape { width, signed, sized } = pending.shape;
    let wider = declared.width > width;
    finish(
        pending,
        Shape { width: width.max(declared.width), signed, sized: if wider { declared.sized } else { sized } },
    )
}

/// The value as a number.
pub(super) fn number(names: &Names<'_>, expr: &Expr) -> Result<i64> {
    let value = evaluate(names, expr)?.number();
    i64::try_from(value).map_err(|_| error(expr.span, format!("{value} is beyond a 64-bit signed number")))
}

/// The places of the bits that a select on `name` takes, lowest first: offset and width, for declared bits
/// `[lsb + width - 1 : lsb]`.
pub(super) fn select(names: &Names<'_>, kind: &ExprKind, span: Span, (lsb, width): (i64, u32)) -> Result<(u32, u32)> {
    let (name, low, high) = match kind {
        ExprKind::Bit(name, index) => {
            let index = number(names, index)?;
            (name, index, index)
        }
        ExprKind::Part(name, bounds) => (name, number(names, &bounds[1])?, number(names, &bounds[0])?),
        ExprKind::Indexed { name, up, base_and_width } => {
            let [base, wide] = &**base_and_width;
            let (base, wide) = (number(names, base)?, number(names, wide)?);
            let last = wide.checked_sub(1).filter(|last| (0..i64::from(u32::MAX)).contains(last));
            let Some(last) = last else {
                return Err(error(span, format!("a select of {wide} bits")).help("the width is 1 or more"));
            };
            let (low, high) = if *up { (base, base.saturating_add(last)) } else { (base.saturating_sub(last), base) };
            (name, low, high)
        }
        _ => return Err(error(span, "no select")),
    };
    if low > high {
        let message = format!("the select [{high}:{low}] runs upwards");
        return Err(Diagnostic::new("N028", message).at(span, "here").help(format!("write [{low}:{high}]")));
    }
    let top = lsb.saturating_add(i64::from(width) - 1);
    if low < lsb || high > top {
        let what = if low == high { format!("[{low}]") } else { format!("[{high}:{low}]") };
        let message = format!("the select {what} is outside `{}`, which has the bits [{top}:{lsb}]", name.text);
        return Err(Diagnostic::new("N019", message).at(span, "outside"));
    }
    Ok(((low - lsb) as u32, (high - low + 1) as u32))
}

fn error(span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new("N020", message).at(span, "here")
}

/// A name that means nothing here.
pub(super) fn unknown(names: &Names<'_>, name: &str, span: Span) -> Diagnostic {
    let diagnostic =
        Diagnostic::new("N010", format!("nothing is called `{name}` here")).at(span, "not declared before");
    diagnostic.nearest(name, names.usable()).help("a name is declared before it is used")
}

fn constant(names: &Names<'_>, name: &str, span: Span) -> Result<Const> {
    match names.find(name) {
        Some(Meaning::Constant(value)) => Ok(value),
        Some(Meaning::Net(_)) => {
            let diagnostic = Diagnostic::new("N020", format!("`{name}` is a net, but a constant is wanted"));
            Err(diagnostic.at(span, "changes with time").help("parameters, localparams and genvars are constants"))
        }
        Some(Meaning::Genvar) => {
            let message = format!("the genvar `{name}` has a value only inside its `for`");
            Err(Diagnostic::new("N020", message).at(span, "outside of any `for`"))
        }
        Some(Meaning::Instance) => {
            Err(Diagnostic::new("N020", format!("`{name}` is an instance")).at(span, "no value"))
        }
        Some(Meaning::Wrong) => Err(Diagnostic::new(FOLLOWS, "a wrong name")),
        None => Err(unknown(names, name, span)),
    }
}

fn checked_width(width: u64, span: Span) -> Result<u32> {
    let fits = u32::try_from(width).ok().filter(|width| (1..=MAX_WIDTH).contains(width));
    fits.ok_or_else(|| Diagnostic::new("N018", format!("a constant of {width} bits")).at(span, "1 to 64 bits fit"))
}

/// An expression whose shape is known, and whose value waits for the shape that the whole gives it. What does not
/// depend on that is worked out at once, so that every part of an expression is visited just once each way.
struct Pending {
    shape: Shape,
    span: Span,
    step: Step,
}

enum Step {
    Known(Const),
    Negate(Box<Pending>),
    Complement(Box<Pending>),
    Combine(Binary, Box<[Pending; 2]>),
    Power(Box<Pending>, i128),
    Shift(Binary, Box<Pending>, u64),
    /// The chosen side of a conditional.
    Chosen(Box<Pending>),
}

/// Width and sign of an expression, its self-determined parts worked out.
fn prepare(names: &Names<'_>, expr: &Expr) -> Result<Pending> {
    let inside = |expr: &Expr| prepare(names, expr).map(Box::new);
    let (shape, step) = match &expr.kind {
        ExprKind::Unary(Unary::Plus, a) => return prepare(names, a),
        ExprKind::Unary(Unary::Minus, a) => inside(a).map(|a| (a.shape, Step::Negate(a)))?,
        ExprKind::Unary(Unary::Not, a) => inside(a).map(|a| (a.shape, Step::Complement(a)))?,
        ExprKind::Binary(op, operands) => prepare_binary(names, *op, operands)?,
        ExprKind::Conditional(parts) => {
            let [condition, yes, no] = &**parts;
            let (yes, no) = (inside(yes)?, inside(no)?);
            let shape = yes.shape.with(no.shape);
            (shape, Step::Chosen(if evaluate(names, condition)?.word != 0 { yes } else { no }))
        }
        _ => known(leaf(names, expr)?),
    };
    Ok(Pending { shape, span: expr.span, step })
}

fn known(value: Const) -> (Shape, Step) {
    (value.shape, Step::Known(value))
}

fn prepare_binary(names: &Names<'_>, op: Binary, operands: &[Expr; 2]) -> Result<(Shape, Step)> {
    let [left, right] = operands;
    Ok(match kind_of(op) {
        BinaryKind::Left => {
            let a = Box::new(prepare(names, left)?);
            let b = evaluate(names, right)?;
            let shape = a.shape;
            (shape, if op == Binary::Power { Step::Power(a, b.number()) } else { Step::Shift(op, a, b.word) })
        }
        BinaryKind::Both => {
            let both = Box::new([prepare(names, left)?, prepare(names, right)?]);
            (both[0].shape.with(both[1].shape), Step::Combine(op, both))
        }
        BinaryKind::Comparison => {
            let (a, b) = (prepare(names, left)?, prepare(names, right)?);
            let shape = a.shape.with(b.shape);
            known(Const::bit(compare(op, finish(a, shape)?, finish(b, shape)?)))
        }
        BinaryKind::Bit => {
            let (a, b) = (evaluate(names, left)?.word != 0, evaluate(names, right)?.word != 0);
            known(Const::bit(if op == Binary::LogicalAnd { a && b } else { a || b }))
        }
    })
}

/// What stands on its own whatever is around it.
fn leaf(names: &Names<'_>, expr: &Expr) -> Result<Const> {
    match &expr.kind {
        ExprKind::Number(literal) => {
            let width = literal.width.unwrap_or(Shape::INTEGER.width);
            let shape = Shape { width, signed: literal.signed, sized: literal.width.is_some() };
            Ok(Const { word: literal.value, shape })
        }
        ExprKind::Name(name) => constant(names, name, expr.span),
        ExprKind::Bit(name, _) | ExprKind::Part(name, _) | ExprKind::Indexed { name, .. } => {
            let whole = constant(names, &name.text, name.span)?;
            let (low, width) = select(names, &expr.kind, expr.span, (0, whole.shape.width))?;
            Ok(Const { word: whole.word >> low & mask(width), shape: Shape::bits(width) })
        }
        ExprKind::Concat(parts) => joined(names, parts, 1, expr.span),
        ExprKind::Replicate(count, parts) => joined(names, parts, times(names, count)?, expr.span),
        ExprKind::Clog2(inside) => Ok(Const::integer(clog2(evaluate(names, inside)?.word).into())),
        ExprKind::Unary(op, inside) => Ok(Const::bit(reduce(*op, evaluate(names, inside)?))),
        ExprKind::Binary(..) | ExprKind::Conditional(_) => evaluate(names, expr),
    }
}

/// The value in the shape of the whole.
fn finish(pending: Pending, to: Shape) -> Result<Const> {
    let result = match pending.step {
        Step::Known(value) => return Ok(value.widened(to)),
        Step::Chosen(inside) => return finish(*inside, to),
        Step::Complement(inside) => {
            let inside = finish(*inside, to)?;
            return Ok(Const { word: !inside.word & mask(to.width), shape: to });
        }
        Step::Negate(inside) => negate(finish(*inside, to)?),
        Step::Combine(op, both) => {
            let [a, b] = *both;
            combine(op, finish(a, to)?, finish(b, to)?)
        }
        Step::Power(base, exponent) => power(finish(*base, to)?, exponent),
        Step::Shift(op, inside, amount) => shift(op, finish(*inside, to)?, amount),
    };
    result.map_err(|why| undefined(why, to, pending.span))
}

/// What the operands of an operator have to do with its result.
enum BinaryKind {
    /// Arithmetic: both have the shape of the result.
    Both,
    /// Shifts and powers: the left one has.
    Left,
    /// The operands share a shape of their own, the result is a bit.
    Comparison,
    /// Each stands on its own, the result is a bit.
    Bit,
}

fn kind_of(op: Binary) -> BinaryKind {
    use Binary::*;
    match op {
        Power | ShiftLeft | ShiftRight | ShiftRightSigned => BinaryKind::Left,
        Less | LessEqual | Greater | GreaterEqual | Equal | NotEqual => BinaryKind::Comparison,
        LogicalAnd | LogicalOr => BinaryKind::Bit,
        _ => BinaryKind::Both,
    }
}

/// How often something is repeated.
pub(super) fn times(names: &Names<'_>, count: &Expr) -> Result<u64> {
    let times = number(names, count)?;
    let positive = u64::try_from(times).ok().filter(|times| *times > 0);
    positive.ok_or_else(|| error(count.span, format!("repeated {times} times")).help("repeat at least once"))
}

/// A constant without a size where bits are counted.
pub(super) fn unsized_part(part: &Expr) -> Diagnostic {
    let diagnostic = Diagnostic::new("N021", "a number without a size has no definite bits");
    diagnostic
        .at(part.span, "how many bits?")
        .help("write its size, as in `1'b1` or `4'd9`, or `localparam [3:0] NAME = 9`")
}

fn undefined(why: Undefined, shape: Shape, span: Span) -> Diagnostic {
    match why {
        Undefined::DivisionByZero => error(span, "a division by zero"),
        Undefined::Overflow => error(span, format!("the value is beyond the {} bits of this expression", shape.width))
            .help("give one of its numbers a larger size, as in `64'd1 << 40`; without one it has 32 bits"),
    }
}

/// Parts, the first one highest, repeated.
fn joined(names: &Names<'_>, parts: &[Expr], times: u64, span: Span) -> Result<Const> {
    let (mut once, mut width) = (0_u64, 0_u32);
    for part in parts {
        let value = evaluate(names, part)?;
        if !value.shape.sized {
            return Err(unsized_part(part));
        }
        width = checked_width(u64::from(width + value.shape.width), span)?;
        once = once.checked_shl(value.shape.width).unwrap_or(0) | value.word;
    }
    let all = checked_width(u64::from(width).saturating_mul(times), span)?;
    let word = (0..times).fold(0_u64, |word, _| word.checked_shl(width).unwrap_or(0) | once);
    Ok(Const { word, shape: Shape::bits(all) })
}

fn reduce(op: Unary, inside: Const) -> bool {
    let ones = inside.word == mask(inside.shape.width);
    let odd = inside.word.count_ones() % 2 == 1;
    match op {
        Unary::ReduceAnd => ones,
        Unary::ReduceNand => !ones,
        Unary::ReduceOr => inside.word != 0,
        Unary::ReduceXor => odd,
        Unary::ReduceXnor => !odd,
        _ => inside.word == 0,
    }
}
