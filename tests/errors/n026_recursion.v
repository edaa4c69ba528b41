module n026_recursion (input wire a, output wire b);
    first first_1 (.x(a), .y(b));
endmodule

module first (input wire x, output wire y);
    second second_1 (.x(x), .y(y));
endmodule

module second (input wire x, output wire y);
    first first_2 (.x(x), .y(y));
endmodule
