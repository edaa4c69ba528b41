//! Multiplexer 21 from gates, as in figure 6, against table 2 and against the block.

use stepwright::simulation::Circuit;

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
    let mut run = Circuit::text("circuits/su1522157/both.v", BOTH).session().start().expect("a circuit");
    let inputs = ["a", "b", "x1", "x2"].map(|name| run.input(name).expect("an input"));
    let outputs = ["gates", "block"].map(|name| run.net(name).expect("an output"));
    for n in 0_i64..1 << 10 {
        let [a, b, x1, x2] = [n & 1, n >> 1 & 1, n >> 2 & 15, n >> 6];
        for (input, word) in inputs.into_iter().zip([a, b, x1, x2]) {
            run.set(input, word).expect("a word that fits");
        }
        // Table 2; the patent leaves out the last row.
        let z = [0, x1, x2, x1 | x2][(a + 2 * b) as usize];
        assert_eq!(outputs.map(|output| run.read(output) as i64), [z, z], "a {a}, b {b}, x1 {x1}, x2 {x2}");
    }
}
