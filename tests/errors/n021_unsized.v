module n021_unsized #(parameter INIT = 3) (input wire a, output wire [3:0] b, c, d);
    assign b = 0;
    assign c = {a, 7};
    multiplexer #(.WIDTH(4)) switch_1 (.a(1), .b(1'b0), .x1(INIT), .x2(4'd0), .z(d));
endmodule
