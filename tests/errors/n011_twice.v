module n011_twice #(parameter N = 1) (input wire a, output wire b);
    wire N = a;
    wire b = a;
    not g_1 (b, a);
    not g_1 (b, a);
    inner #(.M(1), .M(2)) inner_1 (.x(a), .x(a), .y());
endmodule

module inner #(parameter M = 1) (input wire x, output wire y);
    assign y = x;
endmodule

module inner (input wire x, output wire y);
    assign y = x;
endmodule

module multiplexer (input wire x);
endmodule
