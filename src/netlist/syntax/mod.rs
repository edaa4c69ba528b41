//! From text to syntax tree: lexer, numbers, parser.

mod expression;
mod generate;
mod header;
mod instance;
mod item;
mod lexer;
mod number;
mod parser;
mod refuse;
mod tree;

pub(super) use parser::parse;
pub(super) use tree::{
    Attribute, Binary, Connection, Expr, ExprKind, For, GateInstance, Instance, Item, Module, Name, NetType, Parameter,
    ParameterKind, Port, Range, Unary,
};
