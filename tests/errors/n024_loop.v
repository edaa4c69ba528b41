module n024_loop (input wire a, output wire q, output wire [3:0] z);
    wire q_bar;
    nor nor_1 (q, a, q_bar);
    inner inner_1 (.x(q), .y(q_bar));
    multiplexer #(.WIDTH(4)) switch_1 (.a(a), .b(a), .x1({z[2:0], a}), .x2(4'd0), .z(z));
endmodule

module inner (input wire x, output wire y);
    wire passed = x;
    not not_1 (y, passed);
endmodule
