//! Whatever the text: no panic, an end, and a reason for every refusal.

use proptest::prelude::*;

use crate::support::netlist_check::check;

/// A circuit with about every construct in it.
const CIRCUIT: &str = include_str!("every_construct.v");

const TOKENS: &[&str] = &[
    "module",
    "endmodule",
    "input",
    "output",
    "wire",
    "signed",
    "assign",
    "parameter",
    "localparam",
    "integer",
    "genvar",
    "generate",
    "endgenerate",
    "for",
    "begin",
    "end",
    "and",
    "not",
    "xor",
    "register",
    "multiplexer",
    "circuit",
    "inner",
    "clk",
    "a",
    "b",
    "y",
    "i",
    "WIDTH",
    "q",
    "always",
    "reg",
    "if",
    "else",
    "case",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ";",
    ",",
    ".",
    ":",
    "?",
    "=",
    "+",
    "-",
    "*",
    "/",
    "%",
    "&",
    "|",
    "^",
    "~",
    "!",
    "<",
    ">",
    "#",
    "@",
    "<<",
    ">>>",
    "**",
    "(*",
    "*)",
    "+:",
    "-:",
    "==",
    "&&",
    "$clog2",
    "$x",
    "`define",
    "`timescale",
    "0",
    "1",
    "2",
    "4'b10",
    "'hF",
    "8'sd3",
    "1'bx",
    "99999999999",
    "64'd1",
    "1.5",
    "\"s\"",
    "//",
    "/*",
    "*/",
    "\n",
    " ",
    "é",
    "\\",
    "fraction",
];

fn soup(tokens: Vec<usize>) -> String {
    tokens.into_iter().map(|token| format!("{} ", TOKENS[token])).collect()
}

/// One change to a text.
#[derive(Clone, Debug)]
enum Change {
    Cut(usize, usize),
    Insert(usize, usize),
    Replace(usize, char),
    Copy(usize, usize, usize),
}

fn change() -> impl Strategy<Value = Change> {
    let at = 0..CIRCUIT.len();
    prop_oneof![
        (at.clone(), 1..30_usize).prop_map(|(at, length)| Change::Cut(at, length)),
        (at.clone(), 0..TOKENS.len()).prop_map(|(at, token)| Change::Insert(at, token)),
        (at.clone(), any::<char>()).prop_map(|(at, c)| Change::Replace(at, c)),
        (at.clone(), at, 1..60_usize).prop_map(|(from, to, length)| Change::Copy(from, to, length)),
    ]
}

fn changed(mut text: Vec<char>, change: Change) -> Vec<char> {
    let within = |at: usize| at.min(text.len());
    match change {
        Change::Cut(at, length) => {
            text.drain(within(at)..within(at + length));
        }
        Change::Insert(at, token) => {
            let at = within(at);
            text.splice(at..at, format!(" {} ", TOKENS[token]).chars());
        }
        Change::Replace(at, c) => {
            if let Some(old) = text.get_mut(at) {
                *old = c;
            }
        }
        Change::Copy(from, to, length) => {
            let (to, copy) = (within(to), text[within(from)..within(from + length)].to_vec());
            text.splice(to..to, copy);
        }
    }
    text
}

#[test]
fn the_circuit_that_is_mutated_loads_as_it_is() {
    crate::support::load_text(CIRCUIT).unwrap_or_else(|report| panic!("{report}"));
    check(CIRCUIT);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn any_characters_are_read_or_refused(text in any::<String>()) {
        check(&text);
    }

    #[test]
    fn any_tokens_are_read_or_refused(tokens in prop::collection::vec(0..TOKENS.len(), 0..80)) {
        check(&soup(tokens));
    }

    #[test]
    fn any_tokens_in_a_module_are_read_or_refused(tokens in prop::collection::vec(0..TOKENS.len(), 0..60)) {
        check(&format!("module circuit (input wire clk, input wire a, output wire y); {} endmodule", soup(tokens)));
    }

    #[test]
    fn a_changed_circuit_is_read_or_refused(changes in prop::collection::vec(change(), 1..6)) {
        let text: Vec<char> = CIRCUIT.chars().collect();
        let text: String = changes.into_iter().fold(text, changed).into_iter().collect();
        check(&text);
    }
}
