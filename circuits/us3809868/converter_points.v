// The sources of FIG. 5 to 8 of US 3,809,868, to which the text gives no numerals: registers for P0, P1 and the third
// point, P3 or (FIG. 8) P2. Those of FIG. 3 have numerals and stand there.
`default_nettype none

module converter_points (
    input wire clk,
    input wire load,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire signed [15:0] x1,
    input wire signed [15:0] y1,
    input wire signed [15:0] x_third,
    input wire signed [15:0] y_third,
    output wire signed [15:0] held_x0,
    output wire signed [15:0] held_y0,
    output wire signed [15:0] held_x1,
    output wire signed [15:0] held_y1,
    output wire signed [15:0] held_x_third,
    output wire signed [15:0] held_y_third
);
    register #(.WIDTH(16)) source_x0 (
        .clk(clk), .word(x0), .enable(load), .clear(1'b0), .q(held_x0)
    );
    register #(.WIDTH(16)) source_y0 (
        .clk(clk), .word(y0), .enable(load), .clear(1'b0), .q(held_y0)
    );
    register #(.WIDTH(16)) source_x1 (
        .clk(clk), .word(x1), .enable(load), .clear(1'b0), .q(held_x1)
    );
    register #(.WIDTH(16)) source_y1 (
        .clk(clk), .word(y1), .enable(load), .clear(1'b0), .q(held_y1)
    );
    register #(.WIDTH(16)) source_x_third (
        .clk(clk), .word(x_third), .enable(load), .clear(1'b0), .q(held_x_third)
    );
    register #(.WIDTH(16)) source_y_third (
        .clk(clk), .word(y_third), .enable(load), .clear(1'b0), .q(held_y_third)
    );
endmodule
