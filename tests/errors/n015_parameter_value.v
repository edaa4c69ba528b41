module n015_parameter_value (input wire clk, input wire [3:0] a, output wire [4:0] b, c, d);
    multiplexer #(.WIDTH(65)) switch_1 (.a(a[0]), .b(a[1]), .x1(a), .x2(a), .z(b));
    rounder #(.A_WIDTH(4), .FRACTION(4), .WIDTH(5)) rounder_2 (.clk(clk), .strobe(a[0]), .a(a), .rounded(c));
    inner #(.INIT(16)) inner_1 (.y(d));
    localparam [2:0] NEGATIVE = -1;
endmodule

module inner #(parameter [3:0] INIT = 0) (output wire [4:0] y);
    assign y = {1'b0, INIT};
endmodule
