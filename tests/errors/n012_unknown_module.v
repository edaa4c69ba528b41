module n012_unknown_module (input wire [3:0] a, output wire [4:0] b);
    multiplxer #(.WIDTH(2)) switch_1 (.a(a), .z(b));
    wibble wibble_9 (.clk(clk));
endmodule
