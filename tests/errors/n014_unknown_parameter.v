module n014_unknown_parameter (input wire [3:0] a, output wire [3:0] b, output wire [4:0] c);
    multiplexer #(.WIDHT(4)) switch_1 (.a(a[0]), .b(a[1]), .x1(a), .x2(a), .z(b));
    inner #(.SIZE(4), .HALF(2)) inner_1 (.x(a), .y(c));
    inner #(.WIDTH()) inner_2 (.x(a), .y());
endmodule

module inner #(parameter WIDTH = 4) (input wire [WIDTH-1:0] x, output wire [WIDTH:0] y);
    localparam HALF = WIDTH / 2;
    assign y = {1'b0, x};
endmodule
