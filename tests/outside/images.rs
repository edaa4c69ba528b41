//! Icarus holds the very words of a memory image that we hold.

use stepwright::simulation::{Circuit, EngineKind};

use super::circuits::judge;
use super::tools;

/// Every address of the shipped image, some beyond its end, and every code.
const CIRCUIT: &str = r#"
module image (
    input wire clk,
    output wire [15:0] control,
    output wire signed [15:0] word_1,
    output wire signed [15:0] word_2,
    output wire signed [15:0] word_3,
    output wire signed [15:0] word_4,
    output wire [2:0] count,
    output wire [15:0] pointer,
    output wire known
);
    wire [15:0] address;
    binary_counter #(.WIDTH(16)) counter_508 (.clk(clk), .clear(1'b0), .step(1'b1), .count(address), .overflow());
    pointer_table #(.IMAGE("letters")) table_500 (.code(address[7:0]), .pointer(pointer), .known(known));
    instruction_memory #(.IMAGE("letters")) memory_502 (
        .address(address), .control(control), .word_1(word_1), .word_2(word_2), .word_3(word_3), .word_4(word_4),
        .count(count)
    );
endmodule
"#;

#[test]
fn icarus_holds_every_word_and_pointer_of_the_shipped_image() {
    if !tools::present(&["iverilog", "vvp"]) {
        return;
    }
    let session = Circuit::text("circuits/us3809868/image.v", CIRCUIT).session().engine(EngineKind::INTERPRETER);
    let session = |ticks| session.clone().ticks(ticks).elaborate().unwrap_or_else(|report| panic!("{report}"));
    let depth =
        session(1).netlist().cells.iter().flat_map(|cell| &cell.body.graph.roms).map(|rom| rom.image.depth()).max();
    let design = session(depth.expect("a memory") as u64 + 20);
    judge("image", &design).unwrap_or_else(|difference| panic!("{difference}"));
}
