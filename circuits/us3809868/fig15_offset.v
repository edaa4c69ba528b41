// FIG. 15 of US 3,809,868: offset of the initial point, which moves this curve and all subsequent ones.
//
//   X0' = X0 + X offset   Y0' = Y0 + Y offset
//
// J, K, L and M stay. Errata: the summers are 480 and 486; 482 and 484 are not used. The equations of FIG. 15A ("FIG.
// 15" in the text) are lost; they follow from the connections.
//
// Chosen, where the patent is silent: 480 and 486 are clocked at every tick, so X0' and Y0' follow their inputs one
// tick later. `error`, in the same tick: a sum beyond 16 bits. X0' and Y0' are then 0.
`default_nettype none

module fig15_offset (
    input wire clk,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire signed [15:0] offset_x_488,
    input wire signed [15:0] offset_y_490,
    output wire signed [15:0] x0_out,
    output wire signed [15:0] y0_out,
    output wire error
);
    wire signed [15:0] sum_480;
    wire overflow_480;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(16)) summer_480 (
        .clk(clk), .strobe(1'b1), .a(x0), .b(offset_x_488), .sum(sum_480), .overflow(overflow_480)
    );
    wire signed [15:0] sum_486;
    wire overflow_486;
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(16)) summer_486 (
        .clk(clk), .strobe(1'b1), .a(y0), .b(offset_y_490), .sum(sum_486), .overflow(overflow_486)
    );

    wire good;
    or or_error (error, overflow_480, overflow_486);
    not not_error (good, error);
    word_gate #(.WIDTH(16)) gate_x0 (.open(good), .word(sum_480), .passed(x0_out));
    word_gate #(.WIDTH(16)) gate_y0 (.open(good), .word(sum_486), .passed(y0_out));
endmodule
