`default_nettype none

// The interpolator of SU 1522157 fed with frame after frame, for measuring: nothing comes from outside, so a run costs
// just what the simulator costs, and one word at the end tells whether two simulators did the same.
//
// A pseudo-random word is drawn at every tick; whenever the interpolator is at rest, the word of that tick starts the
// next frame. Both operands are 0 to 255. The three step outputs and `busy` are folded into the checksum, and so is
// `link`, by which many of these can be chained so that one checksum tells of all; one alone has it 0.
(* WIDTH_min = 9, WIDTH_max = 48, SEED_min = 1, SEED_max = 2147483647 *)
module self_feeding_interpolator #(
    parameter WIDTH = 12, // bits of a projection
    parameter SEED = 1    // of the pseudo-random words
) (
    input wire clk,
    input wire link,
    output wire [31:0] checksum
);
    wire [30:0] random;
    lfsr #(.SEED(SEED)) source (.clk(clk), .q(random));

    wire [7:0] greater, lesser;
    wire first_is_greater;
    order #(.WIDTH(8)) projections (
        .a(random[7:0]),
        .b(random[23:16]),
        .greater(greater),
        .lesser(lesser),
        .a_is_greater(first_is_greater)
    );

    wire busy, start;
    not at_rest (start, busy);

    wire step_x, step_y, step_xy;
    interpolator #(.WIDTH(WIDTH)) machine (
        .clk(clk),
        .major_32({{(WIDTH-8){1'b0}}, greater}),
        .start_33(start),
        .minor_34({{(WIDTH-8){1'b0}}, lesser}),
        .x_is_major_35(first_is_greater),
        .step_x_36(step_x),
        .step_y_37(step_y),
        .step_xy_38(step_xy),
        .busy(busy)
    );

    checksum #(.WIDTH(5)) sum (.clk(clk), .word({link, busy, step_xy, step_y, step_x}), .sum(checksum));
endmodule
