module n016_open_input (input wire [3:0] a, output wire [3:0] b, output wire [4:0] c);
    multiplexer #(.WIDTH(4)) switch_1 (.a(a[0]), .b(), .x1(a), .z(b));
    inner inner_1 (.y(c));
endmodule

module inner (input wire [4:0] x, output wire [4:0] y);
    assign y = x;
endmodule
