//! The syntax tree of a circuit file: what is written, before names and widths mean anything.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::number::Literal;
use crate::base::Span;
use crate::blocks::{Direction, Gate};

/// A name where it is written.
#[derive(Clone, Debug)]
pub(in crate::netlist) struct Name {
    pub(in crate::netlist) text: Box<str>,
    pub(in crate::netlist) span: Span,
}

/// `(* name = value *)`.
#[derive(Debug)]
pub(in crate::netlist) struct Attribute {
    pub(in crate::netlist) name: Name,
    /// None for a string, too: nothing reads one.
    pub(in crate::netlist) value: Option<Expr>,
}

/// A module.
#[derive(Debug)]
pub(in crate::netlist) struct Module {
    pub(in crate::netlist) name: Name,
    /// By name.
    pub(in crate::netlist) attributes: BTreeMap<Box<str>, Attribute>,
    pub(in crate::netlist) parameters: Vec<Parameter>,
    pub(in crate::netlist) ports: Vec<Port>,
    pub(in crate::netlist) items: Vec<Item>,
    /// Whether a part of it could not be read, so that what it declares may be missing.
    pub(in crate::netlist) damaged: bool,
}

/// A `parameter` or `localparam`.
#[derive(Debug)]
pub(in crate::netlist) struct Parameter {
    pub(in crate::netlist) name: Name,
    pub(in crate::netlist) kind: ParameterKind,
    pub(in crate::netlist) value: Expr,
    pub(in crate::netlist) local: bool,
}

/// The declared type of a parameter.
#[derive(Clone, Debug)]
pub(in crate::netlist) enum ParameterKind {
    /// None: that of its value.
    Untyped,
    /// `integer`.
    Integer,
    /// A range, or `signed`, or both.
    Vector(Rc<NetType>),
}

impl Module {
    /// All parameters, those of the header first.
    pub(in crate::netlist) fn all_parameters(&self) -> impl Iterator<Item = &Parameter> {
        let in_body = self.items.iter().filter_map(|item| match item {
            Item::Parameter(parameter) => Some(parameter),
            _ => None,
        });
        self.parameters.iter().chain(in_body)
    }
}

/// What several declared names share.
#[derive(Debug)]
pub(in crate::netlist) struct NetType {
    pub(in crate::netlist) signed: bool,
    pub(in crate::netlist) range: Option<Range>,
    pub(in crate::netlist) fraction: Option<Expr>,
}

/// `[msb:lsb]`.
#[derive(Debug)]
pub(in crate::netlist) struct Range {
    pub(in crate::netlist) msb: Expr,
    pub(in crate::netlist) lsb: Expr,
    pub(in crate::netlist) span: Span,
}

/// A port of a header.
#[derive(Debug)]
pub(in crate::netlist) struct Port {
    pub(in crate::netlist) direction: Direction,
    pub(in crate::netlist) name: Name,
    pub(in crate::netlist) net_type: Rc<NetType>,
}

/// What stands in a module.
#[derive(Debug)]
pub(in crate::netlist) enum Item {
    Parameter(Parameter),
    Net { name: Name, net_type: Rc<NetType>, value: Option<Expr> },
    Assign { target: Expr, value: Expr },
    Instance(Instance),
    Gate(GateInstance),
    Genvar(Name),
    For(For),
}

/// An instance of a module or a block.
#[derive(Debug)]
pub(in crate::netlist) struct Instance {
    pub(in crate::netlist) module: Name,
    pub(in crate::netlist) overrides: Rc<[Connection]>,
    pub(in crate::netlist) name: Name,
    pub(in crate::netlist) connections: Vec<Connection>,
}

/// `.name(value)`.
#[derive(Debug)]
pub(in crate::netlist) struct Connection {
    pub(in crate::netlist) name: Name,
    pub(in crate::netlist) value: Option<Expr>,
    pub(in crate::netlist) span: Span,
}

/// A gate primitive.
#[derive(Debug)]
pub(in crate::netlist) struct GateInstance {
    pub(in crate::netlist) gate: Gate,
    pub(in crate::netlist) name: Option<Name>,
    pub(in crate::netlist) terminals: Vec<Expr>,
    pub(in crate::netlist) span: Span,
}

/// A generate loop.
#[derive(Debug)]
pub(in crate::netlist) struct For {
    pub(in crate::netlist) genvar: Name,
    pub(in crate::netlist) first: Expr,
    pub(in crate::netlist) condition: Expr,
    pub(in crate::netlist) next: Expr,
    pub(in crate::netlist) label: Name,
    pub(in crate::netlist) items: Vec<Item>,
}

/// An expression.
#[derive(Debug)]
pub(in crate::netlist) struct Expr {
    pub(in crate::netlist) kind: ExprKind,
    pub(in crate::netlist) span: Span,
    /// Levels below it.
    pub(in crate::netlist) depth: u32,
}

