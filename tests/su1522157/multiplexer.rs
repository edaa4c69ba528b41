//! Multiplexer 21 from gates, as in figure 6, against table 2 and against the block.

use std::sync::Arc;

use stepwright::engine::{Engine, Interpreter};

use super::machine::compiled;

/// The gates and the block side by side.
const BOTH: &str = "
module both (
    input wire a, input wire b, input wire [3:0] x1, input wire [3:0] x2,
    output wire [3:0] gates, output wire [3:0] block
);
    multiplexer_21 #(.WIDTH(4)) from_gates (.a(a), .b(b), .x1(x1), .x2(x2), .z(gates));
    multiplexer #(.WIDTH(4)) from_block (.a(a), .b(b), .x1(x1), .x2(x2), .z(block));
endmodule
";

#[test]
fn gates_and_block_follow_table_2_on_every_input() {
    let program = compiled(BOTH, &[], &|_| false);
    let mut engine = Interpreter::new(Arc::clone(&program));
    for n in 0..1 << 10 {
        let [a, b, x1, x2] = [n & 1, n >> 1 & 1, n >> 2 & 15, n >> 6];
        for (place, word) in [a, b, x1, x2].into_iter().enumerate() {
            engine.set_input(place, word);
        }
        engine.settle();
        // Table 2; the patent leaves out the last row.
        let z = [0, x1, x2, x1 | x2][(a + 2 * b) as usize];
        let outputs = program.outputs.iter().map(|port| engine.value(port.value));
        assert_eq!(outputs.collect::<Vec<_>>(), [z, z], "a {a}, b {b}, x1 {x1}, x2 {x2}");
    }
}
