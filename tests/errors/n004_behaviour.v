`define WIDTH 4
`include "other.v"
module n004_behaviour (input wire clk, input wire a, output reg b, inout wire c);
endmodule

module body (input wire clk, input wire a, output wire b);
    reg [3:0] q;
    integer i;
    always @(posedge clk) begin
        if (a) begin q <= q + 1; end
        else q <= 0;
    end
    initial q = 0;
    function [3:0] twice; input [3:0] x; begin twice = x * 2; end endfunction
    task nothing; begin end endtask
    specify (a => b) = 1; endspecify
    if (1) begin : yes assign b = a; end else begin : no assign b = 0; end
    case (1) 1: assign b = a; endcase
    defparam b_1.WIDTH = 3;
    tri t;
    input z;
    bufif1 (b, a, a);
    assign #3 b = a;
    assign b = sum(a);
    wire \odd+name ;
    wire [3:0] memory [0:7];
    wire d = inner.net;
    wire e = $time;
    wire f = "text";
    wire g = 1.5;
endmodule

primitive p (o, i); endprimitive