/// What an expression is.
#[derive(Debug)]
pub(in crate::netlist) enum ExprKind {
    Number(Literal),
    Name(Box<str>),
    /// `name[index]`
    Bit(Name, Box<Expr>),
    /// `name[msb:lsb]`
    Part(Name, Box<[Expr; 2]>),
    /// `name[base +: width]` (`up`) or `name[base -: width]`
    Indexed {
        name: Name,
        up: bool,
        base_and_width: Box<[Expr; 2]>,
    },
    /// The leftmost part is the highest.
    Concat(Vec<Expr>),
    Replicate(Box<Expr>, Vec<Expr>),
    Unary(Unary, Box<Expr>),
    Binary(Binary, Box<[Expr; 2]>),
    Conditional(Box<[Expr; 3]>),
    Clog2(Box<Expr>),
}

impl ExprKind {
    /// The expressions directly inside.
    pub(in crate::netlist) fn parts(&self) -> Vec<&Expr> {
        match self {
            Self::Number(_) | Self::Name(_) => Vec::new(),
            Self::Bit(_, a) | Self::Unary(_, a) | Self::Clog2(a) => vec![a],
            Self::Part(_, ab) | Self::Binary(_, ab) => ab.iter().collect(),
            Self::Indexed { base_and_width, .. } => base_and_width.iter().collect(),
            Self::Conditional(abc) => abc.iter().collect(),
            Self::Concat(all) => all.iter().collect(),
            Self::Replicate(count, all) => std::iter::once(&**count).chain(all).collect(),
        }
    }
}

/// A prefix operator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::netlist) enum Unary {
    Plus,
    Minus,
    Not,
    LogicalNot,
    ReduceAnd,
    ReduceNand,
    ReduceOr,
    ReduceNor,
    ReduceXor,
    ReduceXnor,
}

impl Unary {
    const ALL: [(&'static str, Unary); 11] = [
        ("+", Unary::Plus),
        ("-", Unary::Minus),
        ("~", Unary::Not),
        ("!", Unary::LogicalNot),
        ("&", Unary::ReduceAnd),
        ("~&", Unary::ReduceNand),
        ("|", Unary::ReduceOr),
        ("~|", Unary::ReduceNor),
        ("^", Unary::ReduceXor),
        ("~^", Unary::ReduceXnor),
        ("^~", Unary::ReduceXnor),
    ];

    pub(super) fn from_symbol(symbol: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == symbol).map(|(_, op)| *op)
    }

    /// As it is written.
    pub(in crate::netlist) fn symbol(self) -> &'static str {
        Self::ALL.iter().find(|(_, op)| *op == self).map_or("", |(symbol, _)| symbol)
    }
}

/// An infix operator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::netlist) enum Binary {
    Power,
    Multiply,
    Divide,
    Modulo,
    Add,
    Subtract,
    ShiftLeft,
    ShiftRight,
    ShiftRightSigned,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Xor,
    Xnor,
    Or,
    LogicalAnd,
    LogicalOr,
}

impl Binary {
    /// Symbol, operator, binding strength (IEEE 1364-2005, table 5-4).
    const ALL: [(&'static str, Binary, u32); 25] = [
        ("**", Binary::Power, 11),
        ("*", Binary::Multiply, 10),
        ("/", Binary::Divide, 10),
        ("%", Binary::Modulo, 10),
        ("+", Binary::Add, 9),
        ("-", Binary::Subtract, 9),
        ("<<", Binary::ShiftLeft, 8),
        (">>", Binary::ShiftRight, 8),
        ("<<<", Binary::ShiftLeft, 8),
        (">>>", Binary::ShiftRightSigned, 8),
        ("<", Binary::Less, 7),
        ("<=", Binary::LessEqual, 7),
        (">", Binary::Greater, 7),
        (">=", Binary::GreaterEqual, 7),
        ("==", Binary::Equal, 6),
        ("!=", Binary::NotEqual, 6),
        ("===", Binary::Equal, 6),
        ("!==", Binary::NotEqual, 6),
        ("&", Binary::And, 5),
        ("^", Binary::Xor, 4),
        ("~^", Binary::Xnor, 4),
        ("^~", Binary::Xnor, 4),
        ("|", Binary::Or, 3),
        ("&&", Binary::LogicalAnd, 2),
        ("||", Binary::LogicalOr, 1),
    ];

    pub(super) fn from_symbol(symbol: &str) -> Option<(Self, u32)> {
        Self::ALL.iter().find(|(known, ..)| *known == symbol).map(|(_, op, strength)| (*op, *strength))
    }

    /// As it is written.
    pub(in crate::netlist) fn symbol(self) -> &'static str {
        Self::ALL.iter().find(|(_, op, _)| *op == self).map_or("", |(symbol, ..)| symbol)
    }
}
