//! Icarus and our reader agree on the language: loops, selects, nested modules, and what constant expressions come to.

use stepwright::base::word::mask;
use stepwright::base::{Change, Stimulus, StopRule};
use stepwright::simulation::{Circuit, Session};

use super::circuits::judge;
use super::random::Random;
use super::tools;

fn session(text: &str) -> Session {
    Circuit::text("language.v", text).session()
}

/// Reads `text`, whose top module is `language`, and holds it against Icarus under random inputs.
fn check(text: &str, parameters: &[(String, i64)]) {
    let session = parameters.iter().fold(session(text), |session, (name, value)| session.parameter(name, *value));
    let design = session.elaborate().unwrap_or_else(|report| panic!("{report}"));
    let mut random = Random(5);
    let widths: Vec<_> = design.inputs().map(|port| port.width).collect();
    let each = (0..100).flat_map(|tick| (0..widths.len()).map(move |input| (tick, input)));
    let changes = each.map(|(tick, input)| Change { tick, input, word: random.word() & mask(widths[input]) });
    let stimulus = Stimulus { initial: vec![0; widths.len()], changes: changes.collect(), stop: StopRule::Ticks(100) };
    let design = design.with_stimulus(stimulus);
    judge("language", &design).unwrap_or_else(|difference| panic!("{difference}"));
}

const STRUCTURE: &str = "
`timescale 1ns / 1ns
`default_nettype none
/* A module in a module in a loop. */
module stage #(parameter WIDTH = 4, parameter TURN = 1) (
    input wire clk,
    input wire [WIDTH-1:0] d,
    output wire [WIDTH-1:0] q
);
    localparam LEFT = WIDTH - TURN;
    wire [WIDTH-1:0] held;
    delay_element #(.DELAY(TURN)) delay_1 (.clk(clk), .pulse_in(d[0]), .pulse_out(held[0]));
    assign held[WIDTH-1:1] = d[WIDTH-1:1];
    assign q = {held[LEFT-1:0], held[WIDTH-1:LEFT]};
endmodule

module language #(parameter N = 5) (
    input wire clk,
    input wire [2*N-1:0] word,
    input wire signed [N-1:0] strobe,
    output wire [2*N-1:0] back,
    output wire [$clog2(3*N+1)-1:0] ones,
    output wire parity
);
    localparam HALF = (N + 1) / 2, MORE = N > 4 ? N : 4;
    wire [N:0] chain;
    wire [2*N-1:0] turned;
    assign chain[0] = 1'b0;
    assign ones = {$clog2(3*N+1){1'b1}};
    genvar i, k;
    generate
        for (i = 0; i < N; i = i + 1) begin : lane
            wire [1:0] pair;
            wire set, q;
            assign pair = turned[2*i+1:2*i];
            and both (set, pair[0], pair[1], strobe[i]);
            trigger trigger_1 (.clk(clk), .set(set), .reset(strobe[(i + 1) % N]), .q(q), .q_inverse());
            xor fold (chain[i+1], chain[i], q, pair[i % 2]);
            assign back[2*i+1:2*i] = {q, ~1'b0 & 1'b1};
        end
        for (i = N - 1; i >= HALF; i = i - 2) begin : row
            wire [HALF-1:0] column;
            for (k = 0; k < HALF; k = k + 1) begin : cell_
                nor pick (column[k], word[i], word[k], strobe[k]);
            end
        end
    endgenerate
    stage #(.WIDTH(2*N), .TURN(N - MORE + 3)) stage_1 (.clk(clk), .d(word), .q(turned));
    buf result (parity, chain[N]);
endmodule
";

#[test]
fn icarus_agrees_on_loops_selects_and_nested_modules() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    for n in [5, 8, 13] {
        check(STRUCTURE, &[("N".to_owned(), n)]);
    }
}

/// Text of random constant expressions of a given width, signed and unsigned, in every base.
struct Expressions {
    random: Random,
}

impl Expressions {
    fn literal(&mut self, width: u32) -> String {
        let value = self.random.word() & mask(width) & mask(self.random.below(64) as u32 + 1);
        let sign = if self.random.below(2) == 0 { "s" } else { "" };
        match self.random.below(4) {
            0 => format!("{width}'{sign}d{value}"),
            1 => format!("{width}'{sign}h{value:x}"),
            2 => format!("{width}'{sign}o{value:o}"),
            _ => format!("{width}'{sign}b{value:b}"),
        }
    }

    fn of(&mut self, width: u32, depth: u32) -> String {
        if depth == 0 {
            return self.literal(width);
        }
        let a = self.of(width, depth - 1);
        // The other operand may be narrower: it is extended, by its sign when both are signed.
        let narrow = 1 + self.random.below(u64::from(width)) as u32;
        let b = self.of(narrow, depth - 1);
        match self.random.below(12) {
            0 => format!("({a} + {b})"),
            1 => format!("({b} - {a})"),
            2 => format!("({a} * {b})"),
            3 => format!("({a} & {b})"),
            4 => format!("({b} | {a})"),
            5 => format!("({a} ^ {b})"),
            6 => format!("(~{a})"),
            7 => format!("({a} << {})", self.random.below(u64::from(width) + 1)),
            8 => format!("({a} >> {})", self.random.below(u64::from(width) + 1)),
            9 if narrow < width => format!("{{{}, {b}}}", self.of(width - narrow, depth - 1)),
            10 => format!("(({b} < {}) ? {a} : {})", self.of(narrow, depth - 1), self.of(width, depth - 1)),
            _ => format!("(({b} == {}) ? {} : {a})", self.of(width, depth - 1), self.of(width, depth - 1)),
        }
    }
}

const HEAD: &str = "`default_nettype none\nmodule language (input wire a, output wire y);\nbuf b (y, a);\n";

/// A net that is assigned a constant expression.
fn constant(i: usize, width: u32, expression: &str) -> String {
    format!("wire [{}:0] constant_{i};\nassign constant_{i} = {expression};\n", width - 1)
}

/// Our reader refuses arithmetic that does not fit its bits, which Verilog would cut.
fn is_taken(line: &str) -> bool {
    session(&format!("{HEAD}{line}endmodule\n")).elaborate().is_ok()
}

#[test]
fn icarus_agrees_on_what_constant_expressions_come_to() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let mut expressions = Expressions { random: Random(6) };
    let candidates = (0..1200).map(|i| {
        let width = [1, 4, 8, 13, 32, 64][i % 6];
        constant(i, width, &expressions.of(width, 1 + i as u32 % 3))
    });
    let taken: Vec<_> = candidates.filter(|line| is_taken(line)).collect();
    assert!(taken.len() >= 300, "only {} of 1200 expressions are taken", taken.len());
    check(&format!("{HEAD}{}endmodule\n", taken.concat()), &[]);
}

