module n009_width (input wire [3:0] a, output wire [7:0] b, output wire [4:0] c, d);
    assign b = a;
    wire [2:0] low = a;
    multiplexer #(.WIDTH(5)) switch_1 (.a(a), .b(a[0]), .x1(a), .x2(c), .z(c));
    multiplexer #(.WIDTH(4)) switch_2 (.a(a[0]), .b(a[1]), .x1(a), .x2(a), .z(d));
    wire [1:0] e;
    inner inner_1 (.x(a), .y(e));
    wire f;
    and and_1 (f, a, a[0]);
endmodule

module inner (input wire [2:0] x, output wire y);
    assign y = x[0];
endmodule
