module n013_unknown_port (input wire clk, input wire [3:0] a, output wire [3:0] b, output wire [4:0] c);
    multiplexer #(.WIDTH(4)) switch_1 (.clk(clk), .a(a[0]), .b(a[1]), .x1(a), .x2(a), .x3(a), .z(b));
    inner inner_1 (.first(a), .secnd(c));
endmodule

module inner (input wire [3:0] first, output wire [4:0] second);
    assign second = {1'b0, first};
endmodule
