`timescale 1ns / 1ps
`default_nettype none
// The top module.
module circuit #(parameter WIDTH = 4, parameter integer N = 3, parameter [3:0] K = 4'b1010) (
    input wire clk,
    (* fraction = 2 *) input wire signed [WIDTH-1:0] a, b,
    input wire s,
    output wire [WIDTH-1:0] y, z,
    output wire [N:1] carry,
    output wire q
);
    localparam HALF = WIDTH / 2, LOG = $clog2(WIDTH * 8) - (HALF > 1 ? 1 : 0);
    /* Routing */
    wire [WIDTH-1:0] swapped = {a[HALF-1:0], a[WIDTH-1:HALF]};
    wire [7:4] high;
    assign high = {2{a[0 +: 2]}}, {y[0], y[3:1]} = {b[3 -: 2], K[1:0]};
    (* keep = "true" *) wire n;
    register #(.WIDTH(WIDTH)) register_1 (.clk(clk), .word(swapped), .enable(1'b1), .clear(s), .q(z));
    multiplexer #(.WIDTH(4)) switch_2 (.a(s), .b(n), .x1(high), .x2(4'hF), .z());
    not not_3 (n, s);
    nor (q, n, high[5], a[LOG - 2]);
    genvar i;
    generate
        for (i = 1; i <= N; i = i + 1) begin : stage
            wire both;
            and and_1 (both, a[i - 1], b[i]);
            inner #(.BITS(i)) inner_1 (.clk(clk), .x({i{both}}), .y(carry[i]));
        end
    endgenerate
endmodule

module inner #(parameter BITS = 1) (input wire clk, input wire [BITS-1:0] x, output wire y);
    parameter DELAY = 1;
    wire [BITS-1:0] held;
    register #(.WIDTH(BITS)) register_1 (.clk(clk), .word(x), .enable(1'b1), .clear(1'b0), .q(held));
    xor xor_1 (y, held[BITS-1], x[0]);
endmodule