/// How a parameter is declared, and the width that this gives it; 0 for that of its value.
const DECLARATIONS: [(&str, usize); 5] = [("", 0), ("signed", 0), ("[5:0]", 6), ("signed [5:0]", 6), ("integer", 0)];

/// Values, with the width they have; 0 for whole numbers without one.
const VALUES: [(&str, usize); 7] =
    [("4'd8", 4), ("4'sd8", 4), ("4'sd7", 4), ("6'h2A", 6), ("7'sb1111101", 7), ("9", 0), ("-9", 0)];

/// A module that shows the bits, the sign and the number of its parameter P, which has the default `value`.
fn shows(name: &str, (declaration, declared): (&str, usize), (value, width): (&str, usize)) -> String {
    let width = if declared == 0 { width } else { declared };
    let is_sized = width > 0 && declaration != "integer";
    let twice = if is_sized { format!("wire [{}:0] twice = {{P, P}};", 2 * width - 1) } else { String::new() };
    let wide = if is_sized { "wire [63:0] wide = 64'sd0 + P;" } else { "" };
    format!(
        "module {name} #(parameter {declaration} P = {value}) (input wire a, output wire y);
            localparam {declaration} Q = P;
            {twice} {wide} wire negative = P < 0; wire local = Q < 0; buf b (y, a);
        endmodule\n"
    )
}

#[test]
fn icarus_agrees_on_width_and_sign_of_parameters_by_default_and_given() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let mut modules = String::new();
    let mut instances = String::new();
    let mut taken = 0;
    for (i, declaration) in DECLARATIONS.into_iter().enumerate() {
        for (k, value) in VALUES.into_iter().enumerate() {
            let by_default = shows("language", declaration, value);
            if session(&by_default).elaborate().is_err() {
                // We refuse values that do not fit, which Verilog would cut.
                continue;
            }
            taken += 1;
            if k % 3 == i % 3 {
                // The bench must not change what the default is.
                check(&by_default, &[]);
            }
            modules += &shows(&format!("default_{i}_{k}"), declaration, value);
            let other = if declaration.1 == 0 { (value.0, value.1) } else { ("6'd1", 6) };
            // The same shape, and another value where the declaration gives the shape.
            modules += &shows(&format!("given_{i}_{k}"), declaration, other);
            instances += &format!(
                "wire y_{i}_{k}, z_{i}_{k};
                default_{i}_{k} default_of_{i}_{k} (.a(a), .y(y_{i}_{k}));
                given_{i}_{k} #(.P({})) given_of_{i}_{k} (.a(a), .y(z_{i}_{k}));\n",
                value.0
            );
        }
    }
    assert!(taken >= 28, "only {taken} of 35 cases are taken");
    check(&format!("{HEAD}{instances}endmodule\n{modules}"), &[]);
}

#[test]
fn icarus_agrees_on_parameters_given_from_outside() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    for declaration in DECLARATIONS {
        for value in [0, 7, -1] {
            let is_unsigned = declaration.0 == "[5:0]";
            if is_unsigned && value < 0 {
                continue;
            }
            // Without a declared width the parameter takes that of what is given, a whole number without one.
            let text = shows("language", declaration, ("6'd1", declaration.1));
            check(&text, &[("P".to_owned(), value)]);
        }
    }
}

#[test]
fn the_bench_gets_along_with_every_name_of_the_circuit() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let text = "
        module language (input wire language, input wire language_, input wire bench, output wire y);
            language_bench language_bench_1 (.a(language), .b(language_), .y(y));
        endmodule
        module language_bench (input wire a, input wire b, output wire y);
            and and_1 (y, a, b);
        endmodule";
    check(text, &[]);
}
