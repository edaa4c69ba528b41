module n023_clock (input wire clk, input wire a, output wire b, c, d, e);
    wire other = clk;
    and and_1 (b, clk, a);
    inner inner_1 (.clk(a), .x(a), .y(c));
    inner inner_2 (.x(a), .y(d));
    not not_1 (clk, a);
    inner inner_3 (.clk(clk), .x(clk), .y(e));
endmodule

module inner (input wire clk, input wire x, output wire y);
    assign y = x;
endmodule

module wrong (input wire [1:0] clk);
    wire clk_2;
endmodule
