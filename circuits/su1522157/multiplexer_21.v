`default_nettype none

// Multiplexer 21 of SU 1522157 A1, drawn from gates as in figure 6: for each digit an AND for either channel and an
// OR behind them. Table 2 of the patent:
//
//     A B | Z
//     0 0 | 0
//     1 0 | X1
//     0 1 | X2
//
// The drawing is lost; the gates follow from the table (chosen). With A = B = 1, which the table leaves out, they give
// the or of both words. The block `multiplexer`, which the interpolator uses, does the same.
(* WIDTH_min = 1, WIDTH_max = 64 *)
module multiplexer_21 #(
    parameter WIDTH = 4 // digits
) (
    input wire a,                // channel 1: the adder
    input wire b,                // channel 2: input 32
    input wire [WIDTH-1:0] x1,
    input wire [WIDTH-1:0] x2,
    output wire [WIDTH-1:0] z
);
    wire [WIDTH-1:0] channel_1;
    wire [WIDTH-1:0] channel_2;

    genvar i;
    generate
        for (i = 0; i < WIDTH; i = i + 1) begin : digit
            and and_1 (channel_1[i], a, x1[i]);
            and and_2 (channel_2[i], b, x2[i]);
            or or_z (z[i], channel_1[i], channel_2[i]);
        end
    endgenerate
endmodule
