`default_nettype none

// The function generator of US 3,809,868, FIG. 9, fed with stroke after stroke, for measuring: nothing comes from
// outside, and one word at the end tells whether two simulators did the same.
//
// Two pseudo-random words are drawn at every tick; whenever the generator is at rest, those of that tick are the
// coefficients of the next stroke, of 1 or 3 quarters. Both counters are folded into the checksum.
module self_feeding_function_generator (
    input wire clk,
    output wire [31:0] checksum
);
    wire [30:0] random_x, random_y;
    lfsr #(.SEED(1)) source_x (.clk(clk), .q(random_x));
    lfsr #(.SEED(1522157)) source_y (.clk(clk), .q(random_y));

    // 13 bits: -4096 to 4095. The generator refuses -4096, and is started anew with the words of the next tick.
    wire signed [15:0] j, k, l, m;
    assign j = {{3{random_x[12]}}, random_x[12:0]};
    assign k = {{3{random_x[30]}}, random_x[30:18]};
    assign l = {{3{random_y[12]}}, random_y[12:0]};
    assign m = {{3{random_y[30]}}, random_y[30:18]};
    wire [2:0] quarters;
    assign quarters = {1'b0, random_x[15], 1'b1};

    wire busy, start;
    not at_rest (start, busy);

    wire signed [15:0] x, y;
    fig09_function_generator generator_16 (
        .clk(clk),
        .start(start),
        .j(j),
        .k(k),
        .l(l),
        .m(m),
        .x0(16'd0),
        .y0(16'd0),
        .quarters(quarters),
        .x(x),
        .y(y),
        .busy(busy)
    );

    checksum #(.WIDTH(32)) sum (.clk(clk), .word({y, x}), .sum(checksum));
endmodule
